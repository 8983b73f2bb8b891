//! Compressed clips: whatever the bytes, they are read or refused, and what is read has finite
//! poses. The checksums are put right first, since almost no input passes them.
#![no_main]

use ga_anim::clip::compressed::{CompressedClip, Sampler};
use libfuzzer_sys::fuzz_target;

/// Where the header has the lengths of the sections, and where its checksum is.
const LENGTHS: [usize; 3] = [28, 32, 36];
const HEADER: usize = 72;

fuzz_target!(|data: &[u8]| {
    let _ = CompressedClip::decode(data.to_vec());
    let mut bytes = data.to_vec();
    seal(&mut bytes);
    let Ok(clip) = CompressedClip::decode(bytes) else {
        return;
    };
    assert_eq!(clip.parents().len(), clip.names().len());
    let mut sampler = Sampler::new(&clip);
    let duration = clip.duration();
    for time in [0.0, 0.3 * duration, 0.7 * duration, duration] {
        sampler.sample(time);
        for rotor in sampler.rotors() {
            let parts = [rotor.scalar(), rotor.e12(), rotor.e13(), rotor.e23()];
            assert!(parts.iter().all(|x| x.is_finite()));
        }
        for place in sampler.translations().iter().chain(sampler.scales()) {
            assert!(place.coordinates().iter().all(|x| x.is_finite()));
        }
        assert!(sampler.tracks().iter().all(|x| x.is_finite()));
    }
});

/// Puts right the checksums of the header and of the sections that are there.
fn seal(bytes: &mut [u8]) {
    let Some(numbers) = bytes.get(..HEADER) else {
        return;
    };
    let sum = crc32fast::hash(numbers);
    let lengths = LENGTHS.map(|place| {
        let number = numbers[place..place + 4].try_into().map(u32::from_le_bytes);
        number.unwrap_or(0) as usize
    });
    put(bytes, HEADER, sum);
    let mut begin = HEADER + 4;
    for length in lengths {
        let Some(section) = bytes.get(begin..begin.saturating_add(length)) else {
            return;
        };
        let sum = crc32fast::hash(section);
        put(bytes, begin + length, sum);
        begin += length + 4;
    }
}

fn put(bytes: &mut [u8], place: usize, sum: u32) {
    if let Some(word) = bytes.get_mut(place..place + 4) {
        word.copy_from_slice(&sum.to_le_bytes());
    }
}
