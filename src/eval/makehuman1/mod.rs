//! The formulas of MakeHuman 1. Known so far: what it adds to fitting.

pub mod fit;
