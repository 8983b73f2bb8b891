//! Made-up documents with all that glTF has for motion, against an independent evaluator.

use ga_anim::gltf::{Placed, Placement, Player};
use ga_anim::skin::Method;
use ga_mesh::gltf::{
    Animation, Channel, Document, Interpolation, Keys, Mesh, Mode, MorphTarget, Node, Primitive,
    Skin, Transform, Vertices, decode, encode,
};
use proptest::prelude::*;

use super::reference;
use crate::assert_relative;

/// Numbers between −1 and 1, one after the other, from the beginning again after the last.
struct Pool {
    numbers: Vec<f32>,
    next: usize,
}

impl Pool {
    fn number(&mut self) -> f32 {
        self.next += 1;
        self.numbers[self.next % self.numbers.len()]
    }

    fn array<const N: usize>(&mut self) -> [f32; N] {
        std::array::from_fn(|_| self.number())
    }

    fn arrays<const N: usize>(&mut self, count: usize) -> Vec<[f32; N]> {
        (0..count).map(|_| self.array()).collect()
    }

    /// A quaternion of length 1 up to rounding.
    fn rotation(&mut self) -> [f32; 4] {
        let [x, y, z, w] = self.array();
        let w = w + 0.01f32.copysign(w);
        let length = (x * x + y * y + z * z + w * w).sqrt();
        [x, y, z, w].map(|number| number / length)
    }

    /// Factors of either sign, none of them near 0.
    fn scale(&mut self) -> [f32; 3] {
        self.array().map(|number| number + 0.3f32.copysign(number))
    }

    fn frame(&mut self) -> Transform {
        Transform::Decomposed {
            translation: self.array(),
            rotation: self.rotation(),
            scale: self.scale(),
        }
    }

    fn matrix(&mut self) -> [f32; 16] {
        let mut matrix = self.array();
        for column in 0..4 {
            matrix[4 * column + 3] = if column == 3 { 1.0 } else { 0.0 };
            matrix[5 * column] += 1.5;
        }
        matrix[15] = 1.0;
        matrix
    }

    /// A primitive with this many vertices, sets of joints and morph targets.
    fn primitive(
        &mut self,
        vertices: usize,
        sets: usize,
        joints: u16,
        targets: usize,
    ) -> Primitive {
        let row =
            |vertex: usize| std::array::from_fn(|place| (7 * vertex + 3 * place) as u16 % joints);
        let weights = |pool: &mut Self| pool.array().map(|weight: f32| weight.abs() + 0.01);
        Primitive {
            positions: self.arrays(vertices),
            joints: vec![(0..vertices).map(row).collect(); sets],
            weights: (0..sets)
                .map(|_| (0..vertices).map(|_| weights(self)).collect())
                .collect(),
            targets: (0..targets)
                .map(|_| MorphTarget {
                    positions: self.arrays(vertices),
                    ..MorphTarget::default()
                })
                .collect(),
            ..Primitive::default()
        }
    }

    fn channel(&mut self, node: usize, interpolation: Interpolation, path: Path) -> Channel {
        let keys = 3;
        let count = keys * interpolation.values_per_key();
        let is_spline = interpolation == Interpolation::CubicSpline;
        Channel {
            node,
            times: vec![0.25, 1.0, 2.75],
            interpolation,
            keys: match path {
                Path::Translation => Keys::Translation(self.arrays(count)),
                Path::Scale if is_spline => Keys::Scale(self.arrays(count)),
                Path::Scale => Keys::Scale((0..count).map(|_| self.scale()).collect()),
                Path::Rotation => Keys::Rotation((0..count).map(|_| self.rotation()).collect()),
                Path::Weights(targets) => Keys::Weights(
                    self.arrays::<1>(count * targets)
                        .into_iter()
                        .flatten()
                        .collect(),
                ),
            },
            extras: None,
        }
    }
}

#[derive(Clone, Copy)]
enum Path {
    Translation,
    Rotation,
    Scale,
    Weights(usize),
}

