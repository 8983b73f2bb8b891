//! Affine maps, for transformations that are not conformal.

use core::fmt::{Display, Formatter, Result as FormatResult};
use core::ops::Mul;

use crate::cga3::{
    Dilator, Direction, DualPlane, Line, Motor, Plane, Point, Rotor, Similarity, Translator,
};
use crate::geometry::number::{are_numbers, is_finite_number};
use crate::scalar::{Field, Real, Ring};
use crate::vga3::Vector;

/// An affine map of space, `x' = L x + t`.
///
/// Motions and similarities are affine, and so are maps that no versor represents: those that
/// shear, or scale by a different factor along each axis. These map a sphere to an ellipsoid and
/// are not conformal. An affine map transforms points, directions, lines and planes, but no
/// spheres, circles or point pairs.
///
/// A map may have any coefficients; an infinity or NaN in the map or in its argument propagates to
/// the image. The inverse and conversions to versors check the coefficients.
///
/// `a * b` applies b first. Every versor of motions and scalings converts to its affine map, and an
/// affine map that represents such a versor converts back:
///
/// ```
/// use ga_runtime::cga3::{Motor, Point, Rotor, Translator};
/// use ga_runtime::geometry::{Affine, NotConformal};
///
/// let stretch = Affine::scaling([1.0, 2.0, 3.0]);
/// assert_eq!(stretch.transform(Point::new(1.0, 1.0, 1.0)), Point::new(1.0, 2.0, 3.0));
/// assert_eq!(Motor::try_from(stretch), Err(NotConformal::Shears));
///
/// let quarter = Rotor::from_axis_angle([0.0, 0.0, 1.0], std::f64::consts::FRAC_PI_2).unwrap();
/// let motor = Translator::from_displacement([1.0, 0.0, 0.0]) * quarter;
/// let both = Affine::from(motor) * stretch;
/// let [x, y, z]: [f64; 3] = both.transform(Point::new(1.0, 1.0, 1.0)).coordinates();
/// assert!((x + 1.0).abs() < 1e-15 && (y - 1.0).abs() < 1e-15 && z == 3.0);
/// let back = both.inverse().unwrap().transform(Point::new(x, y, z));
/// assert!(back.distance(Point::new(1.0, 1.0, 1.0)) < 1e-15);
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
#[repr(C)]
pub struct Affine<S> {
    /// The linear part L, by rows. Its columns are the images of e1, e2 and e3 as directions.
    pub linear: [[S; 3]; 3],
    /// The translation t, the image of the origin.
    pub translation: [S; 3],
}

impl<S: Ring> Affine<S> {
    /// The map with this linear part, by rows, and this image of the origin.
    #[inline]
    #[must_use]
    pub const fn new(linear: [[S; 3]; 3], translation: [S; 3]) -> Self {
        Self {
            linear,
            translation,
        }
    }

    /// The translation by t.
    #[inline]
    #[must_use]
    pub fn from_translation(translation: [S; 3]) -> Self {
        Self::new(diagonal([S::one(); 3]), translation)
    }

    /// The scaling by a factor along each axis, about the origin (Cui, eqs. 10 and 11). It is
    /// conformal only if the factors are equal up to sign, and a similarity without mirroring only
    /// if they are equal and positive: see [`Dilator`].
    #[inline]
    #[must_use]
    pub fn scaling(factors: [S; 3]) -> Self {
        Self::new(diagonal(factors), [S::zero(); 3])
    }

    /// The scaling by a factor along each axis, about a point c: `x' = c + s (x − c)` in each
    /// coordinate.
    ///
    /// ```
    /// use ga_runtime::{cga3::Point, geometry::Affine};
    /// let flatten = Affine::scaling_about(Point::new(0.0, 0.0, 5.0), [1.0, 1.0, 0.0]);
    /// assert_eq!(flatten.transform(Point::new(1.0, 2.0, 3.0)), Point::new(1.0, 2.0, 5.0));
    /// assert_eq!(flatten.inverse(), None);
    /// ```
    #[inline]
    #[must_use]
    pub fn scaling_about(centre: Point<S>, factors: [S; 3]) -> Self {
        let ([x, y, z], one) = (centre.coordinates(), S::one());
        let rest = [
            (one - factors[0]) * x,
            (one - factors[1]) * y,
            (one - factors[2]) * z,
        ];
        Self::new(diagonal(factors), rest)
    }

