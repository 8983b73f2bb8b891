//! How a picture looks, apart from what is in it.

use crate::RenderError;
use crate::shade::{Light, Lighting};
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
    /// The mesh's colour.
    pub surface: LinearColour,
    /// Strength of the mesh's highlights.
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

impl Default for Style {
    /// A clay figure before a blue-grey background, 480 × 640.
    fn default() -> Self {
        Self {
            width: 480,
            height: 640,
            supersampling: 2,
            surface: LinearColour::from_srgb([214, 203, 190]),
            gloss: 0.10,
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
            depth_contrast: 3.5,
            bone: LinearColour::from_srgb([28, 88, 160]),
            joint: LinearColour::from_srgb([250, 168, 40]),
            bone_width: 0.006,
        }
    }
}

impl Style {
    /// Width divided by height.
    pub fn aspect(&self) -> f64 {
        f64::from(self.width) / f64::from(self.height)
    }

    pub(crate) fn check(&self) -> Result<(), RenderError> {
        const MOST_SAMPLES: u32 = 16_384;
        if self.width == 0 || self.height == 0 {
            return Err(RenderError::Style("its width or height is zero"));
        }
        if !(1..=8).contains(&self.supersampling) {
            return Err(RenderError::Style("its supersampling is not 1 to 8"));
        }
        let across = self
            .width
            .max(self.height)
            .saturating_mul(self.supersampling);
        if across > MOST_SAMPLES {
            return Err(RenderError::Style(
                "it has more than 16384 samples along a side",
            ));
        }
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
            self.bone_width,
            self.depth_contrast,
        ];
        let channels = colours.into_iter().flat_map(LinearColour::channels);
        channels.chain(strengths)
    }
}
