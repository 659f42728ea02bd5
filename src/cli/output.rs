//! Where reports go: standard output or a file, which is either replaced as a whole or left alone.

use std::io;
use std::path::{Path, PathBuf};

use super::exit::Failure;
use super::one_of::not_one_of;
use mhlint_config::Config;
use mhlint_diag::Outcome;
use mhlint_engine::holds_asset;
use mhlint_fix::replace;
use mhlint_report::Format;
use mhlint_source::{folder_of, link_targets, resolved};

/// `FORMAT[=FILE]`.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) struct Target {
    /// How.
    pub(super) format: Format,
    /// Where to, standard output if none.
    pub(super) file: Option<PathBuf>,
}

impl Target {
    pub(super) fn parse(text: &str) -> Result<Self, String> {
        let (name, file) = text
            .split_once('=')
            .map_or((text, None), |(name, file)| (name, Some(file)));
        let known: Vec<&str> = Format::ALL.iter().map(|(name, _)| *name).collect();
        let found = Format::ALL.iter().find(|(known, _)| *known == name);
        let (_, format) = found.ok_or_else(|| not_one_of("report format", name, &known))?;
        if file == Some("") {
            return Err(format!(
                "missing file after `=`; use for example `{name}=report.txt`"
            ));
        }
        Ok(Self {
            format: *format,
            file: file.map(PathBuf::from),
        })
    }
}

/// The reports to write, `human` to standard output if none was asked for. Refuses before the run
/// what could not be written after it, or would overwrite what the run reads or writes besides.
pub(super) fn targets(asked: &[Target], config: &Config) -> Result<Vec<Target>, Failure> {
    refuse_shared(asked, config)?;
    if asked.is_empty() {
        return Ok(vec![Target {
            format: Format::Human,
            file: None,
        }]);
    }
    let to_stdout = asked.iter().filter(|target| target.file.is_none()).count();
    if to_stdout > 1 {
        return Err(Failure::Usage(format!(
            "{to_stdout} reports go to standard output; write all but one to a file with \
                `--report FORMAT=FILE`"
        )));
    }
    let files: Vec<&PathBuf> = asked
        .iter()
        .filter_map(|target| target.file.as_ref())
        .collect();
    files
        .iter()
        .try_for_each(|file| refuse_unwritable("a report", file))?;
    let mut places: Vec<PathBuf> = files.into_iter().map(|file| resolved(file)).collect();
    places.sort_unstable();
    if let Some(twice) = places
        .windows(2)
        .find(|pair| pair.first() == pair.last())
        .and_then(<[_]>::first)
    {
        return Err(Failure::Usage(format!(
            "two reports go to `{}`; use a different file for each",
            twice.display()
        )));
    }
    Ok(asked.to_vec())
}

/// Refuses a report or baseline in place of the baseline or the configuration.
fn refuse_shared(asked: &[Target], config: &Config) -> Result<(), Failure> {
    let settings = config
        .file
        .as_ref()
        .map(|file| ("the configuration file", resolved(Path::new(&file.path))));
    let baseline = config
        .baseline
        .as_deref()
        .map(|file| ("the baseline", resolved(file)));
    let reports = asked
        .iter()
        .filter_map(|target| Some(("a report", target.file.as_deref()?)));
    let baselines = config
        .baseline
        .as_deref()
        .filter(|_| config.write_baseline)
        .map(|file| ("the baseline", file));
    for (what, file) in reports.chain(baselines) {
        let place = resolved(file);
        let taken = settings
            .iter()
            .chain(&baseline)
            .find(|(other, taken)| *other != what && *taken == place);
        if let Some((other, _)) = taken {
            let shown = file.display();
            return Err(Failure::Usage(format!(
                "cannot write {what} to `{shown}`: that is {other}; use another file"
            )));
        }
    }
    Ok(())
}

/// Refuses a file that `what` could not be written to.
pub(super) fn refuse_unwritable(what: &str, file: &Path) -> Result<(), Failure> {
    let shown = file.display();
    if file.is_dir() {
        return Err(Failure::Usage(format!(
            "cannot write {what} to `{shown}`: it is a folder; use a file in it"
        )));
    }
    let behind = link_targets(file).pop();
    if behind.as_ref().is_some_and(|end| end.is_symlink()) {
        return Err(Failure::Usage(format!(
            "cannot write {what} to `{shown}`: the link leads back to itself; use another file"
        )));
    }
    let parent = folder_of(behind.as_deref().unwrap_or(file));
    if !parent.is_dir() {
        let folder = parent.display();
        let whose = if behind.is_some() {
            ", which the link leads to,"
        } else {
            ""
        };
        return Err(Failure::Usage(format!(
            "cannot write {what} to `{shown}`: folder `{folder}`{whose} does not exist; create it \
                first"
        )));
    }
    Ok(())
}

/// Refuses a report in place of what was checked, before anything is written.
pub(super) fn refuse_asset(
    targets: &[Target],
    paths: &[PathBuf],
    config: &Config,
    outcome: &Outcome,
) -> Result<(), Failure> {
    let is_path = |file: &Path| {
        paths
            .iter()
            .any(|path| path.is_file() && resolved(path) == resolved(file))
    };
    let mut files = targets.iter().filter_map(|target| target.file.as_deref());
    let is_asset = |file: &&Path| {
        file.is_file() && (is_path(file) || holds_asset(outcome, file, &config.systems))
    };
    files.find(is_asset).map_or(Ok(()), |file| {
        let (shown, remedy) = (file.display(), "use a file outside the data");
        Err(Failure::Usage(format!(
            "cannot write a report to `{shown}`: it is an asset and would be overwritten; {remedy}"
        )))
    })
}

/// Writes `what` to a file.
pub(super) fn write_file(what: &str, file: &Path, bytes: &[u8]) -> Result<(), Failure> {
    let shown = file.display();
    replace(file, bytes).map_err(|error| {
        let remedy = remedy(&error);
        Failure::Usage(format!(
            "cannot write {what} to `{shown}`: {error}; {remedy}"
        ))
    })
}

/// What to do about a write that failed.
pub(super) fn remedy(error: &io::Error) -> &'static str {
    match error.kind() {
        io::ErrorKind::StorageFull | io::ErrorKind::QuotaExceeded => {
            "free some space, or use a file on another disk"
        }
        io::ErrorKind::PermissionDenied | io::ErrorKind::ReadOnlyFilesystem => {
            "use a file in a folder that you can write to"
        }
        io::ErrorKind::BrokenPipe => {
            "the program that reads it has ended; keep it running, or use a file"
        }
        _ => "use another file",
    }
}
