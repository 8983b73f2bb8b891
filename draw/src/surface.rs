//! Balls and patches cut into pieces that can be painted one after the other.
//!
//! Every surface is cut where another passes through it: a patch by the planes of other patches, a
//! ball by the planes of patches and by the planes of the circles in which it meets other balls. Of
//! two pieces, a plane then tells which is nearer to the eye, and sorting by these relations gives
//! an order in which each is painted after all that it hides.

use std::f64::consts::{PI, TAU};

use crate::camera::{Camera, Pixel};
use crate::picture::{Ball, Picture};
use crate::vector3::{
    Vector3, along, basis_across, difference, dot, length, on_circle, scaled, sum,
};

/// A plane m·x = k, m of length 1.
type PlaneOf = (Vector3, f64);

/// More surfaces than this are not cut: their number makes a picture confusing enough.
const MOST_CUT: usize = 16;

/// A part of a ball or patch that nothing passes through.
#[derive(Clone, Debug)]
pub(crate) struct Piece {
    pub(crate) surface: Surface,
    /// The corners of a patch in space; of a ball nothing.
    polygon: Vec<Vector3>,
    /// Of a ball, on which sides of which surfaces' planes it is.
    sides: Vec<(Surface, PlaneOf, bool)>,
    /// What of the picture it covers: the inside of the first outline, but only what is also in all
    /// others, each an outline with perhaps a hole.
    pub(crate) regions: Vec<Vec<Vec<Pixel>>>,
    depth: f64,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Surface {
    Ball(usize),
    Patch(usize),
}

impl Picture {
    /// The balls and patches in the order in which they are to be painted.
    pub(crate) fn pieces(&self, camera: &Camera) -> Vec<Piece> {
        let mut pieces = Vec::new();
        let cuts = self.balls.len() + self.patches.len() <= MOST_CUT;
        for index in 0..self.patches.len() {
            self.cut_patch(index, cuts, camera, &mut pieces);
        }
        for index in 0..self.balls.len() {
            self.cut_ball(index, cuts, camera, &mut pieces);
        }
        self.sorted(pieces, camera)
    }

    fn plane_of_patch(&self, index: usize) -> PlaneOf {
        let patch = &self.patches[index];
        (patch.normal, dot(patch.normal, patch.corners[0]))
    }

