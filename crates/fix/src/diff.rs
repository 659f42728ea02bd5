//! Differences as `git diff` writes them, so that `git apply` and `patch -p1` read them.

use similar::udiff::UnifiedHunkHeader;
use similar::{Algorithm, DiffOp, capture_diff_slices, group_diff_ops};

/// Lines around a change that are shown with it.
const AROUND: usize = 3;

/// The difference between two texts of the file at `path`; `after` is `None` where the file goes
/// away. Bytes are kept as they are, those of the path too; nothing where both are equal.
pub fn unified(path: &[u8], before: &[u8], after: Option<&[u8]>) -> Vec<u8> {
    let path = path
        .iter()
        .position(|byte| *byte != b'/')
        .and_then(|start| path.get(start..))
        .unwrap_or_default();
    let (old, new) = (lines(before), lines(after.unwrap_or_default()));
    if old.is_empty() && after.is_none() {
        return removal_of_empty(path).into_bytes();
    }
    let hunks = group_diff_ops(capture_diff_slices(Algorithm::Patience, &old, &new), AROUND);
    if hunks.iter().all(Vec::is_empty) {
        return Vec::new();
    }
    let name = if after.is_some() {
        header(&on_side(b"b/", path))
    } else {
        "/dev/null".to_owned()
    };
    let mut out = format!("--- {}\n+++ {name}\n", header(&on_side(b"a/", path))).into_bytes();
    hunks
        .iter()
        .for_each(|hunk| write_hunk(&mut out, hunk, &old, &new));
    out
}

fn on_side(side: &[u8], path: &[u8]) -> Vec<u8> {
    [side, path].concat()
}

/// Lines as git and patch count them: a carriage return alone ends none.
fn lines(text: &[u8]) -> Vec<&[u8]> {
    text.split_inclusive(|byte| *byte == b'\n').collect()
}

/// Object of git that an empty file is.
const EMPTY: &str = "e69de29bb2d1d6434b8b29ae775ad8c2e48c5391";

/// An empty file has no line that could go: only a header in git's own manner says that it does,
/// and `patch` wants names with spaces in quotes there, and to be told that it is empty. Git takes
/// the lines of a file that comes next for a part of it: in a patch such files come last.
fn removal_of_empty(path: &[u8]) -> String {
    let name = |side: &[u8]| {
        let quoted = quoted(&on_side(side, path));
        if quoted.contains(' ') && !quoted.starts_with('"') {
            format!("\"{quoted}\"")
        } else {
            quoted
        }
    };
    format!(
        "diff --git {} {}\ndeleted file mode 100644\nindex {EMPTY}..{:040}\n",
        name(b"a/"),
        name(b"b/"),
        0
    )
}

fn write_hunk(out: &mut Vec<u8>, hunk: &[DiffOp], old: &[&[u8]], new: &[&[u8]]) {
    if hunk.is_empty() {
        return;
    }
    out.extend_from_slice(format!("{}\n", UnifiedHunkHeader::new(hunk)).as_bytes());
    for part in hunk {
        if let DiffOp::Equal { .. } = part {
            write_lines(out, b' ', old.get(part.old_range()));
        } else {
            write_lines(out, b'-', old.get(part.old_range()));
            write_lines(out, b'+', new.get(part.new_range()));
        }
    }
}

fn write_lines(out: &mut Vec<u8>, sign: u8, lines: Option<&[&[u8]]>) {
    for line in lines.unwrap_or_default() {
        out.push(sign);
        out.extend_from_slice(line);
        if !line.ends_with(b"\n") {
            out.extend_from_slice(b"\n\\ No newline at end of file\n");
        }
    }
}

/// A path as git writes it in a header. Behind a name with a space stands a tab, or `patch` would
/// take it for shorter.
fn header(path: &[u8]) -> String {
    let tab = if path.contains(&b' ') { "\t" } else { "" };
    quoted(path) + tab
}

