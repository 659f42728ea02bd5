//! `mhlint init`: a commented `mhlint.toml`.

use std::fs::OpenOptions;
use std::io::{ErrorKind, Write};
use std::path::Path;

use super::exit::{Exit, Failure};
use crate::config::{FILE_NAME, TEMPLATE};

pub(super) fn run(folder: Option<&Path>, out: &mut dyn Write) -> Result<Exit, Failure> {
    let folder = folder.unwrap_or(Path::new(""));
    if !folder.as_os_str().is_empty() && !folder.is_dir() {
        let shown = folder.display();
        return Err(Failure::Usage(format!(
            "there is no folder `{shown}`; make it first, or name the one of the data"
        )));
    }
    let file = folder.join(FILE_NAME);
    let shown = file.display();
    // The file is made only if there is none, so that two at a time cannot overwrite each other either.
    let made = OpenOptions::new().write(true).create_new(true).open(&file);
    let written = made.and_then(|mut made| made.write_all(TEMPLATE.as_bytes()));
    match written {
        Ok(()) => {}
        Err(error) if error.kind() == ErrorKind::AlreadyExists => {
            let remedy = "edit it, or remove it first; `mhlint config` shows what is in force";
            return Err(Failure::Usage(format!("`{shown}` is there already and was left alone: {remedy}")));
        }
        Err(error) => return Err(Failure::Usage(format!("cannot write `{shown}`: {error}"))),
    }
    writeln!(out, "wrote {shown}: every setting with its meaning, all of them commented out")?;
    Ok(Exit::Clean)
}
