//! Packed files that cannot be unpacked.

use super::super::cause::consequence::{Damage, Moment, consequence, moment};
use super::super::units::bytes as size;
use super::super::unpacking::plain;
use super::super::{Check, Rule, RuleCx};
use mhlint_diag::{
    Application::{Makehuman2, Mpfb},
    Finding, Level, Place, RuleInfo,
};
use mhlint_repo::{FileFacts, View};
use mhlint_source::GzipFault;

pub(crate) static RULE: Rule = Check::File(run).rule(RuleInfo {
    breaks: &[
        (Makehuman2, "never reads packed targets"),
        (Mpfb, "fails with an exception when it unpacks the target"),
    ],
    docs: include_str!("gzip_corrupt.md").trim_ascii_end(),
    ..RuleInfo::new(
        "file-gzip-corrupt",
        Level::Error,
        "a packed file that is cut off, damaged or followed by other data",
    )
});

fn run(view: &View<'_>, file: &FileFacts, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    let message = match &file.gzip_fault {
        Some(GzipFault::Corrupt(reason)) => format!("cannot be unpacked: {}", plain(reason)),
        Some(GzipFault::TrailingGarbage { bytes }) => {
            format!(
                "{} of other data after the end of the packed data",
                size(*bytes as u64)
            )
        }
        Some(GzipFault::Bomb { .. }) | None => return,
    };
    let help = if moment(view, &file.rel) == Moment::Never {
        let application = view.application().title();
        format!(
            "get the file again and unpack it, or export the target as a plain `.target`: \
                {application} reads nothing else"
        )
    } else {
        "pack the file again from its source".to_owned()
    };
    let finding = RULE.at(file, Place::File, message).help(help);
    out.extend(consequence(view, &file.rel, Damage::Packed).map(|loss| loss.of(view, finding)));
}
