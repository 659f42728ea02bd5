//! Packed files that cannot be unpacked.

use super::super::{Check, Rule, RuleCx};
use crate::diag::{Application, Finding, Level, Place, RuleInfo};
use crate::repo::Layer;
use crate::source::GzipFault;

pub(in crate::rules) static RULE: Rule = Rule {
    info: RuleInfo {
        breaks: &[
            (Application::Makehuman2, "does not read packed targets at all"),
            (Application::Mpfb, "stops while it unpacks the target"),
        ],
        docs: "A `.gz` file ends in a checksum. If it was cut off by a broken download or a full disk, changed by a transfer in text \
            mode, or has something behind its end, what was in it is lost or no longer certain.\n\nMakeHuman 2 reads plain targets \
            only; MPFB stops with an exception.\n\nPack the file again from its source.",
        ..RuleInfo::new(
            "file-gzip-corrupt",
            Level::Error,
            "a packed file that is truncated, damaged or followed by garbage",
        )
    },
    check: Check::Layer(run),
};

fn run(layer: &Layer, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    for file in layer.files.values() {
        let message = match &file.gzip_fault {
            Some(GzipFault::Corrupt(reason)) => format!("cannot be unpacked: {reason}"),
            Some(GzipFault::TrailingGarbage { bytes }) => format!("{bytes} bytes of garbage behind the packed data"),
            Some(GzipFault::Bomb { .. }) | None => continue,
        };
        out.push(RULE.at(file, Place::File, message).help("pack the file again from its source"));
    }
}
