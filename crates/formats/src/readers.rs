//! Bytes of one file to what is kept of them, as the table of formats says.

use xxhash_rust::xxh3::xxh3_64;

use super::asset_mesh::AssetMesh;
use super::inline_ignore::{self, InlineIgnore};
use super::json_file::{self, JsonFacts, JsonFault};
use super::table::{Format, Reader, Syntax};
use super::target::{self, MeshSize, Row};
use super::{
    Content, bvh, index_table as table, mesh_metadata, meta as metadata, mhbin, mhclo, mhm, mhmat,
    mhpose, mhw, modifiers, npz, obj, outdated, packed, picture, picture_list as list, scene,
    shader_source, stored_pose as stored, uv_layer as layer, uv_map,
};
use mhlint_json::{self as json, Document, SchemaFaults};
use mhlint_source::{Encoding, GzipFault, Limits, gunzip_at_most, zip_bomb};

/// What a reader is given.
#[derive(Debug, Clone, Copy)]
pub struct Input<'b> {
    /// The content, or the beginning of it where the ends are enough.
    pub bytes: &'b [u8],
    /// The end of it, where it is not all in `bytes`.
    pub tail: &'b [u8],
    /// Bytes of the whole.
    pub size: u64,
    /// Its encoding.
    pub encoding: &'b Encoding,
    /// What is too much.
    pub limits: &'b Limits,
    /// Size of the mesh that the file is for.
    pub mesh: Option<MeshSize>,
}

/// What is kept of a file's bytes.
#[derive(Debug, Clone, Default)]
pub struct Parsed {
    /// What was in it.
    pub content: Content,
    /// Why it could not be unpacked.
    pub gzip_fault: Option<GzipFault>,
    /// Facts on the text of a JSON.
    pub json: JsonFacts,
    /// What the schema of its format says.
    pub schema: SchemaFaults,
    /// Ignores in its comments.
    pub ignores: Vec<InlineIgnore>,
    /// Hash of the decoded content where equal content matters.
    pub content_hash: Option<u64>,
    /// The rows of a target.
    pub rows: Vec<Row>,
}

impl Format {
    /// Reads a file of this format.
    pub fn read(&self, input: &Input<'_>) -> Parsed {
        if input.encoding.lfs_pointer {
            return Parsed {
                content: self.without(JsonFault::LfsPointer),
                ..Parsed::default()
            };
        }
        let parsed = self.parsed(input);
        if self.comments.is_empty() {
            return parsed;
        }
        Parsed {
            ignores: inline_ignore::of_lines(input.bytes, self.comments),
            ..parsed
        }
    }

    fn parsed(&self, input: &Input<'_>) -> Parsed {
        match (self.reader, self.syntax) {
            (Some(Reader::Bytes(read) | Reader::Ends(read)), _) => read(input),
            (Some(Reader::Tree(model)), _) => tree(input, self.schema, model),
            (None, Syntax::Json) => tree(input, self.schema, |_| Content::Json),
            (None, Syntax::Text | Syntax::Binary) => hashed(input),
        }
    }

    /// What stands for the content of a file that could not be read for `fault`.
    pub fn without(&self, fault: JsonFault) -> Content {
        if self.syntax == Syntax::Json {
            Content::Broken(fault)
        } else {
            Content::Unread
        }
    }
}

fn hashed(input: &Input<'_>) -> Parsed {
    Parsed {
        content_hash: Some(xxh3_64(input.bytes)),
        ..Parsed::default()
    }
}

fn tree(input: &Input<'_>, schema: Option<&str>, model: fn(&Document) -> Content) -> Parsed {
    match json_file::parse(input.bytes, input.encoding) {
        Ok(document) => Parsed {
            json: JsonFacts::of(&document),
            schema: schema.map_or_else(SchemaFaults::default, |schema| {
                json::check(schema, &document)
            }),
            content: model(&document),
            ..Parsed::default()
        },
        Err(fault) => Parsed {
            content: Content::Broken(fault),
            ..Parsed::default()
        },
    }
}

