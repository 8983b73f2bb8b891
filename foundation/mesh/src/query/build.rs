//! Building the hierarchy, from the root down: the set of triangles with the largest box is split
//! in two, until there are eight sets. Splits are chosen by the surface area heuristic: the sum
//! over both sides of the area of the box times the number of packets is least among planes between
//! bins (I. Wald, On fast Construction of SAH-based Bounding Volume Hierarchies, 2007).

use ga_runtime::cga3::Point;
use ga_runtime::vga3::Vector;

use super::Bvh;
use super::frame::{Frame, rounded_down, rounded_up};
use super::node::{BRANCHES, Children, DEPTH, LEAF, NOTHING, Node};
use super::packet::{Packet, WIDTH};
use crate::{MeshError, bounds};

/// How many bins the centres of boxes are sorted into.
const BINS: usize = 16;

/// Below this depth, sets are split in half, which bounds the depth of the tree.
const SAH_DEPTH: usize = 9;

/// The greatest number of triangles. Split in half from [`SAH_DEPTH`] on, they stay within
/// [`DEPTH`], and the bits below [`LEAF`] can number their packets.
const LIMIT: usize = 1 << 30;

impl Bvh {
    /// The hierarchy over these triangles, by the surface area heuristic with bins. Positions that
    /// no triangle uses are not looked at. Without triangles, rays hit nothing and the other
    /// queries say so.
    ///
    /// # Errors
    ///
    /// [`MeshError::IndexOutOfRange`]; [`MeshError::NotFinite`] for a corner of a triangle;
    /// [`MeshError::TooLarge`] past 2³⁰ triangles.
    pub fn new<P: Copy + Into<Point<f64>>>(
        positions: &[P],
        triangles: &[[u32; 3]],
    ) -> Result<Self, MeshError> {
        build(positions, triangles)
    }
}

fn build<P: Copy + Into<Point<f64>>>(
    positions: &[P],
    triangles: &[[u32; 3]],
) -> Result<Bvh, MeshError> {
    if triangles.len() > LIMIT {
        let count = triangles.len();
        let what = "triangles of a hierarchy";
        return Err(MeshError::TooLarge { what, count });
    }
    let position = |vertex: u32| Vector::from(positions[vertex as usize].into());
    for (face, triangle) in triangles.iter().enumerate() {
        for &index in triangle {
            let vertices = positions.len();
            if index as usize >= vertices {
                return Err(MeshError::IndexOutOfRange {
                    face,
                    index,
                    vertices,
                });
            }
            let corner = position(index);
            if !corner.is_finite() {
                return Err(MeshError::NotFinite {
                    vertex: index as usize,
                    coordinates: corner.coordinates(),
                });
            }
        }
    }
    let bounds = bounds(triangles.iter().flatten().map(|&vertex| position(vertex)));
    let frame = Frame::of_bounds(bounds.unwrap_or_default());
    let corners = |triangle: u32| triangles[triangle as usize].map(position);
    let mut boxes: Vec<Boxed> = (0..triangles.len() as u32)
        .map(|triangle| Boxed::new(triangle, corners(triangle).map(|c| frame.position(c))))
        .collect();
    let mut tree = Tree {
        nodes: Vec::with_capacity(triangles.len() / 16),
        packets: Vec::with_capacity(triangles.len() / 2),
        corners,
    };
    if !boxes.is_empty() {
        let bounds = Aabb::around(&boxes);
        tree.add_node(&mut boxes, bounds, 0);
    }
    Ok(Bvh {
        frame,
        bounds,
        nodes: tree.nodes,
        screens: tree
            .packets
            .iter()
            .map(|packet| packet.screen(&frame))
            .collect(),
        packets: tree.packets,
        triangle_count: triangles.len(),
    })
}

/// A box; the fourth lane is not used, and makes it two registers.
#[derive(Clone, Copy)]
struct Aabb {
    low: [f32; 4],
    high: [f32; 4],
}

impl Aabb {
    const EMPTY: Self = Self {
        low: [f32::INFINITY; 4],
        high: [f32::NEG_INFINITY; 4],
    };

