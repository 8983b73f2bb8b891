//! Nodes, scenes and cameras.

use super::super::problem::{Element, Problem};
use super::super::{CameraElement, Node, Projection, Scene, Transform, json};
use crate::FormatError;

pub(super) fn scene(json: &json::Scene) -> Scene {
    Scene {
        name: json.name.clone(),
        nodes: json.nodes.clone(),
        extras: json.extras.clone(),
    }
}

pub(super) fn node(index: usize, json: &json::Node) -> Result<Node, FormatError> {
    let is_decomposed =
        json.translation.is_some() || json.rotation.is_some() || json.scale.is_some();
    let transform = match json.matrix {
        Some(_) if is_decomposed => {
            let problem = Problem::Duplicate {
                what: "the transform of node",
                index,
            };
            return Err(FormatError::gltf(Element::Node(index), problem));
        }
        Some(matrix) => Transform::Matrix(matrix),
        None => Transform::Decomposed {
            translation: json.translation.unwrap_or_default(),
            rotation: json.rotation.unwrap_or([0.0, 0.0, 0.0, 1.0]),
            scale: json.scale.unwrap_or([1.0; 3]),
        },
    };
    Ok(Node {
        name: json.name.clone(),
        children: json.children.clone(),
        transform,
        mesh: json.mesh,
        skin: json.skin,
        camera: json.camera,
        weights: json.weights.clone().filter(|weights| !weights.is_empty()),
        extras: json.extras.clone(),
    })
}

pub(super) fn camera(index: usize, json: &json::Camera) -> Result<CameraElement, FormatError> {
    let fault = |problem| FormatError::gltf(Element::Camera(index), problem);
    let projection = match json.kind.as_str() {
        "perspective" => {
            let perspective = json.perspective.as_ref();
            let perspective = perspective.ok_or_else(|| fault(Problem::Missing("perspective")))?;
            Projection::Perspective {
                aspect_ratio: perspective.aspect_ratio,
                vertical_angle: perspective.yfov,
                near: perspective.znear,
                far: perspective.zfar,
            }
        }
        "orthographic" => {
            let orthographic = json.orthographic.as_ref();
            let orthographic =
                orthographic.ok_or_else(|| fault(Problem::Missing("orthographic")))?;
            Projection::Orthographic {
                half_width: orthographic.xmag,
                half_height: orthographic.ymag,
                near: orthographic.znear,
                far: orthographic.zfar,
            }
        }
        other => {
            let (property, value) = ("type", other.to_owned());
            return Err(fault(Problem::Value { property, value }));
        }
    };
    Ok(CameraElement {
        name: json.name.clone(),
        projection,
        extras: json.extras.clone(),
    })
}
