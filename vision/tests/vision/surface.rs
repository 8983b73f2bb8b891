//! Surfaces from disparity, against planes at known places.

use std::sync::Arc;

use ga_camera::Intrinsics;
use ga_camera::rig::RectifiedRig;
use ga_files::Reading;
use ga_image::plane::Plane;
use ga_mesh::format;
use ga_runtime::cga3::{Motor, Plane as Flat, Point, Rotor};
use ga_vision::disparity::{DisparityMap, DisparityMapError};
use ga_vision::matcher::{Matcher, MatcherOptions, Mode};
use ga_vision::surface::{
    DISPARITY_DEVIATION, PairOptions, RectifiedPair, Surface, SurfaceOptions, disparity_range,
    seen_by_both,
};
use proptest::prelude::*;

const SIZE: [usize; 2] = [48, 32];

/// A rig whose principal points are in different columns.
fn rig() -> RectifiedRig {
    let camera = |column| Intrinsics::new([60.0, 58.0], [column, 15.2]).unwrap();
    RectifiedRig::new(camera(23.7), camera(26.2), 0.12).unwrap()
}

/// The disparities of the nearest of some planes, each with its normal, in the left camera's frame,
/// by rays through the pixels; `None` where there is none in front.
fn map_of(planes: &[([f64; 3], [f64; 3])]) -> (DisparityMap, Vec<Option<usize>>) {
    let rig = rig();
    let cameras = rig.stereo_rig();
    let mut owners = Vec::new();
    let pixels = Plane::from_fn(SIZE[0], SIZE[1], |column, row| {
        let ray = cameras.left.ray([column as f64, row as f64]).unwrap();
        let hits = planes
            .iter()
            .enumerate()
            .filter_map(|(index, (point, normal))| {
                let plane = Flat::from_point_normal(Point::from(*point), *normal);
                Some((index, ray.first_hit(plane)?))
            });
        let nearest = hits.min_by(|a, b| a.1.distance.total_cmp(&b.1.distance));
        owners.push(nearest.map(|(index, _)| index));
        nearest.map_or(f32::NAN, |(_, hit)| {
            // Both cameras see the point in one row.
            let [left, right] =
                [cameras.left, cameras.right].map(|camera| camera.project(hit.point).unwrap());
            assert!((left[1] - right[1]).abs() < 1e-12);
            (left[0] - right[0]) as f32
        })
    });
    (DisparityMap::new(pixels), owners)
}

