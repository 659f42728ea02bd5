//! What a data root was taken for, and why.

use serde::Serialize;

use super::{Application, Version};

/// What a data root was taken for, and why.
#[derive(Debug, Clone, Default, PartialEq, Eq, Serialize)]
pub struct Identity {
    /// What kind of place it is.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub kind: Option<PlaceKind>,
    /// The version of the application that its data are of, where something says so.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub version: Option<Version>,
    /// What points to it, and away from others.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub evidence: Vec<Sign>,
    /// Whether nothing else could be meant.
    #[serde(skip)]
    pub is_certain: bool,
    /// Whether the version is that which was asked for.
    #[serde(skip)]
    pub is_version_asked: bool,
}

/// What kind of place data lie in.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum PlaceKind {
    /// What an application brings with it.
    Program,
    /// The same with compiled assets in place of their texts.
    Release,
    /// A part of what an application brings with it, as ports take some.
    Partial,
    /// A user's own folder.
    User,
    /// Assets that go together, to be put into a user's folder.
    Pack,
    /// One asset outside of any data folder.
    Asset,
    /// Several files outside of any data folder.
    Loose,
}

/// Something that points to an application, or away from it.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub struct Sign {
    /// Which.
    pub application: Application,
    /// Whether it points to it.
    pub speaks: Speaks,
    /// What it is: a file or folder, or what is missing.
    pub sign: String,
}

/// On which side a sign is.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[serde(rename_all = "lowercase")]
pub enum Speaks {
    /// For the application.
    For,
    /// Against it.
    Against,
}
