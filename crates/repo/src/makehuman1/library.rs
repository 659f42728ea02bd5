//! What libraries list of what is worn, and by what it is known
//! (`docs/loaders/makehuman1/libraries.md#scan`, `docs/loaders/makehuman1/libraries.md#identity`).

use crate::{FileFacts, Worn};
use mhlint_discover::{archive_library_of, library_of};
use mhlint_formats::mhclo::makehuman1::READER;
use mhlint_formats::mhclo::{Clothes, Entry};

/// What is worn and listed.
#[derive(Debug, Clone, Copy)]
pub struct Asset<'a> {
    /// Its file.
    pub file: &'a FileFacts,
    /// The library that it is listed in.
    pub library: &'a str,
    /// Its name, if it has one of its own.
    pub name: Option<Known<'a>>,
    /// What models know it by.
    pub uuid: Option<Known<'a>>,
}

/// Something that an asset is known by.
#[derive(Debug, Clone, Copy)]
pub struct Known<'a> {
    /// The name or the uuid.
    pub text: &'a str,
    /// The line of it, if there is a text.
    pub entry: Option<&'a Entry>,
}

impl<'a> Asset<'a> {
    /// The asset of a text that can be relied on, or of an archive without a text.
    pub(super) fn of(worn: &Worn<'a>) -> Option<Self> {
        let file = worn.file;
        if let Some(clothes) = worn.clothes() {
            let library = library_of(&file.rel)?;
            return Some(Self {
                file,
                library,
                name: last(clothes, "name"),
                uuid: last(clothes, "uuid"),
            });
        }
        let [name, uuid] = &worn.packed_proxy()?.identity;
        let known = |text: &'a str| (!text.is_empty()).then_some(Known { text, entry: None });
        Some(Self {
            file,
            library: archive_library_of(&file.rel)?,
            name: known(name),
            uuid: known(uuid),
        })
    }
}

/// The last line of a keyword with a value. One with a colon is another word to the program.
fn last<'a>(clothes: &'a Clothes, keyword: &str) -> Option<Known<'a>> {
    let entry = READER.of(clothes).last(keyword)?;
    Some(Known {
        text: &entry.value,
        entry: Some(entry),
    })
}