/// A target, with its rows.
pub(super) fn target(input: &Input<'_>) -> Parsed {
    let Some(parsed) = target::parse_file(input.bytes, input.encoding, input.mesh) else {
        return Parsed::default();
    };
    Parsed {
        content_hash: Some(parsed.facts.displacement),
        ignores: parsed.ignores,
        content: Content::Target(Box::new(parsed.facts)),
        rows: parsed.rows,
        ..Parsed::default()
    }
}

/// What is worn.
pub(super) fn clothes(input: &Input<'_>) -> Parsed {
    let clothes = mhclo::parse(input.bytes, input.mesh).kept();
    Parsed {
        content: Content::Clothes(Box::new(clothes)),
        ..hashed(input)
    }
}

/// What has the extension of an asset where no list looks, or one that no list takes any more: of
/// interest only for its age.
pub(super) fn unlisted(input: &Input<'_>) -> Parsed {
    let found = outdated::of_pose(input.bytes).or_else(|| mhclo::parse(input.bytes, None).outdated);
    Parsed {
        content: found.map_or(Content::Unread, Content::Outdated),
        ..hashed(input)
    }
}

/// A material. One without anything in it names nothing.
pub(super) fn material(input: &Input<'_>) -> Parsed {
    Parsed {
        content: Content::Material(Box::new(mhmat::read(input.bytes))),
        ..hashed(input)
    }
}

/// A picture. One without anything in it is empty, and nothing more.
pub(super) fn picture(input: &Input<'_>) -> Parsed {
    let read = || Content::Picture(Box::new(picture::read(input.bytes, input.tail, input.size)));
    Parsed {
        content: if input.size == 0 {
            Content::Unread
        } else {
            read()
        },
        ..Parsed::default()
    }
}

/// A motion. Of one that is blank or is no UTF-8 the loader reads nothing.
pub(super) fn motion(input: &Input<'_>) -> Parsed {
    let mut parsed = hashed(input);
    if !input.encoding.blank && input.encoding.invalid_utf8_at.is_none() {
        parsed.content = Content::Motion(Box::new(bvh::read(input.bytes)));
    }
    parsed
}

/// A model. One that is blank sets nothing.
pub(super) fn model(input: &Input<'_>) -> Parsed {
    Parsed {
        content: Content::Model(Box::new(mhm::read(input.bytes))),
        ..hashed(input)
    }
}

/// The table of older names.
pub(super) fn modifier_mapping(input: &Input<'_>) -> Parsed {
    Parsed {
        content: Content::Mapping(Box::new(modifiers::mapping::read(input.bytes))),
        ..hashed(input)
    }
}

/// What is said of a motion. Of one that is no UTF-8 the scan reads nothing.
pub(super) fn meta(input: &Input<'_>) -> Parsed {
    let mut parsed = hashed(input);
    if input.encoding.invalid_utf8_at.is_none() {
        parsed.content = Content::Meta(Box::new(metadata::read(input.bytes)));
    }
    parsed
}

/// A pose. Copies of one another are told by their bytes.
pub(super) fn pose(input: &Input<'_>) -> Parsed {
    let parsed = tree(input, Some("mhpose"), |json| {
        Content::Pose(Box::new(mhpose::read(json)))
    });
    Parsed {
        content_hash: Some(xxh3_64(input.bytes)),
        ..parsed
    }
}

/// A pose of MPFB. Copies of one another are told by their bytes.
pub(super) fn stored_pose(input: &Input<'_>) -> Parsed {
    let parsed = tree(input, Some("mpfb_pose"), |json| {
        Content::StoredPose(Box::new(stored::read(json)))
    });
    Parsed {
        content_hash: Some(xxh3_64(input.bytes)),
        ..parsed
    }
}

/// Bytes of a packed JSON at most; those of MPFB come to a fortieth of it. What is larger is not
/// looked into.
const LARGEST_JSON: usize = 64 << 20;

