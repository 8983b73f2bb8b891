//! The statements of an OBJ file, one after the other.

use std::collections::HashMap;

use ga_runtime::vga3::Vector;

use super::ObjProblem;
use super::check::check_indices;
use super::lines::Lines;
use super::statements::{List, Statements};
use crate::colour_range::BRIGHTEST;
use crate::lists::Lists;
use crate::words::{Words, integer, numbers, text};
use crate::{Faces, FormatError, Group};

pub(super) fn statements(bytes: &[u8]) -> Result<Statements, FormatError> {
    let mut parser = Parser {
        group_faces_left: group_faces(bytes.len()),
        ..Parser::default()
    };
    let mut lines = Lines::new(bytes);
    for (line, text) in lines.by_ref() {
        parser
            .statement(line, &text)
            .map_err(|problem| FormatError::Obj { line, problem })?;
    }
    parser.finish(bytes, lines.taken().max(1))
}

/// How many faces the groups of a file of this size may have in all. A line may name many groups,
/// and each of the following faces is then in all of them, so that a small file could ask for any
/// amount of memory. The shortest face has 8 bytes, so that it may be in 64 groups.
fn group_faces(file_size: usize) -> usize {
    file_size.saturating_mul(8).max(1 << 16)
}

/// The part of a file that has been read. Positive indices are not checked until its end, since an
/// element may come before the vertices it uses.
#[derive(Default)]
struct Parser {
    read: Statements,
    /// Where the faces end in `corners`.
    face_ends: Vec<u32>,
    corners: Vec<u32>,
    group_by_name: HashMap<String, usize>,
    object_by_name: HashMap<String, usize>,
    material_by_name: HashMap<String, u32>,
    /// The groups of the latest `g` line, the object of the latest `o` line and the material of the
    /// latest `usemtl` line.
    open_groups: Vec<usize>,
    /// For each group the latest line that names it.
    group_lines: Vec<usize>,
    /// How many more faces the groups may have in all.
    group_faces_left: usize,
    open_object: Option<usize>,
    open_material: Option<u32>,
}

/// A corner of a face, indices from 0.
#[derive(Clone, Copy)]
struct Corner {
    vertex: u32,
    texture: Option<u32>,
    normal: Option<u32>,
}

impl Parser {
    fn statement(&mut self, line: usize, bytes: &[u8]) -> Result<(), ObjProblem> {
        let mut words = Words::new(bytes);
        let Some(keyword) = words.next() else {
            // A comment may have any encoding.
            return if bytes.contains(&0) {
                Err(ObjProblem::NotText)
            } else {
                Ok(())
            };
        };
        match keyword {
            b"v" => self.vertex(line, &mut words),
            b"f" => self.face(words),
            b"vt" => {
                let ([u, v, _], count) = numbers::<3>(&mut words)?;
                expect_count("vt", "1, 2 or 3", count, matches!(count, 1..=3))?;
                self.read.texture.push([u, v]);
                Ok(())
            }
            b"vn" => {
                let ([x, y, z], count) = numbers::<3>(&mut words)?;
                expect_count("vn", "3", count, count == 3)?;
                self.read.normals.push(Vector::new(x, y, z));
                Ok(())
            }
            _ => self.rare_statement(line, keyword, words),
        }
    }

    fn rare_statement(
        &mut self,
        line: usize,
        keyword: &[u8],
        words: Words<'_>,
    ) -> Result<(), ObjProblem> {
        match keyword {
            b"l" => {
                let vertices = words
                    .map(|word| self.vertex_of_line(word))
                    .collect::<Result<Vec<u32>, _>>()?;
                let found = vertices.len();
                self.read
                    .polylines
                    .push(&vertices)
                    .map_err(|_| ObjProblem::LineTooShort { found })
            }
            b"p" => {
                for word in words {
                    let point = self.vertex_alone(word)?;
                    self.read.points.push(point);
                }
                Ok(())
            }
            b"g" => {
                self.open_groups.clear();
                for name in words {
                    let group = named(&mut self.read.groups, &mut self.group_by_name, text(name)?);
                    self.group_lines.resize(self.read.groups.len(), 0);
                    if std::mem::replace(&mut self.group_lines[group], line) != line {
                        self.open_groups.push(group);
                    }
                }
                Ok(())
            }
            b"o" => {
                let name = words.joined()?;
                self.open_object = (!name.is_empty())
                    .then(|| named(&mut self.read.objects, &mut self.object_by_name, &name));
                Ok(())
            }
            b"usemtl" => {
                let name = words.joined()?;
                self.open_material = (!name.is_empty() && name != super::NO_MATERIAL).then(|| {
                    let materials = &mut self.read.materials;
                    let next = materials.len() as u32;
                    *self
                        .material_by_name
                        .entry(name)
                        .or_insert_with_key(|name| {
                            materials.push((name.clone(), line));
                            next
                        })
                });
                Ok(())
            }
            b"mtllib" => {
                self.read.libraries.push((words.joined()?, line));
                Ok(())
            }
            b"s" | b"mg" | b"bevel" | b"c_interp" | b"d_interp" | b"lod" | b"maplib"
            | b"usemap" | b"shadow_obj" | b"trace_obj" => Ok(words.joined().map(|_| ())?),
            _ => {
                let word = text(keyword)?.to_owned();
                words.joined()?;
                Err(ObjProblem::UnknownStatement { word })
            }
        }
    }

