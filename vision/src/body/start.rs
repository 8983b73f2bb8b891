//! Where a fit begins: each point by itself from the views that see it.

use ga_anim::inverse_kinematics::Target;
use ga_runtime::cga3::Point;

use super::{BodyError, BodyModel, Observation};
use crate::camera::Camera;
use crate::triangulation::{TriangulationError, triangulate_views};

/// The points that two views or more determine, with weights by their precision; weight 0 for all
/// others.
///
/// # Errors
/// [`BodyError::Behind`] where most points are behind a camera that sees them.
pub(super) fn triangulated(
    model: &BodyModel,
    cameras: &[Camera],
    observation: &Observation,
) -> Result<Vec<Target>, BodyError> {
    let (mut in_front, mut behind) = (0, 0);
    let mut first_behind = None;
    let mut targets = Vec::with_capacity(model.points().len());
    for (index, point) in model.points().iter().enumerate() {
        let seen = cameras.iter().zip(&observation.views).enumerate();
        let seen =
            seen.filter_map(|(view, (camera, pixels))| Some((view, *camera, pixels[index]?)));
        let (mut views, mut cameras, mut pixels) = (Vec::new(), Vec::new(), Vec::new());
        for (view, camera, pixel) in seen {
            views.push(view);
            cameras.push(camera);
            pixels.push(pixel.position);
        }
        let mut target = Target {
            position: Point::default(),
            weight: 0.0,
        };
        match triangulate_views(&cameras, &pixels) {
            Ok(found) => {
                in_front += 1;
                let variance: f64 = (0..3).map(|k| found.covariance[k][k]).sum();
                target.position = found.position;
                // A pixel that is wrong by far leaves a large error beside the others.
                target.weight = 1.0 / (variance * (1.0 + found.error_px * found.error_px));
            }
            Err(TriangulationError::Behind { view, depth }) => {
                behind += 1;
                first_behind.get_or_insert(BodyError::Behind {
                    view: views[view],
                    point: point.name.clone(),
                    depth,
                });
            }
            Err(_) => {}
        }
        targets.push(target);
    }
    match first_behind {
        Some(error) if behind > in_front => Err(error),
        _ => Ok(targets),
    }
}
