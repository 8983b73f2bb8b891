//! Conjugate gradients, compared with the dense solution.

use ga_numerics::conjugate_gradient::{NotConverged, Options, solve};
use nalgebra_035::{DMatrix, DVector};
use proptest::prelude::*;

const OPTIONS: Options = Options {
    steps: 200,
    relative_tolerance: 1e-13,
    absolute_tolerance: 0.0,
};

proptest! {
    #[test]
    fn solutions_are_those_of_a_dense_factorisation(
        count in 1usize..12,
        numbers in prop::collection::vec(-1.0..1.0f64, 144),
        right in prop::collection::vec(-5.0..5.0f64, 12),
        start in prop::collection::vec(-5.0..5.0f64, 12),
        is_preconditioned in any::<bool>(),
    ) {
        let factor = DMatrix::from_fn(count, count, |row, column| numbers[12 * row + column]);
        let scales = DVector::from_fn(count, |row, _| 10f64.powi(row as i32 % 4));
        let matrix = &factor * factor.transpose() + DMatrix::from_diagonal(&scales);
        let expected = matrix.clone().cholesky().unwrap();
        let expected = expected.solve(&DVector::from_column_slice(&right[..count]));
        let mut x = start[..count].to_vec();
        let steps = solve(
            &right[..count],
            &mut x,
            |x, image| {
                let product = &matrix * DVector::from_column_slice(x);
                image.copy_from_slice(product.as_slice());
            },
            |residual, improved| {
                for (index, improved) in improved.iter_mut().enumerate() {
                    let scale = if is_preconditioned { matrix[(index, index)] } else { 1.0 };
                    *improved = residual[index] / scale;
                }
            },
            &OPTIONS,
        );
        prop_assert!(steps.unwrap() <= 3 * count + 5);
        for (found, expected) in x.iter().zip(&expected) {
            prop_assert!((found - expected).abs() < 1e-9, "{found} {expected}");
        }
    }
}

#[test]
fn equations_that_are_not_solved_are_errors() {
    let copy = |residual: &[f64], improved: &mut [f64]| improved.copy_from_slice(residual);
    // (1, 1) is not in the image of this matrix.
    let singular = |x: &[f64], image: &mut [f64]| image.fill(x[0] - x[1]);
    let mut x = [0.0; 2];
    let found = solve(&[1.0, 1.0], &mut x, singular, copy, &OPTIONS);
    assert_eq!(
        found,
        Err(NotConverged {
            steps: 0,
            residual: 1.0
        })
    );
    let scaled = |x: &[f64], image: &mut [f64]| {
        (image[0], image[1]) = (x[0], 100.0 * x[1]);
    };
    let options = Options {
        steps: 1,
        ..OPTIONS
    };
    let mut x = [0.0; 2];
    let found = solve(&[1.0, 1.0], &mut x, scaled, copy, &options).unwrap_err();
    assert!(found.steps == 1 && found.residual > 0.1);
    // The approximation is kept.
    assert!(x[0] > 0.0 && x[1] > 0.0);
    let nothing = solve(&[], &mut [], |_, _| {}, |_, _| {}, &OPTIONS);
    assert_eq!(nothing, Ok(0));
}
