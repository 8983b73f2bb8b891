//! Where captured points are on a mesh.

use ga_runtime::cga3::{Motor, Point, Similarity};
use ga_runtime::geometry::FitError;

use crate::capture::table::Key;

/// The motion that takes points at rest to their places on a mesh; by default none.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct KeyFit {
    /// From the points, in metres, to the mesh, in its unit.
    pub to_mesh: Similarity<f64>,
    /// The root mean square distance between the keys on the mesh and the points at rest, in the
    /// unit of the mesh.
    pub root_mean_square: f64,
}

impl KeyFit {
    /// The motion that fits best, of any scale or of scale 1.
    ///
    /// # Errors
    /// [`FitError`] where the keys determine none.
    ///
    /// # Panics
    /// Where the point of a key does not exist.
    ///
    /// ```
    /// use ga_runtime::cga3::Point;
    /// use ga_vision::capture::KeyFit;
    /// use ga_vision::capture::table::Key;
    ///
    /// // A mesh in millimetres.
    /// let rest = [[0.0, 0.0, 0.0], [0.1, 0.0, 0.0], [0.0, 0.1, 0.0]].map(Point::from);
    /// let places = [[0.0, 0.0, 0.0], [100.0, 0.0, 0.0], [0.0, 100.0, 0.0]].map(Point::from);
    /// let keys: Vec<Key> = (0..).zip(places).map(|(point, place)| Key { point, place }).collect();
    /// let fit = KeyFit::new(&keys, &rest, true)?;
    /// assert!((fit.to_mesh.factor() - 1000.0).abs() < 1e-9 && fit.root_mean_square < 1e-12);
    /// # Ok::<(), ga_runtime::geometry::FitError<f64>>(())
    /// ```
    pub fn new(keys: &[Key], rest: &[Point<f64>], any_scale: bool) -> Result<Self, FitError<f64>> {
        let pairs = keys.iter().map(|key| (rest[key.point], key.place));
        let pairs: Vec<_> = pairs.collect();
        Ok(if any_scale {
            let fit = Similarity::from_point_pairs(&pairs)?;
            Self {
                to_mesh: fit.motion,
                root_mean_square: fit.residual(&pairs),
            }
        } else {
            let fit = Motor::from_point_pairs(&pairs)?;
            Self {
                to_mesh: fit.motion.into(),
                root_mean_square: fit.residual(&pairs),
            }
        })
    }
}
