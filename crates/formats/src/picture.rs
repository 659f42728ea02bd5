//! Pictures: what their first and last bytes show of them. Nothing is decoded.

use std::ops::Range;

use imagesize::{ImageError, ImageType, blob_size, image_type};

/// As much of the beginning of a picture as is read: JPEG keeps its size behind thumbnails and
/// colour profiles.
pub const HEAD: usize = 64 << 10;
/// As much of its end.
pub const TAIL: usize = 4 << 10;

/// A picture as far as it is known without its pixels.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct Picture {
    /// The format, by content.
    pub format: Option<PictureFormat>,
    /// Width and height.
    pub size: Option<(u64, u64)>,
    /// How the pixels are stored.
    pub pixels: Option<Pixels>,
    /// Why it cannot be shown.
    pub fault: Option<PictureFault>,
}

/// The format of a picture.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum PictureFormat {
    /// PNG.
    Png,
    /// JPEG.
    Jpeg,
    /// BMP.
    Bmp,
    /// Another one that is known by its first bytes.
    Other(&'static str),
    /// One for tools of artists, which few programs show: Photoshop, say.
    Source(&'static str),
}

/// How pixels are stored.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Pixels {
    /// Shades of grey of so many bits, `keyed` if one of them is transparent.
    Grey {
        /// Bits of a pixel.
        bits: u8,
        /// Whether a shade is transparent.
        keyed: bool,
    },
    /// Numbers of colours in a table.
    Palette,
    /// Colours, or grey with transparency, of so many bits each.
    Channels {
        /// Bits of a channel.
        bits: u8,
        /// Whether there is colour.
        colour: bool,
    },
}

/// Why a picture cannot be shown.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum PictureFault {
    /// Its first bytes are those of no picture.
    NotAPicture,
    /// The header is damaged.
    Header,
    /// The header says that there are no pixels.
    NoPixels,
    /// The header says more pixels than the bytes can hold.
    TooManyPixels,
    /// The end is missing.
    CutOff,
}

impl PictureFormat {
    /// What people call it.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Png => "PNG",
            Self::Jpeg => "JPEG",
            Self::Bmp => "BMP",
            Self::Other(name) | Self::Source(name) => name,
        }
    }
}

/// What drawings begin with that are texts: SVG, XPM and XBM.
const DRAWINGS: [&[u8]; 6] = [
    b"<svg",
    b"<?xml",
    b"<!--",
    b"<!DOCTYPE svg",
    b"/* XPM",
    b"#define",
];

/// Looks at the ends of a picture of `size` bytes; `tail` is empty where `head` is all of it.
pub fn read(head: &[u8], tail: &[u8], size: u64) -> Picture {
    let is_whole = head.len() as u64 >= size;
    let Ok(kind) = image_type(head) else {
        let is_text = DRAWINGS
            .iter()
            .any(|mark| head.trim_ascii_start().starts_with(mark));
        let fault = (!is_text).then_some(PictureFault::NotAPicture);
        return Picture {
            fault,
            ..Picture::default()
        };
    };
    let format = format(kind);
    let size_in_header = blob_size(head);
    let measured = size_in_header
        .as_ref()
        .ok()
        .map(|size| (size.width as u64, size.height as u64));
    let pixels = pixels(format, head);
    let fault = match (&size_in_header, measured) {
        (Err(ImageError::IoError(_)), _) if !is_whole => None,
        (Err(_), _) => Some(PictureFault::Header),
        (_, Some((0, _) | (_, 0))) => Some(PictureFault::NoPixels),
        _ if format == PictureFormat::Png => {
            png_fault(head, tail, size, measured.unwrap_or_default())
        }
        _ => None,
    };
    Picture {
        format: Some(format),
        size: measured,
        pixels,
        fault,
    }
}

const fn format(kind: ImageType) -> PictureFormat {
    match kind {
        ImageType::Png => PictureFormat::Png,
        ImageType::Jpeg => PictureFormat::Jpeg,
        ImageType::Bmp => PictureFormat::Bmp,
        ImageType::Gif => PictureFormat::Other("GIF"),
        ImageType::Tiff => PictureFormat::Other("TIFF"),
        ImageType::Webp => PictureFormat::Other("WebP"),
        ImageType::Tga => PictureFormat::Other("TGA"),
        ImageType::Ico => PictureFormat::Other("ICO"),
        ImageType::Pnm => PictureFormat::Other("PNM"),
        ImageType::Psd => PictureFormat::Source("Photoshop"),
        ImageType::Exr => PictureFormat::Source("OpenEXR"),
        ImageType::Hdr => PictureFormat::Source("HDR"),
        ImageType::Dds(_) => PictureFormat::Source("DDS"),
        ImageType::Qoi => PictureFormat::Source("QOI"),
        _ => PictureFormat::Other("unknown"),
    }
}