    /// The determinant of L: the factor of volumes, negative where the map reverses orientation.
    #[inline]
    #[must_use]
    pub fn determinant(self) -> S {
        let [a, b, c] = self.linear;
        determinant([a, b, c])
    }

    /// The image of a point, `L x + t`.
    #[inline]
    #[must_use]
    pub fn transform(self, point: Point<S>) -> Point<S> {
        Point::from(apply(self.linear, point.into()) + Vector::from(self.translation))
    }

    /// The image of a direction, `L v`: the translation does not change it.
    #[inline]
    #[must_use]
    pub fn transform_direction(self, direction: Direction<S>) -> Direction<S> {
        let [x, y, z] = apply(self.linear, direction.into()).coordinates();
        Direction::new(x, y, z)
    }

    /// The image of a line, with its weight: the line through the images of the points that span
    /// it. Zero where L maps the line to a point.
    #[inline]
    #[must_use]
    pub fn transform_line(self, line: Line<S>) -> Line<S> {
        let direction = [-line.e1oi, -line.e2oi, -line.e3oi];
        let moment = [line.e23i, -line.e13i, line.e12i];
        let direction = apply(self.linear, direction.into());
        let moment = apply(cofactors(self.linear), moment.into())
            + Vector::from(self.translation).cross(direction);
        let ([x, y, z], [a, b, c]) = (direction.coordinates(), moment.coordinates());
        Line::new(c, -b, a, -x, -y, -z)
    }

    /// The image of a plane, with its weight: the plane through the images of the points that span
    /// it. Its normal is the cofactor matrix of L (`det L` times the inverse transpose) applied to
    /// the normal; so a map with a reflection reverses it. Zero where L maps the plane to a line or
    /// a point.
    ///
    /// ```
    /// use ga_runtime::{cga3::{Plane, Point}, geometry::Affine};
    /// let map = Affine::new([[1.0, 0.5, 0.0], [0.0, 2.0, 0.0], [0.0, 0.0, 3.0]], [4.0, 5.0, 6.0]);
    /// let points = [[0.0, 0.0, 1.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]].map(Point::from);
    /// let [p, q, r] = points.map(|p| map.transform(p));
    /// let [a, b, c] = points;
    /// assert_eq!(map.transform_plane(Plane::through(a, b, c)), Plane::through(p, q, r));
    /// ```
    #[must_use]
    pub fn transform_plane(self, plane: Plane<S>) -> Plane<S>
    where
        S: Field,
    {
        let dual = plane.dual();
        let normal = apply(cofactors(self.linear), dual.normal().into());
        let distance = self.determinant() * dual.ei + normal.dot(self.translation.into());
        DualPlane::from_normal_distance(normal.into(), distance).undual()
    }

    /// The 4×4 matrix `[L t; 0 1]` by rows, for columns of homogeneous coordinates:
    /// `(x', 1) = M (x, 1)`.
    #[inline]
    #[must_use]
    pub fn to_homogeneous(self) -> [[S; 4]; 4] {
        let ([a, b, c], [x, y, z]) = (self.linear, self.translation);
        let (zero, one) = (S::zero(), S::one());
        [
            [a[0], a[1], a[2], x],
            [b[0], b[1], b[2], y],
            [c[0], c[1], c[2], z],
            [zero, zero, zero, one],
        ]
    }

    /// The map of a 4×4 matrix by rows, `(x', 1) = M (x, 1)`.
    ///
    /// # Errors
    /// The last row is not 0 0 0 1, or an entry is not finite.
    pub fn from_homogeneous(rows: [[S; 4]; 4]) -> Result<Self, NotConformal> {
        let [a, b, c, last] = rows;
        let (zero, one) = (S::zero(), S::one());
        if !rows.into_iter().flatten().all(is_finite_number) {
            return Err(NotConformal::NotFinite);
        }
        if last != [zero, zero, zero, one] {
            return Err(NotConformal::Projective);
        }
        let linear = [a, b, c].map(|[x, y, z, _]| [x, y, z]);
        Ok(Self::new(linear, [a[3], b[3], c[3]]))
    }
}

