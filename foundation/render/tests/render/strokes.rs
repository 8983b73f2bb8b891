//! Lines and dots over surfaces.

use crate::Pixels;
use ga_image::colour::LinearColour;
use ga_render::{Dot, Ground, Object, Polyline, Rendering, Scene, Style, Visibility, render};

use crate::front;
use crate::scenes::{UNIT_SQUARE, one_light, square};

const RED: LinearColour = LinearColour::new(1.0, 0.0, 0.0);

fn style() -> Style {
    one_light(81, [0.0, 1.0, 0.0], LinearColour::BLACK)
}

fn line(points: &[[f64; 3]], visibility: Visibility) -> Polyline<'_> {
    Polyline {
        points,
        colour: RED,
        width: 3.0,
        visibility,
    }
}

/// Whether the pixel that shows a point is red.
fn is_red(picture: &Rendering, point: [f64; 3]) -> bool {
    let [column, row, _] = front(5.0).project(point, 81, 81).unwrap();
    picture.colour.pixel(column as u32, row as u32) == [255, 0, 0]
}

#[test]
fn surfaces_hide_what_is_behind_them() {
    let positions = square(0.0).map(|[x, y, z]| [0.5 * x, y, z]);
    // From in front of the square, through it, to behind it; and from side to side behind it.
    let through = [[0.0, 0.5, 1.0], [0.0, -0.5, -1.0]];
    let behind = [[-1.5, 0.8, -0.5], [1.5, 0.8, -0.5]];
    for (visibility, hidden) in [(Visibility::Hidden, false), (Visibility::OnTop, true)] {
        let lines = [line(&through, visibility), line(&behind, visibility)];
        let scene = Scene {
            objects: vec![Object::new(&positions, &UNIT_SQUARE)],
            lines: &lines,
            ..Scene::default()
        };
        let picture = render(&scene, &front(5.0), &style()).unwrap();
        assert!(is_red(&picture, [0.0, 0.25, 0.5]));
        assert!(is_red(&picture, [0.0, 0.05, 0.1]));
        assert_eq!(is_red(&picture, [0.0, -0.05, -0.1]), hidden);
        assert_eq!(is_red(&picture, [0.0, -0.25, -0.5]), hidden);
        assert_eq!(is_red(&picture, [0.0, 0.8, -0.5]), hidden);
        assert_eq!(is_red(&picture, [0.4, 0.8, -0.5]), hidden);
        assert!(is_red(&picture, [0.9, 0.8, -0.5]));
        assert!(is_red(&picture, [-0.9, 0.8, -0.5]));
    }
}

#[test]
fn what_lies_on_a_surface_is_seen() {
    // A square that recedes steeply, with its outline and a diagonal on it.
    let positions = square(0.0).map(|[x, y, _]| [x, 0.3 * y - 0.4, -1.5 * y]);
    let outline = [0, 1, 2, 3, 0, 2].map(|i: usize| positions[i]);
    let lines = [line(&outline, Visibility::Hidden)];
    let dots = [0.25, 0.75].map(|t: f64| Dot {
        position: [2.0 * t - 1.0, -0.4, 0.0],
        colour: RED,
        diameter: 5.0,
        visibility: Visibility::Hidden,
    });
    let scene = Scene {
        objects: vec![Object::new(&positions, &UNIT_SQUARE)],
        lines: &lines,
        dots: &dots,
        ..Scene::default()
    };
    let picture = render(&scene, &front(5.0), &style()).unwrap();
    for ends in outline.windows(2) {
        for step in 1..20 {
            let t = f64::from(step) / 20.0;
            let place = [0, 1, 2].map(|i: usize| ends[0][i] + t * (ends[1][i] - ends[0][i]));
            assert!(is_red(&picture, place), "{place:?}");
        }
    }
    assert!(dots.iter().all(|dot| is_red(&picture, dot.position)));
    assert!(!is_red(&picture, [0.75, -0.4, 0.0]));
}

#[test]
fn lines_and_dots_are_as_wide_as_they_say() {
    let points = [[-9.0, 0.0, 0.0], [9.0, 0.0, 0.0]];
    let widths = [2.0, 5.0, 8.5];
    for width in widths {
        let lines = [Polyline {
            width,
            colour: LinearColour::WHITE,
            ..line(&points, Visibility::Hidden)
        }];
        let dots = [Dot {
            position: [0.0; 3],
            colour: LinearColour::WHITE,
            diameter: width,
            visibility: Visibility::Hidden,
        }];
        let light = |picture: &Rendering| -> f64 {
            let lights = picture
                .colour
                .values()
                .iter()
                .map(|p| LinearColour::from_srgb(*p).red);
            lights.sum()
        };
        let scene = Scene {
            lines: &lines,
            ..Scene::default()
        };
        let across = light(&render(&scene, &front(5.0), &style()).unwrap()) / 81.0;
        assert!((across - width).abs() < 0.02, "{across} {width}");
        let scene = Scene {
            dots: &dots,
            ..Scene::default()
        };
        let area = light(&render(&scene, &front(5.0), &style()).unwrap());
        // The soft edge, linear over one pixel, adds a twelfth to the square of the radius.
        let exact = std::f64::consts::PI * (width * width / 4.0 + 1.0 / 12.0);
        assert!((area - exact).abs() < 0.4, "{area} {exact}");
    }
}

#[test]
fn the_ground_hides_what_is_below() {
    let points = [[0.0, 0.5, 0.0], [0.0, -1.5, 0.0]];
    let lines = [line(&points, Visibility::Hidden)];
    let scene = Scene {
        lines: &lines,
        ground: Some(Ground {
            height: -0.3,
            grid: 10.0,
        }),
        ..Scene::default()
    };
    let picture = render(&scene, &front(5.0), &style()).unwrap();
    assert!(is_red(&picture, [0.0, 0.2, 0.0]) && is_red(&picture, [0.0, -0.2, 0.0]));
    assert!(!is_red(&picture, [0.0, -0.5, 0.0]) && !is_red(&picture, [0.0, -1.2, 0.0]));
}