/// Bytes of a PNG up to the end of its header: mark, length, name, 13 bytes, checksum.
const PNG_HEADER: usize = 33;
/// What deflate packs into one byte at most, and what is around it.
const DEFLATE: u64 = 1040;

fn png_fault(
    head: &[u8],
    tail: &[u8],
    size: u64,
    (width, height): (u64, u64),
) -> Option<PictureFault> {
    let (Some(data), Some(sum)) = (
        head.get(12..PNG_HEADER - 4),
        head.get(PNG_HEADER - 4..PNG_HEADER),
    ) else {
        return Some(PictureFault::CutOff);
    };
    let mut own = flate2::Crc::new();
    own.update(data);
    if !data.starts_with(b"IHDR") || own.sum().to_be_bytes() != sum {
        return Some(PictureFault::Header);
    }
    let bits = data.get(12).map_or(1, |depth| u64::from(*depth)) * png_channels(data);
    let row = width.saturating_mul(bits).div_ceil(8).saturating_add(1);
    if row.saturating_mul(height) > size.saturating_mul(DEFLATE) {
        return Some(PictureFault::TooManyPixels);
    }
    let end = if tail.is_empty() { head } else { tail };
    let has_end = end
        .get(end.len().saturating_sub(TAIL)..)
        .is_some_and(|end| holds(end, *b"IEND"));
    (!has_end).then_some(PictureFault::CutOff)
}

fn holds(bytes: &[u8], word: [u8; 4]) -> bool {
    bytes.windows(word.len()).any(|window| window == word)
}

/// Values of a pixel, by the colour type behind name, size and depth.
fn png_channels(header: &[u8]) -> u64 {
    match header.get(13) {
        Some(2) => 3,
        Some(4) => 2,
        Some(6) => 4,
        _ => 1,
    }
}

fn pixels(format: PictureFormat, head: &[u8]) -> Option<Pixels> {
    match format {
        PictureFormat::Png => {
            let bits = *head.get(24)?;
            Some(match head.get(25)? {
                0 => Pixels::Grey {
                    bits,
                    keyed: png_has_key(head),
                },
                3 => Pixels::Palette,
                colour => Pixels::Channels {
                    bits,
                    colour: *colour != 4,
                },
            })
        }
        PictureFormat::Jpeg => Some(match jpeg_components(head)? {
            1 => Pixels::Grey {
                bits: 8,
                keyed: false,
            },
            _ => Pixels::Channels {
                bits: 8,
                colour: true,
            },
        }),
        PictureFormat::Bmp => Some(match head.get(28)? {
            1..=8 => Pixels::Palette,
            _ => Pixels::Channels {
                bits: 8,
                colour: true,
            },
        }),
        PictureFormat::Other(_) | PictureFormat::Source(_) => None,
    }
}

/// Whether a chunk in front of the pixels makes a shade transparent.
fn png_has_key(head: &[u8]) -> bool {
    let mut at = PNG_HEADER;
    while let Some(Range { start, .. }) = head.get(at..at + 8).map(|_| at..at + 8) {
        let length = head
            .get(start..start + 4)
            .and_then(|bytes| bytes.try_into().ok())
            .map_or(0, u32::from_be_bytes);
        match head.get(start + 4..start + 8) {
            Some(b"tRNS") => return true,
            Some(b"IDAT") => return false,
            _ => at = start.saturating_add(12).saturating_add(length as usize),
        }
    }
    false
}

