//! The corners of a tag to a small part of a pixel: where lines through its edges meet.
//!
//! The edge of a dark square lies where the brightness rises across it, at the mean place of the
//! gradient: for any blur that is the same to both sides that is where the sharp edge was.

use ga_image::interpolation::bilinear;
use ga_image::plane::Plane;
use ga_runtime::vga2::Vector;

/// The part of an edge at either end that is left out: the blur of the next edge reaches there.
const ENDS: f64 = 0.12;
/// The reach across an edge, in modules, and its bounds in pixels. The modules within the border,
/// and what is beside the margin of the tag, must stay outside.
const REACH: f64 = 0.45;
const REACH_PX: (f64, f64) = (1.2, 4.0);
/// The step across an edge, in pixels.
const STEP: f64 = 0.25;
/// The greatest way of a corner from where it was, in modules.
const GREATEST_WAY: f64 = 1.0;
const PASSES: usize = 3;

/// The distance of two pixels.
pub(super) fn distance(a: [f64; 2], b: [f64; 2]) -> f64 {
    (a[0] - b[0]).hypot(a[1] - b[1])
}

/// The lengths of the edges of a polygon, the first of which begins at the first corner.
pub(super) fn lengths(corners: &[[f64; 2]; 4]) -> [f64; 4] {
    [0, 1, 2, 3].map(|k| distance(corners[k], corners[(k + 1) % 4]))
}

/// The corners of a dark quadrangle, clockwise or anticlockwise, moved to where its edges meet.
/// `None` where the edges are not seen or are elsewhere.
pub(super) fn refined(
    levels: &Plane<f32>,
    corners: [[f64; 2]; 4],
    module: f64,
) -> Option<[[f64; 2]; 4]> {
    let reach = (REACH * module).clamp(REACH_PX.0, REACH_PX.1);
    let mut now = corners.map(Vector::from);
    for _ in 0..PASSES {
        let centre = (now[0] + now[1] + now[2] + now[3]) * 0.25;
        let lines = [0, 1, 2, 3].map(|k| line(levels, [now[k], now[(k + 1) % 4]], centre, reach));
        let [Some(a), Some(b), Some(c), Some(d)] = lines else {
            return None;
        };
        now = [meet(d, a)?, meet(a, b)?, meet(b, c)?, meet(c, d)?];
    }
    let stays =
        |k: usize| (now[k] - Vector::from(corners[k])).length() <= GREATEST_WAY * module.max(2.0);
    (0..4).all(stays).then(|| now.map(Vector::coordinates))
}

/// A point of a line and its direction.
type Line = [Vector<f64>; 2];

/// The line through an edge, by least squares of the distances of where it is seen.
fn line(
    levels: &Plane<f32>,
    [from, to]: [Vector<f64>; 2],
    centre: Vector<f64>,
    reach: f64,
) -> Option<Line> {
    let along = to - from;
    let length = along.length();
    let mut outwards = Vector::new(-along.e2, along.e1) * (1.0 / length);
    if (outwards | ((from + to) * 0.5 - centre)) < 0.0 {
        outwards = -outwards;
    }
    let count = ((length * (1.0 - 2.0 * ENDS)) as usize).clamp(4, 200);
    let mut points = Vec::with_capacity(count);
    for index in 0..count {
        let share = ENDS + (1.0 - 2.0 * ENDS) * (index as f64 + 0.5) / count as f64;
        if let Some((place, weight)) = rise(levels, from + along * share, outwards, reach) {
            points.push((place, weight));
        }
    }
    if 2 * points.len() < count {
        return None;
    }
    let total: f64 = points.iter().map(|(_, weight)| weight).sum();
    let sum = points
        .iter()
        .fold(Vector::default(), |sum, (place, weight)| {
            sum + *place * *weight
        });
    let middle = sum * (1.0 / total);
    let [mut xx, mut xy, mut yy] = [0.0; 3];
    for (place, weight) in &points {
        let offset = *place - middle;
        xx += weight * offset.e1 * offset.e1;
        xy += weight * offset.e1 * offset.e2;
        yy += weight * offset.e2 * offset.e2;
    }
    let angle = 0.5 * (2.0 * xy).atan2(xx - yy);
    Some([middle, Vector::new(angle.cos(), angle.sin())])
}

/// Where the brightness rises outwards across an edge, near a place, and by how much.
fn rise(
    levels: &Plane<f32>,
    place: Vector<f64>,
    outwards: Vector<f64>,
    reach: f64,
) -> Option<(Vector<f64>, f64)> {
    let steps = (reach / STEP).ceil() as i32;
    let level = |half_steps: i32| {
        let at = place + outwards * (0.5 * STEP * f64::from(half_steps));
        bilinear(levels, at.coordinates())
    };
    let (mut sum, mut moment) = (0.0, 0.0);
    for step in -steps..=steps {
        let slope = (level(2 * step + 1)? - level(2 * step - 1)?).max(0.0);
        sum += slope;
        moment += slope * f64::from(step) * STEP;
    }
    (sum > 1.0).then(|| (place + outwards * (moment / sum), sum))
}

/// Where two lines meet; `None` for parallel ones.
fn meet([p, d]: Line, [q, e]: Line) -> Option<Vector<f64>> {
    let sine = (d ^ e).e12;
    (sine.abs() > 0.05).then(|| p + d * (((q - p) ^ e).e12 / sine))
}
