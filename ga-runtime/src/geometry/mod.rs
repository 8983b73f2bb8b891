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
//! | type | formula | built by | read by |
//! | --- | --- | --- | --- |
//! | `Point` | `x + eo + ½x² ei` | `new`, `from([x, y, z])` | `coordinates` |
//! | `FlatPoint` | `p∧ei` | `p ^ Infinity`, `from(p)` | `to_point` |
//! | `Direction` | `v∧ei` | `from_vector` | `vector` |
//! | `PointPair` | `p∧q` | `through`, `tangent`, `from_centre_axis_radius_squared` | `endpoints`, `centre`, `radius`, `radius_squared`, `unit_direction`, `attitude`, `carrier`, `container` |
//! | `Circle` | `p∧q∧r` | `through`, `tangent`, `from_centre_normal_radius`, `…_radius_squared` | `centre`, `radius`, `radius_squared`, `unit_normal`, `attitude`, `axis`, `carrier`, `container` |
//! | `Sphere` | `p∧q∧r∧s` | `through`, `from_centre_radius`, `…_radius_squared` | `centre`, `radius`, `radius_squared` |
//! | `Line` | `p∧q∧ei` | `through`, `from_point_direction`, `from_direction_moment` | `direction`, `unit_direction`, `moment`, `attitude`, `support`, `foot` |
//! | `Plane` | `p∧q∧r∧ei` | `through`, `from_point_normal` | `normal`, `unit_normal`, `attitude`, `support`, `signed_distance` |
//!
//! The dual forms `DualSphere`, `DualPlane`, `DualCircle`, `DualPointPair`, `DualFlatPoint`,
//! `DualDirection` and, for lines, `MotorGenerator` come from `dual` and go back by `undual`; they
//! meet by `^`. [`Kind`] says at run time whether a round is real, imaginary or a tangent, and
//! whether a blade is a round at all.
//!
//! # Rigid versors and scalings
//!
//! | type | formula | built by | read by | along the way |
//! | --- | --- | --- | --- | --- |
//! | `Rotor` | `exp(−½θB)` | `from_axis_angle`, `from_rotation_vector`, `between`, `from_matrix`, `from_quaternion` | `to_axis_angle`, `to_rotation_vector`, `to_matrix`, `to_quaternion`, `path` | `log`, `powf`, `sqrt`, `interpolate`, `along` |
//! | `Translator` | `1 − ½ t ei` | `from_displacement` | `displacement` | `log`, `powf`, `sqrt`, `interpolate` |
//! | `Motor` | `T R` | `translator * rotor`, `about`, `from_matrix`, [`Screw::to_motor`] | `rotor`, `translator`, `to_matrix`, `screw`, `path` | `log`, `powf`, `sqrt`, `interpolate`, `along` |
//! | `MotorGenerator` | `−½θB − ½ t ei` | `Motor::log`, [`Screw::generator`] | `screw` | `exp` |
//! | `Dilator` | `exp(½ ln s eo∧ei)` | `from_factor`, `exp` | `factor` | `log`, `powf`, `sqrt` |
//!
//! A rotor or motor and its negative are the short and the long way to one place: see
//! [`RotationPath`].
//!
//! # Conformal versors
//!
//! | type | formula | built by | read by | along the way |
//! | --- | --- | --- | --- | --- |
//! | `Similarity` | `T R D` | products, `from_parts`, `Dilator::about` | `motor`, `rotor`, `displacement`, `factor`, `fixed_point` | `log`, `powf`, `sqrt`, `interpolate` |
//! | `SimilarityGenerator` | `−½θB − ½ t ei + ½ ln s eo∧ei` | `Similarity::log` | | `exp` |
//! | `Transversor` | `1 − k eo` | `from_vector` | `vector` | `log`, `powf`, `sqrt` |
//! | `EvenVersor` | `V ~V = 1` | products, `From` of the others, `normalize` | | `log`, `powf`, `sqrt`, `interpolate` |
//! | `PointPair` | any bivector | `EvenVersor::log`, `From` of the other generators | | `exp` |
//! | `OddVersor` | `V ~V = 1` | `reflection`, `inversion`, products, `normalize` | | |
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
