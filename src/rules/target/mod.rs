//! Rules on `.target` files and their archives.

pub(super) mod syntax;
