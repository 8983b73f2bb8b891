//! Attributes of meshes: what is refused, and what parts and moved meshes keep.

use ga_mesh::{
    CornerAttribute, Faces, Group, Material, Mesh, MeshError, Polylines, Tangent, Texture,
};
use ga_runtime::vga3::Vector;

/// Two triangles that share an edge.
fn two_triangles() -> Mesh {
    let positions = vec![[0.0; 3], [1.0, 0.0, 0.0], [1.0, 1.0, 0.0], [0.0, 1.0, 0.0]];
    Mesh::new(
        positions,
        Faces::from_uniform(vec![[0, 1, 2], [0, 2, 3]]).unwrap(),
    )
    .unwrap()
}

const UP: Vector<f64> = Vector {
    e1: 0.0,
    e2: 0.0,
    e3: 1.0,
};

fn everywhere<T>(value: T) -> CornerAttribute<T> {
    CornerAttribute {
        values: vec![value],
        corners: vec![Some(0); 6],
    }
}

fn group(name: &str, faces: &[u32]) -> Group {
    Group {
        name: name.into(),
        faces: faces.to_vec(),
    }
}

#[test]
fn faulty_attributes_are_refused() {
    let error = |result: Result<Mesh, MeshError>| result.unwrap_err().to_string();
    let mesh = two_triangles;
    assert_eq!(
        error(mesh().with_colours(vec![[1.0; 4]; 3])),
        "3 colours for 4 vertices"
    );
    assert_eq!(
        error(mesh().with_colours(vec![[1.0, 0.0, f64::NAN, 1.0]; 4])),
        "colour 0 is not finite: [1.0, 0.0, NaN, 1.0]"
    );
    assert_eq!(
        error(mesh().with_normals(everywhere(Vector::default()))),
        "normal 0 is the zero vector"
    );
    let mut short = everywhere(UP);
    short.corners.pop();
    assert_eq!(
        error(mesh().with_normals(short)),
        "the list of normal indices has 5 entries for 6 corners of faces"
    );
    let mut far = everywhere(UP);
    far.corners[4] = Some(1);
    assert_eq!(
        error(mesh().with_normals(far)),
        "corner 4 refers to normal 1, but there are 1"
    );
    let tangent = Tangent {
        direction: Vector::new(1.0, 0.0, 0.0),
        handedness: 0.5,
    };
    assert_eq!(
        error(mesh().with_tangents(everywhere(tangent))),
        "the handedness of tangent 0 is 0.5; it must be 1 or -1"
    );
    assert_eq!(
        error(mesh().with_objects(vec![group("a", &[2])])),
        "group \"a\" refers to face 2, but there are 2 faces"
    );
    let red = Material::named("red");
    assert_eq!(
        error(mesh().with_materials(vec![red.clone()], vec![None])),
        "1 materials of faces for 2 faces"
    );
    assert_eq!(
        error(mesh().with_materials(vec![red.clone()], vec![None, Some(1)])),
        "face 1 refers to material 1, but there are 1 materials"
    );
    let rough = Material {
        roughness: 1.5,
        ..red.clone()
    };
    assert_eq!(
        error(mesh().with_materials(vec![red, rough], vec![None; 2])),
        "the roughness of material \"red\" is out of range"
    );
    let mut texture = Texture::file("a.png");
    texture.offset[1] = f64::INFINITY;
    let placed = Material {
        emissive_texture: Some(texture),
        ..Material::named("glow")
    };
    assert_eq!(
        error(mesh().with_materials(vec![placed], vec![None; 2])),
        "the placement of a texture of material \"glow\" is out of range"
    );
    assert_eq!(
        Polylines::from_lines([&[0, 1][..], &[2]])
            .unwrap_err()
            .to_string(),
        "polyline 1 has 1 vertices; a polyline has at least 2"
    );
    let line = Polylines::from_lines([[0, 4]]).unwrap();
    assert_eq!(
        error(mesh().with_polylines(line)),
        "polyline 0 refers to vertex 4, but there are 4 vertices"
    );
    assert_eq!(
        error(mesh().with_points(vec![3, 9])),
        "point 1 refers to vertex 9, but there are 4 vertices"
    );
    assert_eq!(
        error(mesh().with_positions(vec![[0.0; 3]; 5])),
        "5 positions for 4 vertices"
    );
}

