//! glTF 2.0: scenes with meshes, materials, skins, animations and morph targets.
//!
//! A [`Document`] holds what a `.gltf` or `.glb` file holds, as plain data: lists of numbers in
//! single precision in place of accessors and buffers, and references by index. [`read`] and
//! [`write`](write()) take either form of file, [`decode`] and [`encode`] bytes in memory.
//!
//! | what | types |
//! | --- | --- |
//! | the tree | [`Document`], [`Scene`], [`Node`], [`Transform`], [`CameraElement`], [`Origin`] |
//! | geometry | [`Mesh`], [`Primitive`], [`MorphTarget`], [`CustomAttribute`] |
//! | motion | [`Skin`], [`Animation`], [`Channel`], [`Keys`] |
//! | appearance | [`MaterialElement`], [`TextureElement`], [`Sampler`], [`Image`] |
//! | one skinned mesh | [`model`] |
//! | a [`Mesh`](crate::Mesh) | [`read_mesh`], [`write_mesh`], [`Document::to_mesh`] |
//!
//! glTF is right-handed with *y* up and metres; angles are radians. Texture coordinates have v
//! *down*, so that (0, 0) is the upper left corner of the image.
//!
//! The source is the *glTF 2.0 Specification* of the Khronos Group (ISO/IEC 12113:2022).
//!
//! ```
//! use ga_mesh::FormatError;
//! use ga_mesh::gltf::{self, Problem};
//!
//! let file = br#"{"asset": {"version": "2.0"}, "nodes": [{"children": [1]}, {"children": [0]}]}"#;
//! let error = gltf::decode(file).unwrap_err();
//! assert!(matches!(&error, FormatError::Gltf { problem: Problem::Cycle, .. }));
//! assert_eq!(error.to_string(), "node 0: is an ancestor of itself");
//! ```

mod animation;
mod codes;
mod conform;
mod convert;
mod document;
mod extras;
mod glb;
mod hierarchy;
mod json;
mod material;
mod mesh;
pub mod model;
mod origin;
mod problem;
mod reader;
mod uri;
mod validate;
mod writer;

pub use animation::{Animation, Channel, Interpolation, Keys, Skin};
pub(crate) use convert::mesh_files;
pub use convert::{Placed, Target, Vertices, read_mesh, write_mesh};
pub use document::{Asset, CameraElement, Document, Node, Projection, Scene, Transform};
pub use extras::Extras;
pub use material::{
    Image, ImageSource, MaterialElement, Sampler, TextureElement, TextureInfo, TextureTransform,
};
pub use mesh::{Components, CustomAttribute, Mesh, Mode, MorphTarget, Primitive, Shape};
pub use origin::Origin;
pub use problem::{Element, Problem};
pub use reader::{SUPPORTED_EXTENSIONS, decode, read};
pub use writer::{GltfFiles, encode, encode_files, path_files, write};
