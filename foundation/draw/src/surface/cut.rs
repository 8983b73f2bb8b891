//! Balls and patches cut by the planes of other surfaces.

use std::f64::consts::PI;

use ga_runtime::vga3::Vector;

use super::outline::{outline, region, whole};
use super::piece::{Piece, Surface, mean};
use crate::camera::Camera;
use crate::picture::{Ball, Picture};
use crate::plane::Plane;

impl Picture {
    pub(super) fn plane_of_patch(&self, index: usize) -> Plane {
        let patch = &self.patches[index];
        Plane::through(patch.corners[0], patch.normal)
    }

    /// The pieces of a patch, cut by the planes of the other patches.
    pub(super) fn cut_patch(
        &self,
        index: usize,
        cuts: bool,
        camera: &Camera,
        pieces: &mut Vec<Piece>,
    ) {
        let mut polygons = vec![self.patches[index].corners.clone()];
        for other in (0..self.patches.len()).filter(|&other| cuts && other != index) {
            let plane = self.plane_of_patch(other);
            polygons = polygons
                .iter()
                .flat_map(|polygon| [true, false].map(|side| kept(polygon, plane, side)))
                .filter(|polygon| polygon.len() > 2)
                .collect();
        }
        for polygon in polygons {
            let outline = polygon
                .iter()
                .map(|corner| camera.project(*corner))
                .collect();
            pieces.push(Piece {
                surface: Surface::Patch(index),
                sides: Vec::new(),
                regions: vec![vec![outline]],
                depth: camera.depth(mean(&polygon)),
                polygon,
            });
        }
    }

    /// The pieces of a ball, cut by the planes of patches and of circles in which it meets other
    /// balls.
    pub(super) fn cut_ball(
        &self,
        index: usize,
        cuts: bool,
        camera: &Camera,
        pieces: &mut Vec<Piece>,
    ) {
        let ball = &self.balls[index];
        let mut whole = Piece {
            surface: Surface::Ball(index),
            polygon: Vec::new(),
            sides: Vec::new(),
            regions: vec![vec![whole(outline(ball, camera), camera)]],
            depth: camera.depth(ball.centre),
        };
        if !cuts {
            pieces.push(whole);
            return;
        }
        let mut cutters = Vec::new();
        let patches = (0..self.patches.len()).map(|k| (Surface::Patch(k), self.plane_of_patch(k)));
        let balls = (0..self.balls.len()).filter(|&k| k != index);
        let others = balls.filter_map(|k| {
            let plane = meeting_plane(ball, &self.balls[k])?;
            Some((Surface::Ball(k), plane))
        });
        for (surface, plane) in patches.chain(others) {
            let height = plane.height(ball.centre);
            if height.abs() < 0.999 * ball.radius {
                cutters.push((surface, plane));
            } else {
                whole.sides.push((surface, plane, height > 0.0));
            }
        }
        let mut parts = vec![whole];
        for (surface, plane) in cutters {
            parts = parts
                .iter()
                .flat_map(|part| {
                    [true, false].map(|side| {
                        let mut part = part.clone();
                        part.sides.push((surface, plane, side));
                        part.regions.push(region(ball, plane, side, camera));
                        part
                    })
                })
                .filter(|part| is_visible(ball, part, camera))
                .collect();
        }
        pieces.append(&mut parts);
    }
}

/// The plane of the circle in which two balls meet, with the second ball on its positive side;
/// `None` where they do not meet.
pub(super) fn meeting_plane(a: &Ball, b: &Ball) -> Option<Plane> {
    let way = b.centre - a.centre;
    let apart = way.length();
    if a.imaginary || b.imaginary {
        return None;
    }
    if apart >= a.radius + b.radius || apart <= (a.radius - b.radius).abs() {
        return None;
    }
    let normal = way * apart.recip();
    let t = (apart * apart + a.radius * a.radius - b.radius * b.radius) / (2.0 * apart);
    let distance = normal.dot(a.centre) + t;
    Some(Plane { normal, distance })
}

/// Whether any part of a piece of a ball faces the eye, sampled at 400 points of the ball.
fn is_visible(ball: &Ball, piece: &Piece, camera: &Camera) -> bool {
    let horizon = camera.horizon(ball.centre, ball.radius);
    let golden = PI * (3.0 - 5.0_f64.sqrt());
    (0..400).any(|sample| {
        let height = 1.0 - 2.0 * (f64::from(sample) + 0.5) / 400.0;
        let (sine, cosine) = (golden * f64::from(sample)).sin_cos();
        let across = (1.0 - height * height).sqrt();
        let side = Vector::new(across * cosine, across * sine, height);
        let point = ball.centre + side * ball.radius;
        let mut sides = piece.sides.iter();
        horizon.height(point) >= 0.0
            && sides.all(|(_, plane, side)| (plane.height(point) > 0.0) == *side)
    })
}

/// The part of a convex polygon on one side of a plane.
fn kept(polygon: &[Vector<f64>], plane: Plane, positive: bool) -> Vec<Vector<f64>> {
    let sign = if positive { 1.0 } else { -1.0 };
    let height = |point: &Vector<f64>| sign * plane.height(*point);
    let mut part = Vec::new();
    for (from, to) in polygon.iter().zip(polygon.iter().cycle().skip(1)) {
        let (a, b) = (height(from), height(to));
        if a >= 0.0 {
            part.push(*from);
        }
        if (a > 1e-9 && b < -1e-9) || (a < -1e-9 && b > 1e-9) {
            part.push(from.lerp(*to, a / (a - b)));
        }
    }
    // A polygon in the plane itself counts as on its positive side only.
    let is_real = polygon.iter().any(|point| height(point) > 1e-9)
        || (positive && part.len() == polygon.len());
    if is_real { part } else { Vec::new() }
}
