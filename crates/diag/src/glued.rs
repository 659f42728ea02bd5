//! Keywords that their values are written against: `nameBaby` for `name Baby`.

/// The keyword that a word begins with, the longest one, and what is written against it. `fits`
/// says whether that can be a value of the keyword.
pub fn glued<'k, 'w>(
    word: &'w str,
    keywords: impl IntoIterator<Item = &'k str>,
    fits: impl Fn(&'k str, &'w str) -> bool,
) -> Option<(&'k str, &'w str)> {
    let split = keywords
        .into_iter()
        .filter_map(|keyword| Some((keyword, word.strip_prefix(keyword)?)));
    split
        .filter(|(keyword, value)| !value.is_empty() && fits(keyword, value))
        .max_by_key(|(keyword, _)| keyword.len())
}

/// Whether a text begins as a new word does behind one in small letters.
pub fn begins_word(text: &str) -> bool {
    text.starts_with(|first: char| {
        first.is_uppercase() || first.is_ascii_digit() || !first.is_ascii() || first == '"'
    })
}

/// Whether a text is like the path of a file.
pub fn is_like_path(text: &str) -> bool {
    let name = text.rsplit(['/', '\\']).next().unwrap_or_default();
    text.contains('/')
        || name
            .split_once('.')
            .is_some_and(|(stem, suffix)| !stem.is_empty() && suffix.len() > 1)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_longest_keyword_is_taken_apart_from_its_value() {
        let known = ["name", "shader", "shaderParam"];
        let found = |word: &'static str| glued(word, known, |_, value| begins_word(value));
        assert_eq!(found("nameBabyP"), Some(("name", "BabyP")));
        assert_eq!(found("shaderParamX"), Some(("shaderParam", "X")));
        for word in ["name", "names", "name_x", "name:X", "Xname"] {
            assert_eq!(found(word), None, "{word}");
        }
        assert!(
            is_like_path("hat.obj")
                && is_like_path("x/y")
                && !is_like_path(".5")
                && !is_like_path("1.")
        );
    }
}
