//! Textures from views: against colours that are functions of the place.

use std::f64::consts::TAU;

use ga_camera::{Camera, Fisheye, Intrinsics, Lens, RadialTangential};
use ga_image::colour::{LinearColour, SrgbEncoder, linear_from_srgb};
use ga_image::plane::Plane;
use ga_mesh::TextureSpaceError;
use ga_mesh::query::Bvh;
use ga_mesh::{Faces, Mesh, obj};
use ga_runtime::cga3::Point;
use ga_vision::texture::{
    Options, TextureError, Textured, TriangleWarp, View, affine_error, texture_mesh,
};
use proptest::prelude::*;

pub(super) const SIZE: [usize; 2] = [200, 160];

/// A cube of side 2 around the origin, as its six sides.
fn cube() -> Mesh {
    let corners = (0..8).map(|i: u32| [0, 1, 2].map(|k| f64::from((i >> k) & 1) * 2.0 - 1.0));
    let mut text: String = corners
        .map(|[x, y, z]| format!("v {x} {y} {z}\n"))
        .collect();
    text += "f 1 3 4 2\nf 5 6 8 7\nf 1 2 6 5\nf 3 7 8 4\nf 1 5 7 3\nf 2 4 8 6\n";
    obj::decode(text.as_bytes()).unwrap()
}

/// The linear light of a place: smooth, and different everywhere.
fn paint([x, y, z]: [f64; 3]) -> [f64; 3] {
    let wave = |s: f64| 0.35 + 0.2 * (2.5 * s).sin();
    [
        wave(x + 0.3 * y),
        wave(y - 0.4 * z + 1.0),
        wave(z + 0.2 * x + 2.0),
    ]
}

/// What a camera sees of a painted mesh, times a gain, by 3 × 3 rays for each pixel.
pub(super) fn photograph(
    mesh: &Mesh,
    camera: &Camera,
    gain: f64,
    paint: impl Fn([f64; 3]) -> [f64; 3],
) -> Plane<[u8; 3]> {
    let positions: Vec<[f64; 3]> = mesh.coordinates().collect();
    let bvh = Bvh::new(&positions, &mesh.triangles()).unwrap();
    let encoder = SrgbEncoder::new();
    Plane::from_fn(SIZE[0], SIZE[1], |column, row| {
        let mut sum = [0.0; 3];
        for part in 0..9 {
            let offset = |k: usize| (k as f64 - 1.0) / 3.0;
            let pixel = [
                column as f64 + offset(part % 3),
                row as f64 + offset(part / 3),
            ];
            let ray = camera.ray(pixel);
            let hit = ray.ok().and_then(|ray| bvh.first_hit(ray));
            let colour = hit.map_or([0.02; 3], |hit| paint(hit.hit.point.coordinates()));
            for (sum, value) in sum.iter_mut().zip(colour) {
                *sum += gain * value / 9.0;
            }
        }
        encoder.encode(LinearColour::from(sum))
    })
}

pub(super) fn camera(eye: [f64; 3], target: [f64; 3], lens: Lens) -> Camera {
    let principal = SIZE.map(|side| (side as f64 - 1.0) / 2.0);
    let intrinsics = Intrinsics::new([230.0, 235.0], principal).unwrap();
    let eye = Point::from(eye);
    Camera::look_at(
        intrinsics.with_lens(lens),
        eye,
        target.into(),
        [0.1, 1.0, 0.2],
    )
    .unwrap()
}

/// Eight cameras, four above and four below.
fn around(lens: Lens) -> Vec<Camera> {
    let place = |k: u32| {
        let angle = TAU * (f64::from(k) / 4.0 + 0.07);
        let height = if k < 4 { 3.0 } else { -3.0 };
        [4.0 * angle.cos(), height, 4.0 * angle.sin()]
    };
    (0..8).map(|k| camera(place(k), [0.0; 3], lens)).collect()
}

fn view(name: &str, mesh: &Mesh, camera: &Camera, gain: f64) -> View {
    let picture = photograph(mesh, camera, gain, paint);
    View::new(name, *camera, Some(SIZE), &picture).unwrap()
}

fn views(mesh: &Mesh, cameras: &[Camera], gains: &[f64]) -> Vec<View> {
    let all = cameras.iter().zip(gains.iter().cycle()).enumerate();
    all.map(|(k, (camera, gain))| view(&format!("view {k}"), mesh, camera, *gain))
        .collect()
}

