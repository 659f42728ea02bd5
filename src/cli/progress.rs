//! A sign of life on a terminal, only when a run takes longer than half a second.

use std::io::{self, IsTerminal};
use std::sync::mpsc::{self, RecvTimeoutError, Sender};
use std::thread::{self, JoinHandle};
use std::time::Duration;

use indicatif::{ProgressBar, ProgressStyle};

const PATIENCE: Duration = Duration::from_millis(500);
const TICK: Duration = Duration::from_millis(100);

/// Shows itself on standard error while it lives; leaves nothing behind.
pub(super) struct Progress {
    ended: Option<Sender<()>>,
    drawer: Option<JoinHandle<()>>,
}

impl Progress {
    /// Begins to wait. Does nothing where standard error is no terminal.
    pub(super) fn start(what: &'static str) -> Self {
        if !io::stderr().is_terminal() {
            return Self {
                ended: None,
                drawer: None,
            };
        }
        let (ended, end) = mpsc::channel();
        let drawer = thread::spawn(move || {
            if matches!(end.recv_timeout(PATIENCE), Err(RecvTimeoutError::Timeout)) {
                let bar = spinner(what);
                // The sender is dropped at the end: that is the message.
                let _ = end.recv();
                bar.finish_and_clear();
            }
        });
        Self {
            ended: Some(ended),
            drawer: Some(drawer),
        }
    }
}

impl Drop for Progress {
    fn drop(&mut self) {
        self.ended.take();
        if let Some(drawer) = self.drawer.take() {
            // A drawer that panicked has nothing left to clear.
            let _ = drawer.join();
        }
    }
}

fn spinner(what: &'static str) -> ProgressBar {
    let bar = ProgressBar::new_spinner();
    if let Ok(style) = ProgressStyle::with_template("{spinner} {msg} {elapsed}") {
        bar.set_style(style);
    }
    bar.set_message(what);
    bar.enable_steady_tick(TICK);
    bar
}
