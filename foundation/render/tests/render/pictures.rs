//! Pictures against projections, depths and colours worked out by hand.

use crate::Pixels;
use ga_image::colour::LinearColour;
use ga_render::{
    Ground, Light, Lighting, Polyline, Rendering, Scene, Style, View, ViewDirection, Visibility,
    render,
};
use ga_runtime::vga3::Vector;
use proptest::prelude::*;

use crate::view::point;
use crate::{FIELD_OF_VIEW, front, small};

/// Light from all around and none from a side: a surface shows its own colour.
fn flat(surface: LinearColour) -> Style {
    let dark = Light {
        direction: [0.0, 1.0, 0.0],
        colour: LinearColour::BLACK,
    };
    Style {
        surface,
        gloss: 0.0,
        depth_contrast: 0.0,
        lighting: Lighting {
            key: dark,
            fill: dark,
            sky: LinearColour::WHITE,
            bounce: LinearColour::WHITE,
        },
        background: [LinearColour::BLACK; 2],
        ..small()
    }
}

/// The direction, of depth 1, in which [`front`] sees the middle of a pixel.
fn front_ray(style: &Style, column: u32, row: u32) -> [f64; 3] {
    let half = f64::from(style.height) / 2.0;
    let slope = (FIELD_OF_VIEW / 2.0).tan() / half;
    [
        (f64::from(column) + 0.5 - f64::from(style.width) / 2.0) * slope,
        (half - f64::from(row) - 0.5) * slope,
        -1.0,
    ]
}

pub(crate) fn sphere(radius: f64, centre: [f64; 3]) -> (Vec<[f64; 3]>, Vec<[u32; 3]>) {
    let (rings, sides) = (48u32, 96u32);
    let (mut positions, mut triangles) = (Vec::new(), Vec::new());
    for ring in 0..=rings {
        let polar = std::f64::consts::PI * f64::from(ring) / f64::from(rings);
        for side in 0..sides {
            let around = std::f64::consts::TAU * f64::from(side) / f64::from(sides);
            positions.push([
                centre[0] + radius * polar.sin() * around.sin(),
                centre[1] + radius * polar.cos(),
                centre[2] + radius * polar.sin() * around.cos(),
            ]);
        }
    }
    for ring in 0..rings {
        for side in 0..sides {
            let next = (side + 1) % sides;
            let at = |ring: u32, side: u32| ring * sides + side;
            triangles.push([at(ring, side), at(ring + 1, side), at(ring + 1, next)]);
            triangles.push([at(ring, side), at(ring + 1, next), at(ring, next)]);
        }
    }
    (positions, triangles)
}

fn brightness(picture: &Rendering, column: u32, row: u32) -> u32 {
    picture
        .colour
        .pixel(column, row)
        .iter()
        .map(|&c| u32::from(c))
        .sum()
}

#[test]
fn a_sphere_has_the_outline_and_the_depths_of_a_sphere() {
    let (positions, triangles) = sphere(1.0, [0.0; 3]);
    let style = flat(LinearColour::WHITE);
    let picture = render(&Scene::new(&positions, &triangles), &front(5.0), &style).unwrap();
    for row in 0..style.height {
        for column in 0..style.width {
            let ray = front_ray(&style, column, row);
            // |eye + d ray|² = 1 with eye = (0, 0, 5).
            let [x, y, z] = ray;
            let (a, b, c) = (x * x + y * y + z * z, 5.0 * z, 24.0);
            let discriminant = b * b - a * c;
            let seen = picture.depth.get(column, row);
            if discriminant > 0.3 {
                let depth = (-b - discriminant.sqrt()) / a;
                // Two samples per side see up to a quarter pixel beside the middle.
                assert!((seen.unwrap() - depth).abs() < 0.02, "({column}, {row})");
                assert_eq!(picture.colour.pixel(column, row), [255; 3]);
                assert_eq!(picture.depth.coverage(column, row), 1.0);
            } else if discriminant < -0.3 {
                assert_eq!(seen, None);
                assert_eq!(picture.colour.pixel(column, row), [0; 3]);
            }
        }
    }
}

