//! What a mesh cannot hold of a document.

use serde_json::Value;

use super::super::json::{DRACO, MESHOPT};
use super::super::{Document, Primitive, SUPPORTED_EXTENSIONS};
use crate::Omission;

/// The extension of lights.
const LIGHTS: &str = "KHR_lights_punctual";

impl Document {
    /// What a [`Mesh`](crate::Mesh) of the document lacks, kind by kind: all that
    /// [`to_mesh`](Self::to_mesh) does not take over.
    ///
    /// # Examples
    ///
    /// ```
    /// use ga_mesh::gltf::{Document, Node, Skin};
    ///
    /// let document = Document {
    ///     nodes: vec![Node::default()],
    ///     skins: vec![Skin { joints: vec![0], ..Skin::default() }],
    ///     ..Document::default()
    /// };
    /// assert_eq!(document.omissions()[0].to_string(), "1 skin is left out");
    /// ```
    #[must_use]
    pub fn omissions(&self) -> Vec<Omission> {
        let primitives = || self.meshes.iter().flat_map(|mesh| &mesh.primitives);
        let of_meshes = |count: fn(&Primitive) -> usize| {
            // The primitives of a mesh have the same kinds of things in common.
            let most = |mesh: &super::super::Mesh| mesh.primitives.iter().map(count).max();
            self.meshes.iter().filter_map(most).sum()
        };
        let more = |sets: usize| sets.saturating_sub(1);
        let mut custom: Vec<&str> = primitives()
            .flat_map(|primitive| &primitive.custom)
            .map(|attribute| attribute.name.as_str())
            .collect();
        custom.sort_unstable();
        custom.dedup();
        let extensions = self.unknown_extensions();
        let omissions = [
            Omission::new("skins", "skin", self.skins.len()),
            Omission::new("animations", "animation", self.animations.len()),
            Omission::new(
                "morph targets",
                "morph target",
                of_meshes(|primitive| primitive.targets.len()),
            ),
            Omission::new("cameras", "camera", self.cameras.len()),
            Omission::new("lights", "light", self.light_count()),
            Omission::new("further scenes", "further scene", more(self.scenes.len())),
            Omission::new(
                "nodes below others in the hierarchy",
                "node below another in the hierarchy",
                self.nodes.iter().map(|node| node.children.len()).sum(),
            ),
            Omission::new(
                "further sets of vertex colours",
                "further set of vertex colours",
                of_meshes(|primitive| primitive.colours.len().saturating_sub(1)),
            ),
            named("custom attributes", "custom attribute", custom),
            Omission::new("extras", "extra", self.extras_count()),
            named("extensions", "extension", extensions),
        ];
        omissions.into_iter().flatten().collect()
    }

    /// How many lights the file has that the document was read from.
    fn light_count(&self) -> usize {
        let lights = self.origin.file().and_then(|file| {
            let extension = file.json.get("extensions")?.get(LIGHTS)?;
            extension.get("lights").and_then(Value::as_array)
        });
        lights.map_or(0, Vec::len)
    }

    /// The extensions of that file which a document does not know.
    fn unknown_extensions(&self) -> Vec<&str> {
        let file = self.origin.file().into_iter();
        let names = file.flat_map(|file| &file.root.extensions_used);
        let is_known = |name: &str| {
            SUPPORTED_EXTENSIONS.contains(&name)
                || MESHOPT.contains(&name)
                || [DRACO, LIGHTS].contains(&name)
        };
        names
            .map(String::as_str)
            .filter(|name| !is_known(name))
            .collect()
    }

    /// How many elements have data of an application.
    fn extras_count(&self) -> usize {
        let of_meshes = self.meshes.iter().flat_map(|mesh| {
            let primitives = mesh.primitives.iter().map(|primitive| &primitive.extras);
            primitives.chain([&mesh.extras])
        });
        let of_animations = self.animations.iter().flat_map(|animation| {
            let channels = animation.channels.iter().map(|channel| &channel.extras);
            channels.chain([&animation.extras])
        });
        let all = [&self.extras, &self.asset.extras].into_iter();
        all.chain(self.scenes.iter().map(|scene| &scene.extras))
            .chain(self.nodes.iter().map(|node| &node.extras))
            .chain(of_meshes)
            .chain(self.skins.iter().map(|skin| &skin.extras))
            .chain(of_animations)
            .chain(self.materials.iter().map(|material| &material.extras))
            .chain(self.textures.iter().map(|texture| &texture.extras))
            .chain(self.samplers.iter().map(|sampler| &sampler.extras))
            .chain(self.images.iter().map(|image| &image.extras))
            .chain(self.cameras.iter().map(|camera| &camera.extras))
            .filter(|extras| extras.is_some())
            .count()
    }
}

/// Things that are left out, with their names.
fn named(what: &'static str, one: &'static str, names: Vec<&str>) -> Option<Omission> {
    let omission = Omission::new(what, one, names.len())?;
    let names = names.into_iter().map(str::to_owned).collect();
    Some(Omission { names, ..omission })
}
