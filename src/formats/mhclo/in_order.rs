//! An asset as MPFB reads it: line by line, where a line can end what came before it (formats/mpfb.md §26.1).

use crate::formats::fields::fields;
use crate::source::lines;

/// What is read of an asset, up to where the loader stops.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct InOrder {
    /// Rows, one a vertex of the asset: vertices of the base mesh, their weights, a displacement.
    pub rows: Vec<([i64; 3], [f64; 3], [f64; 3])>,
    /// Vertices to hide as they are listed; the first one of a range is there twice.
    pub deleted: Vec<i64>,
    /// `x_scale`, `y_scale`, `z_scale`: two vertices and a distance.
    pub scales: [Option<([i64; 2], f64)>; 3],
    /// Name of its mesh.
    pub obj_file: Option<String>,
    /// The line at which the loader stops, and with which exception.
    pub stop: Option<(u32, &'static str)>,
}

/// What lines are read as.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Part {
    Header,
    Rows,
    Deleted,
}

/// Reads an asset.
pub fn read(text: &[u8]) -> InOrder {
    let (mut found, mut part) = (InOrder::default(), Part::Header);
    for (number, (_, line)) in (1..).zip(lines(text)) {
        let words: Vec<&[u8]> = fields(line).into_iter().map(|(_, word)| word).collect();
        if let Err(exception) = found.line(&words, &mut part) {
            found.stop = Some((number, exception));
            break;
        }
    }
    found
}

type Step = Result<(), &'static str>;

impl InOrder {
    fn line(&mut self, words: &[&[u8]], part: &mut Part) -> Step {
        let [first, rest @ ..] = words else {
            *part = Part::Header;
            return Ok(());
        };
        match *first {
            // These stand between the rows without ending them.
            b"#" | b"material" => {
                return if rest.is_empty() && *first == b"material" { Err("IndexError") } else { Ok(()) };
            }
            word if word.starts_with(b"vertexboneweights") => return Ok(()),
            _ => {}
        }
        match *part {
            Part::Rows if is_number(first) => return self.row(words),
            Part::Deleted if is_number(first) => return self.listed(words),
            Part::Rows | Part::Deleted => {
                // The line that ends a list is thrown away, whatever it is.
                *part = Part::Header;
                return Ok(());
            }
            Part::Header => {}
        }
        self.keyword(first, rest, part)
    }

    fn keyword(&mut self, first: &[u8], rest: &[&[u8]], part: &mut Part) -> Step {
        match first {
            b"obj_file" => self.obj_file = Some(text(rest.first().ok_or("IndexError")?)),
            b"name" | b"uuid" | b"tag" if rest.is_empty() => return Err("IndexError"),
            b"z_depth" => {
                whole(rest.first().ok_or("IndexError")?)?;
            }
            b"x_scale" | b"y_scale" | b"z_scale" => {
                let [from, to, distance, ..] = rest else { return Err("IndexError") };
                let scale = ([whole(from)?, whole(to)?], number(distance)?);
                let axis = match first {
                    b"x_scale" => 0,
                    b"y_scale" => 1,
                    _ => 2,
                };
                if let Some(slot) = self.scales.get_mut(axis) {
                    *slot = Some(scale);
                }
            }
            b"verts" => {
                if let Some(count) = rest.first() {
                    whole(count)?;
                    *part = Part::Rows;
                }
            }
            b"delete_verts" => *part = Part::Deleted,
            _ => {}
        }
        Ok(())
    }

    fn row(&mut self, words: &[&[u8]]) -> Step {
        let row = match words {
            [only] => ([whole(only)?; 3], [1.0, 0.0, 0.0], [0.0; 3]),
            _ if words.len() >= 9 => {
                let mut numbers = [0.0; 6];
                for (number_of, word) in numbers.iter_mut().zip(words.iter().skip(3)) {
                    *number_of = number(word)?;
                }
                let mut wholes = [0; 3];
                for (whole_of, word) in wholes.iter_mut().zip(words) {
                    *whole_of = whole(word)?;
                }
                let [u, v, w, rest @ ..] = numbers;
                (wholes, [u, v, w], rest)
            }
            _ => return Err("IndexError"),
        };
        self.rows.push(row);
        Ok(())
    }

    /// Numbers and ranges with blanks around the dash.
    fn listed(&mut self, words: &[&[u8]]) -> Step {
        let mut is_range = false;
        for word in words {
            if *word == b"-" {
                is_range = true;
                continue;
            }
            let vertex = whole(word)?;
            let from = self.deleted.last().copied().filter(|_| is_range);
            is_range = false;
            match from {
                Some(from) if vertex >= from => {
                    // The first one is there again.
                    let room = MOST.saturating_sub(self.deleted.len());
                    self.deleted.extend((from..=vertex).take(room));
                }
                Some(_) => {}
                None => self.deleted.push(vertex),
            }
        }
        Ok(())
    }
}

/// Vertices to hide that are kept: no mesh has as many.
const MOST: usize = 4_000_000;

fn is_number(word: &[u8]) -> bool {
    word.iter().all(u8::is_ascii_digit)
}

fn text(word: &[u8]) -> String {
    String::from_utf8_lossy(word).into_owned()
}

fn whole(word: &[u8]) -> Result<i64, &'static str> {
    std::str::from_utf8(word).ok().and_then(|word| word.parse().ok()).ok_or("ValueError")
}

fn number(word: &[u8]) -> Result<f64, &'static str> {
    std::str::from_utf8(word).ok().and_then(|word| word.parse().ok()).ok_or("ValueError")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_line_ends_what_came_before_it() {
        let text =
            b"obj_file a.obj\nx_scale 1 2 3\nverts 0\n5\n# note\nmaterial m.mhmat\n1 2 3 1 0 0 0 0 0\nname x\n7\n";
        let found = read(text);
        assert_eq!((found.rows.len(), found.stop), (2, None));
        assert_eq!(found.scales[0], Some(([1, 2], 3.0)));
        // A keyword directly behind the rows is lost with its section.
        assert!(read(b"verts 0\n5\ndelete_verts\n1 2\n").deleted.is_empty());
        assert_eq!(read(b"verts 0\n5\n\ndelete_verts\n1 - 3 7\n").deleted, [1, 1, 2, 3, 7]);
        assert!(read(b"delete_verts\n\n1 2\n").deleted.is_empty());
        assert_eq!(read(b"delete_verts\n7 - 5 9\n").deleted, [7, 9]);
    }

    #[test]
    fn the_loader_stops() {
        for (text, stop) in [
            ("verts 0\n1 2 3 1 0 0\n", (2, "IndexError")),
            ("verts 0\n1 2 3 a 0 0 0 0 0\n", (2, "ValueError")),
            ("name\n", (1, "IndexError")),
            ("delete_verts\n1 2-4\n", (2, "ValueError")),
            ("y_scale 1 2\n", (1, "IndexError")),
        ] {
            assert_eq!(read(text.as_bytes()).stop, Some(stop), "{text}");
        }
    }
}
