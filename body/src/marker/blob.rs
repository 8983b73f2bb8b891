//! Connected coloured pixels, and the ellipse with their moments.

use std::collections::HashSet;

use ga_image::plane::Plane;
use ga_numerics::order_statistics::Sorted;

/// Sectors in which the outline of a candidate is compared with an ellipse.
const SECTORS: usize = 12;
/// Candidates with a greater extent in pixels are something else.
const MOST_EXTENT: usize = 400;
/// The pixels so near to coloured ones may be covered in part: pictures are not quite sharp.
const BORDER: usize = 2;
/// Candidates of fewer pixels say nothing about colours.
const LEAST_PIXELS: usize = 6;

/// A connected set of coloured pixels with all pixels near it.
pub(super) struct Blob {
    /// Column and row of each pixel.
    pub(super) pixels: Vec<[usize; 2]>,
    /// The part of each pixel that is covered, 0 to 1.
    coverage: Vec<f64>,
}

/// An ellipse with the moments of a set of pixels.
pub(super) struct Ellipse {
    pub(super) centre: [f64; 2],
    pub(super) semi_axes: [f64; 2],
    /// The inverse of the matrix of second moments as xx, xy, yy.
    inverse: [f64; 3],
}

/// Whether a pixel of linear light is coloured.
pub(super) fn is_coloured([red, green, blue]: [f32; 3], least_saturation: f32) -> bool {
    let most = red.max(green).max(blue);
    let chroma = most - red.min(green).min(blue);
    chroma > least_saturation * most && chroma > NOISE
}

/// How the light falls on a candidate.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Shade {
    /// Evenly: all covered pixels have about the same chroma.
    Even,
    /// On one side more than on the other: the chroma changes linearly.
    Inclined,
}

/// The candidates in a picture of linear light: connected pixels of one class, other than 0. Pixels
/// touch by their edges, so that markers which are a pixel apart are separate.
pub(super) fn blobs(light: &Plane<[f32; 3]>, classes: &Plane<u8>, shade: Shade) -> Vec<Blob> {
    let (width, height) = (light.width(), light.height());
    let mut owner = Plane::filled(width, height, 0u32);
    let mut sets: Vec<Vec<[usize; 2]>> = Vec::new();
    for row in 0..height {
        for column in 0..width {
            if classes.row(row)[column] != 0 && owner.row(row)[column] == 0 {
                let number = sets.len() as u32 + 1;
                sets.push(connected([column, row], classes, &mut owner, number));
            }
        }
    }
    let whole = |set: &&Vec<[usize; 2]>| {
        let fits = |axis: usize, size: usize| {
            let places = set.iter().map(|pixel| pixel[axis]);
            let (low, high) =
                places.fold((usize::MAX, 0), |(low, high), c| (low.min(c), high.max(c)));
            // What the picture cuts off has no centre.
            low > 0 && high + 1 < size && high - low < MOST_EXTENT
        };
        set.len() >= LEAST_PIXELS && fits(0, width) && fits(1, height)
    };
    let sets = sets.iter().filter(whole);
    sets.map(|set| Blob::new(light, set, &owner, shade))
        .collect()
}

/// Less chroma than this in linear light is what rounding to 8 bits leaves of grey.
const NOISE: f32 = 0.01;

/// The pixels of one class that are connected with one, marked with a number.
fn connected(
    start: [usize; 2],
    classes: &Plane<u8>,
    owner: &mut Plane<u32>,
    number: u32,
) -> Vec<[usize; 2]> {
    let mut pixels = vec![start];
    let class = classes.get(start[0], start[1]);
    owner.row_mut(start[1])[start[0]] = number;
    let mut next = 0;
    while let Some(&[column, row]) = pixels.get(next) {
        next += 1;
        let around = [
            [column.wrapping_sub(1), row],
            [column + 1, row],
            [column, row.wrapping_sub(1)],
            [column, row + 1],
        ];
        for pixel in around {
            let [column, row] = pixel;
            if classes.get(column, row) == class && owner.get(column, row) == Some(0) {
                owner.row_mut(row)[column] = number;
                pixels.push(pixel);
            }
        }
    }
    pixels
}

/// A connected set with the pixels that it encloses: where two colours meet whose mixture is grey,
/// pixels are not coloured.
fn filled(set: &[[usize; 2]]) -> Vec<[usize; 2]> {
    let range = |axis: usize| {
        let places = set.iter().map(|pixel| pixel[axis]);
        places.fold((usize::MAX, 0), |(low, high), c| (low.min(c), high.max(c)))
    };
    let ((left, right), (top, bottom)) = (range(0), range(1));
    // A box with a free border around the set; what is connected with its corner is outside.
    let (width, height) = (right - left + 3, bottom - top + 3);
    let mut is_free = Plane::filled(width, height, 1u8);
    for [column, row] in set {
        is_free.row_mut(row - top + 1)[column - left + 1] = 0;
    }
    let mut owner = Plane::filled(width, height, 0u32);
    connected([0, 0], &is_free, &mut owner, 1);
    let inside = (0..height).flat_map(|row| (0..width).map(move |column| [column, row]));
    inside
        .filter(|&[column, row]| owner.row(row)[column] == 0)
        .map(|[column, row]| [column + left - 1, row + top - 1])
        .collect()
}

