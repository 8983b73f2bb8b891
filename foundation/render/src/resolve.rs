//! From samples to pixels: shading, ground and background, averaged in linear light.

use ga_image::colour::LinearColour;
use ga_image::plane::Plane;
use rayon::prelude::*;

use crate::depth::DepthMap;
use crate::fragment::Fragment;
use crate::ground_shading::{GroundShading, background};
use crate::layers::{Layer, Layers};
use crate::shade::{Reaching, WorldLighting};
use crate::shadow::{Caster, GroundShadow};
use crate::shadow_map::ShadowMap;
use crate::surface::{NO_TRIANGLE, Samples};
use crate::view::View;
use crate::world::World;
use crate::{Appearance, Ground, RenderError, Shading, Style, Vector, occlusion};

/// Tangents of the half angles of the key light and of the part of the sky that counts for the
/// contact shadow.
pub(crate) const KEY_TANGENT: f64 = 0.06;
const SKY_TANGENT: f64 = 0.9;

/// The greatest number of samples along a side of a pixel.
const MOST: usize = 8;

/// The linear light of each pixel, row by row, and the depths.
pub(crate) fn resolve(
    world: &World,
    ground: Option<Ground>,
    view: &View,
    style: &Style,
    samples: &Samples,
    layers: &Layers,
) -> Result<(Vec<LinearColour>, DepthMap), RenderError> {
    let lighting = WorldLighting::new(&style.lighting, view.forward().into(), view.right().into())
        .ok_or(RenderError::Style("a light has no direction"))?;
    let lit = style.shading == Shading::Lit;
    let factor = style.supersampling as usize;
    let resolver = Resolver {
        world,
        view,
        style,
        samples,
        layers,
        plain: style.material(),
        ground: ground.map(|ground| ground_shading(world, ground, view, style, &lighting)),
        shadows: (lit && style.self_shadow > 0.0)
            .then(|| ShadowMap::new(world, lighting.towards_key()))
            .flatten(),
        all_around: (lit && style.ambient_occlusion > 0.0)
            .then(|| occlusion::reaching(world, samples, factor)),
        lighting,
    };

    let (width, height) = (style.width as usize, style.height as usize);
    // Pixels do not depend on each other, so that any number of threads gives the same.
    let pixels: Vec<Pixel> = (0..width * height)
        .into_par_iter()
        .map(|index| resolver.pixel(index % width, index / width))
        .collect();
    let mut light = Vec::with_capacity(pixels.len());
    let mut depth = DepthMap::empty(style.width, style.height);
    for (index, pixel) in pixels.into_iter().enumerate() {
        light.push(pixel.light);
        depth.set(index, pixel.depth, pixel.coverage);
    }
    Ok((light, depth))
}

struct Resolver<'a> {
    world: &'a World<'a>,
    view: &'a View,
    style: &'a Style,
    samples: &'a Samples,
    layers: &'a Layers,
    lighting: WorldLighting,
    /// The material of objects without one.
    plain: Appearance<'static>,
    ground: Option<GroundShading<'a>>,
    shadows: Option<ShadowMap>,
    /// The share of light from all around that reaches each pixel.
    all_around: Option<Plane>,
}

struct Pixel {
    light: LinearColour,
    depth: f32,
    coverage: f32,
}

