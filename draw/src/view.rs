//! Where a scene is looked at from.

use ga_runtime::vga3::Vector;

/// The way in which space is brought to the plane of the picture.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, serde::Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Projection {
    /// Along parallel rays: what is farther away is drawn as large.
    Orthographic,
    /// Towards an eye at four times the radius of the scene from its centre.
    #[default]
    Perspective,
}

/// The axis that points up in the picture.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, serde::Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Up {
    /// The y axis, as is usual in animation.
    Y,
    /// The z axis, as is usual in geometry.
    #[default]
    Z,
}

/// Where a scene is looked at from.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct View {
    /// By how many degrees the eye goes round the upward axis, counterclockwise as seen from above.
    /// At 0 it looks from the next axis after the upward one: from +x where z is up, from +z where
    /// y is.
    pub azimuth: f64,
    /// How many degrees the eye is above the horizontal plane, from −90 to 90.
    pub elevation: f64,
    /// How much larger than fits by itself the scene is drawn; 1 fits.
    pub zoom: f64,
    /// Parallel rays or an eye.
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
    /// The horizontal axes at 0 and 90 degrees, and the upward one.
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
