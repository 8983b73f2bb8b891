//! Pairs of features with similar descriptors.

use ga_runtime::batch::{Batch, Work};

use super::{Descriptor, Feature};

/// How features are paired.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct MatchOptions {
    /// The greatest number of bits in which descriptors of a pair may differ.
    pub greatest_distance: u32,
    /// The distance to the best feature must be below this part of the distance to the best one
    /// elsewhere.
    pub ratio: f64,
}

impl Default for MatchOptions {
    /// 64 of 256 bits, 0.85.
    fn default() -> Self {
        Self {
            greatest_distance: 64,
            ratio: 0.85,
        }
    }
}

/// Two features that belong together.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Match {
    /// The index of the left view's feature.
    pub left: usize,
    /// The index of the right view's feature.
    pub right: usize,
    /// The number of bits in which the descriptors differ.
    pub distance: u32,
}

/// Pairs of features of two views, each the nearest to the other by their descriptors, and clearly
/// nearer than the nearest feature in another place (D. G. Lowe, "Distinctive image features from
/// scale-invariant keypoints", 2004), in the order of the left ones.
#[must_use]
pub fn match_features(left: &[Feature], right: &[Feature], options: &MatchOptions) -> Vec<Match> {
    let mut matches = Vec::new();
    Batch::new().run(Matching {
        left,
        right,
        options,
        matches: &mut matches,
    });
    matches
}

struct Matching<'a> {
    left: &'a [Feature],
    right: &'a [Feature],
    options: &'a MatchOptions,
    matches: &'a mut Vec<Match>,
}

impl Work for Matching<'_> {
    #[inline(always)]
    fn run(self) {
        let descriptors: Vec<Descriptor> = self.right.iter().map(|f| f.descriptor).collect();
        let mut distances = vec![0; descriptors.len()];
        // For each right feature, the nearest left one so far and its distance.
        let mut nearest_left = vec![(u32::MAX, 0); descriptors.len()];
        for (index, feature) in self.left.iter().enumerate() {
            let mut nearest = (u32::MAX, 0);
            let entries = distances
                .iter_mut()
                .zip(&descriptors)
                .zip(&mut nearest_left);
            for (other, ((distance, descriptor), nearest_left)) in entries.enumerate() {
                *distance = feature.descriptor.distance(descriptor);
                if *distance < nearest.0 {
                    nearest = (*distance, other);
                }
                if *distance < nearest_left.0 {
                    *nearest_left = (*distance, index);
                }
            }
            let (distance, right) = nearest;
            if distance > self.options.greatest_distance {
                continue;
            }
            let elsewhere = self.nearest_elsewhere(&distances, right);
            if f64::from(distance) < self.options.ratio * f64::from(elsewhere) {
                self.matches.push(Match {
                    left: index,
                    right,
                    distance,
                });
            }
        }
        self.matches
            .retain(|found| nearest_left[found.right].1 == found.left);
    }
}

impl Matching<'_> {
    /// The least distance to a feature that is not at the place of the best one: the same corner is
    /// found in several scales.
    #[inline(always)]
    fn nearest_elsewhere(&self, distances: &[u32], best: usize) -> u32 {
        const NEAR: f64 = 4.0;
        let best = &self.right[best];
        let mut least = u32::MAX;
        for (distance, other) in distances.iter().zip(self.right) {
            if *distance < least {
                let reach = NEAR * best.size.max(other.size);
                let [u, v] = [0, 1].map(|axis| (other.pixel[axis] - best.pixel[axis]).abs());
                if u.max(v) > reach {
                    least = *distance;
                }
            }
        }
        least
    }
}
