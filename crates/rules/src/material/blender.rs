//! What MPFB makes of a material (`docs/loaders/mpfb/materials.md#lines-of-a-material`,
//! `docs/loaders/mpfb/materials.md#what-a-material-uses`).

use std::collections::{BTreeMap, BTreeSet};

use super::super::{Rule, RuleCx, did_you_mean, shown};
use super::beside::free_pictures;
use super::faulty_lines::{FaultyLine, Lines, at};
use super::picture::fault;
use super::something_else;
use super::spelling::{self, Meant};
use mhlint_diag::{Application::Mpfb, Case, Evidence, Finding, Level, Place, Suggestions, grouped};
use mhlint_discover::{Kind, Single};
use mhlint_formats::mhmat::mpfb::{is_file, is_key};
use mhlint_formats::mhmat::{Unknown, Value, Word};
use mhlint_formats::python_float;
use mhlint_repo::mpfb::{self, Look, Set};
use mhlint_repo::{FileFacts, Reference, ReferenceKind, Resolution, View, Wearer};
use mhlint_source::{first_name, parent};

const NO_VALUE: Case = &[(
    Mpfb,
    Level::Error,
    "fails with `AttributeError` when it reads the material",
)];
const NO_NUMBER: Case = &[(
    Mpfb,
    Level::Error,
    "fails with `ValueError` when it reads the material",
)];
const TAG: Case = &[(
    Mpfb,
    Level::Error,
    "fails with an exception when it reads the material",
)];
const PARAMETER: Case = &[(
    Mpfb,
    Level::Error,
    "fails with `TypeError` when it reads the material",
)];
const NO_COLOUR: Case = &[(
    Mpfb,
    Level::Warning,
    "ignores the colour and takes its default",
)];

/// Keywords without what has to stand behind them.
pub(super) fn arity(rule: &Rule, view: &View<'_>, out: &mut Vec<Finding>) {
    for look in view.looks() {
        let of =
            |wanted: fn(&Set<'_>) -> bool, message: fn(&Set<'_>) -> String| -> Vec<FaultyLine> {
                let own = look.lines.iter().filter(|set| wanted(set));
                own.map(|set| (at(set), set.key.name.to_owned(), message(set)))
                    .collect()
            };
        let lines = |case| Lines {
            rule,
            file: look.file,
            case,
        };
        let empty = of(lacks_value, |set| {
            format!("`{}` has no value", set.statement.key.text)
        });
        out.extend(lines(NO_VALUE).told(&empty, "write the value, or remove the line"));
        let tags: Vec<_> = empty_tags(look).collect();
        out.extend(lines(TAG).told(&tags, "write the tag, or remove the line"));
        let parameter = of(
            |set| set.key.value == Value::Parameter && set.value.split_whitespace().count() != 2,
            |set| {
                let words = set.value.split_whitespace().count();
                format!("`shaderParam` has {words} words behind it, expected 2")
            },
        );
        out.extend(
            lines(PARAMETER).told(&parameter, "write a name and one value, or remove the line"),
        );
    }
}

/// Tags are joined: one without a value cannot be put behind another.
fn empty_tags<'l>(look: &'l Look<'_>) -> impl Iterator<Item = FaultyLine> + use<'l> {
    let tags = look.lines.iter().filter(|set| set.key.name == "tag");
    let behind = tags.skip_while(|set| set.value.is_empty());
    let empty = behind.filter(|set| set.value.is_empty() && !set.statement.ends_file);
    empty.map(|set| {
        (
            at(set),
            "tag".to_owned(),
            "`tag` has no value, and stands behind another one".to_owned(),
        )
    })
}

/// Of other texts nothing is missed.
fn lacks_value(set: &Set<'_>) -> bool {
    let is_needed = is_file(set.key) || set.key.value == Value::Number;
    is_needed && set.value.is_empty() && !set.statement.ends_file
}

