//! Triangles with parts that are cut out.

use crate::Vector;
use crate::appearance::Appearance;
use crate::barycentric::barycentric;
use crate::raster::Corner;

use crate::world::{Face, World};

/// A triangle that is there only where it is opaque.
pub(crate) struct Cut<'a> {
    material: &'a Appearance<'a>,
    cutoff: f64,
    coordinates: Option<[[f64; 2]; 3]>,
    opacities: [f64; 3],
}

impl<'a> Cut<'a> {
    /// `None` for a triangle without parts that are cut out.
    pub(crate) fn new(world: &World<'a>, face: &Face) -> Option<Self> {
        let material = world.material(face)?;
        Some(Self::with_cutoff(material, face, material.cutoff?))
    }

    /// The part of a triangle that casts a shadow; `None` where all of it does. A transparent
    /// surface casts one where it lets less than half of the light pass.
    pub(crate) fn caster(world: &World<'a>, face: &Face) -> Option<Self> {
        let material = world.material(face)?;
        let half = material.transparent.then_some(0.5);
        Some(Self::with_cutoff(material, face, half.or(material.cutoff)?))
    }

    fn with_cutoff(material: &'a Appearance<'a>, face: &Face, cutoff: f64) -> Self {
        let placement = material.placements.base_colour;
        let coordinates = face.texture_coordinates(placement.set);
        Self {
            material,
            cutoff,
            coordinates: coordinates.map(|corners| corners.map(|p| placement.place(p))),
            opacities: face
                .colours()
                .map_or([1.0; 3], |colours| colours.map(|colour| colour[3])),
        }
    }

    /// Whether the surface is there at barycentric coordinates of the triangle.
    pub(crate) fn shows(&self, weights: [f64; 3]) -> bool {
        let mut opacity = self.material.opacity;
        opacity *= (0..3).map(|i| weights[i] * self.opacities[i]).sum::<f64>();
        if let (Some(map), Some(corners)) = (self.material.base_colour_map, self.coordinates) {
            let coordinates = [0, 1].map(|c| (0..3).map(|i| weights[i] * corners[i][c]).sum());
            opacity *= map.at(coordinates, 0.0)[3];
        }
        opacity >= self.cutoff
    }

    /// Whether the surface is there at the middle of a pixel, where the triangle is projected in
    /// parallel onto a map that is `width` pixels wide.
    pub(crate) fn shows_at(&self, pixel: usize, width: usize, corners: [Corner; 3]) -> bool {
        let place = |x: f64, y: f64| Vector::new(x, y, 1.0);
        let middle = place((pixel % width) as f64 + 0.5, (pixel / width) as f64 + 0.5);
        self.shows(barycentric(middle, corners.map(|[x, y, _]| place(x, y))))
    }
}
