//! The rules: one a file, one table of them all.
//!
//! A rule reads facts and says what would happen. It reads no files, knows no report and no other
//! rule.

// Only a few modules may use files, streams and the environment, and they allow this lint
// themselves; tests may use everything.
#![cfg_attr(not(test), warn(clippy::disallowed_methods))]

use std::sync::LazyLock;

mod archive;
mod archived;
mod aside;
mod base;
mod beside;
mod bvh;
mod catalog;
mod cause;
mod config;
mod editions;
mod expression;
mod file;
mod filter;
mod ink;
mod json;
mod library;
mod macros;
mod material;
mod mesh;
mod metadata;
mod model;
mod modelling;
mod modifiers;
mod numeric;
mod overlay;
mod pack;
mod parts;
mod pictures;
mod pose;
mod preset;
mod program;
mod proxy;
mod regions;
mod rig;
mod rule;
mod scene;
mod side_by_side;
mod skeleton;
mod target;
mod unfit;
mod units;
mod unpacking;
mod uv;
mod wearers;
mod weights;

pub use archived::lower_archived;
pub use aside::lower_aside;
use beside::meant_beside;
pub use cause::consequence::Unread;
pub use cause::consequence::unread;
pub use cause::outdated::drop_outdated;
pub use cause::unmerged::drop_unmerged;
pub use editions::word_for_version;
pub use library::side_by_side::add_pack;
pub use rule::{Check, Rule, RuleCx};
use rule::{
    and_more, are, bones_in_words, counted, did_you_mean, either, enumerated, plain_letters, shown,
    such,
};
pub use side_by_side::SideBySide;
pub use wearers::name_wearers;

/// The rules of each family. A rule that its family does not list does not exist.
static FAMILIES: &[&[&Rule]] = &[
    archive::RULES,
    base::RULES,
    bvh::RULES,
    catalog::RULES,
    config::RULES,
    expression::RULES,
    file::RULES,
    filter::RULES,
    ink::RULES,
    json::RULES,
    library::RULES,
    macros::RULES,
    material::RULES,
    mesh::RULES,
    metadata::RULES,
    model::RULES,
    modelling::RULES,
    modifiers::RULES,
    numeric::RULES,
    overlay::RULES,
    pack::RULES,
    parts::RULES,
    pose::RULES,
    preset::RULES,
    program::RULES,
    proxy::RULES,
    rig::RULES,
    scene::RULES,
    skeleton::RULES,
    target::RULES,
    uv::RULES,
    weights::RULES,
];

/// Every rule, sorted by id.
pub static RULES: LazyLock<Vec<&Rule>> = LazyLock::new(|| {
    let mut all = FAMILIES.concat();
    all.sort_by_key(|rule| rule.info.id);
    all
});

/// A share in percent, with a decimal where it is small.
fn percent(share: f64) -> String {
    let percent = share * 100.0;
    if percent < 10.0 {
        format!("{percent:.1} %")
    } else {
        format!("{percent:.0} %")
    }
}

#[cfg(test)]
mod tests {
    use super::RULES;

    #[test]
    fn every_rule_says_what_the_application_does() {
        // Settings of mhlint itself are no application's matter.
        for rule in RULES
            .iter()
            .filter(|rule| !matches!(rule.info.family(), "config" | "baseline"))
        {
            let effects = rule.info.breaks;
            assert!(!effects.is_empty(), "{}", rule.info.id);
            assert!(
                effects.iter().all(|(_, effect)| !effect.trim().is_empty()),
                "{}",
                rule.info.id
            );
        }
    }
}
