//! Texts for Python's `str.format` with one value
//! (`docs/loaders/makehuman2/sliders.md#display-and-formulas`): which of them are harmless.
//!
//! `{0.__class__}` reads attributes, a width of ten digits exhausts the memory, everything that
//! asks for a second value or a name raises an exception. Nothing is formatted here.

use std::ops::Range;

use super::expression::{Fault, FaultKind, Results};

/// Most digits of a width or precision that is taken for a layout and not for a bomb.
const LONGEST_WIDTH: usize = 3;

/// Checks a text for values of these types, where they are known.
///
/// # Errors
/// The first field that is not `{}` or `{0}` with an optional conversion and layout, or whose
/// layout is not for them.
pub fn check(text: &str, results: Option<Results>) -> Result<(), Fault> {
    let mut at = 0;
    let mut numbering = Numbering::default();
    while let Some(found) = text.get(at..).and_then(|rest| rest.find(['{', '}'])) {
        let start = at + found;
        let rest = text.get(start..).unwrap_or_default();
        if rest.starts_with("{{") || rest.starts_with("}}") {
            at = start + 2;
            continue;
        }
        let end = rest.find('}').map(|length| start + length);
        let Some(end) = end.filter(|_| rest.starts_with('{')) else {
            return Err(raises(start..start + 1, "has an unmatched brace"));
        };
        let body = text.get(start + 1..end).unwrap_or_default();
        field(body, start..end + 1, &mut numbering, results)?;
        at = end + 1;
    }
    Ok(())
}

#[derive(Default)]
struct Numbering {
    automatic: usize,
    manual: bool,
}

fn raises(span: Range<usize>, what: impl Into<String>) -> Fault {
    Fault {
        span,
        kind: FaultKind::Raises,
        what: what.into(),
    }
}

fn field(
    body: &str,
    span: Range<usize>,
    numbering: &mut Numbering,
    results: Option<Results>,
) -> Result<(), Fault> {
    let (head, layout) = body.split_once(':').unwrap_or((body, ""));
    let (name, conversion) = head
        .split_once('!')
        .map_or((head, None), |(name, conversion)| (name, Some(conversion)));
    if name.contains(['.', '[']) {
        let what = format!("reads `{name}`, an attribute or element of the result");
        return Err(Fault {
            span,
            kind: FaultKind::Foreign,
            what,
        });
    }
    if body.contains('{') {
        return Err(raises(span, "has a field inside a field"));
    }
    number(name, &span, numbering)?;
    if conversion.is_some_and(|conversion| !matches!(conversion, "r" | "s" | "a")) {
        return Err(raises(span, "has a conversion other than `!r`, `!s`, `!a`"));
    }
    let digits = layout
        .split(|c: char| !c.is_ascii_digit())
        .map(str::len)
        .max()
        .unwrap_or(0);
    if digits > LONGEST_WIDTH {
        return Err(Fault {
            span,
            kind: FaultKind::Endless,
            what: format!("asks for a width of {digits} digits"),
        });
    }
    let results = if conversion.is_some() {
        Some(Results::TEXT)
    } else {
        results
    };
    Layout::read(layout)
        .rejected(results)
        .map_or(Ok(()), |what| {
            Err(Fault {
                span,
                kind: FaultKind::Layout,
                what,
            })
        })
}

/// What a layout asks for.
#[derive(Default)]
struct Layout {
    /// What only numbers have: a sign, thousands, filling behind the sign.
    is_of_numbers: bool,
    precision: bool,
    /// The letter at its end.
    code: Option<char>,
    /// Something is left that Python does not know.
    is_unknown: bool,
}

impl Layout {
    /// `[[fill]align][sign][z][#][0][width][grouping][.precision][code]`.
    fn read(layout: &str) -> Self {
        let characters: Vec<char> = layout.chars().collect();
        let is_align = |at: usize| {
            characters
                .get(at)
                .is_some_and(|one| matches!(one, '<' | '>' | '=' | '^'))
        };
        let mut at = if is_align(1) {
            2
        } else {
            usize::from(is_align(0))
        };
        let fills_inside = at > 0 && characters.get(at - 1) == Some(&'=');
        let mut take = |wanted: fn(char) -> bool| {
            let is_there = characters.get(at).is_some_and(|one| wanted(*one));
            at += usize::from(is_there);
            is_there
        };
        let sign = take(|one| matches!(one, '+' | '-' | ' '));
        take(|one| one == 'z');
        take(|one| one == '#');
        while take(|one| one.is_ascii_digit()) {}
        let grouping = take(|one| matches!(one, ',' | '_'));
        let precision = take(|one| one == '.');
        let has_digits = !precision || take(|one| one.is_ascii_digit());
        while take(|one| one.is_ascii_digit()) {}
        let code = characters.get(at).copied();
        let is_unknown = !has_digits || characters.len() > at + 1;
        Self {
            is_of_numbers: sign || grouping || fills_inside,
            precision,
            code,
            is_unknown,
        }
    }

