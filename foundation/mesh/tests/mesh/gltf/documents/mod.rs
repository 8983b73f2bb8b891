//! Documents of many shapes, written and read again.

mod choices;

use ga_mesh::gltf::*;
use ga_mesh::{AlphaMode, Filter, Minification, Wrap};
use proptest::prelude::*;

use choices::Choices;

/// A PNG file of one pixel.
pub(crate) const PNG: &[u8] = b"\x89PNG\x0d\x0a\x1a\x0a\0\0\0\x0dIHDR\0\0\0\x01\0\0\0\x01\x08\x02\0\0\0\x90\
\x77\x53\xde\0\0\0\x0cIDAT\x78\xda\x63\xf8\xdf\xa0\0\0\x04\x21\x01\xa0\x73\x42\xe1\x3c\0\0\0\0IEND\xae\x42\x60\x82";

/// A document that obeys the specification to the last warning of the validator: a root with
/// joints and loose nodes, and beside it a node with a skinned mesh.
fn document(choices: &[u32]) -> Document {
    let mut c = Choices(choices.iter());
    let c = &mut c;
    let (joints, materials) = (1 + c.below(300), c.below(3));
    let (targets, skinned_targets) = (c.below(3), c.below(2));
    let skinned = mesh(c, materials, skinned_targets, Some(joints));
    let loose = mesh(c, materials, targets, None);
    // Node 0 is above all joints but has no other part.
    let mut nodes = vec![Node::default()];
    for joint in 1..=joints {
        let parent = c.below(joint);
        nodes[parent].children.push(joint);
        nodes.push(node(c, true));
    }
    let camera = nodes.len();
    nodes[0].children.push(camera);
    nodes.push(Node {
        camera: Some(c.below(2)),
        mesh: Some(1),
        weights: (targets > 0 && c.yes()).then(|| c.list(targets, Choices::float)),
        ..node(c, false)
    });
    nodes.push(Node {
        mesh: Some(0),
        skin: Some(0),
        name: c.name(),
        extras: c.extras(),
        ..Node::default()
    });
    let count = c.below(3);
    let animations = c.list(count, |c| animation(c, joints, camera, targets));
    Document {
        asset: Asset {
            generator: Some("a test".to_owned()),
            copyright: c.name(),
            extras: c.extras(),
        },
        scene: c.yes().then_some(0),
        scenes: vec![Scene {
            name: c.name(),
            nodes: vec![0, nodes.len() - 1],
            extras: c.extras(),
        }],
        nodes,
        meshes: vec![skinned, loose],
        skins: vec![Skin {
            name: c.name(),
            joints: (1..=joints).collect(),
            inverse_bind_matrices: if c.yes() {
                c.list(joints, |c| {
                    let mut matrix: [f32; 16] = c.floats();
                    [matrix[3], matrix[7], matrix[11], matrix[15]] = [0.0, 0.0, 0.0, 1.0];
                    matrix
                })
            } else {
                Vec::new()
            },
            skeleton: c.yes().then_some(0),
            extras: c.extras(),
        }],
        animations,
        materials: c.list(materials, material),
        textures: vec![
            TextureElement {
                name: c.name(),
                sampler: c.yes().then_some(0),
                image: Some(0),
                extras: c.extras(),
            },
            TextureElement {
                image: Some(1),
                ..TextureElement::default()
            },
        ],
        samplers: vec![sampler(c)],
        images: vec![image(c), image(c)],
        cameras: vec![
            CameraElement {
                name: c.name(),
                projection: Projection::Perspective {
                    aspect_ratio: c.yes().then_some(1.5),
                    vertical_angle: 0.1 + c.fraction(),
                    near: 0.01 + c.fraction(),
                    far: c.yes().then_some(100.0),
                },
                extras: c.extras(),
            },
            CameraElement {
                name: None,
                projection: Projection::Orthographic {
                    half_width: 1.0 + c.fraction(),
                    half_height: 1.0,
                    near: c.fraction(),
                    far: 2.0 + c.fraction(),
                },
                extras: None,
            },
        ],
        extras: c.extras(),
        origin: Origin::default(),
    }
}

fn node(c: &mut Choices, is_animated: bool) -> Node {
    let transform = if !is_animated && c.yes() {
        Transform::Matrix([
            2.0,
            0.0,
            0.0,
            0.0,
            0.0,
            1.0,
            0.0,
            0.0,
            0.0,
            0.0,
            1.0,
            0.0,
            c.float(),
            0.5,
            0.25,
            1.0,
        ])
    } else {
        Transform::Decomposed {
            translation: c.floats(),
            rotation: c.unit(),
            scale: [c.fraction() + 0.1, 1.0, 2.0],
        }
    };
    Node {
        name: c.name(),
        transform,
        extras: c.extras(),
        ..Node::default()
    }
}

