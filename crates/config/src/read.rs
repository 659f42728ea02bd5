//! The text of `mhlint.toml` to a [`Config`], or to everything that is wrong with it.

use std::ops::Range;
use std::path::{Path, PathBuf};

use toml::de::{DeTable, DeValue};

use super::fault::{Error, Fault};
use super::keys::{FILE, Key, Shape};
use super::value::{self, Value, Wrong};
use super::{Config, ConfigFile, Date, Globs, Ignore, MOST_SAMPLES, PathBlock, PathGlob, Selector};
use mhlint_diag::{
    Application, Edition, EditionFault, Level, Place, RuleInfo, Suggestions, UnknownRule, Version,
    nearest,
};
use mhlint_source::{Folder, Lines};

/// Most characters that all globs with wildcards of a file have together: some hundreds of them.
/// They take a hundred times the memory of their text, and each of them is tried on each path.
/// Plain paths and names of rules are looked up and do not count.
const MOST_COMPILED: usize = 5_000;

/// Reads a text. `inside` is its folder as printed, `folder` the same to compare paths with.
pub(super) fn read(
    text: &str,
    path: &str,
    inside: &Path,
    folder: Folder,
    rules: &[&'static RuleInfo],
) -> Result<Config, Error> {
    let file = ConfigFile {
        path: path.to_owned(),
        text: text.to_owned(),
        folder,
        ..ConfigFile::default()
    };
    let config = Config::default();
    let suggestions = Suggestions::default();
    let mut reader = Reader {
        inside,
        rules,
        config,
        file,
        faults: Vec::new(),
        compiled: 0,
        suggestions,
    };
    match DeTable::parse(text) {
        Ok(table) => reader.file(table.get_ref()),
        Err(error) => {
            let help = "correct the line; put strings in quotes and lists in brackets".to_owned();
            reader.fault((
                error.span().unwrap_or(0..0),
                format!("not valid TOML: {}", error.message()),
                help,
            ));
        }
    }
    let Reader {
        mut config,
        file,
        mut faults,
        ..
    } = reader;
    if faults.is_empty() {
        config.file = Some(file);
        return Ok(config);
    }
    faults.sort_by_key(|(span, ..)| span.start);
    let lines = Lines::of(text.as_bytes());
    let told = faults
        .into_iter()
        .map(|(span, message, help)| Fault::new(&lines, span, message, help));
    Err(Error {
        path: path.to_owned(),
        faults: told.collect(),
    })
}

struct Reader<'r> {
    inside: &'r Path,
    rules: &'r [&'static RuleInfo],
    config: Config,
    file: ConfigFile,
    faults: Vec<Wrong>,
    /// Characters of the globs with wildcards so far.
    compiled: usize,
    suggestions: Suggestions,
}

