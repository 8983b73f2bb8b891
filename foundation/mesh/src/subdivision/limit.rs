//! Points and normals of the limit surface.

use std::f64::consts::{PI, TAU};

use ga_runtime::vga3::Vector;

use super::loops::beta;
use super::sharpness::{Rule, Sharpness};
use super::stencils::{Builder, StencilLength, Stencils};
use super::{Cage, Scheme};
use crate::MeshError;
use crate::topology::{Fan, VertexRings};

/// Where the vertices of a control mesh go when it is refined without end, and two tangents of the
/// surface there.
///
/// The weights are left eigenvectors of the matrix that refines a vertex and its ring. With the
/// vertex v, its n neighbours eᵢ counter-clockwise and, in Catmull and Clark's scheme, the vertices
/// fᵢ diagonally opposite in the quadrilaterals between eᵢ and eᵢ₊₁:
///
/// | vertex | Loop | Catmull–Clark |
/// | --- | --- | --- |
/// | smooth | (1 − nω) v + ω Σ eᵢ, ω = 1/(n + 3/(8β)) | (n² v + Σ (4 eᵢ + fᵢ))/(n (n + 5)) |
/// | crease | 2/3 v + 1/6 (a + b) | the same |
/// | corner | v | the same |
///
/// where a and b are the neighbours along the crease. The tangents of a smooth vertex are
/// Σ cos(2πi/n) eᵢ and Σ sin(2πi/n) eᵢ in Loop's scheme, with weights for the fᵢ as well in Catmull
/// and Clark's; see [`Limit::new`] for those of creases and corners.
///
/// Sources: M. Halstead, M. Kass and T. DeRose, *Efficient, fair interpolation using Catmull–Clark
/// surfaces*, SIGGRAPH 1993; H. Hoppe et al., *Piecewise smooth surface reconstruction*, SIGGRAPH
/// 1994; H. Biermann, A. Levin and D. Zorin, *Piecewise smooth subdivision surfaces with normal
/// control*, SIGGRAPH 2000; the masks of OpenSubdiv's `Sdc::Scheme`.
///
/// # Examples
///
/// ```
/// use ga_mesh::Faces;
/// use ga_mesh::subdivision::{Cage, Limit, Rules};
///
/// let octahedron = [[1, 0, 0], [-1, 0, 0], [0, 1, 0], [0, -1, 0], [0, 0, 1], [0, 0, -1]];
/// let positions = octahedron.map(|x| x.map(f64::from));
/// let upper = [[0, 2, 4], [2, 1, 4], [1, 3, 4], [3, 0, 4]];
/// let lower = [[2, 0, 5], [1, 2, 5], [3, 1, 5], [0, 3, 5]];
/// let faces = upper.into_iter().chain(lower);
/// let cage = Cage::new(Faces::from_polygons(faces)?, 6, Rules::LOOP)?;
///
/// let limit = Limit::new(&cage)?;
/// let [x, y, z] = limit.positions.applied(&positions)?[4];
/// assert!(x == 0.0 && y == 0.0 && 0.4 < z && z < 0.5);
/// assert_eq!(limit.normals(&positions)?[4], [0.0, 0.0, 1.0]);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Limit {
    /// The point of the limit surface for each vertex, as a weighted sum of the vertices.
    pub positions: Stencils,
    /// Two directions in the tangent plane there, which form a right-handed frame with the outward
    /// normal. Their lengths mean nothing.
    pub tangents: [Stencils; 2],
}

