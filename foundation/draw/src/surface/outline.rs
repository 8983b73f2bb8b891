//! Outlines of balls, and the regions into which planes cut them.

use std::f64::consts::{PI, TAU};

use crate::camera::{Camera, Pixel};
use crate::picture::Ball;
use crate::plane::Plane;
use crate::ring::{Ring, basis_across};
use crate::view::Up;

/// The outline of a ball in space.
pub(crate) fn outline(ball: &Ball, camera: &Camera) -> Ring {
    section(ball, camera.horizon(ball.centre, ball.radius))
}

/// The circle in which a ball meets a plane.
fn section(ball: &Ball, plane: Plane) -> Ring {
    let height = -plane.height(ball.centre);
    let radius = (ball.radius * ball.radius - height * height).max(0.0);
    Ring {
        centre: ball.centre + plane.normal * height,
        basis: basis_across(plane.normal, Up::Z.axes()),
        radius: radius.sqrt(),
    }
}

/// A whole circle in the picture.
pub(super) fn whole(ring: Ring, camera: &Camera) -> Vec<Pixel> {
    arc(ring, 0.0, TAU, camera)
}

/// The part of the picture where the front of a ball is on one side of a plane.
pub(super) fn region(
    ball: &Ball,
    plane: Plane,
    positive: bool,
    camera: &Camera,
) -> Vec<Vec<Pixel>> {
    let horizon = camera.horizon(ball.centre, ball.radius);
    let (rim, cut) = (section(ball, horizon), section(ball, plane));
    let (rim_middle, rim_half) = positive_arc(rim, plane);
    let (cut_middle, cut_half) = positive_arc(cut, horizon);
    if cut_half == 0.0 || cut_half == PI || rim_half == 0.0 || rim_half == PI {
        // The two circles do not cross: the outline is on one side.
        let outline_here = (rim_half > 0.5 * PI) == positive;
        let cut_is_seen = cut_half > 0.5 * PI;
        return match (outline_here, cut_is_seen) {
            (true, true) => vec![whole(rim, camera), whole(cut, camera)],
            (true, false) => vec![whole(rim, camera)],
            (false, true) => vec![whole(cut, camera)],
            (false, false) => Vec::new(),
        };
    }
    let (from, to) = if positive {
        (rim_middle - rim_half, rim_middle + rim_half)
    } else {
        (rim_middle + rim_half, rim_middle + TAU - rim_half)
    };
    let mut path = arc(rim, from, to, camera);
    let mut back = arc(cut, cut_middle - cut_half, cut_middle + cut_half, camera);
    let gap = |a: Option<&Pixel>, b: Option<&Pixel>| match (a, b) {
        (Some(a), Some(b)) => (a[0] - b[0]).hypot(a[1] - b[1]),
        _ => 0.0,
    };
    if gap(path.last(), back.first()) > gap(path.last(), back.last()) {
        back.reverse();
    }
    path.append(&mut back);
    vec![path]
}

/// Points of a circle from one angle to another.
fn arc(ring: Ring, from: f64, to: f64, camera: &Camera) -> Vec<Pixel> {
    let pieces = ((to - from).abs() * 96.0 / TAU).ceil().max(2.0) as u32;
    (0..=pieces)
        .map(|k| {
            let angle = from + (to - from) * f64::from(k) / f64::from(pieces);
            camera.project(ring.at(angle))
        })
        .collect()
}

/// The part of a circle on the positive side of a plane: the angle of its middle, and half its
/// angle.
fn positive_arc(ring: Ring, plane: Plane) -> (f64, f64) {
    let [a, b] = ring.basis.map(|axis| plane.normal.dot(axis) * ring.radius);
    let needed = -plane.height(ring.centre);
    let reach = a.hypot(b);
    let half = if reach <= needed.abs() {
        if needed < 0.0 { PI } else { 0.0 }
    } else {
        (needed / reach).acos()
    };
    (b.atan2(a), half)
}
