//! Small dots all over the skin.

use std::collections::HashMap;

use ga_anim::character::Character;
use ga_runtime::cga3::Point;
use ga_runtime::geometry::ray::Ray;
use rayon::prelude::*;

use super::grid::cell;
use super::marker::Marker;
use super::skin::{Place, Skin};
use crate::{Human, Vector};

/// The radius of the dots in metres on the bones of joints whose names end so: about a third of the
/// radius of the limb, so that a dot is seen whole from most sides.
const RADII: &[(&str, f64)] = &[
    ("Hand", 0.0095),
    ("Toe", 0.0095),
    ("Foot", 0.0110),
    ("LowerArm", 0.0115),
    ("Neck", 0.0120),
    ("UpperArm", 0.0130),
    ("LowerLeg", 0.0130),
    ("Head", 0.0130),
    ("Shoulder", 0.0140),
];
/// The radius on the trunk and the thighs, and the least of all.
const GREATEST: f64 = 0.0150;
const LEAST: f64 = 0.0095;
/// The radius as a part of how thick a limb is.
const OF_THICKNESS: f64 = 1.0 / 6.0;
/// On a skin of large triangles, places are as far apart as this, in metres.
const STEP: f64 = 0.01;
/// Skin that has other skin within this distance before it, in metres, is not seen.
const COVERED: f64 = 0.03;
/// Rays begin so far from the skin, in metres, not to meet it where they begin.
const OFF: f64 = 1e-5;
/// The least distance between centres in radii: seen from the side, dots are still apart.
const SPACING: f64 = 3.5;
/// Cosine of the greatest angle between the normal at the centre and others of a dot.
const BEND: f64 = 0.6;
/// The greatest difference of a joint's weights within a dot.
const DIFFERENCE: f64 = 0.5;
/// What is nearer than this beyond the rim, in metres, must not be the other side of the body.
const BEYOND: f64 = 0.004;
/// The edge of a cell: what is near to a place is in its cell and in those about it.
const CELL: f64 = GREATEST + BEYOND;

impl Human {
    /// Dots all over the skin, about 480: at any place on the trunk and the limbs, several are seen
    /// from any side. Their radii are 15 mm on trunk and thighs and less on thinner limbs, down to
    /// 9.5 mm on the hands, and their centres are 3.5 radii apart or more. There are none where the
    /// skin is strongly curved, as at fingers and ears, and at the creases of joints.
    ///
    /// Each dot is as far as possible from those before it (farthest point sampling: Y. Eldar et
    /// al., The farthest point strategy for progressive image sampling, 1997).
    ///
    /// ```
    /// use ga_mannequin::Human;
    ///
    /// let human = Human::new();
    /// let dots = human.dots();
    /// let arm = human.skeleton.index("LeftLowerArm").ok_or("no forearm")?;
    /// assert!(dots.iter().filter(|dot| dot.joint == arm).count() >= 10);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    #[must_use]
    pub fn dots(&self) -> Vec<Marker> {
        Sampling::of_human(self).map_or_else(Vec::new, |sampling| sampling.named())
    }
}

/// Dots all over the skin of a character in metres, as [`Human::dots`] are on the mannequin: at
/// the joints of the mannequin's names they have the same radii, elsewhere a sixth of how thick the
/// limb is, from 9.5 to 15 mm. There are none where other skin lies over it, as on the teeth.
#[must_use]
pub fn dots_on(character: &Character) -> Vec<Marker> {
    Sampling::of_character(character).map_or_else(Vec::new, |sampling| sampling.named())
}

/// Places on the skin where dots may be.
struct Sampling<'a> {
    skin: Skin<'a>,
    places: Vec<Place>,
    /// For each place the joint of its greatest weight.
    joints: Vec<usize>,
    /// The radius of a dot at each place.
    radii: Vec<f64>,
    /// Whether other skin is over it.
    covered: Vec<bool>,
    /// The places of each cell of a grid.
    cells: HashMap<[i64; 3], Vec<usize>>,
}

