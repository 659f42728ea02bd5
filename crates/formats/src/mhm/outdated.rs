//! Models and expressions of versions that no program reads any more
//! (`docs/loaders/versions.md#formats-that-are-gone`).

use crate::mhm::lines::{Line, Lines, keywords};
use crate::outdated::Outdated;
use crate::{python_float, python_int};

/// A model or expression of an alpha version. Since 1.0 versions begin with `v`, and since 1.1
/// sliders are lines `modifier`.
pub(super) fn of_model(lines: &Lines) -> Option<Outdated> {
    let version = lines.last("version")?;
    let is_alpha = version.text.starts_with("alpha");
    if !is_alpha && !version.text.starts_with("1.0") || lines.of("modifier").next().is_some() {
        return None;
    }
    let is_number =
        |line: &Line, at: usize| line.values.get(at).is_some_and(|one| is_numeric(&one.text));
    // Since 1.1 the line names a file.
    let is_unit = |line: &Line| line.values.len() == 2 && is_number(line, 1);
    let is_later =
        |line: &Line| matches!(&*line.keyword.text, "macro" | "face") && is_number(line, 1);
    let is_slider =
        |line: &Line| !keywords().any(|known| known == &*line.keyword.text) && is_number(line, 0);
    let is_hair = |line: &Line| {
        line.values
            .first()
            .is_some_and(|file| file.text.ends_with(".obj"))
    };
    match () {
        () if is_alpha || lines.all.iter().any(is_later) => Some(Outdated::LaterModel),
        () if lines.all.iter().any(is_slider) || lines.of("hair").any(is_hair) => {
            Some(Outdated::Model)
        }
        () if lines.of("expression").any(is_unit) => Some(Outdated::Expression),
        () => None,
    }
}

fn is_numeric(word: &str) -> bool {
    python_int(word.as_bytes()).is_some() || python_float(word.as_bytes()).is_some()
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;
    use crate::mhm::lines::read;

    #[test]
    fn models_and_expressions() {
        for (text, expected) in [
            (
                "version 1.0.0\ntags a\nexpression mouth-open 0.5\n",
                Some(Outdated::Expression),
            ),
            (
                "version 1.0.0\ngender 0.5\nhair a.obj\n",
                Some(Outdated::Model),
            ),
            ("version 1.0.0\nhair a.obj\n", Some(Outdated::Model)),
            (
                "version alpha_8_rc1\nmacro Gender 0.5\n",
                Some(Outdated::LaterModel),
            ),
            (
                "version 1.0.0\nmodifier head/head-oval 0.5\nexpression a 1\n",
                None,
            ),
            ("version v1.0.0\nmacro Gender 0.5\n", None),
            ("version 1.0.0\nexpression smile.mhpose\n", None),
            ("version 1.2.0\ngender 0.5\n", None),
            ("gender 0.5\n", None),
        ] {
            assert_eq!(of_model(&read(text.as_bytes())), expected, "{text}");
        }
    }

    proptest! {
        #[test]
        fn no_words_stop_it(words in prop::collection::vec("version|1.0.0|macro|[0-9]{1,3}|\n", 0..60)) {
            of_model(&read(words.join(" ").as_bytes()));
        }
    }
}
