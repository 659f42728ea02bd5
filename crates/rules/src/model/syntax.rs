//! A model has at least one line that begins with a keyword of models.

use super::super::{Check, Rule, RuleCx};
use super::{mpfb_lines, own};
use mhlint_diag::{
    Application::{Makehuman2, Mpfb},
    Case, Finding, Level, Place, RuleInfo,
};
use mhlint_discover::Kind;
use mhlint_repo::makehuman2::{Base, View};
use mhlint_repo::mpfb;
use mhlint_source::Encoding;

pub(crate) static RULE: Rule = Check::EachBase(run, |_, _, _| {}, of_mpfb).rule(RuleInfo {
    breaks: &[
        (
            Makehuman2,
            "loads it as the naked default figure, without a message",
        ),
        (
            Mpfb,
            "imports the default character without a name, without a message",
        ),
    ],
    levels: &[(Mpfb, Level::Warning)],
    docs: include_str!("syntax.md").trim_ascii_end(),
    ..RuleInfo::new(
        "model-syntax",
        Level::Error,
        "a model without any line of models",
    )
});

const NO_NAME: Case = &[(Mpfb, Level::Info, "imports a character with an empty name")];

/// Whether a model has text at all. Files without content, or in another encoding than UTF-8, are
/// reported by other rules.
fn has_text(encoding: &Encoding) -> bool {
    !encoding.blank
        && !encoding.only_comments
        && !encoding.lfs_pointer
        && encoding.invalid_utf8_at.is_none()
}

fn run(view: &View<'_>, base: &Base<'_>, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    for saved in
        own(view, base).filter(|saved| has_text(&saved.file.encoding) && !saved.model.has_keyword)
    {
        let finding = RULE.at(
            saved.file,
            Place::File,
            "no line begins with a keyword of models",
        );
        out.push(
            finding.help("restore the model: this file is something else, such as a web page"),
        );
    }
}

/// Whether a byte order mark hides the line `name`, which `file-byte-order-mark` reports.
fn has_lost_name(encoding: &Encoding) -> bool {
    encoding.byte_order_mark
        && encoding
            .marked_words
            .first()
            .is_some_and(|word| &**word == "name")
}

/// The checks for MPFB, which finds keywords only at the start of a line.
fn of_mpfb(view: &mpfb::View<'_>, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    for file in view
        .own(Kind::Model)
        .filter(|file| has_text(&file.encoding))
    {
        let Some(model) = file.model() else { continue };
        let (columns, unparted) = (&model.columns, mpfb_lines::read_unparted(model));
        out.extend(mpfb_lines::rig(&RULE, file, columns));
        if columns.has_line {
            out.extend(mpfb_lines::displaced(&RULE, file, columns));
            out.extend(mpfb_lines::without_blank(&RULE, file, &unparted));
        }
        if !columns.has_line {
            let finding = RULE.at(
                file,
                Place::File,
                "no line begins with a keyword of models at its first column",
            );
            out.push(finding.help("restore the model, or remove the blanks before its keywords"));
        } else if !columns.has_name
            && columns.displaced.is_empty()
            && unparted.is_empty()
            && !has_lost_name(&file.encoding)
        {
            let finding = RULE
                .at(file, Place::File, "the model has no line `name`")
                .key("name")
                .case(NO_NAME);
            out.push(finding.help("add a line `name` with the name of the character"));
        }
    }
}
