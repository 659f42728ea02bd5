//! Who imports whom: paths of the code followed to the file that declares what they name, through
//! lists in braces, `super::` and re-exports.

use std::collections::{BTreeMap, BTreeSet};

use super::Source;

/// A path of names from the root of the crate.
type Names = Vec<String>;

/// The files of the crate as modules.
pub(crate) struct Crate<'s> {
    /// Path of each module and its file.
    modules: BTreeMap<Names, &'s Source>,
    /// What a module has from elsewhere: name to the path behind it.
    aliases: BTreeMap<(Names, String), Names>,
}

impl<'s> Crate<'s> {
    pub(crate) fn of(sources: &'s [Source]) -> Self {
        let modules = sources
            .iter()
            .map(|source| (module_of(&source.path), source))
            .collect();
        let mut all = Self {
            modules,
            aliases: BTreeMap::new(),
        };
        for source in sources {
            let module = module_of(&source.path);
            for (path, name) in used(&source.code()) {
                if let Some(path) = all.absolute(&module, &path) {
                    all.aliases.insert((module.clone(), name), path);
                }
            }
        }
        all
    }

    /// Files that a file imports from: those that it names, and those that declare what it gets
    /// through them.
    pub(crate) fn imports(&self, source: &Source) -> BTreeSet<&'s str> {
        let module = module_of(&source.path);
        let code = source.code();
        let paths = written(&code)
            .into_iter()
            .chain(used(&code).into_iter().map(|(path, _)| path));
        let mut found = BTreeSet::new();
        for path in paths.filter_map(|path| self.absolute(&module, &path)) {
            self.follow(&path, 0, &mut found);
        }
        found.remove(source.path.as_str());
        // The root of the crate is a table of contents: what is imported through it counts where it
        // is declared.
        found.remove("lib.rs");
        found
    }

    /// A path as written in a module, from the root; none for those of other crates.
    fn absolute(&self, module: &[String], path: &[String]) -> Option<Names> {
        let first = path.first()?.as_str();
        let above = path.iter().take_while(|name| *name == "super").count();
        let (start, rest): (&[String], &[String]) = match first {
            "crate" => (&[], &path[1..]),
            "self" => (module, &path[1..]),
            "super" => (
                module.get(..module.len().checked_sub(above)?)?,
                &path[above..],
            ),
            _ => (module, path),
        };
        let whole: Names = start.iter().chain(rest).cloned().collect();
        let is_ours = matches!(first, "crate" | "self" | "super");
        let child = [module, &path[..1]].concat();
        (is_ours || self.modules.contains_key(&child)).then_some(whole)
    }

    /// Notes the file of the last module on a path, and of what stands behind a name that it has
    /// from elsewhere.
    fn follow(&self, path: &[String], depth: usize, found: &mut BTreeSet<&'s str>) {
        let fits = (0..=path.len())
            .rev()
            .find_map(|length| Some((length, self.modules.get(&path[..length])?)));
        let Some((length, source)) = fits.filter(|_| depth < 8) else {
            return;
        };
        let alias = path
            .get(length)
            .and_then(|name| self.aliases.get(&(path[..length].to_vec(), name.clone())));
        found.insert(source.path.as_str());
        if let Some(behind) = alias {
            let whole: Names = behind.iter().chain(&path[length + 1..]).cloned().collect();
            self.follow(&whole, depth + 1, found);
        }
    }
}

/// `a/b.rs` and `a/b/mod.rs` are `a::b`.
fn module_of(path: &str) -> Names {
    let parts = path
        .trim_end_matches(".rs")
        .split('/')
        .filter(|part| !matches!(*part, "mod" | "lib" | "main"));
    parts.map(str::to_owned).collect()
}

/// The `use` declarations: path and the name that it gets.
pub(crate) fn used(code: &str) -> Vec<(Names, String)> {
    let mut found = Vec::new();
    for (at, _) in code.match_indices("use ") {
        let line = code[..at].rsplit('\n').next().unwrap_or_default().trim();
        if line.is_empty() || line.starts_with("pub") && !line.contains(' ') {
            let tree = code[at + 4..].split(';').next().unwrap_or_default();
            flatten(&[], tree, &mut found);
        }
    }
    found
}

