//! Filters, pyramids and other sizes, compared with sums taken pixel by pixel.

use ga_image::filter::{Border, Gaussian};
use ga_image::plane::Plane;
use ga_image::pyramid::{Pyramid, halved};
use ga_image::resample::{Method, resize};
use proptest::prelude::*;

/// Numbers without a pattern.
fn noise(width: usize, height: usize, seed: u32) -> Plane<[u8; 2]> {
    let mut state = seed | 1;
    Plane::from_fn(width, height, |_, _| {
        [(); 2].map(|()| {
            state = state.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
            (state >> 24) as u8
        })
    })
}

/// SciPy's definitions, by repeated steps instead of remainders.
fn outside(border: Border, mut index: i64, length: i64) -> usize {
    while !(0..length).contains(&index) {
        index = match border {
            Border::Replicate => index.clamp(0, length - 1),
            Border::Reflect if index < 0 => -1 - index,
            Border::Reflect => 2 * length - 1 - index,
            Border::Mirror if length == 1 => 0,
            Border::Mirror if index < 0 => -index,
            Border::Mirror => 2 * length - 2 - index,
        };
    }
    index as usize
}

fn convolved(
    plane: &Plane<[u8; 2]>,
    weights: &[f64],
    border: Border,
    [column, row]: [usize; 2],
) -> [f64; 2] {
    let radius = (weights.len() / 2) as i64;
    let mut sums = [0.0; 2];
    for (dy, wy) in (-radius..).zip(weights) {
        for (dx, wx) in (-radius..).zip(weights) {
            let x = outside(border, column as i64 + dx, plane.width() as i64);
            let y = outside(border, row as i64 + dy, plane.height() as i64);
            let pixel = plane.get(x, y).unwrap();
            for channel in 0..2 {
                sums[channel] += wx * wy * f64::from(pixel[channel]);
            }
        }
    }
    sums
}

