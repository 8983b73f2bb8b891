//! Homographies: maps between a plane and its picture.

use ga_runtime::cga3::{Direction, Motor, Point, Rotor, Translator};
use ga_runtime::vga3::Vector;
use nalgebra_035::{DMatrix, Matrix3};

use crate::normalisation::Normalisation;

/// A map from a plane to a picture, `λ (u, v, 1) = H (x, y, 1)`, scaled to a sum of squares of 1.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Homography {
    matrix: Matrix3<f64>,
}

impl Homography {
    /// The homography that takes places of the plane to places of a picture, by the direct linear
    /// transformation with normalised coordinates (R. Hartley and A. Zisserman, "Multiple View
    /// Geometry in Computer Vision", algorithm 4.2).
    ///
    /// `None` for fewer than four pairs, for places or pixels on one line, and where numbers are
    /// not finite.
    ///
    /// ```
    /// use ga_vision::homography::Homography;
    ///
    /// let places = [[0.0, 0.0], [1.0, 0.0], [0.0, 1.0], [1.0, 1.0]];
    /// let pixels = places.map(|[x, y]| [(100.0 * x + 7.0) / (1.0 + 0.2 * y), 50.0 * y]);
    /// let homography = Homography::from_pairs(&places, &pixels).ok_or("on one line")?;
    /// let [u, v] = homography.apply([1.0, 0.0]).ok_or("at infinity")?;
    /// assert!((u - 107.0).abs() < 1e-12 && v.abs() < 1e-12);
    /// # Ok::<(), &str>(())
    /// ```
    #[must_use]
    pub fn from_pairs(places: &[[f64; 2]], pixels: &[[f64; 2]]) -> Option<Self> {
        /// The least ratio of the smallest singular value that must not vanish to the greatest.
        const LEAST_RATIO: f64 = 1e-9;
        let count = places.len();
        if count < 4 || pixels.len() != count {
            return None;
        }
        let similarity = |places: &[[f64; 2]]| Normalisation::new(places.iter().copied());
        let [from, to] = [similarity(places)?, similarity(pixels)?];
        // Nine rows at least, so that the decomposition has nine singular vectors.
        let mut equations = DMatrix::zeros((2 * count).max(9), 9);
        for (index, (place, pixel)) in places.iter().zip(pixels).enumerate() {
            let [x, y] = from.apply(*place);
            let [u, v] = to.apply(*pixel);
            let rows = [
                [x, y, 1.0, 0.0, 0.0, 0.0, -u * x, -u * y, -u],
                [0.0, 0.0, 0.0, x, y, 1.0, -v * x, -v * y, -v],
            ];
            for (k, row) in rows.iter().enumerate() {
                for (column, value) in row.iter().enumerate() {
                    equations[(2 * index + k, column)] = *value;
                }
            }
        }
        let decomposition = equations.try_svd(false, true, f64::EPSILON, 200)?;
        let values = &decomposition.singular_values;
        let mut order: Vec<usize> = (0..9).collect();
        order.sort_by(|a, b| values[*a].total_cmp(&values[*b]));
        let (second, greatest) = (values[order[1]], values[order[8]]);
        if second.is_nan() || second <= LEAST_RATIO * greatest {
            return None;
        }
        let solution = decomposition.v_t?;
        let solution = solution.row(order[0]);
        let matrix = Matrix3::from_fn(|row, column| solution[3 * row + column]);
        // Pixels on one line are the image of a plane through the camera's centre.
        let values = matrix.singular_values();
        if values.min().is_nan() || values.min() <= LEAST_RATIO * values.max() {
            return None;
        }
        let matrix = as_matrix(to).try_inverse()? * matrix * as_matrix(from);
        let matrix = matrix / matrix.norm();
        matrix
            .iter()
            .all(|x| x.is_finite())
            .then_some(Self { matrix })
    }

    /// The place in the picture of a place of the plane; `None` at infinity.
    #[must_use]
    pub fn apply(&self, [x, y]: [f64; 2]) -> Option<[f64; 2]> {
        let image = self.matrix * nalgebra_035::Vector3::new(x, y, 1.0);
        let pixel = [image.x / image.z, image.y / image.z];
        pixel.iter().all(|u| u.is_finite()).then_some(pixel)
    }

