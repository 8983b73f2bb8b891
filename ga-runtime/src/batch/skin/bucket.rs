//! The points of a chunk with one number of influences.

use alloc::vec;
use alloc::vec::Vec;

use crate::cga3::Point;
use crate::scalar::Real;
use crate::vga3::Vector;

/// Points with one number of influences, in the order of their indices. All lists but `order` are
/// padded to whole tiles, with weights of zero on the first joint.
#[derive(Clone, Debug)]
#[allow(unreachable_pub)]
pub struct Bucket<S> {
    /// The number of influences of each point.
    pub(crate) influences: usize,
    /// The index of each point in the chunk.
    pub(crate) order: Vec<u16>,
    /// Whether these indices are consecutive.
    pub(crate) is_run: bool,
    /// e1, e2, e3 and 1.
    pub(crate) points: Vec<[S; 4]>,
    /// e1, e2, e3 and 0; empty without normals.
    pub(crate) normals: Vec<[S; 4]>,
    /// e1, e2, e3 and 0; empty without tangents.
    pub(crate) tangents: Vec<[S; 4]>,
    /// The joints of each point, the heaviest first.
    pub(crate) joints: Vec<u16>,
    /// For the heaviest influence its joint; for the others the index of their pair with it, in the
    /// list of all joints followed by all pairs.
    pub(crate) signed: Vec<u32>,
    /// The weights of each point, in the same order.
    pub(crate) weights: Vec<S>,
}

impl<S: Real<Mask = bool> + Default> Bucket<S> {
    pub(crate) fn new(influences: usize) -> Self {
        Self {
            influences,
            order: Vec::new(),
            is_run: true,
            points: Vec::new(),
            normals: Vec::new(),
            tangents: Vec::new(),
            joints: Vec::new(),
            signed: Vec::new(),
            weights: Vec::new(),
        }
    }

    /// Adds a point whose influences are sorted from the heaviest down.
    pub(crate) fn push(
        &mut self,
        place: u16,
        point: Point<S>,
        row: &[(u32, S)],
        mut number: impl FnMut([u32; 2]) -> u32,
    ) {
        if let Some(&last) = self.order.last() {
            self.is_run &= last + 1 == place;
        }
        self.order.push(place);
        let [x, y, z] = point.coordinates();
        self.points.push([x, y, z, S::one()]);
        let heaviest = row[0].0;
        for (place, &(joint, weight)) in row.iter().enumerate() {
            self.joints.push(joint as u16);
            self.weights.push(weight);
            self.signed.push(if place == 0 {
                joint
            } else {
                number([heaviest, joint])
            });
        }
    }

    pub(crate) fn padded(mut self) -> Self {
        let whole = self.order.len().next_multiple_of(TILE);
        let zero = S::zero();
        self.points.resize(whole, [zero, zero, zero, S::one()]);
        self.joints.resize(whole * self.influences, 0);
        self.signed.resize(whole * self.influences, 0);
        self.weights.resize(whole * self.influences, zero);
        self
    }

    /// The directions of its points, with length 1.
    pub(crate) fn gathered(&self, directions: &[Vector<S>]) -> Vec<[S; 4]> {
        let mut gathered = vec![[S::zero(); 4]; self.points.len()];
        for (place, &index) in gathered.iter_mut().zip(&self.order) {
            let unit = directions[usize::from(index)]
                .normalized()
                .unwrap_or_default();
            let [x, y, z] = unit.coordinates();
            *place = [x, y, z, S::zero()];
        }
        gathered
    }
}

/// The number of points in a tile.
pub(crate) const TILE: usize = 32;

/// The coefficients of the sum of motors for each point of a tile.
pub(crate) type Motors<S> = [[S; TILE]; 8];
