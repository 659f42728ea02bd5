//! Suggestions for misspelt names.

use std::cell::Cell;

/// The candidate most like `name`, if it is near enough to be a slip of the pen.
///
/// Case and separators are forgiven first; then edit distance up to a third of the length counts,
/// and of each word where both have as many: `waist-circ` is no slip for `hips-circ`, however long
/// what they share. Ties go to the smaller candidate, so the answer does not depend on order. The
/// other side or the other direction of `name` is never the answer: it is near by its name and
/// wrong for certain.
///
/// For one name. Who looks for many asks [`Suggestions`].
pub fn nearest<'a>(name: &str, candidates: impl IntoIterator<Item = &'a str>) -> Option<&'a str> {
    Suggestions::default().nearest(name, candidates)
}

/// Letters compared for the suggestions of one rule: a twentieth of a second. Thousands of names
/// that are looked for among thousands are no slips of the pen, and nobody reads that many
/// suggestions.
const COMPARED: usize = 1 << 23;
/// What a candidate costs beside its letters: the count of its letters is compared.
const COST_OF_CANDIDATE: usize = LETTERS;
/// What it costs to look whether something is a candidate.
const COST_OF_LOOK: usize = 16;
/// What it costs to compare two letters, where a candidate is measured.
const COST_OF_PAIR: usize = 16;

/// The [`nearest`] of many names in turn, until too many letters were compared.
#[derive(Debug, Default)]
pub struct Suggestions {
    compared: Cell<usize>,
}

impl Suggestions {
    /// Whether too much was compared for another suggestion.
    pub const fn are_over(&self) -> bool {
        self.compared.get() > COMPARED
    }

    /// Candidates of which some are left out before they are compared. Looking at them counts, too.
    pub fn looked_through<T, I>(&self, all: I) -> impl Iterator<Item = T> + use<'_, T, I>
    where
        I: IntoIterator<Item = T>,
    {
        all.into_iter().take_while(|_| {
            self.compared.set(self.compared.get() + COST_OF_LOOK);
            !self.are_over()
        })
    }

    /// As [`nearest`]; nothing more when too much was compared before.
    pub fn nearest<'a>(
        &self,
        name: &str,
        candidates: impl IntoIterator<Item = &'a str>,
    ) -> Option<&'a str> {
        self.best(name, candidates, |_| (None, 0))
    }

    /// As [`nearest`](Self::nearest) among files of every kind: one with another suffix is another
    /// file, not another name.
    pub fn nearest_of_kind<'a>(
        &self,
        name: &str,
        candidates: impl IntoIterator<Item = &'a str>,
    ) -> Option<&'a str> {
        self.nearest(name, self.of_kind(name, candidates))
    }

    /// The same for files, named with or without folders: one that has all words of `name`, or only
    /// words of it, is nearer than one that differs by more than a letter. `head-side-in` means
    /// `side-in`, not `head-wide`.
    pub fn nearest_file<'a>(
        &self,
        name: &str,
        candidates: impl IntoIterator<Item = &'a str>,
    ) -> Option<&'a str> {
        let words = words_of_file(name);
        // Longer ones are not names of files.
        let is_short = name.len() <= LONGEST_PATH;
        self.best(name, self.of_kind(name, candidates), |candidate| {
            let other = words_of_file(candidate);
            let cost = candidate.len() + words.len() * other.len();
            // Of another kind it is another file, not another name.
            if is_short && suffix(name).eq_ignore_ascii_case(suffix(candidate)) {
                (words_between(&words, &other), cost)
            } else {
                (None, 0)
            }
        })
    }

    /// The candidates that end as a name does.
    fn of_kind<'a>(
        &self,
        name: &str,
        candidates: impl IntoIterator<Item = &'a str>,
    ) -> impl Iterator<Item = &'a str> {
        self.looked_through(candidates)
            .filter(move |candidate| is_of_kind(name, candidate))
    }

    /// The best candidate. `between` says how many words a candidate has more or less, if that is
    /// all, and what it cost.
    fn best<'a>(
        &self,
        name: &str,
        candidates: impl IntoIterator<Item = &'a str>,
        between: impl Fn(&'a str) -> (Option<usize>, usize),
    ) -> Option<&'a str> {
        // Longer ones are no names.
        if name.len() > LONGEST_PATH {
            return None;
        }
        let sought = Sought::new(name);
        let mut best: Option<(Rank, &str)> = None;
        for candidate in candidates {
            if self.are_over() {
                return None;
            }
            // Nothing farther than the best so far is worth measuring.
            let limit = best.map_or(sought.limit, |(rank, _)| rank.limit());
            let (distance, cost) = sought.distance(candidate, limit);
            let (words, cost_of_words) = if distance.is_some_and(|distance| distance <= 1) {
                (None, 0)
            } else {
                between(candidate)
            };
            self.compared
                .set(self.compared.get() + cost + cost_of_words);
            if let Some(rank) = Rank::of(distance, words)
                && best.is_none_or(|best| (rank, candidate) < best)
                && sought.is_other(candidate)
            {
                best = Some((rank, candidate));
            }
        }
        best.map(|(_, candidate)| candidate)
            .filter(|_| !self.are_over())
    }
}

