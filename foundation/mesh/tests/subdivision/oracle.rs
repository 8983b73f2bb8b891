//! One and two steps of Loop's scheme, computed by a program of its own.

use std::collections::BTreeSet;

use ga_mesh::subdivision::{Cage, Rules};
use ga_mesh::{Faces, obj};
use nullcone_shared_data::shared;
use serde_json::Value;

use crate::shapes::assert_close;

fn oracle() -> Value {
    serde_json::from_str(include_str!("../data/loop.json")).unwrap()
}

fn positions(value: &Value) -> Vec<[f64; 3]> {
    serde_json::from_value(value.clone()).unwrap()
}

fn faces(value: &Value) -> Vec<Vec<u32>> {
    serde_json::from_value(value.clone()).unwrap()
}

/// The faces as a set, each beginning with its least vertex.
fn as_set<'a>(faces: impl IntoIterator<Item = &'a [u32]>) -> BTreeSet<Vec<u32>> {
    let rotated = faces.into_iter().map(|face| {
        let least = (0..face.len()).min_by_key(|&place| face[place]).unwrap();
        [&face[least..], &face[..least]].concat()
    });
    rotated.collect()
}

#[test]
fn small_meshes_agree() {
    let oracle = oracle();
    let mut levels = 0;
    for mesh in oracle["meshes"].as_object().unwrap().values() {
        let Some(input) = mesh.get("input") else {
            continue;
        };
        let mut points = positions(&input["vertices"]);
        let polygons = Faces::from_polygons(faces(&input["faces"])).unwrap();
        let mut cage = Cage::new(polygons, points.len(), Rules::LOOP).unwrap();
        for level in mesh["levels"].as_array().unwrap() {
            let fine = cage.refine().unwrap();
            points = fine.stencils.applied(&points).unwrap();
            cage = fine.cage;
            assert_close(&points, &positions(&level["vertices"]), 1e-12);
            let expected = faces(&level["faces"]);
            assert_eq!(
                as_set(cage.faces()),
                as_set(expected.iter().map(Vec::as_slice))
            );
            levels += 1;
        }
    }
    assert_eq!(levels, 8);
}

#[test]
fn scanned_meshes_agree() {
    let oracle = oracle();
    for name in ["spot.obj", "stanford-bunny.obj"] {
        let Some(path) = shared(&format!("data/anim/{name}")) else {
            return;
        };
        let mesh = obj::read(path).unwrap();
        let expected = &oracle["meshes"][name];
        let triangles = Faces::from_polygons(mesh.triangles()).unwrap();
        let counts = |vertices: usize, faces: usize, when: &str| {
            assert_eq!(expected[format!("vertices_{when}")], vertices);
            assert_eq!(expected[format!("faces_{when}")], faces);
        };
        counts(mesh.vertex_count(), triangles.len(), "in");
        let cage = Cage::new(triangles, mesh.vertex_count(), Rules::LOOP).unwrap();
        let fine = cage.refine().unwrap();
        let coarse: Vec<[f64; 3]> = mesh.coordinates().collect();
        let points = fine.stencils.applied(&coarse).unwrap();
        counts(points.len(), fine.cage.faces().len(), "out");

        let indices: Vec<usize> = serde_json::from_value(expected["index"].clone()).unwrap();
        let chosen: Vec<_> = indices.iter().map(|&index| points[index]).collect();
        assert_close(&chosen, &positions(&expected["position"]), 1e-12);
        for (axis, sum) in expected["sum"].as_array().unwrap().iter().enumerate() {
            let found: f64 = points.iter().map(|point| point[axis]).sum();
            assert!((found - sum.as_f64().unwrap()).abs() < 1e-12 * points.len() as f64);
        }
    }
}
