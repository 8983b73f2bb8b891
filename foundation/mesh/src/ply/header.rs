//! The header of a PLY file.

use std::collections::HashSet;

use super::{Place, PlyProblem};
use crate::FormatError;

/// How the numbers of a file are written.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Encoding {
    /// As text.
    Ascii,
    /// Binary, the lowest byte first.
    #[default]
    LittleEndian,
    /// Binary, the highest byte first.
    BigEndian,
}

/// What a file declares.
pub(super) struct Header {
    pub(super) encoding: Encoding,
    pub(super) elements: Vec<Element>,
    /// Where the elements begin.
    pub(super) length: usize,
    /// How many lines the header has.
    pub(super) lines: usize,
}

/// A kind of element.
pub(super) struct Element {
    pub(super) name: String,
    pub(super) count: u64,
    pub(super) properties: Vec<Property>,
    /// The line of its declaration.
    pub(super) line: usize,
}

/// A number of an element, or a list of numbers.
pub(super) struct Property {
    pub(super) name: String,
    /// The type of the list's length, for a list.
    pub(super) length: Option<Scalar>,
    pub(super) scalar: Scalar,
}

/// The type of a number.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Scalar {
    I8,
    U8,
    I16,
    U16,
    I32,
    U32,
    F32,
    F64,
}

impl Scalar {
    fn of_name(name: &str) -> Option<Self> {
        Some(match name {
            "char" | "int8" => Scalar::I8,
            "uchar" | "uint8" => Scalar::U8,
            "short" | "int16" => Scalar::I16,
            "ushort" | "uint16" => Scalar::U16,
            "int" | "int32" => Scalar::I32,
            "uint" | "uint32" => Scalar::U32,
            "float" | "float32" => Scalar::F32,
            "double" | "float64" => Scalar::F64,
            _ => return None,
        })
    }

    pub(super) fn name(self) -> &'static str {
        match self {
            Scalar::I8 => "char",
            Scalar::U8 => "uchar",
            Scalar::I16 => "short",
            Scalar::U16 => "ushort",
            Scalar::I32 => "int",
            Scalar::U32 => "uint",
            Scalar::F32 => "float",
            Scalar::F64 => "double",
        }
    }

    /// The size in a binary file, in bytes.
    pub(super) fn size(self) -> usize {
        match self {
            Scalar::I8 | Scalar::U8 => 1,
            Scalar::I16 | Scalar::U16 => 2,
            Scalar::I32 | Scalar::U32 | Scalar::F32 => 4,
            Scalar::F64 => 8,
        }
    }

    /// The greatest value of an integer type, 1 for the others.
    pub(super) fn full_scale(self) -> f64 {
        match self {
            Scalar::I8 => f64::from(i8::MAX),
            Scalar::U8 => f64::from(u8::MAX),
            Scalar::I16 => f64::from(i16::MAX),
            Scalar::U16 => f64::from(u16::MAX),
            Scalar::I32 => f64::from(i32::MAX),
            Scalar::U32 => f64::from(u32::MAX),
            Scalar::F32 | Scalar::F64 => 1.0,
        }
    }
}

impl Element {
    /// The number of bytes that one element takes at least.
    pub(super) fn least_size(&self, encoding: Encoding) -> usize {
        let sizes = self.properties.iter().map(|property| match encoding {
            // A digit and what separates it from the next.
            Encoding::Ascii => 2,
            _ => property.length.unwrap_or(property.scalar).size(),
        });
        sizes.sum::<usize>().max(1)
    }
}

