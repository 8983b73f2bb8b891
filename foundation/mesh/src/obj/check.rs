//! Indices that refer to something beyond the end of its list. An element may come before the
//! vertices it uses, so that these are known only at the end of the file.

use ga_files::{Deviations, Reading};

use super::ObjProblem;
use super::lines::Lines;
use super::statements::{List, Statements};
use crate::FormatError;
use crate::words::Words;

/// Takes away the indices of texture coordinates or normals in a file that has none at all, as some
/// programs write them. A strict reading leaves them, since they are errors.
pub(super) fn drop_indices_without_list(
    read: &mut Statements,
    bytes: &[u8],
    deviations: &mut Deviations<ObjProblem>,
) -> Result<(), FormatError> {
    for list in [List::Texture, List::Normals] {
        let backwards = read.without_list[list as usize].take();
        if read.count(list) > 0 {
            // The list has begun after the index into it.
            if let Some((line, problem)) = backwards {
                return Err(FormatError::Obj { line, problem });
            }
            continue;
        }
        if deviations.reading() == Reading::Strict {
            continue;
        }
        let corners = match list {
            List::Texture => std::mem::take(&mut read.texture_corners),
            _ => std::mem::take(&mut read.normal_corners),
        };
        let of_faces = read.faces.offsets().windows(2).map(|ends| {
            let corners = corners.get(ends[0] as usize..ends[1] as usize);
            corners.into_iter().flatten().find_map(|&index| index)
        });
        let faces: Vec<(usize, u32)> = of_faces
            .enumerate()
            .filter_map(|(face, index)| Some((face, index?)))
            .collect();
        let mut first = backwards;
        if let Some(&(face, index)) = faces.first() {
            let line = line_of(bytes, b"f", 3, face);
            if first.as_ref().is_none_or(|(earlier, _)| line < *earlier) {
                let index = i64::from(index) + 1;
                first = Some((line, read.out_of_range(&index.to_string(), list, index)));
            }
        }
        if let Some((line, problem)) = first {
            let tolerated = deviations.tolerate_times(line, faces.len().max(1), problem);
            tolerated.map_err(|problem| FormatError::Obj { line, problem })?;
        }
    }
    Ok(())
}

/// Finds the first such face, or else the first such polyline, or else the first such point.
pub(super) fn check_indices(read: &Statements, bytes: &[u8]) -> Result<(), FormatError> {
    let beyond = |index: u32, list: List| index as usize >= read.count(list);
    let error = |line: usize, index: u32, list: List| {
        let index = i64::from(index) + 1;
        Err(FormatError::Obj {
            line,
            problem: read.out_of_range(&index.to_string(), list, index),
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
        return error(line_of(bytes, b"f", 3, face), index, list);
    }
    for (number, line) in read.polylines.iter().enumerate() {
        if let Some(&index) = line.iter().find(|&&index| beyond(index, List::Vertices)) {
            return error(line_of(bytes, b"l", 2, number), index, List::Vertices);
        }
    }
    for (number, &index) in read.points.iter().enumerate() {
        if beyond(index, List::Vertices) {
            return error(line_of_point(bytes, number), index, List::Vertices);
        }
    }
    for &(line, index) in &read.left_out {
        if beyond(index, List::Vertices) {
            return error(line, index, List::Vertices);
        }
    }
    Ok(())
}

/// The line of the statement of this keyword, with at least so many corners, that comes after
/// `before` others.
fn line_of(bytes: &[u8], keyword: &[u8], corners: usize, before: usize) -> usize {
    let is_one = |text: &[u8]| {
        let mut words = Words::new(text);
        words.next() == Some(keyword) && words.count() >= corners
    };
    let mut lines = Lines::new(bytes)
        .filter(|(_, text)| is_one(text))
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
