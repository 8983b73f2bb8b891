//! Gradient vector flow, compared with the dense solution of its equations and with the end of the
//! diffusion of Xu and Prince.

use ga_image::plane::Plane;
use ga_vision::contour::ContourError;
use ga_vision::contour::snake::Flow;
use nalgebra_035::{DMatrix, DVector};

/// Two blobs of different strength, one of which is at the border.
fn strength(width: usize, height: usize) -> Plane<f32> {
    let blob = |u: f64, v: f64, size: f64| (-(u * u + v * v) / (2.0 * size * size)).exp();
    Plane::from_fn(width, height, |column, row| {
        let (u, v) = (column as f64, row as f64);
        (3.0 * blob(u - 5.0, v - 4.0, 1.5) + 2.0 * blob(u - 13.0, v - 9.0, 2.0)) as f32
    })
}

/// The strength by its greatest value, its slopes by half the differences of the neighbours, and
/// the squares of their lengths.
fn slopes(strength: &Plane<f32>) -> ([DVector<f64>; 2], DVector<f64>) {
    let (width, height) = (strength.width(), strength.height());
    let greatest = strength.values().iter().fold(0.0f32, |a, b| a.max(*b));
    let at = |u: i64, v: i64| {
        let column = u.clamp(0, width as i64 - 1) as usize;
        let row = v.clamp(0, height as i64 - 1) as usize;
        f64::from(strength.row(row)[column]) / f64::from(greatest)
    };
    let along = |[x, y]: [i64; 2]| {
        DVector::from_fn(width * height, |index, _| {
            let (u, v) = ((index % width) as i64, (index / width) as i64);
            (at(u + x, v + y) - at(u - x, v - y)) / 2.0
        })
    };
    let slopes = [along([1, 0]), along([0, 1])];
    let squares = slopes[0].component_mul(&slopes[0]) + slopes[1].component_mul(&slopes[1]);
    (slopes, squares)
}

/// The matrix of `−Δ` with as many neighbours as there are.
fn laplacian(width: usize, height: usize) -> DMatrix<f64> {
    let mut matrix = DMatrix::zeros(width * height, width * height);
    let mut join = |a: usize, b: usize| {
        matrix[(a, a)] += 1.0;
        matrix[(b, b)] += 1.0;
        matrix[(a, b)] -= 1.0;
        matrix[(b, a)] -= 1.0;
    };
    for row in 0..height {
        for column in 0..width {
            let index = row * width + column;
            if column + 1 < width {
                join(index, index + 1);
            }
            if row + 1 < height {
                join(index, index + width);
            }
        }
    }
    matrix
}

#[test]
fn the_flow_is_the_dense_solution_of_its_equations() {
    for (width, height) in [(17, 13), (16, 12), (2, 30), (9, 2)] {
        let strength = strength(width, height);
        let (slopes, squares) = slopes(&strength);
        for smoothness in [0.005, 0.2, 5.0] {
            let matrix = laplacian(width, height) * smoothness + DMatrix::from_diagonal(&squares);
            let solver = matrix.lu();
            let found = Flow { smoothness }.field(&strength).unwrap();
            for (found, slope) in found.iter().zip(&slopes) {
                let expected = solver.solve(&squares.component_mul(slope)).unwrap();
                let size = expected.amax();
                for (found, expected) in found.values().iter().zip(expected.iter()) {
                    let error = (found - expected).abs();
                    assert!(
                        error < 1e-6 * size + 1e-9,
                        "{width} × {height}: {error} of {size}"
                    );
                }
            }
        }
    }
}

/// The diffusion in steps of a quarter of the stable one ends where the equations are solved.
#[test]
fn the_diffusion_of_xu_and_prince_ends_in_the_flow() {
    let (width, height) = (12, 10);
    let strength = strength(width, height);
    let (slopes, squares) = slopes(&strength);
    let smoothness = 0.2;
    let step = 0.25 / (4.0 * smoothness + squares.amax());
    let found = Flow { smoothness }.field(&strength).unwrap();
    for (found, slope) in found.iter().zip(&slopes) {
        let mut field: Vec<f64> = slope.iter().copied().collect();
        for _ in 0..6000 {
            let before = field.clone();
            for (index, value) in field.iter_mut().enumerate() {
                let (column, row) = (index % width, index / width);
                let mut sum = squares[index] * (slope[index] - before[index]);
                for (exists, other) in [
                    (column > 0, index.wrapping_sub(1)),
                    (column + 1 < width, index + 1),
                    (row > 0, index.wrapping_sub(width)),
                    (row + 1 < height, index + width),
                ] {
                    if exists {
                        sum += smoothness * (before[other] - before[index]);
                    }
                }
                *value += step * sum;
            }
        }
        for (found, expected) in found.values().iter().zip(&field) {
            assert!((found - expected).abs() < 1e-6, "{found} {expected}");
        }
    }
}

#[test]
fn flows_that_cannot_be_are_errors() {
    let edges = strength(12, 10);
    for smoothness in [0.0, -1.0, f64::NAN, f64::INFINITY] {
        let error = Flow { smoothness }.field(&edges).unwrap_err();
        assert!(matches!(error, ContourError::Setting { .. }), "{error}");
    }
    let level = Plane::filled(8, 7, 0.0f32);
    let none = Flow::default().field(&level).unwrap();
    assert!(none[0].values().iter().all(|force| *force == 0.0));
    let thin = Flow::default().field(&Plane::filled(1, 7, 0.0));
    assert!(matches!(thin, Err(ContourError::TooSmall { width: 1, .. })));
}