impl<S: Real<Mask = bool>> Affine<S> {
    /// The inverse map; `None` where L is singular, or the inverse is beyond the range of the
    /// scalar. It is computed from cofactors, with an error of about ε times the condition number
    /// of L.
    ///
    /// L is treated as singular if its determinant is at most 16 ε, the size of the rounding error,
    /// after rows and columns have been scaled to entries up to 1.
    #[must_use]
    pub fn inverse(self) -> Option<Self> {
        let (unit, [rows, columns]) = balanced(self.linear)?;
        let determinant = Self::new(unit, self.translation).determinant();
        if !is_regular(determinant) {
            return None;
        }
        let inverse = transposed(cofactors(unit));
        let linear = [0, 1, 2]
            .map(|j| [0, 1, 2].map(|i| inverse[j][i] / determinant / rows[i] / columns[j]));
        let translation = (-apply(linear, self.translation.into())).coordinates();
        let is_finite = linear.into_iter().all(are_numbers) && are_numbers(translation);
        is_finite.then(|| Self::new(linear, translation))
    }

    /// The rotation of L and its factor: `L = s R`.
    pub(crate) fn rotation_and_factor(self) -> Result<(Rotor<S>, S), NotConformal> {
        if !(self.linear.into_iter().all(are_numbers) && are_numbers(self.translation)) {
            return Err(NotConformal::NotFinite);
        }
        let largest = largest(self.linear);
        if !S::zero().less_than(largest) {
            return Err(NotConformal::Singular);
        }
        let unit = self.linear.map(|row| row.map(|x| x / largest));
        let [a, b, c] = unit;
        let [a, b, c] = [a, b, c].map(|row| Vector::from(row).length_squared());
        let mean_square = (a + b + c) / S::from_integer(3);
        let size = mean_square.sqrt();
        let rows = unit.map(|row| row.map(|x| x / size));
        if let Some(rotor) = Rotor::from_matrix(rows) {
            return Ok((rotor, size * largest));
        }
        let mirrored = rows.map(|row| row.map(|x| -x));
        Err(if Rotor::from_matrix(mirrored).is_some() {
            NotConformal::Mirrors
        } else if !balanced(rows).is_some_and(|(rows, _)| is_regular(determinant(rows))) {
            NotConformal::Singular
        } else {
            NotConformal::Shears
        })
    }
}

type Matrix<S> = [[S; 3]; 3];

/// The matrix with its rows and then its columns divided by their largest entries, and these
/// divisors; `None` where one vanishes.
fn balanced<S: Real<Mask = bool>>(linear: Matrix<S>) -> Option<(Matrix<S>, [[S; 3]; 2])> {
    let size = |row: [S; 3]| row[0].abs().max(row[1].abs()).max(row[2].abs());
    let divided =
        |matrix: [[S; 3]; 3], sizes: [S; 3]| [0, 1, 2].map(|k| matrix[k].map(|x| x / sizes[k]));
    let are_usable = |sizes: [S; 3]| {
        sizes
            .into_iter()
            .all(|x| S::zero().less_than(x) && x.is_finite())
    };
    let rows = linear.map(size);
    if !are_usable(rows) {
        return None;
    }
    let turned = transposed(divided(linear, rows));
    let columns = turned.map(size);
    if !are_usable(columns) {
        return None;
    }
    Some((transposed(divided(turned, columns)), [rows, columns]))
}

/// Whether the determinant of a [`balanced`] matrix is more than rounding.
fn is_regular<S: Real<Mask = bool>>(determinant: S) -> bool {
    (S::from_integer(16) * S::epsilon()).less_than(determinant.abs())
}

/// The identity.
impl<S: Ring> Default for Affine<S> {
    #[inline]
    fn default() -> Self {
        Self::scaling([S::one(); 3])
    }
}

/// One map after the other, the right one first.
impl<S: Ring> Mul for Affine<S> {
    type Output = Self;

    #[inline]
    fn mul(self, first: Self) -> Self {
        let columns =
            transposed(first.linear).map(|column| apply(self.linear, column.into()).into());
        let origin = self.transform(Point::from(first.translation));
        Self::new(transposed(columns), origin.coordinates())
    }
}