/// Two skins, one with inverse bind matrices, on nodes with frames of their own; a matrix among the
/// joints; sets of eight influences; morph targets with and without a skin; a mesh without a skin
/// below a node that moves.
fn document(numbers: Vec<f32>) -> Document {
    let pool = &mut Pool { numbers, next: 0 };
    let node = |pool: &mut Pool, children: &[usize]| Node {
        transform: pool.frame(),
        children: children.to_vec(),
        ..Node::default()
    };
    let mut nodes = vec![
        node(pool, &[1, 5, 8]),
        node(pool, &[2, 3]),
        node(pool, &[4]),
        node(pool, &[]),
        node(pool, &[]),
        node(pool, &[]),
        node(pool, &[7]),
        node(pool, &[]),
        node(pool, &[]),
        node(pool, &[]),
    ];
    nodes[2].transform = Transform::Matrix(pool.matrix());
    for (node, mesh) in [(5, 0), (6, 1), (8, 2), (9, 3)] {
        nodes[node].mesh = Some(mesh);
    }
    (nodes[5].skin, nodes[6].skin) = (Some(0), Some(1));
    nodes[5].weights = Some(pool.array::<2>().to_vec());
    let mesh = |primitives: Vec<Primitive>, weights: &[f32]| Mesh {
        primitives,
        weights: weights.to_vec(),
        ..Mesh::default()
    };
    let first = vec![pool.primitive(6, 2, 4, 2), pool.primitive(3, 1, 4, 2)];
    let second = vec![pool.primitive(3, 1, 3, 0)];
    let third = vec![pool.primitive(3, 0, 1, 0)];
    let fourth = vec![pool.primitive(3, 0, 1, 1)];
    let mesh_weight = pool.number();
    use Interpolation::{CubicSpline, Linear, Step};
    let mut channels = vec![
        pool.channel(1, Linear, Path::Translation),
        pool.channel(1, CubicSpline, Path::Rotation),
        pool.channel(1, Step, Path::Scale),
        pool.channel(3, Linear, Path::Rotation),
        pool.channel(0, Linear, Path::Scale),
        pool.channel(4, CubicSpline, Path::Translation),
        pool.channel(4, CubicSpline, Path::Scale),
        pool.channel(5, CubicSpline, Path::Weights(2)),
        pool.channel(6, Step, Path::Rotation),
        pool.channel(9, Linear, Path::Weights(1)),
        pool.channel(8, Step, Path::Translation),
    ];
    channels.push(Channel {
        node: 8,
        times: vec![0.5],
        interpolation: Linear,
        keys: Keys::Rotation(vec![pool.rotation()]),
        extras: None,
    });
    let skin = |joints: &[usize], inverse_bind_matrices| Skin {
        joints: joints.to_vec(),
        inverse_bind_matrices,
        ..Skin::default()
    };
    let inverse = (0..4).map(|_| pool.matrix()).collect();
    let second_animation = vec![pool.channel(7, Linear, Path::Rotation)];
    let animation = |channels| Animation {
        channels,
        ..Animation::default()
    };
    Document {
        nodes,
        meshes: vec![
            mesh(first, &[]),
            mesh(second, &[]),
            mesh(third, &[]),
            mesh(fourth, &[mesh_weight]),
        ],
        skins: vec![skin(&[1, 2, 3, 4], inverse), skin(&[7, 1, 0], Vec::new())],
        animations: vec![animation(channels), animation(second_animation)],
        ..Document::default()
    }
}

fn place(document: &Document, animation: Option<usize>, time: f64, method: Method) -> Placed {
    let player = Player::new(document).unwrap();
    let placement = Placement::new(&player).unwrap();
    let pose = player.pose(animation, time).unwrap();
    placement.place(&pose, method).unwrap()
}

fn numbers() -> impl Strategy<Value = Vec<f32>> {
    prop::collection::vec(-1f32..1.0, 331)
}

