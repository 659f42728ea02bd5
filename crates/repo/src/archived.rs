//! Archives that applications read in place of texts.

use std::collections::BTreeMap;

use super::{FileFacts, View};
use mhlint_diag::Application;

/// What archives of one file end in, for each application that reads some.
const fn archives(application: Application) -> &'static [&'static str] {
    match application {
        Application::Makehuman2 => &[".mhbin"],
        Application::Makehuman1 => &[".mhpxy", ".npz"],
        Application::Mpfb => &[],
    }
}

impl<'a> View<'a> {
    /// The archives that are read in place of files, by the paths of these.
    pub fn archived(&self) -> BTreeMap<&'a str, &'a FileFacts> {
        let mut archived: BTreeMap<&str, &FileFacts> = BTreeMap::new();
        let (layer, extensions) = (self.layers().checked, archives(self.application()));
        let files = layer
            .files
            .values()
            .filter(|file| extensions.iter().any(|own| file.rel.ends_with(own)));
        archived.extend(
            files.filter_map(|file| Some((layer.text_of_archive(&file.rel)?.path.as_str(), file))),
        );
        let targets = match self {
            Self::Makehuman2(view) => view.bases.iter().filter_map(|base| base.targets).collect(),
            _ => Vec::new(),
        };
        for folder in targets {
            let Some(archive) = folder.archive() else {
                continue;
            };
            archived.extend(
                folder
                    .targets()
                    .map(|target| (target.path.as_str(), archive)),
            );
        }
        if let Some((archive, targets)) = self
            .as_makehuman1()
            .and_then(|view| view.targets.archived())
        {
            // One without a text has the archive for a file.
            let texts = targets
                .iter()
                .map(|(target, _)| target.file)
                .filter(|file| file.path != archive.file.path);
            archived.extend(texts.map(|file| (file.path.as_str(), archive.file)));
        }
        archived
    }
}