/// A packed JSON. One without a byte is empty, and nothing more.
fn packed_json(input: &Input<'_>, read: fn(&[u8], &Encoding) -> Content) -> Parsed {
    if input.bytes.is_empty() {
        return Parsed::default();
    }
    match gunzip_at_most(input.bytes, input.limits, LARGEST_JSON) {
        Err(fault) => Parsed {
            gzip_fault: Some(fault),
            ..hashed(input)
        },
        Ok(None) => hashed(input),
        Ok(Some(bytes)) => Parsed {
            content: read(&bytes, &Encoding::of(&bytes)),
            ..hashed(input)
        },
    }
}

/// A UV layer of MPFB.
pub(super) fn uv_layer(input: &Input<'_>) -> Parsed {
    packed_json(input, |text, encoding| {
        Content::UvLayer(Box::new(layer::read(text, encoding)))
    })
}

/// A table of faces or vertices of MPFB's base mesh.
pub(super) fn index_table(input: &Input<'_>) -> Parsed {
    packed_json(input, |text, encoding| {
        Content::IndexTable(Box::new(table::read(text, encoding)))
    })
}

/// A file without anything in it gives no mesh: everything measured against none would be out of
/// range.
pub(super) fn mesh(input: &Input<'_>) -> Parsed {
    let mut parsed = hashed(input);
    if !input.encoding.blank && !input.encoding.only_comments {
        parsed.content = Content::Mesh(Box::new(obj::parse(input.bytes)));
    }
    parsed
}

/// The mesh of an asset.
pub(super) fn asset_mesh(input: &Input<'_>) -> Parsed {
    let mut parsed = hashed(input);
    if !input.encoding.blank && !input.encoding.only_comments {
        parsed.content = Content::AssetMesh(Box::new(AssetMesh::of(obj::parse(input.bytes))));
    }
    parsed
}

/// The mirror table of MPFB.
pub(super) fn mirror_table(input: &Input<'_>) -> Parsed {
    Parsed {
        content: Content::MirrorTable(Box::new(mesh_metadata::mirror(input.bytes))),
        ..hashed(input)
    }
}

/// Source of a shader.
pub(super) fn shader_source(input: &Input<'_>) -> Parsed {
    Parsed {
        content: Content::ShaderSource(Box::new(shader_source::read(input.bytes))),
        ..hashed(input)
    }
}

/// A scene. One without a byte is empty, and nothing more.
pub(super) fn scene(input: &Input<'_>) -> Parsed {
    let read = || Content::Scene(Box::new(scene::read(input.bytes)));
    Parsed {
        content: if input.bytes.is_empty() {
            Content::Unread
        } else {
            read()
        },
        ..hashed(input)
    }
}

/// What the program remembers of a library.
pub(super) fn library_cache(input: &Input<'_>) -> Parsed {
    Parsed {
        content: Content::LibraryCache(scene::dangers_of_list(input.bytes)),
        ..hashed(input)
    }
}

/// A map of texture coordinates.
pub(super) fn uv_map(input: &Input<'_>) -> Parsed {
    Parsed {
        content: Content::UvMap(Box::new(uv_map::read(input.bytes))),
        ..hashed(input)
    }
}

/// A packed base mesh. What unpacks beyond all limits is not looked into.
pub(super) fn mesh_archive(input: &Input<'_>) -> Parsed {
    let mut parsed = zip_within(input, &input.limits.of_arrays());
    if parsed.gzip_fault.is_none() {
        parsed.content = Content::MeshArchive(Box::new(mhbin::parse(input.bytes, input.limits)));
    }
    parsed
}

/// Weights are read without a tree; the tree is made only to explain what the typed reader
/// rejected.
pub(super) fn weights(input: &Input<'_>) -> Parsed {
    let weights = match mhw::parse(
        input.bytes,
        input.encoding,
        input.mesh.map(|mesh| mesh.vertices),
    ) {
        Ok(weights) => weights,
        Err(fault) => {
            return Parsed {
                content: Content::Broken(fault),
                ..Parsed::default()
            };
        }
    };
    let needs_explaining =
        !weights.has_weights || weights.has_shapeless_bone || weights.facts.has_duplicate_keys;
    let explained = if needs_explaining {
        tree(input, Some("mhw"), |_| Content::Json)
    } else {
        Parsed::default()
    };
    Parsed {
        content: Content::Weights(Box::new(weights)),
        ..explained
    }
}

