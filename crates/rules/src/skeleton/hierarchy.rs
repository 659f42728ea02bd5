//! Parents followed upwards: roots, parents that do not exist, rings and what hangs below them.

use std::collections::BTreeMap;

use mhlint_formats::mhskel::{Bone, Skeleton};

/// The hierarchy of a skeleton.
#[derive(Debug, Default, PartialEq)]
pub(super) struct Hierarchy<'a> {
    /// Bones without parent.
    pub(super) roots: Vec<&'a str>,
    /// Parents that do not exist, with the bones that name them.
    pub(super) unknown_parents: BTreeMap<&'a str, Vec<&'a str>>,
    /// Bones whose parents run in a circle.
    pub(super) rings: Vec<Ring<'a>>,
    /// Bones of which no one knows what is above them.
    pub(super) unclear: usize,
}

/// A circle of parents.
#[derive(Debug, Default, PartialEq)]
pub(super) struct Ring<'a> {
    /// Its bones, each the parent of the one before.
    pub(super) bones: Vec<&'a str>,
    /// Bones that hang below it, in file order.
    pub(super) below: Vec<&'a str>,
}

#[derive(Clone, Copy, PartialEq)]
enum State {
    New,
    /// On the path that is being followed.
    Open,
    /// Ends at a root, or at something unknown.
    Ends,
    /// Ends in the ring of that number.
    Circles(usize),
}

/// Follows all parents.
pub(super) fn hierarchy(skeleton: &Skeleton) -> Hierarchy<'_> {
    let mut hierarchy = Hierarchy::default();
    let index: BTreeMap<&str, usize> = (skeleton.bones.iter().enumerate())
        .map(|(at, bone)| (bone.name.as_str(), at))
        .collect();
    for bone in &skeleton.bones {
        match bone.parent.as_deref() {
            None if bone.is_root() => hierarchy.roots.push(&bone.name),
            None => hierarchy.unclear += 1,
            Some(parent) if !index.contains_key(parent) => {
                hierarchy
                    .unknown_parents
                    .entry(parent)
                    .or_default()
                    .push(&bone.name);
            }
            Some(_) => {}
        }
    }
    let parent = |at: usize| {
        skeleton
            .bones
            .get(at)
            .and_then(|bone| index.get(bone.parent.as_deref()?).copied())
    };
    let mut states = vec![State::New; skeleton.bones.len()];
    for start in 0..skeleton.bones.len() {
        follow(
            &skeleton.bones,
            start,
            parent,
            &mut states,
            &mut hierarchy.rings,
        );
    }
    hierarchy
}

fn follow<'a>(
    bones: &'a [Bone],
    start: usize,
    parent: impl Fn(usize) -> Option<usize>,
    states: &mut [State],
    rings: &mut Vec<Ring<'a>>,
) {
    let name = |at: usize| bones.get(at).map_or("", |bone| bone.name.as_str());
    let state = |states: &[State], at: usize| states.get(at).copied().unwrap_or(State::Ends);
    let mut path = Vec::new();
    let mut next = Some(start);
    while let Some(at) = next.filter(|at| state(states, *at) == State::New) {
        path.push(at);
        if let Some(state) = states.get_mut(at) {
            *state = State::Open;
        }
        next = parent(at);
    }
    let mut end = next.map_or(State::Ends, |at| state(states, at));
    let ring_start = path.iter().position(|at| Some(*at) == next);
    if end == State::Open {
        end = State::Circles(rings.len());
        let ring = path.iter().skip(ring_start.unwrap_or_default());
        rings.push(Ring {
            bones: ring.map(|at| name(*at)).collect(),
            below: Vec::new(),
        });
    }
    let below = path.iter().take(ring_start.unwrap_or(path.len()));
    if let State::Circles(ring) = end
        && let Some(ring) = rings.get_mut(ring)
    {
        ring.below.extend(below.map(|at| name(*at)));
    }
    for at in path {
        if let Some(state) = states.get_mut(at) {
            *state = end;
        }
    }
}

impl Hierarchy<'_> {
    /// Whether the fault is that nothing is a root; not, if unknown parents, unreadable bones or a
    /// bone that is its own parent explain it.
    pub(super) fn lacks_root(&self) -> bool {
        let is_own_parent = self.rings.iter().any(|ring| ring.bones.len() == 1);
        self.roots.is_empty()
            && self.unknown_parents.is_empty()
            && self.unclear == 0
            && !is_own_parent
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use mhlint_formats::mhskel;

    fn skeleton(parents: &[(&str, &str)]) -> Skeleton {
        let bones: Vec<String> = parents
            .iter()
            .map(|(bone, parent)| format!(r#""{bone}": {{"parent": {parent}}}"#))
            .collect();
        mhskel::read(
            &mhlint_json::parse(format!("{{\"bones\": {{{}}}}}", bones.join(",")).as_bytes())
                .unwrap(),
        )
    }

    #[test]
    fn rings_and_what_hangs_below_are_told_apart() {
        let file = skeleton(&[
            ("x", "\"a\""),
            ("root", "null"),
            ("a", "\"b\""),
            ("b", "\"a\""),
            ("y", "\"x\""),
            ("c", "\"root\""),
            ("self", "\"self\""),
        ]);
        let hierarchy = hierarchy(&file);
        let rings: Vec<_> = hierarchy
            .rings
            .iter()
            .map(|ring| (ring.bones.clone(), ring.below.clone()))
            .collect();
        assert_eq!(
            rings,
            [(vec!["a", "b"], vec!["x", "y"]), (vec!["self"], vec![])]
        );
        assert_eq!(hierarchy.roots, ["root"]);
    }

    #[test]
    fn unknown_and_unreadable_parents_excuse_a_missing_root() {
        assert!(!hierarchy(&skeleton(&[("a", "\"gone\""), ("b", "\"a\"")])).lacks_root());
        assert!(!hierarchy(&skeleton(&[("a", "5"), ("b", "\"a\"")])).lacks_root());
        assert!(hierarchy(&skeleton(&[("a", "\"b\""), ("b", "\"a\"")])).lacks_root());
        assert!(hierarchy(&skeleton(&[])).lacks_root());
    }
}
