//! Pictures at a whole fraction of their size.

use ga_image::plane::{Plane, PlaneView};
use ga_runtime::batch::{Batch, Work};

/// The means of squares of `factor` × `factor` pixels, rounded, for a factor of at most 256. At the
/// right and lower border they are means of the pixels that there are.
pub(super) fn reduced(picture: PlaneView<'_, u8>, factor: usize) -> Plane<u8> {
    if factor == 1 {
        return picture.to_plane();
    }
    let [width, height] = [picture.width(), picture.height()].map(|side| side.div_ceil(factor));
    let mut result = Plane::filled(width, height, 0);
    Batch::new().run(Reduction {
        picture,
        factor,
        result: &mut result,
    });
    result
}

struct Reduction<'a> {
    picture: PlaneView<'a, u8>,
    factor: usize,
    result: &'a mut Plane<u8>,
}

impl Work for Reduction<'_> {
    #[inline(always)]
    fn run(self) {
        let factor = self.factor;
        let mut sums = vec![0u16; self.picture.width()];
        for row in 0..self.result.height() {
            let top = row * factor;
            let rows = factor.min(self.picture.height() - top);
            sums.fill(0);
            for row in top..top + rows {
                for (sum, level) in sums.iter_mut().zip(self.picture.row(row)) {
                    *sum += u16::from(*level);
                }
            }
            let mean = |sums: &[u16]| {
                let count = (sums.len() * rows) as u32;
                let sum: u32 = sums.iter().map(|sum| u32::from(*sum)).sum();
                ((sum + count / 2) / count) as u8
            };
            for (target, sums) in self.result.row_mut(row).iter_mut().zip(sums.chunks(factor)) {
                *target = mean(sums);
            }
        }
    }
}
