//! One shirt from its export to a clean check, as the guide for artists tells it.

use std::fs;
use std::path::Path;

use tempfile::TempDir;

use super::check;
use super::screen::Screen;
use crate::scratch::zipped::{Member, named, zip};
use crate::scratch::{content, copy_folder, edit, project};

const ALONE: &str = "mhlint my-shirt/ --app makehuman2";
const OVER: &str = "mhlint my-shirt/ --system makehuman2/data";
const PACK: &str = "mhlint my-shirt.zip --system makehuman2/data";

/// A shirt as it was exported, beside the data of the application.
fn exported() -> TempDir {
    let folder = tempfile::tempdir().unwrap();
    let root = folder.path();
    copy_folder(
        &project("fixtures/makehuman2/data"),
        &root.join("makehuman2/data"),
    );
    fs::rename(
        root.join("makehuman2/data/clothes/figure/shirt"),
        root.join("my-shirt"),
    )
    .unwrap();
    edit(
        root,
        "my-shirt/shirt.mhmat",
        "diffuseTexture shirt.png",
        "diffuseTexture C:\\work\\shirt.png",
    );
    edit(
        root,
        "my-shirt/shirt.mhclo",
        "uuid 38a1d6f4-50c2-4b7f-8e1d-6c09f2b4d702\n",
        "",
    );
    edit(
        root,
        "my-shirt/shirt.mhclo",
        "173 - 204",
        "173 - 204 283 - 441",
    );
    edit(
        root,
        "my-shirt/shirt.mhclo",
        "197 181 195 0.7000 0.2000 0.1000",
        "97 181 195 0.7000 0.2000 0.1000",
    );
    folder
}

/// What the reports ask for without the base mesh.
fn repair_files(root: &Path) {
    edit(
        root,
        "my-shirt/shirt.mhmat",
        "diffuseTexture C:\\work\\shirt.png",
        "diffuseTexture shirt.png",
    );
    let uuid = "name shirt\nuuid 38a1d6f4-50c2-4b7f-8e1d-6c09f2b4d702\n";
    edit(root, "my-shirt/shirt.mhclo", "name shirt\n", uuid);
}

/// What they ask for with it.
fn repair_fit(root: &Path) {
    edit(
        root,
        "my-shirt/shirt.mhclo",
        "173 - 204 283 - 441",
        "173 - 204",
    );
    edit(
        root,
        "my-shirt/shirt.mhclo",
        "97 181 195 0.7000 0.2000 0.1000",
        "197 181 195 0.7000 0.2000 0.1000",
    );
}

/// Packs the folder as it would be shared.
fn pack(root: &Path) {
    let files = content(&root.join("my-shirt"));
    let members = files.iter().map(|(path, bytes)| {
        let name = format!("clothes/my-shirt/{}", path.to_str().unwrap());
        (named(&name), bytes.as_slice())
    });
    let members: Vec<(Member, &[u8])> = members.collect();
    fs::write(root.join("my-shirt.zip"), zip(&members)).unwrap();
}

#[test]
fn an_artist_takes_a_shirt_from_export_to_a_clean_check() {
    let folder = exported();
    let root = folder.path();
    let mut screen = Screen::new("artist", root);
    screen.run(ALONE, 1);
    check("artist-shirt-alone", &screen.svg());

    repair_files(root);
    let mut screen = Screen::new("artist", root);
    screen.run(OVER, 0);
    check("artist-shirt-fit", &screen.svg());

    repair_fit(root);
    pack(root);
    let mut screen = Screen::new("artist", root);
    screen.run(OVER, 0);
    screen.run(PACK, 0);
    check("artist-shirt-clean", &screen.svg());
}