impl Reader<'_> {
    fn fault(&mut self, wrong: Wrong) {
        self.faults.push(wrong);
    }

    /// Notes what is wrong with a value, if anything.
    fn take<T>(&mut self, result: Result<T, Wrong>) -> Option<T> {
        result.map_err(|wrong| self.fault(wrong)).ok()
    }

    /// The members of a table that `keys` has; the others are faults, as is a key that must be
    /// there.
    fn members<'t, 'i>(
        &mut self,
        table: &'t DeTable<'i>,
        keys: &'static [Key],
        within: &str,
        span: &Range<usize>,
    ) -> Vec<(&'static Key, &'t Value<'i>)> {
        let mut found = Vec::new();
        for (name, value) in table {
            let Some(key) = keys.iter().find(|key| key.name == name.get_ref()) else {
                let known = keys.iter().map(|key| key.name);
                let text = name.get_ref();
                let help =
                    elsewhere(text, !within.is_empty()).unwrap_or_else(|| meant(text, known));
                self.fault((name.span(), format!("unknown key `{text}`{within}"), help));
                continue;
            };
            if within.is_empty() && !matches!(key.shape, Shape::Table(_) | Shape::Tables(_)) {
                self.file.places.insert(key.name.to_owned(), name.span());
            }
            found.push((key, value));
        }
        for key in keys
            .iter()
            .filter(|key| key.required && !found.iter().any(|(known, _)| known.name == key.name))
        {
            self.fault((
                span.clone(),
                format!("missing key `{}`{within}", key.name),
                format!("add it: {}", key.docs),
            ));
        }
        found
    }

    fn file(&mut self, table: &DeTable<'_>) {
        for (key, value) in self.members(table, FILE, "", &(0..0)) {
            match key.name {
                "fail-on" => {
                    let level = value::level(key.name, value, "never");
                    self.config.fail_on = self.take(level).unwrap_or_default();
                }
                "max-warnings" => {
                    self.config.max_warnings = self.take(value::number(key.name, value));
                }
                "select" => self.file.select = self.selectors(key.name, value),
                "skip" => self.file.skip = self.selectors(key.name, value),
                "exclude" => self.file.exclude = self.globs(key.name, value),
                "system" => self.config.systems = self.paths(key.name, value),
                "baseline" => self.config.baseline = self.path(key.name, value),
                "apps" => {
                    let editions = self.applications(key.name, value);
                    self.config.check_for(&editions);
                }
                "bases" => {
                    let names = self.take(value::texts(key.name, value)).unwrap_or_default();
                    self.config.bases =
                        names.into_iter().map(|(name, _)| name.to_owned()).collect();
                }
                "level" => self.file.levels = self.levels(key.name, value),
                "rule" => self.options(value),
                "path" => self.each(key, value, Self::block),
                "ignore" => self.each(key, value, Self::ignore),
                _ => self.eval(key, value),
            }
        }
    }

    fn path(&mut self, name: &str, value: &Value<'_>) -> Option<PathBuf> {
        self.take(value::text(name, value))
            .map(|text| self.inside.join(text))
    }

    /// One path, or a list of several.
    fn paths(&mut self, name: &str, value: &Value<'_>) -> Vec<PathBuf> {
        if value.get_ref().as_array().is_none() {
            return self.path(name, value).into_iter().collect();
        }
        let texts = self.take(value::texts(name, value)).unwrap_or_default();
        texts
            .into_iter()
            .map(|(text, _)| self.inside.join(text))
            .collect()
    }

    fn globs(&mut self, name: &str, value: &Value<'_>) -> Globs {
        let texts = self.take(value::texts(name, value)).unwrap_or_default();
        texts
            .into_iter()
            .filter_map(|(text, span)| self.glob(text, span))
            .collect()
    }

    fn glob(&mut self, text: &str, span: Range<usize>) -> Option<PathGlob> {
        let glob = self.compile(text, &span, PathGlob::new, PathGlob::compiled)?;
        let help =
            "`*` matches any part of a name, `**/` any folders; close every bracket and brace";
        self.take(glob.map_err(|reason| (span, no_glob(text, &reason), help.to_owned())))
    }

    /// Compiles a glob, unless there are too many before it.
    fn compile<G>(
        &mut self,
        text: &str,
        span: &Range<usize>,
        new: fn(&str, Range<usize>) -> Result<G, String>,
        size: fn(&G) -> usize,
    ) -> Option<Result<G, String>> {
        if self.compiled > MOST_COMPILED {
            return None;
        }
        let glob = new(text, span.clone());
        self.compiled = self.compiled.saturating_add(glob.as_ref().map_or(0, size));
        if self.compiled > MOST_COMPILED {
            let message = format!(
                "the globs up to this one have more than {MOST_COMPILED} characters in total"
            );
            let help =
                "use names without wildcards, which do not count, or a baseline for known findings";
            self.fault((span.clone(), message, help.to_owned()));
        }
        Some(glob)
    }

    /// Selectors of rules. One that names a safety rule is refused, one that fits nothing is noted.
    fn selectors(&mut self, name: &str, value: &Value<'_>) -> Vec<Selector> {
        let texts = self.take(value::texts(name, value)).unwrap_or_default();
        let ignores = name != "select";
        texts
            .into_iter()
            .filter_map(|(text, span)| self.selector(name, text, span, ignores))
            .collect()
    }

    fn selector(
        &mut self,
        setting: &str,
        text: &str,
        span: Range<usize>,
        ignores: bool,
    ) -> Option<Selector> {
        let selector = self.compile(text, &span, Selector::new, Selector::compiled)?;
        let help = "use a rule such as `macro-steps-length`, or a glob such as `macro-*`";
        let selector = self
            .take(selector.map_err(|why| (span.clone(), no_glob(text, &why), help.to_owned())))?;
        if ignores
            && self
                .rules
                .iter()
                .any(|rule| rule.id == text && rule.cannot_be_ignored)
        {
            let why = "it protects against running foreign code, leaving the data folder or \
                filling the memory";
            let message = format!("`{text}` cannot be ignored or lowered: {why}");
            self.fault((
                span.clone(),
                message,
                "remove this entry, and fix what the rule reports".to_owned(),
            ));
        }
        if !self.rules.iter().any(|rule| selector.fits(rule.id)) {
            self.unknown(setting, text, span);
        }
        Some(selector)
    }

    fn unknown(&mut self, setting: &str, rule: &str, span: Range<usize>) {
        let nearest = self
            .suggestions
            .nearest(rule, self.rules.iter().map(|rule| rule.id));
        let (path, place) = (self.file.path.clone(), Place::Span(span));
        self.file.unknown.push(UnknownRule {
            path,
            place,
            setting: setting.to_owned(),
            rule: rule.to_owned(),
            nearest,
        });
    }

    fn applications(&mut self, name: &str, value: &Value<'_>) -> Vec<Edition> {
        let texts = self.take(value::texts(name, value)).unwrap_or_default();
        let mut found = Vec::new();
        for (text, span) in texts {
            match Edition::parse(text) {
                Ok(edition) => found.push(edition),
                Err(EditionFault::Application) => {
                    let known = Application::ALL.map(Application::word);
                    self.fault((
                        span,
                        format!("unknown application `{text}`"),
                        meant(text, known),
                    ));
                }
                Err(EditionFault::Version(application)) => {
                    let known = Version::names(application)
                        .map(|name| format!("`{}@{name}`", application.word()));
                    let known = known.collect::<Vec<_>>().join(", ");
                    self.fault((
                        span,
                        format!("unknown version in `{text}`"),
                        format!("use one of {known}"),
                    ));
                }
            }
        }
        found
    }

    /// A table of levels by rule, in order of the file.
    fn levels(&mut self, name: &str, value: &Value<'_>) -> Vec<(Selector, Option<Level>)> {
        let Some(table) = value.get_ref().as_table() else {
            self.fault(value::wrong(name, value, "a table of rules and levels"));
            return Vec::new();
        };
        let mut levels = Vec::new();
        for (rule, value) in table {
            let text = rule.get_ref();
            if let Some(help) = elsewhere(text, true) {
                self.fault((
                    rule.span(),
                    format!("unknown rule `{text}` in `level`"),
                    help,
                ));
                continue;
            }
            let level = self.take(value::level(rule.get_ref(), value, "off"));
            let selector = self.selector(name, rule.get_ref(), rule.span(), true);
            levels.extend(selector.zip(level));
        }
        levels.sort_by_key(|(selector, _)| selector.span.start);
        levels
    }

    fn options(&mut self, value: &Value<'_>) {
        let Some(table) = value.get_ref().as_table() else {
            return self.fault(value::wrong("rule", value, "a table for each rule"));
        };
        for (name, value) in table {
            let Some(rule) = self.rules.iter().find(|rule| rule.id == name.get_ref()) else {
                match elsewhere(name.get_ref(), true) {
                    Some(help) => self.fault((
                        name.span(),
                        format!("unknown rule `{}`", name.get_ref()),
                        help,
                    )),
                    None => self.unknown("rule", name.get_ref(), name.span()),
                }
                continue;
            };
            match value.get_ref() {
                DeValue::Table(options) => self.options_of(rule, options),
                _ => self.fault(value::wrong(
                    &format!("rule.{}", rule.id),
                    value,
                    "a table of options",
                )),
            }
        }
    }

    fn options_of(&mut self, rule: &RuleInfo, options: &DeTable<'_>) {
        for (name, value) in options {
            let text = name.get_ref();
            if !rule.options.iter().any(|option| option.name == text) {
                let known = rule.options.iter().map(|option| option.name);
                let message = format!("rule `{}` has no option `{text}`", rule.id);
                self.fault((
                    name.span(),
                    message,
                    elsewhere(text, true).unwrap_or_else(|| meant(text, known)),
                ));
            } else if let Some(number) = self.take(value::real(text, value)) {
                self.config
                    .rule_options
                    .insert((rule.id.to_owned(), text.to_string()), number);
                self.file
                    .places
                    .insert(format!("rule.{}.{text}", rule.id), name.span());
            }
        }
    }

    fn each(
        &mut self,
        key: &Key,
        value: &Value<'_>,
        read: fn(&mut Self, &DeTable<'_>, &Range<usize>),
    ) {
        let wanted = format!("a list of tables, written `[[{}]]`", key.name);
        let Some(list) = value.get_ref().as_array() else {
            return self.fault(value::wrong(key.name, value, &wanted));
        };
        for item in list {
            match item.get_ref().as_table() {
                Some(table) => read(self, table, &item.span()),
                None => self.fault(value::wrong(key.name, item, &wanted)),
            }
        }
    }

    fn block(&mut self, table: &DeTable<'_>, span: &Range<usize>) {
        let (mut glob, mut skip, mut levels) = (None, Vec::new(), Vec::new());
        for (key, value) in self.members(table, members_of("path"), " in `[[path]]`", span) {
            match key.name {
                "glob" => glob = self.one_glob(key.name, value),
                "skip" => skip = self.selectors(key.name, value),
                _ => levels = self.levels(key.name, value),
            }
        }
        self.file.blocks.extend(glob.map(|glob| PathBlock {
            glob,
            skip,
            levels,
            span: span.clone(),
        }));
    }

    fn one_glob(&mut self, name: &str, value: &Value<'_>) -> Option<PathGlob> {
        let text = self.take(value::text(name, value))?;
        self.glob(text, value.span())
    }

    fn ignore(&mut self, table: &DeTable<'_>, span: &Range<usize>) {
        let (mut rule, mut path, mut reason, mut until) = (None, None, None, None);
        for (key, value) in self.members(table, members_of("ignore"), " in `[[ignore]]`", span) {
            match key.name {
                "rule" => rule = self.rule_to_ignore(value),
                "path" => path = self.one_glob(key.name, value),
                "reason" => reason = self.take(value::text(key.name, value)),
                _ => until = self.take(date(value)).map(|date| (date, value.span())),
            }
        }
        let reason = reason
            .map(str::trim)
            .filter(|reason| !reason.is_empty())
            .map(str::to_owned);
        let Some((rule, path)) = rule.zip(path) else {
            return;
        };
        let until_span = until
            .as_ref()
            .map_or_else(|| span.clone(), |(_, span)| span.clone());
        let until = until.map(|(date, _)| date);
        self.file.ignores.push(Ignore {
            rule,
            path,
            reason,
            until,
            span: span.clone(),
            until_span,
        });
    }

    /// The rule of an ignore: one that does not exist is told with the ignore.
    fn rule_to_ignore(&mut self, value: &Value<'_>) -> Option<Selector> {
        let text = self.take(value::text("rule", value))?;
        let known = self.file.unknown.len();
        let selector = self.selector("ignore", text, value.span(), true);
        self.file.unknown.truncate(known);
        selector
    }

    fn eval(&mut self, key: &'static Key, value: &Value<'_>) {
        let Some(table) = value.get_ref().as_table() else {
            return self.fault(value::wrong(key.name, value, "a table"));
        };
        for (key, value) in self.members(table, members_of("eval"), " in `[eval]`", &value.span()) {
            self.file
                .places
                .insert(format!("eval.{}", key.name), value.span());
            match key.name {
                "samples" => {
                    self.config.samples =
                        self.take(value::number_to(MOST_SAMPLES, key.name, value));
                }
                _ => {
                    self.config.exhaustive =
                        self.take(value::flag(key.name, value)).unwrap_or_default();
                }
            }
        }
    }
}

