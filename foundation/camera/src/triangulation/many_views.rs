//! A point that any number of cameras see.

use ga_numerics::least_squares::{Attempt, Damping, Descent, Search};
use ga_runtime::cga3::Point;
use ga_runtime::geometry::ray::Ray;
use ga_runtime::vga3::Vector;
use nalgebra_035::{Matrix3, Vector3};

use super::TriangulationError;
use crate::Camera;

/// A point that several cameras see, and how well they agree on it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ManyViewsPoint {
    /// Where it is in the world.
    pub position: Point<f64>,
    /// The largest distance of the point from a ray, in metres.
    pub gap: f64,
    /// The largest angle between two rays in radians, in (0, π].
    pub angle: f64,
    /// The least depth in front of a camera, along its optical axis, in metres.
    pub depth: f64,
    /// The root mean square of the distances between its projections and the pixels, in pixels.
    pub error_px: f64,
    /// `(JᵀJ)⁻¹` in square metres for each square pixel, with the derivatives J of all coordinates
    /// of pixels with respect to the point: the covariance of the point for independent noise with
    /// a standard deviation of one pixel.
    pub covariance: [[f64; 3]; 3],
}

/// The largest number of steps; each at least halves what is left in practice.
const STEPS: usize = 100;
const DAMPING: Damping = Damping {
    first: 1e-6,
    least: 1e-15,
    greatest: 1e6,
};
/// The sine of an angle below which rays count as parallel.
const PARALLEL: f64 = 32.0 * f64::EPSILON;

/// The point whose projections are nearest to the pixels at which cameras see it: the sum of the
/// squared distances in all pictures is least.
///
/// It begins at the point nearest to all rays, weighted by focal length and depth, and goes on by
/// the method of Gauss and Newton, damped after Levenberg and Marquardt, until a step no longer
/// changes the point. Nothing is allocated.
///
/// # Errors
/// [`TriangulationError`] for fewer than two views, another number of pixels than of cameras, a
/// pixel that is not finite or outside the field of a lens, rays that are all parallel, a point
/// behind a camera, and where no least sum was found.
///
/// ```
/// use ga_runtime::cga3::Point;
/// use ga_camera::{Camera, Intrinsics};
/// use ga_camera::triangulation::triangulate_views;
///
/// let intrinsics = Intrinsics::new([800.0, 800.0], [320.0, 240.0])?;
/// let point = Point::new(0.1, 1.2, -0.3);
/// let cameras: Vec<Camera> = [[3.0, 1.0, 0.0], [2.0, 1.5, 2.0], [0.0, 1.0, 4.0]]
///     .map(|eye| Camera::look_at(intrinsics, eye.into(), Point::default(), [0.0, 1.0, 0.0]))
///     .into_iter()
///     .flatten()
///     .collect();
/// let pixels = cameras.iter().map(|camera| camera.project(point)).collect::<Result<Vec<_>, _>>()?;
/// let found = triangulate_views(&cameras, &pixels)?;
/// assert!(found.position.distance(point) < 1e-13 && found.error_px < 1e-10);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn triangulate_views(
    cameras: &[Camera],
    pixels: &[[f64; 2]],
) -> Result<ManyViewsPoint, TriangulationError> {
    check(cameras, pixels)?;
    let views = || cameras.iter().zip(pixels);
    let angle = largest_angle(cameras, pixels)?;
    let start = nearest(views(), None)?;
    let start = nearest(views(), Some(start))?;
    // Steps are small against the distances that coordinates are rounded at.
    let reach = cameras.iter().map(|camera| {
        let centre = Vector::from(camera.centre());
        centre.length() + centre.distance(start)
    });
    let size = reach.fold(0.0, f64::max);
    let (point, normal) = descend(start, size, |point| Normal::new(views(), point))?;

    let mut gap: f64 = 0.0;
    let mut depth = f64::INFINITY;
    for (view, (camera, pixel)) in views().enumerate() {
        let ray = ray_of(view, camera, *pixel)?;
        let origin = Vector::from(ray.origin());
        let direction = Vector::from(ray.direction());
        gap = gap.max((point - origin).cross(direction).length());
        let [_, _, z] = camera
            .world_to_camera
            .transform(Point::from(point))
            .coordinates();
        depth = depth.min(z);
    }
    let inverse = normal.matrix.try_inverse();
    let inverse = inverse.ok_or(TriangulationError::NotFinite)?;
    Ok(ManyViewsPoint {
        position: point.into(),
        gap,
        angle,
        depth,
        error_px: (normal.cost / cameras.len() as f64).sqrt(),
        covariance: [0, 1, 2].map(|row| [0, 1, 2].map(|column| inverse[(row, column)])),
    })
}

fn check(cameras: &[Camera], pixels: &[[f64; 2]]) -> Result<(), TriangulationError> {
    if cameras.len() != pixels.len() {
        return Err(TriangulationError::Counts {
            cameras: cameras.len(),
            pixels: pixels.len(),
        });
    }
    if cameras.len() < 2 {
        return Err(TriangulationError::TooFewViews {
            found: cameras.len(),
        });
    }
    Ok(())
}

fn ray_of(view: usize, camera: &Camera, pixel: [f64; 2]) -> Result<Ray<f64>, TriangulationError> {
    let ray = camera.ray(pixel);
    ray.map_err(|error| TriangulationError::of_view(view, error))
}

