//! Why a change can affect a finding, in words.

use crate::diag::Because;

/// One clause, not made harmless yet.
pub(super) fn because(because: &Because) -> String {
    match because {
        Because::Own => "the file changed".to_owned(),
        Because::Inside(changed) => format!("`{changed}` in it changed"),
        Because::SpokenOf(changed) => format!("`{changed}` changed"),
        Because::OtherCapitals => "a file of this name in other capitals changed".to_owned(),
        Because::NamedBy(from) => format!("`{from}`, which names it, changed"),
        Because::Names(changed) => format!("it names `{changed}`, which changed"),
        Because::Decides { changed, base } => format!("`{changed}`, which decides over all of `{base}`, changed"),
        Because::SameBase { changed, base } => format!("`{changed}`, which also belongs to `{base}`, changed"),
        Because::WholeFolder(folder) => format!("the folder `{folder}`, or one that it lies in, changed as a whole"),
        Because::Layers(name) => format!("a `{name}` changed that can decide which data lie over which"),
    }
}
