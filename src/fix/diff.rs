//! Differences as `git diff` writes them, so that `git apply` and `patch -p1` read them.

use similar::{Algorithm, TextDiff};

/// The difference between two texts of the file at `path`; `after` is `None` where the file goes away.
/// Bytes are kept as they are; nothing where both are equal.
///
/// # Panics
/// Never: writing to memory does not fail.
pub fn unified(path: &str, before: &[u8], after: Option<&[u8]>) -> Vec<u8> {
    let path = path.trim_start_matches('/');
    let new = if after.is_some() { format!("b/{path}") } else { "/dev/null".to_owned() };
    let diff = TextDiff::configure().algorithm(Algorithm::Patience).diff_lines(before, after.unwrap_or_default());
    let mut out = Vec::new();
    diff.unified_diff()
        .header(&format!("a/{path}"), &new)
        .to_writer(&mut out)
        .expect("invariant: writing to memory does not fail");
    out
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
}
