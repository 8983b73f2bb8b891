//! How views stand to each other in space and time, by the joints of a person that they show.
//!
//! A calibration that is wrong and films that do not begin together are what fails first, and
//! nothing else shows it: the rays of a joint then miss each other. Small rotations of the cameras
//! and the times by which views are late are found together, as the least sum of
//!
//! ```text
//! Σ ρ( |π_v(exp(G_v) M_v x ~M_v exp(−G_v)) − u_v − d_v u̇_v| / σ )
//! ```
//!
//! over all views v that show a joint at the point x, which is free, with the twist G and the
//! offset d of the view, in frames, the pixel u and its velocity u̇ (bundle adjustment: B. Triggs
//! et al., "Bundle adjustment – a modern synthesis", 2000). No body and no smoothness is assumed.
//! How many of the errors are independent follows from how long they last. Rotations and
//! displacements stay near to what the calibration says, within deviations that are given; all
//! displacements together do not change the size of the rig, which joints do not show.

mod board;
mod bundle;
mod correlation;
mod motion;
mod offsets;
mod options;
mod resampling;
mod shrinkage;

use ga_camera::Camera;
use ga_runtime::vga3::Vector;

use crate::Observation;
use crate::gap::noise;
pub(crate) use board::{is_upside_down, other_poses};
use bundle::Bundle;
use motion::{Motion, OFFSET, SIZE, UNKNOWN, all_moved, without_offset};
pub use options::RegistrationOptions;
pub(crate) use resampling::resampled;

/// How a view stands to the others.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RegisteredView {
    /// The rotation of the camera about its centre from where it was said to be, as a vector in
    /// the axes of the camera, in radians.
    pub rotation: [f64; 3],
    /// The standard deviation of a coordinate of it.
    pub rotation_deviation: f64,
    /// The displacement of its centre in the world, in metres.
    pub displacement: [f64; 3],
    /// The number of the frame of this view that shows what frame 0 of the first view shows.
    pub offset_frames: f64,
    /// The standard deviation of this number; 0 for the first view, and infinite where the motion
    /// does not show it, or where it is at the limit of the search.
    pub offset_deviation: f64,
    /// Whether the number is at the limit of the search, so that the true one may be beyond it. The
    /// camera is then where it was said to be: what a view shows at a wrong time says nothing of
    /// it.
    pub is_offset_at_limit: bool,
}

/// How views stand to each other.
#[derive(Clone, Debug, PartialEq)]
pub struct Registration {
    /// One for each view.
    pub views: Vec<RegisteredView>,
    /// The cameras where they are.
    pub cameras: Vec<Camera>,
}

impl RegisteredView {
    /// The offset in frames; 0 where the motion does not show it, or it is at the limit.
    #[must_use]
    pub fn known_offset(&self) -> f64 {
        match self.offset_deviation.is_finite() {
            true => self.offset_frames,
            false => 0.0,
        }
    }

    /// The angle of the rotation in radians.
    #[must_use]
    pub fn angle(&self) -> f64 {
        let [x, y, z] = self.rotation;
        (x * x + y * y + z * z).sqrt()
    }
}

/// How often velocities are taken anew.
const ROUNDS: usize = 6;
/// Offsets are found where they change by less than this, in frames.
const SETTLED: f64 = 0.02;
/// Cameras are found where no coordinate of their motions changes by more, in radians and metres.
const STILL: f64 = 2e-4;
/// How far an offset changes in a round at most, in frames: velocities are those of straight lines.
const FARTHEST: f64 = 2.0;

