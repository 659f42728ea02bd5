//! A JSON must fit the schema of its format.

use super::super::cause::consequence::{is_accepted, of_value};
use super::super::cause::schema::{has_own_rule, stands_for};
use super::super::cause::{counts_as_missing, is_ignored_override};
use super::super::{Check, Rule, RuleCx};
use super::left_out;
use super::schema_help::edit;
use super::schema_words::{lack, sentence};
use mhlint_diag::{
    Application::{Makehuman1, Makehuman2, Mpfb},
    EXAMPLES, Evidence, Finding, Level, Place, RuleInfo, grouped,
};
use mhlint_json::{SchemaFault, UnknownKey};
use mhlint_repo::{FileFacts, View};

pub(crate) static RULE: Rule = Check::File(run).rule(RuleInfo {
    breaks: &[
        (
            Makehuman2,
            "crashes when it uses the value, usually at start with `TypeError` or `KeyError`",
        ),
        (Makehuman1, "fails where it uses the value"),
        (Mpfb, "crashes when it uses the value"),
    ],
    docs: include_str!("schema.md").trim_ascii_end(),
    counts: "values",
    ..RuleInfo::new(
        "json-schema",
        Level::Error,
        "a value that does not match the schema of its format",
    )
});

fn run(view: &View<'_>, file: &FileFacts, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    if is_ignored_override(file) || counts_as_missing(file) || has_own_rule(file) {
        return;
    }
    // Two missing keys of one object fail at the same keyword; they are two faults.
    let faults = file
        .schema
        .faults
        .iter()
        .filter(|fault| !is_accepted(view, file, fault));
    let by_keyword = grouped(faults.map(|fault| ((fault.keyword.as_str(), lack(fault)), fault)));
    out.extend(
        by_keyword
            .into_iter()
            .filter_map(|((keyword, lack), all)| finding(view, file, keyword, lack, &all)),
    );
    out.extend(left_out(
        &RULE,
        file,
        file.schema.faults_left_out,
        "schema error",
    ));
}

/// One finding for all values that fail in the same way.
fn finding(
    view: &View<'_>,
    file: &FileFacts,
    keyword: &str,
    lack: Option<String>,
    all: &[&SchemaFault],
) -> Option<Finding> {
    let first = all.first()?;
    let message = match all.len() {
        1 => sentence(first),
        count => format!("{} ({count} such values)", sentence(first)),
    };
    let mut finding = RULE.at(file, Place::Pointer(first.pointer.clone()), message);
    finding = finding
        .key(format!("{keyword}{}", lack.unwrap_or_default()))
        .help(help(file, first));
    // Of values that fail in the same way the worst counts.
    let usual = RULE.info.level_in(view.application());
    let each = all.iter().map(|fault| of_value(view, file, fault));
    if let Some(Some(loss)) = each.max_by_key(|loss| loss.map_or(usual, |loss| loss.level)) {
        finding = loss.of(view, finding);
    }
    for other in all.iter().skip(1).take(EXAMPLES - 1) {
        finding = finding.related(
            file.path.clone(),
            Place::Pointer(other.pointer.clone()),
            sentence(other),
        );
    }
    let parts = all.iter().map(|fault| &fault.name);
    Some(
        finding
            .parts(parts)
            .evidence(Evidence::of_cases(all.iter().map(|fault| &fault.pointer))),
    )
}

fn help(file: &FileFacts, fault: &SchemaFault) -> String {
    // A key that is missing under its name may be there under a misspelt one.
    let missing = fault.missing();
    let is_meant = |unknown: &&UnknownKey| {
        unknown
            .pointer
            .rsplit_once('/')
            .is_some_and(|(owner, _)| owner == fault.pointer)
            && missing.is_some_and(|missing| stands_for(unknown, missing))
    };
    if let Some((meant, missing)) = file.schema.unknown.iter().find(is_meant).zip(missing) {
        return format!("did you mean `{missing}` instead of `{}`?", meant.key);
    }
    edit(fault)
}
