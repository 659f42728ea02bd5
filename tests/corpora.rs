//! Whole repositories of the applications, where `MHLINT_CORPORA` names the folder that holds them.
//!
//! They are not part of the project. Without the variable every test here passes with a word on it.
#![allow(clippy::unwrap_used, clippy::panic, reason = "a test may stop where it fails")]
#![allow(clippy::print_stderr, reason = "a test that is left out must say so")]

mod scratch;

use std::path::PathBuf;

use scratch::mhlint;

/// The folder of a corpus, `None` (said aloud) where it is not at hand.
fn corpus(name: &str) -> Option<PathBuf> {
    let Some(folder) = std::env::var_os("MHLINT_CORPORA").map(PathBuf::from) else {
        eprintln!("skipped: MHLINT_CORPORA does not name a folder with `{name}`");
        return None;
    };
    let path = folder.join(name);
    assert!(path.is_dir(), "{} is missing", path.display());
    Some(path)
}

/// The JSON report on a folder of a corpus.
fn report(corpus: &std::path::Path, args: &[&str]) -> serde_json::Value {
    let output = mhlint(corpus, &[args, &["--report", "json"]].concat());
    serde_json::from_slice(&output.stdout)
        .unwrap_or_else(|error| panic!("{error}: {}", String::from_utf8_lossy(&output.stderr)))
}

#[test]
fn makehuman2_ends_with_a_verdict_that_its_counts_bear_out() {
    let Some(corpus) = corpus("makehuman2") else { return };
    let report = report(&corpus, &["data"]);
    let summary = &report["summary"];
    assert_eq!(report["roots"][0]["bases"], serde_json::json!(["hm08", "mh2bot"]));
    assert!(summary["files"].as_u64().unwrap() > 1_000, "{summary}");
    let errors = summary["error"].as_u64().unwrap();
    assert_eq!(report["verdict"], if errors == 0 { "pass" } else { "fail" }, "{summary}");
    let listed = report["findings"].as_array().unwrap().iter();
    assert_eq!(listed.filter(|finding| finding["level"] == "error").count() as u64, errors);
}