#[test]
fn a_floor_under_the_camera_and_behind_it_is_cut_at_the_near_depth() {
    let positions = [
        [-1e3, -1.0, 1e3],
        [1e3, -1.0, 1e3],
        [1e3, -1.0, -1e3],
        [-1e3, -1.0, -1e3],
    ];
    let triangles = [[0, 1, 2], [0, 2, 3]];
    let style = Style {
        supersampling: 1,
        ..flat(LinearColour::WHITE)
    };
    let near = 3.0;
    let camera = View::look_at(
        [0.0; 3],
        [0.0, 0.0, -1.0],
        [0.0, 1.0, 0.0],
        FIELD_OF_VIEW,
        near,
    )
    .unwrap();
    let picture = render(&Scene::new(&positions, &triangles), &camera, &style).unwrap();
    let (mut cut, mut drawn) = (0, 0);
    for row in 0..style.height {
        for column in 0..style.width {
            let depth = -1.0 / front_ray(&style, column, row)[1];
            let seen = picture.depth.get(column, row);
            if depth > near + 1e-6 && depth < 999.0 {
                // Corners lie on a grid of 1/4096 pixel, and 1 / depth changes by 0.007 a pixel.
                assert!(
                    (1.0 / seen.unwrap() - 1.0 / depth).abs() < 2e-6,
                    "({column}, {row})"
                );
                drawn += 1;
            } else {
                assert_eq!(seen, None, "({column}, {row})");
                cut += u32::from(depth > 0.0);
            }
        }
    }
    assert!(drawn > 3_000 && cut > 500, "{drawn} {cut}");
}

#[test]
fn what_is_nearer_hides_what_is_further_in_any_order() {
    let (far, far_triangles) = sphere(1.0, [0.0, 0.0, -1.0]);
    let (near, near_triangles) = sphere(0.4, [0.2, 0.1, 1.5]);
    let join = |a: (&[[f64; 3]], &[[u32; 3]]), b: (&[[f64; 3]], &[[u32; 3]])| {
        let offset = a.0.len() as u32;
        let moved = b.1.iter().map(|t| t.map(|v| v + offset));
        (
            [a.0, b.0].concat(),
            a.1.iter().copied().chain(moved).collect::<Vec<_>>(),
        )
    };
    let one = join((&far, &far_triangles), (&near, &near_triangles));
    let other = join((&near, &near_triangles), (&far, &far_triangles));
    let draw = |mesh: &(Vec<[f64; 3]>, Vec<[u32; 3]>)| {
        render(&Scene::new(&mesh.0, &mesh.1), &front(6.0), &small()).unwrap()
    };
    let (one, other) = (draw(&one), draw(&other));
    assert_eq!(one.colour, other.colour);
    assert_eq!(one.depth, other.depth);
    let [column, row, depth] = front(6.0).project([0.2, 0.1, 1.9], 90, 120).unwrap();
    assert!((one.depth.get(column as u32, row as u32).unwrap() - depth).abs() < 0.01);
}

#[test]
fn half_a_pixel_of_white_is_half_the_light() {
    // One pixel of a camera whose half picture spans 1 at depth 1; the quad covers its left half.
    let style = Style {
        width: 1,
        height: 1,
        supersampling: 4,
        ..flat(LinearColour::WHITE)
    };
    let camera = View::look_at(
        [0.0, 0.0, 1.0],
        [0.0; 3],
        [0.0, 1.0, 0.0],
        std::f64::consts::FRAC_PI_2,
        0.1,
    )
    .unwrap();
    let positions = [
        [-2.0, -2.0, 0.0],
        [0.0, -2.0, 0.0],
        [0.0, 2.0, 0.0],
        [-2.0, 2.0, 0.0],
    ];
    let picture = render(
        &Scene::new(&positions, &[[0, 1, 2], [0, 2, 3]]),
        &camera,
        &style,
    )
    .unwrap();
    assert_eq!(picture.depth.coverage(0, 0), 0.5);
    assert_eq!(picture.colour.pixel(0, 0), [188; 3]);
}

#[test]
fn the_side_towards_the_key_light_is_the_brightest() {
    let (positions, triangles) = sphere(1.0, [0.0; 3]);
    let style = Style {
        gloss: 0.0,
        ..small()
    };
    let picture = render(&Scene::new(&positions, &triangles), &front(5.0), &style).unwrap();
    let (mut best, mut place) = (0, [0.0; 3]);
    for row in 0..style.height {
        for column in 0..style.width {
            if picture.depth.coverage(column, row) == 1.0
                && brightness(&picture, column, row) > best
            {
                best = brightness(&picture, column, row);
                let depth = picture.depth.get(column, row).unwrap();
                let ray = front_ray(&style, column, row);
                place = [ray[0] * depth, ray[1] * depth, 5.0 - depth];
            }
        }
    }
    // The front camera's right, up and backward are the world's axes, and a unit sphere's points
    // are its normals.
    let light = style.lighting.key.direction;
    let angle = Vector::from(place).angle(Vector::from(light)).unwrap();
    assert!(angle.cos() > 0.9, "{place:?} is not towards {light:?}");
}