impl<S: Field> From<Translator<S>> for Affine<S> {
    #[inline]
    fn from(translator: Translator<S>) -> Self {
        Self::from_translation(translator.displacement())
    }
}

impl<S: Ring> From<Rotor<S>> for Affine<S> {
    #[inline]
    fn from(rotor: Rotor<S>) -> Self {
        Self::new(rotor.to_matrix(), [S::zero(); 3])
    }
}

impl<S: Field> From<Motor<S>> for Affine<S> {
    #[inline]
    fn from(motor: Motor<S>) -> Self {
        let displacement = motor.translator().displacement();
        Self::new(motor.rotor().to_matrix(), displacement)
    }
}

impl<S: Real<Mask = bool>> From<Dilator<S>> for Affine<S> {
    #[inline]
    fn from(dilator: Dilator<S>) -> Self {
        Self::scaling([dilator.factor(); 3])
    }
}

/// With `M = T R D` and `D = c + s eo∧ei`, the blades without eo and ei contain c R, those with
/// eo∧ei contain s R, and the rest is `−½ (c − s) t R ei`. The factor is `(c + s)²`, which equals
/// `1/(c − s)²`; of the two the one without cancellation is used.
impl<S: Real> From<Similarity<S>> for Affine<S> {
    fn from(m: Similarity<S>) -> Self {
        let turn = [m.scalar(), m.e12(), m.e13(), m.e23()];
        let scaling = [m.eoi(), m.e12oi(), m.e13oi(), m.e23oi()];
        let product = |k: usize| turn[k] * scaling[k];
        let shrinks = (product(0) + product(1) + product(2) + product(3)).less_than(S::zero());
        let add = |k: usize| S::select(shrinks, turn[k] - scaling[k], turn[k] + scaling[k]);
        let [w, xy, xz, yz] = [add(0), add(1), add(2), add(3)];
        let square = w * w + xy * xy + xz * xz + yz * yz;
        let inverse = S::select(shrinks, square.recip(), S::one());
        let factor = S::select(shrinks, inverse, square);
        // R = (w + xy e12 + …)/√square, so its matrix can be computed without a square root.
        let two = S::from_integer(2) / square;
        let (x, y, z, one) = (-yz, xz, -xy, S::one());
        let linear = [
            [
                one - two * (y * y + z * z),
                two * (x * y - w * z),
                two * (x * z + w * y),
            ],
            [
                two * (x * y + w * z),
                one - two * (x * x + z * z),
                two * (y * z - w * x),
            ],
            [
                two * (x * z - w * y),
                two * (y * z + w * x),
                one - two * (x * x + y * y),
            ],
        ];
        let (a, volume) = ([m.e1i(), m.e2i(), m.e3i()], m.e123i());
        let shift = [
            w * a[0] + xy * a[1] + xz * a[2] + yz * volume,
            w * a[1] - xy * a[0] + yz * a[2] - xz * volume,
            w * a[2] - xz * a[0] - yz * a[1] + xy * volume,
        ];
        Self::new(
            linear.map(|row| row.map(|x| x * factor)),
            shift.map(|x| x * -(inverse + inverse)),
        )
    }
}

/// `L` must be a rotation within √ε.
impl<S: Real<Mask = bool>> TryFrom<Affine<S>> for Motor<S> {
    type Error = NotConformal;

    fn try_from(map: Affine<S>) -> Result<Self, NotConformal> {
        let (rotor, factor) = map.rotation_and_factor()?;
        if S::epsilon().sqrt().less_than((factor - S::one()).abs()) {
            return Err(NotConformal::Scales);
        }
        Ok(Translator::from_displacement(map.translation) * rotor)
    }
}

/// `L` must be a multiple of a rotation within √ε, relative to its size.
impl<S: Real<Mask = bool>> TryFrom<Affine<S>> for Similarity<S> {
    type Error = NotConformal;

    fn try_from(map: Affine<S>) -> Result<Self, NotConformal> {
        let (rotor, factor) = map.rotation_and_factor()?;
        similarity(rotor, factor, map.translation)
    }
}