/// Components of the first frame: 1 is grey.
fn jpeg_components(head: &[u8]) -> Option<u8> {
    let mut at = 2_usize;
    loop {
        let marker = *head.get(at.checked_add(1)?)?;
        let length = u16::from_be_bytes(head.get(at + 2..at + 4)?.try_into().ok()?);
        let is_frame = matches!(marker, 0xc0..=0xcf) && !matches!(marker, 0xc4 | 0xc8 | 0xcc);
        if is_frame {
            return head.get(at + 9).copied();
        }
        at = at.checked_add(2)?.checked_add(usize::from(length).max(2))?;
    }
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;

    /// A PNG of a size, depth and colour type, with `pixels` bytes of data that nobody reads.
    fn png(size: (u32, u32), depth: u8, colour: u8, pixels: usize) -> Vec<u8> {
        let mut png = b"\x89PNG\r\n\x1a\n".to_vec();
        let mut chunk = |name: &[u8; 4], data: &[u8]| {
            let mut sum = flate2::Crc::new();
            sum.update(name);
            sum.update(data);
            png.extend(u32::try_from(data.len()).unwrap().to_be_bytes());
            png.extend(name);
            png.extend(data);
            png.extend(sum.sum().to_be_bytes());
        };
        let header = [
            &size.0.to_be_bytes()[..],
            &size.1.to_be_bytes(),
            &[depth, colour, 0, 0, 0],
        ]
        .concat();
        chunk(b"IHDR", &header);
        chunk(b"IDAT", &vec![0; pixels]);
        chunk(b"IEND", b"");
        png
    }

    fn all(bytes: &[u8]) -> Picture {
        read(bytes, b"", bytes.len() as u64)
    }

    #[test]
    fn a_png_shows_size_and_pixels() {
        let own = all(&png((16, 8), 8, 2, 40));
        let pixels = Some(Pixels::Channels {
            bits: 8,
            colour: true,
        });
        assert_eq!(
            own,
            Picture {
                format: Some(PictureFormat::Png),
                size: Some((16, 8)),
                pixels,
                fault: None
            }
        );
        for (colour, pixels) in [
            (
                0,
                Pixels::Grey {
                    bits: 8,
                    keyed: false,
                },
            ),
            (3, Pixels::Palette),
            (
                4,
                Pixels::Channels {
                    bits: 8,
                    colour: false,
                },
            ),
        ] {
            assert_eq!(all(&png((1, 1), 8, colour, 9)).pixels, Some(pixels));
        }
    }

    #[test]
    fn a_jpeg_and_a_bmp_show_how_their_pixels_are_stored() {
        let jpeg = |components: u8| {
            let app = [&b"\xff\xd8\xff\xe0\0\x10"[..], &[0; 14]].concat();
            [
                &app[..],
                b"\xff\xc0\0\x11\x08\0\x04\0\x06",
                &[components],
                &[0; 12],
            ]
            .concat()
        };
        assert_eq!(
            all(&jpeg(1)).pixels,
            Some(Pixels::Grey {
                bits: 8,
                keyed: false
            })
        );
        let colour = all(&jpeg(3));
        assert_eq!((colour.size, colour.fault), (Some((6, 4)), None));
        let mut bmp = vec![0; 60];
        bmp[..2].copy_from_slice(b"BM");
        (bmp[14], bmp[18], bmp[22], bmp[28]) = (40, 4, 4, 8);
        assert_eq!(
            (all(&bmp).size, all(&bmp).pixels),
            (Some((4, 4)), Some(Pixels::Palette))
        );
    }

    #[test]
    fn what_is_no_picture_or_lies_has_its_fault() {
        let fault = |bytes: &[u8]| all(bytes).fault;
        let good = png((4, 4), 8, 2, 40);
        assert_eq!(
            fault(b"just a text, nothing else"),
            Some(PictureFault::NotAPicture)
        );
        assert_eq!(fault(b"short"), Some(PictureFault::NotAPicture));
        assert_eq!(
            fault(b"<!DOCTYPE html><html></html>"),
            Some(PictureFault::NotAPicture)
        );
        assert_eq!(fault(b"<svg xmlns='http://www.w3.org/2000/svg'/>"), None);
        assert_eq!(fault(&good[..20]), Some(PictureFault::Header));
        assert_eq!(fault(&good[..60]), Some(PictureFault::CutOff));
        assert_eq!(fault(&png((0, 4), 8, 2, 40)), Some(PictureFault::NoPixels));
        assert_eq!(
            fault(&png((60_000, 60_000), 8, 6, 40)),
            Some(PictureFault::TooManyPixels)
        );
        let mut changed = good.clone();
        changed[19] ^= 1;
        assert_eq!(fault(&changed), Some(PictureFault::Header));
        assert_eq!(
            read(&good[..50], &good[50..], good.len() as u64).fault,
            None
        );
        assert_eq!(
            read(b"\xff\xd8\xff\xe0\xff\xff      ", b"\xff\xd9", 99_999).fault,
            None,
            "nobody can tell"
        );
    }

    proptest! {
        #[test]
        fn hostile_bytes_are_a_fault_at_most(
            mark in proptest::sample::select(vec![&b""[..], b"\x89PNG\r\n\x1a\n", b"\xff\xd8\xff", b"BM", b"II*\0", b"P6 ", b"v/1\x01"]),
            rest in proptest::collection::vec(any::<u8>(), 0..80),
            more in 0_u64..1 << 40,
        ) {
            let bytes = [mark, &rest].concat();
            let size = bytes.len() as u64 + more;
            let _ = read(&bytes, &rest, size);
        }

        #[test]
        fn a_whole_png_has_no_fault_and_any_beginning_of_it_has_one(width in 1_u32..50, height in 1_u32..50, cut in 0_usize..70) {
            let good = png((width, height), 8, 2, 60);
            prop_assert_eq!(all(&good).fault, None);
            prop_assert!(all(&good[..cut.max(1)]).fault.is_some());
        }
    }
}
