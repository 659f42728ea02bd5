//! What libraries list of what is worn, and by what it is known (formats/makehuman1.md §2.5, §10.1, §10.7).

use crate::discover::library_of;
use crate::formats::mhclo::{Clothes, Entry};
use crate::repo::{FileFacts, Worn};

/// What is worn and listed.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Asset<'a> {
    /// Its file.
    pub file: &'a FileFacts,
    /// The library that it is listed in.
    pub library: &'a str,
    /// Its name, if it has one of its own.
    pub name: Option<&'a Entry>,
    /// What models know it by.
    pub uuid: Option<&'a Entry>,
}

impl<'a> Asset<'a> {
    /// The asset of a text that can be relied on.
    pub(super) fn of(worn: &Worn<'a>) -> Option<Self> {
        let (file, clothes) = (worn.file, worn.clothes()?);
        let library = library_of(&file.rel)?;
        Some(Self { file, library, name: last(clothes, "name"), uuid: last(clothes, "uuid") })
    }
}

/// The last line of a keyword with a value. One with a colon is another word to the program.
fn last<'a>(clothes: &'a Clothes, keyword: &str) -> Option<&'a Entry> {
    clothes.all(keyword).rev().find(|entry| !entry.has_colon)
}