impl Blob {
    /// A set of coloured pixels without its holes, and all pixels near it that belong to no other
    /// set.
    fn new(light: &Plane<[f32; 3]>, set: &[[usize; 2]], owner: &Plane<u32>, shade: Shade) -> Self {
        let around = |[column, row]: [usize; 2], reach: usize| {
            let rows = row.saturating_sub(reach)..=row + reach;
            let columns = column.saturating_sub(reach)..=column + reach;
            rows.flat_map(move |row| columns.clone().map(move |column| [column, row]))
        };
        let set = &filled(set);
        let own: HashSet<[usize; 2]> = set.iter().copied().collect();
        let is_own = |pixel: [usize; 2]| own.contains(&pixel);
        let mut pixels: Vec<[usize; 2]> = set.to_vec();
        for pixel in set {
            let near = around(*pixel, BORDER);
            let free = near.filter(|&[column, row]| owner.get(column, row) == Some(0));
            pixels.extend(free.filter(|&pixel| !is_own(pixel)));
        }
        pixels[set.len()..].sort_unstable_by_key(|&[column, row]| [row, column]);
        pixels.dedup();

        let chroma = |[column, row]: [usize; 2]| {
            let [red, green, blue] = light.row(row)[column];
            f64::from(red.max(green).max(blue) - red.min(green).min(blue))
        };
        // The chroma of a pixel that is covered whole: that of most, but for those on the edge
        // between the colours, where it is less.
        let mut chromas: Vec<f64> = set.iter().map(|&pixel| chroma(pixel)).collect();
        let full = Sorted::new(&mut chromas).map_or(0.0, |chromas| chromas.quantile(0.8));
        let is_inside = |pixel: [usize; 2]| around(pixel, 1).all(is_own);
        let full = match shade {
            Shade::Even => Incline::even(full),
            Shade::Inclined => {
                let inside = pixels.iter().filter(|&&pixel| is_inside(pixel));
                Incline::of(inside.map(|&pixel| (pixel, chroma(pixel))), full)
            }
        };
        let coverage = pixels.iter().map(|&pixel| {
            // Inside, where no grey is near, the colours of the marker are mixed with each other.
            if is_inside(pixel) {
                1.0
            } else {
                (chroma(pixel) / full.at(pixel)).min(1.0)
            }
        });
        let coverage = coverage.collect();
        Self { pixels, coverage }
    }

    /// The mean light of the pixels, each as far as it is covered.
    pub(super) fn mean_light(&self, light: &Plane<[f32; 3]>) -> [f64; 3] {
        let mut sum = [0.0; 3];
        for (&[column, row], coverage) in self.pixels.iter().zip(&self.coverage) {
            for (sum, channel) in sum.iter_mut().zip(light.row(row)[column]) {
                *sum += coverage * f64::from(channel);
            }
        }
        let total: f64 = self.coverage.iter().sum();
        sum.map(|sum| sum / total)
    }

    /// The mean distance of the outline from an ellipse in pixels, over the [`SECTORS`] of equal
    /// area of the ellipse. In each, the sum of the differences of the covered parts of all pixels
    /// from those that the ellipse covers, divided by the length of the outline, is how far it lies
    /// outside, whether it is sharp or not. The ellipse covers ½ − s of a pixel at the distance s
    /// outside, from 0 to 1.
    pub(super) fn outline_error(&self, ellipse: &Ellipse) -> f64 {
        let mut sums = [0.0; SECTORS];
        for (pixel, coverage) in self.pixels.iter().zip(&self.coverage) {
            let place = pixel.map(|c| c as f64);
            let [x, y] = ellipse.on_unit_circle(place);
            let part = y.atan2(x) / std::f64::consts::TAU + 0.5;
            let sector = ((part * SECTORS as f64) as usize).min(SECTORS - 1);
            sums[sector] += coverage - (0.5 - ellipse.distance(place)).clamp(0.0, 1.0);
        }
        let [greater, smaller] = ellipse.semi_axes;
        let total: f64 = sums.iter().map(|sum| sum.abs()).sum();
        total / (std::f64::consts::PI * (greater + smaller))
    }

