//! The sample files, beside an independent reader.

use std::path::{Path, PathBuf};

use ga_mesh::gltf::{self as ours, Document, ImageSource, Keys, Transform, Vertices};
use gltf::animation::util::ReadOutputs;
use nullcone_shared_data::shared;

/// Every glTF file of the shared data; empty where there is none.
pub(crate) fn samples() -> Vec<PathBuf> {
    let Some(folder) = shared("data/anim/gltf") else {
        return Vec::new();
    };
    let entries = std::fs::read_dir(folder).unwrap();
    let mut paths: Vec<PathBuf> = entries.map(|entry| entry.unwrap().path()).collect();
    paths.retain(|path| {
        matches!(
            path.extension().and_then(|e| e.to_str()),
            Some("gltf" | "glb")
        )
    });
    paths.sort();
    assert!(paths.len() >= 6);
    paths
}

/// The numbers of every primitive, skin and channel are those that the crate gltf reads.
#[test]
fn every_sample_reads_as_by_another_reader() {
    for path in samples() {
        let document = ours::read(&path).unwrap();
        let mut theirs = gltf::Gltf::open(&path).unwrap();
        let blob = theirs.blob.take();
        let buffers = gltf::import_buffers(&theirs, path.parent(), blob).unwrap();
        let data = |buffer: gltf::Buffer| Some(&buffers[buffer.index()][..]);

        assert_eq!(document.nodes.len(), theirs.nodes().len());
        for (node, expected) in document.nodes.iter().zip(theirs.nodes()) {
            assert_eq!(node.name.as_deref(), expected.name());
            let children: Vec<usize> = expected.children().map(|node| node.index()).collect();
            assert_eq!(node.children, children);
            assert_eq!(node.mesh, expected.mesh().map(|mesh| mesh.index()));
            assert_eq!(node.skin, expected.skin().map(|skin| skin.index()));
            let (found, columns) = (node.transform.to_matrix(), expected.transform().matrix());
            for row in 0..3 {
                for column in 0..4 {
                    let expected = f64::from(columns[column][row]);
                    let size = 1.0 + expected.abs();
                    assert!((found[row][column] - expected).abs() < 1e-6 * size);
                }
            }
        }
        assert_eq!(document.meshes.len(), theirs.meshes().len());
        for (mesh, expected) in document.meshes.iter().zip(theirs.meshes()) {
            assert_eq!(mesh.primitives.len(), expected.primitives().len());
            for (primitive, expected) in mesh.primitives.iter().zip(expected.primitives()) {
                let reader = expected.reader(data);
                assert!(
                    reader
                        .read_positions()
                        .unwrap()
                        .eq(primitive.positions.iter().copied())
                );
                let normals = reader.read_normals().into_iter().flatten();
                assert!(normals.eq(primitive.normals.iter().copied()));
                let indices = reader.read_indices().map(|i| i.into_u32().collect());
                assert_eq!(primitive.indices, indices);
                assert_eq!(primitive.material, expected.material().index());
                for (set, found) in primitive.texcoords.iter().enumerate() {
                    let expected = reader.read_tex_coords(set as u32).unwrap().into_f32();
                    assert!(expected.eq(found.iter().copied()));
                }
                for (set, found) in primitive.joints.iter().enumerate() {
                    let expected = reader.read_joints(set as u32).unwrap().into_u16();
                    assert!(expected.eq(found.iter().copied()));
                }
                for (set, found) in primitive.weights.iter().enumerate() {
                    let expected = reader.read_weights(set as u32).unwrap().into_f32();
                    assert!(expected.eq(found.iter().copied()));
                }
            }
        }
        for (skin, expected) in document.skins.iter().zip(theirs.skins()) {
            let joints: Vec<usize> = expected.joints().map(|joint| joint.index()).collect();
            assert_eq!(skin.joints, joints);
            let matrices = expected.reader(data).read_inverse_bind_matrices().unwrap();
            let flat = |columns: [[f32; 4]; 4]| columns.as_flattened().try_into().unwrap();
            let matrices: Vec<[f32; 16]> = matrices.map(flat).collect();
            assert_eq!(skin.inverse_bind_matrices, matrices);
        }
        assert_eq!(document.animations.len(), theirs.animations().len());
        for (animation, expected) in document.animations.iter().zip(theirs.animations()) {
            assert_eq!(animation.channels.len(), expected.channels().count());
            for (channel, expected) in animation.channels.iter().zip(expected.channels()) {
                assert_eq!(channel.node, expected.target().node().index());
                let reader = expected.reader(data);
                assert!(
                    reader
                        .read_inputs()
                        .unwrap()
                        .eq(channel.times.iter().copied())
                );
                let keys = match reader.read_outputs().unwrap() {
                    ReadOutputs::Translations(keys) => Keys::Translation(keys.collect()),
                    ReadOutputs::Rotations(keys) => Keys::Rotation(keys.into_f32().collect()),
                    ReadOutputs::Scales(keys) => Keys::Scale(keys.collect()),
                    ReadOutputs::MorphTargetWeights(keys) => {
                        Keys::Weights(keys.into_f32().collect())
                    }
                };
                assert_eq!(channel.keys, keys);
            }
        }
    }
}

