//! Surfaces that follow captured points.

use std::path::Path;

use super::face::{
    FRAMES, NAMES, assert_near, capture, expression, folder, json, keys, obj, plain, pose, seen,
    strength, table, vertex, vertices,
};
use crate::common::{assert_success, number};

/// The vertices in the text of an OBJ file.
fn obj_vertices(folder: &Path, name: &str) -> Vec<[f64; 3]> {
    let text = std::fs::read_to_string(folder.join(name)).unwrap();
    let lines = text.lines().filter_map(|line| line.strip_prefix("v "));
    lines
        .map(|line| {
            let mut numbers = line.split_whitespace().map(|word| word.parse().unwrap());
            [(); 3].map(|()| numbers.next().unwrap())
        })
        .collect()
}

fn distance(a: [f64; 3], b: [f64; 3]) -> f64 {
    (0..3).map(|k| (a[k] - b[k]).powi(2)).sum::<f64>().sqrt()
}

#[test]
fn the_surface_follows_its_keys() {
    let folder = folder(&table(plain));
    let arguments = "--mesh face.obj --keys keys.csv --frame f2 --out face2.obj --out face.glb \
                     --out e.csv --json";
    let report = json(&capture(folder.path(), arguments));
    // One expression, more or less of it: one target.
    assert_eq!(number(&report, "/surface/morph_targets"), 1.0);
    assert!(number(&report, "/surface/morph_error_max_metres") < 1e-12);
    assert_eq!(number(&report, "/surface/folded_triangles"), 0.0);
    assert!(number(&report, "/surface/key_fit_rms_metres") < 1e-12);
    assert_near(&report["surface"]["sphere_centre_metres"], &[0.0; 3], 1e-12);
    let found = obj_vertices(folder.path(), "face2.obj");
    assert_eq!(found.len(), vertices().len());
    for (place, key) in seen(2).into_iter().zip(keys()) {
        assert!(distance(found[key], place) < 1e-9, "{key}");
    }
    // Independent reading of the animated model.
    let path = folder.path().join("face.glb");
    let (document, buffers, _) = gltf::import(path).unwrap();
    let mesh = document.meshes().next().unwrap();
    let primitive = mesh.primitives().next().unwrap();
    let reader = primitive.reader(|buffer| Some(&buffers[buffer.index()]));
    let rest: Vec<_> = reader.read_positions().unwrap().collect();
    let (targets, normals, _) = reader.read_morph_targets().next().unwrap();
    let target: Vec<_> = targets.unwrap().collect();
    assert_eq!(
        (rest.len(), target.len()),
        (vertices().len(), vertices().len())
    );
    assert_eq!(normals.unwrap().count(), rest.len());
    for (name, key) in NAMES.iter().zip(keys()) {
        let wanted = vertices()[key].map(|x| x as f32);
        let k = rest.iter().position(|place| *place == wanted).unwrap();
        for (found, truth) in target[k].into_iter().zip(expression(name)) {
            assert!((f64::from(found) - truth).abs() < 1e-8);
        }
    }
    let animation = document.animations().next().unwrap();
    let mut properties = 0;
    for channel in animation.channels() {
        use gltf::animation::util::ReadOutputs;
        let reader = channel.reader(|buffer| Some(&buffers[buffer.index()]));
        assert_eq!(reader.read_inputs().unwrap().count(), FRAMES);
        match reader.read_outputs().unwrap() {
            ReadOutputs::MorphTargetWeights(weights) => {
                for (frame, weight) in weights.into_f32().enumerate() {
                    assert!((f64::from(weight) - strength(frame)).abs() < 1e-6);
                }
            }
            ReadOutputs::Translations(places) => {
                for (frame, place) in places.enumerate() {
                    assert!(distance(place.map(f64::from), pose(frame).1) < 1e-6);
                }
            }
            ReadOutputs::Rotations(rotations) => {
                for (frame, [_, y, _, w]) in rotations.into_f32().enumerate() {
                    let (s, c) = (0.5 * pose(frame).0).sin_cos();
                    assert!((f64::from(y) - s).abs() + (f64::from(w) - c).abs() < 1e-6);
                }
            }
            ReadOutputs::Scales(_) => panic!("the size does not change"),
        }
        properties += 1;
    }
    assert_eq!(properties, 3);
}

