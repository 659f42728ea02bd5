//! Packed files that unpack to more than anybody wants in memory.

use super::super::cause::consequence::{Moment, moment};
use super::super::units::bytes;
use super::super::{Check, Rule, RuleCx};
use mhlint_diag::{
    Application::{Makehuman1, Makehuman2, Mpfb},
    Case, Finding, Level, Place, RuleInfo,
};
use mhlint_repo::{FileFacts, View};
use mhlint_source::{GzipFault, PackFault};

pub(crate) static RULE: Rule = Check::Repository(run).rule(RuleInfo {
    cannot_be_ignored: true,
    breaks: &[
        (
            Makehuman2,
            "unpacks the file without a limit until memory runs out",
        ),
        (
            Makehuman1,
            "unpacks the file without a limit until memory runs out",
        ),
        (
            Mpfb,
            "unpacks the file without a limit until memory or disk are full",
        ),
    ],
    docs: include_str!("decompression_bomb.md").trim_ascii_end(),
    ..RuleInfo::new(
        "file-decompression-bomb",
        Level::Error,
        "a packed file that unpacks to an unreasonable size",
    )
});

fn run(view: &View<'_>, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    view.files().for_each(|file| of_file(view, file, out));
    let layer = view.layers().checked;
    let fault = layer
        .pack
        .as_ref()
        .and_then(|pack| pack.faults.as_ref()?.fault.as_ref());
    if let Some(PackFault::Bomb { packed, unpacked }) = fault {
        let message = format!("{} unpack to {} or more", bytes(*packed), bytes(*unpacked));
        out.push(RULE.in_layer(layer, "", message).help(HELP).case(UNPACKED));
    }
}

/// No importer of its own unpacks it.
const UNPACKED: Case = &[(
    Makehuman1,
    Level::Error,
    "gets nothing of it: whoever unpacks it fills the disk",
)];

const HELP: &str = "do not open it; remove it unless you know where it comes from";

fn of_file(view: &View<'_>, file: &FileFacts, out: &mut Vec<Finding>) {
    let Some(GzipFault::Bomb { packed, unpacked }) = file.gzip_fault else {
        return;
    };
    let message = format!("{} unpack to {} or more", bytes(packed), bytes(unpacked));
    let finding = RULE.at(file, Place::File, message).help(HELP);
    // An application without gzip never opens it; people may.
    let is_opened = moment(view, &file.rel) != Moment::Never;
    let application = view.application();
    out.push(if is_opened {
        finding
    } else {
        finding.level_in(application, Level::Info).effect_in(
            application,
            "never opens it, because it does not support gzip",
        )
    });
}