/// Times before, at, between and after the keys.
fn time() -> impl Strategy<Value = f64> {
    prop_oneof![
        Just(-1.0),
        Just(0.25),
        Just(1.0),
        Just(2.75),
        Just(9.0),
        0.2..2.8
    ]
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(96))]

    #[test]
    fn vertices_are_where_an_independent_evaluator_has_them(
        numbers in numbers(),
        animation in prop_oneof![Just(None), Just(Some(0)), Just(Some(1))],
        time in time(),
    ) {
        let file = encode(&document(numbers)).unwrap();
        let expected = reference::vertices(&file, animation, time);
        let placed = place(&decode(&file).unwrap(), animation, time, Method::Linear);
        prop_assert_eq!(placed.positions.len(), expected.len());
        for (found, expected) in placed.positions.iter().zip(expected) {
            for (found, expected) in found.coordinates().into_iter().zip(expected.to_array()) {
                assert_relative(found, expected, 1e-11);
            }
        }
    }

    /// The mesh of placed vertices is that which ga-mesh makes of the document on a path of its
    /// own, by matrices, with normals and tangents.
    #[test]
    fn normals_and_tangents_are_those_of_the_document_as_a_mesh(numbers in numbers()) {
        let mut document = document(numbers);
        for primitive in document.meshes.iter_mut().flat_map(|mesh| &mut mesh.primitives) {
            let next = |&[x, y, z]: &[f32; 3]| [y, z, x];
            primitive.normals = primitive.positions.iter().map(next).collect();
            let tangents = primitive.positions.iter();
            primitive.tangents = tangents.map(|&[x, y, z]| [z, x, y, 1.0]).collect();
            for target in &mut primitive.targets {
                target.normals = target.positions.iter().map(next).collect();
                target.tangents = target.positions.iter().map(|&[x, y, z]| [z, x, y]).collect();
            }
            // Where the joints of a part mirror only some of its vertices, the part has no side.
            for row in primitive.joints.iter_mut().flatten() {
                *row = [0; 4];
            }
        }
        let expected = document.to_mesh(Vertices::Kept).unwrap();
        let placed = place(&document, None, 0.0, Method::Linear);
        let player = Player::new(&document).unwrap();
        let placement = Placement::new(&player).unwrap();
        let found = placement.mesh(&placed, |_| true).unwrap();
        prop_assert_eq!(found.faces(), expected.faces());
        let lists = [&found, &expected].map(|mesh| {
            let normals = mesh.normals().unwrap();
            let tangents = mesh.tangents().unwrap();
            let directions = tangents.values.iter().map(|tangent| tangent.direction);
            (normals.values.iter().copied().chain(directions).collect::<Vec<_>>(), normals, tangents)
        });
        prop_assert_eq!(&lists[0].1.corners, &lists[1].1.corners);
        for (found, expected) in lists[0].2.values.iter().zip(&lists[1].2.values) {
            prop_assert_eq!(found.handedness, expected.handedness);
        }
        prop_assert_eq!(lists[0].0.len(), lists[1].0.len());
        for (found, expected) in lists[0].0.iter().zip(&lists[1].0) {
            // Frames that are almost flat take directions close together.
            prop_assert!((*found - *expected).length() < 1e-6, "{found:?} {expected:?}");
        }
    }

    /// A vertex that one joint moves goes where the joint's transform takes it, scaled, sheared and
    /// mirrored, however the transforms are blended.
    #[test]
    fn motors_keep_what_scales_and_mirrors(numbers in numbers(), time in time()) {
        let mut document = document(numbers);
        for primitive in document.meshes.iter_mut().flat_map(|mesh| &mut mesh.primitives) {
            for (set, weights) in primitive.weights.iter_mut().enumerate() {
                let first = if set == 0 { 0.5 } else { 0.0 };
                weights.iter_mut().for_each(|row| *row = [first, 0.0, 0.0, 0.0]);
            }
        }
        let linear = place(&document, Some(0), time, Method::Linear);
        let motor = place(&document, Some(0), time, Method::Motor);
        for (linear, motor) in linear.positions.iter().zip(&motor.positions) {
            for (linear, motor) in linear.coordinates().into_iter().zip(motor.coordinates()) {
                assert_relative(motor, linear, 1e-12);
            }
        }
    }
}

/// Joints that are rotated, translated and scaled evenly: the dual quaternion blend drops the
/// factor, so the vertices of one joint keep their distances; with the motor blend they are scaled.
#[test]
fn dual_quaternions_drop_scale() {
    let numbers: Vec<f32> = (0..331).map(|k| (k as f32 * 1.7).sin()).collect();
    let pool = &mut Pool { numbers, next: 0 };
    let mut primitive = pool.primitive(4, 1, 1, 0);
    primitive.weights[0] = vec![[1.0, 0.0, 0.0, 0.0]; 4];
    let transform = Transform::Decomposed {
        translation: [1.0, 2.0, 3.0],
        rotation: pool.rotation(),
        scale: [2.5; 3],
    };
    let document = Document {
        nodes: vec![
            Node {
                mesh: Some(0),
                skin: Some(0),
                ..Node::default()
            },
            Node {
                transform,
                ..Node::default()
            },
        ],
        meshes: vec![Mesh {
            primitives: vec![primitive.clone()],
            ..Mesh::default()
        }],
        skins: vec![Skin {
            joints: vec![1],
            ..Skin::default()
        }],
        ..Document::default()
    };
    for (method, factor) in [
        (Method::DualQuaternion, 1.0),
        (Method::Motor, 2.5),
        (Method::Linear, 2.5),
    ] {
        let placed = place(&document, None, 0.0, method).positions;
        for (a, b) in [(0, 1), (1, 2), (2, 3)] {
            let [p, q] = [a, b].map(|vertex: usize| {
                ga_runtime::cga3::Point::from(primitive.positions[vertex].map(f64::from))
            });
            assert_relative(placed[a].distance(placed[b]), factor * p.distance(q), 1e-13);
        }
    }
}

