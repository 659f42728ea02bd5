//! `compressedtargets.npz`: the archive that MakeHuman 2 makes of all targets of a folder.
//!
//! A zip of `.npy`, the key of a member being the path of its target without suffix. The
//! application loads every member at start and asks the archive before the text file
//! (`docs/loaders/makehuman2/targets.md#the-archive-at-the-start`,
//! `docs/loaders/makehuman2/targets.md#the-archive`). Gets bytes and limits, returns the members
//! with the hashes of their rows; keeps no rows.

mod rows;
#[cfg(test)]
pub(crate) mod samples;
pub mod targets;

use std::collections::BTreeMap;
use std::io::{BufReader, Cursor, Read, Take};

use zip::ZipArchive;
use zip::read::ZipFile;

pub use crate::npy::NpyFault;
pub use crate::npz::rows::Rows;
use mhlint_source::Limits;

/// A parsed archive.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Archive {
    /// Members in the order of the archive.
    pub members: Vec<Member>,
    /// Why there are none.
    pub fault: Option<ArchiveFault>,
    /// Unpacks beyond the limits: packed size, and the unpacked bytes at which the work was given
    /// up.
    pub bomb: Option<(u64, u64)>,
    /// Where each name stands; of equal names the last.
    places: BTreeMap<String, usize>,
    /// Whether some member cannot be used.
    has_bad_members: bool,
}

/// A member of an archive.
#[derive(Debug, Clone, PartialEq)]
pub struct Member {
    /// Key by which the application asks for it: path without `.npy`.
    pub name: String,
    /// Its rows, or why the application cannot use them.
    pub rows: Result<Rows, NpyFault>,
}

/// Why an archive cannot be opened.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum ArchiveFault {
    /// No byte in it: what MakeHuman 2 leaves behind when it stops while writing.
    Empty,
    /// No zip, or a damaged one.
    NotZip(String),
}

impl Archive {
    /// Whether the application can load all of it.
    pub fn is_sound(&self) -> bool {
        self.fault.is_none() && self.bomb.is_none() && !self.has_bad_members
    }

    /// The member of a target. Of equal names the last one counts.
    pub fn member(&self, name: &str) -> Option<&Member> {
        self.members.get(*self.places.get(name)?)
    }

    /// One that unpacks beyond the limits and was not looked into.
    pub(super) fn unread(packed: u64, unpacked: u64) -> Self {
        Self {
            bomb: Some((packed, unpacked)),
            ..Self::default()
        }
    }

    fn add(&mut self, name: String, rows: Result<Rows, NpyFault>) {
        self.has_bad_members |= rows.is_err();
        self.places.insert(name.clone(), self.members.len());
        self.members.push(Member { name, rows });
    }
}

/// Reads an archive within `limits`, which are those of arrays.
pub fn parse(bytes: &[u8], limits: &Limits) -> Archive {
    let mut archive = Archive::default();
    let mut zip = match open(bytes) {
        Ok(zip) => zip,
        Err(fault) => {
            archive.fault = Some(fault);
            return archive;
        }
    };
    let packed = bytes.len() as u64;
    let limit = limits.of_arrays().unpacked_limit(packed);
    let mut room = limit;
    for index in 0..zip.len() {
        let name = member_name(&zip, index);
        let (rows, used) = read_member(&mut zip, index, room, |reader| rows::read(reader));
        if used > room {
            archive.bomb = Some((packed, limit - room + used));
            break;
        }
        room -= used;
        archive.add(name, rows);
    }
    archive
}

/// A zip of arrays.
pub(super) type Zip<'b> = ZipArchive<Cursor<&'b [u8]>>;
/// The stream of a member, up to what may be unpacked of it.
pub(super) type Unpacked<'z, 'b> = BufReader<Take<ZipFile<'z, Cursor<&'b [u8]>>>>;

/// Opens an archive.
pub(super) fn open(bytes: &[u8]) -> Result<Zip<'_>, ArchiveFault> {
    if bytes.is_empty() {
        return Err(ArchiveFault::Empty);
    }
    ZipArchive::new(Cursor::new(bytes)).map_err(|error| ArchiveFault::NotZip(error.to_string()))
}

