//! The motions of the joints in a frame.

use ga_runtime::batch::skin::{AffinePalette, MotorPalette, Skin, SkinScalar};
use ga_runtime::cga3::Motor;
use ga_runtime::geometry::Affine;
use serde::Serialize;

use super::stretch::Stretched;
use crate::weights::error::SkinError;

/// How the motions of several joints are combined into that of a vertex.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Method {
    /// The weighted mean of the positions to which the joints would take the vertex.
    #[default]
    Linear,
    /// The weighted mean of the joints' motors, after that of their stretches.
    Motor,
    /// The weighted mean of the joints' motors alone: where joints scale, the scale is dropped.
    DualQuaternion,
}

/// The motions of all joints in a frame, prepared for one [`Method`]; made by
/// [`Binding::palette`](super::Binding::palette). Taking the motions of a further frame allocates
/// nothing.
#[derive(Clone, Debug)]
pub struct Palette<S> {
    joints: usize,
    pub(super) kind: Kind<S>,
    /// Room for the maps of a frame.
    maps: Vec<Affine<S>>,
}

#[derive(Clone, Debug)]
pub(super) enum Kind<S> {
    Affine(AffinePalette<S>),
    Motors {
        palette: MotorPalette<S>,
        /// Whether the joints scale the vertices.
        stretches: bool,
        motors: Vec<Motor<S>>,
        linear: Vec<[[S; 3]; 3]>,
    },
}

impl<S: SkinScalar> Palette<S> {
    pub(super) fn new(skin: &Skin<S>, method: Method) -> Self {
        let joints = skin.joints();
        let kind = match method {
            Method::Linear => Kind::Affine(AffinePalette::new(skin)),
            Method::Motor | Method::DualQuaternion => Kind::Motors {
                palette: MotorPalette::new(skin),
                stretches: method == Method::Motor,
                motors: Vec::with_capacity(joints),
                linear: Vec::with_capacity(joints),
            },
        };
        let maps = Vec::with_capacity(joints);
        Self { joints, kind, maps }
    }

    /// The number of joints.
    #[must_use]
    pub fn joint_count(&self) -> usize {
        self.joints
    }

    /// Takes the motions of a frame, which take the joints from rest to the pose (see
    /// [`Pose::motions`](crate::pose::Pose::motions)).
    ///
    /// # Errors
    ///
    /// [`SkinError::JointCount`] when there is not one for each joint, and
    /// [`SkinError::BadMotion`] for one that is not a unit motor. Then the palette is as before.
    pub fn set_motions(&mut self, motions: &[Motor<S>]) -> Result<(), SkinError> {
        self.check(motions.len())?;
        match &mut self.kind {
            Kind::Affine(palette) => {
                self.maps.clear();
                self.maps
                    .extend(motions.iter().map(|&motion| Affine::from(motion)));
                Ok(palette.set(&self.maps)?)
            }
            Kind::Motors { palette, .. } => Ok(palette.set(motions)?),
        }
    }

    /// Takes the matrices \[A | t\] of a frame by rows, x' = A x + t, with any scale and shear, as
    /// they come from a glTF file: the world matrix of a joint times its inverse bind matrix.
    ///
    /// A blend of motors takes the rotation from the polar decomposition A = R S; see
    /// [`Stretched`].
    ///
    /// # Errors
    ///
    /// As [`set_motions`](Self::set_motions), with [`SkinError::BadMotion`] for a matrix that is
    /// not finite.
    pub fn set_matrices(&mut self, matrices: &[[[S; 4]; 3]]) -> Result<(), SkinError> {
        self.check(matrices.len())?;
        // The list is moved out, so that the palette can be changed; it keeps its memory.
        let mut maps = std::mem::take(&mut self.maps);
        maps.clear();
        maps.extend(
            matrices.iter().map(|rows| {
                Affine::new(rows.map(|[x, y, z, _]| [x, y, z]), rows.map(|row| row[3]))
            }),
        );
        let result = self.set_maps(&maps);
        self.maps = maps;
        result
    }

    /// As [`set_matrices`](Self::set_matrices), with affine maps.
    ///
    /// # Errors
    ///
    /// As [`set_matrices`](Self::set_matrices).
    pub fn set_maps(&mut self, maps: &[Affine<S>]) -> Result<(), SkinError> {
        self.check(maps.len())?;
        match &mut self.kind {
            Kind::Affine(palette) => Ok(palette.set(maps)?),
            Kind::Motors {
                palette,
                stretches,
                motors,
                linear,
            } => {
                motors.clear();
                linear.clear();
                for (joint, map) in maps.iter().enumerate() {
                    let map = Stretched::from_affine(map).ok_or(SkinError::BadMotion { joint })?;
                    motors.push(map.motor);
                    linear.push(map.stretch);
                }
                if *stretches {
                    Ok(palette.set_stretched(motors, linear)?)
                } else {
                    Ok(palette.set(motors)?)
                }
            }
        }
    }

    /// Takes motors with stretches for a frame.
    ///
    /// # Errors
    ///
    /// As [`set_motions`](Self::set_motions).
    pub fn set_stretched(&mut self, joints: &[Stretched<S>]) -> Result<(), SkinError> {
        self.check(joints.len())?;
        match &mut self.kind {
            Kind::Affine(palette) => {
                self.maps.clear();
                self.maps.extend(joints.iter().map(Stretched::affine));
                Ok(palette.set(&self.maps)?)
            }
            Kind::Motors {
                palette,
                stretches,
                motors,
                linear,
            } => {
                motors.clear();
                motors.extend(joints.iter().map(|joint| joint.motor));
                if *stretches {
                    linear.clear();
                    linear.extend(joints.iter().map(|joint| joint.stretch));
                    Ok(palette.set_stretched(motors, linear)?)
                } else {
                    Ok(palette.set(motors)?)
                }
            }
        }
    }

    fn check(&self, found: usize) -> Result<(), SkinError> {
        let expected = self.joints;
        if expected == found {
            Ok(())
        } else {
            Err(SkinError::JointCount { expected, found })
        }
    }
}
