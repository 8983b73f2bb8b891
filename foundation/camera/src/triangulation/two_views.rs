//! Many pairs of pixels of the same two cameras.

use ga_runtime::batch::{Batch, InstructionSet, Work};
use ga_runtime::cga3::{Direction, Point};
use ga_runtime::scalar::Real;
use ga_runtime::vga3::Vector;

use super::TriangulationError;
use super::blocks::{Kernel, by_blocks};
use super::columns::{CovarianceColumns, PixelColumns, PointColumns};
use super::covariance::{Sight, covariance};
use super::kernel::{Rays, mutual_moment};
use super::meeting::Meetings;
use super::optimal::Epipolar;
#[cfg(doc)]
use crate::Intrinsics;
use crate::{Camera, Lens};

/// Which point two rays determine that do not meet.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Method {
    /// The middle of the common perpendicular: the sum of the squared distances from the rays is
    /// least.
    Midpoint,
    /// The point where the rays meet after one step of Gauss and Newton's method: both pixels move
    /// along the gradients of the epipolar condition until it holds to first order. A gradient is
    /// as long as the distance of the point from the other centre, so that the rays move in
    /// proportion to the squares of their depths: the camera that is nearer counts more. The errors
    /// in both pictures are the least ones up to the square of their part of the distance from the
    /// epipole.
    DepthWeighted,
    /// The point whose projections are nearest to the pixels: the sum of the squared distances in
    /// both pictures is least (P. Lindstrom, Triangulation made easy, CVPR 2010; the optimum is
    /// that of R. Hartley and P. Sturm, Triangulation, Computer Vision and Image Understanding 68,
    /// 1997). It is the most likely one for Gaussian noise of equal size in both pictures.
    #[default]
    Optimal,
}

/// Two cameras prepared for the triangulation of many pairs of pixels.
///
/// Pixels come and points go in columns, so that several points are computed side by side with the
/// instructions that the processor has; the results do not depend on which these are.
///
/// ```
/// use ga_runtime::cga3::Point;
/// use ga_camera::Intrinsics;
/// use ga_camera::rig::StereoRig;
/// use ga_camera::triangulation::{Method, PixelColumns, PointColumns, TwoViews};
///
/// let intrinsics = Intrinsics::new([800.0, 800.0], [320.0, 240.0])?;
/// let identity = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
/// let rig = StereoRig::from_matrices(intrinsics, intrinsics, identity, [-0.2, 0.0, 0.0])?;
/// let views = TwoViews::new(&rig.left, &rig.right)?;
///
/// // Disparities of 16 and of 8 pixels; depths of 0.2 · 800/16 and 0.2 · 800/8 metres.
/// let left = PixelColumns { u: &[336.0, 400.0], v: &[240.0, 280.0] };
/// let right = PixelColumns { u: &[320.0, 392.0], v: &[240.0, 280.0] };
/// let mut points = PointColumns::default();
/// views.triangulate(Method::Optimal, left, right, &mut points)?;
/// points.check_in_front()?;
/// let far = points.get(1).unwrap();
/// assert!(far.position.distance(Point::new(2.0, 1.0, 20.0)) < 1e-12 && far.gap < 1e-12);
/// assert!((far.depths[1] - 20.0).abs() < 1e-12);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug)]
pub struct TwoViews {
    rays: Rays<f64>,
    meetings: Meetings<f64>,
    epipolar: Epipolar<f64>,
    sights: [Sight; 2],
    instructions: InstructionSet,
}

/// The sine of the angle below which rays count as parallel: that of directions which differ by
/// their rounding.
const PARALLEL: f64 = 32.0 * f64::EPSILON;

