//! Pictures that materials name must be pictures.

use std::collections::BTreeMap;

use super::super::{Check, Rule, RuleCx};
use crate::diag::{Application::Makehuman2, Evidence, Finding, Level, Place, RuleInfo};
use crate::discover::extension;
use crate::formats::picture::{Picture, PictureFault, PictureFormat};
use crate::repo::{FileFacts, View};

pub(in crate::rules) static RULE: Rule = Check::Repository(run).rule(RuleInfo {
    breaks: &[(Makehuman2, "shows the surface without this picture, and copies the broken file into exports")],
    docs: "A material names a file that is not a picture: a text or a web page that was saved under its name, a picture \
        whose download was interrupted, a header that says no size or more than the file holds, or a format that only \
        programs for artists read, such as Photoshop's.\n\n\
        A missing picture is replaced by the colour of the material. One that cannot be read is not: the file exists, \
        so MakeHuman 2 takes it, gets an empty picture, and copies or embeds the file in every export.\n\n\
        Only the header and the end of the file are read. Empty files are reported by `file-empty`, pointers of Git \
        LFS by `file-lfs-pointer`.\n\n\
        Export the picture again as PNG, or restore it.",
    ..RuleInfo::new("material-unreadable-texture", Level::Warning, "a texture that is not a picture")
});

/// Files whose content cannot be told by its first bytes.
const UNMARKED: [&str; 10] = ["tga", "svg", "svgz", "xpm", "xbm", "pcx", "wbmp", "pict", "jp2", "icns"];

fn run(view: &View<'_>, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    let mut named: BTreeMap<&str, (&FileFacts, Vec<String>)> = BTreeMap::new();
    for surface in view.surfaces() {
        for (keyword, _, file) in surface.found().filter(|(_, _, file)| view.layers().is_checked(file)) {
            let cases = &mut named.entry(&file.path).or_insert((file, Vec::new())).1;
            cases.push(format!("{} {keyword}", surface.file.file_name()));
        }
    }
    for (file, cases) in named.into_values() {
        let Some(message) = fault(file) else { continue };
        let finding = RULE.at(file, Place::File, message).evidence(Evidence::of_unnamed(cases));
        out.push(finding.help("export it again as PNG, or restore it"));
    }
}

/// Whether it is a picture that is shown.
pub(super) fn is_readable(file: &FileFacts) -> bool {
    file.size > 0 && !file.encoding.lfs_pointer && file.unreadable.is_none() && fault(file).is_none()
}

fn fault(file: &FileFacts) -> Option<String> {
    let Picture { format, size, fault, .. } = file.picture()?;
    let name = format!("`{}`", file.file_name());
    Some(match (fault, format) {
        (Some(PictureFault::NotAPicture), _) => {
            let is_known = !UNMARKED.contains(&&*extension(&file.rel).to_lowercase());
            is_known.then(|| format!("{name} is not a picture"))?
        }
        (Some(PictureFault::Header), _) => format!("{name} has a damaged header"),
        (Some(PictureFault::NoPixels), _) => {
            let (width, height) = size.unwrap_or_default();
            format!("{name} has no pixels: its header says {width} x {height}")
        }
        (Some(PictureFault::TooManyPixels), _) => {
            let (width, height) = size.unwrap_or_default();
            format!("{name} is too small for the {width} x {height} pixels of its header")
        }
        (Some(PictureFault::CutOff), _) => format!("{name} ends too early"),
        (None, Some(PictureFormat::Source(format))) => format!("{name} is a {format} file, which cannot be shown"),
        (None, _) => return None,
    })
}
