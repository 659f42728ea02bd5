//! Settings of a run: the configuration file with the command line over it, and `mhlint config`.

use std::fmt::Display;
use std::io::Write;
use std::ops::Range;
use std::path::{Path, PathBuf};

use super::args::CheckArgs;
use super::exit::{Exit, Failure};
use mhlint_config::{Config, ConfigFile, Selector, find};
use mhlint_diag::Level;
use mhlint_engine::{DEFAULT_SAMPLES, rule_infos};
use mhlint_report::printable;
use mhlint_source::{Lines, slashed};

/// The settings in effect.
pub(super) fn settings(args: &CheckArgs) -> Result<Config, Failure> {
    let path = match &args.config {
        Some(path) => Some(path.clone()),
        None => args.paths_or_here().first().and_then(|first| find(first)),
    };
    let file = path
        .map(|path| Config::load(&path, &rule_infos()))
        .transpose()?;
    let mut config = file.unwrap_or_default();
    config.only.clone_from(&args.only);
    config.skip.clone_from(&args.skip);
    config.levels.clone_from(&args.levels);
    config.no_eval = args.no_eval;
    config.exhaustive |= args.exhaustive;
    config.write_baseline = args.write_baseline;
    if !args.systems.is_empty() {
        config.systems.clone_from(&args.systems);
    }
    config.baseline = args.baseline.clone().or(config.baseline);
    config.samples = args.samples.or(config.samples);
    config.max_warnings = args.max_warnings.or(config.max_warnings);
    if !args.applications.is_empty() {
        config.check_for(&args.applications);
        forget(&mut config, "apps");
    }
    if !args.bases.is_empty() {
        config.bases.clone_from(&args.bases);
        forget(&mut config, "bases");
    }
    if let Some(fail_on) = args.fail_on {
        config.fail_on = fail_on.level();
    }
    Ok(config)
}

/// The command line stands in place of a value of the file.
fn forget(config: &mut Config, key: &str) {
    if let Some(file) = &mut config.file {
        file.places.remove(key);
    }
}

/// Shows the settings in effect and where each comes from.
pub(super) fn run(args: &CheckArgs, out: &mut dyn Write) -> Result<Exit, Failure> {
    let config = settings(args)?;
    let empty = ConfigFile::default();
    let file = config.file.as_ref().unwrap_or(&empty);
    let sheet = Sheet {
        config: &config,
        file,
        lines: Lines::of(file.text.as_bytes()),
        args,
    };
    if let Some(file) = &config.file {
        writeln!(out, "# {}", printable(&file.path))?;
    } else {
        let first = args.paths_or_here();
        let first = first.first().map_or(Path::new("."), PathBuf::as_path);
        writeln!(
            out,
            "# no mhlint.toml at or above `{}`; `mhlint init` creates one",
            printable(&slashed(first))
        )?;
    }
    let mut rows = sheet.general();
    rows.extend(sheet.levels());
    rows.extend(sheet.options());
    rows.extend(sheet.blocks());
    let width = rows
        .iter()
        .map(|(setting, _)| setting.chars().count())
        .max()
        .unwrap_or(0)
        .min(WIDEST);
    for (setting, origin) in rows {
        writeln!(out, "{setting:<width$}  # {}", printable(&origin))?;
    }
    Ok(Exit::Clean)
}

/// A setting as it would be written, and where it comes from.
type Row = (String, String);

/// Columns after which the origins need not stand below one another: a list may be as long as the
/// file.
const WIDEST: usize = 400;

const COMMAND_LINE: &str = "command line";

struct Sheet<'a> {
    config: &'a Config,
    file: &'a ConfigFile,
    lines: Lines<'a>,
    args: &'a CheckArgs,
}

