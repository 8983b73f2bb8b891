//! Cutting a surface into connected charts whose normals lie in a cone.

use std::cmp::Reverse;
use std::collections::{BinaryHeap, VecDeque};

use super::Vector;
use super::surface::{NONE, Surface};

/// The cosine of the largest angle between the normal of a face and that of its chart: 55°.
///
/// The projection of faces within 55° of one direction has an area-weighted L2 stretch below 1.1
/// whatever their distribution.
const CONE: f64 = 0.574;

/// Rounds in which all charts grow anew from their middles.
const ROUNDS: usize = 3;

/// A region that no cone reaches and that has less than this part of the whole area becomes part
/// of the charts beside it.
const ISLAND: f64 = 1.0 / 600.0;

/// How much the distance across a face counts more where its normal leaves that of the chart.
const BEND: f64 = 4.0;

/// Charts of a surface: the chart of each face, and how many charts there are.
pub(super) struct Partition {
    pub(super) chart_of: Vec<u32>,
    pub(super) charts: usize,
}

impl Partition {
    /// The faces of each chart, in rising order.
    pub(super) fn faces(&self) -> Vec<Vec<u32>> {
        let mut sizes = vec![0; self.charts];
        for &chart in &self.chart_of {
            sizes[chart as usize] += 1;
        }
        let mut faces: Vec<Vec<u32>> = sizes.into_iter().map(Vec::with_capacity).collect();
        for (face, &chart) in self.chart_of.iter().enumerate() {
            faces[chart as usize].push(face as u32);
        }
        faces
    }
}

/// Charts that cover a surface, by these normals of its faces. Each is connected; a few faces in it
/// may lie outside the cone.
pub(super) fn grow(surface: &Surface, normals: &[Vector]) -> Partition {
    let total: f64 = surface.areas.iter().sum();
    let island = total * ISLAND;
    let mut growth = Growth::new(surface, normals);
    growth.cover(0.0);
    growth.merge();
    for _ in 0..ROUNDS {
        growth.grow_from_middles();
        growth.cover(island);
        growth.merge();
    }
    growth.absorb();
    growth.cover(0.0);
    growth.finish()
}

struct Seed {
    face: u32,
    axis: Vector,
}

struct Growth<'a> {
    surface: &'a Surface,
    normals: &'a [Vector],
    chart_of: Vec<u32>,
    seeds: Vec<Seed>,
    heap: Heap,
}

impl<'a> Growth<'a> {
    fn new(surface: &'a Surface, normals: &'a [Vector]) -> Self {
        Self {
            surface,
            normals,
            chart_of: vec![NONE; surface.len()],
            seeds: Vec::new(),
            heap: Heap::default(),
        }
    }

    /// Adds charts until every region that no chart reaches has less than this area.
    fn cover(&mut self, island: f64) {
        let mut frontier: VecDeque<u32> = (0..self.surface.len() as u32)
            .filter(|&face| self.chart_of[face as usize] != NONE)
            .collect();
        let mut is_small = vec![false; self.surface.len()];
        let mut scan = 0;
        loop {
            // Beside a chart where there is one, so that charts fill the surface without gaps.
            let seed = loop {
                if let Some(face) = frontier.pop_front() {
                    let open = self.surface.neighbours(face).find(|&next| {
                        self.chart_of[next as usize] == NONE && !is_small[next as usize]
                    });
                    if open.is_some() {
                        frontier.push_front(face);
                        break open;
                    }
                } else if scan < self.surface.len() {
                    let face = scan as u32;
                    scan += 1;
                    if self.chart_of[face as usize] == NONE && !is_small[face as usize] {
                        break Some(face);
                    }
                } else {
                    break None;
                }
            };
            let Some(seed) = seed else { return };
            if island > 0.0 {
                let region = self.open_region(seed);
                if self.area(&region) < island {
                    for face in region {
                        is_small[face as usize] = true;
                    }
                    continue;
                }
            }
            let chart = self.seeds.len() as u32;
            let faces = self.grow_one(seed, self.normals[seed as usize], chart);
            // Grown from the border of its neighbours, the chart is one-sided. Its middle is a
            // better place to begin.
            let middle = self.middle(&faces);
            for &face in &faces {
                self.chart_of[face as usize] = NONE;
            }
            let faces = self.grow_one(middle.face, middle.axis, chart);
            self.seeds.push(self.middle(&faces));
            frontier.extend(faces);
        }
    }

    /// The faces without a chart that hang together with one of them.
    fn open_region(&self, seed: u32) -> Vec<u32> {
        let mut seen = rustc_hash::FxHashSet::default();
        seen.insert(seed);
        let mut region = vec![seed];
        let mut next = 0;
        while let Some(&face) = region.get(next) {
            next += 1;
            for beside in self.surface.neighbours(face) {
                if self.chart_of[beside as usize] == NONE && seen.insert(beside) {
                    region.push(beside);
                }
            }
        }
        region
    }

    fn area(&self, faces: &[u32]) -> f64 {
        faces
            .iter()
            .map(|&face| self.surface.areas[face as usize])
            .sum()
    }

    /// Gives one chart all faces within its cone that it reaches and that have no chart.
    fn grow_one(&mut self, seed: u32, axis: Vector, chart: u32) -> Vec<u32> {
        self.chart_of[seed as usize] = chart;
        let mut faces = vec![seed];
        let mut next = 0;
        while let Some(&face) = faces.get(next) {
            next += 1;
            for beside in self.surface.neighbours(face) {
                let free = self.chart_of[beside as usize] == NONE;
                if free && self.normals[beside as usize].dot(axis) >= CONE {
                    self.chart_of[beside as usize] = chart;
                    faces.push(beside);
                }
            }
        }
        faces
    }

