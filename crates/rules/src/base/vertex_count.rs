//! `numverts` must be the vertex count of the base mesh.

use super::super::cause::schema::misspelt;
use super::super::{Check, Rule, RuleCx};
use mhlint_diag::{Application::Makehuman2, Finding, Level, Place, RuleInfo};
use mhlint_discover::Kind;
use mhlint_formats::obj::Mesh;
use mhlint_repo::FileFacts;
use mhlint_repo::makehuman2::{Base, ForeignSign, UnreadMesh, View};

pub(crate) static RULE: Rule = Check::Makehuman2(run).rule(RuleInfo {
    breaks: &[(
        Makehuman2,
        "cannot build binary assets, or builds them with wrong delete masks and crashes when they \
            are put on",
    )],
    docs: include_str!("vertex_count.md").trim_ascii_end(),
    ..RuleInfo::new(
        "base-vertex-count",
        Level::Error,
        "`numverts` differs from the base mesh, or \
        is missing",
    )
});

fn run(view: &View<'_>, base: &Base<'_>, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    if let (Some((file, settings)), Some(other)) = (base.settings(), base.foreign_mesh) {
        if other.sign == ForeignSign::Count {
            let claimed = settings.numverts.unwrap_or_default();
            let has_weights = base
                .pose_rig()
                .is_some_and(|(rig, _)| rig.weights().is_some());
            let others = if has_weights {
                "the weights"
            } else {
                "base.obj"
            };
            out.push(foreign(
                view,
                (file, claimed, others),
                (other.file, other.mesh.facts.vertices),
            ));
        }
        return;
    }
    let (Some((file, settings)), Some((mesh_file, mesh))) = (base.settings(), base.mesh) else {
        return;
    };
    let vertices = mesh.facts.vertices;
    if !settings.has_numverts && misspelt(file, "numverts").is_none() {
        // It came in 2026; of data that are older nobody asks for it.
        if view.layers.are_before(Makehuman2, "2026-08-05") {
            return;
        }
        let effect =
            "cannot build binary assets for this base: compile_meshes.py exits with code 2";
        let finding = RULE
            .at(file, Place::File, "`numverts` is missing")
            .key("numverts")
            .effect(effect);
        return out.push(finding.help(format!("add `\"numverts\": {vertices}`")));
    }
    let Some(claimed) = settings
        .numverts
        .filter(|_| mesh.facts.unreadable_lines == 0)
    else {
        return;
    };
    if i64::try_from(vertices).is_ok_and(|vertices| vertices == claimed) {
        return;
    }
    // The OBJ behind an archive has them: it is the archive that is out of date
    // (`mesh-stale-binary`).
    let has_claimed =
        |text: &Mesh| i64::try_from(text.facts.vertices).is_ok_and(|vertices| vertices == claimed);
    if base
        .mesh_files
        .unread
        .iter()
        .filter_map(UnreadMesh::sound)
        .any(has_claimed)
    {
        return;
    }
    let message = format!(
        "`numverts` is {claimed}, but {} has {vertices} vertices",
        mesh_file.file_name()
    );
    let is_larger = i64::try_from(vertices).is_ok_and(|vertices| vertices < claimed);
    let finding = RULE
        .at(file, Place::pointer(["numverts"]), message)
        .key("numverts")
        .help(if mesh_file.kind == Kind::MeshArchive {
            format!(
                "rebuild base.mhbin with compile_meshes.py if it is out of date; otherwise write \
                 `\"numverts\": {vertices}` and rebuild the binary assets"
            )
        } else {
            format!(
                "restore the right mesh; if this one is meant, write `\"numverts\": {vertices}` \
                    and rebuild the binary assets"
            )
        })
        .related(
            mesh_file.path.clone(),
            Place::File,
            format!("has {vertices} vertices"),
        );
    out.push(if is_larger {
        finding.level(Level::Warning).effect(
            "builds binary assets with delete masks that are too long; crashes with `ValueError` \
             when they are worn with others",
        )
    } else {
        finding
    });
}

/// All the data are made for one mesh, and another one is there.
fn foreign(
    view: &View<'_>,
    (file, claimed, others): (&FileFacts, i64, &str),
    (mesh_file, vertices): (&FileFacts, usize),
) -> Finding {
    let is_short = i64::try_from(vertices).is_ok_and(|vertices| vertices < claimed);
    let is_packed = mesh_file.kind == Kind::MeshArchive;
    let name = mesh_file.file_name();
    let message =
        format!("{name} has {vertices} vertices, but `numverts` and {others} are for {claimed}");
    // Of two layers it is told in the one that is checked.
    let is_own = view.layers.is_checked(mesh_file);
    let (at, place) = if is_own {
        (mesh_file, Place::File)
    } else {
        (file, Place::pointer(["numverts"]))
    };
    let effect = match (is_short, is_packed) {
        (true, true) => {
            "crashes with `IndexError` at start: targets, joints and weights use vertices that \
                are not in the archive"
        }
        (true, false) => "crashes with `IndexError` at start when it loads the weights",
        (false, _) => {
            "applies targets, weights and joints to the wrong vertices, starting at the first \
                added one"
        }
    };
    let help = if is_packed {
        "rebuild the archive with compile_meshes.py from the mesh that the other data is for, or \
         delete it if base.obj is that mesh"
    } else {
        "restore the original mesh, or export it again with the same vertices in the same order"
    };
    let finding = RULE
        .at(at, place, message)
        .key("mesh")
        .effect(effect)
        .help(help);
    finding.related(
        file.path.clone(),
        Place::pointer(["numverts"]),
        format!("`numverts` is {claimed}"),
    )
}
