//! The pictures of the guides are fresh: what a terminal shows of the example repository, and the
//! text of the pages that `tests/browser/pictures.sh` takes pictures of.
//!
//! `UPDATE=1 cargo test --test all pictures::` draws those of terminals and of the figure again.

mod figure;
mod page;
mod screen;
mod shirt;

use std::collections::BTreeSet;
use std::fs;
use std::path::{Path, PathBuf};

use pulldown_cmark::{Event, Parser, Tag};
use tempfile::TempDir;

use crate::scratch::{Case, copy_folder, edit, example, mhlint, project};
use figure::Drawing;
use screen::Screen;

/// What a picture may take of a page.
const LARGEST: u64 = 150_000;

/// Those that a test below makes.
const DRAWN: [&str; 11] = [
    "artist-check",
    "artist-fix",
    "artist-ignore",
    "artist-shape",
    "artist-shirt-alone",
    "artist-shirt-clean",
    "artist-shirt-fit",
    "maintainer-baseline",
    "maintainer-check",
    "maintainer-gate",
    "maintainer-statistics",
];
const OF_PAGES: [&str; 2] = ["artist-page", "maintainer-page"];

const PACK: &str = "mhlint my-pack/ --system makehuman2/data";
const HEAD: &str = "my-pack/target/figure/head";
const SLIDER: &str = "head/head-oval=1";
const COMMENT: &str = "# mhlint: ignore target-zero-delta kept as markers for the mirror script";

/// The pack of an artist beside MakeHuman's own data.
fn pack() -> TempDir {
    let folder = tempfile::tempdir().unwrap();
    let [data, pack] = ["makehuman2/data", HEAD].map(|path| folder.path().join(path));
    copy_folder(&project("fixtures/makehuman2/data"), &data);
    fs::create_dir_all(&pack).unwrap();
    for (name, from) in [
        ("my-nose", "head-oval"),
        ("my-chin", "head-size-incr"),
        ("my-ears", "head-side-out"),
    ] {
        let from = data
            .join("target/figure/head")
            .join(from)
            .with_extension("target");
        fs::copy(from, pack.join(name).with_extension("target")).unwrap();
    }
    folder
}

/// Its faults: a vertex of another mesh, a target without any movement, and rows that move nothing.
fn damaged_pack() -> TempDir {
    let folder = pack();
    let pack = folder.path().join(HEAD);
    edit(
        &pack,
        "my-nose.target",
        "339 0 .001 .001\n",
        "5000 0 .001 .001\n",
    );
    fs::write(
        pack.join("my-ears.target"),
        "# basemesh figure\n337 0 0 0\n338 0 0 0\n339 0 0 0\n",
    )
    .unwrap();
    add_zero_rows(&pack);
    folder
}

fn add_zero_rows(pack: &Path) {
    edit(
        pack,
        "my-chin.target",
        "\n365 ",
        "\n600 0 0 0\n601 0 0 0\n365 ",
    );
}

/// The data of a maintainer: the fault of the README, and a fault of each other level.
fn data() -> TempDir {
    let repository = example();
    for rule in [
        "macro-steps-length",
        "target-unreferenced",
        "target-zero-delta",
    ] {
        Case::read(&project("fixtures/rules").join(rule).join("bad")).apply(repository.path());
    }
    repository
}

/// With more faults, to count them.
fn worse_data() -> TempDir {
    let repository = data();
    for case in [
        "weights-not-normalized/bad-several",
        "target-asymmetric-pair/bad",
        "target-splits-joint-cube/bad",
    ] {
        Case::read(&project("fixtures/rules").join(case)).apply(repository.path());
    }
    let head = repository.path().join("data/target/figure/head");
    for copy in ["head-flat", "head-long"] {
        fs::copy(
            head.join("head-wide.target"),
            head.join(copy).with_extension("target"),
        )
        .unwrap();
    }
    repository
}