/// Numbers and colours that are none.
pub(super) fn values(rule: &Rule, view: &View<'_>, out: &mut Vec<Finding>) {
    for look in view.looks() {
        let lines = |case| Lines {
            rule,
            file: look.file,
            case,
        };
        let of = |sort: Value, is_wrong: fn(&str) -> bool, what: &str| -> Vec<FaultyLine> {
            let own = look
                .lines
                .iter()
                .filter(|set| set.key.value == sort && !set.value.is_empty());
            let own = own.filter(|set| is_wrong(&set.value));
            own.map(|set| {
                let message = format!(
                    "`{}` of `{}` is not {what}",
                    shown(&set.value),
                    set.statement.key.text
                );
                (at(set), set.key.name.to_owned(), message)
            })
            .collect()
        };
        let numbers = of(
            Value::Number,
            |value| python_float(value.as_bytes()).is_none(),
            "one number",
        );
        out.extend(lines(NO_NUMBER).told(
            &numbers,
            "write one number with a decimal point, and no comment behind it",
        ));
        let (broken, unread): (Vec<_>, Vec<_>) = of(
            Value::Colour,
            |value| colour(value) != Colour::Read,
            "a colour",
        )
        .into_iter()
        .partition(|(place, _, _)| is_broken(look, place));
        let help = "write three numbers from 0 to 1 with decimal points and spaces between them";
        out.extend(lines(NO_NUMBER).told(&broken, help));
        out.extend(lines(NO_COLOUR).told(&unread, help));
    }
}

#[derive(PartialEq, Eq)]
enum Colour {
    Read,
    Ignored,
    Broken,
}

/// Three words of digits and points; any other is passed over.
fn colour(value: &str) -> Colour {
    let words: Vec<&str> = value.split_whitespace().collect();
    let is_plain = |word: &&str| word.chars().all(|one| one.is_ascii_digit() || one == '.');
    match words.len() == 3 && words.iter().all(is_plain) {
        false => Colour::Ignored,
        true if words
            .iter()
            .all(|word| python_float(word.as_bytes()).is_some()) =>
        {
            Colour::Read
        }
        true => Colour::Broken,
    }
}

fn is_broken(look: &Look<'_>, place: &Place) -> bool {
    look.lines
        .iter()
        .any(|set| at(set) == *place && colour(&set.value) == Colour::Broken)
}

const QUOTE: Case = &[(
    Mpfb,
    Level::Error,
    "fails with an exception when it makes the material",
)];

/// Quotes and control characters in paths.
pub(super) fn quotes(rule: &Rule, view: &View<'_>, out: &mut Vec<Finding>) {
    for look in view.looks() {
        let is_bad = |one: &&Reference<'_>| {
            one.text
                .contains(|letter: char| letter == '"' || letter.is_control())
        };
        let own = look.pictures.iter().filter(is_bad);
        let faults: Vec<_> = own
            .map(|one| {
                let what = if one.text.contains('"') {
                    "a quote"
                } else {
                    "a control character"
                };
                let message = format!(
                    "`{}` has {what} in its name: `{}`",
                    one.owner,
                    shown(&one.text.escape_debug().to_string())
                );
                (one.place.clone(), one.owner.to_owned(), message)
            })
            .collect();
        out.extend(
            Lines {
                rule,
                file: look.file,
                case: QUOTE,
            }
            .told(&faults, "write the name without it"),
        );
    }
}

const OF_SKIN: Case = &[(
    Mpfb,
    Level::Error,
    "fails with `RuntimeError` when the skin is used as a layered one; others lack the picture",
)];

/// Pictures that do not exist.
pub(super) fn missing(rule: &Rule, view: &View<'_>, cx: &RuleCx<'_>, out: &mut Vec<Finding>) {
    let mut beside: BTreeMap<&str, Vec<&str>> = BTreeMap::new();
    for look in view.looks() {
        for one in &look.pictures {
            let is_absent = matches!(one.resolution, Resolution::Missing | Resolution::Unusable);
            let is_told = one.text.contains('"') || is_rewritten(look, one);
            if !is_absent || is_told || view.layers().checked.has_fault(&one.rel) {
                continue;
            }
            let what = if matches!(one.resolution, Resolution::Unusable) {
                "cannot be opened"
            } else {
                "does not exist"
            };
            let message = format!("texture `{}` of `{}` {what}", shown(one.text), one.owner);
            let folder = parent(&look.file.rel);
            let beside = beside
                .entry(folder)
                .or_insert_with(|| free_pictures(view, folder));
            let help = advice(one, beside, cx);
            let finding = rule
                .at(look.file, one.place.clone(), message)
                .key(one.owner)
                .help(help);
            out.push(if one.kind == ReferenceKind::SkinTexture {
                finding.case(OF_SKIN)
            } else {
                finding
            });
        }
    }
}