/// How views stand to each other. `None` for one view, and where too little is seen by two views.
pub(crate) fn register(
    cameras: &[Camera],
    observations: &[Observation],
    options: &RegistrationOptions,
) -> Option<Registration> {
    if cameras.len() < 2 {
        return None;
    }
    let scale = noise(cameras, observations)?;
    let coarse = offsets::whole(cameras, observations, options.most_frames, scale);
    let mut offsets: Vec<f64> = coarse.iter().map(|frames| *frames as f64).collect();
    let mut motions = vec![[0.0; SIZE]; cameras.len()];
    let most = options.most_frames as f64;
    for round in 1..=ROUNDS {
        let shifted = resampled(observations, &offsets);
        let placed = all_moved(cameras, &motions);
        let scale = noise(&placed, &shifted)?;
        let lasting = correlation::time(&placed, &shifted, scale);
        let bundle = Bundle::new(cameras, &motions, &shifted, options, scale * lasting.sqrt());
        let found = bundle.adjusted(round > 1)?;
        let changes = || found.iter().map(|motion| motion[OFFSET]);
        let moved = found.iter().zip(&motions).flat_map(|(now, before)| {
            let coordinates = now.iter().zip(before).take(OFFSET);
            coordinates.map(|(now, before)| (now - before).abs())
        });
        // Wrong cameras look like errors that last, so that these are measured once more.
        let is_settled =
            changes().all(|change| change.abs() < SETTLED) && moved.fold(0.0, f64::max) < STILL;
        for (offset, change) in offsets.iter_mut().zip(changes()) {
            *offset = (*offset + change.clamp(-FARTHEST, FARTHEST)).clamp(-most, most);
        }
        motions = found.iter().map(|motion| without_offset(*motion)).collect();
        if is_settled || round == ROUNDS {
            let limit = offsets::limit(observations.len(), options.most_frames);
            let is_at_limit = |view: &usize| {
                let (offset, coarse) = (offsets[*view].abs(), coarse[*view].abs());
                limit > 0 && (coarse == limit || offset > limit as f64 - 0.5)
            };
            let at_limit: Vec<usize> = (0..cameras.len()).filter(is_at_limit).collect();
            if !at_limit.is_empty() {
                return without(cameras, observations, options, &at_limit, &offsets);
            }
            let (motions, deviations) = shrinkage::shrunk(&bundle, &found, options)?;
            return Some(registration(cameras, &motions, &deviations, &offsets));
        }
    }
    None
}

/// How views stand to each other, of which some have offsets at the limit of the search: the others
/// by themselves.
fn without(
    cameras: &[Camera],
    observations: &[Observation],
    options: &RegistrationOptions,
    at_limit: &[usize],
    offsets: &[f64],
) -> Option<Registration> {
    let mut others = observations.to_vec();
    for observation in &mut others {
        for &view in at_limit {
            observation.views[view].fill(None);
        }
    }
    let mut found = register(cameras, &others, options).unwrap_or_else(|| {
        // Nothing is known of one view alone.
        let mut deviations = [options.rotation; SIZE];
        deviations[OFFSET] = f64::INFINITY;
        let [still, deviations] = [[0.0; SIZE], deviations].map(|own| vec![own; cameras.len()]);
        registration(cameras, &still, &deviations, offsets)
    });
    for &view in at_limit {
        let own = &mut found.views[view];
        own.is_offset_at_limit = true;
        own.offset_frames = offsets[view];
        own.offset_deviation = f64::INFINITY;
    }
    Some(found)
}

fn registration(
    cameras: &[Camera],
    motions: &[Motion],
    deviations: &[Motion],
    offsets: &[f64],
) -> Registration {
    let moved = all_moved(cameras, motions);
    let views = (0..cameras.len()).map(|view| {
        let [x, y, z, ..] = motions[view];
        let [to, from] = [&moved[view], &cameras[view]].map(|c| Vector::from(c.centre()));
        RegisteredView {
            rotation: [x, y, z],
            rotation_deviation: deviations[view][..3].iter().copied().fold(0.0, f64::max),
            displacement: (to - from).into(),
            offset_frames: if view == 0 { 0.0 } else { offsets[view] },
            offset_deviation: match deviations[view][OFFSET] {
                _ if view == 0 => 0.0,
                known if known < UNKNOWN => known,
                _ => f64::INFINITY,
            },
            is_offset_at_limit: false,
        }
    });
    Registration {
        views: views.collect(),
        cameras: moved,
    }
}

