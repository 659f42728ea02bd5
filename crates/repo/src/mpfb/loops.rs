//! Which targets MPFB composes the names of: five loops over the names in `macro.json`, hard-coded
//! in the program (`docs/loaders/mpfb/macros.md#the-five-loops`).

use std::collections::BTreeMap;

use mhlint_formats::macro_parts::{MacroParts, RACES, Setting};

/// Places among the settings.
pub const GENDER: usize = 0;
pub const AGE: usize = 1;
const MUSCLE: usize = 2;
const WEIGHT: usize = 3;
const PROPORTIONS: usize = 4;
const HEIGHT: usize = 5;
const CUP_SIZE: usize = 6;
const FIRMNESS: usize = 7;

/// A target is applied with a weight above this, as in `eval/mpfb/loops.rs`, which knows no files.
const CUT_OFF: f64 = 0.01;
/// Most combinations of shares in one loop, every part counted with both its names. Those of MPFB
/// come to 3072.
const MOST_COMBINATIONS: usize = 1 << 16;
/// Most bytes of the names of all targets of a loop. Those of MPFB come to a fiftieth.
const MOST_BYTES: usize = 1 << 24;

/// A loop over names.
#[derive(Debug)]
pub struct Loop {
    /// What its targets are called here.
    pub title: &'static str,
    /// What stands before the names, below `targets/`.
    pub prefix: &'static str,
    /// Whose names are put together.
    pub axes: &'static [Axis],
    /// The axes in the order in which they run, outermost first: so the shape keys of a character
    /// follow each other.
    pub order: &'static [usize],
    /// Names with one of these in them are skipped.
    left_out: &'static [&'static str],
}

/// Where a part of a name comes from.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Axis {
    /// The races.
    Race,
    /// The names of a setting, by its place.
    Setting(usize),
    /// One name of a setting: the loop runs where it has a share, whatever that is.
    Only(usize, &'static str),
}

use Axis::{Only, Race, Setting as Of};

/// The loops, in their order.
pub static LOOPS: [Loop; 5] = [
    Loop {
        title: "race",
        prefix: "macrodetails/",
        axes: &[Race, Of(GENDER), Of(AGE)],
        order: &[0, 2, 1],
        left_out: &[],
    },
    Loop {
        title: "universal",
        prefix: "macrodetails/universal-",
        axes: &[Of(GENDER), Of(AGE), Of(MUSCLE), Of(WEIGHT)],
        order: &[0, 1, 2, 3],
        left_out: &[],
    },
    Loop {
        title: "height",
        prefix: "macrodetails/height/",
        axes: &[Of(GENDER), Of(AGE), Of(MUSCLE), Of(WEIGHT), Of(HEIGHT)],
        order: &[0, 1, 2, 3, 4],
        left_out: &[],
    },
    Loop {
        title: "breast",
        prefix: "breast/",
        axes: &[
            Only(GENDER, "female"),
            Of(AGE),
            Of(MUSCLE),
            Of(WEIGHT),
            Of(CUP_SIZE),
            Of(FIRMNESS),
        ],
        order: &[0, 1, 2, 3, 4, 5],
        left_out: &["averagecup-averagefirmness", "-baby-", "_baby_"],
    },
    Loop {
        title: "proportions",
        prefix: "macrodetails/proportions/",
        axes: &[Of(GENDER), Of(AGE), Of(MUSCLE), Of(WEIGHT), Of(PROPORTIONS)],
        order: &[0, 1, 2, 3, 4],
        left_out: &["-baby-", "_baby_"],
    },
];

impl Loop {
    /// Whether it needs a share of a setting.
    pub fn needs(&self, place: usize) -> bool {
        self.axes
            .iter()
            .any(|axis| matches!(axis, Of(own) | Only(own, _) if *own == place))
    }

    /// Path below `targets/` of the target for a combination of names, without suffix; `None` for
    /// one that is skipped.
    pub fn target(&self, names: &[&str]) -> Option<String> {
        // Only the loop over races regards the gender `universal`: its names are those of the next
        // loop.
        let is_universal = self
            .axes
            .iter()
            .zip(names)
            .any(|(axis, name)| *axis == Of(GENDER) && *name == "universal");
        let path = format!("{}{}", self.prefix, names.join("-"));
        let is_skipped = self.left_out.iter().any(|part| path.contains(part));
        (!is_skipped && (!is_universal || !self.axes.contains(&Race))).then_some(path)
    }

    /// What its names are put together from: for each axis the names, with the largest share that a
    /// slider gives them.
    pub fn names<'p>(&self, file: &'p MacroParts) -> Vec<Vec<Name<'p>>> {
        self.axes.iter().map(|axis| axis.names(file)).collect()
    }

    fn combinations(&self, file: &MacroParts) -> usize {
        let parts = |axis: &Axis| {
            axis.setting(file)
                .map_or(RACES.len(), |own| 2 * own.parts.len())
        };
        self.axes.iter().map(parts).fold(1, usize::saturating_mul)
    }

    /// Bytes of the longest name of each setting.
    fn longest(&self, file: &MacroParts) -> usize {
        let settings = self.axes.iter().filter_map(|axis| axis.setting(file));
        let longest = |own: &Setting| {
            own.parts
                .iter()
                .flat_map(|part| [&part.low, &part.high])
                .flatten()
                .map(String::len)
                .max()
        };
        settings.filter_map(longest).sum()
    }
}

/// A name with the largest share that it has anywhere on its slider.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Name<'p> {
    /// The name.
    pub text: &'p str,
    most: f64,
}

