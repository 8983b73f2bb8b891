//! A sequence of expressions as a few shapes.

use crate::capture::CaptureError;
use ga_runtime::vga3::Vector;
use nalgebra_035::{DMatrix, SVD};

/// The principal shapes of a sequence of expressions: displacements of all key points, and how much
/// of each there is in every frame,
///
/// ```text
/// d(frame, key) ≈ Σ weight(frame, j) shape(j, key)
/// ```
///
/// They are what morph targets of an animated model need. Of all sums of this number of shapes this
/// has the least sum of squared errors: it is the singular value decomposition of the table of
/// displacements (C. Eckart and G. Young, "The approximation of one matrix by another of lower
/// rank", Psychometrika 1, 1936). The displacement zero stays zero, so that a model with all
/// weights 0 is at rest.
#[derive(Clone, Debug, PartialEq)]
pub struct PrincipalShapes {
    /// For each shape the displacement of each key where its weight is 1, which is its greatest
    /// weight. Shapes that matter most come first.
    pub shapes: Vec<Vec<Vector<f64>>>,
    /// For each frame the weight of each shape, from −1 to 1.
    pub weights: Vec<Vec<f64>>,
    /// The greatest distance of any key in any frame from its displacement by the shapes, in the
    /// unit of the displacements.
    pub error: f64,
}

impl PrincipalShapes {
    /// As few shapes as represent every key in every frame within a tolerance.
    ///
    /// # Errors
    /// [`CaptureError::ListCounts`] where a frame has another number of keys than the first;
    /// [`CaptureError::KeyNotFinite`]; [`CaptureError::Tolerance`] where it is negative or not
    /// finite.
    ///
    /// ```
    /// use ga_runtime::vga3::Vector;
    /// use ga_vision::capture::PrincipalShapes;
    ///
    /// // A smile that comes and goes half.
    /// let smile = [Vector::new(0.01, 0.02, 0.0), Vector::new(-0.01, 0.02, 0.0)];
    /// let frames = [0.0, 0.5, 1.0, 0.5].map(|part| smile.map(|d| d * part).to_vec());
    /// let found = PrincipalShapes::new(&frames, 1e-6)?;
    /// assert_eq!(found.shapes.len(), 1);
    /// assert!(found.shapes[0][1].distance(smile[1]) < 1e-15);
    /// assert!((found.weights[3][0] - 0.5).abs() < 1e-15 && found.error < 1e-15);
    /// # Ok::<(), ga_vision::capture::CaptureError>(())
    /// ```
    pub fn new(frames: &[Vec<Vector<f64>>], tolerance: f64) -> Result<Self, CaptureError> {
        check(frames, tolerance)?;
        let keys = frames.first().map_or(0, Vec::len);
        let mut left = DMatrix::from_fn(frames.len(), 3 * keys, |frame, column| {
            frames[frame][column / 3][column % 3]
        });
        let mut found = Self {
            shapes: Vec::new(),
            weights: vec![Vec::new(); frames.len()],
            error: greatest(&left),
        };
        if found.error <= tolerance {
            return Ok(found);
        }
        let SVD {
            u: Some(u),
            v_t: Some(v_t),
            singular_values,
        } = left.clone().svd(true, true)
        else {
            return Ok(found);
        };
        for (j, &singular) in singular_values.iter().enumerate() {
            let (parts, shape) = (u.column(j), v_t.row(j));
            left.ger(-singular, &parts, &shape.transpose(), 1.0);
            // The greatest weight becomes 1, which also decides the sign.
            let greatest_part = parts[parts.icamax()];
            if greatest_part == 0.0 {
                break;
            }
            let size = singular * greatest_part;
            let key = |k: usize| Vector::new(shape[3 * k], shape[3 * k + 1], shape[3 * k + 2]);
            found
                .shapes
                .push((0..keys).map(|k| key(k) * size).collect());
            for (weights, part) in found.weights.iter_mut().zip(parts.iter()) {
                weights.push(part / greatest_part);
            }
            found.error = greatest(&left);
            if found.error <= tolerance {
                break;
            }
        }
        Ok(found)
    }
}

fn check(frames: &[Vec<Vector<f64>>], tolerance: f64) -> Result<(), CaptureError> {
    if !(tolerance.is_finite() && tolerance >= 0.0) {
        return Err(CaptureError::Tolerance(tolerance));
    }
    let expected = frames.first().map_or(0, Vec::len);
    for keys in frames {
        if keys.len() != expected {
            return Err(CaptureError::ListCounts {
                what: "displacements",
                expected,
                found: keys.len(),
            });
        }
        if let Some(key) = keys.iter().position(|key| !key.is_finite()) {
            return Err(CaptureError::KeyNotFinite { key });
        }
    }
    Ok(())
}

/// The greatest length of the vectors in the rows of a table.
fn greatest(table: &DMatrix<f64>) -> f64 {
    let vectors = (0..table.ncols() / 3).flat_map(|key| {
        let [x, y, z] = [0, 1, 2].map(|axis| table.column(3 * key + axis));
        (0..table.nrows()).map(move |frame| Vector::new(x[frame], y[frame], z[frame]).length())
    });
    vectors.fold(0.0, f64::max)
}