impl<'a> Sampling<'a> {
    /// The vertices, which are near to each other.
    fn of_human(human: &'a Human) -> Option<Self> {
        let skin = Skin::new(&human.mesh, &human.skeleton, &human.weights)?;
        let places = (0..human.mesh.vertex_count()).map(|vertex| {
            let mut weights = vec![0.0; human.skeleton.len()];
            for influence in human.weights.influences(vertex) {
                weights[influence.joint as usize] = influence.weight;
            }
            Place {
                position: skin.position(vertex as u32),
                normal: skin.normals[vertex],
                weights,
            }
        });
        let places: Vec<Place> = places.collect();
        let radius = |_: usize| GREATEST;
        let covered = vec![false; places.len()];
        Some(Self::new(skin, places, covered, radius))
    }

    /// Places in all triangles.
    fn of_character(character: &'a Character) -> Option<Self> {
        let Character {
            mesh,
            skeleton,
            weights,
        } = character;
        let skin = Skin::new(mesh, skeleton, weights)?;
        let places = (0..skin.triangles.len()).into_par_iter();
        let places = places.flat_map_iter(|triangle| skin.spread(triangle));
        let places: Vec<Place> = places.collect();
        let covered = places.par_iter();
        let covered = covered.map(|place| {
            let ahead = skin.clearance(place, place.normal);
            ahead.is_some_and(|distance| distance < COVERED)
        });
        let covered = covered.collect();
        let thick = places.par_iter().map(|place| {
            let thickness = skin.clearance(place, place.normal * -1.0);
            OF_THICKNESS * thickness.unwrap_or(f64::INFINITY)
        });
        let thick: Vec<f64> = thick.collect();
        Some(Self::new(skin, places, covered, |index| {
            thick[index].clamp(LEAST, GREATEST)
        }))
    }

    /// Of places with the radii where the names of joints do not say them.
    fn new(
        skin: Skin<'a>,
        places: Vec<Place>,
        covered: Vec<bool>,
        radius: impl Fn(usize) -> f64,
    ) -> Self {
        let joints = places.iter().map(|place| {
            let joints = 0..place.weights.len();
            let of = |joint: &usize| place.weights[*joint];
            let strongest = joints.max_by(|a, b| of(a).total_cmp(&of(b)));
            strongest.unwrap_or(0)
        });
        let joints: Vec<usize> = joints.collect();
        let named = skin.skeleton.joints().iter().map(|joint| {
            let found = RADII.iter().find(|(end, _)| joint.name.ends_with(end));
            found.map(|(_, radius)| *radius)
        });
        let named: Vec<Option<f64>> = named.collect();
        let radii = joints.iter().enumerate();
        let radii = radii.map(|(index, &joint)| named[joint].unwrap_or_else(|| radius(index)));
        let radii = radii.collect();
        let mut cells: HashMap<[i64; 3], Vec<usize>> = HashMap::new();
        for (index, place) in places.iter().enumerate() {
            cells
                .entry(cell(place.position, CELL))
                .or_default()
                .push(index);
        }
        Self {
            radii,
            joints,
            covered,
            cells,
            places,
            skin,
        }
    }

    /// The dots with names.
    fn named(&self) -> Vec<Marker> {
        let mut dots = self.dots();
        let joints = self.skin.skeleton.joints();
        let mut counts = vec![0; joints.len()];
        for dot in &mut dots {
            dot.name = format!("{} {}", joints[dot.joint].name, counts[dot.joint]);
            counts[dot.joint] += 1;
        }
        dots
    }

