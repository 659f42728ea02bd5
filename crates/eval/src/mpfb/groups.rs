//! Weights as vertex groups: which bone a group of a file leads to, and what its entries come to.
//!
//! Source: MPFB, weights (`docs/loaders/mpfb/weights.md#group-to-bone`,
//! `docs/loaders/mpfb/weights.md#assigning`; `reference/README.md`, `mpfb_weights`).

use std::collections::{BTreeMap, BTreeSet};

/// Bones of an armature that groups of weights can lead to.
#[derive(Debug, Clone, Default, PartialEq, Eq, PartialOrd, Ord)]
pub struct Takers<'a> {
    bones: BTreeMap<&'a str, usize>,
    extra: BTreeSet<&'a str>,
    with_toes: BTreeSet<&'a str>,
}

/// A bone of an armature.
#[derive(Debug, Clone, Copy)]
pub struct Taker<'a> {
    /// Its name.
    pub name: &'a str,
    /// Name of the bone that it hangs on.
    pub parent: Option<&'a str>,
    /// Whether it deforms: others take no weights.
    pub deforms: bool,
}

/// Groups with this beginning are kept as they are.
pub const MASK: &str = "mhmask-";
const DEFORMING: &str = "DEF-";

impl<'a> Takers<'a> {
    /// The bones of an armature in its order, and those that are made later.
    pub fn new(
        bones: impl IntoIterator<Item = Taker<'a>>,
        extra: impl IntoIterator<Item = &'a str>,
    ) -> Self {
        let mut takers = Self {
            extra: extra.into_iter().collect(),
            ..Self::default()
        };
        for (at, bone) in bones.into_iter().enumerate() {
            if bone.deforms {
                takers.bones.insert(bone.name, at);
            }
            if let Some(parent) = bone.parent.filter(|_| bone.name.contains("toe")) {
                takers.with_toes.insert(parent);
            }
        }
        takers
    }

    /// What any of several armatures takes; the places of the bones stand for nothing.
    pub fn any_of<'t>(all: impl IntoIterator<Item = &'t Self>) -> Self
    where
        'a: 't,
    {
        let mut any = Self::default();
        for one in all {
            // A bone that toes hang on is led to by its own name alone.
            let free = one.bones.iter();
            let free = free.filter(|(name, _)| !one.with_toes.contains(*name));
            any.bones.extend(free);
            any.extra.extend(one.bones.keys().chain(&one.extra));
        }
        any
    }

    /// The bone that a group leads to, and its place in the armature; an extra one has none.
    pub fn taker(&self, group: &str) -> Option<(String, Option<usize>)> {
        let toggled = toggled(group);
        let own = [group, &toggled]
            .into_iter()
            .find_map(|name| self.bone(name));
        let found = own.or_else(|| self.common_toe(group));
        let extra = || {
            [group, &toggled]
                .into_iter()
                .find(|name| self.extra.contains(name))
                .map(|name| (name.to_owned(), None))
        };
        found.or_else(extra)
    }

    fn bone(&self, name: &str) -> Option<(String, Option<usize>)> {
        self.bones.get(name).map(|at| (name.to_owned(), Some(*at)))
    }

    /// The toe that stands for all of them, where a rig has no others.
    fn common_toe(&self, group: &str) -> Option<(String, Option<usize>)> {
        let side = side_of_toe(group)?;
        let names = [
            format!("toe.{side}"),
            format!("DEF-toe.{side}"),
            format!("toe1-1.{side}"),
        ];
        names
            .iter()
            .filter(|name| !self.with_toes.contains(name.as_str()))
            .find_map(|name| self.bone(name))
    }
}

fn toggled(group: &str) -> String {
    group
        .strip_prefix(DEFORMING)
        .map_or_else(|| format!("{DEFORMING}{group}"), str::to_owned)
}

/// The side of a group of a single toe: `toe2-1.L`. Any character may stand before the letter.
fn side_of_toe(group: &str) -> Option<char> {
    let name = group
        .strip_prefix(DEFORMING)
        .unwrap_or(group)
        .strip_prefix("toe")?;
    let mut rest = name.chars();
    let is_digit = |next: Option<char>| next.is_some_and(|digit| digit.is_ascii_digit());
    let is_toe = is_digit(rest.next())
        && rest.next() == Some('-')
        && is_digit(rest.next())
        && rest.next().is_some();
    let side = rest.next().filter(|side| matches!(side, 'L' | 'R'))?;
    (is_toe && rest.next().is_none()).then_some(side)
}

/// A group of a weights file: its name, and vertices with their weights.
pub type FileGroup<'a> = (&'a str, &'a [(i64, f64)]);
/// A vertex group: each vertex once.
pub type VertexGroup = (String, BTreeMap<usize, f64>);

/// A group with its place among the bones, and that in its file.
type Planned<'a> = (usize, usize, String, &'a [(i64, f64)]);

/// How weights are loaded.
#[derive(Debug, Clone, Copy, Default)]
pub struct Loading {
    /// Groups that lead to no bone are kept, too.
    pub all: bool,
    /// Groups that are there are emptied first.
    pub replace: bool,
    /// Vertices of the mesh.
    pub vertices: usize,
}

