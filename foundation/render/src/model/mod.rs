//! Models from files as they are drawn: triangles, materials and textures in memory.
//!
//! [`Model::from_mesh`] takes a mesh with its materials. A [`Model`] owns what a [`Scene`] borrows;
//! [`Model::with_scene`] makes one with ground and edges.
//!
//! ```
//! use ga_render::model::Model;
//! use ga_render::{View, Style, ViewDirection, render};
//!
//! let mesh = ga_mesh::obj::decode(b"v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\n").unwrap();
//! let model = Model::from_mesh(&mesh, None)?;
//! let style = Style::default();
//! let side = ViewDirection::default();
//! let view = View::fit(model.points(), side, 0.5, style.aspect(), 0.1)?;
//! let materials = model.materials();
//! let picture = render(&model.scene(&materials), &view, &style)?;
//! assert!(picture.depth.range().is_some());
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

mod drawing;
mod from_mesh;
mod textures;

use crate::texture::Mipmap;
use crate::{
    Appearance, Attribute, Dot, MaterialChoice, Normals, Object, Polyline, Scene, Visibility,
};
use ga_image::colour::LinearColour;

pub use drawing::Options;
pub use textures::{Meaning, load_texture};

/// A model in memory, ready to be drawn.
#[derive(Clone, Debug, Default)]
pub struct Model {
    parts: Vec<Part>,
    /// The values that the corners of parts refer to.
    normals: Vec<[f64; 3]>,
    texture_coordinates: [Vec<[f64; 2]>; 2],
    tangents: Vec<[f64; 4]>,
    surfaces: Vec<Surface>,
    textures: Vec<Mipmap>,
    lines: Vec<Line>,
    dots: Vec<([f64; 3], LinearColour)>,
    warnings: Vec<String>,
}

/// For each triangle the indices of the values at its corners, if it has any.
type Corners = Vec<Option<[u32; 3]>>;

/// The triangles of an object, which has its own numbers for the vertices.
#[derive(Clone, Debug, Default)]
struct Part {
    positions: Vec<[f64; 3]>,
    triangles: Vec<[u32; 3]>,
    normals: Option<Corners>,
    texture_coordinates: [Option<Corners>; 2],
    tangents: Option<Corners>,
    /// One for each vertex, or none.
    colours: Vec<[f64; 4]>,
    /// One for each triangle.
    materials: Vec<Option<u32>>,
}

/// An edge of a polyline of the model.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Line {
    ends: [[f64; 3]; 2],
    colour: LinearColour,
}

/// A material whose textures are given by index.
#[derive(Clone, Copy, Debug, Default)]
struct Surface {
    material: Appearance<'static>,
    base_colour: Option<usize>,
    metallic_roughness: Option<usize>,
    normal: Option<usize>,
    occlusion: Option<usize>,
    emission: Option<usize>,
}

impl Model {
    /// The materials, which borrow the model's textures.
    pub fn materials(&self) -> Vec<Appearance<'_>> {
        let texture = |index: Option<usize>| index.map(|index| &self.textures[index]);
        let materials = self.surfaces.iter().map(|surface| Appearance {
            base_colour_map: texture(surface.base_colour),
            metallic_roughness_map: texture(surface.metallic_roughness),
            normal_map: texture(surface.normal),
            occlusion_map: texture(surface.occlusion),
            emission_map: texture(surface.emission),
            ..surface.material
        });
        materials.collect()
    }

    /// The model as a scene with its [`materials`](Self::materials).
    pub fn scene<'a>(&'a self, materials: &'a [Appearance<'a>]) -> Scene<'a> {
        Scene {
            objects: self.parts.iter().map(|part| self.object(part)).collect(),
            materials,
            ..Scene::default()
        }
    }

    fn object<'a>(&'a self, part: &'a Part) -> Object<'a> {
        let coordinates = |set: usize| {
            attribute(
                &self.texture_coordinates[set],
                &part.texture_coordinates[set],
            )
        };
        Object {
            normals: attribute(&self.normals, &part.normals)
                .map_or(Normals::Smooth, Normals::Given),
            texture_coordinates: coordinates(0),
            second_texture_coordinates: coordinates(1),
            tangents: attribute(&self.tangents, &part.tangents),
            colours: (!part.colours.is_empty()).then(|| Attribute::of_vertices(&part.colours)),
            material: MaterialChoice::PerTriangle(&part.materials),
            ..Object::new(&part.positions, &part.triangles)
        }
    }

    /// The vertices of all triangles, lines and points, in the world.
    pub fn points(&self) -> impl Iterator<Item = [f64; 3]> + '_ {
        let corners = self.parts.iter().flat_map(|part| {
            let corners = part.triangles.iter().flatten();
            corners.map(|&vertex| part.positions[vertex as usize])
        });
        let ends = self.lines.iter().flat_map(|line| line.ends);
        corners.chain(ends).chain(self.dots.iter().map(|dot| dot.0))
    }

    /// The polylines of the model, edge by edge, as lines of this width in pixels.
    pub fn lines(&self, width: f64) -> Vec<Polyline<'_>> {
        let lines = self.lines.iter().map(|line| Polyline {
            points: &line.ends,
            colour: line.colour,
            width,
            visibility: Visibility::Hidden,
        });
        lines.collect()
    }

    /// The points of the model as dots of this diameter in pixels.
    pub fn dots(&self, diameter: f64) -> Vec<Dot> {
        let dots = self.dots.iter().map(|&(position, colour)| Dot {
            position,
            colour,
            diameter,
            visibility: Visibility::Hidden,
        });
        dots.collect()
    }

    /// The same model with both sides of each face drawn, for formats that do not say which sides
    /// are seen.
    #[must_use]
    pub fn with_both_sides(mut self) -> Self {
        for surface in &mut self.surfaces {
            surface.material.double_sided = true;
        }
        self
    }

    /// Whether there is nothing to be drawn.
    pub fn is_empty(&self) -> bool {
        self.points().next().is_none()
    }

    /// The ends of the edges of all triangles; an edge that triangles of one object share, once.
    pub fn edges(&self) -> Vec<[[f64; 3]; 2]> {
        let mut edges = Vec::new();
        for part in &self.parts {
            let mut pairs: Vec<[u32; 2]> = part
                .triangles
                .iter()
                .flat_map(|&[a, b, c]| [[a, b], [b, c], [c, a]])
                .map(|[a, b]| [a.min(b), a.max(b)])
                .collect();
            pairs.sort_unstable();
            pairs.dedup();
            let place = |vertex: u32| part.positions[vertex as usize];
            edges.extend(pairs.iter().map(|pair| pair.map(place)));
        }
        edges
    }

    /// How many triangles there are.
    pub fn triangle_count(&self) -> usize {
        self.parts.iter().map(|part| part.triangles.len()).sum()
    }

    /// What could not be drawn as the file asks, and what is drawn in its place; a sentence each.
    pub fn warnings(&self) -> &[String] {
        &self.warnings
    }
}

fn attribute<'a, T: Copy>(
    values: &'a [T],
    corners: &'a Option<Corners>,
) -> Option<Attribute<'a, T>> {
    corners
        .as_ref()
        .map(|corners| Attribute::of_corners(values, corners))
}
