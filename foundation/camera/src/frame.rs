//! Frames of reference in types.
//!
//! Coordinates mean something only in a frame. [`In<F, T>`](In) is a `T` with coordinates in the
//! frame F, and [`Pose<A, B>`](Pose) the motor that takes coordinates in A into coordinates in B,
//! `x_B = M x_A ~M`. Both compile to what they hold, and a motor that is applied to coordinates of
//! another frame, or composed in the wrong order, does not compile.
//!
//! ```
//! use ga_runtime::cga3::{Point, Translator};
//! use ga_camera::frame::{In, LeftCamera, Pose, RightCamera, World};
//!
//! let forwards = Translator::from_displacement([0.0, 0.0, 2.0]);
//! let aside = Translator::from_displacement([-0.1, 0.0, 0.0]);
//! let world_to_left = Pose::<World, LeftCamera>::new(forwards.into());
//! let left_to_right = Pose::<LeftCamera, RightCamera>::new(aside.into());
//! let point = In::<World, _>::new(Point::new(0.1, 0.0, 1.0));
//!
//! let seen: In<RightCamera, Point<f64>> = world_to_left.then(left_to_right).transform(point);
//! assert_eq!(seen.value, Point::new(0.0, 0.0, 3.0));
//! assert_eq!(left_to_right.reverse().transform(seen), world_to_left.transform(point));
//! ```
//!
//! The wrong frame is an error of the compiler:
//!
//! ```compile_fail,E0308
//! use ga_runtime::cga3::Point;
//! use ga_camera::frame::{In, LeftCamera, Pose, RightCamera, World};
//! let left_to_right = Pose::<LeftCamera, RightCamera>::default();
//! let point = In::<World, _>::new(Point::new(0.1, 0.0, 1.0));
//! left_to_right.transform(point);
//! ```

use std::fmt::Debug;
use std::marker::PhantomData;

use ga_runtime::cga3::{Motor, Rotor};
use ga_runtime::products::Sandwich;

/// From a camera's frame, with y down and z forward, into one with y up and z towards the viewer,
/// as glTF has it, and back: a rotation by π about x.
///
/// ```
/// use ga_camera::frame::y_up;
/// use ga_runtime::cga3::Point;
/// assert_eq!(y_up().transform(Point::new(1.0, 2.0, 3.0)), Point::new(1.0, -2.0, -3.0));
/// ```
#[must_use]
pub fn y_up() -> Motor<f64> {
    Rotor::new_unchecked(0.0, 0.0, 0.0, -1.0).into()
}

/// A frame of reference, as a type without values. Any type that is `Copy`, `Debug` and `PartialEq`
/// may name one.
pub trait Frame: Copy + Debug + PartialEq {}

macro_rules! frames {
    ($($(#[$text:meta])* $name:ident,)*) => {$(
        $(#[$text])*
        #[derive(Clone, Copy, Debug, PartialEq, Eq)]
        pub enum $name {}

        impl Frame for $name {}
    )*};
}

frames! {
    /// The world in which cameras stand.
    World,
    /// A camera: x to the right, y down, z forward along the optical axis.
    CameraFrame,
    /// The left camera of a rig.
    LeftCamera,
    /// The right camera of a rig.
    RightCamera,
    /// The left camera of a rig after rectification.
    RectifiedLeft,
    /// The right camera of a rig after rectification.
    RectifiedRight,
    /// A calibration board: x along its rows, y along its columns, z into the board.
    Board,
}

/// A value with coordinates in the frame F.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct In<F: Frame, T> {
    /// The value.
    pub value: T,
    frame: PhantomData<F>,
}

impl<F: Frame, T> In<F, T> {
    /// States that the coordinates of a value are in the frame F.
    pub const fn new(value: T) -> Self {
        Self {
            value,
            frame: PhantomData,
        }
    }
}

/// The motor that takes coordinates in the frame A into coordinates in the frame B,
/// `x_B = M x_A ~M`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Pose<A: Frame, B: Frame> {
    /// The motor.
    pub motor: Motor<f64>,
    frames: PhantomData<(A, B)>,
}

impl<A: Frame, B: Frame> Pose<A, B> {
    /// States that a motor takes coordinates in A into coordinates in B.
    #[must_use]
    pub const fn new(motor: Motor<f64>) -> Self {
        Self {
            motor,
            frames: PhantomData,
        }
    }

    /// The same object in the frame B.
    #[must_use]
    pub fn transform<T>(self, object: In<A, T>) -> In<B, <Motor<f64> as Sandwich<T>>::Output>
    where
        Motor<f64>: Sandwich<T>,
    {
        In::new(self.motor.transform(object.value))
    }

    /// From A through B to C: the product `N M` of the motors.
    #[must_use]
    pub fn then<C: Frame>(self, next: Pose<B, C>) -> Pose<A, C> {
        Pose::new(next.motor * self.motor)
    }

    /// From B to A: the reverse `~M`.
    #[must_use]
    pub fn reverse(self) -> Pose<B, A> {
        Pose::new(self.motor.reverse())
    }
}

/// Frames that coincide.
impl<A: Frame, B: Frame> Default for Pose<A, B> {
    fn default() -> Self {
        Self::new(Motor::default())
    }
}
