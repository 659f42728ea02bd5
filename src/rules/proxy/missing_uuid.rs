//! An asset has an identity.

use super::super::cause::library::empty_uuid;
use super::super::{Check, Rule, RuleCx};
use super::{missing::missing, texts};
use crate::diag::{
    Application::{Makehuman1, Makehuman2},
    Finding, Level, RuleInfo,
};
use crate::repo::Body;

pub(in crate::rules) static RULE: Rule = Check::Body(run).rule(RuleInfo {
    breaks: &[(Makehuman2, "crashes with `IndexError` when a model saved with the asset is loaded"), (Makehuman1, "raises `TypeError` when the asset is put on beside another one, and saved models lose it")],
    docs: "An asset has no `uuid`.\n\n\
        MakeHuman 2 writes the name and uuid of each asset into a saved model. Without a uuid the line has a word too \
        few, and loading the model crashes with `IndexError`.\n\n\
        The library reads the file up to the first vertex row with several numbers, so a `uuid` below the rows does \
        not count.\n\nMakeHuman 1 cannot sort assets of one `z_depth` without it: putting two of them on raises `TypeError`. A saved model looks for the name as uuid and loses the asset. A topology needs none.\n\n\
        Add a line `uuid` with a new identifier above `verts`.",
    ..RuleInfo::new("proxy-missing-uuid", Level::Error, "an asset has no uuid")
});

fn run(body: &Body<'_>, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    for text in texts(body) {
        // Topologies do without in MakeHuman 1; an empty line is worse there, and has a finding of its own.
        let is_lost = || !text.worn.is_topology() && text.last("uuid").is_none() && empty_uuid(text.clothes).is_none();
        let is_missing = if text.is_makehuman1() { is_lost() } else { text.clothes.scanned.uuid.is_none() };
        if is_missing {
            out.extend(
                missing(&text, "uuid", "new uuid, from a generator")
                    .map(|(place, message, help)| RULE.at(text.file, place, message).help(help)),
            );
        }
    }
}
