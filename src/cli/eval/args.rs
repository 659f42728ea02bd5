//! Arguments of `mhlint eval`.

use std::path::PathBuf;

use clap::{Args, Subcommand, ValueEnum};

/// What to evaluate.
#[derive(Debug, Subcommand)]
pub(in crate::cli) enum EvalCommand {
    /// Factors of the macro targets, and what became of every combination.
    Macros(MacrosArgs),
    /// The base mesh at a setting.
    Mesh(MeshArgs),
    /// Joints and rest matrices at a setting.
    Skeleton(SkeletonArgs),
    /// A weights file as the application loads it.
    Weights(WeightsArgs),
    /// The base mesh at a setting in a pose.
    Skin(SkinArgs),
    /// An asset fitted to the base mesh.
    Fit(FitArgs),
    /// A batch of cases: computed, or compared with the outputs that are there.
    Cases(CasesArgs),
}

/// A base mesh and its setting.
#[derive(Debug, Args)]
pub(super) struct BaseArgs {
    /// Data folder.
    #[arg(value_name = "ROOT")]
    pub(super) root: PathBuf,
    #[command(flatten)]
    pub(super) setting: SettingArgs,
}

/// How a base is chosen and set.
#[derive(Debug, Args)]
pub(super) struct SettingArgs {
    /// MakeHuman's own data, when the folder is a user's.
    #[arg(long, value_name = "DIR")]
    pub(super) system: Option<PathBuf>,
    /// Base mesh; the only one if not given.
    #[arg(long, value_name = "NAME")]
    pub(super) base: Option<String>,
    /// A slider by the name that models use, or by its key in modelling.json; not clamped; repeatable.
    #[arg(long = "set", value_name = "NAME=VALUE")]
    pub(super) set: Vec<String>,
    /// Settings from a model (.mhm) or a JSON file; --set comes on top.
    #[arg(long, value_name = "FILE")]
    pub(super) settings: Option<PathBuf>,
}

/// What is written of a mesh.
#[derive(Debug, Args)]
pub(super) struct MeshOutput {
    /// File to write instead of standard output.
    #[arg(short, long, value_name = "FILE")]
    pub(super) output: Option<PathBuf>,
    /// The mesh itself, or its box, sums and chosen vertices.
    #[arg(long, value_name = "FORMAT")]
    pub(super) format: Option<MeshFormat>,
    /// Vertices to report in JSON, from 0, with commas.
    #[arg(long, value_name = "N,N", value_delimiter = ',')]
    pub(super) vertices: Vec<i64>,
}

/// Formats of a mesh.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub(super) enum MeshFormat {
    /// Wavefront OBJ: the lines of the original file with other coordinates.
    Obj,
    /// Box, sums and chosen vertices.
    Json,
}

impl MeshOutput {
    /// JSON when vertices are asked for, or the file is called so.
    pub(super) fn is_json(&self) -> bool {
        let named = self.output.as_ref().and_then(|file| file.extension()).is_some_and(|ending| ending == "json");
        self.format.map_or(named || !self.vertices.is_empty(), |format| format == MeshFormat::Json)
    }
}

/// Arguments of `eval macros`.
#[derive(Debug, Args)]
pub(in crate::cli) struct MacrosArgs {
    #[command(flatten)]
    pub(super) base: BaseArgs,
}

/// Arguments of `eval mesh`.
#[derive(Debug, Args)]
pub(in crate::cli) struct MeshArgs {
    #[command(flatten)]
    pub(super) base: BaseArgs,
    #[command(flatten)]
    pub(super) output: MeshOutput,
}

/// Arguments of `eval skeleton`.
#[derive(Debug, Args)]
pub(in crate::cli) struct SkeletonArgs {
    #[command(flatten)]
    pub(super) base: BaseArgs,
    /// Another skeleton than the pose skeleton of the base.
    #[arg(long, value_name = "FILE")]
    pub(super) skeleton: Option<PathBuf>,
}

/// Arguments of `eval weights`.
#[derive(Debug, Args)]
pub(in crate::cli) struct WeightsArgs {
    /// Weights file (.mhw).
    #[arg(value_name = "FILE")]
    pub(super) file: PathBuf,
    /// Skeleton of the weights; names the root bone (`root` if not given).
    #[arg(long, value_name = "FILE")]
    pub(super) skeleton: Option<PathBuf>,
    /// Vertices of the mesh; up to the highest that is listed if not given.
    #[arg(long, value_name = "N")]
    pub(super) vertices: Option<usize>,
    /// Keep only so many bones a vertex.
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u16).range(1..))]
    pub(super) max_influences: Option<u16>,
    /// Move the weights to this skeleton through its reference bones.
    #[arg(long, value_name = "FILE", requires = "skeleton")]
    pub(super) remap_to: Option<PathBuf>,
    /// Write the weights as .mhw.
    #[arg(short, long, value_name = "FILE")]
    pub(super) output: Option<PathBuf>,
}

/// Arguments of `eval skin`.
#[derive(Debug, Args)]
pub(in crate::cli) struct SkinArgs {
    #[command(flatten)]
    pub(super) base: BaseArgs,
    /// Pose: bones with rotation matrices (JSON).
    #[arg(long, value_name = "FILE")]
    pub(super) pose: PathBuf,
    #[command(flatten)]
    pub(super) output: MeshOutput,
}

/// Arguments of `eval fit`.
#[derive(Debug, Args)]
pub(in crate::cli) struct FitArgs {
    /// Asset (.mhclo or .proxy).
    #[arg(value_name = "FILE")]
    pub(super) file: PathBuf,
    /// Data folder, or an OBJ.
    #[arg(long, value_name = "ROOT")]
    pub(super) base_mesh: PathBuf,
    #[command(flatten)]
    pub(super) setting: SettingArgs,
    /// Whether the asset was attached before or after the mesh took its shape: its scales are measured then.
    #[arg(long, value_name = "WHEN", default_value = "after")]
    pub(super) attached: Attached,
    #[command(flatten)]
    pub(super) output: MeshOutput,
}

/// When an asset was attached.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub(super) enum Attached {
    /// Scales of the plain base mesh.
    Before,
    /// Scales of the mesh as it is.
    After,
}

/// Arguments of `eval cases`.
#[derive(Debug, Args)]
pub(in crate::cli) struct CasesArgs {
    /// File of cases (JSON).
    #[arg(value_name = "FILE")]
    pub(super) file: PathBuf,
    /// Folder of a program or of assets that the cases name: makehuman2, makehuman1, mpfb, makehuman-assets; repeatable.
    #[arg(long = "root", value_name = "NAME=DIR")]
    pub(super) roots: Vec<String>,
    /// Compare with the outputs in the file instead of printing own ones.
    #[arg(long)]
    pub(super) compare: bool,
    /// File to write instead of standard output.
    #[arg(short, long, value_name = "FILE")]
    pub(super) output: Option<PathBuf>,
}
