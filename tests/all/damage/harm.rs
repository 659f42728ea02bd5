//! The corpus in memory, and damage done to it.

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};
use std::sync::Arc;

use super::cases::Edit;

/// Files by path below the corpus; the bytes are shared by all cases.
pub(crate) type Files = BTreeMap<String, Arc<[u8]>>;

pub(crate) fn corpus() -> PathBuf {
    let corpora = std::env::var_os("MHLINT_CORPORA")
        .expect("MHLINT_CORPORA names the folder that holds the corpora");
    PathBuf::from(corpora).join("makehuman2")
}

/// Everything below `folder` but photographs and what belongs to the base `without`.
pub(crate) fn load(folder: &Path, without: &str) -> Files {
    let mut files = Files::new();
    let foreign = format!("/{without}/");
    for entry in walkdir::WalkDir::new(folder) {
        let entry = entry.unwrap();
        let path = entry
            .path()
            .strip_prefix(folder)
            .unwrap()
            .to_str()
            .unwrap()
            .replace('\\', "/");
        let wanted =
            !path.contains(&foreign) && Path::new(&path).extension().is_none_or(|ext| ext != "jpg");
        if entry.file_type().is_file() && wanted {
            files.insert(path, std::fs::read(entry.path()).unwrap().into());
        }
    }
    files
}

/// Does the damage, or says why it cannot be done.
pub(crate) fn apply(files: &mut Files, edit: &Edit) -> Result<(), String> {
    let path = |file: &str| format!("data/{file}");
    let known = |file: &str| {
        files
            .get(&path(file))
            .map(Arc::clone)
            .ok_or(format!("there is no `{file}`"))
    };
    match *edit {
        Edit::Replace(file, find, replace) => {
            let bytes = known(file)?;
            let text = std::str::from_utf8(&bytes).unwrap();
            if !text.contains(find) {
                return Err(format!("`{file}` does not hold `{find}`"));
            }
            files.insert(
                path(file),
                text.replacen(find, replace, 1).into_bytes().into(),
            );
        }
        Edit::Insert(file, at, bytes) => {
            let mut all = known(file)?.to_vec();
            all.splice(at..at, bytes.iter().copied());
            files.insert(path(file), all.into());
        }
        Edit::Cut(file, length) => {
            let cut = known(file)?[..length].into();
            files.insert(path(file), cut);
        }
        Edit::Write(file, bytes) => {
            files.insert(path(file), bytes.into());
        }
        Edit::Remove(file) => {
            known(file)?;
            files.remove(&path(file));
        }
        Edit::Copy(from, to) => {
            let bytes = known(from)?;
            files.insert(path(to), bytes);
        }
        Edit::Zero(file, vertices) => {
            let zeroed = zeroed(std::str::from_utf8(&known(file)?).unwrap(), vertices);
            files.insert(path(file), zeroed.into_bytes().into());
        }
        Edit::Move(file, moves) => {
            let displaced = displaced(std::str::from_utf8(&known(file)?).unwrap(), moves)?;
            files.insert(path(file), displaced.into_bytes().into());
        }
        Edit::Rename(from, to) => {
            let bytes = known(from)?;
            files.remove(&path(from));
            files.insert(path(to), bytes);
        }
    }
    Ok(())
}

/// A target whose displacements of some vertices are larger by so much.
fn displaced(text: &str, moves: &[(u32, [f64; 3])]) -> Result<String, String> {
    let mut lines: Vec<String> = text.lines().map(str::to_owned).collect();
    for (vertex, by) in moves {
        let start = format!("{vertex} ");
        let line = lines
            .iter_mut()
            .find(|line| line.starts_with(&start))
            .ok_or(format!("no row for {vertex}"))?;
        let delta: Vec<f64> = line
            .split(' ')
            .skip(1)
            .map(|word| word.parse().unwrap())
            .collect();
        *line = format!(
            "{vertex} {:.5} {:.5} {:.5}",
            delta[0] + by[0],
            delta[1] + by[1],
            delta[2] + by[2]
        );
    }
    Ok(lines.join("\n") + "\n")
}

/// A target that no longer moves some vertices.
fn zeroed(text: &str, vertices: &[u32]) -> String {
    let is_one = |line: &str| {
        let vertex = line
            .split(' ')
            .next()
            .and_then(|word| word.parse::<u32>().ok());
        vertex.filter(|vertex| vertices.contains(vertex))
    };
    let lines = text
        .lines()
        .map(|line| is_one(line).map_or(line.to_owned(), |vertex| format!("{vertex} 0 0 0")));
    lines.map(|line| line + "\n").collect()
}