impl Limit {
    /// The limit of each vertex of a control mesh.
    ///
    /// A crease or corner that is still sharp counts as infinitely sharp, as in OpenSubdiv; refine
    /// the mesh until it is not, if its limit is wanted. Where faces of Catmull and Clark's scheme
    /// are not quadrilaterals, the limit is taken one level finer, where it is the same.
    ///
    /// - On a crease the first tangent runs along it. The second lies in the surface to the left of
    ///   it. It belongs to the greatest eigenvalue among the vectors that are symmetric about the
    ///   middle of the k faces there: with θ = π/k the edges inside have the weights sin(iθ), and
    ///   the vertex and the crease edges the weights that solve the two remaining equations. For
    ///   k = 1, 2 and 3 of Loop's scheme and k = 1 and 2 of Catmull and Clark's these are
    ///   OpenSubdiv's weights; for other k, OpenSubdiv's are close to them. Inside a surface the
    ///   side of the first face is taken.
    /// - At a corner the tangents point along two sharp edges that follow each other around the
    ///   vertex. Where there are not two, the surface has a tip without a tangent plane, and the
    ///   first two edges stand in for it.
    /// - A vertex of two triangles or quadrilaterals that are back to back has no tangent plane,
    ///   nor has a vertex without faces: their tangents are 0.
    ///
    /// # Errors
    ///
    /// [`MeshError::RefinedTooLarge`], where a finer level is needed.
    pub fn new(cage: &Cage) -> Result<Self, MeshError> {
        let of_quadrilaterals = cage.faces().iter().all(|polygon| polygon.len() == 4);
        if cage.rules().scheme == Scheme::CatmullClark && !of_quadrilaterals {
            let fine = cage.refine()?;
            let limit = Self::of_regular(&fine.cage);
            let of_coarse = |stencils: Stencils| {
                let stencils = stencils.truncated(cage.vertex_count());
                fine.stencils
                    .then(&stencils)
                    .expect("one level follows the other")
            };
            return Ok(Self {
                positions: of_coarse(limit.positions),
                tangents: limit.tangents.map(of_coarse),
            });
        }
        Ok(Self::of_regular(cage))
    }

    /// The unit normal of the limit surface at each vertex, on the side from which the faces run
    /// counter-clockwise; the zero vector where the tangents span no plane.
    ///
    /// # Errors
    ///
    /// [`StencilLength`] when there are not as many positions as vertices.
    pub fn normals(&self, positions: &[[f64; 3]]) -> Result<Vec<[f64; 3]>, StencilLength> {
        let [first, second] = &self.tangents;
        let (first, second) = (first.applied(positions)?, second.applied(positions)?);
        let normal = |(first, second): ([f64; 3], [f64; 3])| {
            let normal = Vector::from(first).cross(Vector::from(second));
            normal.normalized().unwrap_or_default().coordinates()
        };
        Ok(first.into_iter().zip(second).map(normal).collect())
    }

    /// The faces are those to which the scheme leads: triangles or quadrilaterals.
    fn of_regular(cage: &Cage) -> Self {
        let vertices = cage.vertex_count();
        let edges = cage.edges();
        let sharpness = Sharpness::new(cage);
        let rings = VertexRings::new(cage.faces(), edges);
        let mut builders = [(); 3].map(|()| Builder::new(vertices, 8 * vertices));
        let mut masks = Masks::default();
        for vertex in 0..vertices as u32 {
            masks.begin(vertex);
            if let Some(fan) = rings.fans(vertex).next() {
                masks.push_ring(cage, vertex, fan);
                let (rule, _) = sharpness.of_vertex(vertex, &masks.neighbours);
                masks.fill(cage.rules().scheme, &sharpness, vertex, rule);
            }
            for (mask, builder) in masks.rows.iter_mut().zip(&mut builders) {
                mask.retain(|&(_, weight)| weight != 0.0);
                if mask.is_empty() {
                    mask.push((vertex, 0.0));
                }
                builder.own(mask);
            }
        }
        let [positions, first, second] = builders.map(Builder::finish);
        Self {
            positions,
            tangents: [first, second],
        }
    }
}

/// The ring of a vertex and the rows of its position and tangents.
#[derive(Default)]
struct Masks {
    /// The other ends of the edges, counter-clockwise.
    neighbours: Vec<u32>,
    /// For Catmull and Clark's scheme the vertices diagonally opposite, each after the neighbour of
    /// the same index.
    diagonals: Vec<u32>,
    rows: [Vec<(u32, f64)>; 3],
}

