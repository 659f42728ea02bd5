//! The file that `mhlint init` writes: every key with its meaning, all of them commented out.

/// Text of a new `mhlint.toml`. A line that begins with `#` and a letter or bracket is a setting.
pub const TEMPLATE: &str = r#"# Settings of mhlint for this repository, all commented out: remove the `#` of a line to set it.
# Values are the defaults where the comment says "default", and examples elsewhere.
# Globs and paths are relative to the folder of this file. `mhlint config` shows the settings in effect.

# Lowest level of findings that makes the exit code 1: "error" (default), "warning", "info" or "never".
#fail-on = "error"

# The exit code is 1 if there are more warnings than this. No limit if it is not set.
#max-warnings = 0

# Rules to run, as names or globs; `mhlint rules` lists them. All by default.
#select = ["*"]

# Rules to skip.
#skip = ["weights-metadata"]

# Report nothing for these files and folders. They are still read to resolve names.
#exclude = ["scratch/**"]

# MakeHuman's own data: read to resolve references, not reported.
#system = "../makehuman2/data"

# Check only what these applications load, and report only these base meshes.
#apps = ["makehuman2"]
#bases = ["hm08"]

# Known findings to hide; `mhlint --write-baseline` writes the file.
#baseline = "mhlint-baseline.json"

# Change the level of rules: "error", "warning", "info" or "off".
#[level]
#macro-unused-component = "warning"

# Options of rules, here two with their defaults; `mhlint explain RULE` lists them.
# Lengths are in units of the mesh, 1 = 10 cm.
#[rule.target-oversized-delta]
#ratio = 20
#[rule.weights-lost-after-threshold]
#distance = 0.01

# Other rules and levels for a part of the repository.
#[[path]]
#glob = "**/target/hm08/measure/**"
#skip = ["target-asymmetric"]
#level = { target-missing-side = "info" }

# Ignore findings of a rule in some files. Needs a reason; `until` is optional.
#[[ignore]]
#rule = "weights-not-normalized"
#path = "**/rigs/hm08/*.mhw"
#reason = "normalised by the loader, kept as painted"
#until = 2027-06-30

# How much of the slider space is evaluated (defaults).
#[eval]
#samples = 64
#exhaustive = false
"#;

/// Text of a new `mhlint.toml` beside loose assets: these applications, these system data, the rest
/// as in [`TEMPLATE`].
pub fn template_for(applications: &[&str], system: Option<&str>) -> String {
    let names: Vec<String> = applications
        .iter()
        .map(|name| format!("\"{name}\""))
        .collect();
    let apps = format!("apps = [{}]", names.join(", "));
    let found = system.map(|system| format!("system = {}", toml::Value::from(system)));
    let line = |line: &str| {
        match line {
        ALL_COMMENTED => {
            "# Settings of mhlint for the assets in this folder. Other settings are commented out: remove the `#`\n\
            # of a line to set it."
                .to_owned()
        }
        DATA_COMMENT if system.is_none() => {
            format!("{line}\n# Not found near this folder: without it nothing is compared with \
                the base mesh.")
        }
        SYSTEM => found.clone().unwrap_or_else(|| line.to_owned()),
        APPS => apps.clone(),
        _ => line.to_owned(),
    }
    };
    TEMPLATE.lines().map(|text| line(text) + "\n").collect()
}

const ALL_COMMENTED: &str = "# Settings of mhlint for this repository, all commented out: remove \
    the `#` of a line to set it.";
const DATA_COMMENT: &str = "# MakeHuman's own data: read to resolve references, not reported.";
const SYSTEM: &str = "#system = \"../makehuman2/data\"";
const APPS: &str = "#apps = [\"makehuman2\"]";

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Config;
    use mhlint_diag::{Level, OptionInfo, RuleInfo};

    fn rules() -> Vec<&'static RuleInfo> {
        static RATIO: [OptionInfo; 1] = [OptionInfo {
            name: "ratio",
            default: 10.0,
            docs: "",
        }];
        static OVERSIZED: RuleInfo = RuleInfo {
            options: &RATIO,
            ..RuleInfo::new("target-oversized-delta", Level::Warning, "")
        };
        static DISTANCE: [OptionInfo; 1] = [OptionInfo {
            name: "distance",
            default: 10.0,
            docs: "",
        }];
        static LOST: RuleInfo = RuleInfo {
            options: &DISTANCE,
            ..RuleInfo::new("weights-lost-after-threshold", Level::Warning, "")
        };
        vec![&OVERSIZED, &LOST]
    }

    #[test]
    fn a_template_for_assets_sets_what_was_found() {
        let text = template_for(&["makehuman2", "makehuman1"], Some("../a \"b\"/data"));
        let config = Config::parse(&text, "mhlint.toml", &rules()).unwrap();
        assert_eq!(config.applications.len(), 2);
        assert!(
            config
                .systems
                .first()
                .is_some_and(|system| system.ends_with("../a \"b\"/data"))
        );
        for line in [ALL_COMMENTED, DATA_COMMENT, SYSTEM, APPS] {
            assert!(TEMPLATE.lines().any(|known| known == line), "{line}");
        }
        let config = Config::parse(
            &template_for(&["makehuman1"], None),
            "mhlint.toml",
            &rules(),
        )
        .unwrap();
        assert_eq!((config.applications.len(), config.systems), (1, Vec::new()));
    }

    #[test]
    fn the_template_sets_nothing_and_every_line_of_it_can_be_set() {
        let silent = Config::parse(TEMPLATE, "mhlint.toml", &rules()).unwrap();
        assert!(silent.file.unwrap().places.is_empty());
        let bare = |line: &str| match line.strip_prefix('#') {
            Some(rest) if !rest.starts_with(' ') => rest.to_owned(),
            _ => line.to_owned(),
        };
        let all: Vec<String> = TEMPLATE.lines().map(bare).collect();
        let config = Config::parse(&all.join("\n"), "mhlint.toml", &rules()).unwrap();
        let file = config.file.unwrap();
        assert_eq!(
            (file.blocks.len(), file.ignores.len(), config.samples),
            (1, 1, Some(64))
        );
        for key in crate::keys::FILE {
            assert!(
                TEMPLATE.contains(key.name),
                "the template lacks `{}`",
                key.name
            );
        }
    }
}
