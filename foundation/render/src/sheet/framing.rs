//! The position of the camera for each frame.

use super::options::Framing;
use super::{Frame, Options, SheetError};
use crate::resolve::KEY_TANGENT;
use crate::shade::WorldLighting;
use crate::{Ground, RenderError, Vector, View};

/// The views of the frames, and the ground they all see.
pub(super) struct Stage {
    pub(super) views: Vec<View>,
    pub(super) ground: Ground,
}

/// Narrow, so that limbs towards the camera are not enlarged.
const FIELD_OF_VIEW: f64 = 0.45;

/// Free border, as a fraction of half the picture.
const MARGIN: f64 = 0.1;

/// The part of a frame that decides on its camera: the place that the camera follows, and points
/// relative to it.
pub(super) struct Outline {
    middle: [f64; 3],
    points: Vec<[f64; 3]>,
}

impl Outline {
    /// All points of a frame.
    pub(super) fn new(frame: &Frame, options: &Options) -> Result<Self, SheetError> {
        check(frame)?;
        let middle = match options.framing {
            Framing::Fixed => [0.0; 3],
            Framing::Following => level_middle(frame),
        };
        let relative = |p: [f64; 3]| std::array::from_fn(|axis| p[axis] - middle[axis]);
        Ok(Self {
            middle,
            points: points(frame).map(relative).collect(),
        })
    }

    /// The few points that alone give the same camera: those that lie farthest out towards each
    /// side of the picture, nearest and farthest, highest and lowest; and those whose shadows do.
    pub(super) fn reduced(self, options: &Options) -> Self {
        let (backward, right) = (options.view.towards_camera(), options.view.right());
        let up = backward.cross(right);
        let tangent = (0.5 * FIELD_OF_VIEW).tan() * (1.0 - MARGIN);
        let (across, along) = (tangent * options.style.aspect(), tangent);
        let sides = [
            right + backward * across,
            backward * across - right,
            up + backward * along,
            backward * along - up,
            backward,
            -backward,
        ];
        let mut directions = vec![Vector::Y, -Vector::Y];
        directions.extend(sides);
        if let Some(light) = towards_key_light(options) {
            // The shadow p − (p·y − h) l / l·y, widened by s (p·y − h) along x and z, is as far
            // along n as p is along n + (s |n·x| + s |n·z| − n·l / l·y) y, but for a constant.
            directions.extend(sides.map(|side| {
                let widening = SOFTNESS * (side.e1.abs() + side.e3.abs());
                side + Vector::Y * (widening - side.dot(light) / light.e2)
            }));
        }
        let farthest = directions.into_iter().filter_map(|direction| {
            let along = |p: &[f64; 3]| direction.dot(Vector::from(*p));
            let order = |p: &&[f64; 3], q: &&[f64; 3]| along(p).total_cmp(&along(q));
            self.points.iter().max_by(order).copied()
        });
        Self {
            middle: self.middle,
            points: farthest.collect(),
        }
    }
}

impl Stage {
    pub(super) fn new(frames: &[Outline], options: &Options) -> Result<Self, SheetError> {
        let seen = frames.iter().flat_map(|frame| frame.points.iter().copied());
        let (mut lowest, mut highest) = (f64::INFINITY, f64::NEG_INFINITY);
        for [_, y, _] in seen.clone() {
            lowest = lowest.min(y);
            highest = highest.max(y);
        }
        let extent = Some(highest - lowest).filter(|&extent| extent > 0.0);

        let ground = options.ground.unwrap_or(lowest);
        let towards_light = towards_key_light(options);
        let shadows = seen
            .clone()
            .filter_map(|p| shadow_of(p, ground, towards_light?))
            .flatten();
        let view = View::fit(
            seen.chain(shadows),
            options.view,
            FIELD_OF_VIEW,
            options.style.aspect(),
            MARGIN,
        )?;
        Ok(Self {
            views: frames
                .iter()
                .map(|frame| view.moved_by(frame.middle))
                .collect(),
            ground: Ground {
                height: ground,
                grid: options
                    .grid
                    .unwrap_or_else(|| round_number(extent.unwrap_or(1.0) / 3.0)),
            },
        })
    }
}

/// The direction towards the light whose shadow is drawn, if one is.
fn towards_key_light(options: &Options) -> Option<Vector> {
    let backward = options.view.towards_camera();
    let right = options.view.right();
    let lighting = WorldLighting::new(&options.style.lighting, -backward, right)?;
    (options.style.shadow > 0.0).then(|| lighting.towards_key())
}

