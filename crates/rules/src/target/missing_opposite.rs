//! A target for one direction of a slider without the other direction.

use super::super::{Check, Rule, RuleCx};
use super::endings::{Endings, Pair};
use super::{asked_for, parent, user_pairs};
use mhlint_diag::{Application::Makehuman2, Case, Finding, Level, Place, RuleInfo, nearest};
use mhlint_discover::Kind;
use mhlint_repo::FileFacts;
use mhlint_repo::makehuman2::{Base, TargetFolder, View};

pub(crate) static RULE: Rule = Check::Makehuman2(run).rule(RuleInfo {
    breaks: &[(
        Makehuman2,
        "creates a slider with one direction only; of a lone `-decr` target, the slider decreases \
            as it moves up",
    )],
    docs: include_str!("missing_opposite.md").trim_ascii_end(),
    ..RuleInfo::new(
        "target-missing-opposite",
        Level::Warning,
        "a target for one direction has no \
        opposite",
    )
});

fn run(view: &View<'_>, base: &Base<'_>, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    out.extend(user_pairs::findings(&RULE, view, base));
    // The scan of user targets knows decr and incr without being told.
    let known = base.settings().is_none().then_some(("decr", "incr"));
    let (endings, asked) = (Endings::of(base, known), asked_for(view, base));
    let unlisted = base.modelling.winner().is_none() && !base.modelling.is_broken();
    let folders = [base.user_targets, base.targets.filter(|_| unlisted)];
    for folder in folders
        .into_iter()
        .flatten()
        .filter(|folder| std::ptr::eq(folder.layer, view.layers.checked))
    {
        let in_use = endings.in_use(folder);
        for file in folder.targets() {
            let Some((opposite, pair)) = opposite_of(file, &endings) else {
                continue;
            };
            let rel = format!("{}/{opposite}.target", parent(&file.rel));
            if folder.layer.file(&rel).is_some() || asked.contains(rel.as_str()) {
                continue;
            }
            let other_case = folder.layer.file_ignoring_case(&rel);
            match other_case.or_else(|| misnamed(folder, file, &rel, pair)) {
                // A folder of other capitals is another matter.
                Some(other) if parent(&other.rel) != parent(&rel) => {}
                // Each lacks the other: once is enough.
                Some(other)
                    if opposite_of(other, &endings).is_some() && file.stem().ends_with(pair.0) => {}
                Some(other) => out.push(renamed(finding(file, &opposite, pair), &opposite, other)),
                None if in_use.contains(&(parent(&file.rel), pair)) => {
                    out.push(finding(file, &opposite, pair));
                }
                None => {}
            }
        }
    }
}

const INCREASES: Case = &[(
    Makehuman2,
    Level::Warning,
    "creates a slider that can only increase",
)];
const DECREASES: Case = &[(
    Makehuman2,
    Level::Warning,
    "creates a slider that only decreases the shape, when it moves up",
)];

fn finding(file: &FileFacts, opposite: &str, (decr, _): Pair<'_>) -> Finding {
    let message = format!("`{}` has no opposite `{opposite}`", file.stem());
    let case = if file
        .stem()
        .strip_suffix(decr)
        .is_some_and(|stem| stem.ends_with('-'))
    {
        DECREASES
    } else {
        INCREASES
    };
    RULE.at(file, Place::File, message).case(case).help(format!(
        "leave it if one direction is meant; otherwise add `{opposite}.target`, before models are \
            saved with the slider"
    ))
}

/// The opposite is there and is not called so.
fn renamed(finding: Finding, opposite: &str, other: &FileFacts) -> Finding {
    let name = other.file_name();
    let help = format!(
        "rename `{name}` to `{opposite}.target` if it is the other direction, before models are \
            saved with the slider"
    );
    let related = format!("`{name}` becomes a slider of its own");
    finding
        .help(help)
        .related(other.path.clone(), Place::File, related)
}

/// A target beside `file` that looks like its opposite `rel` and has lost its ending, or has a
/// misspelt one. Only of `decr` and `incr`: the scan makes pairs of no others, and a plain name
/// beside other endings may be meant.
fn misnamed<'a>(
    folder: TargetFolder<'a>,
    file: &FileFacts,
    rel: &str,
    pair: Pair<'_>,
) -> Option<&'a FileFacts> {
    let (stem, ending) = rel
        .strip_suffix(".target")?
        .rsplit_once('-')
        .filter(|_| pair == ("decr", "incr"))?;
    let plain = folder.layer.file(&format!("{stem}.target"));
    let path = parent(&file.rel);
    let alike = folder.layer.beginning_with(format!("{stem}-"));
    let mut misspelt = alike
        .filter(|other| other.kind == Kind::Target && parent(&other.rel) == path)
        .filter(|other| {
            let word = other
                .rel
                .strip_prefix(stem)
                .and_then(|rest| rest.strip_prefix('-')?.strip_suffix(".target"));
            word.is_some_and(|word| {
                word != pair.0 && word != pair.1 && nearest(word, [ending]).is_some()
            })
        });
    plain.or_else(|| misspelt.next())
}

/// The name of the opposite target and the pair of endings, if the name has such an ending.
fn opposite_of<'a>(file: &FileFacts, endings: &Endings<'a>) -> Option<(String, Pair<'a>)> {
    let (begin, other, pair) = endings.split(file.stem())?;
    Some((format!("{begin}-{other}"), pair))
}
