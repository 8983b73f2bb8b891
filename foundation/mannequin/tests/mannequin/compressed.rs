//! The walk as a compressed clip.

use ga_anim::clip::compressed::{Options, compress, error_at_skin, measure};
use ga_anim::recording::Recording;
use ga_mannequin::walk;

use crate::HUMAN;

#[test]
fn the_walk_keeps_its_bound_and_its_skin() {
    let clip = walk(6).resampled(30.0).unwrap();
    let recording = Recording::from_clip(&HUMAN.skeleton, &clip).unwrap();
    let compressed = compress(&recording, &Options::default(), |_, _| ()).unwrap();
    let measured = measure(&recording, &compressed).unwrap();
    assert!(measured.error <= 1e-4, "{}", measured.error);

    let raw = 40 * recording.frame_count() * recording.joints().len();
    let ratio = raw as f64 / (compressed.as_bytes().len() - compressed.name_bytes()) as f64;
    assert!(ratio >= 9.0, "{ratio}");

    // Vertices lie up to some shells away from the joints that move them.
    let positions = HUMAN.mesh.positions();
    let skin = error_at_skin(&recording, &compressed, positions, &HUMAN.weights).unwrap();
    assert!(skin > 0.0 && skin < 1e-3, "{skin}");
}
