//! Where points are on a mesh, as CSV.

use csv::{ReaderBuilder, StringRecord, Trim};
use ga_mesh::Mesh;
use ga_runtime::cga3::Point;

use super::points::Points;

/// A point that drives the surface.
#[derive(Clone, Copy)]
pub(super) struct Key {
    /// The point, by its column in the table of points.
    pub(super) point: usize,
    /// Where it is on the mesh.
    pub(super) place: Point<f64>,
}

/// What is wrong with a table of keys.
#[derive(Debug, thiserror::Error)]
pub(super) enum KeysError {
    #[error("{0}")]
    Csv(#[from] csv::Error),
    #[error("the first line must be `point,vertex` or `point,x,y,z`, not {0:?}")]
    Header(String),
    #[error("there are no keys")]
    Empty,
    #[error("line {line}: {name:?} is not the name of a point")]
    NoPoint { line: u64, name: String },
    #[error("line {line}: point {name:?} is there twice")]
    Twice { line: u64, name: String },
    #[error("line {line}: {text:?} is not a vertex of the mesh, which are 0 to {last}")]
    Vertex {
        line: u64,
        text: String,
        last: usize,
    },
    #[error("line {line}: {text:?} is not a finite number")]
    Number { line: u64, text: String },
}

/// The keys of a table with the columns `point,vertex` or `point,x,y,z`.
pub(super) fn parse(bytes: &[u8], points: &Points, mesh: &Mesh) -> Result<Vec<Key>, KeysError> {
    let bytes = bytes.strip_prefix(b"\xef\xbb\xbf").unwrap_or(bytes);
    let mut reader = ReaderBuilder::new().trim(Trim::All).from_reader(bytes);
    let header: Vec<_> = reader
        .headers()?
        .iter()
        .map(str::to_ascii_lowercase)
        .collect();
    let names: Vec<_> = header.iter().map(String::as_str).collect();
    let by_vertex = match names[..] {
        ["point", "vertex"] => true,
        ["point", "x", "y", "z"] => false,
        _ => return Err(KeysError::Header(header.join(","))),
    };
    let mut keys: Vec<Key> = Vec::new();
    for record in reader.records() {
        let record = record?;
        let line = record.position().map_or(1, csv::Position::line);
        let name = || record[0].to_owned();
        let point = points.point(&record[0]);
        let point = point.ok_or_else(|| KeysError::NoPoint { line, name: name() })?;
        if keys.iter().any(|key| key.point == point) {
            return Err(KeysError::Twice { line, name: name() });
        }
        let place = match by_vertex {
            true => vertex(&record, line, mesh)?,
            false => place(&record, line)?,
        };
        keys.push(Key { point, place });
    }
    if keys.is_empty() {
        return Err(KeysError::Empty);
    }
    Ok(keys)
}

fn vertex(record: &StringRecord, line: u64, mesh: &Mesh) -> Result<Point<f64>, KeysError> {
    let text = &record[1];
    let index = text.parse::<usize>().ok();
    let place = index.and_then(|index| mesh.positions().get(index));
    place.copied().ok_or_else(|| KeysError::Vertex {
        line,
        text: text.to_owned(),
        last: mesh.vertex_count().saturating_sub(1),
    })
}

fn place(record: &StringRecord, line: u64) -> Result<Point<f64>, KeysError> {
    let mut place = [0.0; 3];
    for (coordinate, text) in place.iter_mut().zip(record.iter().skip(1)) {
        let number = text.parse::<f64>().ok().filter(|x| x.is_finite());
        *coordinate = number.ok_or_else(|| KeysError::Number {
            line,
            text: text.to_owned(),
        })?;
    }
    Ok(place.into())
}
