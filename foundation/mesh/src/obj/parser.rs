//! The statements of an OBJ file, one after the other.

use std::collections::HashMap;

use ga_files::{Deviation, Deviations, Reading};
use ga_runtime::vga3::Vector;

use super::ObjProblem;
use super::check::{check_indices, drop_indices_without_list};
use super::colours::scale_colours;
use super::corner::{Element, corner, lone_vertex, short_corner};
use super::lines::Lines;
use super::statements::{List, Statements};
use super::text::{self, Text};
use crate::colour_range::BRIGHTEST;
use crate::lists::Lists;
use crate::words::{Words, numbers, text};
use crate::{Faces, FormatError, Group};

/// What a file says, and what in it deviates from the format.
pub(super) fn statements(
    bytes: &[u8],
    reading: Reading,
) -> Result<(Statements, Vec<Deviation<ObjProblem>>), FormatError> {
    let at = |line| move |problem| FormatError::Obj { line, problem };
    let Text { text, foreign } =
        text::decode(bytes).map_err(|line| at(line)(ObjProblem::NotText))?;
    let mut parser = Parser {
        group_faces_left: group_faces(bytes.len()),
        deviations: Deviations::new(reading),
        ..Parser::default()
    };
    if let Some(foreign) = foreign {
        let (line, encoding) = (foreign.first_line, foreign.encoding);
        let problem = ObjProblem::NotUtf8 { encoding };
        let tolerated = parser
            .deviations
            .tolerate_times(line, foreign.count, problem);
        tolerated.map_err(at(line))?;
    }
    let mut lines = Lines::new(&text);
    for (line, text) in lines.by_ref() {
        parser.statement(line, &text).map_err(at(line))?;
    }
    if let Some((line, count)) = lines.returns() {
        let problem = ObjProblem::CarriageReturns;
        let tolerated = parser.deviations.tolerate_times(line, count, problem);
        tolerated.map_err(at(line))?;
    }
    parser.finish(&text, lines.taken().max(1))
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
    deviations: Deviations<ObjProblem>,
    /// Whether something was left out that may be geometry.
    lacks_geometry: bool,
}

/// How much of an unknown word is told.
const UNKNOWN_LETTERS: usize = 40;

