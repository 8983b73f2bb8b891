//! What is wrong with a glTF file or document, and where.

use std::fmt;
use std::path::PathBuf;

use super::json::MESHOPT;
use crate::MeshError;

/// An element of a glTF file.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Element {
    /// The file as a whole.
    File,
    /// The JSON text.
    Json,
    /// A chunk of a GLB file.
    Chunk(usize),
    /// A buffer.
    Buffer(usize),
    /// A part of a buffer.
    BufferView(usize),
    /// An accessor, which describes numbers in a part of a buffer.
    Accessor(usize),
    /// A mesh.
    Mesh(usize),
    /// A primitive of a mesh.
    Primitive {
        /// The mesh.
        mesh: usize,
        /// The primitive.
        primitive: usize,
    },
    /// The indices of a primitive.
    Indices {
        /// The mesh.
        mesh: usize,
        /// The primitive.
        primitive: usize,
    },
    /// An attribute of the vertices of a primitive.
    Attribute {
        /// The mesh.
        mesh: usize,
        /// The primitive.
        primitive: usize,
        /// The morph target whose attribute it is, if it is not an attribute of the primitive
        /// itself.
        target: Option<usize>,
        /// The name of the attribute, as `NORMAL`.
        name: String,
    },
    /// A node.
    Node(usize),
    /// A scene.
    Scene(usize),
    /// A skin.
    Skin(usize),
    /// An animation.
    Animation(usize),
    /// A channel of an animation.
    Channel {
        /// The animation.
        animation: usize,
        /// The channel.
        channel: usize,
    },
    /// A material.
    Material(usize),
    /// A texture.
    Texture(usize),
    /// A sampler of textures.
    Sampler(usize),
    /// An image.
    Image(usize),
    /// A camera.
    Camera(usize),
}

/// What is wrong with an element of a glTF file.
#[derive(Clone, Debug, PartialEq)]
pub enum Problem {
    /// The file is of another version of glTF than 2.
    Version(String),
    /// The text is not JSON, or not of the form that glTF prescribes.
    Json(String),
    /// A chunk is of the wrong kind.
    ChunkKind([u8; 4]),
    /// The file requires an extension that this crate does not know.
    UnknownExtension(String),
    /// The geometry that a primitive has by `KHR_draco_mesh_compression` cannot be decompressed.
    Draco(String),
    /// There are fewer bytes than the element needs.
    TooShort {
        /// How many bytes it needs.
        needed: u64,
        /// How many there are.
        found: u64,
    },
    /// The element needs more memory than a file of this size justifies, or more bytes than the
    /// format can number.
    TooLarge {
        /// How many bytes it needs.
        needed: u64,
        /// How many are allowed.
        limit: u64,
    },
    /// The element refers to another one that does not exist.
    OutOfRange {
        /// What it refers to.
        what: &'static str,
        /// The index.
        index: usize,
        /// How many there are.
        count: usize,
    },
    /// The element lacks something.
    Missing(&'static str),
    /// A property has a value that glTF does not allow.
    Value {
        /// The property.
        property: &'static str,
        /// Its value.
        value: String,
    },
    /// The numbers are not of a type that this use of an accessor allows.
    Format {
        /// The type, as `VEC3 of SHORT`.
        found: String,
        /// The types that are allowed.
        allowed: &'static str,
    },
    /// There are not as many of something as there must be.
    Count {
        /// What there is too much or too little of.
        what: &'static str,
        /// How many there must be.
        expected: usize,
        /// How many there are.
        found: usize,
    },
    /// A number is infinite or not a number.
    NotFinite {
        /// The vertex, key or other item that has the number.
        item: usize,
    },
    /// A sparse index is beyond the accessor, or does not exceed the index before it.
    SparseIndex {
        /// Its place among the sparse indices.
        position: usize,
        /// The index.
        index: u32,
        /// How many elements the accessor has.
        count: usize,
    },
    /// An index names a vertex that does not exist.
    VertexIndex {
        /// Its place among the indices.
        position: usize,
        /// The vertex that it names.
        vertex: u32,
        /// How many vertices there are.
        vertices: usize,
    },
    /// A vertex is moved by a joint that the skin does not have.
    Joint {
        /// The vertex.
        vertex: usize,
        /// The joint.
        joint: u16,
        /// How many joints the skin has.
        joints: usize,
    },
    /// The weights of a vertex are all zero, or one is negative.
    Weights {
        /// The vertex.
        vertex: usize,
        /// The sum of its weights.
        sum: f32,
    },
    /// The node is an ancestor of itself.
    Cycle,
    /// The node is a child of two nodes, or twice of one.
    TwoParents {
        /// One parent.
        first: usize,
        /// The other.
        second: usize,
    },
    /// A time is negative or not after the one before.
    Time {
        /// The key.
        key: usize,
        /// Its time in seconds.
        seconds: f32,
    },
    /// Something is there twice.
    Duplicate {
        /// What is there twice.
        what: &'static str,
        /// Its index.
        index: usize,
    },
    /// A URI that does not name a file beside this one and holds no data.
    Uri(String),
    /// The document does not form a mesh.
    Mesh(Box<MeshError>),
    /// A file that this one refers to cannot be read.
    Io {
        /// The file.
        path: PathBuf,
        /// What the operating system said.
        kind: std::io::ErrorKind,
    },
}

impl fmt::Display for Element {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        match self {
            Self::File => f.write_str("file"),
            Self::Json => f.write_str("JSON"),
            Self::Chunk(index) => write!(f, "chunk {index}"),
            Self::Buffer(index) => write!(f, "buffer {index}"),
            Self::BufferView(index) => write!(f, "buffer view {index}"),
            Self::Accessor(index) => write!(f, "accessor {index}"),
            Self::Mesh(index) => write!(f, "mesh {index}"),
            Self::Primitive { mesh, primitive } => write!(f, "mesh {mesh}, primitive {primitive}"),
            Self::Indices { mesh, primitive } => {
                write!(f, "mesh {mesh}, primitive {primitive}, indices")
            }
            Self::Attribute {
                mesh,
                primitive,
                target,
                name,
            } => {
                write!(f, "mesh {mesh}, primitive {primitive}, ")?;
                if let Some(target) = target {
                    write!(f, "morph target {target}, ")?;
                }
                write!(f, "attribute {name}")
            }
            Self::Node(index) => write!(f, "node {index}"),
            Self::Scene(index) => write!(f, "scene {index}"),
            Self::Skin(index) => write!(f, "skin {index}"),
            Self::Animation(index) => write!(f, "animation {index}"),
            Self::Channel { animation, channel } => {
                write!(f, "animation {animation}, channel {channel}")
            }
            Self::Material(index) => write!(f, "material {index}"),
            Self::Texture(index) => write!(f, "texture {index}"),
            Self::Sampler(index) => write!(f, "sampler {index}"),
            Self::Image(index) => write!(f, "image {index}"),
            Self::Camera(index) => write!(f, "camera {index}"),
        }
    }
}