#[test]
fn an_artist_checks_a_pack() {
    let pack = damaged_pack();
    let mut screen = Screen::new("artist", pack.path());
    screen.run(PACK, 1);
    check("artist-check", &screen.svg());
}

/// After the other faults were repaired by hand.
#[test]
fn an_artist_fixes_a_pack() {
    let pack = pack();
    add_zero_rows(&pack.path().join(HEAD));
    let mut screen = Screen::new("artist", pack.path());
    screen.run(&format!("{PACK} --diff"), 1);
    screen.run(&format!("{PACK} --fix"), 0);
    check("artist-fix", &screen.svg());
}

#[test]
fn an_artist_ignores_a_finding() {
    let pack = pack();
    let head = pack.path().join(HEAD);
    add_zero_rows(&head);
    edit(
        &head,
        "my-chin.target",
        "# basemesh figure\n",
        &format!("# basemesh figure\n{COMMENT}\n"),
    );
    let mut screen = Screen::new("artist", pack.path());
    screen.shows(COMMENT);
    screen.run(PACK, 0);
    check("artist-ignore", &screen.svg());
}

#[test]
fn an_artist_computes_a_shape() {
    let pack = pack();
    let shape = |sliders: &[&str]| {
        let args = [
            &["eval", "mesh", "makehuman2/data", "--base", "figure"],
            sliders,
        ]
        .concat();
        Drawing::of(&String::from_utf8(mhlint(pack.path(), &args).stdout).unwrap())
    };
    let [without, with] = [shape(&[]), shape(&["--set", SLIDER])];
    check(
        "artist-shape",
        &figure::two([(&without, "slider at 0"), (&with, "slider at 1")]),
    );
}

#[test]
fn a_maintainer_checks_the_data() {
    let repository = data();
    let mut screen = Screen::new("maintainer", repository.path());
    screen.run("mhlint data/", 1);
    check("maintainer-check", &screen.svg());
}

#[test]
fn a_maintainer_counts_the_findings() {
    let repository = worse_data();
    let mut screen = Screen::new("maintainer", repository.path());
    screen.run("mhlint data/ --statistics", 1);
    check("maintainer-statistics", &screen.svg());
}

#[test]
fn a_maintainer_writes_a_baseline_and_tests_the_gate() {
    let repository = data();
    let mut screen = Screen::new("maintainer", repository.path());
    screen.run(
        "mhlint data/ --baseline mhlint-baseline.json --write-baseline",
        0,
    );
    check("maintainer-baseline", &screen.svg());

    fs::write(
        repository.path().join("mhlint.toml"),
        "baseline = \"mhlint-baseline.json\"\n",
    )
    .unwrap();
    let torso = repository.path().join("data/target/figure/torso");
    fs::rename(
        torso.join("belly-trans-in.target"),
        torso.join("belly-in.target"),
    )
    .unwrap();
    let mut screen = Screen::new("maintainer", repository.path());
    screen.run("mhlint data/", 1);
    check("maintainer-gate", &screen.svg());
}

#[test]
fn pictures_of_pages_show_the_text_of_today() {
    let runs: [(TempDir, &[&str]); 2] = [
        (damaged_pack(), &["my-pack/", "--system", "makehuman2/data"]),
        (worse_data(), &["data/"]),
    ];
    for (name, (folder, args)) in OF_PAGES.into_iter().zip(runs) {
        let page = mhlint(folder.path(), &[args, &["--report", "html"]].concat()).stdout;
        let page = String::from_utf8(page).unwrap();
        match std::env::var_os("PAGES") {
            Some(pages) => write_page(&PathBuf::from(pages), name, &page),
            None => compare_page(name, &page::text(&page)),
        }
    }
}

/// For `tests/browser/pictures.sh`: what it takes a picture of, and what it puts beside it.
fn write_page(folder: &Path, name: &str, page: &str) {
    fs::create_dir_all(folder).unwrap();
    fs::write(folder.join(name).with_extension("html"), page).unwrap();
    fs::write(folder.join(name).with_extension("txt"), page::text(page)).unwrap();
}

