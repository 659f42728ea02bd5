//! Panics are bugs of ours. The engine catches them per file and rule; here they are noted without
//! noise and told at the end, once.

use std::panic::{self, PanicHookInfo};
use std::sync::{Arc, Mutex, PoisonError};

/// The panics of this process.
#[derive(Debug, Clone, Default)]
pub(super) struct Panics {
    noted: Arc<Mutex<Vec<String>>>,
}

impl Panics {
    /// Notes panics from now on instead of printing them.
    pub(super) fn watch() -> Self {
        let panics = Self::default();
        let noted = panics.clone();
        panic::set_hook(Box::new(move |info| noted.note(&describe(info))));
        panics
    }

    /// What was noted, each once.
    pub(super) fn noted(&self) -> Vec<String> {
        let mut noted = self
            .noted
            .lock()
            .unwrap_or_else(PoisonError::into_inner)
            .clone();
        noted.sort_unstable();
        noted.dedup();
        noted
    }

    fn note(&self, what: &str) {
        self.noted
            .lock()
            .unwrap_or_else(PoisonError::into_inner)
            .push(what.to_owned());
    }
}

fn describe(info: &PanicHookInfo<'_>) -> String {
    let place = info
        .location()
        .map_or_else(String::new, |at| format!(" ({}:{})", at.file(), at.line()));
    let payload = info.payload();
    let text = payload.downcast_ref::<&str>().copied();
    let text = text.or_else(|| payload.downcast_ref::<String>().map(String::as_str));
    format!("{}{place}", text.unwrap_or("a panic without a message"))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn equal_panics_are_told_once() {
        let panics = Panics::default();
        for what in ["b", "a", "b"] {
            panics.note(what);
        }
        assert_eq!(panics.noted(), ["a", "b"]);
    }
}
