//! Figures from files.

use std::path::Path;

use ga_anim::character::Character;
use ga_anim::skin::SkinError;
use ga_anim::{gltf, rig};
use ga_files::{ReadError, Reading};
use ga_mesh::{Mesh, obj};

use crate::error::CharacterError;
use crate::figure::Figure;

/// The group of the person in MakeHuman's meshes.
const BODY: &str = "body";

impl Figure {
    /// The figure of a mesh (OBJ), a rig and weights for all vertices of the mesh (JSON, see
    /// [`ga_anim::rig`]), in metres. It is the wanted group of the mesh; where none is wanted the
    /// group `body`, or the whole mesh without such a group.
    ///
    /// # Errors
    ///
    /// [`CharacterError::MeshFile`] and [`CharacterError::RigFile`] for files that cannot be read,
    /// [`CharacterError::NoGroup`], and [`CharacterError::Unit`] where a length in metres is not
    /// finite.
    pub fn read_parts(
        mesh_path: &Path,
        rig_path: &Path,
        weights_path: &Path,
        group: Option<&str>,
        metres_per_unit: f64,
        reading: Reading,
    ) -> Result<Self, CharacterError> {
        let (mesh, warnings) = obj::read_with_warnings(mesh_path, reading)?;
        let warnings = warnings.iter().map(|warning| warning.of_file(mesh_path));
        let skeleton = rig::read(rig_path)?;
        let weights = rig::read_weights(weights_path, &skeleton, mesh.vertex_count())?;
        let group = group_of(mesh_path, &mesh, group)?;
        let part = group.as_deref().and_then(|group| mesh.part(group));
        let (mesh, weights) = match part {
            Some(part) => {
                let selected = weights.select(&part.vertices);
                let weights = selected.ok_or(SkinError::VertexCount {
                    expected: mesh.vertex_count(),
                    found: weights.vertex_count(),
                })?;
                (part.mesh, weights)
            }
            None => (mesh, weights),
        };
        let character = Character {
            mesh,
            skeleton,
            weights,
        };
        let figure = Self::in_metres(mesh_path, character, metres_per_unit)?;
        Ok(Self {
            group,
            warnings: warnings.collect(),
            ..figure
        })
    }

    /// The figure of the skinned meshes of a glTF file, in metres, with the document of the file.
    ///
    /// # Errors
    ///
    /// [`CharacterError::MeshFile`] and [`CharacterError::RigFile`] for a file that cannot be read
    /// or has no skin, and [`CharacterError::Unit`] where a length in metres is not finite.
    pub fn read_gltf(path: &Path, metres_per_unit: f64) -> Result<Self, CharacterError> {
        let document = ga_mesh::gltf::read(path)?;
        let character = gltf::character(&document).map_err(|problem| ReadError::Contents {
            path: path.to_path_buf(),
            problem,
        })?;
        let figure = Self::in_metres(path, character, metres_per_unit)?;
        Ok(Self {
            document: Some(document),
            file: Some(path.to_path_buf()),
            ..figure
        })
    }

    fn in_metres(
        path: &Path,
        character: Character,
        metres_per_unit: f64,
    ) -> Result<Self, CharacterError> {
        let scaled = character.scaled(metres_per_unit);
        let character = scaled.map_err(|source| CharacterError::Unit {
            path: path.to_path_buf(),
            metres_per_unit,
            source: Box::new(source),
        })?;
        Ok(Self {
            metres_per_unit,
            ..Self::new(ga_files::stem(path), character)
        })
    }
}

fn group_of(
    path: &Path,
    mesh: &Mesh,
    wanted: Option<&str>,
) -> Result<Option<String>, CharacterError> {
    match wanted {
        None => Ok(mesh.group(BODY).map(|group| group.name.clone())),
        Some(group) if mesh.group(group).is_some() => Ok(Some(group.to_owned())),
        Some(group) => Err(CharacterError::NoGroup {
            path: path.to_path_buf(),
            group: group.to_owned(),
            groups: mesh.groups().iter().map(|g| g.name.clone()).collect(),
        }),
    }
}