fn mesh(c: &mut Choices, materials: usize, targets: usize, joints: Option<usize>) -> Mesh {
    let count = 1 + c.below(3);
    Mesh {
        name: c.name(),
        primitives: c.list(count, |c| primitive(c, materials, targets, joints)),
        weights: if c.yes() {
            c.list(targets, Choices::float)
        } else {
            Vec::new()
        },
        extras: c.extras(),
    }
}

fn primitive(
    c: &mut Choices,
    materials: usize,
    targets: usize,
    joints: Option<usize>,
) -> Primitive {
    let vertices = 3 * (1 + c.below(4));
    let sets = if joints.is_some() { 1 + c.below(2) } else { 0 };
    let material = (materials > 0 && c.yes()).then(|| c.below(materials));
    // A material may have a texture of normals, for which there must be tangents.
    let has_normals = material.is_some() || c.yes();
    let influences: Vec<Vec<(u16, f32)>> =
        c.list(vertices, |c| influences(c, joints.unwrap_or(1), 4 * sets));
    let set_of = |set: usize, vertex: usize, slot: usize| {
        influences[vertex]
            .get(4 * set + slot)
            .copied()
            .unwrap_or((0, 0.0))
    };
    let table = |set: usize| {
        (0..vertices).map(move |vertex| std::array::from_fn(|slot| set_of(set, vertex, slot)))
    };
    let each = |c: &mut Choices, yes: bool| if yes { vertices } else { c.below(1) };
    let normals = each(c, has_normals);
    let tangents = if material.is_some() || has_normals && c.yes() {
        vertices
    } else {
        0
    };
    let colours = c.below(2);
    let custom = c.below(5);
    let indices = 3 * (1 + c.below(4));
    Primitive {
        mode: Mode::Triangles,
        positions: c.list(vertices, Choices::floats),
        normals: c.list(normals, Choices::unit),
        tangents: c.list(tangents, |c| {
            let [x, y, z] = c.unit();
            [x, y, z, if c.yes() { 1.0 } else { -1.0 }]
        }),
        texcoords: c.list(2, |c| c.list(vertices, Choices::floats)),
        colours: c.list(colours, |c| {
            c.list(vertices, |c| std::array::from_fn(|_| c.fraction()))
        }),
        joints: (0..sets)
            .map(|set| {
                table(set)
                    .map(|row: [(u16, f32); 4]| row.map(|i| i.0))
                    .collect()
            })
            .collect(),
        weights: (0..sets)
            .map(|set| {
                table(set)
                    .map(|row: [(u16, f32); 4]| row.map(|i| i.1))
                    .collect()
            })
            .collect(),
        custom: (0..custom)
            .map(|index| self::custom(c, index, vertices))
            .collect(),
        indices: c
            .yes()
            .then(|| c.list(indices, |c| c.below(vertices) as u32)),
        material,
        targets: c.list(targets, |c| MorphTarget {
            positions: c.list(vertices, Choices::floats),
            normals: c.list(normals, Choices::floats),
            tangents: c.list(tangents, Choices::floats),
            texcoords: Vec::new(),
            colours: Vec::new(),
            custom: Vec::new(),
        }),
        extras: c.extras(),
    }
}

/// Different joints with weights that sum to 1.
fn influences(c: &mut Choices, joints: usize, most: usize) -> Vec<(u16, f32)> {
    if most == 0 {
        return Vec::new();
    }
    let (count, first) = (1 + c.below(most.min(joints)), c.below(joints));
    let weights: Vec<f64> = c.list(count, |c| f64::from(c.fraction()) + 0.01);
    let sum: f64 = weights.iter().sum();
    let joint = |slot: usize| ((first + slot) % joints) as u16;
    weights
        .iter()
        .enumerate()
        .map(|(slot, weight)| (joint(slot), (weight / sum) as f32))
        .collect()
}

/// One attribute of each kind whose items are padded, or not, in different ways.
fn custom(c: &mut Choices, index: usize, vertices: usize) -> CustomAttribute {
    let shapes = [
        Shape::Vec3,
        Shape::Scalar,
        Shape::Mat3,
        Shape::Mat2,
        Shape::Mat4,
    ];
    let shape = shapes[index];
    let count = vertices * shape.components();
    let components = match index {
        0 => Components::U8(c.list(count, |c| c.number() as u8)),
        1 => Components::I16(c.list(count, |c| c.number() as i16)),
        2 => Components::U16(c.list(count, |c| c.number() as u16)),
        3 => Components::I8(c.list(count, |c| (c.number() as i8).max(-127))),
        _ => Components::F32(c.list(count, Choices::float)),
    };
    CustomAttribute {
        name: format!("_CUSTOM_{index}"),
        shape,
        normalized: index == 3,
        components,
    }
}

fn animation(c: &mut Choices, joints: usize, morphing: usize, targets: usize) -> Animation {
    let count = 1 + c.below(3);
    let mut channels = Vec::new();
    for number in 0..count.min(joints) {
        // Different joints, hence different targets.
        channels.push(channel(c, 1 + number, number % 3, 1));
    }
    if targets > 0 {
        channels.push(channel(c, morphing, 3, targets));
    }
    Animation {
        name: c.name(),
        channels,
        extras: c.extras(),
    }
}

