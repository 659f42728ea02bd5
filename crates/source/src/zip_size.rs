//! Unpacked size of zip archives (`.npz`, `.mhbin` are zips) by their directory, without unpacking.
//!
//! Python's zipfile stops reading a member at the size that the directory states, so the stated
//! sizes are what a loader would really unpack. Members may overlap; their sizes count all the
//! same.

use std::io::Cursor;

use super::{GzipFault, Limits};

/// Whether the members of `archive` together unpack beyond `limits`. What is no zip is no bomb.
pub fn zip_bomb(archive: &[u8], limits: &Limits) -> Option<GzipFault> {
    let packed = archive.len() as u64;
    let mut zip = zip::ZipArchive::new(Cursor::new(archive)).ok()?;
    let mut unpacked = 0_u64;
    for index in 0..zip.len() {
        // A member without a readable header cannot be unpacked by anybody.
        let size = zip.by_index_raw(index).map_or(0, |member| member.size());
        unpacked = unpacked.saturating_add(size);
    }
    (unpacked > limits.unpacked_limit(packed)).then_some(GzipFault::Bomb { packed, unpacked })
}

#[cfg(test)]
mod tests {
    use std::io::Write;

    use zip::write::SimpleFileOptions;

    use super::*;

    fn archive(members: &[usize]) -> Vec<u8> {
        let mut zip = zip::ZipWriter::new(Cursor::new(Vec::new()));
        for (index, size) in members.iter().enumerate() {
            zip.start_file(index.to_string(), SimpleFileOptions::default())
                .unwrap();
            zip.write_all(&vec![0; *size]).unwrap();
        }
        zip.finish().unwrap().into_inner()
    }

    #[test]
    fn stated_sizes_are_added_up() {
        let packed = archive(&[600, 400]);
        let limits = |bytes| Limits {
            unpacked_bytes: bytes,
            ..Limits::default()
        };
        assert_eq!(zip_bomb(&packed, &limits(1000)), None);
        let bomb = GzipFault::Bomb {
            packed: packed.len() as u64,
            unpacked: 1000,
        };
        assert_eq!(zip_bomb(&packed, &limits(999)), Some(bomb));
        assert_eq!(zip_bomb(b"no zip at all", &limits(1)), None);
    }
}
