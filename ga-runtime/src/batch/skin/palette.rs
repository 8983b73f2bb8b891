//! The motions of the joints in a frame.

use alloc::vec;
use alloc::vec::Vec;

use super::points::{Chunk, Skin};
use crate::batch::BatchError;
use crate::batch::error::same_length;
use crate::cga3::Motor;
use crate::geometry::Affine;
use crate::geometry::motion::relative_sign;
use crate::scalar::Real;

/// The columns of a matrix `[L | t]`, each filled up to four numbers by a zero.
#[derive(Clone, Copy, Debug, Default)]
#[repr(align(64))]
pub(crate) struct Columns<S>(pub(crate) [S; 16]);

impl<S: Real<Mask = bool> + Default> Columns<S> {
    fn new(map: Affine<S>) -> Self {
        let ([a, b, c], [x, y, z], zero) = (map.linear, map.translation, S::zero());
        Self([
            a[0], b[0], c[0], zero, a[1], b[1], c[1], zero, a[2], b[2], c[2], zero, x, y, z, zero,
        ])
    }
}

/// An affine map for each joint.
#[derive(Clone, Debug)]
pub struct AffinePalette<S> {
    pub(crate) maps: Vec<Columns<S>>,
}

impl<S: Real<Mask = bool> + Default> AffinePalette<S> {
    /// Identity maps for the joints of a skin.
    #[must_use]
    pub fn new(skin: &Skin<S>) -> Self {
        let identity = Columns::new(Affine::from_translation([S::zero(); 3]));
        Self {
            maps: vec![identity; skin.joints()],
        }
    }

    /// Takes the maps of a frame.
    ///
    /// # Errors
    /// There is not one map for each joint, or one is not finite. Then the palette is as before.
    pub fn set(&mut self, maps: &[Affine<S>]) -> Result<(), BatchError> {
        same_length(self.maps.len(), maps.len())?;
        let is_finite = |map: &Affine<S>| {
            let entries = map.linear.iter().flatten().chain(&map.translation);
            entries.fold(true, |all, x| all & x.is_finite())
        };
        if let Some(joint) = maps.iter().position(|map| !is_finite(map)) {
            return Err(BatchError::BadMotion { joint });
        }
        for (columns, map) in self.maps.iter_mut().zip(maps) {
            *columns = Columns::new(*map);
        }
        Ok(())
    }

    pub(super) fn fits(&self, chunk: &Chunk<S>) -> Result<(), BatchError> {
        Ok(same_length(chunk.joints, self.maps.len())?)
    }
}

/// A motor for each joint, and a stretch at rest where joints scale.
#[derive(Clone, Debug)]
pub struct MotorPalette<S> {
    /// The coefficients of each motor, followed by those of each negative.
    pub(crate) motors: Vec<Coefficients<S>>,
    /// The pairs of a heaviest influence and another one.
    pairs: Vec<[u32; 2]>,
    /// For each joint and then for each pair, where its motor with the right sign is in `motors`.
    pub(crate) signed: Vec<u32>,
    /// The pairs that are half a turn apart, whose sign depends on the other influences.
    pub(crate) doubtful: Vec<bool>,
    pub(crate) has_doubtful: bool,
    /// Empty where nothing stretches.
    pub(crate) stretches: Vec<Columns<S>>,
}

/// The coefficients of a motor in the order of its blades.
#[derive(Clone, Copy, Debug, Default)]
#[repr(align(32))]
pub(crate) struct Coefficients<S>(pub(crate) [S; 8]);

impl<S: Real<Mask = bool> + Default> Coefficients<S> {
    pub(super) fn new(m: Motor<S>) -> Self {
        Self([
            m.scalar(),
            m.e12(),
            m.e13(),
            m.e23(),
            m.e1i(),
            m.e2i(),
            m.e3i(),
            m.e123i(),
        ])
    }