impl Masks {
    fn begin(&mut self, vertex: u32) {
        self.neighbours.clear();
        self.diagonals.clear();
        self.rows = Default::default();
        self.rows[0].push((vertex, 1.0));
    }

    fn push_ring(&mut self, cage: &Cage, vertex: u32, fan: Fan<'_>) {
        let edges = fan.edges.iter();
        self.neighbours
            .extend(edges.map(|&edge| cage.edges().other_end(edge, vertex)));
        if cage.rules().scheme == Scheme::CatmullClark {
            let corners = cage.faces().corners();
            let diagonal = |&corner: &u32| {
                let first = corner - corner % 4;
                corners[(first + (corner + 2) % 4) as usize]
            };
            self.diagonals.extend(fan.corners.iter().map(diagonal));
        }
    }

    fn fill(&mut self, scheme: Scheme, sharpness: &Sharpness<'_>, vertex: u32, rule: Rule) {
        match rule {
            Rule::Smooth => match scheme {
                Scheme::Loop => self.smooth_loop(vertex),
                Scheme::CatmullClark => self.smooth_catmull_clark(vertex),
            },
            Rule::Crease([a, b]) => {
                self.rows[0] = vec![(vertex, 2.0 / 3.0), (a, 1.0 / 6.0), (b, 1.0 / 6.0)];
                self.rows[1] = vec![(a, 1.0), (b, -1.0)];
                let place = |end| self.neighbours.iter().position(|&other| other == end);
                let (Some(first), Some(last)) = (place(a), place(b)) else {
                    return;
                };
                match scheme {
                    Scheme::Loop => self.across_loop(vertex, first, last),
                    Scheme::CatmullClark => self.across_catmull_clark(vertex, first, last),
                }
            }
            Rule::Corner => {
                let mut sharp = self.neighbours.iter().copied();
                let mut sharp = sharp
                    .by_ref()
                    .filter(|&end| sharpness.is_sharp(vertex, end));
                let ends = match (sharp.next(), sharp.next()) {
                    (Some(a), Some(b)) => [a, b],
                    _ => [self.neighbours[0], self.neighbours[1]],
                };
                for (row, end) in self.rows[1..].iter_mut().zip(ends) {
                    *row = vec![(end, 1.0), (vertex, -1.0)];
                }
            }
        }
    }

    fn smooth_loop(&mut self, vertex: u32) {
        let n = self.neighbours.len();
        let share = 1.0 / (n as f64 + 0.375 / beta(n));
        self.rows[0] = vec![(vertex, 1.0 - n as f64 * share)];
        for (i, &neighbour) in self.neighbours.iter().enumerate() {
            self.rows[0].push((neighbour, share));
            let (sin, cos) = sin_cos(i, n);
            self.rows[1].push((neighbour, cos));
            self.rows[2].push((neighbour, sin));
        }
    }

    fn smooth_catmull_clark(&mut self, vertex: u32) {
        let n = self.neighbours.len();
        let share = 1.0 / (n * (n + 5)) as f64;
        self.rows[0] = vec![(vertex, (n * n) as f64 * share)];
        let scale = 1.0 / (4.0 * eigenvalue((TAU / n as f64).cos()) - 1.0);
        for (i, (&neighbour, &diagonal)) in self.neighbours.iter().zip(&self.diagonals).enumerate()
        {
            self.rows[0].extend([(neighbour, 4.0 * share), (diagonal, share)]);
            let ((sin, cos), (next_sin, next_cos)) = (sin_cos(i, n), sin_cos(i + 1, n));
            // Vertices of two quadrilaterals have no tangent plane.
            if n > 2 {
                self.rows[1].extend([(neighbour, 4.0 * cos), (diagonal, scale * (cos + next_cos))]);
                self.rows[2].extend([(neighbour, 4.0 * sin), (diagonal, scale * (sin + next_sin))]);
            }
        }
    }