/// How near a candidate is, the nearest first.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
enum Rank {
    /// It differs by a letter at most.
    Letter(usize),
    /// It has so many words more or less.
    Words(usize),
    /// It differs by more letters.
    Letters(usize),
}

impl Rank {
    fn of(distance: Option<usize>, words: Option<usize>) -> Option<Self> {
        match (distance, words) {
            (Some(distance @ ..=1), _) => Some(Self::Letter(distance)),
            (_, Some(words)) => Some(Self::Words(words)),
            (distance, None) => distance.map(Self::Letters),
        }
    }

    /// The distance beyond which no other candidate is nearer.
    fn limit(self) -> usize {
        match self {
            Self::Letter(distance) | Self::Letters(distance) => distance,
            Self::Words(_) => 1,
        }
    }
}

/// The words of a file's name, without folders and extensions.
fn words_of_file(name: &str) -> Vec<&str> {
    let name = name.rsplit('/').next().unwrap_or_default();
    let stem = name.split('.').next().unwrap_or_default();
    stem.split(['-', '_']).collect()
}

/// What is behind the stem of a name.
fn suffix(name: &str) -> &str {
    let name = name.rsplit('/').next().unwrap_or_default();
    name.split_once('.').map_or("", |(_, suffix)| suffix)
}

/// Whether a file ends as a name does, but for a slip of the pen; a name may lack its suffix.
/// `x.png.import` is no picture.
fn is_of_kind(name: &str, candidate: &str) -> bool {
    let last = |path: &str| -> Option<String> {
        let name = path.rsplit('/').next()?;
        name.rsplit_once('.')
            .filter(|(stem, _)| !stem.is_empty())
            .map(|(_, suffix)| suffix.to_lowercase())
    };
    let Some(wanted) = last(name) else {
        return true;
    };
    last(candidate).is_some_and(|own| own == wanted || Sought::new(&wanted).may_mean(&own))
}

/// How many words one name has more than the other, if these come before or after all words of the
/// other and are no more than they.
fn words_between(one: &[&str], other: &[&str]) -> Option<usize> {
    let (long, short) = if one.len() > other.len() {
        (one, other)
    } else {
        (other, one)
    };
    let more = long.len() - short.len();
    let same = |run: &[&str]| {
        run.iter()
            .zip(short)
            .all(|(one, other)| one.eq_ignore_ascii_case(other))
    };
    (0 < more && more <= short.len() && long.windows(short.len()).any(same)).then_some(more)
}

/// A name that many others are compared with.
#[derive(Debug)]
pub struct Sought<'n> {
    name: &'n str,
    folded: String,
    limit: usize,
    letters: [i32; LETTERS],
}

