//! Hidden files of this run that are on disk now, for whoever has to end it.

use std::io;
use std::path::{Path, PathBuf};
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};

use tempfile::NamedTempFile;

/// The hidden files that this run has made and not yet used.
#[derive(Debug, Clone, Default)]
pub struct Pending(Arc<Mutex<Vec<PathBuf>>>);

impl Pending {
    /// Makes one. Whoever wants to end the run waits until it is noted.
    pub(super) fn make<F>(&self, make: impl FnOnce() -> io::Result<NamedTempFile<F>>) -> io::Result<NamedTempFile<F>> {
        let mut all = self.lock();
        let file = make()?;
        all.push(file.path().to_owned());
        Ok(file)
    }

    /// Takes one away, by removing it or by having it take the place of another file.
    pub(super) fn done<T>(&self, path: &Path, take: impl FnOnce() -> T) -> T {
        let mut all = self.lock();
        let taken = take();
        all.retain(|one| one != path);
        taken
    }

    /// Removes all of them, and has the run wait for its end: `end` is called while it can make no other.
    pub fn remove_and<T>(&self, end: impl FnOnce() -> T) -> T {
        let all = self.lock();
        // Journals were the first; contents that they name go before them.
        for path in all.iter().rev() {
            // What cannot be removed a later run will find in the journal, which then stays, too.
            if std::fs::remove_file(path).is_err() && path.exists() {
                break;
            }
        }
        end()
    }

    fn lock(&self) -> MutexGuard<'_, Vec<PathBuf>> {
        self.0.lock().unwrap_or_else(PoisonError::into_inner)
    }
}
