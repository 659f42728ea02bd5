//! Bases and files for the cases of one file.

use std::collections::BTreeMap;
use std::path::Path;

use super::Kind;
use super::inputs::{self, File};
use super::roots::Roots;
use crate::{Error, Evaluation, SliderSetting};
use mhlint_eval::scene::Setting;
use mhlint_eval::vector::Point;
use mhlint_json::Node;

/// Opens a base of a data folder, over system data if there are any; without a name the only one.
pub type OpenBase = fn(&Path, Option<&Path>, Option<&str>) -> Result<Evaluation, Error>;

/// What the cases of one file are computed from; bases are opened once.
pub(crate) struct Computer<'a> {
    pub(crate) roots: &'a Roots,
    pub(crate) file: &'a Node,
    kind: &'static Kind,
    open: OpenBase,
    bases: BTreeMap<Option<String>, Result<Evaluation, Error>>,
    /// Vertices that the case asked for, besides those of its outputs.
    pub(crate) work: usize,
}

impl<'a> Computer<'a> {
    pub(super) fn new(
        kind: &'static Kind,
        roots: &'a Roots,
        file: &File<'a>,
        open: OpenBase,
    ) -> Self {
        Self {
            roots,
            file: file.root,
            kind,
            open,
            bases: BTreeMap::new(),
            work: 0,
        }
    }

    /// The base that a case names, or else the file; without one the only base, or the only one
    /// with macros.
    pub(crate) fn base(&mut self, case: &Node) -> Result<&mut Evaluation, Error> {
        let common = || {
            self.file
                .get("inputs")
                .and_then(|inputs| inputs.get("base"))
        };
        let name = inputs::field(case, "base")
            .or_else(common)
            .and_then(Node::as_str);
        self.base_called(name)
    }

    pub(crate) fn base_called(&mut self, name: Option<&str>) -> Result<&mut Evaluation, Error> {
        let data = self.roots.data(self.kind.application)?;
        let opened = self
            .bases
            .entry(name.map(str::to_owned))
            .or_insert_with(|| open(self.open, &data, name));
        self.work += opened
            .as_ref()
            .map_or(0, |base| base.scene().positions.len());
        opened.as_mut().map_err(|error| error.clone())
    }
}

fn open(open: OpenBase, data: &Path, name: Option<&str>) -> Result<Evaluation, Error> {
    match open(data, None, name) {
        Err(Error::BaseNeeded { known, with_macros }) => match with_macros.as_slice() {
            [only] => open(data, None, Some(only)),
            _ => Err(Error::Input(format!(
                "the case names no base mesh (known: {})",
                known.join(", ")
            ))),
        },
        other => other,
    }
}

/// The mesh at the settings of a case.
pub(crate) fn morphed(
    base: &mut Evaluation,
    modifiers: Option<Vec<SliderSetting>>,
    notes: &mut Vec<String>,
) -> Result<Vec<Point>, Error> {
    let Some(modifiers) = modifiers else {
        return Ok(base.scene().positions.clone());
    };
    let setting = setting(base, &modifiers, notes);
    base.morphed(&setting)
}

/// The settings of a case; names that no slider has are left out.
pub(crate) fn setting(
    base: &Evaluation,
    modifiers: &[SliderSetting],
    notes: &mut Vec<String>,
) -> Setting {
    let (setting, unknown) = base.model_setting(modifiers);
    let left_out = |name| {
        format!(
            "unknown slider `{name}` ignored, as in {}",
            base.application
        )
    };
    notes.extend(unknown.into_iter().map(left_out));
    setting
}
