//! PFM: what is read must come back, bit for bit, when it is written in either order of bytes, and
//! as a disparity map.
#![no_main]

use ga_image::pfm::{self, ByteOrder};
use ga_image::picture::Picture;
use ga_vision::disparity::file;
use libfuzzer_sys::fuzz_target;

fuzz_target!(|data: &[u8]| {
    let Ok(picture) = pfm::decode(data) else {
        return;
    };
    let is_empty = picture.width() == 0 || picture.height() == 0;
    for order in [ByteOrder::Little, ByteOrder::Big] {
        let Ok(bytes) = pfm::encode(&picture, order) else {
            assert!(is_empty);
            return;
        };
        let back = pfm::decode(&bytes).expect("what is written is readable");
        assert_eq!(bits(&back), bits(&picture));
    }
    let map = file::decode(data, None);
    assert_eq!(map.is_ok(), matches!(picture, Picture::GreyF32(_)));
    if let Ok(map) = map {
        let bytes = file::encode(&map).expect("there are pixels");
        assert_eq!(
            file::decode(&bytes, None).expect("what is written is readable"),
            map
        );
    }
});

/// The size of a picture and the bits of its numbers, which NaN does not hide.
fn bits(picture: &Picture) -> (usize, usize, Vec<u32>) {
    let bits = match picture {
        Picture::GreyF32(plane) => plane.values().iter().map(|x| x.to_bits()).collect(),
        Picture::RgbF32(plane) => {
            let samples = plane.values().as_flattened().iter();
            samples.map(|x| x.to_bits()).collect()
        }
        _ => panic!("PFM holds floats only"),
    };
    (picture.width(), picture.height(), bits)
}
