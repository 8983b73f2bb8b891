//! Documents that cannot be played: the error names the element.

use ga_anim::MotionFileError;
use ga_anim::gltf::{Placement, Player};
use ga_anim::skin::Method;
use ga_mesh::FormatError;
use ga_mesh::gltf::{
    Animation, Channel, Document, Element, Interpolation, Keys, Mesh, Node, Primitive, Problem,
    Skin, Transform,
};

/// A triangle that two joints move, one of which rotates.
fn document() -> Document {
    let triangle = Primitive {
        positions: vec![[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]],
        joints: vec![vec![[0, 1, 0, 0]; 3]],
        weights: vec![vec![[0.5, 0.5, 0.0, 0.0]; 3]],
        ..Primitive::default()
    };
    let rotation = Channel {
        node: 2,
        times: vec![0.0, 1.0],
        interpolation: Interpolation::Linear,
        keys: Keys::Rotation(vec![[0.0, 0.0, 0.0, 1.0], [0.0, 0.0, 1.0, 0.0]]),
        extras: None,
    };
    Document {
        nodes: vec![
            Node {
                mesh: Some(0),
                skin: Some(0),
                ..Node::default()
            },
            Node {
                children: vec![2],
                ..Node::default()
            },
            Node::default(),
        ],
        meshes: vec![Mesh {
            primitives: vec![triangle],
            ..Mesh::default()
        }],
        skins: vec![Skin {
            joints: vec![1, 2],
            ..Skin::default()
        }],
        animations: vec![Animation {
            channels: vec![rotation],
            ..Animation::default()
        }],
        ..Document::default()
    }
}

fn scaled(scale: [f32; 3]) -> Transform {
    Transform::Decomposed {
        translation: [0.0; 3],
        rotation: [0.0, 0.0, 0.0, 1.0],
        scale,
    }
}

/// The error of a changed document, read or played at 0.5 s.
fn error(method: Method, change: impl FnOnce(&mut Document)) -> MotionFileError {
    let mut document = document();
    change(&mut document);
    let play = || {
        let player = Player::new(&document)?;
        let placement = Placement::new(&player)?;
        placement.place(&player.pose(Some(0), 0.5)?, method)
    };
    play().unwrap_err()
}

#[track_caller]
fn assert_document(error: MotionFileError, element: Element, problem: Problem) {
    let MotionFileError::Document(FormatError::Gltf {
        path,
        problem: found,
    }) = error
    else {
        panic!("{error}");
    };
    assert_eq!((path.last(), &found), (Some(&element), &problem));
}

const CHANNEL: Element = Element::Channel {
    animation: 0,
    channel: 0,
};

#[test]
fn as_it_is_it_plays() {
    let document = document();
    let player = Player::new(&document).unwrap();
    let placement = Placement::new(&player).unwrap();
    let pose = player.pose(Some(0), 0.5).unwrap();
    for method in [Method::Linear, Method::Motor, Method::DualQuaternion] {
        assert_eq!(placement.place(&pose, method).unwrap().positions.len(), 3);
    }
}

#[test]
fn joints_and_weights() {
    let attribute = |name: &str| Element::Attribute {
        mesh: 0,
        primitive: 0,
        target: None,
        name: name.to_owned(),
    };
    assert_document(
        error(Method::Linear, |d| {
            d.meshes[0].primitives[0].joints[0][1][3] = 2
        }),
        attribute("JOINTS_0"),
        Problem::Joint {
            vertex: 1,
            joint: 2,
            joints: 2,
        },
    );
    assert_document(
        error(Method::Linear, |d| {
            d.meshes[0].primitives[0].weights[0][2] = [0.0; 4]
        }),
        attribute("WEIGHTS_0"),
        Problem::Weights {
            vertex: 2,
            sum: 0.0,
        },
    );
}

#[test]
fn keys_and_times() {
    let with_times = |times: [f32; 2]| {
        error(Method::Linear, |d| {
            d.animations[0].channels[0].times = times.to_vec()
        })
    };
    assert_document(
        with_times([1.0, 1.0]),
        CHANNEL,
        Problem::Time {
            key: 1,
            seconds: 1.0,
        },
    );
    assert_document(
        with_times([-1.0, 1.0]),
        CHANNEL,
        Problem::Time {
            key: 0,
            seconds: -1.0,
        },
    );
    let MotionFileError::Document(nan) = with_times([0.0, f32::NAN]) else {
        panic!("a time that is not a number");
    };
    assert!(nan.to_string().contains("key 1, NaN s"), "{nan}");
    let with_keys = |keys: [[f32; 4]; 2]| {
        error(Method::Linear, |d| {
            d.animations[0].channels[0].keys = Keys::Rotation(keys.to_vec())
        })
    };
    let not_a_number = [[0.0, 0.0, 0.0, 1.0], [0.0, f32::NAN, 0.0, 1.0]];
    assert_document(
        with_keys(not_a_number),
        CHANNEL,
        Problem::NotFinite { item: 5 },
    );
    let (element, seconds) = (CHANNEL, 0.5);
    assert_eq!(
        with_keys([[0.0; 4]; 2]),
        MotionFileError::NoRotation { element, seconds }
    );
}