/// Vertex groups after weights were loaded: those there were, then new ones in the order of the
/// bones, then others in that of the file.
pub fn load(
    existing: Vec<VertexGroup>,
    file: &[FileGroup<'_>],
    takers: &Takers<'_>,
    loading: Loading,
) -> Vec<VertexGroup> {
    let mut plan: Vec<Planned<'_>> = Vec::new();
    for (order, (group, pairs)) in file.iter().enumerate() {
        match takers.taker(group) {
            Some((bone, at)) => plan.push((at.unwrap_or(usize::MAX - 1), order, bone, pairs)),
            None if loading.all || group.starts_with(MASK) => {
                plan.push((usize::MAX, order, (*group).to_owned(), pairs));
            }
            None => {}
        }
    }
    plan.sort_by_key(|(at, order, ..)| (*at, *order));
    let mut groups = existing;
    let mut places: BTreeMap<String, usize> = groups
        .iter()
        .enumerate()
        .map(|(at, (name, _))| (name.clone(), at))
        .collect();
    let mut begun: BTreeMap<usize, BTreeSet<usize>> = BTreeMap::new();
    for (_, _, name, pairs) in plan {
        let known = places.get(&name).copied();
        // An empty list makes no group; it empties one that is replaced.
        if known.is_none() && pairs.is_empty() && !loading.all {
            continue;
        }
        let at = known.unwrap_or(groups.len());
        if known.is_none() {
            places.insert(name.clone(), at);
            groups.push((name, BTreeMap::new()));
        }
        if let Some((_, values)) = groups.get_mut(at) {
            let is_first = !begun.contains_key(&at);
            add(
                values,
                pairs,
                is_first,
                begun.entry(at).or_default(),
                loading,
            );
        }
    }
    groups
}

fn add(
    values: &mut BTreeMap<usize, f64>,
    pairs: &[(i64, f64)],
    is_first: bool,
    seen: &mut BTreeSet<usize>,
    loading: Loading,
) {
    if is_first && loading.replace {
        values.clear();
    }
    for (vertex, weight) in pairs {
        let Some(vertex) = usize::try_from(*vertex)
            .ok()
            .filter(|vertex| *vertex < loading.vertices)
        else {
            continue;
        };
        let value = values.entry(vertex).or_insert(0.0);
        if seen.insert(vertex) {
            *value = 0.0;
        }
        *value = clamped(*value + clamped(*weight));
    }
}

/// Blender keeps weights from 0 to 1; NaN stays.
fn clamped(weight: f64) -> f64 {
    if weight.is_nan() {
        weight
    } else {
        weight.clamp(0.0, 1.0)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn bone<'a>(name: &'a str, parent: Option<&'a str>) -> Taker<'a> {
        Taker {
            name,
            parent,
            deforms: true,
        }
    }

    fn takers() -> Takers<'static> {
        let bones = [
            bone("a", None),
            bone("DEF-b", None),
            bone("toe.L", None),
            bone("toe.R", None),
        ];
        let no = Taker {
            deforms: false,
            ..bone("no", None)
        };
        let toe = bone("toe1.R", Some("toe.R"));
        Takers::new(bones.into_iter().chain([no, toe]), ["x", "DEF-y"])
    }

    #[test]
    fn groups_lead_to_bones() {
        let takers = takers();
        let name = |group: &str| takers.taker(group).map(|(name, _)| name);
        for (group, bone) in [
            ("a", "a"),
            ("DEF-a", "a"),
            ("b", "DEF-b"),
            ("toe3-2.L", "toe.L"),
            ("y", "DEF-y"),
            ("x", "x"),
        ] {
            assert_eq!(name(group).as_deref(), Some(bone), "{group}");
        }
        for group in [
            "A",
            "no",
            "toe3-2.R",
            "toe3-22.L",
            "toe3-2.LL",
            "mhmask-x",
            "",
        ] {
            assert_eq!(name(group), None, "{group}");
        }
    }

    #[test]
    fn entries_add_up_to_one_at_most() {
        let loading = Loading {
            vertices: 3,
            ..Loading::default()
        };
        let file: [FileGroup<'_>; 3] = [
            ("mhmask-m", &[(0, 0.5)]),
            ("b", &[(0, 0.7), (0, 0.6), (9, 1.0), (-1, 1.0)]),
            ("a", &[(1, -2.0), (2, 0.25)]),
        ];
        let groups = load(Vec::new(), &file, &takers(), loading);
        let expected: Vec<VertexGroup> = vec![
            ("a".to_owned(), BTreeMap::from([(1, 0.0), (2, 0.25)])),
            ("DEF-b".to_owned(), BTreeMap::from([(0, 1.0)])),
            ("mhmask-m".to_owned(), BTreeMap::from([(0, 0.5)])),
        ];
        assert_eq!(groups, expected);
        // Listed vertices begin at 0 again, others stay.
        let again = load(groups.clone(), &[("a", &[(1, 0.5)])], &takers(), loading);
        assert_eq!(again[0].1, BTreeMap::from([(1, 0.5), (2, 0.25)]));
        let replaced = load(
            groups,
            &[("a", &[(1, 0.5)])],
            &takers(),
            Loading {
                replace: true,
                ..loading
            },
        );
        assert_eq!(replaced[0].1, BTreeMap::from([(1, 0.5)]));
    }
}