/// The texel that shows a point of a triangle, as linear light.
fn texel(textured: &Textured, corners: &[[f64; 2]; 3], weights: [f64; 3]) -> [f64; 3] {
    let place = |axis: usize| (0..3).map(|i| weights[i] * corners[i][axis]).sum::<f64>();
    let side = textured.texture.width();
    let pixel = |x: f64| ((x * side as f64) as usize).min(side - 1);
    let found = textured.texture.get(pixel(place(0)), pixel(1.0 - place(1)));
    found
        .unwrap()
        .map(|code| linear_from_srgb(f64::from(code) / 255.0))
}

/// For points all over the mesh, the place and what the texture shows there.
pub(super) fn samples(textured: &Textured) -> Vec<([f64; 3], [f64; 3])> {
    let coordinates = ga_mesh::bake::corner_coordinates(&textured.mesh, 0).unwrap();
    let positions: Vec<[f64; 3]> = textured.mesh.coordinates().collect();
    let mut found = Vec::new();
    for (triangle, corners) in textured.mesh.triangles().iter().zip(&coordinates) {
        for (i, j) in (0..20).flat_map(|i| (0..20 - i).map(move |j| (i, j))) {
            let [v, w] = [i, j].map(|k: u32| (f64::from(k) + 0.3) / 21.0);
            let weights = [1.0 - v - w, v, w];
            let place = [0, 1, 2].map(|axis| {
                (0..3)
                    .map(|k| weights[k] * positions[triangle[k] as usize][axis])
                    .sum()
            });
            found.push((place, texel(textured, corners, weights)));
        }
    }
    found
}

/// The mean and the greatest difference of light between a texture, times a factor, and the paint.
fn errors(textured: &Textured, factor: f64) -> [f64; 2] {
    let found = samples(textured);
    let differences = found.iter().flat_map(|(place, light)| {
        let truth = paint(*place);
        [0, 1, 2].map(|k| (factor * light[k] - truth[k]).abs())
    });
    let (sum, most) = differences.fold((0.0, 0.0), |(sum, most): (f64, f64), x| {
        (sum + x, most.max(x))
    });
    [sum / (3 * found.len()) as f64, most]
}

#[test]
fn texels_show_what_is_painted_at_their_place() {
    let mesh = cube();
    let barrel = RadialTangential::new(&[-0.2, 0.05, 0.001, -0.002]).unwrap();
    let fisheye = Fisheye::new(&[0.02, -0.003, 0.0, 0.0]).unwrap();
    for lens in [Lens::Pinhole, barrel.into(), fisheye.into()] {
        let views = views(&mesh, &around(lens), &[1.0]);
        let textured = texture_mesh(&mesh, &views, &Options::with_size(256), |_| ()).unwrap();
        let [mean, most] = errors(&textured, 1.0);
        // A code of sRGB is 0.005 at this light, and a texel 0.013 wide.
        assert!(mean < 0.004 && most < 0.05, "{lens:?}: {mean}, {most}");
        // At corners every view mixes in what is behind them.
        assert!(textured.report.filled_texels < textured.report.covered_texels / 1000);
        assert!(textured.report.unwrapped);
    }
}

#[test]
fn exposures_are_levelled() {
    let mesh = cube();
    let gains = [0.5, 1.0, 1.6];
    let cameras = around(Lens::Pinhole);
    let views = views(&mesh, &cameras, &gains);
    let mut options = Options::with_size(256);
    let textured = texture_mesh(&mesh, &views, &options, |_| ()).unwrap();
    // The gains undo those of the pictures up to a common factor, and their product is 1.
    let all = (0..8).map(|k| gains[k % 3]);
    let mean = all.map(f64::ln).sum::<f64>().exp().powf(1.0 / 8.0);
    for (k, view) in textured.report.views.iter().enumerate() {
        for gain in view.gain {
            let expected = mean / gains[k % 3];
            assert!(
                (gain / expected - 1.0).abs() < 0.01,
                "{k}: {gain} {expected}"
            );
        }
    }
    let [mean_error, most] = errors(&textured, 1.0 / mean);
    assert!(mean_error < 0.005 && most < 0.06, "{mean_error}, {most}");
    options.level_exposure = false;
    let raw = texture_mesh(&mesh, &views, &options, |_| ()).unwrap();
    assert!(errors(&raw, 1.0 / mean)[0] > 0.02);
    assert_eq!(raw.report.views[0].gain, [1.0; 3]);
}

