//! From charts to flat images, with cuts where a chart has none.

use super::Vector;
use super::chart::{Chart, Distortion, Flat};
use super::grow::Heap;
use super::surface::{NONE, Surface};
use super::{embed, overlap, relax};

/// The greatest L2 stretch of a chart that is projected.
const PROJECTED: f64 = 1.09;

/// The least cosine of the angle between the normal of a face and the direction in which its chart
/// is projected: below it, the image is made by relaxation.
const STEEPEST: f64 = 0.3;

/// A chart with its image.
#[derive(Clone)]
pub(super) struct Flattened {
    pub(super) chart: Chart,
    pub(super) image: Vec<Flat>,
    pub(super) distortion: Distortion,
}

/// Flattens these faces, which are connected, as one chart, or as more where one has no image of
/// L2 stretch up to `stretch` that covers no place twice.
pub(super) fn flatten(surface: &Surface, faces: Vec<u32>, stretch: f64) -> Vec<Flattened> {
    let mut open = vec![faces];
    let mut done = Vec::new();
    while let Some(faces) = open.pop() {
        match whole(surface, faces, stretch) {
            Ok(flattened) => done.push(flattened),
            Err((chart, ends)) => open.extend(split(surface, &chart, ends)),
        }
    }
    done
}

/// Flattens these faces as one chart; otherwise the chart, and two of its faces between which it
/// should be cut.
pub(super) fn whole(
    surface: &Surface,
    faces: Vec<u32>,
    stretch: f64,
) -> Result<Flattened, (Chart, [u32; 2])> {
    let chart = Chart::new(surface, faces);
    let mut crossing = None;
    let mut begin = None;
    if let Some((image, least)) = projection(surface, &chart) {
        let distortion = chart.distortion(&image);
        if least >= STEEPEST && distortion.stretch() <= PROJECTED {
            crossing = overlap::crossing(&chart, &image);
            if crossing.is_none() {
                return Ok(Flattened {
                    chart,
                    image,
                    distortion,
                });
            }
        } else if distortion.least > 0.0 {
            begin = Some(image);
        }
    }
    if crossing.is_none()
        && let Some(mut image) = begin.or_else(|| embed::embed(&chart))
    {
        relax::relax(&chart, &mut image);
        let distortion = chart.distortion(&image);
        if distortion.least > 0.0 && distortion.stretch() <= stretch {
            crossing = overlap::crossing(&chart, &image);
            if crossing.is_none() {
                return Ok(Flattened {
                    chart,
                    image,
                    distortion,
                });
            }
        }
    }
    let ends = crossing.unwrap_or_else(|| far_apart(surface, &chart));
    Err((chart, ends))
}

/// The image along the mean normal, and the least cosine of a normal with it; `None` where a face
/// would be folded.
fn projection(surface: &Surface, chart: &Chart) -> Option<(Vec<Flat>, f64)> {
    let normal = |face: u32| surface.normals[face as usize];
    let mut sum = Vector::default();
    for &face in &chart.faces {
        sum += normal(face) * surface.areas[face as usize];
    }
    let axis = sum.normalized()?;
    let cosines = chart.faces.iter().map(|&face| normal(face).dot(axis));
    let least = cosines.fold(f64::INFINITY, f64::min);
    if least < 0.02 {
        return None;
    }
    let [right, up] = axis.orthonormal_pair();
    let flat = |position: &Vector| [position.dot(right), position.dot(up)];
    Some((chart.positions.iter().map(flat).collect(), least))
}

/// Two faces of a chart that are far from each other.
pub(super) fn far_apart(surface: &Surface, chart: &Chart) -> [u32; 2] {
    let mut ends = [0; 2];
    for _ in 0..2 {
        let distances = distances(surface, chart, &[ends[0]]);
        let farthest = (0..chart.faces.len() as u32).max_by(|&a, &b| {
            let distance = |face: u32| distances[face as usize].0;
            distance(a).total_cmp(&distance(b)).then(b.cmp(&a))
        });
        ends = [farthest.unwrap_or(0), ends[0]];
    }
    ends
}

/// Cuts a chart between two of its faces: each face goes to the nearer one.
pub(super) fn split(surface: &Surface, chart: &Chart, ends: [u32; 2]) -> [Vec<u32>; 2] {
    let nearest = distances(surface, chart, &ends);
    let mut halves = [Vec::new(), Vec::new()];
    for (&face, (_, end)) in chart.faces.iter().zip(nearest) {
        halves[end as usize].push(face);
    }
    halves
}

/// For each face of a chart, the distance to the nearest of some seeds through the chart, and which
/// one it is.
fn distances(surface: &Surface, chart: &Chart, seeds: &[u32]) -> Vec<(f32, u32)> {
    let mut found = vec![(f32::INFINITY, NONE); chart.faces.len()];
    let mut heap = Heap::default();
    for (index, &seed) in seeds.iter().enumerate() {
        heap.push(0.0, seed, index as u32);
    }
    let centre = |face: u32| surface.centres[chart.faces[face as usize] as usize];
    while let Some((distance, face, seed)) = heap.pop() {
        if found[face as usize].1 != NONE {
            continue;
        }
        found[face as usize] = (distance, seed);
        for side in 3 * face..3 * face + 3 {
            let other = chart.across[side as usize];
            if other != NONE && found[other as usize / 3].1 == NONE {
                let step = centre(face).distance(centre(other / 3));
                heap.push(distance + step as f32, other / 3, seed);
            }
        }
    }
    found
}
