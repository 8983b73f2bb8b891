//! Written files, read back by an independent reader and evaluated with the matrices of glam.

mod accessors;
mod bad_input;
mod convert;
mod documents;
mod draco;
mod errors;
mod kept;
mod morph_targets;
mod mutations;
mod plain;
mod reader;
mod sampler;
mod samples;
mod source;
mod validator;

use ga_mesh::gltf::Transform;
use ga_mesh::gltf::model::{Dielectric, Model, encode};
use gltf::animation::util::ReadOutputs;
use proptest::prelude::*;

use reader::Read;
use source::{Rigid, Vector, source, strip};

fn assert_near(a: &[Vector], b: &[Vector], tolerance: f64) {
    assert_eq!(a.len(), b.len());
    for (vertex, (a, b)) in a.iter().zip(b).enumerate() {
        for axis in 0..3 {
            let error = (a[axis] - b[axis]).abs();
            assert!(error <= tolerance, "vertex {vertex}: {a:?} is not {b:?}");
        }
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(128))]

    /// At rest the mesh is where it was; at every key it is where the joints put it.
    #[test]
    fn a_reader_skins_as_the_source_does(source in source(1..14)) {
        let read = Read::new(&source.write().unwrap());
        // Up to fourteen joints in a chain, a metre each, in single precision.
        let tolerance = 3e-5;
        assert_near(&read.skinned(None), &source.positions, tolerance);
        for (index, animation) in source.animations.iter().enumerate() {
            for key in 0..animation.times.len() {
                let expected = source.skinned(&source.pose(index, key));
                assert_near(&read.skinned(Some((index, key))), &expected, tolerance);
            }
        }
    }

    /// What the specification asks of vertex data, and what it asks of animations.
    #[test]
    fn numbers_obey_the_specification(source in source(1..14)) {
        let read = Read::new(&source.write().unwrap());
        let primitive = read.primitive();
        let reader = primitive.reader(|b| read.data(b));

        let bounds = primitive.bounding_box();
        let column = |axis: usize| source.positions.iter().map(move |p| p[axis] as f32);
        for axis in 0..3 {
            prop_assert_eq!(bounds.min[axis], column(axis).fold(f32::INFINITY, f32::min));
            prop_assert_eq!(bounds.max[axis], column(axis).fold(f32::NEG_INFINITY, f32::max));
        }
        for normal in reader.read_normals().unwrap() {
            let length = normal.map(f64::from).iter().map(|c| c * c).sum::<f64>().sqrt();
            prop_assert!((length - 1.0).abs() < 1e-6);
        }
        let kept: Vec<u32> = source
            .triangles
            .iter()
            .filter(|[a, b, c]| a != b && b != c && c != a)
            .flatten()
            .copied()
            .collect();
        prop_assert_eq!(reader.read_indices().unwrap().into_u32().collect::<Vec<_>>(), kept);

        let sets = read.influence_sets();
        let most = source.weights.iter().map(Vec::len).max().unwrap();
        prop_assert_eq!(sets.len(), most.div_ceil(4));
        for (vertex, expected) in source.weights.iter().enumerate() {
            let slots = sets.iter().flat_map(|(joints, weights)| joints[vertex].into_iter().zip(weights[vertex]));
            let (used, unused): (Vec<_>, Vec<_>) = slots.partition(|&(_, weight)| weight != 0.0);
            prop_assert!(unused.iter().all(|&(joint, _)| joint == 0));
            prop_assert!(used.is_sorted_by(|a, b| a.1 >= b.1));
            let sum: f64 = used.iter().map(|&(_, weight)| f64::from(weight)).sum();
            prop_assert!((sum - 1.0).abs() < 3.1e-8, "{}", sum);
            for &(joint, expected) in expected {
                let found = used.iter().find(|&&(found, _)| u32::from(found) == joint);
                let weight = found.map_or(0.0, |&(_, weight)| f64::from(weight));
                prop_assert!((weight - expected).abs() < 1e-6);
            }
        }

        for (animation, expected) in read.document.animations().zip(&source.animations) {
            for channel in animation.channels() {
                let reader = channel.reader(|b| read.data(b));
                let times: Vec<f32> = reader.read_inputs().unwrap().collect();
                prop_assert_eq!(&times, &expected.times.iter().map(|&t| t as f32).collect::<Vec<_>>());
                if let ReadOutputs::Rotations(outputs) = reader.read_outputs().unwrap() {
                    let keys: Vec<[f64; 4]> = outputs.into_f32().map(|q| q.map(f64::from)).collect();
                    let dot = |a: &[f64; 4], b: &[f64; 4]| (0..4).map(|i| a[i] * b[i]).sum::<f64>();
                    prop_assert!(keys.iter().all(|q| (dot(q, q) - 1.0).abs() < 1e-6));
                    prop_assert!(keys.windows(2).all(|pair| dot(&pair[0], &pair[1]) >= -1e-6));
                }
            }
        }
    }

    /// The container: lengths, chunk kinds and padding.
    #[test]
    fn the_container_is_aligned(source in source(1..5)) {
        let file = source.write().unwrap();
        let word = |at: usize| u32::from_le_bytes(file[at..at + 4].try_into().unwrap()) as usize;
        prop_assert_eq!(&file[..4], b"glTF");
        prop_assert_eq!((word(4), word(8)), (2, file.len()));
        let json = word(12);
        prop_assert_eq!((json % 4, &file[16..20]), (0, &b"JSON"[..]));
        let binary = word(20 + json);
        prop_assert_eq!((binary % 4, &file[24 + json..28 + json]), (0, &b"BIN\0"[..]));
        prop_assert_eq!(28 + json + binary, file.len());
        let document: serde_json::Value = serde_json::from_slice(&file[20..20 + json]).unwrap();
        prop_assert_eq!(&document["asset"]["generator"], "Nullcone");
        for accessor in document["accessors"].as_array().unwrap() {
            prop_assert_eq!(accessor["byteOffset"].as_u64().unwrap() % 4, 0);
        }
    }
}