    fn around(boxes: &[Boxed]) -> Self {
        boxes
            .iter()
            .fold(Self::EMPTY, |bounds, item| bounds.union(item.bounds))
    }

    #[inline(always)]
    fn union(self, other: Self) -> Self {
        let mut union = self;
        for (x, y) in union.low.iter_mut().zip(other.low) {
            *x = if y < *x { y } else { *x };
        }
        for (x, y) in union.high.iter_mut().zip(other.high) {
            *x = if y > *x { y } else { *x };
        }
        union
    }

    /// Half the area of its surface; zero for the empty box.
    #[inline(always)]
    fn half_area(self) -> f32 {
        let [x, y, z] = [0, 1, 2].map(|axis| self.high[axis] - self.low[axis]);
        if x < 0.0 { 0.0 } else { x * y + y * z + z * x }
    }
}

/// A triangle with its box.
#[derive(Clone, Copy)]
struct Boxed {
    bounds: Aabb,
    triangle: u32,
}

impl Boxed {
    fn new(triangle: u32, [a, b, c]: [Vector<f64>; 3]) -> Self {
        let low = a.min(b).min(c).coordinates().map(rounded_down);
        let high = a.max(b).max(c).coordinates().map(rounded_up);
        Self {
            bounds: Aabb {
                low: [low[0], low[1], low[2], 0.0],
                high: [high[0], high[1], high[2], 0.0],
            },
            triangle,
        }
    }

    /// Twice the centre of the box.
    #[inline(always)]
    fn centre(&self) -> [f32; 4] {
        let mut sum = self.bounds.low;
        for (x, y) in sum.iter_mut().zip(self.bounds.high) {
            *x += y;
        }
        sum
    }
}

/// The part of the tree that is built.
struct Tree<C> {
    nodes: Vec<Node>,
    packets: Vec<Packet>,
    corners: C,
}

/// Triangles that become one child of a node.
struct Set<'a> {
    boxes: &'a mut [Boxed],
    bounds: Aabb,
}

impl<C: Fn(u32) -> [Vector<f64>; 3]> Tree<C> {
    /// Adds a node over these triangles, of which there is at least one, and returns its index.
    fn add_node(&mut self, boxes: &mut [Boxed], bounds: Aabb, depth: usize) -> u32 {
        debug_assert!(depth < DEPTH);
        let mut sets = [const { None }; BRANCHES];
        sets[0] = Some(Set { boxes, bounds });
        let by_area = depth < SAH_DEPTH;
        for free in 1..BRANCHES {
            let largest = sets[..free]
                .iter_mut()
                .flatten()
                .filter(|set| set.boxes.len() > WIDTH)
                .map(|set| {
                    let size = if by_area {
                        set.bounds.half_area()
                    } else {
                        set.boxes.len() as f32
                    };
                    (size, set)
                })
                .reduce(|best, other| if best.0 < other.0 { other } else { best });
            let Some((_, largest)) = largest else { break };
            let whole = std::mem::take(&mut largest.boxes);
            let middle = if by_area { partition(whole) } else { None };
            let middle = middle.unwrap_or_else(|| halve(whole));
            let (left, right) = whole.split_at_mut(middle);
            largest.bounds = Aabb::around(left);
            largest.boxes = left;
            let bounds = Aabb::around(right);
            sets[free] = Some(Set {
                boxes: right,
                bounds,
            });
        }

        let index = self.nodes.len();
        let empty = [f32::INFINITY, f32::NEG_INFINITY];
        self.nodes.push(Node {
            bounds: [0, 1, 2, 3, 4, 5].map(|row| Children::splat(empty[row % 2])),
            children: [NOTHING; BRANCHES],
        });
        for (lane, set) in sets.into_iter().flatten().enumerate() {
            let Set { boxes, bounds } = set;
            let child = if boxes.len() <= WIDTH {
                self.add_leaf(boxes)
            } else {
                self.add_node(boxes, bounds, depth + 1)
            };
            let node = &mut self.nodes[index];
            node.children[lane] = child;
            for axis in 0..3 {
                for (row, bound) in [(2 * axis, bounds.low), (2 * axis + 1, bounds.high)] {
                    let mut numbers = node.bounds[row].to_array();
                    numbers[lane] = bound[axis];
                    node.bounds[row] = Children::from_array(numbers);
                }
            }
        }
        index as u32
    }

