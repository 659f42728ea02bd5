//! Colour for text that goes to a terminal: the sixteen standard colours, or nothing at all.

use mhlint_diag::Level;

/// Puts escape sequences around text where colour is wanted.
#[derive(Debug, Clone, Copy)]
pub struct Paint {
    /// Whether colour is wanted.
    pub color: bool,
}

impl Paint {
    /// Headings.
    pub fn bold(self, text: &str) -> String {
        self.with("1", text)
    }

    /// What may be overlooked.
    pub fn dim(self, text: &str) -> String {
        self.with("2", text)
    }

    /// What is asked for, or new.
    pub fn good(self, text: &str) -> String {
        self.with("32", text)
    }

    /// What is gone.
    pub fn bad(self, text: &str) -> String {
        self.with("31", text)
    }

    /// What to do.
    pub fn hint(self, text: &str) -> String {
        self.with("36", text)
    }

    /// In the colour of a level.
    pub fn level(self, level: Level, text: &str) -> String {
        match level {
            Level::Error => self.with("1;31", text),
            Level::Warning => self.with("1;33", text),
            Level::Info => self.with("1;36", text),
        }
    }

    fn with(self, code: &str, text: &str) -> String {
        if self.color && !text.is_empty() {
            format!("\u{1b}[{code}m{text}\u{1b}[0m")
        } else {
            text.to_owned()
        }
    }
}
