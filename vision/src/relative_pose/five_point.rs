//! Essential matrices of five pairs of directions.

use ga_runtime::vga3::Vector;
use nalgebra_035::SMatrix;

use super::matrix::{EssentialMatrix, null_space};
use ga_numerics::polynomial::real_roots;

/// Exponents of x, y and z.
type Monomial = [u8; 3];

const LINEAR: [Monomial; 4] = [[1, 0, 0], [0, 1, 0], [0, 0, 1], [0, 0, 0]];
const QUADRATIC: [Monomial; 10] = [
    [2, 0, 0],
    [1, 1, 0],
    [0, 2, 0],
    [1, 0, 1],
    [0, 1, 1],
    [0, 0, 2],
    [1, 0, 0],
    [0, 1, 0],
    [0, 0, 1],
    [0, 0, 0],
];
/// The first ten are eliminated. The others are x and y times 1, z and z², and powers of z.
const CUBIC: [Monomial; 20] = [
    [3, 0, 0],
    [0, 3, 0],
    [2, 1, 0],
    [1, 2, 0],
    [2, 0, 1],
    [2, 0, 0],
    [0, 2, 1],
    [0, 2, 0],
    [1, 1, 1],
    [1, 1, 0],
    [1, 0, 2],
    [1, 0, 1],
    [1, 0, 0],
    [0, 1, 2],
    [0, 1, 1],
    [0, 1, 0],
    [0, 0, 3],
    [0, 0, 2],
    [0, 0, 1],
    [0, 0, 0],
];

/// Where the product of two monomials is in a list.
const fn places<const N: usize, const M: usize, const P: usize>(
    first: [Monomial; N],
    second: [Monomial; M],
    products: [Monomial; P],
) -> [[usize; M]; N] {
    let mut table = [[0; M]; N];
    let mut n = 0;
    while n < N {
        let mut m = 0;
        while m < M {
            let (a, b) = (first[n], second[m]);
            let mut p = 0;
            while products[p][0] != a[0] + b[0]
                || products[p][1] != a[1] + b[1]
                || products[p][2] != a[2] + b[2]
            {
                p += 1;
            }
            table[n][m] = p;
            m += 1;
        }
        n += 1;
    }
    table
}

const LINEAR_BY_LINEAR: [[usize; 4]; 4] = places(LINEAR, LINEAR, QUADRATIC);
const QUADRATIC_BY_LINEAR: [[usize; 4]; 10] = places(QUADRATIC, LINEAR, CUBIC);

/// Adds a multiple of a product of polynomials.
fn add_product<const N: usize, const M: usize, const P: usize>(
    sum: &mut [f64; P],
    places: &[[usize; M]; N],
    factor: f64,
    first: &[f64; N],
    second: &[f64; M],
) {
    for (row, a) in places.iter().zip(first) {
        for (&place, b) in row.iter().zip(second) {
            sum[place] += factor * a * b;
        }
    }
}

/// The essential matrices E with `rᵀ E l = 0` for five pairs of directions l and r: up to ten.
///
/// The five equations leave a space of four dimensions, `E = x X + y Y + z Z + W`. In it `det E =
/// 0` and `2 E Eᵀ E − tr(E Eᵀ) E = 0` are ten cubic equations, which are eliminated to one
/// polynomial of degree ten in z (D. Nistér, "An efficient solution to the five-point relative pose
/// problem", IEEE Transactions on Pattern Analysis and Machine Intelligence 26, 2004).
///
/// Fewer are returned, or none, where the pairs are degenerate: directions that coincide, or three
/// or more in one plane with the same in the other view.
///
/// ```
/// use ga_runtime::cga3::{Point, Rotor, Translator};
/// use ga_runtime::vga3::Vector;
/// use ga_vision::relative_pose::five_point;
///
/// let rotor = Rotor::from_axis_angle([0.1, 1.0, 0.2], 0.3).unwrap();
/// let motor = Translator::from_displacement([0.8, 0.1, 0.6]) * rotor;
/// let see = |point: [f64; 3]| -> [Vector<f64>; 2] {
///     [point.into(), motor.transform(Point::from(point)).into()]
/// };
/// let pairs = [[0.0, 0.0, 4.0], [1.0, 0.0, 5.0], [-1.0, 1.0, 6.0], [0.5, -1.0, 3.0]].map(see);
/// let pairs = [pairs[0], pairs[1], pairs[2], pairs[3], see([1.0, 1.2, 7.0])];
/// let [sixth, image] = see([0.3, -0.2, 5.0]);
/// let found = five_point(&pairs);
/// assert!(found.iter().any(|essential| essential.residual(sixth, image).abs() < 1e-9));
/// ```
#[must_use]
pub fn five_point(pairs: &[[Vector<f64>; 2]; 5]) -> Vec<EssentialMatrix> {
    let Some([x, y, z, w]) = null_space::<4>(pairs) else {
        return Vec::new();
    };
    let entry = |k: usize| [x[k], y[k], z[k], w[k]];
    let essential: [[[f64; 4]; 3]; 3] =
        std::array::from_fn(|row| std::array::from_fn(|column| entry(3 * row + column)));
    let Some(reduced) = eliminated(&constraints(&essential)) else {
        return Vec::new();
    };
    let rows = [4, 6, 8].map(|row| Row::new(&reduced, row));
    let mut found = Vec::new();
    for z_value in real_roots(&determinant(&rows)) {
        let [k, l, m] = rows.each_ref().map(|row| row.at(z_value));
        // The unknowns (x, y, 1) are perpendicular to all three rows.
        let normals = [k.cross(l), l.cross(m), m.cross(k)];
        let longest = normals
            .into_iter()
            .max_by(|a, b| a.length_squared().total_cmp(&b.length_squared()));
        let Some(unknowns) = longest else { continue };
        let [x_value, y_value] = [unknowns.e1 / unknowns.e3, unknowns.e2 / unknowns.e3];
        let value = |k: usize| x[k] * x_value + y[k] * y_value + z[k] * z_value + w[k];
        let rows = [0, 3, 6].map(|k| Vector::new(value(k), value(k + 1), value(k + 2)));
        found.extend(EssentialMatrix::normalised(rows));
    }
    found
}

