//! Pictures of every format: an error, or a picture that PNG gives back where it holds its kind.
#![no_main]

use ga_image::{file, png};
use libfuzzer_sys::fuzz_target;

fuzz_target!(|data: &[u8]| {
    let Ok(read) = file::decode_oriented(data) else {
        return;
    };
    assert!(file::decode(data).is_ok());
    if let Ok(bytes) = png::encode(&read.picture) {
        let back = png::decode(&bytes).expect("what is written is readable");
        assert_eq!(back, read.picture);
    }
});
