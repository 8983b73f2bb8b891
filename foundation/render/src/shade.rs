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
}

/// A place of a surface, as far as its reflection depends on it; see
/// [`Appearance`](crate::Appearance).
pub(crate) struct Surface {
    pub(crate) base_colour: LinearColour,
    pub(crate) metallic: f64,
    pub(crate) roughness: f64,
    pub(crate) reflectance: f64,
    /// A unit vector.
    pub(crate) normal: Vector,
}

/// The shares of the lights that reach a place, 0 to 1.
#[derive(Clone, Copy)]
pub(crate) struct Reaching {
    pub(crate) key: f64,
    pub(crate) all_around: f64,
}

/// The least α: highlights of distant lights are still as wide as a few pixels.
const LEAST_ALPHA: f64 = 0.002;

impl WorldLighting {
    /// `None` when a light has no direction.
    pub(crate) fn new(lighting: &Lighting, forward: Vector, right: Vector) -> Option<Self> {
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
        })
    }

    /// The unit direction towards the key light.
    pub(crate) fn towards_key(&self) -> Vector {
        self.key.0
    }

    /// The light that a surface sends in the unit direction `towards_viewer`.
    pub(crate) fn shade(
        &self,
        surface: &Surface,
        towards_viewer: Vector,
        reaching: Reaching,
    ) -> LinearColour {
        let reflection = Reflection::new(surface, towards_viewer);
        let key = reflection.of(self.key.0) * self.key.1 * reaching.key;
        let fill = reflection.of(self.fill.0) * self.fill.1;
        let mirrored = surface.normal * (2.0 * surface.normal.dot(towards_viewer)) - towards_viewer;
        let around = reflection.diffuse * self.all_around(surface.normal)
            + reflection.of_surroundings() * self.all_around(mirrored);
        key + fill + around * reaching.all_around
    }

    /// The light that arrives from the surroundings of a unit direction.
    fn all_around(&self, direction: Vector) -> LinearColour {
        let height = (0.5 + 0.5 * direction.e2).clamp(0.0, 1.0);
        self.bounce.lerp(self.sky, height)
    }
}

/// What is the same for all lights in the reflection of a surface towards a viewer.
struct Reflection<'a> {
    surface: &'a Surface,
    towards_viewer: Vector,
    diffuse: LinearColour,
    /// F₀ and F₉₀.
    fresnel: [LinearColour; 2],
    alpha_squared: f64,
    /// n·v.
    facing: f64,
}

impl<'a> Reflection<'a> {
    fn new(surface: &'a Surface, towards_viewer: Vector) -> Self {
        let alpha = (surface.roughness * surface.roughness).max(LEAST_ALPHA);
        let dielectric = LinearColour::WHITE * surface.reflectance;
        let straight = dielectric.lerp(surface.base_colour, surface.metallic);
        let grazing = LinearColour::from(straight.channels().map(|f| (25.0 * f).min(1.0)));
        Self {
            surface,
            towards_viewer,
            diffuse: surface.base_colour * (1.0 - surface.metallic),
            fresnel: [straight, grazing],
            alpha_squared: alpha * alpha,
            // A normal between two corners may lean away from the viewer.
            facing: surface.normal.dot(towards_viewer).max(1e-4),
        }
    }

    /// The share of the light from a unit direction that is reflected towards the viewer.
    fn of(&self, direction: Vector) -> LinearColour {
        let lit = self.surface.normal.dot(direction);
        if lit <= 0.0 {
            return LinearColour::BLACK;
        }
        let Some(half) = (direction + self.towards_viewer).normalized() else {
            return self.diffuse * lit;
        };
        let a = self.alpha_squared;
        let closeness = self.surface.normal.dot(half).clamp(0.0, 1.0);
        let spread = closeness * closeness * (a - 1.0) + 1.0;
        // π D.
        let distribution = a / (spread * spread);
        let reach = |one: f64, other: f64| one * (other * other * (1.0 - a) + a).sqrt();
        let visibility = 0.5 / (reach(lit, self.facing) + reach(self.facing, lit));
        let fresnel = self.fresnel_at(self.towards_viewer.dot(half), 1.0);
        (self.diffuse + fresnel * (distribution * visibility)) * lit
    }

    /// The share of the light from all around that is reflected as in a mirror.
    fn of_surroundings(&self) -> LinearColour {
        self.fresnel_at(self.facing, 1.0 - self.surface.roughness)
    }

    /// F, with F₉₀ scaled by a factor.
    fn fresnel_at(&self, cosine: f64, grazing: f64) -> LinearColour {
        let part = (1.0 - cosine).clamp(0.0, 1.0).powi(5);
        let [straight, most] = self.fresnel.map(LinearColour::channels);
        let channel = |i: usize| {
            let most = (most[i] * grazing).max(straight[i]);
            straight[i] + (most - straight[i]) * part
        };
        LinearColour::new(channel(0), channel(1), channel(2))
    }
}
