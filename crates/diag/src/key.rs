//! Stable identity of a finding: rule, asset, structural place. Never line, count or wording.

use xxhash_rust::xxh3::xxh3_128;

/// 128 bit fingerprint in hexadecimal. `asset` is the path relative to the data root, `key` the
/// structural name of the fault, `ordinal` tells apart findings that share all three.
pub fn fingerprint(rule: &str, asset: &str, key: &str, ordinal: u32) -> String {
    let mut text = Vec::with_capacity(rule.len() + asset.len() + key.len() + 8);
    for part in [rule, asset, key] {
        text.extend_from_slice(part.as_bytes());
        text.push(0);
    }
    text.extend_from_slice(&ordinal.to_le_bytes());
    format!("{:032x}", xxh3_128(&text))
}

/// A JSON pointer without positions in lists, which shift when an element before them goes away.
pub fn structural(pointer: &str) -> String {
    let is_position =
        |part: &&str| !part.is_empty() && part.bytes().all(|byte| byte.is_ascii_digit());
    let parts = pointer
        .split('/')
        .map(|part| if is_position(&part) { "*" } else { part });
    parts.collect::<Vec<_>>().join("/")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn parts_do_not_run_into_each_other() {
        assert_ne!(fingerprint("a", "bc", "", 0), fingerprint("ab", "c", "", 0));
        assert_eq!(
            structural("/macrodef/2/targets/17/t"),
            "/macrodef/*/targets/*/t"
        );
        assert_ne!(fingerprint("a", "b", "c", 0), fingerprint("a", "b", "c", 1));
    }
}