/// Bytes in which names may differ and still be compared: the time grows with the square, and
/// nobody slips in that many.
const LONGEST: usize = 64;

/// Bytes of the longest path of a file that is worth comparing word by word.
const LONGEST_PATH: usize = 4096;

/// Kinds of letters that are told apart where they are counted.
const LETTERS: usize = 96;

impl<'n> Sought<'n> {
    /// Counts the letters of a name.
    pub fn new(name: &'n str) -> Self {
        let mut letters = [0; LETTERS];
        name.chars()
            .for_each(|letter| letters[kind_of_letter(letter)] += 1);
        Self {
            name,
            folded: fold(name).collect(),
            limit: limit(name),
            letters,
        }
    }

    /// Whether `candidate` alone would be the [`nearest`] one.
    pub fn may_mean(&self, candidate: &str) -> bool {
        self.distance(candidate, self.limit).0.is_some() && self.is_other(candidate)
    }

    /// Whether a name is another one, and not the opposite.
    fn is_other(&self, candidate: &str) -> bool {
        self.name != candidate && !is_opposite(self.name, candidate)
    }

    /// Edit distance, if it is within a limit, and what it cost to tell.
    fn distance(&self, candidate: &str, limit: usize) -> (Option<usize>, usize) {
        let cost = COST_OF_CANDIDATE + candidate.len();
        if fold(candidate).eq(self.folded.chars()) {
            return (Some(0), cost);
        }
        if self.least(candidate) > limit {
            return (None, cost);
        }
        let (name, other) = without_common_ends(self.name, candidate);
        if name.len().max(other.len()) > LONGEST {
            return (None, cost);
        }
        let distance = strsim::damerau_levenshtein(name, other).max(1);
        let is_slip = distance <= limit && (distance == 1 || words_are_slips(self.name, candidate));
        (
            is_slip.then_some(distance),
            cost + COST_OF_PAIR * name.len() * other.len(),
        )
    }

    /// What the edit distance is at least: each edit adds, removes or replaces one letter, or moves
    /// some. Most names are out of reach by this alone.
    fn least(&self, candidate: &str) -> usize {
        let mut letters = self.letters;
        candidate
            .chars()
            .for_each(|letter| letters[kind_of_letter(letter)] -= 1);
        let missing: i32 = letters.iter().filter(|count| **count > 0).sum();
        let surplus: i32 = letters.iter().filter(|count| **count < 0).sum();
        missing.max(-surplus).unsigned_abs() as usize
    }
}

/// In how many letters another name may differ. One or two letters are a name as a whole.
fn limit(name: &str) -> usize {
    let letters = name.chars().count();
    if letters < 3 { 0 } else { (letters / 3).max(1) }
}

/// Two names without what they have in common at both ends, which does not count for their
/// distance.
fn without_common_ends<'s>(mut one: &'s str, mut other: &'s str) -> (&'s str, &'s str) {
    let common = |pairs: &mut dyn Iterator<Item = (char, char)>| -> usize {
        pairs
            .take_while(|(one, other)| one == other)
            .map(|(letter, _)| letter.len_utf8())
            .sum()
    };
    let start = common(&mut one.chars().zip(other.chars()));
    (one, other) = (&one[start..], &other[start..]);
    let end = common(&mut one.chars().rev().zip(other.chars().rev()));
    (&one[..one.len() - end], &other[..other.len() - end])
}

