//! The character that is fitted.

use std::path::Path;

use anyhow::{Context as _, Result};
use ga_anim::clip::Clip;
use ga_anim::gltf::{Rigged, character};
use ga_anim::pose::Pose;
use ga_character::Figure;
use ga_mannequin::Human;
use ga_mesh::gltf::{self, Document};

/// The name of the person that the program makes itself.
pub(crate) const MANNEQUIN: &str = "mannequin";

/// Where the character comes from: a file, or the program where it is called [`MANNEQUIN`]. A file
/// of that name is written with its folder, as in `./mannequin`.
pub(crate) struct CharacterFile<'a>(pub(crate) &'a Path);

impl<'a> CharacterFile<'a> {
    /// The file, where it is one.
    pub(crate) fn path(&self) -> Option<&'a Path> {
        (self.0.as_os_str() != MANNEQUIN).then_some(self.0)
    }

    /// The character with its joints.
    pub(crate) fn read(&self) -> Result<Rigged> {
        let Some(path) = self.path() else {
            return mannequin();
        };
        let shown = || path.display().to_string();
        let document = gltf::read(path)?;
        // Without a skin there is no body to be posed.
        character(&document).with_context(shown)?;
        Rigged::new(&document).with_context(shown)
    }
}

/// The person that the program makes itself, as one from a file.
fn mannequin() -> Result<Rigged> {
    let figure = Figure::new(MANNEQUIN, Human::new().into());
    Ok(Rigged::new(&at_rest(&figure)?)?)
}

/// A figure as a document, with rest as its only animation.
pub(crate) fn at_rest(figure: &Figure) -> Result<Document> {
    let rest = Pose::rest(figure.character.skeleton.len());
    let rest = Clip::new(1.0, vec![rest])?;
    let (bytes, _) = ga_character::gltf::encode(figure, &rest, &figure.name)?;
    Ok(gltf::decode(&bytes)?)
}
