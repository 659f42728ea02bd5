//! One file: bytes to facts. A panic of ours in here is caught and becomes a finding of that file.

use xxhash_rust::xxh3::xxh3_64;

use crate::discover::{Kind, kind_of};
use crate::formats::json_file::{self, JsonFacts, JsonFault};
use crate::formats::target::{MeshSize, Row};
use crate::formats::{
    base_json, geometry, inline_ignore, macro_json, mhskel, mhw, modelling, npz, obj, target, target_cat,
};
use crate::json::{self, Document, SchemaFaults};
use crate::repo::{Content, FileFacts};
use crate::source::{Encoding, Entry, Limits, Tree, try_gunzip, zip_bomb};

/// Smaller files are read even when only their size would matter: they may be stand-ins for the content.
const STAND_IN_BYTES: u64 = 512;

/// A file read: its facts, and its rows if it is a target.
pub(in crate::engine) struct Reading {
    pub(in crate::engine) facts: FileFacts,
    pub(in crate::engine) rows: Vec<Row>,
}

/// Reads one file. `rel` is its path below the data root; `mesh` the size of the mesh it is for.
pub(in crate::engine) fn read(
    tree: &Tree,
    entry: &Entry,
    rel: &str,
    limits: &Limits,
    mesh: Option<MeshSize>,
) -> Reading {
    let mut reading = Reading { facts: empty(tree, entry, rel), rows: Vec::new() };
    if !is_read(&reading.facts) {
        return reading;
    }
    match tree.read(entry, limits) {
        Ok(bytes) => reading.fill(&bytes, limits, mesh),
        Err(fault) => reading.facts.unreadable = Some(fault),
    }
    reading
}

/// Hash of a file's bytes, for files that only their content matters of.
pub(in crate::engine) fn hash(tree: &Tree, entry: &Entry, limits: &Limits) -> Option<u64> {
    tree.read(entry, limits).ok().map(|bytes| xxh3_64(&bytes))
}

