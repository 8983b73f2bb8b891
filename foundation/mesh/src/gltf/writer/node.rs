//! Nodes, scenes, cameras and the asset.

use super::super::{Asset, CameraElement, Node, Projection, Scene, Transform, json};

pub(super) fn asset(asset: &Asset) -> json::Asset {
    json::Asset {
        version: "2.0".to_owned(),
        min_version: None,
        generator: asset.generator.clone(),
        copyright: asset.copyright.clone(),
        extras: asset.extras.clone(),
    }
}

pub(super) fn scene(scene: &Scene) -> json::Scene {
    json::Scene {
        name: scene.name.clone(),
        nodes: scene.nodes.clone(),
        extras: scene.extras.clone(),
    }
}

pub(super) fn node(node: &Node) -> json::Node {
    let (matrix, translation, rotation, scale) = match node.transform {
        Transform::Matrix(matrix) => (Some(matrix), None, None, None),
        Transform::Decomposed {
            translation,
            rotation,
            scale,
        } => (
            None,
            Some(translation).filter(|t| *t != [0.0; 3]),
            Some(rotation).filter(|r| *r != [0.0, 0.0, 0.0, 1.0]),
            Some(scale).filter(|s| *s != [1.0; 3]),
        ),
    };
    json::Node {
        name: node.name.clone(),
        children: node.children.clone(),
        matrix,
        translation,
        rotation,
        scale,
        mesh: node.mesh,
        skin: node.skin,
        camera: node.camera,
        weights: node.weights.clone().filter(|weights| !weights.is_empty()),
        extras: node.extras.clone(),
    }
}

pub(super) fn camera(camera: &CameraElement) -> json::Camera {
    let (kind, perspective, orthographic) = match camera.projection {
        Projection::Perspective {
            aspect_ratio,
            vertical_angle,
            near,
            far,
        } => {
            let perspective = json::Perspective {
                aspect_ratio,
                yfov: vertical_angle,
                zfar: far,
                znear: near,
            };
            ("perspective", Some(perspective), None)
        }
        Projection::Orthographic {
            half_width,
            half_height,
            near,
            far,
        } => {
            let orthographic = json::Orthographic {
                xmag: half_width,
                ymag: half_height,
                zfar: far,
                znear: near,
            };
            ("orthographic", None, Some(orthographic))
        }
    };
    json::Camera {
        name: camera.name.clone(),
        kind: kind.to_owned(),
        perspective,
        orthographic,
        extras: camera.extras.clone(),
    }
}
