//! Lists of polygons.

use crate::MeshError;

/// Polygons, each a list of vertex indices in order along its boundary, in one block of memory.
///
/// Seen from outside, the corners run counter-clockwise.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Faces {
    /// Where in `corners` each face begins, and the end of the last.
    offsets: Vec<u32>,
    corners: Vec<u32>,
}

/// The polygons of [`Faces`], one after the other.
#[derive(Clone, Debug)]
pub struct Polygons<'a> {
    faces: &'a Faces,
    next: usize,
}

impl Faces {
    /// Faces from the lists of their corners.
    ///
    /// # Errors
    ///
    /// [`MeshError::FaceTooShort`] for a face of fewer than three corners; [`MeshError::TooLarge`]
    /// past 2³² − 1 corners.
    pub fn from_polygons<P: AsRef<[u32]>>(
        polygons: impl IntoIterator<Item = P>,
    ) -> Result<Self, MeshError> {
        let mut faces = Self {
            offsets: vec![0],
            corners: Vec::new(),
        };
        for polygon in polygons {
            faces.push(polygon.as_ref())?;
        }
        Ok(faces)
    }

    /// Adds a face at the end.
    ///
    /// # Errors
    ///
    /// As [`Faces::from_polygons`]; the face is then not added.
    pub fn push(&mut self, polygon: &[u32]) -> Result<(), MeshError> {
        if polygon.len() < 3 {
            let (face, corners) = (self.len(), polygon.len());
            return Err(MeshError::FaceTooShort { face, corners });
        }
        let count = self.corners.len() + polygon.len();
        let end = u32::try_from(count).map_err(|_| MeshError::TooLarge {
            what: "corners",
            count,
        })?;
        self.corners.extend_from_slice(polygon);
        self.offsets.push(end);
        Ok(())
    }

    /// How many faces there are.
    #[must_use]
    pub fn len(&self) -> usize {
        self.offsets.len() - 1
    }

    /// Whether there is no face.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }

    /// The vertices of face `face`.
    #[must_use]
    pub fn get(&self, face: usize) -> Option<&[u32]> {
        let end = *self.offsets.get(face + 1)? as usize;
        Some(&self.corners[self.offsets[face] as usize..end])
    }

    /// Where in [`Faces::corners`] the corners of `face` lie.
    pub(crate) fn corner_range(&self, face: usize) -> std::ops::Range<usize> {
        self.offsets[face] as usize..self.offsets[face + 1] as usize
    }

    /// The corners of all faces, one face after the other.
    #[must_use]
    pub fn corners(&self) -> &[u32] {
        &self.corners
    }

    /// Where in [`Faces::corners`] each face begins, and the end of the last: one number more than
    /// there are faces.
    #[must_use]
    pub fn offsets(&self) -> &[u32] {
        &self.offsets
    }

    /// The faces, one after the other.
    #[must_use]
    pub fn iter(&self) -> Polygons<'_> {
        Polygons {
            faces: self,
            next: 0,
        }
    }

    /// Every face split into triangles that share its first corner, in the order of the faces; a
    /// face of n corners gives n − 2 triangles. For convex flat faces the surface stays the same;
    /// the shape of other faces depends on which corner comes first.
    #[must_use]
    pub fn triangles(&self) -> Vec<[u32; 3]> {
        let mut triangles = Vec::with_capacity(self.corners.len() - 2 * self.len());
        for face in self {
            triangles.extend(face[1..].windows(2).map(|edge| [face[0], edge[0], edge[1]]));
        }
        triangles
    }
}

impl Default for Faces {
    /// No faces.
    fn default() -> Self {
        Self {
            offsets: vec![0],
            corners: Vec::new(),
        }
    }
}

impl<'a> IntoIterator for &'a Faces {
    type Item = &'a [u32];
    type IntoIter = Polygons<'a>;

    fn into_iter(self) -> Polygons<'a> {
        self.iter()
    }
}

impl<'a> Iterator for Polygons<'a> {
    type Item = &'a [u32];

    fn next(&mut self) -> Option<&'a [u32]> {
        let face = self.faces.get(self.next)?;
        self.next += 1;
        Some(face)
    }

    fn size_hint(&self) -> (usize, Option<usize>) {
        let left = self.faces.len() - self.next;
        (left, Some(left))
    }
}

impl ExactSizeIterator for Polygons<'_> {}
