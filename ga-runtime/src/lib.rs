//! Conformal geometric algebra that costs nothing.
//!
//! - [`cga3`]: points, spheres, planes, circles, lines and the motions between them, with what each is as geometry.
//!   [`pga3`] is the projective algebra of planes, lines and points.
//! - [`algebra!`]: declares an algebra of your own, with any signature or constant symmetric metric.
//! - [`ga!`]: compiles functions written in an algebra, each as one piece.
//! - [`batch`]: the same on slices, by the best instructions that the processor has.
//! - [`scalar`]: what a coefficient must be able to do, and the scalars that can.
//! - [`Element`] and [`products`]: traits for code that works with any type.
//! - [`interop`]: conversions from and to other crates, each behind its feature.
//! - [`dense`]: the reference algebra that tests compare with; it is meant to be right, not fast.
//! - `testing` (feature of that name): strategies, the exact scalar, and tests written from declarations.
//!
//! ```
//! use ga_runtime::cga3::{Infinity, Motor, Plane, Point, Rotor, Translator};
//!
//! let turn = Rotor::from_axis_angle([0.0, 0.0, 1.0], std::f64::consts::FRAC_PI_2).unwrap();
//! let motor: Motor<f64> = Translator::from_displacement([0.0, 0.0, 1.0]) * turn;
//!
//! // Three points span a plane; the motor moves it as it moves the points.
//! let [p, q, r] = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]].map(Point::from);
//! let plane: Plane<f64> = p ^ q ^ r ^ Infinity;
//! let moved = motor.transform(plane);
//! assert!(moved.signed_distance(motor.transform(q)).unwrap().abs() < 1e-15);
//! ```
//!
//! # Features
//!
//! `std` (on by default) takes elementary functions from the standard library; without it, `libm` brings them. `testing`
//! adds what tests need and brings proptest. `wide` makes the vectors of that crate scalars.
//! [`interop`] lists the features that convert from and to other crates.
//!
//! # What a type is
//!
//! Every type of an algebra is a `Copy` struct over its scalar with one field for each stored coefficient, `repr(C)`. A
//! [`cga3::Point`] in `f32` is 12 bytes; [`cga3::Infinity`] is none. Products are operators (`* ^ | &`) and methods; where a result's
//! type follows from facts, as a moved point is a point, that type comes back and nothing else is computed.
#![cfg_attr(not(feature = "std"), no_std)]
extern crate alloc;

#[doc(hidden)]
#[path = "private.rs"]
pub mod __private;
mod algebras;
pub mod batch;
pub mod dense;
mod element;
pub mod geometry;
pub mod interop;
mod macros;
pub mod products;
pub mod scalar;
#[cfg(feature = "testing")]
pub mod testing;

pub use algebras::{cga3, pga3};
pub use element::Element;