#[test]
fn what_lies_close_behind_an_edge_is_darkened() {
    let square = |half: f64, z: f64| {
        [
            [-half, -half, z],
            [half, -half, z],
            [half, half, z],
            [-half, half, z],
        ]
    };
    let positions = [square(4.0, -1.0), square(0.5, 1.0)].concat();
    let triangles = [[0, 1, 2], [0, 2, 3], [4, 5, 6], [4, 6, 7]];
    let with = |depth_contrast| {
        let style = Style {
            depth_contrast,
            ..flat(LinearColour::WHITE)
        };
        let picture = render(&Scene::new(&positions, &triangles), &front(5.0), &style).unwrap();
        move |point: [f64; 3]| {
            let [column, row, _] = front(5.0).project(point, 90, 120).unwrap();
            brightness(&picture, column as u32, row as u32)
        }
    };
    let (plain, contrasted) = (with(0.0), with(3.0));
    // Seen past the small square's edge, half a unit to the side at depth 4, the large one at depth
    // 6.
    let (beside, away, before) = ([0.80, 0.0, -1.0], [1.7, 0.0, -1.0], [0.0, 0.0, 1.0]);
    assert_eq!([plain(beside), plain(away), plain(before)], [765; 3]);
    assert_eq!([contrasted(away), contrasted(before)], [765; 2]);
    assert!(contrasted(beside) < 740, "{}", contrasted(beside));
}

#[test]
fn degenerate_triangles_change_nothing() {
    let (positions, triangles) = sphere(1.0, [0.0; 3]);
    let mut more = triangles.clone();
    more.extend([[7, 7, 7], [7, 7, 300], [300, 7, 300]]);
    let draw = |triangles: &[[u32; 3]]| {
        render(&Scene::new(&positions, triangles), &front(5.0), &small()).unwrap()
    };
    assert_eq!(draw(&triangles).colour, draw(&more).colour);
}

#[test]
fn the_ground_carries_a_shadow_away_from_the_light_and_hides_what_is_below() {
    let (positions, triangles) = sphere(0.5, [0.0, 0.2, 0.0]);
    let style = Style {
        gloss: 0.0,
        ..small()
    };
    let camera = View::look_at(
        [0.0, 2.0, 6.0],
        [0.0; 3],
        [0.0, 1.0, 0.0],
        FIELD_OF_VIEW,
        0.1,
    )
    .unwrap();
    let scene = |ground| Scene {
        ground,
        ..Scene::new(&positions, &triangles)
    };
    let grid = 1e6;
    let picture = render(&scene(Some(Ground { height: -0.2, grid })), &camera, &style).unwrap();
    // The light comes from the upper left front.
    let at = |x: f64, z: f64| {
        let [column, row, _] = camera
            .project([x, -0.2, z], style.width, style.height)
            .unwrap();
        brightness(&picture, column as u32, row as u32)
    };
    assert!(
        at(0.6, 0.0) + 40 < at(-0.8, 0.0),
        "{} {}",
        at(0.6, 0.0),
        at(-0.8, 0.0)
    );

    let covered = |picture: &Rendering| {
        let pixels =
            (0..style.height).flat_map(|row| (0..style.width).map(move |column| (column, row)));
        pixels
            .map(|(column, row)| picture.depth.coverage(column, row))
            .sum::<f64>()
    };
    let without = render(&scene(None), &camera, &style).unwrap();
    let waist = Some(Ground { height: 0.2, grid });
    let sunk = render(&scene(waist), &camera, &style).unwrap();
    assert!(covered(&sunk) < 0.8 * covered(&without));
    let [column, row, depth] = camera.project([0.0, 0.0, 0.458], 90, 120).unwrap();
    let seen = |picture: &Rendering| picture.depth.get(column as u32, row as u32);
    assert!((seen(&without).unwrap() - depth).abs() < 0.02);
    assert_eq!(seen(&sunk), None);
    let buried = render(
        &scene(Some(Ground { height: 5.0, grid })),
        &front(5.0),
        &style,
    )
    .unwrap();
    assert!(
        covered(&buried) > 0.0,
        "a ground above the camera hides nothing below it"
    );
}

#[test]
fn bones_are_drawn_where_their_ends_are_projected() {
    let style = flat(LinearColour::WHITE);
    let bones = [
        [[0.0; 3], [0.5, 0.5, 0.0]],
        [[0.0, 0.0, 50.0], [0.0, -1.0, 50.0]],
        [[-0.5, -0.5, 0.0], [-3.0, -40.0, 90.0]],
    ];
    let scene = Scene {
        bones: &bones,
        ..Scene::new(&[], &[])
    };
    let camera = front(5.0);
    let picture = render(&scene, &camera, &style).unwrap();
    let at = |point: [f64; 3]| {
        let [column, row, _] = camera.project(point, style.width, style.height).unwrap();
        picture.colour.pixel(column as u32, row as u32)
    };
    let only = |colour| {
        let scene = Style {
            background: [colour; 2],
            ..style
        };
        render(&Scene::new(&[], &[]), &camera, &scene)
            .unwrap()
            .colour
            .pixel(0, 0)
    };
    assert_eq!(at([0.0; 3]), only(style.joint));
    assert_eq!(at([0.5, 0.5, 0.0]), only(style.joint));
    assert_eq!(at([0.25, 0.25, 0.0]), only(style.bone));
    assert_eq!(at([-0.5, -0.5, 0.0]), only(style.joint));
    assert_eq!(at([0.5, -0.5, 0.0]), [0; 3]);
    assert_eq!(picture.depth.range(), None);
}

