use std::collections::HashMap;

use super::lines::Lines;
use super::{ObjError, ObjProblem};
use crate::{Faces, Group, Mesh, MeshError, Texture};

pub(super) fn parse(bytes: &[u8]) -> Result<Mesh, ObjError> {
    let mut parser = Parser::default();
    let mut lines = Lines::new(bytes);
    for (line, text) in lines.by_ref() {
        parser
            .statement(line, &text)
            .map_err(|problem| ObjError { line, problem })?;
    }
    parser.finish(lines.taken().max(1))
}

/// The part of a mesh that has been read. Indices into it count from 0.
#[derive(Default)]
struct Parser {
    positions: Vec<[f64; 3]>,
    texture: Vec<[f64; 2]>,
    normals: usize,
    faces: Faces,
    texture_corners: Vec<Option<u32>>,
    /// The line each face is on, for what can be wrong with it only at the end.
    face_lines: Vec<usize>,
    /// The greatest index of a normal, and its face.
    last_normal: Option<(u32, usize)>,
    groups: Vec<Group>,
    group_by_name: HashMap<String, usize>,
    /// The groups of the latest `g` line and the object of the latest `o` line, as indices into
    /// `groups`.
    open_groups: Vec<usize>,
    open_object: Option<usize>,
    /// The vertices of the face being read.
    corners: Vec<u32>,
}

/// A corner of a face, indices from 0.
struct Corner {
    vertex: u32,
    texture: Option<u32>,
    normal: Option<u32>,
}

impl Parser {
    fn statement(&mut self, line: usize, text: &[u8]) -> Result<(), ObjProblem> {
        let text = match std::str::from_utf8(text) {
            Ok(text) if !text.contains('\0') => text,
            // A comment may have any encoding.
            _ if text.trim_ascii_start().starts_with(b"#") && !text.contains(&0) => return Ok(()),
            _ => return Err(ObjProblem::NotText),
        };
        let mut words = text
            .split_ascii_whitespace()
            .take_while(|word| !word.starts_with('#'));
        let Some(keyword) = words.next() else {
            return Ok(());
        };
        match keyword {
            "v" => {
                let ([x, y, z, ..], count) = numbers::<6>(words)?;
                expect_count("v", "3, 4 or 6", count, matches!(count, 3 | 4 | 6))?;
                self.positions.push([x, y, z]);
            }
            "vt" => {
                let ([u, v, _], count) = numbers::<3>(words)?;
                expect_count("vt", "1, 2 or 3", count, matches!(count, 1..=3))?;
                self.texture.push([u, v]);
            }
            "vn" => {
                let (_, count) = numbers::<3>(words)?;
                expect_count("vn", "3", count, count == 3)?;
                self.normals += 1;
            }
            "f" => self.face(line, words)?,
            "g" => {
                self.open_groups.clear();
                for name in words {
                    let group = self.group(name);
                    if !self.open_groups.contains(&group) {
                        self.open_groups.push(group);
                    }
                }
            }
            "o" => {
                let name = words.collect::<Vec<_>>().join(" ");
                self.open_object = (!name.is_empty()).then(|| self.group(&name));
            }
            "p" | "l" | "s" | "mg" | "bevel" | "c_interp" | "d_interp" | "lod" | "maplib"
            | "usemap" | "usemtl" | "mtllib" | "shadow_obj" | "trace_obj" => {}
            _ => {
                return Err(ObjProblem::UnknownStatement {
                    word: keyword.to_owned(),
                });
            }
        }
        Ok(())
    }

    fn group(&mut self, name: &str) -> usize {
        if let Some(&group) = self.group_by_name.get(name) {
            return group;
        }
        let group = self.groups.len();
        self.groups.push(Group {
            name: name.to_owned(),
            faces: Vec::new(),
        });
        self.group_by_name.insert(name.to_owned(), group);
        group
    }