/// Half way between opposite keys without tangents a spline goes through zero.
#[test]
fn a_spline_through_zero() {
    let (zero, one) = ([0.0; 4], [0.0, 0.0, 0.0, 1.0]);
    let found = error(Method::Linear, |d| {
        let channel = &mut d.animations[0].channels[0];
        channel.interpolation = Interpolation::CubicSpline;
        channel.keys = Keys::Rotation(vec![zero, one, zero, zero, one.map(|x: f32| -x), zero]);
    });
    let (element, seconds) = (CHANNEL, 0.5);
    assert_eq!(found, MotionFileError::NoRotation { element, seconds });
}

#[test]
fn nodes() {
    let cycle = error(Method::Linear, |d| d.nodes[2].children = vec![1]);
    assert_document(cycle, Element::Node(1), Problem::Cycle);
    let matrix = error(Method::Linear, |d| {
        let mut identity = [0.0; 16];
        for place in [0, 5, 10, 15] {
            identity[place] = 1.0;
        }
        d.nodes[2].transform = Transform::Matrix(identity);
    });
    let (element, node) = (CHANNEL, 2);
    assert_eq!(matrix, MotionFileError::AnimatedMatrix { element, node });
    let far = error(Method::Linear, |d| {
        d.nodes[1].transform = scaled([f32::MAX; 3]);
        for _ in 0..9 {
            let child = d.nodes.len();
            let last = if child == 3 { 2 } else { child - 1 };
            d.nodes[last].children = vec![child];
            let transform = scaled([f32::MAX; 3]);
            d.nodes.push(Node {
                transform,
                ..Node::default()
            });
        }
    });
    let (node, seconds) = (10, 0.5);
    assert_eq!(far, MotionFileError::FrameNotFinite { node, seconds });
}

/// A joint that maps everything onto a line has no rotation. One that maps onto a plane has, and
/// the linear blend needs none.
#[test]
fn singular_joints() {
    let flattened = |scale| move |d: &mut Document| d.nodes[2].transform = scaled(scale);
    for method in [Method::Motor, Method::DualQuaternion] {
        for scale in [[0.0; 3], [1.0, 0.0, 0.0]] {
            let (skin, joint, node) = (0, 1, 2);
            let found = error(method, flattened(scale));
            assert_eq!(found, MotionFileError::Singular { skin, joint, node });
        }
    }
    let mut flat = document();
    flattened([1.0, 1.0, 0.0])(&mut flat);
    let mut point = document();
    flattened([0.0; 3])(&mut point);
    for (document, method) in [(flat, Method::Motor), (point, Method::Linear)] {
        let player = Player::new(&document).unwrap();
        let placement = Placement::new(&player).unwrap();
        let pose = player.pose(Some(0), 0.5).unwrap();
        assert!(placement.place(&pose, method).is_ok());
    }
}

#[test]
fn numbers_of_the_caller() {
    let document = document();
    let player = Player::new(&document).unwrap();
    let (animation, count) = (1, 1);
    let none = MotionFileError::NoAnimation { animation, count };
    assert_eq!(none.to_string(), "there is no animation 1: the file has 1");
    assert_eq!(player.pose(Some(1), 0.0), Err(none));
    assert!(matches!(
        player.pose(None, f64::NAN),
        Err(MotionFileError::Time(_))
    ));
}

/// Nodes of a few bytes each may not become vertices without limit.
#[test]
fn one_mesh_in_many_nodes() {
    let mut document = Document {
        meshes: vec![Mesh {
            primitives: vec![Primitive {
                positions: vec![[0.0; 3]; 20_000],
                ..Primitive::default()
            }],
            ..Mesh::default()
        }],
        ..Document::default()
    };
    document.nodes = vec![
        Node {
            mesh: Some(0),
            ..Node::default()
        };
        1000
    ];
    let player = Player::new(&document).unwrap();
    assert_eq!(Placement::new(&player).unwrap().vertex_count(), 20_000_000);
    document.nodes.push(document.nodes[0].clone());
    let player = Player::new(&document).unwrap();
    let (needed, limit) = (20_020_000, 20_000_000);
    let found = Placement::new(&player).unwrap_err();
    assert_eq!(found, MotionFileError::TooLarge { needed, limit });
}
