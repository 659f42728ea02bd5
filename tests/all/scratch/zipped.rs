//! `[[zip]]`: zips as they may come, with members that no good program would write.

use std::io::Write;
use std::path::Path;

use flate2::{Compression, Crc, write::DeflateEncoder};
use serde::Deserialize;

use super::content;

/// A zip to make.
#[derive(Debug, Default, Deserialize)]
#[serde(deny_unknown_fields, default)]
pub struct Zipped {
    pub file: String,
    /// A folder whose content is in it.
    folder: String,
    /// Further members.
    member: Vec<Member>,
    /// How many bytes are cut off its end.
    cut: usize,
    /// Whether the first row in the list of members is damaged.
    damaged_list: bool,
}

/// One member: sound, unless it says something else.
#[derive(Debug, Clone, Deserialize)]
#[serde(deny_unknown_fields, default)]
#[expect(clippy::struct_excessive_bools, reason = "each is a key of a case")]
pub struct Member {
    pub name: String,
    /// The name in hexadecimal, where it is not UTF-8.
    pub hex_name: String,
    pub text: String,
    /// How often the text is repeated; then it is compressed.
    pub times: usize,
    /// A file of the repository that is in it.
    pub from: String,
    /// Whether the name is marked as UTF-8.
    pub marked: bool,
    pub link: bool,
    pub encrypted: bool,
    pub method: Option<u16>,
    /// Whether its content is not that of its checksum.
    pub damaged: bool,
}

impl Default for Member {
    fn default() -> Self {
        let (name, text) = (String::new(), String::new());
        let [hex_name, from] = [String::new(), String::new()];
        let [link, encrypted, damaged] = [false; 3];
        Self {
            name,
            hex_name,
            text,
            times: 1,
            from,
            marked: true,
            link,
            encrypted,
            method: None,
            damaged,
        }
    }
}

impl Zipped {
    /// The zip; paths are those of a repository at `root`.
    pub fn bytes(&self, root: &Path) -> Vec<u8> {
        let mut zip = Writer::default();
        if !self.folder.is_empty() {
            for (path, bytes) in content(&root.join(&self.folder)) {
                zip.add(
                    &Member {
                        name: path.to_str().unwrap().to_owned(),
                        ..Member::default()
                    },
                    &bytes,
                );
            }
        }
        for member in &self.member {
            let own = member.text.repeat(member.times).into_bytes();
            let from =
                (!member.from.is_empty()).then(|| std::fs::read(root.join(&member.from)).unwrap());
            zip.add(member, &from.unwrap_or(own));
        }
        let mut bytes = zip.finish();
        bytes.truncate(bytes.len() - self.cut);
        if self.damaged_list {
            let row = bytes
                .windows(4)
                .position(|four| four == b"PK\x01\x02")
                .unwrap();
            bytes[row] = b'?';
        }
        bytes
    }
}

/// A zip of these members.
pub fn zip(members: &[(Member, &[u8])]) -> Vec<u8> {
    let mut zip = Writer::default();
    members
        .iter()
        .for_each(|(member, bytes)| zip.add(member, bytes));
    zip.finish()
}

/// A member of this name.
pub fn named(name: &str) -> Member {
    Member {
        name: name.to_owned(),
        ..Member::default()
    }
}

#[derive(Default)]
struct Writer {
    bytes: Vec<u8>,
    list: Vec<u8>,
    count: u16,
}

impl Writer {
    fn add(&mut self, member: &Member, content: &[u8]) {
        let digits = member
            .hex_name
            .as_bytes()
            .chunks(2)
            .map(|pair| std::str::from_utf8(pair).unwrap());
        let hex: Vec<u8> = digits
            .map(|pair| u8::from_str_radix(pair, 16).unwrap())
            .collect();
        let name = if hex.is_empty() {
            member.name.as_bytes()
        } else {
            &hex
        };
        let mut crc = Crc::new();
        crc.update(content);
        let is_deflated = member.times > 1;
        let mut packed = if is_deflated {
            deflated(content)
        } else {
            content.to_vec()
        };
        if let Some(first) = packed.first_mut().filter(|_| member.damaged) {
            *first ^= 0x55;
        }
        let flags = u16::from(member.encrypted) | if member.marked { 0x800 } else { 0 };
        let method = member.method.unwrap_or(if is_deflated { 8 } else { 0 });
        let sizes =
            [packed.len(), content.len()].map(|size| u32::try_from(size).unwrap().to_le_bytes());
        let length = u16::try_from(name.len()).unwrap().to_le_bytes();
        // What the list and the header of the member have in common.
        let common = [
            &20_u16.to_le_bytes()[..],
            &flags.to_le_bytes(),
            &method.to_le_bytes(),
            &[0, 0, 0x21, 0],
            &crc.sum().to_le_bytes(),
            &sizes[0],
            &sizes[1],
            &length,
            &[0, 0],
        ]
        .concat();
        let at = u32::try_from(self.bytes.len()).unwrap().to_le_bytes();
        let mode: u32 = if member.link { 0o12_0777 } else { 0o10_0644 };
        let attributes = (mode << 16).to_le_bytes();
        self.list.extend(
            [
                b"PK\x01\x02\x14\x03",
                &common[..],
                &[0; 6],
                &attributes,
                &at,
                name,
            ]
            .concat(),
        );
        self.bytes
            .extend([b"PK\x03\x04", &common[..], name, &packed].concat());
        self.count = self.count.wrapping_add(1);
    }

    fn finish(self) -> Vec<u8> {
        let Self {
            mut bytes,
            list,
            count,
        } = self;
        let [size, at] =
            [list.len(), bytes.len()].map(|number| u32::try_from(number).unwrap().to_le_bytes());
        let count = count.to_le_bytes();
        bytes.extend(list);
        bytes.extend(
            [
                b"PK\x05\x06\0\0\0\0",
                &count[..],
                &count,
                &size,
                &at,
                &[0, 0],
            ]
            .concat(),
        );
        bytes
    }
}

fn deflated(content: &[u8]) -> Vec<u8> {
    let mut encoder = DeflateEncoder::new(Vec::new(), Compression::best());
    encoder.write_all(content).unwrap();
    encoder.finish().unwrap()
}
