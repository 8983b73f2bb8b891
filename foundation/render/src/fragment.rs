//! A place of a surface: where it is, and what its attributes and textures say there.

use crate::barycentric::{volumes, weights};
use ga_image::colour::LinearColour;

use crate::appearance::{Appearance, CoordinateSet, Placement};
use crate::lens::Lens;
use crate::shade::Surface;
use crate::texture::Mipmap;
use crate::world::Face;
use crate::{Vector, View};

/// Where a ray from the eye meets a triangle.
pub(crate) struct Fragment<'w> {
    face: Face<'w>,
    weights: [f64; 3],
    /// The place in the world.
    pub(crate) point: Vector,
    /// The unit vector from there to the eye.
    pub(crate) towards_viewer: Vector,
    /// The triangle's unit normal, on the side of its orientation.
    pub(crate) flat: Vector,
    /// The unit normal between those of the corners, on the side of the triangle's orientation.
    pub(crate) smooth: Vector,
    /// The place by each set of texture coordinates.
    places: [Option<Place>; 2],
}

/// A place by a set of texture coordinates.
#[derive(Clone, Copy)]
struct Place {
    coordinates: [f64; 2],
    /// Their change to the next column, and to the next row.
    steps: [[f64; 2]; 2],
}

/// What shading needs to know of a fragment.
pub(crate) struct Look {
    pub(crate) surface: Surface,
    pub(crate) emission: LinearColour,
    /// 0 to 1.
    pub(crate) opacity: f64,
    /// The share of light from all around that arrives, by the material's map.
    pub(crate) occlusion: f64,
    pub(crate) unlit: bool,
}

impl<'w> Fragment<'w> {
    /// `ray` has depth 1 in the camera's frame; `pixel` is the width of a pixel in those of the
    /// lens. `None` for a triangle without area.
    pub(crate) fn new(
        face: Face<'w>,
        ray: Vector,
        view: &View,
        lens: &Lens,
        pixel: f64,
    ) -> Option<Self> {
        let triangle = face.in_frame();
        let volumes_here = volumes(ray, triangle);
        let weights = weights(volumes_here);
        let flat = face.area_vector().normalized()?;
        let smooth = face
            .normals()
            .and_then(|normals| weighted(normals, weights).normalized())
            .map_or(flat, |normal| face.placed.world_direction(normal));
        let place = |corners: [[f64; 2]; 3]| {
            let coordinates = blend(corners, weights);
            let steps = lens.ray_steps().map(|step| {
                let change = volumes(step * pixel, triangle);
                let total: f64 = (0..3).map(|i| volumes_here[i] + change[i]).sum();
                [0, 1].map(|c| {
                    let moved = (0..3).map(|i| change[i] * (corners[i][c] - coordinates[c]));
                    moved.sum::<f64>() / total
                })
            });
            Place { coordinates, steps }
        };
        let sets = [CoordinateSet::First, CoordinateSet::Second];
        Some(Self {
            point: weighted(face.corners(), weights),
            towards_viewer: view.world_direction(-ray).normalized()?,
            flat,
            smooth,
            places: sets.map(|set| face.texture_coordinates(set).map(place)),
            face,
            weights,
        })
    }

    /// The triangle's barycentric coordinates of the place.
    pub(crate) fn weights(&self) -> [f64; 3] {
        self.weights
    }

    /// The first texture coordinates.
    pub(crate) fn texture_coordinates(&self) -> Option<[f64; 2]> {
        self.places[0].map(|place| place.coordinates)
    }

    /// Whether the viewer sees the back of the triangle.
    pub(crate) fn is_back(&self) -> bool {
        self.flat.dot(self.towards_viewer) < 0.0
    }