    fn vertex(&mut self, line: usize, words: &mut Words<'_>) -> Result<(), ObjProblem> {
        let ([x, y, z, red, green, blue, alpha], count) = numbers::<7>(words)?;
        expect_count("v", "3, 4, 6 or 7", count, matches!(count, 3 | 4 | 6 | 7))?;
        let colours = &mut self.read.colours;
        if count >= 6 {
            // Vertices before the first one with a colour are white, as are those without.
            colours.resize(self.read.positions.len(), [BRIGHTEST; 4]);
            self.read.colour_range.see(&[red, green, blue], &line);
            let alpha = if count == 7 {
                self.read.alpha_range.see(&[alpha], &line);
                alpha
            } else {
                BRIGHTEST
            };
            colours.push([red, green, blue, alpha]);
        } else if !colours.is_empty() {
            colours.push([BRIGHTEST; 4]);
        }
        self.read.positions.push([x, y, z]);
        Ok(())
    }

    fn face(&mut self, mut words: Words<'_>) -> Result<(), ObjProblem> {
        let first = self.corners.len();
        while let Some(rest) = words.rest() {
            let corner = match self.short_corner(rest) {
                Some((corner, length)) if words.advance(length) => corner,
                _ => self.corner(words.next().map_or(Ok(""), text)?)?,
            };
            add_corner(
                &mut self.read.texture_corners,
                self.corners.len(),
                corner.texture,
            );
            add_corner(
                &mut self.read.normal_corners,
                self.corners.len(),
                corner.normal,
            );
            self.corners.push(corner.vertex);
        }
        let found = self.corners.len() - first;
        if found < 3 {
            return Err(ObjProblem::FaceTooShort { found });
        }
        let count = self.corners.len();
        let end = u32::try_from(count).map_err(|_| {
            let what = "corners";
            ObjProblem::Mesh(crate::MeshError::TooLarge { what, count })
        })?;
        let face = self.face_ends.len() as u32;
        self.face_ends.push(end);
        let left = self.group_faces_left.checked_sub(self.open_groups.len());
        self.group_faces_left = left.ok_or(ObjProblem::TooManyGroups)?;
        for &group in &self.open_groups {
            self.read.groups[group].faces.push(face);
        }
        if let Some(object) = self.open_object {
            self.read.objects[object].faces.push(face);
        }
        add_corner(
            &mut self.read.face_materials,
            face as usize,
            self.open_material,
        );
        Ok(())
    }

    /// The corner at the start of `bytes` and its length, in the forms that nearly all corners
    /// have. Other text is `None`.
    fn short_corner(&self, bytes: &[u8]) -> Option<(Corner, usize)> {
        let (vertex, mut length) = integer(bytes)?;
        let mut corner = Corner {
            vertex: self.resolve(vertex, List::Vertices)?,
            texture: None,
            normal: None,
        };
        if bytes.get(length) == Some(&b'/') {
            length += 1;
            if let Some((texture, digits)) = integer(&bytes[length..]) {
                corner.texture = Some(self.resolve(texture, List::Texture)?);
                length += digits;
                if bytes.get(length) != Some(&b'/') {
                    return Some((corner, length));
                }
            } else if bytes.get(length) != Some(&b'/') {
                return None;
            }
            let (normal, digits) = integer(&bytes[length + 1..])?;
            corner.normal = Some(self.resolve(normal, List::Normals)?);
            length += 1 + digits;
        }
        Some((corner, length))
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
        let index = |part: &str, list| self.index(word, part, list).unwrap_or_else(|| Err(bad()));
        Ok(Corner {
            vertex: index(vertex.unwrap_or(""), List::Vertices)?,
            texture: match texture {
                None | Some("") => None,
                Some(part) => Some(index(part, List::Texture)?),
            },
            normal: normal.map(|part| index(part, List::Normals)).transpose()?,
        })
    }

