//! Keywords of other applications.

use super::fault::Fault;
use super::loader;
use mhlint_diag::Level;
use mhlint_formats::mhmat::Line;
use mhlint_repo::Surface;

/// Keywords of other applications, and those of MakeHuman 2 for the same.
#[rustfmt::skip]
const SAME: [(&str, &str); 10] = [
    ("roughness", "roughnessFactor"), ("metallic", "metallicFactor"),
    ("emissionIntensity", "emissiveFactor"), ("bumpmapTexture", "normalmapTexture"),
    ("bumpmapIntensity", "normalmapIntensity"), ("roughnessmapTexture", "metallicRoughnessTexture"),
    ("metallicmapTexture", "metallicRoughnessTexture"),
    ("emissionColorMapTexture", "emissiveTexture"),
    ("emissionStrengthMapTexture", "emissiveTexture"), ("litsphereTexture", "shaderParam"),
];

/// A keyword of another application for something that MakeHuman 2 calls otherwise, and that is not
/// set by that name.
pub(super) fn of_others(surface: &Surface<'_>, line: &Line) -> Option<Fault> {
    let keyword = line.keyword.name;
    let application = surface.application;
    if loader::reads(application, keyword) || line.count == 0 {
        return None;
    }
    let meaning = line.keyword.alias_of.unwrap_or(keyword);
    let same: &[_] = if loader::is_1(application) {
        &[]
    } else {
        &SAME
    };
    let own = same
        .iter()
        .find(|(other, _)| *other == meaning)
        .map(|(_, own)| *own);
    let own = own.or(Some(meaning).filter(|meaning| loader::reads(application, meaning)))?;
    let is_set = match own {
        "shaderParam" => surface.litsphere.is_some(),
        own => surface.material.last(own).is_some(),
    };
    (!is_set).then(|| Fault {
        key: keyword.to_owned(),
        place: Surface::place(line),
        level: Level::Warning,
        message: format!("`{keyword}` is a keyword of other applications"),
        effect: format!("silently ignores the line: its own keyword is `{own}`"),
        help: match own {
            "shaderParam" => "write `shaderParam litsphereTexture` and the name".to_owned(),
            "normalmapTexture" if !loader::is_1(application) => {
                "save the bumps as a normal map, and name that in `normalmapTexture`".to_owned()
            }
            "metallicRoughnessTexture" => {
                "save both maps as one picture, and name that in `metallicRoughnessTexture`"
                    .to_owned()
            }
            own => format!("add a line with `{own}`"),
        },
    })
}
