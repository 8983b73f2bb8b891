//! Baked maps against surfaces that are given by formulas.

use ga_mesh::bake::{Bake, Coarse, Fine, OcclusionOptions, Options, corner_colours};
use ga_mesh::{Faces, Mesh, MeshError, TextureCoordinates, TextureSpaceError};
use ga_runtime::vga3::Vector;

/// A grid over the unit square with these heights, of n × n cells, with texture coordinates that
/// are x and y.
fn sheet(n: u32, height: impl Fn(f64, f64) -> f64) -> Mesh {
    let mut positions = Vec::new();
    let mut coordinates = Vec::new();
    for row in 0..=n {
        for column in 0..=n {
            let (x, y) = (
                f64::from(column) / f64::from(n),
                f64::from(row) / f64::from(n),
            );
            positions.push([x, y, height(x, y)]);
            coordinates.push([x, y]);
        }
    }
    let mut triangles = Vec::new();
    for row in 0..n {
        for column in 0..n {
            let a = row * (n + 1) + column;
            let (b, c, d) = (a + 1, a + n + 2, a + n + 1);
            triangles.extend([[a, b, c], [a, c, d]]);
        }
    }
    let faces = Faces::from_polygons(&triangles).unwrap();
    let texture = TextureCoordinates::of_vertices(coordinates, &faces);
    Mesh::new(positions, faces)
        .unwrap()
        .with_texture_coordinates(vec![texture])
        .unwrap()
}

fn flat() -> Coarse {
    Coarse::from_mesh(&sheet(2, |_, _| 0.0), 0).unwrap()
}

/// The place in the unit square of the centre of a texel.
fn place(size: u32, column: u32, row: u32) -> (f64, f64) {
    let part = |i: u32| (f64::from(i) + 0.5) / f64::from(size);
    (part(column), 1.0 - part(row))
}

fn wave(x: f64, y: f64) -> f64 {
    0.01 * (6.0 * x).sin() * (4.0 * y).cos()
}

#[test]
fn heights_and_normals_are_those_of_the_formula() {
    let coarse = flat();
    let fine = Fine::from_mesh(&sheet(200, wave)).unwrap();
    let size = 64;
    let bake = Bake::new(&coarse, &fine, &Options::with_size(size)).unwrap();
    assert_eq!((bake.covered_texels(), bake.nearest_texels()), (64 * 64, 0));
    let (heights, normals) = (bake.displacement(), bake.normals());
    for row in 0..size {
        for column in 0..size {
            let (x, y) = place(size, column, row);
            let [height] = heights.get(column, row).unwrap();
            assert!((f64::from(height) - wave(x, y)).abs() < 4e-6);
            let slope_x = 0.06 * (6.0 * x).cos() * (4.0 * y).cos();
            let slope_y = -0.04 * (6.0 * x).sin() * (4.0 * y).sin();
            let expected = Vector::new(-slope_x, -slope_y, 1.0).normalized().unwrap();
            let found = Vector::from(normals.get(column, row).unwrap().map(f64::from));
            assert!(found.distance(expected) < 2e-3, "{found:?} {expected:?}");
        }
    }
}

