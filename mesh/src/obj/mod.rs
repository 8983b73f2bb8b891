//! Wavefront OBJ: polygon meshes as text, read strictly and in file order.
//!
//! Vertex n of the mesh is the n-th `v` line of the file, also when no face uses it, so that
//! weights and other data numbered by vertex fit. Every number must be finite and every index in
//! range; an error names the line and the faulty word.
//!
//! | line | read as |
//! | --- | --- |
//! | `v x y z`, `v x y z w`, `v x y z r g b` | a vertex; w and the colour are checked and ignored |
//! | `vt u`, `vt u v`, `vt u v w` | a texture coordinate (u, v); v is 0 when left out |
//! | `vn x y z` | checked and counted; normals are computed where they are needed |
//! | `f a b c …` | a polygon; each corner is `v`, `v/vt`, `v//vn` or `v/vt/vn` |
//! | `g name …`, `o name` | the following faces belong to these groups, and to this one |
//! | `s`, `usemtl`, `mtllib`, `l`, `p` and other attributes | ignored |
//! | `curv`, `surf` and other free-form geometry, unknown words | an error |
//!
//! Indices count from 1, or from −1 backwards from the latest element.
//!
//! A line that ends in `\` continues on the next one. Line ends may be LF or CR LF. A word that
//! begins with `#` begins a comment, which ends with its line; a line of comment may be in any
//! encoding, everything else is UTF-8.
//!
//! The reader does not use `tobj`, which numbers vertices by group in order of use, drops those
//! that no face uses, accepts NaN and does not report line numbers. A scan of the text before and a
//! table of vertices after it could correct that, but the scan alone already gives the whole mesh.
//! The tests compare the faces with those of `tobj`.
//!
//! Source: Wavefront, *Advanced Visualizer* manual, appendix B1, "Object Files".

mod lines;
mod parser;
mod write;

use std::path::Path;

use ga_files::ReadError;

use crate::{Mesh, MeshError};

pub use write::{to_text, write};

/// Reads the mesh in a file.
///
/// # Errors
///
/// [`ReadError::Io`], or [`ReadError::Contents`] as [`parse`] gives.
pub fn read(path: impl AsRef<Path>) -> Result<Mesh, ReadError<ObjError>> {
    ga_files::read(path, parse)
}

/// Reads a mesh from the bytes of a file.
///
/// # Errors
///
/// [`ObjError`], for the first faulty line; indices out of range are found after all other errors.
///
/// # Examples
///
/// ```
/// let mesh = ga_mesh::obj::parse(b"v 0 0 0\nv 1 0 0\nv 0 1 0\ng corner\nf 1 2 -1\n")?;
/// assert_eq!(mesh.faces().get(0), Some(&[0, 1, 2][..]));
/// assert_eq!(mesh.group("corner").map(|group| group.faces.len()), Some(1));
///
/// let error = ga_mesh::obj::parse(b"v 0 0 0\nv 1 0\n").unwrap_err();
/// assert_eq!(error.to_string(), "line 2: a v line has 3, 4 or 6 numbers, but this one has 2");
/// # Ok::<(), ga_mesh::obj::ObjError>(())
/// ```
pub fn parse(bytes: &[u8]) -> Result<Mesh, ObjError> {
    parser::parse(bytes)
}

/// What is wrong with an OBJ file, and where.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[error("line {line}: {problem}")]
pub struct ObjError {
    /// The line, from 1; for a line continued with `\`, its first line; for what is missing,
    /// the last line.
    pub line: usize,
    /// What is wrong.
    pub problem: ObjProblem,
}

/// What can be wrong with an OBJ file.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum ObjProblem {
    /// The line is not UTF-8, or holds a null byte.
    #[error("the file is not UTF-8 text")]
    NotText,
    /// The first word of the line stands for nothing in a polygon mesh.
    #[error("a line of a polygon mesh cannot begin with {word:?}")]
    UnknownStatement {
        /// The word.
        word: String,
    },
    /// A word is in the place of a number.
    #[error("{word:?} is not a number")]
    NotANumber {
        /// The word.
        word: String,
    },
    /// A number is infinite, not a number, or too large.
    #[error("{word:?} is not a finite number")]
    NotFinite {
        /// The word.
        word: String,
    },
    /// A line has too few or too many numbers.
    #[error("a {statement} line has {expected} numbers, but this one has {found}")]
    WrongCount {
        /// The line's first word.
        statement: &'static str,
        /// How many numbers it may have, in words.
        expected: &'static str,
        /// How many it has.
        found: usize,
    },
    /// A corner of a face is not of the form `v`, `v/vt`, `v//vn` or `v/vt/vn`.
    #[error("{word:?} is not a corner of a face (v, v/vt, v//vn or v/vt/vn)")]
    BadCorner {
        /// The corner.
        word: String,
    },
    /// A face has fewer than three corners.
    #[error("a face has at least 3 corners, but this one has {found}")]
    FaceTooShort {
        /// How many it has.
        found: usize,
    },
    /// A corner of a face refers to something that does not exist.
    #[error("{word:?} refers to {what} {index}, but there are {count}")]
    IndexOutOfRange {
        /// The corner.
        word: String,
        /// `"v"`, `"vt"` or `"vn"`.
        what: &'static str,
        /// The index as the file has it, from 1 or negative.
        index: i64,
        /// How many there are, for a negative index before this line.
        count: usize,
    },
    /// There is no `v` line.
    #[error("the file ends without a vertex")]
    NoVertices,
    /// There is no `f` line.
    #[error("the file ends without a face")]
    NoFaces,
    /// The mesh is too large.
    #[error(transparent)]
    Mesh(MeshError),
}
