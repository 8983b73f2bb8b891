//! What most programs in conformal geometry need, by one `use`.
//!
//! The macros [`ga!`](crate::ga) and [`algebra!`](crate::algebra), the algebra [`cga3`] with its
//! primitives and motions, the [`Vector`] of space, and the traits for generic code. None of these
//! has a name of the standard prelude; what stands elsewhere, such as the other algebras and
//! [`geometry`](crate::geometry), is named by its path.
//!
//! ```
//! use ga_runtime::prelude::*;
//!
//! ga! { ga_runtime::cga3;
//!     /// The circle in which a sphere meets a plane, moved by a motor.
//!     fn moved_section(m: Motor, s: Sphere, p: Plane) -> Circle { sandwich(m, s & p) }
//! }
//!
//! # fn main() {
//! let ball = Sphere::from_centre_radius(Point::new(0.0, 0.0, 3.0), 5.0);
//! let ground = Plane::from_point_normal(Point::default(), [0.0, 0.0, 1.0]);
//! let step = Motor::from(Translator::from_displacement([1.0, 0.0, 0.0]));
//! let circle: Circle<f64> = moved_section(step, ball, ground);
//! assert_eq!(circle.radius(), Some(4.0));
//! assert_eq!(circle.centre().unwrap().coordinates(), [1.0, 0.0, 0.0]);
//! # }
//! ```

pub use crate::cga3::{
    self, Circle, Direction, FlatPoint, Infinity, Line, Motor, Origin, Plane, Point, PointPair,
    Rotor, Sphere, Translator,
};
pub use crate::element::Element;
pub use crate::scalar::{Field, Real, Ring};
pub use crate::vga3::Vector;
pub use crate::{algebra, ga};
