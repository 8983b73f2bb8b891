//! Atlases of many surfaces, measured by code of their own.

mod shapes;
mod truth;

use std::collections::HashSet;

use ga_mesh::atlas::{Atlas, Options, measure, unwrap};

use ga_mesh::TextureSpaceError;
use shapes::Shape;

fn made(shape: &Shape, options: &Options) -> Atlas {
    unwrap(&shape.positions, &shape.triangles, options)
        .unwrap_or_else(|error| panic!("{}: {error}", shape.name))
}

/// Options for a texture of this side and margin.
fn options(size: u32, margin_texels: u32) -> Options {
    Options {
        size,
        margin_texels,
        ..Options::default()
    }
}

fn check(shape: &Shape, size: u32, margin: u32, least_utilisation: f64) {
    let atlas = made(shape, &options(size, margin));
    let truth = truth::figures(shape, &atlas, size as usize, margin as usize);
    let report = atlas.report;
    let name = &shape.name;
    assert_eq!(truth.flipped, 0, "{name}: folded triangles");
    assert_eq!(truth.double, 0, "{name}: texels in two triangles");
    assert_eq!(truth.contested, 0, "{name}: texels of two charts");
    assert_eq!(truth.outside, 0, "{name}: texels outside");
    assert!(truth.charts <= 200, "{name}: {} charts", truth.charts);
    assert!(
        truth.stretch_l2 <= 1.1,
        "{name}: stretch {}",
        truth.stretch_l2
    );
    assert!(
        truth.utilisation >= least_utilisation,
        "{name}: utilisation {}",
        truth.utilisation
    );

    assert_eq!(report.charts, truth.charts, "{name}");
    assert_eq!(
        (report.flipped, report.overlapping_texels),
        (0, 0),
        "{name}"
    );
    let difference = (report.stretch_l2 - truth.stretch_l2).abs();
    assert!(difference < 1e-6, "{name}: {difference}");
    let difference = (report.utilisation - truth.utilisation).abs();
    assert!(difference < 2e-3, "{name}: {difference}");
    assert!(report.stretch_max > report.stretch_l2 - 1e-9, "{name}");
}

#[test]
fn every_surface_has_an_atlas_without_folds_and_overlaps() {
    for shape in shapes::all() {
        check(&shape, 1024, 1, 0.55);
    }
}

#[test]
fn a_surface_of_spikes_has_one_too() {
    // Its charts are narrow sectors of cones, which leave more room between them.
    check(&shapes::spikes(), 1024, 1, 0.55);
}

#[test]
fn small_textures_and_wide_margins_are_kept() {
    let torus = shapes::torus(40, 24, [1.0, 0.4]);
    for (size, margin, least) in [
        (512, 0, 0.55),
        (256, 2, 0.45),
        (100, 1, 0.4),
        (2048, 4, 0.55),
    ] {
        check(&torus, size, margin, least);
    }
}

#[test]
fn equal_input_gives_equal_coordinates_in_any_unit() {
    let torus = || shapes::torus(40, 24, [1.0, 0.4]);
    let options = Options::default();
    let atlas = made(&torus(), &options);
    assert_eq!(atlas, made(&torus(), &options));
    for factor in [2.0_f64.powi(-500), 2.0_f64.powi(500)] {
        let scaled = torus().map("scaled", |p| p.map(|x| factor * x));
        assert_eq!(atlas, made(&scaled, &options), "{factor}");
    }
}

#[test]
fn a_surface_of_one_chart_has_one_coordinate_for_each_vertex() {
    let terrain = shapes::terrain(1.0);
    let atlas = made(&terrain, &Options::default());
    assert_eq!(atlas.report.charts, 1);
    let coordinates = atlas.texture_coordinates();
    assert_eq!(coordinates.values.len(), terrain.positions.len());
    let mut of_vertex = vec![None; terrain.positions.len()];
    for (vertex, index) in terrain.triangles.iter().flatten().zip(coordinates.corners) {
        let before = of_vertex[*vertex as usize].replace(index);
        assert!(
            before.is_none_or(|before| before == index),
            "vertex {vertex}"
        );
    }
}