#[test]
fn the_first_vertex_of_a_strip_swings_as_worked_out_by_hand() {
    let mut source = strip(1, 4, 1, 2);
    // A quarter turn about z at (0.1, 0, 0) takes the origin to (0.1, −0.1, 0).
    let quarter = std::f64::consts::FRAC_PI_4;
    source.animations[0].tracks[0].keys[1] = Rigid {
        rotation: [0.0, 0.0, quarter.sin(), quarter.cos()],
        translation: [0.1, 0.0, 0.0],
    };
    let read = Read::new(&source.write().unwrap());
    assert_near(&read.skinned(Some((0, 1)))[..1], &[[0.1, -0.1, 0.0]], 1e-7);
}

#[test]
fn only_joints_that_move_have_channels() {
    let mut source = strip(3, 8, 2, 4);
    let rest = |joint: usize| vec![source.joints[joint].rest; 4];
    let (still, mut flipped) = (rest(1), rest(2));
    // The other sign is the same rotation.
    flipped[2].rotation = [0.0, 0.0, 0.0, -1.0];
    source.animations[0].tracks[1].keys = still;
    source.animations[0].tracks[2].keys = flipped;
    let read = Read::new(&source.write().unwrap());
    let channels: Vec<_> = read
        .document
        .animations()
        .flat_map(|animation| {
            animation
                .channels()
                .map(|c| (c.target().node().index(), c.target().property()))
                .collect::<Vec<_>>()
        })
        .collect();
    use gltf::animation::Property::{Rotation, Translation};
    assert_eq!(channels, [(0, Rotation), (0, Translation)]);
}