/// Bytes of a target at most; those of MPFB come to a hundredth of it. What is larger is not looked
/// into.
const LARGEST_TARGET: usize = 64 << 20;

/// A packed target, with its rows. One without a byte is an empty target.
pub(super) fn packed(input: &Input<'_>) -> Parsed {
    if input.bytes.is_empty() {
        return Parsed::default();
    }
    match gunzip_at_most(input.bytes, input.limits, LARGEST_TARGET) {
        Err(fault) => Parsed {
            gzip_fault: Some(fault),
            ..Parsed::default()
        },
        Ok(None) => Parsed::default(),
        Ok(Some(bytes)) => {
            // Whoever unpacks it has no finding on a mark but that its first line is no row.
            let encoding = Encoding {
                byte_order_mark: false,
                ..Encoding::of(&bytes)
            };
            let parsed = target(&Input {
                bytes: &bytes,
                encoding: &encoding,
                ..*input
            });
            let reason = || GzipFault::Corrupt("what is in it is not UTF-8".to_owned());
            Parsed {
                gzip_fault: encoding.invalid_utf8_at.map(|_| reason()),
                ignores: Vec::new(),
                ..parsed
            }
        }
    }
}

/// An archive of any kind: whether it can be unpacked, and what is in it if it is that of an asset.
pub(super) fn zip(input: &Input<'_>) -> Parsed {
    let limits = if npz::has_arrays(input.bytes) {
        input.limits.of_arrays()
    } else {
        *input.limits
    };
    let mut parsed = zip_within(input, &limits);
    if parsed.gzip_fault.is_none() {
        parsed.content = Content::Packed(Box::new(packed::asset::parse(
            input.bytes,
            input.limits,
            input.mesh,
        )));
    }
    parsed
}

/// The base mesh of MakeHuman 1, packed as its other meshes are.
pub(super) fn base_zip(input: &Input<'_>) -> Parsed {
    let parsed = zip_within(input, &input.limits.of_arrays());
    let content = match &parsed.gzip_fault {
        Some(_) => parsed.content,
        None => Content::Packed(Box::new(packed::asset::parse_base(
            input.bytes,
            input.limits,
        ))),
    };
    Parsed { content, ..parsed }
}

fn zip_within(input: &Input<'_>, limits: &Limits) -> Parsed {
    Parsed {
        gzip_fault: zip_bomb(input.bytes, limits),
        ..Parsed::default()
    }
}

/// An archive of targets. What unpacks beyond all limits is not looked into.
pub(super) fn archive(input: &Input<'_>) -> Parsed {
    let parsed = zip_within(input, &input.limits.of_arrays());
    let archive = match &parsed.gzip_fault {
        Some(GzipFault::Bomb { packed, unpacked }) => npz::Archive::unread(*packed, *unpacked),
        _ => npz::parse(input.bytes, input.limits),
    };
    Parsed {
        content: Content::Archive(Box::new(archive)),
        ..parsed
    }
}

/// The archive of all targets of MakeHuman 1.
pub(super) fn targets_archive(input: &Input<'_>) -> Parsed {
    let parsed = zip_within(input, &input.limits.of_arrays());
    let archive = match &parsed.gzip_fault {
        Some(_) => npz::targets::TargetsNpz {
            is_bomb: true,
            ..npz::targets::TargetsNpz::default()
        },
        None => npz::targets::parse(input.bytes, input.limits),
    };
    Parsed {
        content: Content::TargetsNpz(Box::new(archive)),
        ..parsed
    }
}

/// The pictures of sliders.
pub(super) fn picture_list(input: &Input<'_>) -> Parsed {
    Parsed {
        content: Content::PictureList(Box::new(list::read(input.bytes))),
        ..hashed(input)
    }
}
