//! Text must be UTF-8.

use super::super::archived::weigh;
use super::super::{Check, Rule, RuleCx};
use super::loader::{Moment, is_met, moment};
use crate::diag::{Application, Finding, Level, Place, RuleInfo};
use crate::discover::Kind;
use crate::repo::{FileFacts, View};

pub(in crate::rules) static RULE: Rule = Rule {
    info: RuleInfo {
        breaks: &[(Application::Makehuman2, "stops with a UnicodeDecodeError that nothing catches")],
        docs: "MakeHuman 2 reads JSON, targets, meshes and BVH as strict UTF-8. One letter in Latin-1 or a Windows code page, even in a \
            comment, or a file saved as UTF-16, ends the program with a UnicodeDecodeError: at start for everything that is \
            loaded or scanned then, otherwise when the asset is used.\n\nThe loaders of clothes, materials and models drop bytes that \
            are no UTF-8. But the asset scan at start reads `.mhclo`, `.proxy`, `.mhm` and `.meta` strictly, so there the same byte is \
            fatal, too; only materials and files that the scan does not reach merely lose the letters.\n\nOpen the file in an editor \
            and save it as UTF-8 without byte order mark.",
        ..RuleInfo::new("file-not-utf8", Level::Error, "a text file that is not UTF-8")
    },
    check: Check::Repository(run),
};

fn run(view: &View<'_>, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    let Some(view) = view.makehuman2() else { return };
    let texts = view.layers.checked.files.values().filter(|file| file.kind.is_text());
    for file in texts.filter(|file| is_met(view, file)) {
        let Some(at) = file.encoding.invalid_utf8_at else { continue };
        let guess = file.encoding.guess.unwrap_or("another encoding");
        let message = format!("`{}` is not UTF-8 (probably {guess})", file.file_name());
        let (level, effect) = consequence(file);
        let finding = RULE
            .at(file, Place::Span(at..at + 1), message)
            .level(level)
            .breaks(Application::Makehuman2, effect)
            .help("save the file as UTF-8 without byte order mark");
        out.push(if file.kind == Kind::Target { weigh(&view.target(file), finding) } else { finding });
    }
}

fn consequence(file: &FileFacts) -> (Level, &'static str) {
    let drops_bytes = matches!(file.kind, Kind::Clothes | Kind::Material | Kind::Model | Kind::MotionMeta);
    match moment(file) {
        Moment::Never => (Level::Warning, "does not read it; tools that do stop"),
        Moment::Scan => (Level::Error, "stops at start while it scans the assets"),
        Moment::Start => (Level::Error, "stops at start with a UnicodeDecodeError"),
        Moment::Use if drops_bytes => (Level::Warning, "drops the bytes that are no UTF-8"),
        Moment::Use => (Level::Error, "stops with a UnicodeDecodeError when the file is used"),
    }
}
