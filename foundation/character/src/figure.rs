//! The figure that is animated.

use std::path::{Path, PathBuf};

use ga_anim::character::Character;
use ga_anim::gltf::with_weights;
use ga_image::plane::Plane;
use ga_image::png;
use ga_mesh::gltf::Document;

use crate::error::CharacterError;

/// A character in metres with y up, with its name and the picture on its skin.
#[derive(Clone, Debug)]
pub struct Figure {
    /// The name of the mesh in files.
    pub name: String,
    /// Mesh, skeleton and skin weights.
    pub character: Character,
    /// The picture on its skin, for the texture coordinates of the mesh.
    pub paint: Option<Plane<[u8; 3]>>,
    /// The group of a larger mesh that it is; `None` for the whole.
    pub group: Option<String>,
    /// The length of one unit of the file that it was read from.
    pub metres_per_unit: f64,
    /// The glTF document that it was read from, in the unit of its file, with all that a character
    /// does not have: materials, morph targets, meshes that no joint moves, and more.
    pub document: Option<Document>,
    /// The file of the document, beside which the pictures of its materials are.
    pub file: Option<PathBuf>,
    /// What in the file of its mesh deviates from the format and was read nevertheless.
    pub warnings: Vec<ga_mesh::Warning>,
}

impl Figure {
    /// A whole character in metres, without a painted skin.
    pub fn new(name: impl Into<String>, character: Character) -> Self {
        Self {
            name: name.into(),
            character,
            paint: None,
            group: None,
            metres_per_unit: 1.0,
            document: None,
            file: None,
            warnings: Vec::new(),
        }
    }

    /// The same figure with weights that change over more edges: in each pass those of every vertex
    /// move half the way to the mean of those of its neighbours. No pass changes nothing.
    ///
    /// # Errors
    ///
    /// [`CharacterError::Smoothing`] where the mesh and the weights do not fit together, and
    /// [`CharacterError::Document`] where the document cannot hold them.
    pub fn with_smoothed_weights(mut self, passes: usize) -> Result<Self, CharacterError> {
        // Passes add the influences of neighbours, of which the far ones hardly count.
        const INFLUENCES: usize = 8;
        if passes > 0 {
            let Character { mesh, weights, .. } = &mut self.character;
            let smooth = weights.smoothed(&mesh.triangles(), passes, 0.5);
            *weights = smooth
                .map_err(CharacterError::Smoothing)?
                .strongest(INFLUENCES);
            if let Some(document) = &mut self.document {
                *document = with_weights(document, weights)?;
            }
        }
        Ok(self)
    }

    /// The same figure as it is to be written to a file: its document leads from there to the
    /// pictures of its materials.
    ///
    /// # Errors
    ///
    /// [`CharacterError::Relocation`] for a picture on another drive.
    pub fn relocated(mut self, to: &Path) -> Result<Self, CharacterError> {
        if let (Some(document), Some(from)) = (&mut self.document, self.file.take()) {
            let relocated = document.relocated(&from, to);
            *document = relocated.map_err(|error| CharacterError::Relocation(Box::new(error)))?;
            self.file = Some(to.to_path_buf());
        }
        Ok(self)
    }

    /// The picture on its skin as PNG.
    pub(crate) fn png(&self) -> Result<Option<Vec<u8>>, CharacterError> {
        let png = self.paint.as_ref().map(png::encode).transpose();
        png.map_err(|source| CharacterError::Encode {
            what: "painted skin",
            source,
        })
    }

    /// The joints that a name stands for: the one of this name, or all for `all`.
    ///
    /// # Errors
    ///
    /// [`CharacterError::NoJoint`] for another name, with those that there are.
    pub fn joints_named(&self, name: &str) -> Result<Vec<usize>, CharacterError> {
        let skeleton = &self.character.skeleton;
        match skeleton.index(name) {
            Some(joint) => Ok(vec![joint]),
            None if name == "all" => Ok((0..skeleton.len()).collect()),
            None => Err(CharacterError::NoJoint {
                name: name.to_owned(),
                joints: skeleton.joints().iter().map(|j| j.name.clone()).collect(),
            }),
        }
    }
}

#[cfg(test)]
#[allow(clippy::unwrap_used, reason = "a test may panic")]
mod tests {
    use ga_mannequin::Human;

    use super::*;

    #[test]
    fn names_stand_for_joints() {
        let figure = Figure::new("mannequin", Human::new().into());
        let all = figure.joints_named("all").unwrap();
        assert_eq!(all, (0..21).collect::<Vec<_>>());
        let [head] = figure.joints_named("Head").unwrap()[..] else {
            panic!("one joint")
        };
        assert_eq!(figure.character.skeleton.joints()[head].name, "Head");
        let error = figure.joints_named("Tail").unwrap_err();
        assert!(matches!(error, CharacterError::NoJoint { name, .. } if name == "Tail"));
    }
}
