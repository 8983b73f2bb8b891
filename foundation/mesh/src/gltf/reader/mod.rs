//! Reading: JSON and buffers to a [`Document`].

mod accessor;
mod animation;
mod buffer;
mod draco;
mod file;
mod image;
mod layout;
mod material;
mod node;
mod primitive;

use std::io;
use std::path::{Path, PathBuf};

use ga_files::{ReadError, text};
use serde_json::{Map, Value};

use super::origin::{File, Origin};
use super::problem::{Element, Problem};
use super::uri::{self, Uri};
use super::{Asset, Document, ImageSource, Mesh, Skin, glb, json};
use crate::FormatError;
use accessor::{Accessors, Format};
use buffer::{Buffers, Files};
use file::read_file;

/// The extensions that a file may require.
pub const SUPPORTED_EXTENSIONS: [&str; 5] = [
    json::DRACO,
    "KHR_materials_emissive_strength",
    "KHR_materials_unlit",
    QUANTIZATION,
    "KHR_texture_transform",
];

const QUANTIZATION: &str = "KHR_mesh_quantization";

/// Reads a `.glb` or `.gltf` file and the files of its buffers. Its first bytes decide which it is,
/// not its name. Files of images are not opened; see [`Document::read_images`].
///
/// # Errors
///
/// [`ReadError::Io`] when the file cannot be read, else [`ReadError::Contents`] with what
/// [`decode`] reports, and [`Problem::Io`] for a buffer whose file cannot be read.
pub fn read(path: impl AsRef<Path>) -> Result<Document, ReadError<FormatError>> {
    let path = path.as_ref();
    let folder = folder_of(path);
    ga_files::read(path, |file| {
        document(file, &mut |path, length| {
            read_file(&folder.join(path), length)
        })
    })
}

/// A document from the bytes of a GLB file, or of a glTF file whose buffers are data in URIs.
///
/// Integers that stand for fractions become numbers in single precision, sparse accessors full
/// lists, colours without alpha opaque. Extensions other than [`SUPPORTED_EXTENSIONS`] are left
/// out, and so are channels of animations without a node, as the specification advises; the
/// [`Origin`] of the document keeps them for a writer.
///
/// # Errors
///
/// [`FormatError`] names the faulty element: bytes that are cut off, JSON of another form, a
/// required extension that is not supported, an accessor beyond its buffer, and whatever
/// [`Document::validate`] reports. A document may take up 64 MiB and 64 bytes for each byte of the
/// file; past that the error is [`Problem::TooLarge`].
pub fn decode(file: &[u8]) -> Result<Document, FormatError> {
    document(file, &mut |path, _| {
        let (path, kind) = (path.to_path_buf(), io::ErrorKind::Unsupported);
        Err(Problem::Io { path, kind })
    })
}

impl Document {
    /// Reads the files of images that are named by a URI, relative to a folder, and puts their
    /// bytes in the document.
    ///
    /// # Errors
    ///
    /// [`Problem::Io`] for the first image whose file cannot be read; images before it are loaded.
    pub fn read_images(&mut self, folder: impl AsRef<Path>) -> Result<(), FormatError> {
        for (index, image) in self.images.iter_mut().enumerate() {
            if let ImageSource::Uri(uri) = &image.source {
                image.source = image::load(uri, folder.as_ref())
                    .map_err(|problem| FormatError::gltf(Element::Image(index), problem))?;
            }
        }
        Ok(())
    }
}

/// The folder that contains a file.
pub(super) fn folder_of(path: &Path) -> PathBuf {
    path.parent().unwrap_or(Path::new("")).to_path_buf()
}

fn document(file: &[u8], files: &mut Files) -> Result<Document, FormatError> {
    let (text, binary) = if glb::is_glb(file) {
        glb::split(file)?
    } else {
        (file, None)
    };
    // Some programs begin text with a byte order mark, and fill chunks with zeros.
    let text = text::without_mark(text);
    let last = text.iter().rposition(|&byte| byte != 0);
    let text = &text[..last.map_or(0, |last| last + 1)];
    let root: json::Root = serde_json::from_slice(text).map_err(not_json)?;
    check_version(&root.asset)?;
    let unknown = |name: &&String| !SUPPORTED_EXTENSIONS.contains(&name.as_str());
    if let Some(name) = root.extensions_required.iter().find(unknown) {
        let problem = Problem::UnknownExtension(name.clone());
        return Err(FormatError::gltf(Element::File, problem));
    }
    let buffers = Buffers::load(&root, binary, files)?;
    let mut document = elements(&root, &buffers, file.len())?;
    document.validate()?;
    document.origin = origin(root, text, buffers, file.len())?;
    Ok(document)
}

