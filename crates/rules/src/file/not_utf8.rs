//! Text must be UTF-8.

use super::super::cause::archived::weigh;
use super::super::cause::bytes_by_version::by_version;
use super::super::cause::consequence::{Damage, consequence};
use super::super::cause::is_unmet;
use super::super::{Check, Rule, RuleCx};
use mhlint_diag::{
    Application::{Makehuman1, Makehuman2, Mpfb},
    Case, Finding, Level, Place, RuleInfo,
};
use mhlint_discover::Kind;
use mhlint_formats::Format;
use mhlint_repo::{FileFacts, View};
use mhlint_source::Guess;

pub(crate) static RULE: Rule = Check::File(run).rule(RuleInfo {
    breaks: &[
        (Makehuman2, "crashes with `UnicodeDecodeError`"),
        (Makehuman1, "cannot read the file"),
        (
            Mpfb,
            "fails with `UnicodeDecodeError` where it reads the file",
        ),
    ],
    docs: include_str!("not_utf8.md").trim_ascii_end(),
    ..RuleInfo::new(
        "file-not-utf8",
        Level::Error,
        "a text file that is not UTF-8",
    )
});

fn run(view: &View<'_>, file: &FileFacts, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    let Some(at) = file
        .encoding
        .invalid_utf8_at
        .filter(|_| Format::of(file.kind).is_text() && !is_unmet(view, file))
    else {
        return;
    };
    let Some(loss) = consequence(view, &file.rel, Damage::NotUtf8) else {
        return;
    };
    // Whoever rejects the file reads no other line, either.
    let is_dropped = loss.level == Level::Warning;
    let (guess, help) = file
        .encoding
        .guess
        .map_or(("probably another encoding", SAVE), worded);
    // macOS leaves one beside each file of an archive.
    let help = if file.file_name().starts_with("._") {
        "delete it: macOS keeps its own notes in it"
    } else {
        help
    };
    let message = format!("`{}` is not UTF-8 ({guess})", file.file_name());
    let finding = loss
        .of(view, RULE.at(file, Place::Span(at..at + 1), message))
        .help(help);
    let is_whole = !matches!(file.encoding.guess, None | Some(Guess::SingleByte));
    // The lists of materials of MakeHuman 1 show them as well.
    let is_note = file.file_name().starts_with("._");
    let is_unseen = is_note && !view.is_makehuman1() && !(view.layout().scans)(&file.rel);
    let finding = match file.kind {
        Kind::Clothes
        | Kind::Material
        | Kind::Model
        | Kind::Pose
        | Kind::Motion
        | Kind::MotionMeta
            if is_unseen =>
        {
            finding.case(UNSEEN)
        }
        Kind::Clothes if is_whole => finding.case(NO_LINE),
        Kind::Clothes if file.encoding.only_comments_invalid => finding.case(IN_COMMENTS),
        Kind::Material if file.encoding.only_comments_invalid && is_dropped => {
            finding.case(IN_COMMENTS_OF_MATERIAL)
        }
        _ => finding,
    };
    let finding = by_version(view, file, finding);
    out.push(if file.kind == Kind::Target {
        weigh(&view.target(file), finding)
    } else {
        finding
    });
}

/// Of an asset in another encoding, or of something else under its name, no line is left.
const NO_LINE: Case = &[(
    Makehuman1,
    Level::Error,
    "lists the asset and does not put it on: it recognises no line",
)];

/// What macOS leaves where no list looks.
const UNSEEN: Case = &[(Makehuman2, Level::Info, "never opens it")];
const IN_COMMENTS: Case = &[(
    Makehuman1,
    Level::Info,
    "drops the letters, which are only in comments",
)];
const IN_COMMENTS_OF_MATERIAL: Case = &[(
    Makehuman2,
    Level::Info,
    "drops the letters, which are only in comments",
)];

const SAVE: &str = "save the file as UTF-8 without a byte order mark";

/// What the bytes are, and what to do.
const fn worded(guess: Guess) -> (&'static str, &'static str) {
    match guess {
        Guess::Utf16 => ("probably UTF-16", SAVE),
        Guess::SingleByte => ("probably Latin-1 or a Windows code page", SAVE),
        Guess::Gzip => (
            "packed with gzip",
            "unpack the file: it is read as plain text",
        ),
        Guess::Binary => ("probably binary data", "replace it with the text file"),
    }
}
