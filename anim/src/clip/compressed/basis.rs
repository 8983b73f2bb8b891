//! Orthogonal polynomials on the frames of a segment.

/// The greatest number of frames of a segment.
pub(super) const SEGMENT: usize = 32;

/// The most coefficients of a trend: one more than the greatest degree.
pub(super) const TERMS: usize = 6;

/// Polynomials B₀ … B₅ at the frames 0 … n − 1 of a segment of n frames: B_k has degree k, is
/// orthogonal to the others in the sum over the frames, and has greatest value 1. Polynomials of a
/// degree that n frames do not determine are 0.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Basis {
    /// By degree, then by frame.
    pub(super) values: [[f64; SEGMENT]; TERMS],
    /// Σ B_k², by degree.
    pub(super) squares: [f64; TERMS],
    pub(super) frames: usize,
}

impl Basis {
    pub(super) fn new(frames: usize) -> Self {
        let mut basis = Self {
            values: [[0.0; SEGMENT]; TERMS],
            squares: [0.0; TERMS],
            frames,
        };
        let middle = (frames.max(1) - 1) as f64 / 2.0;
        let place = |frame: usize| (frame as f64 - middle) / middle.max(1.0);
        for degree in 0..TERMS.min(frames) {
            // x times the polynomial before has a part along the two before only, but all are
            // removed, twice, so that rounding does not accumulate.
            let mut next: [f64; SEGMENT] = std::array::from_fn(|frame| match degree {
                _ if frame >= frames => 0.0,
                0 => 1.0,
                _ => basis.values[degree - 1][frame] * place(frame),
            });
            for _ in 0..2 {
                for lower in 0..degree {
                    let other = &basis.values[lower];
                    let along = dot(&next, other) / basis.squares[lower];
                    for (x, y) in next.iter_mut().zip(other) {
                        *x -= along * y;
                    }
                }
            }
            let greatest = next.iter().fold(0.0f64, |most, x| most.max(x.abs()));
            let next = next.map(|x| x / greatest);
            basis.squares[degree] = dot(&next, &next);
            basis.values[degree] = next;
        }
        basis
    }

    /// How many terms the frames determine.
    pub(super) fn terms(&self) -> usize {
        TERMS.min(self.frames)
    }

    /// The coefficients of the polynomial of the greatest degree that is nearest to `values` in
    /// least squares; its lower terms are nearest among those of lower degree.
    pub(super) fn project(&self, values: &[f64; SEGMENT]) -> [f64; TERMS] {
        std::array::from_fn(|term| match self.squares[term] {
            0.0 => 0.0,
            square => dot(&self.values[term], values) / square,
        })
    }
}

fn dot(a: &[f64; SEGMENT], b: &[f64; SEGMENT]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_polynomials_are_orthogonal_and_of_rising_degree() {
        for frames in 1..=SEGMENT {
            let basis = Basis::new(frames);
            for a in 0..TERMS {
                for b in 0..a {
                    let product = dot(&basis.values[a], &basis.values[b]);
                    assert!(
                        product.abs() < 1e-12,
                        "{frames} frames, degrees {a} and {b}"
                    );
                }
            }
            // A power of a lower degree has no part along a polynomial of a higher one.
            for degree in 0..basis.terms() {
                let power: [f64; SEGMENT] = std::array::from_fn(|frame| {
                    let x = frame as f64 / frames as f64;
                    if frame < frames {
                        x.powi(degree as i32)
                    } else {
                        0.0
                    }
                });
                let found = basis.project(&power);
                assert!(found[degree].abs() > 1e-9);
                for above in &found[degree + 1..] {
                    assert!(above.abs() < 1e-12, "{frames} frames, degree {degree}");
                }
            }
        }
    }
}
