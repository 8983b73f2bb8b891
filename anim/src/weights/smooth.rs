//! Smoother weights.
//!
//! Painted weights may change from one bone to the next within a single edge. Where the joint bends
//! strongly all of the bend then falls on that edge, as a ring about an elbow or a crease across a
//! chest, whichever way motions are blended. Averaging over neighbours distributes it.

use ga_mesh::topology::{Edges, Neighbours};

use super::SkinWeights;
use crate::weights::error::SkinError;

impl SkinWeights {
    /// The weights after some passes, in each of which the weights of a vertex move towards the
    /// mean of those of its neighbours along the edges of triangles by a share of the way (explicit
    /// diffusion; a share of ½ is usual). Vertices without triangles keep theirs.
    ///
    /// Every pass adds the influences of the neighbours: prune them by
    /// [`strongest`](Self::strongest).
    ///
    /// # Errors
    ///
    /// [`SkinError::Mesh`] and [`SkinError::BadShare`], and those of [`SkinWeights::new`].
    ///
    /// ```
    /// use ga_anim::weights::SkinWeights;
    ///
    /// // A strip whose middle changes from one joint to the other at once.
    /// let weights = SkinWeights::new(2, [[(0, 1.0)], [(0, 1.0)], [(1, 1.0)], [(1, 1.0)]])?;
    /// let smooth = weights.smoothed(&[[0, 1, 2], [1, 3, 2]], 1, 0.5)?;
    /// assert_eq!(smooth.influences(0)[0].weight, 0.75);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn smoothed(
        &self,
        triangles: &[[u32; 3]],
        passes: usize,
        share: f64,
    ) -> Result<Self, SkinError> {
        if !(0.0..=1.0).contains(&share) {
            return Err(SkinError::BadShare { share });
        }
        let edges = Edges::of_triangles(triangles, self.vertex_count())?;
        let neighbours = Neighbours::new(&edges);
        let mut result = self.clone();
        // The sums for a vertex by joint, and the joints that have one.
        let mut sums = vec![0.0; self.joint_count()];
        let mut touched: Vec<u32> = Vec::new();
        for _ in 0..passes {
            let mut rows = Vec::with_capacity(self.vertex_count());
            for vertex in 0..self.vertex_count() {
                let around = neighbours.of(vertex as u32);
                let own = if around.is_empty() { 1.0 } else { 1.0 - share };
                let mut add = |vertex: usize, factor: f64| {
                    for influence in result.influences(vertex) {
                        let sum: &mut f64 = &mut sums[influence.joint as usize];
                        if *sum == 0.0 {
                            touched.push(influence.joint);
                        }
                        *sum += factor * influence.weight;
                    }
                };
                add(vertex, own);
                for &other in around {
                    add(other as usize, share / around.len() as f64);
                }
                touched.sort_unstable();
                touched.dedup();
                let row: Vec<(u32, f64)> = touched
                    .iter()
                    .map(|&joint| (joint, sums[joint as usize]))
                    .collect();
                for joint in touched.drain(..) {
                    sums[joint as usize] = 0.0;
                }
                rows.push(row);
            }
            result = Self::new(self.joint_count(), rows)?;
        }
        Ok(result)
    }
}
