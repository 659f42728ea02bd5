//! How files of MakeHuman 1 become the arrays that are evaluated: so far those of what is worn.

pub(super) mod worn;
