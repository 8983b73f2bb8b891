//! Many elements at once: slices in, slices out.
//!
//! ```
//! use ga_runtime::batch;
//! use ga_runtime::cga3::{Motor, Point, Translator};
//!
//! let motor: Motor<f32> = Translator::from_displacement([1.0, 0.0, 0.0]).into();
//! let mut points = vec![Point::new(0.0, 0.5, 2.0); 1000];
//! batch::transform(&motor, &mut points);
//! assert_eq!(points[999].coordinates(), [1.0, 0.5, 2.0]);
//! ```
//!
//! | function | what it does |
//! | --- | --- |
//! | [`transform`], [`transform_into`] | one motor moves all elements |
//! | [`transform_each`] | each motor moves its own element |
//! | [`compose`] | products of motors, pair by pair |
//! | [`blend`] | weighted means of motors from a palette, as in skinning |
//! | [`log`], [`exp`] | generators of motors, and back |
//! | [`interpolate`], [`nlerp`] | motors between motors, pair by pair |
//! | [`skin`] | points that each follow several motions, in many frames |
//!
//! Elements are stored as in any slice, one after the other. The loops over them are compiled for
//! the target of the build, for AVX2, and for AVX-512 where that is quicker, and [`Batch`] chooses
//! when the program runs. In each, the compiler translates them into vector instructions, which is
//! faster than copying the coefficients into [`Lanes`](crate::scalar::Lanes) (0.7 ns a point, not
//! 1.3). Multiplications and additions are fused only if the whole program is built for a processor
//! with that instruction, and then in all versions: their results are equal bit for bit.
//! The results of [`transform_each`] and [`compose`] are also equal to those of the methods on
//! single elements. The loops of [`skin`] are an exception: in `f32` they have forms with fused
//! instructions of their own for AVX2 and AVX-512, whose results differ by a few ε.
//! [`transform`] and [`transform_into`] convert the motor to a matrix once, which rounds in another
//! order: results differ by at most a few dozen ε of the largest coefficient of the element and of
//! the translation.
//!
//! Infinite and NaN coefficients propagate as in the arithmetic. If slices have different lengths,
//! that is an error and nothing is written.

mod blend;
mod error;
mod interpolation;
mod moved;
mod screw;
pub mod skin;
mod transform;

pub use crate::instruction_set::InstructionSet;
/// An alias of [`InstructionSet`].
#[doc(no_inline)]
pub use crate::instruction_set::InstructionSet as Path;
pub use crate::unsafe_code::Work;
pub use error::{BatchError, LengthMismatch};
pub use moved::Moved;

use crate::cga3::{Motor, MotorGenerator};
use crate::scalar::Real;

/// The operations on slices by a given set of instructions. The functions of this module take the
/// best one.
///
/// ```
/// use ga_runtime::batch::{Batch, InstructionSet};
/// use ga_runtime::cga3::{Motor, Point};
/// let baseline = Batch::on(InstructionSet::Baseline);
/// let mut points = [Point::new(1.0, 2.0, 3.0)];
/// baseline.transform(&Motor::default(), &mut points);
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Batch {
    instruction_set: InstructionSet,
}

impl Default for Batch {
    fn default() -> Self {
        Self::new()
    }
}

impl Batch {
    /// The best set of instructions that the processor has.
    #[must_use]
    pub fn new() -> Self {
        Self::on(InstructionSet::best())
    }

    /// A given set of instructions; one that the processor lacks is replaced by
    /// [`InstructionSet::Baseline`].
    #[must_use]
    pub fn on(set: InstructionSet) -> Self {
        let instruction_set = if set.is_available() {
            set
        } else {
            InstructionSet::Baseline
        };
        Self { instruction_set }
    }

    /// The set of instructions in use.
    #[must_use]
    pub fn instruction_set(self) -> InstructionSet {
        self.instruction_set
    }

    /// An alias of [`instruction_set`](Self::instruction_set).
    #[must_use]
    pub fn path(self) -> InstructionSet {
        self.instruction_set
    }

    /// Runs a loop of your own, compiled for the set of instructions.
    ///
    /// ```
    /// use ga_runtime::batch::{Batch, Work};
    ///
    /// struct Scale<'a>(&'a mut [f32]);
    ///
    /// impl Work for Scale<'_> {
    ///     #[inline(always)]
    ///     fn run(self) {
    ///         for number in self.0 {
    ///             *number *= 2.0;
    ///         }
    ///     }
    /// }
    ///
    /// let mut numbers = [1.5; 100];
    /// Batch::new().run(Scale(&mut numbers));
    /// assert_eq!(numbers[99], 3.0);
    /// ```
    pub fn run(self, work: impl Work) {
        crate::unsafe_code::run(self.instruction_set, work);
    }
}

/// Moves all elements by one motor, `x ↦ M x ~M`, in place.
pub fn transform<S: Real, X: Moved<S>>(motor: &Motor<S>, elements: &mut [X]) {
    Batch::new().transform(motor, elements);
}

