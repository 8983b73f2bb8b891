//! Affine maps of joints as a stretch and a motor.

use ga_runtime::batch::skin::SkinScalar;
use ga_runtime::cga3::{Motor, Rotor, Translator};
use ga_runtime::geometry::Affine;
use nalgebra_035::Matrix3;

/// An affine map x' = G S x ~G: first a stretch S about the origin, then a motor G.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Stretched<S> {
    /// The motor G.
    pub motor: Motor<S>,
    /// The linear map S by rows: diagonal where the joint scales along the axes.
    pub stretch: [[S; 3]; 3],
}

impl<S: SkinScalar> Stretched<S> {
    /// The map of a matrix \[A | t\] by rows, by the polar decomposition A = R S: S is symmetric,
    /// and R is the rotation nearest to A. With A = U Σ Vᵀ these are R = U Vᵀ and S = V Σ Vᵀ; for a
    /// matrix that mirrors, R remains a rotation, and S mirrors. `None` for a matrix that is not
    /// finite or whose entries are beyond the range of squares.
    ///
    /// ```
    /// use ga_anim::skin::Stretched;
    ///
    /// // A rotation by 90° after a scaling by 3 along x.
    /// let rows = [[0.0, -1.0, 0.0, 5.0], [3.0, 0.0, 0.0, 6.0], [0.0, 0.0, 1.0, 7.0]];
    /// let map = Stretched::<f64>::from_matrix(&rows).ok_or("not finite")?;
    /// assert!((map.stretch[0][0] - 3.0).abs() < 1e-14 && (map.stretch[1][1] - 1.0).abs() < 1e-14);
    /// let (axis, angle) = map.motor.rotor().to_axis_angle();
    /// assert!((angle * axis[2] - std::f64::consts::FRAC_PI_2).abs() < 1e-14);
    /// # Ok::<(), &str>(())
    /// ```
    #[must_use]
    pub fn from_matrix(rows: &[[S; 4]; 3]) -> Option<Self> {
        let linear = rows.map(|[x, y, z, _]| [x, y, z]);
        Self::from_affine(&Affine::new(linear, rows.map(|row| row[3])))
    }

    /// The same for an affine map.
    #[must_use]
    pub fn from_affine(map: &Affine<S>) -> Option<Self> {
        let linear = Matrix3::from_fn(|i, j| map.linear[i][j].into());
        let displacement = map.translation;
        if !linear.iter().all(|x: &f64| x.is_finite())
            || !displacement.iter().all(|x| x.is_finite())
        {
            return None;
        }
        let svd = linear.try_svd(true, true, f64::EPSILON, 0)?;
        let (u, vt) = (svd.u?, svd.v_t?);
        let sign = (u.determinant() * vt.determinant()).signum();
        let rotation = u * vt * sign;
        let stretch = vt.transpose() * Matrix3::from_diagonal(&svd.singular_values) * vt * sign;
        let entries = |m: Matrix3<f64>| std::array::from_fn(|i| std::array::from_fn(|j| m[(i, j)]));
        let scalars = |m: [[f64; 3]; 3]| m.map(|row| row.map(S::from_f64));
        let rotor: Rotor<f64> = Rotor::from_matrix(entries(rotation))?;
        let ([x, y, z], w) = rotor.to_quaternion();
        let rotor = Rotor::from_quaternion([x, y, z].map(S::from_f64), S::from_f64(w))?;
        Some(Self {
            motor: Translator::from_displacement(displacement) * rotor,
            stretch: scalars(entries(stretch)),
        })
    }

    /// The affine map.
    #[must_use]
    pub fn affine(&self) -> Affine<S> {
        let zero = [S::zero(); 3];
        Affine::from(self.motor) * Affine::new(self.stretch, zero)
    }
}