impl fmt::Display for Problem {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        match self {
            Self::Version(version) => write!(f, "version {version} of glTF is not supported"),
            Self::Json(message) => f.write_str(message),
            Self::ChunkKind(kind) => {
                write!(
                    f,
                    "a chunk of kind \"{}\" is not allowed here",
                    kind.escape_ascii()
                )
            }
            Self::UnknownExtension(name) => {
                write!(f, "requires the extension {name}, which is not supported")?;
                if MESHOPT.contains(&name.as_str()) {
                    f.write_str("; `npx @gltf-transform/cli copy IN.glb OUT.glb` removes it")?;
                }
                Ok(())
            }
            Self::Draco(message) => write!(f, "cannot be decompressed: {message}"),
            Self::TooShort { needed, found } => write!(f, "needs {needed} bytes, but has {found}"),
            Self::TooLarge { needed, limit } => {
                write!(f, "needs {needed} bytes, more than the limit of {limit}")
            }
            Self::OutOfRange { what, index, count } => {
                write!(f, "refers to {what} {index}, but there are {count}")
            }
            Self::Missing(what) => write!(f, "lacks {what}"),
            Self::Value { property, value } => write!(f, "{property} cannot be {value}"),
            Self::Format { found, allowed } => write!(f, "is {found}, but must be {allowed}"),
            Self::Count {
                what,
                expected,
                found,
            } => write!(f, "has {found} {what}, not {expected}"),
            Self::NotFinite { item } => write!(f, "item {item} has a number that is not finite"),
            Self::SparseIndex {
                position,
                index,
                count,
            } => write!(
                f,
                "sparse index {position} is {index}, which is not greater than the index before \
                 it or not less than the count {count}"
            ),
            Self::VertexIndex {
                position,
                vertex,
                vertices,
            } => write!(
                f,
                "index {position} names vertex {vertex}, but there are {vertices} vertices"
            ),
            Self::Joint {
                vertex,
                joint,
                joints,
            } => write!(
                f,
                "vertex {vertex} is moved by joint {joint}, but the skin has {joints} joints"
            ),
            Self::Weights { vertex, sum } => write!(
                f,
                "the weights of vertex {vertex} are all zero, or one is negative: \
                 their sum is {sum}"
            ),
            Self::Cycle => f.write_str("is an ancestor of itself"),
            Self::TwoParents { first, second } => {
                write!(f, "is a child of node {first} and of node {second}")
            }
            Self::Time { key, seconds } => write!(
                f,
                "the time of key {key}, {seconds} s, is negative or not after the time before it"
            ),
            Self::Duplicate { what, index } => write!(f, "has {what} {index} twice"),
            Self::Uri(uri) => write!(f, "the URI {uri:?} does not name a file and holds no data"),
            Self::Mesh(error) => error.fmt(f),
            Self::Io { path, kind } => write!(f, "cannot read {}: {kind}", path.display()),
        }
    }
}
