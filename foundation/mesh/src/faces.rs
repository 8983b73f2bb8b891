//! Lists of polygons.

use ga_runtime::vga3::Vector;

use crate::MeshError;
use crate::lists::{Lists, TooMany};
use crate::polygon::Triangulation;

/// Polygons, each a list of vertex indices in order along its boundary, in one block of memory.
///
/// Seen from outside, the corners run counter-clockwise.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Faces {
    polygons: Lists,
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
        let mut faces = Self::default();
        for polygon in polygons {
            faces.push(polygon.as_ref())?;
        }
        Ok(faces)
    }

    /// Faces that all have `N` corners, such as triangles, without a copy of each.
    ///
    /// # Errors
    ///
    /// As [`Faces::from_polygons`].
    ///
    /// # Examples
    ///
    /// ```
    /// let faces = ga_mesh::Faces::from_uniform(vec![[0, 1, 2], [0, 2, 3]])?;
    /// assert_eq!(faces.get(1), Some(&[0, 2, 3][..]));
    /// # Ok::<(), ga_mesh::MeshError>(())
    /// ```
    pub fn from_uniform<const N: usize>(polygons: Vec<[u32; N]>) -> Result<Self, MeshError> {
        if N < 3 && !polygons.is_empty() {
            let (face, corners) = (0, N);
            return Err(MeshError::FaceTooShort { face, corners });
        }
        let count = polygons.len().saturating_mul(N);
        if u32::try_from(count).is_err() {
            return Err(too_many(TooMany(count)));
        }
        let offsets = (0..=polygons.len()).map(|face| (face * N) as u32);
        Ok(Self {
            polygons: Lists::new(offsets.collect(), polygons.into_flattened()),
        })
    }

    /// Faces from lists of at least three corners each.
    pub(crate) fn from_lists(polygons: Lists) -> Self {
        Self { polygons }
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
        self.polygons.push(polygon).map_err(too_many)
    }

    /// How many faces there are.
    #[must_use]
    pub fn len(&self) -> usize {
        self.polygons.len()
    }

    /// Whether there is no face.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }

    /// The vertices of face `face`.
    #[must_use]
    pub fn get(&self, face: usize) -> Option<&[u32]> {
        self.polygons.get(face)
    }

    /// Where in [`Faces::corners`] the corners of `face` lie.
    ///
    /// # Panics
    ///
    /// When there is no such face.
    #[must_use]
    pub fn corner_range(&self, face: usize) -> std::ops::Range<usize> {
        let offsets = self.offsets();
        offsets[face] as usize..offsets[face + 1] as usize
    }

    /// Where in [`Faces::triangles`] those of `face` lie.
    ///
    /// # Panics
    ///
    /// When there is no such face.
    #[must_use]
    pub fn triangle_range(&self, face: usize) -> std::ops::Range<usize> {
        let corners = self.corner_range(face);
        corners.start - 2 * face..corners.end - 2 * (face + 1)
    }

    /// The corners of all faces, one face after the other.
    #[must_use]
    pub fn corners(&self) -> &[u32] {
        self.polygons.items()
    }

    /// Where in [`Faces::corners`] each face begins, and the end of the last: one number more than
    /// there are faces.
    #[must_use]
    pub fn offsets(&self) -> &[u32] {
        self.polygons.offsets()
    }

    /// The faces, one after the other.
    #[must_use]
    pub fn iter(&self) -> Polygons<'_> {
        Polygons {
            faces: self,
            next: 0,
        }
    }

    /// Every face split into triangles, in the order of the faces; a face of n corners gives n − 2
    /// triangles, with its orientation.
    ///
    /// Those of a flat face that does not cross itself cover it exactly, whether it is convex or
    /// not; corners at one place, as of a bridge to a hole, and corners on a straight line are
    /// allowed. Other faces are split as they look along their area vector. The triangles of a
    /// convex face share its first corner.
    ///
    /// # Panics
    ///
    /// When a face names a vertex that has no position.
    ///
    /// # Examples
    ///
    /// ```
    /// use ga_mesh::Faces;
    ///
    /// // An arrow head, whose diagonal between the first and the third corner lies outside.
    /// let arrow = [[0.0, 0.0, 0.0], [2.0, 1.0, 0.0], [0.5, 1.0, 0.0], [0.0, 2.0, 0.0]];
    /// let faces = Faces::from_polygons([[1, 2, 3, 0]])?;
    /// assert_eq!(faces.triangles(&arrow), [[1, 2, 0], [2, 3, 0]]);
    /// # Ok::<(), ga_mesh::MeshError>(())
    /// ```
    #[must_use]
    pub fn triangles<P: Copy + Into<Vector<f64>>>(&self, positions: &[P]) -> Vec<[u32; 3]> {
        let corners = self.corners();
        let mut triangles = self.corner_triangles(positions);
        for corner in triangles.as_flattened_mut() {
            *corner = corners[*corner as usize];
        }
        triangles
    }

    /// The same triangles as [`Faces::triangles`], each as three indices into
    /// [`Faces::corners`], by which attributes of corners are found.
    ///
    /// # Panics
    ///
    /// When a face names a vertex that has no position.
    #[must_use]
    pub fn corner_triangles<P: Copy + Into<Vector<f64>>>(&self, positions: &[P]) -> Vec<[u32; 3]> {
        let mut triangles = Vec::with_capacity(self.corners().len() - 2 * self.len());
        let mut triangulation = Triangulation::new();
        let position = |&vertex: &u32| positions[vertex as usize].into();
        for (face, &first) in self.iter().zip(self.offsets()) {
            let push = |triangle: [u32; 3]| triangles.push(triangle.map(|corner| first + corner));
            triangulation.split(face.iter().map(position), push);
        }
        triangles
    }
}

fn too_many(TooMany(count): TooMany) -> MeshError {
    let what = "corners";
    MeshError::TooLarge { what, count }
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
