//! Writing: a [`Document`] to JSON and buffers.

mod animation;
mod buffer;
mod material;
mod node;
mod primitive;

use std::path::Path;

use super::problem::{Element, Problem};
use super::{Document, ImageSource, glb, json, uri};
use crate::{FileError, FormatError};
use buffer::{Buffer, Use};

/// The files of a document in JSON.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct GltfFiles {
    /// The JSON.
    pub json: Vec<u8>,
    /// The names and contents of the other files: of the buffer, if there is any, and of images.
    pub others: Vec<(String, Vec<u8>)>,
}

/// The bytes of a GLB file of the document. Images whose bytes are in the document are in the file;
/// those named by a URI stay files of their own, which this does not write.
///
/// Numbers are written in single precision as they are, so that [`decode`](super::decode) returns
/// the same vertices, weights and keys. Lists that are equal are written once. What the Khronos
/// validator reports of such a file is in the document; [`Document::conformed`] mends most of it.
///
/// # Errors
///
/// As [`Document::validate`]; [`Problem::TooLarge`] past 4 GiB.
pub fn encode(document: &Document) -> Result<Vec<u8>, FormatError> {
    document.validate()?;
    let mut writer = Writer::new(document);
    for image in &document.images {
        let source = match &image.source {
            ImageSource::Uri(uri) => ImageJson::Uri(uri.clone()),
            ImageSource::Bytes { bytes, .. } => ImageJson::View(writer.buffer.blob(bytes)),
        };
        writer.image(image, source);
    }
    let (text, bytes) = writer.finish(None)?;
    glb::join(text, &bytes)
}

/// The files of a document in JSON with a binary buffer: `name.bin` and, for each image whose bytes
/// are in the document, `name_0.png` or the like, numbered as the images.
///
/// # Errors
///
/// As [`Document::validate`].
pub fn encode_files(document: &Document, name: &str) -> Result<GltfFiles, FormatError> {
    document.validate()?;
    let mut writer = Writer::new(document);
    let mut others = Vec::new();
    for (index, image) in document.images.iter().enumerate() {
        let source = match &image.source {
            ImageSource::Uri(uri) => uri.clone(),
            ImageSource::Bytes { media_type, bytes } => {
                let extension = match media_type.as_str() {
                    "image/jpeg" => "jpg",
                    "image/webp" => "webp",
                    _ => "png",
                };
                let file = format!("{name}_{index}.{extension}");
                let uri = uri::of_file(&file);
                others.push((file, bytes.clone()));
                uri
            }
        };
        writer.image(image, ImageJson::Uri(source));
    }
    let file = format!("{name}.bin");
    let (json, bytes) = writer.finish(Some(uri::of_file(&file)))?;
    if !bytes.is_empty() {
        others.insert(0, (file, bytes));
    }
    Ok(GltfFiles { json, others })
}

/// Writes a document to a file: JSON with other files beside it where the name ends in `.gltf`, see
/// [`encode_files`], else GLB. All files are written, or none.
///
/// # Errors
///
/// [`FileError`].
pub fn write(path: impl AsRef<Path>, document: &Document) -> Result<(), FileError> {
    let path = path.as_ref();
    let files = document_files(path, document)?;
    if let [(_, contents)] = &files[..] {
        return Ok(ga_files::write(path, contents)?);
    }
    let here = Path::new(".");
    let folder = super::reader::folder_of(path);
    let folder = if folder.as_os_str().is_empty() {
        here
    } else {
        &folder
    };
    let files = files.iter().rev();
    let files = files.map(|(name, contents)| (name.as_str(), &contents[..]));
    Ok(ga_files::write_all(folder, files)?)
}

