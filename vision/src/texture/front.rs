//! What is in front: the surface at each pixel of a view.

use ga_image::plane::Plane;
use ga_mesh::query::Bvh;
use ga_runtime::cga3::{Motor, Point};
use ga_runtime::geometry::ray::Ray;
use ga_runtime::vga3::Vector;
use rayon::prelude::*;

use super::geometry::Placed;
use ga_camera::{Camera, Intrinsics};

/// How a texel is seen.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Sight {
    /// All pixels far around it show the surface near it.
    Inner,
    /// All pixels around it do, though not all of those farther away.
    Clear,
    /// The nearest pixels show it, and others something else.
    Edge,
    /// It is hidden, or its colour would be mixed with another.
    Hidden,
}

/// The points that a camera sees at the middles of its pixels, in its frame.
pub(super) struct Front {
    /// NaN where nothing is seen.
    points: Plane<[f32; 3]>,
    /// The greatest focal length in pixels.
    focal: f64,
}

/// How far pixels around a texel have a part in its colour by the spline, how far by the cubic, and
/// how far those that decide it. For a texel larger than a pixel its own extents beyond half a
/// pixel are added.
const REACH: [f64; 3] = [4.0, 1.5, 0.75];

/// A neighbour belongs to the same surface if it is no more than this many pixels away from the
/// tangent plane.
const HEIGHT: f64 = 2.0;

impl Front {
    pub(super) fn new(camera: &Camera, [width, height]: [usize; 2], bvh: &Bvh) -> Self {
        let to_world = camera.world_to_camera.reverse();
        let intrinsics = &camera.intrinsics;
        let rows = (0..height).into_par_iter().flat_map_iter(|row| {
            (0..width).map(move |column| {
                let pixel = [column as f64, row as f64];
                seen(pixel, intrinsics, to_world, bvh).unwrap_or([f32::NAN; 3])
            })
        });
        let points = Plane::from_values(width, height, rows.collect());
        Self {
            points: points.unwrap_or_default(),
            focal: intrinsics.focal()[0].max(intrinsics.focal()[1]),
        }
    }

    /// How a texel is seen.
    pub(super) fn sight(&self, placed: &Placed) -> Sight {
        let [far, wide, narrow] = REACH;
        if !self.shows(placed, narrow) {
            Sight::Hidden
        } else if !self.shows(placed, wide) {
            Sight::Edge
        } else if !self.shows(placed, far) {
            Sight::Clear
        } else {
            Sight::Inner
        }
    }

    /// Whether the pixels around a texel show nothing but the surface near it: neither something in
    /// front of it, nor what is behind its edge.
    fn shows(&self, placed: &Placed, reach: f64) -> bool {
        let beyond = placed.extents().map(|extent| (extent - 0.5).max(0.0));
        let pixels = 1.0 + 2.0 * beyond[0].max(beyond[1]);
        let tolerance = HEIGHT * pixels * placed.point.length() / self.focal;
        let last = [self.points.width() - 1, self.points.height() - 1];
        // The middle comes first, since it decides most often.
        let [across, along] = beyond.map(|beyond| [0.0, -reach - beyond, reach + beyond]);
        along.into_iter().all(|down| {
            across.into_iter().all(|right| {
                let [column, row] = [(0, right), (1, down)].map(|(axis, offset)| {
                    let place = (placed.pixel[axis] + offset).round();
                    place.clamp(0.0, last[axis] as f64) as usize
                });
                let seen = self.points.row(row)[column].map(f64::from);
                let height = placed.normal.dot(Vector::from(seen) - placed.point);
                // A comparison with NaN is false.
                height.abs() <= tolerance
            })
        })
    }
}

/// The point that is seen at a pixel.
fn seen(
    pixel: [f64; 2],
    intrinsics: &Intrinsics,
    to_world: Motor<f64>,
    bvh: &Bvh,
) -> Option<[f32; 3]> {
    let direction = intrinsics.direction(pixel).ok()?;
    let ray = Ray::new_unchecked(Point::default(), direction);
    let found = bvh.first_hit(to_world.transform(ray))?;
    let place = Vector::from(direction.vector()) * found.hit.distance;
    Some(place.coordinates().map(|x| x as f32))
}
