//! How much of a camera's picture is seen after its distortion is undone and its axis rotated.

use ga_runtime::cga3::{Direction, Rotor};

use crate::geometry_error::ViewGeometryError;
use ga_camera::{Intrinsics, LensModel};

/// The border is sampled at this number of places along each side.
const SAMPLES: usize = 9;

/// The tangent of the greatest angle from the new axis at which a place of the old picture has a
/// part in the choice of the new one, 80°: further out, a plane picture would be almost empty.
pub(super) const LARGEST_TANGENT: f64 = 5.67;

/// A camera's picture and the rotation to the frame in which it is to be seen.
pub(super) struct View<'a> {
    pub(super) intrinsics: &'a Intrinsics,
    /// Columns and rows of its pictures.
    pub(super) size: [usize; 2],
    pub(super) rotation: Rotor<f64>,
    /// By how many right angles the rotation rolls its pictures, clockwise: 0 to 3.
    pub(super) quarter_turns: u8,
}

/// Bounds `[left, right, top, bottom]` in the plane z = 1 of the new frame.
#[derive(Clone, Copy, Debug)]
pub(super) struct Bounds {
    /// The largest rectangle that is known to be seen.
    pub(super) inner: [f64; 4],
    /// The smallest rectangle around all that is seen.
    pub(super) outer: [f64; 4],
}

impl View<'_> {
    /// Columns and rows of its pictures after the roll.
    pub(super) fn rolled_size(&self) -> [usize; 2] {
        self.rolled(self.size)
    }

    /// The focal length along the rows and along the columns after the roll.
    pub(super) fn rolled_focal(&self) -> [f64; 2] {
        self.rolled(self.intrinsics.focal())
    }

    fn rolled<T>(&self, [across, down]: [T; 2]) -> [T; 2] {
        if self.quarter_turns.is_multiple_of(2) {
            [across, down]
        } else {
            [down, across]
        }
    }

    /// Which side of the new picture, of left, right, top and bottom, a side of the old one is.
    fn rolled_side(&self, side: usize) -> usize {
        // Clockwise.
        const ROUND: [usize; 4] = [1, 3, 0, 2];
        let place = ROUND.iter().position(|other| *other == side).unwrap_or(0);
        ROUND[(place + usize::from(self.quarter_turns)) % 4]
    }

    /// The mean, in the plane z = 1, of what is seen at the corners of the picture, or through a
    /// fisheye in the middles of its sides: what is seen at its corners may be any way out. OpenCV
    /// does so for both.
    pub(super) fn middle(&self) -> Result<[f64; 2], ViewGeometryError> {
        let [right, bottom] = self.last();
        let pixels = match self.intrinsics.lens().model() {
            LensModel::Fisheye => {
                let [u, v] = [0.5 * right, 0.5 * bottom];
                [[u, 0.0], [right, v], [u, bottom], [0.0, v]]
            }
            _ => [[0.0, 0.0], [right, 0.0], [0.0, bottom], [right, bottom]],
        };
        let mut mean = [0.0; 2];
        for pixel in pixels {
            let place = self.place(pixel)?;
            for (sum, x) in mean.iter_mut().zip(place) {
                *sum += 0.25 * x;
            }
        }
        Ok(mean)
    }

    /// The rectangles inside and around what is seen, from a grid of samples of the border.
    pub(super) fn bounds(&self) -> Result<Bounds, ViewGeometryError> {
        let [right, bottom] = self.last();
        let mut inner = [
            f64::NEG_INFINITY,
            f64::INFINITY,
            f64::NEG_INFINITY,
            f64::INFINITY,
        ];
        let mut outer = [
            f64::INFINITY,
            f64::NEG_INFINITY,
            f64::INFINITY,
            f64::NEG_INFINITY,
        ];
        for index in 0..SAMPLES {
            let part = index as f64 / (SAMPLES - 1) as f64;
            let sides = [
                [0.0, part * bottom],
                [right, part * bottom],
                [part * right, 0.0],
                [part * right, bottom],
            ];
            for (side, pixel) in sides.into_iter().enumerate() {
                let [x, y] = self.place(pixel)?;
                let side = self.rolled_side(side);
                let across = if side < 2 { x } else { y };
                inner[side] = if side.is_multiple_of(2) {
                    inner[side].max(across)
                } else {
                    inner[side].min(across)
                };
                outer = [
                    outer[0].min(x),
                    outer[1].max(x),
                    outer[2].min(y),
                    outer[3].max(y),
                ];
            }
        }
        Ok(Bounds { inner, outer })
    }

    /// The coordinates of the last column and row.
    fn last(&self) -> [f64; 2] {
        self.size.map(|count| (count - 1) as f64)
    }

    /// What is seen at a pixel, in the plane z = 1 of the new frame. Where that is outside the
    /// field of the lens or too far from the new axis, the last place on the way there from the
    /// principal point that is not.
    fn place(&self, pixel: [f64; 2]) -> Result<[f64; 2], ViewGeometryError> {
        if let Some(place) = self.seen(pixel) {
            return Ok(place);
        }
        let centre = self.intrinsics.principal();
        let mut last = self.seen(centre).ok_or(ViewGeometryError::Axis)?;
        let (mut low, mut high) = (0.0, 1.0);
        for _ in 0..50 {
            let middle = 0.5 * (low + high);
            let between = [0, 1].map(|k| centre[k] + middle * (pixel[k] - centre[k]));
            match self.seen(between) {
                Some(place) => (low, last) = (middle, place),
                None => high = middle,
            }
        }
        Ok(last)
    }

    fn seen(&self, pixel: [f64; 2]) -> Option<[f64; 2]> {
        let direction: Direction<f64> = self.intrinsics.direction(pixel).ok()?;
        let [x, y, z] = self.rotation.transform(direction).vector();
        let is_near = z > 0.0 && x.hypot(y) <= LARGEST_TANGENT * z;
        is_near.then(|| [x / z, y / z])
    }
}