pub(super) fn header(bytes: &[u8]) -> Result<Header, FormatError> {
    let at_line = |line: usize| {
        move |problem| FormatError::Ply {
            place: Place::Line(line),
            problem,
        }
    };
    let mut declared = Declarations::default();
    let mut position = 0;
    for line in 1.. {
        if line > 1 && position == bytes.len() {
            return Err(at_line(line - 1)(PlyProblem::NoEndOfHeader));
        }
        let end = memchr::memchr(b'\n', &bytes[position..]).map(|end| position + end);
        let text = &bytes[position..end.unwrap_or(bytes.len())];
        let text = text.strip_suffix(b"\r").unwrap_or(text);
        if line == 1 {
            if text.trim_ascii_end() != b"ply" {
                return Err(at_line(1)(PlyProblem::NotPly));
            }
        } else {
            let is_end = declared.statement(text, line);
            if is_end.map_err(at_line(line))? {
                let encoding = declared
                    .encoding
                    .ok_or(PlyProblem::NoFormat)
                    .map_err(at_line(line))?;
                return Ok(Header {
                    encoding,
                    elements: declared.elements,
                    length: end.map_or(bytes.len(), |end| end + 1),
                    lines: line,
                });
            }
        }
        match end {
            Some(end) => position = end + 1,
            None => return Err(at_line(line)(PlyProblem::NoEndOfHeader)),
        }
    }
    Err(at_line(1)(PlyProblem::NoEndOfHeader))
}

/// What the lines so far declare.
#[derive(Default)]
struct Declarations {
    encoding: Option<Encoding>,
    elements: Vec<Element>,
    element_names: HashSet<String>,
    /// The names of the properties of the latest element.
    property_names: HashSet<String>,
}

impl Declarations {
    /// Reads a line; whether it is the last one.
    fn statement(&mut self, text: &[u8], line: usize) -> Result<bool, PlyProblem> {
        // A comment may have any encoding.
        let first = text.split(u8::is_ascii_whitespace).next().unwrap_or(b"");
        if matches!(first, b"comment" | b"obj_info") {
            return Ok(false);
        }
        let text = std::str::from_utf8(text).map_err(|_| PlyProblem::NotText)?;
        let unknown = || PlyProblem::UnknownLine {
            line: text.chars().take(60).collect(),
        };
        let words: Vec<&str> = text.split_ascii_whitespace().collect();
        match words[..] {
            ["end_header"] => return Ok(true),
            ["format", name, version] => {
                self.encoding = Some(match (name, version) {
                    ("ascii", "1.0") => Encoding::Ascii,
                    ("binary_little_endian", "1.0") => Encoding::LittleEndian,
                    ("binary_big_endian", "1.0") => Encoding::BigEndian,
                    _ => {
                        return Err(PlyProblem::UnknownFormat {
                            format: format!("{name} {version}"),
                        });
                    }
                });
            }
            ["element", name, count] => {
                if self.encoding.is_none() {
                    return Err(PlyProblem::NoFormat);
                }
                if !self.element_names.insert(name.to_owned()) {
                    let name = name.to_owned();
                    return Err(PlyProblem::DeclaredTwice { name });
                }
                self.property_names.clear();
                self.elements.push(Element {
                    name: name.to_owned(),
                    count: count.parse().map_err(|_| unknown())?,
                    properties: Vec::new(),
                    line,
                });
            }
            ["property", scalar, name] => {
                let scalar = Scalar::of_name(scalar).ok_or_else(unknown)?;
                self.add_property(name, None, scalar)?;
            }
            ["property", "list", length, scalar, name] => {
                let length = Scalar::of_name(length).ok_or_else(unknown)?;
                let scalar = Scalar::of_name(scalar).ok_or_else(unknown)?;
                self.add_property(name, Some(length), scalar)?;
            }
            _ => return Err(unknown()),
        }
        Ok(false)
    }

    fn add_property(
        &mut self,
        name: &str,
        length: Option<Scalar>,
        scalar: Scalar,
    ) -> Result<(), PlyProblem> {
        let element = self.elements.last_mut().ok_or(PlyProblem::NoElement)?;
        if !self.property_names.insert(name.to_owned()) {
            let name = format!("{} {name}", element.name);
            return Err(PlyProblem::DeclaredTwice { name });
        }
        element.properties.push(Property {
            name: name.to_owned(),
            length,
            scalar,
        });
        Ok(())
    }
}
