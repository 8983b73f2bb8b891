//! An evaluator of GLB files that shares nothing with ga-anim and ga-mesh: the `gltf` crate reads,
//! and matrices of glam move.

use glam::{DMat4, DQuat, DVec3, DVec4, Mat4};
use gltf::animation::Interpolation;
use gltf::animation::util::ReadOutputs;
use gltf::scene::Transform;

/// The vertices of all nodes with meshes, by linear blend.
pub(super) fn vertices(file: &[u8], animation: Option<usize>, time: f64) -> Vec<DVec3> {
    let (document, buffers, _) = gltf::import_slice(file).unwrap();
    let data = |buffer: gltf::Buffer| Some(&buffers[buffer.index()][..]);
    let mut nodes: Vec<State> = document.nodes().map(|node| State::of(&node)).collect();
    if let Some(animation) = animation {
        for channel in document.animations().nth(animation).unwrap().channels() {
            apply(&channel, &channel.reader(data), time, &mut nodes);
        }
    }
    let mut parents = vec![None; nodes.len()];
    for node in document.nodes() {
        for child in node.children() {
            parents[child.index()] = Some(node.index());
        }
    }
    let world = |node: usize| {
        let chain = std::iter::successors(Some(node), |&node| parents[node]);
        chain.fold(DMat4::IDENTITY, |below, node| nodes[node].matrix() * below)
    };

    let mut all = Vec::new();
    for node in document.nodes() {
        let palette: Option<Vec<DMat4>> = node.skin().map(|skin| {
            let inverse = skin.reader(data).read_inverse_bind_matrices();
            let inverse: Option<Vec<_>> = inverse.map(Iterator::collect);
            let joint = |(index, joint): (usize, gltf::Node)| {
                let inverse = inverse.as_ref().map_or(DMat4::IDENTITY, |list| {
                    Mat4::from_cols_array_2d(&list[index]).as_dmat4()
                });
                world(joint.index()) * inverse
            };
            skin.joints().enumerate().map(joint).collect()
        });
        let primitives = node.mesh().into_iter().flat_map(|mesh| mesh.primitives());
        for primitive in primitives {
            let reader = primitive.reader(data);
            let mut places: Vec<DVec3> = reader.read_positions().unwrap().map(vector).collect();
            for (target, (displacements, _, _)) in reader.read_morph_targets().enumerate() {
                for (place, by) in places.iter_mut().zip(displacements.into_iter().flatten()) {
                    *place += nodes[node.index()].weights[target] * vector(by);
                }
            }
            let Some(palette) = &palette else {
                let matrix = world(node.index());
                all.extend(
                    places
                        .into_iter()
                        .map(|place| matrix.transform_point3(place)),
                );
                continue;
            };
            let mut sums = vec![(DVec3::ZERO, 0.0); places.len()];
            for set in 0.. {
                let Some(joints) = reader.read_joints(set) else {
                    break;
                };
                let weights = reader.read_weights(set).unwrap().into_f32();
                for (vertex, (joints, weights)) in joints.into_u16().zip(weights).enumerate() {
                    for (joint, weight) in joints.into_iter().zip(weights.map(f64::from)) {
                        let moved = palette[usize::from(joint)].transform_point3(places[vertex]);
                        sums[vertex].0 += moved * weight;
                        sums[vertex].1 += weight;
                    }
                }
            }
            all.extend(sums.into_iter().map(|(sum, weight)| sum / weight));
        }
    }
    all
}

/// What an animation changes of a node.
struct State {
    matrix: Option<DMat4>,
    translation: DVec3,
    rotation: DVec4,
    scale: DVec3,
    weights: Vec<f64>,
}

impl State {
    fn of(node: &gltf::Node) -> Self {
        let transform = node.transform();
        let matrix = match &transform {
            Transform::Matrix { matrix } => Some(Mat4::from_cols_array_2d(matrix).as_dmat4()),
            Transform::Decomposed { .. } => None,
        };
        let (translation, rotation, scale) = match transform {
            Transform::Matrix { .. } => ([0.0; 3], [0.0, 0.0, 0.0, 1.0], [1.0; 3]),
            Transform::Decomposed {
                translation,
                rotation,
                scale,
            } => (translation, rotation, scale),
        };
        let of_mesh = node.mesh();
        let targets = of_mesh.as_ref().and_then(|mesh| mesh.primitives().next());
        let targets = targets.map_or(0, |primitive| primitive.morph_targets().len());
        let of_mesh = of_mesh.as_ref().and_then(gltf::Mesh::weights);
        let weights = node.weights().or(of_mesh).unwrap_or_default();
        let mut weights: Vec<f64> = weights.iter().copied().map(f64::from).collect();
        weights.resize(targets, 0.0);
        Self {
            matrix,
            translation: vector(translation),
            rotation: DVec4::from(rotation.map(f64::from)),
            scale: vector(scale),
            weights,
        }
    }

