//! Which bones of the base skeleton those of another one name, in plain numbers
//! (`docs/loaders/makehuman1/skeletons.md#references-and-weights`).

use std::collections::BTreeMap;

use super::mhskel::Skeleton;

/// The bones of a base skeleton, and what the bones of another one name of them.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct BoneReferences<'s> {
    /// The names of the base skeleton, in its order.
    pub base: Vec<&'s str>,
    /// The parent of each of them.
    pub parents: Vec<Option<usize>>,
    /// What each bone of the other skeleton names.
    pub bones: Vec<NamedBones>,
}

/// What a bone names: places of bones of the base skeleton.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct NamedBones {
    /// That of its own name.
    pub same_name: Option<usize>,
    /// Those whose weights it takes; `None` for a name that the base skeleton lacks.
    pub references: Vec<Option<usize>>,
    /// Whether they are given for weights alone.
    pub is_explicit: bool,
}

impl<'s> BoneReferences<'s> {
    /// What `other` names of `base`.
    pub fn of(base: &'s Skeleton, other: &Skeleton) -> Self {
        let order = base.breadth_first().into_iter();
        let ordered: Vec<(&str, Option<usize>)> = order
            .filter_map(|(place, parent)| Some((base.bones.get(place)?.name.as_str(), parent)))
            .collect();
        let places: BTreeMap<&str, usize> = ordered
            .iter()
            .enumerate()
            .rev()
            .map(|(place, (name, _))| (*name, place))
            .collect();
        let place = |name: &str| places.get(name).copied();
        let bones = other.bones.iter().map(|bone| {
            let (names, is_explicit) = bone.weight_references();
            let references = names.iter().map(|name| place(name)).collect();
            NamedBones {
                same_name: place(&bone.name),
                references,
                is_explicit,
            }
        });
        let bones = bones.collect();
        let (base, parents) = ordered.into_iter().unzip();
        Self {
            base,
            parents,
            bones,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::mhskel::read;

    #[test]
    fn names_become_places_in_the_order_of_the_base() {
        let skeleton = |text: &str| read(&mhlint_json::parse(text.as_bytes()).unwrap());
        let bone = r#""head": "a", "tail": "b""#;
        let base = skeleton(&format!(
            r#"{{"bones": {{"tip": {{{bone}, "parent": "root"}}, "root": {{{bone}, "parent": null}}}}}}"#
        ));
        let other = skeleton(&format!(
            r#"{{"bones": {{"tip": {{{bone}, "reference": ["root", "x"]}}, "end": {{{bone}, "weights_reference": "tip"}}}}}}"#
        ));
        let found = BoneReferences::of(&base, &other);
        assert_eq!(
            (found.base, found.parents),
            (vec!["root", "tip"], vec![None, Some(0)])
        );
        let named = |same_name, references: &[Option<usize>], is_explicit| NamedBones {
            same_name,
            references: references.to_vec(),
            is_explicit,
        };
        assert_eq!(
            found.bones,
            [
                named(Some(1), &[Some(0), None], false),
                named(None, &[Some(1)], true)
            ]
        );
    }
}
