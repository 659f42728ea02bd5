//! The picture of an asset in a list must be one.

use super::super::{Check, Rule, RuleCx};
use super::SUFFIXES;
use mhlint_diag::{
    Application::{Makehuman1, Makehuman2},
    Finding, Level, Place, RuleInfo,
};
use mhlint_discover::{extension, library_extension, listed_in};
use mhlint_formats::picture::PictureFault;
use mhlint_repo::{FileFacts, View};

pub(crate) static RULE: Rule = Check::File(run).rule(RuleInfo {
    breaks: &[
        (Makehuman2, "shows an empty picture in the list"),
        (Makehuman1, "shows an empty picture in the list"),
    ],
    docs: include_str!("unreadable_thumbnail.md").trim_ascii_end(),
    ..RuleInfo::new(
        "library-unreadable-thumbnail",
        Level::Warning,
        "a picture of an asset that is not one",
    )
});

fn run(view: &View<'_>, file: &FileFacts, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    let is_thumb = extension(&file.rel) == "thumb" && file.size > 0 && !file.encoding.lfs_pointer;
    let Some(picture) = file.picture().filter(|_| is_thumb && is_shown(view, file)) else {
        return;
    };
    let what = match picture.fault {
        Some(PictureFault::NotAPicture) => "is not a picture",
        Some(PictureFault::Header) => "has a damaged header",
        Some(PictureFault::NoPixels) => "has no pixels",
        Some(PictureFault::TooManyPixels | PictureFault::CutOff) => "ends too early",
        None => return,
    };
    let finding = RULE.at(file, Place::File, format!("`{}` {what}", file.file_name()));
    out.push(finding.help("save a PNG under this name, or remove the file"));
}

/// Whether a list shows it: MakeHuman 2 beside what it lists, MakeHuman 1 in a library, or in place
/// of all that is missing.
fn is_shown(view: &View<'_>, file: &FileFacts) -> bool {
    if view.is_makehuman1() {
        return !file.rel.contains('/')
            || file
                .rel
                .split('/')
                .next()
                .and_then(library_extension)
                .is_some();
    }
    let stem = file.rel.strip_suffix("thumb").unwrap_or(&file.rel);
    let layer = view.layers().checked;
    let is_listed = |suffix: &str| {
        let rel = format!("{stem}{suffix}");
        layer.file(&rel).is_some() && listed_in(&rel).is_some()
    };
    SUFFIXES.iter().any(|suffix| is_listed(suffix)) || layer.file(&format!("{stem}mhmat")).is_some()
}
