//! Findings by file, the gravest files first.

use std::cmp::Reverse;

use mhlint_diag::Finding;

/// Findings that a page holds: with many more no browser opens it.
const MOST: usize = 5_000;

/// The findings for a page, in their order: all of them, or the gravest where there are too many,
/// and how many are left out.
pub(super) fn for_page(findings: &[Finding]) -> (Vec<&Finding>, usize) {
    let mut order: Vec<usize> = (0..findings.len()).collect();
    order.sort_by_key(|at| findings.get(*at).map(|finding| Reverse(finding.level)));
    order.truncate(MOST);
    order.sort_unstable();
    let left = findings.len() - order.len();
    (
        order
            .into_iter()
            .filter_map(|at| findings.get(at))
            .collect(),
        left,
    )
}

/// The findings of each file, the gravest first. They come sorted by path and place; files whose
/// worst finding is of one level keep that order, and so do findings of one level.
pub(super) fn by_file<'f>(findings: &[&'f Finding]) -> Vec<Vec<&'f Finding>> {
    let mut files: Vec<Vec<&Finding>> = findings
        .chunk_by(|a, b| a.path == b.path)
        .map(<[_]>::to_vec)
        .collect();
    files
        .iter_mut()
        .for_each(|file| file.sort_by_key(|finding| Reverse(finding.level)));
    files.sort_by_key(|file| file.first().map(|finding| Reverse(finding.level)));
    files
}

#[cfg(test)]
mod tests {
    use super::*;
    use mhlint_diag::{Level, Place, RuleInfo};

    #[test]
    fn files_with_errors_come_first_and_all_else_stays() {
        let levels = [
            ("a", Level::Info),
            ("b", Level::Warning),
            ("c", Level::Info),
            ("c", Level::Error),
            ("d", Level::Warning),
        ];
        let finding = |(path, level): (&str, Level)| {
            Finding::new(
                &RuleInfo::new("a-rule", level, ""),
                path,
                Place::File,
                "it is so",
            )
        };
        let findings: Vec<Finding> = levels.into_iter().map(finding).collect();
        let files = by_file(&findings.iter().collect::<Vec<_>>());
        let paths: Vec<&str> = files.iter().map(|file| file[0].path.as_str()).collect();
        assert_eq!(paths, ["c", "b", "d", "a"]);
        assert_eq!(
            files[0]
                .iter()
                .map(|finding| finding.level)
                .collect::<Vec<_>>(),
            [Level::Error, Level::Info]
        );
    }

    #[test]
    fn a_page_holds_the_gravest_of_too_many() {
        let level = |at: usize| {
            if at.is_multiple_of(1000) {
                Level::Error
            } else {
                Level::Info
            }
        };
        let finding = |at| {
            Finding::new(
                &RuleInfo::new("a-rule", level(at), ""),
                format!("{at:5}"),
                Place::File,
                "",
            )
        };
        let findings: Vec<Finding> = (0..MOST + 1001).map(finding).collect();
        let (shown, left) = for_page(&findings);
        assert_eq!((shown.len(), left), (MOST, 1001));
        assert_eq!(
            shown
                .iter()
                .filter(|finding| finding.level == Level::Error)
                .count(),
            7
        );
        assert!(shown.is_sorted_by_key(|finding| &finding.path));
        assert_eq!(for_page(&findings[..9]).1, 0);
    }
}