    fn dots(&self) -> Vec<Marker> {
        let mut dots: Vec<Marker> = Vec::new();
        // The distance of each place to the nearest dot as a multiple of the least one; 0 where no
        // dot can be.
        let distances = (0..self.places.len()).into_par_iter();
        let distances = distances.map(|place| match self.is_even(place) {
            true => f64::INFINITY,
            false => 0.0,
        });
        let mut distances: Vec<f64> = distances.collect();
        loop {
            let farthest =
                (0..distances.len()).max_by(|a, b| distances[*a].total_cmp(&distances[*b]));
            let Some(index) = farthest.filter(|index| distances[*index] >= 1.0) else {
                return dots;
            };
            let Some(dot) = self.dot(index) else {
                distances[index] = 0.0;
                continue;
            };
            let (centre, radius) = (self.places[index].position, self.radii[index]);
            let others = self.places.iter().zip(&self.radii);
            for (distance, (place, other)) in distances.iter_mut().zip(others) {
                let least = 0.5 * SPACING * (radius + other);
                *distance = distance.min(place.position.distance(centre) / least);
            }
            dots.push(dot);
        }
    }

    fn dot(&self, index: usize) -> Option<Marker> {
        let Place {
            position, normal, ..
        } = self.places[index];
        let across = normal.cross(Vector::new(0.3, 0.5, 0.8));
        let joint = self.joints[index];
        self.skin
            .disc(joint, position, normal, across, self.radii[index])
    }

    /// Whether the skin is even and seen within the dot about a place, and moves nearly as one.
    fn is_even(&self, index: usize) -> bool {
        let (place, radius) = (&self.places[index], self.radii[index]);
        if self.covered[index] {
            return false;
        }
        let mut least = vec![f64::INFINITY; place.weights.len()];
        let mut greatest = vec![0.0_f64; least.len()];
        for other in self.near(place.position) {
            let squared = (other.position - place.position).length_squared();
            if squared > (radius + BEYOND).powi(2) {
                continue;
            }
            let facing = other.normal.dot(place.normal);
            let is_within = squared < radius * radius;
            if facing < 0.0 || (is_within && facing < BEND) {
                return false;
            }
            if is_within {
                for (joint, &weight) in other.weights.iter().enumerate() {
                    least[joint] = least[joint].min(weight);
                    greatest[joint] = greatest[joint].max(weight);
                }
            }
        }
        greatest
            .iter()
            .zip(&least)
            .all(|(high, low)| high - low <= DIFFERENCE)
    }

    /// The places in the cell of a position and in those about it.
    fn near(&self, position: Vector) -> impl Iterator<Item = &Place> {
        let [x, y, z] = cell(position, CELL);
        let cells = (0..27).map(move |k| [x + k % 3 - 1, y + k / 3 % 3 - 1, z + k / 9 - 1]);
        let indices = cells.filter_map(|cell| self.cells.get(&cell)).flatten();
        indices.map(|&index| &self.places[index])
    }
}

impl Skin<'_> {
    /// Places spread over a triangle: the middles of equal parts.
    fn spread(&self, triangle: usize) -> Vec<Place> {
        let [a, b, c] = self.triangles[triangle].map(|vertex| self.position(vertex));
        let longest = a.distance(b).max(b.distance(c)).max(c.distance(a));
        let parts = (longest / STEP).ceil().max(1.0) as usize;
        let mut places = Vec::with_capacity(parts * parts);
        for row in 0..parts {
            for column in 0..2 * (parts - row) - 1 {
                // Two corners of each part in the row, and one in the next, or the other way round.
                let shift = if column % 2 == 0 { 1.0 } else { 2.0 } / 3.0;
                let [u, v] = [(column / 2) as f64 + shift, row as f64 + shift];
                let [u, v] = [u, v].map(|share| share / parts as f64);
                places.push(self.within(triangle, [1.0 - u - v, u, v]));
            }
        }
        places
    }

    /// How far it is from a place to other skin in a direction.
    fn clearance(&self, place: &Place, direction: Vector) -> Option<f64> {
        let from = place.position + direction * OFF;
        let ray = Ray::new(Point::from(from.coordinates()), direction.coordinates())?;
        Some(self.surface.first_hit(ray)?.hit.distance)
    }
}