    /// The ellipse with the moments of the pixels but for the same variance in all directions, by
    /// which the extent of pixels and blur enlarge them: its area is the covered one. `None` where
    /// the pixels lie on a line.
    pub(super) fn ellipse(&self) -> Option<Ellipse> {
        let pixels = || {
            let pixels = self.pixels.iter().zip(&self.coverage);
            pixels.map(|(&[column, row], &coverage)| ([column as f64, row as f64], coverage))
        };
        let area: f64 = self.coverage.iter().sum();
        let mean = |axis: usize| pixels().map(|(at, w)| w * at[axis]).sum::<f64>() / area;
        let centre = [mean(0), mean(1)];
        let moment = |a: usize, b: usize| {
            let products = pixels().map(|(at, w)| w * (at[a] - centre[a]) * (at[b] - centre[b]));
            products.sum::<f64>() / area
        };
        let [xx, xy, yy] = [moment(0, 0), moment(0, 1), moment(1, 1)];
        // With a variance b less, the area 4π √((xx − b)(yy − b) − xy²) is to be the covered one.
        let half = (0.5 * (xx - yy)).hypot(xy);
        let middle = half.hypot(area / (4.0 * std::f64::consts::PI));
        let blur = 0.5 * (xx + yy) - middle;
        let [xx, yy] = [xx - blur, yy - blur];
        let determinant = xx * yy - xy * xy;
        if !(xx > 0.0 && yy > 0.0 && determinant > 0.0) {
            return None;
        }
        Some(Ellipse {
            centre,
            semi_axes: [middle + half, middle - half].map(|variance| 2.0 * variance.sqrt()),
            inverse: [yy / determinant, -xy / determinant, xx / determinant],
        })
    }
}

/// A linear function of the pixel.
struct Incline {
    origin: [f64; 2],
    value: f64,
    slope: [f64; 2],
    /// It is nowhere less.
    least: f64,
}

impl Incline {
    fn even(value: f64) -> Self {
        Self {
            origin: [0.0; 2],
            value,
            slope: [0.0; 2],
            least: value,
        }
    }

    /// The function with the least squared differences from values at pixels; constant where they
    /// do not determine it.
    fn of(values: impl Iterator<Item = ([usize; 2], f64)>, otherwise: f64) -> Self {
        let values: Vec<([f64; 2], f64)> = values
            .map(|(pixel, value)| (pixel.map(|c| c as f64), value))
            .collect();
        let count = values.len() as f64;
        type Part<'a> = &'a dyn Fn(&([f64; 2], f64)) -> f64;
        let mean = |part: Part<'_>| values.iter().map(part).sum::<f64>() / count;
        let origin = [mean(&|(at, _)| at[0]), mean(&|(at, _)| at[1])];
        let value = mean(&|(_, value)| *value);
        let product =
            |a: usize, b: usize| mean(&|(at, _)| (at[a] - origin[a]) * (at[b] - origin[b]));
        let [xx, xy, yy] = [product(0, 0), product(0, 1), product(1, 1)];
        let [x, y] = [0, 1].map(|k| mean(&|(at, v)| (at[k] - origin[k]) * (v - value)));
        let determinant = xx * yy - xy * xy;
        if !(values.len() >= FEWEST_OF_INCLINE && determinant > LEAST_SPREAD && value > 0.0) {
            return Self::even(otherwise);
        }
        Self {
            origin,
            value,
            slope: [
                (yy * x - xy * y) / determinant,
                (xx * y - xy * x) / determinant,
            ],
            least: 0.25 * value,
        }
    }

    fn at(&self, pixel: [usize; 2]) -> f64 {
        let [x, y] = [0, 1].map(|k| pixel[k] as f64 - self.origin[k]);
        (self.value + self.slope[0] * x + self.slope[1] * y).max(self.least)
    }
}

/// A linear function is fitted to no fewer values.
const FEWEST_OF_INCLINE: usize = 6;
/// The least determinant of the second moments of their pixels.
const LEAST_SPREAD: f64 = 0.1;

impl Ellipse {
    /// The place after a linear map that takes the ellipse to a circle of radius 1: the factor of
    /// Cholesky of the inverse moments, halved.
    fn on_unit_circle(&self, place: [f64; 2]) -> [f64; 2] {
        let [x, y] = [place[0] - self.centre[0], place[1] - self.centre[1]];
        let [xx, xy, yy] = self.inverse;
        let first = xx.sqrt();
        let below = xy / first;
        let second = (yy - below * below).max(0.0).sqrt();
        [0.5 * (first * x + below * y), 0.5 * second * y]
    }

    /// How far a place is from the centre, 1 on the ellipse.
    pub(super) fn radius(&self, place: [f64; 2]) -> f64 {
        let [x, y] = self.on_unit_circle(place);
        x.hypot(y)
    }

    /// About how far outside the ellipse a place near it is, in pixels: the radius less 1, divided
    /// by its gradient.
    fn distance(&self, place: [f64; 2]) -> f64 {
        let [x, y] = [place[0] - self.centre[0], place[1] - self.centre[1]];
        let [xx, xy, yy] = self.inverse;
        let radius = self.radius(place);
        let gradient = 0.25 * (xx * x + xy * y).hypot(xy * x + yy * y) / radius;
        if radius > 0.0 {
            (radius - 1.0) / gradient
        } else {
            f64::NEG_INFINITY
        }
    }
}