proptest! {
    /// The points of a plane lie on it, as accurately as a disparity in f32 says, and the normals
    /// are its normal, towards the camera.
    #[test]
    fn planes_are_found_where_they_are(
        tilt in prop::array::uniform2(-0.4..0.4),
        depth in 1.0..6.0_f64,
    ) {
        let normal = [tilt[0], tilt[1], -1.0];
        let (map, _) = map_of(&[([0.0, 0.0, depth], normal)]);
        let options = SurfaceOptions {
            depth_deviation: f64::INFINITY,
            ..SurfaceOptions::default()
        };
        let surface = Surface::new(&map, &rig(), &options).unwrap();
        prop_assert_eq!(surface.points().len(), map.known());
        let plane = Flat::from_point_normal(Point::new(0.0, 0.0, depth), normal);
        let cameras = rig().stereo_rig();
        for (point, pixel) in surface.points().iter().zip(surface.pixels()) {
            let z = point.coordinates()[2];
            // The depth is f B/d: its error is that of d times z/d.
            let bound = 60.0 * 0.12 / z;
            let rounding = f64::from(f32::EPSILON) * (bound + 2.5) * z / bound;
            prop_assert!(plane.distance_to(*point).unwrap() <= rounding, "{point:?}");
            let [u, v] = cameras.left.project(*point).unwrap();
            prop_assert!((u - f64::from(pixel[0])).abs() < 1e-9 && (v - f64::from(pixel[1])).abs() < 1e-9);
        }
        prop_assert_eq!(surface.triangles().len(), 2 * (SIZE[0] - 1) * (SIZE[1] - 1));
        let length = (tilt[0] * tilt[0] + tilt[1] * tilt[1] + 1.0).sqrt();
        for found in surface.normals() {
            let found = found.unwrap().coordinates();
            for axis in 0..3 {
                prop_assert!((found[axis] - normal[axis] / length).abs() < 1e-4 * depth, "{found:?}");
            }
        }
    }

    /// No triangle joins a wall and what stands before it, and each side keeps all of its own.
    #[test]
    fn surfaces_are_cut_at_depth_jumps(edge in -0.3..0.3_f64, near in 0.8..1.5_f64) {
        // Half of the picture sees a near plane, the other half a wall; columns decide.
        let rig = rig();
        let column = 23.7 + 60.0 * edge;
        let pixels = Plane::from_fn(SIZE[0], SIZE[1], |u, _| {
            let depth = if (u as f64) < column { near } else { 4.0 };
            rig.disparity(depth).unwrap() as f32
        });
        let surface = Surface::new(&DisparityMap::new(pixels), &rig, &SurfaceOptions::default()).unwrap();
        for triangle in surface.triangles() {
            let depths = triangle.map(|corner| surface.points()[corner as usize].coordinates()[2]);
            prop_assert!((depths[0] - depths[1]).abs() + (depths[1] - depths[2]).abs() < 1e-5);
        }
        prop_assert_eq!(surface.triangles().len(), 2 * (SIZE[0] - 2) * (SIZE[1] - 1));
    }

    /// Moving the surface moves its points and normals, and not its triangles.
    #[test]
    fn surfaces_move_as_a_whole(angle in -3.0..3.0_f64) {
        let (map, _) = map_of(&[([0.0, 0.0, 2.0], [0.2, -0.1, -1.0])]);
        let surface = Surface::new(&map, &rig(), &SurfaceOptions::default()).unwrap();
        let rotor = Rotor::from_axis_angle([0.3, 1.0, -0.2], angle).unwrap();
        let moved = surface.clone().moved(&Motor::from(rotor));
        prop_assert_eq!(surface.triangles(), moved.triangles());
        for (before, after) in surface.points().iter().zip(moved.points()) {
            prop_assert!(rotor.transform(*before).distance(*after) < 1e-12);
        }
        for (before, after) in surface.normals().iter().zip(moved.normals()) {
            let [before, after] = [before.unwrap(), after.unwrap()].map(Point::from);
            prop_assert!(rotor.transform(before).distance(after) < 1e-9);
        }
    }
}

/// A square of pixels with one unknown keeps the triangle of the other three, and the diagonal
/// joins the more similar corners.
#[test]
fn squares_are_halved_where_they_agree() {
    let triangles = |values: [f32; 4]| {
        let map = DisparityMap::new(Plane::from_values(2, 2, values.to_vec()).unwrap());
        let surface = Surface::new(&map, &rig(), &SurfaceOptions::default()).unwrap();
        surface
            .triangles()
            .iter()
            .map(|corners| {
                let mut pixels = corners.map(|corner| surface.pixels()[corner as usize]);
                pixels.sort_unstable();
                pixels
            })
            .collect::<Vec<_>>()
    };
    let [a, b, c, d] = [[0, 0], [0, 1], [1, 1], [1, 0]];
    let none = f32::NAN;
    assert_eq!(triangles([none, 5.0, 5.0, 5.0]), [[b, d, c]]);
    assert_eq!(triangles([5.0, 5.0, none, 5.0]), [[a, d, c]]);
    assert_eq!(triangles([5.0, none, none, 5.0]), [[[0; 2]; 3]; 0]);
    // The upper left and lower right corners agree; then the other two.
    assert_eq!(triangles([5.0, 5.5, 4.6, 5.0]), [[a, b, c], [a, d, c]]);
    assert_eq!(triangles([5.5, 5.0, 5.0, 4.6]), [[a, b, d], [b, d, c]]);
    // One corner is cut off.
    assert_eq!(triangles([9.0, 5.0, 5.0, 5.0]), [[b, d, c]]);
}

