//! Finds data roots by their shape (`docs/architecture.md#layouts-and-formats`).

use std::cell::RefCell;
use std::collections::{BTreeMap, BTreeSet};

use super::evidence::evidence;
use super::layout::Sign;
use super::{Layout, Listing, contest};
use mhlint_diag::Application;
use mhlint_source::{depth, folder_and_name, folders_above, is_below};

/// A folder that looks like the data folder of an application.
#[derive(Debug, Clone, PartialEq, Eq, PartialOrd, Ord)]
pub struct DataRoot {
    /// Path from the top of the tree; empty for the top itself.
    pub path: String,
    /// The application.
    pub application: Application,
}

/// The applications whose data a run is expected to contain.
#[derive(Debug, Clone, Copy, Default)]
pub struct Meant<'a> {
    /// Applications that the user named, or gave data of with `--system`.
    pub asked: &'a [Application],
    /// Applications that the user named.
    pub named: &'a [Application],
    /// Applications that have data in another listing of the run.
    pub at_hand: &'a [Application],
}

/// All data roots in a listing, sorted by path.
pub fn find_roots(listing: &Listing<'_>, meant: Meant<'_>) -> Vec<DataRoot> {
    let Signs {
        mut signs,
        confirmed,
    } = Signs::in_listing(listing);
    let shared = contest::settle(&mut signs, listing, meant);
    let mut search = Search::new(listing, meant, signs, confirmed);
    search.leave_out_unclaimed();
    leave_out_misplaced(&mut search.signs, listing);
    search.strong = Strong::of(&search.signs);
    let mut roots = search.outermost();
    Application::ALL
        .into_iter()
        .for_each(|one| search.share(one, &mut roots));
    // A users' folder that certainly belongs to two applications is a root of both, or of the one
    // whose data are at hand.
    let found: BTreeSet<&str> = roots.iter().map(|root| root.path.as_str()).collect();
    let shared = shared
        .into_iter()
        .filter(|root| found.contains(root.path.as_str()));
    let (left, shared): (BTreeSet<DataRoot>, BTreeSet<DataRoot>) =
        shared.partition(|root| search.is_left_to_partner(root));
    roots.retain(|root| !left.contains(root));
    roots.extend(shared);
    roots.sort();
    roots.dedup();
    roots
}

/// The state of the search for data roots.
struct Search<'s> {
    listing: &'s Listing<'s>,
    meant: Meant<'s>,
    /// The roots that are left, each with the best sign for it.
    signs: BTreeMap<DataRoot, Sign>,
    strong: Strong,
    /// The roots that a file beside them confirms.
    confirmed: BTreeSet<DataRoot>,
    /// The applications that may claim a folder without further evidence.
    company: Vec<Application>,
    told: Told,
    /// For the roots that were looked at for this: whether the files beside a root make certain
    /// whose it is.
    are_data: RefCell<BTreeMap<DataRoot, bool>>,
}

impl<'s> Search<'s> {
    fn new(
        listing: &'s Listing<'s>,
        meant: Meant<'s>,
        signs: BTreeMap<DataRoot, Sign>,
        confirmed: BTreeSet<DataRoot>,
    ) -> Self {
        // An application that shares the users' folders of another application (MPFB those of
        // MakeHuman 1) does not claim such a folder by itself. It claims the folder if the user
        // asked for the application, if it has a data root of its own, or if files beside the
        // folder are such as no other application has.
        let strong = Strong::of(&signs);
        let is_at_hand = |application: Application| {
            meant.asked.contains(&application) || strong.has_data(meant, application)
        };
        let claims =
            |one: &Application| Layout::of(*one).shares_roots_of.is_none() || is_at_hand(*one);
        let company = Application::ALL.into_iter().filter(claims).collect();
        let told = Told::of(&signs, &is_at_hand);
        Self {
            listing,
            meant,
            signs,
            strong,
            confirmed,
            company,
            told,
            are_data: RefCell::default(),
        }
    }

