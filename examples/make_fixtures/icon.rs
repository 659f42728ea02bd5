//! Small PNG pictures, one pattern per name.
//!
//! Two colours and a symmetric pattern are drawn from a hash of the name. The image data is stored
//! without compression, so that the bytes do not depend on the version of a compressor.

use std::io::Write;

use flate2::{Compression, Crc, write::ZlibEncoder};

/// Width is a multiple of 16.
pub(crate) fn png(name: &str, width: usize, height: usize) -> Vec<u8> {
    let mut state = hash(name);
    let mut rows = Vec::new();
    for _ in 0..height / 2 {
        let half: Vec<u8> = (0..width / 16).map(|_| next(&mut state)).collect();
        // A filter byte (0: none), the left half, its mirror image; every row twice.
        let mirror: Vec<u8> = half.iter().rev().map(|bits| bits.reverse_bits()).collect();
        let row = [vec![0], half, mirror].concat();
        rows.extend_from_slice(&row);
        rows.extend_from_slice(&row);
    }
    let palette: [u8; 6] = [0; 6].map(|_| next(&mut state));
    // Bit depth 1, colour type 3 (palette), no interlace.
    let header = [&size(width)[..], &size(height)[..], &[1, 3, 0, 0, 0]].concat();
    file(&[
        (b"IHDR", header),
        (b"PLTE", palette.to_vec()),
        (b"IDAT", stored(&rows)),
        (b"IEND", vec![]),
    ])
}

/// A square of 8 by 8 for a surface, with eight bits for each of red, green, blue; and of opacity,
/// if asked for.
pub(crate) fn texture(name: &str, has_alpha: bool) -> Vec<u8> {
    let mut state = hash(name);
    let colours = [(); 4].map(|()| [(); 4].map(|()| next(&mut state)));
    let pixel = |row: usize, column: usize| {
        let colour = colours[(row / 2 + column / 2) % 4];
        if has_alpha {
            colour.to_vec()
        } else {
            colour[..3].to_vec()
        }
    };
    // A filter byte (0: none) and the pixels.
    let rows: Vec<u8> = (0..8)
        .flat_map(|row| [vec![0], (0..8).flat_map(|at| pixel(row, at)).collect()].concat())
        .collect();
    let kind = if has_alpha { 6 } else { 2 };
    let header = [&size(8)[..], &size(8)[..], &[8, kind, 0, 0, 0]].concat();
    file(&[
        (b"IHDR", header),
        (b"IDAT", stored(&rows)),
        (b"IEND", vec![]),
    ])
}

fn size(length: usize) -> [u8; 4] {
    u32::try_from(length)
        .expect("invariant: pictures are small")
        .to_be_bytes()
}

fn file(chunks: &[(&[u8; 4], Vec<u8>)]) -> Vec<u8> {
    let mut file = b"\x89PNG\r\n\x1a\n".to_vec();
    for (kind, data) in chunks {
        let mut checksum = Crc::new();
        checksum.update(*kind);
        checksum.update(data);
        file.extend_from_slice(&size(data.len()));
        file.extend_from_slice(*kind);
        file.extend_from_slice(data);
        file.extend_from_slice(&checksum.sum().to_be_bytes());
    }
    file
}

fn stored(data: &[u8]) -> Vec<u8> {
    let mut encoder = ZlibEncoder::new(Vec::new(), Compression::none());
    encoder
        .write_all(data)
        .and_then(|()| encoder.finish())
        .expect("invariant: writing to memory")
}

/// FNV-1a.
fn hash(name: &str) -> u64 {
    name.bytes().fold(0xcbf2_9ce4_8422_2325, |hash, byte| {
        (hash ^ u64::from(byte)).wrapping_mul(0x0100_0000_01b3)
    })
}

/// Top byte of a linear congruential sequence.
fn next(state: &mut u64) -> u8 {
    *state = state
        .wrapping_mul(6_364_136_223_846_793_005)
        .wrapping_add(1_442_695_040_888_963_407);
    state.to_be_bytes()[0]
}
