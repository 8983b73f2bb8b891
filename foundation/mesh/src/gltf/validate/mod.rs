//! What a document must be: references that exist, lists of matching lengths, numbers in range.

mod animation;
mod check;
mod primitive;

use std::collections::HashSet;

use super::problem::{Element, Problem};
use super::{CameraElement, Document, MaterialElement, Node, Projection, Skin, Transform};
use crate::{AlphaMode, FormatError};
use check::{Checked, count, distinct, exists, fault, finite, in_range, targets_of};

impl Document {
    /// Whether every element refers to elements that exist, every list has the length that others
    /// imply, and every number is finite and in its range. The reader returns only such documents,
    /// and the writer writes only such.
    ///
    /// # Errors
    ///
    /// [`FormatError`] names the first element that is at fault.
    pub fn validate(&self) -> Result<(), FormatError> {
        document(self)
    }
}

fn document(document: &Document) -> Checked {
    let parents = document.parents()?;
    if let Some(scene) = document.scene {
        exists("scene", scene, document.scenes.len())?;
    }
    for (index, scene) in document.scenes.iter().enumerate() {
        let within = |error: FormatError| error.within(Element::Scene(index));
        for &node in &scene.nodes {
            exists("node", node, document.nodes.len()).map_err(within)?;
            if parents[node].is_some() {
                let (property, value) = ("a node at its top", node.to_string());
                return fault(Element::Scene(index), Problem::Value { property, value });
            }
        }
        distinct("node", &scene.nodes).map_err(within)?;
    }
    for (index, mesh) in document.meshes.iter().enumerate() {
        primitive::mesh(index, mesh, document)?;
    }
    for (index, skin) in document.skins.iter().enumerate() {
        self::skin(skin, document).map_err(|error| error.within(Element::Skin(index)))?;
    }
    let mut skinned = HashSet::new();
    for (index, node) in document.nodes.iter().enumerate() {
        self::node(index, node, document, &mut skinned)
            .map_err(|error| error.within(Element::Node(index)))?;
    }
    for (index, animation) in document.animations.iter().enumerate() {
        self::animation::animation(index, animation, document)?;
    }
    for (index, material) in document.materials.iter().enumerate() {
        let checked = self::material(material, document.textures.len());
        checked.map_err(|error| error.within(Element::Material(index)))?;
    }
    for (index, texture) in document.textures.iter().enumerate() {
        let within = |error: FormatError| error.within(Element::Texture(index));
        if let Some(image) = texture.image {
            exists("image", image, document.images.len()).map_err(within)?;
        }
        if let Some(sampler) = texture.sampler {
            exists("sampler", sampler, document.samplers.len()).map_err(within)?;
        }
    }
    for (index, camera) in document.cameras.iter().enumerate() {
        self::camera(camera).map_err(|error| error.within(Element::Camera(index)))?;
    }
    Ok(())
}