proptest! {
    #[test]
    fn the_gaussian_is_a_convolution(
        (width, height) in (1usize..14, 1usize..14),
        sigma in 0.3f64..3.0,
        border in prop::sample::select(&[Border::Reflect, Border::Mirror, Border::Replicate][..]),
        seed in any::<u32>(),
    ) {
        let plane = noise(width, height, seed);
        let gaussian = Gaussian::new(sigma).unwrap();
        let radius = (4.0 * sigma + 0.5).floor() as i32;
        let weights: Vec<f64> = (-radius..=radius)
            .map(|d| (-f64::from(d * d) / (2.0 * sigma * sigma)).exp())
            .collect();
        let sum: f64 = weights.iter().sum();
        let weights: Vec<f64> = weights.iter().map(|w| w / sum).collect();
        let exact = gaussian.blur(&plane.map(|p| p.map(f32::from)), border);
        let rounded = gaussian.blur(&plane, border);
        for row in 0..height {
            for column in 0..width {
                let expected = convolved(&plane, &weights, border, [column, row]);
                for (channel, expected) in expected.into_iter().enumerate() {
                    let got = f64::from(exact.get(column, row).unwrap()[channel]);
                    prop_assert!((got - expected).abs() < 1e-3);
                    let got = f64::from(rounded.get(column, row).unwrap()[channel]);
                    prop_assert!((got - expected).abs() < 0.501);
                }
            }
        }
    }

    /// OpenCV's integer arithmetic: (sum + 128) >> 8.
    #[test]
    fn halving_is_opencvs_pyramid(
        (width, height) in (1usize..14, 1usize..14),
        seed in any::<u32>(),
    ) {
        let plane = noise(width, height, seed);
        let small = halved(&plane);
        prop_assert_eq!((small.width(), small.height()), (width.div_ceil(2), height.div_ceil(2)));
        let weights = [1.0, 4.0, 6.0, 4.0, 1.0];
        for row in 0..small.height() {
            for column in 0..small.width() {
                let sums = convolved(&plane, &weights, Border::Mirror, [2 * column, 2 * row]);
                let expected = sums.map(|sum| ((sum as u32 + 128) >> 8) as u8);
                prop_assert_eq!(small.get(column, row), Some(expected));
            }
        }
        let deep = halved(&plane.map(|p| p.map(|v| u16::from(v) * 257)));
        let floats = halved(&plane.map(|p| p.map(f32::from)));
        for (deep, float) in deep.values().iter().zip(floats.values()) {
            for channel in 0..2 {
                prop_assert!((f32::from(deep[channel]) - 257.0 * float[channel]).abs() <= 0.5);
            }
        }
    }

    /// The integral of the old picture over each new pixel, sampled densely.
    #[test]
    fn area_keeps_the_mean_of_every_square(
        (width, height) in (1usize..12, 1usize..12),
        (new_width, new_height) in (1usize..12, 1usize..12),
        seed in any::<u32>(),
    ) {
        let plane = noise(width, height, seed).map(|[v, _]| f32::from(v));
        let resized = resize(&plane, new_width, new_height, Method::Area).unwrap();
        // Each old pixel becomes new_width × new_height equal parts, of which each new pixel has
        // width × height.
        for row in 0..new_height {
            for column in 0..new_width {
                let mut sum = 0.0;
                for y in row * height..(row + 1) * height {
                    for x in column * width..(column + 1) * width {
                        sum += f64::from(plane.get(x / new_width, y / new_height).unwrap());
                    }
                }
                let expected = sum / (width * height) as f64;
                let got = f64::from(resized.get(column, row).unwrap());
                prop_assert!((got - expected).abs() < 1e-3, "{} for {}", got, expected);
            }
        }
    }

    /// A linear ramp stays one, apart from the constant outermost halves of pixels.
    #[test]
    fn bilinear_interpolation_keeps_ramps(
        (width, height) in (2usize..12, 2usize..12),
        (new_width, new_height) in (1usize..30, 1usize..30),
    ) {
        let ramp = |x: f64, y: f64| 3.0 * x - 2.0 * y + 1.0;
        let plane = Plane::from_fn(width, height, |c, r| ramp(c as f64, r as f64) as f32);
        let resized = resize(&plane, new_width, new_height, Method::Bilinear).unwrap();
        for row in 0..new_height {
            for column in 0..new_width {
                let place = |i: usize, new: usize, old: usize| {
                    let centre = (i as f64 + 0.5) / new as f64 * old as f64 - 0.5;
                    centre.max(0.0).min(old as f64 - 1.0)
                };
                let expected = ramp(place(column, new_width, width), place(row, new_height, height));
                let got = f64::from(resized.get(column, row).unwrap());
                prop_assert!((got - expected).abs() < 1e-4, "{} for {}", got, expected);
            }
        }
    }

    #[test]
    fn the_nearest_pixel_is_the_one_at_the_centre(
        (width, height) in (1usize..12, 1usize..12),
        (new_width, new_height) in (1usize..30, 1usize..30),
        seed in any::<u32>(),
    ) {
        let plane = noise(width, height, seed);
        let resized = resize(&plane, new_width, new_height, Method::Nearest).unwrap();
        for row in 0..new_height {
            for column in 0..new_width {
                let place = |i: usize, new: usize, old: usize| (2 * i + 1) * old / (2 * new);
                let expected = plane.get(place(column, new_width, width), place(row, new_height, height));
                prop_assert_eq!(resized.get(column, row), expected);
            }
        }
    }
}

#[test]
fn pictures_without_pixels_stay_so_and_cannot_grow() {
    let empty = Plane::<u8>::filled(0, 3, 0);
    assert!(halved(&empty).is_empty());
    assert_eq!(Pyramid::new(&empty, 5).levels().len(), 3);
    assert!(
        Gaussian::new(1.0)
            .unwrap()
            .blur(&empty, Border::Mirror)
            .is_empty()
    );
    for method in [Method::Nearest, Method::Bilinear, Method::Area] {
        assert!(resize(&empty, 2, 2, method).is_err());
        assert!(resize(&empty, 0, 2, method).unwrap().is_empty());
        assert!(
            resize(&Plane::filled(2, 2, 1u8), 0, 0, method)
                .unwrap()
                .is_empty()
        );
    }
}

#[test]
fn standard_deviations_out_of_range_are_errors() {
    for sigma in [0.0, -1.0, f64::NAN, f64::INFINITY, 1e9] {
        let message = Gaussian::new(sigma).unwrap_err().to_string();
        assert!(message.starts_with("σ = "), "{message}");
    }
    // A narrow Gaussian is a single pixel.
    let plane = noise(5, 5, 3);
    let narrow = Gaussian::new(0.1).unwrap();
    assert_eq!(
        (narrow.radius(), narrow.blur(&plane, Border::Reflect)),
        (0, plane)
    );
}
