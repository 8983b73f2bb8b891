//! Triangles of two surfaces that meet.

use ga_runtime::scalar::Real;
use ga_runtime::vga3::Vector;

use super::Bvh;
use super::frame::{rounded_down, rounded_up};
use super::node::{BRANCHES, Children, LEAF, NOTHING, Node};
use super::packet::Packet;

impl Bvh {
    /// The pairs of a triangle of this surface and a triangle of another one that have a common
    /// point, in rising order. Triangles are closed: to touch at a corner or an edge is enough, and
    /// triangles in one plane meet where their areas do. Degenerate triangles are segments or
    /// points. A surface meets itself at each triangle and wherever triangles share a corner.
    ///
    /// Both hierarchies are descended together. Two triangles are apart if an axis separates them:
    /// their heights along it do not overlap (C. Ericson, Real-Time Collision Detection, 2005,
    /// 5.2.1). The heights are rounded like any sum of products, so that triangles that only touch
    /// may count as apart where coordinates are not small whole numbers.
    ///
    /// ```
    /// use ga_mesh::query::Bvh;
    /// let corners = [[0.0, 0.0, 0.0], [4.0, 0.0, 0.0], [4.0, 4.0, 0.0], [0.0, 4.0, 0.0]];
    /// let square = Bvh::new(&corners, &[[0, 1, 2], [0, 2, 3]])?;
    /// let corners = [[3.0, 1.0, -1.0], [3.0, 1.0, 1.0], [5.0, 1.0, 0.0]];
    /// let upright = Bvh::new(&corners, &[[0, 1, 2]])?;
    /// assert_eq!(square.overlaps(&upright), [[0, 0]]);
    /// assert_eq!(upright.overlaps(&square), [[0, 0]]);
    /// # Ok::<(), ga_mesh::MeshError>(())
    /// ```
    #[must_use]
    pub fn overlaps(&self, other: &Self) -> Vec<[u32; 2]> {
        let mut found = Vec::new();
        if self.nodes.is_empty() || other.nodes.is_empty() {
            return found;
        }
        let mut rest = vec![Pair {
            references: [0, 0],
            bounds: [[f32::NEG_INFINITY, f32::INFINITY]; 3],
            other_bounds: [[f32::NEG_INFINITY, f32::INFINITY]; 3],
        }];
        while let Some(pair) = rest.pop() {
            match pair.references {
                [a, b] if a & LEAF == 0 && b & LEAF == 0 => {
                    let (node, others) = (&self.nodes[a as usize], &other.nodes[b as usize]);
                    for (child, bounds) in children_in(self, other, others) {
                        push_children(node, child, bounds, &mut rest);
                    }
                }
                [a, b] if a & LEAF == 0 => {
                    push_children(&self.nodes[a as usize], b, pair.other_bounds, &mut rest);
                }
                [a, b] if b & LEAF == 0 => {
                    for (child, bounds) in children_in(self, other, &other.nodes[b as usize]) {
                        if boxes_meet(pair.bounds, bounds) {
                            rest.push(Pair {
                                references: [a, child],
                                bounds: pair.bounds,
                                other_bounds: bounds,
                            });
                        }
                    }
                }
                [a, b] => {
                    if let (Some(a), Some(b)) = (self.packet(a), other.packet(b)) {
                        add_meeting(a, b, &mut found);
                    }
                }
            }
        }
        found.sort_unstable();
        found
    }
}

/// The least and the greatest x, y and z.
type Bounds = [[f32; 2]; 3];

/// A node or leaf of each hierarchy, with their boxes in the frame of the first.
struct Pair {
    references: [u32; 2],
    bounds: Bounds,
    other_bounds: Bounds,
}

fn boxes_meet(a: Bounds, b: Bounds) -> bool {
    (0..3).all(|axis| a[axis][0] <= b[axis][1] && b[axis][0] <= a[axis][1])
}

