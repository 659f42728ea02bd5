//! What is known of packs that lie side by side: whoever has several in one library has their
//! assets in one list.

use std::collections::BTreeMap;

use mhlint_diag::Application;
use mhlint_repo::FileFacts;

/// By what each application knows the assets of packs: those with one key in the order of the
/// packs.
#[derive(Default)]
pub struct SideBySide(BTreeMap<(Application, String), Vec<Listed>>);

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
            self.0.entry((application, key)).or_default().push(listed);
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
        let listed = self.0.get(&(application, key.to_owned()))?;
        let own = listed.iter().find(|one| one.path == file.path)?;
        let earlier = listed.iter().take_while(|one| one.pack != own.pack);
        earlier.into_iter().find(|one| one.rel != own.rel)
    }
}