/// Moves all elements by one motor into another slice.
///
/// # Errors
/// The slices have different lengths.
///
/// ```
/// use ga_runtime::batch::{transform_into, LengthMismatch};
/// use ga_runtime::cga3::{Motor, Point};
/// let points = [Point::new(1.0, 2.0, 3.0); 4];
/// let mut moved = [Point::default(); 4];
/// transform_into(&Motor::default(), &points, &mut moved)?;
/// assert_eq!(moved, points);
/// let error = transform_into(&Motor::default(), &points, &mut moved[..3]);
/// assert_eq!(error, Err(LengthMismatch { expected: 4, found: 3 }));
/// # Ok::<(), LengthMismatch>(())
/// ```
pub fn transform_into<S: Real, X: Moved<S>>(
    motor: &Motor<S>,
    elements: &[X],
    moved: &mut [X],
) -> Result<(), LengthMismatch> {
    Batch::new().transform_into(motor, elements, moved)
}

/// Moves each element by its own motor.
///
/// # Errors
/// The slices have different lengths.
pub fn transform_each<S: Real, X: Moved<S>>(
    motors: &[Motor<S>],
    elements: &[X],
    moved: &mut [X],
) -> Result<(), LengthMismatch> {
    Batch::new().transform_each(motors, elements, moved)
}

/// The products `left · right`, pair by pair; the right motor acts first.
///
/// # Errors
/// The slices have different lengths.
pub fn compose<S: Real>(
    left: &[Motor<S>],
    right: &[Motor<S>],
    products: &mut [Motor<S>],
) -> Result<(), LengthMismatch> {
    Batch::new().compose(left, right, products)
}

/// Weighted means of motors from a palette, normalised. Each result has K influences, which are
/// pairs of an index into the palette and a weight.
///
/// This is [`Motor::blend_influences`] of each list. A motor and its negative are the same motion,
/// so each motor enters with the sign that brings it nearer to the motor of the largest weight (the
/// first of several with that weight). So the mean takes the smaller rotations, and has the sign of
/// that motor. Influences of weight zero are ignored, whatever their index.
///
/// ```
/// use ga_runtime::batch;
/// use ga_runtime::cga3::{Motor, Translator};
/// let palette = [0.0, 2.0].map(|x| Motor::from(Translator::from_displacement([x, 0.0, 0.0])));
/// let mut means = [Motor::default(); 2];
/// batch::blend(&palette, &[[(0, 0.5), (1, 0.5)], [(1, 1.0), (0, 0.0)]], &mut means)?;
/// assert_eq!(means.map(|m| m.translator().displacement()[0]), [1.0, 2.0]);
/// # Ok::<(), batch::BatchError>(())
/// ```
///
/// # Errors
/// The lengths differ, an index is outside of the palette, or the mean of an element does not
/// exist. If lengths or indices are wrong, nothing is written; if a mean does not exist, the means
/// before it have been written.
pub fn blend<S: Real<Mask = bool>, const K: usize>(
    palette: &[Motor<S>],
    influences: &[[(usize, S); K]],
    means: &mut [Motor<S>],
) -> Result<(), BatchError> {
    Batch::new().blend(palette, influences, means)
}

/// The logarithms of motors, as [`Motor::log`].
///
/// # Errors
/// The slices have different lengths.
pub fn log<S: Real>(
    motors: &[Motor<S>],
    generators: &mut [MotorGenerator<S>],
) -> Result<(), LengthMismatch> {
    Batch::new().log(motors, generators)
}

/// The exponentials of generators, as [`MotorGenerator::exp`].
///
/// # Errors
/// The slices have different lengths.
pub fn exp<S: Real>(
    generators: &[MotorGenerator<S>],
    motors: &mut [Motor<S>],
) -> Result<(), LengthMismatch> {
    Batch::new().exp(generators, motors)
}

/// The interpolation of motors along screws, pair by pair, as [`Motor::interpolate`]: slerp.
///
/// # Errors
/// The slices have different lengths.
///
/// ```
/// use ga_runtime::batch;
/// use ga_runtime::cga3::{Motor, Rotor};
/// let about = |angle: f64| Motor::from(Rotor::from_axis_angle([0.0, 0.0, 1.0], angle).unwrap());
/// let mut between = [Motor::default(); 2];
/// batch::interpolate(&[about(0.0); 2], &[about(1.0); 2], &[0.25, 0.5], &mut between)?;
/// let angles = between.map(|m| m.rotor().to_axis_angle().1);
/// assert!((angles[0] - 0.25).abs() < 1e-15 && (angles[1] - 0.5).abs() < 1e-15);
/// # Ok::<(), batch::LengthMismatch>(())
/// ```
pub fn interpolate<S: Real<Mask = bool>>(
    from: &[Motor<S>],
    to: &[Motor<S>],
    t: &[S],
    between: &mut [Motor<S>],
) -> Result<(), LengthMismatch> {
    Batch::new().interpolate(from, to, t, between)
}

/// The normalised linear interpolation of motors, pair by pair, as [`Motor::nlerp`]: the blend of
/// two poses, with a weight for each joint.
///
/// # Errors
/// The slices have different lengths.
pub fn nlerp<S: Real>(
    from: &[Motor<S>],
    to: &[Motor<S>],
    t: &[S],
    between: &mut [Motor<S>],
) -> Result<(), LengthMismatch> {
    Batch::new().nlerp(from, to, t, between)
}
