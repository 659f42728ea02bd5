//! Suggestions for misspelt names.

/// The candidate most like `name`, if it is near enough to be a slip of the pen.
///
/// Case and separators are forgiven first; then edit distance up to a third of the length counts.
/// Ties go to the smaller candidate, so the answer does not depend on order.
pub fn nearest<'a>(name: &str, candidates: impl IntoIterator<Item = &'a str>) -> Option<&'a str> {
    let limit = (name.chars().count() / 3).max(1);
    let folded = fold(name);
    candidates
        .into_iter()
        .filter(|candidate| *candidate != name)
        .map(|candidate| (distance(name, &folded, candidate), candidate))
        .filter(|(distance, _)| *distance <= limit)
        .min()
        .map(|(_, candidate)| candidate)
}

fn distance(name: &str, folded: &str, candidate: &str) -> usize {
    if fold(candidate) == folded {
        return 0;
    }
    strsim::damerau_levenshtein(name, candidate).max(1)
}

fn fold(name: &str) -> String {
    name.chars().filter(|c| !matches!(c, '-' | '_' | '.' | ' ')).flat_map(char::to_lowercase).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn slips_are_found_and_strangers_are_not() {
        let names = ["shapes|male hormonal", "shapes|female hormonal", "face|nose"];
        assert_eq!(nearest("shapes|fale hormonal", names), Some("shapes|male hormonal"));
        assert_eq!(nearest("clothes", names), None);
        assert_eq!(nearest("Face|Nose", names), Some("face|nose"));
    }

    #[test]
    fn the_name_itself_is_no_suggestion() {
        assert_eq!(nearest("a", ["a"]), None);
    }
}
