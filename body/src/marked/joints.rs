//! Where the joints of a fitted body are in the pictures, and how exactly that is known.

use ga_camera::Camera;
use ga_runtime::vga3::Vector;
use nalgebra_035::{Cholesky, DMatrix, DVector};

use super::{MarkedBody, MarkedFit};
use crate::normal::Normal;
use crate::{BodyError, BodyFit, JointPixel};

impl MarkedBody {
    /// For each view and each joint of the skeleton the pixel of its head in a fitted pose, with
    /// its standard deviation. `None` where the camera does not see that place, and in all views
    /// where no dot is recognised on the bone of the joint nor on that of the joint above it: both
    /// end there.
    ///
    /// With the normal equations N of the fit, the unknowns θ of the pose have the covariance N⁻¹
    /// to first order, and a pixel u of the place x of a joint has
    ///
    /// ```text
    /// C = D N⁻¹ Dᵀ,   D = ∂u/∂x ∂x/∂θ,   σ² = ½ tr C
    /// ```
    ///
    /// Errors of one joint in several views are those of one pose, and are not independent.
    ///
    /// # Errors
    /// [`BodyError::NoViews`] without a camera, [`BodyError::Views`] for another number of cameras
    /// than the fit has, and [`BodyError::NoPose`] where they do not see the points of the fit.
    pub fn joints(
        &self,
        cameras: &[Camera],
        found: &MarkedFit,
    ) -> Result<Vec<Vec<Option<JointPixel>>>, BodyError> {
        let fit = BodyFit::new(&self.model, cameras)?;
        fit.check(&found.observation)?;
        let likelihood = fit.likelihood();
        let chain = &likelihood.chain;
        let state = chain.state_of(&found.fitted.pose);
        let normal = &mut fit.normal();
        let equations = likelihood.linearise(&state, &found.observation, normal);
        let covariance = equations.and_then(|()| covariance(normal));
        let covariance = covariance.ok_or(BodyError::NoPose)?;
        let places = chain.places(&state);
        let heads = chain.heads(&state);
        let joints = self.model.skeleton().joints();
        let mut is_recognised = vec![false; joints.len()];
        for view in &found.observation.views {
            for (dot, joint) in view.iter().zip(&self.strongest) {
                is_recognised[*joint] |= dot.is_some();
            }
        }
        let is_known = |joint: &usize| {
            let above = joints[*joint].parent;
            is_recognised[*joint] || above.is_some_and(|above| is_recognised[above])
        };
        let mut views = vec![vec![None; joints.len()]; cameras.len()];
        for joint in (0..joints.len()).filter(is_known) {
            let by_unknowns = chain.derivatives_of_head(&places, joint);
            for (camera, view) in cameras.iter().zip(&mut views) {
                let Ok(seen) = camera.project_with_derivatives(heads[joint].into()) else {
                    continue;
                };
                let variance = seen.by_point.map(|row| {
                    let mut by_unknown = DVector::zeros(chain.count);
                    for (unknown, way) in &by_unknowns {
                        by_unknown[*unknown] = Vector::from(row).dot(*way);
                    }
                    by_unknown.dot(&(&covariance * &by_unknown))
                });
                let deviation = (0.5 * (variance[0] + variance[1])).sqrt();
                view[joint] = Some(JointPixel {
                    position: seen.pixel,
                    deviation,
                })
                .filter(|pixel| pixel.deviation > 0.0 && pixel.deviation.is_finite());
            }
        }
        Ok(views)
    }
}

/// The covariance of the unknowns; `None` where the equations are singular.
fn covariance(normal: &Normal) -> Option<DMatrix<f64>> {
    let mut matrix = normal.matrix.clone();
    for k in 0..matrix.nrows() {
        // What neither dots nor rest show moves no dot, and stays as it is.
        if matrix[(k, k)] <= 0.0 {
            matrix[(k, k)] = 1.0;
        }
    }
    Some(Cholesky::new(matrix)?.inverse())
}