fn no_glob(text: &str, reason: &str) -> String {
    format!("`{}` is not a valid glob: {reason}", value::shortened(text))
}

/// The keys of a table of the file.
fn members_of(name: &str) -> &'static [Key] {
    let shape = FILE
        .iter()
        .find(|key| key.name == name)
        .map(|key| key.shape);
    match shape {
        Some(Shape::Table(keys) | Shape::Tables(keys)) => keys,
        _ => &[],
    }
}

fn date(value: &Value<'_>) -> Result<Date, Wrong> {
    let day = value
        .get_ref()
        .as_datetime()
        .filter(|moment| moment.time.is_none())
        .and_then(|moment| moment.date);
    let day = day.map(|day| Date(i64::from(day.year), day.month, day.day));
    day.ok_or_else(|| value::wrong("until", value, "a date without quotes, such as 2027-06-30"))
}

/// What to do about a key that is one of another table: the top is above all tables, a table begins
/// with its name.
fn elsewhere(name: &str, below: bool) -> Option<String> {
    let is_value = |key: &&Key| {
        !matches!(
            key.shape,
            Shape::Table(_) | Shape::Tables(_) | Shape::Levels | Shape::Options
        )
    };
    if below && FILE.iter().filter(is_value).any(|key| key.name == name) {
        return Some(format!(
            "`{name}` is a top-level key: put it above the first `[section]`"
        ));
    }
    let tables = FILE.iter().filter_map(|table| match table.shape {
        Shape::Table(keys) => Some((format!("[{}]", table.name), keys)),
        Shape::Tables(keys) => Some((format!("[[{}]]", table.name), keys)),
        _ => None,
    });
    let mut holding = tables.filter(|(_, keys)| keys.iter().any(|key| key.name == name));
    holding
        .next()
        .map(|(table, _)| format!("`{name}` is a key of `{table}`: put it below a `{table}` line"))
}

/// What may be meant by a name, or what there is.
fn meant(name: &str, known: impl IntoIterator<Item = &'static str> + Clone) -> String {
    if let Some(near) = nearest(name, known.clone()) {
        return format!("did you mean `{near}`?");
    }
    let known: Vec<&str> = known.into_iter().collect();
    if known.is_empty() {
        "remove it; the rule has no options".to_owned()
    } else {
        format!("use one of: {}", known.join(", "))
    }
}
