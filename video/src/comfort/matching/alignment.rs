//! The alignment of the surroundings of a point to a fraction of a pixel.

use ga_image::plane::PlaneView;

/// Where the surroundings of a pixel of the left view lie in the right view.
#[derive(Clone, Copy, Debug)]
pub(super) struct Aligned {
    /// From the left pixel to the place in the right view.
    pub(super) offset: [f32; 2],
    /// The standard deviation of the offset.
    pub(super) deviation: [f32; 2],
    /// The mean levels in the left and in the right view.
    pub(super) means: [f32; 2],
    pub(super) correlation: f32,
}

/// The greatest number of columns of surroundings.
const WIDEST: usize = 16;

/// Numbers of the surroundings by rows, of which the first columns of each are used.
type Patch = [[f32; WIDEST]; WIDEST];

/// Moves the surroundings of a pixel in the right view until they agree with those in the left view
/// up to a gain and a bias, by Gauss and Newton's method with the slopes of the left view (S. Baker
/// and I. Matthews, "Lucas-Kanade 20 years on: a unifying framework", International Journal of
/// Computer Vision 56, 2004). Gain and bias are those of least squares for each offset: the slopes
/// are made orthogonal to them.
///
/// `None` where the surroundings leave a view, are flat or alike along a line, or where the steps
/// go farther than `farthest` or do not converge.
#[inline(always)]
pub(super) fn align<T: Copy + Into<f32>, const RADIUS: usize>(
    [left, right]: [PlaneView<'_, T>; 2],
    pixel: [usize; 2],
    start: [f32; 2],
    farthest: f32,
) -> Option<Aligned> {
    const STEPS: usize = 12;
    const FINE: f32 = 0.005;
    let side = 2 * RADIUS + 1;
    let count = (side * side) as f32;
    let template = Template::new::<T, RADIUS>(left, pixel)?;
    let mut offset = start;
    let mut samples: Patch = [[0.0; WIDEST]; WIDEST];
    for _ in 0..STEPS {
        sample::<T, RADIUS>(right, pixel, offset, template.mean, &mut samples)?;
        let [sum, square, product, along_x, along_y] = template.products::<RADIUS>(&samples);
        let gain = product / template.spread;
        let spread = square - sum * sum / count;
        if !(0.1..10.0).contains(&gain) || spread <= 0.0 {
            return None;
        }
        let step = template.solve([along_x / gain, along_y / gain]);
        offset = [offset[0] - step[0], offset[1] - step[1]];
        let moved = (offset[0] - start[0]).hypot(offset[1] - start[1]);
        // A step that is not a number leads nowhere.
        if moved.is_nan() || moved > farthest {
            return None;
        }
        if step[0].hypot(step[1]) < FINE {
            // Two of the numbers are used up by gain and bias, two by the offset.
            let residual = (spread - gain * product).max(0.0) / (count - 4.0);
            let variance = residual / (gain * gain);
            return Some(Aligned {
                offset,
                deviation: template.inverse_diagonal().map(|x| (variance * x).sqrt()),
                means: [template.mean, template.mean + sum / count],
                correlation: gain * (template.spread / spread).sqrt(),
            });
        }
    }
    None
}

/// The surroundings in the left view, prepared.
struct Template {
    /// Levels less their mean.
    levels: Patch,
    /// Slopes along columns and rows, orthogonal to a constant and to the levels.
    slopes: [Patch; 2],
    mean: f32,
    /// Σ levels².
    spread: f32,
    /// Σ of the products of slopes: xx, xy and yy.
    normal: [f32; 3],
}

impl Template {
    #[inline(always)]
    fn new<T: Copy + Into<f32>, const RADIUS: usize>(
        view: PlaneView<'_, T>,
        [column, row]: [usize; 2],
    ) -> Option<Self> {
        /// The least share of the squared slope that the steepest direction leaves to the other.
        const LEAST_SHARE: f32 = 0.02;
        let side = 2 * RADIUS + 1;
        let count = (side * side) as f32;
        let (left, above) = (
            column.checked_sub(RADIUS + 1)?,
            row.checked_sub(RADIUS + 1)?,
        );
        // With one more pixel on each side, for the slopes.
        let part = view.part(left, above, side + 2, side + 2)?;
        let mut padded = [[0.0; WIDEST + 2]; WIDEST + 2];
        for (target, source) in padded.iter_mut().zip(part.rows()) {
            for (target, level) in target.iter_mut().zip(source) {
                *target = (*level).into();
            }
        }
        let mut levels: Patch = [[0.0; WIDEST]; WIDEST];
        let mut slopes = [levels; 2];
        let mut sums = [0.0_f32; 3];
        for r in 0..side {
            for c in 0..side {
                let values = [
                    padded[r + 1][c + 1],
                    0.5 * (padded[r + 1][c + 2] - padded[r + 1][c]),
                    0.5 * (padded[r + 2][c + 1] - padded[r][c + 1]),
                ];
                levels[r][c] = values[0];
                slopes[0][r][c] = values[1];
                slopes[1][r][c] = values[2];
                for (sum, value) in sums.iter_mut().zip(values) {
                    *sum += value;
                }
            }
        }
        let [mean, mean_x, mean_y] = sums.map(|sum| sum / count);
        let mut products = [0.0_f32; 3];
        for r in 0..side {
            for c in 0..side {
                levels[r][c] -= mean;
                slopes[0][r][c] -= mean_x;
                slopes[1][r][c] -= mean_y;
                products[0] += levels[r][c] * levels[r][c];
                products[1] += levels[r][c] * slopes[0][r][c];
                products[2] += levels[r][c] * slopes[1][r][c];
            }
        }
        let spread = products[0];
        if spread < count {
            return None;
        }
        let parts = [products[1] / spread, products[2] / spread];
        let mut normal = [0.0_f32; 3];
        for r in 0..side {
            for c in 0..side {
                let [x, y] = [0, 1].map(|axis| slopes[axis][r][c] - parts[axis] * levels[r][c]);
                slopes[0][r][c] = x;
                slopes[1][r][c] = y;
                normal[0] += x * x;
                normal[1] += x * y;
                normal[2] += y * y;
            }
        }
        let [xx, xy, yy] = normal;
        let is_corner = xx * yy - xy * xy > LEAST_SHARE * (xx + yy) * (xx + yy) * 0.25;
        is_corner.then_some(Self {
            levels,
            slopes,
            mean,
            spread,
            normal,
        })
    }

    /// Sums over samples of the other view: of the samples, their squares, and their products with
    /// levels and slopes.
    #[inline(always)]
    fn products<const RADIUS: usize>(&self, samples: &Patch) -> [f32; 5] {
        let side = 2 * RADIUS + 1;
        // One sum for each column, which are independent of each other. Columns beyond the
        // surroundings are zero.
        let mut lanes = [[0.0_f32; WIDEST]; 5];
        for (row, line) in samples.iter().enumerate().take(side) {
            for (column, sample) in line.iter().enumerate() {
                lanes[0][column] += sample;
                lanes[1][column] += sample * sample;
                lanes[2][column] += sample * self.levels[row][column];
                lanes[3][column] += sample * self.slopes[0][row][column];
                lanes[4][column] += sample * self.slopes[1][row][column];
            }
        }
        lanes.map(|lane| lane.iter().sum())
    }

    #[inline(always)]
    fn determinant(&self) -> f32 {
        let [xx, xy, yy] = self.normal;
        xx * yy - xy * xy
    }

    #[inline(always)]
    fn solve(&self, [x, y]: [f32; 2]) -> [f32; 2] {
        let [xx, xy, yy] = self.normal;
        let determinant = self.determinant();
        [
            (yy * x - xy * y) / determinant,
            (xx * y - xy * x) / determinant,
        ]
    }

    #[inline(always)]
    fn inverse_diagonal(&self) -> [f32; 2] {
        let [xx, _, yy] = self.normal;
        [yy, xx].map(|x| x / self.determinant())
    }
}

/// The surroundings of a place in the right view less a mean, by bilinear interpolation; `None`
/// where they leave the view.
#[inline(always)]
fn sample<T: Copy + Into<f32>, const RADIUS: usize>(
    view: PlaneView<'_, T>,
    pixel: [usize; 2],
    offset: [f32; 2],
    mean: f32,
    samples: &mut Patch,
) -> Option<()> {
    let side = 2 * RADIUS + 1;
    let place = [0, 1].map(|axis| pixel[axis] as f32 + offset[axis] - RADIUS as f32);
    if !place.iter().all(|x| *x >= 0.0 && *x < 1e6) {
        return None;
    }
    let [x, y] = place.map(|x| x - x.floor());
    let [column, row] = place.map(|x| x as usize);
    let part = view.part(column, row, side + 1, side + 1)?;
    let mut above = [0.0_f32; WIDEST];
    for (index, line) in part.rows().enumerate() {
        let mut current = [0.0_f32; WIDEST];
        for near in 0..side {
            let [first, second]: [f32; 2] = [line[near].into(), line[near + 1].into()];
            current[near] = first + x * (second - first);
        }
        if index > 0 {
            for near in 0..side {
                samples[index - 1][near] = above[near] + y * (current[near] - above[near]) - mean;
            }
        }
        above = current;
    }
    Some(())
}
