//! Rows of targets, read when a setting first needs them, and the mesh at a setting.

use std::cell::OnceCell;
use std::collections::BTreeMap;
use std::sync::Arc;

use super::error::Error;
use super::files::read_cause;
use super::opened::Evaluation;
use mhlint_diag::{Application, Tally};
use mhlint_discover::extension;
use mhlint_eval::macros::{MacroFault, MacroWork};
use mhlint_eval::proportion::{Lengths, MEDIAN_RATIO, Oversize, extent, is_torn_out, oversize};
use mhlint_eval::scene::{Setting, SettingError};
use mhlint_eval::tears::Neighbours;
use mhlint_eval::vector::Point;
use mhlint_formats::npz;
use mhlint_formats::obj::Mesh;
use mhlint_formats::target::{self, BlankFacts, Row, Target, TargetFacts};
use mhlint_repo::FileFacts;
use mhlint_source::{Encoding, gunzip};

impl Evaluation {
    /// The targets of a setting with their factors: places in the scene's targets, details before
    /// macros.
    ///
    /// # Errors
    /// Macros that stop the application.
    pub fn factors(&self, setting: &Setting) -> Result<Vec<(usize, f64)>, Error> {
        self.scene
            .factors(setting, &mut MacroWork::default())
            .map_err(|error| self.setting_error(error))
    }

    /// The mesh at a setting, without seam duplicates.
    ///
    /// # Errors
    /// Macros that stop the application; a target that is missing or cannot be used.
    pub fn morphed(&mut self, setting: &Setting) -> Result<Vec<Point>, Error> {
        let factors = self.factors(setting)?;
        self.with_factors(&factors)
    }

    /// The mesh with targets of the scene.
    ///
    /// # Errors
    /// A target that is missing or cannot be used.
    fn with_factors(&mut self, factors: &[(usize, f64)]) -> Result<Vec<Point>, Error> {
        self.need_rows(factors.iter().map(|(target, _)| *target))?;
        let mut positions = self.scene.positions.clone();
        self.scene
            .add(&mut positions, factors)
            .map_err(|error| self.setting_error(error))?;
        Ok(positions)
    }

    /// Reads the rows of targets, as far as they are not known. An archive is read once for all of
    /// them.
    pub(super) fn need_rows(&mut self, targets: impl Iterator<Item = usize>) -> Result<(), Error> {
        let mut archive = None;
        for target in targets {
            self.need(target, &mut archive)?;
        }
        Ok(())
    }

    fn need(&mut self, target: usize, archive: &mut Option<Vec<u8>>) -> Result<(), Error> {
        let Some(known) = self.scene.targets.get(target) else {
            return Ok(());
        };
        if known.rows.is_some() {
            return Ok(());
        }
        let member = self
            .archive
            .as_ref()
            .and_then(|(path, members)| Some((path, members.get(&known.name)?)));
        let rows = match member {
            Some((path, member)) => self.read_archived(path, &known.name, member, archive)?,
            None => self.read_rows(&known.path, &known.name)?,
        };
        // Rows for seam duplicates are accepted and overwritten by the application.
        let vertices = self.size.vertices;
        let rows = rows.into_iter().filter(|row| (row.0 as usize) < vertices);
        let rows = if self.adds_rows() {
            added(rows)
        } else {
            rows.collect()
        };
        if let Some(known) = self.scene.targets.get_mut(target) {
            known.rows = Some(Arc::new(rows));
        }
        Ok(())
    }

    /// The bytes of a file for the target `name`.
    fn read_file(&self, path: &str, name: &str) -> Result<Vec<u8>, Error> {
        let (tree, entry) = self.entry(path).ok_or_else(|| self.missing(name))?;
        tree.read(entry, &self.limits)
            .map_err(|fault| Error::file(path, read_cause(&fault)))
    }

    fn read_rows(&self, path: &str, name: &str) -> Result<Vec<Row>, Error> {
        let bytes = self.read_file(path, name)?;
        let bytes = if extension(path) == "gz" {
            self.unpacked(path, &bytes)?
        } else {
            bytes
        };
        let encoding = Encoding::of(&bytes);
        if encoding.lfs_pointer {
            return Err(Error::file(
                path,
                "it is a Git LFS pointer; fetch the file with `git lfs pull`",
            ));
        }
        let target = target::parse_file(&bytes, &encoding, Some(self.size));
        let target = target.ok_or_else(|| Error::file(path, "it is not a target"))?;
        if self.adds_rows() {
            return rows_split_at_blanks(&target, &bytes, self.size.vertices)
                .map_err(|cause| Error::file(path, cause));
        }
        unusable(&target.facts).map_or(Ok(target.rows), |cause| Err(Error::file(path, cause)))
    }

    /// The rows of a target that the application takes from an archive; `archive` has its bytes
    /// once they are read.
    fn read_archived(
        &self,
        path: &str,
        name: &str,
        member: &str,
        archive: &mut Option<Vec<u8>>,
    ) -> Result<Vec<Row>, Error> {
        if self.application != Application::Makehuman1 {
            let reason = format!(
                "{} takes `{name}` from this archive, which mhlint cannot evaluate; move the \
                 archive away to evaluate the text file",
                self.application,
            );
            return Err(Error::file(path, reason));
        }
        let bytes = match archive {
            Some(bytes) => bytes,
            None => archive.insert(self.read_file(path, name)?),
        };
        let rows = npz::targets::rows(bytes, &self.limits, member);
        let rows =
            rows.ok_or_else(|| Error::file(path, format!("`{name}` cannot be read from it")))?;
        match rows
            .iter()
            .find(|row| row.0 as usize >= self.size.with_seams)
        {
            Some((vertex, _)) => Err(Error::file(
                path,
                format!("`{name}` moves vertex {vertex}, which does not exist"),
            )),
            None => Ok(rows),
        }
    }

