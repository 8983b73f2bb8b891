//! How the views are combined: against weights by hand, and colours that continue.

use ga_camera::{Camera, Intrinsics, Lens};
use ga_image::colour::linear_from_srgb;
use ga_image::plane::Plane;
use ga_mesh::{Mesh, obj};
use ga_vision::texture::{Options, Textured, View, texture_mesh};

use super::texture::{SIZE, WALL, camera, photograph, samples};

/// A square of side 2 that fills the texture.
const SQUARE: &[u8] = b"v -1 -1 0\nv 1 -1 0\nv 1 1 0\nv -1 1 0\n\
    vt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\nf 1/1 2/2 3/3 4/4\n";

fn unlevelled(mesh: &Mesh, views: &[View], size: u32) -> Textured {
    let mut options = Options::with_size(size);
    options.level_exposure = false;
    texture_mesh(mesh, views, &options, |_| ()).unwrap()
}

fn evenly(name: &str, camera: Camera, colour: [u8; 3]) -> View {
    View::new(name, camera, None, &Plane::filled(SIZE[0], SIZE[1], colour)).unwrap()
}

/// Of even colours a texel shows the mean with the weights f² cos²θ/r².
#[test]
fn views_count_by_their_pixels_and_by_the_angle_of_incidence() {
    let mesh = obj::decode(SQUARE).unwrap();
    let ahead = camera([0.0, 0.0, 5.0], [0.0; 3], Lens::Pinhole);
    let (sine, cosine) = 1.0_f64.sin_cos();
    let aside = camera([5.0 * sine, 0.0, 5.0 * cosine], [0.0; 3], Lens::Pinhole);
    let far = camera([0.0, 0.0, 8.0], [0.0; 3], Lens::Pinhole);
    let mut long = ahead;
    let focal = ahead.intrinsics.focal().map(|f| 1.2 * f);
    long.intrinsics = Intrinsics::new(focal, ahead.intrinsics.principal()).unwrap();
    for (other, weight) in [
        (aside, cosine * cosine),
        (far, 25.0 / 64.0),
        (long, 1.44),
        (ahead, 1.0),
    ] {
        let views = [
            evenly("red", ahead, [200, 0, 0]),
            evenly("blue", other, [0, 0, 200]),
        ];
        let textured = unlevelled(&mesh, &views, 64);
        let [red, green, blue] = textured.texture.get(32, 32).unwrap();
        let light = |code: u8| linear_from_srgb(f64::from(code) / 255.0);
        let expected = [1.0, weight].map(|w| light(200) * w / (1.0 + weight));
        assert_eq!(green, 0);
        for (found, expected) in [red, blue].into_iter().zip(expected) {
            let found = light(found);
            assert!(
                (found - expected).abs() < 0.01,
                "{weight}: {found} {expected}"
            );
        }
    }
}

/// Where one of two views stops seeing the wall, the texture has no hard edge: the next texel has
/// less than half of the difference.
#[test]
fn weights_fall_smoothly_where_something_hides_the_surface() {
    let text = String::from_utf8(WALL.to_vec()).unwrap();
    let text = text
        .replace(
            "f 1 2 3 4",
            "vt 0 0\nvt 0.75 0\nvt 0.75 0.75\nvt 0 0.75\nf 1/1 2/2 3/3 4/4",
        )
        .replace(
            "f 5 6 7 8",
            "vt 0.8 0.8\nvt 1 0.8\nvt 1 1\nvt 0.8 1\nf 5/5 6/6 7/7 8/8",
        );
    let mesh = obj::decode(text.as_bytes()).unwrap();
    let one = camera([0.0, 0.0, 5.0], [0.0; 3], Lens::Pinhole);
    let other = camera([2.5, 0.0, 4.5], [0.0; 3], Lens::Pinhole);
    let views = [
        evenly("red", one, [200, 30, 30]),
        evenly("blue", other, [30, 30, 200]),
    ];
    let textured = unlevelled(&mesh, &views, 256);
    // Upwards along x = 0.25, which the square hides from the first view up to y = 0.5.
    let light = |y: f64| {
        let [u, v] = [0.25, y].map(|place| 0.75 * (place + 2.0) / 4.0);
        let [column, row] = [u, 1.0 - v].map(|x| (256.0 * x) as usize);
        linear_from_srgb(f64::from(textured.texture.get(column, row).unwrap()[0]) / 255.0)
    };
    let (hidden, seen) = (light(0.0), light(1.4));
    assert!(seen > hidden + 0.1, "{seen} {hidden}");
    let steps = (0..67).map(|k| (light(k as f64 / 48.0) - light((k + 1) as f64 / 48.0)).abs());
    let steepest = steps.fold(0.0, f64::max);
    assert!(
        steepest < 0.4 * (seen - hidden),
        "{steepest} {seen} {hidden}"
    );
}

