//! Who ends a run with a signal while it fixes: nothing of it stays beside the data.

use mhlint_fix::Pending;

/// Waits for signals as long as it lives.
pub(super) struct Watch {
    #[cfg(unix)]
    signals: Option<signal_hook::iterator::Handle>,
}

impl Watch {
    /// Watches over the hidden files of a run: with the first signal that ends programs they go,
    /// and so does the run, with the exit code that shells have for the signal.
    ///
    /// Where no signals can be had, a later run removes what is left.
    #[cfg(unix)]
    pub(super) fn over(pending: &Pending) -> Self {
        use signal_hook::consts::{SIGINT, SIGTERM};
        use signal_hook::iterator::Signals;
        let pending = pending.clone();
        let Ok(mut signals) = Signals::new([SIGINT, SIGTERM]) else {
            return Self { signals: None };
        };
        let handle = signals.handle();
        std::thread::spawn(move || {
            if let Some(signal) = signals.forever().next() {
                pending.remove_and(|| end(signal));
            }
        });
        Self {
            signals: Some(handle),
        }
    }

    /// The same where there are no signals.
    #[cfg(not(unix))]
    pub(super) fn over(_: &Pending) -> Self {
        Self {}
    }
}

impl Drop for Watch {
    fn drop(&mut self) {
        #[cfg(unix)]
        if let Some(signals) = &self.signals {
            signals.close();
        }
    }
}

/// Ends the program as shells expect it.
#[cfg(unix)]
#[expect(
    clippy::exit,
    reason = "whoever ends the program does not wait for what it was about to do"
)]
fn end(signal: i32) {
    std::process::exit(128 + signal)
}
