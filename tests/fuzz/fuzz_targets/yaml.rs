//! Files of cameras and rigs of any format: numbers that were read are finite, and what is written
//! is readable and the same.
#![no_main]

use std::path::Path;

use ga_camera::format::storage::Storage;
use ga_camera::format::{Format, camera, decode, encode_files};
use libfuzzer_sys::fuzz_target;

fuzz_target!(|data: &[u8]| {
    // Files that others name are looked for in a folder that does not exist.
    let file = decode(data, Path::new("nowhere"));
    if let Ok(file) = &file {
        for format in Format::ALL {
            let written = encode_files("file", format, file);
            for (_, text) in written.map(|written| written.files).unwrap_or_default() {
                _ = decode(text.as_bytes(), Path::new("nowhere"));
            }
        }
    }
    let Ok(storage) = Storage::decode(data) else {
        return;
    };
    let mut written = Storage::default();
    for name in storage.names() {
        if let Ok(Some(matrix)) = storage.matrix(name) {
            assert_eq!(matrix.values().len(), matrix.rows() * matrix.columns());
            assert!(matrix.values().iter().all(|x| x.is_finite()));
            written.set_matrix(name, matrix);
        } else if let Ok(Some(number)) = storage.number(name) {
            assert!(number.is_finite());
            written.set_number(name, number);
        } else if let Ok(Some(text)) = storage.text(name) {
            written.set_text(name, &text);
        }
    }
    let back = Storage::decode(written.encode().as_bytes()).expect("what is written is readable");
    for name in written.names() {
        assert_eq!(
            back.matrix(name).ok(),
            written.matrix(name).ok(),
            "{name:?}"
        );
        assert_eq!(
            back.number(name).ok(),
            written.number(name).ok(),
            "{name:?}"
        );
    }
    if let Ok([only]) = file.as_ref().map(|file| file.cameras.as_slice()) {
        if let (Ok(intrinsics), None, None) = (only.intrinsics(), only.pose, &only.picture) {
            let text = camera::storage(&intrinsics, only.size).encode();
            let back = decode(text.as_bytes(), Path::new("")).expect("what is written is readable");
            assert_eq!(back.cameras[0].intrinsics().ok(), Some(intrinsics));
            assert_eq!(back.cameras[0].size, only.size);
        }
    }
});
