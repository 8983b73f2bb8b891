//! Files whose numbers are integers, sparse or shared between accessors: what is read from them
//! must be what the same file says in plain single precision.

use ga_anim::gltf::{Placement, Player};
use ga_anim::skin::Method;
use ga_mesh::gltf::decode;
use serde_json::{Value, json};

use super::reference;
use crate::assert_relative;

/// A GLB file under construction.
#[derive(Default)]
struct Builder {
    bytes: Vec<u8>,
    views: Vec<Value>,
    accessors: Vec<Value>,
}

impl Builder {
    fn view(&mut self, bytes: impl IntoIterator<Item = u8>) -> usize {
        let start = self.bytes.len();
        self.bytes.extend(bytes);
        let length = self.bytes.len() - start;
        self.bytes.resize(self.bytes.len().next_multiple_of(4), 0);
        let view = json!({"buffer": 0, "byteOffset": start, "byteLength": length});
        self.views.push(view);
        self.views.len() - 1
    }

    fn accessor(&mut self, shape: &str, code: u32, count: usize, rest: Value) -> usize {
        let mut accessor = json!({"type": shape, "componentType": code, "count": count});
        let fields = accessor.as_object_mut().unwrap();
        fields.extend(rest.as_object().unwrap().clone());
        self.accessors.push(accessor);
        self.accessors.len() - 1
    }

    fn floats(&mut self, shape: &str, width: usize, numbers: &[f32]) -> usize {
        let view = self.view(numbers.iter().flat_map(|number| number.to_le_bytes()));
        // Positions must state their bounds.
        let bound = |f: fn(f32, f32) -> f32| -> Vec<f32> {
            let axis = |axis: usize| numbers.iter().skip(axis).step_by(width).copied();
            (0..width).map(|k| axis(k).reduce(f).unwrap()).collect()
        };
        let rest = json!({"bufferView": view, "min": bound(f32::min), "max": bound(f32::max)});
        self.accessor(shape, 5126, numbers.len() / width, rest)
    }

    /// The accessor in which some items of another are replaced, or some of zeros.
    fn sparse(&mut self, base: Option<usize>, count: usize, at: &[u8], values: &[f32]) -> usize {
        let indices = self.view(at.iter().copied());
        let values = self.view(values.iter().flat_map(|number| number.to_le_bytes()));
        let mut rest = json!({"min": [-9, -9, -9], "max": [9, 9, 9], "sparse": {
            "count": at.len(),
            "indices": {"bufferView": indices, "componentType": 5121},
            "values": {"bufferView": values},
        }});
        if let Some(base) = base {
            rest["bufferView"] = self.accessors[base]["bufferView"].clone();
        }
        self.accessor("VEC3", 5126, count, rest)
    }

    fn finish(self, mut document: Value) -> Vec<u8> {
        document["asset"] = json!({"version": "2.0"});
        document["buffers"] = json!([{"byteLength": self.bytes.len()}]);
        document["bufferViews"] = self.views.into();
        document["accessors"] = self.accessors.into();
        let mut text = document.to_string().into_bytes();
        text.resize(text.len().next_multiple_of(4), b' ');
        let length = |bytes: &[u8]| (bytes.len() as u32).to_le_bytes();
        let chunk = |kind: &[u8], bytes: &[u8]| [&length(bytes)[..], kind, bytes].concat();
        let chunks = [chunk(b"JSON", &text), chunk(b"BIN\0", &self.bytes)].concat();
        let total = (12 + chunks.len() as u32).to_le_bytes();
        [b"glTF", &2u32.to_le_bytes()[..], &total, &chunks].concat()
    }
}

/// How the numbers of a file are stored.
#[derive(Clone, Copy, PartialEq)]
enum Form {
    Integers,
    Floats,
}