impl Parser {
    fn statement(&mut self, line: usize, bytes: &[u8]) -> Result<(), ObjProblem> {
        let mut words = Words::new(bytes);
        let Some(keyword) = words.next() else {
            return Ok(());
        };
        match keyword {
            b"v" => self.vertex(line, &mut words),
            b"f" => self.face(line, words),
            b"vt" => {
                let ([u, v, _], count) = numbers::<3>(&mut words)?;
                let fits = matches!(count, 1..=3);
                self.expect_count(line, "vt", "1, 2 or 3", count, 1, fits)?;
                self.read.texture.push([u, v]);
                Ok(())
            }
            b"vn" => {
                let ([x, y, z], count) = numbers::<3>(&mut words)?;
                self.expect_count(line, "vn", "3", count, 3, count == 3)?;
                let normal = Vector::new(x, y, z);
                if normal == Vector::default() {
                    self.read.zero_normal_line.get_or_insert(line);
                }
                self.read.normals.push(normal);
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
            b"l" => self.polyline(line, words),
            b"p" => {
                for word in words {
                    let (point, fits) = lone_vertex(&self.read, text(word)?, Element::Point)?;
                    self.tolerate_form(line, fits)?;
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
            _ => self.unknown(line, keyword),
        }
    }

    /// A line that stands for nothing in a polygon mesh.
    fn unknown(&mut self, line: usize, keyword: &[u8]) -> Result<(), ObjProblem> {
        self.lacks_geometry |= is_geometry(keyword);
        let word: String = text(keyword)?.chars().take(UNKNOWN_LETTERS).collect();
        let problem = ObjProblem::UnknownStatement { word };
        self.deviations.tolerate(line, problem)
    }

    fn vertex(&mut self, line: usize, words: &mut Words<'_>) -> Result<(), ObjProblem> {
        let ([x, y, z, red, green, blue, alpha], count) = numbers::<7>(words)?;
        let fits = matches!(count, 3 | 4 | 6 | 7);
        self.expect_count(line, "v", "3, 4, 6 or 7", count, 3, fits)?;
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

    fn face(&mut self, line: usize, mut words: Words<'_>) -> Result<(), ObjProblem> {
        let first = self.corners.len();
        let attributes = [
            self.read.texture_corners.len(),
            self.read.normal_corners.len(),
        ];
        while let Some(rest) = words.rest() {
            let corner = match short_corner(&self.read, rest) {
                Some((corner, length)) if words.advance(length) => corner,
                _ => {
                    let word = words.next().map_or(Ok(""), text)?;
                    let found = corner(&self.read, word)?;
                    self.tolerate_form(line, found.fits)?;
                    for (list, index) in found.without_list {
                        self.without_list(line, word, list, index)?;
                    }
                    found.corner
                }
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
            let problem = ObjProblem::FaceTooShort { found };
            self.deviations.tolerate(line, problem)?;
            self.lacks_geometry = true;
            let vertices = self.corners.drain(first..);
            let left_out = vertices.map(|vertex| (line, vertex));
            self.read.left_out.extend(left_out);
            self.read.texture_corners.truncate(attributes[0]);
            self.read.normal_corners.truncate(attributes[1]);
            return Ok(());
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

    fn polyline(&mut self, line: usize, words: Words<'_>) -> Result<(), ObjProblem> {
        let mut vertices = Vec::new();
        for word in words {
            let (vertex, fits) = lone_vertex(&self.read, text(word)?, Element::Line)?;
            self.tolerate_form(line, fits)?;
            vertices.push(vertex);
        }
        let found = vertices.len();
        if self.read.polylines.push(&vertices).is_err() {
            let problem = ObjProblem::LineTooShort { found };
            self.deviations.tolerate(line, problem)?;
            self.lacks_geometry = true;
            let left_out = vertices.into_iter().map(|vertex| (line, vertex));
            self.read.left_out.extend(left_out);
        }
        Ok(())
    }

    fn tolerate_form(
        &mut self,
        line: usize,
        fits: Result<(), ObjProblem>,
    ) -> Result<(), ObjProblem> {
        fits.or_else(|problem| self.deviations.tolerate(line, problem))
    }

    /// An index that counts backwards in a list that is empty so far. It is tolerated where the
    /// list stays empty.
    fn without_list(
        &mut self,
        line: usize,
        word: &str,
        list: List,
        index: i64,
    ) -> Result<(), ObjProblem> {
        let problem = self.read.out_of_range(word, list, index);
        if self.deviations.reading() == Reading::Strict {
            return Err(problem);
        }
        self.read.without_list[list as usize].get_or_insert((line, problem));
        Ok(())
    }

    fn expect_count(
        &mut self,
        line: usize,
        statement: &'static str,
        expected: &'static str,
        found: usize,
        least: usize,
        fits: bool,
    ) -> Result<(), ObjProblem> {
        if fits {
            return Ok(());
        }
        let problem = ObjProblem::WrongCount {
            statement,
            expected,
            found,
        };
        match found < least {
            true => Err(problem),
            false => self.deviations.tolerate(line, problem),
        }
    }

    fn finish(
        mut self,
        bytes: &[u8],
        last_line: usize,
    ) -> Result<(Statements, Vec<Deviation<ObjProblem>>), FormatError> {
        let at_end = |problem| FormatError::Obj {
            line: last_line,
            problem,
        };
        let read = &mut self.read;
        if read.positions.is_empty() {
            return Err(at_end(ObjProblem::NoVertices));
        }
        if self.face_ends.is_empty() && read.polylines.is_empty() && read.points.is_empty() {
            if self.lacks_geometry {
                return Err(at_end(ObjProblem::NoFaces));
            }
            let tolerated = self.deviations.tolerate(last_line, ObjProblem::NoFaces);
            tolerated.map_err(at_end)?;
            read.points = (0..read.positions.len() as u32).collect();
        }
        let mut offsets = Vec::with_capacity(self.face_ends.len() + 1);
        offsets.push(0);
        offsets.append(&mut self.face_ends);
        read.faces = Faces::from_lists(Lists::new(offsets, self.corners));
        drop_indices_without_list(read, bytes, &mut self.deviations)?;

        let corners = read.faces.corners().len();
        if !read.texture.is_empty() || !read.texture_corners.is_empty() {
            read.texture_corners.resize(corners, None);
        }
        if !read.normals.is_empty() || !read.normal_corners.is_empty() {
            read.normal_corners.resize(corners, None);
        }
        if !read.face_materials.is_empty() {
            read.face_materials.resize(read.faces.len(), None);
        }
        read.last_line = last_line;
        check_indices(read, bytes)?;
        scale_colours(read, &mut self.deviations)?;
        Ok((self.read, self.deviations.into_list()))
    }
}

/// Whether a word that stands for nothing in a polygon mesh may stand for geometry: free-form
/// curves and surfaces, the old word for faces, and words in capital letters.
fn is_geometry(keyword: &[u8]) -> bool {
    matches!(
        keyword.to_ascii_lowercase().as_slice(),
        b"curv"
            | b"curv2"
            | b"surf"
            | b"fo"
            | b"f"
            | b"l"
            | b"p"
            | b"bsp"
            | b"bzp"
            | b"cdc"
            | b"cdp"
    )
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
