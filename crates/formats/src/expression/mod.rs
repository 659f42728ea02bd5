//! Python expressions in assets: which of them may be evaluated without harm
//! (`docs/loaders/makehuman2/sliders.md#display-and-formulas`).
//!
//! MakeHuman 2 hands `display.formula` and `random.rules` to Python's `eval`. Here nothing is
//! evaluated: a tokenizer and a recursive descent parser accept numbers, the one variable,
//! arithmetic, comparison chains, `and`/`or`/`not`, `True`/`False`, conditional expressions,
//! `round`, `str`, texts and their concatenation, and name the first thing beyond that list. The
//! boolean words are on the list because they can neither call anything nor grow anything.

mod grammar;
mod operand;
mod token;

use std::ops::Range;

pub use grammar::{check, results};
pub use operand::Results;

/// Why a text must not, or cannot, be evaluated.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Fault {
    /// The offending bytes.
    pub span: Range<usize>,
    /// What kind of fault.
    pub kind: FaultKind,
    /// What is there: continues the sentence "the formula …".
    pub what: String,
}

/// What evaluation would lead to.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum FaultKind {
    /// Python would evaluate more than the allow list: names, attributes, calls, comprehensions.
    Foreign,
    /// Python may never come to an end, or run out of memory.
    Endless,
    /// Python rejects the text each time.
    Syntax,
    /// Python raises an exception each time.
    Raises,
    /// Python raises a `TypeError` each time: an operator that is not for numbers with decimals.
    Mistyped,
    /// Python makes a pair of it, which is never exactly false.
    Pair,
    /// A layout is not for the value, or for none.
    Layout,
}

impl FaultKind {
    /// Whether `str.format` rejects such a text without running anything of it.
    pub const fn is_of_layout(self) -> bool {
        matches!(self, Self::Layout | Self::Raises | Self::Syntax)
    }
}

impl Fault {
    fn new(kind: FaultKind, span: Range<usize>, what: impl Into<String>) -> Self {
        Self {
            span,
            kind,
            what: what.into(),
        }
    }
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;

    fn kind(text: &str) -> Option<FaultKind> {
        check(text, "val").err().map(|fault| fault.kind)
    }

    #[test]
    fn what_assets_ship_is_accepted() {
        for text in [
            "'neutral' if 0.49 < val < 0.51 else 'male' if val > 0.99 else 'female' if val < 0.01 else \
             str(round (100.0 - val*100.0)) + '% female, ' + str(round(val*100.0)) + '% male'",
            "round(1 + val / (0.5 /24)) if val < .5 else round(25 + (val-0.5) / (0.5 /65))",
            "round(val*100, 2)",
            "  - val ** 2 // 1_000 % 0x1f\n",
            "r'\\d' 'b' \"\"\"c\n\"\"\" + u'\\x41'",
            "not val < 1 and True or 2 ** val > 1",
            "(val # comment\n + 1)",
            "1if val else 2.",
            "1 / val if val > 0 else 0",
            "val and 1 / val",
            "'%d' % (val * 100)",
            "'%5.1f%%' % (val * 100) + ' old'",
        ] {
            assert_eq!(check(text, "val"), Ok(()), "{text}");
        }
    }

    #[test]
    fn code_is_foreign() {
        for text in [
            "__import__('os').system('true')",
            "val.__class__",
            "'a'.join('b')",
            "val[0]",
            "[1]",
            "{1: 2}",
            "lambda: 1",
            "round.__self__",
            "str",
            "round(val, ndigits=1)",
            "round(*'a')",
            "(val for val in 'a')",
            "f'{val}'",
            "b'a'",
            "(val := 1)",
            "\u{ff56}al",
            "x",
            "1j",
        ] {
            assert_eq!(kind(text), Some(FaultKind::Foreign), "{text}");
        }
    }

    #[test]
    fn what_python_refuses_is_syntax() {
        for text in [
            "",
            "val +",
            "(val",
            "val)",
            "val val",
            "'a",
            "'a\nb'",
            "val = 1",
            "1 if val",
            "007",
            "1__0",
            "import os",
            "val\n+1",
            "'\\x4'",
            "1 + not 2",
            "val $",
            "3val",
            "val; 1",
            "\0",
        ] {
            assert_eq!(kind(text), Some(FaultKind::Syntax), "{text:?}");
        }
    }

    #[test]
    fn bombs_are_endless() {
        for text in [
            "9**9**9",
            "(9**9)**9",
            "9 ** round(val * 1e9)",
            "'a' * 99999",
            "'%99999d' % 1",
            "'%d %d' % val",
            "'%d' 'x' % val",
            "'%*d' % val",
            "'%d' % str(val)",
            "round(5, -99999999)",
        ] {
            assert_eq!(kind(text), Some(FaultKind::Endless), "{text}");
        }
    }

