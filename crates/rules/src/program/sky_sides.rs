//! What OpenGL is handed of the sides of a skybox: the bytes of the picture as Qt holds it
//! (`docs/loaders/makehuman2/program.md#sky-boxes`).

use std::collections::BTreeMap;

use super::super::Rule;
use mhlint_diag::{Application::Makehuman2, Case, Evidence, Finding, Level, Place, grouped};
use mhlint_formats::picture::{Picture, PictureFormat, Pixels};
use mhlint_repo::FileFacts;

/// The pictures of a skybox by their sides.
pub(super) type Sides<'l> = BTreeMap<&'l str, &'l FileFacts>;

/// When a skybox is shown.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Shown {
    AtStart,
    /// When somebody chooses it.
    Chosen,
    /// Which one `shader.json` names is not known.
    Perhaps,
}

const CRASH_AT_START: Case = &[(
    Makehuman2,
    Level::Error,
    "crashes with a segmentation fault at every start",
)];
const CRASH_CHOSEN: Case = &[(
    Makehuman2,
    Level::Error,
    "crashes with a segmentation fault when the skybox is chosen in the window of the scene",
)];
const CRASH_PERHAPS: Case = &[(
    Makehuman2,
    Level::Error,
    "crashes with a segmentation fault when the skybox is shown, at every start if `shader.json` \
        names it",
)];
const CUT_OFF: Case = &[(
    Makehuman2,
    Level::Info,
    "shows the side cut off or distorted",
)];

/// What every side is taken to have, in pixels.
const SIDE: u64 = 2048;
/// Bits that are taken of it, 4 bytes a pixel.
const TAKEN: u64 = SIDE * SIDE * 32;

/// What is wrong with a side.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
enum Fault {
    Unreadable,
    Small,
    FewBits,
    OtherSize,
}

pub(super) fn faults(
    rule: &Rule,
    name: &str,
    sides: &Sides<'_>,
    shown: Shown,
    out: &mut Vec<Finding>,
) {
    let found = sides
        .values()
        .filter_map(|file| Some((fault(file)?, *file)));
    out.extend(grouped(found).into_iter().filter_map(|(fault, files)| {
        let (first, picture) = files
            .first()
            .and_then(|file| Some((*file, file.picture()?)))?;
        let more = if files.len() > 1 {
            format!(" ({} sides)", files.len())
        } else {
            String::new()
        };
        let message = format!("`{}` {}{more}", first.file_name(), words(fault, picture));
        let case = match (fault, shown) {
            (Fault::OtherSize, _) => CUT_OFF,
            (_, Shown::AtStart) => CRASH_AT_START,
            (_, Shown::Chosen) => CRASH_CHOSEN,
            (_, Shown::Perhaps) => CRASH_PERHAPS,
        };
        let names = files.iter().map(|file| file.file_name());
        let parts = files.iter().map(|file| (file.file_name(), &file.path));
        let finding = rule
            .at(first, Place::File, message)
            .key(format!("{name} {fault:?}"))
            .case(case)
            .parts_in(parts);
        let help = "save the six pictures with 2048 by 2048 pixels in full colour";
        Some(finding.help(help).evidence(Evidence::of_cases(names)))
    }));
}

fn fault(file: &FileFacts) -> Option<Fault> {
    // Of a file without anything in it others speak.
    if file.size == 0 || file.encoding.lfs_pointer || file.unreadable.is_some() {
        return None;
    }
    let picture = file.picture()?;
    if picture.fault.is_some() || matches!(picture.format, Some(PictureFormat::Source(_))) {
        return Some(Fault::Unreadable);
    }
    let (width, height) = picture.size?;
    let pixels = width.saturating_mul(height);
    if pixels.saturating_mul(bits(picture)) >= TAKEN {
        return ((width, height) != (SIDE, SIDE)).then_some(Fault::OtherSize);
    }
    Some(if pixels < SIDE * SIDE {
        Fault::Small
    } else {
        Fault::FewBits
    })
}

/// Bits of a pixel as Qt holds it; those of a usual picture where that is not known.
fn bits(picture: &Picture) -> u64 {
    match picture.pixels {
        Some(Pixels::Grey { bits, keyed: false }) if bits <= 8 => 8,
        Some(Pixels::Grey { keyed: false, .. }) => 16,
        Some(Pixels::Palette) => 8,
        Some(Pixels::Channels { bits: 9.., .. }) => 64,
        _ => 32,
    }
}

fn words(fault: Fault, picture: &Picture) -> String {
    let (width, height) = picture.size.unwrap_or_default();
    match fault {
        Fault::Unreadable => "is not a picture that can be read".to_owned(),
        Fault::Small | Fault::OtherSize => {
            format!("has {width} × {height} pixels, expected {SIDE} × {SIDE}")
        }
        Fault::FewBits if picture.pixels == Some(Pixels::Palette) => {
            "has a table of colours, expected full colour".to_owned()
        }
        Fault::FewBits => "has shades of grey alone, expected full colour".to_owned(),
    }
}
