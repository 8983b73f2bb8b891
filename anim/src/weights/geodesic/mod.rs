//! Skin weights from the distance to the bones through the body.
//!
//! The formula is that of [`super::distance`] (Cui, eq. 33) with the n nearest bones and
//! the exponent m, but L is the length of the shortest path from the point to the bone that stays
//! inside the body: a hand that hangs beside a thigh is near to it in space and far from it along
//! the arm, so the thigh does not move the hand.
//!
//! The body is the inside of the mesh. It is divided into cubic cells; two neighbours are connected
//! only if the surface does not pass between their centres, however thin the gap is. Distances
//! spread from the cells that see a bone by the fast marching method, which solves |∇L| = 1, and on
//! to the vertices: through the body to those that a cell sees, and along the edges of the mesh to
//! those of parts that are thinner than a cell. A vertex near to a bone that sees it takes its
//! distance exactly. All bones spread together, and only the n nearest go on from each place.
//!
//! Where there is no inside, since the surface is open or has no thickness, all distances go along
//! the edges, from the vertex that is nearest to the bone; [`GeodesicWeights::has_interior`] tells.
//!
//! Sources: J. A. Sethian, "A fast marching level set method for monotonically advancing fronts",
//! PNAS 93, 1996; O. Dionne, M. de Lasa, "Geodesic voxel binding for production character meshes",
//! Symposium on Computer Animation 2013.

mod march;
mod network;
mod volume;

use ga_mesh::query::Bvh;
use ga_runtime::cga3::Point;
use ga_runtime::vga3::Vector;

use super::SkinWeights;
use super::distance::{self, Bone};
use crate::weights::error::SkinError;
use network::Network;

/// The most cells along the longest side of the box about the mesh. A cell takes less than a byte,
/// and one inside the body some dozens.
const MOST_CELLS: usize = 256;

/// How weights are computed.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Options {
    /// The number n of bones that a point follows.
    pub influences: usize,
    /// The exponent m of the decrease with distance.
    pub exponent: f64,
    /// How many cells there are along the longest side of the box about the mesh, at most 256.
    pub resolution: usize,
}

impl Default for Options {
    fn default() -> Self {
        Self {
            influences: 4,
            exponent: 2.0,
            resolution: 128,
        }
    }
}

/// Weights, and how they came about.
#[derive(Clone, Debug, PartialEq)]
pub struct GeodesicWeights {
    /// The weights of all vertices.
    pub weights: SkinWeights,
    /// Whether the mesh has an inside. Without one, distances go along the surface.
    pub has_interior: bool,
    /// The vertices that no path from a bone reaches, such as those of an eye in its socket: they
    /// have the weights of the corner of a triangle that is nearest to them among those that are
    /// reached, or else the weights by distance in space.
    pub unreached: Vec<u32>,
}

