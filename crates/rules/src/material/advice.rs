//! What to write for a picture that is not found.

use std::collections::BTreeMap;
use std::ops::Bound;

use super::super::{did_you_mean, meant_beside};
use mhlint_diag::{Grouped, Place, Suggestions, grouped};
use mhlint_discover::extension;
use mhlint_formats::mhmat::Line;
use mhlint_repo::{FileFacts, PictureFolders, Reference, View};
use mhlint_source::file_name;

/// The pictures that names may be meant for.
pub(super) struct Advice<'v, 'a> {
    view: &'v View<'a>,
    /// By their names without folders.
    pictures: Grouped<&'a str, &'a FileFacts>,
    /// By their paths.
    paths: BTreeMap<&'a str, &'a FileFacts>,
    /// Those of them that nobody names.
    free: BTreeMap<&'a str, &'a FileFacts>,
    suggestions: Suggestions,
}

impl<'v, 'a> Advice<'v, 'a> {
    pub(super) fn of(view: &'v View<'a>) -> Self {
        let files = view
            .layers()
            .checked
            .files
            .values()
            .filter(|file| is_picture(file));
        let paths: BTreeMap<&str, &FileFacts> =
            files.map(|file| (file.rel.as_str(), file)).collect();
        let pictures = grouped(paths.values().map(|file| (file.file_name(), *file)));
        let free = paths.iter().filter(|(_, file)| is_free(view, file));
        Self {
            view,
            pictures,
            free: free.map(|(path, file)| (*path, *file)).collect(),
            paths,
            suggestions: Suggestions::default(),
        }
    }

    pub(super) fn on(&self, reference: &Reference<'_>) -> String {
        let otherwise = "correct the name, add the picture, or remove the line";
        let whole = with_blanks(reference);
        if let Some(help) =
            meant_beside(self.view.layers().checked, &reference.rel, whole.as_deref())
        {
            return help;
        }
        let Some(folders) = self.view.picture_folders(reference) else {
            return otherwise.to_owned();
        };
        if let Some(name) = whole.clone().filter(|name| self.is_near(name, &folders)) {
            return format!(
                "rename `{name}` without spaces, and write that name: a name ends at the first \
                    space"
            );
        }
        let cut = whole
            .filter(|name| is_cut(reference.text, name))
            .map(|name| joined(&name));
        if let Some(name) = cut
            .iter()
            .flatten()
            .find(|name| self.is_near(name, &folders))
        {
            return format!("write `{name}`: a name ends at the first space");
        }
        if let Some(name) = self.moved(reference, &folders) {
            return format!("write `{name}`: the picture is there");
        }
        if let Some([name, ..]) = &cut {
            return format!(
                "write the name without spaces, such as `{name}`: it ends at the first space"
            );
        }
        let names = self
            .suggestions
            .looked_through(self.free_below(around(&folders)))
            .filter_map(|file| near(file, &folders).filter(|name| is_name(name)));
        did_you_mean(self.suggestions.nearest(reference.text, names), otherwise)
    }

    /// The pictures below a folder that nobody names.
    fn free_below(&self, folder: &str) -> impl Iterator<Item = &'a FileFacts> {
        let within = format!("{folder}/");
        let from = self
            .free
            .range::<str, _>((Bound::Included(within.as_str()), Bound::Unbounded));
        from.map(|(_, file)| *file)
            .take_while(move |file| file.rel.starts_with(&within))
    }

    /// Whether a picture lies where a material looks for this name.
    fn is_near(&self, name: &str, folders: &PictureFolders<'_>) -> bool {
        let asked = [folders.own, around(folders)];
        let found = asked
            .iter()
            .filter_map(|folder| self.paths.get(format!("{folder}/{name}").as_str()));
        found
            .into_iter()
            .any(|file| near(file, folders) == Some(name))
    }

    /// A picture of this name in another folder: one of the same asset, or one that nobody names.
    fn moved(&self, reference: &Reference<'_>, folders: &PictureFolders<'_>) -> Option<&'a str> {
        let same = self.pictures.get(file_name(reference.text))?;
        let has_own_folder = around(folders).matches('/').count() > 1;
        let same = same.get(..SAME_NAMES).unwrap_or(same);
        let around = same
            .iter()
            .filter(|file| has_own_folder || self.is_free(file));
        let mut around = around.filter_map(|file| near(file, folders));
        let shared = same
            .iter()
            .filter(|file| self.is_free(file))
            .filter_map(|file| below(&file.rel, &folders.all));
        // The first part of such a name would be left out.
        let mut shared = shared.filter(|name| !name.starts_with(folders.sort));
        around
            .find(|name| is_name(name))
            .or_else(|| shared.find(|name| is_name(name)))
    }

    fn is_free(&self, file: &FileFacts) -> bool {
        self.free.contains_key(file.rel.as_str())
    }
}

