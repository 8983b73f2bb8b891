//! The places of all points of a body together.
//!
//! Two views that are near to each other hardly determine how far away a point is, and one view
//! does not at all; the known distances between points do, up to reflections: a bone that points
//! towards the views is seen as one that points away from them. So each point has candidates along
//! the line on which it is seen. Points with fixed distances form a tree, on which the least sum of
//! the costs of candidates and of distances is found exactly, from the leaves to the root, and on
//! which places are drawn at random as likely as they are (P. Felzenszwalb, D. Huttenlocher,
//! "Pictorial structures for object recognition", International Journal of Computer Vision 61,
//! 2005).

use std::collections::VecDeque;

use ga_runtime::vga3::Vector;
use rand_chacha::ChaCha8Rng;
use rand_chacha::rand_core::Rng;

use super::candidates::{Candidates, Sight};
use super::links::Links;
use crate::Observation;
use ga_camera::Camera;
use ga_camera::triangulation::triangulate_views;

/// The places of points together.
#[derive(Clone, Debug)]
pub(crate) struct Places {
    /// `None` for points that no view shows.
    pub(crate) points: Vec<Option<Vector<f64>>>,
    /// The views that are wrong, each with the point.
    pub(crate) wrong: Vec<(usize, usize)>,
}

/// A point of a tree after the first one.
#[derive(Clone, Copy, Debug)]
struct Branch {
    point: usize,
    /// The seen point before it.
    from: usize,
    /// The least and the greatest distance between them.
    range: [f64; 2],
}

/// The candidates of all points, and what they cost together.
#[derive(Clone, Debug)]
pub(super) struct Depths {
    /// For each point the views that show it.
    views: Vec<Vec<usize>>,
    /// The first point of each tree.
    roots: Vec<usize>,
    branches: Vec<Branch>,
    candidates: Vec<Candidates>,
    /// For each branch the costs of distances, in rows for the point before it.
    tables: Vec<Vec<f64>>,
}

/// The cost of an error of four standard deviations, which is hardly one of noise.
const SUSPICIOUS: f64 = 16.0;

impl Depths {
    /// The candidates of points that two views or more show around the places where these agree,
    /// and of others along their rays. Where they do not fit together, each of the views may be
    /// wrong, which costs `wrong`.
    pub(super) fn new(
        links: &Links,
        cameras: &[Camera],
        observation: &Observation,
        triangulated: &[Option<Vector<f64>>],
        wrong: f64,
    ) -> Self {
        let sights: Vec<Vec<Sight<'_>>> = (0..triangulated.len())
            .map(|point| sights(cameras, observation, point))
            .collect();
        let around = sights.iter().zip(triangulated);
        let around: Vec<Candidates> = around
            .map(|(sights, place)| {
                let found = place.and_then(|place| Candidates::around(place, sights));
                found.unwrap_or_default()
            })
            .collect();
        let views = (0..triangulated.len()).map(|point| {
            let views = observation.views.iter().enumerate();
            views
                .filter_map(|(view, pixels)| pixels[point].map(|_| view))
                .collect()
        });
        let views: Vec<Vec<usize>> = views.collect();
        let first = Self::of(links, &views, &sights, around.clone());
        let suspicious = first.suspicious(&sights);
        if !suspicious.contains(&true) {
            return first;
        }
        let mut candidates = around;
        for point in 0..candidates.len() {
            if suspicious[point] && sights[point].len() > 1 {
                let near = nearest(links, point, &suspicious, triangulated);
                let own = std::mem::take(&mut candidates[point]);
                candidates[point] = with_wrong_views(own, &sights[point], near, wrong);
            }
        }
        Self::of(links, &views, &sights, candidates)
    }