    /// What attributes, material and textures say.
    pub(crate) fn look(&self, material: &Appearance) -> Look {
        let places = &material.placements;
        let read = |map: Option<&Mipmap>, place: &Placement| {
            map.map_or([1.0; 4], |map| self.read(map, place))
        };
        let tint = self
            .face
            .colours()
            .map_or([1.0; 4], |corners| blend(corners, self.weights));
        let colour = |[red, green, blue, _]: [f64; 4]| LinearColour::new(red, green, blue);
        let normal = match material.normal_map {
            Some(map) => self.mapped_normal(map, &places.normal, material.normal_scale),
            None => self.smooth,
        };
        let [_, roughness, metallic, _] =
            read(material.metallic_roughness_map, &places.metallic_roughness);
        let occlusion = read(material.occlusion_map, &places.occlusion)[0];
        let base = read(material.base_colour_map, &places.base_colour);
        Look {
            surface: Surface {
                base_colour: material.base_colour * colour(base) * colour(tint),
                metallic: material.metallic * metallic,
                roughness: material.roughness * roughness,
                reflectance: material.reflectance,
                normal: if self.is_back() { -normal } else { normal },
            },
            emission: material.emission * colour(read(material.emission_map, &places.emission)),
            opacity: (material.opacity * base[3] * tint[3]).clamp(0.0, 1.0),
            occlusion: 1.0 + material.occlusion_strength * (occlusion - 1.0),
            unlit: material.unlit,
        }
    }

    /// A texture at this place; white where the triangle has no texture coordinates.
    fn read(&self, texture: &Mipmap, placement: &Placement) -> [f64; 4] {
        let Some(Place { coordinates, steps }) = self.places[placement.set as usize] else {
            return [1.0; 4];
        };
        let coordinates = placement.place(coordinates);
        let steps = steps.map(|step| placement.change(step));
        let size = [texture.width() as f64, texture.height() as f64];
        let length = |[du, dv]: [f64; 2]| (du * size[0]).hypot(dv * size[1]);
        texture.at(coordinates, length(steps[0]).max(length(steps[1])))
    }

    /// The unit normal of a normal map. As MikkTSpace asks, normal and tangent between the corners
    /// are not made unit vectors before they are combined.
    fn mapped_normal(&self, map: &Mipmap, placement: &Placement, scale: f64) -> Vector {
        let Some((normal, tangent, sign)) = self.frame(placement.set) else {
            return self.smooth;
        };
        let [x, y, z, _] = self.read(map, placement).map(|c| 2.0 * c - 1.0);
        let bitangent = normal.cross(tangent) * sign;
        let mapped = tangent * (x * scale) + bitangent * (y * scale) + normal * z;
        mapped
            .normalized()
            .map_or(self.smooth, |n| self.face.placed.world_direction(n))
    }

    /// Normal, tangent and the sign of the bitangent in the object's coordinates.
    fn frame(&self, set: CoordinateSet) -> Option<(Vector, Vector, f64)> {
        let corners = self.face.object_corners();
        let normal = match self.face.normals() {
            Some(normals) => weighted(normals, self.weights),
            None => (corners[1] - corners[0])
                .cross(corners[2] - corners[0])
                .normalized()?,
        };
        if let Some(tangents) = self.face.tangents() {
            let directions = tangents.map(|[x, y, z, _]| Vector::new(x, y, z));
            let sign = if tangents[0][3] < 0.0 { -1.0 } else { 1.0 };
            return Some((normal, weighted(directions, self.weights), sign));
        }
        // The edges e = Δu t + Δv b, solved for t.
        let [a, b, c] = self.face.texture_coordinates(set)?;
        let [du1, dv1] = [b[0] - a[0], b[1] - a[1]];
        let [du2, dv2] = [c[0] - a[0], c[1] - a[1]];
        let area = du1 * dv2 - du2 * dv1;
        let along = ((corners[1] - corners[0]) * dv2 - (corners[2] - corners[0]) * dv1)
            * if area < 0.0 { -1.0 } else { 1.0 };
        let tangent = along.reject(normal)?.normalized()?;
        Some((normal, tangent, if area < 0.0 { -1.0 } else { 1.0 }))
    }
}

fn weighted(vectors: [Vector; 3], weights: [f64; 3]) -> Vector {
    vectors[0] * weights[0] + vectors[1] * weights[1] + vectors[2] * weights[2]
}

fn blend<const N: usize>(corners: [[f64; N]; 3], weights: [f64; 3]) -> [f64; N] {
    std::array::from_fn(|c| (0..3).map(|i| corners[i][c] * weights[i]).sum())
}