#[test]
fn normals_of_single_precision_stay_as_they_are_and_others_become_unit_vectors() {
    let single = Vector::new(0.6f32.into(), 0.8f32.into(), 0.0);
    assert_ne!(single.dot(single), 1.0);
    let mesh = two_triangles()
        .with_normals(CornerAttribute {
            values: vec![single, Vector::new(0.0, 0.0, -4.0)],
            corners: vec![Some(0), Some(1), None, None, None, None],
        })
        .unwrap();
    let normals = mesh.normals().unwrap();
    assert_eq!(normals.values, [single, -UP]);
    assert_eq!(normals.get(1), Some(&-UP));
    assert_eq!(normals.get(2), None);
    assert_eq!(normals.get(6), None);
}

#[test]
fn a_face_is_in_one_object() {
    let mesh = two_triangles()
        .with_objects(vec![group("first", &[1]), group("second", &[1, 0, 0])])
        .unwrap();
    assert_eq!(mesh.object("second").unwrap().faces, [0]);
    assert_eq!(mesh.part("first").unwrap().vertices, [0, 2, 3]);
}

#[test]
fn a_part_keeps_every_attribute() {
    let tangent = |x: f64| Tangent {
        direction: Vector::new(x, 0.0, 0.0),
        handedness: -x,
    };
    let mesh = two_triangles()
        .with_colours((0..4).map(|v| [f64::from(v), 0.0, 0.0, 1.0]).collect())
        .and_then(|mesh| mesh.with_normals(everywhere(UP)))
        .and_then(|mesh| {
            mesh.with_tangents(CornerAttribute {
                values: vec![tangent(1.0), tangent(-1.0)],
                corners: (0..6).map(|corner| Some(corner / 3)).collect(),
            })
        })
        .and_then(|mesh| {
            mesh.with_materials(
                vec![Material::named("a"), Material::named("b")],
                vec![Some(0), Some(1)],
            )
        })
        .and_then(|mesh| mesh.with_groups(vec![group("back", &[1])]))
        .and_then(|mesh| mesh.with_points(vec![1]))
        .unwrap();
    let part = mesh.part("back").unwrap().mesh;
    let reds: Vec<f64> = part.colours().unwrap().iter().map(|c| c[0]).collect();
    assert_eq!(reds, [0.0, 2.0, 3.0]);
    assert_eq!(part.normals().unwrap().corners, [Some(0); 3]);
    assert_eq!(part.tangents().unwrap().get(0), Some(&tangent(-1.0)));
    assert_eq!(part.face_materials(), [Some(1)]);
    assert_eq!(part.material(0).unwrap().name, "b");
    assert_eq!(part.points(), [0u32; 0]);

    let scaled = mesh.scaled(2.0).unwrap();
    assert_eq!(scaled.normals(), mesh.normals());
    let moved = mesh.with_positions(vec![[0.0; 3]; 4]).unwrap();
    assert_eq!((moved.normals(), moved.tangents()), (None, None));
    assert_eq!(moved.colours(), mesh.colours());
    assert_eq!(moved.points(), [1]);
}

/// r⁴ = 2 / (n + 2) by hand: n = 30 gives 1/16, so r = 1/2.
#[test]
fn exponents_and_roughness_correspond() {
    assert_eq!(Material::roughness_of_exponent(30.0), 0.5);
    assert_eq!(Material::exponent_of_roughness(0.5), 30.0);
    assert_eq!(Material::roughness_of_exponent(0.0), 1.0);
    assert_eq!(Material::exponent_of_roughness(1.0), 0.0);
    assert_eq!(Material::exponent_of_roughness(0.0), 1e6);
}

#[test]
fn corner_triangles_follow_the_triangles() {
    let faces = Faces::from_polygons([&[4, 5, 6, 7][..], &[7, 6, 0]]).unwrap();
    let positions = [0, 0, 0, 0, 0, 1, 3, 2].map(|i| [f64::from(i % 2), f64::from(i / 2), 0.0]);
    let corners = faces.corner_triangles(&positions);
    assert_eq!(corners, [[0, 1, 2], [0, 2, 3], [4, 5, 6]]);
    let vertices: Vec<[u32; 3]> = corners
        .iter()
        .map(|triangle| triangle.map(|corner| faces.corners()[corner as usize]))
        .collect();
    assert_eq!(vertices, faces.triangles(&positions));
}
