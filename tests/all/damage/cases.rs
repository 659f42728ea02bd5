//! The tables: what is damaged and what must be said about it, without evaluation and with it.

/// One damage.
pub(crate) struct Case {
    pub(crate) name: &'static str,
    /// Base that is loaded, the other one is left out.
    pub(crate) base: &'static str,
    pub(crate) damage: &'static [Edit],
    /// `rule path` of every finding that the undamaged data do not have, sorted; `×3` behind it:
    /// three of them.
    pub(crate) fresh: &'static [&'static str],
    /// `rule asset` of every finding that is no longer there at all, the same way.
    pub(crate) gone: &'static [&'static str],
    /// What the message of a new finding holds: the setting of the sliders that shows it.
    pub(crate) says: &'static str,
}

/// A change; paths are below `data/`.
pub(crate) enum Edit {
    /// The first occurrence of a text by another.
    Replace(&'static str, &'static str, &'static str),
    /// Bytes at an offset.
    Insert(&'static str, usize, &'static [u8]),
    /// Only so many bytes are left.
    Cut(&'static str, usize),
    /// A whole file.
    Write(&'static str, &'static [u8]),
    Remove(&'static str),
    Rename(&'static str, &'static str),
    Copy(&'static str, &'static str),
    /// Displacements of vertices of a target, each moved by so much more.
    Move(&'static str, &'static [(u32, [f64; 3])]),
    /// Vertices that a target lists and no longer moves.
    Zero(&'static str, &'static [u32]),
}

use Edit::{Copy, Cut, Insert, Move, Remove, Rename, Replace, Write, Zero};

/// Deeper than any limit.
static DEEP: [u8; 100_000] = [b'['; 100_000];

const fn case(
    name: &'static str,
    base: &'static str,
    damage: &'static [Edit],
    fresh: &'static [&'static str],
    gone: &'static [&'static str],
) -> Case {
    Case {
        name,
        base,
        damage,
        fresh,
        gone,
        says: "",
    }
}

impl Case {
    const fn saying(self, says: &'static str) -> Self {
        Self { says, ..self }
    }
}

// Findings that the undamaged data have and that several damages take away.

/// Combinations that no target is for.
const OF_ABSENT_COMBINATIONS: &[&str] = &["macro-missing-combination target/hm08/macro.json ×3"];

/// What is said of combinations and of the shapes they make: gone where a component is bound to no
/// slider.
const OF_COMBINATIONS: &[&str] = &[
    "macro-missing-combination target/hm08/macro.json ×3",
    "numeric-dead-range target/hm08/macro.json ×3",
    "numeric-threshold-loss target/hm08/macro.json",
];

/// All that is said of macros that are not evaluated: gone without `macro.json`.
const OF_MACROS: &[&str] = &[
    "macro-alias-suspect target/hm08/macro.json ×2",
    "macro-missing-combination target/hm08/macro.json ×3",
];

/// All that is said of macros, evaluated ones included: gone without `macro.json`.
const OF_EVALUATED_MACROS: &[&str] = &[
    "macro-alias-suspect target/hm08/macro.json ×2",
    "macro-missing-combination target/hm08/macro.json ×3",
    "numeric-dead-range target/hm08/macro.json ×3",
    "numeric-threshold-loss target/hm08/macro.json",
];

/// All that is said of sliders, evaluated ones included: gone without `modelling.json`.
const OF_SLIDERS: &[&str] = &[
    "base-unknown-preset base/hm08/base.json",
    "file-unreferenced target/hm08/icons",
    "macro-missing-combination target/hm08/macro.json ×3",
    "modelling-measure target/hm08/modelling.json ×3",
    "numeric-dead-range target/hm08/macro.json ×3",
    "numeric-threshold-loss target/hm08/macro.json",
    "target-asymmetric-pair target/hm08/armslegs/l-foot-trans-backward.target",
    "target-asymmetric-pair target/hm08/armslegs/l-foot-trans-forward.target",
    "target-asymmetric-pair target/hm08/eyes/l-eye-corner1-up.target",
    "target-moves-helpers-only data",
];

/// All that is said of the mesh and of what moves it: gone without a mesh.
const OF_MESH: &[&str] = &[
    "base-geometry-range base/hm08/geometry.json",
    "mesh-reopened-group base/hm08/base.obj",
    "modelling-measure target/hm08/modelling.json ×3",
    "numeric-dead-range target/hm08/macro.json ×3",
    "numeric-threshold-loss target/hm08/macro.json",
    "target-asymmetric data",
    "target-asymmetric-pair target/hm08/armslegs/l-foot-trans-backward.target",
    "target-asymmetric-pair target/hm08/armslegs/l-foot-trans-forward.target",
    "target-asymmetric-pair target/hm08/eyes/l-eye-corner1-up.target",
    "target-moves-helpers-only data",
    "weights-not-normalized rigs/hm08/default_weights.mhw",
    "weights-too-many-influences rigs/hm08/default_weights.mhw",
];

/// What is only said of a mesh whose vertices are counted.
const OF_COUNTED_VERTICES: &[&str] = &[
    "base-vertex-count base/mh2bot/base.json",
    "weights-not-normalized rigs/mh2bot/default_weights.mhw",
];

/// What is only said of weights that could be read.
const OF_WEIGHTS: &[&str] = &[
    "weights-not-normalized rigs/hm08/default_weights.mhw",
    "weights-too-many-influences rigs/hm08/default_weights.mhw",
];

pub(crate) static CASES: &[Case] = &[
    case("a pointer of git lfs for a target", "mh2bot", &[Write("target/mh2bot/armslegs/upperarms-length-incr.target", b"version https://git-lfs.github.com/spec/v1\noid sha256:4d7a214614ab2935c943f9e0ff69d22eadbb8f32b1258daaa5e2ca24d17e2393\nsize 12345\n")], &["file-lfs-pointer target/mh2bot/armslegs/upperarms-length-incr.target"], &[]),
    case("Latin-1 in JSON", "mh2bot", &[Insert("target/mh2bot/target_cat.json", 1, b"\"\xe9\": 1,")], &["file-not-utf8 target/mh2bot/target_cat.json"], &[]),
    case("Latin-1 in the header of a target", "mh2bot", &[Insert("target/mh2bot/armslegs/upperarms-length-incr.target", 0, b"# J\xf6rg\n")], &["file-not-utf8 target/mh2bot/armslegs/upperarms-length-incr.target"], &[]),
    case("byte order mark in JSON", "mh2bot", &[Insert("target/mh2bot/modelling.json", 0, b"\xef\xbb\xbf")], &["file-byte-order-mark target/mh2bot/modelling.json"], &[]),
    case("byte order mark in a target", "mh2bot", &[Insert("target/mh2bot/armslegs/upperarms-length-incr.target", 0, b"\xef\xbb\xbf")], &["file-byte-order-mark target/mh2bot/armslegs/upperarms-length-incr.target"], &[]),
    case("packed target cut short", "mh2bot", &[Write("target/mh2bot/body/packed.target.gz", b"\x1f\x8b\x08\x00\x00")], &["file-gzip-corrupt target/mh2bot/body/packed.target.gz"], &[]),
    case("empty target", "mh2bot", &[Write("target/mh2bot/armslegs/upperarms-length-incr.target", b"")], &["file-empty target/mh2bot/armslegs/upperarms-length-incr.target"], &[]),
    case("empty weights", "mh2bot", &[Write("rigs/mh2bot/default_weights.mhw", b"")], &["file-empty rigs/mh2bot/default_weights.mhw"], &["weights-not-normalized rigs/mh2bot/default_weights.mhw"]),
    case("empty modelling.json", "mh2bot", &[Write("target/mh2bot/modelling.json", b"")], &["file-empty target/mh2bot/modelling.json"], &[]),
    case("twins that differ in case", "mh2bot", &[Write("target/mh2bot/body/Upperbody-width-incr.target", b"1 0 0 .1\n")], &["file-case-conflict target/mh2bot/body/upperbody-width-incr.target", "target-unreferenced target/mh2bot/body/Upperbody-width-incr.target"], &[]),
    case("a file in another case than its reference", "mh2bot", &[Rename("target/mh2bot/body/upperbody-width-incr.target", "target/mh2bot/body/Upperbody-width-incr.target")], &["file-case-mismatch target/mh2bot/modelling.json"], &[]),
    case("a name that Windows cannot hold", "mh2bot", &[Write("target/mh2bot/what?.txt", b"x")], &["file-unportable-name target/mh2bot/what?.txt"], &[]),
    case("backslash in a reference", "mh2bot", &[Replace("target/mh2bot/modelling.json", "body/upperbody-width-incr", "body\\\\upperbody-width-incr")], &["file-backslash-path target/mh2bot/modelling.json"], &[]),
    case("a reference that leaves the root", "mh2bot", &[Replace("target/mh2bot/modelling.json", "body/upperbody-width-incr", "../../../../upperbody-width-incr")], &["file-path-escape target/mh2bot/modelling.json"], &[]),
    case("an absolute reference", "mh2bot", &[Replace("target/mh2bot/modelling.json", "body/upperbody-width-incr", "/home/me/upperbody-width-incr")], &["file-absolute-path target/mh2bot/modelling.json"], &[]),
    case("the same displacement twice",
        "mh2bot",
        &[Copy("target/mh2bot/body/upperbody-width-incr.target", "target/mh2bot/body/upperbody-depth-incr.target")],
        &["file-duplicate-content target/mh2bot/body/upperbody-depth-incr.target"],
        &[],
    ),
    case("a folder where a file is expected", "mh2bot", &[Remove("target/mh2bot/modelling.json"), Write("target/mh2bot/modelling.json/x.txt", b"x")], &["file-in-place-of-folder target/mh2bot/modelling.json"], &[]),
    case("an icon nobody uses", "hm08", &[Write("target/hm08/icons/stray.png", b"\x89PNG\r\n\x1a\n")], &["file-unreferenced target/hm08/icons/stray.png"], &[]),
    case("modelling.json cut in the middle", "mh2bot", &[Cut("target/mh2bot/modelling.json", 700)], &["json-syntax target/mh2bot/modelling.json"], &[]),
    case("a comma too many", "mh2bot", &[Replace("base/mh2bot/base.json", "\"clothes\" ]", "\"clothes\", ]")], &["json-syntax base/mh2bot/base.json"], &["base-vertex-count base/mh2bot/base.json"]),
    case("a comment in JSON", "mh2bot", &[Replace("target/mh2bot/target_cat.json", "{", "{ // categories\n")], &["json-syntax target/mh2bot/target_cat.json"], &[]),
    case("a list for an object", "mh2bot", &[Write("target/mh2bot/target_cat.json", b"[]")], &["file-empty target/mh2bot/target_cat.json"], &[]),
    case("text for a number", "mh2bot", &[Replace("base/mh2bot/base.json", "7267", "\"many\"")], &["json-schema base/mh2bot/base.json"], &["base-vertex-count base/mh2bot/base.json"]),
    case("the same key twice", "mh2bot", &[Replace("target/mh2bot/modelling.json", "\"group\": \"main|arms\",", "\"group\": \"main|arms\", \"group\": \"main|arms\",")], &["json-duplicate-key target/mh2bot/modelling.json"], &[]),
    case("a misspelt key", "mh2bot", &[Replace("target/mh2bot/modelling.json", "\"name\": \"Upper Arms Length\",", "\"nmae\": \"Upper Arms Length\",")], &["json-unknown-key target/mh2bot/modelling.json"], &[]),
    case("a very deep document", "mh2bot", &[Write("target/mh2bot/target_cat.json", &DEEP)], &["json-too-deep target/mh2bot/target_cat.json"], &[]),
    case("a target that is gone", "mh2bot", &[Remove("target/mh2bot/body/upperbody-width-incr.target")], &["modelling-missing-target target/mh2bot/modelling.json"], &[]),
    case("a group of no category", "mh2bot", &[Replace("target/mh2bot/modelling.json", "\"main|arms\"", "\"main|armz\"")], &["modelling-unknown-group target/mh2bot/modelling.json"], &[]),
    case("a category without sliders", "mh2bot", &[Replace("target/mh2bot/target_cat.json", "\"items\": [", "\"items\": [ {\"title\": \"Tail\", \"cat\": \"tail\"},")], &["modelling-empty-category target/mh2bot/target_cat.json"], &[]),
    case("decr without incr", "mh2bot", &[Replace("target/mh2bot/modelling.json", ",\n                \"incr\": \"armslegs/upperarms-length-incr\"", "")], &["modelling-decr-only target/mh2bot/modelling.json"], &[]),
    case("default beyond the range", "hm08", &[Replace("target/hm08/modelling.json", "\"default\": 0.5", "\"default\": 50")], &["modelling-default-range target/hm08/modelling.json"], &[]),
    case("foreign code in a formula", "hm08", &[Replace("target/hm08/modelling.json", "round(val*100, 2)", "__import__('os').getcwd()")], &["modelling-unsafe-formula target/hm08/modelling.json"], &[]),
    case("foreign code in a random rule", "hm08", &[Replace("base/hm08/base.json", "x < 0.5", "open('x')")], &["base-unsafe-rule base/hm08/base.json"], &[]),
    case("text slot beyond the five", "hm08", &[Replace("target/hm08/modelling.json", "\"slot\": 3", "\"slot\": 9")], &["modelling-text-slot target/hm08/modelling.json"], &[]),
    case("a symmetry partner that does not exist", "hm08", &[Replace("target/hm08/modelling.json", "\"eyes/l-eye-bag-decr|incr\"", "\"eyes/l-eye-bog-decr|incr\"")], &["modelling-unknown-symmetry target/hm08/modelling.json"], &[]),
    case("a measure over a vertex that is not there", "hm08", &[Replace("target/hm08/modelling.json", "\"measure\": [8439", "\"measure\": [99999")], &["modelling-measure target/hm08/modelling.json"], &["modelling-measure target/hm08/modelling.json"]),
    case("an icon that is gone", "hm08", &[Remove("target/hm08/icons/nose-hump-decr-incr.png")], &["modelling-missing-icon target/hm08/modelling.json"], &[]),
    case("barycentric of two", "hm08", &[Replace("target/hm08/modelling.json", "[ \"macrodetails/African\", \"macrodetails/Asian\", \"macrodetails/Caucasian\"]", "[ \"macrodetails/African\", \"macrodetails/Asian\"]")], &["modelling-barycentric-arity target/hm08/modelling.json"], &[]),
    case("a pair without opposites", "mh2bot", &[Replace("base/mh2bot/base.json", "\"decr\": \"incr\"", "\"up\": \"down\"")], &["modelling-opposites target/mh2bot/modelling.json"], &[]),
    case("skeleton of another name", "mh2bot", &[Replace("base/mh2bot/base.json", "\"default.mhskel\"", "\"defualt.mhskel\"")], &["base-missing-file base/mh2bot/base.json"], &[]),
    case("equipment of another name", "mh2bot", &[Replace("base/mh2bot/base.json", "[ \"clothes\" ]", "[ \"clothings\" ]")], &["base-unknown-equipment base/mh2bot/base.json"], &[]),
    case("visible group of another name", "mh2bot", &[Replace("base/mh2bot/base.json", "\"mh_default\"", "\"mh_defualt\"")], &["base-unknown-equipment base/mh2bot/base.json"], &[]),
    case("preset of another name", "hm08", &[Replace("base/hm08/base.json", "\"breast/BreastSize\": 0.5", "\"breast/BreastSise\": 0.5")], &["base-unknown-preset base/hm08/base.json"], &[]),
    case("another vertex count", "hm08", &[Replace("base/hm08/base.json", "19158", "19157")], &["base-vertex-count base/hm08/base.json"], &[]),
    case("a geometry range moved", "hm08", &[Replace("base/hm08/geometry.json", "\"body\": [0, 13379]", "\"body\": [0, 13300]")], &["base-geometry-range base/hm08/geometry.json"], &[]),
    case("a word for a number", "mh2bot", &[Replace("target/mh2bot/armslegs/upperarms-length-incr.target", "1628 0 -3.303 0", "1628 0 down 0")], &["target-syntax target/mh2bot/armslegs/upperarms-length-incr.target"], &[]),
    case("comma for a point", "mh2bot", &[Replace("target/mh2bot/armslegs/upperarms-length-incr.target", "1628 0 -3.303 0", "1628 0 -3,303 0")], &["target-syntax target/mh2bot/armslegs/upperarms-length-incr.target"], &[]),
    case("a row of three", "mh2bot", &[Replace("target/mh2bot/armslegs/upperarms-length-incr.target", "1628 0 -3.303 0", "1628 0 -3.303")], &["target-field-count target/mh2bot/armslegs/upperarms-length-incr.target"], &[]),
    case("a negative index", "mh2bot", &[Replace("target/mh2bot/armslegs/upperarms-length-incr.target", "1628 0 -3.303 0", "-1628 0 -3.303 0")], &["target-negative-index target/mh2bot/armslegs/upperarms-length-incr.target"], &[]),
    case("an index beyond the mesh", "mh2bot", &[Replace("target/mh2bot/armslegs/upperarms-length-incr.target", "1628 0 -3.303 0", "7259 0 -3.303 0")], &["target-vertex-out-of-range target/mh2bot/armslegs/upperarms-length-incr.target"], &[]),
    case("a vertex twice", "mh2bot", &[Replace("target/mh2bot/armslegs/upperarms-length-incr.target", "1628 0 -3.303 0", "1628 0 -3.303 0\n1628 0 1 0")], &["target-duplicate-vertex target/mh2bot/armslegs/upperarms-length-incr.target"], &[]),
    case("NaN in a target", "mh2bot", &[Replace("target/mh2bot/armslegs/upperarms-length-incr.target", "1628 0 -3.303 0", "1628 0 nan 0")], &["target-non-finite target/mh2bot/armslegs/upperarms-length-incr.target"], &[]),
    case("1e400 in a target", "mh2bot", &[Replace("target/mh2bot/armslegs/upperarms-length-incr.target", "1628 0 -3.303 0", "1628 0 1e400 0")], &["target-non-finite target/mh2bot/armslegs/upperarms-length-incr.target"], &[]),
    case("a displacement of a million", "mh2bot", &[Replace("target/mh2bot/armslegs/upperarms-length-incr.target", "1628 0 -3.303 0", "1628 0 1000000 0")], &["target-oversized-delta target/mh2bot/armslegs/upperarms-length-incr.target"], &[]),
    case("a row that moves nothing", "mh2bot", &[Replace("target/mh2bot/armslegs/upperarms-length-incr.target", "1628 0 -3.303 0", "1628 0 0 0")], &["target-zero-delta target/mh2bot/armslegs/upperarms-length-incr.target"], &[]),
    case("a target of zeros", "mh2bot", &[Write("target/mh2bot/armslegs/upperarms-length-incr.target", b"1628 0 0 0\n1629 0 0 0\n")], &["target-without-effect target/mh2bot/armslegs/upperarms-length-incr.target"], &[]),
    case("header of another base mesh", "mh2bot", &[Insert("target/mh2bot/armslegs/upperarms-length-incr.target", 0, b"# basemesh hm08\n")], &["target-basemesh-mismatch target/mh2bot/armslegs/upperarms-length-incr.target"], &[]),
    case("a target that nobody uses", "mh2bot", &[Write("target/mh2bot/body/stray.target", b"1 0 0 .1\n")], &["target-unreferenced target/mh2bot/body/stray.target"], &[]),
    case("an archive that is none", "mh2bot", &[Write("target/mh2bot/compressedtargets.npz", b"PK\x03\x04 no zip")], &["archive-malformed target/mh2bot/compressedtargets.npz"], &[]),
    case("a face over a missing vertex", "mh2bot", &[Replace("base/mh2bot/base.obj", "f 111/1 ", "f 99111/1 ")], &["mesh-face-out-of-range base/mh2bot/base.obj"], OF_COUNTED_VERTICES),
    case("a face without texture coordinates", "mh2bot", &[Replace("base/mh2bot/base.obj", "f 111/1 112/2 115/3 114/4", "f 111 112 115 114")], &["mesh-partial-uv base/mh2bot/base.obj"], &[]),
    case("NaN in the mesh", "mh2bot", &[Replace("base/mh2bot/base.obj", "v 1.992549 3.499722 -2.280204", "v nan 3.499722 -2.280204")], &["mesh-non-finite base/mh2bot/base.obj"], &[]),
    case("a word in a vertex", "mh2bot", &[Replace("base/mh2bot/base.obj", "v 1.992549 3.499722 -2.280204", "v here 3.499722 -2.280204")], &["mesh-syntax base/mh2bot/base.obj"], OF_COUNTED_VERTICES),
    case("a parent that does not exist", "mh2bot", &[Replace("rigs/mh2bot/default.mhskel", "\"parent\": \"hand.L\"", "\"parent\": \"hnd.L\"")], &["skeleton-unknown-parent rigs/mh2bot/default.mhskel"], &[]),
    case(
        "a bone that is its own parent",
        "mh2bot",
        &[Replace("rigs/mh2bot/default.mhskel", "\"parent\": \"finger1.2.L\"", "\"parent\": \"finger1.3.L\"")],
        &["skeleton-cycle rigs/mh2bot/default.mhskel"],
        &[],
    ),
    case("a joint that does not exist", "mh2bot", &[Replace("rigs/mh2bot/default.mhskel", "\"head\": \"eyebrow.L___head\"", "\"head\": \"eyebrow.L__head\"")], &["skeleton-unknown-joint rigs/mh2bot/default.mhskel"], &[]),
    case("a joint without vertices", "mh2bot", &[Replace("rigs/mh2bot/default.mhskel", "[3108, 3110]", "[]")], &["skeleton-empty-joint rigs/mh2bot/default.mhskel"], &[]),
    case("a joint beyond the mesh", "mh2bot", &[Replace("rigs/mh2bot/default.mhskel", "[3108, 3110]", "[3108, 99999]")], &["skeleton-joint-out-of-range rigs/mh2bot/default.mhskel"], &[]),
    case("weights file of another name", "mh2bot", &[Replace("rigs/mh2bot/default.mhskel", "\"default_weights.mhw\"", "\"defualt_weights.mhw\"")], &["skeleton-missing-weights rigs/mh2bot/default.mhskel"], &[]),
    case("a plane of another name", "hm08", &[Replace("rigs/hm08/default.mhskel", "\"rotation_plane\": \"clavicle.L____plane\"", "\"rotation_plane\": \"clavicle.L___plane\"")], &["skeleton-unknown-plane rigs/hm08/default.mhskel"], &[]),
    case("a plane of two points", "hm08", &[Replace("rigs/hm08/default.mhskel", "\"lowerarm01.L____tail\",\n            \"lowerarm01.L____head\",\n            \"upperarm02.L____head\"", "\"lowerarm01.L____tail\",\n            \"lowerarm01.L____head\"")], &["skeleton-malformed-plane rigs/hm08/default.mhskel"], &[]),
    case("weights for a bone that does not exist", "mh2bot", &[Replace("rigs/mh2bot/default_weights.mhw", "\"eyebrow.L\":", "\"eyebrwo.L\":")], &["weights-unknown-bone rigs/mh2bot/default_weights.mhw"], &[]),
    case("a negative weight", "mh2bot", &[Replace("rigs/mh2bot/default_weights.mhw", "[3082, 1.0]", "[3082, -1.0]")], &["weights-negative rigs/mh2bot/default_weights.mhw"], &[]),
    case("NaN for a weight", "mh2bot", &[Replace("rigs/mh2bot/default_weights.mhw", "[3082, 1.0]", "[3082, NaN]")], &["weights-non-finite rigs/mh2bot/default_weights.mhw"], &[]),
    case("a weight above one", "mh2bot", &[Replace("rigs/mh2bot/default_weights.mhw", "[3132, 0.9]", "[3132, 9.0]")], &["weights-above-one rigs/mh2bot/default_weights.mhw"], &[]),
    case("a weight too small to count", "mh2bot", &[Replace("rigs/mh2bot/default_weights.mhw", "[3082, 1.0],", "[3082, 1.0], [9, 0.00001],")], &["weights-below-threshold rigs/mh2bot/default_weights.mhw"], &[]),
    case("a vertex twice in a bone", "mh2bot", &[Replace("rigs/mh2bot/default_weights.mhw", "[3082, 1.0],", "[3082, 0.5], [3082, 0.5],")], &["weights-duplicate-vertex rigs/mh2bot/default_weights.mhw"], &[]),
    case("a weight beyond the mesh", "mh2bot", &[Replace("rigs/mh2bot/default_weights.mhw", "[3082, 1.0]", "[3082, 1.0], [99999, 1.0]")], &["weights-vertex-out-of-range rigs/mh2bot/default_weights.mhw"], &[]),
    case("a pair of three", "mh2bot", &[Replace("rigs/mh2bot/default_weights.mhw", "[3082, 1.0]", "[3082, 1.0, 1.0]")], &["weights-malformed-pair rigs/mh2bot/default_weights.mhw"], &[]),
    case("a vertex without weight", "mh2bot", &[Replace("rigs/mh2bot/default_weights.mhw", "[3082, 1.0], ", "")], &["weights-unweighted-vertex rigs/mh2bot/default_weights.mhw"], &[]),
    case("steps and values of different length", "hm08", &[Replace("target/hm08/macro.json", "\"steps\": [0.0, 0.1875, 0.5, 1.0]", "\"steps\": [0.0, 0.5, 1.0]")], &["macro-steps-length target/hm08/macro.json"], OF_ABSENT_COMBINATIONS),
    case("steps out of order", "hm08", &[Replace("target/hm08/macro.json", "\"steps\": [0.0, 0.1875, 0.5, 1.0]", "\"steps\": [0.0, 0.5, 0.1875, 1.0]")], &["macro-steps-order target/hm08/macro.json"], &[]),
    case("steps that end early", "hm08", &[Replace("target/hm08/macro.json", "\"steps\": [0.0, 0.1875, 0.5, 1.0]", "\"steps\": [0.0, 0.1875, 0.5, 0.9]")], &["macro-steps-range target/hm08/macro.json"], &[]),
    case("steps beside a sum", "hm08", &[Replace("target/hm08/macro.json", "\"sum\": [", "\"steps\": [0.0, 0.5, 1.0], \"sum\": [")], &["macro-steps-and-sum target/hm08/macro.json"], &[]),
    case("a sum of two", "hm08", &[Replace("target/hm08/macro.json", "[\"African\", \"Asian\", \"Caucasian\"]", "[\"African\", \"Asian\"]")], &["macro-sum-arity target/hm08/macro.json"], &[]),
    case("a component of no macrodef", "hm08", &[Replace("target/hm08/macro.json", "\"firmness\":  {", "\"spare\": {\"values\": [\"a\", \"b\"], \"steps\": [0.0, 1.0], \"pattern\": \"breast/BreastSize\" },\n\"firmness\":  {")], &["macro-unused-component target/hm08/macro.json"], &[]),
    case("a pattern of no slider", "hm08", &[Replace("target/hm08/macro.json", "\"macrodetails/Age\"", "\"macrodetails/Aeg\"")], &["macro-unknown-pattern target/hm08/macro.json"], OF_ABSENT_COMBINATIONS),
    case("a component that is not defined", "hm08", &[Replace("target/hm08/macro.json", "\"comp\": [ \"phenotype\", \"gender\", \"age\" ]", "\"comp\": [ \"phenotype\", \"gender\", \"aeg\" ]")], &["macro-unknown-component target/hm08/macro.json"], &[]),
    case("a component twice", "hm08", &[Replace("target/hm08/macro.json", "\"comp\": [ \"phenotype\", \"gender\", \"age\" ]", "\"comp\": [ \"phenotype\", \"gender\", \"age\", \"age\" ]")], &["macro-repeated-component target/hm08/macro.json"], &[]),
    case("a folder of another name", "hm08", &[Replace("target/hm08/macro.json", "\"folder\": \"macro_age\"", "\"folder\": \"macro_aeg\"")], &["macro-folder-missing target/hm08/macro.json"], &[]),
    case("a combination that is left out", "hm08", &[Replace("target/hm08/macro.json", "{ \"name\": \"african-female-baby\",\t\"t\": \"african-female-baby\" },", "")], &["macro-missing-combination target/hm08/macro.json"], &[]),
    case("a combination out of order", "hm08", &[Replace("target/hm08/macro.json", "\"name\": \"african-female-baby\"", "\"name\": \"african-baby-female\"")], &["macro-unexpected-combination target/hm08/macro.json"], &[]),
    case("a combination twice", "hm08", &[Replace("target/hm08/macro.json", "{ \"name\": \"african-female-baby\",\t\"t\": \"african-female-baby\" },", "{ \"name\": \"african-female-baby\",\t\"t\": \"african-female-baby\" }, { \"name\": \"african-female-baby\",\t\"t\": \"african-female-baby\" },")], &["macro-duplicate-combination target/hm08/macro.json"], &[]),
    case("a macro target that is gone", "hm08", &[Remove("target/hm08/macro_age/african-female-baby.target")], &["macro-missing-target target/hm08/macro.json"], &[]),
    case("a macro target with its extension", "hm08", &[Replace("target/hm08/macro.json", "\"t\": \"african-female-baby\"", "\"t\": \"african-female-baby.target\"")], &["macro-target-extension target/hm08/macro.json"], &[]),
    case("an influence beyond the macrodefs", "hm08", &[Replace("target/hm08/modelling.json", "\"macro_influence\": [3]", "\"macro_influence\": [3, 9]")], &["macro-influence-range target/hm08/modelling.json"], &[]),
    case("an influence that is left out", "hm08", &[Replace("target/hm08/modelling.json", "\"macro_influence\": [0, 1, 2, 3, 4]", "\"macro_influence\": [0, 1, 2, 3]")], &["macro-influence-mismatch target/hm08/modelling.json"], &[]),
    case("barycentric in another order", "hm08", &[Replace("target/hm08/macro.json", "[\"African\", \"Asian\", \"Caucasian\"]", "[\"Asian\", \"African\", \"Caucasian\"]")], &["macro-barycentric-mismatch target/hm08/macro.json"], &[]),
    case("half of a pair", "hm08", &[Remove("target/hm08/ears/l-ear-flap-incr.target")], &["modelling-missing-target target/hm08/modelling.json"], &[]),
    case("a contarget macro.json that is broken", "hm08", &[Write("contarget/hm08/macro.json", b"{")], &["overlay-broken-override contarget/hm08/macro.json"], &[]),
    case("contarget categories alone",
        "hm08",
        &[Copy("target/hm08/target_cat.json", "contarget/hm08/target_cat.json")],
        &[
            "overlay-partial-override contarget/hm08/target_cat.json",
        ],
        &[],
    ),
    case("a category that is an empty object", "mh2bot", &[Replace("target/mh2bot/target_cat.json", "\"Main\": {", "\"Tail\": {},\n\"Main\": {")], &["modelling-empty-category target/mh2bot/target_cat.json"], &[]),
    case("the only category without anything", "mh2bot", &[Write("target/mh2bot/target_cat.json", b"{\"Main\": {}}")], &["modelling-unknown-group target/mh2bot/modelling.json"], &[]),
    case("base.json in other capitals", "mh2bot", &[Rename("base/mh2bot/base.json", "base/mh2bot/Base.json")], &["file-case-mismatch base/mh2bot/Base.json"], &["base-vertex-count base/mh2bot/base.json"]),
    case("base.obj in other capitals", "mh2bot", &[Rename("base/mh2bot/base.obj", "base/mh2bot/base.OBJ")], &["file-case-mismatch base/mh2bot/base.OBJ"], OF_COUNTED_VERTICES),
    case("base.mhm in other capitals", "mh2bot", &[Rename("base/mh2bot/base.mhm", "base/mh2bot/Base.mhm")], &["file-case-mismatch base/mh2bot/base.json"], &[]),
    case("a skeleton in other capitals", "mh2bot", &[Rename("rigs/mh2bot/default.mhskel", "rigs/mh2bot/Default.mhskel")], &["file-case-mismatch base/mh2bot/base.json"], &[]),
    case("weights in other capitals", "mh2bot", &[Rename("rigs/mh2bot/default_weights.mhw", "rigs/mh2bot/Default_weights.mhw")], &["file-case-mismatch rigs/mh2bot/default.mhskel", "weights-not-normalized rigs/mh2bot/Default_weights.mhw"], &["weights-not-normalized rigs/mh2bot/default_weights.mhw"]),
    case("target_cat.json in other capitals", "mh2bot", &[Rename("target/mh2bot/target_cat.json", "target/mh2bot/Target_cat.json")], &["file-case-mismatch target/mh2bot/Target_cat.json"], &[]),
    case("misspelt planes", "hm08", &[Replace("rigs/hm08/default.mhskel", "\"planes\": {", "\"plnes\": {")], &["skeleton-unknown-plane rigs/hm08/default.mhskel"], &[]),
    case("a contarget macro.json in other capitals", "hm08", &[Copy("target/hm08/macro.json", "contarget/hm08/Macro.json")], &["file-case-mismatch contarget/hm08/Macro.json"], &[]),
    case("a contarget macro.json in other capitals beside its sliders", "hm08", &[Copy("target/hm08/macro.json", "contarget/hm08/Macro.json"), Copy("target/hm08/modelling.json", "contarget/hm08/modelling.json")], &["file-case-mismatch contarget/hm08/Macro.json", "modelling-measure contarget/hm08/modelling.json ×3"], &["modelling-measure target/hm08/modelling.json ×3"]),
    case("macro.json in other capitals", "hm08", &[Rename("target/hm08/macro.json", "target/hm08/Macro.json")], &["file-case-mismatch target/hm08/Macro.json"], OF_MACROS),
    case("macro.json that is gone", "hm08", &[Remove("target/hm08/macro.json")], &["base-missing-file target/hm08/macro.json"], OF_MACROS),
    case("modelling.json that is gone", "hm08", &[Remove("target/hm08/modelling.json")], &["base-missing-file target/hm08/modelling.json"], &["base-unknown-preset base/hm08/base.json", "file-unreferenced target/hm08/icons", "macro-missing-combination target/hm08/macro.json ×3", "modelling-measure target/hm08/modelling.json ×3"]),
    case("target_cat.json that is gone", "hm08", &[Remove("target/hm08/target_cat.json")], &["modelling-unknown-group target/hm08/modelling.json"], &[]),
    case("decr that is gone from a pair with a partner", "hm08", &[Replace("target/hm08/modelling.json", "\"decr\": \"eyes/l-eye-bag-decr\",", "")], &["modelling-unknown-symmetry target/hm08/modelling.json"], &[]),
    case("incr that is gone from a pair with a partner", "hm08", &[Replace("target/hm08/modelling.json", "\"incr\": \"eyes/l-eye-bag-incr\",", "")], &["modelling-decr-only target/hm08/modelling.json"], &[]),
    case("decr that is gone from a pair", "hm08", &[Replace("target/hm08/modelling.json", "\"decr\": \"nose/nose-hump-decr\",", "")], &["target-unreferenced target/hm08/nose/nose-hump-decr.target"], &[]),
    case("a slider that is gone", "hm08", &[Replace("target/hm08/modelling.json", "\"Nose Hump\": {\n\t\t\"name\": \"Hump\",\n\t\t\"group\": \"face|nose features\",\n\t\t\"icon\": \"nose-hump-decr-incr.png\",\n\t\t\"decr\": \"nose/nose-hump-decr\",\n\t\t\"incr\": \"nose/nose-hump-incr\"\n\t},", "")], &["target-unreferenced target/hm08/nose/nose-hump-incr.target"], &[]),
    case("an unnormalised vertex beside thousands", "hm08", &[Replace("rigs/hm08/default_weights.mhw", "[66, 1.0]", "[66, 0.5]")], &["weights-not-normalized rigs/hm08/default_weights.mhw"], &[]),
    case("an unused macro target beside others", "hm08", &[Write("target/hm08/macro_fembreast/stray.target", b"1 0 0 .1\n")], &["macro-unreferenced-target target/hm08/macro_fembreast/stray.target"], &[]),
    case("a suspect alias beside others", "hm08", &[Replace("target/hm08/macro.json", "\"t\": \"child-minmuscle-averageweight-maxcup-averagefirmness\"", "\"t\": \"child-minmuscle-maxweight-maxcup-averagefirmness\"")], &["macro-alias-suspect target/hm08/macro.json"], &[]),
    case("a missing combination beside hundreds", "hm08", &[Replace("target/hm08/macro.json", "{ \"name\": \"female-child-minmuscle-averageweight-maxcup-averagefirmness\",\t\"t\": \"child-minmuscle-averageweight-maxcup-averagefirmness\" },", "")], &["macro-missing-combination target/hm08/macro.json"], &[]),
    case("a third target of the same displacement", "hm08", &[Copy("target/hm08/armslegs/upperlegs-height-incr.target", "target/hm08/armslegs/upperlegs-height-decr.target")], &["file-duplicate-content target/hm08/armslegs/upperlegs-height-decr.target"], &["file-duplicate-content target/hm08/armslegs/upperlegs-height-incr.target"]),
    case("line ends of Windows", "mh2bot", &[Replace("target/mh2bot/armslegs/upperarms-length-incr.target", "1628 0 -3.303 0\n", "1628 0 -3.303 0\r\n")], &[], &[]),
];

/// Damage checked with evaluation. A case runs once every rule that it expects exists.
pub(crate) static NUMERIC: &[Case] = &[
    case(
        "a NaN is no matter of the settings",
        "hm08",
        &[Replace(
            "target/hm08/nose/nose-hump-incr.target",
            "109 0 -.008 0",
            "109 0 nan 0",
        )],
        &["target-non-finite target/hm08/nose/nose-hump-incr.target"],
        &[],
    ),
    case(
        "a displacement of a million is no matter of the settings",
        "hm08",
        &[Replace(
            "target/hm08/nose/nose-hump-incr.target",
            "109 0 -.008 0",
            "109 0 1000000 0",
        )],
        &["target-oversized-delta target/hm08/nose/nose-hump-incr.target"],
        &[],
    ),
    case(
        "steps that leave a dead range",
        "hm08",
        &[Replace(
            "target/hm08/macro.json",
            "[0.0, 0.1875, 0.5, 1.0]",
            "[0.0, 0.1875, 0.5, 0.9]",
        )],
        &["macro-steps-range target/hm08/macro.json"],
        &["numeric-dead-range target/hm08/macro.json ×2"],
    ),
    case(
        "a torn joint cube",
        "hm08",
        &[Replace(
            "target/hm08/nose/nose-hump-incr.target",
            "109 0 -.008 0",
            "109 0 -.008 0\n13654 0 0.5 0",
        )],
        &["target-splits-joint-cube target/hm08/nose/nose-hump-incr.target"],
        &[],
    ),
    case(
        "a left target that is not the mirror of the right one",
        "hm08",
        &[Replace(
            "target/hm08/ears/l-ear-flap-incr.target",
            "7565 -.003 -.001 -.003",
            "7565 -.003 -.5 -.003",
        )],
        &["target-asymmetric-pair target/hm08/ears/l-ear-flap-incr.target"],
        &[],
    ),
    case(
        "a plane whose joints lie in a line",
        "hm08",
        &[
            Replace(
                "rigs/hm08/default.mhskel",
                "\"joints\": {\n",
                "\"joints\": {\n\"middle\": [14062, 14063, 14064, 14065, 14066, 14067, 14068, 14069, \
                 14502, 14503, 14504, 14505, 14506, 14507, 14508, 14509],\n",
            ),
            Replace(
                "rigs/hm08/default.mhskel",
                "\"head____plane\": [\n            \"special01____tail\",            \n            \"head____tail\",\n            \
                 \"head____head\"",
                "\"head____plane\": [\"clavicle.L____tail\", \"middle\", \"clavicle.R____tail\"",
            ),
        ],
        &["skeleton-degenerate-plane rigs/hm08/default.mhskel"],
        &[],
    ),
    case(
        "a bone without length in a baby alone",
        "hm08",
        &[Move(
            "target/hm08/macro_age/caucasian-female-baby.target",
            &[
                (13646, [0.0, -0.43295, -0.01295]),
                (13647, [0.0, -0.43295, -0.01295]),
                (13648, [0.0, -0.43295, -0.01295]),
                (13649, [0.0, -0.43295, -0.01295]),
                (13650, [0.0, -0.43295, -0.01295]),
                (13651, [0.0, -0.43295, -0.01295]),
                (13652, [0.0, -0.43295, -0.01295]),
                (13653, [0.0, -0.43295, -0.01295]),
            ],
        )],
        &["numeric-zero-length-bone target/hm08/macro_age/caucasian-female-baby.target"],
        &[],
    )
    .saying("macrodetails/Age = 0"),
    case(
        "a face that collapses at one corner alone",
        "hm08",
        &[Move(
            "target/hm08/macro_muscle/male-old-maxmuscle-maxweight.target",
            &[
                (10951, [-0.07421, -0.10703, 0.02848]),
                (10949, [0.11221, -0.11687, -0.11193]),
                (10954, [0.08372, 0.13863, 0.00719]),
                (10956, [-0.12172, 0.08526, 0.07627]),
                (4322, [0.07421, -0.10703, 0.02848]),
                (4320, [-0.11221, -0.11687, -0.11193]),
                (4326, [-0.08372, 0.13863, 0.00719]),
                (4328, [0.12172, 0.08526, 0.07627]),
            ],
        )],
        &["numeric-collapsed-faces target/hm08/macro_muscle/male-old-maxmuscle-maxweight.target"],
        &[],
    )
    .saying("macrodetails-universal/Muscle = 1, macrodetails-universal/Weight = 1"),
    case(
        "a side that moves nothing",
        "hm08",
        &[Zero(
            "target/hm08/nose/nose-point-width-incr.target",
            &[
                274, 275, 276, 277, 278, 279, 280, 289, 290, 292, 293, 295, 296, 300, 338, 899,
                5050, 5052, 5053, 5057, 5070,
            ],
        )],
        // Without the zero rows, which say nothing, the target is as uneven.
        &[
            "target-asymmetric target/hm08/nose/nose-point-width-incr.target",
            "target-zero-delta target/hm08/nose/nose-point-width-incr.target",
        ],
        &[],
    ),
    case(
        "evaluated: macro.json that is gone",
        "hm08",
        &[Remove("target/hm08/macro.json")],
        &["base-missing-file target/hm08/macro.json"],
        OF_EVALUATED_MACROS,
    ),
    case(
        "evaluated: macro.json cut in the middle",
        "hm08",
        &[Cut("target/hm08/macro.json", 4000)],
        &["json-syntax target/hm08/macro.json"],
        OF_EVALUATED_MACROS,
    ),
    case(
        "evaluated: modelling.json that is gone",
        "hm08",
        &[Remove("target/hm08/modelling.json")],
        &["base-missing-file target/hm08/modelling.json"],
        OF_SLIDERS,
    ),
    case(
        "evaluated: modelling.json cut in the middle",
        "hm08",
        &[Cut("target/hm08/modelling.json", 4000)],
        &["json-syntax target/hm08/modelling.json"],
        OF_SLIDERS,
    ),
    case(
        "evaluated: a slider that is gone",
        "hm08",
        &[Replace(
            "target/hm08/modelling.json",
            "\"Nose Hump\": {\n\t\t\"name\": \"Hump\",\n\t\t\"group\": \"face|nose features\",\n\t\t\"icon\": \"nose-hump-decr-incr.png\",\n\t\t\"decr\": \"nose/nose-hump-decr\",\n\t\t\"incr\": \"nose/nose-hump-incr\"\n\t},",
            "",
        )],
        &["target-unreferenced target/hm08/nose/nose-hump-incr.target"],
        &[],
    ),
    case(
        "evaluated: a misspelt pattern",
        "hm08",
        &[Replace(
            "target/hm08/modelling.json",
            "\"macro\": \"macrodetails/Age\"",
            "\"macro\": \"macrodetails/Aeg\"",
        )],
        &["macro-unknown-pattern target/hm08/macro.json"],
        OF_COMBINATIONS,
    ),
    case(
        "evaluated: a default beyond the range",
        "hm08",
        &[Replace(
            "target/hm08/modelling.json",
            "\"default\": 0.5",
            "\"default\": 50",
        )],
        &["modelling-default-range target/hm08/modelling.json"],
        &[],
    ),
    case(
        "evaluated: half of a pair",
        "hm08",
        &[Remove("target/hm08/ears/l-ear-flap-incr.target")],
        &["modelling-missing-target target/hm08/modelling.json"],
        &[],
    ),
    case(
        "evaluated: a macro target that is gone",
        "hm08",
        &[Remove("target/hm08/macro_age/african-female-baby.target")],
        &["macro-missing-target target/hm08/macro.json"],
        &[],
    ),
    case(
        "evaluated: an empty macro target",
        "hm08",
        &[Write(
            "target/hm08/macro_age/african-female-baby.target",
            b"",
        )],
        &["macro-empty-target target/hm08/macro.json"],
        &[],
    ),
    case(
        "evaluated: a word in a macro target",
        "hm08",
        &[Write(
            "target/hm08/macro_age/african-female-baby.target",
            b"1 2 x 3\n",
        )],
        &["target-syntax target/hm08/macro_age/african-female-baby.target"],
        &[],
    ),
    case(
        "evaluated: an index beyond the mesh",
        "hm08",
        &[Write(
            "target/hm08/macro_age/african-female-baby.target",
            b"99999 2 1 3\n",
        )],
        &["target-vertex-out-of-range target/hm08/macro_age/african-female-baby.target"],
        &[],
    ),
    case(
        "evaluated: an empty detail target",
        "hm08",
        &[Write("target/hm08/ears/l-ear-flap-incr.target", b"")],
        &["file-empty target/hm08/ears/l-ear-flap-incr.target"],
        &[],
    ),
    case(
        "evaluated: a vertex twice",
        "hm08",
        &[Replace(
            "target/hm08/nose/nose-hump-incr.target",
            "109 0 -.008 0",
            "109 0 -.008 0\n109 0 -.008 0",
        )],
        &["target-duplicate-vertex target/hm08/nose/nose-hump-incr.target"],
        &[],
    ),
    case(
        "evaluated: a negative weight",
        "hm08",
        &[Replace(
            "rigs/hm08/default_weights.mhw",
            "[1399, 0.016]",
            "[1399, -0.5]",
        )],
        &["weights-negative rigs/hm08/default_weights.mhw"],
        &[],
    ),
    case(
        "evaluated: NaN for a weight",
        "hm08",
        &[Replace(
            "rigs/hm08/default_weights.mhw",
            "[1399, 0.016]",
            "[1399, NaN]",
        )],
        &["weights-non-finite rigs/hm08/default_weights.mhw"],
        &[],
    ),
    case(
        "evaluated: weights cut in the middle",
        "hm08",
        &[Cut("rigs/hm08/default_weights.mhw", 90000)],
        &["json-syntax rigs/hm08/default_weights.mhw"],
        OF_WEIGHTS,
    ),
    case(
        "evaluated: weights that are gone",
        "hm08",
        &[Remove("rigs/hm08/default_weights.mhw")],
        &["skeleton-missing-weights rigs/hm08/default.mhskel"],
        OF_WEIGHTS,
    ),
    case(
        "evaluated: weights for a bone that does not exist",
        "hm08",
        &[Replace(
            "rigs/hm08/default_weights.mhw",
            "\"breast.L\":",
            "\"brest.L\":",
        )],
        &["weights-unknown-bone rigs/hm08/default_weights.mhw"],
        &[],
    ),
    case(
        "evaluated: the skeleton is gone",
        "hm08",
        &[Remove("rigs/hm08/default.mhskel")],
        &["base-missing-file base/hm08/base.json"],
        &["weights-too-many-influences rigs/hm08/default_weights.mhw"],
    ),
    case(
        "evaluated: a joint that does not exist",
        "hm08",
        &[Replace(
            "rigs/hm08/default.mhskel",
            "\"head\": \"breast.L____head\"",
            "\"head\": \"breast.L___head\"",
        )],
        &["skeleton-unknown-joint rigs/hm08/default.mhskel"],
        &["weights-too-many-influences rigs/hm08/default_weights.mhw"],
    ),
    case(
        "evaluated: a joint beyond the mesh",
        "hm08",
        &[Replace(
            "rigs/hm08/default.mhskel",
            "14030, 14031",
            "14030, 99999",
        )],
        &["skeleton-joint-out-of-range rigs/hm08/default.mhskel"],
        &["weights-too-many-influences rigs/hm08/default_weights.mhw"],
    ),
    case(
        "evaluated: a parent that does not exist",
        "hm08",
        &[Replace(
            "rigs/hm08/default.mhskel",
            "\"parent\": \"spine01\"",
            "\"parent\": \"spin01\"",
        )],
        &["skeleton-unknown-parent rigs/hm08/default.mhskel"],
        &["weights-too-many-influences rigs/hm08/default_weights.mhw"],
    ),
    case(
        "evaluated: tail at head",
        "hm08",
        &[Replace(
            "rigs/hm08/default.mhskel",
            "\"tail\": \"breast.L____tail\"",
            "\"tail\": \"breast.L____head\"",
        )],
        &["skeleton-zero-length-bone rigs/hm08/default.mhskel"],
        &[],
    ),
    case(
        "evaluated: misspelt planes",
        "hm08",
        &[Replace(
            "rigs/hm08/default.mhskel",
            "\"planes\": {",
            "\"plnes\": {",
        )],
        &["skeleton-unknown-plane rigs/hm08/default.mhskel"],
        &["weights-too-many-influences rigs/hm08/default_weights.mhw"],
    ),
    case(
        "evaluated: a mesh with a word",
        "hm08",
        &[Replace("base/hm08/base.obj", "\nv ", "\nv x")],
        &["mesh-syntax base/hm08/base.obj"],
        OF_MESH,
    ),
    case(
        "evaluated: a mesh that is gone",
        "hm08",
        &[Remove("base/hm08/base.obj")],
        &["base-missing-file base/hm08/base.json"],
        OF_MESH,
    ),
    case(
        "evaluated: base.json that is gone",
        "hm08",
        &[Remove("base/hm08/base.json")],
        &["base-missing-file base/hm08/base.json"],
        &[
            "base-unknown-preset base/hm08/base.json",
            "target-asymmetric data",
            "target-moves-helpers-only data",
            "weights-too-many-influences rigs/hm08/default_weights.mhw",
        ],
    ),
    case(
        "evaluated: steps out of order",
        "hm08",
        &[Replace(
            "target/hm08/macro.json",
            "\"steps\": [0.0, 0.1875, 0.5, 1.0]",
            "\"steps\": [0.0, 0.5, 0.1875, 1.0]",
        )],
        &["macro-steps-order target/hm08/macro.json"],
        &["numeric-dead-range target/hm08/macro.json ×2"],
    ),
    case(
        "evaluated: a pattern of no slider",
        "hm08",
        &[Replace(
            "target/hm08/macro.json",
            "\"macrodetails/Age\"",
            "\"macrodetails/Aeg\"",
        )],
        &["macro-unknown-pattern target/hm08/macro.json"],
        OF_COMBINATIONS,
    ),
    case(
        "evaluated: a folder of another name",
        "hm08",
        &[Replace(
            "target/hm08/macro.json",
            "\"folder\": \"macro_age\"",
            "\"folder\": \"macro_aeg\"",
        )],
        &["macro-folder-missing target/hm08/macro.json"],
        &[],
    ),
    case(
        "evaluated: a combination out of order",
        "hm08",
        &[Replace(
            "target/hm08/macro.json",
            "\"name\": \"african-female-baby\"",
            "\"name\": \"african-baby-female\"",
        )],
        &["macro-unexpected-combination target/hm08/macro.json"],
        &[],
    ),
    case(
        "evaluated: an uneven vertex in a pair that is uneven already",
        "hm08",
        &[Replace(
            "target/hm08/eyes/l-eye-corner1-up.target",
            "6790 .001 .006 0",
            "6790 .001 .106 0",
        )],
        &["target-asymmetric-pair target/hm08/eyes/l-eye-corner1-up.target"],
        &[],
    ),
    case(
        "evaluated: an uneven target beside others",
        "hm08",
        &[Replace(
            "target/hm08/nose/nose-hump-incr.target",
            "109 0 -.008 0",
            "109 0 -.058 0",
        )],
        &["target-asymmetric target/hm08/nose/nose-hump-incr.target"],
        &[],
    ),
    case(
        "evaluated: a target without body beside others",
        "hm08",
        &[Copy(
            "target/hm08/genitals/penis-length-incr.target",
            "target/hm08/nose/nose-hump-incr.target",
        )],
        &[
            "file-duplicate-content target/hm08/genitals/penis-length-incr.target",
            "target-moves-helpers-only target/hm08/nose/nose-hump-incr.target",
            "target-oversized-delta target/hm08/nose/nose-hump-incr.target",
        ],
        &[],
    ),
];
