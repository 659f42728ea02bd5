//! One file: bytes to facts. A panic of ours in here is caught and becomes a finding of that file.

use xxhash_rust::xxh3::xxh3_64;

use crate::discover::Candidate;
use crate::formats::json_file::{JsonFacts, JsonFault};
use crate::formats::target::{MeshSize, Row};
use crate::formats::{Content, Input, Parsed};
use crate::json::SchemaFaults;
use crate::repo::FileFacts;
use crate::source::{Encoding, Limits, Tree};

/// Smaller files are read even when only their size would matter: they may be stand-ins for the content.
const STAND_IN_BYTES: u64 = 512;

/// A file read: its facts, and its rows if it is a target.
pub(in crate::engine) struct Reading {
    pub(in crate::engine) facts: FileFacts,
    pub(in crate::engine) rows: Vec<Row>,
}

/// Reads one file; `mesh` is the size of the mesh it is for.
pub(in crate::engine) fn read(tree: &Tree, file: &Candidate<'_>, limits: &Limits, mesh: Option<MeshSize>) -> Reading {
    let mut reading = Reading { facts: unread(tree, file), rows: Vec::new() };
    let format = reading.facts.kind.format();
    if !format.is_read() && reading.facts.size >= STAND_IN_BYTES {
        return reading;
    }
    match tree.read(file.entry, limits) {
        Ok(bytes) => {
            reading.facts.encoding = Encoding::of(&bytes);
            let input = Input { bytes: &bytes, encoding: &reading.facts.encoding, limits, mesh };
            reading.take(format.read(&input));
        }
        Err(fault) => reading.facts.unreadable = Some(fault),
    }
    reading
}

/// Hash of a file's bytes, for files that only their content matters of.
pub(super) fn hash(tree: &Tree, file: &Candidate<'_>, limits: &Limits) -> Option<u64> {
    tree.read(file.entry, limits).ok().map(|bytes| xxh3_64(&bytes))
}

/// The facts of a file that is not read.
pub(super) fn unread(tree: &Tree, file: &Candidate<'_>) -> FileFacts {
    FileFacts {
        path: tree.shown(&file.entry.path),
        rel: file.rel.to_string(),
        link_to: link_to(file),
        kind: file.kind(),
        uses: file.uses.clone(),
        size: file.entry.size,
        unreadable: None,
        failed: false,
        gzip_fault: None,
        encoding: Encoding::default(),
        json: JsonFacts::default(),
        schema: SchemaFaults::default(),
        ignores: Vec::new(),
        content_hash: None,
        content: Content::Unread,
    }
}

/// The file behind a link, relative to the data root.
fn link_to(file: &Candidate<'_>) -> Option<String> {
    let root = file.entry.path.strip_suffix(&*file.rel)?;
    file.entry.link_to.as_ref()?.strip_prefix(root).map(str::to_owned)
}

impl Reading {
    fn take(&mut self, parsed: Parsed) {
        let facts = &mut self.facts;
        facts.content = parsed.content;
        facts.gzip_fault = parsed.gzip_fault;
        facts.json = parsed.json;
        facts.schema = parsed.schema;
        facts.ignores = parsed.ignores;
        facts.content_hash = parsed.content_hash;
        self.rows = parsed.rows;
    }
}

/// A stand-in for a file on which a parser of ours panicked.
pub(super) fn panicked(tree: &Tree, file: &Candidate<'_>) -> Reading {
    let mut facts = unread(tree, file);
    facts.failed = true;
    facts.content = facts.kind.format().without(JsonFault::Empty);
    Reading { facts, rows: Vec::new() }
}
