//! How a picture looks, apart from what is in it.

use crate::shade::{Light, Lighting};
use crate::{Appearance, RenderError};
use ga_image::colour::LinearColour;

/// Size, light and colours of a picture.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Style {
    /// Columns of the picture.
    pub width: u32,
    /// Rows of the picture.
    pub height: u32,
    /// Samples along each side of a pixel, 1 to 8.
    pub supersampling: u32,
    /// Whether surfaces are lit.
    pub shading: Shading,
    /// The colour of objects without a material.
    pub surface: LinearColour,
    /// The share of light that objects without a material reflect as a highlight at a right angle;
    /// their other numbers are those of [`Appearance::default`].
    pub gloss: f64,
    /// The lights.
    pub lighting: Lighting,
    /// The background at the top and at the bottom.
    pub background: [LinearColour; 2],
    /// The ground's colour.
    pub ground: LinearColour,
    /// The colour of the lines of the ground's grid.
    pub grid: LinearColour,
    /// How much of the ground's light the key light's shadow takes away, 0 to 1.
    pub shadow: f64,
    /// How much of the ground's light is taken away close under the mesh, 0 to 1.
    pub occlusion: f64,
    /// How much of the key light objects keep from each other and from themselves, 0 to 1. The
    /// shadow is found in a map of 2048 × 2048 depths seen from the light, and its edge is smoothed
    /// over three of them. Cut-outs cast the shadow of the whole triangle.
    pub self_shadow: f64,
    /// How much of the light from all around is kept away by what is near, 0 to 1: found in the
    /// depths of the picture, within 6 % of the diagonal of the objects' bounding box.
    pub ambient_occlusion: f64,
    /// How strongly surfaces are darkened beside nearer ones, so that crossing limbs can be
    /// distinguished: the share of light that is removed where a surface lies one diagonal of the
    /// mesh's bounding box behind its surroundings; 0 for none.
    pub depth_contrast: f64,
    /// The colour of bones.
    pub bone: LinearColour,
    /// The colour of the dots at their ends.
    pub joint: LinearColour,
    /// The width of bones, as a fraction of the picture's height.
    pub bone_width: f64,
}

/// Whether surfaces are lit.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Shading {
    /// By the lights, as their [`Appearance`] says.
    #[default]
    Lit,
    /// Each surface shows its base colour.
    Unlit,
}

impl Default for Style {
    /// A clay figure before a blue-grey background, 480 × 640.
    fn default() -> Self {
        Self {
            width: 480,
            height: 640,
            supersampling: 2,
            shading: Shading::Lit,
            surface: LinearColour::from_srgb([214, 203, 190]),
            gloss: 0.025,
            lighting: Lighting {
                key: Light {
                    direction: [-0.75, 1.0, 0.6],
                    colour: LinearColour::new(0.95, 0.90, 0.82),
                },
                fill: Light {
                    direction: [0.9, 0.15, 0.45],
                    colour: LinearColour::new(0.10, 0.13, 0.18),
                },
                sky: LinearColour::new(0.26, 0.29, 0.34),
                bounce: LinearColour::new(0.14, 0.12, 0.11),
            },
            background: [
                LinearColour::from_srgb([226, 231, 238]),
                LinearColour::from_srgb([178, 187, 199]),
            ],
            ground: LinearColour::from_srgb([205, 210, 217]),
            grid: LinearColour::from_srgb([174, 182, 193]),
            shadow: 0.42,
            occlusion: 0.35,
            self_shadow: 0.0,
            ambient_occlusion: 0.0,
            depth_contrast: 3.5,
            bone: LinearColour::from_srgb([28, 88, 160]),
            joint: LinearColour::from_srgb([250, 168, 40]),
            bone_width: 0.006,
        }
    }
}

impl Style {
    /// The style of models from files: objects keep light from each other and from themselves, and
    /// what is behind edges is as light as elsewhere.
    #[must_use]
    pub fn model() -> Self {
        Self {
            self_shadow: 0.8,
            ambient_occlusion: 0.7,
            depth_contrast: 0.0,
            ..Self::default()
        }
    }

    /// Width divided by height.
    pub fn aspect(&self) -> f64 {
        f64::from(self.width) / f64::from(self.height)
    }

    /// The material of objects without one.
    pub(crate) fn material(&self) -> Appearance<'static> {
        Appearance {
            base_colour: self.surface,
            reflectance: self.gloss.min(1.0),
            ..Appearance::default()
        }
    }

    pub(crate) fn check(&self) -> Result<(), RenderError> {
        if !(1..=8).contains(&self.supersampling) {
            return Err(RenderError::Style("its supersampling is not 1 to 8"));
        }
        check_size([self.width, self.height], self.supersampling)?;
        if !self.numbers().all(|n| n.is_finite() && n >= 0.0) {
            return Err(RenderError::Style(
                "a colour or strength is negative or not finite",
            ));
        }
        if self.lighting.key.direction[1] <= 0.0 {
            return Err(RenderError::Style("its key light is not above the horizon"));
        }
        Ok(())
    }

    fn numbers(&self) -> impl Iterator<Item = f64> {
        let lighting = &self.lighting;
        let colours = [
            self.surface,
            lighting.key.colour,
            lighting.fill.colour,
            lighting.sky,
            lighting.bounce,
            self.background[0],
            self.background[1],
            self.ground,
            self.grid,
            self.bone,
            self.joint,
        ];
        let strengths = [
            self.gloss,
            self.shadow,
            self.occlusion,
            self.self_shadow,
            self.ambient_occlusion,
            self.bone_width,
            self.depth_contrast,
        ];
        let channels = colours.into_iter().flat_map(LinearColour::channels);
        channels.chain(strengths)
    }
}

/// Checks the size of a picture with this many samples along each side of a pixel.
pub(crate) fn check_size([width, height]: [u32; 2], factor: u32) -> Result<(), RenderError> {
    const MOST_SAMPLES: u32 = 16_384;
    if width == 0 || height == 0 {
        return Err(RenderError::Style("its width or height is zero"));
    }
    if width.max(height).saturating_mul(factor) > MOST_SAMPLES {
        return Err(RenderError::Style(
            "it has more than 16384 samples along a side",
        ));
    }
    Ok(())
}
