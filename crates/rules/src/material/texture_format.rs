//! The extension of a picture must be that of its format.

use std::collections::BTreeMap;

use super::super::{Check, Rule, RuleCx};
use super::picture::is_readable;
use mhlint_diag::{Application::Makehuman2, Finding, Level, Place, RuleInfo};
use mhlint_discover::extension;
use mhlint_formats::picture::PictureFormat;
use mhlint_repo::{FileFacts, View};

pub(crate) static RULE: Rule = Check::Repository(run).rule(RuleInfo {
    breaks: &[(
        Makehuman2,
        "shows it, but exports it with the wrong format: other programs may not load it",
    )],
    docs: include_str!("texture_format.md").trim_ascii_end(),
    ..RuleInfo::new(
        "material-texture-format",
        Level::Warning,
        "a texture whose extension is that of another format",
    )
});

fn run(view: &View<'_>, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    let found = view
        .surfaces()
        .iter()
        .flat_map(|surface| surface.found().map(|(_, _, file)| file));
    let own = found.filter(|file| view.layers().is_checked(file) && is_readable(file));
    let files: BTreeMap<&str, &FileFacts> = own.map(|file| (file.path.as_str(), file)).collect();
    for file in files.into_values() {
        let Some(format) = file.picture().and_then(|picture| picture.format) else {
            continue;
        };
        let extension = extension(&file.rel);
        let named = named(&extension.to_lowercase());
        if named.is_some_and(|named| named != format.name()) {
            let message = format!("`{}` is a {} file", file.file_name(), format.name());
            let finding = RULE.at(file, Place::File, message);
            out.push(finding.help(format!(
                "rename it to `{}`, here and in the materials",
                renamed(file, format)
            )));
        }
    }
}

/// The format that an extension stands for.
fn named(extension: &str) -> Option<&'static str> {
    match extension {
        "png" => Some("PNG"),
        "jpg" | "jpeg" => Some("JPEG"),
        "bmp" => Some("BMP"),
        "gif" => Some("GIF"),
        "tif" | "tiff" => Some("TIFF"),
        "webp" => Some("WebP"),
        _ => None,
    }
}

fn renamed(file: &FileFacts, format: PictureFormat) -> String {
    let extension = if format == PictureFormat::Jpeg {
        "jpg".to_owned()
    } else {
        format.name().to_lowercase()
    };
    format!("{}.{extension}", file.stem())
}
