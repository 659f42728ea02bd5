//! What the body of MakeHuman 1 wears, as it fits it
//! (`docs/loaders/makehuman1/clothes.md#fitting`).

use std::collections::BTreeMap;

use crate::worn::{fitted, measure_all, scale_lines, skin};
use mhlint_eval::makehuman1::fit::{ShearLine, Stretch};
use mhlint_eval::vector::round_to_f32;
use mhlint_eval::worn::WornMeasure;
use mhlint_formats::mhclo::Clothes;
use mhlint_formats::mhclo::makehuman1::READER;
use mhlint_formats::{python_float, python_int};
use mhlint_repo::Layers;
use mhlint_repo::makehuman1::{mesh, shows, worn};

/// Measures the assets of the checked layer.
pub(crate) fn measure(layers: Layers<'_>) -> BTreeMap<String, WornMeasure> {
    let Some((_, mesh)) = mesh(layers).filter(|(_, mesh)| mesh.is_sound()) else {
        return BTreeMap::new();
    };
    let all = worn(layers);
    let own = all.iter().filter(|worn| layers.is_checked(worn.file));
    let fitted = fitted(mesh, own, |_, clothes| {
        stretch(clothes).factors(&mesh.positions).ok()
    });
    if fitted.is_empty() {
        BTreeMap::new()
    } else {
        measure_all(mesh, &skin(mesh, shows), &fitted)
    }
}

/// The lines of an asset that stretch it; of several for one axis the last.
pub(crate) fn stretch(clothes: &Clothes) -> Stretch {
    let set = |start: &str| {
        ["x", "y", "z"].map(|axis| shear_line(clothes, &format!("{start}shear_{axis}")))
    };
    Stretch {
        scales: scale_lines(clothes),
        shears: ["", "l_", "r_"].map(set),
    }
}

fn shear_line(clothes: &Clothes, keyword: &str) -> Option<ShearLine> {
    let entry = READER.of(clothes).last(keyword)?;
    let mut words = entry
        .value
        .split(' ')
        .filter(|word| !word.is_empty())
        .map(str::as_bytes);
    let mut vertex = || u32::try_from(python_int(words.next()?)?).ok();
    let vertices = [vertex()?, vertex()?];
    let mut place = || python_float(words.next()?).map(round_to_f32);
    Some(ShearLine {
        vertices,
        places: [place()?, place()?],
    })
}
