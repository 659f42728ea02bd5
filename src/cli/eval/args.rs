//! Arguments of `mhlint eval`.

use std::path::PathBuf;

use clap::{Args, Subcommand, ValueEnum};

/// What to evaluate.
#[derive(Debug, Subcommand)]
pub(in crate::cli) enum EvalCommand {
    /// Compute the factors of macro targets and combinations.
    Macros(BaseArgs),
    /// Compute what modifiers of MakeHuman 1 do to their targets.
    Modifiers(BaseArgs),
    /// Compute the base mesh for slider settings.
    Mesh(MeshArgs),
    /// Compute joints and rest matrices for slider settings.
    Skeleton(SkeletonArgs),
    /// Compute the bones of a rig of MPFB for slider settings.
    Rig(RigArgs),
    /// Load a weights file as the application does.
    Weights(WeightsArgs),
    /// Compute the posed base mesh for slider settings.
    Skin(SkinArgs),
    /// Fit an asset to the base mesh.
    Fit(FitArgs),
    /// Compute a batch of cases, or compare it with recorded outputs.
    Cases(CasesArgs),
}

/// A base mesh and its setting.
#[derive(Debug, Args)]
pub(in crate::cli) struct BaseArgs {
    /// Data folder to evaluate.
    #[arg(value_name = "ROOT")]
    pub(super) root: PathBuf,
    #[command(flatten)]
    pub(super) setting: SettingArgs,
}

/// How a base is chosen and set.
#[derive(Debug, Args)]
pub(super) struct SettingArgs {
    /// MakeHuman's own data, if ROOT is a user's data folder.
    #[arg(long, value_name = "FOLDER")]
    pub(super) system: Option<PathBuf>,
    /// Base mesh to use; optional if there is only one.
    #[arg(long, value_name = "NAME")]
    pub(super) base: Option<String>,
    /// Set a slider; can be repeated.
    ///
    /// NAME is the name in models (.mhm) or the key in modelling.json. VALUE is not clamped.
    #[arg(long = "set", value_name = "NAME=VALUE")]
    pub(super) set: Vec<String>,
    /// Read slider settings from a model (.mhm), a saved character of MPFB or another JSON file.
    ///
    /// --set overrides them.
    #[arg(long, value_name = "FILE")]
    pub(super) settings: Option<PathBuf>,
}

/// What is written of a mesh.
#[derive(Debug, Args)]
pub(super) struct MeshOutput {
    /// Write to this file instead of standard output.
    #[arg(short, long, value_name = "FILE")]
    pub(super) output: Option<PathBuf>,
    /// Output format; obj unless FILE ends in .json or --vertices is used.
    #[arg(long, value_name = "FORMAT")]
    pub(super) format: Option<MeshFormat>,
    /// Vertices to list in the JSON output; the first vertex is 0.
    #[arg(long, value_name = "N,N", value_delimiter = ',')]
    pub(super) vertices: Vec<i64>,
}

/// Formats of a mesh.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub(super) enum MeshFormat {
    /// Wavefront OBJ: the original file with new coordinates.
    Obj,
    /// Bounding box, sums and chosen vertices.
    Json,
}

impl MeshOutput {
    /// JSON when vertices are asked for, or the file is called so.
    pub(super) fn is_json(&self) -> bool {
        let named = self
            .output
            .as_ref()
            .and_then(|file| file.extension())
            .is_some_and(|ending| ending == "json");
        self.format
            .map_or(named || !self.vertices.is_empty(), |format| {
                format == MeshFormat::Json
            })
    }
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
    /// Use this skeleton instead of the pose skeleton of the base.
    #[arg(long, value_name = "FILE")]
    pub(super) skeleton: Option<PathBuf>,
}

/// A rig of MPFB, and how large its figure is.
#[derive(Debug, Args)]
pub(super) struct RigChoice {
    /// Rig of MPFB (rig.*.json).
    #[arg(long, value_name = "FILE")]
    pub(super) rig: Option<PathBuf>,
    /// MPFB: so many metres are one unit of base.obj.
    #[arg(long, value_name = "N", default_value_t = 0.1)]
    pub(super) scale: f64,
}

/// Arguments of `eval rig`.
#[derive(Debug, Args)]
pub(in crate::cli) struct RigArgs {
    #[command(flatten)]
    pub(super) base: BaseArgs,
    #[command(flatten)]
    pub(super) choice: RigChoice,
}

