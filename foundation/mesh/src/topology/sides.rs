//! The sides of faces, one after the other.

use crate::{Faces, MeshError};

/// Lists of faces of one kind. The loops over their sides are compiled for each kind.
pub(super) trait Sides: Copy {
    /// How many sides, which is how many corners, there are.
    fn count(self) -> usize;

    /// Calls `side(corner, from, to)` for each side, in the order of the corners.
    fn each(self, side: impl FnMut(u32, u32, u32));

    /// For each corner its face; `None` where every face has three corners.
    fn faces(self) -> Option<Vec<u32>>;
}

/// Triangles: three corners after three.
#[derive(Clone, Copy)]
pub(super) struct Triangles<'a>(pub(super) &'a [[u32; 3]]);

/// Polygons.
#[derive(Clone, Copy)]
pub(super) struct Polygons<'a>(pub(super) &'a Faces);

impl Sides for Triangles<'_> {
    fn count(self) -> usize {
        3 * self.0.len()
    }

    #[inline]
    fn each(self, mut side: impl FnMut(u32, u32, u32)) {
        let mut corner = 0;
        for &[a, b, c] in self.0 {
            side(corner, a, b);
            side(corner + 1, b, c);
            side(corner + 2, c, a);
            corner += 3;
        }
    }

    fn faces(self) -> Option<Vec<u32>> {
        None
    }
}

impl Sides for Polygons<'_> {
    fn count(self) -> usize {
        self.0.corners().len()
    }

    #[inline]
    fn each(self, mut side: impl FnMut(u32, u32, u32)) {
        let mut corner = 0;
        for face in self.0 {
            for (here, &from) in face.iter().enumerate() {
                let to = face.get(here + 1).unwrap_or(&face[0]);
                side(corner, from, *to);
                corner += 1;
            }
        }
    }

    fn faces(self) -> Option<Vec<u32>> {
        let mut faces = Vec::with_capacity(self.count());
        for (face, polygon) in self.0.iter().enumerate() {
            faces.extend(std::iter::repeat_n(face as u32, polygon.len()));
        }
        Some(faces)
    }
}

/// The corners as triangles, where every face is one.
pub(super) fn as_triangles(faces: &Faces) -> Option<&[[u32; 3]]> {
    let (triangles, rest) = faces.corners().as_chunks();
    let all = rest.is_empty()
        && triangles.len() == faces.len()
        && faces
            .offsets()
            .windows(2)
            .all(|ends| ends[1] - ends[0] == 3);
    all.then_some(triangles)
}

/// Checks that every vertex exists and that 32-bit indices suffice.
pub(super) fn check<S: Sides>(sides: S, vertices: usize) -> Result<(), MeshError> {
    for (what, count) in [("vertices", vertices), ("corners", sides.count())] {
        if u32::try_from(count).is_err() {
            return Err(MeshError::TooLarge { what, count });
        }
    }
    let mut largest = 0;
    sides.each(|_, from, _| largest = largest.max(from));
    if (largest as usize) < vertices || sides.count() == 0 {
        return Ok(());
    }
    let mut first = None;
    sides.each(|corner, from, _| {
        if from as usize >= vertices {
            first.get_or_insert((corner, from));
        }
    });
    let Some((corner, index)) = first else {
        return Ok(());
    };
    let face = match sides.faces() {
        Some(faces) => faces[corner as usize] as usize,
        None => corner as usize / 3,
    };
    Err(MeshError::IndexOutOfRange {
        face,
        index,
        vertices,
    })
}