#[test]
fn vertices_at_the_same_position_are_one() {
    // A grid of triangles none of which shares a vertex with another one.
    let terrain = shapes::terrain(1.0);
    let positions: Vec<[f64; 3]> = terrain
        .triangles
        .iter()
        .flat_map(|triangle| triangle.map(|v| terrain.positions[v as usize]))
        .collect();
    let triangles: Vec<[u32; 3]> = (0..terrain.triangles.len() as u32)
        .map(|t| [3 * t, 3 * t + 1, 3 * t + 2])
        .collect();
    let apart = unwrap(&positions, &triangles, &Options::default()).unwrap();
    let joined = made(&terrain, &Options::default());
    assert_eq!(apart.coordinates, joined.coordinates);
}

#[test]
fn a_degenerate_triangle_is_one_point_of_a_neighbour() {
    let positions = [
        [0.0, 0.0, 0.0],
        [1.0, 0.0, 0.0],
        [1.0, 1.0, 0.0],
        [0.5, 0.5, 0.0],
        [9.0, 9.0, 9.0],
    ];
    // The second triangle lies on the diagonal, the third names a vertex twice, and no triangle
    // with area touches the last one.
    let triangles = [[0, 1, 2], [0, 2, 3], [1, 1, 2], [4, 4, 4]];
    let atlas = unwrap(&positions, &triangles, &Options::default()).unwrap();
    let [a, b, c] = atlas.coordinates[0];
    assert!((b[0] - a[0]) * (c[1] - a[1]) > (c[0] - a[0]) * (b[1] - a[1]));
    assert_eq!(atlas.coordinates[1], [a; 3]);
    assert_eq!(atlas.coordinates[2], [b; 3]);
    assert_eq!(atlas.coordinates[3], [a; 3]);
    assert_eq!(atlas.charts, [0; 4]);
    assert_eq!((atlas.report.charts, atlas.report.flipped), (1, 0));
}

#[test]
fn charts_end_where_the_surface_is_not_an_oriented_manifold() {
    // Three triangles at one edge, and a pair whose orientations differ.
    let positions = [
        [0.0, 0.0, 0.0],
        [0.0, 0.0, 1.0],
        [1.0, 0.0, 0.5],
        [-1.0, 0.1, 0.5],
        [0.9, 0.3, 0.5],
        [2.0, 0.0, 1.5],
    ];
    let triangles = [[0, 1, 2], [1, 0, 3], [0, 1, 4], [1, 2, 5]];
    let atlas = unwrap(&positions, &triangles, &Options::default()).unwrap();
    let charts: HashSet<u32> = atlas.charts.iter().copied().collect();
    assert_eq!(charts.len(), 4);
    assert_eq!(
        (atlas.report.flipped, atlas.report.overlapping_texels),
        (0, 0)
    );
}

#[test]
fn a_flat_surface_is_not_stretched() {
    let page = [
        [0.0, 0.0, 3.0],
        [4.0, 0.0, 3.0],
        [4.0, 3.0, 3.0],
        [0.0, 3.0, 3.0],
    ];
    let atlas = unwrap(&page, &[[0, 1, 2], [0, 2, 3]], &options(512, 1)).unwrap();
    assert!((atlas.report.stretch_l2 - 1.0).abs() < 1e-12);
    assert!((atlas.report.stretch_max - 1.0).abs() < 1e-12);
    let length = |a: [f64; 2], b: [f64; 2]| (a[0] - b[0]).hypot(a[1] - b[1]);
    let [a, b, c] = atlas.coordinates[0];
    assert!((length(a, b) / length(b, c) - 4.0 / 3.0).abs() < 1e-12);
    assert!((length(a, c) / length(b, c) - 5.0 / 3.0).abs() < 1e-12);
}

