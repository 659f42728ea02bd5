//! Changes that authors make to a real repository: `--since`, `--staged` and `--against` say what
//! each of them brings, all three the same, and the same as two whole reports beside each other.

use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

use rayon::prelude::*;
use serde_json::Value;

use crate::scratch::{copy_folder, corpus, edit, mhlint, remove, stderr};

/// What an author does to a file. Paths are relative to the repository.
enum Edit {
    /// The first of a text in a file becomes another one.
    Replace(&'static str, &'static str, &'static str),
    /// At the end of a file.
    Append(&'static str, &'static str),
    Write(&'static str, &'static str),
    Copy(&'static str, &'static str),
    Rename(&'static str, &'static str),
    /// A file or a folder.
    Remove(&'static str),
    /// Line ends become those of Windows.
    Crlf(&'static str),
}
use Edit::{Append, Copy, Crlf, Remove, Rename, Replace, Write};

/// A change, and the findings that it brings: `new`, `worse` or `gone`, the rule, and how the path
/// ends.
struct Change {
    name: &'static str,
    /// What was done to the corpus before and is committed.
    before: &'static [Edit],
    edits: &'static [Edit],
    brings: &'static [&'static str],
    /// What only one of comparison and whole reports says, on purpose.
    otherwise: &'static [&'static str],
}

/// The usual one, on the corpus as it is.
const CHANGE: Change = Change {
    name: "",
    before: &[],
    edits: &[],
    brings: &[],
    otherwise: &[],
};

const HM08_BASE: &str = "data/base/hm08/base.json";
const BOT_BASE: &str = "data/base/mh2bot/base.json";
const MACRO: &str = "data/target/hm08/macro.json";
const SLIDERS: &str = "data/target/hm08/modelling.json";
const BOT_SLIDERS: &str = "data/target/mh2bot/modelling.json";
const SKELETON: &str = "data/rigs/mh2bot/default.mhskel";
const WEIGHTS: &str = "data/rigs/mh2bot/default_weights.mhw";
const OVAL: &str = "data/target/hm08/head/head-oval.target";
const ROUND: &str = "data/target/hm08/head/head-round.target";
const NOSE: &str = "data/target/hm08/nose/nose-volume-incr.target";
const SMALL_NOSE: &str = "data/target/hm08/nose/nose-volume-decr.target";
/// One of six targets with zero rows.
const OLD_ZEROS: &str =
    "data/target/hm08/macro_prop/female-old-averagemuscle-maxweight-ideal.target";
const FOREARMS: &str = "data/target/mh2bot/armslegs/forearms-length-incr.target";
/// Not the mirror image of its partner.
const FOOT: &str = "data/target/hm08/armslegs/l-foot-trans-forward.target";
const BABY: &str = "data/target/hm08/macro_age/african-female-baby.target";
/// Overrides the sliders of the system.
const OVERRIDE: &str = "user/contarget/hm08/modelling.json";

const OVAL_ROW: &str = "\n0 -.004 0 0\n";
const ROUND_ROW: &str = "\n9 -.004 0 0\n";
const POINTER: &str = "version https://git-lfs.github.com/spec/v1\n\
    oid sha256:4d7a214614ab2935c943f9e0ff69d22eadbb8f32b1258daaa5e2ca24d17e2393\nsize 12345\n";
const IGNORE: &str =
    "# basemesh hm08\n# mhlint: ignore target-asymmetric-pair helpers may differ\n";

const CHANGES: [Change; 57] = [
    // Rows of targets.
    Change {
        name: "a displacement is no number",
        edits: &[Replace(OVAL, OVAL_ROW, "\n0 nan 0 0\n")],
        brings: &["new target-non-finite head/head-oval.target"],
        ..CHANGE
    },
    Change {
        name: "a row is there twice",
        edits: &[Replace(OVAL, OVAL_ROW, "\n0 -.004 0 0\n0 -.004 0 0\n")],
        brings: &["new target-duplicate-vertex head/head-oval.target"],
        ..CHANGE
    },
    Change {
        name: "a row for a vertex that the mesh does not have",
        edits: &[Append(OVAL, "99999 .1 0 0\n")],
        brings: &["new target-vertex-out-of-range head/head-oval.target"],
        ..CHANGE
    },
    Change {
        name: "a remark behind a row",
        edits: &[Replace(OVAL, OVAL_ROW, "\n0 -.004 0 0 # ear\n")],
        brings: &[
            "new target-field-count head/head-oval.target",
            "worse target-asymmetric head/head-oval.target",
        ],
        // As many targets as before, but in one of them another vertex.
        otherwise: &["worse target-asymmetric head/head-oval.target"],
        ..CHANGE
    },
    Change {
        name: "a zero row more in a target that has some",
        edits: &[Append(OLD_ZEROS, "1472 0 0 0\n")],
        otherwise: &["worse target-zero-delta maxweight-ideal.target"],
        ..CHANGE
    },
    Change {
        name: "a zero row in a target beside those that have some",
        edits: &[Append(NOSE, "0 0 0 0\n")],
        brings: &["worse target-zero-delta nose/nose-volume-incr.target"],
        ..CHANGE
    },
    Change {
        name: "a zero row of one target wanders to another one",
        before: &[Append(NOSE, "0 0 0 0\n")],
        edits: &[
            Replace(NOSE, "\n0 0 0 0\n", "\n"),
            Append(SMALL_NOSE, "0 0 0 0\n"),
        ],
        brings: &["worse target-zero-delta nose/nose-volume-decr.target"],
        otherwise: &["worse target-zero-delta nose/nose-volume-decr.target"],
    },
    Change {
        name: "the first zero row of a base",
        edits: &[Append(FOREARMS, "0 0 0 0\n")],
        brings: &["new target-zero-delta forearms-length-incr.target"],
        ..CHANGE
    },
    Change {
        name: "a fault wanders from one target to another one",
        before: &[Replace(OVAL, OVAL_ROW, "\n0 nan 0 0\n")],
        edits: &[
            Replace(OVAL, "\n0 nan 0 0\n", OVAL_ROW),
            Replace(ROUND, ROUND_ROW, "\n9 nan 0 0\n"),
        ],
        brings: &[
            "new target-non-finite head/head-round.target",
            "gone target-non-finite head/head-oval.target",
            "worse target-asymmetric head/head-oval.target",
        ],
        // One target more that can be told, and one less.
        otherwise: &["worse target-asymmetric head/head-oval.target"],
    },
    Change {
        name: "a fault is mended",
        before: &[Replace(OVAL, OVAL_ROW, "\n0 nan 0 0\n")],
        edits: &[Replace(OVAL, "\n0 nan 0 0\n", OVAL_ROW)],
        // What was not told of a target that cannot be used is told again.
        brings: &[
            "gone target-non-finite head/head-oval.target",
            "worse target-asymmetric head/head-oval.target",
        ],
        ..CHANGE
    },
    // Files of targets.
    Change {
        name: "a target that a slider uses gets another name",
        edits: &[Rename(OVAL, "data/target/hm08/head/egg.target")],
        brings: &["new modelling-missing-target hm08/modelling.json"],
        ..CHANGE
    },
    Change {
        name: "a target is renamed in capitals only",
        edits: &[Rename(OVAL, "data/target/hm08/head/Head-Oval.target")],
        brings: &["new file-case-mismatch hm08/modelling.json"],
        ..CHANGE
    },
    Change {
        name: "a target that a slider uses is deleted",
        edits: &[Remove(ROUND)],
        brings: &["new modelling-missing-target hm08/modelling.json"],
        ..CHANGE
    },
    Change {
        name: "a target without a slider is added",
        edits: &[Write(
            "data/target/hm08/head/brow.target",
            "# basemesh hm08\n131 0 .1 0\n132 0 .1 0\n",
        )],
        brings: &["new target-unreferenced head/brow.target"],
        ..CHANGE
    },
    Change {
        name: "a target is copied",
        edits: &[Copy(NOSE, "data/target/hm08/nose/wart.target")],
        brings: &[
            "new target-unreferenced nose/wart.target",
            "new file-duplicate-content nose/nose-volume-incr.target",
        ],
        ..CHANGE
    },
    Change {
        name: "a target gets the ending of packed ones",
        edits: &[Rename(OVAL, "data/target/hm08/head/head-oval.target.gz")],
        brings: &[
            "new modelling-missing-target hm08/modelling.json",
            "new file-gzip-corrupt head-oval.target.gz",
        ],
        ..CHANGE
    },
    Change {
        name: "a target becomes a pointer",
        edits: &[Write(OVAL, POINTER)],
        brings: &["new file-lfs-pointer head/head-oval.target"],
        ..CHANGE
    },
    Change {
        name: "a target with zero rows becomes a pointer",
        edits: &[Write(OLD_ZEROS, POINTER)],
        brings: &["new file-lfs-pointer maxweight-ideal.target"],
        ..CHANGE
    },
    Change {
        name: "a target loses its content",
        edits: &[Write(OVAL, "")],
        brings: &["new file-empty head/head-oval.target"],
        ..CHANGE
    },
    Change {
        name: "a folder of targets is deleted",
        edits: &[Remove("data/target/hm08/forehead")],
        brings: &["new modelling-missing-target hm08/modelling.json"],
        ..CHANGE
    },
    Change {
        name: "line ends of a target",
        edits: &[Crlf(OVAL)],
        ..CHANGE
    },
    Change {
        name: "a comment in a target",
        edits: &[Replace(OVAL, OVAL_ROW, "\n# ear\n0 -.004 0 0\n")],
        ..CHANGE
    },
    // Sliders.
    Change {
        name: "a slider gets another name",
        edits: &[Replace(SLIDERS, "\"Head Oval\": {", "\"Head Egg\": {")],
        ..CHANGE
    },
    Change {
        name: "two sliders move one target",
        edits: &[Replace(
            SLIDERS,
            "\"head/head-round\"",
            "\"head/head-oval\"",
        )],
        brings: &[
            "new modelling-duplicate-pattern hm08/modelling.json",
            "new target-unreferenced head-round.target",
        ],
        ..CHANGE
    },
    Change {
        name: "an icon is deleted",
        edits: &[Remove("data/target/hm08/icons/head-oval.png")],
        brings: &["new modelling-missing-icon hm08/modelling.json"],
        ..CHANGE
    },
    Change {
        name: "a second icon without a slider",
        edits: &[Write("data/target/hm08/icons/zygoma.png", "a picture")],
        brings: &["worse file-unreferenced icons/zygoma.png"],
        ..CHANGE
    },
    Change {
        name: "a slider is there twice",
        edits: &[Replace(
            BOT_SLIDERS,
            "\"UArm Diameter\": {",
            "\"UArm Length\": {",
        )],
        brings: &[
            "new json-duplicate-key mh2bot/modelling.json",
            "new target-unreferenced armslegs/upperarms-length-incr.target",
        ],
        ..CHANGE
    },
    Change {
        name: "sliders are no JSON any more",
        edits: &[Replace(
            BOT_SLIDERS,
            "\"UArm Length\": {",
            "\"UArm Length\" {",
        )],
        brings: &["new json-syntax mh2bot/modelling.json"],
        ..CHANGE
    },
    Change {
        name: "sliders with findings are no JSON any more",
        edits: &[Replace(SLIDERS, "\"Head Oval\": {", "\"Head Oval\" {")],
        brings: &[
            "new json-syntax hm08/modelling.json",
            "gone modelling-measure hm08/modelling.json",
            "gone modelling-measure hm08/modelling.json",
            "gone modelling-measure hm08/modelling.json",
            "gone base-unknown-preset hm08/base.json",
            "gone file-unreferenced man-diamond.png",
            "gone target-moves-helpers-only penis-length-incr.target",
            "gone target-asymmetric-pair l-foot-trans-backward.target",
            "gone target-asymmetric-pair l-foot-trans-forward.target",
            "gone target-asymmetric-pair l-eye-corner1-up.target",
            "gone macro-missing-combination hm08/macro.json",
            "gone macro-missing-combination hm08/macro.json",
            "gone macro-missing-combination hm08/macro.json",
            "gone numeric-dead-range hm08/macro.json",
            "gone numeric-dead-range hm08/macro.json",
            "gone numeric-dead-range hm08/macro.json",
            "gone numeric-threshold-loss hm08/macro.json",
        ],
        ..CHANGE
    },
    Change {
        name: "a category that no slider is in",
        edits: &[Replace(
            "data/target/hm08/target_cat.json",
            "\"cat\": \"hip\"",
            "\"cat\": \"hipp\"",
        )],
        brings: &["new modelling-unknown-group hm08/modelling.json"],
        ..CHANGE
    },
    // Macros.
    Change {
        name: "a target of a macro is deleted",
        edits: &[Remove(BABY)],
        brings: &["new macro-missing-target hm08/macro.json"],
        ..CHANGE
    },
    Change {
        name: "a target of a macro loses its content",
        edits: &[Write(BABY, "")],
        brings: &["new macro-empty-target hm08/macro.json"],
        ..CHANGE
    },
    Change {
        name: "a component has a step too many",
        edits: &[Replace(
            MACRO,
            "[0.0, 0.1875, 0.5, 1.0]",
            "[0.0, 0.1875, 0.5, 0.75, 1.0]",
        )],
        brings: &[
            "new macro-steps-length hm08/macro.json",
            "gone macro-missing-combination hm08/macro.json",
            "gone macro-missing-combination hm08/macro.json",
            "gone macro-missing-combination hm08/macro.json",
            "gone numeric-dead-range hm08/macro.json",
            "gone numeric-dead-range hm08/macro.json",
            "gone numeric-dead-range hm08/macro.json",
        ],
        ..CHANGE
    },
    Change {
        name: "a combination is dropped",
        edits: &[Replace(MACRO, "\"t\": \"asian-male-old\"", "\"t\": null")],
        brings: &["new macro-unreferenced-target macro_age/asian-male-old.target"],
        ..CHANGE
    },
    Change {
        name: "a combination is mended",
        edits: &[Replace(
            MACRO,
            "\"t\": \"child-minmuscle-maxweight-averagecup-maxfirmness\" },\n\t\t\t{ \"name\": \
             \"female-child-minmuscle-averageweight-averagecup-minfirmness\"",
            "\"t\": \"child-minmuscle-averageweight-averagecup-maxfirmness\" },\n\t\t\t{ \"name\": \
             \"female-child-minmuscle-averageweight-averagecup-minfirmness\"",
        )],
        brings: &["gone macro-alias-suspect hm08/macro.json"],
        ..CHANGE
    },
    Change {
        name: "line ends of a JSON",
        edits: &[Crlf(MACRO)],
        ..CHANGE
    },
    // Weights and skeletons.
    Change {
        name: "weights for a bone that is not there",
        edits: &[Replace(WEIGHTS, "\"eyebrow.L\": [", "\"eyebrow.X\": [")],
        brings: &["new weights-unknown-bone mh2bot/default_weights.mhw"],
        ..CHANGE
    },
    Change {
        name: "weights for a vertex that is not there",
        edits: &[Replace(WEIGHTS, "[3082, 1.0]", "[93082, 1.0]")],
        brings: &["new weights-vertex-out-of-range mh2bot/default_weights.mhw"],
        ..CHANGE
    },
    Change {
        name: "one vertex more whose weights do not add up",
        edits: &[Replace(WEIGHTS, "[3082, 1.0]", "[3082, 0.5]")],
        brings: &["worse weights-not-normalized mh2bot/default_weights.mhw"],
        ..CHANGE
    },
    Change {
        name: "a bone at a joint that is not there",
        edits: &[Replace(
            SKELETON,
            "\"eyebrow.L___head\"",
            "\"eyebrow.L___hed\"",
        )],
        brings: &[
            "new skeleton-unknown-joint mh2bot/default.mhskel",
            "gone skeleton-noisy-roll mh2bot/default.mhskel",
        ],
        ..CHANGE
    },
    Change {
        name: "a bone below a parent that is not there",
        edits: &[Replace(
            SKELETON,
            "\"parent\": \"head\"",
            "\"parent\": \"hed\"",
        )],
        brings: &[
            "new skeleton-unknown-parent mh2bot/default.mhskel",
            "gone skeleton-noisy-roll mh2bot/default.mhskel",
        ],
        ..CHANGE
    },
    // Bases.
    Change {
        name: "a wrong count is corrected",
        edits: &[Replace(BOT_BASE, "7267", "7259")],
        brings: &["gone base-vertex-count mh2bot/base.json"],
        ..CHANGE
    },
    Change {
        name: "a wrong count becomes another one",
        edits: &[Replace(BOT_BASE, "7267", "7266")],
        ..CHANGE
    },
    Change {
        name: "a preset that the start model resets is corrected",
        edits: &[Replace(
            HM08_BASE,
            "\"macrodetails/African\": 0.33",
            "\"macrodetails/African\": 0.34",
        )],
        brings: &[],
        ..CHANGE
    },
    Change {
        name: "a preset for no slider",
        edits: &[Replace(
            HM08_BASE,
            "\"breast/BreastSize\"",
            "\"breast/BreastSiz\"",
        )],
        brings: &["new base-unknown-preset hm08/base.json"],
        ..CHANGE
    },
    Change {
        name: "a comma too many",
        edits: &[Replace(
            "data/base/hm08/body-poses.json",
            "\"Rest\": {},",
            "\"Rest\": {,},",
        )],
        brings: &[
            "new json-syntax hm08/body-poses.json",
            "gone pose-matrix hm08/body-poses.json",
        ],
        ..CHANGE
    },
    // Materials and pictures.
    Change {
        name: "a texture is misspelt",
        edits: &[Replace(
            "data/clothes/mh2bot/oilcan/oilcan.mhmat",
            "oilcan.png",
            "oilcam.png",
        )],
        brings: &["new material-missing-texture oilcan/oilcan.mhmat"],
        ..CHANGE
    },
    Change {
        name: "a texture gets another name",
        edits: &[Rename(
            "data/skins/mh2bot/textures/mh2bot_light.png",
            "data/skins/mh2bot/textures/glow.png",
        )],
        brings: &["new material-missing-texture mh2bot/default.mhmat"],
        ..CHANGE
    },
    Change {
        name: "a picture becomes a pointer",
        edits: &[Write("data/target/hm08/icons/head-oval.png", POINTER)],
        brings: &["new file-lfs-pointer icons/head-oval.png"],
        ..CHANGE
    },
    // Overlays.
    Change {
        // The system's data are checked without the user's as well.
        name: "the user has sliders instead of those of the system",
        edits: &[Copy(SLIDERS, OVERRIDE)],
        brings: &[
            "new overlay-partial-override contarget/hm08/modelling.json",
            "new modelling-measure contarget/hm08/modelling.json",
            "new modelling-measure contarget/hm08/modelling.json",
            "new modelling-measure contarget/hm08/modelling.json",
        ],
        ..CHANGE
    },
    Change {
        name: "a fault where the user has other sliders",
        before: &[Copy(SLIDERS, OVERRIDE)],
        edits: &[Replace(SLIDERS, "\"head-oval.png\"", "\"head-ovel.png\"")],
        brings: &["new modelling-missing-icon data/target/hm08/modelling.json"],
        ..CHANGE
    },
    Change {
        name: "a target of the user's own",
        edits: &[Write(
            "user/target/hm08/nose/nose-tip.target",
            "# basemesh hm08\n131 0 .1 0\n132 0 .1 0\n",
        )],
        ..CHANGE
    },
    // Ignores and settings.
    Change {
        name: "a finding is ignored",
        edits: &[Replace(FOOT, "# basemesh hm08\n", IGNORE)],
        brings: &["gone target-asymmetric-pair l-foot-trans-forward.target"],
        ..CHANGE
    },
    Change {
        name: "a finding is ignored no more",
        before: &[Replace(FOOT, "# basemesh hm08\n", IGNORE)],
        edits: &[Replace(FOOT, IGNORE, "# basemesh hm08\n")],
        brings: &["new target-asymmetric-pair l-foot-trans-forward.target"],
        ..CHANGE
    },
    Change {
        name: "nothing is ignored",
        before: &[Replace(BOT_BASE, "7267", "7259")],
        edits: &[Replace(OVAL, "# basemesh hm08\n", IGNORE)],
        brings: &["new config-unused-ignore head/head-oval.target"],
        ..CHANGE
    },
    Change {
        name: "a level is set",
        edits: &[Write(
            "mhlint.toml",
            "[level]\ntarget-zero-delta = \"error\"\n",
        )],
        otherwise: &["worse target-zero-delta maxweight-ideal.target"],
        ..CHANGE
    },
    // Beside the data.
    Change {
        name: "a text beside the data",
        edits: &[Write("README.md", "# Data\n")],
        ..CHANGE
    },
];

impl Edit {
    fn apply(&self, root: &Path) {
        let read = |file: &str| fs::read_to_string(root.join(file)).unwrap();
        match *self {
            Replace(file, find, with) => edit(root, file, find, with),
            Append(file, text) => fs::write(root.join(file), read(file) + text).unwrap(),
            Write(file, text) => fs::write(made(root, file), text).unwrap(),
            Copy(from, to) => drop(fs::copy(root.join(from), made(root, to)).unwrap()),
            Rename(from, to) => fs::rename(root.join(from), root.join(to)).unwrap(),
            Remove(path) => remove(&root.join(path)),
            Crlf(file) => fs::write(root.join(file), read(file).replace('\n', "\r\n")).unwrap(),
        }
    }
}

/// The place of a file that is to be made.
fn made(root: &Path, file: &str) -> PathBuf {
    let path = root.join(file);
    fs::create_dir_all(path.parent().unwrap()).unwrap();
    path
}

fn git(folder: &Path, arguments: &[&str]) {
    let identity = [
        "-c",
        "user.name=t",
        "-c",
        "user.email=t@example.org",
        "-c",
        "commit.gpgsign=false",
    ];
    let output = Command::new("git")
        .current_dir(folder)
        .args(identity)
        .args(arguments)
        .output()
        .unwrap();
    assert!(
        output.status.success(),
        "git {arguments:?}: {}",
        stderr(&output)
    );
}

fn commit_all(root: &Path) {
    git(root, &["add", "-A"]);
    git(root, &["commit", "-q", "-m", "before the change"]);
}

/// The JSON report.
fn report(root: &Path, more: &[&str]) -> Value {
    let output = mhlint(root, &[&["check", ".", "--report", "json"], more].concat());
    serde_json::from_slice(&output.stdout)
        .unwrap_or_else(|error| panic!("{error}: {}", stderr(&output)))
}

/// Findings of a report by their identity.
type Findings = BTreeMap<String, Value>;

fn findings(report: &Value) -> Findings {
    let findings = report["findings"].as_array().unwrap();
    let named = |finding: &Value| {
        (
            finding["fingerprint"].as_str().unwrap().to_owned(),
            finding.clone(),
        )
    };
    let by_name: Findings = findings.iter().map(named).collect();
    assert_eq!(
        by_name.len(),
        findings.len(),
        "two findings of one fingerprint"
    );
    by_name
}

/// What became of a finding: `new`, `worse` or `gone`, its fingerprint, rule and path.
#[derive(Debug, Clone, PartialEq, Eq, PartialOrd, Ord)]
struct News {
    what: &'static str,
    fingerprint: String,
    rule: String,
    path: String,
}

impl News {
    fn of(what: &'static str, finding: &Value) -> Self {
        let [fingerprint, rule, path] =
            ["fingerprint", "rule", "path"].map(|key| finding[key].as_str().unwrap().to_owned());
        Self {
            what,
            fingerprint,
            rule,
            path,
        }
    }

