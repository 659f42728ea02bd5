//! Packed files that unpack to more than anybody wants in memory.

use super::super::cause::consequence::{Moment, moment};
use super::super::{Check, Rule, RuleCx};
use crate::diag::{Application, Finding, Level, Place, RuleInfo};
use crate::repo::{FileFacts, View};
use crate::source::GzipFault;

pub(in crate::rules) static RULE: Rule = Rule {
    info: RuleInfo {
        cannot_be_ignored: true,
        breaks: &[(Application::Makehuman2, "unpacks archives without a limit: memory runs out")],
        docs: "A small packed file can hold gigabytes of zeros. Loaders unpack without asking, and the computer runs out of memory. \
            Packed assets shrink three to ten times; `mhlint` gives up beyond 512 MiB, or beyond 200 times the packed size once \
            16 MiB are passed. For `.npz`, `.mhbin` and `.zip` the sizes stated in the archive are added up; the arrays of the \
            first two shrink less, and the limit is 32 times the packed size once 64 KiB are passed.\n\nThis rule \
            cannot be muted. Do not open the file; ask where it comes from.",
        ..RuleInfo::new(
            "file-decompression-bomb",
            Level::Error,
            "a packed file that unpacks beyond every sensible size",
        )
    },
    check: Check::File(run),
};

fn run(view: &View<'_>, file: &FileFacts, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    let Some(GzipFault::Bomb { packed, unpacked }) = file.gzip_fault else { return };
    let message = format!("{packed} bytes unpack to {unpacked} bytes or more");
    let finding = RULE.at(file, Place::File, message).help("do not open it; ask where it comes from");
    // An application without gzip never opens it; people may.
    let is_opened = moment(view, &file.rel) != Moment::Never;
    let application = view.application();
    out.push(if is_opened {
        finding
    } else {
        finding.level_in(application, Level::Info).effect_in(application, "never opens it, as it has no gzip")
    });
}