#[test]
fn coordinates_from_elsewhere_are_measured() {
    // A square of two triangles, whose second one is laid over the first one, mirrored.
    let page = [
        [0.0, 0.0, 0.0],
        [1.0, 0.0, 0.0],
        [1.0, 1.0, 0.0],
        [0.0, 1.0, 0.0],
    ];
    let triangles = [[0, 1, 2], [0, 2, 3]];
    let [left, right] = [8.25 / 64.0, 56.25 / 64.0];
    let [a, b, c] = [[left, 0.125], [right, 0.125], [right, 0.875]];
    let options = options(64, 0);
    let report = measure(&page, &triangles, &[[a, b, c], [a, c, b]], &options).unwrap();
    assert_eq!((report.charts, report.flipped), (1, 1));
    // Row j of 48 has the centres to the right of its own column.
    assert_eq!(report.overlapping_texels, 48 * 47 / 2);
    let report = measure(
        &page,
        &triangles,
        &[[a, b, c], [a, c, [left, 0.875]]],
        &options,
    );
    let report = report.unwrap();
    assert_eq!(
        (report.charts, report.flipped, report.overlapping_texels),
        (1, 0, 0)
    );
    assert_eq!(report.utilisation, 0.75 * 0.75);
    assert!((report.stretch_l2 - 1.0).abs() < 1e-12);

    let torus = shapes::torus(40, 24, [1.0, 0.4]);
    let atlas = made(&torus, &Options::default());
    let (positions, triangles) = (&torus.positions, &torus.triangles);
    let again = measure(
        positions,
        triangles,
        &atlas.coordinates,
        &Options::default(),
    )
    .unwrap();
    assert_eq!(
        (again.charts, again.overlapping_texels),
        (atlas.report.charts, 0)
    );
    assert!((again.stretch_l2 - atlas.report.stretch_l2).abs() < 1e-12);

    let error = measure(positions, triangles, &[], &Options::default()).unwrap_err();
    let expected = triangles.len();
    assert_eq!(error, TextureSpaceError::Coordinates { expected, found: 0 });
    for bad in [f64::NAN, -0.5, 1.5, f64::INFINITY] {
        let corners = [[a, b, c], [a, c, [bad, 0.5]]];
        let error = measure(&page, &[[0, 1, 2], [0, 2, 3]], &corners, &options).unwrap_err();
        assert_eq!(error, TextureSpaceError::OutsideSquare { face: 1 });
    }
}

#[test]
fn bad_input_is_an_error_that_names_the_element() {
    let page = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]];
    let whole = [[0, 1, 2]];
    let default = Options::default();
    let error = |positions: &[[f64; 3]], triangles: &[[u32; 3]], options: &Options| {
        unwrap(positions, triangles, options).unwrap_err()
    };
    assert_eq!(error(&page, &[], &default), TextureSpaceError::NoFaces);
    assert_eq!(
        error(&page, &[[0, 0, 1], [2, 2, 2]], &default),
        TextureSpaceError::NoArea { faces: 2 }
    );
    assert_eq!(
        error(&page, &[[0, 1, 2], [0, 3, 1]], &default),
        TextureSpaceError::IndexOutOfRange {
            face: 1,
            index: 3,
            vertices: 3
        }
    );
    for bad in [f64::NAN, f64::INFINITY] {
        let positions = [page[0], [0.0, bad, 0.0], page[2]];
        assert_eq!(
            error(&positions, &whole, &default),
            TextureSpaceError::NotFinite { vertex: 1 }
        );
    }
    for size in [0, 16_385] {
        assert_eq!(
            error(&page, &whole, &options(size, 1)),
            TextureSpaceError::Size { size }
        );
    }
    let cramped = TextureSpaceError::DoesNotFit {
        charts: 1,
        margin_texels: 8,
        size: 16,
    };
    assert_eq!(error(&page, &whole, &options(16, 8)), cramped);
}
