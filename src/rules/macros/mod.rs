//! Rules on `macro.json` of MakeHuman 2.

pub(super) mod steps_length;
