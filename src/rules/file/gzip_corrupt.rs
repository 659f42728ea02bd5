//! Packed files that cannot be unpacked.

use super::super::cause::consequence::{Damage, Moment, consequence, moment};
use super::super::{Check, Rule, RuleCx};
use crate::diag::{Application, Finding, Level, Place, RuleInfo};
use crate::repo::{FileFacts, View};
use crate::source::GzipFault;

pub(in crate::rules) static RULE: Rule = Rule {
    info: RuleInfo {
        breaks: &[
            (Application::Makehuman2, "does not read packed targets at all"),
            (Application::Mpfb, "stops while it unpacks the target"),
        ],
        docs: "A `.gz` file ends in a checksum. If it was cut off by a broken download or a full disk, changed by a transfer in text \
            mode, or has something behind its end, what was in it is lost or no longer certain.\n\nMPFB stops with an exception. \
            MakeHuman 2 reads plain targets only and never opens a packed one; in its data folder the finding is an info.\n\nPack \
            the file again from its source.",
        ..RuleInfo::new(
            "file-gzip-corrupt",
            Level::Error,
            "a packed file that is truncated, damaged or followed by garbage",
        )
    },
    check: Check::File(run),
};

fn run(view: &View<'_>, file: &FileFacts, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    let message = match &file.gzip_fault {
        Some(GzipFault::Corrupt(reason)) => format!("cannot be unpacked: {reason}"),
        Some(GzipFault::TrailingGarbage { bytes }) => format!("{bytes} bytes of garbage behind the packed data"),
        Some(GzipFault::Bomb { .. }) | None => return,
    };
    let help = if moment(view, &file.rel) == Moment::Never {
        let application = view.application().title();
        format!("{application} reads plain targets only: put the unpacked target here, or remove the file")
    } else {
        "pack the file again from its source".to_owned()
    };
    let finding = RULE.at(file, Place::File, message).help(help);
    out.extend(consequence(view, &file.rel, Damage::Packed).map(|loss| loss.of(view, finding)));
}
