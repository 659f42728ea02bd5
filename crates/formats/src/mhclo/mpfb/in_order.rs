//! An asset as MPFB reads it: line by line, where a line can end what came before it
//! (`docs/loaders/mpfb/clothes.md#lines`).

use super::Machine;
use crate::fields::fields;
use mhlint_source::lines;

/// What is read of an asset, up to where the loader stops.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct InOrder {
    /// Rows, one a vertex of the asset.
    pub rows: Vec<Row>,
    /// Vertices to hide as they are listed; the first one of a range is there twice.
    pub deleted: Vec<i64>,
    /// Ranges to hide stood above the rows: they are counted as rows, and none has the number of
    /// its vertex any more.
    pub are_ranges_first: bool,
    /// `x_scale`, `y_scale`, `z_scale`: two vertices and a distance.
    pub scales: [Option<([i64; 2], f64)>; 3],
    /// Name of its mesh.
    pub obj_file: Option<String>,
    /// The line at which the loader stops, and with which exception.
    pub stop: Option<(u32, &'static str)>,
}

/// Vertices of the base mesh, their weights, a displacement.
pub type Row = ([i64; 3], [f64; 3], [f64; 3]);

/// Reads an asset.
pub fn read(text: &[u8]) -> InOrder {
    let mut machine = Machine::keeping();
    for (number, (_, line)) in (1..).zip(lines(text)) {
        machine.take(number, &fields(line));
        if machine.has_stopped() {
            break;
        }
    }
    let (found, stop) = machine.into_kept();
    InOrder {
        stop: stop.map(|stop| (stop.line, stop.cause.exception())),
        ..found
    }
}

/// Vertices to hide that are kept: no mesh has as many.
const MOST: usize = 4_000_000;

impl InOrder {
    /// Takes a vertex to hide, or the end of a range that begins at the one before.
    pub(super) fn hide(&mut self, vertex: i64, ends_range: bool) {
        self.are_ranges_first |= ends_range && self.rows.is_empty();
        match self.deleted.last().copied().filter(|_| ends_range) {
            Some(from) => {
                // The first one is there again.
                let room = MOST.saturating_sub(self.deleted.len());
                self.deleted.extend((from..=vertex).take(room));
            }
            None => self.deleted.push(vertex),
        }
    }
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
        assert_eq!(
            read(b"verts 0\n5\n\ndelete_verts\n1 - 3 7\n").deleted,
            [1, 1, 2, 3, 7]
        );
        assert!(read(b"delete_verts\n\n1 2\n").deleted.is_empty());
        assert_eq!(read(b"delete_verts\n7 - 5 9\n").deleted, [7, 9]);
        // Ranges above the rows are counted as such; single numbers are not.
        let is_first = |text: &[u8]| read(text).are_ranges_first;
        assert!(is_first(b"delete_verts\n5 - 7\n\nverts 0\n5\n"));
        assert!(
            !is_first(b"delete_verts\n5 7\n\nverts 0\n5\n")
                && !is_first(b"verts 0\n5\n\ndelete_verts\n5 - 7\n")
        );
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