    /// The mean normal of some faces, and the face nearest to their centre that lies within the
    /// cone of it.
    fn middle(&self, faces: &[u32]) -> Seed {
        let surface = self.surface;
        let mut axis = Vector::default();
        let mut centre = Vector::default();
        let mut area = 0.0;
        for &face in faces {
            let weight = surface.areas[face as usize];
            axis += self.normals[face as usize] * weight;
            centre += surface.centres[face as usize] * weight;
            area += weight;
        }
        let centre = centre * (1.0 / area);
        let first = self.normals[faces[0] as usize];
        let axis = axis.normalized().unwrap_or(first);
        let distance = |face: u32| (surface.centres[face as usize] - centre).length_squared();
        let within = faces
            .iter()
            .filter(|&&face| self.normals[face as usize].dot(axis) >= CONE);
        match within.min_by(|&&a, &&b| distance(a).total_cmp(&distance(b))) {
            Some(&face) => Seed { face, axis },
            // The normals are all around: one face is as good as another.
            None => Seed {
                face: faces[0],
                axis: first,
            },
        }
    }

    /// All charts grow at the same time from their middles, and each face goes to the nearest.
    /// Faces outside all cones are left without a chart.
    fn grow_from_middles(&mut self) {
        let mut lists: Vec<Vec<u32>> = vec![Vec::new(); self.seeds.len()];
        for (face, &chart) in self.chart_of.iter().enumerate() {
            if chart != NONE {
                lists[chart as usize].push(face as u32);
            }
        }
        self.seeds = lists
            .iter()
            .filter(|faces| !faces.is_empty())
            .map(|faces| self.middle(faces))
            .collect();
        self.chart_of = vec![NONE; self.surface.len()];
        for (chart, seed) in self.seeds.iter().enumerate() {
            self.heap.push(0.0, seed.face, chart as u32);
        }
        let surface = self.surface;
        while let Some((distance, face, chart)) = self.heap.pop() {
            if self.chart_of[face as usize] != NONE {
                continue;
            }
            self.chart_of[face as usize] = chart;
            let axis = self.seeds[chart as usize].axis;
            let here = surface.centres[face as usize];
            for beside in surface.neighbours(face) {
                let cosine = self.normals[beside as usize].dot(axis);
                if self.chart_of[beside as usize] == NONE && cosine >= CONE {
                    let step = here.distance(surface.centres[beside as usize]);
                    let step = step * (1.0 + BEND * (1.0 - cosine));
                    self.heap.push(distance + step as f32, beside, chart);
                }
            }
        }
        // A chart whose seed was taken by another one has no faces any more.
        self.renumber();
    }

    /// Joins charts while the union stays within a cone.
    fn merge(&mut self) {
        super::merge::merge(
            self.surface,
            self.normals,
            &mut self.chart_of,
            self.seeds.len(),
        );
        self.renumber();
    }

    /// Leaves out the charts without faces.
    fn renumber(&mut self) {
        let mut number = vec![NONE; self.seeds.len()];
        for &chart in &self.chart_of {
            if chart != NONE {
                number[chart as usize] = 0;
            }
        }
        let kept = number.iter_mut().filter(|number| **number != NONE);
        for (place, number) in kept.enumerate() {
            *number = place as u32;
        }
        for chart in self.chart_of.iter_mut().filter(|chart| **chart != NONE) {
            *chart = number[*chart as usize];
        }
        let mut old = number.iter();
        self.seeds
            .retain(|_| old.next().is_some_and(|&number| number != NONE));
    }

    /// Gives the faces without a chart to the charts beside them.
    fn absorb(&mut self) {
        let (surface, normals) = (self.surface, self.normals);
        let push = |heap: &mut Heap, chart_of: &[u32], distance: f32, face: u32| {
            let chart = chart_of[face as usize];
            let normal = normals[face as usize];
            for beside in surface.neighbours(face) {
                if chart_of[beside as usize] == NONE {
                    let bend = 1.0 - normal.dot(normals[beside as usize]);
                    heap.push(distance + bend as f32, beside, chart);
                }
            }
        };
        for face in 0..surface.len() as u32 {
            if self.chart_of[face as usize] != NONE {
                push(&mut self.heap, &self.chart_of, 0.0, face);
            }
        }
        while let Some((distance, face, chart)) = self.heap.pop() {
            if self.chart_of[face as usize] == NONE {
                self.chart_of[face as usize] = chart;
                push(&mut self.heap, &self.chart_of, distance, face);
            }
        }
    }

    fn finish(self) -> Partition {
        Partition {
            chart_of: self.chart_of,
            charts: self.seeds.len(),
        }
    }
}

/// Faces that charts may take, the nearest first; among equally near ones that of lower number.
#[derive(Default)]
pub(super) struct Heap(BinaryHeap<Reverse<(u64, u32)>>);

impl Heap {
    /// `distance` is not negative.
    pub(super) fn push(&mut self, distance: f32, face: u32, chart: u32) {
        // Floats that are not negative are in the order of their bits.
        let key = u64::from(distance.max(0.0).to_bits()) << 32 | u64::from(face);
        self.0.push(Reverse((key, chart)));
    }

    pub(super) fn pop(&mut self) -> Option<(f32, u32, u32)> {
        let Reverse((key, chart)) = self.0.pop()?;
        Some((f32::from_bits((key >> 32) as u32), key as u32, chart))
    }
}
