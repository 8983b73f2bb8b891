//! Small dots all over the skin.

use ga_mesh::normals::vertex_normals;

use super::{Marker, Skin};
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
/// The radius on the trunk and the thighs.
const GREATEST: f64 = 0.0150;
/// The least distance between centres in radii: seen from the side, dots are still apart.
const SPACING: f64 = 3.5;
/// Cosine of the greatest angle between the normal at the centre and others of a dot.
const BEND: f64 = 0.6;
/// The greatest difference of a joint's weights within a dot.
const DIFFERENCE: f64 = 0.5;
/// What is nearer than this beyond the rim, in metres, must not be the other side of the body.
const BEYOND: f64 = 0.004;

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
        let Some(sampling) = Sampling::new(self) else {
            return Vec::new();
        };
        let mut dots = sampling.dots();
        let mut counts = vec![0; self.skeleton.len()];
        for dot in &mut dots {
            let name = &self.skeleton.joints()[dot.joint].name;
            dot.name = format!("{name} {}", counts[dot.joint]);
            counts[dot.joint] += 1;
        }
        dots
    }
}

/// The vertices as places of dots.
struct Sampling<'a> {
    skin: Skin<'a>,
    positions: Vec<Vector>,
    normals: Vec<Vector>,
    /// For each vertex the joint of its greatest weight.
    joints: Vec<usize>,
    /// The radius of a dot at each vertex.
    radii: Vec<f64>,
}

impl<'a> Sampling<'a> {
    fn new(human: &'a Human) -> Option<Self> {
        let skin = Skin::new(human)?;
        let coordinates: Vec<[f64; 3]> = human.mesh.coordinates().collect();
        let normals = vertex_normals(&coordinates, &skin.triangles);
        let joints = (0..coordinates.len()).map(|vertex| {
            let influences = human.weights.influences(vertex).iter();
            let strongest = influences.max_by(|a, b| a.weight.total_cmp(&b.weight));
            strongest.map_or(0, |influence| influence.joint as usize)
        });
        let joints: Vec<usize> = joints.collect();
        let of_joint = human.skeleton.joints().iter().map(|joint| {
            let found = RADII.iter().find(|(end, _)| joint.name.ends_with(end));
            found.map_or(GREATEST, |(_, radius)| *radius)
        });
        let of_joint: Vec<f64> = of_joint.collect();
        Some(Self {
            radii: joints.iter().map(|&joint| of_joint[joint]).collect(),
            positions: coordinates.into_iter().map(Vector::from).collect(),
            normals: normals.into_iter().map(Vector::from).collect(),
            joints,
            skin,
        })
    }

    fn dots(&self) -> Vec<Marker> {
        let mut dots: Vec<Marker> = Vec::new();
        // The distance of each vertex to the nearest dot as a multiple of the least one.
        let mut distances = vec![f64::INFINITY; self.positions.len()];
        loop {
            let farthest =
                (0..distances.len()).max_by(|a, b| distances[*a].total_cmp(&distances[*b]));
            let Some(vertex) = farthest.filter(|vertex| distances[*vertex] >= 1.0) else {
                return dots;
            };
            let dot = self.is_even(vertex).then(|| self.dot(vertex)).flatten();
            let Some(dot) = dot else {
                distances[vertex] = 0.0;
                continue;
            };
            let (centre, radius) = (self.positions[vertex], self.radii[vertex]);
            for (distance, (place, other)) in distances
                .iter_mut()
                .zip(self.positions.iter().zip(&self.radii))
            {
                let least = 0.5 * SPACING * (radius + other);
                *distance = distance.min(place.distance(centre) / least);
            }
            dots.push(dot);
        }
    }

    fn dot(&self, vertex: usize) -> Option<Marker> {
        let normal = self.normals[vertex];
        let across = normal.cross(Vector::new(0.3, 0.5, 0.8));
        let (centre, radius) = (self.positions[vertex], self.radii[vertex]);
        self.skin
            .disc(self.joints[vertex], centre, normal, across, radius)
    }

    /// Whether the skin is even within the dot about a vertex, and moves nearly as one.
    fn is_even(&self, vertex: usize) -> bool {
        let (centre, normal, radius) = (
            self.positions[vertex],
            self.normals[vertex],
            self.radii[vertex],
        );
        let mut least = vec![f64::INFINITY; self.skin.human.skeleton.len()];
        let mut greatest = vec![0.0_f64; least.len()];
        for (other, place) in self.positions.iter().enumerate() {
            let squared = (*place - centre).length_squared();
            if squared > (radius + BEYOND).powi(2) {
                continue;
            }
            let facing = self.normals[other].dot(normal);
            let is_within = squared < radius * radius;
            if facing < 0.0 || (is_within && facing < BEND) {
                return false;
            }
            if is_within {
                let mut weights = vec![0.0; least.len()];
                for influence in self.skin.human.weights.influences(other) {
                    weights[influence.joint as usize] = influence.weight;
                }
                for (joint, weight) in weights.into_iter().enumerate() {
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
}
