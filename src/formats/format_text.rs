//! Texts for Python's `str.format` with one value (formats/makehuman2.md §4.5): which of them are harmless.
//!
//! `{0.__class__}` reads attributes, a width of ten digits exhausts the memory, everything that asks for a
//! second value or a name raises an exception. Nothing is formatted here.

use std::ops::Range;

use super::expression::{Fault, FaultKind};

/// Most digits of a width or precision that is taken for a layout and not for a bomb.
const LONGEST_WIDTH: usize = 3;

/// Checks a text.
///
/// # Errors
/// The first field that is not `{}` or `{0}` with an optional conversion and layout.
pub(crate) fn check(text: &str) -> Result<(), Fault> {
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
            return Err(raises(start..start + 1, "has a brace without its partner"));
        };
        let body = text.get(start + 1..end).unwrap_or_default();
        field(body, start..end + 1, &mut numbering)?;
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
    Fault { span, kind: FaultKind::Raises, what: what.into() }
}

fn field(body: &str, span: Range<usize>, numbering: &mut Numbering) -> Result<(), Fault> {
    let (head, layout) = body.split_once(':').unwrap_or((body, ""));
    let (name, conversion) = head.split_once('!').map_or((head, None), |(name, conversion)| (name, Some(conversion)));
    if name.contains(['.', '[']) {
        let what = format!("reads `{name}`, an attribute or element of the result");
        return Err(Fault { span, kind: FaultKind::Foreign, what });
    }
    if body.contains('{') {
        return Err(raises(span, "has a field inside a field"));
    }
    number(name, &span, numbering)?;
    if conversion.is_some_and(|conversion| !matches!(conversion, "r" | "s" | "a")) {
        return Err(raises(span, "has a conversion other than `!r`, `!s`, `!a`"));
    }
    let digits = layout.split(|c: char| !c.is_ascii_digit()).map(str::len).max().unwrap_or(0);
    if digits > LONGEST_WIDTH {
        return Err(Fault { span, kind: FaultKind::Endless, what: format!("asks for a width of {digits} digits") });
    }
    Ok(())
}

fn number(name: &str, span: &Range<usize>, numbering: &mut Numbering) -> Result<(), Fault> {
    if name.is_empty() {
        numbering.automatic += 1;
        if numbering.automatic > 1 {
            return Err(raises(span.clone(), "asks for a second value; there is only one"));
        }
    } else if name.bytes().all(|byte| byte.is_ascii_digit()) {
        numbering.manual = true;
        if name.bytes().any(|byte| byte != b'0') {
            return Err(raises(span.clone(), "asks for a second value; there is only one"));
        }
    } else {
        return Err(raises(span.clone(), format!("asks for a value called `{name}`; the only one has no name")));
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
        check(text).err().map(|fault| fault.kind)
    }

    #[test]
    fn one_value_is_all_there_is() {
        for text in ["", "{}", "Age: {} years", "{0} of {0}", "{{}} {:>8.2f}%", "{!r:>3}"] {
            assert_eq!(check(text), Ok(()), "{text}");
        }
        for text in ["{1}", "{} {}", "{} {0}", "{name}", "{", "}", "a } b", "{!x}", "{:{}}"] {
            assert_eq!(kind(text), Some(FaultKind::Raises), "{text}");
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
            let _ = check(&text);
        }
    }
}
