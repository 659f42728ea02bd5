//! Suggestions for misspelt names.

/// The candidate most like `name`, if it is near enough to be a slip of the pen.
///
/// Case and separators are forgiven first; then edit distance up to a third of the length counts.
/// Ties go to the smaller candidate, so the answer does not depend on order. The other side or the other direction of
/// `name` is never the answer: it is near by its name and wrong for certain.
pub fn nearest<'a>(name: &str, candidates: impl IntoIterator<Item = &'a str>) -> Option<&'a str> {
    let limit = (name.chars().count() / 3).max(1);
    let folded = fold(name);
    candidates
        .into_iter()
        .filter(|candidate| *candidate != name && !is_opposite(name, candidate))
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

/// Words that stand for opposites where they are all that differs.
const OPPOSITES: [[&str; 2]; 8] = [
    ["l", "r"],
    ["left", "right"],
    ["incr", "decr"],
    ["up", "down"],
    ["in", "out"],
    ["forward", "backward"],
    ["upper", "lower"],
    ["male", "female"],
];

/// Whether two names differ by opposite words alone: `l-knee` and `r-knee`, `young-minmuscle` and `young-maxmuscle`.
fn is_opposite(one: &str, other: &str) -> bool {
    let words = |name: &str| -> Vec<String> {
        name.split(|c: char| !c.is_alphanumeric()).map(str::to_lowercase).collect::<Vec<_>>()
    };
    let (one, other) = (words(one), words(other));
    let mut differing = one.iter().zip(&other).filter(|(one, other)| one != other).peekable();
    one.len() == other.len() && differing.peek().is_some() && differing.all(|(one, other)| are_opposites(one, other))
}

fn are_opposites(one: &str, other: &str) -> bool {
    let is_pair = |[a, b]: &[&str; 2]| (one, other) == (*a, *b) || (one, other) == (*b, *a);
    let range =
        |low: &str, high: &str| low.strip_prefix("min").is_some_and(|rest| high.strip_prefix("max") == Some(rest));
    OPPOSITES.iter().any(is_pair) || range(one, other) || range(other, one)
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
    fn the_opposite_is_no_suggestion() {
        for (name, opposite, like) in [
            ("l-knee", "r-knee", "l-kne"),
            ("lowerarm.L", "lowerarm.R", "lowerarm.l"),
            ("teen-minmuscle", "teen-maxmuscle", "teen-minmuscles"),
            ("nose-hump-incr", "nose-hump-decr", "nose-hum-incr"),
        ] {
            assert_eq!(nearest(name, [opposite]), None, "{name}");
            assert_eq!(nearest(name, [opposite, like]), Some(like), "{name}");
        }
        assert_eq!(nearest("r-kne", ["l-knee", "r-knee"]), Some("r-knee"));
    }

    #[test]
    fn the_name_itself_is_no_suggestion() {
        assert_eq!(nearest("a", ["a"]), None);
    }
}
