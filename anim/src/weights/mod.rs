//! Skin weights: how much each joint moves each vertex.
//!
//! [`SkinWeights`] holds them, painted or computed; [`distance`] and [`geodesic`] compute them from
//! the bones; [`SkinWeights::smoothed`] spreads steep changes, [`SkinWeights::strongest`] keeps the
//! greatest.

pub mod distance;
pub(crate) mod error;
pub mod geodesic;
mod smooth;

use error::SkinError;

/// One joint's share in the motion of one vertex.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Influence {
    /// The joint, as an index into its skeleton.
    pub joint: u32,
    /// Its share, above 0 and at most 1.
    pub weight: f64,
}

/// For every vertex the joints that move it, as many as there are, with weights that sum to 1.
///
/// Kept as one list of influences and the place where each vertex begins (compressed sparse rows).
/// The influences of a vertex stay in the order they were given in.
///
/// # Examples
///
/// ```
/// use ga_anim::weights::{Influence, SkinWeights};
///
/// let weights = SkinWeights::new(2, [vec![(0, 3.0), (1, 1.0)], vec![(1, 0.5)]])?;
/// assert_eq!(weights.influences(0)[0], Influence { joint: 0, weight: 0.75 });
/// assert_eq!(weights.strongest(1).influences(0), [Influence { joint: 0, weight: 1.0 }]);
/// # Ok::<(), ga_anim::skin::SkinError>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct SkinWeights {
    joint_count: usize,
    /// Where in `influences` each vertex begins, and the end of the last.
    offsets: Vec<u32>,
    influences: Vec<Influence>,
}

impl SkinWeights {
    /// Weights for the vertices in their order, each a list of (joint, weight), divided by their
    /// sum. A weight of 0 is left out.
    ///
    /// # Errors
    ///
    /// [`SkinError::Unweighted`], [`SkinError::BadWeight`], [`SkinError::JointOutOfRange`],
    /// [`SkinError::DuplicateJoint`] and [`SkinError::TooManyInfluences`].
    pub fn new<V: AsRef<[(u32, f64)]>>(
        joint_count: usize,
        vertices: impl IntoIterator<Item = V>,
    ) -> Result<Self, SkinError> {
        let mut result = Self {
            joint_count,
            offsets: vec![0],
            influences: Vec::new(),
        };
        for (vertex, list) in vertices.into_iter().enumerate() {
            result.push_checked(vertex, list.as_ref())?;
        }
        Ok(result)
    }

    /// How many vertices have weights.
    #[must_use]
    pub fn vertex_count(&self) -> usize {
        self.offsets.len() - 1
    }

    /// How many joints the skeleton has that the weights were made for.
    #[must_use]
    pub fn joint_count(&self) -> usize {
        self.joint_count
    }

    /// The influences on a vertex; none for a vertex that does not exist.
    #[must_use]
    pub fn influences(&self, vertex: usize) -> &[Influence] {
        match self.offsets.get(vertex + 1) {
            Some(&end) => &self.influences[self.offsets[vertex] as usize..end as usize],
            None => &[],
        }
    }

    /// The influences on each vertex, one vertex after the other.
    pub fn iter(&self) -> impl ExactSizeIterator<Item = &[Influence]> + '_ {
        self.offsets
            .windows(2)
            .map(|row| &self.influences[row[0] as usize..row[1] as usize])
    }

    /// The greatest number of influences on one vertex.
    #[must_use]
    pub fn max_influences(&self) -> usize {
        self.iter().map(<[_]>::len).max().unwrap_or(0)
    }

    /// The same weights with at most `count` influences (at least one) on each vertex: the
    /// greatest, from the greatest down, divided by their sum. Between equal weights the one listed
    /// first stays.
    #[must_use]
    pub fn strongest(&self, count: usize) -> Self {
        let mut result = Self {
            joint_count: self.joint_count,
            offsets: vec![0],
            influences: Vec::new(),
        };
        let mut row = Vec::new();
        for influences in self.iter() {
            row.clear();
            row.extend_from_slice(influences);
            row.sort_by(|a, b| b.weight.total_cmp(&a.weight));
            row.truncate(count.max(1));
            result.push_normalised(&row);
        }
        result
    }

    /// The weights of these vertices in this order, as for a [`Part`](ga_mesh::Part) of a mesh,
    /// or `None` when one of them does not exist.
    #[must_use]
    pub fn select(&self, vertices: &[u32]) -> Option<Self> {
        let mut result = Self {
            joint_count: self.joint_count,
            offsets: vec![0],
            influences: Vec::new(),
        };
        for &vertex in vertices {
            if vertex as usize >= self.vertex_count() {
                return None;
            }
            result
                .influences
                .extend_from_slice(self.influences(vertex as usize));
            result
                .offsets
                .push(u32::try_from(result.influences.len()).ok()?);
        }
        Some(result)
    }

    fn push_checked(&mut self, vertex: usize, list: &[(u32, f64)]) -> Result<(), SkinError> {
        let joints = self.joint_count;
        let mut row: Vec<Influence> = Vec::with_capacity(list.len());
        for &(joint, weight) in list {
            if joint as usize >= joints {
                return Err(SkinError::JointOutOfRange {
                    vertex,
                    joint,
                    joints,
                });
            }
            if !weight.is_finite() || weight < 0.0 {
                return Err(SkinError::BadWeight {
                    vertex,
                    joint,
                    weight,
                });
            }
            if row.iter().any(|influence| influence.joint == joint) {
                return Err(SkinError::DuplicateJoint { vertex, joint });
            }
            if weight > 0.0 {
                row.push(Influence { joint, weight });
            }
        }
        if row.is_empty() {
            return Err(SkinError::Unweighted { vertex });
        }
        // Dividing by the greatest first keeps the sum finite and above 0.
        let greatest = row
            .iter()
            .map(|influence| influence.weight)
            .fold(0.0, f64::max);
        for influence in &mut row {
            influence.weight /= greatest;
        }
        row.retain(|influence| influence.weight > 0.0);
        if u32::try_from(self.influences.len() + row.len()).is_err() {
            return Err(SkinError::TooManyInfluences);
        }
        self.push_normalised(&row);
        Ok(())
    }

    fn push_normalised(&mut self, row: &[Influence]) {
        let sum: f64 = row.iter().map(|influence| influence.weight).sum();
        self.influences
            .extend(row.iter().map(|influence| Influence {
                weight: influence.weight / sum,
                ..*influence
            }));
        self.offsets.push(self.influences.len() as u32);
    }
}