    /// Whether a folder of users that two applications certainly share is left to the other one:
    /// its data are at hand, and nobody asked for this one or has its data.
    fn is_left_to_partner(&self, root: &DataRoot) -> bool {
        let has_data = |one| self.strong.has_data(self.meant, one);
        let is_partner = |one: &Application| contest::share_users(*one, root.application);
        let mut partners = Application::ALL.into_iter().filter(is_partner);
        let is_meant = self.meant.asked.contains(&root.application) || has_data(root.application);
        !is_meant && partners.any(has_data)
    }

    /// Removes roots that their application may not claim. If a file beside a root confirms that
    /// the root belongs to another application, it is removed as well, unless that application
    /// shares the users' folders of this one.
    fn leave_out_unclaimed(&mut self) {
        let Self {
            signs,
            confirmed,
            company,
            told,
            ..
        } = self;
        let is_confirmed_of_other = |root: &DataRoot| {
            let is_foreign = |other: &Application| {
                *other != root.application
                    && Layout::of(*other).shares_roots_of != Some(root.application)
            };
            let mut foreign = Application::ALL.into_iter().filter(is_foreign);
            foreign.any(|other| confirmed.contains(&root.of(other)))
        };
        signs.retain(|root, sign| {
            let is_own = company.contains(&root.application)
                || confirmed.contains(root)
                || told.alone.contains(root);
            *sign == Sign::Strong || is_own && !is_confirmed_of_other(root)
        });
    }

    /// The roots that are not inside or around a better root.
    fn outermost(&self) -> Vec<DataRoot> {
        let mut roots = self.of_sign(Sign::Strong, &[]);
        // These two signs are equally good: a root with the one does not exclude a root with the
        // other.
        let [of_users, weak] = [Sign::OfUser, Sign::Weak].map(|sign| self.of_sign(sign, &roots));
        roots.extend(of_users.into_iter().chain(weak));
        roots.extend(self.of_sign(Sign::Faint, &roots));
        roots
    }

    /// The roots with this sign that are not inside or around one of the `better` roots.
    fn of_sign(&self, sign: Sign, better: &[DataRoot]) -> Vec<DataRoot> {
        let own = self
            .signs
            .iter()
            .filter(|(_, own)| **own == sign)
            .map(|(root, _)| root);
        let better: BTreeSet<&DataRoot> = better.iter().collect();
        let is_near = |root: &DataRoot| {
            let above = folders_above(&root.path).flat_map(|path| roots_at(&better, path));
            let below = roots_below(&better, &root.path);
            above.chain(below).any(|other| self.is_near(root, other))
        };
        own.filter(|root| !is_near(root)).cloned().collect()
    }

    /// Whether a root does not stand beside a better one, which is inside or around it.
    fn is_near(&self, root: &DataRoot, better: &DataRoot) -> bool {
        let are_two =
            || is_beside_own(root, better, &self.strong) || self.told.are_apart(root, better);
        !are_two() && !self.is_stray(root, better)
    }

    /// Whether `other` is only a stray folder for `root`: it belongs to another application, and
    /// the files beside `root` make certain that `root` is a data root.
    fn is_stray(&self, root: &DataRoot, other: &DataRoot) -> bool {
        let look = || evidence(self.listing, &root.path, root.application).is_certain_beside;
        let is_certain = || {
            *self
                .are_data
                .borrow_mut()
                .entry(root.clone())
                .or_insert_with(look)
        };
        root.application != other.application && has_beside(root.application) && is_certain()
    }

