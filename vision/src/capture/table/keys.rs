//! Where points are on a mesh, as a table.

use ga_files::table::{Table, TableError};
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
    /// The text is not a table.
    #[error(transparent)]
    Table(#[from] TableError),
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
        line: usize,
        /// The name.
        name: String,
    },
    /// Two keys have one point.
    #[error("line {line}: point {name:?} is there twice")]
    Twice {
        /// The line in the file, from 1.
        line: usize,
        /// The name.
        name: String,
    },
    /// A vertex is not one of the mesh.
    #[error("line {line}: {text:?} is not a vertex of the mesh, which are 0 to {last}")]
    Vertex {
        /// The line in the file, from 1.
        line: usize,
        /// The text of the field.
        text: String,
        /// The last vertex of the mesh.
        last: usize,
    },
}

/// The keys of a table with the columns `point,vertex` or `point,x,y,z`.
///
/// # Errors
/// What is wrong with the table, with the line.
pub fn decode_keys(
    bytes: &[u8],
    points: &PointTable,
    mesh: &Mesh,
) -> Result<Vec<Key>, KeyTableError> {
    let table = Table::with_names(bytes).map_err(|error| match error {
        TableError::Empty => KeyTableError::Header(String::new()),
        other => other.into(),
    })?;
    let header = table.names().iter().map(|name| name.to_ascii_lowercase());
    let header: Vec<_> = header.collect();
    let names: Vec<_> = header.iter().map(String::as_str).collect();
    let by_vertex = match names[..] {
        ["point", "vertex"] => true,
        ["point", "x", "y", "z"] => false,
        _ => return Err(KeyTableError::Header(header.join(","))),
    };
    let mut keys: Vec<Key> = Vec::new();
    for row in 0..table.len() {
        let (line, name) = (table.line(row), table.text(row, 0));
        let named = || name.to_owned();
        let point = points.point(name);
        let point = point.map_err(|_| KeyTableError::NoPoint {
            line,
            name: named(),
        })?;
        if keys.iter().any(|key| key.point == point) {
            return Err(KeyTableError::Twice {
                line,
                name: named(),
            });
        }
        let place = match by_vertex {
            true => vertex(&table, row, mesh)?,
            false => place(&table, row)?,
        };
        keys.push(Key { point, place });
    }
    if keys.is_empty() {
        return Err(KeyTableError::Empty);
    }
    Ok(keys)
}

fn vertex(table: &Table, row: usize, mesh: &Mesh) -> Result<Point<f64>, KeyTableError> {
    let text = table.text(row, 1);
    let index = text.parse::<usize>().ok();
    let place = index.and_then(|index| mesh.positions().get(index));
    place.copied().ok_or_else(|| KeyTableError::Vertex {
        line: table.line(row),
        text: text.to_owned(),
        last: mesh.vertex_count().saturating_sub(1),
    })
}

fn place(table: &Table, row: usize) -> Result<Point<f64>, KeyTableError> {
    let mut place = [0.0; 3];
    for (coordinate, column) in place.iter_mut().zip(1..) {
        let number = table.number(row, column)?;
        *coordinate = number.ok_or_else(|| table.not_a_number(row, column))?;
    }
    Ok(place.into())
}