#[test]
fn views_of_opposite_sides_have_nothing_to_compare() {
    let mesh = cube();
    let corner = |s: f64| camera([4.0 * s, 3.0 * s, 4.0 * s], [0.0; 3], Lens::Pinhole);
    let mut cameras = vec![corner(1.0), corner(-1.0)];
    let views_of = |cameras: &[Camera]| views(&mesh, cameras, &[0.7, 1.0]);
    let options = Options::with_size(128);
    let textured = texture_mesh(&mesh, &views_of(&cameras), &options, |_| ()).unwrap();
    for view in &textured.report.views {
        assert_eq!((view.overlapping_views, view.gain), (0, [1.0; 3]));
    }
    // This one sees sides of both.
    cameras.push(camera([4.0, -3.0, 4.0], [0.0; 3], Lens::Pinhole));
    let textured = texture_mesh(&mesh, &views_of(&cameras), &options, |_| ()).unwrap();
    let overlaps = textured.report.views.iter().map(|v| v.overlapping_views);
    assert_eq!(overlaps.collect::<Vec<_>>(), [1, 1, 2]);
}

#[test]
fn a_room_is_seen_from_inside() {
    let outside = cube();
    let turned = outside.triangles().into_iter().map(|[a, b, c]| [a, c, b]);
    let faces = Faces::from_polygons(turned).unwrap();
    let room = Mesh::new(outside.positions().to_vec(), faces).unwrap();
    let camera = camera([0.0; 3], [1.0, 0.0, 0.0], Lens::Pinhole);
    let views = [view("room", &room, &camera, 1.0)];
    let textured = texture_mesh(&room, &views, &Options::with_size(256), |_| ()).unwrap();
    let mut compared = 0;
    for (place, light) in samples(&textured) {
        let [x, y, z] = place;
        if x > 0.99 && y.abs() < 0.2 && z.abs() < 0.2 {
            let truth = paint(place);
            assert!(
                (0..3).all(|k| (light[k] - truth[k]).abs() < 0.02),
                "{place:?}"
            );
            compared += 1;
        }
    }
    assert!(compared > 4, "{compared}");
}

/// A wall, and a small square in front of it.
pub(super) const WALL: &[u8] = b"v -2 -2 0\nv 2 -2 0\nv 2 2 0\nv -2 2 0\nf 1 2 3 4\n\
    v -0.4 -0.4 1\nv 0.4 -0.4 1\nv 0.4 0.4 1\nv -0.4 0.4 1\nf 5 6 7 8\n";

#[test]
fn what_hides_a_surface_is_not_painted_on_it() {
    let mesh = obj::decode(WALL).unwrap();
    let red_in_front = |[_, _, z]: [f64; 3]| {
        if z > 0.5 {
            [0.8, 0.0, 0.0]
        } else {
            [0.0, 0.0, 0.8]
        }
    };
    let eyes = [[0.0, 0.0, 5.0], [2.5, 0.0, 4.5], [-1.0, 2.5, 4.5]];
    let views = eyes.iter().map(|eye| {
        let camera = camera(*eye, [0.0; 3], Lens::Pinhole);
        let picture = photograph(&mesh, &camera, 1.0, red_in_front);
        View::new("view", camera, None, &picture).unwrap()
    });
    let views: Vec<View> = views.collect();
    let textured = texture_mesh(&mesh, &views, &Options::with_size(256), |_| ()).unwrap();
    for (place, light) in samples(&textured) {
        let truth = red_in_front(place);
        let difference = (0..3)
            .map(|k| (light[k] - truth[k]).abs())
            .fold(0.0, f64::max);
        // At the border of the square every view mixes in the wall.
        let is_at_border = place[2] > 0.5 && place[0].abs().max(place[1].abs()) > 0.36;
        assert!(is_at_border || difference < 0.02, "{place:?}: {light:?}");
    }
}

