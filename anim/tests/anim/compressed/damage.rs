//! Files that are cut or changed.

use ga_anim::clip::ClipError;
use ga_anim::clip::compressed::{CompressedClip, Options};
use proptest::prelude::*;

use super::{compressed, noise, recording, rigid, rotation, tree};

fn small() -> CompressedClip {
    let recording = recording(&tree(3), 0.01, 40, |frame, joint| {
        let angles = [0, 1, 2].map(|k| 0.01 * noise(frame, joint, k));
        rigid([0.1 * joint as f64, 0.2, 0.0], rotation(angles))
    });
    compressed(&recording, &Options::default())
}

#[test]
fn a_file_reads_back_as_it_was_written() {
    let clip = small();
    let back = CompressedClip::decode(clip.as_bytes().to_vec()).unwrap();
    assert_eq!(back, clip);
    assert_eq!(back.names(), ["joint 0", "joint 1", "joint 2"]);
    assert_eq!(back.parents(), tree(3));
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("a.clip");
    clip.write(&path).unwrap();
    assert_eq!(CompressedClip::read(&path).unwrap(), clip);
    std::fs::write(&path, &clip.as_bytes()[..90]).unwrap();
    let message = CompressedClip::read(&path).unwrap_err().to_string();
    let start = format!(
        "{}: the file ends in its names: it has 90 bytes of ",
        path.display()
    );
    assert!(message.starts_with(&start), "{message}");
}

#[test]
fn a_cut_at_any_byte_is_an_error_that_says_where() {
    let clip = small();
    let bytes = clip.as_bytes();
    for length in 0..bytes.len() {
        let error = CompressedClip::decode(bytes[..length].to_vec()).unwrap_err();
        match error {
            ClipError::NotAClip => assert_eq!(length, 0),
            ClipError::Truncated {
                section,
                expected,
                found,
            } => {
                assert_eq!(found, length as u64);
                assert!(expected > found && expected <= bytes.len() as u64);
                assert_eq!(section == "header", length < 76);
            }
            other => panic!("cut at byte {length}: {other}"),
        }
    }
    let mut longer = bytes.to_vec();
    longer.push(0);
    let error = CompressedClip::decode(longer).unwrap_err();
    let (expected, found) = (bytes.len() as u64, bytes.len() as u64 + 1);
    assert_eq!(error, ClipError::TooLong { expected, found });
}

#[test]
fn any_changed_byte_is_an_error() {
    let clip = small();
    let mut bytes = clip.as_bytes().to_vec();
    for at in 0..bytes.len() {
        for change in [1, 0x80, 0xff] {
            bytes[at] ^= change;
            let error = CompressedClip::decode(bytes.clone()).unwrap_err();
            match error {
                ClipError::NotAClip => assert!(at < 8),
                ClipError::Checksum { .. } => assert!(at >= 8),
                other => panic!("byte {at} changed by {change}: {other}"),
            }
            bytes[at] ^= change;
        }
    }
}

/// Puts right the checksums of the header and of the sections.
fn sealed(mut bytes: Vec<u8>) -> Vec<u8> {
    let sum = crc32fast::hash(&bytes[..72]).to_le_bytes();
    bytes[72..76].copy_from_slice(&sum);
    let mut begin = 76usize;
    for place in [28, 32, 36] {
        let length = u32::from_le_bytes(bytes[place..place + 4].try_into().unwrap()) as usize;
        let Some(end) = begin
            .checked_add(length)
            .filter(|end| end + 4 <= bytes.len())
        else {
            break;
        };
        let sum = crc32fast::hash(&bytes[begin..end]).to_le_bytes();
        bytes[end..end + 4].copy_from_slice(&sum);
        begin = end + 4;
    }
    bytes
}

#[test]
fn a_whole_file_of_another_version_or_with_impossible_numbers_is_an_error() {
    let clip = small();
    let with = |at: usize, number: [u8; 4]| {
        let mut bytes = clip.as_bytes().to_vec();
        bytes[at..at + 4].copy_from_slice(&number);
        CompressedClip::decode(sealed(bytes))
            .unwrap_err()
            .to_string()
    };
    assert_eq!(
        with(8, 2u32.to_le_bytes()),
        "the clip has version 2 of the format, and this program reads version 1"
    );
    assert_eq!(
        with(12, [0; 4]),
        "the clip is invalid: the number of joints is 0"
    );
    assert_eq!(
        with(16, [0; 4]),
        "the clip is invalid: the number of frames is 0"
    );
    // More joints, frames, tracks and bounds than the bytes hold: nothing is allocated for them.
    for at in [12, 16, 20, 24] {
        let message = with(at, [0xff; 4]);
        assert!(message.starts_with("the clip is invalid: "), "{message}");
    }
    let message = with(28, [0xff; 4]);
    assert!(
        message.starts_with("the file ends in its names: "),
        "{message}"
    );
    // Not a number for the time of a frame, and for the tolerance.
    for at in [44, 52] {
        let message = with(at, [0, 0, 0xf8, 0x7f]);
        assert!(message.starts_with("the clip is invalid: "), "{message}");
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(400))]

    #[test]
    fn a_sealed_file_never_panics_and_never_yields_nan(
        damage in proptest::collection::vec((any::<prop::sample::Index>(), any::<u8>()), 1..6),
    ) {
        let mut bytes = small_bytes().to_vec();
        for (place, byte) in damage {
            let place = place.index(bytes.len());
            bytes[place] = byte;
        }
        if let Ok(clip) = CompressedClip::decode(sealed(bytes)) {
            let mut sampler = ga_anim::clip::compressed::Sampler::new(&clip);
            for time in [0.0, 0.1, 0.205, 1e9] {
                sampler.sample(time);
                for rotor in sampler.rotors() {
                    prop_assert!(rotor.scalar().is_finite() && rotor.e12().is_finite());
                }
                for place in sampler.translations() {
                    prop_assert!(place.coordinates().iter().all(|x| x.is_finite()));
                }
            }
        }
    }
}

fn small_bytes() -> &'static [u8] {
    static BYTES: std::sync::LazyLock<Vec<u8>> =
        std::sync::LazyLock::new(|| small().as_bytes().to_vec());
    &BYTES
}
