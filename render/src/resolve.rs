//! From samples to pixels: shading, ground and background, averaged in linear light.

use ga_mesh::normals::{area_vector, vertex_normals};
use rayon::prelude::*;

use crate::camera::Camera;
use crate::depth::DepthMap;
use crate::ground::{GroundShading, background};
use crate::shade::WorldLighting;
use crate::shadow::GroundShadow;
use crate::surface::{Samples, barycentric};
use crate::{RenderError, Scene, Style, Vector};
use ga_image::colour::LinearColour;

/// Tangents of the half angles of the key light and of the part of the sky that counts for the
/// contact shadow.
const KEY_TANGENT: f64 = 0.06;
const SKY_TANGENT: f64 = 0.9;

/// The linear light of each pixel, row by row, and the depths.
pub(crate) fn resolve(
    scene: &Scene,
    camera: &Camera,
    style: &Style,
    samples: &Samples,
) -> Result<(Vec<LinearColour>, DepthMap), RenderError> {
    let lighting = WorldLighting::new(
        &style.lighting,
        style.gloss,
        camera.forward().into(),
        camera.right().into(),
    )
    .ok_or(RenderError::Style("a light has no direction"))?;
    let resolver = Resolver {
        scene,
        camera,
        style,
        samples,
        normals: vertex_normals(scene.positions, scene.triangles)
            .into_iter()
            .map(Vector::from)
            .collect(),
        ground: ground_shading(scene, camera, style, &lighting),
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
    scene: &'a Scene<'a>,
    camera: &'a Camera,
    style: &'a Style,
    samples: &'a Samples,
    normals: Vec<Vector>,
    lighting: WorldLighting,
    ground: Option<GroundShading<'a>>,
}

struct Pixel {
    light: LinearColour,
    depth: f32,
    coverage: f32,
}

impl Resolver<'_> {
    fn pixel(&self, column: usize, row: usize) -> Pixel {
        let n = self.style.supersampling as usize;
        let per_sample = 1.0 / (n * n) as f64;
        let mut light = LinearColour::BLACK;
        let (mut covered, mut nearest) = (0, 0f32);
        for j in 0..n {
            for i in 0..n {
                let (x, y) = (column * n + i, row * n + j);
                let index = y * self.samples.width + x;
                let inverse = self.samples.inverse_depth[index];
                if inverse == 0.0 {
                    continue;
                }
                let ray = self.samples.lens.ray(x as f64 + 0.5, y as f64 + 0.5);
                if self.ground_depth(ray) < 1.0 / f64::from(inverse) {
                    continue;
                }
                light += self.surface(self.samples.triangle[index], ray);
                nearest = nearest.max(inverse);
                covered += 1;
            }
        }
        let coverage = f64::from(covered) * per_sample;
        light = light * per_sample;
        if coverage < 1.0 {
            light += self.surroundings(column, row) * (1.0 - coverage);
        }
        Pixel {
            light,
            depth: 1.0 / nearest,
            coverage: coverage as f32,
        }
    }

    /// The mesh's light towards the eye along a ray of the camera's frame.
    fn surface(&self, triangle: u32, ray: Vector) -> LinearColour {
        let corners = self.scene.triangles[triangle as usize].map(|v| v as usize);
        let weights = barycentric(ray, corners.map(|v| self.samples.view[v]));
        let mut normal = Vector::default();
        for (corner, weight) in corners.into_iter().zip(weights) {
            normal += self.normals[corner] * weight;
        }
        let flat = area_vector(corners.map(|v| self.scene.positions[v].into()));
        let towards_viewer = self.camera.world_direction(-ray);
        let (Some(mut normal), Some(towards_viewer)) = (
            normal.normalized().or_else(|| flat.normalized()),
            towards_viewer.normalized(),
        ) else {
            return self.style.surface;
        };
        if flat.dot(towards_viewer) < 0.0 {
            normal = -normal;
        }
        self.lighting
            .shade(self.style.surface, normal, towards_viewer)
    }

    /// What is seen beside the mesh, at the middle of a pixel.
    fn surroundings(&self, column: usize, row: usize) -> LinearColour {
        let n = f64::from(self.style.supersampling);
        let (x, y) = ((column as f64 + 0.5) * n, (row as f64 + 0.5) * n);
        let ray = self.samples.lens.ray(x, y);
        let behind = background(
            self.style,
            (row as f64 + 0.5) / f64::from(self.style.height),
        );
        let depth = self.ground_depth(ray);
        match &self.ground {
            Some(ground) if depth.is_finite() => {
                let direction = self.camera.world_direction(ray);
                let point = Vector::from(self.camera.eye()) + direction * depth;
                // A pixel's patch of ground is longer than wide by one over the sine of the ray's
                // slope.
                let sine = direction.e2.abs() / direction.length();
                let pixel = depth * n / self.samples.lens.focal;
                ground.colour(point, pixel / sine.sqrt(), behind)
            }
            _ => behind,
        }
    }

    /// The depth at which a ray of the camera's frame meets the ground; infinite where it does not.
    fn ground_depth(&self, ray: Vector) -> f64 {
        let Some(ground) = &self.ground else {
            return f64::INFINITY;
        };
        let fall = self.camera.world_direction(ray).e2;
        let depth = (ground.ground.height - self.camera.eye()[1]) / fall;
        if depth >= self.camera.near() {
            depth
        } else {
            f64::INFINITY
        }
    }
}

fn ground_shading<'a>(
    scene: &Scene,
    camera: &Camera,
    style: &'a Style,
    lighting: &WorldLighting,
) -> Option<GroundShading<'a>> {
    let ground = scene.ground?;
    let shadow = |direction, tangent| {
        GroundShadow::new(
            scene.positions,
            scene.triangles,
            ground.height,
            direction,
            tangent,
        )
    };
    let (key_shadow, sky_shadow) = rayon::join(
        || shadow(lighting.towards_key(), KEY_TANGENT),
        || shadow(Vector::Y, SKY_TANGENT),
    );
    let eye = Vector::from(camera.eye());
    let centre = centre_of(scene.positions).unwrap_or(eye);
    Some(GroundShading {
        ground,
        style,
        key_shadow,
        sky_shadow,
        centre,
        fade: centre.distance(eye),
    })
}

/// The mean of some points.
fn centre_of(positions: &[[f64; 3]]) -> Option<Vector> {
    let sum = positions
        .iter()
        .map(|&position| Vector::from(position))
        .reduce(|a, b| a + b)?;
    Some(sum * (1.0 / positions.len() as f64))
}
