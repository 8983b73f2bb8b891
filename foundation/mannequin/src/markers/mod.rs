//! Markers on the skin, by which cameras find the body: discs round the bones, and dots all over.

mod dots;
mod layout;

use ga_anim::weights::Influence;
use ga_image::plane::Plane;
use ga_mesh::query::Bvh;
use ga_runtime::cga3::Point;
use ga_runtime::geometry::ray::Ray;

use crate::{Human, Vector};
use layout::{LAYOUT, Ring};

/// The radius of the inner disc as a part of the marker's.
const INNER: f64 = 0.55;
/// Points round the rim of a marker, by which its middle and its weights are found.
const RIM: usize = 32;
/// Steps by which a point of the rim is moved along the skin to its distance from the centre.
const RIM_STEPS: usize = 8;

/// A disc on the skin at rest, all points of the skin within a radius of its centre: a ring of one
/// colour round an inner disc of another, which has 0.55 of the radius.
///
/// Pictures show its outline. On a bent skin the centre of the outline is not the centre of the
/// disc, which bulges out of the plane of the rim; it is the middle of the rim, from wherever the
/// whole of it is seen.
#[derive(Clone, Debug, PartialEq)]
pub struct Marker {
    /// The name of the joint and the number of the marker on its bone from 0, such as
    /// `LeftLowerArm 2`.
    pub name: String,
    /// The joint on whose bone it is.
    pub joint: usize,
    /// Its centre on the skin at rest, in metres.
    pub centre: [f64; 3],
    /// The distance of its rim from the centre, in metres.
    pub radius: f64,
    /// The unit normal of the skin at its centre at rest, outwards.
    pub normal: [f64; 3],
    /// The mean of its rim at rest: the point that pictures show as its centre.
    pub middle: [f64; 3],
    /// The mean of the skin weights at its rim, greatest first.
    pub weights: Vec<Influence>,
}

impl Human {
    /// The markers of the body: 4 round the middle of each long bone, and others on the trunk, the
    /// head, the shoulders, the hands and the feet, 70 in all. They do not overlap.
    ///
    /// ```
    /// use ga_mannequin::Human;
    ///
    /// let human = Human::new();
    /// let markers = human.markers();
    /// let shin = human.skeleton.index("LeftLowerLeg").ok_or("no shin")?;
    /// assert_eq!(markers.iter().filter(|marker| marker.joint == shin).count(), 4);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    #[must_use]
    pub fn markers(&self) -> Vec<Marker> {
        let Some(skin) = Skin::new(self) else {
            return Vec::new();
        };
        let mut markers: Vec<Marker> = Vec::new();
        for ring in LAYOUT {
            for joint in ring.joints(&self.skeleton) {
                let before = markers
                    .iter()
                    .filter(|marker| marker.joint == joint)
                    .count();
                let found = ring
                    .angles
                    .iter()
                    .filter_map(|&angle| skin.marker(ring, joint, angle));
                let name = &self.skeleton.joints()[joint].name;
                let named = found.enumerate().map(|(number, marker)| Marker {
                    name: format!("{name} {}", before + number),
                    ..marker
                });
                markers.extend(named.collect::<Vec<_>>());
            }
        }
        markers
    }

    /// The texture of [`Human::texture`] in dark grey, with markers painted on it: for each marker
    /// the 8-bit sRGB colours of its inner disc and of its ring. Grey has no hue, so that a picture
    /// of the body is coloured where a marker is, and nowhere else.
    ///
    /// Markers without colours are left out.
    #[must_use]
    pub fn marked_texture(
        &self,
        size: usize,
        markers: &[Marker],
        colours: &[[[u8; 3]; 2]],
    ) -> Plane<[u8; 3]> {
        let painted: Vec<(Vector, f64, [[f64; 3]; 2])> = markers
            .iter()
            .zip(colours)
            .map(|(marker, colours)| {
                let light = colours.map(|colour| {
                    colour.map(|c| ga_image::colour::linear_from_srgb(f64::from(c) / 255.0))
                });
                (Vector::from(marker.centre), marker.radius, light)
            })
            .collect();
        // Edges are as soft as a texel.
        let softness = 1.0 / (TEXELS_PER_METRE * size as f64);
        let encoder = ga_image::colour::SrgbEncoder::new();
        self.painted(size, |point, cloth| {
            let near = painted.iter().find(|(centre, radius, _)| {
                (point - *centre).length_squared() < (radius + softness).powi(2)
            });
            let light = cloth.map(ga_image::colour::linear_from_srgb);
            let grey = DARKENING * (0.2126 * light[0] + 0.7152 * light[1] + 0.0722 * light[2]);
            let mut colour = [grey; 3];
            if let Some((centre, radius, [inner, ring])) = near {
                let distance = point.distance(*centre);
                let within =
                    |radius: f64| (0.5 + 0.5 * (radius - distance) / softness).clamp(0.0, 1.0);
                let mix = |a: [f64; 3], b: [f64; 3], t: f64| {
                    std::array::from_fn(|i| a[i] + (b[i] - a[i]) * t)
                };
                colour = mix(
                    mix(colour, *ring, within(*radius)),
                    *inner,
                    within(INNER * radius),
                );
            }
            encoder.encode(colour.into()).map(|c| f64::from(c) / 255.0)
        })
    }
}

/// The light of the grey skin as a part of that of its colours: markers are brighter.
const DARKENING: f64 = 0.4;
/// How many texels a metre of the skin has, for each row of the texture: the charts of its 2 square
/// metres cover about two thirds of the texture.
const TEXELS_PER_METRE: f64 = 0.55;

struct Skin<'a> {
    human: &'a Human,
    surface: Bvh,
    triangles: Vec<[u32; 3]>,
}

impl<'a> Skin<'a> {
    fn new(human: &'a Human) -> Option<Self> {
        let positions: Vec<[f64; 3]> = human.mesh.coordinates().collect();
        let triangles = human.mesh.triangles();
        let surface = Bvh::new(&positions, &triangles).ok()?;
        Some(Self {
            human,
            surface,
            triangles,
        })
    }

    /// The marker that a ray from the bone meets at an angle; `None` where there is no skin.
    fn marker(&self, ring: &Ring, joint: usize, angle: f64) -> Option<Marker> {
        let (from, direction) = ring.ray(&self.human.skeleton.joints()[joint], angle)?;
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
    fn disc(
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
        let mut weights = vec![0.0; self.human.skeleton.len()];
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
        let mut way = direction;
        for _ in 0..RIM_STEPS {
            let near = self
                .surface
                .nearest(Point::from(centre + way * radius))
                .ok()?;
            way = (Vector::from(near.point) - centre).normalized()?;
        }
        let place = centre + way * radius;
        let near = self.surface.nearest(Point::from(place)).ok()?;
        let mut weights = vec![0.0; self.human.skeleton.len()];
        let corners = self.triangles[near.triangle as usize];
        for (vertex, share) in corners.into_iter().zip(near.barycentric) {
            for influence in self.human.weights.influences(vertex as usize) {
                weights[influence.joint as usize] += share * influence.weight;
            }
        }
        Some((place, weights))
    }

    fn position(&self, vertex: u32) -> Vector {
        Vector::from(self.human.mesh.positions()[vertex as usize])
    }
}

/// The weights above zero, greatest first.
fn influences(weights: &[f64]) -> Vec<Influence> {
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
