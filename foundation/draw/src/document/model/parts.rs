//! The points, vertices and triangles that a page has of a model.

use std::collections::HashMap;

use super::scale::Scale;
use super::view::{ModelCoordinates, ModelView};

/// What is written of a model.
pub(super) struct Parts {
    pub(super) scale: Scale<3>,
    /// The numbers of each point in all frames.
    pub(super) points: Vec<Vec<[u16; 3]>>,
    pub(super) vertices: Vec<Vertex>,
    pub(super) triangles: Vec<[u32; 3]>,
    pub(super) texture_scale: Option<Scale<2>>,
}

/// A vertex as it is drawn.
#[derive(Clone, Copy, PartialEq, Eq, Hash)]
pub(super) struct Vertex {
    pub(super) point: u32,
    pub(super) coordinates: Option<[u16; 2]>,
    pub(super) colour: Option<[u8; 3]>,
}

impl Parts {
    /// Points and vertices are numbered in the order in which triangles have them.
    pub(super) fn of(model: &ModelView) -> Self {
        let corners = || model.triangles.iter().flatten().copied();
        let positions = model
            .frames
            .iter()
            .flat_map(|frame| corners().map(|vertex| frame[vertex as usize]));
        let scale = Scale::of(positions);
        let coordinates = model.texture.as_ref().map(|texture| &texture.coordinates);
        let texture_scale = coordinates.map(|coordinates| {
            Scale::of(
                model
                    .triangles
                    .iter()
                    .enumerate()
                    .flat_map(|(k, triangle)| {
                        [0, 1, 2].map(|corner| down(coordinates, k, corner, triangle[corner]))
                    }),
            )
        });
        let mut points = Numbered::default();
        // The point of each vertex of the model that a triangle has had.
        let mut known = vec![None; model.frames[0].len()];
        let mut vertices = Numbered::default();
        let mut triangles = Vec::with_capacity(model.triangles.len());
        for (k, triangle) in model.triangles.iter().enumerate() {
            triangles.push([0, 1, 2].map(|corner| {
                let vertex = triangle[corner];
                let index = vertex as usize;
                let point = *known[index].get_or_insert_with(|| {
                    let path = model.frames.iter().map(|frame| scale.numbers(frame[index]));
                    points.number(path.collect())
                });
                let coordinates = coordinates
                    .zip(texture_scale)
                    .map(|(all, scale)| scale.numbers(down(all, k, corner, vertex)));
                vertices.number(Vertex {
                    point,
                    coordinates,
                    colour: model.colours.as_ref().map(|colours| colours[index].0),
                })
            }));
        }
        Self {
            scale,
            points: points.items,
            vertices: vertices.items,
            triangles,
            texture_scale,
        }
    }
}

/// Texture coordinates of a corner with v down, as the page has them.
fn down(coordinates: &ModelCoordinates, triangle: usize, corner: usize, vertex: u32) -> [f64; 2] {
    let [u, v] = coordinates.of(triangle, corner, vertex);
    [u, 1.0 - v]
}

/// Different things in the order in which they came, with their numbers.
struct Numbered<T> {
    items: Vec<T>,
    numbers: HashMap<T, u32>,
}

impl<T> Default for Numbered<T> {
    fn default() -> Self {
        Self {
            items: vec![],
            numbers: HashMap::new(),
        }
    }
}

impl<T: Clone + Eq + std::hash::Hash> Numbered<T> {
    fn number(&mut self, item: T) -> u32 {
        let next = self.items.len() as u32;
        *self.numbers.entry(item).or_insert_with_key(|item| {
            self.items.push(item.clone());
            next
        })
    }
}
