//! The JSON of a document and its buffer.

use serde_json::{Map, Value};

use super::super::{Document, ImageSource, json};
use super::buffer::{Buffer, Use};
use super::kept::{self, Kept, list, not_json, value, with_extensions};
use super::references::compressed;
use super::{animation, material, node, primitive, unused};
use crate::FormatError;

/// Where an image is to be whose bytes are in the document. Others keep their URIs.
pub(super) enum ImagePlace {
    InBuffer,
    /// In a file of this URI.
    File(String),
}

/// What the JSON has that a document knows.
const KNOWN: [&str; 18] = [
    "accessors",
    "animations",
    "asset",
    "bufferViews",
    "buffers",
    "cameras",
    "extensionsRequired",
    "extensionsUsed",
    "extras",
    "images",
    "materials",
    "meshes",
    "nodes",
    "samplers",
    "scene",
    "scenes",
    "skins",
    "textures",
];

/// A document on its way to a file.
pub(super) struct Writer<'a> {
    document: &'a Document,
    kept: Option<Kept<'a>>,
    buffer: Buffer,
    /// Those of the file that the document was read from.
    old: OldBuffers,
    images: Vec<json::Image>,
    /// The images that stand as in that file.
    is_old: Vec<bool>,
}

/// The buffers of a file as one, and what describes them.
#[derive(Default)]
struct OldBuffers {
    views: Vec<Value>,
    accessors: Vec<Value>,
    /// The first buffer, and those without bytes.
    buffers: Vec<Value>,
}

impl<'a> Writer<'a> {
    pub(super) fn new(document: &'a Document) -> Result<Self, FormatError> {
        let kept = Kept::new(document)?;
        let (old, bytes) = kept.as_ref().map(joined).unwrap_or_default();
        Ok(Self {
            buffer: Buffer::after(bytes, old.views.len(), old.accessors.len()),
            document,
            kept,
            old,
            images: Vec::new(),
            is_old: Vec::new(),
        })
    }

    /// Adds an image of the document; all must be added in their order.
    pub(super) fn image(&mut self, index: usize, place: ImagePlace) {
        let image = &self.document.images[index];
        let old = self.kept.as_ref().and_then(|kept| {
            let is_same = kept.before.images.get(index) == Some(image);
            kept.file.root.images.get(index).filter(|_| is_same)
        });
        let (uri, media_type, is_old) = match (&image.source, place) {
            (ImageSource::Uri(uri), _) => (Some(uri.clone()), None, old.is_some()),
            (ImageSource::Bytes { media_type, .. }, ImagePlace::File(uri)) => {
                (Some(uri), Some(media_type.clone()), false)
            }
            (ImageSource::Bytes { media_type, .. }, ImagePlace::InBuffer) => {
                let is_old = old.is_some_and(|old| old.buffer_view.is_some());
                (None, Some(media_type.clone()), is_old)
            }
        };
        let buffer_view = match (&image.source, &uri) {
            (ImageSource::Bytes { bytes, .. }, None) if !is_old => Some(self.buffer.blob(bytes)),
            _ => None,
        };
        self.is_old.push(is_old);
        self.images.push(json::Image {
            name: image.name.clone(),
            uri,
            mime_type: media_type,
            buffer_view,
            extras: image.extras.clone(),
        });
    }