/// The names and contents of the files that [`write`] writes, that of the path first.
///
/// # Errors
///
/// [`FileError::Contents`], as [`Document::validate`] gives.
pub fn document_files(
    path: &Path,
    document: &Document,
) -> Result<Vec<(String, Vec<u8>)>, FileError> {
    let fault = |problem| FileError::Contents {
        path: path.to_path_buf(),
        problem,
    };
    let is_json = path
        .extension()
        .is_some_and(|extension| extension.eq_ignore_ascii_case("gltf"));
    let stem = path.file_stem().and_then(|stem| stem.to_str());
    let name = path.file_name().unwrap_or_default().to_string_lossy();
    let (true, Some(stem)) = (is_json, stem) else {
        let contents = encode(document).map_err(fault)?;
        return Ok(vec![(name.into_owned(), contents)]);
    };
    let GltfFiles { json, others } = encode_files(document, stem).map_err(fault)?;
    let mut files = vec![(name.into_owned(), json)];
    files.extend(others);
    Ok(files)
}

/// Where the JSON says that an image is.
enum ImageJson {
    Uri(String),
    View(usize),
}

/// A document on its way to a file.
struct Writer<'a> {
    document: &'a Document,
    buffer: Buffer,
    images: Vec<json::Image>,
}

impl<'a> Writer<'a> {
    fn new(document: &'a Document) -> Self {
        Self {
            document,
            buffer: Buffer::default(),
            images: Vec::new(),
        }
    }

    fn image(&mut self, image: &super::Image, source: ImageJson) {
        let (uri, buffer_view) = match source {
            ImageJson::Uri(uri) => (Some(uri), None),
            ImageJson::View(view) => (None, Some(view)),
        };
        let media_type = match &image.source {
            ImageSource::Bytes { media_type, .. } => Some(media_type.clone()),
            ImageSource::Uri(_) => None,
        };
        self.images.push(json::Image {
            name: image.name.clone(),
            uri,
            mime_type: media_type,
            buffer_view,
            extras: image.extras.clone(),
        });
    }

    /// The JSON, and the bytes of the buffer, which is the file of this URI, if any.
    fn finish(mut self, uri: Option<String>) -> Result<(Vec<u8>, Vec<u8>), FormatError> {
        let document = self.document;
        let buffer = &mut self.buffer;
        let meshes = document
            .meshes
            .iter()
            .map(|mesh| primitive::mesh(mesh, buffer));
        let meshes = meshes.collect();
        let skins = document.skins.iter().map(|skin| json::Skin {
            name: skin.name.clone(),
            joints: skin.joints.clone(),
            inverse_bind_matrices: match &skin.inverse_bind_matrices[..] {
                [] => None,
                matrices => Some(buffer.floats(matrices, Use::Other)),
            },
            skeleton: skin.skeleton,
            extras: skin.extras.clone(),
        });
        let skins = skins.collect();
        let animations = document.animations.iter();
        // An animation must have a channel.
        let animations = animations.filter(|animation| !animation.channels.is_empty());
        let animations = animations.map(|animation| animation::animation(animation, buffer));
        let animations = animations.collect();
        let buffers = if buffer.bytes.is_empty() {
            Vec::new()
        } else {
            vec![json::Buffer {
                byte_length: buffer.bytes.len() as u64,
                uri,
            }]
        };
        let root = json::Root {
            asset: node::asset(&document.asset),
            extensions_used: material::extensions(document),
            extensions_required: Vec::new(),
            scene: document.scene,
            scenes: document.scenes.iter().map(node::scene).collect(),
            nodes: document.nodes.iter().map(node::node).collect(),
            meshes,
            skins,
            animations,
            materials: document.materials.iter().map(material::material).collect(),
            textures: document.textures.iter().map(material::texture).collect(),
            samplers: document.samplers.iter().map(material::sampler).collect(),
            images: self.images,
            cameras: document.cameras.iter().map(node::camera).collect(),
            accessors: self.buffer.accessors,
            buffer_views: self.buffer.views,
            buffers,
            extras: document.extras.clone(),
        };
        let text = serde_json::to_vec(&root)
            .map_err(|error| FormatError::gltf(Element::Json, Problem::Json(error.to_string())))?;
        Ok((text, self.buffer.bytes))
    }
}
