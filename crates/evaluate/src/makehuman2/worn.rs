//! What a body of MakeHuman 2 wears, as it fits it (`docs/loaders/makehuman2/clothes.md#fitting`).

use std::collections::BTreeMap;

use crate::worn::{Fitted, fitted, measure_all, scale_lines, skin};
use mhlint_eval::makehuman2::fit::axis_scales;
use mhlint_eval::worn::WornMeasure;
use mhlint_repo::makehuman2::{Base, worn};
use mhlint_repo::{Layers, Worn};

/// What is worn of the checked layer.
pub(crate) fn own<'a>(base: &Base<'_>, layers: Layers<'a>) -> Vec<Worn<'a>> {
    let mut own = worn(layers, Some(base.name));
    own.retain(|worn| layers.is_checked(worn.file));
    own
}

/// The assets that can be fitted to the mesh of a base.
pub(crate) fn fit<'w>(base: &Base<'_>, own: &'w [Worn<'w>]) -> Vec<Fitted<'w>> {
    let Some((_, mesh)) = base.mesh.filter(|(_, mesh)| mesh.is_sound()) else {
        return Vec::new();
    };
    fitted(mesh, own.iter(), |worn, clothes| {
        let lines = if worn.is_topology() {
            [None; 3]
        } else {
            scale_lines(clothes)
        };
        axis_scales(&mesh.positions, lines).ok()
    })
}

/// Measures them.
pub(crate) fn measure(base: &Base<'_>, fitted: &[Fitted<'_>]) -> BTreeMap<String, WornMeasure> {
    let Some((_, mesh)) = base.mesh.filter(|_| !fitted.is_empty()) else {
        return BTreeMap::new();
    };
    let shown = base
        .settings()
        .and_then(|(_, settings)| settings.shown.as_ref());
    let skin = skin(mesh, |group| {
        shown.is_some_and(|shown| shown.contains(group))
    });
    measure_all(mesh, &skin, fitted)
}
