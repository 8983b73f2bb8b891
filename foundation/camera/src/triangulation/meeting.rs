//! Where the rays of two pixels meet after the pixels were corrected.

use ga_runtime::cga3::{Direction, Motor, Point};
use ga_runtime::scalar::Real;
use ga_runtime::vga3::Vector;

use super::kernel::{RayAngle, mutual_moment};
use crate::Camera;

#[allow(unreachable_pub)]
mod formulas {
    ga_runtime::ga! { ga_runtime::cga3;
        /// The direction of a pixel's ray, of depth 1.
        pub fn direction(uniform k: [Scalar; 4], u: Scalar, v: Scalar) -> Direction {
            ((u - k[2]) * k[0] * e1 + (v - k[3]) * k[1] * e2 + e3) ^ ei
        }

        /// A direction in the left camera's frame.
        pub fn rotated(uniform right: Rotor, b: Direction) -> Direction {
            sandwich(right, b)
        }

        /// A place in the world.
        pub fn placed(uniform left: Motor, x: Point) -> Point {
            sandwich(left, x)
        }
    }
}

/// Two pinhole cameras prepared for rays that meet. All directions have the axes of the left
/// camera.
#[derive(Clone, Copy, Debug)]
pub(super) struct Meetings<S> {
    directions: [formulas::Direction<S>; 2],
    rotated: formulas::Rotated<S>,
    placed: formulas::Placed<S>,
    /// From the left centre to the right one.
    baseline: Vector<S>,
    /// The optical axis of the right camera, and how far along it the right centre is.
    forward: Vector<S>,
    ahead: S,
    /// The rows of E: the mutual moment of rays of the directions a and b, in the frames of their
    /// cameras, is `Σ aᵢ Eᵢⱼ bⱼ`.
    rows: [Vector<S>; 3],
    /// Its first columns.
    columns: [Vector<S>; 2],
    /// For each camera the squares of the reciprocal focal lengths: the variances of the first two
    /// coordinates of directions.
    variances: [[S; 2]; 2],
}

/// The rays of two pixels as measured.
#[derive(Clone, Copy, Debug)]
pub(super) struct Measured<S> {
    /// The directions in the frames of their cameras, of depth 1.
    directions: [Vector<S>; 2],
    /// The direction a × b.
    normal: Vector<S>,
    pub(super) angle: RayAngle<S>,
    /// The derivatives of the mutual moment by the first two coordinates of both directions.
    gradients: [[S; 2]; 2],
    /// The mutual moment.
    pub(super) moment: S,
}

/// Where two rays meet.
#[derive(Clone, Copy, Debug)]
pub(super) struct Meeting<S> {
    /// A direction of the left ray.
    direction: Vector<S>,
    /// What multiple of it leads to the place, multiplied by the divisor.
    multiple: S,
    /// What the multiple is to be divided by.
    pub(super) divisor: S,
}

impl Meetings<f64> {
    pub(super) fn new(left: &Camera, right: &Camera) -> Self {
        let to_left: Motor<f64> = left.world_to_camera * right.world_to_camera.reverse();
        let basis = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]].map(Direction::from_vector);
        let entries = basis.map(|a| basis.map(|b| mutual_moment(to_left, a, b)));
        let column = |k: usize| Vector::from(entries.map(|row| row[k]));
        let baseline = Vector::from(to_left.transform(Point::default()));
        let forward = Vector::from(to_left.transform(basis[2]));
        let focal = [left, right].map(|camera| camera.intrinsics.focal());
        let direction = |camera: &Camera| {
            let ([fx, fy], [cx, cy]) = (camera.intrinsics.focal(), camera.intrinsics.principal());
            formulas::direction([fx.recip(), fy.recip(), cx, cy])
        };
        Self {
            directions: [direction(left), direction(right)],
            rotated: formulas::rotated(to_left.rotor()),
            placed: formulas::placed(left.world_to_camera.reverse()),
            baseline,
            forward,
            ahead: baseline.dot(forward),
            rows: entries.map(Vector::from),
            columns: [column(0), column(1)],
            variances: focal.map(|lengths| lengths.map(|length| (length * length).recip())),
        }
    }
}