/// The largest angle between two rays.
fn largest_angle(cameras: &[Camera], pixels: &[[f64; 2]]) -> Result<f64, TriangulationError> {
    let direction = |index: usize| -> Result<Vector<f64>, TriangulationError> {
        Ok(ray_of(index, &cameras[index], pixels[index])?
            .direction()
            .into())
    };
    let (mut largest, mut largest_sine): (f64, f64) = (0.0, 0.0);
    for first in 0..cameras.len() {
        let a = direction(first)?;
        for second in 0..first {
            let b = direction(second)?;
            let sine = a.cross(b).length();
            largest_sine = largest_sine.max(sine);
            largest = largest.max(sine.atan2(a.dot(b)));
        }
    }
    if largest_sine <= PARALLEL {
        return Err(TriangulationError::Parallel { sine: largest_sine });
    }
    Ok(largest)
}

/// The point nearest to all rays: the sum of the squared distances is least. Where a place near it
/// is known, the distances are weighted by focal length and depth, as errors in pictures.
fn nearest<'a>(
    views: impl Iterator<Item = (&'a Camera, &'a [f64; 2])>,
    near: Option<Vector<f64>>,
) -> Result<Vector<f64>, TriangulationError> {
    let (mut matrix, mut right) = (Matrix3::zeros(), Vector3::zeros());
    for (view, (camera, pixel)) in views.enumerate() {
        let ray = ray_of(view, camera, *pixel)?;
        let direction = column(ray.direction().into());
        let weight = near.map_or(1.0, |near| {
            let [fx, fy] = camera.intrinsics.focal();
            let [_, _, depth] = camera
                .world_to_camera
                .transform(Point::from(near))
                .coordinates();
            fx * fy / (depth * depth)
        });
        let across = (Matrix3::identity() - direction * direction.transpose()) * weight;
        matrix += across;
        right += across * column(ray.origin().into());
    }
    let place = matrix.cholesky().map(|factors| factors.solve(&right));
    let place = place.filter(|place| place.iter().all(|x| x.is_finite()));
    place
        .map(|place| Vector::new(place.x, place.y, place.z))
        .ok_or(TriangulationError::NotFinite)
}

fn column(vector: Vector<f64>) -> Vector3<f64> {
    Vector3::from(vector.coordinates())
}

/// The normal equations of the errors in all pictures at a point.
#[derive(Clone, Copy)]
struct Normal {
    /// The sum of the squared errors in square pixels.
    cost: f64,
    matrix: Matrix3<f64>,
    gradient: Vector3<f64>,
}

impl Normal {
    /// The view behind which the point lies is an error.
    fn new<'a>(
        views: impl Iterator<Item = (&'a Camera, &'a [f64; 2])>,
        point: Vector<f64>,
    ) -> Result<Self, TriangulationError> {
        let (mut cost, mut matrix, mut gradient) = (0.0, Matrix3::zeros(), Vector3::zeros());
        for (view, (camera, pixel)) in views.enumerate() {
            let seen = camera.project_with_derivatives(point.into());
            let seen = seen.map_err(|error| TriangulationError::of_view(view, error))?;
            for ((slope, found), pixel) in seen.by_point.into_iter().zip(seen.pixel).zip(pixel) {
                let row = Vector3::from(slope);
                let error = found - pixel;
                cost += error * error;
                matrix += row * row.transpose();
                gradient += row * error;
            }
        }
        Ok(Self {
            cost,
            matrix,
            gradient,
        })
    }
}

/// Descends to a least sum of squares, and the normal equations there. `size` is a distance at
/// whose rounding steps end.
fn descend(
    start: Vector<f64>,
    size: f64,
    normal_at: impl Fn(Vector<f64>) -> Result<Normal, TriangulationError>,
) -> Result<(Vector<f64>, Normal), TriangulationError> {
    let normal = normal_at(start)?;
    let mut search = Search::new(normal.cost, DAMPING);
    let mut descent = Descending {
        normal_at,
        size,
        place: (start, normal),
        next: Err(TriangulationError::NotFinite),
    };
    match search.run(&mut descent, STEPS).has_converged {
        true => Ok(descent.place),
        // What refused the last steps, such as a camera that does not see the point.
        false => match descent.next {
            Err(error) => Err(error),
            Ok(_) => Err(TriangulationError::NotConverged { steps: STEPS }),
        },
    }
}

struct Descending<F> {
    normal_at: F,
    size: f64,
    place: (Vector<f64>, Normal),
    next: Result<(Vector<f64>, Normal), TriangulationError>,
}

impl<F: Fn(Vector<f64>) -> Result<Normal, TriangulationError>> Descent for Descending<F> {
    #[inline]
    fn attempt(&mut self, damping: f64) -> Attempt {
        let (point, normal) = &self.place;
        let diagonal = normal.matrix.diagonal();
        let damped = normal.matrix + Matrix3::from_diagonal(&(diagonal * damping));
        let Some(factors) = damped.cholesky() else {
            self.next = Err(TriangulationError::NotFinite);
            return Attempt::NONE;
        };
        let step = factors.solve(&normal.gradient);
        let next = *point - Vector::new(step.x, step.y, step.z);
        let promise = normal.gradient.dot(&step);
        let is_small =
            step.norm() <= 4.0 * f64::EPSILON * self.size || promise <= f64::EPSILON * normal.cost;
        let attempt = Attempt {
            size: step.norm(),
            predicted: promise + damping * diagonal.dot(&step.component_mul(&step)),
            is_small,
            cost: f64::INFINITY,
        };
        self.next = (self.normal_at)(next).map(|found| (next, found));
        let cost = self
            .next
            .as_ref()
            .map_or(f64::INFINITY, |(_, found)| found.cost);
        Attempt { cost, ..attempt }
    }

    #[inline]
    fn accept(&mut self) {
        if let Ok(next) = self.next {
            self.place = next;
        }
    }
}