    /// The JSON, and the bytes of the buffer, which is the file of this URI, if any.
    pub(super) fn finish(mut self, uri: Option<String>) -> Result<(Vec<u8>, Vec<u8>), FormatError> {
        let (document, kept) = (self.document, self.kept.as_ref());
        let mut root = kept.map(|kept| kept.others(&KNOWN)).unwrap_or_default();
        root.insert("asset".to_owned(), self.asset()?);
        for (name, elements) in self.elements()? {
            insert(&mut root, name, elements);
        }
        for (name, of_file, own) in self.extensions() {
            let names = of_file.into_iter().chain(own).map(Value::String);
            insert(&mut root, name, names.collect());
        }
        if let Some(scene) = document.scene {
            root.insert("scene".to_owned(), scene.into());
        }
        if let Some(extras) = &document.extras {
            root.insert("extras".to_owned(), extras.clone());
        }
        for accessor in &self.buffer.accessors {
            self.old.accessors.push(value(accessor)?);
        }
        for view in &self.buffer.views {
            self.old.views.push(value(view)?);
        }
        insert(&mut root, "accessors", self.old.accessors);
        insert(&mut root, "bufferViews", self.old.views);
        let mut bytes = self.buffer.bytes;
        if let Some(kept) = &self.kept {
            unused::remove(&mut root, &mut bytes, &kept.file.json);
        }
        let mut buffers = self.old.buffers.into_iter();
        let first = buffers.next();
        if !bytes.is_empty() || first.is_some() {
            let new = value(&json::Buffer {
                byte_length: bytes.len() as u64,
                uri,
                extensions: json::BufferExtensions::default(),
            })?;
            let first = first.map_or_else(|| new.clone(), |old| with_properties(&new, old));
            let all = std::iter::once(first).filter(|_| !bytes.is_empty());
            insert(&mut root, "buffers", all.chain(buffers).collect());
        }
        let text = serde_json::to_vec(&root).map_err(not_json)?;
        Ok((text, bytes))
    }

    fn asset(&self) -> Result<Value, FormatError> {
        let asset = || value(&node::asset(&self.document.asset));
        let old = self.kept.as_ref().and_then(|kept| {
            let is_same = kept.before.asset == self.document.asset;
            Some((kept.file.json.get("asset")?, is_same))
        });
        Ok(match old {
            Some((old, true)) => old.clone(),
            Some((old, false)) => with_extensions(asset()?, old),
            None => asset()?,
        })
    }

