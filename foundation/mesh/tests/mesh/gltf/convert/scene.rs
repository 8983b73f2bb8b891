//! Nodes of a scene: they place, mirror and weight their meshes.

use ga_mesh::gltf::{self as ours, Document, Node, Primitive, Transform, Vertices};

/// A quarter turn about z, a translation and a scale of −2 along x, which mirrors.
#[test]
fn nodes_place_and_mirror_their_meshes() {
    let half = std::f32::consts::FRAC_1_SQRT_2;
    let triangle = Primitive {
        positions: vec![[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]],
        normals: vec![[half, 0.0, half]; 3],
        tangents: vec![[half, 0.0, -half, 1.0]; 3],
        texcoords: vec![vec![[0.0, 0.0], [1.0, 0.0], [0.0, 1.0]]],
        ..Primitive::default()
    };
    let node = |transform, children| Node {
        transform,
        children,
        ..Node::default()
    };
    let turn = Transform::Decomposed {
        translation: [10.0, 0.0, 0.0],
        rotation: [0.0, 0.0, half, half],
        scale: [1.0; 3],
    };
    let mirror = Transform::Decomposed {
        translation: [0.0; 3],
        rotation: [0.0, 0.0, 0.0, 1.0],
        scale: [-2.0, 1.0, 1.0],
    };
    let document = Document {
        nodes: vec![
            Node {
                mesh: Some(0),
                name: Some("leaf".to_owned()),
                ..node(mirror, vec![])
            },
            node(turn, vec![0]),
        ],
        meshes: vec![ours::Mesh {
            primitives: vec![triangle],
            ..ours::Mesh::default()
        }],
        ..Document::default()
    };
    let mesh = document.to_mesh(Vertices::Kept).unwrap();
    // (x, y) becomes (−2 x, y), then (−y, −2 x) + (10, 0).
    let expected = [[10.0, 0.0, 0.0], [10.0, -2.0, 0.0], [9.0, 0.0, 0.0]];
    let near = |a: [f64; 3], b: [f64; 3]| (0..3).all(|i| (a[i] - b[i]).abs() < 1e-6);
    for (found, expected) in mesh.coordinates().zip(expected) {
        assert!(near(found, expected), "{found:?}");
    }
    assert_eq!(mesh.objects()[0].name, "leaf");
    // The reversed triangle still has its normal on the outside, here as far as z goes: the plane
    // x + z = 0 becomes −x/2 + z = 0, and then −y/2 + z = 0.
    assert_eq!(mesh.faces().get(0), Some(&[0, 2, 1][..]));
    let length = 1.25f64.sqrt();
    let normal = mesh.normals().unwrap().get(0).unwrap().coordinates();
    assert!(
        near(normal, [0.0, -0.5 / length, 1.0 / length]),
        "{normal:?}"
    );
    let tangent = mesh.tangents().unwrap().get(0).unwrap();
    let length = 5f64.sqrt();
    let direction = tangent.direction.coordinates();
    assert!(
        near(direction, [0.0, -2.0 / length, -1.0 / length]),
        "{direction:?}"
    );
    assert_eq!(tangent.handedness, -1.0);
    assert_eq!(mesh.texture_coordinates().unwrap().values[2], [0.0, 0.0]);
}

/// A few bytes in the file for each node must not become gigabytes.
#[test]
fn nodes_may_not_place_a_mesh_without_end() {
    let node = Node {
        mesh: Some(0),
        ..Node::default()
    };
    let document = |nodes: usize| Document {
        nodes: vec![node.clone(); nodes],
        meshes: vec![ours::Mesh {
            primitives: vec![Primitive {
                positions: vec![[0.0; 3]; 1000],
                ..Primitive::default()
            }],
            ..ours::Mesh::default()
        }],
        ..Document::default()
    };
    let placed = document(1000).to_mesh(Vertices::Kept).unwrap();
    assert_eq!(placed.vertex_count(), 1_000_000);
    let error = document(20_000).to_mesh(Vertices::Kept).unwrap_err();
    let expected = "file: needs 480000000 bytes, more than the limit of 402653184";
    assert_eq!(error.to_string(), expected);
}

/// Three nodes, each with a triangle at its own height; the second is a child of the first.
#[test]
fn only_the_nodes_of_the_default_scene_are_converted() {
    let node = |height: f32, children| Node {
        mesh: Some(0),
        transform: Transform::Decomposed {
            translation: [0.0, 0.0, height],
            rotation: [0.0, 0.0, 0.0, 1.0],
            scale: [1.0; 3],
        },
        children,
        ..Node::default()
    };
    let scene = |node| ours::Scene {
        nodes: vec![node],
        ..ours::Scene::default()
    };
    let mut document = Document {
        scene: Some(1),
        scenes: vec![scene(2), scene(0)],
        nodes: vec![node(1.0, vec![1]), node(2.0, vec![]), node(5.0, vec![])],
        meshes: vec![ours::Mesh {
            primitives: vec![Primitive {
                positions: vec![[0.0; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]],
                ..Primitive::default()
            }],
            ..ours::Mesh::default()
        }],
        ..Document::default()
    };
    let heights = |document: &Document| -> Vec<f64> {
        let mesh = document.to_mesh(Vertices::Kept).unwrap();
        mesh.coordinates().step_by(3).map(|[_, _, z]| z).collect()
    };
    assert_eq!(heights(&document), [1.0, 3.0]);
    document.scene = None;
    assert_eq!(heights(&document), [5.0]);
    document.scenes.clear();
    assert_eq!(heights(&document), [1.0, 3.0, 5.0]);
}

/// Half of one target and twice the other.
#[test]
fn morph_targets_have_the_weights_of_the_node() {
    let target = |x: f32| ours::MorphTarget {
        positions: vec![[x, 0.0, 0.0]; 3],
        ..ours::MorphTarget::default()
    };
    let primitive = Primitive {
        positions: vec![[0.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]],
        targets: vec![target(3.0), target(10.0)],
        ..Primitive::default()
    };
    let node = |weights| Node {
        mesh: Some(0),
        weights,
        ..Node::default()
    };
    let document = Document {
        nodes: vec![node(None), node(Some(vec![0.5, 2.0]))],
        meshes: vec![ours::Mesh {
            primitives: vec![primitive],
            weights: vec![1.0, 0.0],
            ..ours::Mesh::default()
        }],
        ..Document::default()
    };
    let mesh = document.to_mesh(Vertices::Kept).unwrap();
    let x: Vec<f64> = mesh.coordinates().map(|[x, _, _]| x).collect();
    assert_eq!(x, [3.0, 3.0, 3.0, 21.5, 21.5, 21.5]);
}
