//! An asset has an identity.

use super::super::{Check, Rule, RuleCx};
use super::{missing::missing, texts};
use crate::diag::{Application::Makehuman2, Finding, Level, RuleInfo};
use crate::repo::Body;

pub(in crate::rules) static RULE: Rule = Check::Body(run).rule(RuleInfo {
    breaks: &[(Makehuman2, "crashes with `IndexError` when a model saved with the asset is loaded")],
    docs: "An asset has no `uuid`.\n\n\
        MakeHuman 2 writes the name and uuid of each asset into a saved model. Without a uuid the line has a word too \
        few, and loading the model crashes with `IndexError`.\n\n\
        The library reads the file up to the first vertex row with several numbers, so a `uuid` below the rows does \
        not count.\n\n\
        Add a line `uuid` with a new identifier above `verts`.",
    ..RuleInfo::new("proxy-missing-uuid", Level::Error, "an asset has no uuid")
});

fn run(body: &Body<'_>, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    for text in texts(body) {
        if text.clothes.scanned.uuid.is_none() {
            out.extend(
                missing(&text, "uuid", "new uuid, from a generator")
                    .map(|(place, message, help)| RULE.at(text.file, place, message).help(help)),
            );
        }
    }
}
