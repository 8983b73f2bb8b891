//! OBJ files as meshes with their materials.

use std::collections::HashMap;
use std::path::Path;
use std::{fmt, io};

use ga_files::{Deviation, ReadError, Reading, Tolerated};
use ga_runtime::vga3::Vector;

use super::ObjProblem;
use super::mtl::{self, MtlProblem};
use super::parser::statements;
use super::statements::Statements;
use crate::colour_space::linear_from_srgb;
use crate::{CornerAttribute, FormatError, Image, Material, Mesh, MeshError};

/// Something in an OBJ file that deviates from the format, or that the file refers to and that is
/// not there; and what the mesh has in its place.
#[derive(Clone, Debug, PartialEq)]
pub enum Warning {
    /// Lines that deviate from the format; each kind once.
    Deviation(Deviation<ObjProblem>),
    /// There is no material library of this name. Its materials are the default one.
    MissingLibrary {
        /// The line that names it.
        line: usize,
        /// Its name.
        library: String,
    },
    /// No library defines this material. It is the default one.
    UndefinedMaterial {
        /// The line that uses it first.
        line: usize,
        /// Its name.
        material: String,
    },
    /// There is no such picture. The material keeps the reference to it.
    MissingTexture {
        /// The name of the material.
        material: String,
        /// The path of the picture.
        path: String,
    },
    /// A library has lines that deviate from its format; each kind once.
    Library {
        /// The name of the library.
        library: String,
        /// The lines, in the library.
        deviation: Deviation<MtlProblem>,
    },
    /// Some `vn` lines are zero vectors. Corners with one of them have no normal.
    ZeroNormals {
        /// The first of them.
        line: usize,
        /// How many lines.
        count: usize,
    },
}

impl fmt::Display for Warning {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Warning::Deviation(deviation) => deviation.fmt(f),
            Warning::MissingLibrary { line, library } => write!(
                f,
                "line {line}: the file {library} does not exist; its materials have the default appearance"
            ),
            Warning::UndefinedMaterial { line, material } => write!(
                f,
                "line {line}: no library defines the material {material:?}; it has the default \
                 appearance"
            ),
            Warning::MissingTexture { material, path } => write!(
                f,
                "material {material:?}: there is no picture {path}; the surface is shown without it"
            ),
            Warning::Library { library, deviation } => write!(f, "{library}: {deviation}"),
            Warning::ZeroNormals { line, count } => write!(
                f,
                "line {line}: {count} normals are zero vectors; corners that refer to them have no \
                 normal"
            ),
        }
    }
}

impl Warning {
    /// What it is, as one word for programs.
    #[must_use]
    pub fn kind(&self) -> &'static str {
        match self {
            Warning::Deviation(deviation) => deviation.problem.kind(),
            Warning::Library { deviation, .. } => deviation.problem.kind(),
            Warning::ZeroNormals { .. } => "zero_normals",
            Warning::MissingLibrary { .. }
            | Warning::UndefinedMaterial { .. }
            | Warning::MissingTexture { .. } => "missing_part",
        }
    }

    /// The warning as one of the file at this path.
    #[must_use]
    pub fn of_file(&self, path: &Path) -> crate::Warning {
        let warning = |line, message| crate::Warning {
            kind: self.kind(),
            file: None,
            line,
            message,
        };
        match self {
            Warning::Library { library, deviation } => crate::Warning {
                file: Some(path.with_file_name(library)),
                ..warning(Some(deviation.line), deviation.to_string())
            },
            Warning::Deviation(Deviation { line, .. })
            | Warning::MissingLibrary { line, .. }
            | Warning::UndefinedMaterial { line, .. }
            | Warning::ZeroNormals { line, .. } => warning(Some(*line), self.to_string()),
            Warning::MissingTexture { .. } => warning(None, self.to_string()),
        }
    }
}

/// Reads the mesh in a file tolerantly, with the material libraries beside it.
///
/// # Errors
///
/// [`ReadError::Io`], or [`ReadError::Contents`] as [`decode_with_libraries`] gives.
pub fn read(path: impl AsRef<Path>) -> Result<Mesh, ReadError<FormatError>> {
    read_with_warnings(path, Reading::Tolerant).map(|(mesh, _)| mesh)
}

/// Reads the mesh in a file as [`read`] does, and says what was tolerated, left out or replaced.
///
/// # Errors
///
/// As [`read`].
pub fn read_with_warnings(
    path: impl AsRef<Path>,
    reading: Reading,
) -> Result<(Mesh, Vec<Warning>), ReadError<FormatError>> {
    let path = path.as_ref();
    let folder = path.parent().unwrap_or(Path::new(""));
    let (mesh, mut warnings) = ga_files::read(path, |bytes| {
        decode_with_libraries(bytes, reading, |library| {
            std::fs::read(folder.join(library))
        })
    })?;
    for material in mesh.materials() {
        for texture in material.textures() {
            if let Image::File(path) = &texture.image
                && !folder.join(path).exists()
            {
                let warning = Warning::MissingTexture {
                    material: material.name.clone(),
                    path: path.clone(),
                };
                if !warnings.contains(&warning) {
                    warnings.push(warning);
                }
            }
        }
    }
    Ok((mesh, warnings))
}