#[test]
fn holes_take_the_colours_around_them() {
    let mesh = cube();
    // From one corner three sides are seen; the others are filled.
    let camera = camera([4.0, 3.0, 4.0], [0.0; 3], Lens::Pinhole);
    let picture = Plane::filled(SIZE[0], SIZE[1], [90_u8, 120, 40]);
    let views = [View::new("one", camera, None, &picture).unwrap()];
    let textured = texture_mesh(&mesh, &views, &Options::with_size(128), |_| ()).unwrap();
    let report = &textured.report;
    let filled = report.filled_texels as f64 / report.covered_texels as f64;
    assert!((filled - 0.5).abs() < 0.05, "{filled}");
    assert!(
        textured
            .texture
            .values()
            .iter()
            .all(|texel| *texel == [90, 120, 40])
    );
}

#[test]
fn textures_are_the_same_for_any_number_of_threads() {
    let mesh = cube();
    let views = views(&mesh, &around(Lens::Pinhole)[..3], &[1.0, 0.8]);
    let run = |threads| {
        let pool = rayon::ThreadPoolBuilder::new()
            .num_threads(threads)
            .build()
            .unwrap();
        let run = || texture_mesh(&mesh, &views, &Options::with_size(128), |_| ());
        let textured = pool.install(run).unwrap();
        (textured.texture, textured.report)
    };
    assert_eq!(run(1), run(3));
}

#[test]
fn own_coordinates_are_used_unless_a_new_atlas_is_asked_for() {
    let text = b"v -1 -1 0\nv 1 -1 0\nv 1 1 0\nv -1 1 0\nvt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\n\
        f 1/1 2/2 3/3 4/4\n";
    let mesh = obj::decode(text).unwrap();
    let views = [view(
        "front",
        &mesh,
        &camera([0.0, 0.5, 4.0], [0.0; 3], Lens::Pinhole),
        1.0,
    )];
    let mut options = Options::with_size(64);
    let own = texture_mesh(&mesh, &views, &options, |_| ()).unwrap();
    assert_eq!((own.mesh.faces().len(), own.report.charts), (1, 1));
    assert_eq!(own.mesh.texture_coordinates(), mesh.texture_coordinates());
    assert!(!own.report.unwrapped && errors(&own, 1.0)[0] < 0.004);
    options.unwrap = true;
    let new = texture_mesh(&mesh, &views, &options, |_| ()).unwrap();
    assert!(new.report.unwrapped && errors(&new, 1.0)[0] < 0.004);
    assert_eq!(new.mesh.faces().len(), 2);
    let model = new.to_mesh().unwrap();
    assert!(model.material(0).unwrap().unlit);
}

#[test]
fn bad_input_is_named() {
    let mesh = cube();
    let good = camera([4.0, 3.0, 4.0], [0.0; 3], Lens::Pinhole);
    let picture = Plane::filled(SIZE[0], SIZE[1], [100_u8; 3]);
    let view = |name: &str, camera| View::new(name, camera, Some(SIZE), &picture).unwrap();
    let run = |mesh: &Mesh, views: &[View], size| {
        let found = texture_mesh(mesh, views, &Options::with_size(size), |_| ());
        found.unwrap_err().to_string()
    };
    let options = Options::with_size(64);
    assert!(matches!(
        texture_mesh(&mesh, &[], &options, |_| ()),
        Err(TextureError::NoViews)
    ));
    let wrong = View::new("a.png", good, Some([64, 48]), &picture).unwrap_err();
    let expected = "view a.png: the picture has 200 × 160 pixels and its camera is for 64 × 48";
    assert_eq!(wrong.to_string(), expected);
    assert!(View::new("a.png", good, None, &Plane::<u8>::default()).is_err());

    let away = camera([4.0, 3.0, 4.0], [9.0, 3.0, 4.0], Lens::Pinhole);
    let views = [view("good", good), view("away.png", away)];
    assert_eq!(
        run(&mesh, &views, 64),
        "view away.png: the camera does not see the mesh"
    );
    let inside = camera([0.5, 0.2, 0.0], [9.0, 3.0, 4.0], Lens::Pinhole);
    let views = [view("good", good), view("in.png", inside)];
    let message = run(&mesh, &views, 64);
    assert!(
        message.starts_with("view in.png: the camera's centre ["),
        "{message}"
    );
    assert!(message.ends_with("is inside the mesh"), "{message}");
    let points = obj::decode(b"v 0 0 0\nv 1 0 0\np 1 2\n").unwrap();
    let line = obj::decode(b"v 0 0 0\nv 1 0 0\nv 2 0 0\nf 1 2 3\n").unwrap();
    assert!(run(&points, &views[..1], 64).contains("no triangles"));
    assert!(run(&line, &views[..1], 64).contains("degenerate"));

    let too_small = texture_mesh(&mesh, &views[..1], &Options::with_size(8), |_| ());
    assert!(matches!(
        too_small,
        Err(TextureError::TextureSpace(
            TextureSpaceError::DoesNotFit { .. }
        ))
    ));
    // Two squares whose own coordinates are less than a texel apart.
    let text = b"v 0 0 0\nv 1 0 0\nv 1 1 0\nv 2 0 0\nv 3 0 0\nv 3 1 0\n\
        vt 0 0\nvt 0.001 0\nvt 0.001 0.001\nvt 0.002 0\nvt 0.003 0\nvt 0.003 0.001\n\
        f 1/1 2/2 3/3\nf 4/4 5/5 6/6\n";
    let close = obj::decode(text).unwrap();
    let message = run(&close, &views[..1], 64);
    assert!(message.contains("64 × 64 texels is too small"), "{message}");
    assert!(message.contains("1 of 2 charts"), "{message}");
    // Two squares with the same place in the texture.
    let text = b"v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 2 0 0\nv 3 0 0\nv 3 1 0\nv 2 1 0\n\
        vt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\nf 1/1 2/2 3/3 4/4\nf 5/1 6/2 7/3 8/4\n";
    let message = run(&obj::decode(text).unwrap(), &views[..1], 64);
    assert!(message.starts_with("1 of 2 charts"), "{message}");
    assert!(message.contains("lie under others"), "{message}");
    let tiled = obj::decode(b"v 0 0 0\nv 1 0 0\nv 1 1 0\nvt 0 0\nvt 3 0\nvt 3 3\nf 1/1 2/2 3/3\n");
    assert!(run(&tiled.unwrap(), &views[..1], 64).contains("outside of the unit square"));
}

