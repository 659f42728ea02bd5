//! Files of which something else is told before what is in them.

use super::consequence::{Moment, moment};
use mhlint_discover::{Kind, is_in_override_folder};
use mhlint_formats::Content;
use mhlint_formats::json_file::JsonFault;
use mhlint_json::SyntaxKind;
use mhlint_repo::{FileFacts, View};

/// Whether the content of the file is not at hand: it was not read, or is a stand-in.
fn is_unread(file: &FileFacts) -> bool {
    file.failed
        || file.unreadable.is_some()
        || file.encoding.lfs_pointer
        || file.gzip_fault.is_some()
}

/// Whether nobody meets what is in the file: it is unread, or no loader opens its name. A
/// `macro.json` in the target folder of a user is never opened, either (`overlay-shadowed`).
pub(crate) fn is_unmet(view: &View<'_>, file: &FileFacts) -> bool {
    is_unread(file) || moment(view, &file.rel) == Moment::Never
}

/// Whether the file is one of `contarget/` that falls back to the system's where it cannot be read:
/// the fallback is the worse news (`overlay-broken-override`).
pub(crate) fn is_override(file: &FileFacts) -> bool {
    is_in_override_folder(&file.rel)
        && matches!(
            file.kind,
            Kind::MacroJson | Kind::ModellingJson | Kind::TargetCategories
        )
}

/// Whether the file is an override that is taken for absent without a word to the user: no JSON, a
/// byte order mark, or nothing in it (`docs/loaders/makehuman2/folders.md#overlays`,
/// `docs/loaders/makehuman2/text-and-json.md#json`).
///
/// `overlay-broken-override` speaks for such a file; other rules on its text keep quiet. Bytes that
/// are no UTF-8 stop the application instead, and nesting beyond all measure does, too.
pub(crate) fn is_ignored_override(file: &FileFacts) -> bool {
    is_override(file)
        && match &*file.content {
            Content::Broken(JsonFault::Empty | JsonFault::ByteOrderMark) => {
                !file.failed && file.unreadable.is_none()
            }
            Content::Broken(JsonFault::Syntax(fault)) => fault.kind != SyntaxKind::TooDeep,
            Content::Broken(JsonFault::NotUtf8 | JsonFault::LfsPointer) => false,
            _ => file.json.falsy,
        }
}

/// Whether the whole file is an empty value (`null`, `[]`, `0`), which Python takes for false and
/// the loader for no file: `file-empty` speaks.
pub(crate) fn counts_as_missing(file: &FileFacts) -> bool {
    let wanted = matches!(
        file.kind,
        Kind::BaseJson
            | Kind::MacroJson
            | Kind::ModellingJson
            | Kind::TargetCategories
            | Kind::Pose
            | Kind::PoseUnits
            | Kind::SelectionFilter
            | Kind::Version
            | Kind::Shaders
    );
    wanted && file.json.falsy
}
