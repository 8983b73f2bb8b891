//! The elements of a PLY file as a mesh.

use ga_files::Reading;
use ga_runtime::vga3::Vector;

use super::body::Body;
use super::header::{Element, Property, Scalar, header};
use super::problem::{Place, PlyProblem};
use super::warning::Warning;
use crate::colour_range::{ByteColours, ColourOutOfRange, ColourRange, part};
use crate::colour_space::linear_from_srgb;
use crate::{CornerAttribute, Faces, FormatError, Mesh, MeshError, Normals, Polylines, Rgba};

pub(super) fn mesh(bytes: &[u8], reading: Reading) -> Result<(Mesh, Vec<Warning>), FormatError> {
    let header = header(bytes)?;
    let mut body = Body::new(&header, bytes);
    let mut read = Elements::default();
    for element in &header.elements {
        match element.name.as_str() {
            "vertex" => read.vertices = Some(vertices(element, &mut body, reading)?),
            "face" => read.read_faces(element, &mut body)?,
            "edge" => read.read_edges(element, &mut body)?,
            "tristrips" => read.read_strips(element, &mut body)?,
            // Elements without properties take no space in any encoding, so that a file of a few
            // bytes may declare any number of them.
            _ if element.properties.is_empty() => {}
            _ => body.each(element, |body| {
                element
                    .properties
                    .iter()
                    .try_for_each(|property| skip(property, body))
            })?,
        }
    }
    let in_file = |problem| FormatError::Ply {
        place: Place::File,
        problem,
    };
    let vertices = read.vertices.take().ok_or(PlyProblem::NoVertices);
    let vertices = vertices.map_err(in_file)?;
    let warnings = vertices.has_bytes.then_some(Warning::ByteColours);
    let mesh = read.into_mesh(vertices);
    let mesh = mesh.map_err(|error| in_file(PlyProblem::Mesh(error)))?;
    Ok((mesh, warnings.into_iter().collect()))
}

fn at(element: &Element) -> impl Fn(PlyProblem) -> FormatError {
    let line = element.line;
    move |problem| FormatError::Ply {
        place: Place::Line(line),
        problem,
    }
}

#[derive(Default)]
struct Elements {
    vertices: Option<Vertices>,
    faces: Faces,
    /// Texture coordinates of corners; without lists of them in the file the second is empty.
    texture: Vec<[f64; 2]>,
    texture_corners: Vec<Option<u32>>,
    edges: Polylines,
}

/// Lists are empty where the file lacks their properties.
#[derive(Default)]
struct Vertices {
    positions: Vec<[f64; 3]>,
    normals: Vec<Vector<f64>>,
    colours: Vec<Rgba>,
    /// Whether colours without a full scale of their own were bytes.
    has_bytes: bool,
    texture: Vec<[f64; 2]>,
}

/// What a property of a vertex stands for, as a place in a list of twelve numbers.
fn slot(name: &str) -> Option<usize> {
    Some(match name {
        "x" => 0,
        "y" => 1,
        "z" => 2,
        "nx" => 3,
        "ny" => 4,
        "nz" => 5,
        "red" | "r" | "diffuse_red" => 6,
        "green" | "g" | "diffuse_green" => 7,
        "blue" | "b" | "diffuse_blue" => 8,
        "alpha" | "a" | "diffuse_alpha" => 9,
        "s" | "u" | "texture_u" => 10,
        "t" | "v" | "texture_v" => 11,
        _ => return None,
    })
}