    /// Whether both say the same. Of a group only its new part is shown, where that is: paths may
    /// differ.
    fn is_also(&self, other: &Self) -> bool {
        (self.what, &self.fingerprint) == (other.what, &other.fingerprint)
    }

    /// Whether a row of the table means it.
    fn is_meant(&self, row: &str) -> bool {
        let words: Vec<&str> = row.split(' ').collect();
        words[0] == self.what && words[1] == self.rule && self.path.ends_with(words[2])
    }
}

/// What two whole reports say beside each other.
fn difference(before: &Findings, after: &Findings) -> Vec<News> {
    let mut all = gone(before, after);
    for (fingerprint, finding) in after {
        match before.get(fingerprint) {
            None => all.push(News::of("new", finding)),
            Some(old) if badness(old) < badness(finding) => all.push(News::of("worse", finding)),
            Some(_) => {}
        }
    }
    all
}

fn gone(before: &Findings, after: &Findings) -> Vec<News> {
    let gone = before
        .iter()
        .filter(|(fingerprint, _)| !after.contains_key(*fingerprint));
    gone.map(|(_, finding)| News::of("gone", finding)).collect()
}

/// Level and count.
fn badness(finding: &Value) -> (Option<usize>, Option<u64>) {
    let level = finding["level"].as_str().unwrap();
    let level = ["info", "warning", "error"]
        .iter()
        .position(|name| *name == level);
    (level, finding["evidence"]["count"].as_u64())
}

/// What a comparison shows.
fn shown(before: &Findings, compared: &Findings) -> Vec<News> {
    let what = |fingerprint| {
        if before.contains_key(fingerprint) {
            "worse"
        } else {
            "new"
        }
    };
    compared
        .iter()
        .map(|(fingerprint, finding)| News::of(what(fingerprint), finding))
        .collect()
}

/// What only the first has.
fn without(all: &[News], others: &[News]) -> Vec<News> {
    all.iter()
        .filter(|one| !others.iter().any(|other| one.is_also(other)))
        .cloned()
        .collect()
}

/// What differs between the rows of a table and what they are for.
fn amiss(rows: &[&str], mut news: Vec<News>) -> Vec<String> {
    let mut amiss = Vec::new();
    for row in rows {
        match news.iter().position(|one| one.is_meant(row)) {
            Some(at) => drop(news.remove(at)),
            None => amiss.push(format!("not told: {row}")),
        }
    }
    amiss.extend(
        news.iter()
            .map(|one| format!("not in the table: {} {} {}", one.what, one.rule, one.path)),
    );
    amiss
}

/// The repository as it was, without what git knows of it.
fn copy_of(root: &Path, to: &Path) -> PathBuf {
    for entry in fs::read_dir(root)
        .unwrap()
        .map(Result::unwrap)
        .filter(|entry| entry.file_name() != ".git")
    {
        copy_folder(&entry.path(), &to.join(entry.file_name()));
    }
    to.to_owned()
}

/// Makes a change to a clone, and gives what is wrong with the reports on it.
fn try_change(original: &Path, change: &Change) -> Vec<String> {
    let folder = tempfile::tempdir().unwrap();
    let root = folder.path().join("now");
    git(
        folder.path(),
        &["clone", "-q", original.to_str().unwrap(), "now"],
    );
    if !change.before.is_empty() {
        change.before.iter().for_each(|edit| edit.apply(&root));
        commit_all(&root);
    }
    let earlier = if change.before.is_empty() {
        original.to_owned()
    } else {
        copy_of(&root, &folder.path().join("before"))
    };
    let before = findings(&report(&earlier, &[]));
    change.edits.iter().for_each(|edit| edit.apply(&root));
    let after = findings(&report(&root, &[]));
    let since = report(&root, &["--since", "HEAD"]);
    let against = report(&root, &["--against", earlier.to_str().unwrap()]);
    git(&root, &["add", "-A"]);
    let staged = report(&root, &["--staged"]);
    let mut faults = Vec::new();
    for (option, other) in [("--against", &against), ("--staged", &staged)] {
        let differs = |what: &str, one: &Value, other: &Value| {
            format!("{option}, {what}: {other}\n  not {one}")
        };
        if other["findings"] != since["findings"] {
            faults.push(differs("findings", &since["findings"], &other["findings"]));
        }
        if other["compared"]["gone"] != since["compared"]["gone"] {
            faults.push(differs(
                "gone",
                &since["compared"]["gone"],
                &other["compared"]["gone"],
            ));
        }
    }
    let mut told = shown(&before, &findings(&since));
    let gone = gone(&before, &after);
    if since["compared"]["gone"] != gone.len() {
        faults.push(format!(
            "{} gone, not {}",
            since["compared"]["gone"],
            gone.len()
        ));
    }
    told.extend(gone);
    let plain = difference(&before, &after);
    let otherwise = [without(&told, &plain), without(&plain, &told)].concat();
    faults.extend(
        amiss(change.otherwise, otherwise)
            .into_iter()
            .map(|fault| format!("whole reports: {fault}")),
    );
    faults.extend(amiss(change.brings, told));
    faults
        .iter()
        .map(|fault| format!("{}: {fault}", change.name))
        .collect()
}

#[test]
#[ignore = "needs the corpora: MHLINT_CORPORA=FOLDER cargo test -- --ignored"]
fn a_change_brings_what_it_brings() {
    let folder = tempfile::tempdir().unwrap();
    let original = folder.path();
    copy_folder(&corpus("makehuman2/data"), &original.join("data"));
    git(original, &["init", "-q", "-b", "main"]);
    commit_all(original);
    let faults: Vec<String> = CHANGES
        .par_iter()
        .flat_map_iter(|change| try_change(original, change))
        .collect();
    assert!(
        faults.is_empty(),
        "{} faults\n{}",
        faults.len(),
        faults.join("\n")
    );
}