/// `skinned` are the pairs of meshes and skins whose influences have been checked.
fn node(
    index: usize,
    node: &Node,
    document: &Document,
    skinned: &mut HashSet<(usize, usize)>,
) -> Checked {
    if let Some(camera) = node.camera {
        exists("camera", camera, document.cameras.len())?;
    }
    let is_finite = match node.transform {
        Transform::Matrix(matrix) => {
            let last_row = [matrix[3], matrix[7], matrix[11], matrix[15]];
            if last_row != [0.0, 0.0, 0.0, 1.0] {
                let value = format!("{last_row:?}");
                let property = "the last row of the matrix";
                return fault(Element::File, Problem::Value { property, value });
            }
            matrix.iter().all(|number| number.is_finite())
        }
        Transform::Decomposed {
            translation,
            rotation,
            scale,
        } => {
            if rotation == [0.0; 4] {
                let (property, value) = ("rotation", "zero".to_owned());
                return fault(Element::File, Problem::Value { property, value });
            }
            let numbers = translation.iter().chain(&rotation).chain(&scale);
            numbers.copied().all(f32::is_finite)
        }
    };
    let weights = node.weights.iter().flatten();
    if !is_finite || !weights.copied().all(f32::is_finite) {
        return fault(Element::File, Problem::NotFinite { item: index });
    }
    let Some(mesh) = node.mesh else {
        return match (node.skin, &node.weights) {
            (None, None) => Ok(()),
            _ => fault(
                Element::File,
                Problem::Missing("the mesh of its skin or weights"),
            ),
        };
    };
    exists("mesh", mesh, document.meshes.len())?;
    if let Some(weights) = &node.weights {
        let (expected, found) = (targets_of(document, mesh), weights.len());
        count("weights of morph targets", expected, found)?;
    }
    if let Some(skin) = node.skin {
        exists("skin", skin, document.skins.len())?;
        if !skinned.insert((mesh, skin)) {
            return Ok(());
        }
        let joints = document.skins[skin].joints.len();
        let primitives = document.meshes[mesh].primitives.iter().enumerate();
        for (primitive, data) in primitives {
            primitive::influences(mesh, primitive, data, joints)?;
        }
    }
    Ok(())
}

fn skin(skin: &Skin, document: &Document) -> Checked {
    if skin.joints.is_empty() {
        return fault(Element::File, Problem::Missing("joints"));
    }
    for &joint in skin.joints.iter().chain(&skin.skeleton) {
        exists("node", joint, document.nodes.len())?;
    }
    distinct("joint", &skin.joints)?;
    let matrices = &skin.inverse_bind_matrices;
    if !matrices.is_empty() {
        let (expected, found) = (skin.joints.len(), matrices.len());
        count("inverse bind matrices", expected, found)?;
    }
    finite(matrices)
}

fn material(material: &MaterialElement, textures: usize) -> Checked {
    for info in material.textures() {
        exists("texture", info.texture, textures)?;
        if let Some(transform) = info.transform {
            let numbers = [transform.offset, transform.scale, [transform.rotation, 0.0]];
            finite(&numbers)?;
        }
    }
    let fractions = material
        .base_colour
        .iter()
        .chain(&material.emissive)
        .chain([
            &material.metallic,
            &material.roughness,
            &material.occlusion_strength,
        ]);
    for fraction in fractions {
        in_range("a factor", *fraction, 0.0..=1.0)?;
    }
    in_range(
        "normalTexture.scale",
        material.normal_scale,
        f32::MIN..=f32::MAX,
    )?;
    in_range(
        "emissiveStrength",
        material.emissive_strength,
        0.0..=f32::MAX,
    )?;
    if let AlphaMode::Mask { cutoff } = material.alpha_mode {
        in_range("alphaCutoff", cutoff as f32, 0.0..=f32::MAX)?;
    }
    Ok(())
}

fn camera(camera: &CameraElement) -> Checked {
    const POSITIVE: std::ops::RangeInclusive<f32> = f32::MIN_POSITIVE..=f32::MAX;
    let (near, far) = match camera.projection {
        Projection::Perspective {
            aspect_ratio,
            vertical_angle,
            near,
            far,
        } => {
            in_range("yfov", vertical_angle, POSITIVE)?;
            in_range("aspectRatio", aspect_ratio.unwrap_or(1.0), POSITIVE)?;
            in_range("znear", near, POSITIVE)?;
            (near, far)
        }
        Projection::Orthographic {
            half_width,
            half_height,
            near,
            far,
        } => {
            for (property, half) in [("xmag", half_width), ("ymag", half_height)] {
                in_range(property, half.abs(), POSITIVE)?;
            }
            in_range("znear", near, 0.0..=f32::MAX)?;
            (near, Some(far))
        }
    };
    in_range("zfar", far.unwrap_or(f32::MAX), near.next_up()..=f32::MAX)
}