/// Adds the children of a node whose boxes meet a box, each with what lies in that box.
fn push_children(node: &Node, other: u32, other_bounds: Bounds, rest: &mut Vec<Pair>) {
    let mut meets = [true; BRANCHES];
    for (axis, [low, high]) in other_bounds.into_iter().enumerate() {
        let [lower, upper] = [node.bounds[2 * axis], node.bounds[2 * axis + 1]];
        let is_below = lower.less_or_equal(Children::splat(high));
        let is_above = Children::splat(low).less_or_equal(upper);
        let both = (is_below & is_above).to_array();
        for (meets, both) in meets.iter_mut().zip(both) {
            *meets &= both;
        }
    }
    for (lane, &child) in node.children.iter().enumerate() {
        if meets[lane] && child != NOTHING {
            rest.push(Pair {
                references: [child, other],
                bounds: bounds_of(node, lane),
                other_bounds,
            });
        }
    }
}

fn bounds_of(node: &Node, lane: usize) -> Bounds {
    [0, 1, 2].map(|axis| [node.bounds[2 * axis][lane], node.bounds[2 * axis + 1][lane]])
}

/// The children of a node of another hierarchy, with their boxes in the frame of the first.
fn children_in(first: &Bvh, other: &Bvh, node: &Node) -> impl Iterator<Item = (u32, Bounds)> {
    let between = other.frame.centre - first.frame.centre;
    let (scale, other_scale) = (first.frame.scale, other.frame.scale);
    let children = node.children.iter().copied().enumerate();
    children
        .filter(|&(_, child)| child != NOTHING)
        .map(move |(lane, child)| {
            let bounds = bounds_of(node, lane);
            let bounds = [0, 1, 2].map(|axis| {
                // More than the rounding errors of both frames.
                let margin =
                    |x: f64| (x.abs() + between[axis].abs()) * (1.0 / (1_u64 << 48) as f64);
                let [low, high] = bounds[axis].map(|x| f64::from(x) / other_scale);
                let (low, high) = (low - margin(low), high + margin(high));
                [
                    rounded_down((between[axis] + low) * scale),
                    rounded_up((between[axis] + high) * scale),
                ]
            });
            (child, bounds)
        })
}

/// Adds the pairs of triangles of two packets that meet.
fn add_meeting(a: &Packet, b: &Packet, found: &mut Vec<[u32; 2]>) {
    for lane in a.lanes() {
        let corners = a.triangle(lane);
        for other in b.lanes() {
            if triangles_meet(corners, b.triangle(other)) {
                found.push([a.triangles[lane], b.triangles[other]]);
            }
        }
    }
}

/// Whether no axis separates two triangles.
///
/// In general position, one of the normals or of the products of two sides separates them if any
/// axis does. In one plane it is a perpendicular of a side in that plane, and for segments and
/// points a perpendicular of a side towards the other triangle, or the side itself.
fn triangles_meet(first: [Vector<f64>; 3], second: [Vector<f64>; 3]) -> bool {
    // Halfway, so that the answer is the same for the triangles in the other order.
    let origin = (first[0] + second[0]) * 0.5;
    let (first, second) = (first.map(|p| p - origin), second.map(|p| p - origin));
    let is_separated = |axis: Vector<f64>| {
        let [[low, high], [other_low, other_high]] =
            [first, second].map(|corners| interval(corners.map(|corner| corner.dot(axis))));
        high < other_low || other_high < low
    };
    let units = [Vector::X, Vector::Y, Vector::Z];
    if units.into_iter().any(is_separated) {
        return false;
    }
    let sides = [first, second].map(|[a, b, c]| [b - a, c - b, a - c]);
    let normals = sides.map(|[ab, bc, _]| ab.cross(bc));
    if normals.into_iter().any(is_separated) {
        return false;
    }
    let towards = second[0] - first[0];
    let all_sides = sides.as_flattened();
    let is_apart = is_separated(towards)
        || all_sides.iter().any(|&side| {
            is_separated(side)
                || is_separated(side.cross(side.cross(towards)))
                || normals
                    .into_iter()
                    .any(|normal| is_separated(normal.cross(side)))
        })
        || sides[0].into_iter().any(|side| {
            sides[1].into_iter().any(|other| {
                let across = side.cross(other);
                is_separated(across)
                    || is_separated(across.cross(side))
                    || is_separated(across.cross(other))
            })
        });
    !is_apart
}

/// The least and the greatest of three numbers.
fn interval([a, b, c]: [f64; 3]) -> [f64; 2] {
    [a.min(b).min(c), a.max(b).max(c)]
}
