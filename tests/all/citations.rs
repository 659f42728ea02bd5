//! The evidence: what the code says of a loader leads to the page that has it.

use std::collections::BTreeSet;
use std::fs;
use std::path::{Path, PathBuf};

use crate::scratch::project;

/// Where the pages are.
const PAGES: &str = "docs/loaders/";

#[test]
fn every_citation_leads_to_a_heading() {
    let mut wrong = Vec::new();
    let mut count = 0;
    for file in sources() {
        let text = fs::read_to_string(&file).unwrap();
        for (at, _) in text.match_indices(PAGES) {
            let cited: String = text[at..]
                .chars()
                .take_while(|c| c.is_alphanumeric() || "/-_.#".contains(*c))
                .collect();
            let cited = cited.trim_end_matches(['.', '#']);
            count += 1;
            if !leads_somewhere(cited) {
                wrong.push(format!("{}: {cited}", file.display()));
            }
        }
    }
    assert!(
        wrong.is_empty(),
        "{}\n{} citations",
        wrong.join("\n"),
        wrong.len()
    );
    assert!(count > 200, "{count}");
}

#[test]
fn no_comment_cites_a_page_outside_of_the_repository() {
    let outside = ["makehuman1", "makehuman2", "mpfb"]
        .map(|name| [format!("{name}.md §"), format!("{name}-observed.md")]);
    let outside: Vec<String> = outside
        .into_iter()
        .flatten()
        .chain(["formats/additions.md", "formats/versions.md"].map(str::to_owned))
        .collect();
    let mut wrong = Vec::new();
    for file in sources()
        .into_iter()
        .filter(|file| !file.ends_with("citations.rs"))
    {
        for (number, line) in fs::read_to_string(&file).unwrap().lines().enumerate() {
            if outside.iter().any(|cited| line.contains(cited.as_str())) || line.contains('§') {
                wrong.push(format!(
                    "{}:{}: {}",
                    file.display(),
                    number + 1,
                    line.trim()
                ));
            }
        }
    }
    assert!(
        wrong.is_empty(),
        "{}\n{} lines",
        wrong.join("\n"),
        wrong.len()
    );
}

#[test]
fn every_page_is_reached_from_the_first_one() {
    let reached: BTreeSet<PathBuf> = links(&project(PAGES).join("README.md"))
        .into_iter()
        .collect();
    let mut all = Vec::new();
    markdown(&project(PAGES), &mut all);
    let missing: Vec<_> = all
        .iter()
        .filter(|page| !page.ends_with("README.md") && !reached.contains(*page))
        .collect();
    assert!(missing.is_empty(), "{missing:?}");
}

#[test]
fn links_between_the_pages_lead_to_headings() {
    let mut all = Vec::new();
    markdown(&project(PAGES), &mut all);
    let mut wrong = Vec::new();
    for page in &all {
        let text = fs::read_to_string(page).unwrap();
        for link in text
            .split("](")
            .skip(1)
            .filter_map(|rest| rest.split(')').next())
        {
            let (file, anchor) = link.split_once('#').unwrap_or((link, ""));
            let target = if file.is_empty() {
                page.clone()
            } else {
                page.parent().unwrap().join(file)
            };
            let is_outer = link.contains("://");
            if !is_outer
                && !(target.exists() && (anchor.is_empty() || anchors(&target).contains(anchor)))
            {
                wrong.push(format!("{}: {link}", page.display()));
            }
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

fn leads_somewhere(cited: &str) -> bool {
    let (page, anchor) = cited.split_once('#').unwrap_or((cited, ""));
    let path = project(page);
    path.exists() && (anchor.is_empty() || anchors(&path).contains(anchor))
}

/// What the headings of a page are called in links, as GitHub makes them.
fn anchors(page: &Path) -> BTreeSet<String> {
    let text = fs::read_to_string(page).unwrap_or_default();
    let headings = text.lines().filter(|line| line.starts_with('#'));
    headings
        .map(|line| slug(line.trim_start_matches('#').trim()))
        .collect()
}

fn slug(heading: &str) -> String {
    let kept = heading
        .to_lowercase()
        .chars()
        .filter(|c| c.is_alphanumeric() || " -_".contains(*c))
        .collect::<String>();
    kept.replace(' ', "-")
}

#[test]
fn headings_become_anchors_as_on_github() {
    assert_eq!(slug("Rows of `.mhclo`, and more"), "rows-of-mhclo-and-more");
    assert_eq!(slug("What stops (and when)"), "what-stops-and-when");
}

fn links(page: &Path) -> Vec<PathBuf> {
    let text = fs::read_to_string(page).unwrap();
    let links = text
        .split("](")
        .skip(1)
        .filter_map(|rest| rest.split([')', '#']).next());
    links
        .map(|link| page.parent().unwrap().join(link))
        .collect()
}

fn markdown(folder: &Path, found: &mut Vec<PathBuf>) {
    for entry in fs::read_dir(folder)
        .unwrap()
        .map(|entry| entry.unwrap().path())
    {
        if entry.is_dir() {
            markdown(&entry, found);
        } else if entry.extension().is_some_and(|extension| extension == "md") {
            found.push(entry);
        }
    }
}

/// The Rust files of the workspace.
fn sources() -> Vec<PathBuf> {
    let folders = ["src", "crates", "schemas", "tests", "benches", "examples"].map(project);
    let files = folders.iter().flat_map(|folder| {
        walkdir::WalkDir::new(folder)
            .into_iter()
            .filter_map(Result::ok)
    });
    let files = files.map(walkdir::DirEntry::into_path);
    files
        .filter(|file| file.extension().is_some_and(|extension| extension == "rs"))
        .collect()
}
