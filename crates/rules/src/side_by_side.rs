//! What is known of packs that lie side by side: whoever has several in one library has their
//! assets in one list.

use std::collections::BTreeMap;

use mhlint_diag::Application;
use mhlint_repo::FileFacts;

/// By what each application knows the assets of packs: those with one key in the order of the
/// packs.
#[derive(Default)]
pub struct SideBySide(BTreeMap<(Application, String), Alike>);

/// The assets with one key.
#[derive(Default)]
struct Alike {
    all: Vec<Listed>,
    /// Where each pack begins among them.
    packs: BTreeMap<String, usize>,
    /// The first asset at each path.
    by_path: BTreeMap<String, usize>,
    /// The first that lies at another place in its pack than the first of all.
    elsewhere: Option<usize>,
}

impl Alike {
    fn add(&mut self, one: Listed) {
        let place = self.all.len();
        self.packs.entry(one.pack.clone()).or_insert(place);
        self.by_path.entry(one.path.clone()).or_insert(place);
        let is_elsewhere = self.all.first().is_some_and(|first| first.rel != one.rel);
        if self.elsewhere.is_none() && is_elsewhere {
            self.elsewhere = Some(place);
        }
        self.all.push(one);
    }

    fn earlier(&self, path: &str) -> Option<&Listed> {
        let own = self.all.get(*self.by_path.get(path)?)?;
        let earlier = self.all.get(..*self.packs.get(&own.pack)?)?;
        // Where the first lies at the same place, the first elsewhere does not.
        let first = earlier.first().filter(|one| one.rel != own.rel);
        first.or_else(|| earlier.get(self.elsewhere?))
    }
}

/// An asset of a pack.
pub(crate) struct Listed {
    pub(crate) pack: String,
    pub(crate) path: String,
    pub(crate) rel: String,
    pub(crate) content: Option<u64>,
}

/// An asset with what tells it from others in the list.
pub(crate) type Identity<'a> = (String, &'a FileFacts);

impl SideBySide {
    /// Adds the assets of a pack.
    pub(crate) fn add(&mut self, application: Application, pack: &str, assets: Vec<Identity<'_>>) {
        for (key, file) in assets {
            let listed = Listed {
                pack: pack.to_owned(),
                path: file.path.clone(),
                rel: file.rel.clone(),
                content: file.content_hash,
            };
            self.0.entry((application, key)).or_default().add(listed);
        }
    }

    /// The first asset of an earlier pack with a key. What lies at the same place is another state
    /// of the same asset.
    pub(crate) fn earlier(
        &self,
        application: Application,
        key: &str,
        file: &FileFacts,
    ) -> Option<&Listed> {
        let alike = self.0.get(&(application, key.to_owned()))?;
        alike.earlier(&file.path)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_first_that_lies_elsewhere_in_an_earlier_pack_is_the_earlier_one() {
        let mut alike = Alike::default();
        for (pack, rel) in [("a", "x"), ("a", "y"), ("b", "x"), ("c", "y"), ("c", "z")] {
            alike.add(Listed {
                pack: pack.to_owned(),
                path: format!("{pack}/{rel}"),
                rel: rel.to_owned(),
                content: None,
            });
        }
        let earlier = |path: &str| alike.earlier(path).map(|one| one.path.as_str());
        let found = ["a/x", "a/y", "b/x", "c/y", "c/z", "d/x"].map(earlier);
        assert_eq!(
            found,
            [None, None, Some("a/y"), Some("a/x"), Some("a/x"), None]
        );
    }
}