proptest! {
    /// No point of a triangle is further from its affine image than the bound.
    #[test]
    fn the_error_of_affine_warps_is_bounded(
        corners in prop::array::uniform3((-1.0..1.0_f64, -1.0..1.0_f64, 1.0..6.0_f64)),
        weights in prop::collection::vec((0.0..1.0_f64, 0.0..1.0_f64), 40),
    ) {
        let corners = corners.map(|(x, y, z)| [x * z, y * z, z]);
        let intrinsics = Intrinsics::new([500.0, 480.0], [320.0, 240.0]).unwrap();
        let pixel = |place: [f64; 3]| intrinsics.project(Point::from(place)).unwrap();
        let pixels = corners.map(pixel);
        let bound = affine_error(corners.map(|corner| corner[2]), pixels);
        let from = [[0.0, 0.0], [1.0, 0.0], [0.0, 1.0]];
        let warp = TriangleWarp::new(from, pixels).unwrap();
        for (v, w) in weights {
            let (v, w) = if v + w > 1.0 { (1.0 - v, 1.0 - w) } else { (v, w) };
            let place = [0, 1, 2].map(|axis| {
                (1.0 - v - w) * corners[0][axis] + v * corners[1][axis] + w * corners[2][axis]
            });
            let (truth, affine) = (pixel(place), warp.at([v, w]));
            let error = (truth[0] - affine[0]).hypot(truth[1] - affine[1]);
            prop_assert!(error <= bound + 1e-9, "{} {}", error, bound);
        }
    }

    /// Affine maps are found from three points and their images.
    #[test]
    fn warps_take_corners_to_corners(
        from in prop::array::uniform3(prop::array::uniform2(-9.0..9.0_f64)),
        to in prop::array::uniform3(prop::array::uniform2(-9.0..9.0_f64)),
    ) {
        let [a, b, c] = from;
        let area = (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
        prop_assume!(area.abs() > 0.1);
        let warp = TriangleWarp::new(from, to).unwrap();
        for (from, to) in from.into_iter().zip(to) {
            let found = warp.at(from);
            prop_assert!((0..2).all(|k| (found[k] - to[k]).abs() < 1e-9));
        }
    }
}

#[test]
fn a_triangle_without_area_has_no_warp() {
    let line = [[0.0, 0.0], [1.0, 1.0], [2.0, 2.0]];
    assert_eq!(TriangleWarp::new(line, line), None);
    assert_eq!(affine_error([1.0, -1.0, 2.0], line), f64::INFINITY);
}
