//! An asset is opened by an extension in small letters.

use super::super::{Check, Rule, RuleCx};
use mhlint_diag::{Application::Makehuman1, Case, Finding, Level, Place, RuleInfo};
use mhlint_discover::{extension, library_extension, library_of};
use mhlint_repo::makehuman1::View;
use mhlint_source::parent;

pub(crate) static RULE: Rule = Check::Makehuman1(run).rule(RuleInfo {
    breaks: &[(Makehuman1, "lists the asset and cannot open it")],
    docs: include_str!("extension_case.md").trim_ascii_end(),
    ..RuleInfo::new(
        "proxy-extension-case",
        Level::Error,
        "an asset whose extension has capitals",
    )
});

const TWINS: Case = &[(
    Makehuman1,
    Level::Error,
    "lists nothing of this library: two files differ only in case",
)];

fn run(view: &View<'_>, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    let layer = view.layers.checked;
    for file in layer.files.values() {
        let Some(library) = library_of(&file.rel) else {
            continue;
        };
        let Some(right) = library_extension(library).filter(|right| *right != extension(&file.rel))
        else {
            continue;
        };
        let name = format!("{}.{right}", file.stem());
        let twin = layer.file(&format!("{}/{name}", parent(&file.rel)));
        // Only what is worn, and topologies, are opened by another name than they are called.
        if twin.is_none()
            && matches!(
                library,
                "poses" | "skins" | "rigs" | "expressions" | "models"
            )
        {
            continue;
        }
        let message = format!(
            "`{}` must end in `.{right}`: capitals matter",
            file.file_name()
        );
        let finding = RULE.at(file, Place::File, message);
        out.push(match twin {
            Some(twin) => {
                let help = "remove one of the two files, or give this one a name of its own";
                finding
                    .case(TWINS)
                    .related(twin.path.clone(), Place::File, "the other file")
                    .help(help)
            }
            None => finding.help(format!("rename it to `{name}`")),
        });
    }
}