/// The file as it was read.
fn origin(
    mut root: json::Root,
    text: &[u8],
    buffers: Buffers,
    size: usize,
) -> Result<Origin, FormatError> {
    let mut json: Map<String, Value> = serde_json::from_slice(text).map_err(not_json)?;
    // Their bytes are kept, which may be in the URIs.
    let list = json.get_mut("buffers").and_then(Value::as_array_mut);
    for buffer in list.into_iter().flatten().filter_map(Value::as_object_mut) {
        buffer.remove("uri");
    }
    let uris = root.buffers.iter_mut().filter_map(|it| it.uri.take());
    let parts = uris.filter_map(|uri| match uri::parse(&uri) {
        Some(Uri::File(path)) => Some(path),
        _ => None,
    });
    let parts = parts.collect();
    Ok(Origin::new(File {
        root,
        json,
        buffers: buffers.into_bytes(),
        size,
        parts,
    }))
}

/// The document of a file that was read before.
pub(super) fn document_of(file: &File) -> Result<Document, FormatError> {
    elements(&file.root, &Buffers::of(&file.buffers), file.size)
}

fn not_json(error: serde_json::Error) -> FormatError {
    FormatError::gltf(Element::Json, Problem::Json(error.to_string()))
}

/// A file may state the least version that a reader must know, beside its own.
fn check_version(asset: &json::Asset) -> Result<(), FormatError> {
    let (version, is_known) = match &asset.min_version {
        Some(minimum) => (minimum, minimum == "2.0"),
        None => (&asset.version, asset.version.split('.').next() == Some("2")),
    };
    if is_known {
        return Ok(());
    }
    let problem = Problem::Version(version.clone());
    Err(FormatError::gltf(Element::File, problem))
}

fn elements(root: &json::Root, buffers: &Buffers, size: usize) -> Result<Document, FormatError> {
    let accessors = &Accessors::new(root, buffers, size)?;
    let is_quantized = root.extensions_used.iter().any(|name| name == QUANTIZATION);
    Ok(Document {
        asset: Asset {
            generator: root.asset.generator.clone(),
            copyright: root.asset.copyright.clone(),
            extras: root.asset.extras.clone(),
        },
        scene: root.scene,
        scenes: root.scenes.iter().map(node::scene).collect(),
        nodes: numbered(&root.nodes, node::node)?,
        meshes: numbered(&root.meshes, |index, mesh| {
            Ok(Mesh {
                name: mesh.name.clone(),
                primitives: numbered(&mesh.primitives, |primitive, json| {
                    let reader = primitive::Reader {
                        accessors,
                        is_quantized,
                        mesh: index,
                        primitive,
                    };
                    reader.primitive(json)
                })?,
                weights: mesh.weights.clone(),
                extras: mesh.extras.clone(),
            })
        })?,
        skins: numbered(&root.skins, |index, json| skin(index, json, accessors))?,
        animations: numbered(&root.animations, |index, json| {
            animation::animation(index, json, accessors)
        })?,
        materials: numbered(&root.materials, material::material)?,
        textures: root.textures.iter().map(material::texture).collect(),
        samplers: numbered(&root.samplers, material::sampler)?,
        images: numbered(&root.images, |index, json| {
            image::image(index, json, root, buffers, accessors)
        })?,
        cameras: numbered(&root.cameras, node::camera)?,
        extras: root.extras.clone(),
        origin: Origin::default(),
    })
}

fn numbered<T, U>(
    items: &[T],
    convert: impl Fn(usize, &T) -> Result<U, FormatError>,
) -> Result<Vec<U>, FormatError> {
    let items = items.iter().enumerate();
    items.map(|(index, item)| convert(index, item)).collect()
}

fn skin(index: usize, json: &json::Skin, accessors: &Accessors) -> Result<Skin, FormatError> {
    let mut matrices = match json.inverse_bind_matrices {
        Some(accessor) => accessors
            .floats(accessor, super::Shape::Mat4, Format::Float)
            .map_err(|error| error.within(Element::Skin(index)))?,
        None => Vec::new(),
    };
    // There may be more than there are joints.
    matrices.truncate(json.joints.len());
    Ok(Skin {
        name: json.name.clone(),
        joints: json.joints.clone(),
        inverse_bind_matrices: matrices,
        skeleton: json.skeleton,
        extras: json.extras.clone(),
    })
}