#[test]
fn depth_pictures_are_brighter_where_it_is_nearer() {
    let (positions, triangles) = sphere(1.0, [0.0; 3]);
    let picture = render(&Scene::new(&positions, &triangles), &front(5.0), &small()).unwrap();
    let (near, far) = picture.depth.range().unwrap();
    assert!(
        (near - 4.0).abs() < 1e-3 && far > 4.7 && far < 4.9,
        "{near} {far}"
    );
    let depths = picture.depth.to_plane(near, far);
    let at = |column, row| depths.pixel(column, row);
    assert!(at(45, 60) >= 254);
    assert!(at(45, 60) > at(55, 60) && at(55, 60) > at(62, 60) && at(62, 60) > 40);
    assert_eq!(at(2, 2), 0);
}

#[test]
fn the_largest_allowed_coordinates_give_a_picture() {
    let positions = [[-1e30, -1e30, 0.0], [1e30, -1e30, 0.0], [0.0, 1e30, -1e30]];
    let camera = View::fit(positions, ViewDirection::default(), 0.8, 0.75, 0.1).unwrap();
    let scene = Scene {
        ground: Some(Ground {
            height: -1e30,
            grid: 1e29,
        }),
        ..Scene::new(&positions, &[[0, 1, 2]])
    };
    let picture = render(&scene, &camera, &small()).unwrap();
    assert!(picture.depth.range().is_some());
}

#[test]
fn sky_and_shadow_colours_follow_srgb() {
    assert_eq!(
        LinearColour::from_srgb([0, 255, 0]),
        LinearColour::new(0.0, 1.0, 0.0)
    );
    let empty = render(
        &Scene::new(&[], &[]),
        &front(5.0),
        &Style {
            background: [LinearColour::from_srgb([10, 120, 240]); 2],
            ..small()
        },
    );
    assert_eq!(empty.unwrap().colour.pixel(30, 30), [10, 120, 240]);
}

#[test]
fn any_number_of_threads_gives_the_same_picture() {
    let (positions, triangles) = sphere(0.5, [0.0, 0.2, 0.0]);
    let points = [[-1.0, 0.0, 0.0], [1.0, 0.5, 0.3]];
    let lines = [Polyline {
        points: &points,
        colour: LinearColour::WHITE,
        width: 2.5,
        visibility: Visibility::Hidden,
    }];
    let scene = Scene {
        lines: &lines,
        ground: Some(Ground {
            height: -0.3,
            grid: 0.2,
        }),
        ..Scene::new(&positions, &triangles)
    };
    let style = Style {
        self_shadow: 1.0,
        ambient_occlusion: 1.0,
        ..small()
    };
    let draw = |threads| {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads);
        let pool = pool.build().unwrap();
        pool.install(|| render(&scene, &front(3.0), &style).unwrap())
    };
    let (one, many) = (draw(1), draw(5));
    assert!(one.colour == many.colour && one.depth == many.depth);
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(24))]

    /// No finite scene panics or is refused.
    #[test]
    fn any_finite_scene_is_drawn(
        positions in prop::collection::vec(point(), 3..12),
        picks in prop::collection::vec(prop::array::uniform3(any::<prop::sample::Index>()), 0..12),
        eye in point(),
        height in -20f64..20.0,
    ) {
        let triangles: Vec<_> = picks
            .iter()
            .map(|t| t.map(|i| i.index(positions.len()) as u32))
            .collect();
        let camera = View::look_at(eye, [1.0, 2.0, 70.0], [0.0, 1.0, 0.0], 1.5, 1e-3).unwrap();
        let scene = Scene {
            ground: Some(Ground { height, grid: 3.0 }),
            bones: &[[positions[0], positions[1]]],
            ..Scene::new(&positions, &triangles)
        };
        let style = Style { width: 20, height: 20, ..Style::default() };
        let picture = render(&scene, &camera, &style).unwrap();
        if let Some((near, _)) = picture.depth.range() {
            prop_assert!(near >= camera.near() * 0.999);
        }
    }
}
