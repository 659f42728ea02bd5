//! Standard error: each line is made harmless before it gets there, whoever wrote it and whatever
//! names are in it.

use std::io::{self, Write};

use mhlint_report::printable;

/// Standard error, line by line.
pub(super) struct Harmless {
    // Not locked: another thread that says something would wait for ever.
    to: io::Stderr,
    line: Vec<u8>,
}

impl Harmless {
    pub(super) fn stderr() -> Self {
        Self {
            to: io::stderr(),
            line: Vec::new(),
        }
    }
}

impl Write for Harmless {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        for piece in bytes.split_inclusive(|byte| *byte == b'\n') {
            self.line.extend_from_slice(piece);
            if let Some(line) = self.line.strip_suffix(b"\n") {
                let line = printable(&String::from_utf8_lossy(line));
                self.line.clear();
                writeln!(self.to, "{line}")?;
            }
        }
        Ok(bytes.len())
    }

    fn flush(&mut self) -> io::Result<()> {
        let rest = printable(&String::from_utf8_lossy(&self.line));
        self.line.clear();
        write!(self.to, "{rest}")?;
        self.to.flush()
    }
}
