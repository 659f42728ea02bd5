//! What a rule is: declared data and a function over facts.

use std::collections::BTreeMap;

use super::side_by_side::SideBySide;
use mhlint_diag::{Application, Finding, OptionInfo, Place, RuleInfo, Suggestions, Upkeep};
use mhlint_eval::measures::Measures;
use mhlint_repo::{Body, FileFacts, Layer, View, makehuman1, makehuman2, mpfb};

/// A rule. It runs where one of the applications that its `breaks` name is checked.
pub struct Rule {
    /// Declared half.
    pub info: RuleInfo,
    /// Checking half.
    pub check: Check,
}

/// What a rule looks at. A rule takes the narrowest, and what all applications have before what one
/// of them has.
pub enum Check {
    /// Each file of the checked layer.
    File(fn(&View<'_>, &FileFacts, &RuleCx<'_>, &mut Vec<Finding>)),
    /// Each body.
    Body(fn(&Body<'_>, &RuleCx<'_>, &mut Vec<Finding>)),
    /// Each base mesh of `MakeHuman` 2, over all layers.
    Makehuman2(fn(&makehuman2::View<'_>, &makehuman2::Base<'_>, &RuleCx<'_>, &mut Vec<Finding>)),
    /// The data of `MakeHuman` 2 as a whole: what its lists show.
    Makehuman2Library(fn(&makehuman2::View<'_>, &RuleCx<'_>, &mut Vec<Finding>)),
    /// Each base mesh of `MakeHuman` 2 with what is for it, the data of `MakeHuman` 1, and those of
    /// MPFB.
    EachBase(
        fn(&makehuman2::View<'_>, &makehuman2::Base<'_>, &RuleCx<'_>, &mut Vec<Finding>),
        fn(&makehuman1::View<'_>, &RuleCx<'_>, &mut Vec<Finding>),
        fn(&mpfb::View<'_>, &RuleCx<'_>, &mut Vec<Finding>),
    ),
    /// The data of `MakeHuman` 2 as a whole, and those of `MakeHuman` 1: what their lists show.
    Libraries(
        fn(&makehuman2::View<'_>, &RuleCx<'_>, &mut Vec<Finding>),
        fn(&makehuman1::View<'_>, &RuleCx<'_>, &mut Vec<Finding>),
    ),
    /// What the lists of all three show: `MakeHuman` 2, `MakeHuman` 1, MPFB.
    LibrariesOfAll(
        fn(&makehuman2::View<'_>, &RuleCx<'_>, &mut Vec<Finding>),
        fn(&makehuman1::View<'_>, &RuleCx<'_>, &mut Vec<Finding>),
        fn(&mpfb::View<'_>, &RuleCx<'_>, &mut Vec<Finding>),
    ),
    /// The data of `MakeHuman` 1.
    Makehuman1(fn(&makehuman1::View<'_>, &RuleCx<'_>, &mut Vec<Finding>)),
    /// The data of MPFB.
    Mpfb(fn(&mpfb::View<'_>, &RuleCx<'_>, &mut Vec<Finding>)),
    /// Each body with what evaluation measured on it.
    Numeric(fn(&Body<'_>, &Measures, &RuleCx<'_>, &mut Vec<Finding>)),
    /// All layers, whatever the application.
    Repository(fn(&View<'_>, &RuleCx<'_>, &mut Vec<Finding>)),
    /// Ignores and baseline, after everything else.
    Upkeep(fn(&Upkeep, &RuleCx<'_>, &mut Vec<Finding>)),
}

/// What a rule may ask besides facts.
pub struct RuleCx<'a> {
    /// Options that were set, by rule and name.
    pub options: &'a BTreeMap<(String, String), f64>,
    /// What misspelt names were meant to be; one run of a rule asks for so many and no more.
    pub suggestions: Suggestions,
    /// The assets of packs that are checked side by side.
    pub beside: &'a SideBySide,
}

impl Check {
    /// A rule that checks so.
    pub const fn rule(self, info: RuleInfo) -> Rule {
        Rule { info, check: self }
    }
}

impl Rule {
    /// A finding of this rule at `place` of `file`.
    pub fn at(&self, file: &FileFacts, place: Place, message: impl Into<String>) -> Finding {
        Finding::new(&self.info, file.path.clone(), place, message)
    }

    /// A finding about something in a layer that is no read file.
    pub fn in_layer(&self, layer: &Layer, rel: &str, message: impl Into<String>) -> Finding {
        Finding::new(&self.info, layer.display(rel), Place::File, message)
    }

    /// Whether the rule says what an application does. One on mhlint's own settings concerns every
    /// one.
    pub fn concerns(&self, application: Application) -> bool {
        self.info.breaks.is_empty()
            || self
                .info
                .breaks
                .iter()
                .any(|(concerned, _)| *concerned == application)
    }
}

impl<'a> RuleCx<'a> {
    /// For one run of a rule.
    pub fn new(options: &'a BTreeMap<(String, String), f64>, beside: &'a SideBySide) -> Self {
        Self {
            options,
            suggestions: Suggestions::default(),
            beside,
        }
    }

    /// Value of an option of `rule`: as set, or its default.
    pub fn option(&self, rule: &Rule, name: &'static str) -> f64 {
        let declared = rule.info.options.iter().find(|option| option.name == name);
        declared.map_or(f64::NAN, |option| self.option_of(rule.info.id, option))
    }

    /// The same for an option that several rules ask for: that of the rule `id`.
    pub fn option_of(&self, id: &str, option: &OptionInfo) -> f64 {
        self.options
            .get(&(id.to_owned(), option.name.to_owned()))
            .copied()
            .unwrap_or(option.default)
    }
}

/// `1 target`, `3 targets`.
pub(super) fn counted(count: impl ToString, thing: &str) -> String {
    let count = count.to_string();
    format!("{count} {thing}{}", if count == "1" { "" } else { "s" })
}

/// The verb behind so many things.
pub(super) const fn are(count: usize) -> &'static str {
    if count == 1 { "is" } else { "are" }
}

/// ` (3 such lines)` behind a message on the first of several; nothing behind one on a single case.
pub(super) fn such(count: impl ToString, things: &str) -> String {
    match &*count.to_string() {
        "0" | "1" => String::new(),
        count => format!(" ({count} such {things})"),
    }
}

/// ` (and 2 more members)` behind a message that names the first of several; nothing behind one
/// that names the only one.
pub(super) fn and_more(count: usize, thing: &str) -> String {
    match count {
        0 | 1 => String::new(),
        count => format!(" (and {})", counted(count - 1, &format!("more {thing}"))),
    }
}

/// `bone a`; `bones a, b and c`; of many the first three.
pub(super) fn bones_in_words(bones: &[&str]) -> String {
    let quoted: Vec<String> = bones
        .iter()
        .take(3)
        .map(|bone| format!("`{bone}`"))
        .collect();
    match (bones.len(), quoted.as_slice()) {
        (1, _) => format!("bone {}", quoted.concat()),
        (2 | 3, [first @ .., last]) => format!("bones {} and {last}", first.join(", ")),
        (count, _) => format!(
            "bones {} and {} more",
            quoted.join(", "),
            count.saturating_sub(3)
        ),
    }
}

/// `a`, `a and b`, `a, b and c`; of more than five names the first five, `and 25 more`.
pub(super) fn enumerated<T: AsRef<str>>(names: &[T]) -> String {
    let names: Vec<&str> = names.iter().map(AsRef::as_ref).collect();
    match names.as_slice() {
        [] => String::new(),
        [only] => (*only).to_owned(),
        [first, second, third, fourth, fifth, _, ..] => {
            let more = names.len() - 5;
            format!("{first}, {second}, {third}, {fourth}, {fifth} and {more} more")
        }
        [others @ .., last] => format!("{} and {last}", others.join(", ")),
    }
}

/// `a`, `a or b`, `a, b or c`.
pub(super) fn either<T: AsRef<str>>(names: &[T]) -> String {
    let names: Vec<&str> = names.iter().map(AsRef::as_ref).collect();
    match names.as_slice() {
        [] => String::new(),
        [only] => (*only).to_owned(),
        [others @ .., last] => format!("{} or {last}", others.join(", ")),
    }
}

/// What to write in place of a letter that is not ASCII: accents go, other scripts are written in
/// letters from a to z.
pub(super) fn plain_letters(letter: char) -> &'static str {
    if letter < FIRST_OF_OTHER_SCRIPTS {
        "write it with plain letters, without accents: `Joerg` for `Jörg`"
    } else {
        "write it with letters from a to z"
    }
}

/// Behind the Latin letters with accents.
const FIRST_OF_OTHER_SCRIPTS: char = '\u{250}';

/// The help on a name that is unknown: a known one that is near, or else what to do.
pub(super) fn did_you_mean(near: Option<&str>, otherwise: impl Into<String>) -> String {
    near.map_or_else(
        || otherwise.into(),
        |near| format!("did you mean `{near}`?"),
    )
}

/// Letters of a text of a file that a message quotes. Names of files are never longer.
const QUOTED: usize = 255;

/// A text of a file as a message quotes it: whole, or with a mark where it was cut.
pub(super) fn shown(text: &str) -> String {
    match text.char_indices().nth(QUOTED) {
        Some((end, _)) => format!("{}…", text.get(..end).unwrap_or_default()),
        None => text.to_owned(),
    }
}