/// Along the interpolated normals of a coarse sphere, heights are its distances from a fine one.
#[test]
fn a_normal_map_restores_the_normals_of_a_sphere() {
    // Each octant of an octahedron is one triangle with its own place in the texture.
    let unit = |axis: usize, sign: f64| {
        let mut v = Vector::ZERO;
        v[axis] = sign;
        v
    };
    let corners = [unit(0, 1.0), unit(1, 1.0), unit(2, 1.0)];
    let positions: Vec<[f64; 3]> = corners.iter().map(|c| c.coordinates()).collect();
    let faces = Faces::from_polygons([[0, 1, 2]]).unwrap();
    let coordinates = vec![[0.1, 0.1], [0.9, 0.15], [0.4, 0.85]];
    let texture = TextureCoordinates::of_vertices(coordinates.clone(), &faces);
    let normals = ga_mesh::Normals::of_vertices(corners.to_vec(), &faces);
    let coarse = Mesh::new(positions, faces)
        .unwrap()
        .with_texture_coordinates(vec![texture])
        .unwrap()
        .with_normals(normals)
        .unwrap();
    let coarse = Coarse::from_mesh(&coarse, 0).unwrap();

    // A fine sphere with its true normals.
    let (mut triangles, mut normals) = (Vec::new(), Vec::new());
    let n = 128;
    let point = |i: u32, j: u32| {
        let (polar, around) = (f64::from(i) / f64::from(n), f64::from(j) / f64::from(n));
        let (polar, around) = (polar * std::f64::consts::PI, around * std::f64::consts::TAU);
        let (sine, cosine) = polar.sin_cos();
        Vector::new(sine * around.cos(), sine * around.sin(), cosine)
    };
    for i in 0..n {
        for j in 0..n {
            let [a, b, c, d] = [
                point(i, j),
                point(i + 1, j),
                point(i + 1, j + 1),
                point(i, j + 1),
            ];
            for triangle in [[a, b, c], [a, c, d]] {
                triangles.push(triangle);
                normals.push(triangle);
            }
        }
    }
    let fine = Fine::new(triangles, normals).unwrap();
    let mut options = Options::with_size(64);
    options.cage_distance = Some(1.0);
    let bake = Bake::new(&coarse, &fine, &options).unwrap();
    assert_eq!(bake.nearest_texels(), 0);
    let (map, heights) = (bake.normals(), bake.displacement());

    // Decoded as MikkTSpace asks, and displaced along the normal, each texel whose centre lies in
    // the triangle gives the point of the sphere and its normal.
    let [a, b, c] =
        [coordinates[0], coordinates[1], coordinates[2]].map(|[u, v]| Vector::new(u, v, 0.0));
    let whole = (b - a).cross(c - a).e3;
    let mut checked = 0;
    for row in 0..64 {
        for column in 0..64 {
            let (u, v) = place(64, column, row);
            let p = Vector::new(u, v, 0.0);
            let weights = [
                (c - b).cross(p - b).e3,
                (a - c).cross(p - c).e3,
                (b - a).cross(p - a).e3,
            ];
            let weights = weights.map(|w| w / whole);
            if weights.iter().any(|&w| w < 0.0) {
                continue;
            }
            let sum = |values: [Vector<f64>; 3]| {
                values[0] * weights[0] + values[1] * weights[1] + values[2] * weights[2]
            };
            let corners = coarse.triangles[0];
            let [n, t] = [
                sum(corners.map(|c| c.normal)),
                sum(corners.map(|c| c.tangent.direction)),
            ];
            let bitangent = n.cross(t) * corners[0].tangent.handedness;
            let [x, y, z] = map.get(column, row).unwrap().map(f64::from);
            let decoded = (t * x + bitangent * y + n * z).normalized().unwrap();
            let height = f64::from(heights.get(column, row).unwrap()[0]);
            let place = sum(corners.map(|c| c.position)) + n.normalized().unwrap() * height;
            assert!((place.length() - 1.0).abs() < 1e-3);
            assert!(decoded.distance(place) < 1e-3, "{decoded:?} {place:?}");
            checked += 1;
        }
    }
    assert!(checked > 1000);
}

