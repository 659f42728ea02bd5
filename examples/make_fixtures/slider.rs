//! Detail sliders: one table row gives the targets, the icon and the entry of `modelling.json`.
//!
//! A sided row gives a left and a right slider that are mirror images; `{side}` in its texts
//! becomes `l`/`r` in file names and `left`/`right` in groups.

use serde_json::{Map, Value, json};

use crate::icon;
use crate::mesh::{Mesh, Point};
use crate::morph::{Side, target_text};
use crate::tree::Tree;

pub(crate) struct Detail {
    /// Text shown, and key in `modelling.json`, where sided rows get `L-` or `R-` before it.
    pub(crate) label: &'static str,
    pub(crate) group: &'static str,
    /// Path of the targets below the target folder, without the ending of a pair.
    pub(crate) stem: &'static str,
    /// Endings of the negative and the positive target; `None` for a slider with one side and a
    /// single target.
    pub(crate) ends: Option<(&'static str, &'static str)>,
    pub(crate) sided: bool,
    pub(crate) amount: f64,
    pub(crate) field: fn(Point, f64) -> Point,
}

/// Where the files of a base go.
pub(crate) struct Place<'a> {
    pub(crate) base: &'a str,
    /// Target folder of the base, from the root of the tree.
    pub(crate) folder: &'a str,
}

/// Adds targets and icons, returns the entries.
pub(crate) fn add_details(
    tree: &mut Tree,
    mesh: &Mesh,
    place: &Place,
    details: &[Detail],
) -> Map<String, Value> {
    let mut entries = Map::new();
    for detail in details {
        let sides: &[Side] = if detail.sided {
            &[Side::Right, Side::Left]
        } else {
            &[Side::Both]
        };
        for &side in sides {
            add_targets(tree, mesh, place, detail, side);
            let (key, value) = entry(detail, side);
            add_icon(tree, place, value["icon"].as_str().unwrap_or_default());
            entries.insert(key, value);
        }
    }
    entries
}

/// `icon` is the file name with suffix; its picture depends on it and the base only.
pub(crate) fn add_icon(tree: &mut Tree, place: &Place, icon: &str) {
    let picture = icon::png(&format!("{}/{icon}", place.base), 32, 16);
    tree.add(format!("{}/icons/{icon}", place.folder), picture);
}

fn add_targets(tree: &mut Tree, mesh: &Mesh, place: &Place, detail: &Detail, side: Side) {
    let (incr, decr) = files(detail, side);
    for (file, sign) in [(Some(incr), 1.0), (decr, -1.0)] {
        if let Some(file) = file {
            let field = |point: Point| (detail.field)(point, sign * detail.amount);
            let text = target_text(mesh, place.base, side, &field);
            tree.add(format!("{}/{file}.target", place.folder), text);
        }
    }
}

fn entry(detail: &Detail, side: Side) -> (String, Value) {
    let (incr, decr) = files(detail, side);
    let (key, word) = match side {
        Side::Both => (detail.label.to_owned(), ""),
        Side::Left => (format!("L-{}", detail.label), "left"),
        Side::Right => (format!("R-{}", detail.label), "right"),
    };
    let icon = incr.split_once('/').map_or(incr.as_str(), |(_, file)| file);
    let icon = detail.ends.map_or(icon, |(_, high)| {
        icon.strip_suffix(high)
            .unwrap_or(icon)
            .trim_end_matches('-')
    });
    // Without `name`, the key is shown.
    let mut value = if detail.sided {
        json!({ "name": detail.label })
    } else {
        json!({})
    };
    value["group"] = json!(detail.group.replace("{side}", word));
    value["icon"] = json!(format!("{icon}.png"));
    if let Some(decr) = decr {
        value["decr"] = json!(decr);
    }
    value["incr"] = json!(incr);
    match side {
        Side::Both => {}
        // `rsym` stands in the entry of the left side and names the right one's pattern
        // (`docs/loaders/makehuman2/sliders.md#keys-of-a-slider`).
        Side::Left => value["rsym"] = json!(pattern(detail, Side::Right)),
        Side::Right => value["lsym"] = json!(pattern(detail, Side::Left)),
    }
    (key, value)
}

/// The name under which the program knows the slider
/// (`docs/loaders/makehuman2/sliders.md#pattern`).
pub(crate) fn pattern(detail: &Detail, side: Side) -> String {
    match (files(detail, side), detail.ends) {
        ((_, Some(decr)), Some((_, high))) => format!("{decr}|{high}"),
        ((incr, _), _) => incr,
    }
}

/// Paths of the positive and the negative target, without suffix.
fn files(detail: &Detail, side: Side) -> (String, Option<String>) {
    let stem = detail
        .stem
        .replace("{side}", if side == Side::Right { "r" } else { "l" });
    match detail.ends {
        Some((low, high)) => (format!("{stem}-{high}"), Some(format!("{stem}-{low}"))),
        None => (stem, None),
    }
}
