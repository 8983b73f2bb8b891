//! How much each view counts at each texel.

use rayon::prelude::*;

use super::covered::Covered;
use super::front::{Front, Sight};
use super::geometry::{Geometry, Placed};
use super::sampler::Reach;
use super::target::Target;
use super::view::View;

/// The least part of its weight that a texel keeps at the edge of what a view sees: it counts only
/// where no other view sees the texel well.
const SHARE_AT_EDGES: f32 = 1e-4;

/// Cosines of the angle of incidence: below the first a view counts as at an edge, from the second
/// on it counts in full.
const COSINES: [f64; 2] = [0.1, 0.3];

/// The weights of a view are zero at the border of its picture and rise over this number of pixels.
const BORDER: f64 = 8.0;

/// How well a texel is seen.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(super) enum Grade {
    Unseen,
    /// Some of the pixels around it show something else.
    Edge,
    /// It is seen, near an edge or at a grazing angle.
    Seen,
    /// It counts in full or nearly so.
    Well,
}

/// The weights of one view.
pub(super) struct Weights {
    /// One for each texel, 0 where it is not seen.
    pub(super) values: Vec<f32>,
    /// How many texels are seen.
    pub(super) seen: usize,
    /// How well each texel is seen.
    pub(super) grades: Vec<Grade>,
    /// Which pixels each texel may depend on.
    pub(super) reaches: Vec<Reach>,
}

impl Weights {
    /// The weights of a view: pixels by area, times the cosine of the angle of incidence, falling
    /// smoothly to nearly zero where the surface is hidden, over `feather` texels.
    pub(super) fn new(
        view: &View,
        geometry: &Geometry,
        target: &Target,
        covered: &Covered,
        feather: usize,
    ) -> Self {
        let size = [view.picture.width(), view.picture.height()];
        let front = Front::new(&view.camera, size, &target.bvh);
        let [fx, fy] = view.camera.intrinsics.focal();
        let weight = |placed: &Placed| {
            let pixels = fx * fy * placed.cosine / placed.point.length_squared();
            (pixels * placed.cosine) as f32
        };
        let look = |texel| {
            let unseen = (0.0, Sight::Hidden);
            let Some(placed) = geometry.place(texel) else {
                return unseen;
            };
            let border = border(placed.pixel, size);
            if border <= 0.0 {
                return unseen;
            }
            match front.sight(&placed) {
                Sight::Hidden => unseen,
                sight => (weight(&placed), sight),
            }
        };
        let is_clear = |sight: Sight| matches!(sight, Sight::Clear | Sight::Inner);
        let found: Vec<(f32, Sight)> = covered.texels.par_iter().map(look).collect();
        let mut soft: Vec<[f32; 1]> = found
            .iter()
            .map(|(_, sight)| [f32::from(u8::from(is_clear(*sight)))])
            .collect();
        covered.smooth(&mut soft, feather);
        let fade = |index: usize| {
            let (weight, sight) = found[index];
            if weight == 0.0 {
                return (0.0, Grade::Unseen);
            }
            let placed = geometry.place(&covered.texels[index]);
            let Some(placed) = placed.filter(|_| is_clear(sight)) else {
                return (weight * SHARE_AT_EDGES, Grade::Edge);
            };
            // Half of the neighbours are hidden at a straight edge.
            let inner = smooth_step(2.0 * f64::from(soft[index][0]) - 1.0);
            let [low, high] = COSINES;
            let facing = smooth_step((placed.cosine - low) / (high - low));
            let share = (inner * facing * border(placed.pixel, size)) as f32;
            let grade = if share > 0.5 {
                Grade::Well
            } else {
                Grade::Seen
            };
            (weight * share.max(SHARE_AT_EDGES), grade)
        };
        let (values, grades): (Vec<f32>, Vec<Grade>) =
            (0..covered.len()).into_par_iter().map(fade).unzip();
        let reach = |(_, sight): &(f32, Sight)| match sight {
            Sight::Inner => Reach::Spline,
            _ => Reach::Near,
        };
        Self {
            reaches: found.iter().map(reach).collect(),
            seen: values.iter().filter(|weight| **weight > 0.0).count(),
            values,
            grades,
        }
    }
}

/// 0 outside of the picture and at its border, 1 well inside of it.
fn border(pixel: [f64; 2], size: [usize; 2]) -> f64 {
    let inside = |axis: usize| {
        let last = size[axis] as f64 - 1.0;
        pixel[axis].min(last - pixel[axis]) + 0.5
    };
    let room = BORDER.min(0.25 * size[0].min(size[1]) as f64);
    smooth_step(inside(0).min(inside(1)) / room)
}

/// 0 up to 0, 1 from 1 on, 3x² − 2x³ between.
fn smooth_step(x: f64) -> f64 {
    let x = x.clamp(0.0, 1.0);
    x * x * (3.0 - 2.0 * x)
}
