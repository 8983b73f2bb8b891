//! The data from which the script draws a motion. Places are three whole numbers of tenths of
//! millimetres, one after the other.

use ga_runtime::vga3::Vector;
use serde::Serialize;

use super::check::poses;
use super::model::{Motion, MotionCamera, MotionFilm, Side};
use crate::camera::Camera;
use crate::colour::Colour;
use crate::view::{Up, View};

/// Tenths of millimetres in a metre.
const UNITS: f64 = 1e4;
/// The distance between the lines on the floor, in metres.
const STEP: f64 = 0.5;
/// The largest number of steps along a side of the floor; a larger floor has longer steps.
const MOST_STEPS: f64 = 60.0;
/// The radius in metres to which a smaller figure is shown.
const LEAST_RADIUS: f64 = 0.3;
/// The part of the canvas that the figure fills.
const FILLING: f64 = 0.92;
/// How far to the side of the first camera the eye is at first, in degrees.
const ASIDE: f64 = 25.0;

/// The data of a motion.
#[derive(Debug, Serialize)]
pub(super) struct Data<'a> {
    pub(super) rate: f64,
    pub(super) names: &'a [String],
    /// For each bone its ends and its side.
    pub(super) bones: Vec<[usize; 3]>,
    /// The colours of the sides.
    pub(super) colours: [Colour; 3],
    /// For each frame the index of its pose.
    pub(super) frames: Vec<Option<usize>>,
    /// The points of all poses.
    pub(super) points: Vec<i32>,
    /// The ends of the lines on the floor.
    pub(super) floor: Vec<i32>,
    /// The distance between them in metres.
    #[serde(skip)]
    pub(super) step: f64,
    pub(super) cameras: Vec<Pyramid<'a>>,
    pub(super) films: Vec<Film<'a>>,
    /// The middle of the figure.
    pub(super) middle: [i32; 3],
    /// The radius about the middle that contains everything, which is the unit of the camera.
    pub(super) radius: f64,
    /// The number of pixels of the radius for each pixel of the canvas's shorter side.
    pub(super) scale: f64,
    pub(super) azimuth: f64,
    pub(super) elevation: f64,
    pub(super) axes: [[f64; 3]; 3],
}

/// A camera.
#[derive(Debug, Serialize)]
pub(super) struct Pyramid<'a> {
    pub(super) name: &'a str,
    /// The ends of its edges; the first end is the tip.
    pub(super) lines: Vec<i32>,
}

/// A film.
#[derive(Debug, Serialize)]
pub(super) struct Film<'a> {
    pub(super) name: &'a str,
    pub(super) size: [u32; 2],
    pub(super) pictures: Vec<Still>,
}

/// A picture of a film, which is shown from the frame `start` until before the frame `end`.
#[derive(Debug, Serialize)]
pub(super) struct Still {
    pub(super) start: usize,
    pub(super) end: usize,
    pub(super) source: String,
}

impl<'a> Data<'a> {
    /// The data of a motion that has been checked.
    pub(super) fn of(motion: &'a Motion) -> Self {
        let places = || poses(motion).flat_map(|(_, pose)| pose);
        let [low, high] = extent(places());
        let middle = [0, 1, 2].map(|k| f64::midpoint(low[k], high[k]));
        let (floor, step) = floor(motion.floor, low, high);
        let farthest = |places: &mut dyn Iterator<Item = &[f64; 3]>| {
            places.fold(LEAST_RADIUS, |most, place| {
                most.max(distance(*place, middle))
            })
        };
        let reach = farthest(&mut places());
        let cameras = || motion.cameras.iter();
        let seen =
            cameras().flat_map(|camera| std::iter::once(&camera.centre).chain(&camera.corners));
        let whole = farthest(&mut places().chain(&floor).chain(seen));
        let aside = cameras().next().map(|camera| {
            let [x, _, z] = [0, 1, 2].map(|k| camera.centre[k] - middle[k]);
            x.atan2(z).to_degrees().round() + ASIDE
        });
        let view = View::default();
        let mut pose = 0..;
        Self {
            rate: motion.frames_per_second,
            names: &motion.names,
            bones: motion
                .bones
                .iter()
                .map(|bone| [bone.ends[0], bone.ends[1], bone.side as usize])
                .collect(),
            colours: Side::ALL.map(Side::colour),
            frames: motion
                .frames
                .iter()
                .map(|frame| frame.as_ref().and_then(|_| pose.next()))
                .collect(),
            points: units(places()),
            floor: units(&floor),
            step,
            cameras: cameras().map(pyramid).collect(),
            films: motion.films.iter().map(film).collect(),
            middle: middle.map(unit),
            radius: (UNITS * whole).round(),
            // The camera has the scene's radius as its unit.
            scale: (1e5 * FILLING / 2.0 * whole / reach).round() / 1e5,
            azimuth: aside.unwrap_or(view.azimuth),
            elevation: view.elevation,
            axes: Up::Y.axes().map(<[f64; 3]>::from),
        }
    }

