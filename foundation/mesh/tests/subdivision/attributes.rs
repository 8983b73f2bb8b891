//! Meshes with all that they carry.

use ga_mesh::subdivision::{Rules, Subdivision, Tags, subdivide};
use ga_mesh::{CornerAttribute, Faces, Group, Material, Mesh, MeshError, Polylines};

/// A triangle and a quadrilateral beside each other, with everything that a mesh can have.
fn painted() -> Mesh {
    let positions = [
        [0.0, 0.0, 0.0],
        [1.0, 0.0, 0.0],
        [1.0, 1.0, 0.0],
        [0.0, 1.0, 0.0],
        [2.0, 0.5, 0.0],
    ];
    let faces = Faces::from_polygons([&[1, 4, 2][..], &[0, 1, 2, 3]]).unwrap();
    let coordinates = CornerAttribute {
        values: vec![[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]],
        corners: vec![None, None, None, Some(0), Some(1), Some(2), Some(3)],
    };
    let group = |name: &str, faces: &[u32]| Group {
        name: name.to_owned(),
        faces: faces.to_vec(),
    };
    Mesh::new(positions.to_vec(), faces)
        .unwrap()
        .with_colours(positions.map(|[x, y, _]| [x, y, 0.5, 1.0]).to_vec())
        .unwrap()
        .with_texture_coordinates(vec![coordinates])
        .unwrap()
        .with_groups(vec![group("all", &[0, 1]), group("square", &[1])])
        .unwrap()
        .with_objects(vec![group("triangle", &[0])])
        .unwrap()
        .with_materials(
            vec![Material::named("red"), Material::named("blue")],
            vec![None, Some(1)],
        )
        .unwrap()
        .with_polylines(Polylines::from_lines([[0, 4]]).unwrap())
        .unwrap()
        .with_points(vec![3])
        .unwrap()
}

#[test]
fn attributes_are_carried_along() {
    let mesh = painted();
    for levels in 0..3 {
        let fine = subdivide(&mesh, levels, Rules::CATMULL_CLARK, &Tags::default()).unwrap();
        // The first face becomes 3, the second 4, and each of these 4.
        let [first, second] = match levels {
            0 => [1, 1],
            _ => [3 * 4_u32.pow(levels - 1), 4_u32.pow(levels)],
        };
        let total = first + second;
        assert_eq!(fine.faces().len() as u32, total);
        assert!(
            fine.group("all")
                .unwrap()
                .faces
                .iter()
                .copied()
                .eq(0..total)
        );
        assert!(
            fine.group("square")
                .unwrap()
                .faces
                .iter()
                .copied()
                .eq(first..total)
        );
        assert!(
            fine.object("triangle")
                .unwrap()
                .faces
                .iter()
                .copied()
                .eq(0..first)
        );
        for face in 0..total {
            let expected = (face >= first).then_some("blue");
            let material = fine.material(face as usize);
            assert_eq!(material.map(|material| material.name.as_str()), expected);
        }
        assert_eq!(fine.polylines(), mesh.polylines());
        assert_eq!(fine.points(), mesh.points());
        // The colours are those of the coordinates, and move with them.
        for (colour, [x, y, _]) in fine.colours().unwrap().iter().zip(fine.coordinates()) {
            assert!((colour[0] - x).abs() < 1e-15 && (colour[1] - y).abs() < 1e-15);
            assert!((colour[2] - 0.5).abs() < 1e-15 && (colour[3] - 1.0).abs() < 1e-15);
        }
        let coordinates = fine.texture_coordinates().unwrap();
        let corners = fine.faces().corners().len();
        let with = (0..corners)
            .filter(|&corner| coordinates.get(corner).is_some())
            .count();
        assert_eq!(with as u32, second * 4);
    }
}

#[test]
fn a_mesh_without_texture_coordinates_at_any_face_keeps_the_empty_set() {
    let mesh = painted();
    let empty = CornerAttribute {
        values: vec![[0.5; 2]],
        corners: vec![None; 7],
    };
    let mesh = mesh.with_texture_coordinates(vec![empty]).unwrap();
    let fine = subdivide(&mesh, 1, Rules::CATMULL_CLARK, &Tags::default()).unwrap();
    assert_eq!(fine.texture_coordinate_sets().len(), 1);
    assert!(
        fine.texture_coordinates()
            .unwrap()
            .corners
            .iter()
            .all(Option::is_none)
    );
}

#[test]
fn levels_can_be_seen_one_by_one() {
    let mesh = painted();
    let level = Subdivision::new(&mesh, Rules::CATMULL_CLARK, &Tags::default()).unwrap();
    let level = level.refined().unwrap();
    let (faces, positions) = (level.cage().faces().clone(), level.positions().to_vec());
    let fine = level.into_mesh().unwrap();
    assert_eq!(fine.faces(), &faces);
    assert_eq!(fine.positions(), positions);
}

#[test]
fn too_many_levels_are_refused_before_the_work() {
    let error =
        |levels| subdivide(&painted(), levels, Rules::CATMULL_CLARK, &Tags::default()).unwrap_err();
    let too_large = |count| MeshError::RefinedTooLarge {
        what: "corners",
        count,
    };
    assert_eq!(error(15), too_large(7 << 30));
    assert_eq!(error(u32::MAX), too_large(u64::MAX));
}