#[cfg(test)]
mod tests {
    use ga_camera::Intrinsics;
    use ga_runtime::cga3::Point;
    use rand_chacha::ChaCha8Rng;
    use rand_chacha::rand_core::{Rng, SeedableRng};

    use super::motion::moved_by;
    use super::*;
    use crate::JointPixel;

    const POINTS: usize = 17;
    const FRAMES: usize = 150;
    const NOISE: f64 = 2.0;

    struct Random(ChaCha8Rng);

    impl Random {
        fn uniform(&mut self) -> f64 {
            f64::from(self.0.next_u32()) / 2.0_f64.powi(32)
        }

        /// Nearly Gaussian, with the variance 1.
        fn normal(&mut self) -> f64 {
            (0..12).map(|_| self.uniform()).sum::<f64>() - 6.0
        }
    }

    /// Points of a body that walks on the spot: each on an ellipse of its own.
    fn place(point: usize, time: f64, phases: &[[f64; 3]]) -> Point<f64> {
        let wave = |k: usize| (time / 9.0 + phases[point][k]).sin();
        let height = 0.12 * point as f64;
        Point::new(0.2 * wave(0), height + 0.1 * wave(1), 0.25 * wave(2))
    }

    fn cameras(count: usize) -> Vec<Camera> {
        let intrinsics = Intrinsics::new([1400.0; 2], [960.0, 540.0]).unwrap();
        let up = [0.0, 1.0, 0.0];
        let around = (0..count).map(|k| {
            let angle = 0.9 * k as f64;
            let eye = Point::new(4.0 * angle.sin(), 1.2 + 0.3 * k as f64, 4.0 * angle.cos());
            Camera::look_at(intrinsics, eye, Point::new(0.0, 0.8, 0.0), up).unwrap()
        });
        around.collect()
    }

    fn seen(cameras: &[Camera], offsets: &[f64], random: &mut Random) -> Vec<Observation> {
        let phases = (0..POINTS).map(|_| [0; 3].map(|_| 6.3 * random.uniform()));
        let phases: Vec<[f64; 3]> = phases.collect();
        let frames = (0..FRAMES).map(|frame| Observation {
            views: cameras
                .iter()
                .zip(offsets)
                .map(|(camera, offset)| {
                    let points = (0..POINTS).map(|point| {
                        let at = place(point, frame as f64 - offset, &phases);
                        let pixel = camera.project(at).unwrap();
                        Some(JointPixel {
                            position: pixel.map(|x| x + NOISE * random.normal()),
                            deviation: 2.0,
                        })
                    });
                    points.collect()
                })
                .collect(),
        });
        frames.collect()
    }

    #[test]
    fn offsets_and_rotations_come_back() {
        for (seed, count, offsets) in [
            (0, 3, vec![0.0, 3.4, -5.0]),
            (1, 2, vec![0.0, -2.7]),
            (2, 4, vec![0.0, 0.0, 1.5, 4.8]),
        ] {
            let random = &mut Random(ChaCha8Rng::seed_from_u64(seed));
            let true_cameras = cameras(count);
            let observations = seen(&true_cameras, &offsets, random);
            // The calibration is wrong by a rotation of up to one degree.
            let turned = true_cameras.iter().map(|camera| {
                let axis = [0; 3].map(|_| random.normal());
                let length = axis.iter().map(|x| x * x).sum::<f64>().sqrt();
                let angle = random.uniform().to_radians();
                let [x, y, z] = axis.map(|x| x * angle / length);
                moved_by(camera, &[x, y, z, 0.0, 0.0, 0.0, 0.0])
            });
            let turned: Vec<Camera> = turned.collect();
            let options = RegistrationOptions::default();
            let found = register(&turned, &observations, &options).unwrap();
            for (view, (found, offset)) in found.views.iter().zip(&offsets).enumerate() {
                let error = (found.offset_frames - offset).abs();
                assert!(
                    error < 0.2,
                    "{seed} {view}: {found:?}, and {offset} is true"
                );
            }
            let found_views = &found.views;
            // All cameras together may follow the body to one side, which hardly shows.
            for (view, (found, truth)) in found.cameras.iter().zip(&true_cameras).enumerate() {
                let way = truth.world_to_camera.rotor() * found.world_to_camera.rotor().reverse();
                let angle = crate::chain::rotation_vector(way).length().to_degrees();
                let deviation = found_views[view].rotation_deviation.to_degrees();
                assert!(
                    angle < 4.0 * deviation && deviation < 0.3,
                    "{seed} {view}: {angle}°"
                );
            }
            let together = resampled(&observations, &offsets);
            let [before, after, best] = [&turned, &found.cameras, &true_cameras]
                .map(|cameras| noise(cameras, &together).unwrap());
            assert!(
                after < 1.02 * best && before > 1.3 * best,
                "{before} {after} {best}"
            );
        }
    }

