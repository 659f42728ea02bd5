//! Text of an asset made harmless wherever it is read by people: a terminal, the log of a CI
//! system, a page.

/// What takes the place of a character that would do something instead of being read.
const SHOWN: char = '\u{fffd}';

/// The text on one line, without characters that control a terminal, turn the direction of writing
/// or are no text at all, and without what CI systems take for a command (`::error::`, `##[group]`,
/// `##vso[...]`).
pub fn printable(text: &str) -> String {
    let mut shown = String::with_capacity(text.len());
    let mut characters = text.chars().peekable();
    let mut before = ' ';
    while let Some(character) = characters.next() {
        let character = match character {
            '\n' | '\r' | '\t' | '\u{2028}' | '\u{2029}' => ' ',
            other if other.is_control() || is_direction(other) || is_no_text(other) => SHOWN,
            other => other,
        };
        // A line of a log may begin at any word, because long lines are broken.
        let starts_command = character == ':' && before == ' ' && characters.peek() == Some(&':');
        if starts_command || (character == '#' && before == '#') {
            shown.push(SHOWN);
        }
        shown.push(character);
        before = character;
    }
    shown
}

/// Characters that turn the direction of writing and so can make a name look like another one.
fn is_direction(character: char) -> bool {
    matches!(
        character,
        '\u{61c}' | '\u{200e}' | '\u{200f}' | '\u{202a}'..='\u{202e}' | '\u{2066}'..='\u{2069}'
    )
}

/// Code points that neither XML nor HTML accepts, and the byte order mark.
fn is_no_text(character: char) -> bool {
    matches!(character, '\u{feff}' | '\u{fdd0}'..='\u{fdef}')
        || u32::from(character) & 0xfffe == 0xfffe
}

#[cfg(test)]
mod tests {
    use super::printable;

    #[test]
    fn what_would_act_is_shown_instead() {
        assert_eq!(
            printable("a\u{1b}[31m\u{0}b\nc\td"),
            "a\u{fffd}[31m\u{fffd}b c d"
        );
        assert_eq!(
            printable("\u{202e}gpj\u{2066}\u{feff}\u{ffff}\u{1fffe}"),
            "\u{fffd}gpj\u{fffd}\u{fffd}\u{fffd}\u{fffd}"
        );
    }

    #[test]
    fn commands_of_ci_systems_are_broken() {
        assert_eq!(printable("::error::x"), "\u{fffd}::error::x");
        assert_eq!(printable("a\n::stop::x"), "a \u{fffd}::stop::x");
        assert_eq!(
            printable("##[group]x ##vso[y"),
            "#\u{fffd}#[group]x #\u{fffd}#vso[y"
        );
    }

    #[test]
    fn ordinary_text_stays() {
        for text in [
            "crate::name",
            "a: b",
            "n\u{e4}he #1",
            "\u{5e2}\u{5d1}\u{5e8}\u{5d9}\u{5ea}",
            "\u{1f600}",
        ] {
            assert_eq!(printable(text), text);
        }
    }

    #[test]
    fn twice_is_once() {
        let once = printable("## ::x ###");
        assert_eq!(printable(&once), once);
    }
}