    /// The vertex of a corner `v` or `v/vt` of a polyline.
    fn vertex_of_line(&self, word: &[u8]) -> Result<u32, ObjProblem> {
        let word = text(word)?;
        let bad = || ObjProblem::BadLineVertex {
            word: word.to_owned(),
        };
        let (vertex, texture) = match word.split_once('/') {
            Some((vertex, texture)) => (vertex, Some(texture)),
            None => (word, None),
        };
        if let Some(texture) = texture {
            let index = self.index(word, texture, List::Texture);
            index.unwrap_or_else(|| Err(bad()))?;
        }
        let index = self.index(word, vertex, List::Vertices);
        index.unwrap_or_else(|| Err(bad()))
    }

    fn vertex_alone(&self, word: &[u8]) -> Result<u32, ObjProblem> {
        let word = text(word)?;
        let index = self.index(word, word, List::Vertices);
        index.unwrap_or_else(|| {
            Err(ObjProblem::BadPoint {
                word: word.to_owned(),
            })
        })
    }

    /// The index that `part` of a word stands for, or `None` where it is not an integer.
    fn index(&self, word: &str, part: &str, list: List) -> Option<Result<u32, ObjProblem>> {
        let index: i64 = part.parse().ok()?;
        Some(
            self.resolve(index, list)
                .ok_or_else(|| ObjProblem::IndexOutOfRange {
                    word: word.to_owned(),
                    what: list.keyword(),
                    index,
                    count: self.read.count(list),
                }),
        )
    }

    /// An index of the file, from 1 or backwards from −1, counted from 0.
    #[inline]
    fn resolve(&self, index: i64, list: List) -> Option<u32> {
        let from_zero = if index < 0 {
            index.checked_add(self.read.count(list) as i64)?
        } else {
            index - 1
        };
        u32::try_from(from_zero).ok()
    }

    fn finish(mut self, bytes: &[u8], last_line: usize) -> Result<Statements, FormatError> {
        let at_end = |problem| FormatError::Obj {
            line: last_line,
            problem,
        };
        let read = &mut self.read;
        if read.positions.is_empty() {
            return Err(at_end(ObjProblem::NoVertices));
        }
        if self.face_ends.is_empty() && read.polylines.is_empty() && read.points.is_empty() {
            return Err(at_end(ObjProblem::NoFaces));
        }
        let corners = self.corners.len();
        if !read.texture.is_empty() || !read.texture_corners.is_empty() {
            read.texture_corners.resize(corners, None);
        }
        if !read.normals.is_empty() || !read.normal_corners.is_empty() {
            read.normal_corners.resize(corners, None);
        }
        if !read.face_materials.is_empty() {
            read.face_materials.resize(self.face_ends.len(), None);
        }
        read.last_line = last_line;
        let mut offsets = Vec::with_capacity(self.face_ends.len() + 1);
        offsets.push(0);
        offsets.append(&mut self.face_ends);
        self.read.faces = Faces::from_lists(Lists::new(offsets, self.corners));
        check_indices(&self.read, bytes)?;
        Ok(self.read)
    }
}

/// Appends to a list that stays empty until the first entry that is there; `length` is its length
/// with the absent entries before.
#[inline]
fn add_corner(list: &mut Vec<Option<u32>>, length: usize, entry: Option<u32>) {
    if entry.is_some() && list.len() < length {
        list.resize(length, None);
    }
    if entry.is_some() || !list.is_empty() {
        list.push(entry);
    }
}

/// The index of the group of this name, a new one where there is none.
fn named(groups: &mut Vec<Group>, by_name: &mut HashMap<String, usize>, name: &str) -> usize {
    if let Some(&group) = by_name.get(name) {
        return group;
    }
    groups.push(Group {
        name: name.to_owned(),
        faces: Vec::new(),
    });
    by_name.insert(name.to_owned(), groups.len() - 1);
    groups.len() - 1
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
