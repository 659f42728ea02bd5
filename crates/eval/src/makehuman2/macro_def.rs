//! A macro system as its file defines it, in plain names and numbers: what `MacroTable` is made
//! from.
//!
//! Filled by the caller. Source: MakeHuman 2, `macro.json`
//! (`docs/loaders/makehuman2/macros.md#structure`).

/// Where the position of a registered slider is found in the settings.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Slider {
    /// A slider with one number: its place in the settings.
    Value(usize),
    /// A triangle: the places of its three numbers, in the order of the `barycentric` list.
    Barycentric([usize; 3]),
}

/// A component as `macro.json` defines it.
#[derive(Clone, Debug)]
pub struct Component<'a> {
    /// Key in `components`.
    pub name: &'a str,
    /// Pattern of the slider, or the first part of it for `Blend::Sum`.
    pub pattern: &'a str,
    /// Value names, the parts of the combination names.
    pub values: Vec<&'a str>,
    /// How slider positions become weights.
    pub blend: Blend<'a>,
}

/// How slider positions become weights. Where both are written, `steps` wins.
#[derive(Clone, Debug)]
pub enum Blend<'a> {
    /// Linear between slider positions.
    Steps(Vec<f64>),
    /// The numbers of a triangle; each entry follows `pattern` in the name of its slider.
    Sum(Vec<&'a str>),
}

/// A macrodef as `macro.json` defines it.
#[derive(Clone, Debug, Default)]
pub struct Macrodef<'a> {
    /// `comp`: names of components, in the order of the name parts.
    pub components: Vec<&'a str>,
    /// Combination name and the number of its target (equal paths, equal number; dense from 0),
    /// `None` for null. Names of all macrodefs share one table.
    pub links: Vec<(&'a str, Option<u32>)>,
}
