//! Rules on binary archives.

pub(super) mod malformed;
mod words;
mod worn;
