//! Markers on the skin, by which cameras find the body: discs round the bones, and dots all over,
//! also those of other bodies.

mod discs;
mod dots;
mod grid;
mod layout;
mod marker;
mod skin;

use std::collections::HashMap;

use ga_image::plane::Plane;

use crate::{Human, Vector};
use grid::cell;
use layout::LAYOUT;
use skin::Skin;

pub use discs::{DISC_LIFT, with_discs};
pub use dots::dots_on;
pub use marker::Marker;

/// The radius of the inner disc as a part of the marker's.
const INNER: f64 = 0.55;

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
        let Some(skin) = Skin::new(&self.mesh, &self.skeleton, &self.weights) else {
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
        // The markers that reach into each cell of a grid, at most eight cells each.
        let reaches = painted.iter().map(|(_, radius, _)| radius + softness);
        let edge = 2.0 * reaches.fold(0.0, f64::max);
        let mut cells: HashMap<[i64; 3], Vec<usize>> = HashMap::new();
        for (index, (centre, radius, _)) in painted.iter().enumerate() {
            let reach = Vector::from([radius + softness; 3]);
            let [low, high] = [cell(*centre - reach, edge), cell(*centre + reach, edge)];
            for x in low[0]..=high[0] {
                for y in low[1]..=high[1] {
                    for z in low[2]..=high[2] {
                        cells.entry([x, y, z]).or_default().push(index);
                    }
                }
            }
        }
        let encoder = ga_image::colour::SrgbEncoder::new();
        self.painted(size, |point, cloth| {
            let markers = cells.get(&cell(point, edge)).into_iter().flatten();
            let near = markers
                .map(|&index| &painted[index])
                .find(|(centre, radius, _)| {
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
