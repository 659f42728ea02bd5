//! Materials as MakeHuman 2 has them
//! (`docs/loaders/makehuman2/materials.md#alternative-materials`).

use super::OWN;
use crate::surface::Picture;
use crate::{FileFacts, Layers, Reference, Resolution, Surface, Wearer};
use mhlint_diag::Place;
use mhlint_formats::mhmat::Material;
use mhlint_source::file_name;

/// The litsphere that comes with the program.
const SHIPPED: &str = "skinmat_eye.png";

/// What becomes of a material, with the pictures that all of its lines lead to, in file order.
pub(super) fn surface<'a>(
    layers: Layers<'a>,
    file: &'a FileFacts,
    material: &'a Material,
    wearer: Wearer,
    references: &[Reference<'a>],
) -> Surface<'a> {
    let mut pictures: Vec<(&'static str, Picture<'a>)> = Vec::new();
    for (texture, reference) in material.textures.iter().zip(references) {
        let picture = picture(reference);
        match pictures
            .iter_mut()
            .find(|(keyword, _)| *keyword == texture.keyword)
        {
            // The last one that is found wins.
            Some((_, other))
                if picture.file.is_some() || picture.is_open || other.file.is_none() =>
            {
                *other = picture;
            }
            Some(_) => {}
            None => pictures.push((texture.keyword, picture)),
        }
    }
    let litsphere = litsphere(layers, material);
    Surface {
        application: OWN,
        file,
        material,
        wearer,
        is_first: false,
        pictures,
        litsphere,
        parameters: Vec::new(),
        shader: None,
    }
}

fn picture<'a>(reference: &Reference<'a>) -> Picture<'a> {
    let is_open = matches!(
        reference.resolution,
        Resolution::NeedsSystem | Resolution::Moved | Resolution::Escapes | Resolution::Absolute
    );
    Picture {
        text: reference.text,
        place: reference.place.clone(),
        file: reference.found(),
        is_open,
    }
}

/// It is looked for by its name without folders, in one folder of the user and of the system.
fn litsphere<'a>(layers: Layers<'a>, material: &'a Material) -> Option<Picture<'a>> {
    let word = material.parameter("litsphereTexture")?.words.get(1)?;
    let name = file_name(&word.text);
    let rel = format!("shaders/litspheres/{name}");
    let file = layers
        .strongest_first()
        .chain(layers.beside)
        .find_map(|layer| layer.file(&rel));
    // A system without shaders is not the program's whole one.
    let has_shaders = |system: &crate::Layer| system.below("shaders").next().is_some();
    let system = layers.system.filter(|_| !layers.is_one_root());
    let is_known = system.is_some_and(|system| name != SHIPPED || has_shaders(system));
    // That a pack has it where its importer ignores it is a fault of the pack.
    let is_ignored = || {
        layers
            .checked
            .pack
            .as_ref()
            .is_some_and(|pack| pack.ignores(&format!("litspheres/{name}")))
    };
    Some(Picture {
        text: &word.text,
        place: Place::Span(word.span.clone()),
        file,
        is_open: file.is_none() && (!is_known || is_ignored()),
    })
}