    /// The motor.
    pub(super) fn motor(&self) -> Motor<S> {
        let [scalar, e12, e13, e23, e1i, e2i, e3i, e123i] = self.0;
        Motor::new_unchecked(scalar, e12, e13, e23, e1i, e2i, e3i, e123i)
    }
}

impl<S: Real<Mask = bool> + Default> MotorPalette<S> {
    /// Identity motors for the joints of a skin.
    #[must_use]
    pub fn new(skin: &Skin<S>) -> Self {
        let joints = skin.joints();
        let identity = Motor::default();
        let mut motors = vec![Coefficients::new(identity); joints];
        motors.resize(2 * joints, Coefficients::new(-identity));
        let pairs = skin.pairs.clone();
        Self {
            motors,
            signed: (0..joints as u32)
                .chain(pairs.iter().map(|[_, other]| *other))
                .collect(),
            doubtful: vec![false; joints + pairs.len()],
            has_doubtful: false,
            stretches: Vec::with_capacity(joints),
            pairs,
        }
    }

    /// Takes the motors of a frame; nothing stretches.
    ///
    /// # Errors
    /// There is not one motor for each joint, or one is not a unit motor within √ε. Then the
    /// palette is as before.
    pub fn set(&mut self, motors: &[Motor<S>]) -> Result<(), BatchError> {
        let joints = self.motors.len() / 2;
        same_length(joints, motors.len())?;
        if let Some(joint) = motors.iter().position(|motor| !is_unit(*motor)) {
            return Err(BatchError::BadMotion { joint });
        }
        self.stretches.clear();
        for (joint, motor) in motors.iter().enumerate() {
            self.motors[joint] = Coefficients::new(*motor);
            self.motors[joints + joint] = Coefficients::new(-*motor);
        }
        self.has_doubtful = false;
        for (number, &[heaviest, other]) in self.pairs.iter().enumerate() {
            let sign = relative_sign(motors[heaviest as usize], motors[other as usize]);
            let is_opposite = sign.is_some_and(|sign| sign.less_than(S::zero()));
            self.signed[joints + number] = other + if is_opposite { joints as u32 } else { 0 };
            self.doubtful[joints + number] = sign.is_none();
            self.has_doubtful |= sign.is_none();
        }
        Ok(())
    }

    /// Takes the motors of a frame, and for each joint a linear map that acts on the points at rest
    /// before the motor: the scaling or stretching of the joint.
    ///
    /// # Errors
    /// As [`set`](Self::set), for both lists.
    pub fn set_stretched(
        &mut self,
        motors: &[Motor<S>],
        stretches: &[[[S; 3]; 3]],
    ) -> Result<(), BatchError> {
        same_length(self.motors.len() / 2, stretches.len())?;
        let is_finite = |rows: &[[S; 3]; 3]| rows.iter().flatten().all(|x| x.is_finite());
        if let Some(joint) = stretches.iter().position(|rows| !is_finite(rows)) {
            return Err(BatchError::BadMotion { joint });
        }
        self.set(motors)?;
        let zero = [S::zero(); 3];
        self.stretches.extend(
            stretches
                .iter()
                .map(|rows| Columns::new(Affine::new(*rows, zero))),
        );
        Ok(())
    }

    pub(super) fn fits(&self, chunk: &Chunk<S>) -> Result<(), BatchError> {
        same_length(2 * chunk.joints, self.motors.len())?;
        Ok(same_length(chunk.pairs, self.pairs.len())?)
    }
}

/// Whether a motor is finite and has norm 1 within √ε.
fn is_unit<S: Real<Mask = bool> + Default>(motor: Motor<S>) -> bool {
    let [s, a, b, c, x, y, z, volume] = Coefficients::new(motor).0;
    let square = s * s + a * a + b * b + c * c;
    let is_one = (square - S::one()).abs().less_than(S::epsilon().sqrt());
    is_one
        && [x, y, z, volume]
            .into_iter()
            .all(|number| number.is_finite())
}