impl Axis {
    fn setting<'p>(&self, file: &'p MacroParts) -> Option<&'p Setting> {
        let (Of(place) | Only(place, _)) = self else {
            return None;
        };
        file.settings.iter().find(|own| own.place == *place)
    }

    fn names<'p>(&self, file: &'p MacroParts) -> Vec<Name<'p>> {
        match self {
            Race => RACES.iter().map(|text| Name { text, most: 1.0 }).collect(),
            Of(_) => self.setting(file).map(names).unwrap_or_default(),
            Only(place, only) => {
                let mut names = Of(*place).names(file);
                names.retain(|name| name.text == *only);
                // The share itself does not count.
                names
                    .iter_mut()
                    .for_each(|name| name.most = if name.most > 0.0 { 1.0 } else { 0.0 });
                names
            }
        }
    }
}

/// The names of a setting in the order of its parts, each once.
pub fn names(setting: &Setting) -> Vec<Name<'_>> {
    let mut names: Vec<Name<'_>> = Vec::new();
    let mut places: BTreeMap<&str, usize> = BTreeMap::new();
    for part in &setting.parts {
        let length = part.highest - part.lowest;
        // One that never matches, or gives shares that are no numbers, adds nothing.
        let is_live = length > 0.0 && length.is_finite();
        let is_reached = is_live && part.lowest < 1.0 && part.highest > 0.0;
        let low = 1.0 - (part.lowest.max(0.0) - part.lowest) / length;
        let high = (part.highest.min(1.0) - part.lowest) / length;
        for (text, share) in [(&part.low, low), (&part.high, high)] {
            let Some(text) = text.as_deref() else {
                continue;
            };
            let most = if is_reached { share } else { 0.0 };
            let place = *places.entry(text).or_insert(names.len());
            match names.get_mut(place) {
                Some(known) => known.most = known.most.max(most),
                None => names.push(Name { text, most }),
            }
        }
    }
    names
}

/// Whether a combination gets a weight above the cut-off at some setting of the sliders.
pub fn is_reachable(combination: &[Name<'_>]) -> bool {
    combination.iter().map(|name| name.most).product::<f64>() > CUT_OFF
}

/// Whether these are more combinations than are looked at.
pub(super) fn are_too_many(file: &MacroParts) -> bool {
    LOOPS.iter().any(|own| {
        let (combinations, longest) = (own.combinations(file), own.longest(file));
        combinations > MOST_COMBINATIONS || combinations.saturating_mul(longest) > MOST_BYTES
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use mhlint_formats::macro_parts::Part;

    fn part(lowest: f64, highest: f64, low: &str, high: &str) -> Part {
        let name = |text: &str| Some(text.to_owned()).filter(|text| !text.is_empty());
        Part {
            index: 0,
            lowest,
            highest,
            low: name(low),
            high: name(high),
        }
    }

    fn setting(parts: Vec<Part>) -> Setting {
        Setting {
            place: AGE,
            parts,
            is_whole: true,
        }
    }

    #[test]
    fn names_come_once_with_their_largest_share() {
        let setting = setting(vec![
            part(-1.0, 0.5, "baby", "child"),
            part(0.5, 1.5, "child", "old"),
            part(2.0, 3.0, "", "ghost"),
            part(0.6, 0.4, "turned", ""),
            part(f64::NEG_INFINITY, 1.0, "endless", ""),
        ]);
        let found: Vec<(&str, f64)> = names(&setting)
            .iter()
            .map(|name| (name.text, name.most))
            .collect();
        let baby = 1.0 - 1.0 / 1.5;
        assert_eq!(
            found,
            [
                ("baby", baby),
                ("child", 1.0),
                ("old", 0.5),
                ("ghost", 0.0),
                ("turned", 0.0),
                ("endless", 0.0)
            ]
        );
        assert!(!is_reachable(&[names(&setting)[3]]) && is_reachable(&[names(&setting)[0]]));
    }

    #[test]
    fn what_the_loops_skip_is_never_asked_for() {
        let target = |number: usize, names: &[&str]| LOOPS[number].target(names);
        assert_eq!(
            target(0, &["asian", "female", "young"]).as_deref(),
            Some("macrodetails/asian-female-young")
        );
        assert_eq!(target(0, &["asian", "universal", "young"]), None);
        assert_eq!(
            target(3, &["female", "baby", "a", "b", "mincup", "x"]),
            None
        );
        assert_eq!(
            target(
                3,
                &["female", "young", "a", "b", "averagecup", "averagefirmness"]
            ),
            None
        );
        assert!(
            target(
                3,
                &["female", "young", "a", "b", "averagecup", "maxfirmness"]
            )
            .is_some()
        );
        assert_eq!(target(4, &["male", "baby", "a", "b", "ideal"]), None);
        assert!(target(1, &["male", "baby", "a", "b"]).is_some());
    }

    #[test]
    fn loops_are_bounded() {
        let parts = |count: usize| vec![part(0.0, 1.0, "a", "b"); count];
        let file = |count: usize| MacroParts {
            settings: (0..8)
                .map(|place| Setting {
                    place,
                    parts: parts(count),
                    is_whole: true,
                })
                .collect(),
            ..MacroParts::default()
        };
        assert!(!are_too_many(&file(2)) && are_too_many(&file(40)));
        let mut long = file(2);
        long.settings[AGE].parts[0].low = Some("a".repeat(MOST_BYTES));
        assert!(are_too_many(&long));
    }
}
