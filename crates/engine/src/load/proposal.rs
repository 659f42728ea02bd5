//! What settings would fit a folder of loose assets.

use std::path::Path;

use super::super::error::Error;
use super::super::settle::Scope;
use super::found::roots_of;
use super::input::open;
use super::place::Place;
use super::roots::{Roots, places};
use mhlint_config::Config;
use mhlint_diag::{Application, Outcome};
use mhlint_discover::{Kind, is_read_though_hidden};
use mhlint_source::{Tree, canonical};

/// Settings that fit a folder of loose assets.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Proposal {
    /// The applications that read the assets.
    pub applications: Vec<Application>,
    /// The system data near the folder, relative to it.
    pub system: Option<String>,
}

/// Levels below the folder around one on which signs of system data stand: that of a data folder,
/// and one above it.
const LEVELS: usize = 6;

/// What settings fit a folder; `None` for one that has no loose assets, or lies in a data folder or
/// holds one.
///
/// # Errors
/// When the folder cannot be read.
pub fn propose(folder: &Path) -> Result<Option<Proposal>, Error> {
    let options = Config::default();
    let inputs = open(&[folder.to_path_buf()], &options.limits)?;
    if inputs
        .iter()
        .any(|input| !roots_of(&input.tree, &[], |_| true).is_empty())
    {
        return Ok(None);
    }
    let scope = Scope::new(Vec::new(), &options);
    let roots = Roots::of(&inputs, &[], &scope, &options, &mut Outcome::default())?;
    let reading: Vec<Application> = Application::ALL
        .into_iter()
        .filter(|application| {
            roots
                .checked
                .iter()
                .any(|(place, _)| place.is_of(*application))
        })
        .collect();
    if reading.is_empty() {
        return Ok(None);
    }
    let near = canonical(folder).and_then(|folder| system_near(&folder, &reading));
    Ok(Some(match near {
        Some((system, applications)) => Proposal {
            applications,
            system: Some(system),
        },
        None => Proposal {
            applications: reading,
            system: None,
        },
    }))
}

/// The system data of one of the applications that the folder around `folder` is or holds, relative
/// to `folder`, with the applications.
fn system_near(folder: &Path, reading: &[Application]) -> Option<(String, Vec<Application>)> {
    let tree = Tree::on_disk_to_depth(
        String::new(),
        folder.parent()?,
        LEVELS,
        is_read_though_hidden,
    );
    let systems = places(&tree, roots_of(&tree, &[], |one| reading.contains(&one)));
    let system = systems
        .iter()
        .filter(|place| has_base_mesh(place))
        .min_by_key(|place| place.path().matches('/').count())?;
    let applications = reading
        .iter()
        .copied()
        .filter(|application| system.is_of(*application))
        .collect();
    let path = system.path();
    Some((
        if path.is_empty() {
            "..".to_owned()
        } else {
            format!("../{path}")
        },
        applications,
    ))
}

fn has_base_mesh(place: &Place<'_>) -> bool {
    place
        .files()
        .any(|file| matches!(file.kind(), Kind::BaseMesh | Kind::MeshArchive))
}