fn vertices(
    element: &Element,
    body: &mut Body<'_>,
    reading: Reading,
) -> Result<Vertices, FormatError> {
    let slots: Vec<Option<usize>> = element
        .properties
        .iter()
        .map(|property| slot(&property.name).filter(|_| property.length.is_none()))
        .collect();
    let has = |slot: usize| slots.contains(&Some(slot));
    for (slot, property) in ["x", "y", "z"].into_iter().enumerate() {
        if !has(slot) {
            let element_name = "vertex";
            return Err(at(element)(PlyProblem::MissingProperty {
                element: element_name,
                property,
            }));
        }
    }
    let (has_normal, has_texture) = ((3..6).all(has), (10..12).all(has));
    let has_colour = (6..9).all(has);
    let count = body.check_count(element)?;
    let (mut colour_range, mut alpha_range) = (ColourRange::default(), ColourRange::default());
    let mut vertices = Vertices {
        positions: Vec::with_capacity(count),
        ..Vertices::default()
    };
    body.each(element, |body| {
        let mut numbers = [0.0; 12];
        numbers[9] = 1.0;
        for (property, &slot) in element.properties.iter().zip(&slots) {
            match slot {
                Some(slot) => {
                    let number = body.number(property.scalar)?;
                    numbers[slot] = match slot {
                        6..10 => number / property.scalar.full_scale(),
                        _ => number,
                    };
                }
                None => skip(property, body)?,
            }
        }
        let [x, y, z, nx, ny, nz, red, green, blue, alpha, u, v] = numbers;
        vertices.positions.push([x, y, z]);
        if has_normal {
            vertices.normals.push(Vector::new(nx, ny, nz));
        }
        if has_colour {
            let place = body.place(element);
            colour_range.see(&[red, green, blue], &place);
            alpha_range.see(&[alpha], &place);
            vertices.colours.push([red, green, blue, alpha]);
        }
        if has_texture {
            vertices.texture.push([u, v]);
        }
        Ok(())
    })?;
    let out_of_range = |ColourOutOfRange { place, value }| FormatError::Ply {
        place,
        problem: PlyProblem::ColourOutOfRange { value },
    };
    let ranges = [colour_range, alpha_range];
    let [of_colour, of_alpha] = ranges.map(|range| range.bytes().map_err(out_of_range));
    let bytes = [of_colour?, of_alpha?];
    let [is_colour_byte, is_alpha_byte] = [0, 1].map(|part| bytes[part].is_some());
    let first = bytes
        .into_iter()
        .flatten()
        .min_by(|a, b| a.place.cmp(&b.place));
    if let Some(ByteColours { place, value, .. }) = first {
        if reading == Reading::Strict {
            let problem = PlyProblem::ByteColours { value };
            return Err(FormatError::Ply { place, problem });
        }
        vertices.has_bytes = true;
    }
    for [red, green, blue, alpha] in &mut vertices.colours {
        for number in [red, green, blue] {
            *number = linear_from_srgb(part(*number, is_colour_byte));
        }
        *alpha = part(*alpha, is_alpha_byte);
    }
    Ok(vertices)
}

fn skip(property: &Property, body: &mut Body<'_>) -> Result<(), PlyProblem> {
    let count = match property.length {
        Some(length) => body.length(length, property.scalar)?,
        None => 1,
    };
    for _ in 0..count {
        body.number(property.scalar)?;
    }
    Ok(())
}

fn index(number: f64) -> Result<u32, PlyProblem> {
    if number.fract() != 0.0 || !(0.0..=f64::from(u32::MAX)).contains(&number) {
        return Err(PlyProblem::NotAnIndex { index: number });
    }
    Ok(number as u32)
}

impl Elements {
    fn read_faces(&mut self, element: &Element, body: &mut Body<'_>) -> Result<(), FormatError> {
        let is_polygon = |property: &Property| {
            let name = property.name.as_str();
            property.length.is_some() && matches!(name, "vertex_indices" | "vertex_index")
        };
        if !element.properties.iter().any(is_polygon) {
            return Err(at(element)(PlyProblem::MissingProperty {
                element: "face",
                property: "vertex_indices",
            }));
        }
        let is_texture =
            |property: &Property| property.length.is_some() && property.name == "texcoord";
        let has_texture = element.properties.iter().any(is_texture);
        let (mut polygon, mut texture) = (Vec::new(), Vec::new());
        body.each(element, |body| {
            for property in &element.properties {
                if is_polygon(property) {
                    read_list(property, body, &mut polygon, index)?;
                } else if is_texture(property) {
                    read_list(property, body, &mut texture, Ok)?;
                } else {
                    skip(property, body)?;
                }
            }
            self.faces.push(&polygon).map_err(|error| match error {
                MeshError::FaceTooShort { corners: found, .. } => {
                    PlyProblem::FaceTooShort { found }
                }
                error => PlyProblem::Mesh(error),
            })?;
            if has_texture {
                self.add_texture(polygon.len(), &texture)?;
            }
            Ok(())
        })
    }

