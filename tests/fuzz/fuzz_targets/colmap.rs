//! Models of COLMAP in a folder, as text and binary: cameras, then two bytes 255, then images.
#![no_main]

use std::sync::LazyLock;

use ga_camera::format::read;
use libfuzzer_sys::fuzz_target;
use tempfile::TempDir;

static FOLDERS: LazyLock<[TempDir; 2]> =
    LazyLock::new(|| [(); 2].map(|()| tempfile::tempdir().expect("there is room for a folder")));

fuzz_target!(|data: &[u8]| {
    let middle = data.windows(2).position(|pair| pair == [255; 2]);
    let (cameras, images) = match middle {
        Some(middle) => (&data[..middle], &data[middle + 2..]),
        None => (data, &[][..]),
    };
    for (folder, ending) in FOLDERS.iter().zip(["txt", "bin"]) {
        for (name, bytes) in [("cameras", cameras), ("images", images)] {
            let path = folder.path().join(format!("{name}.{ending}"));
            std::fs::write(path, bytes).expect("the folder is ours");
        }
        match read(folder.path()) {
            Ok(file) => {
                for camera in &file.cameras {
                    let pose = camera.pose.map(|pose| pose.to_matrix());
                    assert!(pose.iter().flatten().flatten().all(|x| x.is_finite()));
                }
            }
            Err(error) => assert!(!error.to_string().contains('\n'), "{error}"),
        }
    }
});
