//! What can be wrong with an OBJ file.

use std::borrow::Cow;

use ga_files::Tolerated;
use ga_files::text::Encoding;

use super::mtl::MtlProblem;
use crate::MeshError;
use crate::words::WordError;

/// What can be wrong with an OBJ file.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum ObjProblem {
    /// The line is not UTF-8, or holds a null byte.
    #[error("the file is not UTF-8 text")]
    NotText,
    /// The file is in another encoding.
    #[error("the file is not UTF-8 text")]
    NotUtf8 {
        /// As which it is read, unless it is read strictly.
        encoding: Encoding,
    },
    /// A line ends in a carriage return alone.
    #[error("the line ends in a carriage return alone")]
    CarriageReturns,
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
    /// A vertex of a polyline is not of the form `v` or `v/vt`.
    #[error("{word:?} is not a vertex of a line (v or v/vt)")]
    BadLineVertex {
        /// The vertex.
        word: String,
    },
    /// A word of a `p` line is not an index.
    #[error("{word:?} is not the index of a vertex")]
    BadPoint {
        /// The word.
        word: String,
    },
    /// A polyline has fewer than two vertices.
    #[error("a line has at least 2 vertices, but this one has {found}")]
    LineTooShort {
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
    /// Many faces are in many groups each, which would take far more memory than the file.
    #[error("the groups have too many faces in all for a file of this size")]
    TooManyGroups,
    /// There is no `v` line.
    #[error("the file ends without a vertex")]
    NoVertices,
    /// There is no `f`, `l` or `p` line.
    #[error("the file ends without a face, a line or a point")]
    NoFaces,
    /// The colour of a vertex is out of range.
    #[error(
        "{value} is not a part of a colour, which is from 0 to 1, or a whole number up to 255 where all \
         in the file are"
    )]
    ColourOutOfRange {
        /// The red, green, blue or alpha of the line.
        value: f64,
    },
    /// The colours of the vertices, or their opacities, are whole numbers up to 255.
    #[error("{value} is not from 0 to 1, as {what} are")]
    ByteColours {
        /// What they are: `colours` or `opacities`.
        what: &'static str,
        /// The first number beyond 1.
        value: f64,
    },
    /// The mesh is too large.
    #[error(transparent)]
    Mesh(MeshError),
    /// A material library that the line names cannot be read.
    #[error("cannot read {library}: {message}")]
    LibraryUnreadable {
        /// The name of the library.
        library: String,
        /// What the operating system said.
        message: String,
    },
    /// A material library that the line names has a fault.
    #[error("{library}: line {line}: {problem}")]
    Library {
        /// The name of the library.
        library: String,
        /// The line in the library, from 1.
        line: usize,
        /// What is wrong with it.
        problem: Box<MtlProblem>,
    },
}

impl From<WordError> for ObjProblem {
    fn from(error: WordError) -> Self {
        match error {
            WordError::Encoding => ObjProblem::NotText,
            WordError::Word(word) => ObjProblem::NotANumber { word },
            WordError::Infinite(word) => ObjProblem::NotFinite { word },
        }
    }
}

impl Tolerated for ObjProblem {
    fn kind(&self) -> &'static str {
        match self {
            Self::NotText | Self::NotUtf8 { .. } => "encoding",
            Self::CarriageReturns => "line_ends",
            Self::UnknownStatement { .. } => "unknown_statement",
            Self::NotANumber { .. } | Self::NotFinite { .. } => "not_a_number",
            Self::WrongCount { .. } => "number_count",
            Self::BadCorner { .. } => "corner_form",
            Self::BadLineVertex { .. } => "line_vertex_form",
            Self::BadPoint { .. } => "point_form",
            Self::FaceTooShort { .. } => "short_face",
            Self::LineTooShort { .. } => "short_line",
            Self::IndexOutOfRange { what: "vn", .. } => "no_normals",
            Self::IndexOutOfRange { what: "vt", .. } => "no_texture_coordinates",
            Self::IndexOutOfRange { .. } => "index_out_of_range",
            Self::NoFaces => "points_alone",
            Self::NoVertices => "no_vertices",
            Self::ColourOutOfRange { .. } => "colour_range",
            Self::ByteColours { .. } => "byte_colours",
            Self::TooManyGroups | Self::Mesh(_) => "too_large",
            Self::LibraryUnreadable { .. } | Self::Library { .. } => "library",
        }
    }

    fn remedy(&self) -> Cow<'_, str> {
        match self {
            Self::NotUtf8 { encoding } => return format!("it is read as {encoding}").into(),
            Self::CarriageReturns => "the next line begins behind it",
            Self::WrongCount { .. } => "the numbers beyond are ignored",
            Self::BadCorner { .. } | Self::BadLineVertex { .. } | Self::BadPoint { .. } => {
                "what does not fit this form is ignored"
            }
            Self::IndexOutOfRange { what: "vn", .. } => "such corners have no normal",
            Self::IndexOutOfRange { what: "vt", .. } => "such corners have no texture coordinates",
            Self::NoFaces => "its vertices are read as points",
            Self::ByteColours { what, .. } => {
                return format!(
                    "all {what} are whole numbers up to 255, by which they are divided"
                )
                .into();
            }
            _ => "it is left out",
        }
        .into()
    }

    fn is_like(&self, other: &Self) -> bool {
        match (self, other) {
            (Self::UnknownStatement { word }, Self::UnknownStatement { word: other }) => {
                word == other
            }
            (
                Self::WrongCount { statement, .. },
                Self::WrongCount {
                    statement: other, ..
                },
            ) => statement == other,
            (Self::IndexOutOfRange { what, .. }, Self::IndexOutOfRange { what: other, .. })
            | (Self::ByteColours { what, .. }, Self::ByteColours { what: other, .. }) => {
                what == other
            }
            _ => std::mem::discriminant(self) == std::mem::discriminant(other),
        }
    }
}