    /// With candidates along rays for points that one view shows.
    fn of(
        links: &Links,
        views: &[Vec<usize>],
        sights: &[Vec<Sight<'_>>],
        mut candidates: Vec<Candidates>,
    ) -> Self {
        let (roots, mut branches) = tree(links, sights, &candidates);
        for branch in &branches {
            if candidates[branch.point].is_empty() {
                let from = &candidates[branch.from];
                let reach = from.radius + branch.range[1];
                let ray = Candidates::on_ray(sights[branch.point][0], from.centre, reach);
                candidates[branch.point] = ray.unwrap_or_default();
            }
        }
        branches.retain(|branch| {
            !candidates[branch.point].is_empty() && !candidates[branch.from].is_empty()
        });
        let tables = branches.iter().map(|branch| {
            candidates[branch.from].distances(&candidates[branch.point], branch.range)
        });
        Self {
            views: views.to_vec(),
            tables: tables.collect(),
            roots,
            branches,
            candidates,
        }
    }

    /// The costs of all candidates with those of the best ones below them, or with the means over
    /// all below.
    fn upward(&self, sum: impl Fn(&[f64]) -> f64) -> Vec<Vec<f64>> {
        let mut costs: Vec<Vec<f64>> = self.candidates.iter().map(Candidates::costs).collect();
        let mut values = Vec::new();
        for (branch, table) in self.branches.iter().zip(&self.tables).rev() {
            let below = std::mem::take(&mut costs[branch.point]);
            let rows = table.chunks_exact(below.len());
            for (cost, row) in costs[branch.from].iter_mut().zip(rows) {
                values.clear();
                values.extend(row.iter().zip(&below).map(|(a, b)| a + b));
                *cost += sum(&values);
            }
            costs[branch.point] = below;
        }
        costs
    }

    /// Chooses candidates from the roots to the leaves by their costs.
    fn downward(&self, costs: &[Vec<f64>], mut choose: impl FnMut(&[f64]) -> usize) -> Vec<usize> {
        let mut chosen = vec![0; self.candidates.len()];
        for &root in &self.roots {
            chosen[root] = choose(&costs[root]);
        }
        let mut values = Vec::new();
        for (branch, table) in self.branches.iter().zip(&self.tables) {
            let below = &costs[branch.point];
            let row = &table[chosen[branch.from] * below.len()..][..below.len()];
            values.clear();
            values.extend(row.iter().zip(below).map(|(a, b)| a + b));
            chosen[branch.point] = choose(&values);
        }
        chosen
    }

    fn places(&self, chosen: &[usize]) -> Places {
        let candidates = || self.candidates.iter().zip(chosen);
        let points = candidates().map(|(own, &index)| (!own.is_empty()).then(|| own.place(index)));
        let wrong = candidates()
            .enumerate()
            .filter_map(|(point, (own, &index))| {
                let wrong = (!own.is_empty()).then(|| own.wrong(index))??;
                Some((self.views[point][wrong], point))
            });
        Places {
            points: points.collect(),
            wrong: wrong.collect(),
        }
    }

    fn least(&self) -> Vec<usize> {
        self.downward(&self.upward(minimum), position_of_minimum)
    }

    /// The most likely places.
    pub(super) fn best(&self) -> Places {
        self.places(&self.least())
    }

    /// Places drawn at random as likely as they are.
    pub(super) fn samples(&self, count: usize, random: &mut ChaCha8Rng) -> Vec<Places> {
        let costs = self.upward(log_sum);
        let mut draw = |values: &[f64]| {
            let least = minimum(values);
            let weights = || values.iter().map(|value| (-0.5 * (value - least)).exp());
            let chance = f64::from(random.next_u32()) / 2.0_f64.powi(32);
            let mut left = chance * weights().sum::<f64>();
            let found = weights().position(|weight| {
                left -= weight;
                left < 0.0
            });
            found.unwrap_or(0)
        };
        (0..count)
            .map(|_| self.places(&self.downward(&costs, &mut draw)))
            .collect()
    }

    /// Which points do not fit together with others even at the best places.
    fn suspicious(&self, sights: &[Vec<Sight<'_>>]) -> Vec<bool> {
        let chosen = self.least();
        let of_point = self.candidates.iter().zip(&chosen).zip(sights);
        let mut found: Vec<bool> = of_point
            .map(|((own, &index), sights)| match own.is_empty() {
                true => sights.len() > 1,
                false => own.costs()[index] > SUSPICIOUS,
            })
            .collect();
        for (branch, table) in self.branches.iter().zip(&self.tables) {
            let width = self.candidates[branch.point].len();
            let cost = table[chosen[branch.from] * width + chosen[branch.point]];
            if cost - minimum(table) > SUSPICIOUS {
                found[branch.point] = true;
                found[branch.from] = true;
            }
        }
        found
    }
}

fn minimum(values: &[f64]) -> f64 {
    values.iter().copied().fold(f64::INFINITY, f64::min)
}

fn position_of_minimum(values: &[f64]) -> usize {
    let all = values.iter().enumerate();
    all.min_by(|a, b| a.1.total_cmp(b.1)).map_or(0, |(k, _)| k)
}

/// The cost of any of several.
fn log_sum(values: &[f64]) -> f64 {
    let least = minimum(values);
    let sum: f64 = values
        .iter()
        .map(|value| (-0.5 * (value - least)).exp())
        .sum();
    least - 2.0 * sum.ln()
}

/// The views that show a point.
fn sights<'c>(cameras: &'c [Camera], observation: &Observation, point: usize) -> Vec<Sight<'c>> {
    let views = cameras.iter().zip(&observation.views);
    views
        .filter_map(|(camera, pixels)| Some((camera, pixels[point]?)))
        .collect()
}