/// Whether a zip has arrays in it, and nothing that is larger unpacked than they are.
pub(super) fn has_arrays(bytes: &[u8]) -> bool {
    let is_array = |zip: &Zip<'_>| {
        zip.name_for_index(0)
            .and_then(Result::ok)
            .is_some_and(|name| name.ends_with(".npy"))
    };
    open(bytes).is_ok_and(|zip| is_array(&zip))
}

/// The key of a member.
pub(super) fn member_name(zip: &Zip<'_>, index: usize) -> String {
    let name = zip.name_for_index(index).and_then(Result::ok);
    name.map_or_else(
        || format!("#{index}"),
        |name| name.strip_suffix(".npy").unwrap_or(&name).to_owned(),
    )
}

/// What `read` makes of a member, and the bytes that it unpacked to, one more than `room` if it
/// goes beyond.
pub(super) fn read_member<'b, T>(
    zip: &mut Zip<'b>,
    index: usize,
    room: u64,
    read: impl FnOnce(&mut Unpacked<'_, 'b>) -> Result<T, NpyFault>,
) -> (Result<T, NpyFault>, u64) {
    match zip.by_index(index) {
        Ok(file) => {
            let allowed = room.saturating_add(1);
            let mut reader = BufReader::new(file.take(allowed));
            let found = read(&mut reader);
            (found, allowed - reader.into_inner().limit())
        }
        Err(error) => (Err(NpyFault::Damaged(error.to_string())), 0),
    }
}

/// The members of an archive that are asked for one by one, within what may be unpacked of it.
pub(super) struct Members<'b> {
    zip: Zip<'b>,
    names: Vec<String>,
    room: u64,
}

impl<'b> Members<'b> {
    /// Opens an archive.
    pub(super) fn open(bytes: &'b [u8], limits: &Limits) -> Result<Self, ArchiveFault> {
        let zip = open(bytes)?;
        let names = (0..zip.len())
            .map(|index| member_name(&zip, index))
            .collect();
        Ok(Self {
            zip,
            names,
            room: limits.of_arrays().unpacked_limit(bytes.len() as u64),
        })
    }

    /// Whether there is a member of this name.
    pub(super) fn has(&self, name: &str) -> bool {
        self.names.iter().any(|own| own == name)
    }

    /// What `read` makes of a member, of equal names the last; nothing if it is not there.
    pub(super) fn read<T>(
        &mut self,
        name: &str,
        read: impl FnOnce(&mut Unpacked<'_, 'b>) -> Result<T, NpyFault>,
    ) -> Option<Result<T, NpyFault>> {
        let place = self.names.iter().rposition(|own| own == name)?;
        let (found, used) = read_member(&mut self.zip, place, self.room, read);
        self.room = self.room.saturating_sub(used);
        Some(found)
    }
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;
    use crate::npz::samples::{npy, zip_of};
    use crate::target;

    const USUAL: &str = "[('index', '<u4'), ('vector', '<f4', (3,))]";

    fn two_rows() -> Vec<u8> {
        let rows: [(u32, [f32; 3]); 2] = [(3, [0.119, -10.205, 0.0]), (70000, [1.0, 2.0, 3.0])];
        rows.iter()
            .flat_map(|(i, d)| {
                i.to_le_bytes()
                    .into_iter()
                    .chain(d.iter().flat_map(|v| v.to_le_bytes()))
            })
            .collect()
    }

    fn only(bytes: Vec<u8>) -> Result<Rows, NpyFault> {
        let archive = parse(&zip_of(&[("head/a.npy", bytes)]), &Limits::default());
        assert_eq!(archive.members.len(), 1);
        archive.member("head/a").unwrap().rows.clone()
    }

    #[test]
    fn rows_hash_as_the_text_target_does() {
        let text = target::parse(b"# basemesh x\n3 .119 -10.205 0\n70000 1 2 3\n", None);
        let rows = only(npy(USUAL, "(2,)", &two_rows())).unwrap();
        assert_eq!((rows.count, rows.content), (2, text.facts.content));
    }

