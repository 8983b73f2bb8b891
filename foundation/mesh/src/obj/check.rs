//! Indices that refer to something beyond the end of its list. An element may come before the
//! vertices it uses, so that these are known only at the end of the file.

use super::ObjProblem;
use super::lines::Lines;
use super::statements::{List, Statements};
use crate::FormatError;
use crate::words::Words;

/// Finds the first such face, or else the first such polyline, or else the first such point.
pub(super) fn check_indices(read: &Statements, bytes: &[u8]) -> Result<(), FormatError> {
    let beyond = |index: u32, list: List| index as usize >= read.count(list);
    let error = |line: usize, index: u32, list: List| {
        let index = i64::from(index) + 1;
        Err(FormatError::Obj {
            line,
            problem: ObjProblem::IndexOutOfRange {
                word: index.to_string(),
                what: list.keyword(),
                index,
                count: read.count(list),
            },
        })
    };
    let vertices = read.faces.corners();
    let vertex = vertices
        .iter()
        .position(|&index| beyond(index, List::Vertices))
        .map(|corner| (corner, List::Vertices, vertices[corner]));
    let optional = |indices: &[Option<u32>], list| {
        let mut found = indices.iter().enumerate();
        found.find_map(|(corner, index)| {
            let index = index.filter(|&index| beyond(index, list))?;
            Some((corner, list, index))
        })
    };
    let first = vertex
        .into_iter()
        .chain(optional(&read.texture_corners, List::Texture))
        .chain(optional(&read.normal_corners, List::Normals))
        .min_by_key(|&(corner, ..)| corner);
    if let Some((corner, list, index)) = first {
        let ends = &read.faces.offsets()[1..];
        let face = ends.partition_point(|&end| end as usize <= corner);
        return error(line_of(bytes, b"f", face), index, list);
    }
    for (number, line) in read.polylines.iter().enumerate() {
        if let Some(&index) = line.iter().find(|&&index| beyond(index, List::Vertices)) {
            return error(line_of(bytes, b"l", number), index, List::Vertices);
        }
    }
    for (number, &index) in read.points.iter().enumerate() {
        if beyond(index, List::Vertices) {
            return error(line_of_point(bytes, number), index, List::Vertices);
        }
    }
    Ok(())
}

/// The line of the statement of this keyword that comes after `before` others.
fn line_of(bytes: &[u8], keyword: &[u8], before: usize) -> usize {
    let mut lines = Lines::new(bytes)
        .filter(|(_, text)| Words::new(text).next() == Some(keyword))
        .map(|(line, _)| line);
    lines.nth(before).unwrap_or(1)
}

/// The line of the point that comes after `before` others in `p` lines.
fn line_of_point(bytes: &[u8], before: usize) -> usize {
    let mut points = Lines::new(bytes).flat_map(|(line, text)| {
        let mut words = Words::new(&text);
        let count = match words.next() {
            Some(b"p") => words.count(),
            _ => 0,
        };
        std::iter::repeat_n(line, count)
    });
    points.nth(before).unwrap_or(1)
}