const OTHERWISE: &str = "correct the name, add the picture, or remove the line";

/// What to write for a picture that is not found.
fn advice(one: &Reference<'_>, beside: &[&str], cx: &RuleCx<'_>) -> String {
    if let Some((name, _)) = one.text.split_once(" #") {
        return format!(
            "write `{}`: a comment behind it belongs to the name",
            name.trim_end()
        );
    }
    let near = cx.suggestions.nearest(one.text, beside.iter().copied());
    did_you_mean(near, OTHERWISE)
}

/// The line that names a picture.
fn line<'l>(look: &'l Look<'_>, picture: &Reference<'_>) -> Option<&'l Set<'l>> {
    look.lines
        .iter()
        .find(|set| Place::Span(set.statement.value.span.clone()) == picture.place)
}

/// Whether the correction of the keyword changes the name of the picture.
fn is_rewritten(look: &Look<'_>, picture: &Reference<'_>) -> bool {
    line(look, picture).is_some_and(|set| set.value != *set.statement.value.text)
}

/// Names that the correction of a keyword changes.
pub(super) fn rewritten(rule: &Rule, view: &mpfb::View<'_>, out: &mut Vec<Finding>) {
    for look in &view.looks {
        for one in look
            .pictures
            .iter()
            .filter(|one| is_rewritten(look, one) && one.found().is_none())
        {
            let Some(set) = line(look, one) else { continue };
            let message = format!(
                "`{}` is corrected in `{}` as well: `{}`",
                set.statement.key.text, one.text, set.value
            );
            let finding = rule
                .at(look.file, one.place.clone(), message)
                .key(one.owner);
            out.push(finding.help(format!("write `{}` for the keyword", one.owner)));
        }
    }
}

/// Files that are no pictures.
pub(super) fn unreadable(rule: &Rule, view: &View<'_>, out: &mut Vec<Finding>) {
    let mut named: BTreeMap<&str, (&FileFacts, Vec<String>)> = BTreeMap::new();
    // The skin of the add-on names its pictures in code.
    let is_of_skin =
        |file: &FileFacts| (view.layout().single)(&file.rel) == Some(Single::SkinPicture);
    for file in view.files().filter(|file| is_of_skin(file)) {
        named.insert(&file.path, (file, vec!["the layered skin".to_owned()]));
    }
    for look in view.looks() {
        for one in &look.pictures {
            let Some(file) = one.found() else { continue };
            let cases = &mut named.entry(&file.path).or_insert((file, Vec::new())).1;
            cases.push(format!("{} {}", look.file.file_name(), one.owner));
        }
    }
    for (file, cases) in named.into_values() {
        let Some(message) = fault(file) else { continue };
        let finding = rule
            .at(file, Place::File, message)
            .evidence(Evidence::of_unnamed(cases));
        out.push(finding.help("export it again as PNG, or restore it"));
    }
}