/// The shadow of a point on the ground with its soft edge, as the corners of a level square, unless
/// the light stands too low for a picture to hold it: the shadow would be longer than twice the
/// height of the point.
fn shadow_of(point: [f64; 3], ground: f64, towards_light: Vector) -> Option<[[f64; 3]; 4]> {
    let point = Vector::from(point);
    let level = towards_light.e1.hypot(towards_light.e3);
    let height = point.e2 - ground;
    if !(towards_light.e2 > 0.5 * level && height > 0.0) {
        return None;
    }
    let middle = point - towards_light * (height / towards_light.e2);
    let reach = SOFTNESS * height;
    let corners = [[-1.0, -1.0], [1.0, -1.0], [1.0, 1.0], [-1.0, 1.0]];
    Some(corners.map(|[x, z]| (middle + Vector::new(x, 0.0, z) * reach).coordinates()))
}

/// How far the soft edge of a shadow reaches, as a share of the height of what casts it.
const SOFTNESS: f64 = 2.0 * KEY_TANGENT;

fn points<'a>(frame: &Frame<'a>) -> impl Iterator<Item = [f64; 3]> + Clone + use<'a> {
    let (positions, bones) = (frame.positions, frame.bones);
    positions
        .iter()
        .copied()
        .chain(bones.iter().flatten().copied())
}

/// Checked here to report the frame's number, which the renderer does not know.
fn check(frame: &Frame) -> Result<(), SheetError> {
    let finite = |p: &[f64; 3]| p.iter().all(|c| c.is_finite());
    let source = match frame.positions.iter().position(|p| !finite(p)) {
        Some(vertex) => RenderError::Position { object: 0, vertex },
        None => match frame.bones.iter().position(|ends| !ends.iter().all(finite)) {
            Some(bone) => RenderError::Bone { bone },
            None => return Ok(()),
        },
    };
    Err(SheetError::Frame {
        number: frame.caption.number,
        source,
    })
}

/// The mean of a frame's points, at height 0. (The middle of its bounds would sway with every swing
/// of an arm.)
fn level_middle(frame: &Frame) -> [f64; 3] {
    let (mut x, mut z, mut count) = (0.0, 0.0, 0.0f64);
    for point in points(frame) {
        x += point[0];
        z += point[2];
        count += 1.0;
    }
    [x / count.max(1.0), 0.0, z / count.max(1.0)]
}

/// The greatest of 1, 2 and 5 times a power of ten that is not above `x`.
fn round_number(x: f64) -> f64 {
    let power = 10f64.powf(x.log10().floor());
    let factor = [5.0, 2.0]
        .into_iter()
        .find(|f| f * power <= x * (1.0 + 1e-9));
    factor.unwrap_or(1.0) * power
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::sheet::Caption;

    #[test]
    fn round_numbers() {
        for (x, rounded) in [
            (0.45, 0.2),
            (0.5, 0.5),
            (4.99, 2.0),
            (1.0, 1.0),
            (73.0, 50.0),
        ] {
            assert!((round_number(x) - rounded).abs() < 1e-12 * rounded, "{x}");
        }
    }

    /// Points of a ball, of which the reduced outlines keep a few.
    #[test]
    fn the_outermost_points_give_the_same_cameras() {
        for framing in [Framing::Fixed, Framing::Following] {
            let options = Options {
                framing,
                ..Options::default()
            };
            let ball = |frame: usize| -> Vec<[f64; 3]> {
                let point = |k: usize| {
                    let (k, frame) = (k as f64, frame as f64);
                    let [x, y, z] = [0.7 * k, 1.9 * k, 3.1 * k].map(f64::sin);
                    [x + 0.3 * frame, y + (2.0 * frame).sin(), z - 0.2 * frame]
                };
                (0..500).map(point).collect()
            };
            let balls: Vec<_> = (0..3).map(ball).collect();
            let outline = |number: usize| {
                let frame = Frame {
                    caption: Caption::new(number),
                    positions: &balls[number],
                    bones: &[],
                };
                Outline::new(&frame, &options).unwrap()
            };
            let whole: Vec<_> = (0..3).map(outline).collect();
            let reduced = (0..3).map(|number| outline(number).reduced(&options));
            let reduced: Vec<_> = reduced.collect();
            assert!(reduced.iter().all(|outline| outline.points.len() < 20));
            let [whole, reduced] =
                [whole, reduced].map(|outlines| Stage::new(&outlines, &options).unwrap());
            assert_eq!(whole.views, reduced.views);
            assert_eq!(whole.ground.height, reduced.ground.height);
        }
    }
}