/// The facts of a file that is not read.
pub(in crate::engine) fn empty(tree: &Tree, entry: &Entry, rel: &str) -> FileFacts {
    let (kind, base) = kind_of(rel);
    let path = if tree.label().is_empty() { entry.path.clone() } else { format!("{}/{}", tree.label(), entry.path) };
    FileFacts {
        path,
        rel: rel.to_owned(),
        link_to: link_to(entry, rel),
        kind,
        base: base.map(str::to_owned),
        size: entry.size,
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
fn link_to(entry: &Entry, rel: &str) -> Option<String> {
    let root = entry.path.strip_suffix(rel)?;
    entry.link_to.as_ref()?.strip_prefix(root).map(str::to_owned)
}

fn is_read(facts: &FileFacts) -> bool {
    facts.kind.is_text() || facts.kind == Kind::PackedTarget || is_zip(&facts.rel) || facts.size < STAND_IN_BYTES
}

fn is_zip(rel: &str) -> bool {
    [".npz", ".mhbin", ".mhpxy", ".zip"].iter().any(|ending| rel.ends_with(ending))
}

impl Reading {
    fn fill(&mut self, bytes: &[u8], limits: &Limits, mesh: Option<MeshSize>) {
        let facts = &mut self.facts;
        facts.encoding = Encoding::of(bytes);
        if facts.encoding.lfs_pointer {
            facts.content = stand_in(facts.kind);
            return;
        }
        match facts.kind {
            Kind::PackedTarget => facts.gzip_fault = try_gunzip(bytes, limits).err(),
            Kind::Target => self.rows = fill_target(facts, bytes, mesh),
            Kind::BaseMesh => fill_mesh(facts, bytes),
            Kind::Weights => fill_weights(facts, bytes, mesh),
            kind if kind.is_json() => fill_json(facts, bytes),
            Kind::TargetArchive => {
                facts.gzip_fault = zip_bomb(bytes, limits);
                facts.content = Content::Archive(Box::new(npz::parse(bytes, limits)));
            }
            _ if is_zip(&facts.rel) => facts.gzip_fault = zip_bomb(bytes, limits),
            Kind::Text => {
                facts.content_hash = Some(xxh3_64(bytes));
                facts.ignores = inline_ignore::of_lines(bytes, comment_marks(&facts.rel));
            }
            _ => facts.content_hash = Some(xxh3_64(bytes)),
        }
    }
}

/// What comments begin with, in formats of text that have them.
fn comment_marks(rel: &str) -> &'static [&'static str] {
    match rel.rsplit_once('.').map(|(_, extension)| extension) {
        Some("mhclo" | "proxy" | "mhm") => &["#"],
        Some("mhmat") => &["#", "//"],
        _ => &[],
    }
}

fn stand_in(kind: Kind) -> Content {
    if kind.is_json() { Content::Broken(JsonFault::LfsPointer) } else { Content::Unread }
}

fn fill_target(facts: &mut FileFacts, bytes: &[u8], mesh: Option<MeshSize>) -> Vec<Row> {
    let Some(parsed) = target::parse_file(bytes, &facts.encoding, mesh) else { return Vec::new() };
    facts.content_hash = Some(parsed.facts.displacement);
    facts.ignores = parsed.ignores;
    facts.content = Content::Target(Box::new(parsed.facts));
    parsed.rows
}

/// A file without anything in it gives no mesh: everything measured against none would be out of range.
fn fill_mesh(facts: &mut FileFacts, bytes: &[u8]) {
    facts.content_hash = Some(xxh3_64(bytes));
    if !facts.encoding.blank && !facts.encoding.only_comments {
        facts.content = Content::Mesh(Box::new(obj::parse(bytes)));
    }
}

fn fill_json(facts: &mut FileFacts, bytes: &[u8]) {
    match json_file::parse(bytes, &facts.encoding) {
        Ok(document) => {
            facts.json = JsonFacts::of(&document);
            if let Some(schema) = schema_of(facts.kind) {
                facts.schema = json::check(schema, &document);
            }
            facts.content = model(facts.kind, &document);
        }
        Err(fault) => facts.content = Content::Broken(fault),
    }
}

fn model(kind: Kind, document: &Document) -> Content {
    match kind {
        Kind::BaseJson => Content::BaseJson(Box::new(base_json::read(document))),
        Kind::Geometry => Content::Geometry(Box::new(geometry::read(document))),
        Kind::MacroJson => Content::Macro(Box::new(macro_json::read(document))),
        Kind::ModellingJson => Content::Modelling(Box::new(modelling::read(document))),
        Kind::TargetCategories => Content::Categories(Box::new(target_cat::read(document))),
        Kind::Skeleton => Content::Skeleton(Box::new(mhskel::read(document))),
        _ => Content::Json,
    }
}

/// Name of the schema of a kind.
pub(in crate::engine) fn schema_of(kind: Kind) -> Option<&'static str> {
    match kind {
        Kind::BaseJson => Some("base"),
        Kind::Geometry => Some("geometry"),
        Kind::MacroJson => Some("macro"),
        Kind::ModellingJson => Some("modelling"),
        Kind::TargetCategories => Some("target_cat"),
        Kind::Skeleton => Some("mhskel"),
        Kind::Weights => Some("mhw"),
        _ => None,
    }
}

/// Weights are read without a tree; the tree is made only to explain what the typed reader refused.
fn fill_weights(facts: &mut FileFacts, bytes: &[u8], mesh: Option<MeshSize>) {
    match mhw::parse(bytes, &facts.encoding, mesh.map(|mesh| mesh.vertices)) {
        Ok(weights) => {
            let needs_explaining =
                !weights.has_weights || weights.has_shapeless_bone || !weights.facts.json.duplicates.is_empty();
            facts.content = Content::Weights(Box::new(weights));
            if needs_explaining && let Ok(document) = json_file::parse(bytes, &facts.encoding) {
                facts.json = JsonFacts::of(&document);
                facts.schema = json::check("mhw", &document);
            }
        }
        Err(fault) => facts.content = Content::Broken(fault),
    }
}

/// A stand-in for a file on which a parser of ours panicked.
pub(in crate::engine) fn panicked(tree: &Tree, entry: &Entry, rel: &str) -> Reading {
    let mut facts = empty(tree, entry, rel);
    let reason = "mhlint itself failed on this file; please report it with the file".to_owned();
    facts.unreadable = Some(crate::source::ReadFault::Unreadable(reason));
    facts.failed = true;
    facts.content = if facts.kind.is_json() { Content::Broken(JsonFault::Empty) } else { Content::Unread };
    Reading { facts, rows: Vec::new() }
}
