//! What libraries say of data that cannot be unpacked, in plain words.

/// Behind `cannot be unpacked: `. What no reader of this report meets often keeps the words of the
/// library.
pub(super) fn plain(reason: &str) -> String {
    let known = [
        ("unexpected end of file", "its end is missing"),
        ("unexpected eof", "its end is missing"),
        ("failed to fill whole buffer", "its end is missing"),
        ("checksum", "its content does not match its checksum"),
        ("gzip header", "it is not a gzip file"),
    ];
    let reason_in_lower_case = reason.to_lowercase();
    let plain = known
        .iter()
        .find(|(theirs, _)| reason_in_lower_case.contains(theirs));
    plain.map_or_else(
        || format!("its content is damaged ({reason})"),
        |(_, plain)| (*plain).to_owned(),
    )
}

#[cfg(test)]
mod tests {
    use super::plain;

    #[test]
    fn known_reasons_have_plain_words() {
        assert_eq!(plain("unexpected end of file"), "its end is missing");
        assert_eq!(
            plain("Invalid checksum"),
            "its content does not match its checksum"
        );
        assert_eq!(
            plain("deflate decompression error"),
            "its content is damaged (deflate decompression error)"
        );
    }
}
