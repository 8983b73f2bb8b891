//! Dark discs in a picture.

use ga_image::plane::Plane;
use ga_numerics::order_statistics::median;
use ga_runtime::vga2::Vector;

use crate::contour::borders;
use crate::contour::fit::{Ellipse, ellipse};

/// Thresholds between the darkest and the brightest pixel.
const LEVELS: u32 = 16;
/// The least of the semi-axes in pixels.
const LEAST_AXIS: f64 = 2.5;
/// The least ratio of the axes: a disc that is seen more obliquely has no certain centre.
const LEAST_RATIO: f64 = 0.2;
/// How far the border may be from the ellipse: as a part of its axes, and in pixels.
const TOLERANCE: [f64; 2] = [0.08, 1.0];

/// The image of a disc.
#[derive(Clone, Copy, Debug)]
pub(super) struct Disc {
    /// Its centre of mass in the picture.
    pub(super) centre: Vector<f64>,
    /// Its area in pixels.
    pub(super) area: f64,
}

/// The dark ellipses that are there at two neighbouring thresholds or more, from the top.
pub(super) fn discs(picture: &Plane<u8>) -> Vec<Disc> {
    let (least, greatest) = (picture.values().iter()).fold((u8::MAX, 0), |(least, greatest), x| {
        (least.min(*x), greatest.max(*x))
    });
    let range = u32::from(greatest.saturating_sub(least));
    let mut groups: Vec<Vec<Ellipse>> = Vec::new();
    for level in 0..LEVELS {
        let threshold = u32::from(least) + range * (2 * level + 1) / (2 * LEVELS);
        let dark = picture.map(|value| u8::from(u32::from(value) <= threshold));
        for contour in borders(&dark) {
            let Some(found) = whole_ellipse(&contour.points(), contour.is_hole, picture) else {
                continue;
            };
            let is_same = |group: &&mut Vec<Ellipse>| {
                group.last().is_some_and(|last| {
                    let [x, y] = [0, 1].map(|k| found.centre[k] - last.centre[k]);
                    x.hypot(y) < 0.3 * last.semi_axes[1]
                })
            };
            match groups.iter_mut().find(is_same) {
                Some(group) => group.push(found),
                None => groups.push(vec![found]),
            }
        }
    }
    let groups = groups.iter().filter(|group| group.len() > 1);
    groups
        .filter_map(|group| disc(picture, &group[group.len() / 2]))
        .collect()
}

/// The ellipse of a border, where it is one and lies in the picture.
fn whole_ellipse(points: &[[f64; 2]], is_hole: bool, picture: &Plane<u8>) -> Option<Ellipse> {
    if is_hole || points.len() < 12 {
        return None;
    }
    let last = [picture.width(), picture.height()].map(|side| side as f64 - 1.0);
    let is_inside = |point: &[f64; 2]| (0..2).all(|k| point[k] > 0.0 && point[k] < last[k]);
    let found = ellipse(points).ok()?;
    let [major, minor] = found.semi_axes;
    let is_near = |point: &[f64; 2]| {
        let radius = radius(&found, *point);
        let off = (radius - 1.0).abs();
        off < TOLERANCE[0] || off * minor < TOLERANCE[1]
    };
    let is_disc = minor >= LEAST_AXIS
        && minor >= LEAST_RATIO * major
        && points.iter().all(is_inside)
        && points.iter().all(is_near);
    is_disc.then_some(found)
}

/// The distance of a place from the centre of an ellipse, in that of its border in this direction.
fn radius(ellipse: &Ellipse, place: [f64; 2]) -> f64 {
    let [x, y] = [0, 1].map(|k| place[k] - ellipse.centre[k]);
    let (sin, cos) = ellipse.angle.sin_cos();
    let [along, across] = [x * cos + y * sin, y * cos - x * sin];
    (along / ellipse.semi_axes[0]).hypot(across / ellipse.semi_axes[1])
}

/// The centre of mass of how much darker pixels are than those around a disc.
fn disc(picture: &Plane<u8>, ellipse: &Ellipse) -> Option<Disc> {
    /// By how much the borders of dark pixels lie inside the disc.
    const INSIDE: f64 = 0.5;
    /// How far blur reaches beyond the border, and how wide the ring beyond it is, in pixels.
    const REACH: [f64; 2] = [2.0, 1.5];
    let grown = |by: f64| Ellipse {
        semi_axes: ellipse.semi_axes.map(|axis| axis + INSIDE + by),
        ..*ellipse
    };
    let [own, ring] = [grown(REACH[0]), grown(REACH[0] + REACH[1])];
    let [left, top] = ellipse
        .centre
        .map(|x| (x - ring.semi_axes[0]).floor().max(0.0) as usize);
    let end = |k: usize, side: usize| {
        ((ellipse.centre[k] + ring.semi_axes[0]).ceil() as usize + 1).min(side)
    };
    let pixels = |right: usize, bottom: usize| {
        (top..bottom).flat_map(move |row| (left..right).map(move |column| [column, row]))
    };
    let all: Vec<([f64; 2], f64)> = pixels(end(0, picture.width()), end(1, picture.height()))
        .map(|[column, row]| {
            let value = f64::from(picture.row(row)[column]);
            ([column as f64, row as f64], value)
        })
        .collect();
    let around = all
        .iter()
        .filter(|(place, _)| radius(&own, *place) > 1.0 && radius(&ring, *place) <= 1.0);
    let mut around: Vec<f64> = around.map(|(_, value)| *value).collect();
    let inside = all
        .iter()
        .filter(|(place, _)| radius(ellipse, *place) < 0.5);
    let mut inside: Vec<f64> = inside.map(|(_, value)| *value).collect();
    let [bright, dark] = [median(&mut around)?, median(&mut inside)?];
    if bright <= dark {
        return None;
    }
    let (mut mass, mut sum) = (0.0, Vector::default());
    for (place, value) in &all {
        if radius(&own, *place) <= 1.0 {
            let weight = (bright - value) / (bright - dark);
            mass += weight;
            sum += Vector::new(place[0], place[1]) * weight;
        }
    }
    (mass > 0.0).then(|| Disc {
        centre: sum * (1.0 / mass),
        area: mass,
    })
}
