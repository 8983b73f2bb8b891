//! Synthetic scenes of flat textured panels, seen by two cameras, whose disparities are known
//! exactly: each pixel is a ray, and the first panel that it hits tells what it shows, how far away
//! it is, and whether the other camera sees it.

mod texture;

use ga_camera::rig::StereoRig;
use ga_camera::{Camera, Intrinsics};
use ga_image::plane::Plane as Pixels;
use ga_runtime::cga3::{Infinity, Point};
use ga_runtime::geometry::ray::Ray;
use ga_runtime::vga3::Vector;
use ga_vision::disparity::DisparityMap;

use texture::Texture;

/// A surface hides what is further away than it by more than this, in metres.
const BEHIND: f64 = 1e-6;

/// A parallelogram with a texture.
pub(crate) struct Panel {
    corner: Point<f64>,
    sides: [Vector<f64>; 2],
    texture: Texture,
}

impl Panel {
    /// The panel with this corner and these sides, which are perpendicular; `grain` is the length
    /// in metres of the shortest waves of the texture.
    pub(crate) fn new(corner: [f64; 3], sides: [[f64; 3]; 2], grain: f64, seed: u64) -> Self {
        Self {
            corner: corner.into(),
            sides: sides.map(Vector::from),
            texture: Texture::new(grain, seed),
        }
    }

    /// A panel parallel to the pictures at a depth, from one corner to the opposite one, as seen by
    /// a camera with these intrinsics: the corners are pixels.
    pub(crate) fn facing(
        intrinsics: Intrinsics,
        depth: f64,
        [from, to]: [[f64; 2]; 2],
        grain_px: f64,
        seed: u64,
    ) -> Self {
        let ([f, _], [cx, cy]) = (intrinsics.focal(), intrinsics.principal());
        let at = |[u, v]: [f64; 2]| [(u - cx) / f * depth, (v - cy) / f * depth];
        let ([x, y], [right, bottom]) = (at(from), at(to));
        let sides = [[right - x, 0.0, 0.0], [0.0, bottom - y, 0.0]];
        Self::new([x, y, depth], sides, grain_px * depth / f, seed)
    }

    /// Where a ray hits the panel: the distance along the ray, and the place on the panel in metres
    /// along its sides.
    fn hit(&self, ray: Ray<f64>) -> Option<(f64, [f64; 2])> {
        let [first, second] = self.sides.map(|side| self.corner + side);
        let hit = ray.first_hit(self.corner ^ first ^ second ^ Infinity)?;
        let place = self.corner.vector_to(hit.point);
        let along = self.sides.map(|side| place.dot(side) / side.length());
        let within = (0..2).all(|k| (0.0..=self.sides[k].length()).contains(&along[k]));
        within.then_some((hit.distance, along))
    }
}

/// What the right camera sees of what a pixel of the left view shows.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Seen {
    /// The same point.
    ByBoth,
    /// A point in front of it.
    Occluded,
    /// It lies beside the right view.
    OutOfView,
}

/// Panels and the rig that looks at them.
pub(crate) struct Scene {
    pub(crate) rig: StereoRig,
    pub(crate) size: [usize; 2],
    pub(crate) panels: Vec<Panel>,
}

/// The views of a scene, and what is true for each pixel of the left one.
pub(crate) struct Views {
    pub(crate) left: Pixels<u8>,
    pub(crate) right: Pixels<u8>,
    pub(crate) truth: DisparityMap,
    pub(crate) seen: Pixels<Seen>,
}

impl Scene {
    /// Two equal cameras side by side, with parallel axes.
    pub(crate) fn new(focal: f64, baseline: f64, size: [usize; 2]) -> Self {
        let centre = size.map(|side| (side as f64 - 1.0) / 2.0);
        let intrinsics = Intrinsics::new([focal, focal], centre).unwrap();
        let identity = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
        let displacement = [-baseline, 0.0, 0.0];
        let rig = StereoRig::from_matrices(intrinsics, intrinsics, identity, displacement);
        Self {
            rig: rig.unwrap(),
            size,
            panels: Vec::new(),
        }
    }

    /// The two views. Every ray must hit a panel.
    pub(crate) fn views(&self) -> Views {
        let [width, height] = self.size;
        let mut seen = Pixels::filled(width, height, Seen::ByBoth);
        let truth = Pixels::from_fn(width, height, |column, row| {
            let (disparity, state) = self.truth([column as f64, row as f64]);
            seen.values_mut()[row * width + column] = state;
            disparity as f32
        });
        Views {
            left: self.picture(&self.rig.left),
            right: self.picture(&self.rig.right),
            truth: DisparityMap::new(truth),
            seen,
        }
    }

    /// The disparity of a pixel of the left view, and what the right camera sees.
    pub(crate) fn truth(&self, pixel: [f64; 2]) -> (f64, Seen) {
        let ray = self.rig.left.ray(pixel).unwrap();
        let (distance, _) = self.first_hit(ray).unwrap();
        let point = ray.at(distance);
        let [u, _] = self.rig.right.project(point).unwrap();
        let back = Ray::through(self.rig.right.centre(), point).unwrap();
        let nearest = self.first_hit(back).unwrap().0;
        let seen = if u < -0.5 || u >= self.size[0] as f64 - 0.5 {
            Seen::OutOfView
        } else if nearest < back.depth(point) - BEHIND {
            Seen::Occluded
        } else {
            Seen::ByBoth
        };
        (pixel[0] - u, seen)
    }

    /// The distance along a ray, and the level of grey there.
    fn first_hit(&self, ray: Ray<f64>) -> Option<(f64, f64)> {
        let hits = self.panels.iter().filter_map(|panel| {
            let (distance, place) = panel.hit(ray)?;
            Some((distance, panel, place))
        });
        let (distance, panel, place) = hits.min_by(|a, b| a.0.total_cmp(&b.0))?;
        Some((distance, panel.texture.level(place)))
    }

    /// What a camera sees, each pixel the mean of 2 × 2 rays.
    fn picture(&self, camera: &Camera) -> Pixels<u8> {
        Pixels::from_fn(self.size[0], self.size[1], |column, row| {
            let level = |dx: f64, dy: f64| {
                let ray = camera.ray([column as f64 + dx, row as f64 + dy]).unwrap();
                self.first_hit(ray).unwrap().1
            };
            let quarter = 0.25;
            let upper = level(-quarter, -quarter) + level(quarter, -quarter);
            let lower = level(-quarter, quarter) + level(quarter, quarter);
            (0.25 * (upper + lower)).round() as u8
        })
    }
}