    /// Triangles in strips, as Stanford's scans have them: each vertex of a strip makes a triangle
    /// with the two before it, in which the first two of every other triangle change places. A
    /// negative index ends a strip.
    fn read_strips(&mut self, element: &Element, body: &mut Body<'_>) -> Result<(), FormatError> {
        let is_strip = |property: &Property| {
            let name = property.name.as_str();
            property.length.is_some() && matches!(name, "vertex_indices" | "vertex_index")
        };
        if !element.properties.iter().any(is_strip) {
            return Err(at(element)(PlyProblem::MissingProperty {
                element: "tristrips",
                property: "vertex_indices",
            }));
        }
        let mut strip = Vec::new();
        body.each(element, |body| {
            for property in &element.properties {
                if is_strip(property) {
                    read_list(property, body, &mut strip, Ok)?;
                } else {
                    skip(property, body)?;
                }
            }
            for strip in strip.split(|&index| index < 0.0) {
                let vertices = strip.iter().map(|&number| index(number));
                let vertices = vertices.collect::<Result<Vec<u32>, _>>()?;
                for (number, &[a, b, c]) in vertices.array_windows().enumerate() {
                    let triangle = if number % 2 == 0 {
                        [a, b, c]
                    } else {
                        [b, a, c]
                    };
                    // Vertices are repeated where a strip changes its direction.
                    if a != b && b != c && c != a {
                        self.faces.push(&triangle).map_err(PlyProblem::Mesh)?;
                    }
                }
            }
            Ok(())
        })
    }

    /// Texture coordinates of a face; none where the list is empty.
    fn add_texture(&mut self, corners: usize, numbers: &[f64]) -> Result<(), PlyProblem> {
        if numbers.is_empty() {
            self.texture_corners.extend(vec![None; corners]);
            return Ok(());
        }
        let (coordinates, rest) = numbers.as_chunks();
        if coordinates.len() != corners || !rest.is_empty() {
            let found = numbers.len();
            return Err(PlyProblem::TextureLength { corners, found });
        }
        let first = self.texture.len() as u32;
        self.texture.extend_from_slice(coordinates);
        self.texture_corners
            .extend((first..).take(corners).map(Some));
        Ok(())
    }

    fn read_edges(&mut self, element: &Element, body: &mut Body<'_>) -> Result<(), FormatError> {
        for end in ["vertex1", "vertex2"] {
            let is_end = |property: &Property| property.length.is_none() && property.name == end;
            if !element.properties.iter().any(is_end) {
                return Err(at(element)(PlyProblem::MissingProperty {
                    element: "edge",
                    property: end,
                }));
            }
        }
        body.each(element, |body| {
            let mut ends = [0; 2];
            for property in &element.properties {
                match (property.name.as_str(), property.length) {
                    ("vertex1", None) => ends[0] = index(body.number(property.scalar)?)?,
                    ("vertex2", None) => ends[1] = index(body.number(property.scalar)?)?,
                    _ => skip(property, body)?,
                }
            }
            self.edges.push(&ends).map_err(PlyProblem::Mesh)
        })
    }

    fn into_mesh(self, vertices: Vertices) -> Result<Mesh, MeshError> {
        // Vertices alone are a cloud of points.
        let is_cloud = self.faces.is_empty() && self.edges.is_empty();
        let points = if is_cloud {
            vertices.positions.len()
        } else {
            0
        };
        let mut mesh = Mesh::new(vertices.positions, self.faces)?
            .with_polylines(self.edges)?
            .with_points((0..points as u32).collect())?;
        if !vertices.colours.is_empty() {
            mesh = mesh.with_colours(vertices.colours)?;
        }
        if !vertices.normals.is_empty() {
            let normals = Normals::of_directions(&vertices.normals, mesh.faces());
            mesh = mesh.with_normals(normals)?;
        }
        if !self.texture_corners.is_empty() {
            mesh = mesh.with_texture_coordinates(vec![CornerAttribute {
                values: self.texture,
                corners: self.texture_corners,
            }])?;
        } else if !vertices.texture.is_empty() {
            let texture = CornerAttribute::of_vertices(vertices.texture, mesh.faces());
            // An index out of range was found by `Mesh::new`.
            mesh = mesh.with_texture_coordinates(vec![texture])?;
        }
        Ok(mesh)
    }
}

fn read_list<T>(
    property: &Property,
    body: &mut Body<'_>,
    list: &mut Vec<T>,
    convert: impl Fn(f64) -> Result<T, PlyProblem>,
) -> Result<(), PlyProblem> {
    list.clear();
    let length = property.length.unwrap_or(Scalar::U8);
    for _ in 0..body.length(length, property.scalar)? {
        list.push(convert(body.number(property.scalar)?)?);
    }
    Ok(())
}
