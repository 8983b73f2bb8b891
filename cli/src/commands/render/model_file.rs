//! The model as it is read and as it moves.

use std::path::{Path, PathBuf};

use anyhow::{Context as _, Result, bail};
use ga_character::AnimatedScene;
use ga_character::animated_scene::Moment;
use ga_mesh::Mesh;
use ga_mesh::gltf::{self, Animation, Document};
use ga_render::View;
use ga_render::model::Model;

use crate::format::Format;
use crate::frame::Warning;
use crate::mesh_file;

/// What is in the file of a model.
pub(super) struct ModelFile {
    path: PathBuf,
    /// The document of a glTF file.
    pub(super) document: Option<Document>,
    /// The mesh of a file of another format.
    mesh: Option<Mesh>,
    pub(super) warnings: Vec<Warning>,
}

impl ModelFile {
    /// Reads a model, with its animations where they are played.
    pub(super) fn read(path: &Path, plays: bool) -> Result<Self> {
        let mut file = Self {
            path: path.to_path_buf(),
            document: None,
            mesh: None,
            warnings: Vec::new(),
        };
        if Format::of(path, &[Format::Glb, Format::Gltf]).is_some() {
            let mut document = gltf::read(path)?;
            if !plays {
                // One that cannot be played does not matter.
                document.animations.clear();
            }
            file.document = Some(document);
        } else if plays {
            bail!(
                "{}: only glTF models (.glb or .gltf) have animations",
                path.display()
            );
        } else {
            let (mesh, warnings) = mesh_file::read(path)?;
            (file.mesh, file.warnings) = (Some(mesh), warnings);
        }
        Ok(file)
    }

    /// The animation of a number.
    pub(super) fn animation(&self, number: Option<usize>) -> Option<&Animation> {
        self.document.as_ref()?.animations.get(number?)
    }

    /// The model with its pictures.
    pub(super) fn scene(&self) -> Result<Scene<'_>> {
        let folder = self.path.parent();
        let named = || self.path.display().to_string();
        match (&self.document, &self.mesh) {
            (Some(document), _) => {
                let scene = AnimatedScene::new(document, folder);
                Ok(Scene::Animated(Box::new(scene.with_context(named)?)))
            }
            (None, mesh) => {
                let mesh = mesh.as_ref();
                let model = mesh.map(|mesh| Model::from_mesh(mesh, folder));
                let model = model.transpose().with_context(named)?;
                let model = model.unwrap_or_default().with_both_sides();
                Ok(Scene::Still(Box::new(model)))
            }
        }
    }
}

/// A model that moves, or one that does not.
pub(super) enum Scene<'a> {
    Animated(Box<AnimatedScene<'a>>),
    Still(Box<Model>),
}

impl Scene<'_> {
    pub(super) fn at(&mut self, moment: Moment) -> Result<&Model> {
        Ok(match self {
            Self::Animated(scene) => scene.at(moment)?,
            Self::Still(model) => model,
        })
    }

    /// What the camera of a node sees.
    pub(super) fn view(&self, node: usize, moment: Moment) -> Result<View> {
        match self {
            Self::Animated(scene) => Ok(scene.view(node, moment)?),
            Self::Still(_) => bail!("the model has no camera"),
        }
    }

    /// Warnings of what the file refers to that is not there.
    pub(super) fn warnings(&self, file: &Path) -> Vec<Warning> {
        let sentences = match self {
            Self::Animated(scene) => scene.warnings(),
            Self::Still(model) => model.warnings(),
        };
        mesh_file::missing_parts(file, sentences.iter().cloned())
    }
}