    /// Errors that wrong cameras make last over the whole clip, and those of the detector do not.
    #[test]
    fn rotations_of_four_cameras_come_back_to_a_tenth_of_a_degree() {
        let mut errors = Vec::new();
        for seed in 10..13 {
            let random = &mut Random(ChaCha8Rng::seed_from_u64(seed));
            let right = cameras(4);
            let observations = seen(&right, &[0.0; 4], random);
            let turned = right.iter().map(|camera| {
                let [x, y, z] = [0; 3].map(|_| (1.2 * random.uniform() - 0.6).to_radians());
                moved_by(camera, &[x, y, z, 0.0, 0.0, 0.0, 0.0])
            });
            let turned: Vec<Camera> = turned.collect();
            let options = RegistrationOptions::default();
            let found = register(&turned, &observations, &options).unwrap();
            let beside_first = |cameras: &[Camera], view: usize| {
                let [own, first] = [view, 0].map(|k| cameras[k].world_to_camera.rotor());
                own * first.reverse()
            };
            errors.extend((1..4).map(|view| {
                let [own, truth] = [&found.cameras, &right].map(|c| beside_first(c, view));
                let way = own * truth.reverse();
                crate::chain::rotation_vector(way).length().to_degrees()
            }));
        }
        let mean = errors.iter().sum::<f64>() / errors.len() as f64;
        assert!(mean < 0.1, "{mean}°: {errors:?}");
    }

    #[test]
    fn offsets_at_the_limit_of_the_search_are_not_decided() {
        let random = &mut Random(ChaCha8Rng::seed_from_u64(4));
        let cameras = cameras(3);
        let observations = seen(&cameras, &[0.0, 3.0, 7.0], random);
        for (most, is_decided) in [(5, [true, true, false]), (9, [true; 3])] {
            let options = RegistrationOptions {
                most_frames: most,
                ..RegistrationOptions::default()
            };
            let found = register(&cameras, &observations, &options).unwrap();
            for (view, is_decided) in found.views.iter().zip(is_decided) {
                assert_eq!(view.is_offset_at_limit, !is_decided, "{most}: {view:?}");
                assert_eq!(
                    view.offset_deviation.is_finite(),
                    is_decided,
                    "{most}: {view:?}"
                );
            }
            let last = found.views[2];
            match is_decided[2] {
                true => assert!((last.known_offset() - 7.0).abs() < 0.2, "{last:?}"),
                false => assert!(
                    last.known_offset() == 0.0 && last.angle() < 1e-9,
                    "{last:?}"
                ),
            }
        }
    }

    #[test]
    fn what_is_right_is_left() {
        let random = &mut Random(ChaCha8Rng::seed_from_u64(3));
        let cameras = cameras(3);
        let observations = seen(&cameras, &[0.0; 3], random);
        let found = register(&cameras, &observations, &RegistrationOptions::default()).unwrap();
        for view in found.views {
            assert!(
                view.angle() < 4.0 * view.rotation_deviation.max(1e-5),
                "{view:?}"
            );
            assert!(
                view.offset_frames.abs() < 0.1 && view.displacement.iter().all(|x| x.abs() < 1e-8),
                "{view:?}"
            );
        }
        assert!(
            register(
                &cameras[..1],
                &observations,
                &RegistrationOptions::default()
            )
            .is_none()
        );
    }
}
