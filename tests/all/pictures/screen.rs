//! The real binary on a terminal of its own, and what stands there afterwards as SVG.

use std::fs;
use std::io::Read;
use std::os::fd::OwnedFd;
use std::path::{Path, PathBuf};
use std::process::Stdio;

use anstyle_svg::{Palette, Term};
use nix::pty::{OpenptyResult, Winsize, openpty};

use crate::scratch;

/// A page on GitHub has room for that many without making the letters smaller.
const COLUMNS: u16 = 100;

/// Dark, whatever the page is.
const FOREGROUND: u32 = 0xd6_dbe1;
const BACKGROUND: u32 = 0x1b_1f26;

/// The sixteen colours, light enough for that background.
const COLORS: [u32; 16] = [
    0x3b_4048, 0xff_7b72, 0x7e_e787, 0xf2_cc60, 0x79_c0ff, 0xd2_a8ff, 0x76_e3ea,
    0xd6_dbe1, // plain
    0x8b_949e, 0xff_a198, 0xa5_f0ab, 0xf8_e08e, 0xa5_d6ff, 0xe2_c5ff, 0xb3_f0f5,
    0xff_ffff, // bright
];

/// What is dimmed is read as well.
const DIMMED: &str = "opacity: 0.4;";

/// Commands in a folder, one after the other, with what they print.
pub(super) struct Screen {
    guide: String,
    folder: PathBuf,
    ansi: String,
}

impl Screen {
    /// For a guide that has the commands as text, to copy them.
    pub(super) fn new(guide: &str, folder: &Path) -> Self {
        let guide =
            fs::read_to_string(scratch::project("docs").join(guide).with_extension("md")).unwrap();
        Self {
            guide,
            folder: folder.to_owned(),
            ansi: String::new(),
        }
    }

    /// Runs `mhlint …`, which must end with `code`.
    #[track_caller]
    pub(super) fn run(&mut self, line: &str, code: i32) {
        let words: Vec<&str> = line.split_whitespace().collect();
        assert_eq!(words[0], "mhlint", "only mhlint runs here: {line}");
        self.shows(line);
        let (printed, found) = on_a_terminal(&self.folder, &words[1..]);
        assert_eq!(found, Some(code), "{line}: {printed}");
        let gap = if self.ansi.is_empty() { "" } else { "\n" };
        let prompt = format!("{gap}\u{1b}[32m$\u{1b}[0m \u{1b}[1m{line}\u{1b}[0m\n");
        self.ansi.push_str(&prompt);
        self.ansi.push_str(&printed);
        let widest = printed
            .lines()
            .map(|line| plain(line).chars().count())
            .max();
        assert!(
            widest <= Some(usize::from(COLUMNS)),
            "a terminal would break a line of {widest:?}: {printed}"
        );
    }

    /// The guide has this line as text.
    #[track_caller]
    pub(super) fn shows(&self, line: &str) {
        assert!(
            self.guide.contains(&format!("    {line}")),
            "the guide lacks the line `{line}`"
        );
    }

    /// A picture of it.
    pub(super) fn svg(&self) -> String {
        let term = Term::new().palette(Palette(COLORS.map(|color| rgb(color).into())));
        let term = term
            .fg_color(rgb(FOREGROUND).into())
            .bg_color(rgb(BACKGROUND).into());
        let svg = term.render_svg(self.ansi.trim_end_matches('\n'));
        let svg = svg.replace(DIMMED, "opacity: 0.7;");
        // Each line ends with a line break inside its element, for those who copy from it; no blank
        // stands before it.
        svg.lines()
            .map(str::trim_end)
            .fold(String::new(), |text, line| text + line + "\n")
    }
}

fn rgb(color: u32) -> (u8, u8, u8) {
    let [_, red, green, blue] = color.to_be_bytes();
    (red, green, blue)
}

/// A line without its colours.
fn plain(line: &str) -> String {
    line.split('\u{1b}')
        .map(|piece| {
            piece
                .split_once('m')
                .filter(|_| piece.starts_with('['))
                .map_or(piece, |(_, text)| text)
        })
        .collect()
}

/// What the binary prints in `folder` where standard output is a terminal with colour and UTF-8.
/// Standard error is none, so that no progress is drawn if the machine is slow; its lines come
/// last, but a baseline is written before the report.
fn on_a_terminal(folder: &Path, args: &[&str]) -> (String, Option<i32>) {
    let size = Winsize {
        ws_row: 50,
        ws_col: COLUMNS,
        ws_xpixel: 0,
        ws_ypixel: 0,
    };
    let OpenptyResult { master, slave } = openpty(&size, None).unwrap();
    let mut command = scratch::command(folder, args);
    command
        .env("TERM", "xterm-256color")
        .env("LC_ALL", "C.UTF-8")
        .env_remove("FORCE_COLOR");
    let mut child = command
        .stdout(Stdio::from(slave))
        .stderr(Stdio::piped())
        .spawn()
        .unwrap();
    // It holds the terminal as well, which ends when nobody does.
    drop(command);
    let mut printed = read(master);
    let mut errors = String::new();
    child
        .stderr
        .take()
        .unwrap()
        .read_to_string(&mut errors)
        .unwrap();
    if args.contains(&"--write-baseline") {
        printed.insert_str(0, &errors);
    } else {
        printed.push_str(&errors);
    }
    (printed, child.wait().unwrap().code())
}

/// Everything until the terminal is closed, which Linux reports as an error.
fn read(master: OwnedFd) -> String {
    let mut bytes = Vec::new();
    let _ = fs::File::from(master).read_to_end(&mut bytes);
    String::from_utf8(bytes).unwrap().replace("\r\n", "\n")
}
