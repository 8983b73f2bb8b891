//! Channels at any time, as appendix C of the specification has it, beside sampled channels and
//! skinned vertices from independent numpy code.

use ga_mesh::gltf::{self as ours, Channel, Interpolation, Keys, Vertices};
use glam::DQuat;
use nullcone_shared_data::shared;
use serde_json::Value;

use super::samples::posed;

/// The value of a channel at a time in seconds.
pub(crate) fn sample(channel: &Channel, seconds: f64) -> Vec<f64> {
    let width = channel.keys.width();
    let per_key = channel.interpolation.values_per_key();
    let values = channel.keys.numbers();
    let is_rotation = matches!(channel.keys, Keys::Rotation(_));
    // Which of the values of a key: 0 or, of a spline, 0 to 2.
    let value = |key: usize, which: usize| -> Vec<f64> {
        let start = (key * per_key + which) * width;
        values[start..start + width]
            .iter()
            .map(|&c| f64::from(c))
            .collect()
    };
    let of_key = |key: usize| value(key, per_key / 2);
    let times: Vec<f64> = channel.times.iter().map(|&t| f64::from(t)).collect();
    let last = times.len() - 1;
    let next = times.partition_point(|&time| time <= seconds);
    if next == 0 || next > last {
        return of_key(if next == 0 { 0 } else { last });
    }
    let (key, step) = (next - 1, times[next] - times[next - 1]);
    let t = (seconds - times[key]) / step;
    let sampled: Vec<f64> = match channel.interpolation {
        Interpolation::Step => of_key(key),
        Interpolation::Linear if is_rotation => slerp(&of_key(key), &of_key(next), t),
        Interpolation::Linear => {
            let pairs = of_key(key).into_iter().zip(of_key(next));
            pairs.map(|(a, b)| a + t * (b - a)).collect()
        }
        Interpolation::CubicSpline => {
            let (t2, t3) = (t * t, t * t * t);
            let terms = [
                (2.0 * t3 - 3.0 * t2 + 1.0, value(key, 1)),
                (step * (t3 - 2.0 * t2 + t), value(key, 2)),
                (-2.0 * t3 + 3.0 * t2, value(next, 1)),
                (step * (t3 - t2), value(next, 0)),
            ];
            let at = |i: usize| terms.iter().map(|(factor, v)| factor * v[i]).sum();
            (0..width).map(at).collect()
        }
    };
    if is_rotation {
        return DQuat::from_slice(&sampled).normalize().to_array().to_vec();
    }
    sampled
}

/// Section C.4: along the shorter arc, of keys as they are, whatever their length.
fn slerp(a: &[f64], b: &[f64], t: f64) -> Vec<f64> {
    let dot: f64 = a.iter().zip(b).map(|(a, b)| a * b).sum();
    let angle = dot.abs().min(1.0).acos();
    if angle == 0.0 {
        return a.to_vec();
    }
    let from = ((1.0 - t) * angle).sin() / angle.sin();
    let to = (t * angle).sin() / angle.sin() * dot.signum();
    a.iter().zip(b).map(|(a, b)| from * a + to * b).collect()
}

fn oracle(name: &str) -> Option<Value> {
    let path = shared(&format!("oracle/anim/{name}.json"))?;
    Some(serde_json::from_slice(&std::fs::read(path).unwrap()).unwrap())
}

fn numbers(value: &Value) -> Vec<f64> {
    let numbers = value.as_array().unwrap().iter();
    numbers.map(|number| number.as_f64().unwrap()).collect()
}

#[test]
fn keys_give_the_sampled_channels() {
    let Some(oracle) = oracle("samplers") else {
        return;
    };
    let mut count = 0;
    let files = oracle.as_object().unwrap().iter();
    for (file, channels) in files.filter(|(file, _)| file.starts_with("gltf/")) {
        let document = ours::read(shared(&format!("data/anim/{file}")).unwrap()).unwrap();
        for expected in channels.as_array().unwrap() {
            let index = |key: &str| expected[key].as_u64().unwrap() as usize;
            let channel = &document.animations[index("animation")].channels[index("channel")];
            assert_eq!(channel.node, index("node"));
            assert_eq!(channel.keys.path(), expected["path"]);
            let values = expected["value"].as_array().unwrap();
            for (time, value) in numbers(&expected["t"]).into_iter().zip(values) {
                let (found, expected) = (sample(channel, time), numbers(value));
                let dot: f64 = found.iter().zip(&expected).map(|(a, b)| a * b).sum();
                // Both signs of a quaternion are one rotation.
                let is_rotation = matches!(channel.keys, Keys::Rotation(_));
                let sign = if is_rotation && dot < 0.0 { -1.0 } else { 1.0 };
                for (found, expected) in found.iter().zip(expected) {
                    let error = (found - sign * expected).abs();
                    assert!(
                        error <= 1e-6 * (1.0 + expected.abs()),
                        "{file} at {time}: {error}"
                    );
                }
                count += 1;
            }
        }
    }
    assert!(count > 400, "{count}");
}

/// Joints and skinned vertices of every sampled pose, through the document's own matrices.
#[test]
fn posed_skins_give_the_sampled_vertices() {
    let Some(oracle) = oracle("skin") else {
        return;
    };
    let mut count = 0;
    for (file, cases) in oracle["files"].as_object().unwrap() {
        let document = ours::read(shared(&format!("data/anim/{file}")).unwrap()).unwrap();
        for case in cases.as_array().unwrap() {
            let index = |key: &str| case[key].as_u64().unwrap() as usize;
            let posed = posed(&document, index("animation"), case["t"].as_f64().unwrap());
            let matrices = posed.world_matrices().unwrap();
            let mesh = posed.to_mesh(Vertices::Kept).unwrap();
            assert_eq!(mesh.vertex_count(), index("vertices"));
            let bounds = mesh.bounds().unwrap();
            let size = bounds
                .as_flattened()
                .iter()
                .fold(1.0f64, |s, c| s.max(c.abs()));
            let skin = &posed.skins[posed.nodes[index("node")].skin.unwrap()];
            let frames = case["joint_world"].as_array().unwrap();
            for (&joint, expected) in skin.joints.iter().zip(frames) {
                for (found, expected) in matrices[joint].iter().zip(expected.as_array().unwrap()) {
                    for (column, expected) in numbers(expected).into_iter().enumerate() {
                        let unit = if column == 3 { size } else { 1.0 };
                        let error = (found[column] - expected).abs();
                        assert!(error <= 1e-5 * unit, "{file}, joint {joint}: {error}");
                    }
                }
            }
            let expected = case["lbs"].as_array().unwrap();
            for (vertex, expected) in numbers(&case["index"]).into_iter().zip(expected) {
                let found = mesh.positions()[vertex as usize].coordinates();
                for (found, expected) in found.into_iter().zip(numbers(expected)) {
                    assert!(
                        (found - expected).abs() <= 1e-5 * size,
                        "{file}: {found} {expected}"
                    );
                    count += 1;
                }
            }
        }
    }
    assert!(count > 10_000, "{count}");
}
