//! How much light from all around reaches what is seen, judged by the depths of the picture.
//!
//! After Mittring 2007, *Finding next gen: CryEngine 2*, with points spread over the hemisphere of
//! the normal: a point above a surface is taken to be blocked where something lies in front of it
//! in the picture, unless that is too near to the eye to be a neighbour. Points are denser towards
//! the normal, as the cosine law of diffuse light asks, and all distances up to the radius are
//! alike, so that a blocker counts the less the farther it is. The share of free points is the
//! light.

use ga_image::plane::Plane;
use rayon::prelude::*;

use crate::Vector;
use crate::lens::Lens;
use crate::surface::Samples;
use crate::world::World;

/// The distance of the farthest points, as a share of the diagonal of the objects' bounding box.
const RADIUS: f64 = 0.06;

/// Points for each pixel; sixteen neighbouring pixels have different ones, and share them.
const POINTS: usize = 12;

/// The side of the square of pixels that share their points.
const TILE: usize = 4;

/// What is seen in a pixel: its place in the camera's frame and its unit normal there.
#[derive(Clone, Copy)]
struct Seen {
    place: Vector,
    normal: Vector,
}

/// The share of light from all around that reaches each pixel's surface, 0 to 1. `factor` is the
/// number of samples along each side of a pixel.
pub(crate) fn reaching(world: &World, samples: &Samples, factor: usize) -> Plane {
    let (width, height) = (samples.width / factor, samples.height / factor);
    let lens = samples.lens.scaled(1.0 / factor as f64);
    let radius = RADIUS * world.extent();
    let seen: Vec<Option<Seen>> = (0..width * height)
        .into_par_iter()
        .map(|index| seen(world, samples, factor, index % width, index / width))
        .collect();
    let points = points(radius);
    let field = Field {
        seen: &seen,
        width,
        height,
        lens,
        radius,
    };
    let raw: Vec<f32> = (0..width * height)
        .into_par_iter()
        .map(|index| field.reaching(index, &points))
        .collect();
    let mut plane = Plane::filled(width, height, 1.0);
    plane
        .values_mut()
        .par_iter_mut()
        .enumerate()
        .for_each(|(index, value)| *value = field.shared(index, &raw));
    plane
}

struct Field<'a> {
    seen: &'a [Option<Seen>],
    width: usize,
    height: usize,
    lens: Lens,
    radius: f64,
}

impl Field<'_> {
    fn reaching(&self, index: usize, points: &[[Vector; POINTS]; TILE * TILE]) -> f32 {
        let Some(Seen { place, normal }) = self.seen[index] else {
            return 1.0;
        };
        let [across, along] = normal.orthonormal_pair();
        let (column, row) = (index % self.width, index / self.width);
        let tile = (row % TILE) * TILE + column % TILE;
        let mut blocked = 0;
        for point in &points[tile] {
            let point = place + across * point.e1 + along * point.e2 + normal * point.e3;
            if point.e3 <= 0.0 {
                continue;
            }
            let [x, y] = self.lens.project([point.e1, point.e2], 1.0 / point.e3);
            let inside = x >= 0.0 && y >= 0.0 && x < self.width as f64 && y < self.height as f64;
            if !inside {
                continue;
            }
            let there = self.seen[y as usize * self.width + x as usize];
            let in_front = there.is_some_and(|there| {
                let depth = there.place.e3;
                depth < point.e3 && place.e3 - depth < self.radius
            });
            blocked += u32::from(in_front);
        }
        1.0 - blocked as f32 / POINTS as f32
    }

    /// The mean over the pixels around that show the same surface.
    fn shared(&self, index: usize, raw: &[f32]) -> f32 {
        let Some(here) = self.seen[index] else {
            return 1.0;
        };
        let (column, row) = (index % self.width, index / self.width);
        let (mut sum, mut count) = (0.0, 0.0f32);
        let around = |middle: usize, size: usize| {
            middle.saturating_sub(TILE / 2)..(middle + TILE / 2).min(size)
        };
        for j in around(row, self.height) {
            for i in around(column, self.width) {
                let other = j * self.width + i;
                let Some(there) = self.seen[other] else {
                    continue;
                };
                if (there.place - here.place).dot(here.normal).abs() < 0.25 * self.radius {
                    sum += raw[other];
                    count += 1.0;
                }
            }
        }
        sum / count.max(1.0)
    }
}

/// The nearest surface in a pixel.
fn seen(
    world: &World,
    samples: &Samples,
    factor: usize,
    column: usize,
    row: usize,
) -> Option<Seen> {
    let (mut nearest, mut at) = (0.0, [0, 0]);
    for j in row * factor..(row + 1) * factor {
        for i in column * factor..(column + 1) * factor {
            let inverse = samples.inverse_depth[j * samples.width + i];
            if inverse > nearest {
                (nearest, at) = (inverse, [i, j]);
            }
        }
    }
    if nearest == 0.0 {
        return None;
    }
    let ray = samples.lens.ray(at[0] as f64 + 0.5, at[1] as f64 + 0.5);
    let triangle = samples.triangle[at[1] * samples.width + at[0]];
    let [a, b, c] = world.face(triangle).in_frame();
    let normal = (b - a).cross(c - a).normalized()?;
    Some(Seen {
        place: ray * (1.0 / f64::from(nearest)),
        normal: if normal.dot(ray) > 0.0 {
            -normal
        } else {
            normal
        },
    })
}

/// Points over the hemisphere around the third axis, rotated differently for each pixel of a tile.
fn points(radius: f64) -> [[Vector; POINTS]; TILE * TILE] {
    // Steps of these fractions of the unit interval, of the golden ratio and of the plane's
    // analogue of it, spread any number of directions and distances evenly.
    const AROUND: f64 = 0.618_033_988_749_895;
    const ALONG: f64 = 0.569_840_290_998_053_2;
    let share = |index: usize| index as f64 / (TILE * TILE) as f64;
    std::array::from_fn(|pixel| {
        // Steps of 7 and of 11 visit all sixteen and keep neighbours apart.
        let rotation = share((pixel * 7) % (TILE * TILE));
        let displacement = share((pixel * 11) % (TILE * TILE)) + share(1) / 2.0;
        std::array::from_fn(|i| {
            let part = (i as f64 + 0.5) / POINTS as f64;
            let around = std::f64::consts::TAU * (i as f64 * AROUND + rotation);
            let distance = radius * (i as f64 * ALONG + displacement).fract();
            let (sine, cosine) = (part.sqrt(), (1.0 - part).sqrt());
            Vector::new(around.cos() * sine, around.sin() * sine, cosine) * distance
        })
    })
}
