//! The colour of a lit surface.

use crate::Vector;
use ga_image::colour::LinearColour;

/// A distant light.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Light {
    /// Direction towards the light, of any length, as *right*, *world up* and *towards the viewer*:
    /// lights stand around the camera as in a studio, but stay level when it looks up or down.
    pub direction: [f64; 3],
    /// Linear colour times strength.
    pub colour: LinearColour,
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
    pub sky: LinearColour,
    /// What a surface that faces straight down receives from all around.
    pub bounce: LinearColour,
}

/// The lights with their directions in the world.
pub(crate) struct WorldLighting {
    key: (Vector, LinearColour),
    fill: (Vector, LinearColour),
    sky: LinearColour,
    bounce: LinearColour,
    gloss: f64,
}

/// How closely a highlight keeps to the mirror direction (Blinn and Phong's exponent).
const SHARPNESS: i32 = 28;

impl WorldLighting {
    /// `None` when a light has no direction.
    pub(crate) fn new(
        lighting: &Lighting,
        gloss: f64,
        forward: Vector,
        right: Vector,
    ) -> Option<Self> {
        let backward = Vector::new(-forward.e1, 0.0, -forward.e3)
            .normalized()
            .or_else(|| Vector::new(-right.e3, 0.0, right.e1).normalized())?;
        let across = Vector::new(backward.e3, 0.0, -backward.e1);
        let world = |light: &Light| {
            let direction = Vector::from(light.direction).normalized()?;
            let level = across * direction.e1 + backward * direction.e3;
            Some((level + Vector::new(0.0, direction.e2, 0.0), light.colour))
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
    pub(crate) fn towards_key(&self) -> Vector {
        self.key.0
    }

    /// The light that a surface of the given colour and unit normal sends in the unit direction
    /// `towards_viewer`.
    pub(crate) fn shade(
        &self,
        surface: LinearColour,
        normal: Vector,
        towards_viewer: Vector,
    ) -> LinearColour {
        let mut diffuse = self.bounce.lerp(self.sky, 0.5 + 0.5 * normal.e2);
        let mut highlight = LinearColour::BLACK;
        for (direction, colour) in [self.key, self.fill] {
            let facing = normal.dot(direction).max(0.0);
            diffuse += colour * facing;
            if let Some(half) = (direction + towards_viewer).normalized() {
                let closeness = normal.dot(half).max(0.0).powi(SHARPNESS);
                highlight += colour * (self.gloss * closeness * facing.sqrt());
            }
        }
        surface * diffuse + highlight
    }
}
