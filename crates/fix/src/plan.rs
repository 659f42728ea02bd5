//! Which fixes can be done together: a fix is taken as a whole, and only if it touches nothing that
//! another fix of the same turn changes. The others wait for the next turn, when the file was
//! checked again.

use std::collections::BTreeMap;

use mhlint_diag::Edit;

/// What a fix does to one file.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Patch {
    /// Some of its bytes become others.
    Edits(Vec<Edit>),
    /// The file goes away.
    Remove,
}

/// The fixes of one turn, by file.
#[derive(Debug, Default)]
pub struct Plan {
    files: BTreeMap<String, Planned>,
}

/// What is to be done to one file.
#[derive(Debug)]
enum Planned {
    /// Edits by where they begin; they do not meet.
    Edits(BTreeMap<usize, Edit>),
    Remove,
}

impl Plan {
    /// Takes a fix in, whole or not at all. `false`: it has to wait, or changes nothing. A fix has
    /// one patch for a file.
    pub fn accept(&mut self, fix: Vec<(String, Patch)>) -> bool {
        let mut taken = Vec::with_capacity(fix.len());
        for (path, patch) in fix {
            let Some(patch) = self.fitting(&path, patch) else {
                return false;
            };
            taken.push((path, patch));
        }
        taken.retain(|(_, patch)| !matches!(patch, Patch::Edits(edits) if edits.is_empty()));
        let accepted = !taken.is_empty();
        for (path, patch) in taken {
            self.add(path, patch);
        }
        accepted
    }

    /// The patch with its edits in order, unless some of them meet one another or those that are
    /// planned.
    fn fitting(&self, file: &str, patch: Patch) -> Option<Patch> {
        match (self.files.get(file), patch) {
            (None, Patch::Remove) => Some(Patch::Remove),
            (None, Patch::Edits(edits)) => sorted(edits).map(Patch::Edits),
            (Some(Planned::Edits(known)), Patch::Edits(edits)) => {
                let edits = sorted(edits)?;
                edits
                    .iter()
                    .all(|edit| is_apart(known, edit))
                    .then_some(Patch::Edits(edits))
            }
            (Some(_), _) => None,
        }
    }

    fn add(&mut self, file: String, patch: Patch) {
        match patch {
            Patch::Remove => {
                self.files.insert(file, Planned::Remove);
            }
            Patch::Edits(edits) => {
                let planned = self
                    .files
                    .entry(file)
                    .or_insert_with(|| Planned::Edits(BTreeMap::new()));
                if let Planned::Edits(known) = planned {
                    known.extend(edits.into_iter().map(|edit| (edit.range.start, edit)));
                }
            }
        }
    }

    /// Whether there is nothing to do.
    pub fn is_empty(&self) -> bool {
        self.files.is_empty()
    }

    /// What is to be done, by file.
    pub fn into_files(self) -> BTreeMap<String, Patch> {
        let patch = |planned| match planned {
            Planned::Edits(edits) => Patch::Edits(edits.into_values().collect()),
            Planned::Remove => Patch::Remove,
        };
        self.files
            .into_iter()
            .map(|(path, planned)| (path, patch(planned)))
            .collect()
    }
}

/// Whether an edit meets neither the planned one before it nor the one behind it.
fn is_apart(known: &BTreeMap<usize, Edit>, edit: &Edit) -> bool {
    let before = known.range(..=edit.range.start).next_back();
    let behind = known.range(edit.range.start..).next();
    !before.is_some_and(|(_, before)| meet(before, edit))
        && !behind.is_some_and(|(_, behind)| meet(edit, behind))
}

/// Whether an edit meets one that does not begin before it.
fn meet(a: &Edit, b: &Edit) -> bool {
    a.range.start == b.range.start || b.range.start < a.range.end
}

fn sorted(mut edits: Vec<Edit>) -> Option<Vec<Edit>> {
    edits.sort_by_key(|edit| (edit.range.start, edit.range.end));
    let clash = edits
        .windows(2)
        .any(|pair| matches!(pair, [a, b] if meet(a, b)));
    (!clash).then_some(edits)
}

/// The text with edits that are sorted and do not meet, as a [`Plan`] gives them.
pub fn apply(text: &[u8], edits: &[Edit]) -> Vec<u8> {
    let mut out = Vec::with_capacity(text.len());
    let mut at = 0;
    for edit in edits {
        out.extend_from_slice(text.get(at..edit.range.start).unwrap_or_default());
        out.extend_from_slice(&edit.text);
        at = edit.range.end;
    }
    out.extend_from_slice(text.get(at..).unwrap_or_default());
    out
}

#[cfg(test)]
mod tests {
    use super::*;

    fn edits(edits: &[(usize, usize, &str)]) -> Patch {
        Patch::Edits(
            edits
                .iter()
                .map(|(from, to, text)| Edit::replacement(*from..*to, *text))
                .collect(),
        )
    }

    fn on(file: &str, patch: Patch) -> (String, Patch) {
        (file.to_owned(), patch)
    }

    #[test]
    fn fixes_that_meet_wait() {
        let mut plan = Plan::default();
        assert!(plan.accept(vec![on("a", edits(&[(4, 6, "x")]))]));
        assert!(
            plan.accept(vec![on("a", edits(&[(0, 4, ""), (6, 7, "yz")]))]),
            "neighbours do not meet"
        );
        assert!(!plan.accept(vec![on("a", edits(&[(5, 8, "")]))]));
        assert!(!plan.accept(vec![on("a", edits(&[(4, 4, "before")]))]));
        assert!(!plan.accept(vec![on("a", Patch::Remove)]));
        let files = plan.into_files();
        let Some(Patch::Edits(all)) = files.get("a") else {
            panic!("edits")
        };
        assert_eq!(apply(b"0123456789", all), b"xyz789");
    }

    #[test]
    fn many_fixes_of_one_file_lie_in_order() {
        let mut plan = Plan::default();
        for number in (0..1000).rev() {
            assert!(plan.accept(vec![on("a", edits(&[(2 * number, 2 * number + 1, "")]))]));
        }
        assert!(
            !plan.accept(vec![on("a", edits(&[(2001, 2002, ""), (7, 9, "")]))]),
            "one of them meets"
        );
        let Some(Patch::Edits(all)) = plan.into_files().remove("a") else {
            panic!("edits")
        };
        assert_eq!(
            (all.len(), all.is_sorted_by_key(|edit| edit.range.start)),
            (1000, true)
        );
    }

    #[test]
    fn a_fix_is_taken_whole_or_not_at_all() {
        let mut plan = Plan::default();
        assert!(plan.accept(vec![on("a", edits(&[(0, 1, "")]))]));
        assert!(!plan.accept(vec![
            on("b", edits(&[(0, 1, "")])),
            on("a", edits(&[(0, 2, "")]))
        ]));
        assert!(!plan.accept(vec![on("c", edits(&[]))]), "nothing to change");
        assert!(plan.accept(vec![on("d", Patch::Remove)]));
        assert_eq!(
            plan.into_files().into_keys().collect::<Vec<_>>(),
            ["a", "d"]
        );
    }
}