/// Two joints, of which one rotates and one has eight influences on the vertices beside it; a morph
/// target whose weight moves.
fn file(form: Form) -> Vec<u8> {
    let mut builder = Builder::default();
    let b = &mut builder;
    let is_plain = form == Form::Floats;
    let base = [0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.5, 0.5, 2.0];
    let plain_base = b.floats("VEC3", 3, &base);
    let positions = if is_plain {
        let mut full = base;
        full[3..6].copy_from_slice(&[1.5, -0.5, 0.25]);
        full[9..12].copy_from_slice(&[0.25, 2.0, 3.0]);
        b.floats("VEC3", 3, &full)
    } else {
        b.sparse(
            Some(plain_base),
            4,
            &[1, 3],
            &[1.5, -0.5, 0.25, 0.25, 2.0, 3.0],
        )
    };
    // Displacements that are zero but for one vertex.
    let target = if is_plain {
        let mut full = [0.0; 12];
        full[6..9].copy_from_slice(&[0.0, 0.25, 1.0]);
        b.floats("VEC3", 3, &full)
    } else {
        b.sparse(None, 4, &[2], &[0.0, 0.25, 1.0])
    };
    let joints_0 = b.view([0, 1, 2, 0].repeat(4));
    let joints_0 = b.accessor("VEC4", 5121, 4, json!({"bufferView": joints_0}));
    let joints_1 = b.view(
        [3u16, 4, 0, 0]
            .repeat(4)
            .iter()
            .flat_map(|j| j.to_le_bytes()),
    );
    let joints_1 = b.accessor("VEC4", 5123, 4, json!({"bufferView": joints_1}));
    let first: Vec<u8> = (0..16).map(|k| (40 + 13 * k) as u8).collect();
    let second: Vec<u16> = (0..16).map(|k| 65_535 - 4000 * k).collect();
    let keys: Vec<i16> = vec![
        0, 0, 0, 32_767, -32_768, 0, 0, 100, 12_000, -20_000, 15_000, 17_000,
    ];
    let few: Vec<i8> = vec![0, 0, 0, 127, 0, -128, 3, 5, 60, 60, -60, 70];
    let amounts: Vec<u8> = vec![0, 255, 51];
    let (weights_0, weights_1, rotations, coarse, morph);
    if is_plain {
        let fractions = |list: &[f32], greatest: f32| -> Vec<f32> {
            list.iter().map(|&x| (x / greatest).max(-1.0)).collect()
        };
        let of = |list: Vec<f32>, greatest| fractions(&list, greatest);
        let numbers = of(first.iter().map(|&x| x.into()).collect(), 255.0);
        weights_0 = b.floats("VEC4", 4, &numbers);
        let numbers = of(second.iter().map(|&x| x.into()).collect(), 65_535.0);
        weights_1 = b.floats("VEC4", 4, &numbers);
        let numbers = of(keys.iter().map(|&x| x.into()).collect(), 32_767.0);
        rotations = b.floats("VEC4", 4, &numbers);
        let numbers = of(few.iter().map(|&x| x.into()).collect(), 127.0);
        coarse = b.floats("VEC4", 4, &numbers);
        let numbers = of(amounts.iter().map(|&x| x.into()).collect(), 255.0);
        morph = b.floats("SCALAR", 1, &numbers);
    } else {
        let normalised = |view: usize| json!({"bufferView": view, "normalized": true});
        let view = b.view(first);
        weights_0 = b.accessor("VEC4", 5121, 4, normalised(view));
        let view = b.view(second.iter().flat_map(|x| x.to_le_bytes()));
        weights_1 = b.accessor("VEC4", 5123, 4, normalised(view));
        let view = b.view(keys.iter().flat_map(|x| x.to_le_bytes()));
        rotations = b.accessor("VEC4", 5122, 3, normalised(view));
        let view = b.view(few.iter().map(|&x| x as u8));
        coarse = b.accessor("VEC4", 5120, 3, normalised(view));
        let view = b.view(amounts);
        morph = b.accessor("SCALAR", 5121, 3, normalised(view));
    }
    let times = b.floats("SCALAR", 1, &[0.0, 0.5, 2.0]);
    let channel = |sampler: usize, node: usize, path: &str| json!({"sampler": sampler, "target": {"node": node, "path": path}});
    let sampler = |output: usize| json!({"input": times, "output": output});
    builder.finish(json!({
        "nodes": [
            {"mesh": 0, "skin": 0, "scale": [9, 9, 9]},
            {"children": [2], "translation": [0, 1, 0], "scale": [1, 2, -0.5]},
            {"children": [3], "translation": [1, 0, 0]},
            {"children": [4, 5], "rotation": [0.6, 0, 0, 0.8]},
            {"translation": [0, 0, 0.5]},
            {"matrix": [0, 2, 0, 0, -1, 0, 0, 0, 0.5, 0, 1, 0, 3, 2, 1, 1]}
        ],
        "meshes": [{"primitives": [{
            "attributes": {
                "POSITION": positions, "JOINTS_0": joints_0, "JOINTS_1": joints_1,
                "WEIGHTS_0": weights_0, "WEIGHTS_1": weights_1,
            },
            "targets": [{"POSITION": target}],
        }]}],
        "skins": [{"joints": [1, 2, 3, 4, 5]}],
        "animations": [{
            "channels": [
                channel(0, 2, "rotation"), channel(1, 1, "rotation"), channel(2, 0, "weights"),
            ],
            "samplers": [sampler(rotations), sampler(coarse), sampler(morph)],
        }],
    }))
}

#[test]
fn integers_and_sparse_numbers_mean_what_floats_mean() {
    let [integers, floats] = [Form::Integers, Form::Floats].map(file);
    let [parsed, plain] = [&integers, &floats].map(|file| decode(file).unwrap());
    assert_eq!(parsed.meshes, plain.meshes);
    assert_eq!(parsed.animations, plain.animations);
    for time in [-1.0, 0.0, 0.3, 0.5, 1.1, 2.0, 5.0] {
        let player = Player::new(&parsed).unwrap();
        let placement = Placement::new(&player).unwrap();
        let pose = player.pose(Some(0), time).unwrap();
        let placed = placement.place(&pose, Method::Linear).unwrap();
        // The `gltf` crate multiplies by a rounded reciprocal of the greatest integer.
        for (file, bound) in [(&floats, 1e-12), (&integers, 1e-6)] {
            let expected = reference::vertices(file, Some(0), time);
            assert_eq!(placed.positions.len(), expected.len());
            for (found, expected) in placed.positions.iter().zip(expected) {
                for (found, expected) in found.coordinates().into_iter().zip(expected.to_array()) {
                    assert_relative(found, expected, bound);
                }
            }
        }
    }
}