/// A surface beyond the cage is still found, by the nearest point.
#[test]
fn beyond_the_cage_the_nearest_point_is_taken() {
    let coarse = Coarse::from_mesh(&sheet(2, |_, _| 1.0), 0).unwrap();
    let fine = Fine::from_mesh(&sheet(10, |_, _| 1.25)).unwrap();
    let mut options = Options::with_size(16);
    let bake = Bake::new(&coarse, &fine, &options).unwrap();
    assert_eq!(bake.nearest_texels(), 256);
    assert!(
        bake.displacement()
            .texels
            .iter()
            .all(|&[h]| (h - 0.25).abs() < 1e-6)
    );
    options.cage_distance = Some(0.3);
    let bake = Bake::new(&coarse, &fine, &options).unwrap();
    assert_eq!(bake.nearest_texels(), 0);
    assert!(
        bake.displacement()
            .texels
            .iter()
            .all(|&[h]| (h - 0.25).abs() < 1e-6)
    );
    // Where it faces the other way, it is not crossed.
    let back = Mesh::new(
        vec![[0.0, 0.0, 1.1], [1.0, 0.0, 1.1], [0.0, 1.0, 1.1]],
        Faces::from_polygons([[0, 2, 1]]).unwrap(),
    );
    let back = Fine::from_mesh(&back.unwrap()).unwrap();
    let bake = Bake::new(&coarse, &back, &options).unwrap();
    assert_eq!(bake.nearest_texels(), 256);
}

#[test]
fn colours_of_vertices_are_interpolated() {
    let mesh = sheet(8, |_, _| 0.0);
    let colours = mesh
        .coordinates()
        .map(|[x, y, _]| [x, y, 0.5, 1.0])
        .collect();
    let mesh = mesh.with_colours(colours).unwrap();
    let colours = corner_colours(&mesh).unwrap();
    let (coarse, fine) = (flat(), Fine::from_mesh(&mesh).unwrap());
    let bake = Bake::new(&coarse, &fine, &Options::with_size(32)).unwrap();
    let map = bake.colour(|point| {
        let colour = point.mean(&colours[point.triangle as usize]);
        colour.map(|x| x as f32)
    });
    for row in 0..32 {
        for column in 0..32 {
            let (x, y) = place(32, column, row);
            let [r, g, b, a] = map.get(column, row).unwrap().map(f64::from);
            assert!((r - x).abs() < 1e-6 && (g - y).abs() < 1e-6 && b == 0.5);
            assert!((a - 1.0).abs() < 1e-6);
        }
    }
}

