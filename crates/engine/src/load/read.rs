//! One file: bytes to facts. A panic of ours in here is caught and becomes a finding of that file.

use std::sync::Arc;

use mhlint_discover::Candidate;
use mhlint_formats::json_file::JsonFault;
use mhlint_formats::target::{MeshSize, Row};
use mhlint_formats::{Format, Input, Parsed};
use mhlint_repo::FileFacts;
use mhlint_source::{Encoding, Limits, Tree};

/// Smaller files are read even when only their size would matter: they may be stand-ins for the
/// content.
const STAND_IN_BYTES: u64 = 512;

/// Reads one file, with its rows if it is a target; `mesh` is the size of the mesh it is for.
pub(super) fn read(
    tree: &Tree,
    file: &Candidate<'_>,
    limits: &Limits,
    mesh: Option<MeshSize>,
) -> (FileFacts, Vec<Row>) {
    let format = Format::of(file.kind());
    if !format.is_read() && format.ends().is_none() && file.entry.size >= STAND_IN_BYTES {
        return (unread(tree, file), Vec::new());
    }
    let read = match format.ends() {
        Some(ends) => tree.read_ends(file.entry, ends, limits),
        None => tree
            .read(file.entry, limits)
            .map(|bytes| (bytes, Vec::new())),
    };
    let (bytes, tail) = match read {
        Ok(ends) => ends,
        Err(fault) => {
            return (
                FileFacts {
                    unreadable: Some(fault),
                    ..unread(tree, file)
                },
                Vec::new(),
            );
        }
    };
    let encoding = Encoding::of(&bytes);
    let mut parsed = format.read(&Input {
        bytes: &bytes,
        tail: &tail,
        size: file.entry.size,
        encoding: &encoding,
        limits,
        mesh,
    });
    let rows = std::mem::take(&mut parsed.rows);
    (facts(tree, file, encoding, parsed), rows)
}

/// The facts of a file that is not read.
pub(super) fn unread(tree: &Tree, file: &Candidate<'_>) -> FileFacts {
    facts(tree, file, Encoding::default(), Parsed::default())
}

/// A stand-in for a file on which a parser of ours panicked.
pub(super) fn panicked(tree: &Tree, file: &Candidate<'_>) -> FileFacts {
    let content = Arc::new(Format::of(file.kind()).without(JsonFault::Empty));
    FileFacts {
        failed: true,
        content,
        ..unread(tree, file)
    }
}

/// The facts of a file under another path, as links give it.
pub(super) fn behind_link(tree: &Tree, file: &Candidate<'_>, facts: &FileFacts) -> FileFacts {
    FileFacts {
        path: tree.shown(&file.entry.path),
        rel: file.rel.to_string(),
        is_loose: file.is_loose,
        link_to: link_to(file),
        uses: file.uses.clone(),
        ..facts.clone()
    }
}

fn facts(tree: &Tree, file: &Candidate<'_>, encoding: Encoding, parsed: Parsed) -> FileFacts {
    FileFacts {
        path: tree.shown(&file.entry.path),
        rel: file.rel.to_string(),
        is_loose: file.is_loose,
        link_to: link_to(file),
        kind: file.kind(),
        uses: file.uses.clone(),
        size: file.entry.size,
        unreadable: None,
        failed: false,
        gzip_fault: parsed.gzip_fault,
        encoding,
        json: parsed.json,
        schema: parsed.schema,
        ignores: parsed.ignores,
        content_hash: parsed.content_hash,
        content: Arc::new(parsed.content),
    }
}

/// The file behind a link, relative to the data root.
fn link_to(file: &Candidate<'_>) -> Option<String> {
    let root = file.entry.path.strip_suffix(&*file.rel)?;
    file.entry
        .link_to
        .as_ref()?
        .strip_prefix(root)
        .map(str::to_owned)
}
