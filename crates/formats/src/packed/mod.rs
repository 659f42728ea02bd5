//! What is packed of an asset, and read in place of its text: the mesh, what is worn, or both.

pub mod asset;
mod mesh;
pub mod proxy;
