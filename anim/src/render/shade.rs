//! The colour of a lit surface.

use super::color::LinearColor;
use super::vector::{Vector, add, add_scaled, dot, multiply, normalized, scale};

/// A distant light.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Light {
    /// Direction towards the light, of any length, as *right*, *world up* and *towards the viewer*:
    /// lights stand around the camera as in a studio, but stay level when it looks up or down.
    pub direction: [f64; 3],
    /// Linear colour times strength.
    pub color: LinearColor,
}

/// A key light that models the form, a weaker fill light that opens its shadows, and light from all
/// around.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Lighting {
    /// The main light; it casts the shadow on the ground.
    pub key: Light,
    /// The second light.
    pub fill: Light,
    /// What a surface that faces straight up receives from all around.
    pub sky: LinearColor,
    /// What a surface that faces straight down receives from all around.
    pub bounce: LinearColor,
}

/// The lights with their directions in the world.
pub(super) struct WorldLighting {
    key: (Vector, LinearColor),
    fill: (Vector, LinearColor),
    sky: LinearColor,
    bounce: LinearColor,
    gloss: f64,
}

/// How closely a highlight keeps to the mirror direction (Blinn and Phong's exponent).
const SHARPNESS: i32 = 28;

impl WorldLighting {
    /// `None` when a light has no direction.
    pub(super) fn new(
        lighting: &Lighting,
        gloss: f64,
        forward: Vector,
        right: Vector,
    ) -> Option<Self> {
        let backward = normalized([-forward[0], 0.0, -forward[2]])
            .or_else(|| normalized([-right[2], 0.0, right[0]]))?;
        let across = [backward[2], 0.0, -backward[0]];
        let world = |light: &Light| {
            let [right, up, towards] = normalized(light.direction)?;
            let level = add_scaled(scale(across, right), backward, towards);
            Some((add(level, [0.0, up, 0.0]), light.color))
        };
        Some(Self {
            key: world(&lighting.key)?,
            fill: world(&lighting.fill)?,
            sky: lighting.sky,
            bounce: lighting.bounce,
            gloss,
        })
    }

    /// The unit direction towards the key light.
    pub(super) fn towards_key(&self) -> Vector {
        self.key.0
    }

    /// The light that a surface of the given colour and unit normal sends in the unit direction
    /// `towards_viewer`.
    pub(super) fn shade(
        &self,
        surface: LinearColor,
        normal: Vector,
        towards_viewer: Vector,
    ) -> LinearColor {
        let from_above = 0.5 + 0.5 * normal[1];
        let mut diffuse = add_scaled(scale(self.bounce, 1.0 - from_above), self.sky, from_above);
        let mut highlight = [0.0; 3];
        for (direction, color) in [self.key, self.fill] {
            let facing = dot(normal, direction).max(0.0);
            diffuse = add_scaled(diffuse, color, facing);
            if let Some(half) = normalized(add(direction, towards_viewer)) {
                let closeness = dot(normal, half).max(0.0).powi(SHARPNESS);
                highlight = add_scaled(highlight, color, self.gloss * closeness * facing.sqrt());
            }
        }
        add(multiply(surface, diffuse), highlight)
    }
}
