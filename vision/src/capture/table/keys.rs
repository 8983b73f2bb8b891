//! Where points are on a mesh, as CSV.

use csv::{ReaderBuilder, StringRecord, Trim};
use ga_mesh::Mesh;
use ga_runtime::cga3::Point;

use super::points::PointTable;

/// A point that drives the surface.
#[derive(Clone, Copy, Debug)]
pub struct Key {
    /// The point, by its column in the table of points.
    pub point: usize,
    /// Where it is on the mesh.
    pub place: Point<f64>,
}

/// What is wrong with a table of keys.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum KeyTableError {
    /// The text is not CSV.
    #[error("{0}")]
    Csv(#[from] csv::Error),
    /// The first line has other names.
    #[error("the first line must be `point,vertex` or `point,x,y,z`, not {0:?}")]
    Header(String),
    /// There is no key.
    #[error("there are no keys")]
    Empty,
    /// A name is not that of a point.
    #[error("line {line}: {name:?} is not the name of a point")]
    NoPoint {
        /// The line in the file, from 1.
        line: u64,
        /// The name.
        name: String,
    },
    /// Two keys have one point.
    #[error("line {line}: point {name:?} is there twice")]
    Twice {
        /// The line in the file, from 1.
        line: u64,
        /// The name.
        name: String,
    },
    /// A vertex is not one of the mesh.
    #[error("line {line}: {text:?} is not a vertex of the mesh, which are 0 to {last}")]
    Vertex {
        /// The line in the file, from 1.
        line: u64,
        /// The text of the field.
        text: String,
        /// The last vertex of the mesh.
        last: usize,
    },
    /// A coordinate is not a finite number.
    #[error("line {line}: {text:?} is not a finite number")]
    Number {
        /// The line in the file, from 1.
        line: u64,
        /// The text of the field.
        text: String,
    },
}

/// The keys of a table with the columns `point,vertex` or `point,x,y,z`.
///
/// # Errors
/// What is wrong with the table, with the line.
pub fn parse_keys(
    bytes: &[u8],
    points: &PointTable,
    mesh: &Mesh,
) -> Result<Vec<Key>, KeyTableError> {
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
        _ => return Err(KeyTableError::Header(header.join(","))),
    };
    let mut keys: Vec<Key> = Vec::new();
    for record in reader.records() {
        let record = record?;
        let line = record.position().map_or(1, csv::Position::line);
        let name = || record[0].to_owned();
        let point = points.point(&record[0]);
        let point = point.ok_or_else(|| KeyTableError::NoPoint { line, name: name() })?;
        if keys.iter().any(|key| key.point == point) {
            return Err(KeyTableError::Twice { line, name: name() });
        }
        let place = match by_vertex {
            true => vertex(&record, line, mesh)?,
            false => place(&record, line)?,
        };
        keys.push(Key { point, place });
    }
    if keys.is_empty() {
        return Err(KeyTableError::Empty);
    }
    Ok(keys)
}

fn vertex(record: &StringRecord, line: u64, mesh: &Mesh) -> Result<Point<f64>, KeyTableError> {
    let text = &record[1];
    let index = text.parse::<usize>().ok();
    let place = index.and_then(|index| mesh.positions().get(index));
    place.copied().ok_or_else(|| KeyTableError::Vertex {
        line,
        text: text.to_owned(),
        last: mesh.vertex_count().saturating_sub(1),
    })
}

fn place(record: &StringRecord, line: u64) -> Result<Point<f64>, KeyTableError> {
    let mut place = [0.0; 3];
    for (coordinate, text) in place.iter_mut().zip(record.iter().skip(1)) {
        let number = text.parse::<f64>().ok().filter(|x| x.is_finite());
        *coordinate = number.ok_or_else(|| KeyTableError::Number {
            line,
            text: text.to_owned(),
        })?;
    }
    Ok(place.into())
}
