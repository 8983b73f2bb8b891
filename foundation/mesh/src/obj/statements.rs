//! What an OBJ file says.

use ga_runtime::vga3::Vector;

use super::ObjProblem;
use crate::colour_range::ColourRange;
use crate::{Faces, Group, Polylines};

/// What an OBJ file says, indices checked and counted from 0.
#[derive(Default)]
pub(super) struct Statements {
    pub(super) positions: Vec<[f64; 3]>,
    /// Empty, or one for each position; the colour in the file's colour space and range.
    pub(super) colours: Vec<[f64; 4]>,
    /// The ranges of red, green and blue, and of alpha, by lines.
    pub(super) colour_range: ColourRange<usize>,
    pub(super) alpha_range: ColourRange<usize>,
    pub(super) texture: Vec<[f64; 2]>,
    pub(super) normals: Vec<Vector<f64>>,
    pub(super) faces: Faces,
    /// Empty, or one for each corner of the faces.
    pub(super) texture_corners: Vec<Option<u32>>,
    pub(super) normal_corners: Vec<Option<u32>>,
    pub(super) groups: Vec<Group>,
    pub(super) objects: Vec<Group>,
    /// The names of `usemtl` lines, and where each is named first.
    pub(super) materials: Vec<(String, usize)>,
    /// Empty, or one for each face.
    pub(super) face_materials: Vec<Option<u32>>,
    /// What `mtllib` lines name, with their lines.
    pub(super) libraries: Vec<(String, usize)>,
    pub(super) polylines: Polylines,
    pub(super) points: Vec<u32>,
    /// The vertices of faces and polylines that are too short, and so left out, with their lines.
    pub(super) left_out: Vec<(usize, u32)>,
    /// The first index backwards into the list of texture coordinates or of normals while that is
    /// empty, with its line, in the place of the [`List`].
    pub(super) without_list: [Option<(usize, ObjProblem)>; 3],
    /// The first normal that is a zero vector.
    pub(super) zero_normal_line: Option<usize>,
    pub(super) last_line: usize,
}

/// The lists that an index may refer to.
#[derive(Clone, Copy)]
pub(super) enum List {
    Vertices,
    Texture,
    Normals,
}

impl List {
    pub(super) fn keyword(self) -> &'static str {
        match self {
            List::Vertices => "v",
            List::Texture => "vt",
            List::Normals => "vn",
        }
    }
}

impl Statements {
    /// How many elements a list has so far.
    pub(super) fn count(&self, list: List) -> usize {
        match list {
            List::Vertices => self.positions.len(),
            List::Texture => self.texture.len(),
            List::Normals => self.normals.len(),
        }
    }

    /// The error of an index of the file that a word has.
    pub(super) fn out_of_range(&self, word: &str, list: List, index: i64) -> ObjProblem {
        ObjProblem::IndexOutOfRange {
            word: word.to_owned(),
            what: list.keyword(),
            index,
            count: self.count(list),
        }
    }

    /// An index of the file, from 1 or backwards from −1, counted from 0.
    #[inline]
    pub(super) fn resolve(&self, index: i64, list: List) -> Option<u32> {
        let from_zero = if index < 0 {
            index.checked_add(self.count(list) as i64)?
        } else {
            index - 1
        };
        u32::try_from(from_zero).ok()
    }
}