/// Whether each word is near the one in its place. Names with other numbers of words are compared
/// as a whole, and the extension of a file is no word: `skin.jpg` may well be meant by `skin.png`.
fn words_are_slips(one: &str, other: &str) -> bool {
    let (one, other) = match (one.rsplit_once('.'), other.rsplit_once('.')) {
        (Some((one, _)), Some((other, _))) => (one, other),
        _ => (one, other),
    };
    let words = |name| -> Vec<&str> { str::split(name, |c: char| !c.is_alphanumeric()).collect() };
    let (one, other) = (words(one), words(other));
    let is_slip = |(one, other): (&&str, &&str)| {
        let limit = (one.chars().count() / 3).max(1);
        let (one, other) = without_common_ends(one, other);
        one.len().abs_diff(other.len()) <= 4 * limit
            && strsim::damerau_levenshtein(one, other) <= limit
    };
    if one.len() == other.len() {
        return one.iter().zip(&other).all(is_slip);
    }
    // A word is missing: `torso/belly-in` is a slip for `torso/belly-trans-in`.
    let (long, short) = if one.len() > other.len() {
        (&one, &other)
    } else {
        (&other, &one)
    };
    let mut words = long.iter();
    if short.len() > 1 && short.iter().all(|word| words.any(|other| other == word)) {
        return true;
    }
    // As a whole: one begins with the other, or few letters differ.
    let (one, other) = (one.concat(), other.concat());
    let (is_start, limit) = (
        one.starts_with(&other) || other.starts_with(&one),
        one.chars().count() / 6,
    );
    let (one, other) = without_common_ends(&one, &other);
    is_start
        || one.len().max(other.len()) <= LONGEST && strsim::damerau_levenshtein(one, other) <= limit
}