#[test]
fn several_roots_get_a_node_above_them() {
    let mut source = strip(3, 8, 2, 2);
    source.joints[1].parent = None;
    let read = Read::new(&source.write().unwrap());
    let scene: Vec<_> = read
        .document
        .scenes()
        .next()
        .unwrap()
        .nodes()
        .map(|n| n.index())
        .collect();
    assert_eq!(scene, [3, 4]);
    let above: Vec<_> = read
        .document
        .nodes()
        .nth(3)
        .unwrap()
        .children()
        .map(|n| n.index())
        .collect();
    assert_eq!(above, [0, 1]);
    assert_near(&read.skinned(None), &source.positions, 1e-6);
}

#[test]
fn plaster_is_the_linear_light_of_its_srgb_colour() {
    for (found, code) in Dielectric::default()
        .base_colour
        .into_iter()
        .zip([214.0, 203.0, 190.0])
    {
        // IEC 61966-2-1.
        let expected = ((code / 255.0 + 0.055) / 1.055f64).powf(2.4);
        assert!((found - expected).abs() < 1e-15);
    }
}

#[test]
fn a_mesh_without_a_skin_is_written_alone() {
    let source = strip(1, 6, 1, 1);
    let built = source.build();
    let model = Model {
        skin: None,
        animations: &[],
        ..built.model()
    };
    let read = Read::new(&encode(&model).unwrap());
    assert_eq!(
        read.document.skins().len() + read.document.animations().len(),
        0
    );
    assert_eq!(read.influence_sets(), []);
    assert_eq!(read.document.nodes().len(), 1);
}

/// The smallest integer types that hold the numbers, on both sides of each limit.
#[test]
fn indices_and_joints_are_as_wide_as_they_must_be() {
    use gltf::accessor::DataType;
    for (vertices, joints, index_type, joint_type) in [
        (65_535, 256, DataType::U16, DataType::U8),
        (65_536, 257, DataType::U32, DataType::U16),
    ] {
        let source = strip(joints, vertices, 5, 1);
        let read = Read::new(&source.write().unwrap());
        let primitive = read.primitive();
        assert_eq!(primitive.indices().unwrap().data_type(), index_type);
        let highest = primitive
            .reader(|b| read.data(b))
            .read_indices()
            .unwrap()
            .into_u32()
            .max();
        assert_eq!(highest, Some(vertices as u32 - 1));
        assert_eq!(
            primitive
                .get(&gltf::Semantic::Joints(1))
                .unwrap()
                .data_type(),
            joint_type
        );
        let (joints_read, _) = &read.influence_sets()[0];
        assert_eq!(
            joints_read.iter().flatten().max(),
            Some(&(joints as u16 - 1))
        );
    }
}

/// Columns of the matrix are the rotated and scaled axes and the translation; a quaternion may have
/// any length.
#[test]
fn a_transform_scales_rotates_and_translates() {
    let half = 0.5f32.sqrt();
    for length in [1.0, 0.25, 3.0] {
        // A quarter about z takes x to y and y to −x.
        let transform = Transform::Decomposed {
            translation: [7.0, 8.0, 9.0],
            rotation: [0.0, 0.0, half, half].map(|part| part * length),
            scale: [2.0, 3.0, 5.0],
        };
        let expected = [
            [0.0, -3.0, 0.0, 7.0],
            [2.0, 0.0, 0.0, 8.0],
            [0.0, 0.0, 5.0, 9.0],
        ];
        for (found, expected) in transform
            .to_matrix()
            .iter()
            .flatten()
            .zip(expected.as_flattened())
        {
            assert!(
                (found - expected).abs() < 1e-6,
                "{length}: {found} {expected}"
            );
        }
    }
    // The same rotation about a slanted axis, by a third of a whole, permutes the axes.
    let third = Transform::Decomposed {
        translation: [0.0; 3],
        rotation: [1.0; 4],
        scale: [1.0; 3],
    };
    let expected = [[0.0, 0.0, 1.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]];
    for (found, expected) in third.to_matrix().iter().zip(expected) {
        assert_eq!(found[..3], expected);
    }
}