/// The candidates where one of the views is wrong, beside those where none is.
fn with_wrong_views(
    own: Candidates,
    sights: &[Sight<'_>],
    near: Option<(Vector<f64>, f64)>,
    cost: f64,
) -> Candidates {
    let mut all = own;
    for wrong in 0..sights.len() {
        let mut right = sights.to_vec();
        right.remove(wrong);
        let found = match (&right[..], near) {
            ([sight], Some((centre, reach))) => Candidates::on_ray(*sight, centre, reach),
            ([_], None) => None,
            _ => {
                let cameras: Vec<Camera> = right.iter().map(|(camera, _)| **camera).collect();
                let pixels: Vec<[f64; 2]> = right.iter().map(|(_, pixel)| pixel.position).collect();
                let place = triangulate_views(&cameras, &pixels).ok();
                place.and_then(|place| Candidates::around(place.position.into(), &right))
            }
        };
        if let Some(found) = found {
            all = all.or(found, wrong, cost);
        }
    }
    all
}

/// The nearest triangulated point that fits the others, and how far it is along bones.
fn nearest(
    links: &Links,
    point: usize,
    suspicious: &[bool],
    triangulated: &[Option<Vector<f64>>],
) -> Option<(Vector<f64>, f64)> {
    let mut distances: Vec<Option<f64>> = vec![None; suspicious.len()];
    distances[point] = Some(0.0);
    let mut queue = VecDeque::from([point]);
    while let Some(point) = queue.pop_front() {
        let distance = distances[point]?;
        if let (false, Some(place)) = (suspicious[point], triangulated[point]) {
            return Some((place, distance));
        }
        for (next, length) in links.of(point) {
            if distances[next].is_none() {
                distances[next] = Some(distance + length);
                queue.push_back(next);
            }
        }
    }
    None
}

/// Seen points as trees, whose first points have candidates, each point after the one from which
/// its distance is known. Unseen points between two of them leave a range of distances.
fn tree(
    links: &Links,
    sights: &[Vec<Sight<'_>>],
    candidates: &[Candidates],
) -> (Vec<usize>, Vec<Branch>) {
    let (mut roots, mut branches) = (Vec::new(), Vec::new());
    // For each point the nearest seen point before it, and the range of distances from there.
    let mut before: Vec<Option<(usize, [f64; 2])>> = vec![None; candidates.len()];
    for root in 0..candidates.len() {
        if before[root].is_some() || candidates[root].is_empty() {
            continue;
        }
        roots.push(root);
        before[root] = Some((root, [0.0; 2]));
        let mut queue = VecDeque::from([root]);
        while let Some(point) = queue.pop_front() {
            let Some((from, [least, greatest])) = before[point] else {
                continue;
            };
            for (next, length) in links.of(point) {
                if before[next].is_some() {
                    continue;
                }
                let nearest = (least - length).max(length - greatest).max(0.0);
                let range = [nearest, greatest + length];
                before[next] = Some((from, range));
                if !sights[next].is_empty() {
                    branches.push(Branch {
                        point: next,
                        from,
                        range,
                    });
                    before[next] = Some((next, [0.0; 2]));
                }
                queue.push_back(next);
            }
        }
    }
    (roots, branches)
}