    /// Adds the users' folders that an application shares with another application: every root of
    /// the other application that is a user's folder becomes a root of this application, too.
    fn share(&self, application: Application, roots: &mut Vec<DataRoot>) {
        let Some(other) = Layout::of(application).shares_roots_of else {
            return;
        };
        let own = |root: &DataRoot| DataRoot {
            path: root.path.clone(),
            application,
        };
        let is_asked = |one: Application| self.meant.asked.contains(&one);
        // A faint sign, which several applications have, means a user's folder. If the user asked
        // for the application, every sign does but a strong one, which means data of the program.
        let is_users =
            |sign: Sign| sign == Sign::Faint || sign < Sign::Strong && is_asked(application);
        let is_shared = |root: &&DataRoot| {
            let is_meant =
                self.company.contains(&application) || self.told.shared.contains(&own(root));
            let sign = self.signs.get(*root).copied();
            is_meant && root.application == other && sign.is_some_and(is_users)
        };
        let shared: Vec<DataRoot> = roots.iter().filter(is_shared).map(own).collect();
        // If this application has data, and the other application neither has data nor was asked
        // for, a root that files beside it confirm for this application does not belong to the
        // other application.
        let has_data = |one| self.strong.has_data(self.meant, one);
        if has_data(application) && !has_data(other) && !is_asked(other) {
            let is_other = |root: &DataRoot| {
                root.application == other && self.signs.get(root) == Some(&Sign::Faint)
            };
            roots.retain(|root| !is_other(root) || !self.confirmed.contains(&own(root)));
        }
        roots.extend(shared);
    }
}

/// Where the data are that are certainly those of an application.
#[derive(Default)]
struct Strong {
    /// Their paths and those of the folders above them.
    paths: BTreeSet<(Application, String)>,
}

impl Strong {
    fn of(signs: &BTreeMap<DataRoot, Sign>) -> Self {
        let strong = signs.iter().filter(|(_, sign)| **sign == Sign::Strong);
        let paths = strong.flat_map(|(root, _)| {
            let above = root.path.match_indices('/').map(|(at, _)| at);
            let ends = above.chain([root.path.len()]);
            ends.filter_map(|end| Some((root.application, root.path.get(..end)?.to_owned())))
        });
        Self {
            paths: paths.collect(),
        }
    }

    /// Whether an application has such data, in this listing or in another one.
    fn has_data(&self, meant: Meant<'_>, application: Application) -> bool {
        let mut from = self.paths.range((application, String::new())..);
        meant.at_hand.contains(&application)
            || from.next().is_some_and(|(other, _)| *other == application)
    }
}

impl DataRoot {
    /// The same folder as a root of another application.
    fn of(&self, application: Application) -> Self {
        Self {
            path: self.path.clone(),
            application,
        }
    }
}

/// Those of the roots that are at a path.
fn roots_at<'r>(
    roots: &BTreeSet<&'r DataRoot>,
    path: &str,
) -> impl Iterator<Item = &'r DataRoot> + use<'r> {
    let at = |application| DataRoot {
        path: path.to_owned(),
        application,
    };
    let found = Application::ALL.map(|application| roots.get(&at(application)).copied());
    found.into_iter().flatten()
}

/// Those of the roots that lie below a folder.
fn roots_below<'s, 'r>(
    roots: &'s BTreeSet<&'r DataRoot>,
    folder: &str,
) -> impl Iterator<Item = &'r DataRoot> + use<'s, 'r> {
    let start = if folder.is_empty() {
        String::new()
    } else {
        format!("{folder}/")
    };
    let first = DataRoot {
        path: start.clone(),
        application: Application::ALL[0],
    };
    let from = roots.range::<DataRoot, _>(&first..).copied();
    from.take_while(move |root| root.path.starts_with(&start))
}