    fn add_leaf(&mut self, boxes: &[Boxed]) -> u32 {
        let last = boxes.len() - 1;
        let triangles = [0, 1, 2, 3].map(|lane: usize| boxes[lane.min(last)].triangle);
        self.packets.push(Packet::new(triangles, &self.corners));
        (self.packets.len() - 1) as u32 | LEAF
    }
}

/// Puts the triangles into two sets, the first in front, and returns its length; `None` where their
/// boxes have one centre.
fn partition(boxes: &mut [Boxed]) -> Option<usize> {
    let mut low = [f32::INFINITY; 4];
    let mut high = [f32::NEG_INFINITY; 4];
    for item in &*boxes {
        let centre = item.centre();
        for axis in 0..4 {
            low[axis] = if centre[axis] < low[axis] {
                centre[axis]
            } else {
                low[axis]
            };
            high[axis] = if centre[axis] > high[axis] {
                centre[axis]
            } else {
                high[axis]
            };
        }
    }
    let mut factor = [0.0; 4];
    for axis in 0..3 {
        let extent = high[axis] - low[axis];
        // Slightly less, so that the highest centre lies in the last bin.
        factor[axis] = if extent > 1e-30 {
            BINS as f32 * 0.99999 / extent
        } else {
            0.0
        };
    }
    let bin_of = |centre: [f32; 4], axis: usize| {
        (((centre[axis] - low[axis]) * factor[axis]) as usize).min(BINS - 1)
    };

    let mut bins = [[(Aabb::EMPTY, 0_u32); BINS]; 3];
    for item in &*boxes {
        let centre = item.centre();
        for (axis, bins) in bins.iter_mut().enumerate() {
            let bin = &mut bins[bin_of(centre, axis)];
            bin.0 = bin.0.union(item.bounds);
            bin.1 += 1;
        }
    }
    let mut best: Option<(f32, usize, usize)> = None;
    for (axis, bins) in bins.iter().enumerate() {
        if factor[axis] == 0.0 {
            continue;
        }
        let mut below = [0.0; BINS];
        let mut sum = (Aabb::EMPTY, 0);
        for (bin, cost) in bins.iter().zip(&mut below) {
            *cost = cost_of(sum);
            sum = (sum.0.union(bin.0), sum.1 + bin.1);
        }
        let mut sum = (Aabb::EMPTY, 0);
        for plane in (1..BINS).rev() {
            let bin = bins[plane];
            sum = (sum.0.union(bin.0), sum.1 + bin.1);
            if sum.1 == 0 || sum.1 as usize == boxes.len() {
                continue;
            }
            let cost = below[plane] + cost_of(sum);
            if best.is_none_or(|best| cost < best.0) {
                best = Some((cost, axis, plane));
            }
        }
    }
    let (_, axis, plane) = best?;

    let mut middle = 0;
    for place in 0..boxes.len() {
        if bin_of(boxes[place].centre(), axis) < plane {
            boxes.swap(middle, place);
            middle += 1;
        }
    }
    Some(middle)
}

/// The cost of a set by the surface area heuristic: the area of its box times its packets.
fn cost_of((bounds, count): (Aabb, u32)) -> f32 {
    bounds.half_area() * count.div_ceil(WIDTH as u32) as f32
}

/// Splits in half along the longest side of the box, and returns the length of the first half.
fn halve(boxes: &mut [Boxed]) -> usize {
    let Aabb { low, high } = Aabb::around(boxes);
    let extent = |axis: usize| high[axis] - low[axis];
    let axis = (1..3).fold(0, |longest, axis| {
        if extent(axis) > extent(longest) {
            axis
        } else {
            longest
        }
    });
    let middle = boxes.len() / 2;
    boxes.select_nth_unstable_by(middle, |a, b| {
        let order = a.centre()[axis].total_cmp(&b.centre()[axis]);
        order.then(a.triangle.cmp(&b.triangle))
    });
    middle
}
