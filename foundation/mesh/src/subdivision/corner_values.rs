//! Values at the corners of faces.

use super::cage::Smoothing;
use super::{Boundary, Cage, Corner, Crease, Rules, Stencils, Tags, TextureRule};
use crate::topology::DisjointSets;
use crate::{Faces, MeshError};

/// Values at the corners of faces, such as texture coordinates, which may differ between the faces
/// at a vertex: OpenSubdiv's face-varying data.
///
/// Faces that meet at an edge without a seam have their values at its ends in common. The faces
/// connected in this way form charts, and the values a mesh of their own, with the same faces and
/// with boundaries at the seams. That mesh is refined by the same scheme as the positions, with the
/// same creases, and by a [`TextureRule`] at its boundary. So values stay on their side of every
/// seam.
///
/// A given value that faces on two separate spans around a vertex use, that is, with other values
/// between them on both sides, becomes two values, each with its own boundary. With
/// [`TextureRule::LinearCorners`] both are smooth, where OpenSubdiv keeps such a value sharp.
///
/// # Examples
///
/// ```
/// use ga_mesh::Faces;
/// use ga_mesh::subdivision::{Cage, CornerValues, Rules};
///
/// // Two triangles, with a seam along their common edge: value 3 is used by the second alone.
/// let cage = Cage::new(Faces::from_polygons([[0, 1, 2], [2, 1, 3]])?, 4, Rules::LOOP)?;
/// let corners = [0, 1, 2, 3, 1, 4].map(Some);
/// let values = CornerValues::new(&cage, &corners)?.expect("some corner has a value");
/// assert_eq!(values.sources(), [0, 1, 2, 3, 1, 4]);
///
/// let (fine, stencils) = values.refine()?;
/// assert_eq!(fine.corners().len(), 4 * corners.len());
/// // Both ends of the seam and its middle have a value for each side.
/// assert_eq!(stencils.row_count(), 6 + 6);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug)]
pub struct CornerValues {
    cage: Cage,
    sources: Vec<u32>,
    /// For each face of the mesh, how many corners it has, or 0 if it is without values.
    sizes: Vec<Size>,
}

/// The corners of a face, and whether it has values.
#[derive(Clone, Copy, Debug)]
struct Size {
    corners: u32,
    has_values: bool,
}

impl CornerValues {
    /// The values of a control mesh: for each corner, in the order of [`Faces::corners`], the index
    /// of its value. A face counts as having values when all its corners do. `None` when no face
    /// has values.
    ///
    /// # Errors
    ///
    /// [`MeshError::Length`] when there are not as many entries as corners.
    pub fn new(cage: &Cage, corners: &[Option<u32>]) -> Result<Option<Self>, MeshError> {
        let count = cage.faces().corners().len();
        if corners.len() != count {
            return Err(MeshError::Length {
                what: "values",
                expected: count,
                found: corners.len(),
            });
        }
        let range = |face| cage.faces().corner_range(face);
        let size = |face| Size {
            corners: range(face).len() as u32,
            has_values: corners[range(face)].iter().all(Option::is_some),
        };
        let sizes: Vec<Size> = (0..cage.faces().len()).map(size).collect();
        if !sizes.iter().any(|size| size.has_values) {
            return Ok(None);
        }

        let mut groups = DisjointSets::new(count);
        let mut continuous = vec![false; cage.edges().len()];
        for (edge, continuous) in (0..).zip(&mut continuous) {
            let Some(pairs) = corner_pairs(cage, edge) else {
                continue;
            };
            let same = |[one, other]: [u32; 2]| {
                let has_values =
                    |corner| sizes[cage.edges().face_of_corner(corner) as usize].has_values;
                corners[one as usize] == corners[other as usize]
                    && has_values(one)
                    && has_values(other)
            };
            if pairs.into_iter().all(same) {
                *continuous = true;
                pairs
                    .into_iter()
                    .for_each(|[one, other]| groups.unite(one, other));
            }
        }

        let (mut value_of_group, mut sources) = (vec![None; count], Vec::new());
        let mut value_of_corner = vec![None; count];
        let mut faces = Faces::default();
        for (face, _) in sizes.iter().enumerate().filter(|(_, size)| size.has_values) {
            let mut polygon = Vec::new();
            for corner in range(face) {
                let group = groups.find(corner as u32) as usize;
                let value = *value_of_group[group].get_or_insert_with(|| {
                    sources.extend(corners[corner]);
                    sources.len() as u32 - 1
                });
                value_of_corner[corner] = Some(value);
                polygon.push(value);
            }
            faces.push(&polygon)?;
        }

        let rules = cage.rules();
        let (boundary, smoothing) = match rules.texture {
            TextureRule::LinearAll => (Boundary::EdgeOnly, Smoothing::Linear),
            TextureRule::LinearBoundaries => (Boundary::EdgeOnly, Smoothing::FixedBoundary),
            TextureRule::LinearCorners => (Boundary::EdgeAndCorner, Smoothing::Smooth),
        };
        let rules = Rules { boundary, ..rules };
        let tags = tags(cage, &value_of_corner, &continuous);
        let cage =
            Cage::with_smoothing(faces, sources.len(), rules, smoothing)?.with_tags(&tags)?;
        Ok(Some(Self {
            cage,
            sources,
            sizes,
        }))
    }

