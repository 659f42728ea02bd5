//! Arrays and archives for tests.

use std::io::{Cursor, Write};

use zip::write::{SimpleFileOptions, ZipWriter};

/// An array of this type and shape, as their texts stand in a header.
pub(crate) fn npy(descr: &str, shape: &str, data: &[u8]) -> Vec<u8> {
    npy_in_order(descr, "False", shape, data)
}

/// The same with or without the elements of a column together.
pub(crate) fn npy_in_order(descr: &str, by_column: &str, shape: &str, data: &[u8]) -> Vec<u8> {
    let header =
        format!("{{'descr': {descr}, 'fortran_order': {by_column}, 'shape': {shape}, }}\n");
    let length = u16::try_from(header.len())
        .expect("headers of samples are short")
        .to_le_bytes();
    [
        b"\x93NUMPY\x01\x00".as_slice(),
        &length,
        header.as_bytes(),
        data,
    ]
    .concat()
}

/// An archive with these members.
pub(crate) fn zip_of(members: &[(&str, Vec<u8>)]) -> Vec<u8> {
    let mut writer = ZipWriter::new(Cursor::new(Vec::new()));
    for (name, bytes) in members {
        writer
            .start_file(*name, SimpleFileOptions::default())
            .expect("memory takes members");
        writer.write_all(bytes).expect("memory takes bytes");
    }
    writer
        .finish()
        .expect("memory takes the directory")
        .into_inner()
}
