//! Euclidean geometry in cga3: what each type is built from, what can be read back from it, and how
//! two of them lie to each other.
//!
//! Nearly everything here is an inherent method of a type of [`cga3`](crate::cga3). Coordinates are
//! arrays `[x, y, z]`, angles are in radians and right-handed. What may not exist comes back as an
//! `Option`, and so does what may be beyond the range of the scalar: what is read back is finite or
//! `None`. What is built holds products of up to three coordinates, which very large ones take
//! beyond the range.
//!
//! # Primitives
//!
//! - `Point`: `x + eo + ½x² ei`; built by `new`, `from([x, y, z])`; read by `coordinates`.
//! - `FlatPoint`: `p∧ei`; built by `p ^ Infinity`, `from(p)`; read by `to_point`.
//! - `Direction`: `v∧ei`; built by `from_vector`; read by `vector`.
//! - `PointPair`: `p∧q`; built by `through`, `tangent`, `from_centre_axis_radius_squared`; read by
//!   `endpoints`, `centre`, `radius`, `radius_squared`, `unit_direction`, `attitude`, `carrier`,
//!   `container`.
//! - `Circle`: `p∧q∧r`; built by `through`, `tangent`, `from_centre_normal_radius`,
//!   `…_radius_squared`; read by `centre`, `radius`, `radius_squared`, `unit_normal`, `attitude`,
//!   `axis`, `carrier`, `container`.
//! - `Sphere`: `p∧q∧r∧s`; built by `through`, `from_centre_radius`, `…_radius_squared`; read by
//!   `centre`, `radius`, `radius_squared`.
//! - `Line`: `p∧q∧ei`; built by `through`, `from_point_direction`, `from_direction_moment`; read by
//!   `direction`, `unit_direction`, `moment`, `attitude`, `support`, `foot`.
//! - `Plane`: `p∧q∧r∧ei`; built by `through`, `from_point_normal`; read by `normal`, `unit_normal`,
//!   `attitude`, `support`, `signed_distance`.
//!
//! The dual forms `DualSphere`, `DualPlane`, `DualCircle`, `DualPointPair`, `DualFlatPoint`,
//! `DualDirection` and, for lines, `MotorGenerator` come from `dual` and go back by `undual`; they
//! meet by `^`. [`Kind`] says at run time whether a round is real, imaginary or a tangent, and
//! whether a blade is a round at all.
//!
//! # Rigid versors and scalings
//!
//! - `Rotor`: `exp(−½θB)`; built by `from_axis_angle`, `from_rotation_vector`, `between`,
//!   `from_matrix`, `from_quaternion`; read by `to_axis_angle`, `to_rotation_vector`, `to_matrix`,
//!   `to_quaternion`, `path`; along the way `log`, `powf`, `sqrt`, `interpolate`, `along`.
//! - `Translator`: `1 − ½ t ei`; built by `from_displacement`; read by `displacement`; along the
//!   way `log`, `powf`, `sqrt`, `interpolate`.
//! - `Motor`: `T R`; built by `translator * rotor`, `about`, `from_matrix`, [`Screw::to_motor`];
//!   read by `rotor`, `translator`, `to_matrix`, `screw`, `path`; along the way `log`, `powf`,
//!   `sqrt`, `interpolate`, `along`.
//! - `MotorGenerator`: `−½θB − ½ t ei`; built by `Motor::log`, [`Screw::generator`]; read by
//!   `screw`; along the way `exp`.
//! - `Dilator`: `exp(½ ln s eo∧ei)`; built by `from_factor`, `exp`; read by `factor`; along the way
//!   `log`, `powf`, `sqrt`.
//!
//! A rotor or motor and its negative are the short and the long way to one place: see
//! [`RotationPath`].
//!
//! # Conformal versors
//!
//! - `Similarity`: `T R D`; built by products, `from_parts`, `Dilator::about`; read by `motor`,
//!   `rotor`, `displacement`, `factor`, `fixed_point`; along the way `log`, `powf`, `sqrt`,
//!   `interpolate`.
//! - `SimilarityGenerator`: `−½θB − ½ t ei + ½ ln s eo∧ei`; built by `Similarity::log`; along the
//!   way `exp`.
//! - `Transversor`: `1 − k eo`; built by `from_vector`; read by `vector`; along the way `log`,
//!   `powf`, `sqrt`.
//! - `EvenVersor`: `V ~V = 1`; built by products, `From` of the others, `normalize`; along the way
//!   `log`, `powf`, `sqrt`, `interpolate`.
//! - `PointPair`: any bivector; built by `EvenVersor::log`, `From` of the other generators; along
//!   the way `exp`.
//! - `OddVersor`: `V ~V = 1`; built by `reflection`, `inversion`, products, `normalize`.
//!
//! Where the image of a point may have a weight, `transform_point` divides by it.
//!
//! # Relations and other maps
//!
//! What two primitives have to do with each other, distances and angles among it, is in
//! [`relation`]. 4×4 matrices are in [`homogeneous`], maps that are not conformal in [`Affine`].
//! Means of many motions, curves through them and motions that fit points are in [`motion`].
//!
//! [`vga3::Vector`](crate::vga3::Vector) is the vector of space, with its operators, lengths and
//! angles. The other algebras have their geometry as inherent methods of their types too, behind
//! the features of their names; coordinates of the plane are `[x, y]`. [`DualQuaternionParts`] are
//! a motor as others write it, two quaternions.

#[cfg(feature = "cga2")]
mod cga2;
mod cga3;
mod number;
#[cfg(feature = "pga2")]
mod pga2;
#[cfg(feature = "pga3")]
mod pga3;
#[cfg(feature = "sta")]
mod sta;
#[cfg(any(feature = "cga2", feature = "pga2", feature = "vga2"))]
mod vector2;
#[cfg(feature = "vga2")]
mod vga2;
mod vga3;

#[cfg(feature = "nalgebra-035")]
pub(crate) use cga3::affine;
pub use cga3::{
    Affine, DualQuaternionParts, Kind, NotConformal, NotUnit, RotationPath, Screw, homogeneous,
    motion, relation,
};
#[cfg(feature = "sta")]
pub use sta::{NotSlowerThanLight, relative_velocity, velocity_sum};