/// Half way round a joint that turns by a half turn, the linear blend falls onto the axis and the
/// blends of motors keep the distance from it.
#[test]
fn motors_do_not_collapse() {
    let vertex = Primitive {
        positions: vec![[0.0, 1.0, 0.0]],
        joints: vec![vec![[0, 1, 0, 0]]],
        weights: vec![vec![[0.5, 0.5, 0.0, 0.0]]],
        ..Primitive::default()
    };
    let half_turn = Transform::Decomposed {
        translation: [0.0; 3],
        rotation: [1.0, 0.0, 0.0, 0.0],
        scale: [1.0; 3],
    };
    let document = Document {
        nodes: vec![
            Node {
                mesh: Some(0),
                skin: Some(0),
                ..Node::default()
            },
            Node::default(),
            Node {
                transform: half_turn,
                ..Node::default()
            },
        ],
        meshes: vec![Mesh {
            primitives: vec![vertex],
            ..Mesh::default()
        }],
        skins: vec![Skin {
            joints: vec![1, 2],
            ..Skin::default()
        }],
        ..Document::default()
    };
    for (method, height) in [
        (Method::Linear, 0.0),
        (Method::Motor, 1.0),
        (Method::DualQuaternion, 1.0),
    ] {
        let [x, y, z] = place(&document, None, 0.0, method).positions[0].coordinates();
        assert_eq!(x, 0.0);
        assert!((y.hypot(z) - height).abs() < 1e-15, "{method:?}");
    }
}

/// The mesh has the faces, lines and points of the primitives; a mirrored part has its faces
/// reversed; an object has the name of its node, of its mesh, or its number.
#[test]
fn the_mesh_has_what_the_primitives_form() {
    let positions = vec![
        [0.0, 0.0, 0.0],
        [1.0, 0.0, 0.0],
        [0.0, 1.0, 0.0],
        [1.0, 1.0, 0.0],
    ];
    let part = |mode, indices: &[u32]| Primitive {
        mode,
        positions: positions.clone(),
        indices: Some(indices.to_vec()),
        ..Primitive::default()
    };
    let unseen = Primitive {
        normals: vec![[0.0, 0.0, 1.0]; 3],
        ..Primitive::default()
    };
    let mesh = |name: Option<&str>, primitives| Mesh {
        name: name.map(ToOwned::to_owned),
        primitives,
        ..Mesh::default()
    };
    let node = |name: Option<&str>, mesh, scale| Node {
        name: name.map(ToOwned::to_owned),
        mesh: Some(mesh),
        transform: Transform::Decomposed {
            translation: [0.0; 3],
            rotation: [0.0, 0.0, 0.0, 1.0],
            scale,
        },
        ..Node::default()
    };
    let document = Document {
        nodes: vec![
            node(Some("plain"), 0, [1.0; 3]),
            node(None, 0, [-1.0, 1.0, 1.0]),
            node(None, 1, [1.0; 3]),
        ],
        meshes: vec![
            mesh(
                Some("strip"),
                vec![part(Mode::TriangleStrip, &[0, 1, 2, 3])],
            ),
            mesh(
                None,
                vec![
                    part(Mode::LineLoop, &[0, 1, 3]),
                    unseen,
                    part(Mode::Points, &[2]),
                ],
            ),
        ],
        ..Document::default()
    };
    let player = Player::new(&document).unwrap();
    let placement = Placement::new(&player).unwrap();
    let placed = placement
        .place(&player.pose(None, 0.0).unwrap(), Method::Linear)
        .unwrap();
    assert_eq!(placed.is_mirrored, [false, true, false, false, false]);
    let ranges: Vec<_> = placement
        .parts()
        .iter()
        .map(|part| part.vertices.clone())
        .collect();
    assert_eq!(ranges, [0..4, 4..8, 8..12, 12..12, 12..16]);
    let mesh = placement.mesh(&placed, |_| true).unwrap();
    assert_eq!(
        mesh.triangles(),
        [[0, 1, 2], [1, 3, 2], [4, 6, 5], [5, 6, 7]]
    );
    assert_eq!(mesh.polylines().get(0), Some(&[8, 9, 11, 8][..]));
    assert_eq!(mesh.points(), [14]);
    assert_eq!(mesh.coordinates().nth(5), Some([-1.0, 0.0, 0.0]));
    let objects: Vec<_> = mesh
        .objects()
        .iter()
        .map(|o| (o.name.as_str(), &o.faces[..]))
        .collect();
    assert_eq!(
        objects,
        [("plain", &[0, 1][..]), ("strip", &[2, 3]), ("node 2", &[])]
    );
}
