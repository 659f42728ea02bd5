//! What a rule is: declared data and a function over facts.

use std::collections::BTreeMap;

use crate::diag::{Finding, OptionInfo, Place, RuleInfo, Upkeep};
use crate::eval::measures::Measures;
use crate::repo::{Base, FileFacts, Layer, Repository};

/// A rule.
pub(crate) struct Rule {
    /// Declared half.
    pub(crate) info: RuleInfo,
    /// Judging half.
    pub(crate) check: Check,
}

/// What a rule looks at. A rule takes the narrowest.
pub(crate) enum Check {
    /// The files of the judged layer, whatever the application.
    Layer(fn(&Layer, &RuleCx<'_>, &mut Vec<Finding>)),
    /// One base mesh over all layers.
    Base(fn(&Repository<'_>, &Base<'_>, &RuleCx<'_>, &mut Vec<Finding>)),
    /// One base mesh with what evaluation measured on it.
    Numeric(fn(&Repository<'_>, &Base<'_>, &Measures, &RuleCx<'_>, &mut Vec<Finding>)),
    /// All layers.
    Repository(fn(&Repository<'_>, &RuleCx<'_>, &mut Vec<Finding>)),
    /// Mutes and baseline, after everything else.
    Upkeep(fn(&Upkeep, &RuleCx<'_>, &mut Vec<Finding>)),
}

/// What a rule may ask besides facts.
pub(crate) struct RuleCx<'a> {
    /// Options that were set, by rule and name.
    pub(crate) options: &'a BTreeMap<(String, String), f64>,
}

impl Rule {
    /// A finding of this rule at `place` of `file`.
    pub(crate) fn at(&self, file: &FileFacts, place: Place, message: impl Into<String>) -> Finding {
        Finding::new(&self.info, file.path.clone(), place, message)
    }

    /// A finding about something in a layer that is no read file.
    pub(crate) fn in_layer(&self, layer: &Layer, rel: &str, message: impl Into<String>) -> Finding {
        Finding::new(&self.info, layer.display(rel), Place::File, message)
    }
}

impl RuleCx<'_> {
    /// Value of an option of `rule`: as set, or its default.
    pub(crate) fn option(&self, rule: &Rule, name: &'static str) -> f64 {
        let declared = rule.info.options.iter().find(|option| option.name == name);
        declared.map_or(f64::NAN, |option| self.option_of(rule.info.id, option))
    }

    /// The same for an option that several rules ask for: that of the rule `id`.
    pub(crate) fn option_of(&self, id: &str, option: &OptionInfo) -> f64 {
        self.options.get(&(id.to_owned(), option.name.to_owned())).copied().unwrap_or(option.default)
    }
}