/// The weights of the vertices of a mesh with respect to bones, given by head and tail in the order
/// of their joints.
///
/// # Errors
///
/// Those of [`distance_weights`](super::distance::distance_weights), and [`SkinError::Mesh`],
/// [`SkinError::NoTriangles`] and [`SkinError::BadResolution`].
///
/// # Examples
///
/// Two boxes side by side, a hand's breadth apart, each with its bone: neither bone moves the other
/// box.
///
/// ```
/// use ga_anim::weights::geodesic::{Options, geodesic_weights};
///
/// let corner = |x: f64, k: usize| [x + (k & 1) as f64, (k >> 1 & 1) as f64, (k >> 2) as f64];
/// let positions: Vec<[f64; 3]> =
///     [0.0, 1.1].iter().flat_map(|&x| (0..8).map(move |k| corner(x, k))).collect();
/// let faces =
///     [[0, 2, 3, 1], [4, 5, 7, 6], [0, 1, 5, 4], [2, 6, 7, 3], [0, 4, 6, 2], [1, 3, 7, 5]];
/// let triangles: Vec<[u32; 3]> = [0, 8]
///     .iter()
///     .flat_map(|first| faces.map(|quad| quad.map(|k: u32| k + first)))
///     .flat_map(|[a, b, c, d]| [[a, b, c], [a, c, d]])
///     .collect();
/// let bones = [[[0.5, 0.5, 0.1], [0.5, 0.5, 0.9]], [[1.6, 0.5, 0.1], [1.6, 0.5, 0.9]]];
///
/// let found = geodesic_weights(&positions, &triangles, &bones, &Options::default())?;
/// assert!(found.has_interior);
/// assert_eq!(found.weights.influences(1).len(), 1);
/// assert_eq!(found.weights.influences(8)[0].joint, 1);
/// # Ok::<(), ga_anim::skin::SkinError>(())
/// ```
pub fn geodesic_weights<P: Copy + Into<Point<f64>>>(
    positions: &[P],
    triangles: &[[u32; 3]],
    bones: &[Bone],
    options: &Options,
) -> Result<GeodesicWeights, SkinError> {
    distance::check(bones, options.influences, options.exponent)?;
    let resolution = options.resolution;
    if resolution == 0 || resolution > MOST_CELLS {
        return Err(SkinError::BadResolution { resolution });
    }
    let places: Vec<Vector<f64>> = positions.iter().map(|&p| Vector::from(p.into())).collect();
    if let Some(point) = places.iter().position(|p| !p.length().is_finite()) {
        let coordinates = places[point].coordinates();
        return Err(SkinError::BadPoint { point, coordinates });
    }
    let bvh = Bvh::new(positions, triangles)?;
    let network =
        Network::new(&places, triangles, &bvh, resolution).ok_or(SkinError::NoTriangles)?;
    let count = options.influences.min(bones.len());
    let found = march::march(&network, &places, bones, count, &bvh);
    let reached = |vertex: u32| !found.of_vertex(vertex as usize).is_empty();
    let unreached: Vec<u32> = (0..places.len() as u32).filter(|&v| !reached(v)).collect();
    let nearest = nearest_reached(&places, triangles, &unreached, reached)?;

    let mut rows: Vec<Vec<(u32, f64)>> = (0..places.len())
        .map(|vertex| distance::shares(found.of_vertex(vertex), options.exponent))
        .collect();
    for (&vertex, nearest) in unreached.iter().zip(nearest) {
        let place = places[vertex as usize].coordinates();
        rows[vertex as usize] = match nearest {
            Some(other) => rows[other as usize].clone(),
            None => {
                let near = distance::nearest(place, bones, count);
                if !near.iter().all(|(_, length)| length.is_finite()) {
                    let point = vertex as usize;
                    return Err(SkinError::BadPoint {
                        point,
                        coordinates: place,
                    });
                }
                distance::shares(&near, options.exponent)
            }
        };
    }
    Ok(GeodesicWeights {
        weights: SkinWeights::new(bones.len(), rows)?,
        has_interior: network.has_interior(),
        unreached,
    })
}

/// For each vertex that is not reached, the nearest corner of the nearest triangle that is.
fn nearest_reached(
    places: &[Vector<f64>],
    triangles: &[[u32; 3]],
    unreached: &[u32],
    reached: impl Fn(u32) -> bool,
) -> Result<Vec<Option<u32>>, SkinError> {
    if unreached.is_empty() {
        return Ok(Vec::new());
    }
    let whole: Vec<[u32; 3]> = triangles
        .iter()
        .copied()
        .filter(|t| t.iter().all(|&v| reached(v)))
        .collect();
    let points: Vec<Point<f64>> = places.iter().map(|&place| Point::from(place)).collect();
    let bvh = Bvh::new(&points, &whole)?;
    let nearest = |vertex: &u32| {
        let nearest = bvh.nearest(points[*vertex as usize]).ok()?;
        let corners = whole[nearest.triangle as usize];
        let heaviest = (0..3).max_by(|&a, &b| {
            nearest.barycentric[a]
                .total_cmp(&nearest.barycentric[b])
                .then(b.cmp(&a))
        })?;
        Some(corners[heaviest])
    };
    Ok(unreached.iter().map(nearest).collect())
}
