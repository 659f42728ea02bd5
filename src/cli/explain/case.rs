//! A fixture of a rule as text: its edits as small diffs, and the findings that it gives.

use include_dir::{Dir, include_dir};
use serde::Deserialize;

use mhlint_report::count;

static FIXTURES: Dir<'_> = include_dir!("$CARGO_MANIFEST_DIR/fixtures/rules");

/// Lines of a written file that are shown.
const SHOWN_LINES: usize = 12;
/// Characters of a line that are shown.
const SHOWN_CHARACTERS: usize = 100;

/// A case with what it gives.
#[derive(Debug, Clone, Default, Deserialize)]
#[serde(default)]
pub(super) struct Case {
    #[serde(skip)]
    pub(super) name: String,
    /// What it shows, in a sentence.
    pub(super) why: String,
    /// The findings, a line each.
    #[serde(skip)]
    pub(super) expected: Vec<String>,
    args: Vec<String>,
    edit: Vec<Edit>,
    remove: Vec<String>,
    rename: Vec<[String; 2]>,
    copy: Vec<[String; 2]>,
    write: Vec<Written>,
    pack: Vec<Packed>,
    compiled: Vec<Packed>,
    targets: Vec<TargetArchive>,
    link: Vec<[String; 2]>,
    folder: Vec<String>,
    zip: Vec<Zipped>,
}

#[derive(Debug, Clone, Deserialize)]
struct Edit {
    file: String,
    find: String,
    replace: String,
}

#[derive(Debug, Clone, Default, Deserialize)]
#[serde(default)]
struct Written {
    file: String,
    text: String,
    hex: String,
    times: Option<usize>,
    gzip: bool,
}

/// A mesh that is packed.
#[derive(Debug, Clone, Default, Deserialize)]
#[serde(default)]
struct Packed {
    file: String,
    from: String,
    find: String,
    replace: String,
    without: Vec<String>,
    alone: bool,
    cut: usize,
}

/// An archive of targets that is made.
#[derive(Debug, Clone, Default, Deserialize)]
#[serde(default)]
struct TargetArchive {
    data: String,
    without: Vec<String>,
    member: Vec<Member>,
    prefix: String,
    no_list: bool,
    list: Option<Vec<String>>,
    removed: Vec<String>,
}

/// A zip that is made.
#[derive(Debug, Clone, Default, Deserialize)]
#[serde(default)]
struct Zipped {
    file: String,
    folder: String,
    member: Vec<Member>,
}

#[derive(Debug, Clone, Default, Deserialize)]
#[serde(default)]
struct Member {
    name: String,
    link: bool,
    encrypted: bool,
}

/// The cases of a rule, sorted by name.
pub(super) fn cases(rule: &str) -> Vec<Case> {
    let folders = FIXTURES.get_dir(rule).into_iter().flat_map(Dir::dirs);
    let mut cases: Vec<Case> = folders.filter_map(read).collect();
    cases.sort_by(|a, b| a.name.cmp(&b.name));
    cases
}

fn read(folder: &Dir<'_>) -> Option<Case> {
    let text = |name: &str| FIXTURES.get_file(folder.path().join(name))?.contents_utf8();
    let mut case: Case = toml::from_str(text("case.toml")?).ok()?;
    folder
        .path()
        .file_name()?
        .to_str()?
        .clone_into(&mut case.name);
    case.expected = text("expected.txt")
        .unwrap_or_default()
        .lines()
        .map(str::to_owned)
        .collect();
    Some(case)
}

impl Case {
    /// What the case changes in the example repository; changed lines have `-` or `+` in column
    /// five.
    pub(super) fn lines(&self) -> Vec<String> {
        let mut lines = Vec::new();
        lines.extend(
            self.rename
                .iter()
                .map(|[from, to]| format!("  {from} renamed to {to}")),
        );
        lines.extend(
            self.copy
                .iter()
                .map(|[from, to]| format!("  {from} copied to {to}")),
        );
        lines.extend(self.remove.iter().map(|path| format!("  {path} removed")));
        self.write
            .iter()
            .for_each(|written| written.push_lines(&mut lines));
        self.pack
            .iter()
            .for_each(|packed| packed.push_lines(&mut lines));
        self.compiled
            .iter()
            .for_each(|packed| packed.push_lines(&mut lines));
        self.targets
            .iter()
            .for_each(|archive| archive.push_lines(&mut lines));
        self.edit
            .iter()
            .for_each(|edit| edit.push_lines(&mut lines));
        lines.extend(self.folder.iter().map(|path| format!("  {path}/ created")));
        lines.extend(
            self.link
                .iter()
                .map(|[path, to]| format!("  {path} linked to {to}")),
        );
        self.zip.iter().for_each(|zip| zip.push_lines(&mut lines));
        if !self.args.is_empty() {
            lines.push(format!("  mhlint {}", self.args.join(" ")));
        }
        lines
    }
}

