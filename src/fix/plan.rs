//! Which fixes can be done together: a fix is taken as a whole, and only if it touches nothing that another
//! fix of the same turn changes. The others wait for the next turn, when the file was checked again.

use std::collections::BTreeMap;

use crate::diag::Edit;

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
    files: BTreeMap<String, Patch>,
}

impl Plan {
    /// Takes a fix in, whole or not at all. `false`: it has to wait, or changes nothing.
    pub fn accept(&mut self, fix: Vec<(String, Patch)>) -> bool {
        let mut joined: BTreeMap<String, Patch> = BTreeMap::new();
        for (path, patch) in fix {
            let known = joined.remove(&path).or_else(|| self.files.get(&path).cloned());
            let Some(patch) = join(known, patch) else { return false };
            joined.insert(path, patch);
        }
        joined.retain(|_, patch| !matches!(patch, Patch::Edits(edits) if edits.is_empty()));
        let accepted = !joined.is_empty();
        self.files.append(&mut joined);
        accepted
    }

    /// Whether there is nothing to do.
    pub fn is_empty(&self) -> bool {
        self.files.is_empty()
    }

    /// What is to be done, by file.
    pub fn into_files(self) -> BTreeMap<String, Patch> {
        self.files
    }
}

/// Both patches of a file in one, unless they meet.
fn join(known: Option<Patch>, patch: Patch) -> Option<Patch> {
    match (known, patch) {
        (None, Patch::Remove) => Some(Patch::Remove),
        (None, Patch::Edits(edits)) => sorted(edits).map(Patch::Edits),
        (Some(Patch::Edits(mut edits)), Patch::Edits(more)) => {
            edits.extend(more);
            sorted(edits).map(Patch::Edits)
        }
        (Some(_), _) => None,
    }
}

fn sorted(mut edits: Vec<Edit>) -> Option<Vec<Edit>> {
    edits.sort_by_key(|edit| (edit.range.start, edit.range.end));
    let meet = |a: &Edit, b: &Edit| a.range.start == b.range.start || b.range.start < a.range.end;
    let clash = edits.windows(2).any(|pair| matches!(pair, [a, b] if meet(a, b)));
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
        Patch::Edits(edits.iter().map(|(from, to, text)| Edit::replacement(*from..*to, *text)).collect())
    }

    fn on(file: &str, patch: Patch) -> (String, Patch) {
        (file.to_owned(), patch)
    }

    #[test]
    fn fixes_that_meet_wait() {
        let mut plan = Plan::default();
        assert!(plan.accept(vec![on("a", edits(&[(4, 6, "x")]))]));
        assert!(plan.accept(vec![on("a", edits(&[(0, 4, ""), (6, 7, "yz")]))]), "neighbours do not meet");
        assert!(!plan.accept(vec![on("a", edits(&[(5, 8, "")]))]));
        assert!(!plan.accept(vec![on("a", edits(&[(4, 4, "before")]))]));
        assert!(!plan.accept(vec![on("a", Patch::Remove)]));
        let files = plan.into_files();
        let Some(Patch::Edits(all)) = files.get("a") else { panic!("edits") };
        assert_eq!(apply(b"0123456789", all), b"xyz789");
    }

    #[test]
    fn a_fix_is_taken_whole_or_not_at_all() {
        let mut plan = Plan::default();
        assert!(plan.accept(vec![on("a", edits(&[(0, 1, "")]))]));
        assert!(!plan.accept(vec![on("b", edits(&[(0, 1, "")])), on("a", edits(&[(0, 2, "")]))]));
        assert!(!plan.accept(vec![on("c", edits(&[]))]), "nothing to change");
        assert!(plan.accept(vec![on("d", Patch::Remove)]));
        assert_eq!(plan.into_files().into_keys().collect::<Vec<_>>(), ["a", "d"]);
    }
}
