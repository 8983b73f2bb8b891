//! What can be wrong with a PLY file.

use std::fmt;

use crate::MeshError;

/// A place in a PLY file.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Place {
    /// A line of the header or of a file of text, from 1.
    Line(usize),
    /// An element of a binary file.
    Element {
        /// The kind of element, such as `vertex`.
        kind: Box<str>,
        /// Which one, from 0.
        index: usize,
        /// Where in the file it begins, in bytes from 0.
        byte: usize,
    },
    /// The file as a whole.
    File,
}

/// The beginning of a message: the place and a colon, or nothing for the file as a whole.
impl fmt::Display for Place {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Place::Line(line) => write!(f, "line {line}: "),
            Place::Element { kind, index, byte } => write!(f, "{kind} {index} at byte {byte}: "),
            Place::File => Ok(()),
        }
    }
}

/// What can be wrong with a PLY file.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum PlyProblem {
    /// The file does not begin with `ply`.
    #[error("a PLY file begins with the line \"ply\"")]
    NotPly,
    /// The header has no `end_header` line.
    #[error("the header has no end_header line")]
    NoEndOfHeader,
    /// The header has no `format` line before its first element.
    #[error("the header does not say the format before its first element")]
    NoFormat,
    /// The format is not ascii, binary_little_endian or binary_big_endian.
    #[error("there is no format {format:?}")]
    UnknownFormat {
        /// What the line says.
        format: String,
    },
    /// A line of the header is not of a known form.
    #[error("{line:?} is not a line of a PLY header")]
    UnknownLine {
        /// The line.
        line: String,
    },
    /// A property comes before the first element.
    #[error("a property comes before the first element")]
    NoElement,
    /// Two elements or two properties of an element have one name.
    #[error("{name} is declared twice")]
    DeclaredTwice {
        /// The name.
        name: String,
    },
    /// The header claims more elements than the file has room for.
    #[error("{count} elements {element} need at least {needed} bytes, but the file has {left}")]
    TooMany {
        /// The kind of element.
        element: String,
        /// How many the header claims.
        count: u64,
        /// How many bytes they need at least.
        needed: u64,
        /// How many bytes are left after the header and the elements before.
        left: usize,
    },
    /// The header has no element `vertex`.
    #[error("the header declares no vertices")]
    NoVertices,
    /// An element lacks a property.
    #[error("element {element} has no property {property} of the right kind")]
    MissingProperty {
        /// The kind of element.
        element: &'static str,
        /// The property.
        property: &'static str,
    },
    /// The colour of a vertex is out of range.
    #[error(
        "{value} is not a part of a colour, which is from 0 to 1, or a whole number up to 255 where all \
         in the file are"
    )]
    ColourOutOfRange {
        /// The red, green, blue or alpha of the vertex.
        value: f64,
    },
    /// The colours of the vertices, or their opacities, are `float` or `double` and whole numbers
    /// up to 255.
    #[error("{value} is not a part of a colour, which is from 0 to 1")]
    ByteColours {
        /// The first number beyond 1.
        value: f64,
    },
    /// The file ends within an element.
    #[error("the file ends within the element")]
    EndOfFile,
    /// A line has fewer numbers than its element.
    #[error("the line ends before its element does")]
    EndOfLine,
    /// A line has more words than its element.
    #[error("{word:?} follows the end of the element")]
    WordAfterElement {
        /// The first word too much.
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
    /// The text is not UTF-8.
    #[error("the file is not UTF-8 text")]
    NotText,
    /// The length of a list is negative or not an integer, or the list is longer than the file.
    #[error("a list has the length {length}")]
    ListLength {
        /// The length.
        length: f64,
    },
    /// An index is negative or not an integer.
    #[error("{index} is not the index of a vertex")]
    NotAnIndex {
        /// The number.
        index: f64,
    },
    /// A face has fewer than three corners.
    #[error("a face has at least 3 corners, but this one has {found}")]
    FaceTooShort {
        /// How many it has.
        found: usize,
    },
    /// A list of texture coordinates does not fit its face.
    #[error("{found} numbers are not a texture coordinate for each of {corners} corners")]
    TextureLength {
        /// How many corners the face has.
        corners: usize,
        /// How many numbers the list has.
        found: usize,
    },
    /// The data do not form a mesh.
    #[error(transparent)]
    Mesh(MeshError),
}
