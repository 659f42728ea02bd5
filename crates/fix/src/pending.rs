//! Hidden files of this run that are on disk now, for whoever has to end it.

use std::collections::BTreeSet;
use std::fs;
use std::io;
use std::path::{Path, PathBuf};
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};

use tempfile::NamedTempFile;

use super::journal::is_journal;

/// The hidden files that this run has made and not yet used.
#[derive(Debug, Clone, Default)]
pub struct Pending(Arc<Mutex<BTreeSet<PathBuf>>>);

impl Pending {
    /// Makes one. Whoever wants to end the run waits until it is noted.
    pub(super) fn make<F>(
        &self,
        make: impl FnOnce() -> io::Result<NamedTempFile<F>>,
    ) -> io::Result<NamedTempFile<F>> {
        let mut all = self.lock();
        let file = make()?;
        all.insert(file.path().to_owned());
        Ok(file)
    }

    /// Takes one away, by removing it or by having it take the place of another file.
    pub(super) fn done<T>(&self, path: &Path, take: impl FnOnce() -> T) -> T {
        let mut all = self.lock();
        let taken = take();
        all.remove(path);
        taken
    }

    /// Removes all of them, and has the run wait for its end: `end` is called while it can make no
    /// other.
    pub fn remove_and<T>(&self, end: impl FnOnce() -> T) -> T {
        let all = self.lock();
        let (journals, contents): (Vec<&PathBuf>, Vec<&PathBuf>) =
            all.iter().partition(|path| is_journal(path));
        let mut is_clean = true;
        for path in contents {
            is_clean &= fs::remove_file(path).is_ok() || !path.exists();
        }
        // What could not be removed a later run finds in the journals.
        for path in journals.into_iter().filter(|_| is_clean) {
            let _ = fs::remove_file(path);
        }
        end()
    }

    fn lock(&self) -> MutexGuard<'_, BTreeSet<PathBuf>> {
        self.0.lock().unwrap_or_else(PoisonError::into_inner)
    }
}