    /// The text of a packed target. One without a byte is an empty target.
    fn unpacked(&self, path: &str, bytes: &[u8]) -> Result<Vec<u8>, Error> {
        if bytes.is_empty() || Encoding::of(bytes).lfs_pointer {
            return Ok(bytes.to_vec());
        }
        gunzip(bytes, &self.limits).map_err(|_| Error::file(path, "it cannot be unpacked"))
    }

    fn missing(&self, name: &str) -> Error {
        Error::MissingTarget {
            application: self.application,
            name: name.to_owned(),
        }
    }

    fn setting_error(&self, error: SettingError) -> Error {
        match error {
            SettingError::Unusable { target } => self.missing(
                self.scene
                    .targets
                    .get(target)
                    .map_or("", |target| &target.name),
            ),
            SettingError::Macro(MacroFault::Makehuman2(error)) => self.macro_error(error),
            SettingError::Morph(error) => Error::index(self.application, error),
        }
    }
}

/// The rows of each vertex as one.
fn added(rows: impl Iterator<Item = Row>) -> Vec<Row> {
    let mut sums: BTreeMap<u32, [f32; 3]> = BTreeMap::new();
    for (vertex, delta) in rows {
        let sum = sums.entry(vertex).or_default();
        sum.iter_mut()
            .zip(delta)
            .for_each(|(sum, delta)| *sum += delta);
    }
    sums.into_iter().collect()
}

/// Finds targets whose rows rules report for themselves: looking at them again in every setting
/// would say it many times.
pub(super) struct Suspects<'m> {
    mesh: &'m Mesh,
    extent: Option<f32>,
    neighbours: OnceCell<Neighbours>,
}

impl<'m> Suspects<'m> {
    pub(super) fn new(mesh: &'m Mesh) -> Self {
        Self {
            mesh,
            extent: extent(&mesh.positions),
            neighbours: OnceCell::new(),
        }
    }

    pub(super) fn has(&self, file: &FileFacts) -> bool {
        file.target()
            .is_some_and(|facts| facts.non_finite.count > 0 || self.is_oversized(facts))
    }

    fn is_oversized(&self, facts: &TargetFacts) -> bool {
        let Some((largest, size)) = facts.largest.zip(self.extent) else {
            return false;
        };
        let lengths = Lengths {
            longest: largest.length,
            median: facts.median_length,
            tail: facts.tail_length,
        };
        match oversize(lengths, size, MEDIAN_RATIO) {
            Some(Oversize::Outlier) => {
                let neighbours = self.neighbours.get_or_init(|| {
                    Neighbours::new(self.mesh.positions.len(), self.mesh.vertices_of_faces())
                });
                is_torn_out(&facts.longest, facts.tail_length, largest.index, neighbours)
            }
            oversized => oversized.is_some(),
        }
    }
}

/// Whether a target is evaluated: whether its rows say what applications can do.
pub(super) fn is_usable(target: &TargetFacts) -> bool {
    target.unreadable_rows == 0 && target.negative.count == 0 && target.out_of_range.count == 0
}

/// The rows as MPFB takes them: four fields split at single blanks, an index below 0 counts from
/// the end, one that is too large is passed over (`docs/loaders/mpfb/targets.md#rows`). What stops
/// it otherwise.
fn rows_split_at_blanks(target: &Target, text: &[u8], vertices: usize) -> Result<Vec<Row>, String> {
    let facts = &target.facts;
    if facts.blanks.is_none() && facts.negative.count == 0 {
        let in_range = TargetFacts {
            out_of_range: Tally::default(),
            ..facts.clone()
        };
        return unusable(&in_range).map_or(Ok(target.rows.clone()), Err);
    }
    facts
        .blanks
        .as_ref()
        .and_then(|blanks| at_blanks(blanks))
        .map_or(Ok(()), Err)?;
    let count = i64::try_from(vertices).unwrap_or(i64::MAX);
    let mut rows = Vec::new();
    for (index, delta) in target::rows_at_blanks(text) {
        let from_start = if index < 0 { index + count } else { index };
        match u32::try_from(from_start) {
            Ok(vertex) if from_start < count => rows.push((vertex, delta)),
            Ok(_) => {}
            Err(_) if from_start < 0 => return Err(format!("vertex {index} does not exist")),
            Err(_) => {}
        }
    }
    Ok(rows)
}

/// The first line at which a loader stops that splits at single blanks.
fn at_blanks(blanks: &BlankFacts) -> Option<String> {
    let of_line = |(line, cause): (u32, String)| format!("line {line}: {cause}");
    let separator = blanks.separators.first.first();
    let separator = separator.map(|(line, _)| {
        (
            *line,
            "its fields are not separated by single blanks".to_owned(),
        )
    });
    let few = blanks
        .few
        .first
        .first()
        .map(|(line, fields)| (*line, format!("{fields} fields instead of 4")));
    let field = blanks
        .unreadable
        .as_ref()
        .map(|field| (field.line, format!("`{}` is not a number", field.field)));
    [separator, few, field]
        .into_iter()
        .flatten()
        .min()
        .map(of_line)
}

fn unusable(target: &TargetFacts) -> Option<String> {
    if is_usable(target) {
        return None;
    }
    if let Some(bad) = target.unreadable.first() {
        return Some(format!(
            "line {}: `{}` is not a number",
            bad.line, bad.field
        ));
    }
    if target.negative.count > 0 {
        return Some(format!(
            "rows with a negative vertex number: {}",
            target.negative.count
        ));
    }
    Some(format!(
        "rows for vertices that the mesh does not have: {}",
        target.out_of_range.count
    ))
}