/// Whether nobody names a picture.
fn is_free(view: &View<'_>, file: &FileFacts) -> bool {
    view.references().to_file(file).next().is_none()
}

/// Pictures of one name that are looked at: of more of them none is meant more than another.
const SAME_NAMES: usize = 1000;

/// Whether it can be written as a name.
fn is_name(name: &str) -> bool {
    !name.contains([' ', char::REPLACEMENT_CHARACTER])
}

/// The whole name, where the one that is looked for may end too early.
fn with_blanks(reference: &Reference<'_>) -> Option<String> {
    let Place::Span(span) = &reference.place else {
        return None;
    };
    // They stand in the order of the file.
    let material = reference.from.material()?;
    let at = material
        .textures
        .partition_point(|texture| texture.span.start < span.start);
    if let Some(texture) = material
        .textures
        .get(at)
        .filter(|texture| texture.span == *span)
    {
        return (!texture.lost.is_empty())
            .then(|| format!("{} {}", texture.word, texture.lost).replace('"', ""));
    }
    // A picture of another keyword.
    let from = |line: &'_ Line| line.words.iter().position(|word| word.span == *span);
    let (line, at) = material
        .lines
        .iter()
        .find_map(|line| Some((line, from(line)?)))?;
    let words: Vec<&str> = line.words.iter().skip(at).map(|word| &*word.text).collect();
    (words.len() > 1).then(|| words.join(" ").replace('"', ""))
}

/// Whether a name was cut off before its extension, as `plain` of `plain skin.png`.
fn is_cut(text: &str, whole: &str) -> bool {
    let is_named = |name: &str| PICTURES.contains(&extension(name).to_lowercase().as_str());
    is_named(whole) && !is_named(text) && !whole.contains("//") && !whole.contains('#')
}

/// Names without spaces that may be meant by one with them.
fn joined(whole: &str) -> [String; 3] {
    ["_", "", "-"].map(|by| whole.replace(' ', by))
}

/// The farthest folder around a material in which its pictures are looked for.
fn around<'r>(folders: &PictureFolders<'r>) -> &'r str {
    folders.above.unwrap_or(folders.own)
}

/// The name of a picture there, as the material would write it.
fn near<'a>(file: &'a FileFacts, folders: &PictureFolders<'_>) -> Option<&'a str> {
    below(&file.rel, folders.own).or_else(|| below(&file.rel, around(folders)))
}

fn below<'p>(path: &'p str, folder: &str) -> Option<&'p str> {
    path.strip_prefix(folder)?.strip_prefix('/')
}

/// Extensions of pictures that MakeHuman 2 can show, in small letters.
const PICTURES: [&str; 10] = [
    "bmp", "gif", "jpeg", "jpg", "png", "svg", "tga", "tif", "tiff", "webp",
];

fn is_picture(file: &FileFacts) -> bool {
    PICTURES.contains(&extension(&file.rel).to_lowercase().as_str())
}

/// Marks that people put around names.
pub(super) const QUOTES: [char; 8] = [
    '"', '\'', '`', '\u{201c}', '\u{201d}', '\u{201e}', '\u{2018}', '\u{2019}',
];

/// Whether a name begins or ends with a quote.
pub(super) fn is_quoted(text: &str) -> bool {
    text.starts_with(QUOTES) || text.ends_with(QUOTES)
}