impl<S: Real> Meetings<S> {
    /// The rays of a pair of pixels.
    #[inline(always)]
    pub(super) fn measured(&self, left: [S; 2], right: [S; 2]) -> Measured<S> {
        let [q, p] = self.directions_of(left, right);
        let b = self.in_left(p);
        let normal = q.cross(b);
        let gradient = [self.rows[0].dot(p), self.rows[1].dot(p)];
        Measured {
            directions: [q, p],
            normal,
            angle: RayAngle {
                square: normal.dot(normal),
                cosine: q.dot(b),
            },
            gradients: [gradient, [self.columns[0].dot(q), self.columns[1].dot(q)]],
            moment: self.rows[2].dot(p) + (q.e1 * gradient[0] + q.e2 * gradient[1]),
        }
    }

    /// Where the rays meet after one step along the gradients of their mutual moment, in which
    /// pixels count equally. (P. D. Sampson, Fitting conic sections to "very scattered" data,
    /// Computer Graphics and Image Processing 18, 1982.)
    #[inline(always)]
    pub(super) fn after_step(&self, measured: &Measured<S>) -> Meeting<S> {
        let [first, second] = measured.gradients;
        let scaled =
            |k: usize, [x, y]: [S; 2]| [x * self.variances[k][0], y * self.variances[k][1]];
        let (step, other) = (scaled(0, first), scaled(1, second));
        let square = (step[0] * first[0] + step[1] * first[1])
            + (other[0] * second[0] + other[1] * second[1]);
        // The directions are multiplied by the square instead of a division by it.
        let stepped = |direction: Vector<S>, [x, y]: [S; 2]| {
            Vector::new(
                direction.e1 * square - measured.moment * x,
                direction.e2 * square - measured.moment * y,
                square,
            )
        };
        let [q, p] = measured.directions;
        self.meeting(stepped(q, step), stepped(p, other), measured.normal)
    }

    /// Where the rays of corrected pixels meet.
    #[inline(always)]
    pub(super) fn corrected(
        &self,
        [left, right]: [[S; 2]; 2],
        measured: &Measured<S>,
    ) -> Meeting<S> {
        let [q, p] = self.directions_of(left, right);
        self.meeting(q, p, measured.normal)
    }

    /// The place in the world where rays meet, and its depths in front of both cameras, for the
    /// reciprocal of the divisor.
    #[inline(always)]
    pub(super) fn place(&self, meeting: &Meeting<S>, by_divisor: S) -> (Vector<S>, [S; 2]) {
        let place = meeting.direction * (meeting.multiple * by_divisor);
        let depths = [place.e3, place.dot(self.forward) - self.ahead];
        (Vector::from(self.placed.apply(place.into())), depths)
    }

    #[inline(always)]
    fn directions_of(&self, [u, v]: [S; 2], [x, y]: [S; 2]) -> [Vector<S>; 2] {
        let [left, right] = &self.directions;
        [left.apply(u, v), right.apply(x, y)].map(Vector::from)
    }

    #[inline(always)]
    fn in_left(&self, direction: Vector<S>) -> Vector<S> {
        Vector::from(self.rotated.apply(direction.into()))
    }

    /// The meeting of two rays in one plane of about the normal n. With the baseline c,
    /// `s a = c + t b`, and the product with b × n has s alone.
    #[inline(always)]
    fn meeting(&self, a: Vector<S>, p: Vector<S>, normal: Vector<S>) -> Meeting<S> {
        let across = self.in_left(p).cross(normal);
        Meeting {
            direction: a,
            multiple: self.baseline.dot(across),
            divisor: a.dot(across),
        }
    }
}
