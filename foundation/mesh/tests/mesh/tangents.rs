//! Tangents against those of surfaces with formulas.

use std::f64::consts::TAU;

use ga_mesh::tangents::mikktspace;
use ga_mesh::{CornerAttribute, Faces, Mesh, MeshError};
use ga_runtime::vga3::Vector;

/// A torus about the z axis, u around the axis and v around the tube. Texture coordinates have a
/// seam, vertices do not.
fn torus(around: u32, tube: u32, mirrored: bool) -> Mesh {
    let (large, small) = (2.0, 0.75);
    let mut positions = Vec::new();
    let mut normals = Vec::new();
    for i in 0..around {
        for j in 0..tube {
            let [a, b] = [
                TAU * f64::from(i) / f64::from(around),
                TAU * f64::from(j) / f64::from(tube),
            ];
            let outward = Vector::new(a.cos() * b.cos(), a.sin() * b.cos(), b.sin());
            let centre = Vector::new(large * a.cos(), large * a.sin(), 0.0);
            positions.push((centre + outward * small).coordinates());
            normals.push(outward);
        }
    }
    let (mut polygons, mut values, mut corners) = (Vec::new(), Vec::new(), Vec::new());
    for i in 0..around {
        for j in 0..tube {
            let square = [(i, j), (i + 1, j), (i + 1, j + 1), (i, j + 1)];
            polygons.push(square.map(|(i, j)| i % around * tube + j % tube));
            for (i, j) in square {
                let u = f64::from(i) / f64::from(around);
                let u = if mirrored { 1.0 - u } else { u };
                corners.push(Some(values.len() as u32));
                values.push([u, f64::from(j) / f64::from(tube)]);
            }
        }
    }
    let faces = Faces::from_uniform(polygons).unwrap();
    let normals = CornerAttribute::of_vertices(normals, &faces);
    Mesh::new(positions, faces)
        .and_then(|mesh| mesh.with_normals(normals))
        .and_then(|mesh| mesh.with_texture_coordinates(vec![CornerAttribute { values, corners }]))
        .unwrap()
}

/// On a torus the tangent at the angle a around the axis is (−sin a, cos a, 0), also at the seam;
/// where the picture is mirrored it is the opposite, and left-handed.
#[test]
fn tangents_of_a_torus_run_around_its_axis() {
    for (mirrored, sign) in [(false, 1.0), (true, -1.0)] {
        let (around, tube) = (48, 24);
        let mesh = torus(around, tube, mirrored);
        let tangents = mikktspace(&mesh, 0).unwrap();
        for (corner, &vertex) in mesh.faces().corners().iter().enumerate() {
            let a = TAU * f64::from(vertex / tube) / f64::from(around);
            let expected = Vector::new(-a.sin(), a.cos(), 0.0) * sign;
            let tangent = tangents.get(corner).unwrap();
            assert_eq!(tangent.handedness, sign);
            let cosine = tangent.direction.dot(expected);
            // At the seam of the picture a tangent comes from the faces on one side alone: it is
            // off by half the angle of a face, whose cosine is 0.99786.
            assert!(cosine > 0.9978, "corner {corner}: {cosine}");
        }
        assert!(mesh.with_tangents(tangents).is_ok());
    }
}

/// On a plane with an affine picture the tangent is the gradient's direction, whatever the corners
/// of the polygon.
#[test]
fn tangents_of_a_plane_are_those_of_its_picture() {
    let hexagon: Vec<[f64; 3]> = (0..6)
        .map(|k| {
            let angle = TAU * f64::from(k) / 6.0;
            [angle.cos(), angle.sin(), 0.0]
        })
        .collect();
    // The picture rotated by 30 degrees: u = x cos 30° + y sin 30°.
    let (sine, cosine) = 0.5f64.asin().sin_cos();
    let picture = hexagon.iter();
    let picture = picture.map(|[x, y, _]| [x * cosine + y * sine, y * cosine - x * sine]);
    let faces = Faces::from_polygons([[0, 1, 2, 3, 4, 5]]).unwrap();
    let coordinates = CornerAttribute::of_vertices(picture.collect(), &faces);
    let mesh = Mesh::new(hexagon, faces).unwrap();
    let mesh = mesh.with_texture_coordinates(vec![coordinates]).unwrap();
    let tangents = mikktspace(&mesh, 0).unwrap();
    for corner in 0..6 {
        let tangent = tangents.get(corner).unwrap();
        let expected = Vector::new(cosine, sine, 0.0);
        assert!(tangent.direction.distance(expected) < 1e-6);
        assert_eq!(tangent.handedness, 1.0);
    }
}

#[test]
fn what_lacks_a_picture_has_no_tangent() {
    let faces = Faces::from_polygons([[0, 1, 2], [0, 2, 3]]).unwrap();
    let corners = vec![[0.0; 3], [1.0, 0.0, 0.0], [1.0, 1.0, 0.0], [0.0, 1.0, 0.0]];
    let mesh = Mesh::new(corners, faces).unwrap();
    assert_eq!(
        mikktspace(&mesh, 0),
        Err(MeshError::NoTextureCoordinates { set: 0 })
    );
    let half = CornerAttribute {
        values: vec![[0.0, 0.0], [1.0, 0.0], [1.0, 1.0]],
        corners: vec![Some(0), Some(1), Some(2), Some(0), None, Some(2)],
    };
    let mesh = mesh.with_texture_coordinates(vec![half]).unwrap();
    let tangents = mikktspace(&mesh, 0).unwrap();
    assert!((0..3).all(|corner| tangents.get(corner).is_some()));
    assert!((3..6).all(|corner| tangents.get(corner).is_none()));
    let far = mesh.scaled(1e300).unwrap();
    assert!(matches!(
        mikktspace(&far, 0),
        Err(MeshError::TooFar { vertex: 1, .. })
    ));
}
