//! Small inputs from strangers that once stopped, swelled or slowed mhlint. What makes each of them
//! harmless is held by a test beside the code, which counts work; here each of them is run through
//! the real binary, as it is and ten times as large, for a verdict.
//!
//! `cargo test --release --test all -- --ignored bounded:: --nocapture` prints what each takes;
//! with `MHLINT=FILE` of another binary.

mod formats;
mod long;
mod macros;
mod names;
mod settings;
mod worn;

use std::ffi::OsString;
use std::fs;
use std::path::Path;
use std::process::Command;

/// An input of a stranger.
pub(super) struct Input {
    /// What it is.
    pub name: &'static str,
    /// How often the part that matters is repeated.
    pub times: usize,
    /// Path and bytes of its files, with that number of repetitions.
    pub files: fn(usize) -> Vec<(String, Vec<u8>)>,
    /// What mhlint is asked to do, in the folder of the files.
    pub args: &'static [&'static str],
    /// The exit code there has to be: 2 only where the input itself is refused.
    pub exit: i32,
}

/// What a run took.
struct Taken {
    exit: Option<i32>,
    seconds: f64,
    mebibytes: f64,
    err: String,
}

fn run(input: &Input, times: usize) -> (usize, Taken) {
    let folder = tempfile::tempdir().unwrap();
    let files = (input.files)(times);
    let size = files.iter().map(|(_, bytes)| bytes.len()).sum();
    for (path, bytes) in files {
        let path = folder.path().join(path);
        fs::create_dir_all(path.parent().unwrap()).unwrap();
        fs::write(path, bytes).unwrap();
    }
    (size, measured(folder.path(), input.args))
}

/// Runs the binary under GNU time, which tells its time and its largest resident set.
fn measured(folder: &Path, args: &[&str]) -> Taken {
    let figures = folder.join(".figures");
    let mut command = Command::new("/usr/bin/time");
    command
        .args(["-q", "-f", "%e %M", "-o"])
        .arg(&figures)
        .arg(binary())
        .args(args);
    let output = command.current_dir(folder).output().unwrap();
    let figures = fs::read_to_string(figures).unwrap();
    let mut figures = figures
        .split_whitespace()
        .map(|figure| figure.parse::<f64>().unwrap());
    let (seconds, kibibytes) = (figures.next().unwrap(), figures.next().unwrap());
    let err = String::from_utf8_lossy(&output.stderr).into_owned();
    Taken {
        exit: output.status.code(),
        seconds,
        mebibytes: kibibytes / 1024.0,
        err,
    }
}

/// The binary of this build, or another one to compare with.
fn binary() -> OsString {
    std::env::var_os("MHLINT").unwrap_or_else(|| env!("CARGO_BIN_EXE_mhlint").into())
}

#[test]
#[ignore = "times the release binary: cargo test --release -- --ignored bounded::"]
fn every_input_ends_with_a_verdict() {
    println!(
        "{:<48} {:>9} {:>8} {:>9}   {:>9} {:>8} {:>9}",
        "input", "KB", "s", "MiB", "10 x KB", "s", "MiB"
    );
    let mut failed = Vec::new();
    let inputs = [
        formats::INPUTS,
        long::INPUTS,
        macros::INPUTS,
        names::INPUTS,
        settings::INPUTS,
        worn::INPUTS,
    ];
    for input in inputs.into_iter().flatten() {
        let (size, taken) = run(input, input.times);
        let (large, more) = run(input, 10 * input.times);
        println!(
            "{:<48} {:>9.1} {:>8.2} {:>9.1}   {:>9.1} {:>8.2} {:>9.1}",
            input.name,
            size as f64 / 1000.0,
            taken.seconds,
            taken.mebibytes,
            large as f64 / 1000.0,
            more.seconds,
            more.mebibytes
        );
        if taken.exit != Some(input.exit) {
            failed.push(format!(
                "{}: exit {:?}, not {}: {}",
                input.name, taken.exit, input.exit, taken.err
            ));
        }
        if more.exit.is_none_or(|exit| exit > 3) {
            failed.push(format!(
                "{}, ten times: exit {:?}: {}",
                input.name, more.exit, more.err
            ));
        }
    }
    assert!(failed.is_empty(), "{}", failed.join("\n"));
}
