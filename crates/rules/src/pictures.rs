//! Which files are pictures to an application.

use mhlint_discover::extension;
use mhlint_repo::FileFacts;

/// Extensions of pictures that Blender loads, in small letters.
const OF_BLENDER: [&str; 16] = [
    "bmp", "cin", "dds", "dpx", "exr", "hdr", "jp2", "jpeg", "jpg", "png", "psd", "sgi", "tga",
    "tif", "tiff", "webp",
];

/// Whether Blender takes a file of this name for a picture.
pub(super) fn blender_loads(file: &FileFacts) -> bool {
    OF_BLENDER.contains(&extension(&file.rel).to_lowercase().as_str())
}
