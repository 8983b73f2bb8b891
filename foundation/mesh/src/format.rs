//! Mesh files of any format, chosen by the ending of their names.

use std::ffi::OsStr;
use std::path::{Path, PathBuf};

use ga_files::{ReadError, Reading};

use crate::{
    FileError, Image, Material, Mesh, Omission, Warning, gltf, obj, omission, ply, relocation,
};

/// A format of mesh files. All are read and written.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Format {
    /// Wavefront OBJ; see [`obj`].
    Obj,
    /// PLY; see [`ply`].
    Ply,
    /// glTF 2.0, as JSON or GLB; see [`gltf`].
    Gltf,
}

/// How a mesh is written, for formats that leave a choice.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Options {
    /// The encoding of PLY.
    pub ply: ply::Encoding,
}

/// A mesh, with what in its file deviates from the format or is not there.
type Read = (Mesh, Vec<Warning>);

/// The names, the first of which does not count, and contents of files.
type Files = Vec<(String, Vec<u8>)>;

/// What is known of a format.
struct Description {
    name: &'static str,
    /// The usual one first.
    endings: &'static [&'static str],
    keeps_materials: bool,
    keeps_animations: bool,
    read: fn(&Path, Reading) -> Result<Read, FileError>,
    files: fn(&Path, &Mesh, &Options) -> Result<Files, FileError>,
    /// The files beside one that it is read with, but for pictures.
    libraries: fn(&Path, Reading) -> Result<Vec<PathBuf>, FileError>,
    /// What it cannot hold of a mesh.
    omissions: fn(&Mesh) -> Vec<Omission>,
}

impl Format {
    /// All formats.
    pub const ALL: [Self; 3] = [Self::Obj, Self::Ply, Self::Gltf];

    /// The table of the formats. All else that is said of them here follows from it.
    const fn description(self) -> &'static Description {
        match self {
            Self::Obj => &Description {
                name: "Wavefront OBJ with MTL",
                endings: &["obj"],
                keeps_materials: true,
                keeps_animations: false,
                read: |path, reading| {
                    let (mesh, warnings) = obj::read_with_warnings(path, reading)?;
                    let warnings = warnings.iter().map(|warning| warning.of_file(path));
                    Ok((mesh, warnings.collect()))
                },
                files: |path, mesh, _| Ok(obj::files(path, mesh)),
                libraries: libraries_of_obj,
                omissions: omission::of_obj,
            },
            Self::Ply => &Description {
                name: "PLY",
                endings: &["ply"],
                keeps_materials: false,
                keeps_animations: false,
                read: |path, reading| {
                    let (mesh, warnings) = ply::read_with_warnings(path, reading)?;
                    Ok((mesh, warnings.iter().map(Warning::from).collect()))
                },
                files: |_, mesh, options| Ok(vec![(String::new(), ply::encode(mesh, options.ply))]),
                libraries: |_, _| Ok(Vec::new()),
                omissions: omission::of_ply,
            },
            Self::Gltf => &Description {
                name: "glTF 2.0",
                endings: &["glb", "gltf"],
                keeps_materials: true,
                keeps_animations: true,
                read: |path, _| {
                    let mesh = gltf::read(path)?.to_mesh(gltf::Vertices::Merged);
                    let wrong = |problem| ReadError::Contents {
                        path: path.to_path_buf(),
                        problem,
                    };
                    Ok((mesh.map_err(wrong)?, Vec::new()))
                },
                files: |path, mesh, _| gltf::mesh_files(path, mesh),
                libraries: |path, _| buffers_of_gltf(path),
                omissions: omission::of_gltf,
            },
        }
    }

    /// The name for people, as `glTF 2.0`.
    #[must_use]
    pub fn name(self) -> &'static str {
        self.description().name
    }

    /// The endings of the names of its files in small letters, without the point, the usual one
    /// first.
    #[must_use]
    pub fn endings(self) -> &'static [&'static str] {
        self.description().endings
    }

    /// Whether the faces of a mesh keep their materials, and these their pictures.
    #[must_use]
    pub fn keeps_materials(self) -> bool {
        self.description().keeps_materials
    }

    /// Whether a mesh can move in it.
    #[must_use]
    pub fn keeps_animations(self) -> bool {
        self.description().keeps_animations
    }

    /// What the format cannot hold of a mesh, kind by kind.
    ///
    /// # Examples
    ///
    /// ```
    /// use ga_mesh::{format::Format, obj};
    ///
    /// let mesh = obj::decode(b"v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\ng a\nf 1 2 3 4\n")?;
    /// let omissions = Format::Ply.omissions(&mesh);
    /// assert_eq!(omissions[0].to_string(), "1 group is left out");
    /// # Ok::<(), ga_mesh::FormatError>(())
    /// ```
    #[must_use]
    pub fn omissions(self, mesh: &Mesh) -> Vec<Omission> {
        (self.description().omissions)(mesh)
    }

    /// The format that the ending of a file's name stands for, in small or capital letters.
    ///
    /// # Errors
    ///
    /// [`FileError::Unknown`].
    ///
    /// # Examples
    ///
    /// ```
    /// use ga_mesh::format::Format;
    ///
    /// assert_eq!(Format::of_path("scans/Bunny.PLY")?, Format::Ply);
    /// assert!(Format::of_path("bunny.txt").is_err());
    /// # Ok::<(), ga_mesh::FileError>(())
    /// ```
    pub fn of_path(path: impl AsRef<Path>) -> Result<Self, FileError> {
        let path = path.as_ref();
        let ending = path.extension().and_then(OsStr::to_str).unwrap_or("");
        let fits = |known: &&str| ending.eq_ignore_ascii_case(known);
        let mut formats = Self::ALL.into_iter();
        let found = formats.find(|format| format.endings().iter().any(fits));
        found.ok_or_else(|| FileError::Unknown {
            path: path.to_path_buf(),
            endings: Self::ALL
                .iter()
                .flat_map(|format| format.endings())
                .copied()
                .collect(),
        })
    }
}

