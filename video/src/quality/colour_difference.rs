//! The difference of colours as people see it.

use ga_image::plane::Plane;
use palette::color_difference::Ciede2000;
use palette::white_point::D65;
use palette::{IntoColor, Lab, Srgb};
use rayon::prelude::*;

/// The mean over the pixels of the difference CIEDE2000 of two pictures in sRGB: 0 where they are
/// equal, about 1 where the difference can just be seen side by side (G. Sharma, W. Wu, E. N.
/// Dalal, "The CIEDE2000 color-difference formula", 2005). White is D65. Where the sizes differ,
/// what both have counts.
///
/// ```
/// use ga_image::plane::Plane;
/// use ga_video::quality::mean_ciede2000;
///
/// let [black, white] = [0u8, 255].map(|level| Plane::filled(4, 2, [level; 3]));
/// assert_eq!(mean_ciede2000(&black, &black), 0.0);
/// assert!((mean_ciede2000(&black, &white) - 100.0).abs() < 1e-3);
/// ```
#[must_use]
pub fn mean_ciede2000(reference: &Plane<[u8; 3]>, distorted: &Plane<[u8; 3]>) -> f64 {
    let rows = reference.height().min(distorted.height());
    let width = reference.width().min(distorted.width());
    let difference = |(a, b): (&[u8; 3], &[u8; 3])| match a == b {
        true => 0.0,
        false => f64::from(lab(*a).difference(lab(*b))),
    };
    // Sums of rows, in their order, do not depend on the number of threads.
    let sums = (0..rows).into_par_iter().map(|row| {
        let pairs = reference.row(row).iter().zip(distorted.row(row));
        pairs.map(difference).sum::<f64>()
    });
    let sums: Vec<f64> = sums.collect();
    sums.iter().sum::<f64>() / (rows * width).max(1) as f64
}

fn lab([red, green, blue]: [u8; 3]) -> Lab<D65, f32> {
    Srgb::new(red, green, blue)
        .into_linear::<f32>()
        .into_color()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The pairs of Sharma, Wu and Dalal, table 1, that exercise each branch of the formula.
    #[test]
    fn the_library_has_the_printed_numbers() {
        let pairs: [([f64; 3], [f64; 3], f64); 34] = [
            ([50.0, 2.6772, -79.7751], [50.0, 0.0, -82.7485], 2.0425),
            ([50.0, 3.1571, -77.2803], [50.0, 0.0, -82.7485], 2.8615),
            ([50.0, 2.8361, -74.0200], [50.0, 0.0, -82.7485], 3.4412),
            ([50.0, -1.3802, -84.2814], [50.0, 0.0, -82.7485], 1.0000),
            ([50.0, -1.1848, -84.8006], [50.0, 0.0, -82.7485], 1.0000),
            ([50.0, -0.9009, -85.5211], [50.0, 0.0, -82.7485], 1.0000),
            ([50.0, 0.0, 0.0], [50.0, -1.0, 2.0], 2.3669),
            ([50.0, -1.0, 2.0], [50.0, 0.0, 0.0], 2.3669),
            ([50.0, 2.4900, -0.0010], [50.0, -2.4900, 0.0009], 7.1792),
            ([50.0, 2.4900, -0.0010], [50.0, -2.4900, 0.0010], 7.1792),
            ([50.0, 2.4900, -0.0010], [50.0, -2.4900, 0.0011], 7.2195),
            ([50.0, 2.4900, -0.0010], [50.0, -2.4900, 0.0012], 7.2195),
            ([50.0, -0.0010, 2.4900], [50.0, 0.0009, -2.4900], 4.8045),
            ([50.0, -0.0010, 2.4900], [50.0, 0.0010, -2.4900], 4.8045),
            ([50.0, -0.0010, 2.4900], [50.0, 0.0011, -2.4900], 4.7461),
            ([50.0, 2.5, 0.0], [50.0, 0.0, -2.5], 4.3065),
            ([50.0, 2.5, 0.0], [73.0, 25.0, -18.0], 27.1492),
            ([50.0, 2.5, 0.0], [61.0, -5.0, 29.0], 22.8977),
            ([50.0, 2.5, 0.0], [56.0, -27.0, -3.0], 31.9030),
            ([50.0, 2.5, 0.0], [58.0, 24.0, 15.0], 19.4535),
            ([50.0, 2.5, 0.0], [50.0, 3.1736, 0.5854], 1.0000),
            ([50.0, 2.5, 0.0], [50.0, 3.2972, 0.0], 1.0000),
            ([50.0, 2.5, 0.0], [50.0, 1.8634, 0.5757], 1.0000),
            ([50.0, 2.5, 0.0], [50.0, 3.2592, 0.3350], 1.0000),
            (
                [60.2574, -34.0099, 36.2677],
                [60.4626, -34.1751, 39.4387],
                1.2644,
            ),
            (
                [63.0109, -31.0961, -5.8663],
                [62.8187, -29.7946, -4.0864],
                1.2630,
            ),
            (
                [61.2901, 3.7196, -5.3901],
                [61.4292, 2.2480, -4.9620],
                1.8731,
            ),
            (
                [35.0831, -44.1164, 3.7933],
                [35.0232, -40.0716, 1.5901],
                1.8645,
            ),
            (
                [22.7233, 20.0904, -46.6940],
                [23.0331, 14.9730, -42.5619],
                2.0373,
            ),
            (
                [36.4612, 47.8580, 18.3852],
                [36.2715, 50.5065, 21.2231],
                1.4146,
            ),
            (
                [90.8027, -2.0831, 1.4410],
                [91.1528, -1.6435, 0.0447],
                1.4441,
            ),
            (
                [90.9257, -0.5406, -0.9208],
                [88.6381, -0.8985, -0.7239],
                1.5381,
            ),
            (
                [6.7747, -0.2908, -2.4247],
                [5.8714, -0.0985, -2.2286],
                0.6377,
            ),
            (
                [2.0776, 0.0795, -1.1350],
                [0.9033, -0.0636, -0.5514],
                0.9082,
            ),
        ];
        for (first, second, expected) in pairs {
            let [a, b] = [first, second].map(|[l, a, b]| Lab::<D65, f64>::new(l, a, b));
            let found = a.difference(b);
            assert!(
                (found - expected).abs() < 1e-4,
                "{first:?} {second:?}: {found}"
            );
        }
    }

    /// Lab of the primaries of sRGB, as B. Lindbloom's calculator prints them for D65.
    #[test]
    fn colours_have_the_lab_of_srgb() {
        for (rgb, expected) in [
            ([255, 0, 0], [53.24, 80.09, 67.20]),
            ([0, 255, 0], [87.73, -86.18, 83.18]),
            ([0, 0, 255], [32.30, 79.19, -107.86]),
        ] {
            let found = lab(rgb);
            let found = [found.l, found.a, found.b];
            let errors = found
                .iter()
                .zip(expected)
                .map(|(f, e): (&f32, f32)| (f - e).abs());
            assert!(errors.fold(0.0, f32::max) < 0.03, "{rgb:?}: {found:?}");
        }
    }
}