/// Every vertex, weight and key, and all the rest.
#[test]
fn every_sample_survives_writing() {
    for path in samples() {
        let document = ours::read(&path).unwrap();
        let file = ours::encode(&document).unwrap();
        assert_eq!(ours::decode(&file).unwrap(), document, "{path:?}");

        let folder = tempfile::tempdir().unwrap();
        let copy = folder.path().join("copy of it.gltf");
        ours::write(&copy, &document).unwrap();
        let mut again = ours::read(&copy).unwrap();
        let had_files: Vec<bool> = document.images.iter().map(is_file).collect();
        for (image, had_file) in again.images.iter().zip(&had_files) {
            assert!(is_file(image) || *had_file);
        }
        if !had_files.contains(&true) {
            again.read_images(folder.path()).unwrap();
        }
        assert_eq!(again, document, "{path:?}");
    }
}

fn is_file(image: &ours::Image) -> bool {
    matches!(image.source, ImageSource::Uri(_))
}

/// Where every vertex is, and moves, is as before.
#[test]
fn a_conformed_document_has_the_same_shape() {
    for path in samples() {
        let document = ours::read(&path).unwrap();
        let conformed = document.conformed().unwrap();
        assert_eq!(conformed.conformed().unwrap(), conformed);
        for animation in 0..document.animations.len() {
            let [before, after] = [&document, &conformed].map(|document| {
                let posed = posed(document, animation, 0.37);
                posed.to_mesh(Vertices::Kept).unwrap()
            });
            // No sample has a mesh behind a skinned one, so that the vertices keep their order.
            assert_eq!(before.vertex_count(), after.vertex_count());
            let bounds = before.bounds().unwrap();
            let size = bounds
                .as_flattened()
                .iter()
                .fold(1.0f64, |s, c| s.max(c.abs()));
            for (before, after) in before.coordinates().zip(after.coordinates()) {
                for axis in 0..3 {
                    let error = (before[axis] - after[axis]).abs();
                    assert!(error <= 1e-6 * size, "{path:?}: {error}");
                }
            }
        }
    }
}

/// One sample names a picture that is not there. The document reads; only loading the picture
/// fails.
#[test]
fn a_missing_picture_is_named() {
    let Some(path) = shared("data/anim/gltf/interpolation_test.gltf") else {
        return;
    };
    let mut document = ours::read(&path).unwrap();
    let folder = path.parent().unwrap_or(Path::new(""));
    let error = document.read_images(folder).unwrap_err();
    let picture = folder.join("l.jpg");
    let expected = format!(
        "image 0: cannot read {}: entity not found",
        picture.display()
    );
    assert_eq!(error.to_string(), expected);
}

/// A document whose nodes have the transforms of an animation at a time, in seconds.
pub(crate) fn posed(document: &Document, animation: usize, seconds: f64) -> Document {
    let mut posed = document.clone();
    for channel in &document.animations[animation].channels {
        let value = super::sampler::sample(channel, seconds);
        let node = &mut posed.nodes[channel.node];
        let Transform::Decomposed {
            translation,
            rotation,
            scale,
        } = &mut node.transform
        else {
            panic!("an animated node has no matrix");
        };
        let single = |axis: usize| value[axis] as f32;
        match channel.keys {
            Keys::Translation(_) => *translation = std::array::from_fn(single),
            Keys::Rotation(_) => *rotation = std::array::from_fn(single),
            Keys::Scale(_) => *scale = std::array::from_fn(single),
            Keys::Weights(_) => {}
        }
    }
    posed
}
