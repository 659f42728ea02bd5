//! Finds the rules that the texts in ignores name. Each text is looked up once, however many
//! comments and findings there are.

use std::cell::RefCell;
use std::collections::HashMap;
use std::rc::Rc;

use mhlint_config::Selector;
use mhlint_diag::Suggestions;
use mhlint_rules::RULES;

/// The rules that were found for each text.
#[derive(Default)]
pub(super) struct NamedRules {
    found: RefCell<HashMap<String, Rc<[&'static str]>>>,
    suggestions: Suggestions,
}

impl NamedRules {
    /// The rules that match a text; none if the text is no valid glob.
    pub(super) fn of(&self, text: &str) -> Rc<[&'static str]> {
        if let Some(rules) = self.found.borrow().get(text) {
            return Rc::clone(rules);
        }
        let ids = RULES.iter().map(|rule| rule.info.id);
        let rules: Rc<[&'static str]> = match Selector::new(text, 0..0) {
            Ok(selector) => ids.filter(|id| selector.fits(id)).collect(),
            Err(_) => Rc::new([]),
        };
        self.found
            .borrow_mut()
            .insert(text.to_owned(), Rc::clone(&rules));
        rules
    }

    /// The rule whose name is most like a text.
    pub(super) fn nearest(&self, text: &str) -> Option<&'static str> {
        self.suggestions
            .nearest(text, RULES.iter().map(|rule| rule.info.id))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_text_is_compiled_once() {
        let named = NamedRules::default();
        for _ in 0..1000 {
            assert!(named.of("json-*").contains(&"json-syntax"));
            assert!(named.of("{").is_empty());
        }
        assert_eq!(named.found.borrow().len(), 2);
        assert!(Rc::ptr_eq(&named.of("json-*"), &named.of("json-*")));
    }
}