    /// The tangent across a crease from neighbour `first` to neighbour `last`.
    ///
    /// With λ = 3/8 + cos(θ)/4 and sin(iθ) as the weights inside, the columns of a crease edge and
    /// of the vertex leave (λ − 1/2) l − w/8 = sin(θ)/8 and (λ − 3/4) w − l = 3/8 Σ sin(iθ) for
    /// the weights l of each crease edge and w of the vertex; Σ sin(iθ) = cot(θ/2).
    fn across_loop(&mut self, vertex: u32, first: usize, last: usize) {
        let faces = last - first;
        let (sin, cos) = (PI / faces as f64).sin_cos();
        let (own, end) = if faces == 1 {
            (-2.0, 1.0)
        } else {
            let cotangent = (1.0 + cos) / sin;
            let determinant = (2.0 * cos + 1.0) * (2.0 * cos - 5.0);
            (
                ((2.0 * cos - 1.0) * 3.0 * cotangent + 8.0 * sin) / determinant,
                ((2.0 * cos - 3.0) * sin + 3.0 * cotangent) / determinant,
            )
        };
        self.push_ends(vertex, first, last, own, end);
        for i in 1..faces {
            let weight = (PI * i as f64 / faces as f64).sin();
            self.rows[2].push((self.neighbours[first + i], weight));
        }
    }

    /// As [`Masks::across_loop`]: with λ as of the smooth vertex, sin(iθ) inside and
    /// (sin((i − 1)θ) + sin(iθ))/(4 (4λ − 1)) as the weights φᵢ of the faces, the two equations are
    /// (λ − 1/2) l − w/8 = sin(θ)/16 + φ₁/4 and (λ − 3/4) w − l = 3/8 Σ sin(iθ) + 1/4 Σ φᵢ.
    fn across_catmull_clark(&mut self, vertex: u32, first: usize, last: usize) {
        let faces = last - first;
        if faces == 1 {
            self.push_ends(vertex, first, last, -2.0, 1.0);
            return;
        }
        let theta = PI / faces as f64;
        let (sin, cos) = theta.sin_cos();
        let lambda = eigenvalue(cos);
        let scale = 1.0 / (4.0 * (4.0 * lambda - 1.0));
        let cotangent = (1.0 + cos) / sin;
        let of_edge = sin / 16.0 + 0.25 * scale * sin;
        let of_vertex = 0.375 * cotangent + 0.5 * scale * cotangent;
        let determinant = (lambda - 1.0) * (lambda - 0.25);
        self.push_ends(
            vertex,
            first,
            last,
            ((lambda - 0.5) * of_vertex + of_edge) / determinant,
            (of_edge * (lambda - 0.75) + of_vertex / 8.0) / determinant,
        );
        let weight = |i: usize| (theta * i as f64).sin();
        for i in 1..faces {
            self.rows[2].push((self.neighbours[first + i], weight(i)));
        }
        for i in 0..faces {
            let weight = scale * (weight(i) + weight(i + 1));
            self.rows[2].push((self.diagonals[first + i], weight));
        }
    }

    fn push_ends(&mut self, vertex: u32, first: usize, last: usize, own: f64, end: f64) {
        let (a, b) = (self.neighbours[first], self.neighbours[last]);
        self.rows[2].extend([(vertex, own), (a, end), (b, end)]);
    }
}

/// The greatest eigenvalue, apart from 1, of Catmull and Clark's scheme among vectors that go with
/// cos(iθ), where this is the cosine of θ.
fn eigenvalue(cos: f64) -> f64 {
    (5.0 + cos + ((cos + 9.0) * (cos + 1.0)).sqrt()) / 16.0
}

/// The sine and cosine of i n-ths of a full turn; exact for quarters of one.
fn sin_cos(i: usize, n: usize) -> (f64, f64) {
    match (4 * i).checked_rem(n) {
        Some(0) => [(0.0, 1.0), (1.0, 0.0), (0.0, -1.0), (-1.0, 0.0)][4 * i / n % 4],
        _ => (TAU * i as f64 / n as f64).sin_cos(),
    }
}
