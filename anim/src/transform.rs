//! The transform of a joint relative to its parent: a motor and a factor along each axis.
//!
//! A factor along each axis is not a versor, so the transform of a joint is a pair,
//!
//! ```text
//! x' = M (s ∘ x) ~M,   M = T R,
//! ```
//!
//! with s ∘ x the product component by component: first the scaling along the joint's axes, then
//! the rotation, then the translation, as in glTF. The composition of two such pairs is not a pair
//! where a scaling comes before a rotation (the result shears), so the transforms of joints are
//! composed as affine maps: see [`model_maps`](crate::recording::model_maps).

use ga_runtime::cga3::{Motor, Point, Rotor, Translator};
use ga_runtime::geometry::Affine;
use ga_runtime::scalar::{Field, Real};
use ga_runtime::vga3::Vector;

/// The transform of a joint relative to its parent, x' = M (s ∘ x) ~M.
///
/// # Examples
///
/// ```
/// use ga_anim::transform::Transform;
/// use ga_runtime::cga3::{Point, Rotor};
/// use ga_runtime::vga3::Vector;
///
/// let quarter = Rotor::from_axis_angle([0.0, 0.0, 1.0], std::f64::consts::FRAC_PI_2)
///     .ok_or("no axis")?;
/// let transform =
///     Transform::from_parts(Vector::new(5.0, 0.0, 0.0), quarter, Vector::new(2.0, 1.0, 1.0));
/// let [x, y, z] = transform.transform(Point::new(1.0, 0.0, 0.0)).coordinates();
/// assert!((x - 5.0).abs() < 1e-15 && (y - 2.0).abs() < 1e-15 && z == 0.0);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Transform<S> {
    /// The rotation and the translation.
    pub motor: Motor<S>,
    /// The factors along the joint's own axes, which come first.
    pub scale: Vector<S>,
}

impl<S: Field> Default for Transform<S> {
    /// The identity.
    fn default() -> Self {
        Self::from(Motor::default())
    }
}

impl<S: Field> From<Motor<S>> for Transform<S> {
    /// A rigid motion: all factors are 1.
    fn from(motor: Motor<S>) -> Self {
        let one = S::one();
        Self {
            motor,
            scale: Vector::new(one, one, one),
        }
    }
}

impl<S: Field> Transform<S> {
    /// Scaling by `scale`, then `rotor`, then the translation.
    #[must_use]
    pub fn from_parts(translation: Vector<S>, rotor: Rotor<S>, scale: Vector<S>) -> Self {
        let motor = Translator::from_displacement(translation.coordinates()) * rotor;
        Self { motor, scale }
    }

    /// The translation, which comes last: the place of the joint relative to its parent.
    #[must_use]
    pub fn translation(&self) -> Vector<S> {
        self.motor.translator().displacement().into()
    }

    /// The rotation.
    #[must_use]
    pub fn rotor(&self) -> Rotor<S> {
        self.motor.rotor()
    }

    /// A point given in the joint's frame, in that of its parent.
    #[must_use]
    pub fn transform(&self, point: Point<S>) -> Point<S> {
        let [x, y, z] = Vector::from(point.coordinates())
            .component_product(self.scale)
            .coordinates();
        self.motor.transform(Point::new(x, y, z))
    }

    /// The same map as a matrix `[L | t]` by rows, x' = L x + t.
    #[must_use]
    pub fn to_matrix(&self) -> [[S; 4]; 3] {
        let [a, b, c] = self.scale.coordinates();
        self.motor
            .to_matrix()
            .map(|[x, y, z, t]| [x * a, y * b, z * c, t])
    }

    /// The same map as an affine map, which composes with others by `*`.
    #[must_use]
    pub fn to_affine(&self) -> Affine<S> {
        let rows = self.to_matrix();
        Affine::new(rows.map(|[x, y, z, _]| [x, y, z]), rows.map(|row| row[3]))
    }
}

impl<S: Real<Mask = bool>> Transform<S> {
    /// Whether all factors are 1, so that the motor says all.
    #[must_use]
    pub fn is_rigid(&self) -> bool {
        self.scale.coordinates().iter().all(|&x| x == S::one())
    }

    /// The transform a part `t` of the way to `other`: the rotation by slerp along the shorter arc,
    /// translation and factors linearly.
    ///
    /// This is what glTF's linear interpolation and most players of BVH files do. For the screw
    /// motion instead, see [`Motor::interpolate`].
    ///
    /// # Examples
    ///
    /// ```
    /// use ga_anim::transform::Transform;
    /// use ga_runtime::cga3::{Motor, Translator};
    ///
    /// let to = Transform::from(Motor::from(Translator::from_displacement([2.0, 0.0, 0.0])));
    /// let half = Transform::default().interpolate(&to, 0.5);
    /// assert_eq!(half.translation().coordinates(), [1.0, 0.0, 0.0]);
    /// ```
    #[must_use]
    pub fn interpolate(&self, other: &Self, t: S) -> Self {
        Self::from_parts(
            self.translation().lerp(other.translation(), t),
            self.rotor().interpolate(other.rotor(), t),
            self.scale.lerp(other.scale, t),
        )
    }
}
