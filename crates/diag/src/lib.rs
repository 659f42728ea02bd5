//! What a finding is: plain data shared by every layer.
//!
//! A leaf of the house: imports nothing of ours, no terminal types, no borrowed sources. Rules make
//! [`Finding`]s, the engine places and sorts them, reports only say them.

// Only a few modules may use files, streams and the environment, and they allow this lint
// themselves; tests may use everything.
#![cfg_attr(not(test), warn(clippy::disallowed_methods))]

mod baseline;
mod consumer;
mod evidence;
mod finding;
mod fix;
mod glued;
mod grouped;
mod identity;
mod key;
mod level;
mod measure;
mod nearest;
mod note;
mod outcome;
mod parts;
mod place;
mod rule_info;
mod subject;
mod upkeep;
mod version;

pub use baseline::{Baseline, Entry};
pub use consumer::grade_consumers;
pub use consumer::{AssetGroup, Consumed, Consumer, Fares};
pub use evidence::{Cases, EXAMPLES, Evidence, Few, Tally, Worst};
pub use finding::{Break, Finding, IgnoredFiles, NewParts, Related};
pub use fix::{Change, Edit, Fix, Replaced, Rewrite, Step};
pub use glued::{begins_word, glued, is_like_path};
pub use grouped::{Grouped, grouped};
pub use identity::{Identity, PlaceKind, Sign, Speaks};
pub use key::{fingerprint, structural};
pub use level::{Application, Confidence, Level};
pub use measure::{Figure, Grown, Grows, Measure, MeasureKind, Towards};
pub use nearest::{Sought, Suggestions, nearest};
pub use note::Note;
pub use outcome::{
    ApplicationVerdict, Compared, FailedStep, NotChecked, Outcome, Phase, RootSummary, Scope,
    Summary, TakenOver, Timed, Timing, Unchecked, Untouched, Verdict,
};
pub use parts::{Name, NameIndex, Parts};
pub use place::{Element, Excerpt, Folder, Location, Place, add_step, pointer, steps};
#[cfg(test)]
pub(crate) use rule_info::OF_TWO;
pub use rule_info::{Case, FixKind, OptionInfo, RuleInfo};
pub use subject::Subject;
pub use upkeep::{BaselineUse, IdleGlob, IgnoreState, IgnoreUse, UnknownRule, Upkeep};
pub use version::{Edition, EditionFault, Version};