impl Sheet<'_> {
    fn general(&self) -> Vec<Row> {
        let (config, args, file) = (self.config, self.args, self.file);
        let path = |path: &PathBuf| quoted(slashed(path));
        let mut rows = vec![
            self.row(
                "fail-on",
                config
                    .fail_on
                    .map_or("\"never\"".to_owned(), |l| quoted(l.word())),
                args.fail_on.is_some(),
            ),
            self.row(
                "max-warnings",
                or_none(config.max_warnings),
                args.max_warnings.is_some(),
            ),
            self.select(),
        ];
        // `--only` stands in place of these.
        if args.only.is_empty() {
            rows.push((
                "skip = ".to_owned() + &list(file.skip.iter().map(|s| &s.text)),
                self.origin("skip", false),
            ));
        }
        if !args.skip.is_empty() {
            rows.push((
                format!("skip = {}", list(&args.skip)),
                COMMAND_LINE.to_owned(),
            ));
        }
        let apps = config.editions().map(|one| one.to_string());
        rows.extend([
            self.row(
                "exclude",
                list(file.exclude.iter().map(|glob| &glob.text)),
                false,
            ),
            self.row(
                "system",
                list(config.systems.iter().map(|system| system.display())),
                !args.systems.is_empty(),
            ),
            self.row("apps", list(apps), !args.applications.is_empty()),
            self.row("bases", list(&config.bases), !args.bases.is_empty()),
            self.row(
                "baseline",
                or_none(config.baseline.as_ref().map(path)),
                args.baseline.is_some(),
            ),
        ]);
        if config.no_eval {
            rows.push((
                "eval = none (--no-eval)".to_owned(),
                COMMAND_LINE.to_owned(),
            ));
        } else {
            rows.extend([
                self.row(
                    "eval.samples",
                    config.samples.unwrap_or(DEFAULT_SAMPLES),
                    args.samples.is_some(),
                ),
                self.row("eval.exhaustive", config.exhaustive, args.exhaustive),
            ]);
        }
        rows
    }

    fn row(&self, key: &str, value: impl Display, by_command_line: bool) -> Row {
        (
            format!("{key} = {value}"),
            self.origin(key, by_command_line),
        )
    }

    /// Line of a span of the file, counted from 1.
    fn line(&self, span: &Range<usize>) -> u32 {
        self.lines.position(span.start).line
    }

    fn origin(&self, key: &str, by_command_line: bool) -> String {
        match self.file.places.get(key).map(|span| self.line(span)) {
            _ if by_command_line => COMMAND_LINE.to_owned(),
            Some(line) => format!("{}:{line}", self.file.path),
            None => "default".to_owned(),
        }
    }

    /// `--only` stands in place of what the file selects.
    fn select(&self) -> Row {
        let selected = if !self.args.only.is_empty() {
            list(&self.args.only)
        } else if self.file.select.is_empty() {
            list(["*"])
        } else {
            list(self.file.select.iter().map(|selector| &selector.text))
        };
        self.row("select", selected, !self.args.only.is_empty())
    }

    fn levels(&self) -> Vec<Row> {
        let in_force = self
            .file
            .levels
            .iter()
            .filter(|(_, level)| self.is_in_force(*level));
        let file = in_force.map(|(selector, level)| self.level(selector, *level));
        let args = self.args.levels.iter();
        file.chain(args.map(|(rule, level)| (level_text(rule, *level), COMMAND_LINE.to_owned())))
            .collect()
    }

    /// `--only` stands in place of what the file turns off; another level stays.
    fn is_in_force(&self, level: Option<Level>) -> bool {
        level.is_some() || self.args.only.is_empty()
    }

    fn level(&self, selector: &Selector, level: Option<Level>) -> Row {
        let line = self.line(&selector.span);
        (
            level_text(&selector.text, level),
            format!("{}:{line}", self.file.path),
        )
    }

    fn options(&self) -> Vec<Row> {
        let rules = rule_infos();
        let options = rules
            .iter()
            .flat_map(|rule| rule.options.iter().map(move |option| (rule.id, option)));
        options
            .map(|(rule, option)| {
                let set = self
                    .config
                    .rule_options
                    .get(&(rule.to_owned(), option.name.to_owned()));
                self.row(
                    &format!("rule.{rule}.{}", option.name),
                    set.copied().unwrap_or(option.default),
                    false,
                )
            })
            .collect()
    }

    fn blocks(&self) -> Vec<Row> {
        let at = |line: u32| format!("{}:{line}", self.file.path);
        let mut rows = Vec::new();
        for block in &self.file.blocks {
            let within = format!("path {}: ", quoted(&block.glob.text));
            if !block.skip.is_empty() && self.args.only.is_empty() {
                let skip = list(block.skip.iter().map(|selector| &selector.text));
                rows.push((format!("{within}skip = {skip}"), at(self.line(&block.span))));
            }
            for (selector, level) in block
                .levels
                .iter()
                .filter(|(_, level)| self.is_in_force(*level))
            {
                let (text, origin) = self.level(selector, *level);
                rows.push((format!("{within}{text}"), origin));
            }
        }
        for ignore in &self.file.ignores {
            let until = ignore
                .until
                .map(|until| format!(" until {until}"))
                .unwrap_or_default();
            let text = format!(
                "ignore {} in {}{until}",
                quoted(&ignore.rule.text),
                quoted(&ignore.path.text)
            );
            rows.push((text, at(self.line(&ignore.span))));
        }
        rows
    }
}

fn level_text(rule: &str, level: Option<Level>) -> String {
    format!(
        "level.{rule} = {}",
        quoted(level.map_or("off", Level::word))
    )
}

fn list<T: Display>(items: impl IntoIterator<Item = T>) -> String {
    let items: Vec<String> = items.into_iter().map(quoted).collect();
    format!("[{}]", items.join(", "))
}

fn quoted(text: impl Display) -> String {
    printable(&format!("\"{text}\""))
}

fn or_none<T: Display>(value: Option<T>) -> String {
    value.map_or_else(|| "none".to_owned(), |value| value.to_string())
}