    fn face<'a>(
        &mut self,
        line: usize,
        words: impl Iterator<Item = &'a str>,
    ) -> Result<(), ObjProblem> {
        let mut corners = std::mem::take(&mut self.corners);
        corners.clear();
        for word in words {
            let Corner {
                vertex,
                texture,
                normal,
            } = self.corner(word)?;
            corners.push(vertex);
            self.texture_corners.push(texture);
            if let Some(normal) =
                normal.filter(|&normal| self.last_normal.is_none_or(|(last, _)| normal > last))
            {
                self.last_normal = Some((normal, self.faces.len()));
            }
        }
        let face = self.faces.len() as u32;
        self.faces.push(&corners).map_err(|error| match error {
            MeshError::FaceTooShort { corners: found, .. } => ObjProblem::FaceTooShort { found },
            error => ObjProblem::Mesh(error),
        })?;
        self.corners = corners;
        self.face_lines.push(line);
        let object = self
            .open_object
            .filter(|object| !self.open_groups.contains(object));
        for &group in self.open_groups.iter().chain(&object) {
            self.groups[group].faces.push(face);
        }
        Ok(())
    }

    fn corner(&self, word: &str) -> Result<Corner, ObjProblem> {
        let bad = || ObjProblem::BadCorner {
            word: word.to_owned(),
        };
        let mut parts = word.split('/');
        let (vertex, texture, normal) = (parts.next(), parts.next(), parts.next());
        if parts.next().is_some() || normal == Some("") || (normal.is_none() && texture == Some(""))
        {
            return Err(bad());
        }
        let index = |part: &str, what: &'static str, count: usize| -> Result<u32, ObjProblem> {
            let index: i64 = part.parse().map_err(|_| bad())?;
            let from_zero = if index < 0 {
                index.checked_add(count as i64)
            } else {
                index.checked_sub(1)
            };
            from_zero
                .and_then(|index| u32::try_from(index).ok())
                .ok_or_else(|| {
                    let word = word.to_owned();
                    ObjProblem::IndexOutOfRange {
                        word,
                        what,
                        index,
                        count,
                    }
                })
        };
        Ok(Corner {
            vertex: index(vertex.unwrap_or(""), "v", self.positions.len())?,
            texture: match texture {
                None | Some("") => None,
                Some(part) => Some(index(part, "vt", self.texture.len())?),
            },
            normal: normal
                .map(|part| index(part, "vn", self.normals))
                .transpose()?,
        })
    }

    /// A face may come before its vertices, so positive indices are checked here.
    fn finish(self, last_line: usize) -> Result<Mesh, ObjError> {
        let at_end = |problem| ObjError {
            line: last_line,
            problem,
        };
        if self.positions.is_empty() {
            return Err(at_end(ObjProblem::NoVertices));
        }
        if self.faces.is_empty() {
            return Err(at_end(ObjProblem::NoFaces));
        }
        self.check_indices()?;
        let mesh = Mesh::new(self.positions, self.faces)
            .and_then(|mesh| mesh.with_groups(self.groups))
            .and_then(|mesh| {
                if self.texture.is_empty() {
                    return Ok(mesh);
                }
                mesh.with_texture(Texture {
                    coordinates: self.texture,
                    corners: self.texture_corners,
                })
            });
        mesh.map_err(|error| at_end(ObjProblem::Mesh(error)))
    }

    fn check_indices(&self) -> Result<(), ObjError> {
        let out_of_range = |face: usize, what, index: u32, count| {
            let index = i64::from(index) + 1;
            let problem = ObjProblem::IndexOutOfRange {
                word: index.to_string(),
                what,
                index,
                count,
            };
            ObjError {
                line: self.face_lines[face],
                problem,
            }
        };
        let (vertices, coordinates) = (self.positions.len(), self.texture.len());
        let mut corner = 0;
        for (face, corners) in self.faces.iter().enumerate() {
            for &vertex in corners {
                if vertex as usize >= vertices {
                    return Err(out_of_range(face, "v", vertex, vertices));
                }
                match self.texture_corners[corner] {
                    Some(index) if index as usize >= coordinates => {
                        return Err(out_of_range(face, "vt", index, coordinates));
                    }
                    _ => corner += 1,
                }
            }
        }
        match self.last_normal {
            Some((index, face)) if index as usize >= self.normals => {
                Err(out_of_range(face, "vn", index, self.normals))
            }
            _ => Ok(()),
        }
    }
}

/// The numbers on a line: the first `N` of them, 0 where there are fewer, and how many there are.
fn numbers<'a, const N: usize>(
    words: impl Iterator<Item = &'a str>,
) -> Result<([f64; N], usize), ObjProblem> {
    let mut values = [0.0; N];
    let mut count = 0;
    for word in words {
        let value: f64 = word.parse().map_err(|_| ObjProblem::NotANumber {
            word: word.to_owned(),
        })?;
        if !value.is_finite() {
            return Err(ObjProblem::NotFinite {
                word: word.to_owned(),
            });
        }
        if let Some(slot) = values.get_mut(count) {
            *slot = value;
        }
        count += 1;
    }
    Ok((values, count))
}

fn expect_count(
    statement: &'static str,
    expected: &'static str,
    found: usize,
    fits: bool,
) -> Result<(), ObjProblem> {
    if fits {
        Ok(())
    } else {
        Err(ObjProblem::WrongCount {
            statement,
            expected,
            found,
        })
    }
}
