//! Creases and corners, and the text that lists them.

use super::tag_problem::TagProblem;
use crate::MeshError;

/// The sharpness from which on creases and corners are infinitely sharp, as in OpenSubdiv. It never
/// falls.
pub const INFINITELY_SHARP: f64 = 10.0;

/// Which edges and vertices of a mesh are sharper than the rest.
///
/// A sharpness s between 0 and 10 gives the rules of a sharp crease for s levels and those of a
/// smooth surface then; a fractional level blends the two linearly. 0 is smooth, 10 or more
/// infinitely sharp.
///
/// T. DeRose, M. Kass, T. Truong, *Subdivision surfaces in character animation*, SIGGRAPH 1998.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Tags {
    /// Sharp edges. Where an edge is listed twice, the later entry counts.
    pub creases: Vec<Crease>,
    /// Sharp vertices. Where a vertex is listed twice, the later entry counts.
    pub corners: Vec<Corner>,
}

/// A sharp edge.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Crease {
    /// Its ends, in any order.
    pub vertices: [u32; 2],
    /// At least 0.
    pub sharpness: f64,
}

/// A sharp vertex.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Corner {
    /// The vertex.
    pub vertex: u32,
    /// At least 0.
    pub sharpness: f64,
}

/// Tags read from text, and the lines that they come from.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct TagText {
    /// The tags, in the order of the lines.
    pub tags: Tags,
    /// For each crease its line, from 1.
    pub crease_lines: Vec<usize>,
    /// For each corner its line, from 1.
    pub corner_lines: Vec<usize>,
}

impl TagText {
    /// Reads lines of the form `crease a b sharpness` and `corner v sharpness`.
    ///
    /// Vertices are counted from 0, as in the tags of OpenSubdiv's shapes, although OBJ files count
    /// from 1. The sharpness may be `inf`. Empty lines, and all of a line from `#` on, are ignored.
    ///
    /// # Errors
    ///
    /// [`MeshError::Tag`] for the first faulty line.
    ///
    /// # Examples
    ///
    /// ```
    /// use ga_mesh::subdivision::TagText;
    ///
    /// let text = TagText::decode(b"# the lid\ncrease 0 1 2.5\ncorner 3 inf\n")?;
    /// assert_eq!(text.tags.creases[0].vertices, [0, 1]);
    /// assert_eq!(text.tags.corners[0].sharpness, f64::INFINITY);
    /// assert_eq!(text.corner_lines, [3]);
    ///
    /// let error = TagText::decode(b"crease 0 1 -1\n").unwrap_err();
    /// assert_eq!(
    ///     error.to_string(),
    ///     "line 1: \"-1\" is not a sharpness: a number that is at least 0, or inf"
    /// );
    /// # Ok::<(), ga_mesh::MeshError>(())
    /// ```
    pub fn decode(bytes: &[u8]) -> Result<Self, MeshError> {
        let mut text = Self::default();
        for (line, bytes) in (1..).zip(bytes.split(|&byte| byte == b'\n')) {
            text.push_line(line, bytes)
                .map_err(|problem| MeshError::Tag { line, problem })?;
        }
        Ok(text)
    }

    /// The line of the tag that an error is about.
    #[must_use]
    pub fn line_of(&self, error: &MeshError) -> Option<usize> {
        match error {
            MeshError::NoEdge { crease, .. } => self.crease_lines.get(*crease).copied(),
            MeshError::NoVertex { corner, .. } => self.corner_lines.get(*corner).copied(),
            _ => None,
        }
    }

    fn push_line(&mut self, line: usize, bytes: &[u8]) -> Result<(), TagProblem> {
        let bytes = bytes.split(|&byte| byte == b'#').next().unwrap_or_default();
        let text = std::str::from_utf8(bytes).map_err(|_| TagProblem::NotText)?;
        let words: Vec<&str> = text.split_whitespace().collect();
        match words[..] {
            [] => {}
            ["crease", a, b, sharpness] => {
                self.tags.creases.push(Crease {
                    vertices: [vertex(a)?, vertex(b)?],
                    sharpness: self::sharpness(sharpness)?,
                });
                self.crease_lines.push(line);
            }
            ["corner", v, sharpness] => {
                self.tags.corners.push(Corner {
                    vertex: vertex(v)?,
                    sharpness: self::sharpness(sharpness)?,
                });
                self.corner_lines.push(line);
            }
            ["crease", ..] => {
                return Err(TagProblem::WrongCount {
                    expected: "crease a b sharpness",
                    found: words.len() - 1,
                });
            }
            ["corner", ..] => {
                return Err(TagProblem::WrongCount {
                    expected: "corner v sharpness",
                    found: words.len() - 1,
                });
            }
            [word, ..] => {
                let word = word.to_owned();
                return Err(TagProblem::UnknownTag { word });
            }
        }
        Ok(())
    }
}

fn vertex(word: &str) -> Result<u32, TagProblem> {
    word.parse().map_err(|_| TagProblem::NotAVertex {
        word: word.to_owned(),
    })
}

fn sharpness(word: &str) -> Result<f64, TagProblem> {
    match word.parse() {
        Ok(sharpness) if sharpness >= 0.0 => Ok(sharpness),
        _ => Err(TagProblem::NotASharpness {
            word: word.to_owned(),
        }),
    }
}