/// Arguments of `eval weights`.
#[derive(Debug, Args)]
pub(in crate::cli) struct WeightsArgs {
    /// Weights file (.mhw).
    #[arg(value_name = "FILE")]
    pub(super) file: PathBuf,
    /// Skeleton of the weights.
    ///
    /// Vertices without weights go to its root bone, or to `root` if no skeleton is used.
    #[arg(long, value_name = "FILE")]
    pub(super) skeleton: Option<PathBuf>,
    /// Load the weights as this application does.
    #[arg(
        long,
        value_name = "APPLICATION",
        default_value = "makehuman2",
        conflicts_with = "rig"
    )]
    pub(super) app: LoadedBy,
    /// Rig of MPFB (rig.*.json): load the weights as MPFB does, into vertex groups of its bones.
    #[arg(
        long,
        value_name = "FILE",
        conflicts_with_all = ["skeleton", "max_influences", "remap_to", "output"],
    )]
    pub(super) rig: Option<PathBuf>,
    /// Number of vertices of the mesh.
    ///
    /// By default, up to the highest vertex in the file.
    #[arg(long, value_name = "N")]
    pub(super) vertices: Option<usize>,
    /// Keep at most this many bones per vertex.
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u16).range(1..))]
    pub(super) max_influences: Option<u16>,
    /// Transfer the weights to this skeleton by its reference bones.
    #[arg(long, value_name = "FILE", requires = "skeleton")]
    pub(super) remap_to: Option<PathBuf>,
    /// Write the resulting weights to this .mhw file.
    #[arg(short, long, value_name = "FILE")]
    pub(super) output: Option<PathBuf>,
}

/// Arguments of `eval skin`.
#[derive(Debug, Args)]
pub(in crate::cli) struct SkinArgs {
    #[command(flatten)]
    pub(super) base: BaseArgs,
    /// Pose file (JSON): bones with rotation matrices; for MPFB one of its poses.
    #[arg(long, value_name = "FILE")]
    pub(super) pose: PathBuf,
    #[command(flatten)]
    pub(super) choice: RigChoice,
    /// Weights of the rig of MPFB.
    #[arg(long, value_name = "FILE", requires = "rig")]
    pub(super) weights: Option<PathBuf>,
    #[command(flatten)]
    pub(super) output: MeshOutput,
}

/// Arguments of `eval fit`.
#[derive(Debug, Args)]
pub(in crate::cli) struct FitArgs {
    /// Asset file (.mhclo or .proxy).
    #[arg(value_name = "FILE")]
    pub(super) file: PathBuf,
    /// Data folder, or an OBJ file of the base mesh.
    #[arg(long, value_name = "ROOT")]
    pub(super) base_mesh: PathBuf,
    /// Fit the asset as this application does.
    #[arg(long, value_name = "APPLICATION", default_value = "makehuman2")]
    pub(super) app: FittedBy,
    #[command(flatten)]
    pub(super) setting: SettingArgs,
    /// Whether the asset was attached before or after the morph.
    ///
    /// The scales of the asset are measured on the mesh of that moment.
    #[arg(long, value_name = "WHEN", default_value = "after")]
    pub(super) attached: Attached,
    /// MPFB: so many metres are one unit of base.obj.
    #[arg(long, value_name = "N", default_value_t = 0.1)]
    pub(super) scale: f64,
    #[command(flatten)]
    pub(super) output: MeshOutput,
}

/// Applications whose fitting is known.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub(super) enum FittedBy {
    /// MakeHuman 2.
    Makehuman2,
    /// MakeHuman 1; its sliders cannot be set yet.
    Makehuman1,
    /// MPFB.
    Mpfb,
}

/// Applications that load weights for a skeleton.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub(super) enum LoadedBy {
    /// MakeHuman 2.
    Makehuman2,
    /// MakeHuman 1: bones of another skeleton take the weights of their reference bones.
    Makehuman1,
}

/// When an asset was attached.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub(super) enum Attached {
    /// Measure the scales on the base mesh before the morph.
    Before,
    /// Measure the scales on the base mesh after the morph.
    After,
}

/// Arguments of `eval cases`.
#[derive(Debug, Args)]
pub(in crate::cli) struct CasesArgs {
    /// File with the cases (JSON).
    #[arg(value_name = "FILE")]
    pub(super) file: PathBuf,
    /// Folder of a program or of assets that the cases use; can be repeated.
    ///
    /// NAME is makehuman2, makehuman1, mpfb or makehuman-assets.
    #[arg(long = "root", value_name = "NAME=DIR")]
    pub(super) roots: Vec<String>,
    /// Compare with the outputs in the file instead of printing outputs.
    #[arg(long)]
    pub(super) compare: bool,
    /// Write to this file instead of standard output.
    #[arg(short, long, value_name = "FILE")]
    pub(super) output: Option<PathBuf>,
}
