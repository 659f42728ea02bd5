//! `mhlint init`: a commented `mhlint.toml`.

use std::fs::OpenOptions;
use std::io::{ErrorKind, Write};
use std::path::Path;

use super::exit::{Exit, Failure};
use super::output::remedy;
use mhlint_config::{FILE_NAME, TEMPLATE, find, template_for};
use mhlint_engine::{Proposal, propose};
use mhlint_report::printable;

pub(super) fn run(
    folder: Option<&Path>,
    out: &mut dyn Write,
    err: &mut dyn Write,
) -> Result<Exit, Failure> {
    let folder = folder.unwrap_or(Path::new("."));
    if !folder.is_dir() {
        let shown = folder.display();
        return Err(Failure::Usage(format!(
            "folder `{shown}` does not exist; create it first, or use the folder of the data"
        )));
    }
    let file = if folder == Path::new(".") {
        FILE_NAME.into()
    } else {
        folder.join(FILE_NAME)
    };
    let shown = file.display();
    let above = find(folder);
    // A folder that cannot be read has no assets; whether the file can be made is another matter.
    let proposal = propose(folder).unwrap_or_default();
    // The file is made only if there is none, so that two at a time cannot overwrite each other
    // either.
    let made = OpenOptions::new().write(true).create_new(true).open(&file);
    let written = made.and_then(|mut made| made.write_all(text(proposal.as_ref()).as_bytes()));
    match written {
        Ok(()) => {}
        Err(error) if error.kind() == ErrorKind::AlreadyExists => {
            let remedy =
                "edit it, or remove it first (`mhlint config` shows the settings in effect)";
            return Err(Failure::Usage(format!(
                "`{shown}` already exists and was not changed; {remedy}"
            )));
        }
        Err(error) => {
            return Err(Failure::Usage(format!(
                "cannot write `{shown}`: {error}; {}",
                remedy(&error)
            )));
        }
    }
    writeln!(
        out,
        "wrote {}: {}",
        printable(&shown.to_string()),
        printable(&summary(proposal.as_ref()))
    )?;
    if let Some(above) = above {
        let above = above.display();
        let remedy = "copy its settings to the new file, or remove the new file";
        writeln!(
            err,
            "mhlint: `{above}` no longer applies in `{}`; {remedy}",
            folder.display()
        )?;
    }
    Ok(Exit::Clean)
}

fn text(proposal: Option<&Proposal>) -> String {
    let Some(Proposal {
        applications,
        system,
    }) = proposal
    else {
        return TEMPLATE.to_owned();
    };
    let names: Vec<&str> = applications
        .iter()
        .map(|application| application.word())
        .collect();
    template_for(&names, system.as_deref())
}

/// What is in the file.
fn summary(proposal: Option<&Proposal>) -> String {
    let Some(Proposal {
        applications,
        system,
    }) = proposal
    else {
        return "all settings, explained and commented out".to_owned();
    };
    let names: Vec<String> = applications.iter().map(ToString::to_string).collect();
    let system = match system {
        Some(system) => format!("with the system data in `{system}`"),
        None => "without system data, which were not found near the folder".to_owned(),
    };
    format!(
        "checks the assets for {}, {system}; all other settings are explained and commented out",
        names.join(" and ")
    )
}