/// The ten cubic equations of an essential matrix: its determinant, and its singular values.
fn constraints(e: &[[[f64; 4]; 3]; 3]) -> SMatrix<f64, 10, 20> {
    let mut square = [[[0.0; 10]; 3]; 3];
    for (i, j, k) in indices() {
        add_product(
            &mut square[i][j],
            &LINEAR_BY_LINEAR,
            1.0,
            &e[i][k],
            &e[j][k],
        );
    }
    let trace: [f64; 10] = std::array::from_fn(|k| (0..3).map(|i| square[i][i][k]).sum());
    let mut equations = [[0.0; 20]; 10];
    for (i, j, k) in indices() {
        let equation = &mut equations[3 * i + j];
        add_product(equation, &QUADRATIC_BY_LINEAR, 2.0, &square[i][k], &e[k][j]);
    }
    for (i, row) in e.iter().enumerate() {
        for (j, entry) in row.iter().enumerate() {
            let equation = &mut equations[3 * i + j];
            add_product(equation, &QUADRATIC_BY_LINEAR, -1.0, &trace, entry);
        }
    }
    for (column, entry) in e[0].iter().enumerate() {
        let (next, last) = ((column + 1) % 3, (column + 2) % 3);
        let mut minor = [0.0; 10];
        add_product(&mut minor, &LINEAR_BY_LINEAR, 1.0, &e[1][next], &e[2][last]);
        add_product(
            &mut minor,
            &LINEAR_BY_LINEAR,
            -1.0,
            &e[1][last],
            &e[2][next],
        );
        add_product(&mut equations[9], &QUADRATIC_BY_LINEAR, 1.0, &minor, entry);
    }
    SMatrix::from_fn(|row, column| equations[row][column])
}

fn indices() -> impl Iterator<Item = (usize, usize, usize)> {
    (0..27).map(|index| (index / 9, index / 3 % 3, index % 3))
}

/// The last ten columns after the first ten have become the identity.
fn eliminated(equations: &SMatrix<f64, 10, 20>) -> Option<SMatrix<f64, 10, 10>> {
    let first = equations.fixed_columns::<10>(0).into_owned();
    let last = equations.fixed_columns::<10>(10).into_owned();
    first.lu().solve(&last)
}

/// An equation that is linear in x and y: its coefficients of x, y and 1 are polynomials in z, with
/// the constant term first.
struct Row {
    x: [f64; 4],
    y: [f64; 4],
    one: [f64; 5],
}

impl Row {
    /// The equation of a monomial with a factor z, less z times that of the monomial without it.
    fn new(reduced: &SMatrix<f64, 10, 10>, row: usize) -> Self {
        let with = |column: usize| reduced[(row, column)];
        let without = |column: usize| reduced[(row + 1, column)];
        let part = |first: usize| {
            let [a, b, c] = [first, first + 1, first + 2].map(with);
            let [d, e, f] = [first, first + 1, first + 2].map(without);
            [c, b - f, a - e, -d]
        };
        let [a, b, c, d] = [6, 7, 8, 9].map(with);
        let [e, f, g, h] = [6, 7, 8, 9].map(without);
        Self {
            x: part(0),
            y: part(3),
            one: [d, c - h, b - g, a - f, -e],
        }
    }

    fn at(&self, z: f64) -> Vector<f64> {
        let value =
            |coefficients: &[f64]| coefficients.iter().rev().fold(0.0, |sum, c| sum * z + c);
        Vector::new(value(&self.x), value(&self.y), value(&self.one))
    }
}

/// The determinant of three rows, of degree ten in z.
fn determinant(rows: &[Row; 3]) -> [f64; 11] {
    let mut sum = [0.0; 11];
    for k in 0..3 {
        let (l, m) = ((k + 1) % 3, (k + 2) % 3);
        for (i, a) in rows[k].one.iter().enumerate() {
            for (j, b) in rows[l].x.iter().enumerate() {
                for (n, c) in rows[m].y.iter().enumerate() {
                    sum[i + j + n] += a * b * c;
                }
            }
            for (j, b) in rows[l].y.iter().enumerate() {
                for (n, c) in rows[m].x.iter().enumerate() {
                    sum[i + j + n] -= a * b * c;
                }
            }
        }
    }
    sum
}