impl TwoViews {
    /// Prepares two cameras.
    ///
    /// # Errors
    /// [`TriangulationError::NoBaseline`] where the centres of the cameras coincide up to rounding,
    /// [`TriangulationError::NotFinite`] where a pose is not finite, and
    /// [`TriangulationError::Distorted`] for a lens with distortion: its pixels are
    /// [undistorted](Intrinsics::undistort) first, and then those of a pinhole.
    pub fn new(left: &Camera, right: &Camera) -> Result<Self, TriangulationError> {
        for (view, camera) in [left, right].into_iter().enumerate() {
            if camera.intrinsics.lens() != Lens::Pinhole {
                return Err(TriangulationError::Distorted { view });
            }
        }
        let centres = [left.centre(), right.centre()];
        let baseline = centres[0].distance(centres[1]);
        let size: f64 = centres
            .iter()
            .map(|centre| centre.distance(Point::default()))
            .sum();
        if !(baseline.is_finite() && size.is_finite()) {
            return Err(TriangulationError::NotFinite);
        }
        if baseline <= 8.0 * f64::EPSILON * size || baseline == 0.0 {
            return Err(TriangulationError::NoBaseline);
        }
        // All directions have the axes of the world, all places begin at the left centre.
        let rotation = left.world_to_camera.reverse().rotor();
        let right_to_left = left.world_to_camera * right.world_to_camera.reverse();
        let right_to_axes = rotation * right_to_left;
        let pixels = [left, right].map(|camera| {
            let ([fx, fy], [cx, cy]) = (camera.intrinsics.focal(), camera.intrinsics.principal());
            [fx.recip(), fy.recip(), cx, cy]
        });
        let focal = [left, right].map(|camera| camera.intrinsics.focal());
        let common = focal[0][0];
        let basis = |focal: [f64; 2]| {
            let [x, y] = focal.map(|length| common / length);
            [[x, 0.0, 0.0], [0.0, y, 0.0], [0.0, 0.0, 1.0]].map(Direction::from_vector)
        };
        let entries = basis(focal[0]).map(|a| {
            let a = rotation.transform(a);
            basis(focal[1]).map(|b| mutual_moment(right_to_axes, a, b) / baseline)
        });
        let principal = [left, right].map(|camera| camera.intrinsics.principal());
        Ok(Self {
            rays: Rays::new(rotation, right_to_axes, centres[0], pixels),
            meetings: Meetings::new(left, right),
            epipolar: Epipolar::new(entries, principal, common),
            sights: [left, right]
                .map(|camera| Sight::new(camera.world_to_camera, camera.intrinsics.focal())),
            instructions: InstructionSet::best(),
        })
    }

    /// The same with given instructions instead of the best that the processor has.
    #[must_use]
    pub fn on(mut self, instructions: InstructionSet) -> Self {
        self.instructions = instructions;
        self
    }

    /// The points of pairs of pixels, with the distance and the angle of the rays and the depths in
    /// front of both cameras.
    ///
    /// For every method the distance is that of the measured rays. Points behind a camera are no
    /// error: their depths are negative ([`PointColumns::check_in_front`]). Where `points` had room
    /// for as many before, nothing is allocated. After an error its contents have no meaning.
    ///
    /// # Errors
    /// [`TriangulationError`] for columns of different lengths, and for the first pair of pixels
    /// that are not finite or whose rays are parallel.
    pub fn triangulate(
        &self,
        method: Method,
        left: PixelColumns<'_>,
        right: PixelColumns<'_>,
        points: &mut PointColumns,
    ) -> Result<(), TriangulationError> {
        let inputs = same_length(left, right)?;
        points.resize(left.u.len());
        let mut passed = true;
        Batch::on(self.instructions).run(Points {
            views: self,
            method,
            inputs,
            points,
            passed: &mut passed,
        });
        if passed {
            return Ok(());
        }
        Err(self.first_error(method, left, right))
    }

