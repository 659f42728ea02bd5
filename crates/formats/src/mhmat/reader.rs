//! The lines of a material in turn.

use std::collections::BTreeMap;
use std::ops::Range;

use super::keyword::{self, Keyword, Value};
use super::statement::statements;
use super::{Line, MOST_LINES, MOST_UNKNOWN, Material, Texture, Unknown, Word};
use crate::fields::fields;
use mhlint_diag::Application::Makehuman2;
use mhlint_source::lines;

/// Words of a line that are kept: a keyword wants three at most, and one more shows that there are
/// too many.
const WORDS: usize = 5;

/// Reads all lines. What is not UTF-8 is no name of a picture.
pub fn read(text: &[u8]) -> Material {
    let mut material = Material {
        statements: statements(text),
        ..Material::default()
    };
    let mut known = BTreeMap::new();
    for (number, (Range { start, .. }, line)) in (1..).zip(lines(text)) {
        let words = fields(line);
        let Some(((_, first), rest)) = words.split_first() else {
            continue;
        };
        if first.starts_with(b"#") || first.starts_with(b"//") {
            continue;
        }
        let Some(keyword) = keyword::written(first) else {
            unknown(&mut material, &mut known, &words, start);
            continue;
        };
        if material.lines.len() == MOST_LINES {
            material.left_out += 1;
            continue;
        }
        if keyword.value == Value::Picture {
            texture(&mut material, keyword, rest, start);
        }
        let kept = rest
            .iter()
            .take(WORDS)
            .map(|word| kept(start, word))
            .collect();
        material.lines.push(Line {
            keyword,
            number,
            words: kept,
            count: rest.len(),
        });
    }
    material
}

fn kept(start: usize, (at, word): &(usize, &[u8])) -> Word {
    Word {
        text: String::from_utf8_lossy(word).into(),
        span: start + at..start + at + word.len(),
    }
}

/// A picture of which the last one that is found counts for MakeHuman 2, so that not the last line
/// alone is kept.
fn texture(
    material: &mut Material,
    keyword: &'static Keyword,
    rest: &[(usize, &[u8])],
    start: usize,
) {
    let is_sought = keyword.is_read_by(Makehuman2);
    let Some(((at, word), lost)) = rest.split_first().filter(|_| is_sought) else {
        return;
    };
    let Ok(name) = std::str::from_utf8(word) else {
        return;
    };
    let lost: Vec<_> = lost
        .iter()
        .map(|(_, word)| String::from_utf8_lossy(word))
        .collect();
    let span = start + at..start + at + word.len();
    material.textures.push(Texture {
        keyword: keyword.name,
        word: name.into(),
        lost: lost.join(" ").into(),
        span,
    });
}

