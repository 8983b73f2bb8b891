//! Corners of faces, vertices of polylines, and points.

use super::ObjProblem;
use super::statements::{List, Statements};
use crate::words::integer;

/// A corner of a face, indices from 0.
#[derive(Clone, Copy)]
pub(super) struct Corner {
    pub(super) vertex: u32,
    pub(super) texture: Option<u32>,
    pub(super) normal: Option<u32>,
}

/// A corner in any form.
pub(super) struct Found {
    pub(super) corner: Corner,
    /// The form is one of those that the format has; otherwise some index is empty, or there are
    /// more than three.
    pub(super) fits: Result<(), ObjProblem>,
    /// Indices backwards into lists that are empty so far; the corner goes without them.
    pub(super) without_list: Vec<(List, i64)>,
}

/// What is made of vertices without normals.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum Element {
    Line,
    Point,
}

/// The corner at the start of `bytes` and its length, in the forms that nearly all corners have.
/// Other text is `None`.
pub(super) fn short_corner(read: &Statements, bytes: &[u8]) -> Option<(Corner, usize)> {
    let (vertex, mut length) = integer(bytes)?;
    let mut corner = Corner {
        vertex: read.resolve(vertex, List::Vertices)?,
        texture: None,
        normal: None,
    };
    if bytes.get(length) == Some(&b'/') {
        length += 1;
        if let Some((texture, digits)) = integer(&bytes[length..]) {
            corner.texture = Some(read.resolve(texture, List::Texture)?);
            length += digits;
            if bytes.get(length) != Some(&b'/') {
                return Some((corner, length));
            }
        } else if bytes.get(length) != Some(&b'/') {
            return None;
        }
        let (normal, digits) = integer(&bytes[length + 1..])?;
        corner.normal = Some(read.resolve(normal, List::Normals)?);
        length += 1 + digits;
    }
    Some((corner, length))
}

pub(super) fn corner(read: &Statements, word: &str) -> Result<Found, ObjProblem> {
    let bad = || ObjProblem::BadCorner {
        word: word.to_owned(),
    };
    let parts = parts(word).ok_or_else(bad)?;
    let fits = match parts[..] {
        [Some(_)] | [Some(_), Some(_)] | [Some(_), _, Some(_)] => Ok(()),
        _ => Err(bad()),
    };
    let index = parts[0].ok_or_else(bad)?;
    let vertex = read.resolve(index, List::Vertices);
    let vertex = vertex.ok_or_else(|| read.out_of_range(word, List::Vertices, index))?;
    let mut without_list = Vec::new();
    let mut attribute = |place: usize, list| {
        let Some(index) = parts.get(place).copied().flatten() else {
            return Ok(None);
        };
        match read.resolve(index, list) {
            None if index < 0 && read.count(list) == 0 => {
                without_list.push((list, index));
                Ok(None)
            }
            None => Err(read.out_of_range(word, list, index)),
            found => Ok(found),
        }
    };
    let texture = attribute(1, List::Texture)?;
    let normal = attribute(2, List::Normals)?;
    Ok(Found {
        corner: Corner {
            vertex,
            texture,
            normal,
        },
        fits,
        without_list,
    })
}

/// The vertex of a polyline, `v` or `v/vt`, or the point `v`, and whether the word has that form.
pub(super) fn lone_vertex(
    read: &Statements,
    word: &str,
    element: Element,
) -> Result<(u32, Result<(), ObjProblem>), ObjProblem> {
    let bad = || {
        let word = word.to_owned();
        match element {
            Element::Line => ObjProblem::BadLineVertex { word },
            Element::Point => ObjProblem::BadPoint { word },
        }
    };
    let parts = parts(word).ok_or_else(bad)?;
    let fits = match parts[..] {
        [Some(_)] => Ok(()),
        [Some(_), Some(texture)] if element == Element::Line => {
            match read.resolve(texture, List::Texture) {
                Some(_) => Ok(()),
                None => return Err(read.out_of_range(word, List::Texture, texture)),
            }
        }
        _ => Err(bad()),
    };
    let index = parts[0].ok_or_else(bad)?;
    let vertex = read.resolve(index, List::Vertices);
    let vertex = vertex.ok_or_else(|| read.out_of_range(word, List::Vertices, index))?;
    Ok((vertex, fits))
}

/// The indices between the slashes of a word; `None` where something else than an index or nothing
/// is there.
fn parts(word: &str) -> Option<Vec<Option<i64>>> {
    let part = |part: &str| match part {
        "" => Some(None),
        _ => part.parse().ok().map(Some),
    };
    word.split('/').map(part).collect()
}