    /// The covariances of points that [`triangulate`](Self::triangulate) found, for independent
    /// Gaussian noise of the standard deviation `noise` in pixels in all coordinates: `σ² (JᵀJ)⁻¹`
    /// with the derivatives J of the four coordinates with respect to the point. It is that of the
    /// optimal point to first order; the midpoint's is larger where the depths differ.
    ///
    /// # Errors
    /// [`TriangulationError::Noise`] for noise that is not positive and finite, and
    /// [`TriangulationError::Point`] for the first point that is not finite, or lies in the plane
    /// of a camera's centre or on the line of both centres.
    ///
    /// ```
    /// use ga_camera::Intrinsics;
    /// use ga_camera::rig::StereoRig;
    /// use ga_camera::triangulation::*;
    ///
    /// let intrinsics = Intrinsics::new([800.0, 800.0], [320.0, 240.0])?;
    /// let identity = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
    /// let rig = StereoRig::from_matrices(intrinsics, intrinsics, identity, [-0.2, 0.0, 0.0])?;
    /// let views = TwoViews::new(&rig.left, &rig.right)?;
    /// let left = PixelColumns { u: &[336.0], v: &[240.0] };
    /// let right = PixelColumns { u: &[320.0], v: &[240.0] };
    /// let (mut points, mut covariances) = Default::default();
    /// views.triangulate(Method::Optimal, left, right, &mut points)?;
    /// views.covariances(0.5, &points, &mut covariances)?;
    /// // The depth is f B/d, so that its deviation is z/d times that of the disparity, √2 σ.
    /// let deviation = covariances.get(0).unwrap()[2][2].sqrt();
    /// assert!((deviation - 10.0 / 16.0 * 0.5_f64.sqrt()).abs() < 1e-12);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn covariances(
        &self,
        noise: f64,
        points: &PointColumns,
        covariances: &mut CovarianceColumns,
    ) -> Result<(), TriangulationError> {
        if !(noise.is_finite() && noise > 0.0) {
            return Err(TriangulationError::Noise(noise));
        }
        let expected = points.x.len();
        for (column, found) in [("y", points.y.len()), ("z", points.z.len())] {
            if found != expected {
                return Err(TriangulationError::Length {
                    column,
                    expected,
                    found,
                });
            }
        }
        covariances.resize(expected);
        let mut passed = true;
        Batch::on(self.instructions).run(Covariances {
            views: self,
            variance: noise * noise,
            points,
            covariances,
            passed: &mut passed,
        });
        if passed {
            return Ok(());
        }
        let variances = covariances.xx.iter().zip(&covariances.yy);
        let sums = variances.zip(&covariances.zz).map(|((x, y), z)| x + y + z);
        let point = sums.take_while(|sum| is_variance(*sum)).count();
        Err(TriangulationError::NotFinite.of_point(point))
    }

    /// The first pair that determines no point, and why.
    fn first_error(
        &self,
        method: Method,
        left: PixelColumns<'_>,
        right: PixelColumns<'_>,
    ) -> TriangulationError {
        let kernel = PointKernel {
            method,
            rays: self.rays,
            meetings: self.meetings,
            epipolar: self.epipolar,
        };
        for point in 0..left.u.len() {
            let pixels = [left.get(point), right.get(point)];
            if !kernel.row(pixels).passed {
                let [left, right] = pixels;
                let sine = self.rays.pair(left, right).angle().sine();
                let error = if pixels.iter().flatten().all(|u| u.is_finite())
                    && sine.is_finite()
                    // Without a root, the limit is rounded in another way.
                    && sine <= PARALLEL * (1.0 + 8.0 * f64::EPSILON)
                {
                    TriangulationError::Parallel { sine }
                } else {
                    TriangulationError::NotFinite
                };
                return error.of_point(point);
            }
        }
        TriangulationError::NotFinite.of_point(0)
    }
}

/// The reciprocals of two numbers by one division.
#[inline(always)]
fn reciprocals<S: Real>(a: S, b: S) -> [S; 2] {
    let both = (a * b).recip();
    [b * both, a * both]
}

/// Two views and what is computed of them.
struct PointKernel<S> {
    method: Method,
    rays: Rays<S>,
    meetings: Meetings<S>,
    epipolar: Epipolar<S>,
}

