//! The files to write, collected in memory: relative path to bytes.
//!
//! `replace_in` deletes the generated layers of an earlier run and writes all files. It must never
//! delete a folder that it does not recognise as its own work.

use std::collections::BTreeMap;
use std::fs;
use std::io;
use std::path::Path;

/// A folder that only this generator makes in each layer; its presence allows the layer to be
/// replaced.
const LAYERS: [(&str, &str); 2] = [("data", "base/figure"), ("user", "base/imp")];

pub(crate) struct Tree {
    files: BTreeMap<String, Vec<u8>>,
}

impl Tree {
    pub(crate) fn new() -> Self {
        Self {
            files: BTreeMap::new(),
        }
    }

    /// Adds a file; `path` is relative, with forward slashes.
    pub(crate) fn add(&mut self, path: impl Into<String>, content: impl Into<Vec<u8>>) {
        let path = path.into();
        let earlier = self.files.insert(path.clone(), content.into());
        assert!(earlier.is_none(), "{path} is generated twice");
    }

    pub(crate) fn replace_in(&self, folder: &Path) -> io::Result<()> {
        for (layer, mark) in LAYERS {
            remove_layer(&folder.join(layer), mark)?;
        }
        for (path, content) in &self.files {
            let file = folder.join(path);
            if let Some(parent) = file.parent() {
                fs::create_dir_all(parent)?;
            }
            fs::write(file, content)?;
        }
        Ok(())
    }

    /// Paths of the files that are missing, others or too many in `folder`.
    #[cfg(test)]
    pub(crate) fn differences(
        &self,
        folder: &Path,
    ) -> Result<Vec<String>, Box<dyn std::error::Error>> {
        let mut found = BTreeMap::new();
        for entry in walkdir::WalkDir::new(folder) {
            let entry = entry?;
            if entry.file_type().is_file() {
                let path = entry
                    .path()
                    .strip_prefix(folder)?
                    .to_string_lossy()
                    .replace('\\', "/");
                found.insert(path, fs::read(entry.path())?);
            }
        }
        let paths: std::collections::BTreeSet<&String> =
            found.keys().chain(self.files.keys()).collect();
        let differs = paths
            .into_iter()
            .filter(|path| found.get(*path) != self.files.get(*path));
        Ok(differs.cloned().collect())
    }
}

fn remove_layer(layer: &Path, mark: &str) -> io::Result<()> {
    if !layer.exists() {
        return Ok(());
    }
    if !layer.join(mark).is_dir() {
        let text = format!(
            "{} was not made by this generator (no {mark} in it)",
            layer.display()
        );
        return Err(io::Error::other(text));
    }
    fs::remove_dir_all(layer)
}
