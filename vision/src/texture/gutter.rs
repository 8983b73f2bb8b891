//! What is between charts.

use ga_image::plane::Plane;
use ga_mesh::bake::Texels;

/// The number of texels around charts that are copies of their border.
const COPIES: u32 = 4;

/// Fills the texels that show nothing, so that neither interpolation nor smaller copies of the
/// texture (mip levels) mix anything else into the charts: copies of the nearest texels around
/// each chart, and beyond them the mean colours of larger and larger squares of the texture
/// (pull and push; S. Gortler, R. Grzeszczuk, R. Szeliski and M. Cohen, The Lumigraph, 1996).
pub(super) fn fill(texture: &mut Plane<[f32; 3]>, known: &mut [bool], texels: &Texels) {
    for [target, source] in texels.margin(COPIES) {
        texture.values_mut()[target as usize] = texture.values()[source as usize];
        known[target as usize] = true;
    }
    let side = texture.width();
    let values = texture.values().iter().zip(known.iter());
    let finest = values.map(|([red, green, blue], known)| match known {
        true => [*red, *green, *blue, 1.0],
        false => [0.0; 4],
    });
    let mut levels = vec![Plane::from_values(side, side, finest.collect()).unwrap_or_default()];
    while let Some(last) = levels.last().filter(|last| last.width() > 1) {
        let next = pulled(last);
        levels.push(next);
    }
    // From the coarsest, every square that knows nothing takes the colour of the one it is in.
    for level in (0..levels.len().saturating_sub(1)).rev() {
        let (fine, coarse) = levels.split_at_mut(level + 1);
        let width = fine[level].width();
        for (place, value) in fine[level].values_mut().iter_mut().enumerate() {
            if value[3] == 0.0 {
                *value = coarse[0].row(place / width / 2)[place % width / 2];
            }
        }
    }
    let filled = levels[0].values().iter();
    for (value, [red, green, blue, _]) in texture.values_mut().iter_mut().zip(filled) {
        *value = [*red, *green, *blue];
    }
}

/// The means of squares of 2 × 2 texels, as far as they are known; the last number says whether one
/// is.
fn pulled(fine: &Plane<[f32; 4]>) -> Plane<[f32; 4]> {
    let side = fine.width().div_ceil(2);
    Plane::from_fn(side, side, |column, row| {
        let mut sum = [0.0; 4];
        for (right, down) in [(0, 0), (1, 0), (0, 1), (1, 1)] {
            let value = fine.get(2 * column + right, 2 * row + down);
            let value = value.filter(|value| value[3] > 0.0).unwrap_or_default();
            for (sum, x) in sum.iter_mut().zip(value) {
                *sum += x;
            }
        }
        match sum[3] > 0.0 {
            true => sum.map(|x| x / sum[3]),
            false => sum,
        }
    })
}
