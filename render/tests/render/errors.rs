//! Scenes, cameras and styles that cannot be drawn.

use ga_image::colour::LinearColour;
use ga_render::{
    Camera, Ground, Light, Lighting, RenderError, Scene, Style, ViewDirection, render,
};

use crate::{front, small};

#[test]
fn bad_input_is_named() {
    let positions = [[0.0; 3], [1.0, 0.0, 0.0], [0.0, f64::NAN, 0.0]];
    let good = [[0.0; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]];
    let (camera, style) = (front(5.0), small());
    let draw = |positions, triangles, bones, ground, style| {
        let scene = Scene {
            bones,
            ground,
            ..Scene::new(positions, triangles)
        };
        render(&scene, &camera, &style).map(|_| ())
    };
    assert_eq!(
        draw(&positions, &[], &[], None, style),
        Err(RenderError::Position {
            object: 0,
            vertex: 2
        })
    );
    assert_eq!(
        draw(&good, &[[0, 1, 2], [2, 1, 3]], &[], None, style),
        Err(RenderError::Triangle {
            object: 0,
            triangle: 1,
            vertex: 3,
            vertices: 3
        })
    );
    assert_eq!(
        draw(
            &good,
            &[],
            &[[[0.0; 3]; 2], [[0.0; 3], [f64::INFINITY; 3]]],
            None,
            style
        ),
        Err(RenderError::Bone { bone: 1 })
    );
    for (height, grid) in [
        (f64::NAN, 1.0),
        (0.0, 0.0),
        (0.0, -1.0),
        (0.0, f64::INFINITY),
    ] {
        assert_eq!(
            draw(&good, &[], &[], Some(Ground { height, grid }), style),
            Err(RenderError::Ground)
        );
    }
    for bad in [
        Style { width: 0, ..style },
        Style {
            height: 9_000,
            ..style
        },
        Style {
            supersampling: 0,
            ..style
        },
        Style {
            gloss: f64::NAN,
            ..style
        },
        Style {
            surface: LinearColour::new(-1.0, -1.0, -1.0),
            ..style
        },
        Style {
            lighting: Lighting {
                key: Light {
                    direction: [1.0, 0.0, 0.0],
                    colour: LinearColour::WHITE,
                },
                ..style.lighting
            },
            ..style
        },
        Style {
            lighting: Lighting {
                fill: Light {
                    direction: [0.0; 3],
                    colour: LinearColour::WHITE,
                },
                ..style.lighting
            },
            ..style
        },
    ] {
        assert!(
            matches!(draw(&good, &[], &[], None, bad), Err(RenderError::Style(_))),
            "{bad:?}"
        );
    }
    let up = [0.0, 1.0, 0.0];
    let (eye, target) = ([0.0, 0.0, 5.0], [0.0; 3]);
    for bad in [
        Camera::look_at(eye, eye, up, 0.8, 0.1),
        Camera::look_at(eye, target, [0.0, 0.0, 2.0], 0.8, 0.1),
        Camera::look_at(eye, target, [0.0; 3], 0.8, 0.1),
        Camera::look_at(eye, [f64::NAN; 3], up, 0.8, 0.1),
        Camera::look_at(eye, target, up, 0.0, 0.1),
        Camera::look_at(eye, target, up, 3.2, 0.1),
        Camera::look_at(eye, target, up, 0.8, 0.0),
        Camera::fit([], ViewDirection::default(), 0.8, 0.75, 0.1),
        Camera::fit([[1.0; 3]; 4], ViewDirection::default(), 0.8, 0.75, 0.1),
        Camera::fit(
            [[1.0; 3], [f64::NAN; 3]],
            ViewDirection::default(),
            0.8,
            0.75,
            0.1,
        ),
        Camera::fit(
            good,
            ViewDirection {
                elevation: 1.6,
                azimuth: 0.0,
            },
            0.8,
            0.75,
            0.1,
        ),
        Camera::fit(good, ViewDirection::default(), 0.8, -1.0, 0.1),
        Camera::fit(good, ViewDirection::default(), 0.8, 0.75, 1.0),
    ] {
        assert!(matches!(bad, Err(RenderError::Camera(_))), "{bad:?}");
    }
}