    #[test]
    fn what_always_raises_is_told_apart() {
        for text in [
            "'a' + 1",
            "val - 'a'",
            "val < 'a'",
            "round('a')",
            "val / 0",
            "round(val, 1.5)",
            "str()",
        ] {
            assert_eq!(kind(text), Some(FaultKind::Raises), "{text}");
        }
    }

    #[test]
    fn operators_that_are_not_for_numbers_run_nothing() {
        for text in ["val & 1", "val ^ 2", "~val", "val << 1", "val in 'a'"] {
            assert_eq!(kind(text), Some(FaultKind::Mistyped), "{text}");
        }
        assert_eq!(
            (kind("val < 0,5"), kind("val is 1")),
            (Some(FaultKind::Pair), Some(FaultKind::Foreign))
        );
    }

    #[test]
    fn the_variable_can_be_zero_unless_a_condition_is_there() {
        for text in [
            "1 / val",
            "2 // (val)",
            "1 % -val < 5",
            "(1 if val else 2) + 1 / val",
        ] {
            assert_eq!(kind(text), Some(FaultKind::Raises), "{text}");
        }
        assert_eq!(check("1 / (val + 1)", "val"), Ok(()));
    }

    #[test]
    fn types_are_those_of_python() {
        let all = |truth, whole, fraction, text| Results {
            truth,
            whole,
            fraction,
            text,
        };
        for (text, found) in [
            ("val * 100", Results::FRACTION),
            ("round(val * 100)", Results::WHOLE),
            ("round(val * 100, 1)", Results::FRACTION),
            ("1 + 2 * 3 // 2", Results::WHOLE),
            ("4 / 2", Results::FRACTION),
            ("2 ** 3", Results::WHOLE),
            ("2 ** -1", Results::FRACTION),
            ("val < 1", Results::TRUTH),
            ("(val < 1) + 1", Results::WHOLE),
            ("not val or val", all(true, false, true, false)),
            ("str(val) + '%'", Results::TEXT),
            (
                "'none' if val < .1 else round(val)",
                all(false, true, false, true),
            ),
        ] {
            assert_eq!(results(text, "val"), Ok(found), "{text}");
        }
    }

    #[test]
    fn the_offending_bytes_are_named() {
        let fault = check("val + os.x", "val").unwrap_err();
        assert_eq!(
            (fault.span, fault.what.as_str()),
            (6..8, "reads the name `os`")
        );
    }

    #[test]
    fn depth_is_bounded() {
        for text in [
            "(".repeat(100_000),
            "-".repeat(100_000),
            "not ".repeat(100_000),
            "1**".repeat(100_000),
        ] {
            assert!(check(&text, "val").is_err());
        }
        assert_eq!(check(&format!("1{}", "+1".repeat(100_000)), "val"), Ok(()));
    }

    /// Words of an accepted text outside its quotes: only these may be there.
    fn words(text: &str) -> Vec<String> {
        let mut words = Vec::new();
        let mut word = String::new();
        for character in text.chars().chain([' ']) {
            if character.is_alphanumeric() || character == '_' {
                word.push(character);
            } else if !word.is_empty() {
                words.push(std::mem::take(&mut word));
            }
        }
        words
    }

    proptest! {
        #[test]
        fn no_text_panics(text in "\\PC{0,60}") {
            let _ = check(&text, "val");
        }

        #[test]
        fn no_python_like_text_panics(
            parts in prop::collection::vec(prop::sample::select(vec![
                "val", "round", "str", "(", ")", "'a'", "'", "\"", "\\", "1", ".5", "**", "*", "+", "-", "/", "%", "<", "==",
                "if", "else", "not", "and", "[", "]", ".", ",", "lambda", ":", "os", "=", "\n", " ", "#", "f'", "0x", "e5", "é",
            ]), 0..24)
        ) {
            let _ = check(&parts.concat(), "val");
        }

        #[test]
        fn only_listed_words_are_accepted(
            parts in prop::collection::vec(prop::sample::select(vec![
                "val", "round", "str", "(", ")", "1", ".5", "*", "+", "-", "/", "<", "if", "else", "not", "and", "or", "os",
                "open", "__x__", ".", "[", "]", ",", "eval", "True", "for", "in", "lambda",
            ]), 0..12)
        ) {
            let text = parts.join(" ");
            if check(&text, "val").is_ok() {
                let listed = ["val", "round", "str", "if", "else", "not", "and", "or", "True", "1", "5"];
                for word in words(&text) {
                    prop_assert!(listed.contains(&word.as_str()), "{} in {}", word, text);
                }
                prop_assert!(!text.contains(['[', ']']) && !text.contains(" . "), "{}", text);
            }
        }
    }
}
