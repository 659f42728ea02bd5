//! Parts of a JSON that the schema says something of: what they lack, or seem to hold, follows from
//! that.

use mhlint_diag::pointer;
use mhlint_json::{SchemaFault, UnknownKey};
use mhlint_repo::FileFacts;

/// Whether the whole is of another type than its format.
pub(crate) fn is_of_wrong_type(file: &FileFacts) -> bool {
    file.schema.faults.iter().any(SchemaFault::is_wrong_root)
}

/// Whether a rule for files of this kind says what does not fit: its loader takes more than a
/// schema can say.
pub(crate) const fn has_own_rule(file: &FileFacts) -> bool {
    file.kind.is_judged_by_loader()
}

/// Whether the schema has nothing against the value at a pointer or below it; else the model lacks
/// a part of it.
pub(crate) fn is_sound(file: &FileFacts, pointer: &str) -> bool {
    file.schema
        .at(pointer)
        .chain(file.schema.inside(pointer))
        .next()
        .is_none()
}

/// The key that stands where `key` is meant, if it is misspelt.
pub(crate) fn misspelt<'f>(file: &'f FileFacts, key: &str) -> Option<&'f UnknownKey> {
    file.schema
        .unknown
        .iter()
        .find(|unknown| unknown.nearest.as_deref() == Some(key))
}

/// Whether an unknown key stands where a key is missing from the same object: it is much like that
/// one, or like no other and the only one that is unknown there.
pub(crate) fn stands_for(unknown: &UnknownKey, missing: &str) -> bool {
    match &unknown.nearest {
        Some(nearest) => nearest == missing,
        None => !unknown.is_object && unknown.is_alone,
    }
}

/// Whether a member of the whole is there with a fault in it, or under a misspelt key.
pub(crate) fn is_faulty(file: &FileFacts, key: &str) -> bool {
    !is_sound(file, &pointer(&[key])) || misspelt(file, key).is_some()
}
