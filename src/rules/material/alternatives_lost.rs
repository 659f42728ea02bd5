//! Materials that are offered for an asset must be found, also by saved models.

use super::super::{Check, Rule, RuleCx, counted};
use crate::diag::{Application::Makehuman2, Case, Evidence, Finding, Level, Place, RuleInfo};
use crate::discover::Kind;
use crate::repo::{FileFacts, Layer, ReferenceKind, View, Wearer, Worn, parent};
use crate::source::is_below;

pub(in crate::rules) static RULE: Rule = Check::Repository(run).rule(RuleInfo {
    breaks: &[(Makehuman2, "does not offer the materials")],
    docs: "MakeHuman 2 offers for an asset all materials in the folder of its mesh and below. Some of them are lost:\n\n\
        - A material with a space in its file name is offered, but a saved model cannot name it: loaded again, the asset \
        wears its standard material, the body the default skin.\n\
        - If `obj_file` names a mesh in a sub-folder, materials next to the asset are not offered. Its own one still \
        loads.\n\
        - An asset directly in the folder of the base mesh, such as `clothes/<base>/`, is offered the materials of all \
        assets there, and a chosen one is lost when the model is loaded.\n\n\
        Rename the material, or keep each asset in a folder of its own, with its mesh and its materials.",
    ..RuleInfo::new("material-alternatives-lost", Level::Warning, "materials that are not offered, or lost in models")
});

const OF_ASSET: Case =
    &[(Makehuman2, Level::Warning, "offers it, but a saved model wears the standard material again")];
const OF_SKIN: Case = &[(Makehuman2, Level::Warning, "offers it, but a saved model has the default skin again")];
const OF_ALL: Case = &[(
    Makehuman2,
    Level::Warning,
    "offers the materials of all assets in the folder, and loses the chosen one when the model is loaded",
)];

fn run(view: &View<'_>, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    let layers = view.layers();
    for surface in view.surfaces().iter().filter(|surface| layers.is_checked(surface.file)) {
        let name = surface.file.file_name();
        if name.contains(char::is_whitespace) && surface.wearer != Wearer::Asset {
            let finding = RULE.at(surface.file, Place::File, format!("`{name}` has a space in its name")).key("space");
            let finding = finding.case(if surface.wearer == Wearer::Skin { OF_SKIN } else { OF_ASSET });
            out.push(finding.help("rename the file without spaces, and everything that names it"));
        }
    }
    for worn in view.assets().iter().filter(|worn| layers.is_checked(worn.file) && !is_topology(worn.file)) {
        out.extend(elsewhere(layers.checked, worn));
    }
}

/// A topology wears the skin.
fn is_topology(file: &FileFacts) -> bool {
    file.rel.starts_with("proxy/")
}

/// What becomes of the materials around an asset whose mesh is not in a folder for both.
fn elsewhere(layer: &Layer, worn: &Worn<'_>) -> Option<Finding> {
    let references = worn.references.as_ref()?;
    let of = |kind| references.iter().find(|one| one.kind == kind);
    let mesh = of(ReferenceKind::AssetMesh)?;
    mesh.found()?;
    let (own, searched) = (parent(&worn.file.rel), parent(&mesh.rel));
    let named = of(ReferenceKind::AssetMaterial).and_then(|one| one.found()).map(|file| file.rel.as_str());
    let materials = |folder: &str| -> Vec<&FileFacts> {
        let files = layer.below(folder).filter(|file| file.kind == Kind::Material);
        files.filter(|file| Some(file.rel.as_str()) != named).collect()
    };
    let (lost, case): (Vec<&FileFacts>, Option<Case>) = if searched.matches('/').count() < 2 {
        (materials(searched), Some(OF_ALL))
    } else if is_below(own, searched) {
        return None;
    } else {
        let around = materials(own);
        (around.into_iter().filter(|file| !is_below(&file.rel, searched)).collect(), None)
    };
    lost.first()?;
    let message = if case.is_some() {
        "lies with its mesh in the folder of all assets".to_owned()
    } else {
        format!("{} next to it, but the mesh is in `{searched}`", counted(lost.len(), "material"))
    };
    let finding = RULE.at(worn.file, mesh.place.clone(), message).key("folder");
    let finding = finding.evidence(Evidence::of_cases(lost.iter().map(|file| file.rel.as_str())));
    let help = "keep asset, mesh and materials together in a folder of their own";
    Some(case.map_or(finding.clone(), |case| finding.case(case)).help(help))
}
