//! `.mhmat`: how a surface looks, as MakeHuman 2 reads it (formats/makehuman2.md §17).
//!
//! A line is a keyword and words, split at white space; what is behind the first word of a file name is lost. Unknown
//! keywords are passed over, comments among them. A byte order mark belongs to the first word.

use std::ops::Range;

use super::fields::fields;
use crate::source::lines;

/// The file, as far as rules ask about it.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct Material {
    /// The pictures that it names, in file order.
    pub textures: Vec<Texture>,
    /// Keywords of pictures without a name behind them, at which the loader stops, with their lines.
    pub valueless: Vec<(&'static str, u32)>,
}

/// A line that names a picture.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Texture {
    /// What it is for.
    pub keyword: &'static str,
    /// The name: one word.
    pub word: Box<str>,
    /// What is written behind that word and lost, words joined by one blank.
    pub lost: Box<str>,
    /// Where the name stands, in bytes.
    pub span: Range<usize>,
}

/// The keywords whose pictures are looked for.
const TEXTURES: [&str; 5] =
    ["diffuseTexture", "normalmapTexture", "aomapTexture", "metallicRoughnessTexture", "emissiveTexture"];

/// Reads all lines. What is no UTF-8 is no name.
pub fn read(text: &[u8]) -> Material {
    let mut material = Material::default();
    for (number, (Range { start, .. }, line)) in (1..).zip(lines(text)) {
        let words = fields(line);
        let Some((_, first)) = words.first() else { continue };
        let Some(keyword) = TEXTURES.into_iter().find(|keyword| keyword.as_bytes() == *first) else { continue };
        let Some((at, word)) = words.get(1) else {
            material.valueless.push((keyword, number));
            continue;
        };
        let Ok(name) = std::str::from_utf8(word) else { continue };
        let lost: Vec<_> = words.iter().skip(2).map(|(_, word)| String::from_utf8_lossy(word)).collect();
        let span = start + at..start + at + word.len();
        material.textures.push(Texture { keyword, word: name.into(), lost: lost.join(" ").into(), span });
    }
    material
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;

    fn names(text: &str) -> Vec<(&'static str, String, String)> {
        let textures = read(text.as_bytes()).textures;
        textures.into_iter().map(|one| (one.keyword, one.word.into(), one.lost.into())).collect()
    }

    #[test]
    fn a_picture_is_the_word_behind_its_keyword() {
        let text = "# diffuseTexture no.png\n//diffuseTexture no.png\nname diffuseTexture\n diffuseTexture\ta.png\r\n\
            aomapTexture b c  d.png\nspecularmapTexture no.png\rDiffuseTexture no.png\remissiveTexture e.png # glow";
        let own = |word: &str, lost: &str| (word.to_owned(), lost.to_owned());
        let expected = [("diffuseTexture", own("a.png", "")), ("aomapTexture", own("b", "c d.png"))];
        let expected = expected.into_iter().chain([("emissiveTexture", own("e.png", "# glow"))]);
        assert_eq!(names(text), expected.map(|(keyword, (word, lost))| (keyword, word, lost)).collect::<Vec<_>>());
    }

    #[test]
    fn a_name_has_its_place_and_a_missing_one_its_line() {
        let text = b"name x\r\ndiffuseTexture \n\n  normalmapTexture  n.png\n";
        let material = read(text);
        assert_eq!(material.valueless, [("diffuseTexture", 2)]);
        let spans = material.textures.iter().map(|one| &text[one.span.clone()]);
        assert_eq!(spans.collect::<Vec<_>>(), [b"n.png"]);
    }

    #[test]
    fn a_mark_swallows_the_first_keyword_and_bytes_are_no_name() {
        assert_eq!(names("\u{feff}diffuseTexture a.png"), []);
        assert_eq!(read(b"diffuseTexture \xff.png"), Material::default());
    }

    proptest! {
        #[test]
        fn every_name_stands_where_it_says(
            text in proptest::collection::vec(proptest::sample::select(b"\n\r \xc3\xa4a".to_vec()), 0..30),
        ) {
            let text = [b"diffuseTexture ", text.as_slice(), b"\raomapTexture b"].concat();
            for texture in read(&text).textures {
                prop_assert_eq!(text.get(texture.span.clone()), Some(texture.word.as_bytes()));
            }
        }
    }
}
