//! The skin of a body at rest, and discs on it.

use ga_anim::skeleton::Skeleton;
use ga_anim::weights::{Influence, SkinWeights};
use ga_mesh::Mesh;
use ga_mesh::normals::vertex_normals;
use ga_mesh::query::Bvh;
use ga_runtime::cga3::Point;
use ga_runtime::geometry::ray::Ray;

use super::layout::Ring;
use super::marker::Marker;
use crate::Vector;

/// Points round the rim of a marker, by which its middle and its weights are found.
const RIM: usize = 32;
/// Steps by which a point of the rim is moved along the skin to its distance from the centre.
const RIM_STEPS: usize = 8;

pub(super) struct Skin<'a> {
    pub(super) mesh: &'a Mesh,
    pub(super) skeleton: &'a Skeleton,
    pub(super) weights: &'a SkinWeights,
    pub(super) surface: Bvh,
    pub(super) triangles: Vec<[u32; 3]>,
    /// Of the vertices.
    pub(super) normals: Vec<Vector>,
}

/// A place on the skin.
#[derive(Clone, Debug)]
pub(super) struct Place {
    pub(super) position: Vector,
    /// Outwards; not of unit length where the skin has none.
    pub(super) normal: Vector,
    /// For each joint.
    pub(super) weights: Vec<f64>,
}

impl<'a> Skin<'a> {
    /// `None` for a mesh without triangles.
    pub(super) fn new(
        mesh: &'a Mesh,
        skeleton: &'a Skeleton,
        weights: &'a SkinWeights,
    ) -> Option<Self> {
        let positions: Vec<[f64; 3]> = mesh.coordinates().collect();
        let triangles = mesh.triangles();
        let surface = Bvh::new(&positions, &triangles).ok()?;
        let normals = vertex_normals(&positions, &triangles).into_iter();
        (!triangles.is_empty()).then(|| Self {
            mesh,
            skeleton,
            weights,
            surface,
            normals: normals.map(Vector::from).collect(),
            triangles,
        })
    }

    /// The marker that a ray from the bone meets at an angle; `None` where there is no skin.
    pub(super) fn marker(&self, ring: &Ring, joint: usize, angle: f64) -> Option<Marker> {
        let (from, direction) = ring.ray(&self.skeleton.joints()[joint], angle)?;
        let ray = Ray::new(Point::from(from), direction.coordinates())?;
        let hit = self.surface.first_hit(ray)?;
        let centre = from + direction.normalized()? * hit.hit.distance;
        let corners = self.triangles[hit.triangle as usize].map(|vertex| self.position(vertex));
        let normal = (corners[1] - corners[0])
            .cross(corners[2] - corners[0])
            .normalized()?;
        let across = normal.cross(direction.cross(Vector::new(0.3, 0.5, 0.8)));
        self.disc(joint, centre, normal, across, ring.radius)
    }

    /// The disc of a radius about a point of the skin, with its rim from a direction on.
    pub(super) fn disc(
        &self,
        joint: usize,
        centre: Vector,
        normal: Vector,
        across: Vector,
        radius: f64,
    ) -> Option<Marker> {
        let across = across.normalized()?;
        let depth = normal.cross(across);
        let mut middle = Vector::ZERO;
        let mut weights = vec![0.0; self.skeleton.len()];
        for step in 0..RIM {
            let (sin, cos) = (std::f64::consts::TAU * step as f64 / RIM as f64).sin_cos();
            let rim = self.rim(centre, across * cos + depth * sin, radius)?;
            middle += rim.0 / RIM as f64;
            for (sum, weight) in weights.iter_mut().zip(rim.1) {
                *sum += weight / RIM as f64;
            }
        }
        Some(Marker {
            name: String::new(),
            joint,
            centre: centre.coordinates(),
            radius,
            normal: normal.coordinates(),
            middle: middle.coordinates(),
            weights: influences(&weights),
        })
    }

    /// The point of the skin at a distance from a centre in about a direction, and its weights.
    fn rim(&self, centre: Vector, direction: Vector, radius: f64) -> Option<(Vector, Vec<f64>)> {
        let place = self.at_distance(centre, direction, radius)?;
        Some((place, self.nearest(place)?.weights))
    }

    /// The point of the skin at a distance from a centre in about a direction.
    pub(super) fn at_distance(
        &self,
        centre: Vector,
        direction: Vector,
        radius: f64,
    ) -> Option<Vector> {
        let mut way = direction;
        for _ in 0..RIM_STEPS {
            let near = self
                .surface
                .nearest(Point::from(centre + way * radius))
                .ok()?;
            way = (Vector::from(near.point) - centre).normalized()?;
        }
        Some(centre + way * radius)
    }

    /// The place of the skin that is nearest to a point.
    pub(super) fn nearest(&self, point: Vector) -> Option<Place> {
        let near = self.surface.nearest(Point::from(point)).ok()?;
        Some(self.within(near.triangle as usize, near.barycentric))
    }

    /// The place in a triangle with these barycentric coordinates.
    pub(super) fn within(&self, triangle: usize, barycentric: [f64; 3]) -> Place {
        let mut place = Place {
            position: Vector::ZERO,
            normal: Vector::ZERO,
            weights: vec![0.0; self.skeleton.len()],
        };
        for (vertex, share) in self.triangles[triangle].into_iter().zip(barycentric) {
            place.position += self.position(vertex) * share;
            place.normal += self.normals[vertex as usize] * share;
            for influence in self.weights.influences(vertex as usize) {
                place.weights[influence.joint as usize] += share * influence.weight;
            }
        }
        place.normal = place.normal.normalized().unwrap_or(place.normal);
        place
    }

    pub(super) fn position(&self, vertex: u32) -> Vector {
        Vector::from(self.mesh.positions()[vertex as usize])
    }
}

/// The weights above zero, greatest first.
pub(super) fn influences(weights: &[f64]) -> Vec<Influence> {
    let joints = weights
        .iter()
        .enumerate()
        .filter(|(_, weight)| **weight > 0.0);
    let mut influences: Vec<Influence> = joints
        .map(|(joint, &weight)| Influence {
            joint: joint as u32,
            weight,
        })
        .collect();
    influences.sort_by(|a, b| b.weight.total_cmp(&a.weight));
    influences
}
