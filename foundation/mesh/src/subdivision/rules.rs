//! Which rules a subdivision follows.

use crate::Faces;

/// How faces are split and smoothed.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Scheme {
    /// Loop's scheme for triangles: each becomes four. With the valence n of a vertex and
    /// β = (5/8 − (3/8 + cos(2π/n)/4)²)/n, a vertex goes to (1 − nβ) v + β Σ eᵢ, where eᵢ are its
    /// neighbours. A new vertex on the edge ab between the triangles abc and bad is
    /// 3/8 (a + b) + 1/8 (c + d).
    ///
    /// C. Loop, *Smooth Subdivision Surfaces Based on Triangles*, master's thesis, University of
    /// Utah, 1987.
    Loop,
    /// Catmull and Clark's scheme for polygons: a face of k corners becomes k quadrilaterals. A
    /// new vertex in a face is the mean of its corners, one on an edge the mean of the ends and of
    /// the two vertices in the faces. A vertex of valence n goes to
    /// (n − 2)/n v + 1/n² Σ (eᵢ + fᵢ), with its neighbours eᵢ and the vertices fᵢ in its faces.
    ///
    /// E. Catmull and J. Clark, *Recursively generated B-spline surfaces on arbitrary topological
    /// meshes*, Computer-Aided Design 10, 1978.
    CatmullClark,
}

impl Scheme {
    /// Loop's where all faces are triangles, otherwise Catmull and Clark's.
    #[must_use]
    pub fn of_faces(faces: &Faces) -> Self {
        match faces.iter().all(|face| face.len() == 3) {
            true => Self::Loop,
            false => Self::CatmullClark,
        }
    }

    /// How many faces there are after a number of levels, or the greatest number where there are
    /// more than that.
    ///
    /// ```
    /// use ga_mesh::Faces;
    /// use ga_mesh::subdivision::Scheme;
    ///
    /// let pentagon = Faces::from_polygons([[0, 1, 2, 3, 4]])?;
    /// let scheme = Scheme::of_faces(&pentagon);
    /// assert_eq!([0, 1, 2].map(|n| scheme.refined_face_count(&pentagon, n)), [1, 5, 20]);
    /// # Ok::<(), ga_mesh::MeshError>(())
    /// ```
    #[must_use]
    pub fn refined_face_count(self, faces: &Faces, levels: u32) -> u64 {
        let (first, levels) = match (self, levels) {
            (Self::CatmullClark, 1..) => (faces.corners().len(), levels - 1),
            _ => (faces.len(), levels),
        };
        (first as u64).saturating_mul(4_u64.saturating_pow(levels))
    }

    /// How many corners the faces of a refined mesh have.
    pub(super) fn face_size(self) -> u32 {
        match self {
            Self::Loop => 3,
            Self::CatmullClark => 4,
        }
    }

    /// How many faces take the place of a face with this many corners.
    pub(super) fn children(self, corners: u32) -> u32 {
        match self {
            Self::Loop => 4,
            Self::CatmullClark => corners,
        }
    }
}

/// What happens at the boundary of a mesh. Edges of the boundary are infinitely sharp creases in
/// either case, so that the boundary becomes a cubic B-spline curve that depends on boundary
/// vertices alone.
///
/// OpenSubdiv calls this `VtxBoundaryInterpolation`.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Default)]
pub enum Boundary {
    /// All vertices of the boundary are smooth along it (`VTX_BOUNDARY_EDGE_ONLY`).
    #[default]
    EdgeOnly,
    /// Vertices of one face alone are infinitely sharp corners: they stay where they are
    /// (`VTX_BOUNDARY_EDGE_AND_CORNER`).
    EdgeAndCorner,
}

/// How the sharpness of a crease falls from level to level.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Default)]
pub enum CreaseMethod {
    /// By 1 a level (OpenSubdiv's `CREASE_UNIFORM`, called `normal` in its files).
    #[default]
    Normal,
    /// The half of an edge at one of its ends gets 3/4 of the edge's sharpness and 1/4 of the mean
    /// sharpness of the other creases at that end, less 1 (`CREASE_CHAIKIN`). Sharpness then varies
    /// smoothly along a chain of creases. Infinitely sharp edges neither change nor count.
    Chaikin,
}

/// How values at the corners of faces, such as texture coordinates, are refined.
///
/// A *seam* is an edge across which the values of the two faces differ at either end. Seams stay
/// seams under every rule. These are OpenSubdiv's rules for face-varying data; its
/// `FVAR_LINEAR_CORNERS_PLUS1` and `FVAR_LINEAR_CORNERS_PLUS2` are not offered.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Default)]
pub enum TextureRule {
    /// Every value is interpolated linearly on its face (`FVAR_LINEAR_ALL`).
    LinearAll,
    /// Values are linear along seams and boundaries, which keep the outlines of charts as they are,
    /// and smoothed like positions elsewhere (`FVAR_LINEAR_BOUNDARIES`).
    #[default]
    LinearBoundaries,
    /// Values are smoothed like positions, along seams like positions along a boundary; a value of
    /// one face alone is kept (`FVAR_LINEAR_CORNERS_ONLY`).
    LinearCorners,
}

/// The rules of a subdivision.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Rules {
    /// How faces are split and smoothed.
    pub scheme: Scheme,
    /// What happens at the boundary.
    pub boundary: Boundary,
    /// How creases become smooth.
    pub creases: CreaseMethod,
    /// How values at the corners of faces are refined.
    pub texture: TextureRule,
}

impl Rules {
    /// Loop's scheme with the default of every other rule.
    pub const LOOP: Self = Self::new(Scheme::Loop);

    /// Catmull and Clark's scheme with the default of every other rule.
    pub const CATMULL_CLARK: Self = Self::new(Scheme::CatmullClark);

    /// A scheme with the default of every other rule.
    #[must_use]
    pub const fn new(scheme: Scheme) -> Self {
        Self {
            scheme,
            boundary: Boundary::EdgeOnly,
            creases: CreaseMethod::Normal,
            texture: TextureRule::LinearBoundaries,
        }
    }
}
