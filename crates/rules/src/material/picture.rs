//! Whether a picture can be shown.

use mhlint_discover::{Kind, extension};
use mhlint_formats::Format;
use mhlint_formats::picture::{Picture, PictureFault, PictureFormat};
use mhlint_repo::FileFacts;

/// Files whose content cannot be told by its first bytes.
const UNMARKED: [&str; 10] = [
    "tga", "svg", "svgz", "xpm", "xbm", "pcx", "wbmp", "pict", "jp2", "icns",
];

/// Whether it is a picture that is shown.
pub(super) fn is_readable(file: &FileFacts) -> bool {
    file.size > 0
        && !file.encoding.lfs_pointer
        && file.unreadable.is_none()
        && fault(file).is_none()
}

/// Why it is not, in words.
pub(super) fn fault(file: &FileFacts) -> Option<String> {
    let name = format!("`{}`", file.file_name());
    let Some(Picture {
        format,
        size,
        fault,
        ..
    }) = file.picture()
    else {
        return is_something_else(file.kind).then(|| format!("{name} is not a picture"));
    };
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
        (None, Some(PictureFormat::Source(format))) => {
            format!("{name} is a {format} file, which cannot be shown")
        }
        (None, _) => return None,
    })
}

/// Whether a file is a mesh, a material or another text. Of unknown files nobody can tell.
pub(super) fn is_something_else(kind: Kind) -> bool {
    Format::of(kind).is_text() && kind != Kind::Other
}