    /// For each value of these corners, the index of the value that was given. A given value
    /// appears once for each group of faces that have it in common across edges; it does not appear
    /// if no face has it.
    #[must_use]
    pub fn sources(&self) -> &[u32] {
        &self.sources
    }

    /// For each corner of the mesh at this level, the index of its value.
    #[must_use]
    pub fn corners(&self) -> Vec<Option<u32>> {
        let mut values = self.cage.faces().corners().iter();
        let mut corners = Vec::new();
        for size in &self.sizes {
            for _ in 0..size.corners {
                corners.push(if size.has_values {
                    values.next().copied()
                } else {
                    None
                });
            }
        }
        corners
    }

    /// The values of the next level, and the stencils that compute them from those of this one.
    /// [`CornerValues::sources`] of the next level is empty, since its values are new.
    ///
    /// # Errors
    ///
    /// [`MeshError::RefinedTooLarge`].
    pub fn refine(&self) -> Result<(Self, Stencils), MeshError> {
        let refined = self.cage.refine()?;
        let sizes = self.sizes.iter().flat_map(|&size| {
            let children = self.cage.rules().scheme.children(size.corners);
            std::iter::repeat_n(
                Size {
                    corners: self.cage.rules().scheme.face_size(),
                    ..size
                },
                children as usize,
            )
        });
        let fine = Self {
            cage: refined.cage,
            sources: Vec::new(),
            sizes: sizes.collect(),
        };
        Ok((fine, refined.stencils))
    }
}

/// The corners of the two faces at an edge, as a pair at each of its ends.
fn corner_pairs(cage: &Cage, edge: u32) -> Option<[[u32; 2]; 2]> {
    let edges = cage.edges();
    let &[one, other] = edges.sides(edge) else {
        return None;
    };
    let next = |corner: u32| {
        let range = cage
            .faces()
            .corner_range(edges.face_of_corner(corner) as usize);
        if corner as usize + 1 == range.end {
            range.start as u32
        } else {
            corner + 1
        }
    };
    let vertex = |corner: u32| cage.faces().corners()[corner as usize];
    Some(if vertex(one) == vertex(other) {
        [[one, other], [next(one), next(other)]]
    } else {
        [[one, next(other)], [next(one), other]]
    })
}

/// The creases and corners of the positions as those of the values.
fn tags(cage: &Cage, value_of_corner: &[Option<u32>], continuous: &[bool]) -> Tags {
    let mut tags = Tags::default();
    for &Crease {
        vertices: [a, b],
        sharpness,
    } in cage.creases()
    {
        let Some(edge) = cage.edges().between(a, b) else {
            continue;
        };
        if !continuous[edge as usize] {
            continue;
        }
        if let Some([[one, _], [other, _]]) = corner_pairs(cage, edge)
            && let (Some(a), Some(b)) = (
                value_of_corner[one as usize],
                value_of_corner[other as usize],
            )
        {
            tags.creases.push(Crease {
                vertices: [a, b],
                sharpness,
            });
        }
    }
    if !cage.corners().is_empty() {
        for (&vertex, &value) in cage.faces().corners().iter().zip(value_of_corner) {
            let place = cage
                .corners()
                .binary_search_by_key(&vertex, |corner| corner.vertex);
            if let (Ok(place), Some(vertex)) = (place, value) {
                let sharpness = cage.corners()[place].sharpness;
                tags.corners.push(Corner { vertex, sharpness });
            }
        }
    }
    tags
}
