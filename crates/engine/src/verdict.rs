//! How a run ends: its counts and verdicts, and which files it has looked at.

use std::collections::BTreeSet;
use std::path::{Path, PathBuf};

use mhlint_config::Config;
use mhlint_diag::{Application, ApplicationVerdict, Level, Outcome, Verdict, grade_consumers};
use mhlint_discover::Layout;
use mhlint_source::{resolved, slashed};

/// Counts the findings by level and gives every application its verdict.
pub(super) fn conclude(outcome: &mut Outcome, config: &Config) {
    let of = |level| {
        outcome
            .findings
            .iter()
            .filter(|finding| finding.level == level)
            .count()
    };
    let counts = (of(Level::Error), of(Level::Warning), of(Level::Info));
    (
        outcome.summary.error,
        outcome.summary.warning,
        outcome.summary.info,
    ) = counts;
    grade_consumers(&mut outcome.consumers, &outcome.findings);
    let checked: BTreeSet<Application> =
        outcome.roots.iter().map(|root| root.application).collect();
    outcome.applications = checked
        .into_iter()
        .map(|application| verdict(application, outcome, config))
        .collect();
}

/// A finding counts for the applications that it breaks, at its level for each.
fn verdict(application: Application, outcome: &Outcome, config: &Config) -> ApplicationVerdict {
    let breaks = outcome.findings.iter().flat_map(|finding| &finding.breaks);
    let levels = breaks
        .filter(|one| one.application == application)
        .map(|one| one.level);
    let passes = outcome.is_whole() && !config.fails(levels);
    ApplicationVerdict {
        application,
        verdict: if passes { Verdict::Pass } else { Verdict::Fail },
    }
}

/// Whether a file lies where a checked data root or the system data have their assets, or is a
/// loose one of them.
pub fn holds_asset(outcome: &Outcome, file: &Path, systems: &[PathBuf]) -> bool {
    let place = resolved(file);
    let is_asset_in = |(root, application): (&Path, Application)| {
        let rel = place
            .strip_prefix(resolved(root))
            .map(slashed)
            .unwrap_or_default();
        Layout::of(application).is_asset(&rel)
    };
    let roots = outcome
        .roots
        .iter()
        .map(|root| (Path::new(root.path.as_str()), root.application));
    let systems = systems
        .iter()
        .flat_map(|system| Application::ALL.map(|application| (system.as_path(), application)));
    roots.chain(systems).any(is_asset_in)
}

#[cfg(test)]
mod tests {
    use super::*;
    use mhlint_diag::{FailedStep, Finding, Place, RootSummary, RuleInfo};

    /// An error for one application and an info for another one.
    const RULE: RuleInfo = RuleInfo {
        breaks: &[
            (Application::Makehuman2, "stops"),
            (Application::Mpfb, "ignores it"),
        ],
        levels: &[(Application::Mpfb, Level::Info)],
        ..RuleInfo::new("a-rule", Level::Error, "a fault")
    };

    fn checked(findings: Vec<Finding>) -> Outcome {
        let root = |application| RootSummary {
            path: String::new(),
            application,
            bases: Vec::new(),
            identity: mhlint_diag::Identity::default(),
        };
        let roots = [Application::Mpfb, Application::Makehuman2]
            .map(root)
            .to_vec();
        Outcome {
            roots,
            findings,
            ..Outcome::default()
        }
    }

    fn verdicts(findings: Vec<Finding>, config: &Config) -> [(Application, Verdict); 2] {
        let mut outcome = checked(findings);
        conclude(&mut outcome, config);
        [0, 1].map(|number| {
            (
                outcome.applications[number].application,
                outcome.applications[number].verdict,
            )
        })
    }

    #[test]
    fn a_run_that_misses_something_does_not_pass() {
        let what = || vec!["something".to_owned()];
        let config = Config {
            fail_on: None,
            ..Config::default()
        };
        assert!(config.passes(&Outcome::default()));
        for missing in [
            Outcome {
                failed_rules: what(),
                ..Outcome::default()
            },
            Outcome {
                failed_files: what(),
                ..Outcome::default()
            },
            Outcome {
                failed_steps: vec![FailedStep::Places],
                ..Outcome::default()
            },
        ] {
            assert!(!config.passes(&missing) && !missing.is_whole());
        }
    }

    #[test]
    fn a_finding_fails_only_the_applications_that_it_breaks() {
        use Application::{Makehuman2, Mpfb};
        use Verdict::{Fail, Pass};
        let only = RuleInfo {
            breaks: &[(Mpfb, "stops")],
            levels: &[],
            ..RULE
        };
        let found = |rule: &RuleInfo| vec![Finding::new(rule, "a", Place::File, "it")];
        let config = Config::default();
        assert_eq!(
            verdicts(found(&only), &config),
            [(Makehuman2, Pass), (Mpfb, Fail)]
        );
        assert_eq!(
            verdicts(found(&RULE), &config),
            [(Makehuman2, Fail), (Mpfb, Pass)]
        );
        let settings = RuleInfo {
            breaks: &[],
            levels: &[],
            ..RULE
        };
        assert_eq!(
            verdicts(found(&settings), &config),
            [(Makehuman2, Pass), (Mpfb, Pass)]
        );
        assert!(
            !config.passes(&checked(found(&settings))),
            "the run fails all the same"
        );
    }

    #[test]
    fn warnings_are_counted_for_each_application() {
        let warned = |application| {
            Finding::new(&RULE, "a", Place::File, "it")
                .level(Level::Info)
                .level_in(application, Level::Warning)
        };
        let config = Config {
            max_warnings: Some(1),
            ..Config::default()
        };
        let [own, other] = [Application::Makehuman2, Application::Mpfb];
        let found = verdicts(vec![warned(own), warned(own), warned(other)], &config);
        assert_eq!(found, [(own, Verdict::Fail), (other, Verdict::Pass)]);
    }
}