/// The error of converting a matrix or an affine map to a versor that does not represent it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum NotConformal {
    /// An entry is infinite or not a number, or the result is beyond the range of the scalar.
    NotFinite,
    /// The last row of a 4×4 matrix is not 0 0 0 1.
    Projective,
    /// The linear part is singular.
    Singular,
    /// The linear part shears, or scales by different factors along different axes.
    Shears,
    /// The linear part reverses orientation.
    Mirrors,
    /// The linear part scales, so the map is not a motion.
    Scales,
    /// The linear part rotates, so the map is neither a translation nor a scaling.
    Rotates,
    /// The map moves the origin, so it is neither a rotor's nor a dilator's.
    Translates,
    /// The linear part does not reverse orientation.
    DoesNotMirror,
}

#[allow(non_upper_case_globals, reason = "former names of variants")]
impl NotConformal {
    /// The former name of [`NotConformal::Rotates`].
    #[deprecated(note = "renamed to `Rotates`")]
    pub const Turns: Self = Self::Rotates;
    /// The former name of [`NotConformal::Translates`].
    #[deprecated(note = "renamed to `Translates`")]
    pub const Shifts: Self = Self::Translates;
}

impl Display for NotConformal {
    fn fmt(&self, f: &mut Formatter<'_>) -> FormatResult {
        f.write_str(match self {
            Self::NotFinite => "an entry of the matrix is not finite or out of range",
            Self::Projective => "the last row of the matrix is not 0 0 0 1",
            Self::Singular => "the linear part of the map is singular",
            Self::Shears => {
                "the linear part of the map shears or scales by different factors along different axes"
            }
            Self::Mirrors => "the linear part of the map reverses orientation",
            Self::Scales => "the linear part of the map scales",
            Self::Rotates => "the linear part of the map rotates",
            Self::Translates => "the map moves the origin",
            Self::DoesNotMirror => "the linear part of the map does not reverse orientation",
        })
    }
}

impl core::error::Error for NotConformal {}

/// The similarity `T R D`. For `D = c + s eo∧ei` its blades with ei contain `(c − s) t`, or,
/// written as `D T(t/factor) R`, `(c + s) t/factor`: of the two the one without cancellation is
/// used.
pub(crate) fn similarity<S: Real<Mask = bool>>(
    rotor: Rotor<S>,
    factor: S,
    translation: [S; 3],
) -> Result<Similarity<S>, NotConformal> {
    let dilator = Dilator::from_factor(factor).ok_or(NotConformal::NotFinite)?;
    let shift = |translation| Translator::from_displacement(translation) * rotor;
    Ok(if factor.less_than(S::one()) {
        shift(translation) * dilator
    } else {
        dilator * shift(translation.map(|x| x / factor))
    })
}

fn diagonal<S: Ring>([x, y, z]: [S; 3]) -> [[S; 3]; 3] {
    let zero = S::zero();
    [[x, zero, zero], [zero, y, zero], [zero, zero, z]]
}

fn transposed<S: Copy>([a, b, c]: [[S; 3]; 3]) -> [[S; 3]; 3] {
    [[a[0], b[0], c[0]], [a[1], b[1], c[1]], [a[2], b[2], c[2]]]
}

fn determinant<S: Ring>(rows: [[S; 3]; 3]) -> S {
    let [a, b, c] = rows.map(Vector::from);
    a.dot(b.cross(c))
}

/// Not by `map`, which the compiler does not always inline.
#[inline]
fn apply<S: Ring>([a, b, c]: [[S; 3]; 3], vector: Vector<S>) -> Vector<S> {
    let row = |[x, y, z]: [S; 3]| Vector::new(x, y, z).dot(vector);
    Vector::new(row(a), row(b), row(c))
}

/// `det L` times the inverse transpose: it maps the cross product of two vectors to that of their
/// images.
fn cofactors<S: Ring>([a, b, c]: [[S; 3]; 3]) -> [[S; 3]; 3] {
    let [a, b, c] = [a, b, c].map(Vector::from);
    [b.cross(c), c.cross(a), a.cross(b)].map(Vector::coordinates)
}

/// The largest absolute value of the entries.
fn largest<S: Real<Mask = bool>>(rows: [[S; 3]; 3]) -> S {
    let entries = rows.into_iter().flatten();
    entries.fold(S::zero(), |largest, x| largest.max(x.abs()))
}