/// Paths that begin with `crate::` or `super::`, anywhere.
fn written(code: &str) -> Vec<Names> {
    let mut found = Vec::new();
    for (at, _) in code
        .match_indices("crate::")
        .chain(code.match_indices("super::"))
    {
        let before = code[..at].chars().next_back();
        if !before.is_some_and(|c| is_name(c) || c == ':') {
            flatten(&[], tree_at(&code[at..]), &mut found);
        }
    }
    found.into_iter().map(|(path, _)| path).collect()
}

/// The path with its list in braces, if it ends in one.
fn tree_at(code: &str) -> &str {
    let plain = code
        .find(|c: char| !is_name(c) && c != ':')
        .unwrap_or(code.len());
    let mut depth = 0;
    if !code[plain..].starts_with('{') || !code[..plain].ends_with("::") {
        return code[..plain].trim_end_matches(':');
    }
    let end = code[plain..].find(|c| {
        depth += i32::from(c == '{') - i32::from(c == '}');
        depth == 0
    });
    &code[..end.map_or(code.len(), |end| plain + end + 1)]
}

/// The paths of a `use` tree.
fn flatten(before: &[String], tree: &str, found: &mut Vec<(Names, String)>) {
    let tree = tree.trim();
    if let Some((path, list)) = tree.split_once('{') {
        let before = [before, &names(path)].concat();
        let list = list.rsplit_once('}').map_or(list, |(list, _)| list);
        split(list)
            .into_iter()
            .filter(|part| !part.trim().is_empty())
            .for_each(|part| flatten(&before, part, found));
        return;
    }
    let (path, name) = tree
        .split_once(" as ")
        .map_or((tree, None), |(path, name)| (path, Some(name.trim())));
    let mut path = [before, &names(path)].concat();
    if path.len() > 1 && path.last().is_some_and(|name| name == "self") {
        path.pop();
    }
    let name = name.map_or_else(|| path.last().cloned().unwrap_or_default(), str::to_owned);
    found.push((path, name));
}

fn names(path: &str) -> Names {
    path.split("::")
        .map(str::trim)
        .filter(|name| !name.is_empty())
        .map(str::to_owned)
        .collect()
}

/// The parts between commas outside of braces.
fn split(list: &str) -> Vec<&str> {
    let mut depth = 0;
    let outside = |c: char| {
        depth += i32::from(c == '{') - i32::from(c == '}');
        c == ',' && depth == 0
    };
    list.split(outside).collect()
}

fn is_name(c: char) -> bool {
    c.is_alphanumeric() || c == '_'
}

/// Groups of nodes that reach each other, larger than one.
pub(crate) fn circles(edges: &BTreeMap<String, BTreeSet<String>>) -> Vec<Vec<&str>> {
    let reach = |from: &str| {
        let mut seen: BTreeSet<&str> = BTreeSet::new();
        let mut open: Vec<&str> = edges
            .get(from)
            .into_iter()
            .flatten()
            .map(String::as_str)
            .collect();
        while let Some(node) = open.pop() {
            if seen.insert(node) {
                open.extend(edges.get(node).into_iter().flatten().map(String::as_str));
            }
        }
        seen
    };
    let reached: BTreeMap<&str, BTreeSet<&str>> = edges
        .keys()
        .map(|node| (node.as_str(), reach(node)))
        .collect();
    let group = |node: &&str| -> Vec<&str> {
        let back = |other: &&&str| reached.get(**other).is_some_and(|of| of.contains(*node));
        reached
            .get(*node)
            .into_iter()
            .flatten()
            .filter(back)
            .copied()
            .collect()
    };
    let groups: BTreeSet<Vec<&str>> = reached
        .keys()
        .map(group)
        .filter(|group| group.len() > 1)
        .collect();
    groups.into_iter().collect()
}