fn unknown<'t>(
    material: &mut Material,
    known: &mut BTreeMap<&'t [u8], usize>,
    words: &[(usize, &'t [u8])],
    start: usize,
) {
    let Some((first, rest)) = words.split_first() else {
        return;
    };
    if let Some(one) = known
        .get(first.1)
        .and_then(|at| material.unknown.get_mut(*at))
    {
        one.lines += 1;
    } else if known.len() < MOST_UNKNOWN {
        known.insert(first.1, material.unknown.len());
        let value = rest
            .first()
            .map(|(_, word)| String::from_utf8_lossy(word).into());
        material.unknown.push(Unknown {
            word: kept(start, first),
            value,
            lines: 1,
        });
    } else {
        material.left_out += 1;
    }
}

#[cfg(test)]
mod tests {
    #![allow(clippy::indexing_slicing, reason = "tests know what there is")]

    use proptest::prelude::*;

    use super::*;

    fn names(text: &str) -> Vec<(&'static str, String, String)> {
        let textures = read(text.as_bytes()).textures;
        textures
            .into_iter()
            .map(|one| (one.keyword, one.word.into(), one.lost.into()))
            .collect()
    }

    #[test]
    fn a_picture_is_the_word_behind_its_keyword() {
        let text = "# diffuseTexture no.png\n//diffuseTexture no.png\nname diffuseTexture\n diffuseTexture\ta.png\r\n\
            aomapTexture b c  d.png\nspecularmapTexture no.png\rDiffuseTexture \
            no.png\remissiveTexture e.png # glow";
        let own = |word: &str, lost: &str| (word.to_owned(), lost.to_owned());
        let expected = [
            ("diffuseTexture", own("a.png", "")),
            ("aomapTexture", own("b", "c d.png")),
        ];
        let expected = expected
            .into_iter()
            .chain([("emissiveTexture", own("e.png", "# glow"))]);
        assert_eq!(
            names(text),
            expected
                .map(|(keyword, (word, lost))| (keyword, word, lost))
                .collect::<Vec<_>>()
        );
    }

    #[test]
    fn lines_keep_their_words_and_places() {
        let text = b"name x\r\ndiffuseTexture \n\n  diffuseColor  .5 0,5 1 2 3 4\n#opacity 1\nopacity nan\n";
        let material = read(text);
        let told: Vec<_> = material
            .lines
            .iter()
            .map(|line| (line.number, line.keyword.name, line.count))
            .collect();
        let expected = [
            (1, "name", 1),
            (2, "diffuseTexture", 0),
            (4, "diffuseColor", 6),
            (6, "opacity", 1),
        ];
        assert_eq!(told, expected);
        let colour = material.last("diffuseColor").unwrap();
        assert_eq!(
            (colour.number_at(0), colour.number_at(1), colour.words.len()),
            (Some(0.5), None, 5)
        );
        assert_eq!(text.get(colour.words[1].span.clone()), Some(&b"0,5"[..]));
        assert!(
            material
                .last("opacity")
                .unwrap()
                .number_at(0)
                .unwrap()
                .is_nan()
        );
    }

    #[test]
    fn a_mark_swallows_the_first_keyword_and_bytes_are_no_name() {
        assert_eq!(names("\u{feff}diffuseTexture a.png"), []);
        assert_eq!(read("\u{feff}name a".as_bytes()).unknown.len(), 1);
        assert_eq!(read(b"diffuseTexture \xff.png").textures, []);
    }

    #[test]
    fn unknown_words_are_counted_and_few() {
        let text = "diffuseColour 1 1 1\nDiffuseTexture a.png\ndiffuseColour 0 0 0\n";
        let unknown = read(text.as_bytes()).unknown;
        assert_eq!(
            unknown
                .iter()
                .map(|one| (&*one.word.text, one.lines))
                .collect::<Vec<_>>(),
            [("diffuseColour", 2), ("DiffuseTexture", 1)]
        );
        let many = (0..200)
            .map(|number| format!("a{number} x\n"))
            .collect::<Vec<_>>()
            .concat();
        let material = read(many.as_bytes());
        assert_eq!(
            (material.unknown.len(), material.left_out),
            (MOST_UNKNOWN, 200 - MOST_UNKNOWN)
        );
        for line in ["opacity 1\n", "diffuseTexture a.png\n"] {
            let long = read(line.repeat(MOST_LINES + 3).as_bytes());
            assert_eq!((long.lines.len(), long.left_out), (MOST_LINES, 3));
            assert!(long.textures.len() <= MOST_LINES);
        }
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

        #[test]
        fn hostile_bytes_are_read(text in proptest::collection::vec(any::<u8>(), 0..200)) {
            let material = read(&text);
            prop_assert!(material.lines.len() + material.unknown.len() + material.left_out <= text.len());
        }

        #[test]
        fn every_line_that_is_written_is_found(values in proptest::collection::vec(("[a-z]{1,9}", -2.0_f64..9.0), 1..20)) {
            let text = values.iter().map(|(word, number)| format!("shaderParam {word} {number}\n"));
            let lines = read(text.collect::<Vec<_>>().concat().as_bytes()).lines;
            prop_assert_eq!(lines.len(), values.len());
            for (line, (word, number)) in lines.iter().zip(&values) {
                prop_assert_eq!((line.word(0), line.number_at(1)), (word.as_str(), Some(*number)));
            }
        }
    }
}