#[test]
fn steps_depths_and_views_choose_points() {
    let (map, owners) = map_of(&[
        ([0.0, 0.0, 2.0], [0.0, 0.0, -1.0]),
        ([0.9, 0.0, 1.0], [-1.0, 0.0, -0.4]),
    ]);
    assert!(owners.contains(&Some(0)) && owners.contains(&Some(1)));
    let count = |options: SurfaceOptions| {
        let surface = Surface::new(&map, &rig(), &options).unwrap();
        (surface.points().len(), surface.triangles().len())
    };
    let all = SurfaceOptions::default();
    assert_eq!(count(all).0, SIZE[0] * SIZE[1]);
    assert_eq!(
        count(SurfaceOptions { step: 4, ..all }).0,
        SIZE[0] * SIZE[1] / 16
    );
    let far = SurfaceOptions {
        depths: [1.999, 2.001],
        ..all
    };
    assert_eq!(
        count(far).0,
        owners.iter().filter(|owner| **owner == Some(0)).count()
    );
    // Both cameras see a point whose disparity is at most its column, rounded, and none in a column
    // of the right view that is outside.
    let whole = Plane::filled(SIZE[0], SIZE[1], true);
    let partly = Plane::from_fn(SIZE[0], SIZE[1], |column, _| column != 7);
    let seen = seen_by_both(&map, [whole.view(), partly.view()]).unwrap();
    for row in 0..SIZE[1] {
        for column in 0..SIZE[0] {
            let disparity = map.get(column, row).unwrap();
            let place = (column as f32 - disparity + 0.5).floor();
            let expected = (place >= 0.0 && place != 7.0).then_some(disparity);
            assert_eq!(seen.get(column, row), expected);
        }
    }
    assert!(seen.known() <= map.known() - SIZE[1]);
    let none = seen_by_both(
        &map,
        [Plane::filled(SIZE[0], SIZE[1], false).view(), whole.view()],
    );
    assert_eq!(none.unwrap().known(), 0);
    assert!(seen_by_both(&map, [whole.view(), Plane::filled(3, 3, true).view()]).is_err());
}

/// The range is that of the scene, whatever the size of the views.
#[test]
fn the_range_of_disparities_is_found() {
    let level = |column: usize, row: usize| {
        let mixed = (column as u32).wrapping_mul(2_654_435_761) ^ (row as u32).wrapping_mul(40_503);
        (mixed.wrapping_mul(2_246_822_519) >> 24) as u8
    };
    // Blocks of four pixels, so that the texture remains where the views are halved.
    for (width, shift) in [(240, 20), (640, 40), (640, 88)] {
        let view = |shift: usize| {
            Plane::from_fn(width, 120, |column, row| {
                level((column + shift) / 4, row / 4)
            })
        };
        let range = disparity_range(&view(0), &view(shift), 1).unwrap();
        assert!(
            range > shift && range <= shift + 48 && range.is_multiple_of(16),
            "{range} {shift}"
        );
    }
    assert!(disparity_range(&Plane::filled(3, 3, 0u8), &Plane::filled(3, 3, 0u8), 1).is_err());
    // Flat views keep enough rows, and very wide ones get a range that a matcher accepts.
    let view =
        |shift: usize| Plane::from_fn(2000, 40, |column, row| level((column + shift) / 4, row / 4));
    let range = disparity_range(&view(0), &view(100), 1).unwrap();
    assert!(range > 100 && range <= 160, "{range}");
    let wide = Plane::filled(3100, 10, 90u8);
    let options = MatcherOptions {
        range: [0, disparity_range(&wide, &wide, 1).unwrap() as i32],
        mode: Mode::Fast,
        threads: 1,
    };
    assert!(Matcher::new(options, 3100, 10).is_ok());
}

fn ramp() -> Plane<[u8; 3]> {
    Plane::from_fn(SIZE[0], SIZE[1], |column, row| {
        [5 * column as u8, 7 * row as u8, 128]
    })
}

