//! Files of cameras of each format with some other bytes: what is read is finite and comes back
//! from every format that holds it, and what is refused is so in one line.
#![no_main]

use std::path::Path;
use std::sync::LazyLock;

use ga_camera::format::{CameraFile, Format, decode, encode_files};
use libfuzzer_sys::fuzz_target;

/// Texts of each format; the first byte of an input chooses one.
static TEXTS: LazyLock<Vec<String>> = LazyLock::new(|| {
    let cases = include_str!("../../../foundation/camera/tests/data/formats.json");
    let cases: Vec<serde_json::Value> = serde_json::from_str(cases).expect("cases are JSON");
    let own = [
        "cam0=[500 0 320; 0 500 240; 0 0 1]\ncam1=[500 0 325; 0 500 240; 0 0 1]\ndoffs=5\n\
         baseline=100\nwidth=640\nheight=480\nndisp=64\n",
        "{\"views\": [{\"picture\": \"a.png\", \"camera\": {\"width\": 640, \"height\": 480, \"fx\": 500, \
         \"fy\": 500, \"cx\": 320, \"cy\": 240, \"distortion\": [0.1, 0, 0, 0]}, \"quaternion_wxyz\": \
         [1, 0, 0, 0], \"translation\": [0, 0, 1]}]}",
        "# Cameras\n1 OPENCV 640 480 500 501 320.5 240.5 -0.1 0.02 0.001 0.002\n",
    ];
    let texts = cases.iter().filter_map(|case| case["text"].as_str());
    texts.chain(own).map(str::to_owned).collect()
});

// The bytes behind the first are edits: two of a place, how many bytes are cut there, how many of
// those behind are put there.
fuzz_target!(|data: &[u8]| {
    let Some((choice, mut edits)) = data.split_first() else {
        return;
    };
    let mut bytes = TEXTS[usize::from(*choice) % TEXTS.len()]
        .clone()
        .into_bytes();
    while let [high, low, cut, count, rest @ ..] = edits {
        let place = usize::from(u16::from_be_bytes([*high, *low])) % (bytes.len() + 1);
        let end = (place + usize::from(*cut)).min(bytes.len());
        let (new, rest) = rest.split_at(usize::from(count % 16).min(rest.len()));
        bytes.splice(place..end, new.iter().copied());
        edits = rest;
    }
    // Files that others name are looked for in a folder that does not exist.
    match decode(&bytes, Path::new("nowhere")) {
        Ok(file) => check(&file),
        Err(error) => assert!(!error.to_string().contains('\n'), "{error}"),
    }
});

fn check(file: &CameraFile) {
    for camera in &file.cameras {
        let pose = camera.pose.map(|pose| pose.to_matrix());
        assert!(pose.iter().flatten().flatten().all(|x| x.is_finite()));
        if let Ok((intrinsics, skew)) = camera.intrinsics_and_skew() {
            assert!(skew.is_finite());
            assert!(intrinsics.parameters().iter().all(|x| x.is_finite()));
        }
    }
    for format in Format::ALL {
        let Ok(written) = encode_files("file", format, file) else {
            continue;
        };
        for (_, text) in written.files {
            let back = decode(text.as_bytes(), Path::new("nowhere"));
            if format.names_in_folder().is_none() {
                let back = back.expect("what is written is readable");
                assert_eq!(back.cameras.len(), file.cameras.len());
            }
        }
    }
}
