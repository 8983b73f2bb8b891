//! Texels that no view sees well, filled from their neighbours on the surface.

use super::blend::{Blend, NONE};
use super::covered::Covered;
use super::target::{Seam, Target};
use super::weight::Grade;
use ga_numerics::conjugate_gradient::{self, Options};

/// How strongly a texel at the edge of what is seen keeps its colour, compared with the difference
/// from one neighbour: it gives way to better ones within about ten texels.
const HOLD: f64 = 0.01;

/// The membrane is solved until its residual is a thousandth of what it was at first.
const SOLVER: Options = Options {
    steps: 400,
    relative_tolerance: 1e-3,
    absolute_tolerance: 1e-6,
};

/// Texels that are not seen well, as a graph.
struct Holes {
    /// Their numbers.
    texels: Vec<u32>,
    /// Where in `neighbours` those of each begin, and the end of the last.
    offsets: Vec<u32>,
    /// Numbers of texels.
    neighbours: Vec<u32>,
    /// How strongly each keeps its colour.
    hold: Vec<f64>,
    /// For each texel of the surface its number among the holes, or `u32::MAX`.
    number: Vec<u32>,
}

/// Fills the texels that no view sees well with the smoothest colours between those around them:
/// the colours x that minimise
///
/// ```text
/// Σ |x_a − x_b|² + 0.01 Σ |x_e − c_e|²
/// ```
///
/// over neighbours a, b in a chart or across the seams of the atlas, and over the texels e that are
/// seen at an edge alone, in the colour c. What no view sees solves Laplace's equation. Parts of
/// the surface of which nothing is seen get the mean colour of everything else. Returns how many
/// texels no view sees.
pub(super) fn fill(blend: &mut Blend, covered: &Covered, target: &Target) -> usize {
    let holes = Holes::new(blend, covered, target);
    if !holes.texels.is_empty() {
        let lost = holes.fill_outwards(blend);
        holes.relax(blend, &lost);
    }
    blend.best.iter().filter(|best| **best == NONE).count()
}

impl Holes {
    fn new(blend: &Blend, covered: &Covered, target: &Target) -> Self {
        let mut number = vec![u32::MAX; covered.len()];
        let mut texels = Vec::new();
        let mut hold = Vec::new();
        for (texel, grade) in (0..).zip(&blend.grades) {
            if *grade <= Grade::Edge {
                number[texel as usize] = texels.len() as u32;
                texels.push(texel);
                hold.push(if *grade == Grade::Edge { HOLD } else { 0.0 });
            }
        }
        let seams = match texels.is_empty() {
            true => Vec::new(),
            false => across_seams(&target.seams, covered),
        };
        let pairs = || covered.neighbours().chain(seams.iter().copied());
        let hole = |texel: u32| Some(number[texel as usize] as usize).filter(|h| *h < texels.len());
        let mut offsets = vec![0_u32; texels.len() + 1];
        for hole in pairs().flatten().filter_map(hole) {
            offsets[hole + 1] += 1;
        }
        for index in 0..texels.len() {
            offsets[index + 1] += offsets[index];
        }
        let mut next = offsets.clone();
        let mut neighbours = vec![0; offsets[texels.len()] as usize];
        for [a, b] in pairs() {
            for [from, to] in [[a, b], [b, a]] {
                if let Some(hole) = hole(from) {
                    neighbours[next[hole] as usize] = to;
                    next[hole] += 1;
                }
            }
        }
        Self {
            texels,
            offsets,
            neighbours,
            hold,
            number,
        }
    }

    fn neighbours(&self, hole: usize) -> &[u32] {
        &self.neighbours[self.offsets[hole] as usize..self.offsets[hole + 1] as usize]
    }