#[test]
fn models_survive_their_files() {
    let (map, _) = map_of(&[([0.0, 0.0, 2.0], [0.1, 0.0, -1.0])]);
    let surface = Surface::new(&map, &rig(), &SurfaceOptions::default()).unwrap();
    let folder = tempfile::tempdir().unwrap();
    let picture = ga_image::png::encode(&ramp()).unwrap();
    let models = [
        ("cloud", surface.to_cloud(&ramp()).unwrap()),
        ("mesh", surface.to_mesh(&ramp()).unwrap()),
        (
            "textured",
            surface
                .to_textured_mesh("image/png", Arc::from(picture))
                .unwrap(),
        ),
    ];
    for (name, mesh) in &models {
        for ending in ["ply", "obj", "glb"] {
            let path = folder.path().join(format!("{name}.{ending}"));
            format::write(&path, mesh, &format::Options::default()).unwrap();
            let again = format::read(&path, Reading::Tolerant).unwrap().0;
            assert_eq!(
                again.vertex_count(),
                surface.points().len(),
                "{name}.{ending}"
            );
            assert_eq!(again.faces().len(), mesh.faces().len());
            let Some(colours) = again.colours() else {
                assert_eq!(*name, "textured");
                continue;
            };
            for (colour, pixel) in colours.iter().zip(surface.pixels()) {
                let code = f64::from(ramp().get(pixel[0] as usize, pixel[1] as usize).unwrap()[0]);
                // The exact curve of sRGB.
                let code = code / 255.0;
                let light = if code <= 0.04045 {
                    code / 12.92
                } else {
                    ((code + 0.055) / 1.055).powf(2.4)
                };
                assert!((colour[0] - light).abs() < 3e-3, "{name}.{ending}");
            }
        }
    }
    // The centre of the first pixel of the picture is half a pixel from its left and upper edge.
    let places = &models[2].1.texture_coordinates().unwrap().values;
    assert_eq!(places[0], [0.5 / 48.0, 1.0 - 0.5 / 32.0]);
}

#[test]
fn faulty_surfaces_are_errors() {
    let (map, _) = map_of(&[([0.0, 0.0, 2.0], [0.0, 0.0, -1.0])]);
    let rig = rig();
    let error = |options: SurfaceOptions| Surface::new(&map, &rig, &options).unwrap_err();
    let all = SurfaceOptions::default();
    assert_eq!(
        error(SurfaceOptions { cut_px: 0.0, ..all }),
        DisparityMapError::Cut(0.0)
    );
    assert!(matches!(
        error(SurfaceOptions {
            cut_px: f64::NAN,
            ..all
        }),
        DisparityMapError::Cut(_)
    ));
    assert_eq!(
        error(SurfaceOptions { step: 0, ..all }),
        DisparityMapError::Step
    );
    let depths = [3.0, 2.0];
    assert_eq!(
        error(SurfaceOptions { depths, ..all }),
        DisparityMapError::Depths(3.0, 2.0)
    );
    let pixels = SIZE[0] * SIZE[1];
    assert_eq!(
        error(SurfaceOptions {
            depths: [3.0, 4.0],
            ..all
        }),
        DisparityMapError::Empty {
            pixels,
            uncertain: 0
        }
    );
    // At infinity and behind the cameras there are no points.
    for disparity in [f32::NAN, -2.5, -10.0] {
        let map = DisparityMap::new(Plane::filled(4, 4, disparity));
        let error = Surface::new(&map, &rig, &all).unwrap_err();
        let (pixels, uncertain) = (16, 0);
        assert_eq!(error, DisparityMapError::Empty { pixels, uncertain });
    }
    assert!(matches!(
        Surface::new(&DisparityMap::default(), &rig, &all),
        Err(DisparityMapError::Empty { pixels: 0, .. })
    ));
    let surface = Surface::new(&map, &rig, &all).unwrap();
    let small = Plane::filled(4, 4, [0u8; 3]);
    assert!(matches!(
        surface.to_mesh(&small),
        Err(DisparityMapError::PictureSize {
            picture: [4, 4],
            ..
        })
    ));
    assert!(matches!(
        surface.to_cloud(&small),
        Err(DisparityMapError::PictureSize { .. })
    ));
    // A chessboard of depths has points and no triangle.
    let board = Plane::from_fn(8, 8, |u, v| if (u + v) % 2 == 0 { 5.0 } else { 15.0 });
    let torn = Surface::new(&DisparityMap::new(board), &rig, &all).unwrap();
    assert_eq!((torn.points().len(), torn.triangles().len()), (64, 0));
    let picture = Plane::filled(8, 8, [0u8; 3]);
    assert!(matches!(
        torn.to_mesh(&picture),
        Err(DisparityMapError::NoTriangles)
    ));
    assert_eq!(torn.to_cloud(&picture).unwrap().vertex_count(), 64);
}

