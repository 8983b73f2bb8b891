//! Meshes with morph targets as documents.

use ga_mesh::gltf::{self, Document, Target, Vertices};
use ga_mesh::normals::vertex_normals;
use ga_mesh::{CornerAttribute, Faces, Mesh, Normals, Polylines};
use ga_runtime::vga3::Vector;

/// A pyramid whose corners have other texture coordinates in each face, with an edge drawn beside
/// and a vertex that nothing uses.
fn pyramid() -> Mesh {
    let corners = vec![
        [9.0, 9.0, 9.0],
        [0.0, 0.0, 0.0],
        [1.0, 0.0, 0.0],
        [0.0, 1.0, 0.0],
        [0.0, 0.0, 1.0],
    ];
    let faces = [[1, 3, 2], [1, 2, 4], [2, 3, 4], [3, 1, 4]];
    let picture = CornerAttribute {
        values: vec![[0.0, 0.0], [1.0, 0.0], [0.0, 1.0], [0.5, 0.5]],
        corners: (0..12).map(|corner| Some(corner % 4)).collect(),
    };
    let mesh = Mesh::new(corners, Faces::from_polygons(faces).unwrap()).unwrap();
    mesh.with_texture_coordinates(vec![picture])
        .unwrap()
        .with_polylines(Polylines::from_lines([[2, 4]]).unwrap())
        .unwrap()
}

fn displacements(factor: f64) -> Vec<Vector<f64>> {
    let one = |k: u32| Vector::new(factor * f64::from(k), 0.25, -factor);
    (0..5).map(one).collect()
}

#[test]
fn targets_move_the_vertices_of_the_mesh() {
    let mesh = pyramid();
    let (first, second) = (displacements(0.5), displacements(-2.0));
    let targets = [("first", &first), ("second", &second)].map(|(name, displacements)| Target {
        name,
        displacements,
    });
    let mut document = Document::from_mesh_with_targets(&mesh, &targets).unwrap();
    let file = gltf::encode(&document).unwrap();
    assert_eq!(gltf::decode(&file).unwrap().meshes, document.meshes);
    assert!(document.meshes[0].primitives.len() > 1);
    let rest: Vec<_> = mesh.coordinates().collect();
    for primitive in &document.meshes[0].primitives {
        assert_eq!(primitive.targets.len(), 2);
        assert!(
            primitive
                .targets
                .iter()
                .all(|target| target.normals.is_empty())
        );
        for (k, place) in primitive.positions.iter().enumerate() {
            let at = |p: &[f64; 3]| p.map(|x| x as f32) == *place;
            let vertex = rest.iter().position(at).unwrap();
            for (target, expected) in primitive.targets.iter().zip([&first, &second]) {
                let expected = expected[vertex].coordinates().map(|x| x as f32);
                assert_eq!(target.positions[k], expected);
            }
        }
    }
    let names = document.meshes[0].extras.as_ref().unwrap()["targetNames"].clone();
    assert_eq!(names, serde_json::json!(["first", "second"]));
    assert_eq!(document.meshes[0].target_names(), ["first", "second"]);
    for names in [
        serde_json::json!(["first"]),
        serde_json::json!(["first", 2]),
    ] {
        let mut other = document.meshes[0].clone();
        other.extras = Some(serde_json::json!({ "targetNames": names }));
        assert!(other.target_names().is_empty());
    }
    // Without weights the document is at rest.
    let places = |document: &Document| {
        let mesh = document.to_mesh(Vertices::Merged).unwrap();
        mesh.coordinates().collect::<Vec<_>>()
    };
    let plain = Document::from_mesh(&mesh).unwrap();
    assert!(plain.meshes[0].extras.is_none() && plain.meshes[0].primitives[0].targets.is_empty());
    assert_eq!(places(&document), places(&plain));
    document.meshes[0].weights = vec![1.0, 0.5];
    let moved = (0..5).map(|k| Vector::from(rest[k]) + first[k] + second[k] * 0.5);
    let moved = mesh
        .with_positions(moved.map(Vector::coordinates).collect())
        .unwrap();
    assert_eq!(
        places(&document),
        places(&Document::from_mesh(&moved).unwrap())
    );
}

#[test]
fn targets_change_the_normals_of_meshes_that_have_them() {
    let mesh = pyramid();
    let triangles = mesh.triangles();
    let rest: Vec<_> = mesh.coordinates().collect();
    let moved: Vec<_> = rest
        .iter()
        .zip(displacements(0.3))
        .map(|(&p, d)| (Vector::from(p) + d).coordinates())
        .collect();
    let [mut before, after] = [&rest, &moved].map(|places| vertex_normals(places, &triangles));
    // The vertex without a face has no normal.
    before[0] = [0.0, 0.0, 1.0];
    let values = before.iter().map(|&n| Vector::from(n)).collect();
    let normals: Normals = CornerAttribute::of_vertices(values, mesh.faces());
    let smooth = mesh.clone().with_normals(normals).unwrap();
    let displacements = displacements(0.3);
    let target = Target {
        name: "",
        displacements: &displacements,
    };
    let document = Document::from_mesh_with_targets(&smooth, &[target]).unwrap();
    let surface = &document.meshes[0].primitives[0];
    let target = &surface.targets[0];
    assert_eq!(target.normals.len(), surface.positions.len());
    for (k, place) in surface.positions.iter().enumerate() {
        let at = |p: &[f64; 3]| p.map(|x| x as f32) == *place;
        let vertex = rest.iter().position(at).unwrap();
        for (axis, after) in after[vertex].into_iter().enumerate() {
            let found = surface.normals[k][axis] + target.normals[k][axis];
            assert!((f64::from(found) - after).abs() < 1e-6);
        }
    }
}

#[test]
fn targets_of_another_mesh_are_refused() {
    let few = [Vector::ZERO; 4];
    let target = Target {
        name: "few",
        displacements: &few,
    };
    let error = Document::from_mesh_with_targets(&pyramid(), &[target]).unwrap_err();
    assert!(
        error.to_string().contains("4 positions for 5 vertices"),
        "{error}"
    );
    let mut wrong = displacements(1.0);
    wrong[3] = Vector::new(0.0, f64::NAN, 0.0);
    let target = Target {
        name: "wrong",
        displacements: &wrong,
    };
    assert!(Document::from_mesh_with_targets(&pyramid(), &[target]).is_err());
}
