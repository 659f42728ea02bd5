//! What the path of a target tells MakeHuman 1: the group it is in, and the macro variables that it
//! depends on (`docs/loaders/makehuman1/targets.md#names`).

/// The categories of macro variables with the words that stand for their values.
pub const CATEGORIES: [(&str, &[&str]); 9] = [
    ("gender", &["male", "female"]),
    ("age", &["baby", "child", "young", "old"]),
    ("race", &["caucasian", "asian", "african"]),
    ("muscle", &["maxmuscle", "averagemuscle", "minmuscle"]),
    ("weight", &["minweight", "averageweight", "maxweight"]),
    ("height", &["minheight", "averageheight", "maxheight"]),
    ("breastsize", &["mincup", "averagecup", "maxcup"]),
    (
        "breastfirmness",
        &["minfirmness", "averagefirmness", "maxfirmness"],
    ),
    (
        "bodyproportions",
        &[
            "uncommonproportions",
            "regularproportions",
            "idealproportions",
        ],
    ),
];

/// What a path comes to.
#[derive(Debug, Clone, Default, PartialEq, Eq, PartialOrd, Ord)]
pub struct TargetName {
    /// The words of the name of its group.
    pub key: Vec<String>,
    /// For each category the value that it has.
    pub values: Values,
}

/// For each category a value.
pub type Values = [Option<&'static str>; CATEGORIES.len()];

/// The values of a path with one more element.
///
/// # Errors
/// As [`TargetName::of`].
pub fn values_below(mut values: Values, element: &str) -> Result<Values, Clash> {
    words(element)
        .filter_map(reserved)
        .try_for_each(|own| add(&mut values, own))
        .map(|()| values)
}

/// The words of an element that count.
fn words(element: &str) -> impl Iterator<Item = &str> {
    let all = element.split(['-', '_', '.']).enumerate();
    all.filter(|(at, word)| !(*at == 0 && *word == "targets" || *word == "target"))
        .map(|(_, word)| word)
}

fn add(values: &mut Values, (place, value): (usize, &'static str)) -> Result<(), Clash> {
    let Some(slot) = values.get_mut(place) else {
        return Ok(());
    };
    if let Some(first) = slot.filter(|first| *first != value) {
        let category = CATEGORIES.get(place).map_or("", |(category, _)| category);
        return Err(Clash {
            category,
            first,
            second: value,
        });
    }
    *slot = Some(value);
    Ok(())
}

/// Two values of one category.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Clash {
    /// The category.
    pub category: &'static str,
    /// The value that it has already.
    pub first: &'static str,
    /// The other one.
    pub second: &'static str,
}

impl TargetName {
    /// What a path below the data folder comes to.
    ///
    /// # Errors
    /// Two values of one category: the application stops there.
    pub fn of(rel: &str) -> Result<Self, Clash> {
        rel.split('/').try_fold(Self::default(), Self::below)
    }

    /// What becomes of it with one more element of the path, a folder or the name of the file.
    ///
    /// # Errors
    /// As [`Self::of`].
    pub fn below(mut self, element: &str) -> Result<Self, Clash> {
        for word in words(element) {
            match reserved(word) {
                Some(own) => add(&mut self.values, own)?,
                None => self.key.push(word.to_owned()),
            }
        }
        Ok(self)
    }

    /// The categories that it has a value of.
    pub fn categories(&self) -> impl Iterator<Item = (&'static str, &'static str)> {
        let named = CATEGORIES.iter().zip(&self.values);
        named.filter_map(|((category, _), value)| Some((*category, (*value)?)))
    }

    /// The value that it has of a category.
    pub fn value(&self, category: &str) -> Option<&'static str> {
        self.categories()
            .find(|(own, _)| *own == category)
            .map(|(_, value)| value)
    }

    /// Whether it depends on some macro variable.
    pub fn is_macro(&self) -> bool {
        self.values.iter().any(Option::is_some)
    }

    /// The name of its group.
    pub fn group(&self) -> String {
        self.key.join("-")
    }
}

/// The place of the category that a word is a value of, and the word.
fn reserved(word: &str) -> Option<(usize, &'static str)> {
    let value = |(_, values): &(&str, &'static [&'static str])| {
        values.iter().find(|value| **value == word).copied()
    };
    CATEGORIES
        .iter()
        .enumerate()
        .find_map(|(place, row)| Some((place, value(row)?)))
}

/// The category that a word is a value of, such as `gender` of `male`.
pub fn category_of(word: &str) -> Option<&'static str> {
    CATEGORIES
        .get(reserved(word)?.0)
        .map(|(category, _)| *category)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn of(rel: &str) -> (String, Vec<(&'static str, &'static str)>) {
        let name = TargetName::of(rel).unwrap();
        (name.group(), name.categories().collect())
    }

    #[test]
    fn words_are_values_or_parts_of_the_group() {
        let race = vec![("gender", "female"), ("age", "baby"), ("race", "asian")];
        assert_eq!(
            of("targets/macrodetails/asian-female-baby.target"),
            ("macrodetails".to_owned(), race)
        );
        assert_eq!(
            of("targets/head/head-oval.target"),
            ("head-head-oval".to_owned(), Vec::new())
        );
        assert_eq!(of("head/targets-head_oval.target").0, "head-head-oval");
        assert_eq!(of("head/oval-targets.target").0, "head-oval-targets");
        assert_eq!(of("targets/targets/head/target/oval.target").0, "head-oval");
        assert_eq!(of("targets/head/head--oval.target").0, "head-head--oval");
        assert_eq!(of("targets/head/Female.TARGET").0, "head-Female-TARGET");
        assert_eq!(
            of("targets/macrodetails/height/minheight.target"),
            (
                "macrodetails-height".to_owned(),
                vec![("height", "minheight")]
            )
        );
        assert_eq!(of("targets/female.target").0, "");
    }

    #[test]
    fn one_category_has_one_value() {
        assert_eq!(
            of("targets/female/female-old.target").1,
            [("gender", "female"), ("age", "old")]
        );
        let clash = Clash {
            category: "gender",
            first: "male",
            second: "female",
        };
        assert_eq!(TargetName::of("clothes/male_female_shirt"), Err(clash));
        assert!(TargetName::of("hair/old/young").is_err());
        assert!(TargetName::of("hair/Old/young").is_ok());
        assert_eq!(category_of("mincup"), Some("breastsize"));
        assert_eq!(category_of("cup"), None);
    }
}
