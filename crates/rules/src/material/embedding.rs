//! Textures must be of a format that the glTF export can embed.

use super::super::{Check, Rule, RuleCx};
use super::picture::is_readable;
use mhlint_diag::{Application::Makehuman2, Case, Evidence, Finding, Level, RuleInfo};
use mhlint_discover::extension;
use mhlint_repo::{FileFacts, View};

pub(crate) static RULE: Rule = Check::Repository(run).rule(RuleInfo {
    breaks: &[(
        Makehuman2,
        "leaves the texture out of a glTF with embedded textures, where all textures after it are \
            then mixed up",
    )],
    docs: include_str!("embedding.md").trim_ascii_end(),
    ..RuleInfo::new(
        "material-embedding",
        Level::Warning,
        "a texture that the glTF export cannot \
        embed",
    )
});

const NOTHING: Case = &[(
    Makehuman2,
    Level::Warning,
    "does not export the figure as glTF with embedded textures: \"No diffuse material found.\"",
)];

const EMBEDDED: [&str; 3] = ["png", "jpg", "jpeg"];

fn run(view: &View<'_>, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    for surface in view
        .surfaces()
        .iter()
        .filter(|surface| view.layers().is_checked(surface.file))
    {
        let is_left_out =
            |file: &FileFacts| is_readable(file) && !EMBEDDED.contains(&extension(&file.rel));
        let exported = surface
            .found()
            .filter(|(keyword, _, file)| *keyword != "litsphereTexture" && is_left_out(file));
        let textures: Vec<_> = exported.collect();
        let diffuse = textures
            .iter()
            .find(|(keyword, _, _)| *keyword == "diffuseTexture");
        let Some((keyword, picture, file)) = diffuse.or(textures.first()) else {
            continue;
        };
        let name = file.file_name();
        let message = match textures.len() {
            1 => format!("texture `{name}` of `{keyword}` cannot be embedded in a glTF"),
            count => format!("{count} textures cannot be embedded in a glTF, first `{name}`"),
        };
        let lower = extension(&file.rel).to_lowercase();
        let help = if EMBEDDED.contains(&&*lower) {
            format!(
                "rename it to `{}.{lower}`, here and in the material",
                file.stem()
            )
        } else {
            "save it as PNG or JPEG, and name that file in the material".to_owned()
        };
        let finding = RULE
            .at(surface.file, picture.place.clone(), message)
            .help(help);
        let names = textures.iter().map(|(keyword, _, _)| *keyword);
        let finding = finding.key("embedding").evidence(Evidence::of_cases(names));
        out.push(if diffuse.is_some() {
            finding.case(NOTHING)
        } else {
            finding
        });
    }
}