/// Around a chart texels are as at its border, and none of the texture is black.
#[test]
fn the_border_of_a_chart_is_continued() {
    let text = String::from_utf8(SQUARE.to_vec()).unwrap();
    let [small, large] = [" 0.25", " 0.75"];
    let inner = text
        .replace("vt 0 0", &["vt", small, small].concat())
        .replace("vt 1 0", &["vt", large, small].concat())
        .replace("vt 1 1", &["vt", large, large].concat())
        .replace("vt 0 1", &["vt", small, large].concat());
    let mesh = obj::decode(inner.as_bytes()).unwrap();
    let camera = camera([0.0, 0.0, 5.0], [0.0; 3], Lens::Pinhole);
    let paint = |[x, _, _]: [f64; 3]| [0.3 + 0.2 * x, 0.2, 0.6 - 0.2 * x];
    let picture = photograph(&mesh, &camera, 1.0, paint);
    let view = View::new("front", camera, None, &picture).unwrap();
    let textured = unlevelled(&mesh, &[view], 64);
    let at = |column, row| textured.texture.get(column, row).unwrap();
    for row in 18..46 {
        for steps in 1..=4 {
            let near = |a: [u8; 3], b: [u8; 3]| (0..3).all(|k| a[k].abs_diff(b[k]) <= 2);
            assert!(near(at(16 - steps, row), at(16, row)), "{row} {steps}");
            assert!(near(at(47 + steps, row), at(47, row)), "{row} {steps}");
        }
    }
    let texels = textured.texture.values();
    assert!(
        texels
            .iter()
            .all(|texel| texel.iter().all(|code| *code > 40))
    );
}

/// A side that no view sees takes the colours of the side beside it, from the edge they share on
/// the surface, though they are apart in the texture.
#[test]
fn holes_are_filled_across_the_seams_of_the_atlas() {
    let text = b"v -1 -1 0\nv 0 -1 0\nv 0 1 0\nv -1 1 0\nv 0 -1 -1\nv 0 1 -1\n\
        vt 0 0\nvt 0.4 0\nvt 0.4 0.4\nvt 0 0.4\nvt 0.6 0.55\nvt 1 0.55\nvt 1 0.95\n\
        vt 0.6 0.95\nf 1/1 2/2 3/3 4/4\nf 2/5 5/6 6/7 3/8\n";
    let mesh = obj::decode(text).unwrap();
    let camera = camera([-1.5, 0.0, 5.0], [-0.5, 0.0, 0.0], Lens::Pinhole);
    let paint = |[_, y, _]: [f64; 3]| [0.4 + 0.3 * y, 0.3, 0.4 - 0.3 * y];
    let picture = photograph(&mesh, &camera, 1.0, paint);
    let view = View::new("front", camera, None, &picture).unwrap();
    let textured = unlevelled(&mesh, &[view], 128);
    assert_eq!(textured.report.charts, 2);
    let mut compared = 0;
    for (place, light) in samples(&textured) {
        let [x, y, z] = place;
        if x == 0.0 && z > -0.15 && z < 0.0 && y.abs() < 0.5 {
            let truth = paint(place);
            assert!(
                (0..3).all(|k| (light[k] - truth[k]).abs() < 0.06),
                "{place:?} {light:?}"
            );
            compared += 1;
        }
    }
    assert!(compared > 5, "{compared}");
}