fn compare_page(name: &str, now: &str) {
    let then = fs::read_to_string(picture(name, "txt")).unwrap_or_default();
    if then != now {
        let [then, now] = first_difference(&then, now);
        panic!(
            "docs/pictures/{name}.png is stale: it shows `{then}`, the page `{now}`; run tests/browser/pictures.sh"
        );
    }
}

/// Compares a drawn picture, or writes it.
#[track_caller]
fn check(name: &str, svg: &str) {
    assert!(
        DRAWN.contains(&name),
        "{name} is not in the list of drawn pictures"
    );
    let path = picture(name, "svg");
    let then = fs::read_to_string(&path).unwrap_or_default();
    if then == svg {
        return;
    }
    if std::env::var_os("UPDATE").is_none() {
        let [then, now] = first_difference(&then, svg).map(page::between_tags);
        panic!(
            "{name}.svg is stale: it shows `{then}`, now `{now}`; UPDATE=1 cargo test --test all pictures::"
        );
    }
    fs::create_dir_all(path.parent().unwrap()).unwrap();
    fs::write(path, svg).unwrap();
}

/// The first lines that differ.
fn first_difference<'a>(then: &'a str, now: &'a str) -> [&'a str; 2] {
    let [mut then, mut now] = [then.lines(), now.lines()];
    loop {
        match (then.next(), now.next()) {
            (one, other) if one == other && one.is_some() => {}
            (one, other) => return [one, other].map(Option::unwrap_or_default),
        }
    }
}

#[test]
fn every_picture_is_in_a_document_and_every_document_has_its_pictures() {
    let mut used = BTreeSet::new();
    for document in documents() {
        for (target, words) in images(&fs::read_to_string(&document).unwrap()) {
            let path = document.parent().unwrap().join(&target);
            assert!(
                path.is_file(),
                "{}: there is no {target}",
                document.display()
            );
            assert!(
                !words.is_empty(),
                "{}: {target} is not described",
                document.display()
            );
            used.insert(path.file_name().unwrap().to_owned());
        }
    }
    for entry in fs::read_dir(project("docs/pictures")).unwrap() {
        let path = entry.unwrap().path();
        let is_text = path.extension().is_some_and(|extension| extension == "txt");
        let picture = if is_text {
            path.with_extension("png")
        } else {
            path
        };
        let name = picture.file_stem().unwrap().to_str().unwrap();
        assert!(
            DRAWN.contains(&name) || OF_PAGES.contains(&name),
            "no test makes {}",
            picture.display()
        );
        assert!(
            used.contains(picture.file_name().unwrap()),
            "{} is in no document",
            picture.display()
        );
        assert!(
            fs::metadata(&picture).unwrap().len() < LARGEST,
            "{} is too large",
            picture.display()
        );
    }
}

fn documents() -> Vec<PathBuf> {
    let of = |folder: &str| {
        fs::read_dir(project(folder))
            .unwrap()
            .map(|entry| entry.unwrap().path())
    };
    let all = of("docs")
        .chain(of("docs/rules"))
        .chain([project("README.md"), project("CONTRIBUTING.md")]);
    all.filter(|path| path.extension().is_some_and(|extension| extension == "md"))
        .collect()
}

/// The pictures in a document, with what is said of them.
fn images(text: &str) -> Vec<(String, String)> {
    let mut all: Vec<(String, String)> = Vec::new();
    let mut is_inside = false;
    for event in Parser::new(text) {
        match event {
            Event::Start(Tag::Image { dest_url, .. }) => {
                all.push((dest_url.into_string(), String::new()));
                is_inside = true;
            }
            Event::End(pulldown_cmark::TagEnd::Image) => is_inside = false,
            Event::Text(words) | Event::Code(words) if is_inside => {
                all.last_mut().unwrap().1.push_str(&words);
            }
            _ => {}
        }
    }
    all
}

fn picture(name: &str, extension: &str) -> PathBuf {
    project("docs/pictures")
        .join(name)
        .with_extension(extension)
}
