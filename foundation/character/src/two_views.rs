//! The joints of the moving figure, observed by two cameras and triangulated from their pictures.

use ga_anim::character::Character;
use ga_anim::clip::Clip;
use ga_body::pose_error::mean_per_joint_position_error;
use ga_camera::observation::observe;
use ga_camera::rig::StereoRig;
use ga_camera::{Camera, Intrinsics};
use ga_runtime::cga3::Point;
use ga_runtime::vga3::Vector;
use serde::Serialize;

use crate::error::CharacterError;

/// A full-HD camera that sees 62° across.
const PICTURE: [f64; 2] = [1920.0, 1080.0];
const FOCAL_LENGTH: f64 = 1600.0;

/// The angle between the directions that the two cameras look from.
const ANGLE_DEGREES: f64 = 30.0;

/// The distance of the cameras as a multiple of the least distance at which they see everything.
const ROOM: f64 = 1.1;

/// What two cameras saw, and how accurately the joints were triangulated.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct TwoViews {
    /// Width and height of the pictures.
    pub picture_pixels: [f64; 2],
    /// The focal length of both cameras.
    pub focal_length_pixels: f64,
    /// How far the cameras are from each other.
    pub baseline_metres: f64,
    /// Where the left camera stands.
    pub left_camera_metres: [f64; 3],
    /// Where the right camera stands.
    pub right_camera_metres: [f64; 3],
    /// What both look at.
    pub target_metres: [f64; 3],
    /// The angle between their optical axes.
    pub angle_degrees: f64,
    /// Joints in all frames together.
    pub joints_seen: usize,
    /// What was found from exact pixels.
    pub noise_free: Found,
    /// What was found from pixels with a standard deviation of 1 pixel in both directions.
    pub one_pixel_noise: Found,
    /// What the noise was made from.
    pub seed: u64,
}

/// How accurately the joints were triangulated.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Found {
    /// The mean distance from a joint to where it was found (MPJPE).
    pub mean_per_joint_position_error_metres: f64,
    /// The greatest distance from a joint to where it was found.
    pub joint_position_error_max_metres: f64,
    /// The greatest distance between the two rays of a joint.
    pub ray_gap_max_metres: f64,
    /// Whether every joint was found in front of both cameras.
    pub all_in_front_of_both_cameras: bool,
    /// Whether every joint was seen inside both pictures.
    pub all_inside_both_pictures: bool,
}

impl TwoViews {
    /// Sees the joints of every frame, exactly and with a standard deviation of 1 pixel in both
    /// directions, and triangulates them. Equal seeds give equal noise.
    ///
    /// # Errors
    ///
    /// [`CharacterError::Skeleton`] for a clip of another skeleton; [`CharacterError::NoPlace`],
    /// [`CharacterError::Observation`] and [`CharacterError::Triangulation`] for motions that no
    /// two cameras see, such as one in a single point.
    pub fn new(character: &Character, clip: &Clip, seed: u64) -> Result<Self, CharacterError> {
        let mut joints: Vec<Point<f64>> = Vec::new();
        for pose in clip.frames() {
            joints.extend(character.joints(pose)?.into_iter().map(Point::from));
        }
        let places = joints.iter().map(|joint| Vector::from(*joint));
        let [low, high] = ga_mesh::bounds(places).unwrap_or_default();
        let target = ((low + high) * 0.5).coordinates();
        let rig = rig(&joints, target).ok_or(CharacterError::NoPlace)?;
        Ok(Self {
            picture_pixels: PICTURE,
            focal_length_pixels: FOCAL_LENGTH,
            baseline_metres: rig.baseline(),
            left_camera_metres: rig.left.centre().coordinates(),
            right_camera_metres: rig.right.centre().coordinates(),
            target_metres: target,
            angle_degrees: ANGLE_DEGREES,
            joints_seen: joints.len(),
            noise_free: Found::new(&rig, &joints, 0.0, seed)?,
            one_pixel_noise: Found::new(&rig, &joints, 1.0, seed)?,
            seed,
        })
    }
}

impl Found {
    fn new(
        rig: &StereoRig,
        joints: &[Point<f64>],
        noise: f64,
        seed: u64,
    ) -> Result<Self, CharacterError> {
        let failed = |camera| {
            move |error| CharacterError::Observation {
                camera,
                source: Box::new(error),
            }
        };
        let left = observe(&rig.left, joints, noise, seed).map_err(failed("left"))?;
        // Noise of its own for each camera.
        let right = observe(&rig.right, joints, noise, !seed).map_err(failed("right"))?;
        let seen = rig.triangulate_all(&left, &right);
        let seen = seen.map_err(|error| CharacterError::Triangulation(Box::new(error)))?;
        let places: Vec<Point<f64>> = seen.iter().map(|seen| seen.position).collect();
        let errors = joints.iter().zip(&places).map(|(a, b)| a.distance(*b));
        let is_inside = |pixel: &[f64; 2]| {
            let axes = pixel.iter().zip(PICTURE);
            // Pixel centres are whole numbers.
            axes.into_iter()
                .all(|(u, size)| (-0.5..size - 0.5).contains(u))
        };
        Ok(Self {
            mean_per_joint_position_error_metres: mean_per_joint_position_error(joints, &places)?,
            joint_position_error_max_metres: errors.fold(0.0, f64::max),
            ray_gap_max_metres: seen.iter().map(|seen| seen.gap).fold(0.0, f64::max),
            all_in_front_of_both_cameras: seen.iter().all(|seen| seen.is_in_front()),
            all_inside_both_pictures: left.iter().chain(&right).all(is_inside),
        })
    }
}

/// Two cameras that look at the middle from one height and one distance. A ball round the middle
/// that holds all points fits into both pictures, and the cameras stand where the points spread
/// across the picture rather than in depth.
fn rig(points: &[Point<f64>], target: [f64; 3]) -> Option<StereoRig> {
    let target = Point::from(target);
    let radius = points
        .iter()
        .map(|point| point.distance(target))
        .fold(0.0, f64::max);
    let half_height = (0.5 * PICTURE[1]).atan2(FOCAL_LENGTH);
    let distance = ROOM * radius / half_height.sin();

    let spread = |axis: usize| {
        let from_middle = points
            .iter()
            .map(|point| (point.coordinates()[axis] - target.coordinates()[axis]).abs());
        from_middle.fold(0.0, f64::max)
    };
    let across = if spread(0) < spread(2) {
        0.5 * std::f64::consts::PI
    } else {
        0.0
    };
    let principal = PICTURE.map(|size| 0.5 * (size - 1.0));
    let intrinsics = Intrinsics::new([FOCAL_LENGTH; 2], principal).ok()?;
    let camera = |aside: f64| {
        let (sin, cos) = (across + aside.to_radians()).sin_cos();
        let [x, y, z] = target.coordinates();
        let eye = Point::new(x + distance * sin, y, z + distance * cos);
        Camera::look_at(intrinsics, eye, target, [0.0, 1.0, 0.0])
    };
    Some(StereoRig {
        left: camera(-0.5 * ANGLE_DEGREES)?,
        right: camera(0.5 * ANGLE_DEGREES)?,
    })
}
