//! Rotors and isometries of the crate `ultraviolet`.

use std::ops::Mul;

use ultraviolet::{DIsometry3, DRotor3, DVec3, Isometry3, Rotor3, Slerp, Vec3};

use crate::comparison::Comparison;
use crate::inputs::{self, Numbers};
use crate::precision::Precision;

/// The types of one precision.
pub(super) trait Types: Precision {
    type Vector: Copy;
    type Rotor: Copy + Mul<Output = Self::Rotor> + Slerp<Self>;
    type Isometry: Copy + Mul<Output = Self::Isometry>;

    const ROTOR: &'static str;
    const ISOMETRY: &'static str;

    fn vector(numbers: &mut Numbers) -> <Self as Types>::Vector;
    fn rotor(numbers: &mut Numbers) -> Self::Rotor;
    fn isometry(numbers: &mut Numbers) -> Self::Isometry;
    fn moved(
        isometry: &Self::Isometry,
        vector: &<Self as Types>::Vector,
    ) -> <Self as Types>::Vector;
}

macro_rules! types {
    ($scalar:ident, $vector:ident, $rotor:ident, $isometry:ident) => {
        impl Types for $scalar {
            type Vector = $vector;
            type Rotor = $rotor;
            type Isometry = $isometry;

            const ROTOR: &'static str = concat!("ultraviolet ", stringify!($rotor));
            const ISOMETRY: &'static str = concat!("ultraviolet ", stringify!($isometry));

            fn vector(numbers: &mut Numbers) -> $vector {
                $vector::from(numbers.numbers::<$scalar, 3>())
            }
            fn rotor(numbers: &mut Numbers) -> $rotor {
                let [from, to] = [(); 2].map(|()| <Self as Types>::vector(numbers).normalized());
                $rotor::from_rotation_between(from, to)
            }
            fn isometry(numbers: &mut Numbers) -> $isometry {
                $isometry::new(<Self as Types>::vector(numbers), Self::rotor(numbers))
            }
            #[inline(always)]
            fn moved(isometry: &$isometry, vector: &$vector) -> $vector {
                isometry.transform_vec(*vector)
            }
        }
    };
}

types!(f32, Vec3, Rotor3, Isometry3);
types!(f64, DVec3, DRotor3, DIsometry3);

pub(super) fn motor_point<S: Types>(group: &mut Comparison<'_>) {
    let isometries = inputs::list(1, S::isometry);
    let vectors = inputs::list(2, <S as Types>::vector);
    group.zip(S::ISOMETRY, &isometries, &vectors, S::moved);
}

pub(super) fn motor_motor<S: Types>(group: &mut Comparison<'_>) {
    let (left, right) = (inputs::list(1, S::isometry), inputs::list(2, S::isometry));
    group.zip(S::ISOMETRY, &left, &right, |a, b| *a * *b);
}

pub(super) fn rotor_rotor<S: Types>(group: &mut Comparison<'_>) {
    let (left, right) = (inputs::list(1, S::rotor), inputs::list(2, S::rotor));
    group.zip(S::ROTOR, &left, &right, |a, b| *a * *b);
}

pub(super) fn interpolation<S: Types>(group: &mut Comparison<'_>) {
    let pairs = inputs::list(1, |numbers| {
        (S::rotor(numbers), S::rotor(numbers), numbers.number::<S>())
    });
    group.map(S::ROTOR, &pairs, |(a, b, t)| a.slerp(*b, *t));
}
