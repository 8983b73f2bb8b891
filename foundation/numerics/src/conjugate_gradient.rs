//! Linear equations with a symmetric positive definite matrix that is too large to be stored, by
//! the method of conjugate gradients.

/// When the search ends.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Options {
    /// The greatest number of steps.
    pub steps: usize,
    /// The search ends when the residual is no longer than this part of the one at the beginning…
    pub relative_tolerance: f64,
    /// …or no longer than this.
    pub absolute_tolerance: f64,
}

/// The search ended before the residual was small.
#[derive(Clone, Copy, Debug, PartialEq, thiserror::Error)]
#[error("{steps} steps of conjugate gradients leave the part {residual} of the residual")]
pub struct NotConverged {
    /// How many steps were taken.
    pub steps: usize,
    /// The length of the residual by that at the beginning.
    pub residual: f64,
}

/// Solves `A x = b`, from the given x on. Returns the number of steps; x is the last approximation
/// even where it has not converged.
///
/// `image` writes `A x` for its first argument x to its second one. `precondition` writes an
/// approximation of `A⁻¹ r` for its first argument r, linear in r with a symmetric positive
/// definite matrix, or r itself. The matrix A may be singular where b lies in its image (M.
/// Hestenes and E. Stiefel, "Methods of conjugate gradients for solving linear systems", 1952).
///
/// ```
/// use ga_numerics::conjugate_gradient::{Options, solve};
///
/// let mut x = [0.0; 2];
/// let options = Options { steps: 2, relative_tolerance: 1e-12, absolute_tolerance: 0.0 };
/// let image = |x: &[f64], to: &mut [f64]| {
///     (to[0], to[1]) = (4.0 * x[0] + x[1], x[0] + 3.0 * x[1]);
/// };
/// let steps = solve(&[6.0, 7.0], &mut x, image, |r, to| to.copy_from_slice(r), &options)?;
/// assert!(steps <= 2 && (x[0] - 1.0).abs() < 1e-12 && (x[1] - 2.0).abs() < 1e-12);
/// # Ok::<(), ga_numerics::conjugate_gradient::NotConverged>(())
/// ```
///
/// # Errors
/// [`NotConverged`] after the greatest number of steps, and where the matrix is not positive
/// definite or a number is not finite.
///
/// # Panics
/// Where `right` and `x` are not of one length.
pub fn solve(
    right: &[f64],
    x: &mut [f64],
    mut image: impl FnMut(&[f64], &mut [f64]),
    mut precondition: impl FnMut(&[f64], &mut [f64]),
    options: &Options,
) -> Result<usize, NotConverged> {
    assert_eq!(right.len(), x.len(), "as many numbers as unknowns");
    let [mut of_direction, mut improved, mut direction] = [(); 3].map(|()| vec![0.0; x.len()]);
    image(x, &mut of_direction);
    let mut residual: Vec<f64> = right
        .iter()
        .zip(&of_direction)
        .map(|(b, a)| b - a)
        .collect();
    let start = length(&residual);
    let enough = (options.relative_tolerance * start).max(options.absolute_tolerance);
    let mut before = f64::INFINITY;
    let mut steps = 0;
    loop {
        let left = length(&residual);
        if left <= enough {
            return Ok(steps);
        }
        let not_converged = NotConverged {
            steps,
            residual: left / start,
        };
        if steps == options.steps {
            return Err(not_converged);
        }
        precondition(&residual, &mut improved);
        let product = dot(&residual, &improved);
        let share = product / before;
        for (direction, improved) in direction.iter_mut().zip(&improved) {
            *direction = improved + share * *direction;
        }
        before = product;
        image(&direction, &mut of_direction);
        let curvature = dot(&direction, &of_direction);
        if curvature.is_nan() || curvature <= 0.0 {
            return Err(not_converged);
        }
        let step = product / curvature;
        for (x, direction) in x.iter_mut().zip(&direction) {
            *x += step * direction;
        }
        for (residual, image) in residual.iter_mut().zip(&of_direction) {
            *residual -= step * image;
        }
        steps += 1;
    }
}

fn dot(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

fn length(a: &[f64]) -> f64 {
    dot(a, a).sqrt()
}
