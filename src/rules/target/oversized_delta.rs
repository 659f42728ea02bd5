//! Displacements out of all proportion: a lost decimal point, a wrong unit.

use super::super::{Check, Rule, RuleCx};
use super::decoded;
use crate::diag::{Application, Confidence, Element, Evidence, Finding, Level, OptionInfo, Place, RuleInfo};
use crate::formats::target::{Largest, TargetFacts};
use crate::repo::{Base, FileFacts, Repository};

pub(in crate::rules) static RULE: Rule = Rule {
    info: RuleInfo {
        breaks: &[(Application::Makehuman2, "tears the vertex out of the mesh when the target is applied")],
        docs: "A displacement that does not fit the mesh or the rest of its target.\n\nReported are a vertex that moves farther \
            than the whole base mesh is large, and a vertex that stands out of its own target: many times the median of the \
            target, several times as far as all but its longest rows, and a considerable part of the mesh. A target that \
            changes everything a lot, or grows steadily towards one place, is not reported.\n\nMostly a decimal point is \
            missing (`119` for `.119`), or the shape was exported in other units; MakeHuman counts in decimetres. Look at \
            the row; if the shape is meant, raise `ratio`.\n\nWithout the base mesh (`--system`) this is not judged.",
        options: &[OptionInfo {
            name: "ratio",
            default: 20.0,
            docs: "how many times its target's median displacement a vertex may move",
        }],
        ..RuleInfo::new("target-oversized-delta", Level::Warning, "a displacement out of proportion to mesh and target")
    },
    check: Check::Base(run),
};

/// Share of the mesh's size below which nothing is oversized: no detail of a face is torn by less.
const SMALLEST_SHARE: f32 = 0.05;
/// How many times the length that all but the longest rows keep an outlier must have. In the shipped
/// targets the longest row is at most twice as long.
const ISOLATION: f32 = 4.0;

fn run(repository: &Repository<'_>, base: &Base<'_>, cx: &RuleCx<'_>, out: &mut Vec<Finding>) {
    let Some(size) = base.mesh.and_then(|(_, mesh)| extent(&mesh.positions)) else { return };
    #[expect(clippy::cast_possible_truncation, reason = "a factor set by people")]
    let ratio = cx.option(&RULE, "ratio") as f32;
    let own = repository.judged.files.values().filter(|file| file.base.as_deref() == Some(base.name));
    for (file, facts) in own.filter_map(decoded) {
        let Some(largest) = facts.largest else { continue };
        let times = largest.length / facts.median_length;
        if largest.length > size {
            let message = format!("{}, farther than the whole base mesh is large ({size:.1})", moves(&largest));
            out.push(finding(file, facts, &largest, message));
        } else if is_outlier(facts, &largest, size, ratio) {
            let message = format!("{}, {times:.0} times the median of this target", moves(&largest));
            out.push(finding(file, facts, &largest, message).confidence(Confidence::Medium));
        }
    }
}

fn is_outlier(facts: &TargetFacts, largest: &Largest, size: f32, ratio: f32) -> bool {
    let length = largest.length;
    length > ratio * facts.median_length && length > ISOLATION * facts.tail_length && length > SMALLEST_SHARE * size
}

fn moves(largest: &Largest) -> String {
    format!("vertex {} moves {:.3} dm", largest.index, largest.length)
}

fn finding(file: &FileFacts, facts: &TargetFacts, largest: &Largest, message: String) -> Finding {
    let place = u64::try_from(largest.index)
        .map_or(Place::Line(largest.line), |index| Place::Row(largest.line, Element { kind: "vertex", index }));
    let evidence = Evidence { count: 1, ..Evidence::default() };
    RULE.at(file, place, message)
        .help("look for a missing decimal point or another unit; lengths are decimetres")
        .evidence(
            evidence.out_of(facts.rows).with_worst(f64::from(largest.length), format!("vertex {}", largest.index)),
        )
}

/// The longest side of the box around the mesh, in decimetres.
fn extent(positions: &[[f32; 3]]) -> Option<f32> {
    let range = |axis: fn(&[f32; 3]) -> f32| {
        let values = positions.iter().map(axis).filter(|value| value.is_finite());
        let (low, high) = values.fold((f32::MAX, f32::MIN), |(low, high), value| (low.min(value), high.max(value)));
        high - low
    };
    let size = range(|[x, _, _]| *x).max(range(|[_, y, _]| *y)).max(range(|[_, _, z]| *z));
    (size > 0.0 && size.is_finite()).then_some(size)
}
