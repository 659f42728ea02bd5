//! How many vertices are on the visible body and how many on helpers, in words.

use std::collections::BTreeMap;

use mhlint_repo::{Body, Region};

/// `2 on the visible body, 3 on helpers`; nothing where the mesh, or what of it is shown, is not
/// known.
pub(super) fn regions(body: &Body<'_>, vertices: impl IntoIterator<Item = u32>) -> Option<String> {
    let mut counts: BTreeMap<Region, usize> = BTreeMap::new();
    for region in vertices
        .into_iter()
        .filter_map(|vertex| body.region(vertex))
    {
        *counts.entry(region).or_default() += 1;
    }
    in_words(&counts)
}

/// The same of vertices that are counted already.
pub(super) fn in_words(counts: &BTreeMap<Region, usize>) -> Option<String> {
    let place = |region: &Region| match region {
        Region::Visible => "on the visible body",
        Region::Helper => "on helpers",
        Region::Faceless => "without a face",
    };
    if let (1, Some(region)) = (counts.len(), counts.keys().next()) {
        return Some(format!("all {}", place(region)));
    }
    let each: Vec<String> = counts
        .iter()
        .map(|(region, count)| format!("{count} {}", place(region)))
        .collect();
    (!each.is_empty()).then(|| each.join(", "))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_body_is_counted_first() {
        let words = |counts: &[(Region, usize)]| in_words(&counts.iter().copied().collect());
        assert_eq!(words(&[]), None);
        assert_eq!(
            words(&[(Region::Helper, 7)]).as_deref(),
            Some("all on helpers")
        );
        let all = [
            (Region::Faceless, 1),
            (Region::Helper, 3),
            (Region::Visible, 2),
        ];
        assert_eq!(
            words(&all).as_deref(),
            Some("2 on the visible body, 3 on helpers, 1 without a face")
        );
    }
}