/// Reads a mesh, and says what in its file deviates from the format and was read nevertheless, and
/// what was replaced where the file refers to something that is not there.
///
/// Vertices of a glTF file with equal positions become one vertex, see
/// [`Vertices::Merged`](gltf::Vertices::Merged), since such a file has to split vertices where
/// corners differ in normals or texture coordinates. Those of other formats are numbered as in the
/// file.
///
/// # Errors
///
/// [`FileError`].
pub fn read(path: impl AsRef<Path>, reading: Reading) -> Result<(Mesh, Vec<Warning>), FileError> {
    let path = path.as_ref();
    (Format::of_path(path)?.description().read)(path, reading)
}

/// The files beside a mesh that it is read with: libraries of materials, buffers, and pictures.
///
/// # Errors
///
/// [`FileError`].
pub fn parts(path: impl AsRef<Path>, reading: Reading) -> Result<Vec<PathBuf>, FileError> {
    let path = path.as_ref();
    let description = Format::of_path(path)?.description();
    let (mesh, _) = (description.read)(path, reading)?;
    let mut parts = (description.libraries)(path, reading)?;
    for texture in mesh.materials().iter().flat_map(Material::textures) {
        if let Image::File(picture) = &texture.image {
            parts.push(path.with_file_name(picture));
        }
    }
    Ok(parts)
}

/// Writes a mesh and the files beside it, all of them or none.
///
/// # Errors
///
/// [`FileError`].
pub fn write(path: impl AsRef<Path>, mesh: &Mesh, options: &Options) -> Result<(), FileError> {
    let files = encode_files(path, mesh, options)?;
    let files = files.iter().map(|(path, contents)| (path, &contents[..]));
    Ok(ga_files::write_together(files)?)
}

/// The paths and contents of the files that [`write()`] writes: that at `path` first, then those
/// beside it, as libraries of materials, buffers and pictures.
///
/// # Errors
///
/// [`FileError`].
///
/// # Examples
///
/// ```
/// use ga_mesh::{Faces, Material, Mesh, format};
///
/// let corners = vec![[0.0; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]];
/// let mesh = Mesh::new(corners, Faces::from_polygons([[0, 1, 2]])?)?
///     .with_materials(vec![Material::named("red")], vec![Some(0)])?;
/// let files = format::encode_files("out/a.obj", &mesh, &format::Options::default())?;
/// assert_eq!(files[0].0.to_str(), Some("out/a.obj"));
/// assert!(files[1].0.ends_with("a.mtl"));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn encode_files(
    path: impl AsRef<Path>,
    mesh: &Mesh,
    options: &Options,
) -> Result<Vec<(PathBuf, Vec<u8>)>, FileError> {
    let path = path.as_ref();
    let files = (Format::of_path(path)?.description().files)(path, mesh, options)?;
    let files = files.into_iter().enumerate();
    let files = files.map(|(index, (name, contents))| match index {
        0 => (path.to_path_buf(), contents),
        _ => (path.with_file_name(name), contents),
    });
    Ok(files.collect())
}

/// The libraries of materials that an OBJ file names and that are there.
fn libraries_of_obj(path: &Path, reading: Reading) -> Result<Vec<PathBuf>, FileError> {
    let mut libraries = Vec::new();
    ga_files::read(path, |bytes| {
        obj::decode_with_libraries(bytes, reading, |name| {
            let library = path.with_file_name(name);
            let bytes = std::fs::read(&library)?;
            libraries.push(library);
            Ok(bytes)
        })
    })?;
    Ok(libraries)
}

/// The buffers of a glTF file that lie beside it.
fn buffers_of_gltf(path: &Path) -> Result<Vec<PathBuf>, FileError> {
    let document = gltf::read(path)?;
    let buffers = document.origin.buffer_files().iter();
    Ok(buffers.map(|buffer| path.with_file_name(buffer)).collect())
}

/// The mesh of a file as it is to be written to another file: where that lies in another folder,
/// the paths of pictures are changed so that they lead to the same pictures. Absolute paths become
/// relative ones in any case.
///
/// # Errors
///
/// [`FileError::Picture`] for a picture on another drive. [`FileError::Mesh`] is passed on; a
/// mesh that was read has no such fault.
pub fn relocated(mesh: &Mesh, from: &Path, to: &Path) -> Result<Mesh, FileError> {
    let Some(way) = relocation::Way::new(from, to) else {
        return Ok(mesh.clone());
    };
    if mesh.materials().is_empty() {
        return Ok(mesh.clone());
    }
    let mut materials = mesh.materials().to_vec();
    for texture in materials
        .iter_mut()
        .flat_map(|material| material.textures_mut())
    {
        if let Image::File(path) = &mut texture.image {
            *path = way.of(path)?;
        }
    }
    let of_faces = mesh.face_materials().to_vec();
    Ok(mesh.clone().with_materials(materials, of_faces)?)
}
