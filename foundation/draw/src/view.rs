//! The direction from which a scene is seen.

use ga_runtime::vga3::Vector;

/// The projection from space to the plane of the picture.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, serde::Deserialize)]
#[serde(
    rename_all = "lowercase",
    expecting = "\"orthographic\" or \"perspective\""
)]
pub enum Projection {
    /// Along parallel rays: distance does not change the size.
    Orthographic,
    /// Towards an eye whose distance from the centre of the scene is four times the scene's radius.
    #[default]
    Perspective,
}

/// The axis that points up in the picture.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, serde::Deserialize)]
#[serde(rename_all = "lowercase", expecting = "\"y\" or \"z\"")]
pub enum Up {
    /// The y axis, as is usual in animation.
    Y,
    /// The z axis, as is usual in geometry.
    #[default]
    Z,
}

/// The direction from which a scene is seen, and the projection.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct View {
    /// The angle of the eye about the upward axis in degrees, counterclockwise as seen from above.
    /// At 0 the eye is on the axis that cyclically follows the upward one: on +x where z is up, on
    /// +z where y is up.
    pub azimuth: f64,
    /// The angle of the eye above the horizontal plane in degrees, from −90 to 90.
    pub elevation: f64,
    /// The factor by which the scene is enlarged; at 1 it fills the picture.
    pub zoom: f64,
    /// Along parallel rays or towards an eye.
    pub projection: Projection,
    /// The axis that points up.
    pub up: Up,
}

impl Default for View {
    fn default() -> Self {
        Self {
            azimuth: 35.0,
            elevation: 22.0,
            zoom: 1.0,
            projection: Projection::default(),
            up: Up::default(),
        }
    }
}

impl Up {
    /// The horizontal axes at azimuth 0 and 90 degrees, and the upward axis.
    pub(crate) fn axes(self) -> [Vector<f64>; 3] {
        let x = Vector::new(1.0, 0.0, 0.0);
        let y = Vector::new(0.0, 1.0, 0.0);
        let z = Vector::new(0.0, 0.0, 1.0);
        match self {
            Self::Y => [z, x, y],
            Self::Z => [x, y, z],
        }
    }
}
