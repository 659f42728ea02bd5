//! The visible text of an HTML report, line by line: what a picture of it is compared by where
//! there is no browser.

/// The texts between the tags, one in a line, without what is not shown. What comes after the
/// findings is in no picture: the rules, and the version of mhlint.
pub(super) fn text(page: &str) -> String {
    let body = page
        .split_once("<body")
        .and_then(|(_, body)| body.split_once("</main>"))
        .unwrap()
        .0;
    let mut shown = String::new();
    for piece in without(without(body.to_owned(), "style"), "script")
        .split('<')
        .skip(1)
    {
        let text = piece.split_once('>').map_or(piece, |(_, text)| text);
        push_lines(&mut shown, &decoded(text));
    }
    shown
}

/// Without an element and what is in it.
fn without(mut page: String, element: &str) -> String {
    let [open, close] = [format!("<{element}"), format!("</{element}>")];
    while let Some(start) = page.find(&open) {
        let end = page[start..]
            .find(&close)
            .map_or(page.len(), |at| start + at + close.len());
        page.replace_range(start..end, "");
    }
    page
}

fn push_lines(shown: &mut String, text: &str) {
    for line in text.lines().map(str::trim).filter(|line| !line.is_empty()) {
        shown.push_str(line);
        shown.push('\n');
    }
}

/// What `maud` escapes.
fn decoded(text: &str) -> String {
    let pairs = [
        ("&lt;", "<"),
        ("&gt;", ">"),
        ("&quot;", "\""),
        ("&amp;", "&"),
    ];
    pairs
        .iter()
        .fold(text.to_owned(), |text, (from, to)| text.replace(from, to))
}

/// The text of a line of markup.
pub(super) fn between_tags(line: &str) -> String {
    let pieces = line
        .split('<')
        .map(|piece| piece.split_once('>').map_or(piece, |(_, text)| text));
    decoded(&pieces.collect::<String>()).trim().to_owned()
}