/// Words that are meant as keywords, and keywords that stand behind white space.
pub(super) fn unknown(rule: &Rule, view: &View<'_>, cx: &RuleCx<'_>, out: &mut Vec<Finding>) {
    for look in view.looks() {
        if let Some(finding) = something_else::told(rule, look) {
            out.push(finding);
            continue;
        }
        // What other applications read is left to them.
        let is_of_others = |word: &str| {
            look.material
                .lines
                .iter()
                .any(|line| line.keyword.name == word)
        };
        let mut near = Vec::new();
        let mut indented = Vec::new();
        for statement in &look.material.statements {
            let word = &*statement.key.text;
            let place = Place::Span(statement.key.span.clone());
            let known = is_key(word);
            if statement.is_indented && known && look.last_of(word).is_none() {
                indented.push((place, word.to_owned(), format!("`{word}` is indented")));
            } else if !known && !look.reads(word) && !is_of_others(word) {
                near.extend(misspelt(&statement.key, cx));
            }
        }
        // Words of more than letters begin no statement.
        let is_statement = |word: &Word| word.text.bytes().all(|byte| byte.is_ascii_alphabetic());
        let others = look
            .material
            .unknown
            .iter()
            .map(|one| &one.word)
            .filter(|word| !is_statement(word));
        near.extend(others.filter_map(|word| misspelt(word, cx)));
        let lines = Lines {
            rule,
            file: look.file,
            case: &[],
        };
        out.extend(lines.told(&indented, "remove the white space in front of the line"));
        out.extend(lines.told(
            &near,
            "correct the keyword, or put `# ` in front of the line",
        ));
        out.extend(
            look.material
                .unknown
                .iter()
                .find_map(|one| unparted(rule, look, one, cx)),
        );
    }
}

/// A word that is meant as a keyword.
fn misspelt(word: &Word, cx: &RuleCx<'_>) -> Option<FaultyLine> {
    let Meant::Keyword(meant) = spelling::meant(&word.text, is_key, &cx.suggestions) else {
        return None;
    };
    let message = format!(
        "`{}` is not a keyword of a material, but `{meant}` is",
        shown(&word.text)
    );
    Some((
        Place::Span(word.span.clone()),
        word.text.to_string(),
        message,
    ))
}

/// A keyword with its value written against it.
fn unparted(rule: &Rule, look: &Look<'_>, one: &Unknown, cx: &RuleCx<'_>) -> Option<Finding> {
    let word = &*one.word.text;
    let Meant::Glued(keyword) = spelling::meant(word, is_key, &cx.suggestions) else {
        return None;
    };
    if look.last_of(keyword).is_some() {
        return None;
    }
    let message = format!("`{}` is not a keyword of a material", shown(word));
    let finding = rule
        .at(look.file, Place::Span(one.word.span.clone()), message)
        .key(word);
    Some(finding.help(spelling::parted(keyword, one)))
}

/// Both maps in one material.
pub(super) fn conflicting(rule: &Rule, view: &mpfb::View<'_>, out: &mut Vec<Finding>) {
    for look in &view.looks {
        let (Some(_), Some(specular)) = (
            look.picture("roughnessmapTexture"),
            look.picture("specularmapTexture"),
        ) else {
            continue;
        };
        let message = "the material has both `roughnessmapTexture` and `specularmapTexture`";
        out.push(
            rule.at(look.file, specular.place.clone(), message)
                .help("remove one of the two lines"),
        );
    }
}

/// Materials of what is worn that have a colour alone.
pub(super) fn plain(rule: &Rule, view: &mpfb::View<'_>, out: &mut Vec<Finding>) {
    // Eyes have a setting of their own, and proxies wear the skin.
    let counts = |look: &&Look<'_>| {
        let section = first_name(&look.file.rel);
        look.wearer == Wearer::Asset && !matches!(section, "eyes" | "proxymeshes")
    };
    for look in view
        .looks
        .iter()
        .filter(counts)
        .filter(|look| is_plain(look))
    {
        let finding = rule.at(
            look.file,
            Place::File,
            "the material of an asset has no `diffuseTexture`",
        );
        out.push(finding.help("add a `diffuseTexture`: a small picture of one colour does"));
    }
}

const DIFFUSE: &str = "diffuseTexture";

