//! `images.list`: the pictures that MakeHuman 1 has for its sliders beside an archive of targets
//! (`docs/loaders/makehuman1/target-archive.md#content`).

/// The pictures of a list.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct PictureList {
    /// Its lines that end in `.png`.
    pub pictures: Vec<Box<str>>,
    /// Whether it is no UTF-8, which the program takes for no list at all.
    pub is_broken: bool,
}

/// No system has a path of more bytes.
const LONGEST: usize = 4096;

/// Reads a list.
pub fn read(bytes: &[u8]) -> PictureList {
    let Ok(text) = std::str::from_utf8(bytes) else {
        return PictureList {
            is_broken: true,
            ..PictureList::default()
        };
    };
    let is_path =
        |line: &&str| line.len() <= LONGEST && line.to_ascii_lowercase().ends_with(".png");
    let lines = text.lines().map(str::trim).filter(is_path);
    PictureList {
        pictures: lines.map(Into::into).collect(),
        is_broken: false,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lines_that_end_as_pictures_do_count() {
        let list = read(b"data/targets/head/a.png\r\n# note\n\ndata/b.jpg\ndata/c.png");
        assert_eq!(
            list.pictures,
            [
                Box::from("data/targets/head/a.png"),
                Box::from("data/c.png")
            ]
        );
        assert!(read(b"data/\xff.png\n").is_broken && read(b"").pictures.is_empty());
    }
}
