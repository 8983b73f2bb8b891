//! Meshes: what they turn down, and parts of them.

use ga_mesh::{CornerAttribute, Faces, Group, Mesh, MeshError, TextureCoordinates};
use proptest::array::uniform3;
use proptest::collection::vec;
use proptest::prelude::*;

const SQUARE: [[f64; 3]; 4] = [
    [0.0, 0.0, 0.0],
    [1.0, 0.0, 0.0],
    [1.0, 1.0, 0.0],
    [0.0, 1.0, 0.0],
];

fn square() -> Mesh {
    Mesh::new(
        SQUARE.to_vec(),
        Faces::from_polygons([vec![0, 1, 2, 3], vec![3, 2, 1]]).unwrap(),
    )
    .unwrap()
}

#[test]
fn what_is_no_mesh_is_an_error() {
    let two = Faces::from_polygons([&[0, 1, 2][..], &[0, 1]]);
    assert_eq!(
        two,
        Err(MeshError::FaceTooShort {
            face: 1,
            corners: 2
        })
    );
    let faces = || Faces::from_polygons([[0, 1, 2], [0, 2, 4]]).unwrap();
    let out = MeshError::IndexOutOfRange {
        face: 1,
        index: 4,
        vertices: 4,
    };
    assert_eq!(Mesh::new(SQUARE.to_vec(), faces()), Err(out));
    let mut far = SQUARE.to_vec();
    far[2][1] = f64::INFINITY;
    let error = MeshError::NotFinite {
        vertex: 2,
        coordinates: far[2],
    };
    assert_eq!(Mesh::new(far, Faces::default()), Err(error));
    assert!(matches!(
        square().scaled(f64::MAX).and_then(|mesh| mesh.scaled(2.0)),
        Err(MeshError::NotFinite { .. })
    ));
    assert!(matches!(
        square().with_positions(SQUARE[..3].to_vec()),
        Err(MeshError::IndexOutOfRange { .. })
    ));

    let texture = |coordinates: &[[f64; 2]], corners: &[Option<u32>]| {
        square().with_texture_coordinates(vec![CornerAttribute {
            values: coordinates.to_vec(),
            corners: corners.to_vec(),
        }])
    };
    let none = [None; 7];
    assert_eq!(
        texture(&[], &none[..6]),
        Err(MeshError::AttributeLength {
            attribute: "texture coordinate",
            expected: 7,
            found: 6
        })
    );
    let mut one = none;
    one[5] = Some(1);
    let error = MeshError::AttributeOutOfRange {
        attribute: "texture coordinate",
        corner: 5,
        index: 1,
        values: 1,
    };
    assert_eq!(texture(&[[0.0, 0.0]], &one), Err(error));
    let message = texture(&[[0.0, f64::NAN]], &none).unwrap_err().to_string();
    assert_eq!(message, "texture coordinate 0 is not finite: [0.0, NaN]");
    let group = Group {
        name: "back".into(),
        faces: vec![2, 0],
    };
    let error = MeshError::GroupOutOfRange {
        group: "back".into(),
        face: 2,
        faces: 2,
    };
    assert_eq!(square().with_groups(vec![group]), Err(error));
}

#[test]
fn bounds_and_scale() {
    let mesh = square().scaled(0.1).unwrap();
    assert_eq!(mesh.bounds(), Some([[0.0; 3], [0.1, 0.1, 0.0]]));
    let none = Mesh::new(Vec::<[f64; 3]>::new(), Faces::default()).unwrap();
    assert_eq!(none.bounds(), None);
}

proptest! {
    /// A convex polygon has the area of its fan.
    #[test]
    fn a_fan_covers_its_polygon(corners in 3usize..20, radius in 0.1..10.0f64) {
        let angle = std::f64::consts::TAU / corners as f64;
        let positions: Vec<[f64; 3]> =
            (0..corners).map(|i| [radius * (angle * i as f64).cos(), radius * (angle * i as f64).sin(), 0.0]).collect();
        let faces = Faces::from_polygons([(0..corners as u32).collect::<Vec<_>>()]).unwrap();
        let triangles = faces.triangles(&positions);
        prop_assert_eq!(triangles.len(), corners - 2);
        let area: f64 = triangles
            .iter()
            .map(|triangle| {
                let [a, b, c] = triangle.map(|corner| positions[corner as usize]);
                0.5 * ((b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]))
            })
            .sum();
        let exact = 0.5 * corners as f64 * radius * radius * angle.sin();
        prop_assert!((area - exact).abs() < 1e-12 * exact.abs().max(1.0));
    }

    #[test]
    fn a_part_has_the_same_corners(
        positions in vec(uniform3(-1.0..1.0f64), 12),
        polygons in vec(vec(0u32..12, 3..6), 1..10),
        chosen in vec(any::<prop::sample::Index>(), 1..6),
    ) {
        let corner_count: usize = polygons.iter().map(Vec::len).sum();
        let texture = TextureCoordinates {
            values: (0..corner_count).map(|i| [i as f64, 0.5]).collect(),
            corners: (0..corner_count as u32).map(|i| (i % 3 > 0).then_some(i)).collect(),
        };
        let faces: Vec<u32> = chosen.iter().map(|index| index.index(polygons.len()) as u32).collect();
        let groups = vec![
            Group { name: "all".into(), faces: (0..polygons.len() as u32).collect() },
            Group { name: "some".into(), faces },
        ];
        let mesh = Mesh::new(positions.clone(), Faces::from_polygons(&polygons).unwrap())
            .and_then(|mesh| mesh.with_texture_coordinates(vec![texture]))
            .and_then(|mesh| mesh.with_groups(groups))
            .unwrap();
        let part = mesh.part("some").unwrap();
        let kept = &mesh.group("some").unwrap().faces;
        prop_assert!(kept.windows(2).all(|pair| pair[0] < pair[1]));
        prop_assert_eq!(part.mesh.faces().len(), kept.len());
        prop_assert!(part.vertices.windows(2).all(|pair| pair[0] < pair[1]));

        let places = |mesh: &Mesh, face: usize| -> Vec<[f64; 3]> {
            let all: Vec<_> = mesh.coordinates().collect();
            mesh.faces().get(face).unwrap().iter().map(|&vertex| all[vertex as usize]).collect()
        };
        let mut corner = 0;
        let firsts: Vec<usize> = polygons.iter().scan(0, |first, face| { let here = *first; *first += face.len(); Some(here) }).collect();
        for (new, &old) in kept.iter().enumerate() {
            let old = old as usize;
            prop_assert_eq!(places(&part.mesh, new), places(&mesh, old));
            for k in 0..polygons[old].len() {
                let texture = |mesh: &Mesh, corner: usize| mesh.texture_coordinates().unwrap().corners[corner];
                prop_assert_eq!(texture(&part.mesh, corner), texture(&mesh, firsts[old] + k));
                corner += 1;
            }
        }
        for (new, old) in part.vertices.iter().enumerate() {
            prop_assert_eq!(part.mesh.coordinates().nth(new), Some(positions[*old as usize]));
        }
        let used: std::collections::BTreeSet<u32> = part.mesh.faces().corners().iter().copied().collect();
        prop_assert_eq!(used.len(), part.vertices.len());
        prop_assert_eq!(part.mesh.group("all").unwrap().faces.len(), kept.len());
    }
}