const fn kind_of_letter(letter: char) -> usize {
    letter as usize % LETTERS
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

/// Whether two names differ by opposite words alone: `l-knee` and `r-knee`, `young-minmuscle` and
/// `young-maxmuscle`.
fn is_opposite(one: &str, other: &str) -> bool {
    let words = |name: &str| -> Vec<String> {
        name.split(|c: char| !c.is_alphanumeric())
            .map(str::to_lowercase)
            .collect::<Vec<_>>()
    };
    let (one, other) = (words(one), words(other));
    let mut differing = one
        .iter()
        .zip(&other)
        .filter(|(one, other)| one != other)
        .peekable();
    one.len() == other.len()
        && differing.peek().is_some()
        && differing.all(|(one, other)| are_opposites(one, other))
}

fn are_opposites(one: &str, other: &str) -> bool {
    let is_pair = |[a, b]: &[&str; 2]| (one, other) == (*a, *b) || (one, other) == (*b, *a);
    let range = |low: &str, high: &str| {
        low.strip_prefix("min")
            .is_some_and(|rest| high.strip_prefix("max") == Some(rest))
    };
    OPPOSITES.iter().any(is_pair)
        || range(one, other)
        || range(other, one)
        || are_numbered(one, other)
}

/// Whether two words differ in their number alone, as `spine01` and `spine02`.
fn are_numbered(one: &str, other: &str) -> bool {
    let stem = |word: &str| word.trim_end_matches(|c: char| c.is_ascii_digit()).len();
    let (end, other_end) = (stem(one), stem(other));
    end < one.len() && other_end < other.len() && one.get(..end) == other.get(..other_end)
}

fn fold(name: &str) -> impl Iterator<Item = char> {
    name.chars()
        .filter(|c| !matches!(c, '-' | '_' | '.' | ' '))
        .flat_map(char::to_lowercase)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn slips_are_found_and_strangers_are_not() {
        let names = [
            "shapes|male hormonal",
            "shapes|female hormonal",
            "face|nose",
        ];
        assert_eq!(
            nearest("shapes|fale hormonal", names),
            Some("shapes|male hormonal")
        );
        assert_eq!(nearest("clothes", names), None);
        assert_eq!(nearest("Face|Nose", names), Some("face|nose"));
    }

    #[test]
    fn names_of_another_thing_are_no_suggestions() {
        for (name, other) in [
            ("c", "a"),
            ("l1", "r1"),
            ("torso/belly-trans-in|out", "ears/l-ear-trans-in|out"),
        ] {
            assert_eq!(nearest(name, [other]), None, "{name}");
        }
        assert_eq!(nearest("c", ["C"]), Some("C"));
        assert_eq!(
            nearest("vertexboneweights", ["vertexboneweights_file"]),
            Some("vertexboneweights_file")
        );
        assert_eq!(
            nearest("torso/belly-trans-in", ["torso/belly-in"]),
            Some("torso/belly-in")
        );
        assert_eq!(
            nearest("macrodetailsCoastal", ["macrodetails/Coastal"]),
            Some("macrodetails/Coastal")
        );
    }

    #[test]
    fn a_file_of_another_kind_is_no_suggestion() {
        let of_kind = |name: &str, other: &'static str| {
            Suggestions::default()
                .nearest_of_kind(name, [other])
                .is_some()
        };
        for (name, other) in [
            ("long_blond_hair.png", "long_blond_hair.png.import"),
            ("young_african.mhmat", "young_african.png"),
            ("a-long-name.target", "a-long-name.target.gz"),
        ] {
            assert!(!of_kind(name, other), "{name}");
            assert_eq!(
                Suggestions::default().nearest_file(name, [other]),
                None,
                "{name}"
            );
        }
        for (name, other) in [
            ("skin.mhmt", "skin.mhmat"),
            ("skin.PNG", "skin.png"),
            ("long_skin", "long_skim"),
        ] {
            assert!(of_kind(name, other), "{name}");
        }
    }

    #[test]
    fn the_opposite_is_no_suggestion() {
        for (name, opposite, like) in [
            ("l-knee", "r-knee", "l-kne"),
            ("lowerarm.L", "lowerarm.R", "lowerarm.l"),
            ("teen-minmuscle", "teen-maxmuscle", "teen-minmuscles"),
            ("nose-hump-incr", "nose-hump-decr", "nose-hum-incr"),
            ("spine01", "spine02", "spin01"),
            ("metacarpal1.L", "metacarpal2.L", "metacarpal1.l"),
        ] {
            assert_eq!(nearest(name, [opposite]), None, "{name}");
            assert_eq!(nearest(name, [opposite, like]), Some(like), "{name}");
        }
        assert_eq!(nearest("r-kne", ["l-knee", "r-knee"]), Some("r-knee"));
    }

    proptest::proptest! {
        #[test]
        fn what_is_left_out_changes_no_distance(name in "[ab-]{0,9}", candidate in "[abC-]{0,9}") {
            let whole = strsim::damerau_levenshtein(&name, &candidate);
            let sought = Sought::new(&name);
            proptest::prop_assert!(sought.least(&candidate) <= whole);
            let (one, other) = without_common_ends(&name, &candidate);
            proptest::prop_assert_eq!(strsim::damerau_levenshtein(one, other), whole);
        }
    }

    #[test]
    fn however_many_names_are_sought_only_so_much_is_compared() {
        let groups: Vec<String> = (0..20_000)
            .map(|at| format!("group {at}|{}", at * 7919 % 20_011))
            .collect();
        let suggestions = Suggestions::default();
        let touched = Cell::new(0);
        for at in 0..20_000 {
            let candidates = groups
                .iter()
                .inspect(|_| touched.set(touched.get() + 1))
                .map(String::as_str);
            suggestions.nearest(&format!("grop {at}"), candidates);
        }
        // Each name that is sought in vain asks for one candidate more.
        assert!(
            touched.get() < COMPARED / COST_OF_CANDIDATE + 20_000,
            "{}",
            touched.get()
        );
        let most = COMPARED + COST_OF_CANDIDATE + COST_OF_PAIR * LONGEST * LONGEST;
        assert!(
            suggestions.compared.get() < most,
            "{}",
            suggestions.compared.get()
        );
    }

    #[test]
    fn what_is_left_out_counts_as_well() {
        let pictures: Vec<String> = (0..20_000).map(|at| format!("{at}.png")).collect();
        let suggestions = Suggestions::default();
        let touched = Cell::new(0);
        for at in 0..20_000 {
            let candidates = pictures
                .iter()
                .inspect(|_| touched.set(touched.get() + 1))
                .map(String::as_str);
            suggestions.nearest_of_kind(&format!("{at}.mhmat"), candidates);
        }
        assert!(suggestions.are_over());
        assert!(
            touched.get() < COMPARED / COST_OF_LOOK + 20_001,
            "{}",
            touched.get()
        );
    }

    #[test]
    fn suggestions_have_an_end() {
        let suggestions = Suggestions::default();
        assert_eq!(suggestions.nearest("l-kne", ["l-knee"]), Some("l-knee"));
        suggestions.compared.set(COMPARED + 1);
        assert_eq!(suggestions.nearest("l-kne", ["l-knee"]), None);
    }

    #[test]
    fn long_names_cost_no_more_than_the_bound() {
        let names: Vec<String> = (0..400)
            .map(|bone| format!("{}{bone:03}", "ab".repeat(98)))
            .collect();
        let suggestions = Suggestions::default();
        for name in &names {
            let parent: String = name.chars().rev().collect();
            suggestions.nearest(&parent, names.iter().map(String::as_str));
        }
        let most = COST_OF_CANDIDATE + 199 + COST_OF_PAIR * LONGEST * LONGEST;
        assert!(
            suggestions.compared.get() <= COMPARED + most,
            "{}",
            suggestions.compared.get()
        );
    }

    #[test]
    fn another_word_is_no_slip() {
        for (name, other) in [
            ("macrodetails/Gender", "macrodetails/Age"),
            (
                "measure/measure-waist-circ-decr|incr",
                "measure/measure-hips-circ-decr|incr",
            ),
            (
                "legs/r-upperleg-thick-decr|incr",
                "legs/r-lowerleg-thick-decr|incr",
            ),
        ] {
            assert_eq!(nearest(name, [other]), None, "{name}");
        }
        assert_eq!(
            nearest("skin_diffuse.png", ["skin_diffuse.jpg"]),
            Some("skin_diffuse.jpg")
        );
        assert_eq!(
            nearest("macrodetails/Gendr", ["macrodetails/Gender"]),
            Some("macrodetails/Gender")
        );
    }

    #[test]
    fn a_file_with_the_same_words_is_nearer_than_one_with_the_same_letters() {
        for (name, candidates, meant) in [
            (
                "head-side-in.target",
                ["head-wide.target", "side-in.target"],
                Some("side-in.target"),
            ),
            (
                "a/side-in.target",
                ["a/side-inch.target", "a/head_Side_in.target"],
                Some("a/head_Side_in.target"),
            ),
            (
                "head-side-in.target",
                ["side-in.target", "head-side-im.target"],
                Some("head-side-im.target"),
            ),
            (
                "head-side-in.target",
                ["in.target", "headside.target"],
                Some("headside.target"),
            ),
            (
                "head-side-in.target",
                ["head-side-out.target", "in-side.target"],
                None,
            ),
        ] {
            let backwards = candidates.iter().rev().copied();
            assert_eq!(
                Suggestions::default().nearest_file(name, candidates),
                meant,
                "{name}"
            );
            assert_eq!(
                Suggestions::default().nearest_file(name, backwards),
                meant,
                "{name}"
            );
        }
        let long = "a-".repeat(LONGEST_PATH);
        assert_eq!(Suggestions::default().nearest_file(&long, ["a-a-a"]), None);
    }

    #[test]
    fn files_with_many_words_cost_no_more_than_the_bound() {
        let names: Vec<String> = (0..400)
            .map(|at| format!("{}{at:03}", "a-".repeat(120)))
            .collect();
        let suggestions = Suggestions::default();
        for name in &names {
            suggestions.nearest_file(&format!("b-{name}"), names.iter().map(String::as_str));
        }
        let most = COST_OF_CANDIDATE + 2 * 243 + 122 * 122 + COST_OF_PAIR * LONGEST * LONGEST;
        assert!(
            suggestions.compared.get() <= COMPARED + most,
            "{}",
            suggestions.compared.get()
        );
    }

    #[test]
    fn the_name_itself_is_no_suggestion() {
        assert_eq!(nearest("a", ["a"]), None);
    }
}