/// Random blocks, and the same at a disparity of 21 px.
#[test]
fn a_rectified_pair_has_its_disparities_where_they_are_certain() {
    let grey = |u: usize, v: usize| {
        let block = (u / 4 + 1) * 7919 + (v / 4 + 1) * 104_729;
        [(block * block / 977 % 200) as u8; 3]
    };
    let view = |shift: usize| Plane::from_fn(400, 160, |u, v| grey(u + shift, v));
    let pair = RectifiedPair::new(&[view(0).into(), view(21).into()], rig());
    let options = PairOptions {
        threads: 1,
        ..PairOptions::default()
    };
    let found = pair.disparities(&options).unwrap();
    let (map, [least, beyond]) = (found.disparity, found.range);
    assert!(least == 0 && beyond > 21, "{beyond}");
    assert!(found.faults.is_empty());
    let right = (0..160).flat_map(|v| (40..400).map(move |u| (u, v)));
    let near = right.filter(|&(u, v)| map.get(u, v).is_some_and(|d| (d - 21.0).abs() < 0.5));
    assert!(near.count() > 160 * 360 * 9 / 10);
    let none = pair
        .disparities(&PairOptions {
            max_disparity: Some(32),
            least_confidence: 1.5,
            ..options
        })
        .unwrap();
    assert_eq!((none.disparity.known(), none.range), (0, [0, 32]));
}

/// The relative deviation is 0.25 px / (d + offset): 1/4 at 1 px, 1/10 at 2.5 px.
#[test]
fn depths_that_noise_decides_are_left_out() {
    let rig = rig();
    let offset = rig.disparity_offset() as f32;
    let values = [-1.0, 0.055, 0.9, 1.1, 2.4, 2.6, 30.0].map(|d| d - offset);
    let row = [values, values].concat();
    let map = DisparityMap::new(Plane::from_values(7, 2, row).unwrap());
    let found = |options: SurfaceOptions| {
        let surface = Surface::new(&map, &rig, &options).unwrap();
        (surface.points().len(), surface.summary())
    };
    let all = SurfaceOptions::default();
    for (depth_deviation, points) in [(0.25, 8), (0.1, 4), (f64::INFINITY, 12)] {
        let (count, summary) = found(SurfaceOptions {
            depth_deviation,
            ..all
        });
        assert_eq!((count, summary.uncertain), (points, 12 - points));
        let limit = depth_deviation * 60.0 * 0.12 / DISPARITY_DEVIATION;
        assert!(summary.farthest <= limit, "{}", summary.farthest);
    }
    // What is out of the range of depths is not counted.
    let depths = [0.0, 7.0];
    assert_eq!(found(SurfaceOptions { depths, ..all }).1.uncertain, 0);
    for depth_deviation in [0.0, -1.0, f64::NAN] {
        let error = Surface::new(
            &map,
            &rig,
            &SurfaceOptions {
                depth_deviation,
                ..all
            },
        );
        assert!(matches!(error, Err(DisparityMapError::DepthDeviation(_))));
    }
    let far = DisparityMap::new(Plane::filled(2, 2, 0.1 - offset));
    let error = Surface::new(&far, &rig, &all).unwrap_err();
    assert!(
        error.to_string().contains("4 of them are left out for it"),
        "{error}"
    );
}

#[test]
fn depths_are_summed_up() {
    // A wall at 0.1 · 500/25 = 2 m, with one pixel at 1 m and one that is not known.
    let camera = Intrinsics::new([500.0, 500.0], [1.5, 1.0]).unwrap();
    let rig = RectifiedRig::new(camera, camera, 0.1).unwrap();
    let mut values = vec![25.0; 12];
    values[5] = 50.0;
    values[6] = f32::NAN;
    let map = DisparityMap::new(Plane::from_values(4, 3, values).unwrap());
    let found = Surface::new(&map, &rig, &SurfaceOptions::default());
    let found = found.unwrap().summary();
    assert_eq!(
        [found.nearest, found.median, found.farthest],
        [1.0, 2.0, 2.0]
    );
    assert!((found.density - 100.0 * 11.0 / 12.0).abs() < 1e-12);
}
