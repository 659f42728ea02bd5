//! Packs that lie side by side: whoever has several in one library has their assets in one list.

use super::super::side_by_side::{Identity, Listed, SideBySide};
use super::super::{Rule, counted};
use super::shelves;
use mhlint_diag::{Application, Case, Finding, Level, Place, grouped};
use mhlint_repo::{FileFacts, View, makehuman1, makehuman2, mpfb};
use mhlint_source::file_name;

/// Adds the assets of a pack.
pub fn add_pack(beside: &mut SideBySide, view: &View<'_>) {
    let identities = match view {
        View::Makehuman2(view) => of_makehuman2(view),
        View::Makehuman1(view) => of_makehuman1(view),
        View::Mpfb(view) => of_mpfb(view),
    };
    beside.add(view.application(), &view.layers().checked.path, identities);
}

/// Name and uuid together, for each base mesh. Skeletons have a list of their own.
fn of_makehuman2<'a>(view: &makehuman2::View<'a>) -> Vec<Identity<'a>> {
    let bases = view.library.bases().into_iter();
    let assets = bases.flat_map(|base| view.library.of_base(base));
    let own = assets.filter(|one| {
        view.layers.is_checked(one.file) && one.category != "rigs" && !one.name.is_empty()
    });
    own.map(|one| (format!("{} {}{}", one.base, one.name, one.uuid), one.file))
        .collect()
}

/// The uuid, in each library.
fn of_makehuman1<'a>(view: &makehuman1::View<'a>) -> Vec<Identity<'a>> {
    let own = view.assets().filter(|one| view.layers.is_checked(one.file));
    own.filter_map(|one| Some((format!("{} {}", one.library, one.uuid?.text), one.file)))
        .collect()
}

/// The label in each list.
fn of_mpfb<'a>(view: &mpfb::View<'a>) -> Vec<Identity<'a>> {
    let own = shelves::listed(view.layers.checked);
    own.map(|(folder, file)| (format!("{folder} {}", shelves::label(file)), file))
        .collect()
}

/// What an application makes of two packs with assets that it does not tell apart.
struct Words {
    application: Application,
    what: &'static str,
    help: &'static str,
    clash: Case,
    copy: Case,
}

const MAKEHUMAN2: Words = Words {
    application: Application::Makehuman2,
    what: "the same name and uuid",
    help: "give the newer of the two a name and a uuid of its own, or say that only one of the \
        packs can be installed",
    clash: &[(
        Application::Makehuman2,
        Level::Error,
        "lists only one of them once both packs are installed",
    )],
    copy: &[(
        Application::Makehuman2,
        Level::Warning,
        "lists only one of the copies once both packs are installed",
    )],
};

const MAKEHUMAN1: Words = Words {
    application: Application::Makehuman1,
    what: "the same uuid",
    help: "give the newer of the two a uuid of its own, or say that only one of the packs can be \
        installed",
    clash: &[(
        Application::Makehuman1,
        Level::Error,
        "cannot wear both together once both packs are installed, and models may wear the other \
            one",
    )],
    copy: &[(
        Application::Makehuman1,
        Level::Warning,
        "lists both once both packs are installed; while one is worn the other cannot be chosen",
    )],
};

const MPFB: Words = Words {
    application: Application::Mpfb,
    what: "the same label",
    help: "rename the newer of the two, or say that only one of the packs can be installed",
    clash: &[(
        Application::Mpfb,
        Level::Error,
        "lists only one of them once both packs are installed",
    )],
    copy: &[(
        Application::Mpfb,
        Level::Warning,
        "lists one of the copies once both packs are installed",
    )],
};

pub(super) fn in_makehuman2(
    rule: &Rule,
    view: &makehuman2::View<'_>,
    beside: &SideBySide,
    out: &mut Vec<Finding>,
) {
    report(rule, &MAKEHUMAN2, of_makehuman2(view), beside, out);
}

pub(super) fn in_makehuman1(
    rule: &Rule,
    view: &makehuman1::View<'_>,
    beside: &SideBySide,
    out: &mut Vec<Finding>,
) {
    report(rule, &MAKEHUMAN1, of_makehuman1(view), beside, out);
}

pub(crate) fn in_mpfb(
    rule: &Rule,
    view: &mpfb::View<'_>,
    beside: &SideBySide,
    out: &mut Vec<Finding>,
) {
    report(rule, &MPFB, of_mpfb(view), beside, out);
}

/// One finding for each pair of packs, and copies apart from those that differ.
fn report<'f>(
    rule: &Rule,
    words: &Words,
    own: Vec<Identity<'f>>,
    beside: &SideBySide,
    out: &mut Vec<Finding>,
) {
    let clash =
        |(key, file): Identity<'f>| Some((file, beside.earlier(words.application, &key, file)?));
    let is_copy = |file: &FileFacts, other: &Listed| {
        file.content_hash.is_some() && file.content_hash == other.content
    };
    let clashes = own.into_iter().filter_map(clash);
    let by_pack = clashes.map(|(file, other): (&'f FileFacts, _)| {
        ((&other.pack, is_copy(file, other)), (file, other))
    });
    for ((pack, are_copies), clashes) in grouped(by_pack) {
        let Some((file, other)) = clashes.first() else {
            continue;
        };
        let message = match clashes.len() {
            1 => format!("has {} as `{}`", words.what, other.path),
            count => {
                format!(
                    "{} have {} as some of `{pack}`, first `{}`",
                    counted(count, "asset"),
                    words.what,
                    file.shown()
                )
            }
        };
        let name = file_name(pack);
        let finding = rule
            .at(file, Place::File, message)
            .key(format!("pack {name} {are_copies}"));
        let finding = finding.related(
            other.path.clone(),
            Place::File,
            "the asset of the other pack",
        );
        let finding = finding.parts_in(clashes.iter().map(|(file, _)| (file.shown(), &file.path)));
        let help = if are_copies {
            "leave the copy out of one of the packs, if they are installed together"
        } else {
            words.help
        };
        out.push(
            finding
                .case(if are_copies { words.copy } else { words.clash })
                .help(help),
        );
    }
}
