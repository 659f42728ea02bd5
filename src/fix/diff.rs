//! Differences as `git diff` writes them, so that `git apply` and `patch -p1` read them.

use similar::{Algorithm, TextDiff};

/// The difference between two texts of the file at `path`; `after` is `None` where the file goes away.
/// Bytes are kept as they are; nothing where both are equal.
///
/// # Panics
/// Never: writing to memory does not fail.
pub fn unified(path: &str, before: &[u8], after: Option<&[u8]>) -> Vec<u8> {
    let path = path.trim_start_matches('/');
    let new = if after.is_some() { header(&format!("b/{path}")) } else { "/dev/null".to_owned() };
    let diff = TextDiff::configure().algorithm(Algorithm::Patience).diff_lines(before, after.unwrap_or_default());
    let mut out = Vec::new();
    diff.unified_diff()
        .header(&header(&format!("a/{path}")), &new)
        .to_writer(&mut out)
        .expect("invariant: writing to memory does not fail");
    out
}

/// A path as git writes it in a header. Behind a name with a blank stands a tab, or `patch` would take it for shorter.
fn header(path: &str) -> String {
    let tab = if path.contains(' ') { "\t" } else { "" };
    quoted(path) + tab
}

/// A path as git writes it: in quotes where it holds what would end the line or the name, so that the name
/// of a file cannot make a patch for another.
fn quoted(path: &str) -> String {
    if !path.chars().any(|c| c.is_control() || c == '"' || c == '\\') {
        return path.to_owned();
    }
    let mut out = String::from("\"");
    for byte in path.bytes() {
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
        String::from_utf8(unified("/a/b.target", before.as_bytes(), after.map(str::as_bytes))).unwrap()
    }

    #[test]
    fn lines_keep_their_ends() {
        let expected =
            "--- a/a/b.target\n+++ b/a/b.target\n@@ -1,3 +1,2 @@\n 1\r\n-2\r\n 3\n\\ No newline at end of file\n";
        assert_eq!(shown("1\r\n2\r\n3", Some("1\r\n3")), expected);
        assert_eq!(shown("1\n", Some("1\n")), "");
    }

    #[test]
    fn a_file_that_goes_away_has_no_new_name() {
        assert_eq!(shown("1\n", None), "--- a/a/b.target\n+++ /dev/null\n@@ -1 +0,0 @@\n-1\n");
    }

    #[test]
    fn a_tab_ends_a_name_with_a_blank() {
        let shown = String::from_utf8(unified("a b", b"1\n", Some(b"2\n"))).unwrap();
        assert!(shown.starts_with("--- a/a b\t\n+++ b/a b\t\n@@"), "{shown}");
    }

    #[test]
    fn the_name_of_a_file_cannot_end_its_line() {
        let path = "x\n--- a/victim\n+++ b/\u{e9}\"\\.target";
        let shown = String::from_utf8(unified(path, b"1\n", Some(b"2\n"))).unwrap();
        let expected = [
            "--- \"a/x\\n--- a/victim\\n+++ b/\\303\\251\\\"\\\\.target\"\t",
            "+++ \"b/x\\n--- a/victim\\n+++ b/\\303\\251\\\"\\\\.target\"\t",
            "@@ -1 +1 @@\n-1\n+2\n",
        ];
        assert_eq!(shown, expected.join("\n"));
        assert!(
            String::from_utf8(unified("gr\u{fc}n.target", b"1\n", None))
                .unwrap()
                .starts_with("--- a/gr\u{fc}n.target\n")
        );
    }
}
