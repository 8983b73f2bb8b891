//! Matrices of nalgebra and glam.

use ga_runtime::cga3::RoundVector;
use ga_runtime::linear::LinearMap;
use ga_runtime::vga3::{Bivector, Vector};
use ga_runtime::{pga3, sta};
use glam_034::{DMat3, DVec3, Mat4};
use nalgebra_035::{Matrix3, Matrix5, Vector3, Vector5};

const ROWS: [[f64; 3]; 3] = [[1.0, 2.0, 3.0], [4.0, 5.0, 6.0], [7.0, 8.0, -9.0]];

#[test]
fn matrices_act_on_columns_of_coefficients() {
    let map = LinearMap::<Vector<f64>, Vector<f64>>::from_rows(ROWS);
    let image = map.apply(Vector::new(1.0, -1.0, 2.0)).coordinates();
    let matrix: Matrix3<f64> = (&map).into();
    assert_eq!(matrix * Vector3::new(1.0, -1.0, 2.0), Vector3::from(image));
    let matrix: DMat3 = (&map).into();
    assert_eq!(matrix * DVec3::new(1.0, -1.0, 2.0), DVec3::from(image));
}

#[test]
fn matrices_come_back() {
    let map = LinearMap::<Vector<f64>, Bivector<f64>>::from_rows(ROWS);
    assert_eq!(LinearMap::from(Matrix3::from(&map)), map);
    assert_eq!(LinearMap::from(DMat3::from(&map)), map);
    let rows: [[f32; 4]; 4] =
        core::array::from_fn(|i| core::array::from_fn(|j| (4 * i + j) as f32));
    let map = LinearMap::<sta::Vector<f32>, pga3::Plane<f32>>::from_rows(rows);
    let matrix = Mat4::from(&map);
    assert_eq!(matrix.row(1).to_array(), rows[1]);
    assert_eq!(LinearMap::from(matrix), map);
    let matrix = Matrix5::from_fn(|i, j| (i * j) as f64 - i as f64);
    let map = LinearMap::<RoundVector<f64>, RoundVector<f64>>::from(matrix);
    let x = Vector5::new(1.0, 2.0, 3.0, 4.0, 5.0);
    let image = map.apply(RoundVector::new(1.0, 2.0, 3.0, 4.0, 5.0));
    assert_eq!(
        matrix * x,
        Vector5::new(image.e1, image.e2, image.e3, image.eo, image.ei)
    );
}
