//! Lines split at white space as Python does it, without copying, with the offset of each field.

/// White space separated fields with their offsets; white space as Python's `split()` has it.
pub(super) fn fields(line: &[u8]) -> Vec<(usize, &[u8])> {
    if line.is_ascii() {
        return ascii_fields(line);
    }
    let text = String::from_utf8_lossy(line);
    if text.len() != line.len() {
        return ascii_fields(line);
    }
    let mut fields = Vec::new();
    let mut start = None;
    for (at, character) in text.char_indices().chain([(text.len(), ' ')]) {
        match (is_python_space(character), start) {
            (false, None) => start = Some(at),
            (true, Some(from)) => {
                fields.push((from, line.get(from..at).unwrap_or_default()));
                start = None;
            }
            _ => {}
        }
    }
    fields
}

fn ascii_fields(line: &[u8]) -> Vec<(usize, &[u8])> {
    let mut fields = Vec::with_capacity(4);
    let mut at = 0;
    while let Some(length) = line
        .get(at..)
        .and_then(|rest| rest.iter().position(|b| !is_python_space(char::from(*b))))
    {
        let start = at + length;
        let rest = line.get(start..).unwrap_or_default();
        let width = rest
            .iter()
            .position(|b| is_python_space(char::from(*b)))
            .unwrap_or(rest.len());
        fields.push((start, rest.get(..width).unwrap_or_default()));
        at = start + width;
    }
    fields
}

fn is_python_space(character: char) -> bool {
    character.is_whitespace() || matches!(character, '\u{1c}'..='\u{1f}')
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;

    #[test]
    fn white_space_is_that_of_python() {
        let line = "a\tb\u{a0}c\u{1c}d \u{2003}e".as_bytes();
        let found: Vec<_> = fields(line).into_iter().map(|(_, field)| field).collect();
        assert_eq!(found, [b"a", b"b", b"c", b"d", b"e"]);
    }

    proptest! {
        #[test]
        fn fields_lie_where_they_say(line in proptest::collection::vec(any::<u8>(), 0..60)) {
            for (start, field) in fields(&line) {
                prop_assert!(!field.is_empty());
                prop_assert_eq!(&line[start..start + field.len()], field);
            }
        }

        #[test]
        fn text_is_split_as_by_rust(line in "[a\u{e9} \t\u{a0}\u{2003}]{0,20}") {
            let found: Vec<_> = fields(line.as_bytes()).into_iter().map(|(_, field)| field).collect();
            let expected: Vec<_> = line.split_whitespace().map(str::as_bytes).collect();
            prop_assert_eq!(found, expected);
        }
    }
}