/// Removes `data` folders that are no data roots, and roots that are none because a folder `data`
/// in them is the data root.
fn leave_out_misplaced(signs: &mut BTreeMap<DataRoot, Sign>, listing: &Listing<'_>) {
    // Files in the wrong place in a data root may suggest a folder `data` in that root. There is no
    // such folder.
    let is_supposed = |root: &DataRoot| {
        let above = root
            .path
            .strip_suffix("data")
            .map(|above| above.trim_end_matches('/'));
        let is_root = |path: &str| {
            let at = |application| DataRoot {
                path: path.to_owned(),
                application,
            };
            let mut all = Application::ALL.into_iter().map(at);
            all.any(|other| signs.contains_key(&other))
        };
        !listing.has_folder(&root.path) && above.is_some_and(is_root)
    };
    let supposed: BTreeSet<DataRoot> = signs
        .keys()
        .filter(|root| is_supposed(root))
        .cloned()
        .collect();
    signs.retain(|root, _| !supposed.contains(root));
    // A folder `data/data` is a copy that was put into the wrong folder.
    let astray = |root: &DataRoot| {
        let above = root
            .path
            .strip_suffix("/data")
            .filter(|above| is_data(above));
        above.is_some_and(|above| {
            signs.contains_key(&DataRoot {
                path: above.to_owned(),
                ..root.clone()
            })
        })
    };
    let astray: BTreeSet<DataRoot> = signs
        .keys()
        .filter(|root| has_beside(root.application) && astray(root))
        .cloned()
        .collect();
    signs.retain(|root, _| !astray.contains(root));
    // Files beside a folder `data` that is a root do not make a root of the folder above it.
    let is_above_data = |root: &DataRoot| {
        let below = data_in(&root.path, root.application);
        has_beside(root.application) && signs.contains_key(&below)
    };
    let above_data: BTreeSet<DataRoot> = signs
        .keys()
        .filter(|root| is_above_data(root))
        .cloned()
        .collect();
    signs.retain(|root, _| !above_data.contains(root));
}

/// Whether a file belongs to a package of JavaScript, which a project may contain.
fn is_of_package(file: &str) -> bool {
    file.split('/').any(|part| part == "node_modules")
}

/// The signs of data roots in a listing.
#[derive(Default)]
struct Signs {
    /// The best sign of each root.
    signs: BTreeMap<DataRoot, Sign>,
    /// The roots that a file beside them confirms.
    confirmed: BTreeSet<DataRoot>,
}

impl Signs {
    fn in_listing(listing: &Listing<'_>) -> Self {
        let mut found = Self::default();
        for file in listing.files().filter(|file| !is_of_package(file)) {
            for application in Application::ALL {
                found.confirmed.extend(beside_of(file, application));
                let layout = Layout::of(application);
                if let Some((path, sign)) = layout.sign(file, listing) {
                    found.add(
                        DataRoot {
                            path: path.to_owned(),
                            application,
                        },
                        sign,
                    );
                }
                // A user's folder may contain nothing but the files that lie beside its `data`.
                let above = layout
                    .above_data(file)
                    .map(|above| data_in(above, application));
                if let Some(data) = above {
                    // This holds even without a folder `data`, if the content of the file tells the
                    // application.
                    if listing.has_folder(&data.path) {
                        found.add(data, Sign::Faint);
                    } else if (layout.tells_without_data)(listing, file) {
                        found.add(data, Sign::OfUser);
                    }
                }
            }
        }
        found
    }

    fn add(&mut self, root: DataRoot, sign: Sign) {
        let known = self.signs.entry(root).or_insert(sign);
        *known = sign.max(*known);
    }
}

/// Users' folders of an application that shares those of another application, recognised by the
/// files in them although neither application has data in this run.
#[derive(Default)]
struct Told {
    /// Folders with files that only users of the application have: they do not belong to the other
    /// application.
    alone: BTreeSet<DataRoot>,
    /// Folders with assets that both applications have, and with files that suggest this
    /// application rather than the other: they belong to both.
    shared: BTreeSet<DataRoot>,
}

