//! Euclidean geometry in cga3: how each type is constructed, which Euclidean data can be read from
//! it, and the relations between two of them.
//!
//! Nearly everything here is an inherent method of a type of [`cga3`](crate::cga3). Coordinates are
//! arrays `[x, y, z]`, angles are in radians and right-handed. A result that may not exist, or that
//! may be beyond the range of the scalar, is an `Option`: data read from an element is finite or
//! `None`. Constructors compute products of up to three coordinates, which may overflow for very
//! large coordinates.
//!
//! # Primitives
//!
//! - `Point`: `x + eo + ½x² ei`; built by `new`, `from([x, y, z])`, `p + direction`, `midpoint`,
//!   `lerp`; read by `coordinates`, `x`, `y`, `z`, `p.to(q)`.
//! - `FlatPoint`: `p∧ei`; built by `p ^ Infinity`, `from(p)`; read by `to_point`.
//! - `Direction`: `v∧ei`; built by `p.to(q)`, `from([x, y, z])`; read by `vector`, `length`, `dot`,
//!   `cross`, `normalized`.
//! - `PointPair`: `p∧q`; built by `through`, `tangent`, `from_centre_axis_radius_squared`; read by
//!   `endpoints`, `centre`, `radius`, `radius_squared`, `unit_direction`, `attitude`, `carrier`,
//!   `container`.
//! - `Circle`: `p∧q∧r`; built by `through`, `tangent`, `from_centre_normal_radius`,
//!   `…_radius_squared`; read by `centre`, `radius`, `radius_squared`, `unit_normal`, `attitude`,
//!   `axis`, `carrier`, `container`.
//! - `Sphere`: `p∧q∧r∧s`; built by `through`, `from_centre_radius`, `…_radius_squared`; read by
//!   `centre`, `radius`, `radius_squared`, `tangent_plane_at`.
//! - `Line`: `p∧q∧ei`; built by `through`, `from_point_direction`, `from_direction_moment`; read by
//!   `direction`, `unit_direction`, `moment`, `attitude`, `support`, `foot`.
//! - `Plane`: `p∧q∧r∧ei`; built by `through`, `from_point_normal`; read by `normal`, `unit_normal`,
//!   `attitude`, `support`, `signed_distance`.
//!
//! The dual forms `DualSphere`, `DualPlane`, `DualCircle`, `DualPointPair`, `DualFlatPoint`,
//! `DualDirection` and, for lines, `MotorGenerator` are results of `dual`, and `undual` converts
//! them back; `^` is the meet of dual forms. [`Kind`] classifies blades at run time: whether one is
//! round, and whether a round is real, imaginary or a tangent.
//!
//! # Rigid versors and scalings
//!
//! - `Rotor`: `exp(−½θB)`; built by `from_axis_angle`, `from_rotation_vector`, `between`,
//!   `from_matrix`, `from_quaternion`, `from_euler`, `look_along`; read by `to_axis_angle`,
//!   `to_rotation_vector`, `to_matrix`, `to_quaternion`, `to_euler`, `path`; functions `log`,
//!   `powf`, `sqrt`, `interpolate`, `nlerp`, `along`.
//! - `Translator`: `1 − ½ t ei`; built by `from_displacement`; read by `displacement`; functions
//!   `log`, `powf`, `sqrt`, `interpolate`.
//! - `Motor`: `T R`; built by `translator * rotor`, `about`, `look_at`, `from_matrix`,
//!   [`Screw::to_motor`]; read by `rotor`, `translator`, `to_matrix`, `screw`, `path`; functions
//!   `log`, `powf`, `sqrt`, `interpolate`, `nlerp`, `along`.
//! - `MotorGenerator`: `−½θB − ½ t ei`; built by `Motor::log`, [`Screw::generator`],
//!   `from_velocities`; read by `screw`, `velocity_at`, `angular_velocity`; functions `exp`.
//! - `Dilator`: `exp(½ ln s eo∧ei)`; built by `from_factor`, `exp`; read by `factor`; functions
//!   `log`, `powf`, `sqrt`.
//!
//! A rotor or motor and its negative are the short and the long rotation to the same orientation:
//! see [`RotationPath`].
//!
//! # Conformal versors
//!
//! - `Similarity`: `T R D`; built by products, `from_parts`, `Dilator::about`; read by `motor`,
//!   `rotor`, `displacement`, `factor`, `fixed_point`; functions `log`, `powf`, `sqrt`,
//!   `interpolate`.
//! - `SimilarityGenerator`: `−½θB − ½ t ei + ½ ln s eo∧ei`; built by `Similarity::log`; functions
//!   `exp`.
//! - `Transversor`: `1 − k eo`; built by `from_vector`; read by `vector`; functions `log`,
//!   `powf`, `sqrt`.
//! - `EvenVersor`: `V ~V = 1`; built by products, `From` of the others, `normalize`, `nearest_to`;
//!   read by `reflections`, `similarity_and_transversor`; functions `log`, `powf`, `sqrt`,
//!   `interpolate`.
//! - `Bivector`: any element of grade 2; built by `EvenVersor::log`, `From` of other generators;
//!   functions `exp`.
//! - `OddVersor`: `V ~V = 1`; built by `reflection`, `inversion`, products, `normalize`,
//!   `nearest_to`; read by `reflections`, `similarity_and_inversion`.
//!
//! Where the image of a point may have a weight, `transform_point` divides by it.
//!
//! # Relations and other maps
//!
//! Relations between two primitives, such as distances and angles, are in [`relation`], rays and
//! what they hit first in [`ray`], 4×4 matrices in [`homogeneous`], and affine maps, which need not
//! be conformal, in [`Affine`], with the motion and the similarity nearest to one. Matrices of maps
//! of any other elements are in [`linear`](crate::linear). Means of many motions, curves through
//! them and motions that fit points are in [`motion`], primitives that fit points in [`fit`];
//! chains of joints and their Jacobians in [`kinematics`].
//!
//! [`vga3::Vector`](crate::vga3::Vector) is the vector of space, with its operators, lengths and
//! angles. The other algebras have their geometry as inherent methods of their types too, behind
//! the features of their names; coordinates of the plane are `[x, y]`. [`DualQuaternionParts`] is a
//! motor as a pair of quaternions, as other libraries store it.

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
pub(crate) use cga3::composition;
pub use cga3::{
    Affine, DualQuaternionParts, EulerOrder, FitError, Kind, LookAtError, Nearest, NearestVersor,
    NotConformal, NotUnit, RotationPath, Screw, fit, homogeneous, kinematics, motion, ray,
    relation,
};
#[cfg(feature = "sta")]
pub use sta::{NotLorentz, NotSlowerThanLight, relative_velocity, velocity_sum};