    fn cut_patch(&self, index: usize, cuts: bool, camera: &Camera, pieces: &mut Vec<Piece>) {
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

    fn cut_ball(&self, index: usize, cuts: bool, camera: &Camera, pieces: &mut Vec<Piece>) {
        let ball = &self.balls[index];
        let mut whole = Piece {
            surface: Surface::Ball(index),
            polygon: Vec::new(),
            sides: Vec::new(),
            regions: vec![vec![outline(ball, camera)]],
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
            let height = dot(plane.0, ball.centre) - plane.1;
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
                .filter(|part| is_seen(ball, part, camera))
                .collect();
        }
        pieces.append(&mut parts);
    }

    /// Sorts so that each piece comes after those that it hides; where these relations go round in
    /// a circle, by depth.
    fn sorted(&self, pieces: Vec<Piece>, camera: &Camera) -> Vec<Piece> {
        let bounds: Vec<[Pixel; 2]> = pieces.iter().map(bounds).collect();
        let overlap = |a: usize, b: usize| {
            (0..2).all(|k| bounds[a][0][k] <= bounds[b][1][k] && bounds[b][0][k] <= bounds[a][1][k])
        };
        // How many pieces have still to come before each, and which come after it.
        let mut before = vec![0; pieces.len()];
        let mut after = vec![Vec::new(); pieces.len()];
        for a in 0..pieces.len() {
            for b in a + 1..pieces.len() {
                if !overlap(a, b) {
                    continue;
                }
                if let Some(hides) = self.hides(&pieces[a], &pieces[b], camera) {
                    let (first, second) = if hides { (b, a) } else { (a, b) };
                    before[second] += 1;
                    after[first].push(second);
                }
            }
        }
        let mut rest: Vec<usize> = (0..pieces.len()).collect();
        rest.sort_by(|&a, &b| pieces[a].depth.total_cmp(&pieces[b].depth));
        let mut order = Vec::new();
        while !rest.is_empty() {
            let next = rest
                .iter()
                .position(|&piece| before[piece] == 0)
                .unwrap_or(0);
            let piece = rest.remove(next);
            for &later in &after[piece] {
                before[later] -= 1;
            }
            order.push(piece);
        }
        let mut pieces: Vec<Option<Piece>> = pieces.into_iter().map(Some).collect();
        order
            .into_iter()
            .filter_map(|index| pieces[index].take())
            .collect()
    }

    /// Whether the first piece hides the second where both are; `None` where neither does.
    fn hides(&self, a: &Piece, b: &Piece, camera: &Camera) -> Option<bool> {
        match (a.surface, b.surface) {
            (Surface::Patch(i), Surface::Patch(j)) if i != j => {
                let plane = self.plane_of_patch(j);
                let height = dot(plane.0, mean(&a.polygon)) - plane.1;
                (height.abs() > 1e-9).then(|| (height > 0.0) == camera.is_above(plane))
            }
            (Surface::Ball(i), Surface::Patch(j)) => Some(self.ball_hides_patch(i, a, j, camera)),
            (Surface::Patch(i), Surface::Ball(j)) => Some(!self.ball_hides_patch(j, b, i, camera)),
            (Surface::Ball(i), Surface::Ball(j)) if i != j => {
                Some(self.ball_hides_ball([i, j], [a, b], camera))
            }
            _ => None,
        }
    }

    fn ball_hides_patch(&self, ball: usize, piece: &Piece, patch: usize, camera: &Camera) -> bool {
        let plane = self.plane_of_patch(patch);
        let side = side_of(piece, Surface::Patch(patch))
            .unwrap_or_else(|| dot(plane.0, self.balls[ball].centre) > plane.1);
        side == camera.is_above(plane)
    }

    fn ball_hides_ball(&self, [i, j]: [usize; 2], pieces: [&Piece; 2], camera: &Camera) -> bool {
        let [a, b] = [&self.balls[i], &self.balls[j]];
        let apart = length(difference(b.centre, a.centre));
        if apart <= (a.radius - b.radius).abs() {
            // The outer one's front is in front of the inner one.
            return a.radius > b.radius;
        }
        if meeting_plane(a, b).is_none() {
            // The plane half way between the surfaces.
            let m = scaled(difference(b.centre, a.centre), apart.recip());
            let k = dot(m, a.centre) + a.radius + 0.5 * (apart - a.radius - b.radius);
            return !camera.is_above((m, k));
        }
        // The positive side of the plane as seen from a is that of b.
        let within = |piece, other| side_of(piece, Surface::Ball(other)).unwrap_or(false);
        match (within(pieces[0], j), within(pieces[1], i)) {
            (false, false) => meeting_plane(a, b).is_none_or(|plane| !camera.is_above(plane)),
            // What is within the other ball is behind its surface.
            (within_b, _) => !within_b,
        }
    }
}

/// On which side of a surface's plane a piece of a ball is.
fn side_of(piece: &Piece, surface: Surface) -> Option<bool> {
    let mut sides = piece.sides.iter();
    sides.find(|side| side.0 == surface).map(|side| side.2)
}

/// The plane of the circle in which two balls meet, its positive side that of the second; `None`
/// where they do not.
fn meeting_plane(a: &Ball, b: &Ball) -> Option<PlaneOf> {
    let way = difference(b.centre, a.centre);
    let apart = length(way);
    if a.imaginary || b.imaginary {
        return None;
    }
    if apart >= a.radius + b.radius || apart <= (a.radius - b.radius).abs() {
        return None;
    }
    let m = scaled(way, apart.recip());
    let t = (apart * apart + a.radius * a.radius - b.radius * b.radius) / (2.0 * apart);
    Some((m, dot(m, a.centre) + t))
}

/// The outline of a ball as points in space: orthonormal vectors in its plane, centre and radius.
pub(crate) fn horizon_circle(ball: &Ball, camera: &Camera) -> (Vector3, [Vector3; 2], f64) {
    circle_of(ball, camera.horizon(ball.centre, ball.radius))
}

/// The circle in which a ball meets a plane.
fn circle_of(ball: &Ball, (m, k): PlaneOf) -> (Vector3, [Vector3; 2], f64) {
    let height = k - dot(m, ball.centre);
    let radius = (ball.radius * ball.radius - height * height)
        .max(0.0)
        .sqrt();
    (
        along(ball.centre, m, height),
        basis_across(m, [0.0, 0.0, 1.0]),
        radius,
    )
}

fn outline(ball: &Ball, camera: &Camera) -> Vec<Pixel> {
    arc(horizon_circle(ball, camera), 0.0, TAU, camera)
}

/// Points of a circle from one angle to another.
fn arc(
    (centre, basis, radius): (Vector3, [Vector3; 2], f64),
    from: f64,
    to: f64,
    camera: &Camera,
) -> Vec<Pixel> {
    let pieces = ((to - from).abs() * 96.0 / TAU).ceil().max(2.0) as u32;
    (0..=pieces)
        .map(|k| {
            let angle = from + (to - from) * f64::from(k) / f64::from(pieces);
            camera.project(on_circle(centre, basis, radius, angle))
        })
        .collect()
}

/// The angle in the middle of the part of a circle on the positive side of a plane, and half the
/// size of that part.
fn positive_arc(
    (centre, [u, v], radius): (Vector3, [Vector3; 2], f64),
    (m, k): PlaneOf,
) -> (f64, f64) {
    let [a, b] = [dot(m, u) * radius, dot(m, v) * radius];
    let needed = k - dot(m, centre);
    let reach = a.hypot(b);
    let half = if reach <= needed.abs() {
        if needed < 0.0 { PI } else { 0.0 }
    } else {
        (needed / reach).acos()
    };
    (b.atan2(a), half)
}

/// The part of the picture in which the front of a ball is on one side of a plane.
fn region(ball: &Ball, plane: PlaneOf, positive: bool, camera: &Camera) -> Vec<Vec<Pixel>> {
    let horizon = camera.horizon(ball.centre, ball.radius);
    let (rim, cut) = (circle_of(ball, horizon), circle_of(ball, plane));
    let (rim_middle, rim_half) = positive_arc(rim, plane);
    let (cut_middle, cut_half) = positive_arc(cut, horizon);
    let whole = |circle| arc(circle, 0.0, TAU, camera);
    if cut_half == 0.0 || cut_half == PI || rim_half == 0.0 || rim_half == PI {
        // The two circles do not cross: the outline is on one side.
        let outline_here = (rim_half > 0.5 * PI) == positive;
        let cut_is_seen = cut_half > 0.5 * PI;
        return match (outline_here, cut_is_seen) {
            (true, true) => vec![whole(rim), whole(cut)],
            (true, false) => vec![whole(rim)],
            (false, true) => vec![whole(cut)],
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

/// Whether anything of a piece of a ball can be seen, by a few hundred points.
fn is_seen(ball: &Ball, piece: &Piece, camera: &Camera) -> bool {
    let (m, k) = camera.horizon(ball.centre, ball.radius);
    let golden = PI * (3.0 - 5.0_f64.sqrt());
    (0..400).any(|sample| {
        let height = 1.0 - 2.0 * (f64::from(sample) + 0.5) / 400.0;
        let (sine, cosine) = (golden * f64::from(sample)).sin_cos();
        let across = (1.0 - height * height).sqrt();
        let point = along(
            ball.centre,
            [across * cosine, across * sine, height],
            ball.radius,
        );
        let mut sides = piece.sides.iter();
        dot(m, point) >= k && sides.all(|(_, (m, k), side)| (dot(*m, point) > *k) == *side)
    })
}

/// The part of a convex polygon on one side of a plane.
fn kept(polygon: &[Vector3], (m, k): PlaneOf, positive: bool) -> Vec<Vector3> {
    let sign = if positive { 1.0 } else { -1.0 };
    let height = |point: &Vector3| sign * (dot(m, *point) - k);
    let mut part = Vec::new();
    for (from, to) in polygon.iter().zip(polygon.iter().cycle().skip(1)) {
        let (a, b) = (height(from), height(to));
        if a >= 0.0 {
            part.push(*from);
        }
        if (a > 1e-9 && b < -1e-9) || (a < -1e-9 && b > 1e-9) {
            part.push(along(*from, difference(*to, *from), a / (a - b)));
        }
    }
    // A polygon in the plane belongs to its positive side only.
    let is_real = polygon.iter().any(|point| height(point) > 1e-9)
        || (positive && part.len() == polygon.len());
    if is_real { part } else { Vec::new() }
}

fn mean(points: &[Vector3]) -> Vector3 {
    let total = points
        .iter()
        .fold([0.0; 3], |total, point| sum(total, *point));
    scaled(total, (points.len() as f64).recip())
}

/// The box round what a piece covers.
fn bounds(piece: &Piece) -> [Pixel; 2] {
    let mut bounds = [[f64::NEG_INFINITY; 2], [f64::INFINITY; 2]];
    for region in &piece.regions {
        let mut own = [[f64::INFINITY; 2], [f64::NEG_INFINITY; 2]];
        for point in region.iter().flatten() {
            for k in 0..2 {
                own[0][k] = own[0][k].min(point[k]);
                own[1][k] = own[1][k].max(point[k]);
            }
        }
        for k in 0..2 {
            bounds[0][k] = bounds[0][k].max(own[0][k]);
            bounds[1][k] = bounds[1][k].min(own[1][k]);
        }
    }
    bounds
}