impl Told {
    fn of(signs: &BTreeMap<DataRoot, Sign>, is_at_hand: &dyn Fn(Application) -> bool) -> Self {
        let mut told = Self::default();
        for (root, sign) in signs
            .iter()
            .filter(|(_, sign)| matches!(sign, Sign::Weak | Sign::OfUser))
        {
            let Some(partner) = Layout::of(root.application).shares_roots_of else {
                continue;
            };
            let sign_of = |application| {
                signs
                    .get(&DataRoot {
                        path: root.path.clone(),
                        application,
                    })
                    .copied()
            };
            let mut third = Application::ALL
                .into_iter()
                .filter(|one| *one != root.application && *one != partner);
            let mut is_of_third = || third.any(|other| sign_of(other).is_some());
            // In `custom/` of the other application users may give folders any names.
            let is_in_custom = || root.path.split('/').any(|name| name == "custom");
            if is_at_hand(root.application)
                || is_at_hand(partner)
                || is_in_custom()
                || is_of_third()
            {
                continue;
            }
            match (sign, sign_of(partner)) {
                (Sign::OfUser, None | Some(Sign::Faint)) => {
                    told.alone.insert(root.clone());
                }
                (_, Some(Sign::Faint)) => {
                    told.shared.insert(root.clone());
                }
                _ => {}
            }
        }
        told
    }

    /// Whether a root and a better one are two separate roots, although one lies inside the other.
    /// They are if the better root has files that only its application has, or if the root is one
    /// of `alone` or `shared` and the better one belongs to a third application.
    fn are_apart(&self, root: &DataRoot, better: &DataRoot) -> bool {
        let is_apart = |application: Application| {
            let told = root.of(application);
            let is_third = better.application != application
                && Layout::of(application).shares_roots_of != Some(better.application);
            is_third && (self.alone.contains(&told) || self.shared.contains(&told))
        };
        root.path != better.path
            && (self.alone.contains(better) || Application::ALL.into_iter().any(is_apart))
    }
}

/// Whether the application has files beside a folder called `data` that belong to that folder.
fn has_beside(application: Application) -> bool {
    !Layout::of(application).beside.is_empty()
}

fn is_data(path: &str) -> bool {
    path.rsplit('/').next() == Some("data")
}

/// The data root that a file lies beside, if the name of the file shows that it belongs to the
/// application.
fn beside_of(file: &str, application: Application) -> Option<DataRoot> {
    let layout = Layout::of(application);
    let (folder, name) = file.rsplit_once('/')?;
    let (above, folder) = folder_and_name(folder);
    let is_telling = layout.beside.contains(&folder)
        && (layout.is_telling)(layout.use_of(&format!("{folder}/{name}")).kind);
    is_telling.then(|| data_in(above, application))
}

/// The folder `data` in the folder `above`, as a data root of the application.
fn data_in(above: &str, application: Application) -> DataRoot {
    let path = if above.is_empty() {
        "data".to_owned()
    } else {
        format!("{above}/data")
    };
    DataRoot { path, application }
}

