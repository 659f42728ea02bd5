//! A zip as a listing of files and their bytes, without unpacking it to disk.
//!
//! Members that no file may be made of are faults. The sizes in the list of members are what is
//! unpacked at most, and what they come to is bounded.

mod directory;
mod name;
mod unpack;

use std::collections::BTreeMap;
use std::sync::Arc;

use xxhash_rust::xxh3::xxh3_64;

use self::directory::{Record, records};
use self::name::{Name, name, shown};
use self::unpack::{check, unpack};
use super::{Limits, normalized};
use crate::path::parent;

/// Bytes that a path has at most, on any system that the applications run on.
const LONGEST: u64 = 4096;

/// What is wrong with a zip as a whole: nothing in it is read.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum PackFault {
    /// It is no zip, or the end with the list of its members is missing.
    NoZip,
    /// The list of its members is damaged.
    List,
    /// It has more members than anybody has assets.
    TooMany {
        /// So many are listed.
        most: usize,
    },
    /// What its members say to unpack to is beyond the limits.
    Bomb {
        /// Size of the zip in bytes.
        packed: u64,
        /// Bytes that its members come to.
        unpacked: u64,
    },
}

/// Why no file is made of a member.
#[derive(Debug, Clone, PartialEq, Eq, PartialOrd, Ord)]
pub enum MemberFault {
    /// Its name begins at a root or a drive, or has `..` in it.
    Escapes,
    /// It is a link that leads out of the pack.
    LinkLeaves {
        /// What it says.
        to: String,
    },
    /// It is a link.
    Link {
        /// What it says.
        to: String,
    },
    /// It is encrypted.
    Encrypted,
    /// It is packed in a way that is hardly ever used.
    Method(u16),
    /// Its name is marked as UTF-8, which it is not.
    NameNotUtf8,
    /// It cannot be unpacked.
    Damaged(&'static str),
    /// Another member of its name comes later in the list, with other content.
    Replaced,
}

/// Ways to pack that Python unpacks: bzip2 and LZMA.
const UNPACKED_BY_PYTHON: [u16; 2] = [12, 14];

impl MemberFault {
    /// Whether the applications unpack the member nevertheless.
    pub fn is_of_reader(&self) -> bool {
        matches!(self, Self::Method(method) if UNPACKED_BY_PYTHON.contains(method))
    }
}

/// What is to be known of a zip besides the files in it.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct PackFacts {
    /// Names of all members in the order of the list, as Python reads them.
    pub names: Vec<String>,
    /// What is wrong with it as a whole.
    pub fault: Option<PackFault>,
    /// Members that are no files, by name.
    pub faults: Vec<(String, MemberFault)>,
    /// Paths of the files whose names have `\` for a separator.
    pub backslashes: Vec<String>,
    /// Paths of the files whose names are UTF-8 but not marked as such, with the names that Python
    /// makes of them.
    pub unmarked: BTreeMap<String, String>,
}

/// A zip with the members that are files.
#[derive(Debug)]
pub(super) struct Pack {
    zip: Arc<[u8]>,
    hash: u64,
    files: BTreeMap<String, Record>,
    folders: Vec<String>,
}

impl PartialEq for Pack {
    fn eq(&self, other: &Self) -> bool {
        self.zip.len() == other.zip.len() && self.hash == other.hash
    }
}

impl Eq for Pack {}

impl Pack {
    /// Reads the list of members, and tries each of them.
    pub(super) fn open(zip: Vec<u8>, limits: &Limits) -> (Self, PackFacts) {
        let mut facts = PackFacts::default();
        let records = within(&zip, limits).unwrap_or_else(|fault| {
            facts.fault = Some(fault);
            Vec::new()
        });
        let hash = xxh3_64(&zip);
        let mut pack = Self {
            zip: zip.into(),
            hash,
            files: BTreeMap::new(),
            folders: Vec::new(),
        };
        facts.names = records.iter().map(shown).collect();
        for record in records {
            if let Err(fault) = pack.add(&record, &mut facts) {
                let path = name(&record).map(|name| name.path);
                facts
                    .faults
                    .push((path.unwrap_or_else(|_| shown(&record)), fault));
            }
        }
        pack.drop_files_below_files(&mut facts);
        facts
            .backslashes
            .retain(|path| pack.files.contains_key(path));
        facts
            .unmarked
            .retain(|path, _| pack.files.contains_key(path));
        facts.faults.sort();
        (pack, facts)
    }

    fn add(&mut self, record: &Record, facts: &mut PackFacts) -> Result<(), MemberFault> {
        let Name {
            path,
            read_as,
            has_backslash,
            is_folder,
        } = name(record)?;
        if is_folder {
            self.folders.push(path);
            return Ok(());
        }
        if record.is_encrypted {
            return Err(MemberFault::Encrypted);
        }
        check(&self.zip, record)?;
        if record.is_link {
            return Err(self.link(&path, record));
        }
        if has_backslash {
            facts.backslashes.push(path.clone());
        }
        facts
            .unmarked
            .extend(read_as.map(|read_as| (path.clone(), read_as)));
        let before = self.files.insert(path.clone(), record.clone());
        if before.is_some_and(|before| (before.crc, before.size) != (record.crc, record.size)) {
            facts.faults.push((path, MemberFault::Replaced));
        }
        Ok(())
    }

    /// What is wrong with a link.
    fn link(&self, path: &str, record: &Record) -> MemberFault {
        if record.size > LONGEST {
            return MemberFault::Damaged("it is a link to a path that is too long");
        }
        let to = unpack(&self.zip, record).unwrap_or_default();
        let to = String::from_utf8_lossy(&to).into_owned();
        let folder = parent(path);
        let is_inside = !to.starts_with('/') && normalized(&format!("{folder}/{to}")).is_some();
        if is_inside {
            MemberFault::Link { to }
        } else {
            MemberFault::LinkLeaves { to }
        }
    }

    /// Whoever unpacks it fails at a file that is to lie in another file.
    fn drop_files_below_files(&mut self, facts: &mut PackFacts) {
        let taken =
            |folder: Option<&str>| folder.is_some_and(|folder| self.files.contains_key(folder));
        let is_below =
            |path: &&String| path.match_indices('/').any(|(at, _)| taken(path.get(..at)));
        let below: Vec<String> = self.files.keys().filter(is_below).cloned().collect();
        for path in below {
            self.files.remove(&path);
            facts.faults.push((
                path,
                MemberFault::Damaged("another member has the name of its folder"),
            ));
        }
    }

    /// The files with their sizes.
    pub(super) fn files(&self) -> impl Iterator<Item = (&str, u64)> {
        self.files
            .iter()
            .map(|(path, record)| (path.as_str(), record.size))
    }

    /// Members that are folders.
    pub(super) fn folders(&self) -> impl Iterator<Item = &str> {
        self.folders.iter().map(String::as_str)
    }

    /// The bytes of a file; `None` if there is no such file.
    pub(super) fn read(&self, path: &str) -> Option<Result<Vec<u8>, MemberFault>> {
        self.files.get(path).map(|record| unpack(&self.zip, record))
    }
}

/// The list of members, if what they unpack to is within the limits.
fn within(zip: &[u8], limits: &Limits) -> Result<Vec<Record>, PackFault> {
    let records = records(zip)?;
    let packed = zip.len() as u64;
    let unpacked = records
        .iter()
        .fold(0_u64, |sum, record| sum.saturating_add(record.size));
    if unpacked > limits.unpacked_limit(packed) {
        Err(PackFault::Bomb { packed, unpacked })
    } else {
        Ok(records)
    }
}
