//! The data from which the script draws a model.

use base64::Engine;
use base64::prelude::BASE64_STANDARD;
use serde::Serialize;

use super::parts::Parts;
use super::scale::Numbers;
use super::sight::Sight;
use super::view::ModelView;

/// The data of a model. Lists of numbers are written as base64 of their bytes, the lowest of each
/// number first.
#[derive(Debug, Serialize)]
pub(super) struct Data {
    /// Frames per second.
    rate: f64,
    /// The number of frames.
    pub(super) frames: usize,
    /// What is at the same place in all frames is one point. Its coordinates in each frame, one
    /// frame after the other.
    points: Numbers,
    /// The index of its point for each vertex; none where these are the same. A point has several
    /// vertices where seams of the texture and steps of colour meet.
    sources: Option<String>,
    /// The indices of the vertices of each triangle.
    triangles: String,
    /// Whether indices have 32 bits; they have 16 otherwise.
    wide: bool,
    /// Texture coordinates of the vertices, with v down.
    coordinates: Option<Numbers>,
    /// The address of the texture's picture.
    picture: Option<String>,
    /// Red, green and blue of each vertex, with 8 bits each.
    colours: Option<String>,
    /// What the camera looks at in each frame, or in all.
    centres: Vec<[f32; 3]>,
    /// The radius about these that contains the model in each frame, which is the unit of the
    /// camera.
    radius: f64,
    /// The distance from the vertical line through them within which the model is, in radii.
    across: f64,
    floor: Option<f64>,
    /// The side of a square of the floor's grid.
    pub(super) square: f64,
    azimuth: f64,
    elevation: f64,
}

impl Data {
    /// The data of a model that has been checked.
    pub(super) fn of(model: &ModelView) -> Self {
        let parts = Parts::of(model);
        let wide = parts.vertices.len() > 1 << 16;
        let indices = |numbers: &mut dyn Iterator<Item = u32>| {
            let bytes: Vec<u8> = if wide {
                numbers.flat_map(u32::to_le_bytes).collect()
            } else {
                numbers
                    .flat_map(|number| (number as u16).to_le_bytes())
                    .collect()
            };
            BASE64_STANDARD.encode(bytes)
        };
        let seams = parts.vertices.len() > parts.points.len();
        let coordinates = parts.texture_scale.map(|scale| {
            let numbers = parts
                .vertices
                .iter()
                .filter_map(|vertex| vertex.coordinates);
            scale.encode(numbers)
        });
        let colours = model.colours.as_ref().map(|_| {
            let colours = parts.vertices.iter().filter_map(|vertex| vertex.colour);
            BASE64_STANDARD.encode(colours.flatten().collect::<Vec<u8>>())
        });
        let points = parts.scale.encode(
            (0..model.frames.len())
                .flat_map(|frame| parts.points.iter().map(move |point| point[frame])),
        );
        let Sight {
            centres,
            radius,
            across,
        } = Sight::of(model);
        Self {
            rate: model.frames_per_second,
            frames: model.frames.len(),
            points,
            sources: seams.then(|| indices(&mut parts.vertices.iter().map(|vertex| vertex.point))),
            triangles: indices(&mut parts.triangles.iter().flatten().copied()),
            wide,
            coordinates,
            picture: model
                .texture
                .as_ref()
                .map(|texture| texture.encoding.address(&texture.bytes)),
            colours,
            centres: centres
                .iter()
                .map(|place| place.map(|x| x as f32))
                .collect(),
            radius,
            across: across / radius,
            floor: model.floor,
            square: square(radius),
            azimuth: model.turn[0] % 360.0,
            elevation: model.turn[1].clamp(-90.0, 90.0),
        }
    }
}

/// The greatest of 1, 2, 5, 10, … and 0.5, 0.2, 0.1, … metres that is at most 0.6 radii.
fn square(radius: f64) -> f64 {
    let most = 0.6 * radius;
    let mut power = 0;
    let of = |digit: f64, power: i32| {
        // Powers of ten with positive exponents are exact, so that 0.1 is written as such.
        if power < 0 {
            digit / 10_f64.powi(-power)
        } else {
            digit * 10_f64.powi(power)
        }
    };
    while of(1.0, power) > most {
        power -= 1;
    }
    while of(10.0, power) <= most {
        power += 1;
    }
    let digits = [5.0, 2.0]
        .into_iter()
        .find(|&digit| of(digit, power) <= most);
    of(digits.unwrap_or(1.0), power)
}
