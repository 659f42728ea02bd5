//! Which keyword of a material a word is meant to be. A picture must never be taken for that of
//! another keyword: who follows such advice replaces the colour of a surface by its heights.

use super::super::shown;
use mhlint_diag::{Suggestions, begins_word, glued, is_like_path, nearest};
use mhlint_formats::mhmat::{Keyword, Unknown, Value, keywords};
use mhlint_formats::python_float;

/// What a word is meant to be.
pub(super) enum Meant {
    /// A keyword.
    Keyword(&'static str),
    /// A keyword against which its value is written.
    Glued(&'static str),
    /// No keyword that the application reads.
    Nothing,
}

/// What a word is meant to be where `reads` says what the application reads.
pub(super) fn meant(word: &str, reads: impl Fn(&str) -> bool, suggestions: &Suggestions) -> Meant {
    let own = keywords().filter(|keyword| reads(keyword.name));
    if let Some((keyword, _)) = glued(word, own.map(|keyword| keyword.name), fits) {
        return Meant::Glued(keyword);
    }
    // One that is nearer to a keyword of another application is meant as that.
    let words = words_of(word);
    let like = keywords()
        .filter(|keyword| is_like(word, &words, keyword.name))
        .map(|keyword| keyword.name);
    let near = suggestions.nearest(word, like).or_else(|| begun(&words));
    let near = near.and_then(|near| keywords().find(|keyword| keyword.name == near));
    let names = near
        .into_iter()
        .flat_map(|near| [Some(near.name), near.alias_of])
        .flatten();
    names
        .into_iter()
        .find(|name| reads(name))
        .map_or(Meant::Nothing, Meant::Keyword)
}

/// What to write where a word is a keyword with its value.
pub(super) fn parted(keyword: &str, one: &Unknown) -> String {
    match (one.word.text.strip_prefix(keyword), &one.value) {
        (Some(value), None) => format!("did you mean `{keyword} {}`?", shown(value)),
        _ => format!("write a space behind `{keyword}`"),
    }
}

/// Whether a text can be the value of a keyword that it is written against.
fn fits(keyword: &str, value: &str) -> bool {
    let kind = keywords()
        .find(|one| one.name == keyword)
        .map(|one| one.value);
    kind.is_some_and(|kind| match kind {
        Value::Text => begins_word(value),
        Value::Picture | Value::Word => is_like_path(value),
        Value::Number | Value::Whole | Value::Colour => python_float(value.as_bytes()).is_some(),
        Value::Flag => ["true", "false", "yes", "no"]
            .iter()
            .any(|word| word.eq_ignore_ascii_case(value)),
        Value::Parameter => false,
    })
}

/// The words that a keyword is put together of, in small letters and without `map`.
fn words_of(text: &str) -> Vec<String> {
    let mut words = vec![String::new()];
    let mut was_small = false;
    for letter in text.chars() {
        let is_mark = matches!(letter, '_' | '-');
        if is_mark || was_small && letter.is_uppercase() {
            words.push(String::new());
        }
        was_small = letter.is_lowercase();
        if let Some(word) = words.last_mut().filter(|_| !is_mark) {
            word.extend(letter.to_lowercase());
        }
    }
    words.iter_mut().for_each(|word| {
        if word.len() > MAP.len() && word.ends_with(MAP) {
            word.truncate(word.len() - MAP.len());
        }
    });
    words.retain(|word| !word.is_empty() && word != MAP);
    words
}

const MAP: &str = "map";

/// Whether each word of a keyword is near the one in its place. As a whole `displaceTexture` is
/// near `diffuseTexture`.
fn is_like(word: &str, words: &[String], keyword: &str) -> bool {
    let known = words_of(keyword);
    if words.len() == known.len() {
        return words
            .iter()
            .zip(&known)
            .all(|(one, other)| is_slip(one, other));
    }
    let start = |text: &str| {
        text.chars()
            .take(3)
            .flat_map(char::to_lowercase)
            .collect::<String>()
    };
    start(word) == start(keyword)
}

fn is_slip(one: &str, other: &str) -> bool {
    one == other || nearest(one, [other]).is_some()
}

/// Letters by which the beginning of a word is known.
const KNOWN: usize = 4;

/// The keyword whose first word begins as that of this one, if all such mean the same: `displace`
/// for `displacement`.
fn begun(words: &[String]) -> Option<&'static str> {
    let (first, rest) = words
        .split_first()
        .filter(|(first, _)| first.len() >= KNOWN)?;
    let is_begun = |keyword: &&'static Keyword| {
        let known = words_of(keyword.name);
        let own = known
            .split_first()
            .filter(|(own, others)| own.len() >= KNOWN && others.len() == rest.len());
        own.is_some_and(|(own, others)| {
            let is_start = own.starts_with(first.as_str()) || first.starts_with(own.as_str());
            is_start
                && rest
                    .iter()
                    .zip(others)
                    .all(|(one, other)| is_slip(one, other))
        })
    };
    let mut found = keywords().filter(is_begun);
    let one = found.next()?;
    let meaning = |keyword: &Keyword| keyword.alias_of.unwrap_or(keyword.name).to_lowercase();
    found
        .all(|other| meaning(other) == meaning(one))
        .then_some(one.name)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn written(word: &str) -> String {
        match meant(word, |_| true, &Suggestions::default()) {
            Meant::Keyword(name) => name.to_owned(),
            Meant::Glued(name) => format!("{name} {}", word.trim_start_matches(name)),
            Meant::Nothing => "-".to_owned(),
        }
    }

    #[test]
    fn a_word_is_never_meant_to_name_another_picture() {
        for (word, keyword) in [
            ("displaceTexture", "displacementmapTexture"),
            ("displacementTexture", "displacementmapTexture"),
            ("displaceIntensity", "displacementmapIntensity"),
            ("difuseTexture", "diffuseTexture"),
            ("diffuseTextur", "diffuseTexture"),
            ("diffusetexture", "diffuseTexture"),
            ("diffuse_texture", "diffuseTexture"),
            ("normalMapTexture", "normalmapTexture"),
            ("normalTexture", "normalmapTexture"),
            ("specularTexture", "specularmapTexture"),
            ("transTexture", "-"),
            ("alphaTexture", "-"),
            ("maskTexture", "-"),
            ("displacetexture", "-"),
        ] {
            assert_eq!(written(word), keyword, "{word}");
        }
    }

    #[test]
    fn values_are_told_from_keywords() {
        for (word, line) in [
            ("nameBabyP", "name BabyP"),
            ("opacity0.5", "opacity 0.5"),
            ("diffuseTexturehat.png", "diffuseTexture hat.png"),
            ("transparentTrue", "transparent True"),
            ("names", "name"),
        ] {
            assert_eq!(written(word), line, "{word}");
        }
    }
}