    fn matrix(&self) -> DMat4 {
        let rotation = DQuat::from_vec4(self.rotation.normalize());
        let parts = DMat4::from_scale_rotation_translation(self.scale, rotation, self.translation);
        self.matrix.unwrap_or(parts)
    }
}

fn apply<'a, F>(
    channel: &gltf::animation::Channel<'a>,
    reader: &gltf::animation::Reader<'a, 'a, F>,
    time: f64,
    nodes: &mut [State],
) where
    F: Clone + Fn(gltf::Buffer<'a>) -> Option<&'a [u8]>,
{
    let times: Vec<f64> = reader.read_inputs().unwrap().map(f64::from).collect();
    let interpolation = channel.sampler().interpolation();
    let state = &mut nodes[channel.target().node().index()];
    match reader.read_outputs().unwrap() {
        ReadOutputs::Translations(keys) => {
            let keys: Vec<DVec4> = keys.map(|key| vector(key).extend(0.0)).collect();
            state.translation = at(&times, &keys, interpolation, false, time).truncate();
        }
        ReadOutputs::Scales(keys) => {
            let keys: Vec<DVec4> = keys.map(|key| vector(key).extend(0.0)).collect();
            state.scale = at(&times, &keys, interpolation, false, time).truncate();
        }
        ReadOutputs::Rotations(keys) => {
            let keys = keys.into_f32().map(|key| DVec4::from(key.map(f64::from)));
            state.rotation = at(&times, &keys.collect::<Vec<_>>(), interpolation, true, time);
        }
        ReadOutputs::MorphTargetWeights(keys) => {
            let keys: Vec<f64> = keys.into_f32().map(f64::from).collect();
            let count = state.weights.len();
            for (target, weight) in state.weights.iter_mut().enumerate() {
                let own = keys.iter().skip(target).step_by(count);
                let own: Vec<DVec4> = own.map(|&key| DVec4::splat(key)).collect();
                *weight = at(&times, &own, interpolation, false, time).x;
            }
        }
    }
}

/// The formulas of glTF 2.0, appendix C, as they stand there.
fn at(
    times: &[f64],
    keys: &[DVec4],
    interpolation: Interpolation,
    is_rotation: bool,
    time: f64,
) -> DVec4 {
    let value = |key: usize| match interpolation {
        Interpolation::CubicSpline => keys[3 * key + 1],
        _ => keys[key],
    };
    if time <= times[0] {
        return value(0);
    }
    let last = times.len() - 1;
    if time >= times[last] {
        return value(last);
    }
    let next = times.iter().position(|&key| key > time).unwrap();
    let (before, interval) = (next - 1, times[next] - times[next - 1]);
    let t = (time - times[before]) / interval;
    let (from, to) = (value(before), value(next));
    match interpolation {
        Interpolation::Step => from,
        Interpolation::Linear if is_rotation => {
            // The arc cosine of a dot product would not tell near keys apart.
            let to = to * from.dot(to).signum();
            let angle = 2.0 * (from - to).length().atan2((from + to).length());
            let weights = match angle > 0.0 {
                true => [(1.0 - t) * angle, t * angle].map(|part| part.sin() / angle.sin()),
                false => [1.0 - t, t],
            };
            from * weights[0] + to * weights[1]
        }
        Interpolation::Linear => from * (1.0 - t) + to * t,
        Interpolation::CubicSpline => {
            let (out_of, into) = (keys[3 * before + 2], keys[3 * next]);
            (2.0 * t.powi(3) - 3.0 * t.powi(2) + 1.0) * from
                + interval * (t.powi(3) - 2.0 * t.powi(2) + t) * out_of
                + (-2.0 * t.powi(3) + 3.0 * t.powi(2)) * to
                + interval * (t.powi(3) - t.powi(2)) * into
        }
    }
}

fn vector(coordinates: [f32; 3]) -> DVec3 {
    DVec3::from(coordinates.map(f64::from))
}