/// Whether a root inside a root of another application lies near certain data of its own
/// application: both have a folder in common that is below the top of the outer root.
fn is_beside_own(root: &DataRoot, outer: &DataRoot, strong: &Strong) -> bool {
    let depth = if outer.path.is_empty() {
        0
    } else {
        depth(&outer.path)
    };
    let end = root.path.match_indices('/').map(|(at, _)| at);
    let end = end.chain([root.path.len()]).nth(depth);
    let common = end.and_then(|end| root.path.get(..end));
    let is_own = |common: &str| {
        let common = (root.application, common.to_owned());
        strong.paths.contains(&common)
    };
    outer.application != root.application
        && is_below(&root.path, &outer.path)
        && common.is_some_and(is_own)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn of<'f>(files: &[&'f str]) -> Listing<'f> {
        Listing::of(files.iter().copied(), [])
    }

    fn found(files: &[&str]) -> Vec<(String, Application)> {
        find_roots(&of(files), Meant::default())
            .into_iter()
            .map(|root| (root.path, root.application))
            .collect()
    }

    #[test]
    fn shapes_of_the_three_applications() {
        assert_eq!(
            found(&["data/base/hm08/base.json", "data/target/hm08/a/b.target"]),
            [("data".to_owned(), Application::Makehuman2)]
        );
        assert_eq!(
            found(&["base/hm08/base.obj"]),
            [(String::new(), Application::Makehuman2)]
        );
        assert_eq!(
            found(&["base/hm08/base.mhbin"]),
            [(String::new(), Application::Makehuman2)]
        );
        assert_eq!(
            found(&["x/targets/target.json", "x/mesh_metadata/a.json"]),
            [("x".to_owned(), Application::Mpfb)]
        );
        assert_eq!(
            found(&[
                "data/modifiers/modeling_modifiers.json",
                "data/3dobjs/base.obj"
            ]),
            [("data".to_owned(), Application::Makehuman1)]
        );
    }

    #[test]
    fn a_build_folder_called_target_is_no_root() {
        assert_eq!(
            found(&[
                "target/corpora/mh/data/base/hm08/base.json",
                "target/corpora/mh/data/target/hm08/x.target"
            ]),
            [("target/corpora/mh/data".to_owned(), Application::Makehuman2)]
        );
    }

    #[test]
    fn a_library_alone_is_a_faint_sign() {
        assert_eq!(
            found(&["pack/clothes/hat/hat.mhclo"]),
            [("pack".to_owned(), Application::Makehuman1)]
        );
        for path in [
            "pack/clothes/hm08/hat/hat.mhclo",
            "pack/hair/mh2bot/bob.mhclo",
            "pack/skins/hm08/tan/tan.mhmat",
        ] {
            assert_eq!(
                found(&[path]),
                [("pack".to_owned(), Application::Makehuman2)],
                "{path}"
            );
        }
        assert_eq!(found(&["pack/clothes/hm08/notes.txt"]), []);
        assert_eq!(
            found(&[
                "user/clothes/figure/hat.mhclo",
                "user/target/figure/mine/x.target"
            ]),
            [("user".to_owned(), Application::Makehuman2)]
        );
    }

    #[test]
    #[expect(clippy::too_many_lines, reason = "a table")]
    fn a_library_is_that_of_two_applications_where_the_other_one_is_at_hand() {
        let both = |path: &str| {
            [
                (path.to_owned(), Application::Makehuman1),
                (path.to_owned(), Application::Mpfb),
            ]
        };
        let library = "user/clothes/hat/hat.mhclo";
        let with_system = found(&["data/targets/target.json", library]);
        assert_eq!(
            with_system.iter().skip(1).cloned().collect::<Vec<_>>(),
            both("user")
        );
        let with_presets = found(&[
            "data/targets/target.json",
            "user/config/human.a.json",
            "user/data/clothes/a/a.mhclo",
        ]);
        assert_eq!(
            with_presets.get(1),
            Some(&("user/data".to_owned(), Application::Mpfb)),
            "{with_presets:?}"
        );
        assert_eq!(with_presets.len(), 2);
        let asked = find_roots(
            &of(&[library]),
            Meant {
                asked: &[Application::Mpfb],
                ..Meant::default()
            },
        );
        assert_eq!(
            asked
                .into_iter()
                .map(|root| (root.path, root.application))
                .collect::<Vec<_>>(),
            both("user")
        );
        // Without data of MPFB or MakeHuman 1 a folder of packs, expressions or custom targets is
        // no data root. If it has assets, too, it belongs to MakeHuman 1; it belongs to both
        // applications if MakeHuman 1 has no use for the other files.
        assert_eq!(
            found(&[
                "src/packs/mine.json",
                "src/expressions/a.json",
                "src/custom/x.target.gz"
            ]),
            []
        );
        for path in ["user/expressions/a.json", "user/custom/x.target"] {
            assert_eq!(
                found(&[library, path]),
                [("user".to_owned(), Application::Makehuman1)],
                "{path}"
            );
        }
        for path in ["user/packs/mine.json", "user/targets/a/b.target"] {
            assert_eq!(
                found(&[library, path, "other/hair/bob.mhclo"])[1..],
                both("user"),
                "{path}"
            );
        }
        for path in [
            "user/targets/custom/x.target",
            "user/targets/mine/x.target.gz",
        ] {
            for files in [&[path][..], &[path, library]] {
                assert_eq!(
                    found(files),
                    [("user".to_owned(), Application::Mpfb)],
                    "{path}"
                );
            }
            let of_asked = find_roots(
                &of(&[path, library]),
                Meant {
                    asked: &[Application::Makehuman1],
                    ..Meant::default()
                },
            );
            assert_eq!(
                of_asked
                    .into_iter()
                    .map(|root| root.application)
                    .collect::<Vec<_>>(),
                [Application::Makehuman1]
            );
            // If there are data of MakeHuman 1, a target in such a folder is in the wrong place.
            let beside = found(&["data/modifiers/a_modifiers.json", path, library]);
            assert_eq!(
                beside[1..],
                [("user".to_owned(), Application::Makehuman1)],
                "{path}"
            );
            // No such file makes a folder of MakeHuman 2 a folder of another application.
            let of_other = found(&["user/target/hm08/a/b.target", path]);
            assert_eq!(
                of_other,
                [("user".to_owned(), Application::Makehuman2)],
                "{path}"
            );
            // A root of MPFB inside a root of MakeHuman 1 is found as a root of its own.
            let around = format!("pack/{path}");
            let both = [
                ("pack".to_owned(), Application::Makehuman1),
                ("pack/user".to_owned(), Application::Mpfb),
            ];
            assert_eq!(
                found(&["pack/clothes/hat/hat.mhclo", &around]),
                both,
                "{path}"
            );
        }
        // They are roots even if data of a third application are inside.
        let third = [
            "packs/a.json",
            "hair/bob.mhclo",
            "tools/data/base/hm08/base.json",
        ];
        assert_eq!(found(&third).len(), 3, "{:?}", found(&third));
        let of_program = [
            "data/modifiers/a_modifiers.json",
            "data/packs/a.json",
            "data/targets/a/x.target.gz",
        ];
        assert_eq!(
            found(&of_program),
            [("data".to_owned(), Application::Makehuman1)]
        );
    }

    #[test]
    fn what_lies_beside_a_folder_tells_whose_it_is() {
        let files = [
            "user/config/human.ada.json",
            "user/data/custom/x.target",
            "user/data/clothes/hat/hat.mhclo",
        ];
        let of_mpfb = vec![("user/data".to_owned(), Application::Mpfb)];
        assert_eq!(
            found(&["user/config/human.ada.json", "user/data/packs/mine.json"]),
            of_mpfb
        );
        assert!(found(&files).contains(&of_mpfb[0]));
        assert_eq!(
            found(&["user/config/studio.json", "user/data/packs/mine.json"]),
            []
        );
        // Files at the top are as good as files in a folder. Files that lie above `data` by mistake
        // make no root.
        let stray = [
            "config/human.ada.json",
            "data/targets/a/b.target",
            "targets/a/b.target",
        ];
        assert_eq!(found(&stray), [("data".to_owned(), Application::Mpfb)]);
    }

    #[test]
    fn a_folder_that_went_astray_makes_no_root() {
        let config = "user/config/human.ada.json";
        let of_user = vec![("user/data".to_owned(), Application::Mpfb)];
        assert_eq!(
            found(&[
                config,
                "user/data/packs/a.json",
                "user/data/data/custom/x.target.gz"
            ]),
            of_user
        );
        assert_eq!(
            found(&[
                config,
                "user/data/packs/a.json",
                "user/data/target/mine/x.target"
            ]),
            of_user
        );
        let own = [
            "data/mesh_metadata/hm08.mirror",
            "data/target/macrodetails/macro.json",
        ];
        assert_eq!(found(&own), [("data".to_owned(), Application::Mpfb)]);
    }

    #[test]
    fn targets_alone_are_a_weak_sign() {
        assert_eq!(
            found(&["user/target/hm08/mine/x.target"]),
            [("user".to_owned(), Application::Makehuman2)]
        );
    }
}