    /// Why Python rejects a value of these types; of unknown ones if it rejects all.
    fn rejected(&self, results: Option<Results>) -> Option<String> {
        let whole = self.code.is_none_or(|code| "bcdoxXneEfFgG%".contains(code))
            && !(self.precision && self.code.is_none_or(|code| "bcdoxXn".contains(code)));
        let fraction = self.code.is_none_or(|code| "neEfFgG%".contains(code));
        let text = self.code.is_none_or(|code| code == 's') && !self.is_of_numbers;
        if self.is_unknown || !(whole || fraction || text) {
            return Some("has an unknown layout".to_owned());
        }
        let types = results?;
        let rejected = [
            (types.text && !text, "a string"),
            (types.fraction && !fraction, "a decimal number"),
            ((types.whole || types.truth) && !whole, "a whole number"),
        ];
        let (_, value) = rejected.into_iter().find(|(is_refused, _)| *is_refused)?;
        Some(match self.code {
            Some(code) => format!("formats {value} as `{code}`, which Python rejects"),
            None => format!("has a layout that Python rejects for {value}"),
        })
    }
}

fn number(name: &str, span: &Range<usize>, numbering: &mut Numbering) -> Result<(), Fault> {
    if name.is_empty() {
        numbering.automatic += 1;
        if numbering.automatic > 1 {
            return Err(raises(
                span.clone(),
                "asks for a second value, but there is only one",
            ));
        }
    } else if name.bytes().all(|byte| byte.is_ascii_digit()) {
        numbering.manual = true;
        if name.bytes().any(|byte| byte != b'0') {
            return Err(raises(
                span.clone(),
                "asks for a second value, but there is only one",
            ));
        }
    } else {
        return Err(raises(
            span.clone(),
            format!("asks for a value called `{name}`, but the only one has no name"),
        ));
    }
    if numbering.manual && numbering.automatic > 0 {
        return Err(raises(span.clone(), "mixes `{}` and `{0}`"));
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;

    fn kind(text: &str) -> Option<FaultKind> {
        check(text, None).err().map(|fault| fault.kind)
    }

    #[test]
    fn one_value_is_all_there_is() {
        for text in [
            "",
            "{}",
            "Age: {} years",
            "{0} of {0}",
            "{{}} {:>8.2f}%",
            "{!r:>3}",
        ] {
            assert_eq!(check(text, None), Ok(()), "{text}");
        }
        for text in [
            "{1}", "{} {}", "{} {0}", "{name}", "{", "}", "a } b", "{!x}", "{:{}}",
        ] {
            assert_eq!(kind(text), Some(FaultKind::Raises), "{text}");
        }
    }

    #[test]
    fn layouts_are_for_the_types_that_python_takes_them_for() {
        let of = |whole, fraction, text| Results {
            truth: false,
            whole,
            fraction,
            text,
        };
        for (text, results, is_sound) in [
            ("{:d}", of(true, false, false), true),
            ("{:d}", of(false, true, false), false),
            ("{:.1f}", of(true, true, false), true),
            ("{:.1f}", of(false, false, true), false),
            ("{:.1f}", of(false, true, true), false),
            ("{!s:.1f}", of(false, true, false), false),
            ("{!s:>8}", of(false, true, false), true),
            ("{:.2}", of(true, false, false), false),
            ("{:.2}", of(false, true, true), true),
            ("{:s}", of(true, false, false), false),
            ("{:,}", of(true, true, false), true),
            ("{:+}", of(false, false, true), false),
            ("{:*^+08,.2f}%", of(false, true, false), true),
        ] {
            assert_eq!(
                check(text, Some(results)).is_ok(),
                is_sound,
                "{text} {results:?}"
            );
        }
        for text in ["{:q}", "{:.f}", "{:5dd}", "{:+s}"] {
            assert_eq!(kind(text), Some(FaultKind::Layout), "{text}");
        }
    }

    #[test]
    fn attributes_and_bombs_are_told_apart() {
        assert_eq!(kind("{0.__class__.__init__}"), Some(FaultKind::Foreign));
        assert_eq!(kind("{[0]}"), Some(FaultKind::Foreign));
        assert_eq!(kind("{:>9999999999}"), Some(FaultKind::Endless));
    }

    proptest! {
        #[test]
        fn no_text_panics(text in "[{}!:.\\[\\]0-9aré]{0,20}") {
            let _ = check(&text, Some(Results::TEXT));
        }
    }
}