impl Resolver<'_> {
    /// A pixel's light. Each triangle in it is shaded once, at the middle of its samples.
    fn pixel(&self, column: usize, row: usize) -> Pixel {
        let n = self.style.supersampling as usize;
        let index = row * self.style.width as usize + column;
        let mut seen = [NO_TRIANGLE; MOST * MOST];
        let mut nearest = 0f32;
        for (sample, seen) in seen.iter_mut().enumerate().take(n * n) {
            let (x, y) = (column * n + sample % n, row * n + sample / n);
            let index = y * self.samples.width + x;
            let inverse = self.samples.inverse_depth[index];
            if inverse > 0.0 && !self.is_below_ground(x, y, inverse) {
                *seen = self.samples.triangle[index];
                nearest = nearest.max(inverse);
            }
        }

        let per_sample = 1.0 / (n * n) as f64;
        let coverage = seen.iter().filter(|&&t| t != NO_TRIANGLE).count() as f64 * per_sample;
        let surroundings = if coverage < 1.0 {
            self.surroundings(column, row)
        } else {
            LinearColour::BLACK
        };
        let layers = self.layers.of(index);
        let mut lights = [surroundings; MOST * MOST];
        let mut light = LinearColour::BLACK;
        for first in 0..n * n {
            let triangle = seen[first];
            if triangle == NO_TRIANGLE {
                continue;
            }
            let members = (first..n * n).filter(|&sample| seen[sample] == triangle);
            let (colour, _) = self.surface(triangle, self.middle(members, column, row), index);
            for sample in first..n * n {
                if seen[sample] == triangle {
                    seen[sample] = NO_TRIANGLE;
                    lights[sample] = colour;
                    light += colour;
                }
            }
        }
        light = light * per_sample + surroundings * (1.0 - coverage);
        if !layers.is_empty() {
            light = self.behind_layers(layers, &mut lights[..n * n], column, row);
        }
        Pixel {
            light,
            depth: 1.0 / nearest,
            coverage: coverage as f32,
        }
    }

    /// The ray of the camera's frame through the middle of some samples of a pixel.
    fn middle(&self, samples: impl Iterator<Item = usize>, column: usize, row: usize) -> Vector {
        let n = self.style.supersampling as usize;
        let (mut count, mut across, mut down) = (0.0, 0.0, 0.0);
        for sample in samples {
            count += 1.0;
            across += (sample % n) as f64;
            down += (sample / n) as f64;
        }
        let x = (column * n) as f64 + across / count + 0.5;
        let y = (row * n) as f64 + down / count + 0.5;
        self.samples.lens.ray(x, y)
    }

    /// A pixel's light behind its transparent layers, of which each triangle is shaded once.
    /// `lights` is the light that comes from behind all layers at each sample.
    fn behind_layers(
        &self,
        layers: &[Layer],
        lights: &mut [LinearColour],
        column: usize,
        row: usize,
    ) -> LinearColour {
        let n = self.style.supersampling as usize;
        let index = row * self.style.width as usize + column;
        let mut by_triangle: Vec<[u32; 2]> = layers
            .iter()
            .map(|layer| [layer.triangle, layer.sample])
            .collect();
        by_triangle.sort_unstable();
        let shaded: Vec<(u32, LinearColour, f64)> = by_triangle
            .chunk_by(|a, b| a[0] == b[0])
            .map(|group| {
                let samples = group.iter().map(|&[_, sample]| sample as usize);
                let ray = self.middle(samples, column, row);
                let (colour, opacity) = self.surface(group[0][0], ray, index);
                (group[0][0], colour, opacity)
            })
            .collect();
        for layer in layers {
            let sample = layer.sample as usize;
            let (x, y) = (column * n + sample % n, row * n + sample / n);
            let place = shaded.partition_point(|&(triangle, ..)| triangle < layer.triangle);
            let (_, colour, opacity) = shaded[place];
            if !self.is_below_ground(x, y, layer.inverse_depth) {
                lights[sample] = lights[sample].lerp(colour, opacity);
            }
        }
        let sum = lights
            .iter()
            .fold(LinearColour::BLACK, |sum, &light| sum + light);
        sum * (1.0 / lights.len() as f64)
    }

    fn is_below_ground(&self, x: usize, y: usize, inverse_depth: f32) -> bool {
        self.ground.as_ref().is_some_and(|shading| {
            let ray = self.samples.lens.ray(x as f64 + 0.5, y as f64 + 0.5);
            shading.ground.depth(self.view, ray) < 1.0 / f64::from(inverse_depth)
        })
    }

    /// A triangle's light towards the eye along a ray of the camera's frame, and its opacity.
    fn surface(&self, triangle: u32, ray: Vector, pixel: usize) -> (LinearColour, f64) {
        let face = self.world.face(triangle);
        let material = self.world.material(&face).unwrap_or(&self.plain);
        let n = f64::from(self.style.supersampling);
        let Some(fragment) = Fragment::new(face, ray, self.view, &self.samples.lens, n) else {
            return (material.base_colour, material.opacity);
        };
        let look = fragment.look(material);
        if look.unlit || self.style.shading == Shading::Unlit {
            return (look.surface.base_colour, look.opacity);
        }
        let key = self.shadows.as_ref().map_or(1.0, |shadows| {
            let visibility = shadows.visibility(fragment.point, fragment.flat);
            1.0 - self.style.self_shadow * (1.0 - visibility)
        });
        let all_around = self.all_around.as_ref().map_or(1.0, |plane| {
            1.0 - self.style.ambient_occlusion * (1.0 - f64::from(plane.values()[pixel]))
        });
        let reaching = Reaching {
            key: key.max(0.0),
            all_around: all_around.max(0.0) * look.occlusion,
        };
        let reflected = self
            .lighting
            .shade(&look.surface, fragment.towards_viewer, reaching);
        (reflected + look.emission, look.opacity)
    }

    /// What is seen beside the mesh, at the middle of a pixel.
    fn surroundings(&self, column: usize, row: usize) -> LinearColour {
        let n = f64::from(self.style.supersampling);
        let (x, y) = ((column as f64 + 0.5) * n, (row as f64 + 0.5) * n);
        let behind = background(
            self.style,
            (row as f64 + 0.5) / f64::from(self.style.height),
        );
        let Some(shading) = &self.ground else {
            return behind;
        };
        let ray = self.samples.lens.ray(x, y);
        let depth = shading.ground.depth(self.view, ray);
        if depth.is_infinite() {
            return behind;
        }
        let direction = self.view.world_direction(ray);
        let point = Vector::from(self.view.eye()) + direction * depth;
        // A pixel's patch of ground is longer than wide by one over the sine of the ray's slope.
        let sine = direction.e2.abs() / direction.length();
        let pixel = depth * n / self.samples.lens.magnification();
        shading.colour(point, pixel / sine.sqrt(), behind)
    }
}

fn ground_shading<'a>(
    world: &World,
    ground: Ground,
    view: &View,
    style: &'a Style,
    lighting: &WorldLighting,
) -> GroundShading<'a> {
    let objects = world.objects.iter();
    let casters: Vec<Caster> = objects.map(|placed| Caster::new(world, placed)).collect();
    let shadow =
        |direction, tangent| GroundShadow::new(&casters, ground.height, direction, tangent);
    let (key_shadow, sky_shadow) = rayon::join(
        || shadow(lighting.towards_key(), KEY_TANGENT),
        || shadow(Vector::Y, SKY_TANGENT),
    );
    let eye = Vector::from(view.eye());
    let centre = world.centre().unwrap_or(eye);
    GroundShading {
        ground,
        style,
        key_shadow,
        sky_shadow,
        centre,
        fade: centre.distance(eye),
    }
}
