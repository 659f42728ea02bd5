//! Files far beyond the size of their kind.

use super::super::{Check, Rule, RuleCx};
use mhlint_diag::{Application::Makehuman2, Finding, Level, OptionInfo, Place, RuleInfo};
use mhlint_discover::Kind;
use mhlint_formats::Format;
use mhlint_repo::{FileFacts, View};
use mhlint_source::ReadFault;

pub(crate) static RULE: Rule = Check::File(run).rule(RuleInfo {
    breaks: &[(Makehuman2, "loads it slowly and uses a lot of memory")],
    options: &[
        OptionInfo {
            name: "json",
            default: 8.0,
            docs: "largest JSON, skeleton or weights file in MB (1,000,000 bytes)",
        },
        OptionInfo {
            name: "target",
            default: 4.0,
            docs: "largest target in MB; all 19158 vertices of hm08 need 0.6",
        },
        OptionInfo {
            name: "mesh",
            default: 32.0,
            docs: "largest mesh (.obj, base.mhbin) in MB; hm08 has 2",
        },
        OptionInfo {
            name: "picture",
            default: 32.0,
            docs: "largest picture in MB; 4096 by 4096 pixels need up to 64 unpacked",
        },
        OptionInfo {
            name: "other",
            default: 256.0,
            docs: "largest file of any other kind in MB",
        },
    ],
    docs: include_str!("too_large.md").trim_ascii_end(),
    ..RuleInfo::new(
        "file-too-large",
        Level::Warning,
        "a file that is unusually large for its kind",
    )
});

/// Bytes in a MB.
const MB: f64 = 1e6;

fn run(_: &View<'_>, file: &FileFacts, cx: &RuleCx<'_>, out: &mut Vec<Finding>) {
    let size = file.size as f64;
    let limit = cx.option(&RULE, option(file));
    let unread = matches!(file.unreadable, Some(ReadFault::TooLarge { .. }));
    if size <= limit * MB && !unread {
        return;
    }
    let message = if unread {
        format!(
            "{} too large to check: {:.1} MB",
            Format::of(file.kind).title,
            size / MB
        )
    } else {
        format!(
            "unusually large {}: {} MB, more than {limit} MB",
            Format::of(file.kind).title,
            above(size / MB, limit)
        )
    };
    let help = if unread {
        "make it smaller: mhlint reads no file of more than 512 MiB".to_owned()
    } else {
        format!(
            "make it smaller, or raise the option `{}` of this rule",
            option(file)
        )
    };
    out.push(RULE.at(file, Place::File, message).help(help));
}

/// A number with as many decimals as show that it is larger than a limit, at least one.
fn above(size: f64, limit: f64) -> String {
    let shown = (1..=6).map(|decimals| format!("{size:.decimals$}"));
    let mut differing = shown.filter(|text| text.parse::<f64>().is_ok_and(|shown| shown > limit));
    differing.next().unwrap_or_else(|| size.to_string())
}

fn option(file: &FileFacts) -> &'static str {
    match file.kind {
        kind if Format::of(kind).is_json() => "json",
        Kind::Target | Kind::PackedTarget => "target",
        Kind::BaseMesh | Kind::MeshArchive | Kind::PackedBaseMesh | Kind::AssetMesh => "mesh",
        Kind::Image | Kind::TargetIcon => "picture",
        _ => "other",
    }
}