    /// The two motions of a camera that sees a plane in two views, by the map from the directions
    /// (x, y, 1) of one view to those of the other. A translation has the distance of the first
    /// camera from the plane as its unit; with the opposite translation and the plane on the other
    /// side a motion has the same map.
    ///
    /// A point x of the plane `n · x = 1` moves to `R x + t = (R + t nᵀ) x`, so that H is a
    /// multiple of `R + t nᵀ`, which rotates the vectors across n and keeps their length. The
    /// vectors that H makes neither longer nor shorter, beside its other singular values, are those
    /// of two planes through its middle singular vector: each of them is across the normal of one
    /// solution (O. D. Faugeras and F. Lustman, "Motion and structure from motion in a piecewise
    /// planar environment", 1988). Both explain the views of the plane alike.
    ///
    /// `None` where the cameras are in one place, which shows no plane.
    ///
    /// ```
    /// use ga_vision::homography::Homography;
    ///
    /// // A wall at z = 1 and a camera that moves to its right by a half: x' = x − 0.5 z.
    /// let directions = [[-0.3, -0.2], [0.4, -0.1], [-0.2, 0.3], [0.1, 0.2]];
    /// let moved = directions.map(|[x, y]| [x - 0.5, y]);
    /// let seen = Homography::from_pairs(&directions, &moved).ok_or("on one line")?;
    /// let motions = seen.motions().ok_or("no translation")?;
    /// let along = motions.map(|motor| motor.translator().displacement()[0].abs());
    /// assert!(along.iter().any(|x| (x - 0.5).abs() < 1e-9));
    /// # Ok::<(), &str>(())
    /// ```
    #[must_use]
    pub fn motions(&self) -> Option<[Motor<f64>; 2]> {
        /// The least change of length, as a part of it, that is not rounding.
        const LEAST: f64 = 1e-9;
        let matrix = match self.matrix.determinant() < 0.0 {
            true => -self.matrix,
            false => self.matrix,
        };
        let decomposed = (matrix.transpose() * matrix).symmetric_eigen();
        let mut order = [0, 1, 2];
        order.sort_by(|a, b| decomposed.eigenvalues[*b].total_cmp(&decomposed.eigenvalues[*a]));
        let [longest, middle, shortest] = order.map(|k| decomposed.eigenvalues[k]);
        let [first, axis, last] = order.map(|k| decomposed.eigenvectors.column(k).into_owned());
        let matrix = matrix / middle.sqrt();
        let shrinks = (1.0 - shortest / middle).max(0.0).sqrt();
        let grows = (longest / middle - 1.0).max(0.0).sqrt();
        let whole = shrinks.hypot(grows);
        if whole.is_nan() || whole * whole <= LEAST {
            return None;
        }
        let motion = |sign: f64| {
            let across = (first * shrinks + last * (sign * grows)) / whole;
            let normal = axis.cross(&across);
            let (axis_image, across_image) = (matrix * axis, matrix * across);
            let pairs = [
                (axis, axis_image),
                (across, across_image),
                (normal, axis_image.cross(&across_image)),
            ];
            let pairs = pairs.map(|(from, to)| (from.into(), to.into()));
            let rotor = Rotor::from_direction_pairs(&pairs).ok()?.motion;
            let rotated = Direction::from_vector(normal.into());
            let rotated = Vector::from(rotor.transform(rotated));
            let displacement = Vector::from(<[f64; 3]>::from(matrix * normal)) - rotated;
            Some(Translator::from_displacement(displacement.coordinates()) * rotor)
        };
        Some([motion(1.0)?, motion(-1.0)?])
    }

    /// `H d` for a direction d, with the sign for which what is in front of one camera is in front
    /// of the other.
    pub(crate) fn image(&self, direction: Vector<f64>) -> Vector<f64> {
        let [first, second, third] = [0, 1, 2].map(|column| self.column(column));
        let image = first * direction.e1 + second * direction.e2 + third * direction.e3;
        image * first.cross(second).dot(third).signum()
    }

    /// The column of the matrix with an index below 3.
    pub(crate) fn column(&self, column: usize) -> Vector<f64> {
        Vector::from([0, 1, 2].map(|row| self.matrix[(row, column)]))
    }

    /// The motor that takes the plane z = 0 into the frame of a camera that sees it by this
    /// homography at focal length 1: the columns are the images of e1, e2 and the origin, up to a
    /// factor that makes the first two as long as they are. The rotation is the one that fits them
    /// best. `None` where the plane contains the camera's centre.
    pub(crate) fn motion(&self) -> Option<Motor<f64>> {
        let [first, second, origin] = [0, 1, 2].map(|column| self.column(column));
        let length = (first.length() * second.length()).sqrt();
        // The board is in front of the camera.
        let scale = (1.0 / length).copysign(origin.e3);
        let [first, second, origin] = [first * scale, second * scale, origin * scale];
        let normal = first.cross(second);
        let pairs = [
            ([1.0, 0.0, 0.0], first.coordinates()),
            ([0.0, 1.0, 0.0], second.coordinates()),
            ([0.0, 0.0, 1.0], normal.coordinates()),
        ];
        let rotor = Rotor::from_direction_pairs(&pairs).ok()?.motion;
        Some(Translator::from_displacement(origin.coordinates()) * rotor)
    }
}

fn as_matrix(similarity: Normalisation) -> Matrix3<f64> {
    let Normalisation { centre, scale } = similarity;
    let [x, y] = centre.map(|x| -scale * x);
    Matrix3::new(scale, 0.0, x, 0.0, scale, y, 0.0, 0.0, 1.0)
}

/// The places of a plane z = 0.
pub(crate) fn in_plane(places: &[Point<f64>]) -> Vec<[f64; 2]> {
    let flat = places.iter().map(|place| {
        let [x, y, _] = place.coordinates();
        [x, y]
    });
    flat.collect()
}
