//! Rows of targets, read when a setting first needs them, and the mesh at a setting.

use super::error::Error;
use super::files::read_cause;
use super::open::Evaluation;
use crate::engine::compose::is_usable;
use crate::engine::load::read;
use crate::eval::component::ComponentFault;
use crate::eval::macro_eval::MacroResult;
use crate::eval::macros::{MacroError, MacroTable};
use crate::eval::scene::{Setting, SettingError};
use crate::eval::vector::Point;
use crate::formats::target::Row;
use crate::repo::FileFacts;

impl Evaluation {
    /// The targets of a setting with their factors: places in the scene's targets, details before macros.
    ///
    /// # Errors
    /// Macros that stop the application.
    pub fn factors(&self, setting: &Setting) -> Result<Vec<(usize, f64)>, Error> {
        self.scene.factors(setting, &mut MacroResult::default()).map_err(|error| self.setting_error(error))
    }

    /// The mesh at a setting, without seam duplicates.
    ///
    /// # Errors
    /// Macros that stop the application; a target that is missing or cannot be used.
    pub fn morphed(&mut self, setting: &Setting) -> Result<Vec<Point>, Error> {
        let factors = self.factors(setting)?;
        for (target, _) in &factors {
            self.need_rows(*target)?;
        }
        let mut positions = self.scene.positions.clone();
        self.scene.add(&mut positions, &factors).map_err(|error| self.setting_error(error))?;
        Ok(positions)
    }

    /// Every combination of the macros at a setting.
    ///
    /// # Errors
    /// No macros, or macros that stop the application.
    pub fn macros(&self, setting: &Setting) -> Result<(&MacroTable, MacroResult), Error> {
        let base = self.base.clone();
        let table = self.scene.macros.as_ref().filter(|_| self.macros.is_ok());
        let table = table
            .ok_or_else(|| Error::NoMacros { base, reason: self.macros.as_ref().err().cloned().unwrap_or_default() })?;
        let mut result = MacroResult::default();
        let evaluated = table.evaluate(&setting.macros, &mut result);
        evaluated.map_err(|error| self.setting_error(SettingError::Macro(error)))?;
        Ok((table, result))
    }

    fn need_rows(&mut self, target: usize) -> Result<(), Error> {
        let Some(known) = self.scene.targets.get(target) else { return Ok(()) };
        if known.rows.is_some() {
            return Ok(());
        }
        if let Some((path, _)) = self.archive.as_ref().filter(|(_, members)| members.contains(&known.name)) {
            let reason = format!(
                "MakeHuman 2 takes `{}` from it, and targets are only evaluated from text here; evaluate without the archive",
                known.name
            );
            return Err(Error::file(path, reason));
        }
        let rows = self.read_rows(&known.path, &known.name)?;
        // Rows for seam duplicates are accepted and overwritten by the application.
        let vertices = self.size.vertices;
        let rows = rows.into_iter().filter(|row| (row.index as usize) < vertices);
        let rows = rows.map(|row| (row.index, row.delta)).collect();
        if let Some(known) = self.scene.targets.get_mut(target) {
            known.rows = Some(rows);
        }
        Ok(())
    }

    fn read_rows(&self, path: &str, name: &str) -> Result<Vec<Row>, Error> {
        let (tree, entry) = self.entry(path).ok_or_else(|| Error::MissingTarget(name.to_owned()))?;
        // Only the ending counts for the kind; the path below the data root is not known here.
        let rel = format!("target/{}/{name}.target", self.base);
        let reading = read::read(tree, entry, &rel, &self.limits, Some(self.size));
        match unusable(&reading.facts) {
            Some(cause) => Err(Error::file(path, cause)),
            None => Ok(reading.rows),
        }
    }

    fn setting_error(&self, error: SettingError) -> Error {
        match error {
            SettingError::Unusable { target } => {
                Error::MissingTarget(self.scene.targets.get(target).map_or_else(String::new, |t| t.name.clone()))
            }
            SettingError::Macro(error) => self.macro_error(error),
            SettingError::Morph(error) => error.into(),
        }
    }

    fn macro_error(&self, error: MacroError) -> Error {
        let MacroError::Component { component, fault } = error else {
            return Error::NoMacros { base: self.base.clone(), reason: error.to_string() };
        };
        let name = self.macros.as_ref().ok().and_then(|macros| {
            // The table holds the components that have a pattern.
            let used =
                macros.components.iter().filter(|c| c.pattern.is_some() && (c.steps.is_some() || c.sum.is_some()));
            used.map(|c| c.name.as_str()).nth(component)
        });
        Error::Stops {
            exception: exception(fault),
            reason: format!("macro component `{}`: {fault}", name.unwrap_or("?")),
        }
    }
}

/// What Python raises (formats/makehuman2.md §3.4).
fn exception(fault: ComponentFault) -> &'static str {
    match fault {
        ComponentFault::EqualSteps => "ZeroDivisionError",
        ComponentFault::NotBarycentric(_) => "TypeError",
        ComponentFault::MissingValue(_)
        | ComponentFault::MissingSum(_)
        | ComponentFault::FourthCorner
        | ComponentFault::MissingSetting(_) => "IndexError",
    }
}

/// Why the application cannot load or apply a target.
fn unusable(facts: &FileFacts) -> Option<String> {
    if let Some(fault) = &facts.unreadable {
        return Some(read_cause(fault));
    }
    let Some(target) = facts.target() else {
        let pointer = facts.encoding.lfs_pointer;
        return Some(if pointer { "it is a Git LFS pointer".to_owned() } else { "it is no target".to_owned() });
    };
    if is_usable(facts) {
        return None;
    }
    if let Some(bad) = target.unreadable.first() {
        return Some(format!("line {}: `{}` is no number", bad.line, bad.field));
    }
    if target.negative.count > 0 {
        return Some(format!("{} rows have a negative vertex", target.negative.count));
    }
    Some(format!("{} rows move vertices that the mesh does not have", target.out_of_range.count))
}
