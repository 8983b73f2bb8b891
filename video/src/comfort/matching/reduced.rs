//! A view of fewer pixels, and the contrast around each.

use ga_image::filter::{Border, Gaussian};
use ga_image::plane::{Plane, PlaneView};
use ga_runtime::batch::{Batch, Work};

use crate::keyframe::signature::box_means_into;

/// The number of pixels on either side of a pixel of a reduced view in its surroundings.
pub(super) const RADIUS: usize = 4;

/// Columns and rows of the surroundings.
pub(super) const SIDE: usize = 2 * RADIUS + 1;

/// Surroundings with a smaller standard deviation, in levels, count as flat.
const FLAT: f32 = 1.0;

/// What is subtracted from levels: the middle of the codes, which keeps sums small.
pub(super) const ZERO: f32 = 128.0;

/// A reduced view.
#[derive(Clone, Debug)]
pub(super) struct Reduced {
    /// The means over boxes, less [`ZERO`].
    pub(super) levels: Plane,
    /// 1 / √Σ (I − mean)² over the surroundings of each pixel that has all of them; 0 elsewhere.
    pub(super) reciprocal_norms: Plane,
    /// Sums over columns of the surroundings, of levels and of their squares.
    sums: [Vec<f32>; 2],
}

impl Reduced {
    pub(super) fn new([width, height]: [usize; 2]) -> Self {
        Self {
            levels: Plane::filled(width, height, 0.0),
            reciprocal_norms: Plane::filled(width, height, 0.0),
            sums: [(); 2].map(|()| vec![0.0; width]),
        }
    }

    pub(super) fn size(&self) -> [usize; 2] {
        [self.levels.width(), self.levels.height()]
    }

    /// The view of these pixels, of which each box of `factor` × `factor` becomes one. What is left
    /// at the right and lower border is left out.
    pub(super) fn update(&mut self, view: PlaneView<'_, u8>, factor: usize) {
        let [width, height] = self.size();
        let Some(part) = view.part(0, 0, factor * width, factor * height) else {
            return;
        };
        box_means_into(part, &mut self.levels);
        for level in self.levels.values_mut() {
            *level -= ZERO;
        }
        Batch::new().run(Norms(self));
    }

    /// Removes details that a blurred view does not have.
    pub(super) fn smooth(&mut self) {
        /// The standard deviation in pixels of the reduced view.
        const SIGMA: f64 = 2.0;
        if let Ok(gaussian) = Gaussian::new(SIGMA) {
            self.levels = gaussian.blur(&self.levels, Border::Mirror);
            Batch::new().run(Norms(self));
        }
    }
}

struct Norms<'a>(&'a mut Reduced);

impl Work for Norms<'_> {
    #[inline(always)]
    fn run(self) {
        const COUNT: f32 = (SIDE * SIDE) as f32;
        let [width, height] = self.0.size();
        let Reduced {
            levels,
            reciprocal_norms,
            sums: [sums, squares],
        } = self.0;
        for row in RADIUS..height - RADIUS {
            sums.fill(0.0);
            squares.fill(0.0);
            for near in row - RADIUS..=row + RADIUS {
                let columns = sums.iter_mut().zip(squares.iter_mut());
                for ((sum, square), level) in columns.zip(levels.row(near)) {
                    *sum += level;
                    *square += level * level;
                }
            }
            let targets = &mut reciprocal_norms.row_mut(row)[RADIUS..width - RADIUS];
            for (column, norm) in targets.iter_mut().enumerate() {
                let (mut sum, mut square) = (0.0, 0.0);
                for near in 0..SIDE {
                    sum += sums[column + near];
                    square += squares[column + near];
                }
                let spread = square - sum * sum / COUNT;
                *norm = 1.0 / spread.max(FLAT * FLAT * COUNT).sqrt();
            }
        }
    }
}
