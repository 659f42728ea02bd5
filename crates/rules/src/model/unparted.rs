//! Keywords of models that are joined with their values to one word: `nameBaby` for `name Baby`.

use mhlint_diag::{begins_word, glued, is_like_path};
use mhlint_formats::mhm::CATEGORIES;
use mhlint_formats::mhm::lines::{Line, Lines, keywords};

/// A line whose first word is a keyword joined with its value.
pub(super) struct Unparted<'l> {
    pub(super) line: &'l Line,
    pub(super) keyword: &'static str,
    value: &'l str,
}

/// The lines of a model whose first word is a keyword joined with its value.
pub(super) fn unparted(lines: &Lines) -> impl Iterator<Item = Unparted<'_>> {
    lines.all.iter().filter_map(of_line)
}

/// The keyword and the value in the first word of a line, if it is both.
pub(super) fn of_line(line: &Line) -> Option<Unparted<'_>> {
    let word = &*line.keyword.text;
    let (keyword, value) =
        glued(word, keywords(), fits).filter(|_| keywords().all(|known| known != word))?;
    Some(Unparted {
        line,
        keyword,
        value,
    })
}

fn fits(keyword: &str, value: &str) -> bool {
    match keyword {
        "name" | "tags" => begins_word(value),
        "modifier" | "skinMaterial" | "skeleton" | "pose" | "expression" | "material" => {
            is_like_path(value)
        }
        "subdivide" | "clothesHideFaces" => matches!(value, "True" | "False"),
        "version" => value
            .trim_start_matches('v')
            .starts_with(|first: char| first.is_ascii_digit()),
        category => CATEGORIES.contains(&category) && begins_word(value),
    }
}

impl Unparted<'_> {
    /// Whether the line is meant to put an asset on.
    pub(super) fn is_worn(&self) -> bool {
        CATEGORIES.contains(&self.keyword)
    }

    /// Whether the value is only shown in lists, so that it changes nothing in the character.
    pub(super) fn is_label(&self) -> bool {
        matches!(self.keyword, "name" | "tags" | "version")
    }

    /// The message of the finding.
    pub(super) fn message(&self) -> String {
        format!("`{}` is not a keyword of models", self.line.keyword.text)
    }

    /// The help of the finding: the line as it should be.
    pub(super) fn help(&self) -> String {
        let words = self.line.values.iter().map(|word| &*word.text);
        let line: Vec<&str> = [self.keyword, self.value]
            .into_iter()
            .chain(words)
            .collect();
        format!("did you mean `{}`?", line.join(" "))
    }
}