fn channel(c: &mut Choices, node: usize, kind: usize, width: usize) -> Channel {
    let modes = [
        Interpolation::Linear,
        Interpolation::Step,
        Interpolation::CubicSpline,
    ];
    let interpolation = modes[c.below(3)];
    // A spline has at least two keys.
    let count = 2 + c.below(4);
    let mut time = 0.0;
    let times = c.list(count, |c| {
        time += c.fraction() + 0.01;
        time
    });
    let values = count * interpolation.values_per_key();
    let keys = match kind {
        0 => Keys::Rotation(c.list(values, Choices::unit)),
        1 => Keys::Translation(c.list(values, Choices::floats)),
        2 => Keys::Scale(c.list(values, Choices::floats)),
        _ => Keys::Weights(c.list(values * width, Choices::float)),
    };
    Channel {
        node,
        times,
        interpolation,
        keys,
        extras: c.extras(),
    }
}

fn material(c: &mut Choices) -> MaterialElement {
    let texture = |c: &mut Choices| {
        c.yes().then(|| TextureInfo {
            texture: c.below(2),
            texcoord: c.below(2) as u32,
            transform: c.yes().then(|| TextureTransform {
                offset: c.floats(),
                rotation: c.fraction(),
                scale: [1.0, c.fraction()],
                texcoord: c.yes().then_some(1),
            }),
        })
    };
    let (normal_texture, occlusion_texture) = (texture(c), texture(c));
    // The validator warns of an unlit surface with a strength of its light.
    let unlit = c.yes();
    MaterialElement {
        name: c.name(),
        base_colour: std::array::from_fn(|_| c.fraction()),
        base_colour_texture: texture(c),
        metallic: c.fraction(),
        roughness: c.fraction(),
        metallic_roughness_texture: texture(c),
        // Without the texture the number is not in the file.
        normal_scale: if normal_texture.is_some() {
            c.float()
        } else {
            1.0
        },
        normal_texture,
        occlusion_strength: if occlusion_texture.is_some() {
            c.fraction()
        } else {
            1.0
        },
        occlusion_texture,
        emissive: std::array::from_fn(|_| c.fraction()),
        emissive_strength: if unlit { 1.0 } else { 1.0 + c.fraction() },
        emissive_texture: texture(c),
        alpha_mode: match c.below(3) {
            0 => AlphaMode::Opaque,
            1 => AlphaMode::Blend,
            _ => AlphaMode::Mask {
                cutoff: c.fraction().into(),
            },
        },
        double_sided: c.yes(),
        unlit,
        extras: c.extras(),
    }
}

fn sampler(c: &mut Choices) -> Sampler {
    let filters = [Filter::Nearest, Filter::Linear];
    let wraps = [Wrap::Repeat, Wrap::MirroredRepeat, Wrap::ClampToEdge];
    Sampler {
        name: c.name(),
        magnification: c.yes().then(|| filters[c.below(2)]),
        minification: c.yes().then(|| Minification {
            filter: filters[c.below(2)],
            levels: c.yes().then(|| filters[c.below(2)]),
        }),
        wrap_u: wraps[c.below(3)],
        wrap_v: wraps[c.below(3)],
        extras: c.extras(),
    }
}

fn image(c: &mut Choices) -> Image {
    Image {
        name: c.name(),
        source: ImageSource::Bytes {
            media_type: "image/png".to_owned(),
            bytes: PNG.to_vec(),
        },
        extras: c.extras(),
    }
}

pub(crate) fn documents() -> impl Strategy<Value = Document> {
    prop::collection::vec(any::<u32>(), 0..4000).prop_map(|choices| document(&choices))
}

/// A document with everything in it, always the same.
pub(crate) fn example(seed: u32) -> Document {
    let mut state = seed;
    let mut next = || {
        // A linear congruential generator; its upper bits are good enough.
        state = state.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
        state ^ state >> 13
    };
    document(&(0..4000).map(|_| next()).collect::<Vec<_>>())
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(64))]

    /// Nothing is lost, as one file or as several.
    #[test]
    fn a_written_document_reads_as_it_was(document in documents()) {
        prop_assert_eq!(decode(&encode(&document).unwrap()).unwrap(), document.clone());
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("model.gltf");
        write(&path, &document).unwrap();
        let mut again = read(&path).unwrap();
        again.read_images(folder.path()).unwrap();
        prop_assert_eq!(again, document);
    }
}

/// Lists that are equal are in the file once.
#[test]
fn shared_lists_are_written_once() {
    let one = example(7);
    let mut two = one.clone();
    let copy = two.meshes[1].clone();
    two.meshes.push(copy);
    let [one, two] = [&one, &two].map(|document| encode(document).unwrap().len());
    assert!(two - one < 3000, "{one} {two}");
}
