//! What the applications make of paths: one [`Layout`] each.

pub(super) mod makehuman1;
pub(super) mod makehuman2;
pub(super) mod mpfb;

use mpfb::importer::Refusal;
use xxhash_rust::xxh3::xxh3_64;

use super::listing::Listing;
use super::paths::Paths;
use super::{Candidate, Kind, Use, extension};
use mhlint_diag::Application;
use mhlint_source::{depth, folder_and_name, folders_above, parent};

/// How an application lays out its data folders: what their paths say, without a look into a file.
#[derive(Debug)]
pub struct Layout {
    /// Whose layout it is.
    pub application: Application,
    /// What tells its data folder, for people.
    pub shape: &'static str,
    /// Levels below a data root on which its signs stand.
    pub depth: usize,
    /// Folders at the top of a data root.
    folders: &'static [&'static [&'static str]],
    /// Whether a path is a sign of a data root, how telling, and how many levels above the root is.
    sign: fn(&[&str]) -> Option<(Sign, usize)>,
    /// What such a sign is worth, with what lies around it: of a data root, the file, and what it
    /// was taken for.
    weigh: fn(&Listing<'_>, &str, &str, Sign) -> Option<Sign>,
    /// The version that the data of a program are of, where something in them says so.
    pub version: fn(&Paths<'_>) -> Option<&'static str>,
    /// Whether the data of a program are those of a release, compiled.
    pub is_release: fn(&Paths<'_>) -> bool,
    /// Whether only the folder of a user has a file at such a path, besides those that all such
    /// folders have.
    pub is_of_user: fn(&[&str]) -> bool,
    /// Whether a loose file with this extension, and what is in it, is for other applications where
    /// nobody asks.
    pub is_of_others: fn(&str, Says<'_>) -> bool,
    /// The list that a loose file with this extension is for by what is in it.
    pub list_by_content: fn(&str, Says<'_>) -> Option<&'static str>,
    /// What a path below a data root is for, and the base mesh that it belongs to.
    place: Classify,
    /// Whether the file of this name, in these folders, is read although it is hidden.
    reads_hidden: fn(&HiddenPath<'_>) -> bool,
    /// The place below a user's data root that the file at a path belongs to, for a base mesh if
    /// one is known; `None` for files that are not checked outside a data root.
    pub loose_place: fn(&str, Option<&str>) -> Option<String>,
    /// Where its importer puts the file at a path of a pack, for a base mesh; `None` for what it
    /// ignores. An application without an importer has what is unpacked into its data folder.
    pub import: Option<fn(&str, &str) -> Option<String>>,
    /// Whether people put files of a pack without the folders of a data root to where they belong:
    /// nothing imports them.
    pub unpacks_singly: bool,
    /// Why an importer that checks a pack before it unpacks it refuses one with members of these
    /// names.
    pub refuses: Option<Refuses>,
    /// Whether a file of this name could run code if it were put to its data.
    pub is_dangerous: fn(&str) -> bool,
    /// The library that a loose file belongs to, by its extension and the names of the folders
    /// above it, the nearest first; `None` for files that no library lists.
    pub shelf: fn(&str, &[&str]) -> Option<&'static str>,
    /// Whether libraries have a folder for each base mesh.
    pub has_bases: bool,
    /// The only base mesh, where there is but one.
    pub only_base: Option<&'static str>,
    /// The joint without which no motion is for its skeleton, where there is but one skeleton.
    pub joint: Option<&'static str>,
    /// The library in which files are opened that only its own folder may hold.
    pub flat: &'static str,
    /// Folders and files beside a data root that is called `data` that belong to it.
    pub beside: &'static [&'static str],
    /// The folder above that with a user's data folder which a file lies beside that only such a
    /// user has; it may be empty.
    above_data: fn(&[&str]) -> Option<usize>,
    /// Whether such a file is of a user even where no folder of data is.
    pub tells_without_data: fn(&Listing<'_>, &str) -> bool,
    /// Files that it looks for in all of its data root, also where that of another application is
    /// inside it.
    pub everywhere: Option<Kind>,
    /// Another application whose users' folders are its own, too, where it is asked for or has data
    /// at hand.
    pub shares_roots_of: Option<Application>,
    /// Whether what is named in one user's folder may lie in another one that is given.
    pub has_second_user: bool,
    /// The part that the data root with these files plays.
    pub role: fn(&[Candidate<'_>]) -> Role,
    /// Whether a file of this kind in one of those folders is of the application and of no other.
    pub is_telling: fn(Kind) -> bool,
    /// Whether the root with these files, beside another one, is the system although it could play
    /// both parts.
    pub is_system_of_two: fn(&[Candidate<'_>]) -> bool,
    /// Whether the data of a program with these files are all that it has, whatever other data of a
    /// program are given; the second says which base meshes these have.
    pub stands_alone: fn(&[Candidate<'_>], Holds<'_>) -> bool,
    /// Whether any loader opens a file of this name.
    pub opens: fn(&str) -> bool,
    /// Whether the scan of assets opens a file of this name.
    pub scans: fn(&str) -> bool,
    /// What a file of this name is that shares its kind with others and not what becomes of them.
    pub single: fn(&str) -> Option<Single>,
    /// Whether loaders list this path as a folder; the second says which names are those of base
    /// meshes.
    pub is_folder: fn(&str, Holds<'_>) -> bool,
    /// The path under which a file of this name but for its capitals is looked for, where nothing
    /// has that path; the second says what there is.
    pub misnamed: fn(&str, Holds<'_>) -> Option<String>,
}

/// Files that an application has a use of their own for, without a format of their own.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Single {
    /// The names of what expressions are made of.
    Expressions,
    /// The same of poses.
    Poses,
    /// Any other JSON beside a base mesh.
    BesideBase,
    /// The ranges of the one base mesh that scripts know.
    ScriptedRanges,
    /// One of the pictures that the default skin of MakeHuman 1 blends, or the layered one of MPFB.
    SkinPicture,
    /// The skin that MakeHuman 1 starts with.
    FirstSkin,
    /// The skeleton that MakeHuman 1 starts with, and its usual weights.
    FirstRig,
    /// Where MakeHuman 1 keeps the lists of its libraries.
    CacheFolder,
    /// The scene that MakeHuman 1 starts with.
    FirstScene,
    /// What a library shows for an asset.
    Thumbnail,
    /// A target of a user of MakeHuman 1, which has a slider for itself.
    OwnTarget,
    /// The mesh that MakeHuman 2 shows for a lamp.
    LampSymbol,
    /// A side of a skybox of MakeHuman 2.
    SkySide,
}

/// What is asked of a name or path.
pub(super) type Says<'q> = &'q dyn Fn(&str) -> bool;
/// The same.
type Holds<'q> = &'q dyn Fn(&str) -> bool;
/// Why a pack with members of these names is refused.
type Refuses = fn(&[String]) -> Option<Refusal>;
type Classify = for<'p> fn(&[&'p str]) -> (Kind, Option<&'p str>);

/// How telling a path is.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub(super) enum Sign {
    /// Other applications have the same; counts only where nothing else is near.
    Faint,
    /// Could stand elsewhere, too; counts only where nothing better is near.
    Weak,
    /// Only users of this application have such a file.
    OfUser,
    /// Only this application has such a file.
    Strong,
}

/// The part a data root plays.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Role {
    /// What the application calls its system data.
    System,
    /// A user's folder with base meshes of its own, or both in one.
    Both,
    /// A user's folder.
    User,
}

/// A path with a name in it that begins with a point. It may begin above the data root.
struct HiddenPath<'p> {
    /// Whether it is known to lie in a data root of the application.
    in_root: bool,
    /// What lies above the first hidden name below the data root, or below the folder that is
    /// listed; what stands before that is a part of it, whatever it is called.
    visible: &'p [&'p str],
    /// The last name.
    name: &'p str,
    /// Whether that is a folder.
    is_folder: bool,
}

/// Folders of the programs that hold no assets.
const OF_PROGRAMS: [&str; 13] = [
    "..",
    "cache",
    "config",
    "dbcache",
    "downloads",
    "languages",
    "models",
    "poseunits",
    "props",
    "settings",
    "shaders",
    "themes",
    "vertexgroups",
];

/// The base mesh of the applications that have but one.
const HM08: &str = "hm08";

/// The base meshes that `MakeHuman` 2 comes with: a folder of its assets has one of these names.
/// Below a library of another application they are no asset.
pub(super) const MAKEHUMAN2_BASES: [&str; 2] = [HM08, "mh2bot"];

/// Folders of what a body wears, of all applications.
pub(super) const WORN: [&str; 7] = [
    "clothes",
    "hair",
    "eyes",
    "eyebrows",
    "eyelashes",
    "teeth",
    "tongue",
];

/// The first of the folders that is one of these, the nearest first.
fn first_of(known: &[&'static str], above: &[&str]) -> Option<&'static str> {
    above
        .iter()
        .find_map(|name| known.iter().find(|known| *known == name))
        .copied()
}

/// The folder of what a body wears that a loose asset lies in, or where most of them belong.
fn worn_shelf(above: &[&str]) -> &'static str {
    first_of(&WORN, above).unwrap_or(CLOTHES)
}

/// Where what a body wears belongs if nothing says more.
const CLOTHES: &str = "clothes";

/// Folders of other assets that `MakeHuman` 1 and MPFB both have.
pub(super) const LIBRARIES: [&str; 5] = ["proxymeshes", "rigs", "poses", "expressions", "skins"];

impl Layout {
    /// What layouts have that know of nothing else: no root, and nothing that is left out of one.
    const PLAIN: Self = Self {
        application: Application::Makehuman1,
        shape: "",
        depth: 0,
        folders: &[],
        sign: |_| None,
        weigh: |_, _, _, sign| Some(sign),
        version: |_| None,
        is_release: |_| false,
        is_of_user: |_| false,
        is_of_others: |_, _| false,
        list_by_content: |_, _| None,
        place: |_| (Kind::Other, None),
        reads_hidden: |_| false,
        loose_place: |_, _| None,
        import: None,
        unpacks_singly: false,
        is_dangerous: |_| false,
        shelf: |_, _| None,
        has_bases: false,
        only_base: None,
        joint: None,
        flat: "",
        refuses: None,
        beside: &[],
        is_telling: |_| false,
        above_data: |_| None,
        tells_without_data: |_, _| false,
        everywhere: None,
        shares_roots_of: None,
        has_second_user: false,
        role: |_| Role::User,
        is_system_of_two: |_| true,
        stands_alone: |_, _| true,
        opens: |_| true,
        scans: |_| false,
        single: |_| None,
        is_folder: |_, _| false,
        misnamed: |_, _| None,
    };

    /// The layout of an application.
    pub const fn of(application: Application) -> &'static Self {
        match application {
            Application::Makehuman2 => &makehuman2::LAYOUT,
            Application::Makehuman1 => &makehuman1::LAYOUT,
            Application::Mpfb => &mpfb::LAYOUT,
        }
    }

    /// What a path below a data root is for.
    pub fn use_of(&self, rel: &str) -> Use {
        let parts: Vec<&str> = rel.split('/').collect();
        let (mut kind, owner) = (self.place)(&parts);
        // Other programs keep settings beside the data, and in folders of their own.
        if kind == Kind::Json && !self.may_hold_json(&parts) {
            kind = Kind::Other;
        }
        Use {
            application: self.application,
            kind,
            owner: owner.map(str::to_owned),
        }
    }

    /// Whether a JSON without a name of its own is in a folder that the application may have.
    fn may_hold_json(&self, parts: &[&str]) -> bool {
        let [top, _, ..] = parts else { return false };
        self.has_at_top(top)
            || self.folder_in_other_case(top).is_some()
            || OF_PROGRAMS.contains(top)
    }

    /// The parts of `path` above folder names that belong to a data root, the nearest first: where
    /// a data root would be that `path` lies inside of.
    pub fn roots_above<'p>(&self, path: &'p str) -> impl Iterator<Item = &'p str> + use<'_, 'p> {
        let folders = folders_above(path).map(folder_and_name);
        folders
            .filter(|(_, name)| self.has_at_top(name))
            .map(|(above, _)| above)
    }

    /// Whether a data root has a folder of this name at its top.
    pub fn has_at_top(&self, name: &str) -> bool {
        self.folders.iter().any(|folders| folders.contains(&name))
    }

    /// The base mesh that most assets are for.
    pub const USUAL_BASE: &str = HM08;

    /// Whether no asset for the base mesh of this name is one of the application.
    pub fn is_base_of_others(&self, name: &str) -> bool {
        self.only_base.is_some_and(|only| only != name) && MAKEHUMAN2_BASES.contains(&name)
    }

    /// The folders that a data root can have at its top.
    pub fn at_top(&self) -> impl Iterator<Item = &'static str> {
        self.folders.iter().copied().flatten().copied()
    }

    /// The folder at the top of a data root that differs from this name in its capitals alone.
    pub fn folder_in_other_case(&self, name: &str) -> Option<&'static str> {
        self.at_top()
            .find(|folder| *folder != name && folder.eq_ignore_ascii_case(name))
    }

    /// Whether a path below a data root is that of an asset, or would be one outside of any.
    pub fn is_asset(&self, rel: &str) -> bool {
        let folder = parent(rel);
        let is_known = || !matches!(self.use_of(rel).kind, Kind::Other | Kind::Packed);
        self.roots_above(folder).next().is_some() && is_known()
            || (self.loose_place)(rel, None).is_some()
            || (self.shelf)(extension(rel), &[]).is_some()
    }

    /// Whether a path below a data root, which is the first so many bytes of it, is not hidden from
    /// the application.
    pub(super) fn takes(&self, path: &str, root: usize, is_folder: bool) -> bool {
        self.takes_below(path, root, is_folder, true)
    }

    /// The same; the first so many bytes may as well be a folder above a data root, or one in it.
    fn takes_below(&self, path: &str, folder: usize, is_folder: bool, in_root: bool) -> bool {
        let below = path
            .get(folder..)
            .unwrap_or_default()
            .trim_start_matches('/');
        let Some(hidden) = below.split('/').position(|part| part.starts_with('.')) else {
            return true;
        };
        let parts: Vec<&str> = path.split('/').collect();
        let visible = parts
            .get(..parts.len() - depth(below) + hidden)
            .unwrap_or_default();
        let path = HiddenPath {
            in_root,
            visible,
            name: parts.last().copied().unwrap_or_default(),
            is_folder,
        };
        (self.reads_hidden)(&path)
    }

    /// The folder that holds the data folder of the user whom this file belongs to, be there
    /// anything in it or not.
    pub(super) fn above_data<'p>(&self, path: &'p str) -> Option<&'p str> {
        let parts: Vec<&str> = path.split('/').collect();
        ancestor(path, (self.above_data)(&parts)?)
    }

    /// The data root that a file is a sign of.
    pub(super) fn sign<'p>(&self, path: &'p str, listing: &Listing<'_>) -> Option<(&'p str, Sign)> {
        let parts: Vec<&str> = path.split('/').collect();
        let (sign, levels) = (self.sign)(&parts)?;
        let root = ancestor(path, levels)?;
        Some((root, (self.weigh)(listing, root, path, sign)?))
    }
}

/// Whether an application reads a file whose name, or that of a folder above it, begins with a
/// point; of a folder, whether such a file could be in it, or its name counts. `path` lies below a
/// folder of this name, which may be above a data root, or in one; what that one is called is
/// nothing.
pub fn is_read_though_hidden(folder: &str, path: &str, is_folder: bool) -> bool {
    let whole = format!("{folder}/{path}");
    Application::ALL.iter().any(|application| {
        Layout::of(*application).takes_below(&whole, folder.len(), is_folder, false)
    })
}

/// A name that stands for the folder of a loose file: where the file will lie nobody knows, so that
/// nothing is wrong with its name. Folders keep names of their own.
fn near(folder: &str) -> String {
    let is_plain = |letter: char| letter.is_ascii_alphanumeric() || matches!(letter, '-' | '_');
    let plain: String = folder
        .chars()
        .map(|letter| if is_plain(letter) { letter } else { '_' })
        .collect();
    match plain == folder.replace('/', "_") {
        _ if folder.is_empty() => "loose".to_owned(),
        true => plain,
        false => format!("{plain}_{:x}", xxh3_64(folder.as_bytes())),
    }
}

/// The path without its last `levels` parts.
fn ancestor(path: &str, levels: usize) -> Option<&str> {
    let mut rest = path;
    for _ in 0..levels {
        match rest.rsplit_once('/') {
            Some((parent, _)) => rest = parent,
            None if rest.is_empty() => return None,
            None => rest = "",
        }
    }
    Some(rest)
}
