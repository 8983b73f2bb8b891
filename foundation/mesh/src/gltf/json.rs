//! The JSON of a glTF file, as section 5 of the specification has it.
//!
//! The crate gltf-json is not used: it shortens indices to 32 bits without an error, requires
//! properties that are optional (the node of a channel), and drops attributes of morph targets
//! other than positions, normals and tangents.

use std::collections::BTreeMap;

use serde::{Deserialize, Serialize};
use serde_json::Value;

type Extras = Option<Value>;

/// Whether a property is left out because it has its default.
fn is_default<T: Default + PartialEq>(value: &T) -> bool {
    *value == T::default()
}

/// Derives what each object has in common, and leaves out each property that has its default.
macro_rules! objects {
    ($($(#[$meta:meta])* $name:ident { $($(#[$field_meta:meta])* $field:ident: $type:ty,)* })*) => {$(
        $(#[$meta])*
        #[derive(Clone, Debug, Serialize, Deserialize)]
        #[serde(rename_all = "camelCase")]
        pub(super) struct $name {
            $($(#[$field_meta])* pub(super) $field: $type,)*
        }
    )*};
}

objects! {
    #[derive(Default)]
    Root {
        asset: Asset,
        #[serde(default, skip_serializing_if = "Vec::is_empty")]
        extensions_used: Vec<String>,
        #[serde(default, skip_serializing_if = "Vec::is_empty")]
        extensions_required: Vec<String>,
        #[serde(skip_serializing_if = "Option::is_none")]
        scene: Option<usize>,
        #[serde(default, skip_serializing_if = "Vec::is_empty")]
        scenes: Vec<Scene>,
        #[serde(default, skip_serializing_if = "Vec::is_empty")]
        nodes: Vec<Node>,
        #[serde(default, skip_serializing_if = "Vec::is_empty")]
        meshes: Vec<Mesh>,
        #[serde(default, skip_serializing_if = "Vec::is_empty")]
        skins: Vec<Skin>,
        #[serde(default, skip_serializing_if = "Vec::is_empty")]
        animations: Vec<Animation>,
        #[serde(default, skip_serializing_if = "Vec::is_empty")]
        materials: Vec<Material>,
        #[serde(default, skip_serializing_if = "Vec::is_empty")]
        textures: Vec<Texture>,
        #[serde(default, skip_serializing_if = "Vec::is_empty")]
        samplers: Vec<Sampler>,
        #[serde(default, skip_serializing_if = "Vec::is_empty")]
        images: Vec<Image>,
        #[serde(default, skip_serializing_if = "Vec::is_empty")]
        cameras: Vec<Camera>,
        #[serde(default, skip_serializing_if = "Vec::is_empty")]
        accessors: Vec<Accessor>,
        #[serde(default, skip_serializing_if = "Vec::is_empty")]
        buffer_views: Vec<BufferView>,
        #[serde(default, skip_serializing_if = "Vec::is_empty")]
        buffers: Vec<Buffer>,
        #[serde(skip_serializing_if = "Option::is_none")]
        extras: Extras,
    }

    #[derive(Default)]
    Asset {
        version: String,
        #[serde(skip_serializing_if = "Option::is_none")]
        min_version: Option<String>,
        #[serde(skip_serializing_if = "Option::is_none")]
        generator: Option<String>,
        #[serde(skip_serializing_if = "Option::is_none")]
        copyright: Option<String>,
        #[serde(skip_serializing_if = "Option::is_none")]
        extras: Extras,
    }

    Scene {
        #[serde(skip_serializing_if = "Option::is_none")]
        name: Option<String>,
        #[serde(default, skip_serializing_if = "Vec::is_empty")]
        nodes: Vec<usize>,
        #[serde(skip_serializing_if = "Option::is_none")]
        extras: Extras,
    }

    Node {
        #[serde(skip_serializing_if = "Option::is_none")]
        name: Option<String>,
        #[serde(default, skip_serializing_if = "Vec::is_empty")]
        children: Vec<usize>,
        #[serde(skip_serializing_if = "Option::is_none")]
        matrix: Option<[f32; 16]>,
        #[serde(skip_serializing_if = "Option::is_none")]
        translation: Option<[f32; 3]>,
        #[serde(skip_serializing_if = "Option::is_none")]
        rotation: Option<[f32; 4]>,
        #[serde(skip_serializing_if = "Option::is_none")]
        scale: Option<[f32; 3]>,
        #[serde(skip_serializing_if = "Option::is_none")]
        mesh: Option<usize>,
        #[serde(skip_serializing_if = "Option::is_none")]
        skin: Option<usize>,
        #[serde(skip_serializing_if = "Option::is_none")]
        camera: Option<usize>,
        #[serde(skip_serializing_if = "Option::is_none")]
        weights: Option<Vec<f32>>,
        #[serde(skip_serializing_if = "Option::is_none")]
        extras: Extras,
    }

    Mesh {
        #[serde(skip_serializing_if = "Option::is_none")]
        name: Option<String>,
        primitives: Vec<Primitive>,
        #[serde(default, skip_serializing_if = "Vec::is_empty")]
        weights: Vec<f32>,
        #[serde(skip_serializing_if = "Option::is_none")]
        extras: Extras,
    }

    Primitive {
        attributes: Attributes,
        #[serde(skip_serializing_if = "Option::is_none")]
        indices: Option<usize>,
        #[serde(skip_serializing_if = "Option::is_none")]
        material: Option<usize>,
        #[serde(default = "triangles", skip_serializing_if = "is_triangles")]
        mode: u64,
        #[serde(default, skip_serializing_if = "Vec::is_empty")]
        targets: Vec<Attributes>,
        #[serde(default, skip_serializing)]
        extensions: PrimitiveExtensions,
        #[serde(skip_serializing_if = "Option::is_none")]
        extras: Extras,
    }

    #[derive(Default)]
    PrimitiveExtensions {
        #[serde(rename = "KHR_draco_mesh_compression")]
        draco: Option<Draco>,
    }

    Draco {
        buffer_view: usize,
        /// The number of each attribute in the compressed data, by its name.
        attributes: BTreeMap<String, u32>,
    }

    Skin {
        #[serde(skip_serializing_if = "Option::is_none")]
        name: Option<String>,
        joints: Vec<usize>,
        #[serde(skip_serializing_if = "Option::is_none")]
        inverse_bind_matrices: Option<usize>,
        #[serde(skip_serializing_if = "Option::is_none")]
        skeleton: Option<usize>,
        #[serde(skip_serializing_if = "Option::is_none")]
        extras: Extras,
    }

    Animation {
        #[serde(skip_serializing_if = "Option::is_none")]
        name: Option<String>,
        channels: Vec<Channel>,
        samplers: Vec<AnimationSampler>,
        #[serde(skip_serializing_if = "Option::is_none")]
        extras: Extras,
    }

    Channel {
        sampler: usize,
        target: Target,
        #[serde(skip_serializing_if = "Option::is_none")]
        extras: Extras,
    }

    Target {
        #[serde(skip_serializing_if = "Option::is_none")]
        node: Option<usize>,
        path: String,
    }

    #[derive(PartialEq)]
    AnimationSampler {
        input: usize,
        output: usize,
        #[serde(skip_serializing_if = "Option::is_none")]
        interpolation: Option<String>,
    }

    Material {
        #[serde(skip_serializing_if = "Option::is_none")]
        name: Option<String>,
        #[serde(skip_serializing_if = "Option::is_none")]
        pbr_metallic_roughness: Option<PbrMetallicRoughness>,
        #[serde(skip_serializing_if = "Option::is_none")]
        normal_texture: Option<TextureInfo>,
        #[serde(skip_serializing_if = "Option::is_none")]
        occlusion_texture: Option<TextureInfo>,
        #[serde(skip_serializing_if = "Option::is_none")]
        emissive_texture: Option<TextureInfo>,
        #[serde(skip_serializing_if = "Option::is_none")]
        emissive_factor: Option<[f32; 3]>,
        #[serde(skip_serializing_if = "Option::is_none")]
        alpha_mode: Option<String>,
        #[serde(skip_serializing_if = "Option::is_none")]
        alpha_cutoff: Option<f32>,
        #[serde(default, skip_serializing_if = "is_default")]
        double_sided: bool,
        #[serde(default, skip_serializing_if = "is_default")]
        extensions: MaterialExtensions,
        #[serde(skip_serializing_if = "Option::is_none")]
        extras: Extras,
    }

    #[derive(Default, PartialEq)]
    PbrMetallicRoughness {
        #[serde(skip_serializing_if = "Option::is_none")]
        base_color_factor: Option<[f32; 4]>,
        #[serde(skip_serializing_if = "Option::is_none")]
        base_color_texture: Option<TextureInfo>,
        #[serde(skip_serializing_if = "Option::is_none")]
        metallic_factor: Option<f32>,
        #[serde(skip_serializing_if = "Option::is_none")]
        roughness_factor: Option<f32>,
        #[serde(skip_serializing_if = "Option::is_none")]
        metallic_roughness_texture: Option<TextureInfo>,
    }

    #[derive(Default, PartialEq)]
    MaterialExtensions {
        #[serde(rename = "KHR_materials_unlit", skip_serializing_if = "Option::is_none")]
        unlit: Option<Empty>,
        #[serde(
            rename = "KHR_materials_emissive_strength",
            skip_serializing_if = "Option::is_none"
        )]
        emissive_strength: Option<EmissiveStrength>,
    }

    #[derive(Default, PartialEq)]
    Empty {}

    #[derive(PartialEq)]
    EmissiveStrength {
        #[serde(skip_serializing_if = "Option::is_none")]
        emissive_strength: Option<f32>,
    }

    /// A reference to a texture, with the numbers of normal and occlusion textures too.
    #[derive(Default, PartialEq)]
    TextureInfo {
        index: usize,
        #[serde(default, skip_serializing_if = "is_default")]
        tex_coord: u32,
        #[serde(skip_serializing_if = "Option::is_none")]
        scale: Option<f32>,
        #[serde(skip_serializing_if = "Option::is_none")]
        strength: Option<f32>,
        #[serde(default, skip_serializing_if = "is_default")]
        extensions: TextureInfoExtensions,
    }

    #[derive(Default, PartialEq)]
    TextureInfoExtensions {
        #[serde(rename = "KHR_texture_transform", skip_serializing_if = "Option::is_none")]
        transform: Option<TextureTransform>,
    }

    #[derive(Default, PartialEq)]
    TextureTransform {
        #[serde(skip_serializing_if = "Option::is_none")]
        offset: Option<[f32; 2]>,
        #[serde(skip_serializing_if = "Option::is_none")]
        rotation: Option<f32>,
        #[serde(skip_serializing_if = "Option::is_none")]
        scale: Option<[f32; 2]>,
        #[serde(skip_serializing_if = "Option::is_none")]
        tex_coord: Option<u32>,
    }

    Texture {
        #[serde(skip_serializing_if = "Option::is_none")]
        name: Option<String>,
        #[serde(skip_serializing_if = "Option::is_none")]
        sampler: Option<usize>,
        #[serde(skip_serializing_if = "Option::is_none")]
        source: Option<usize>,
        #[serde(skip_serializing_if = "Option::is_none")]
        extras: Extras,
    }

    Sampler {
        #[serde(skip_serializing_if = "Option::is_none")]
        name: Option<String>,
        #[serde(skip_serializing_if = "Option::is_none")]
        mag_filter: Option<u64>,
        #[serde(skip_serializing_if = "Option::is_none")]
        min_filter: Option<u64>,
        #[serde(skip_serializing_if = "Option::is_none")]
        wrap_s: Option<u64>,
        #[serde(skip_serializing_if = "Option::is_none")]
        wrap_t: Option<u64>,
        #[serde(skip_serializing_if = "Option::is_none")]
        extras: Extras,
    }

    Image {
        #[serde(skip_serializing_if = "Option::is_none")]
        name: Option<String>,
        #[serde(skip_serializing_if = "Option::is_none")]
        uri: Option<String>,
        #[serde(skip_serializing_if = "Option::is_none")]
        mime_type: Option<String>,
        #[serde(skip_serializing_if = "Option::is_none")]
        buffer_view: Option<usize>,
        #[serde(skip_serializing_if = "Option::is_none")]
        extras: Extras,
    }

    Camera {
        #[serde(skip_serializing_if = "Option::is_none")]
        name: Option<String>,
        #[serde(rename = "type")]
        kind: String,
        #[serde(skip_serializing_if = "Option::is_none")]
        perspective: Option<Perspective>,
        #[serde(skip_serializing_if = "Option::is_none")]
        orthographic: Option<Orthographic>,
        #[serde(skip_serializing_if = "Option::is_none")]
        extras: Extras,
    }

    Perspective {
        #[serde(skip_serializing_if = "Option::is_none")]
        aspect_ratio: Option<f32>,
        yfov: f32,
        #[serde(skip_serializing_if = "Option::is_none")]
        zfar: Option<f32>,
        znear: f32,
    }

    Orthographic {
        xmag: f32,
        ymag: f32,
        zfar: f32,
        znear: f32,
    }

    Accessor {
        #[serde(skip_serializing_if = "Option::is_none")]
        buffer_view: Option<usize>,
        #[serde(default)]
        byte_offset: u64,
        component_type: u64,
        count: u64,
        #[serde(rename = "type")]
        shape: String,
        #[serde(default, skip_serializing_if = "is_default")]
        normalized: bool,
        #[serde(skip_serializing_if = "Option::is_none")]
        sparse: Option<Sparse>,
        #[serde(skip_deserializing, skip_serializing_if = "Vec::is_empty")]
        min: Vec<f32>,
        #[serde(skip_deserializing, skip_serializing_if = "Vec::is_empty")]
        max: Vec<f32>,
    }

    Sparse {
        count: u64,
        indices: SparseIndices,
        values: SparseValues,
    }

    SparseIndices {
        buffer_view: usize,
        #[serde(default)]
        byte_offset: u64,
        component_type: u64,
    }

    SparseValues {
        buffer_view: usize,
        #[serde(default)]
        byte_offset: u64,
    }

    BufferView {
        buffer: usize,
        #[serde(default)]
        byte_offset: u64,
        byte_length: u64,
        #[serde(skip_serializing_if = "Option::is_none")]
        byte_stride: Option<u64>,
        #[serde(skip_serializing_if = "Option::is_none")]
        target: Option<u64>,
    }

    Buffer {
        byte_length: u64,
        #[serde(skip_serializing_if = "Option::is_none")]
        uri: Option<String>,
        #[serde(default, skip_serializing)]
        extensions: BufferExtensions,
    }

    #[derive(Default)]
    BufferExtensions {
        #[serde(rename = "EXT_meshopt_compression", alias = "KHR_meshopt_compression")]
        meshopt: Option<Empty>,
    }
}

/// The accessor of each attribute, by its name.
pub(super) type Attributes = BTreeMap<String, usize>;

/// The extension by which primitives are compressed.
pub(super) const DRACO: &str = "KHR_draco_mesh_compression";

/// The names of the extension by which buffer views are compressed.
pub(super) const MESHOPT: [&str; 2] = ["EXT_meshopt_compression", "KHR_meshopt_compression"];

/// The code of triangles as the mode of a primitive.
pub(super) const TRIANGLES: u64 = 4;

fn triangles() -> u64 {
    TRIANGLES
}

fn is_triangles(mode: &u64) -> bool {
    *mode == TRIANGLES
}

/// The codes of types of numbers.
pub(super) mod component_type {
    pub(in super::super) const BYTE: u64 = 5120;
    pub(in super::super) const UNSIGNED_BYTE: u64 = 5121;
    pub(in super::super) const SHORT: u64 = 5122;
    pub(in super::super) const UNSIGNED_SHORT: u64 = 5123;
    pub(in super::super) const UNSIGNED_INT: u64 = 5125;
    pub(in super::super) const FLOAT: u64 = 5126;
}

/// The codes of filters and of what lies beyond an image.
pub(super) mod sampling {
    pub(in super::super) const NEAREST: u64 = 9728;
    pub(in super::super) const LINEAR: u64 = 9729;
    pub(in super::super) const NEAREST_MIPMAP_NEAREST: u64 = 9984;
    pub(in super::super) const LINEAR_MIPMAP_NEAREST: u64 = 9985;
    pub(in super::super) const NEAREST_MIPMAP_LINEAR: u64 = 9986;
    pub(in super::super) const LINEAR_MIPMAP_LINEAR: u64 = 9987;
    pub(in super::super) const REPEAT: u64 = 10497;
    pub(in super::super) const CLAMP_TO_EDGE: u64 = 33071;
    pub(in super::super) const MIRRORED_REPEAT: u64 = 33648;
}