    #[test]
    fn wider_types_and_foreign_order_are_read() {
        let text = target::parse(b"3 .5 -1.25 0\n", None);
        let big = [
            3_i64.to_be_bytes(),
            0.5_f64.to_be_bytes(),
            (-1.25_f64).to_be_bytes(),
            0_f64.to_be_bytes(),
        ]
        .concat();
        let rows = only(npy(
            "[('index', '>i8'), ('vector', '>f8', (3,))]",
            "(1,)",
            &big,
        ))
        .unwrap();
        assert_eq!(rows.content, text.facts.content);
    }

    #[test]
    fn what_the_application_cannot_use_is_named() {
        let some = two_rows();
        assert_eq!(only(b"text".to_vec()), Err(NpyFault::NotNpy));
        assert_eq!(
            only(npy("'|O'", "(1,)", b"\x80\x04.")),
            Err(NpyFault::Object)
        );
        assert_eq!(
            only(npy(
                "[('index', '|O'), ('vector', '<f4', (3,))]",
                "(1,)",
                &some
            )),
            Err(NpyFault::Object)
        );
        assert_eq!(
            only(npy("'<f4'", "(8,)", &some)),
            Err(NpyFault::MissingField("index"))
        );
        assert_eq!(
            only(npy("[('index', '<u4')]", "(2,)", &some)),
            Err(NpyFault::MissingField("vector"))
        );
        let wrong = NpyFault::WrongType("vector", "<f4".to_owned());
        assert_eq!(
            only(npy(
                "[('index', '<u4'), ('vector', '<f4', (2,))]",
                "(2,)",
                &some
            )),
            Err(wrong)
        );
        assert_eq!(only(npy(USUAL, "(1, 2)", &some)), Err(NpyFault::Shape));
        assert_eq!(only(npy(USUAL, "(3,)", &some)), Err(NpyFault::Truncated));
        assert_eq!(only(npy("nonsense(", "(1,)", &some)), Err(NpyFault::Header));
    }

    #[test]
    fn archives_that_cannot_be_opened() {
        assert_eq!(
            parse(b"", &Limits::default()).fault,
            Some(ArchiveFault::Empty)
        );
        assert!(matches!(
            parse(b"hello", &Limits::default()).fault,
            Some(ArchiveFault::NotZip(_))
        ));
    }

    #[test]
    fn a_bomb_is_given_up() {
        let packed = zip_of(&[("a.npy", npy(USUAL, "(4000,)", &vec![0; 64_000]))]);
        let limits = Limits {
            ratio_free_bytes: 1000,
            unpacked_ratio: 2,
            ..Limits::default()
        };
        let archive = parse(&packed, &limits);
        assert!(archive.bomb.is_some() && archive.members.is_empty());
        assert_eq!(parse(&packed, &Limits::default()).bomb, None);
        let tiny_rows = "[('index', '|u1'), ('vector', '|i1', (3,))]";
        let dense = zip_of(&[("a.npy", npy(tiny_rows, "(1000000,)", &vec![0; 4_000_000]))]);
        let (packed, unpacked) = parse(&dense, &Limits::default()).bomb.unwrap();
        assert!(unpacked <= (packed * 32).max(64 << 10) + 1, "{unpacked}");
    }

    #[test]
    fn every_truncation_and_every_changed_byte_is_survived() {
        let bytes = zip_of(&[("head/a.npy", npy(USUAL, "(2,)", &two_rows()))]);
        for length in 0..bytes.len() {
            assert!(parse(&bytes[..length], &Limits::default()).fault.is_some());
        }
        for at in 0..bytes.len() {
            for value in [0, 0x7f, 0xff] {
                let mut changed = bytes.clone();
                changed[at] = value;
                parse(&changed, &Limits::default());
            }
        }
    }

    proptest! {
        #[test]
        fn any_array_is_read_or_refused(bytes in proptest::collection::vec(any::<u8>(), 0..200)) {
            let whole = [b"\x93NUMPY\x01\x00".as_slice(), &bytes].concat();
            let archive = parse(&zip_of(&[("a.npy", whole)]), &Limits::default());
            prop_assert_eq!(archive.members.len(), 1);
        }
    }
}
