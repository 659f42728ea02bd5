//! Archives that unpack to very much.

use std::io::{Cursor, Write};

use zip::write::{SimpleFileOptions, ZipWriter};

use super::{Files, SQUARE, base, file};

fn npy(descr: &str, rows: usize, bytes: usize) -> Vec<u8> {
    let header = format!("{{'descr': {descr}, 'fortran_order': False, 'shape': ({rows},), }}\n");
    let length = u16::try_from(header.len()).unwrap().to_le_bytes();
    [
        b"\x93NUMPY\x01\x00".as_slice(),
        &length,
        header.as_bytes(),
        &vec![0; bytes],
    ]
    .concat()
}

fn zip(members: impl Iterator<Item = (String, Vec<u8>)>) -> Vec<u8> {
    let mut zip = ZipWriter::new(Cursor::new(Vec::new()));
    for (name, bytes) in members {
        zip.start_file(name, SimpleFileOptions::default()).unwrap();
        zip.write_all(&bytes).unwrap();
    }
    zip.finish().unwrap().into_inner()
}

const TINY_ROWS: &str = "[('index', '|u1'), ('vector', '|i1', (3,))]";

/// A megabyte of rows for each time.
pub(super) fn dense_archive(times: usize) -> Files {
    let members = (0..times).map(|at| (format!("t/{at}.npy"), npy(TINY_ROWS, 250_000, 1_000_000)));
    let sliders = r#"{"s": {"incr": "t/0"}}"#;
    let more = [
        file("data/target/b/t/0.target", "0 .1 0 0\n"),
        file("data/target/b/modelling.json", sliders),
        file("data/target/b/compressedtargets.npz", zip(members)),
    ];
    [base(SQUARE), more.to_vec()].concat()
}

/// Entries of the directory that all lead to the same bytes.
pub(super) fn overlapping_archive(times: usize) -> Files {
    let archive = zip([("00000.npy".to_owned(), npy(TINY_ROWS, 50_000, 200_000))].into_iter());
    let find = |mark: &[u8]| archive.windows(4).position(|found| found == mark).unwrap();
    let (directory, end) = (find(b"PK\x01\x02"), find(b"PK\x05\x06"));
    let mut out = archive[..directory].to_vec();
    for at in 0..times {
        let entry = archive[directory..end].to_vec();
        let name = entry
            .windows(5)
            .position(|found| found == b"00000")
            .unwrap();
        out.extend(
            [
                &entry[..name],
                format!("{:05}", at % 100_000).as_bytes(),
                &entry[name + 5..],
            ]
            .concat(),
        );
    }
    let size = u32::try_from(out.len() - directory).unwrap();
    let count = u16::try_from(times.min(65_535)).unwrap().to_le_bytes();
    let place = u32::try_from(directory).unwrap().to_le_bytes();
    out.extend(
        [
            b"PK\x05\x06\0\0\0\0".as_slice(),
            &count,
            &count,
            &size.to_le_bytes(),
            &place,
            &[0, 0],
        ]
        .concat(),
    );
    [
        base(SQUARE),
        vec![file("data/target/b/compressedtargets.npz", out)],
    ]
    .concat()
}

pub(super) fn dense_mesh(times: usize) -> Files {
    let members = (0..times).map(|at| {
        (
            if at == 0 {
                "coord.npy".to_owned()
            } else {
                format!("{at}.npy")
            },
            at,
        )
    });
    let members = members.map(|(name, _)| (name, npy("'|i1'", 1_000_000, 1_000_000)));
    [
        base(SQUARE),
        vec![file("data/base/b/base.mhbin", zip(members))],
    ]
    .concat()
}