/// Reads a mesh from the bytes of a file tolerantly. Its materials have their names and are the
/// default otherwise.
///
/// # Errors
///
/// [`FormatError`], for the first faulty line; indices out of range are found after all other
/// errors.
///
/// # Examples
///
/// ```
/// let mesh = ga_mesh::obj::decode(b"v 0 0 0\nv 1 0 0\nv 0 1 0\ng corner\nf 1 2 -1\n")?;
/// assert_eq!(mesh.faces().get(0), Some(&[0, 1, 2][..]));
/// assert_eq!(mesh.group("corner").map(|group| group.faces.len()), Some(1));
///
/// let error = ga_mesh::obj::decode(b"v 0 0 0\nv 1 0\n").unwrap_err();
/// assert_eq!(error.to_string(), "line 2: a v line has 3, 4, 6 or 7 numbers, but this one has 2");
/// # Ok::<(), ga_mesh::FormatError>(())
/// ```
pub fn decode(bytes: &[u8]) -> Result<Mesh, FormatError> {
    let nothing = |_: &str| Err(io::ErrorKind::NotFound.into());
    decode_with_libraries(bytes, Reading::Tolerant, nothing).map(|(mesh, _)| mesh)
}

/// Reads a mesh from the bytes of a file; `open` gives the bytes of a material library by its name.
///
/// A name with spaces is asked for as a whole first and then word by word, since `mtllib` may list
/// several files. Of several materials of one name the first counts. The mesh has all materials of
/// the libraries, in their order.
///
/// # Errors
///
/// As [`decode`]; [`ObjProblem::LibraryUnreadable`] where `open` fails otherwise than with
/// [`NotFound`](io::ErrorKind::NotFound), and [`ObjProblem::Library`] for a fault in a library.
///
/// # Examples
///
/// ```
/// use ga_files::Reading;
/// use ga_mesh::obj::decode_with_libraries;
///
/// let text = b"mtllib a.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl red\nf 1 2 3\n";
/// let library = |_: &str| Ok(b"newmtl red\nKd 1 0 0\n".to_vec());
/// let (mesh, _) = decode_with_libraries(text, Reading::Strict, library)?;
/// let red = mesh.material(0).map(|material| material.base_colour);
/// assert_eq!(red, Some([1.0, 0.0, 0.0, 1.0]));
///
/// let text = b"v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\nvw 1 0.5\n";
/// let (_, warnings) = decode_with_libraries(text, Reading::Tolerant, library)?;
/// let message = "line 5: a line of a polygon mesh cannot begin with \"vw\"; it is left out";
/// assert_eq!(warnings[0].to_string(), message);
/// # Ok::<(), ga_mesh::FormatError>(())
/// ```
pub fn decode_with_libraries(
    bytes: &[u8],
    reading: Reading,
    mut open: impl FnMut(&str) -> io::Result<Vec<u8>>,
) -> Result<(Mesh, Vec<Warning>), FormatError> {
    let (mut read, deviations) = statements(bytes, reading)?;
    let mut warnings: Vec<Warning> = deviations.into_iter().map(Warning::Deviation).collect();
    let mut materials = Vec::new();
    let decode = |library: &[u8]| mtl::library(library, reading);
    for (library, line) in std::mem::take(&mut read.libraries) {
        let library = (library.as_str(), line);
        add_library(library, &mut open, decode, &mut materials, &mut warnings)?;
    }
    let face_materials = resolve(&mut read, &mut materials, &mut warnings);
    drop_zero_normals(&mut read, &mut warnings);
    let line = read.last_line;
    let mesh = mesh(read, materials, face_materials).map_err(|error| FormatError::Obj {
        line,
        problem: ObjProblem::Mesh(error),
    })?;
    Ok((mesh, warnings))
}