    /// All lists but those of the buffer.
    fn elements(&mut self) -> Result<[(&'static str, Vec<Value>); 10], FormatError> {
        let (document, kept) = (self.document, self.kept.as_ref());
        let buffer = &mut self.buffer;
        let meshes = list(
            kept,
            "meshes",
            &document.meshes,
            |d| &d.meshes,
            |index, mesh| primitive::mesh(index, mesh, kept, buffer),
        )?;
        let skins = list(
            kept,
            "skins",
            &document.skins,
            |d| &d.skins,
            |_, skin| {
                value(&json::Skin {
                    name: skin.name.clone(),
                    joints: skin.joints.clone(),
                    inverse_bind_matrices: match &skin.inverse_bind_matrices[..] {
                        [] => None,
                        matrices => Some(buffer.floats(matrices, Use::Other)),
                    },
                    skeleton: skin.skeleton,
                    extras: skin.extras.clone(),
                })
            },
        )?;
        let mut animations = kept::animations(kept, &document.animations, |motion| {
            value(&animation::animation(motion, buffer))
        })?;
        // An animation must have a channel.
        animations.retain(|it| it.get("channels") != Some(&Value::Array(Vec::new())));
        let mut images = Vec::with_capacity(self.images.len());
        for (index, (image, &is_old)) in self.images.iter().zip(&self.is_old).enumerate() {
            let old = kept.and_then(|kept| kept.file.element("images", index));
            images.push(match old {
                Some(old) if is_old => old.clone(),
                Some(old) => with_extensions(value(image)?, old),
                None => value(image)?,
            });
        }
        let (nodes, scenes) = (&document.nodes, &document.scenes);
        let (materials, textures) = (&document.materials, &document.textures);
        let (samplers, cameras) = (&document.samplers, &document.cameras);
        Ok([
            ("meshes", meshes),
            ("skins", skins),
            ("animations", animations),
            ("images", images),
            (
                "scenes",
                list(
                    kept,
                    "scenes",
                    scenes,
                    |d| &d.scenes,
                    |_, it| value(&node::scene(it)),
                )?,
            ),
            (
                "nodes",
                list(
                    kept,
                    "nodes",
                    nodes,
                    |d| &d.nodes,
                    |_, it| value(&node::node(it)),
                )?,
            ),
            (
                "materials",
                list(
                    kept,
                    "materials",
                    materials,
                    |d| &d.materials,
                    |_, it| value(&material::material(it)),
                )?,
            ),
            (
                "textures",
                list(
                    kept,
                    "textures",
                    textures,
                    |d| &d.textures,
                    |_, it| value(&material::texture(it)),
                )?,
            ),
            (
                "samplers",
                list(
                    kept,
                    "samplers",
                    samplers,
                    |d| &d.samplers,
                    |_, it| value(&material::sampler(it)),
                )?,
            ),
            (
                "cameras",
                list(
                    kept,
                    "cameras",
                    cameras,
                    |d| &d.cameras,
                    |_, it| value(&node::camera(it)),
                )?,
            ),
        ])
    }

    /// The names of the extensions that are used and required: those of the file, and new ones.
    fn extensions(&self) -> [(&'static str, Vec<String>, Vec<String>); 2] {
        let root = self.kept.as_ref().map(|kept| &kept.file.root);
        let of =
            |list: fn(&json::Root) -> &Vec<String>| root.map(list).cloned().unwrap_or_default();
        let used = of(|root| &root.extensions_used);
        let mut own = material::extensions(self.document);
        own.retain(|name| !used.contains(name));
        [
            ("extensionsUsed", used, own),
            (
                "extensionsRequired",
                of(|root| &root.extensions_required),
                Vec::new(),
            ),
        ]
    }
}

/// Lists are left out where they are empty.
fn insert(root: &mut Map<String, Value>, name: &str, list: Vec<Value>) {
    if !list.is_empty() {
        root.insert(name.to_owned(), Value::Array(list));
    }
}

/// An element with the properties of a new one.
fn with_properties(new: &Value, mut old: Value) -> Value {
    if let (Some(old), Some(new)) = (old.as_object_mut(), new.as_object()) {
        old.extend(new.iter().map(|(key, value)| (key.clone(), value.clone())));
    }
    old
}

/// The buffers of a file joined to one, with their views, and the bytes of that one. Buffers
/// without bytes stay behind it: those for which compressed ones stand.
fn joined(kept: &Kept) -> (OldBuffers, Vec<u8>) {
    let list = |name: &str| {
        let list = kept.file.json.get(name).and_then(Value::as_array);
        list.cloned().unwrap_or_default()
    };
    let (mut first, mut others, mut bytes) = (None, Vec::new(), Vec::new());
    // For each buffer its new number, and where it begins.
    let mut places = Vec::new();
    for (contents, described) in kept.file.buffers.iter().zip(list("buffers")) {
        match contents {
            Some(contents) => {
                bytes.resize(usize::next_multiple_of(bytes.len(), 4), 0);
                places.push((0, bytes.len() as u64));
                bytes.extend_from_slice(contents);
                first = first.or(Some(described));
            }
            None => {
                others.push(described);
                places.push((others.len(), 0));
            }
        }
    }
    if !places.is_empty() && bytes.is_empty() {
        // A buffer has at least one byte.
        bytes.resize(4, 0);
    }
    let first = first.unwrap_or_else(|| Value::Object(Map::new()));
    let buffers = std::iter::once(first).chain(others);
    let mut views = list("bufferViews");
    for view in &mut views {
        relocate(view, &places);
        for part in compressed(view) {
            relocate(part, &places);
        }
    }
    let old = OldBuffers {
        views,
        accessors: list("accessors"),
        buffers: buffers.filter(|_| !places.is_empty()).collect(),
    };
    (old, bytes)
}

/// Moves a part of a buffer to where that buffer is now.
fn relocate(part: &mut Value, places: &[(usize, u64)]) {
    let place = part.get("buffer").and_then(Value::as_u64);
    let Some(&(buffer, start)) = place.and_then(|buffer| places.get(buffer as usize)) else {
        return;
    };
    let offset = part.get("byteOffset").and_then(Value::as_u64).unwrap_or(0);
    part["buffer"] = buffer.into();
    if offset + start > 0 {
        part["byteOffset"] = (offset + start).into();
    }
}