    /// Fills holes ring by ring from what is seen, each texel with the mean of the neighbours that
    /// are filled already. Returns which holes have no way to anything seen.
    fn fill_outwards(&self, blend: &mut Blend) -> Vec<bool> {
        let mut filled: Vec<bool> = blend.best.iter().map(|best| *best != NONE).collect();
        let mut waits: Vec<bool> = self.hold.iter().map(|hold| *hold == 0.0).collect();
        let is_beside = |hole: &usize| {
            waits[*hole] && self.neighbours(*hole).iter().any(|t| filled[*t as usize])
        };
        let mut ring: Vec<usize> = (0..self.texels.len()).filter(is_beside).collect();
        for hole in &ring {
            waits[*hole] = false;
        }
        while !ring.is_empty() {
            let mut next = Vec::new();
            for hole in &ring {
                let near = self.neighbours(*hole);
                let known = near.iter().filter(|texel| filled[**texel as usize]);
                blend.colours[self.texels[*hole] as usize] =
                    mean(known.map(|texel| blend.colours[*texel as usize]));
            }
            for hole in &ring {
                filled[self.texels[*hole] as usize] = true;
                for texel in self.neighbours(*hole) {
                    let other = self.number[*texel as usize] as usize;
                    if other < waits.len() && std::mem::replace(&mut waits[other], false) {
                        next.push(other);
                    }
                }
            }
            ring = next;
        }
        if waits.contains(&true) {
            let seen = blend.best.iter().zip(&blend.colours);
            let seen = seen.filter(|(best, _)| **best != NONE);
            let colour = mean(seen.map(|(_, colour)| *colour));
            for (hole, _) in waits.iter().enumerate().filter(|(_, waits)| **waits) {
                blend.colours[self.texels[hole] as usize] = colour;
            }
        }
        waits
    }

    /// Solves for the colours of which each is the mean of its neighbours, by conjugate gradients
    /// from the colours as they are. `fixed` holes stay.
    fn relax(&self, blend: &mut Blend, fixed: &[bool]) {
        let count = self.texels.len();
        let is_free = |texel: u32| {
            let hole = self.number[texel as usize] as usize;
            hole < count && !fixed[hole]
        };
        for channel in 0..3 {
            let mut x: Vec<f64> = self
                .texels
                .iter()
                .map(|texel| f64::from(blend.colours[*texel as usize][channel]))
                .collect();
            // The graph's Laplacian of free holes, with what they hold and all others as known.
            let mut right = vec![0.0; count];
            for hole in (0..count).filter(|hole| !fixed[*hole]) {
                let neighbours = self.neighbours(hole).iter();
                let known = neighbours.filter(|texel| !is_free(**texel));
                let sum: f64 = known
                    .map(|texel| f64::from(blend.colours[*texel as usize][channel]))
                    .sum();
                right[hole] = sum + self.hold[hole] * x[hole];
            }
            let image = |x: &[f64], image: &mut [f64]| {
                for (hole, image) in image.iter_mut().enumerate() {
                    *image = if fixed[hole] {
                        0.0
                    } else {
                        let neighbours = self.neighbours(hole).iter();
                        let differences = neighbours.map(|&texel| {
                            if is_free(texel) {
                                x[hole] - x[self.number[texel as usize] as usize]
                            } else {
                                x[hole]
                            }
                        });
                        differences.sum::<f64>() + self.hold[hole] * x[hole]
                    };
                }
            };
            // What the steps leave is smooth already, and no reason to refuse a texture.
            let _ = conjugate_gradient::solve(
                &right,
                &mut x,
                image,
                |residual, improved| improved.copy_from_slice(residual),
                &SOLVER,
            );
            for (texel, value) in self.texels.iter().zip(x) {
                blend.colours[*texel as usize][channel] = value.max(0.0) as f32;
            }
        }
    }
}

/// Pairs of texels on either side of the seams of an atlas that show the same points.
fn across_seams(seams: &[Seam], covered: &Covered) -> Vec<[u32; 2]> {
    let size = f64::from(covered.size);
    let last = covered.size - 1;
    let mut pairs: Vec<[u32; 2]> = Vec::new();
    for seam in seams {
        let lengths = seam
            .sides
            .map(|[[a, b], [c, d]]| size * (c - a).hypot(d - b));
        let steps = (2.0 * lengths[0].max(lengths[1])).ceil().max(1.0) as u32;
        let mut previous = None;
        for step in 0..steps {
            let t = (f64::from(step) + 0.5) / f64::from(steps);
            let texel = |[[a, b], [c, d]]: [[f64; 2]; 2]| {
                let [u, v] = [a + t * (c - a), b + t * (d - b)];
                let [column, row] = [u, 1.0 - v].map(|x| ((x * size) as u32).min(last));
                covered.find(row * covered.size + column)
            };
            if let [Some(a), Some(b)] = seam.sides.map(texel)
                && a != b
                && previous != Some([a, b])
            {
                previous = Some([a, b]);
                pairs.push([a, b]);
            }
        }
    }
    pairs
}

fn mean(colours: impl Iterator<Item = [f32; 3]>) -> [f32; 3] {
    let (mut sum, mut count) = ([0.0_f64; 3], 0.0);
    for colour in colours {
        for (sum, value) in sum.iter_mut().zip(colour) {
            *sum += f64::from(value);
        }
        count += 1.0;
    }
    sum.map(|x| (x / f64::max(count, 1.0)) as f32)
}
