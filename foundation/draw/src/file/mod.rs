//! Scenes from JSON.

mod build;
mod element;
mod error;
mod format;
mod made;
mod relation;
mod trajectory;

pub use error::{ElementProblem, SceneError};

use crate::scene::Scene;

impl Scene {
    /// Reads a scene from the bytes of a JSON text; the [documentation of the
    /// crate](crate#scenes-in-json) describes the format.
    ///
    /// # Errors
    ///
    /// [`SceneError`], which names the line and column, or the element and the value.
    ///
    /// ```
    /// use ga_draw::Scene;
    /// let scene = Scene::decode(br#"{"elements": [
    ///     {"name": "S", "sphere": {"centre": [0, 0, 0], "radius": 1}},
    ///     {"name": "l", "line": {"through": [[-2, 0, 0], [2, 0, 0]]}},
    ///     {"meet": ["S", "l"]}
    /// ]}"#)?;
    /// assert_eq!(scene.shapes().nth(2).unwrap().kind(), "point pair");
    /// # Ok::<(), ga_draw::SceneError>(())
    /// ```
    pub fn decode(bytes: &[u8]) -> Result<Self, SceneError> {
        build::scene(serde_json::from_slice(bytes)?)
    }
}
