//! What the terminal can do, by its kind and the environment.

use std::env;
use std::io::{self, IsTerminal};

use super::args::ColorChoice;

/// Columns when nobody knows better, and the bounds of what reads well.
const COLUMNS: usize = 80;
const NARROWEST: usize = 40;
const WIDEST: usize = 110;

/// How standard output may be written to.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) struct Terminal {
    pub(super) color: bool,
    pub(super) unicode: bool,
    pub(super) width: usize,
}

/// What the decision depends on.
struct Surroundings {
    is_terminal: bool,
    variable: fn(&str) -> Option<String>,
}

impl Terminal {
    /// What files are written for: no colour, no drawing.
    pub(super) const PLAIN: Self = Self {
        color: false,
        unicode: false,
        width: COLUMNS,
    };

    /// Standard output as it is.
    pub(super) fn of_stdout(choice: ColorChoice) -> Self {
        let variable = |name: &str| env::var(name).ok().filter(|value| !value.is_empty());
        let around = Surroundings {
            is_terminal: io::stdout().is_terminal(),
            variable,
        };
        Self {
            color: color(choice, &around),
            unicode: unicode(&around),
            width: width(&around),
        }
    }
}

/// `--color`, then `NO_COLOR`, then `FORCE_COLOR` and `CLICOLOR_FORCE`, then whether it is a
/// terminal that knows colour. Logs of CI systems show colour even where `TERM` is not set.
fn color(choice: ColorChoice, around: &Surroundings) -> bool {
    let is_set = |name| (around.variable)(name).is_some_and(|value| value != "0");
    match choice {
        ColorChoice::Always => true,
        ColorChoice::Never => false,
        ColorChoice::Auto if (around.variable)("NO_COLOR").is_some() => false,
        ColorChoice::Auto if is_set("FORCE_COLOR") || is_set("CLICOLOR_FORCE") => true,
        ColorChoice::Auto => {
            let knows_color = match (around.variable)("TERM") {
                Some(term) => term != "dumb",
                None => cfg!(windows) || is_set("CI"),
            };
            around.is_terminal && knows_color
        }
    }
}

fn unicode(around: &Surroundings) -> bool {
    let locale = ["LC_ALL", "LC_CTYPE", "LANG"]
        .into_iter()
        .find_map(around.variable);
    let names_utf8 = |locale: String| {
        let locale = locale.to_ascii_lowercase();
        locale.contains("utf-8") || locale.contains("utf8")
    };
    around.is_terminal && locale.map_or(cfg!(any(windows, target_os = "macos")), names_utf8)
}

fn width(around: &Surroundings) -> usize {
    let said = (around.variable)("COLUMNS").and_then(|columns| columns.parse().ok());
    let measured = || {
        around
            .is_terminal
            .then(terminal_size::terminal_size)
            .flatten()
            .map(|(width, _)| usize::from(width.0))
    };
    said.or_else(measured)
        .unwrap_or(COLUMNS)
        .clamp(NARROWEST, WIDEST)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn auto(is_terminal: bool, variable: fn(&str) -> Option<String>) -> bool {
        color(
            ColorChoice::Auto,
            &Surroundings {
                is_terminal,
                variable,
            },
        )
    }

    fn only(name: &str, wanted: &str, value: &str) -> Option<String> {
        (name == wanted).then(|| value.to_owned())
    }

    #[test]
    fn a_terminal_gets_colour_and_a_pipe_none() {
        assert!(auto(true, |name| only(name, "TERM", "xterm")));
        assert!(!auto(false, |name| only(name, "TERM", "xterm")));
        assert!(!auto(true, |name| only(name, "TERM", "dumb")));
    }

    #[test]
    fn the_environment_overrides_the_terminal() {
        assert!(!auto(true, |name| only(name, "NO_COLOR", "1")
            .or(only(name, "TERM", "xterm"))));
        assert!(auto(false, |name| only(name, "CLICOLOR_FORCE", "1")));
        assert!(auto(false, |name| only(name, "FORCE_COLOR", "1")));
        assert!(!auto(false, |name| only(name, "NO_COLOR", "1").or(only(
            name,
            "FORCE_COLOR",
            "1"
        ))));
        assert!(!auto(false, |name| only(name, "CLICOLOR_FORCE", "0")));
        assert!(auto(true, |name| only(name, "CI", "true")));
        assert!(!auto(false, |name| only(name, "CI", "true")));
    }

    #[test]
    fn the_option_overrides_the_environment() {
        let around = Surroundings {
            is_terminal: false,
            variable: |name| only(name, "NO_COLOR", "1"),
        };
        assert!(color(ColorChoice::Always, &around));
        assert!(!color(ColorChoice::Never, &around));
    }

    #[test]
    fn drawing_needs_a_terminal_and_a_locale() {
        let draws = |is_terminal, variable| {
            unicode(&Surroundings {
                is_terminal,
                variable,
            })
        };
        assert!(draws(true, |name| only(name, "LANG", "de_DE.UTF-8")));
        assert!(!draws(true, |name| only(name, "LC_ALL", "C")));
        assert!(!draws(false, |name| only(name, "LANG", "de_DE.UTF-8")));
    }

    #[test]
    fn width_is_bounded() {
        let of = |variable| {
            width(&Surroundings {
                is_terminal: false,
                variable,
            })
        };
        assert_eq!(of(|_| None), COLUMNS);
        assert_eq!(of(|name| only(name, "COLUMNS", "9")), NARROWEST);
        assert_eq!(of(|name| only(name, "COLUMNS", "999")), WIDEST);
    }
}
