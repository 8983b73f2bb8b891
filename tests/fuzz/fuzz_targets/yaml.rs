//! YAML of cameras and rigs as OpenCV writes it, and calib.txt of Middlebury: numbers that were
//! read are finite, and what is written is readable and the same.
#![no_main]

use ga_camera::format::calib::Calib;
use ga_camera::format::camera::CameraFile;
use ga_camera::format::rig::RigFile;
use ga_camera::format::yaml::Storage;
use libfuzzer_sys::fuzz_target;

fuzz_target!(|data: &[u8]| {
    let _ = Calib::decode(data);
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
    if let Ok(camera) = CameraFile::decode(data) {
        let text = camera.encode();
        let back = CameraFile::decode(text.as_bytes()).expect("what is written is readable");
        assert_eq!(back, camera);
    }
    let _ = RigFile::decode(data);
});
