//! Writes the example repository of the tests: a small, complete and faultless `MakeHuman` 2 data
//! tree.
//!
//! Usage: `cargo run --example make_fixtures [DIR]`. It replaces `DIR/data` (the system layer, base
//! `figure`) and `DIR/user` (the user layer, base `imp` and user targets for `figure`); default is
//! `fixtures/makehuman2`. A second run writes the same bytes. Everything is computed here from
//! tables; nothing is copied from other assets.

mod assets;
mod fields;
mod figure;
mod figure_base;
mod figure_macros;
mod figure_rig;
mod figure_sliders;
mod icon;
mod imp;
mod imp_assets;
mod json_text;
mod mesh;
mod morph;
mod motions;
mod patch;
mod rig;
mod slider;
mod tree;
mod user_targets;
mod voxel;
mod wardrobe;
mod worn;

use std::error::Error;
use std::path::PathBuf;

use tree::Tree;

fn main() -> Result<(), Box<dyn Error>> {
    let folder = std::env::args_os()
        .nth(1)
        .map_or_else(default_folder, PathBuf::from);
    make().replace_in(&folder)?;
    Ok(())
}

fn make() -> Tree {
    let mut tree = Tree::new();
    let body = figure::build();
    figure_base::add(&mut tree, &body);
    figure_macros::add(&mut tree, &body.mesh);
    figure_sliders::add(&mut tree, &body);
    figure_rig::add(&mut tree, &body);
    user_targets::add(&mut tree, &body.mesh);
    wardrobe::add(&mut tree, &body);
    motions::add(&mut tree);
    imp_assets::add(&mut tree);
    tree
}

fn default_folder() -> PathBuf {
    PathBuf::from(concat!(env!("CARGO_MANIFEST_DIR"), "/fixtures/makehuman2"))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Who changes the example by hand loses it with the next run.
    #[test]
    fn the_example_repository_is_what_is_made_here() {
        assert_eq!(
            make().differences(&default_folder()).unwrap(),
            Vec::<String>::new()
        );
    }
}
