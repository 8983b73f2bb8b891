//! Characters: the mesh, skeleton and weights of a document's skins.

use ga_anim::MotionFileError;
use ga_anim::gltf::{Placement, Player, character};
use ga_anim::skin::{self, Method};
use ga_mesh::gltf::{
    Animation, Channel, Document, Interpolation, Keys, Mesh, Node, Primitive, Skin, Transform,
};
use ga_runtime::cga3::{Motor, Point, Rotor};
use nullcone_shared_data::shared;

fn at(name: Option<&str>, children: &[usize], translation: [f32; 3]) -> Node {
    Node {
        name: name.map(ToOwned::to_owned),
        children: children.to_vec(),
        transform: Transform::Decomposed {
            translation,
            rotation: [0.0, 0.0, 0.0, 1.0],
            scale: [1.0; 3],
        },
        ..Node::default()
    }
}

/// An arm whose two skins number its joints differently, with a node between that is not a joint of
/// either; a ring below the hand, and a floor below nothing.
fn document() -> Document {
    let part = |joints: [u16; 4], weights: [f32; 4]| Mesh {
        primitives: vec![Primitive {
            positions: vec![[1.0, 0.0, 0.0], [2.0, 0.0, 0.0], [1.5, 1.0, 0.0]],
            joints: vec![vec![joints; 3]],
            weights: vec![vec![weights; 3]],
            ..Primitive::default()
        }],
        ..Mesh::default()
    };
    let plain = Mesh {
        primitives: vec![Primitive {
            positions: vec![[0.0; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]],
            ..Primitive::default()
        }],
        ..Mesh::default()
    };
    let mut nodes = vec![
        at(Some("floor"), &[], [0.0, -1.0, 0.0]),
        at(Some("scene"), &[2, 6, 7], [0.0, 1.0, 0.0]),
        at(Some("arm"), &[3], [0.0; 3]),
        at(None, &[4], [1.0, 0.0, 0.0]),
        at(Some("arm"), &[5], [1.0, 0.0, 0.0]),
        at(Some("ring"), &[], [0.5, 0.0, 0.0]),
        at(Some("skin"), &[], [9.0; 3]),
        at(Some("sleeve"), &[], [9.0; 3]),
    ];
    for (node, mesh, skin) in [(0, 2, None), (5, 2, None), (6, 0, Some(0)), (7, 1, Some(1))] {
        (nodes[node].mesh, nodes[node].skin) = (Some(mesh), skin);
    }
    let inverse = |x: f32| {
        let mut matrix = [0.0; 16];
        for place in [0, 5, 10, 15] {
            matrix[place] = 1.0;
        }
        (matrix[12], matrix[13]) = (-x, -1.0);
        matrix
    };
    let skin = |joints: &[usize], places: &[f32]| Skin {
        joints: joints.to_vec(),
        inverse_bind_matrices: places.iter().map(|&x| inverse(x)).collect(),
        ..Skin::default()
    };
    let bend = Channel {
        node: 4,
        times: vec![0.0, 1.0],
        interpolation: Interpolation::Linear,
        keys: Keys::Rotation(vec![[0.0, 0.0, 0.0, 1.0], [0.0, 0.0, 0.6, 0.8]]),
        extras: None,
    };
    Document {
        nodes,
        meshes: vec![
            part([0, 1, 0, 0], [0.25, 0.75, 0.0, 0.0]),
            part([1, 0, 0, 0], [0.5, 0.5, 0.0, 0.0]),
            plain,
        ],
        skins: vec![skin(&[2, 4], &[0.0, 2.0]), skin(&[4, 2], &[2.0, 0.0])],
        animations: vec![Animation {
            channels: vec![bend],
            ..Animation::default()
        }],
        ..Document::default()
    }
}

#[test]
fn joints_weights_and_vertices() {
    let body = character(&document()).unwrap();
    let joints = body.skeleton.joints();
    let names: Vec<&str> = joints.iter().map(|joint| joint.name.as_str()).collect();
    assert_eq!(names, ["arm", "node 3", "arm (node 4)"]);
    let parents: Vec<_> = joints.iter().map(|joint| joint.parent).collect();
    assert_eq!(parents, [None, Some(0), Some(1)]);
    assert_eq!(joints[1].head, [1.0, 1.0, 0.0]);
    assert_eq!(joints[1].tail, [2.0, 1.0, 0.0]);
    // The last bone continues the one above.
    assert_eq!(joints[2].tail, [2.5, 1.0, 0.0]);
    // The ring, the skin and the sleeve; not the floor.
    assert_eq!(body.mesh.vertex_count(), 9);
    let row = |vertex: usize| -> Vec<(u32, f64)> {
        let influences = body.weights.influences(vertex).iter();
        influences
            .map(|influence| (influence.joint, influence.weight))
            .collect()
    };
    assert_eq!(row(0), [(2, 1.0)]);
    assert_eq!(row(3), [(0, 0.25), (2, 0.75)]);
    assert_eq!(row(6), [(0, 0.5), (2, 0.5)]);
}

/// The character moved by motors is where the document's animation takes its vertices.
#[test]
fn it_moves_as_its_document_does() {
    let document = document();
    let body = character(&document).unwrap();
    let rotor = Rotor::from_quaternion([0.0, 0.0, 0.6], 0.8).unwrap();
    let hand = Motor::about(Point::new(2.0, 1.0, 0.0), rotor);
    let motions = [Motor::default(), Motor::default(), hand];
    let moved = skin::skin(
        body.mesh.positions(),
        &body.weights,
        &motions,
        Method::Linear,
    )
    .unwrap();
    let player = Player::new(&document).unwrap();
    let placement = Placement::new(&player).unwrap();
    let pose = player.pose(Some(0), 1.0).unwrap();
    let played = placement.place(&pose, Method::Linear).unwrap().positions;
    // Those of the floor come first.
    for (found, expected) in moved.iter().zip(&played[3..]) {
        assert!(
            found.distance(*expected) < 1e-7,
            "{found:?} is not {expected:?}"
        );
    }
}

#[test]
fn a_document_without_a_skin() {
    let mut still = document();
    still.nodes.iter_mut().for_each(|node| node.skin = None);
    assert_eq!(character(&still), Err(MotionFileError::NoSkin));
}

#[test]
fn the_cesium_man() {
    let Some(path) = shared("data/anim/gltf/cesium_man.gltf") else {
        return;
    };
    let body = character(&ga_mesh::gltf::read(path).unwrap()).unwrap();
    assert_eq!((body.skeleton.len(), body.mesh.vertex_count()), (19, 3273));
    let [low, high] = body.mesh.bounds().unwrap();
    // He stands upright.
    assert!(
        low[1].abs() < 0.05 && (high[1] - 1.5).abs() < 0.1,
        "{low:?} {high:?}"
    );
    // Every joint is within the body or close to it.
    for joint in body.skeleton.joints() {
        for axis in 0..3 {
            let range = low[axis] - 0.1..high[axis] + 0.1;
            assert!(range.contains(&joint.head[axis]), "{}", joint.name);
        }
    }
}

#[test]
fn joints_whose_numbered_names_are_taken() {
    let mut document = document();
    document.nodes[2].name = Some("node 3".to_owned());
    let body = character(&document).unwrap();
    let joints = body.skeleton.joints().iter();
    let names: Vec<&str> = joints.map(|joint| joint.name.as_str()).collect();
    assert_eq!(names, ["node 3", "node 3_", "arm"]);
}