/// Below the edge of a high wall, half of the sky is hidden; on an open sheet, nothing.
#[test]
fn occlusion_is_the_hidden_part_of_the_sky() {
    let coarse = flat();
    let open = Fine::from_mesh(&sheet(4, |_, _| 0.0)).unwrap();
    let bake = Bake::new(&coarse, &open, &Options::with_size(8)).unwrap();
    let map = bake.occlusion(&OcclusionOptions::default()).unwrap();
    assert!(map.texels.iter().all(|&[x]| x == 1.0));

    // A wall of great height and length at x = 0, seen from the sheet. At the distance x from it,
    // directions with the cosine weight see the half of the sky away from the wall, and little of
    // the other half, since the wall is 1000 high.
    let mut triangles = Vec::new();
    let corner = |[x, y, z]: [f64; 3]| Vector::new(x, y, z);
    triangles.push([[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [1.0, 1.0, 0.0]].map(corner));
    triangles.push([[0.0, 0.0, 0.0], [1.0, 1.0, 0.0], [0.0, 1.0, 0.0]].map(corner));
    let (far, top) = (1000.0, 1000.0);
    let wall = [
        [0.0, -far, 0.0],
        [0.0, far, 0.0],
        [0.0, far, top],
        [0.0, -far, top],
    ]
    .map(corner);
    triangles.push([wall[0], wall[1], wall[2]]);
    triangles.push([wall[0], wall[2], wall[3]]);
    let normals = vec![[Vector::ZERO; 3]; 4];
    let fine = Fine::new(triangles, normals).unwrap();
    let bake = Bake::new(&coarse, &fine, &Options::with_size(8)).unwrap();
    let mut options = OcclusionOptions::default();
    options.rays = 256;
    let map = bake.occlusion(&options).unwrap();
    for &[open] in &map.texels {
        assert!((open - 0.5).abs() < 0.02, "{open}");
    }
    assert_eq!(bake.occlusion(&options).unwrap(), map);
    options.seed = 1;
    assert_ne!(bake.occlusion(&options).unwrap(), map);
    // What is further away than the wall does not hide anything.
    options.distance = 0.01;
    assert!(
        bake.occlusion(&options)
            .unwrap()
            .texels
            .iter()
            .all(|&[x]| x == 1.0)
    );
    options.distance = f64::NAN;
    assert!(bake.occlusion(&options).is_err());
    options = OcclusionOptions::default();
    options.rays = 0;
    assert!(bake.occlusion(&options).is_err());
}

#[test]
fn texels_around_the_covered_ones_are_filled() {
    // A triangle in the middle of the texture.
    let faces = Faces::from_polygons([[0, 1, 2]]).unwrap();
    let coordinates = vec![[0.25, 0.25], [0.75, 0.25], [0.25, 0.75]];
    let texture = TextureCoordinates::of_vertices(coordinates, &faces);
    let positions = vec![[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]];
    let mesh = Mesh::new(positions, faces)
        .unwrap()
        .with_texture_coordinates(vec![texture])
        .unwrap();
    let coarse = Coarse::from_mesh(&mesh, 0).unwrap();
    let fine = Fine::from_mesh(&sheet(1, |_, _| 0.01)).unwrap();
    let filled = |steps: u32| {
        let mut options = Options::with_size(32);
        options.dilation_texels = steps;
        let bake = Bake::new(&coarse, &fine, &options).unwrap();
        let map = bake.displacement();
        // No texel has another height, and those that touch the triangle have it.
        assert!(
            map.texels
                .iter()
                .all(|&[h]| h == 0.0 || (h - 0.01).abs() < 1e-7)
        );
        (
            bake.covered_texels(),
            map.texels.iter().filter(|&&[h]| h != 0.0).count(),
        )
    };
    // The triangle has sides of 16 texels along the rows and columns of the texture: 15 + … + 1
    // whole texels and 16 along the third side, and its corners touch no others but those beside
    // its sides, which lie on lines between texels.
    let (covered, total) = filled(0);
    assert_eq!(covered, total);
    assert!((136..=136 + 51).contains(&covered), "{covered}");
    let (same, one) = filled(1);
    assert_eq!(same, covered);
    let (_, two) = filled(2);
    assert!(covered < one && one < two && two < 32 * 32);
}

#[test]
fn bad_input_is_an_error() {
    let coarse = flat();
    let fine = Fine::from_mesh(&sheet(1, |_, _| 0.0)).unwrap();
    for size in [0, 20_000] {
        let error = Bake::new(&coarse, &fine, &Options::with_size(size)).unwrap_err();
        assert_eq!(error, TextureSpaceError::MapSize { size });
    }
    for cage in [f64::NAN, -1.0, f64::INFINITY] {
        let mut options = Options::with_size(4);
        options.cage_distance = Some(cage);
        let error = Bake::new(&coarse, &fine, &options).unwrap_err();
        assert!(matches!(
            error,
            TextureSpaceError::Number {
                what: "cage distance",
                ..
            }
        ));
    }
    let mut outside = coarse.clone();
    outside.triangles[3][1].coordinate = [0.5, 1.5];
    let error = Bake::new(&outside, &fine, &Options::with_size(4)).unwrap_err();
    let expected = TextureSpaceError::CornerOutsideSquare {
        triangle: 3,
        coordinate: [0.5, 1.5],
    };
    assert_eq!(error, expected);
    let empty = Coarse { triangles: vec![] };
    let error = Bake::new(&empty, &fine, &Options::with_size(4)).unwrap_err();
    assert_eq!(error, TextureSpaceError::NoTriangles { surface: "coarse" });
    let error = Fine::new(vec![], vec![]).unwrap_err();
    assert_eq!(error, TextureSpaceError::NoTriangles { surface: "fine" });
    let mesh = Mesh::new(
        vec![[0.0; 3]; 3],
        Faces::from_polygons([[0, 1, 2]]).unwrap(),
    )
    .unwrap();
    assert!(matches!(
        Coarse::from_mesh(&mesh, 0),
        Err(TextureSpaceError::Mesh(MeshError::NoTextureCoordinates {
            set: 0
        }))
    ));
}
