//! A licence is recorded as it is written.

use super::super::{Check, Rule};
use super::mpfb;
use crate::diag::{Application::Mpfb, Level, RuleInfo};

pub(in crate::rules) static RULE: Rule = Check::Body(|body, _, out| mpfb::names::licence(&RULE, body, out)).rule(RuleInfo {
    breaks: &[(Mpfb, "records another licence for the asset")],
    docs: "The comment `# license` names a licence that MPFB records as another one.\n\n\
        MPFB takes every line with `by` in it for CC-BY, and everything else for CC0: `AGPL3`, `CC-BY-SA` and the like are lost.\n\n\
        Nothing has to be done if the right licence is told elsewhere. Otherwise use CC0 or CC-BY.",
    ..RuleInfo::new("proxy-licence-unrecognised", Level::Warning, "a licence that is recorded as another one")
});