    /// The first frame with a pose.
    pub(super) fn first(&self) -> usize {
        let known = self.frames.iter().position(Option::is_some);
        known.unwrap_or_default()
    }

    /// The camera of a canvas of some size at first, for points from [`place`](Self::place).
    pub(super) fn camera(&self, [width, height]: [f64; 2]) -> Camera {
        let mut camera = Camera::new(&View {
            azimuth: self.azimuth,
            elevation: self.elevation,
            up: Up::Y,
            ..View::default()
        });
        camera.scale = self.scale * width.min(height);
        camera.middle = [width / 2.0, height / 2.0];
        camera
    }

    /// A place for the camera from the three numbers that are written.
    pub(super) fn place(&self, numbers: &[i32]) -> Vector<f64> {
        let number = |k: usize| f64::from(numbers[k]) - f64::from(self.middle[k]);
        Vector::from([0, 1, 2].map(|k| number(k) / self.radius))
    }
}

fn unit(metres: f64) -> i32 {
    (UNITS * metres).round() as i32
}

fn units<'p>(places: impl IntoIterator<Item = &'p [f64; 3]>) -> Vec<i32> {
    places.into_iter().flatten().map(|&x| unit(x)).collect()
}

/// The corners of the box that contains places.
fn extent<'p>(places: impl Iterator<Item = &'p [f64; 3]>) -> [[f64; 3]; 2] {
    let start = [[f64::INFINITY; 3], [f64::NEG_INFINITY; 3]];
    places.fold(start, |[low, high], place| {
        let of = |choose: fn(f64, f64) -> f64, bound: [f64; 3]| {
            [0, 1, 2].map(|k| choose(bound[k], place[k]))
        };
        [of(f64::min, low), of(f64::max, high)]
    })
}

fn distance(a: [f64; 3], b: [f64; 3]) -> f64 {
    let squares = a.into_iter().zip(b).map(|(a, b)| (a - b).powi(2));
    squares.sum::<f64>().sqrt()
}

/// The ends of the lines on the floor below a box, and the distance between them.
fn floor(height: Option<f64>, low: [f64; 3], high: [f64; 3]) -> (Vec<[f64; 3]>, f64) {
    let Some(height) = height else {
        return (vec![], STEP);
    };
    let size = (high[0] - low[0]).max(high[2] - low[2]);
    let mut step = STEP;
    while size / step > MOST_STEPS {
        step *= 2.0;
    }
    let range = |k: usize| [(low[k] / step).floor() - 1.0, (high[k] / step).ceil() + 1.0];
    let [[x, x_end], [z, z_end]] = [range(0), range(2)];
    let mut ends = Vec::new();
    for k in 0..=(x_end - x) as usize {
        let x = x + k as f64;
        ends.extend([[x, z], [x, z_end]]);
    }
    for k in 0..=(z_end - z) as usize {
        let z = z + k as f64;
        ends.extend([[x, z], [x_end, z]]);
    }
    let place = |[x, z]: [f64; 2]| [step * x, height, step * z];
    (ends.into_iter().map(place).collect(), step)
}

fn pyramid(camera: &MotionCamera) -> Pyramid<'_> {
    let MotionCamera {
        name,
        centre,
        corners,
    } = camera;
    let sides = corners.iter().flat_map(|corner| [centre, corner]);
    let base = (0..4).flat_map(|k| [&corners[k], &corners[(k + 1) % 4]]);
    Pyramid {
        name,
        lines: units(sides.chain(base)),
    }
}

fn film(film: &MotionFilm) -> Film<'_> {
    let still = film.pictures.iter().map(|picture| Still {
        start: picture.frames.start,
        end: picture.frames.end,
        source: picture.encoding.address(&picture.bytes),
    });
    Film {
        name: &film.name,
        size: film.size,
        pictures: still.collect(),
    }
}