/// A path as git writes it: in quotes where it is not Unicode, or holds what would end the line or
/// the name, so that the name of a file cannot make a patch for another.
fn quoted(path: &[u8]) -> String {
    let is_plain = |text: &&str| {
        !text
            .chars()
            .any(|c| c.is_control() || c == '"' || c == '\\')
    };
    if let Some(text) = std::str::from_utf8(path).ok().filter(is_plain) {
        return text.to_owned();
    }
    let mut out = String::from("\"");
    for byte in path.iter().copied() {
        match byte {
            b'"' | b'\\' => out.extend(['\\', char::from(byte)]),
            b'\n' => out.push_str("\\n"),
            b'\t' => out.push_str("\\t"),
            b'\r' => out.push_str("\\r"),
            b' '..=b'~' => out.push(char::from(byte)),
            _ => out.extend(['\\', octal(byte >> 6), octal(byte >> 3), octal(byte)]),
        }
    }
    out.push('"');
    out
}

/// The last digit of a number written to the base of eight.
fn octal(byte: u8) -> char {
    char::from(b'0' + (byte & 7))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn shown(before: &str, after: Option<&str>) -> String {
        String::from_utf8(unified(
            b"/a/b.target",
            before.as_bytes(),
            after.map(str::as_bytes),
        ))
        .unwrap()
    }

    #[test]
    fn lines_keep_their_ends() {
        let expected = "--- a/a/b.target\n+++ b/a/b.target\n@@ -1,3 +1,2 @@\n 1\r\n-2\r\n 3\n\\ \
            No newline at end of file\n";
        assert_eq!(shown("1\r\n2\r\n3", Some("1\r\n3")), expected);
        assert_eq!(shown("1\n", Some("1\n")), "");
    }

    #[test]
    fn a_file_that_goes_away_has_no_new_name() {
        assert_eq!(
            shown("1\n", None),
            "--- a/a/b.target\n+++ /dev/null\n@@ -1 +0,0 @@\n-1\n"
        );
    }

    #[test]
    fn a_carriage_return_alone_ends_no_line() {
        let expected = "--- a/a/b.target\n+++ b/a/b.target\n@@ -1,2 +1 @@\n 1\r2\n-3\r\n\\ No \
            newline at end of file\n";
        assert_eq!(shown("1\r2\n3\r", Some("1\r2\n")), expected);
    }

    #[test]
    fn bytes_that_are_no_utf8_are_kept() {
        let diff = unified(b"a", b"\xff\n1\n", Some(b"\xff\n"));
        assert_eq!(diff, b"--- a/a\n+++ b/a\n@@ -1,2 +1 @@\n \xff\n-1\n");
    }

    #[test]
    fn an_empty_file_goes_by_a_header() {
        for (path, names) in [
            ("a/b", "a/a/b b/a/b"),
            ("a b", "\"a/a b\" \"b/a b\""),
            ("a b\t", "\"a/a b\\t\" \"b/a b\\t\""),
        ] {
            let shown = String::from_utf8(unified(path.as_bytes(), b"", None)).unwrap();
            let head = format!("diff --git {names}\ndeleted file mode 100644\nindex e69de29");
            assert!(
                shown.starts_with(&head)
                    && shown.ends_with("..0000000000000000000000000000000000000000\n"),
                "{shown}"
            );
        }
        assert_eq!(unified(b"a", b"", Some(b"")), b"");
    }

    #[test]
    fn a_tab_ends_a_name_with_a_blank() {
        let shown = String::from_utf8(unified(b"a b", b"1\n", Some(b"2\n"))).unwrap();
        assert!(shown.starts_with("--- a/a b\t\n+++ b/a b\t\n@@"), "{shown}");
    }

    #[test]
    fn the_name_of_a_file_cannot_end_its_line() {
        let path = "x\n--- a/victim\n+++ b/\u{e9}\"\\.target";
        let shown = String::from_utf8(unified(path.as_bytes(), b"1\n", Some(b"2\n"))).unwrap();
        let expected = [
            "--- \"a/x\\n--- a/victim\\n+++ b/\\303\\251\\\"\\\\.target\"\t",
            "+++ \"b/x\\n--- a/victim\\n+++ b/\\303\\251\\\"\\\\.target\"\t",
            "@@ -1 +1 @@\n-1\n+2\n",
        ];
        assert_eq!(shown, expected.join("\n"));
        assert!(
            String::from_utf8(unified("gr\u{fc}n.target".as_bytes(), b"1\n", None))
                .unwrap()
                .starts_with("--- a/gr\u{fc}n.target\n")
        );
    }
}
