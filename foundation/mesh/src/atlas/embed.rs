//! An image of a disc that never folds, to begin from: Tutte's embedding.

use super::chart::{Chart, Flat};
use super::surface::NONE;

/// Steps of the conjugate gradients at most.
const STEPS: usize = 2000;

/// The embedding of a chart into a disc: the longest boundary curve becomes the circle, and every
/// other vertex is the mean of its neighbours (Tutte 1963, *How to draw a graph*). A hole is filled
/// by one more vertex that is joined to all of its boundary.
///
/// `None` when the chart is not a disc with holes, or when rounding made a triangle fold.
pub(super) fn embed(chart: &Chart) -> Option<Vec<Flat>> {
    let loops = chart.loops();
    let outer = loops.first()?;
    let holes = &loops[1..];
    let sides = chart.across.len();
    let at_boundary = chart.across.iter().filter(|&&other| other == NONE).count();
    let edges = (sides + at_boundary) / 2;
    let euler = chart.positions.len() as i64 - edges as i64 + chart.triangles.len() as i64;
    if euler + holes.len() as i64 != 1 {
        return None;
    }

    let total: f64 = outer.iter().map(|&side| chart.length(side)).sum();
    let area: f64 = chart.distortion_free_area();
    let radius = (area / std::f64::consts::PI).sqrt();
    let count = chart.positions.len() + holes.len();
    let mut image = vec![[0.0; 2]; count];
    let mut is_fixed = vec![false; count];
    let mut along = 0.0;
    for &side in outer {
        let vertex = chart.side(side)[0] as usize;
        let (sine, cosine) = (std::f64::consts::TAU * along / total).sin_cos();
        image[vertex] = [radius * cosine, radius * sine];
        is_fixed[vertex] = true;
        along += chart.length(side);
    }

    let mut links: Vec<[u32; 2]> = Vec::with_capacity(edges);
    for side in 0..sides as u32 {
        let other = chart.across[side as usize];
        if other == NONE || side < other {
            links.push(chart.side(side));
        }
    }
    for (hole, sides) in holes.iter().enumerate() {
        let centre = (chart.positions.len() + hole) as u32;
        links.extend(sides.iter().map(|&side| [chart.side(side)[0], centre]));
    }
    relax(&links, &is_fixed, &mut image);
    image.truncate(chart.positions.len());
    (chart.distortion(&image).least > 0.0).then_some(image)
}

impl Chart {
    fn distortion_free_area(&self) -> f64 {
        let area = |face| {
            let [a, b, c] = self.corners(face);
            0.5 * (b - a).cross(c - a).length()
        };
        (0..self.faces.len()).map(area).sum()
    }
}

/// Moves the vertices that are not fixed to the mean of their neighbours, by conjugate gradients
/// with the diagonal as preconditioner.
fn relax(links: &[[u32; 2]], is_fixed: &[bool], image: &mut [Flat]) {
    let mut degree = vec![0.0; image.len()];
    for link in links {
        for &vertex in link {
            degree[vertex as usize] += 1.0;
        }
    }
    // The Laplacian of the links, and nothing at fixed vertices.
    let apply = |x: &[Flat], out: &mut [Flat]| {
        for (vertex, out) in out.iter_mut().enumerate() {
            *out = x[vertex].map(|x| x * degree[vertex]);
        }
        for &[a, b] in links {
            let (a, b) = (a as usize, b as usize);
            for axis in 0..2 {
                out[a][axis] -= x[b][axis];
                out[b][axis] -= x[a][axis];
            }
        }
        for (out, _) in out.iter_mut().zip(is_fixed).filter(|(_, fixed)| **fixed) {
            *out = [0.0; 2];
        }
    };
    let dot = |a: &[Flat], b: &[Flat]| -> f64 {
        a.iter()
            .zip(b)
            .map(|(a, b)| a[0] * b[0] + a[1] * b[1])
            .sum()
    };
    let mut residual = vec![[0.0; 2]; image.len()];
    apply(image, &mut residual);
    for residual in &mut residual {
        *residual = residual.map(|x| -x);
    }
    let precondition = |residual: &[Flat]| -> Vec<Flat> {
        let pairs = residual.iter().zip(&degree);
        pairs.map(|(r, d)| r.map(|r| r / d.max(1.0))).collect()
    };
    let mut direction = precondition(&residual);
    let mut measure = dot(&residual, &direction);
    let enough = measure * 1e-24;
    let mut product = vec![[0.0; 2]; image.len()];
    for _ in 0..STEPS {
        if measure <= enough || measure == 0.0 {
            break;
        }
        apply(&direction, &mut product);
        let step = measure / dot(&direction, &product);
        for vertex in 0..image.len() {
            for axis in 0..2 {
                image[vertex][axis] += step * direction[vertex][axis];
                residual[vertex][axis] -= step * product[vertex][axis];
            }
        }
        let conditioned = precondition(&residual);
        let before = std::mem::replace(&mut measure, dot(&residual, &conditioned));
        let share = measure / before;
        for (direction, conditioned) in direction.iter_mut().zip(&conditioned) {
            for axis in 0..2 {
                direction[axis] = conditioned[axis] + share * direction[axis];
            }
        }
    }
}
