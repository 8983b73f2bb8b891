//! Mesh files of any format, chosen by the ending of their names.

use std::ffi::OsStr;
use std::path::{Component, Path, PathBuf};

use ga_files::ReadError;

use crate::{FileError, Image, Mesh, gltf, obj, ply};

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

/// A mesh, with a sentence for each thing that its file refers to and that is not there.
type Read = (Mesh, Vec<String>);

/// The names, the first of which does not count, and contents of files.
type Files = Vec<(String, Vec<u8>)>;

/// What is known of a format.
struct Description {
    name: &'static str,
    /// The usual one first.
    endings: &'static [&'static str],
    keeps_materials: bool,
    read: fn(&Path) -> Result<Read, FileError>,
    files: fn(&Path, &Mesh, &Options) -> Result<Files, FileError>,
    /// What is left out of a mesh, a sentence each.
    omissions: fn(&Mesh) -> Vec<String>,
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
                read: |path| {
                    let (mesh, warnings) = obj::read_with_warnings(path)?;
                    Ok((mesh, warnings.iter().map(ToString::to_string).collect()))
                },
                files: |path, mesh, _| Ok(obj::files(path, mesh)),
                omissions: textures_without_place,
            },
            Self::Ply => &Description {
                name: "PLY",
                endings: &["ply"],
                keeps_materials: false,
                read: |path| {
                    let (mesh, warnings) = ply::read_with_warnings(path)?;
                    Ok((mesh, warnings.iter().map(ToString::to_string).collect()))
                },
                files: |_, mesh, options| Ok(vec![(String::new(), ply::encode(mesh, options.ply))]),
                omissions: |_| Vec::new(),
            },
            Self::Gltf => &Description {
                name: "glTF 2.0",
                endings: &["glb", "gltf"],
                keeps_materials: true,
                read: |path| {
                    let mesh = gltf::read(path)?.to_mesh(gltf::Vertices::Merged);
                    let wrong = |problem| ReadError::Contents {
                        path: path.to_path_buf(),
                        problem,
                    };
                    Ok((mesh.map_err(wrong)?, Vec::new()))
                },
                files: |path, mesh, _| gltf::mesh_files(path, mesh),
                omissions: |_| Vec::new(),
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

    /// What the format cannot hold of a mesh although it keeps the like, a sentence each: textures
    /// that MTL cannot place.
    #[must_use]
    pub fn omissions(self, mesh: &Mesh) -> Vec<String> {
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

/// Reads a mesh, and says what was replaced where the file refers to something that is not there, a
/// sentence each.
///
/// Vertices of a glTF file with equal positions become one vertex, see
/// [`Vertices::Merged`](gltf::Vertices::Merged), since such a file has to split vertices where
/// corners differ in normals or texture coordinates. Those of other formats are numbered as in the
/// file.
///
/// # Errors
///
/// [`FileError`].
pub fn read(path: impl AsRef<Path>) -> Result<(Mesh, Vec<String>), FileError> {
    let path = path.as_ref();
    (Format::of_path(path)?.description().read)(path)
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

/// The textures that MTL cannot place, a sentence for each material and reason.
fn textures_without_place(mesh: &Mesh) -> Vec<String> {
    let mut sentences = Vec::new();
    for material in mesh.materials() {
        for (kind, count) in [
            (
                "are rotated",
                material.textures().filter(|t| t.rotation != 0.0).count(),
            ),
            (
                "use a second set of texture coordinates",
                material.textures().filter(|t| t.set != 0).count(),
            ),
        ] {
            if count > 0 {
                let name = &material.name;
                sentences.push(format!(
                    "material {name:?}: textures that {kind} are left out, since MTL cannot describe \
                     them ({count})"
                ));
            }
        }
    }
    sentences
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
    let folder = |file: &Path| {
        let folder = std::path::absolute(file).ok()?;
        folder.parent().map(Path::to_path_buf)
    };
    let (Some(from), Some(to)) = (folder(from), folder(to)) else {
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
        if let Image::File(path) = &mut texture.image
            && (from != to || Path::new(path).has_root())
        {
            let picture = from.join(&*path);
            let relative = relative_path(&to, &picture);
            *path = relative.ok_or(FileError::Picture { path: picture })?;
        }
    }
    let of_faces = mesh.face_materials().to_vec();
    Ok(mesh.clone().with_materials(materials, of_faces)?)
}

/// The path from a folder to a file, both absolute, with `/` between folders.
fn relative_path(folder: &Path, file: &Path) -> Option<String> {
    let (mut folder, mut file) = (normal(folder), normal(file));
    let shared = folder.iter().zip(&file).take_while(|(a, b)| a == b).count();
    // Nothing in common, as on two drives.
    if shared == 0 {
        return None;
    }
    let mut steps = vec![".."; folder.split_off(shared).len()];
    let rest = file.split_off(shared);
    for component in &rest {
        steps.push(component.as_os_str().to_str()?);
    }
    Some(steps.join("/"))
}

/// The components of an absolute path, `.` and `..` resolved.
fn normal(path: &Path) -> Vec<Component<'_>> {
    let mut components = Vec::new();
    for component in path.components() {
        match component {
            Component::CurDir => {}
            Component::ParentDir => {
                components.pop();
            }
            other => components.push(other),
        }
    }
    components
}

#[cfg(test)]
mod tests {
    use super::*;

    #[cfg(unix)]
    #[test]
    fn paths_lead_from_folder_to_file() {
        let relative = |folder: &str, file: &str| relative_path(folder.as_ref(), file.as_ref());
        assert_eq!(relative("/a/b", "/a/b/c.png").unwrap(), "c.png");
        assert_eq!(relative("/a/b", "/a/x/../d/c.png").unwrap(), "../d/c.png");
        assert_eq!(relative("/a/b/c", "/d.png").unwrap(), "../../../d.png");
    }
}
