//! Transparent surfaces and sides of faces, against colours worked out by hand.

use crate::{Pixels, enumerated};
use ga_image::colour::LinearColour;
use ga_render::{
    Appearance, Buffers, Ground, MaterialChoice, Object, Scene, Shading, Style, View, render,
};
use proptest::prelude::*;

use crate::scenes::{UNIT_SQUARE, code, one_light, square};

/// Sees exactly the square from (−1, −1) to (1, 1) at height 0, facing it.
fn straight() -> View {
    let angle = 2.0 * (1f64 / 20.0).atan();
    View::look_at([0.0, 0.0, 20.0], [0.0; 3], [0.0, 1.0, 0.0], angle, 1.0).unwrap()
}

fn style(supersampling: u32) -> Style {
    Style {
        shading: Shading::Unlit,
        supersampling,
        background: [LinearColour::new(0.2, 0.4, 0.8); 2],
        ..one_light(8, [0.0, 0.001, 1.0], LinearColour::WHITE)
    }
}

fn glass(colour: [f64; 3], opacity: f64) -> Appearance<'static> {
    Appearance {
        base_colour: LinearColour::from(colour),
        opacity,
        transparent: true,
        ..Appearance::default()
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(24))]

    /// Panes one behind the other, given in any order, over an opaque one that hides the last.
    #[test]
    fn panes_are_blended_from_back_to_front(
        panes in prop::collection::vec(([0.0f64..1.0, 0.0f64..1.0, 0.0f64..1.0], 0.0f64..1.0), 1..6),
        order in any::<prop::sample::Index>(),
        opaque in any::<bool>(),
        supersampling in 1u32..4,
    ) {
        let mut expected = if opaque { [1.0; 3] } else { [0.2, 0.4, 0.8] };
        for (colour, opacity) in &panes {
            expected = [0, 1, 2].map(|i| expected[i] * (1.0 - opacity) + colour[i] * opacity);
        }
        // A pane behind the opaque one is never seen.
        let mut materials: Vec<Appearance> =
            panes.iter().map(|(colour, opacity)| glass(*colour, *opacity)).collect();
        materials.push(glass([0.0; 3], 0.9));
        materials.push(Appearance::default());
        let mut heights: Vec<f64> = (0..panes.len()).map(|i| 1e-3 * i as f64).collect();
        heights.extend(if opaque { [-2e-3, -1e-3] } else { [-100.0, -1e-3] });
        let count = panes.len() + if opaque { 2 } else { 0 };
        let positions: Vec<_> = heights.iter().map(|&height| square(height)).collect();
        let shift = order.index(count);
        let objects = (0..count).map(|i| (i + shift) % count).map(|i| Object {
            material: MaterialChoice::One(i as u32),
            ..Object::new(&positions[i], &UNIT_SQUARE)
        });
        let scene = Scene { objects: objects.collect(), materials: &materials, ..Scene::default() };
        let picture = render(&scene, &straight(), &style(supersampling)).unwrap();
        let pixel = picture.colour.pixel(4, 3);
        for (found, expected) in pixel.into_iter().zip(expected) {
            prop_assert!((f64::from(found) - code(expected)).abs() < 0.51, "{pixel:?} {expected}");
        }
        prop_assert_eq!(picture.depth.range().is_some(), opaque);
    }
}

/// Two panes that cross along the middle column: on each side the other one is in front.
#[test]
fn panes_that_cross_are_blended_place_by_place() {
    let tilted = |slope: f64| square(0.0).map(|[x, y, _]| [x, y, slope * x]);
    let (left, right) = (tilted(-1e-4), tilted(1e-4));
    let materials = [glass([1.0, 0.0, 0.0], 0.5), glass([0.0, 0.0, 1.0], 0.5)];
    let objects = [&left, &right]
        .into_iter()
        .enumerate()
        .map(|(i, positions)| Object {
            material: MaterialChoice::One(i as u32),
            ..Object::new(positions, &UNIT_SQUARE)
        });
    let scene = Scene {
        objects: objects.collect(),
        materials: &materials,
        ..Scene::default()
    };
    let style = Style {
        background: [LinearColour::BLACK; 2],
        ..style(2)
    };
    let picture = render(&scene, &straight(), &style).unwrap().colour;
    let (half, quarter) = (code(0.5).round() as u8, code(0.25).round() as u8);
    for (column, _, pixel) in enumerated(&picture) {
        let expected = if column < 4 {
            [half, 0, quarter]
        } else {
            [quarter, 0, half]
        };
        assert_eq!(pixel, expected, "column {column}");
    }
}

#[test]
fn a_transparent_surface_is_in_the_buffers_and_hidden_below_the_ground() {
    let positions = square(0.0);
    let materials = [glass([1.0; 3], 0.25), glass([1.0; 3], 0.0)];
    let object = Object {
        material: MaterialChoice::One(0),
        ..Object::new(&positions, &UNIT_SQUARE)
    };
    let mut scene = Scene {
        objects: vec![object],
        materials: &materials,
        ..Scene::default()
    };
    let buffers = Buffers::new(&scene, &straight(), 8, 8).unwrap();
    assert_eq!(buffers.get(3, 3).unwrap().material, Some(0));

    let shown = |scene: &Scene| {
        let camera = View::look_at([0.0, 3.0, 8.0], [0.0; 3], [0.0, 1.0, 0.0], 0.3, 0.1).unwrap();
        render(scene, &camera, &style(2)).unwrap().colour
    };
    scene.ground = Some(Ground {
        height: 2.0,
        grid: 1.0,
    });
    let above = shown(&scene);
    scene.objects[0].material = MaterialChoice::One(1);
    let without = shown(&scene);
    assert_eq!(above.pixel(4, 6), without.pixel(4, 6));
}

#[test]
fn the_back_of_a_face_is_drawn_where_it_is_asked_for() {
    let positions = square(0.0);
    let turned: Vec<[u32; 3]> = UNIT_SQUARE.iter().map(|&[a, b, c]| [a, c, b]).collect();
    for (double_sided, triangles, seen) in [
        (true, &UNIT_SQUARE[..], true),
        (true, &turned[..], true),
        (false, &UNIT_SQUARE[..], true),
        (false, &turned[..], false),
    ] {
        for transparent in [false, true] {
            let materials = [Appearance {
                double_sided,
                transparent,
                ..Appearance::default()
            }];
            let object = Object {
                material: MaterialChoice::One(0),
                ..Object::new(&positions, triangles)
            };
            let scene = Scene {
                objects: vec![object],
                materials: &materials,
                ..Scene::default()
            };
            let picture = render(&scene, &straight(), &style(1)).unwrap().colour;
            let white = picture.pixel(4, 4) == [255; 3];
            assert_eq!(white, seen, "{double_sided} {transparent}");
            let buffers = Buffers::new(&scene, &straight(), 8, 8).unwrap();
            assert_eq!(buffers.get(4, 4).is_some(), seen);
        }
    }
}
