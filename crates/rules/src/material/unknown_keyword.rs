//! Keywords must be those that the application reads.

use super::super::{Check, Rule, RuleCx, shown};
use super::blender;
use super::fault::{Fault, report};
use super::loader;
use super::others::of_others;
use super::spelling::{self, Meant};
use mhlint_diag::{
    Application::{Makehuman1, Makehuman2, Mpfb},
    Finding, Level, Place, RuleInfo, nearest,
};
use mhlint_formats::mhmat::{Line, Material, Unknown};
use mhlint_repo::{Surface, View};
use mhlint_source::Guess;

pub(crate) static RULE: Rule = Check::Repository(run).rule(RuleInfo {
    breaks: &[
        (Makehuman2, "silently ignores the line"),
        (Makehuman1, "silently ignores the line"),
        (Mpfb, "ignores the line, with a message in the log"),
    ],
    docs: include_str!("unknown_keyword.md").trim_ascii_end(),
    ..RuleInfo::new(
        "material-unknown-keyword",
        Level::Warning,
        "a keyword of a material that is not known",
    )
});

fn run(view: &View<'_>, cx: &RuleCx<'_>, out: &mut Vec<Finding>) {
    if view.is_mpfb() {
        return blender::unknown(&RULE, view, cx, out);
    }
    let own = view
        .surfaces()
        .iter()
        .filter(|surface| view.layers().is_checked(surface.file));
    // What is no text has a finding of its own.
    let is_text = |surface: &&Surface<'_>| {
        matches!(surface.file.encoding.guess, None | Some(Guess::SingleByte))
    };
    for surface in own.filter(is_text) {
        let material = surface.material;
        if material.lines.is_empty() && !is_marked(material) {
            out.extend(nothing_known(view, surface));
            continue;
        }
        let foreign = material
            .lines
            .iter()
            .filter_map(|line| of_others(surface, line));
        // A byte order mark has a finding of its own.
        let unknown = material
            .unknown
            .iter()
            .filter(|one| !one.word.text.starts_with(MARK));
        let of_shader = material
            .lines_of("shaderConfig")
            .filter(|_| loader::is_1(surface.application));
        let unknown = unknown.map(|one| unknown_word(cx, surface, one));
        let mut faults: Vec<Fault> = unknown
            .chain(foreign)
            .chain(of_shader.filter_map(of_config))
            .collect();
        faults.sort_by_key(|fault| start(&fault.place));
        report(&RULE, surface, faults, "begin with unknown words", out);
    }
}

const MARK: char = '\u{feff}';

fn is_marked(material: &Material) -> bool {
    material
        .unknown
        .first()
        .is_some_and(|one| one.word.text.starts_with(MARK))
}

/// A file that is something else.
fn nothing_known(view: &View<'_>, surface: &Surface<'_>) -> Option<Finding> {
    let first = surface.material.unknown.first()?;
    let place = Place::Span(first.word.span.clone());
    let finding = RULE
        .at(
            surface.file,
            place,
            "no line begins with a keyword of a material",
        )
        .key("all");
    let effect = "ignores all lines: the surface is white, without a name";
    Some(
        finding
            .effect_in(view.application(), effect)
            .help("restore the material, or export it again"),
    )
}

const SILENT: &str = "silently ignores the line";
const NAMELESS: &str = "silently ignores the line: the material has no name";

const fn start(place: &Place) -> usize {
    if let Place::Span(span) = place {
        span.start
    } else {
        0
    }
}

fn unknown_word(cx: &RuleCx<'_>, surface: &Surface<'_>, one: &Unknown) -> Fault {
    let text = shown(&one.word.text);
    let meant = spelling::meant(
        &one.word.text,
        |name| loader::reads(surface.application, name),
        &cx.suggestions,
    );
    // With a line of the keyword nothing is missing.
    let is_lost = |keyword: &str| surface.material.last(keyword).is_none();
    let (level, effect, help) = match meant {
        Meant::Keyword(near) => (Level::Warning, SILENT, format!("did you mean `{near}`?")),
        Meant::Glued("name") if is_lost("name") => {
            (Level::Warning, NAMELESS, spelling::parted("name", one))
        }
        Meant::Glued(keyword) if is_lost(keyword) => {
            (Level::Warning, SILENT, spelling::parted(keyword, one))
        }
        Meant::Glued(keyword) => (
            Level::Info,
            "ignores the line",
            spelling::parted(keyword, one),
        ),
        Meant::Nothing => (
            Level::Info,
            "ignores the line",
            "remove the line, or put `# ` in front of it".to_owned(),
        ),
    };
    Fault {
        message: format!("`{text}` is not a keyword of a material"),
        effect: effect.to_owned(),
        key: text,
        place: Place::Span(one.word.span.clone()),
        level,
        help,
    }
}

/// What can be switched on and off in a shader of MakeHuman 1
/// (`docs/loaders/makehuman1/materials.md#material-keywords`).
const PARTS: [&str; 8] = [
    "diffuse",
    "bump",
    "normal",
    "displacement",
    "spec",
    "vertexColors",
    "transparency",
    "ambientOcclusion",
];

/// A part that no shader has.
fn of_config(line: &Line) -> Option<Fault> {
    let text = shown(line.word(0));
    let help = match nearest(&text, PARTS) {
        Some(near) => format!("did you mean `{near}`?"),
        None => "remove the line".to_owned(),
    };
    (line.count > 0 && !PARTS.contains(&&*text)).then(|| Fault {
        message: format!("`shaderConfig` does not know `{text}`"),
        key: format!("shaderConfig {text}"),
        place: Surface::place(line),
        level: Level::Warning,
        effect: "logs a warning and ignores the line".to_owned(),
        help,
    })
}