/// A mesh in millimetres, upside down, with places of the keys in its own coordinates.
#[test]
fn the_mesh_may_have_its_own_coordinates() {
    let own = |[x, y, z]: [f64; 3]| [-1000.0 * x + 5.0, -1000.0 * y + 900.0, 1000.0 * z];
    let folder = folder(&table(plain));
    let mesh: Vec<_> = vertices().into_iter().map(own).collect();
    std::fs::write(folder.path().join("face.obj"), obj(&mesh)).unwrap();
    let rows: String = NAMES
        .iter()
        .zip(keys())
        .map(|(name, key)| {
            let [x, y, z] = own(vertices()[key]);
            format!("{name},{x},{y},{z}\n")
        })
        .collect();
    std::fs::write(
        folder.path().join("keys.csv"),
        format!("point,x,y,z\n{rows}"),
    )
    .unwrap();
    let start = "--mesh face.obj --keys keys.csv --frame f2";
    let there = format!("{start} --fit-scale --out there.obj --json");
    let report = json(&capture(folder.path(), &there));
    assert!(number(&report, "/surface/key_fit_rms_metres") < 1e-9);
    // Lengths are in metres whatever the unit of the mesh.
    let surface = &report["surface"];
    assert!((number(surface, "/metres_per_mesh_unit") - 1e-3).abs() < 1e-12);
    let centre = own([0.0; 3]).map(|x| 1e-3 * x);
    assert_near(&surface["sphere_centre_metres"], &centre, 1e-9);
    assert_near(&surface["area"]["centre_metres"], &centre, 1e-9);
    // No key moves by more than 12 mm, so that the surface may stay within 13 mm.
    let coarse = format!("{start} --fit-scale --tolerance 0.013 --json");
    let report = json(&capture(folder.path(), &coarse));
    assert_eq!(number(&report, "/surface/morph_targets"), 0.0);
    assert!((number(&report, "/surface/morph_error_max_metres") - 0.012).abs() < 1e-9);
    let found = obj_vertices(folder.path(), "there.obj");
    for (place, key) in seen(2).into_iter().zip(keys()) {
        assert!(distance(found[key], place) < 1e-9, "{key}");
    }
    // Without the pose, the surface stays where the mesh is.
    let still = format!("{start} --fit-scale --still --out still.obj");
    assert_success(&capture(folder.path(), &still));
    let found = obj_vertices(folder.path(), "still.obj");
    for (name, key) in NAMES.iter().zip(keys()) {
        let [x, y, z] = vertices()[key];
        let [a, b, c] = expression(name);
        assert!(
            distance(found[key], own([x + a, y + b, z + c])) < 1e-6,
            "{name}"
        );
    }
    // Without a change of size, the keys do not fit.
    let report = json(&capture(
        folder.path(),
        "--mesh face.obj --keys keys.csv --json",
    ));
    assert!(number(&report, "/surface/key_fit_rms_metres") > 10.0);
}

#[test]
fn a_local_area_moves_alone() {
    let folder = folder(&table(plain));
    let start = "--mesh face.obj --keys keys.csv --frame f2 --still --area chin:0.05";
    let report = json(&capture(
        folder.path(),
        &format!("{start} --out a.obj --json"),
    ));
    let area = &report["surface"]["area"];
    assert_eq!(
        (&area["key"], &area["centre_kept"]),
        (&"chin".into(), &false.into())
    );
    let inside = number(area, "/vertices");
    assert!(inside > 20.0 && inside < 300.0, "{inside}");
    let (rest, found) = (vertices(), obj_vertices(folder.path(), "a.obj"));
    let chin = keys()[4];
    let mut moved = 0.0;
    for (place, found) in rest.iter().zip(&found) {
        let by = distance(*place, *found);
        assert!(by < 1e-9 || distance(*place, rest[chin]) < 0.05, "{by}");
        moved += f64::from(u8::from(by > 1e-9));
    }
    assert!(moved > 0.5 * inside && moved <= inside);
    let [_, y, _] = found[chin];
    assert!(
        (y - (rest[chin][1] - 0.012)).abs() < 1e-9,
        "the key moves as captured"
    );
    assert!(number(area, "/centre_displacement_metres/2/1") < -0.001);

    let kept = format!("{start} --keep-centre --out kept.obj --json");
    let report = json(&capture(folder.path(), &kept));
    let area = &report["surface"]["area"];
    for frame in 0..FRAMES {
        assert_near(&area["centre_displacement_metres"][frame], &[0.0; 3], 1e-12);
    }
    let found = obj_vertices(folder.path(), "kept.obj");
    assert!(found[chin][1] - rest[chin][1] > -0.012);
    assert!(distance(found[vertex(3, 0)], rest[vertex(3, 0)]) < 1e-12);
}
