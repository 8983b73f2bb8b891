//! Meshes as PLY files.

use super::Encoding;
use super::header::Scalar;
use crate::colour_space::srgb_from_linear;
use crate::{CornerAttribute, Mesh};

/// A mesh as the bytes of a PLY file. What PLY cannot hold is left out; see [`ply`](super).
///
/// # Examples
///
/// ```
/// use ga_mesh::{obj, ply};
///
/// let mesh = obj::decode(b"v 0 0 0\nv 1 0 0\nv 0 0.1 0\nf 1 2 3\n")?;
/// let file = ply::encode(&mesh, ply::Encoding::Ascii);
/// assert!(file.ends_with(b"end_header\n0 0 0\n1 0 0\n0 0.1 0\n3 0 1 2\n"));
/// assert_eq!(ply::decode(&file).as_ref(), Ok(&mesh));
/// # Ok::<(), ga_mesh::FormatError>(())
/// ```
#[must_use]
pub fn encode(mesh: &Mesh, encoding: Encoding) -> Vec<u8> {
    let vertices = VertexColumns::new(mesh);
    let faces = FaceColumns::new(mesh, &vertices);
    let edges: usize = mesh.polylines().iter().map(|line| line.len() - 1).sum();
    let mut file = header(mesh, &vertices, &faces, edges, encoding).into_bytes();
    let mut numbers = Numbers {
        encoding,
        file: &mut file,
        begins_line: true,
    };
    for vertex in 0..mesh.vertex_count() {
        for column in &vertices.columns {
            for &number in &column.numbers[vertex * column.names.len()..][..column.names.len()] {
                numbers.push(column.scalar, number);
            }
        }
        numbers.end_line();
    }
    let mut corner = 0;
    for face in mesh.faces() {
        numbers.push(faces.length, face.len() as f64);
        for &vertex in face {
            numbers.push(faces.index, f64::from(vertex));
        }
        if let Some(texture) = faces.texture {
            let coordinates: Vec<[f64; 2]> = (corner..corner + face.len())
                .map_while(|corner| texture.get(corner).copied())
                .collect();
            let whole = coordinates.len() == face.len();
            let coordinates = if whole { &coordinates[..] } else { &[] };
            numbers.push(faces.texture_length, 2.0 * coordinates.len() as f64);
            for &number in coordinates.as_flattened() {
                numbers.push(faces.texture_scalar, number);
            }
        }
        corner += face.len();
        numbers.end_line();
    }
    for pair in mesh.polylines().iter().flat_map(|line| line.windows(2)) {
        for &vertex in pair {
            numbers.push(faces.index, f64::from(vertex));
        }
        numbers.end_line();
    }
    file
}

/// Properties of vertices that have one type, such as x, y and z.
struct Column {
    names: &'static [&'static str],
    scalar: Scalar,
    /// One number for each name, vertex after vertex.
    numbers: Vec<f64>,
}

impl Column {
    fn new(names: &'static [&'static str], numbers: Vec<f64>) -> Self {
        let scalar = floating(&numbers);
        Self {
            names,
            scalar,
            numbers,
        }
    }
}

struct VertexColumns {
    columns: Vec<Column>,
    /// Whether texture coordinates are among them.
    has_texture: bool,
}

impl VertexColumns {
    fn new(mesh: &Mesh) -> Self {
        let positions: Vec<f64> = mesh.coordinates().flatten().collect();
        let mut columns = vec![Column::new(&["x", "y", "z"], positions)];
        if let Some(normals) = mesh
            .normals()
            .and_then(|normals| of_vertices(mesh, normals))
        {
            let numbers = normals
                .into_iter()
                .flat_map(|normal| normal.unwrap_or_default().coordinates());
            columns.push(Column::new(&["nx", "ny", "nz"], numbers.collect()));
        }
        let texture = mesh
            .texture_coordinates()
            .filter(|texture| texture.corners.iter().all(Option::is_some))
            .and_then(|texture| of_vertices(mesh, texture));
        let has_texture = texture.is_some();
        if let Some(texture) = texture {
            let numbers = texture.into_iter().flat_map(Option::unwrap_or_default);
            columns.push(Column::new(&["s", "t"], numbers.collect()));
        }
        columns.extend(colours(mesh));
        Self {
            columns,
            has_texture,
        }
    }
}

fn colours(mesh: &Mesh) -> Option<Column> {
    let colours = mesh.colours()?;
    let opaque = colours.iter().all(|colour| colour[3] == 1.0);
    let names: &[_] = if opaque {
        &["red", "green", "blue"]
    } else {
        &["red", "green", "blue", "alpha"]
    };
    let mut numbers = Vec::with_capacity(names.len() * colours.len());
    for &[red, green, blue, alpha] in colours {
        numbers.extend([red, green, blue].map(srgb_from_linear));
        if !opaque {
            numbers.push(alpha);
        }
    }
    let in_bytes = |number: &f64| {
        let byte = 255.0 * number;
        (byte - byte.round()).abs() < 1e-9 && (0.0..=255.0).contains(&byte.round())
    };
    if !numbers.iter().all(in_bytes) {
        return Some(Column::new(names, numbers));
    }
    Some(Column {
        names,
        scalar: Scalar::U8,
        numbers: numbers.into_iter().map(|n| (255.0 * n).round()).collect(),
    })
}