impl Edit {
    fn push_lines(&self, lines: &mut Vec<String>) {
        lines.push(format!("  {}", self.file));
        let old: Vec<&str> = self.find.lines().collect();
        let new: Vec<&str> = self.replace.lines().collect();
        let same = |pairs: &mut dyn Iterator<Item = (&&str, &&str)>| {
            pairs.take_while(|(a, b)| a == b).count()
        };
        let before = same(&mut old.iter().zip(&new));
        let bound = old.len().min(new.len()) - before;
        let after = same(&mut old.iter().rev().zip(new.iter().rev())).min(bound);
        let mut push = |sign: char, part: Option<&[&str]>| {
            lines.extend(
                part.unwrap_or_default()
                    .iter()
                    .map(|line| format!("    {sign} {}", shorten(line))),
            );
        };
        push(' ', old.get(..before));
        push('-', old.get(before..old.len() - after));
        push('+', new.get(before..new.len() - after));
        push(' ', old.get(old.len() - after..));
    }
}

impl Written {
    fn push_lines(&self, lines: &mut Vec<String>) {
        let bytes = self
            .hex
            .bytes()
            .filter(|byte| !byte.is_ascii_whitespace())
            .count()
            / 2;
        let what = match (self.times, bytes) {
            (Some(times), _) => format!(", repeated {times} times"),
            (None, 0) => String::new(),
            (None, _) => format!(", {bytes} bytes of binary data"),
        };
        let packed = if self.gzip {
            ", compressed with gzip"
        } else {
            ""
        };
        lines.push(format!("  {} (written{what}{packed})", self.file));
        let all: Vec<&str> = self.text.lines().collect();
        lines.extend(
            all.iter()
                .take(SHOWN_LINES)
                .map(|line| format!("    + {}", shorten(line))),
        );
        if all.len() > SHOWN_LINES {
            lines.push(format!(
                "      ... and {}",
                count(all.len() - SHOWN_LINES, "more line")
            ));
        }
    }
}

impl Packed {
    fn push_lines(&self, lines: &mut Vec<String>) {
        let without = match self.without.as_slice() {
            [] => String::new(),
            members => format!(", without `{}`", members.join("`, `")),
        };
        let cut = if self.cut > 0 { ", cut off" } else { "" };
        lines.push(format!(
            "  {} (packed from {}{without}{cut})",
            self.file, self.from
        ));
        if self.alone {
            lines.push(format!("  {} removed", self.from));
        }
        if !self.find.is_empty() {
            lines.push("    with".to_owned());
            lines.extend(
                self.find
                    .lines()
                    .map(|line| format!("    - {}", shorten(line))),
            );
            lines.extend(
                self.replace
                    .lines()
                    .map(|line| format!("    + {}", shorten(line))),
            );
        }
    }
}

impl TargetArchive {
    fn push_lines(&self, lines: &mut Vec<String>) {
        let data = &self.data;
        lines.push(format!("  {data}/targets.npz made of the targets"));
        if !self.prefix.is_empty() {
            lines.push(format!("    each under {}", self.prefix));
        }
        lines.extend(
            self.without
                .iter()
                .map(|name| format!("    without {name}")),
        );
        lines.extend(
            self.member
                .iter()
                .map(|member| format!("    with another {}", member.name)),
        );
        match &self.list {
            _ if self.no_list => lines.push("    without images.list".to_owned()),
            Some(list) => lines.push(format!(
                "  {data}/images.list with {}",
                count(list.len(), "line")
            )),
            None => {}
        }
        lines.extend(self.removed.iter().map(|path| match path.as_str() {
            "*" => "  all texts of targets removed".to_owned(),
            path => format!("  {data}/{path}.target removed"),
        }));
    }
}

impl Zipped {
    fn push_lines(&self, lines: &mut Vec<String>) {
        let content = if self.folder.is_empty() {
            String::new()
        } else {
            format!(" (content of {})", self.folder)
        };
        lines.push(format!("  {}{content}", self.file));
        for Member {
            name,
            link,
            encrypted,
        } in &self.member
        {
            let what = if *link { " (a link)" } else { "" };
            let how = if *encrypted { " (encrypted)" } else { "" };
            lines.push(format!("    + {}{what}{how}", shorten(name)));
        }
    }
}

fn shorten(line: &str) -> String {
    let shown: String = mhlint_report::printable(line)
        .chars()
        .take(SHOWN_CHARACTERS)
        .collect();
    if shown.len() < line.len() {
        format!("{shown}...")
    } else {
        shown
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_case_of_every_rule_is_read() {
        let mut folders = 0;
        for rule in FIXTURES.dirs() {
            let name = rule.path().to_str().unwrap();
            let read = cases(name);
            assert_eq!(read.len(), rule.dirs().count(), "{name}");
            assert!(
                read.iter()
                    .all(|case| !case.why.is_empty() && !case.lines().is_empty()),
                "{name}"
            );
            folders += read.len();
        }
        assert!(folders > 0);
    }

    #[test]
    fn equal_lines_of_an_edit_are_context() {
        let edit = Edit {
            file: "f".to_owned(),
            find: "a\nb\nc".to_owned(),
            replace: "a\nx\ny\nc".to_owned(),
        };
        let mut lines = Vec::new();
        edit.push_lines(&mut lines);
        assert_eq!(
            lines,
            ["  f", "      a", "    - b", "    + x", "    + y", "      c"]
        );
    }
}
