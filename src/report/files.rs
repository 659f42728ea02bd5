//! Findings by file, the gravest files first.

use std::borrow::Borrow;
use std::cmp::Reverse;

use crate::diag::Finding;

/// The findings of each file. They come sorted by path; files whose worst finding is of one level keep that order.
pub(super) fn by_file<F: Borrow<Finding>>(findings: &[F]) -> Vec<&[F]> {
    let mut files: Vec<&[F]> = findings.chunk_by(|a, b| a.borrow().path == b.borrow().path).collect();
    files.sort_by_key(|file| Reverse(file.iter().map(|finding| finding.borrow().level).max()));
    files
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::diag::{Level, Place, RuleInfo};

    #[test]
    fn files_with_errors_come_first_and_all_else_stays() {
        let levels =
            [("a", Level::Info), ("b", Level::Warning), ("c", Level::Info), ("c", Level::Error), ("d", Level::Warning)];
        let finding = |(path, level): (&str, Level)| {
            Finding::new(&RuleInfo::new("a-rule", level, ""), path, Place::File, "it is so")
        };
        let findings: Vec<Finding> = levels.into_iter().map(finding).collect();
        let paths: Vec<&str> = by_file(&findings).into_iter().map(|file| file[0].path.as_str()).collect();
        assert_eq!(paths, ["c", "b", "d", "a"]);
        assert_eq!(by_file(&findings)[0].len(), 2);
    }
}