/// Adds the materials of what a `mtllib` line names.
fn add_library(
    (name, line): (&str, usize),
    open: &mut impl FnMut(&str) -> io::Result<Vec<u8>>,
    decode: impl Fn(&[u8]) -> Result<mtl::Library, mtl::Fault>,
    materials: &mut Vec<Material>,
    warnings: &mut Vec<Warning>,
) -> Result<(), FormatError> {
    let mut open = |library: &str| match open(library) {
        Ok(bytes) => Ok(Some(bytes)),
        Err(error) if error.kind() == io::ErrorKind::NotFound => Ok(None),
        Err(error) => Err(FormatError::Obj {
            line,
            problem: ObjProblem::LibraryUnreadable {
                library: library.to_owned(),
                message: error.to_string(),
            },
        }),
    };
    let mut library_warnings = Vec::new();
    let mut add = |library: &str, bytes: Vec<u8>| {
        let (read, deviations) = decode(&bytes).map_err(|(at, problem)| {
            let library = library.to_owned();
            let problem = ObjProblem::Library {
                library,
                line: at,
                problem: Box::new(problem),
            };
            FormatError::Obj { line, problem }
        })?;
        materials.extend(read);
        let deviations = deviations.into_iter();
        library_warnings.extend(deviations.map(|deviation| Warning::Library {
            library: library.to_owned(),
            deviation,
        }));
        Ok::<(), FormatError>(())
    };
    if name.is_empty() {
        return Ok(());
    }
    if let Some(bytes) = open(name)? {
        add(name, bytes)?;
        warnings.append(&mut library_warnings);
        return Ok(());
    }
    let words: Vec<&str> = name.split(' ').collect();
    let mut found = Vec::new();
    if words.len() > 1 {
        for word in &words {
            found.push(open(word)?);
        }
    }
    if found.iter().all(Option::is_none) {
        let library = name.to_owned();
        warnings.push(Warning::MissingLibrary { line, library });
        return Ok(());
    }
    for (word, bytes) in words.into_iter().zip(found) {
        match bytes {
            Some(bytes) => add(word, bytes)?,
            None => warnings.push(Warning::MissingLibrary {
                line,
                library: word.to_owned(),
            }),
        }
    }
    warnings.append(&mut library_warnings);
    Ok(())
}

/// The material of each face as an index into `materials`, which gains those that are used but not
/// defined.
fn resolve(
    read: &mut Statements,
    materials: &mut Vec<Material>,
    warnings: &mut Vec<Warning>,
) -> Vec<Option<u32>> {
    let mut by_name = HashMap::new();
    for (index, material) in materials.iter().enumerate() {
        by_name.entry(material.name.clone()).or_insert(index as u32);
    }
    let mut indices = Vec::new();
    for (name, line) in std::mem::take(&mut read.materials) {
        let index = match by_name.get(&name) {
            Some(&index) => index,
            None => {
                materials.push(Material::named(name.clone()));
                let material = name;
                warnings.push(Warning::UndefinedMaterial { line, material });
                materials.len() as u32 - 1
            }
        };
        indices.push(index);
    }
    let mut face_materials = std::mem::take(&mut read.face_materials);
    for material in face_materials.iter_mut().flatten() {
        *material = indices[*material as usize];
    }
    face_materials.resize(read.faces.len(), None);
    face_materials
}

/// Takes zero vectors out of the list of normals and numbers the others anew.
fn drop_zero_normals(read: &mut Statements, warnings: &mut Vec<Warning>) {
    let is_zero = |normal: &Vector<f64>| *normal == Vector::default();
    let count = read.normals.iter().filter(|normal| is_zero(normal)).count();
    if count == 0 {
        return;
    }
    let line = read.zero_normal_line.unwrap_or(read.last_line);
    warnings.push(Warning::ZeroNormals { line, count });
    let mut next = 0;
    let numbers: Vec<Option<u32>> = read
        .normals
        .iter()
        .map(|normal| {
            let number = (!is_zero(normal)).then_some(next);
            next += u32::from(number.is_some());
            number
        })
        .collect();
    read.normals.retain(|normal| !is_zero(normal));
    for corner in &mut read.normal_corners {
        *corner = corner.and_then(|index| numbers[index as usize]);
    }
}

fn mesh(
    read: Statements,
    materials: Vec<Material>,
    face_materials: Vec<Option<u32>>,
) -> Result<Mesh, MeshError> {
    let mut mesh = Mesh::new(read.positions, read.faces)?
        .with_groups(read.groups)?
        .with_objects(read.objects)?
        .with_polylines(read.polylines)?
        .with_points(read.points)?;
    if !materials.is_empty() {
        mesh = mesh.with_materials(materials, face_materials)?;
    }
    if !read.texture_corners.is_empty() || !read.texture.is_empty() {
        mesh = mesh.with_texture_coordinates(vec![CornerAttribute {
            values: read.texture,
            corners: read.texture_corners,
        }])?;
    }
    if !read.normals.is_empty() {
        mesh = mesh.with_normals(CornerAttribute {
            values: read.normals,
            corners: read.normal_corners,
        })?;
    }
    if !read.colours.is_empty() {
        let linear = |[red, green, blue, alpha]: [f64; 4]| {
            [
                linear_from_srgb(red),
                linear_from_srgb(green),
                linear_from_srgb(blue),
                alpha,
            ]
        };
        mesh = mesh.with_colours(read.colours.into_iter().map(linear).collect())?;
    }
    Ok(mesh)
}