/// A keyword that is meant to be `diffuseTexture` has a finding of its own.
fn is_plain(look: &Look<'_>) -> bool {
    let is_meant = |word: &str| match spelling::meant(word, is_key, &Suggestions::default()) {
        Meant::Keyword(name) | Meant::Glued(name) => name == DIFFUSE,
        Meant::Nothing => word.eq_ignore_ascii_case(DIFFUSE),
    };
    let is_empty = look.file.encoding.blank || look.file.encoding.only_comments;
    let words = look
        .material
        .statements
        .iter()
        .map(|statement| &statement.key.text);
    let is_spelt = words
        .chain(look.material.unknown.iter().map(|one| &one.word.text))
        .any(|word| is_meant(word));
    look.picture(DIFFUSE).is_none() && !is_empty && !is_spelt
}

/// Skins without a texture, where there are ink layers.
pub(super) fn bare_skins(rule: &Rule, view: &mpfb::View<'_>, out: &mut Vec<Finding>) {
    let layers = || view.layers.strongest_first().chain(view.layers.beside);
    let has_ink = layers().any(|layer| {
        layer
            .below("ink_layers")
            .any(|file| file.kind_in(Mpfb) == Kind::InkLayer)
    });
    let skins = view
        .looks
        .iter()
        .filter(|look| has_ink && look.wearer == Wearer::Skin);
    for look in skins.filter(|look| look.picture("diffuseTexture").is_none()) {
        let finding = rule.at(look.file, Place::File, "the skin has no `diffuseTexture`");
        out.push(finding.help("add a `diffuseTexture`: ink layers are put over it"));
    }
}

/// Different pictures of one file name.
pub(super) fn same_names(rule: &Rule, view: &mpfb::View<'_>, out: &mut Vec<Finding>) {
    let mut found = Vec::new();
    for look in &view.looks {
        let own = look.pictures.iter().filter_map(|one| {
            one.found()
                .map(|file| (file.file_name(), (look, one, file)))
        });
        found.extend(own);
    }
    for (name, uses) in grouped(found) {
        let mut seen = BTreeSet::new();
        let different: Vec<_> = uses
            .iter()
            .filter(|(_, _, file)| seen.insert((file.size, file.content_hash)))
            .collect();
        let [(_, _, first), .., (look, one, _)] = different.as_slice() else {
            continue;
        };
        let message = format!(
            "`{name}` is the name of {} different pictures",
            different.len()
        );
        let finding = rule.at(look.file, one.place.clone(), message).key(name);
        let finding = finding.related(first.path.clone(), Place::File, "another one");
        let cases = different.iter().map(|(_, _, file)| file.shown());
        out.push(
            finding
                .evidence(Evidence::of_cases(cases))
                .help("give each picture a name of its own"),
        );
    }
}

/// Maps that are pictures in colours.
const COLOURS: [&str; 3] = [
    "diffuseTexture",
    "emissionColorMapTexture",
    "subsurfaceColorMapTexture",
];
/// Maps whose pictures stand for numbers. Heights are taken from a picture in colours on purpose.
const DATA: [&str; 3] = [
    "normalmapTexture",
    "roughnessmapTexture",
    "metallicmapTexture",
];

/// Pictures that are in use both for colours and for numbers.
pub(super) fn both_spaces(rule: &Rule, view: &mpfb::View<'_>, out: &mut Vec<Finding>) {
    let used = |maps: &'static [&'static str]| {
        let all = view
            .looks
            .iter()
            .flat_map(|look| look.pictures.iter().map(move |one| (look, one)));
        let own = all.filter(move |(_, one)| maps.contains(&one.owner));
        own.filter_map(|(look, one)| Some((one.found()?.path.as_str(), (look, one))))
    };
    let colours: BTreeMap<&str, _> = used(&COLOURS).collect();
    let mut told = BTreeSet::new();
    for (path, (look, one)) in used(&DATA) {
        let Some((other, colour)) = colours.get(path).filter(|_| told.insert(path)) else {
            continue;
        };
        let message = format!(
            "`{}` is the picture of `{}` and of `{}`",
            shown(one.text),
            colour.owner,
            one.owner
        );
        let finding = rule
            .at(look.file, one.place.clone(), message)
            .key(one.owner);
        let finding = finding.related(
            other.file.path.clone(),
            colour.place.clone(),
            "the same picture for colours",
        );
        out.push(finding.help("name a picture that was made for this map"));
    }
}
