//! From transforms relative to the parents to model space.

use ga_runtime::cga3::Motor;
use ga_runtime::geometry::Affine;
use ga_runtime::scalar::Real;

use crate::kinematics::KinematicsError;
use crate::transform::Transform;

/// The affine map of each joint's frame to model space: A = A_parent A_local.
///
/// # Errors
///
/// [`KinematicsError::SliceLength`] and [`KinematicsError::ParentNotBefore`]; then nothing is
/// written.
///
/// # Examples
///
/// ```
/// use ga_anim::recording::model_maps;
/// use ga_anim::transform::Transform;
/// use ga_runtime::cga3::Rotor;
/// use ga_runtime::geometry::Affine;
/// use ga_runtime::vga3::Vector;
///
/// let along = Vector::new(1.0, 0.0, 0.0);
/// let locals = [
///     Transform::from_parts(along, Rotor::default(), Vector::new(2.0, 1.0, 1.0)),
///     Transform::from_parts(along, Rotor::default(), Vector::new(1.0, 1.0, 1.0)),
/// ];
/// let mut maps = [Affine::from_translation([0.0; 3]); 2];
/// model_maps(&[None, Some(0)], &locals, &mut maps)?;
/// assert_eq!(maps[1].translation, [3.0, 0.0, 0.0]);
/// # Ok::<(), ga_anim::kinematics::KinematicsError>(())
/// ```
pub fn model_maps<S: Real>(
    parents: &[Option<usize>],
    locals: &[Transform<S>],
    maps: &mut [Affine<S>],
) -> Result<(), KinematicsError> {
    check(parents, locals.len(), maps.len())?;
    for (joint, (parent, local)) in parents.iter().zip(locals).enumerate() {
        let local = local.to_affine();
        maps[joint] = parent.map_or(local, |parent| maps[parent] * local);
    }
    Ok(())
}

/// The motor of each joint's frame in model space, M = M_parent M_local, where no joint is scaled.
///
/// # Errors
///
/// [`KinematicsError::SliceLength`], [`KinematicsError::ParentNotBefore`] and
/// [`KinematicsError::Scaled`]; then nothing is written.
pub fn model_motors<S: Real<Mask = bool>>(
    parents: &[Option<usize>],
    locals: &[Transform<S>],
    motors: &mut [Motor<S>],
) -> Result<(), KinematicsError> {
    check(parents, locals.len(), motors.len())?;
    if let Some(joint) = locals.iter().position(|local| !local.is_rigid()) {
        return Err(KinematicsError::Scaled { joint });
    }
    for (joint, (parent, local)) in parents.iter().zip(locals).enumerate() {
        motors[joint] = parent.map_or(local.motor, |parent| motors[parent] * local.motor);
    }
    Ok(())
}

fn check(parents: &[Option<usize>], locals: usize, results: usize) -> Result<(), KinematicsError> {
    let expected = parents.len();
    for found in [locals, results] {
        if found != expected {
            return Err(KinematicsError::SliceLength { expected, found });
        }
    }
    for (joint, parent) in parents.iter().enumerate() {
        if let Some(parent) = parent.filter(|&parent| parent >= joint) {
            return Err(KinematicsError::ParentNotBefore { joint, parent });
        }
    }
    Ok(())
}