impl<S: Real> PointKernel<S> {
    /// The point of one pair of pixels.
    #[inline(always)]
    fn row(&self, [left, right]: [[S; 2]; 2]) -> Row<S> {
        let (angle, [by_square, by_norm], moment, position, depths);
        match self.method {
            Method::Midpoint => {
                let pair = self.rays.pair(left, right);
                (angle, moment) = (pair.angle(), pair.height);
                [by_square, by_norm] = reciprocals(angle.square, angle.norm());
                depths = pair.depths.map(|depth| depth * by_square);
                position = Vector::from(self.rays.middle(&pair, by_square));
            }
            Method::DepthWeighted | Method::Optimal => {
                let measured = self.meetings.measured(left, right);
                (angle, moment) = (measured.angle, measured.moment);
                let meeting = if self.method == Method::Optimal {
                    let corrected = self.epipolar.nearest(left, right);
                    self.meetings.corrected(corrected, &measured)
                } else {
                    self.meetings.after_step(&measured)
                };
                // Its own division: the angle does not wait for the meeting.
                [by_square, by_norm] = reciprocals(angle.square, angle.norm());
                (position, depths) = self.meetings.place(&meeting, meeting.divisor.recip());
            }
        }
        let [gap, parallax] = angle.gap_and_angle(moment, by_square, by_norm);
        let [x, y, z] = position.coordinates();
        let largest = x.abs() + y.abs() + z.abs() + gap + depths[0] + depths[1];
        let least = S::from_f64(PARALLEL * PARALLEL);
        Row {
            position,
            gap,
            angle: parallax,
            depths,
            passed: largest.is_finite() & least.less_than(angle.square * by_norm),
        }
    }
}

impl Kernel<4, 7> for PointKernel<f64> {
    #[inline(always)]
    fn compute(&self, [u, v, x, y]: [f64; 4]) -> ([f64; 7], bool) {
        let row = self.row([[u, v], [x, y]]);
        let [x, y, z] = row.position.coordinates();
        let [s, t] = row.depths;
        ([x, y, z, row.gap, row.angle, s, t], row.passed)
    }
}

/// A point with what belongs to it.
struct Row<S: Real> {
    position: Vector<S>,
    gap: S,
    angle: S,
    depths: [S; 2],
    passed: S::Mask,
}

fn same_length<'a>(
    left: PixelColumns<'a>,
    right: PixelColumns<'a>,
) -> Result<[&'a [f64]; 4], TriangulationError> {
    let expected = left.u.len();
    let columns = [
        ("the v column of the left view", left.v),
        ("the u column of the right view", right.u),
        ("the v column of the right view", right.v),
    ];
    for (column, slice) in columns {
        if slice.len() != expected {
            return Err(TriangulationError::Length {
                column,
                expected,
                found: slice.len(),
            });
        }
    }
    Ok([left.u, left.v, right.u, right.v])
}

/// The loop over pairs of pixels.
struct Points<'a> {
    views: &'a TwoViews,
    method: Method,
    inputs: [&'a [f64]; 4],
    points: &'a mut PointColumns,
    passed: &'a mut bool,
}

impl Points<'_> {
    #[inline(always)]
    fn by(self, method: Method) {
        let kernel = PointKernel {
            method,
            rays: self.views.rays,
            meetings: self.views.meetings,
            epipolar: self.views.epipolar,
        };
        *self.passed = by_blocks(self.inputs, self.points.slices(), &kernel);
    }
}

impl Work for Points<'_> {
    #[inline(always)]
    fn run(self) {
        // One loop for each method.
        match self.method {
            Method::Midpoint => self.by(Method::Midpoint),
            Method::DepthWeighted => self.by(Method::DepthWeighted),
            Method::Optimal => self.by(Method::Optimal),
        }
    }
}

/// The loop over points for their covariances.
struct Covariances<'a> {
    views: &'a TwoViews,
    variance: f64,
    points: &'a PointColumns,
    covariances: &'a mut CovarianceColumns,
    passed: &'a mut bool,
}

/// Both cameras and the variance of a coordinate of a pixel.
struct CovarianceKernel {
    sights: [Sight; 2],
    variance: f64,
}

/// Whether the sum of the variances of a point's coordinates is one.
#[inline(always)]
fn is_variance(sum: f64) -> bool {
    sum.is_finite() & (sum > 0.0)
}

impl Kernel<3, 6> for CovarianceKernel {
    #[inline(always)]
    fn compute(&self, [x, y, z]: [f64; 3]) -> ([f64; 6], bool) {
        let entries = covariance(&self.sights, Vector::new(x, y, z), self.variance);
        (entries, is_variance(entries[0] + entries[3] + entries[5]))
    }
}

impl Work for Covariances<'_> {
    #[inline(always)]
    fn run(self) {
        let kernel = CovarianceKernel {
            sights: self.views.sights,
            variance: self.variance,
        };
        let inputs = [&*self.points.x, &self.points.y, &self.points.z];
        *self.passed = by_blocks(inputs, self.covariances.slices(), &kernel);
    }
}