/// The types of the lists of faces.
struct FaceColumns<'a> {
    length: Scalar,
    index: Scalar,
    texture: Option<&'a CornerAttribute<[f64; 2]>>,
    texture_length: Scalar,
    texture_scalar: Scalar,
}

impl<'a> FaceColumns<'a> {
    fn new(mesh: &'a Mesh, vertices: &VertexColumns) -> Self {
        let longest = mesh.faces().iter().map(<[u32]>::len).max().unwrap_or(0);
        let length = |longest: usize| match u8::try_from(longest) {
            Ok(_) => Scalar::U8,
            Err(_) => Scalar::U32,
        };
        let is_int = i32::try_from(mesh.vertex_count()).is_ok();
        let texture = mesh
            .texture_coordinates()
            .filter(|texture| !vertices.has_texture && texture.corners.iter().any(Option::is_some));
        Self {
            length: length(longest),
            index: if is_int { Scalar::I32 } else { Scalar::U32 },
            texture,
            texture_length: length(2 * longest),
            texture_scalar: floating(texture.map_or(&[][..], |set| set.values.as_flattened())),
        }
    }
}

/// The type of floating-point numbers that loses nothing.
fn floating(numbers: &[f64]) -> Scalar {
    let is_single = |&number: &f64| f64::from(number as f32) == number;
    if numbers.iter().all(is_single) {
        Scalar::F32
    } else {
        Scalar::F64
    }
}

/// The value of each vertex, or `None` where its corners differ or none has any.
fn of_vertices<T: Copy + PartialEq>(
    mesh: &Mesh,
    attribute: &CornerAttribute<T>,
) -> Option<Vec<Option<T>>> {
    let mut values: Vec<Option<Option<T>>> = vec![None; mesh.vertex_count()];
    for (corner, &vertex) in mesh.faces().corners().iter().enumerate() {
        let value = attribute.get(corner).copied();
        let known = values[vertex as usize].get_or_insert(value);
        if *known != value {
            return None;
        }
    }
    let values: Vec<Option<T>> = values.into_iter().map(Option::flatten).collect();
    values.iter().any(Option::is_some).then_some(values)
}

fn header(
    mesh: &Mesh,
    vertices: &VertexColumns,
    faces: &FaceColumns<'_>,
    edges: usize,
    encoding: Encoding,
) -> String {
    let format = match encoding {
        Encoding::Ascii => "ascii",
        Encoding::LittleEndian => "binary_little_endian",
        Encoding::BigEndian => "binary_big_endian",
    };
    let mut text = format!(
        "ply\nformat {format} 1.0\nelement vertex {}\n",
        mesh.vertex_count()
    );
    for column in &vertices.columns {
        for name in column.names {
            text += &format!("property {} {name}\n", column.scalar.name());
        }
    }
    let [length, index] = [faces.length.name(), faces.index.name()];
    text += &format!("element face {}\n", mesh.faces().len());
    text += &format!("property list {length} {index} vertex_indices\n");
    if faces.texture.is_some() {
        let [length, scalar] = [faces.texture_length.name(), faces.texture_scalar.name()];
        text += &format!("property list {length} {scalar} texcoord\n");
    }
    if edges > 0 {
        text += &format!("element edge {edges}\n");
        text += &format!("property {index} vertex1\nproperty {index} vertex2\n");
    }
    text + "end_header\n"
}

/// Appends numbers to a file.
struct Numbers<'a> {
    encoding: Encoding,
    file: &'a mut Vec<u8>,
    begins_line: bool,
}

impl Numbers<'_> {
    fn push(&mut self, scalar: Scalar, number: f64) {
        if self.encoding == Encoding::Ascii {
            if !self.begins_line {
                self.file.push(b' ');
            }
            self.begins_line = false;
            // In full, since text is read in double precision whatever type is declared.
            self.file.extend_from_slice(number.to_string().as_bytes());
            return;
        }
        let start = self.file.len();
        match scalar {
            Scalar::I8 => self.file.extend((number as i8).to_le_bytes()),
            Scalar::U8 => self.file.push(number as u8),
            Scalar::I16 => self.file.extend((number as i16).to_le_bytes()),
            Scalar::U16 => self.file.extend((number as u16).to_le_bytes()),
            Scalar::I32 => self.file.extend((number as i32).to_le_bytes()),
            Scalar::U32 => self.file.extend((number as u32).to_le_bytes()),
            Scalar::F32 => self.file.extend((number as f32).to_le_bytes()),
            Scalar::F64 => self.file.extend(number.to_le_bytes()),
        }
        if self.encoding == Encoding::BigEndian {
            self.file[start..].reverse();
        }
    }

    fn end_line(&mut self) {
        if self.encoding == Encoding::Ascii {
            self.file.push(b'\n');
            self.begins_line = true;
        }
    }
}
