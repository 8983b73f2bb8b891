//! Scenes, cameras and styles that cannot be drawn.

use ga_image::colour::LinearColour;
use ga_render::{
    Appearance, Attribute, Dot, Ground, Light, Lighting, MaterialChoice, Normals, Polyline,
    RenderError, Scene, Style, View, ViewDirection, Visibility, render,
};
use ga_runtime::cga3::{Motor, Translator};

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
        View::look_at(eye, eye, up, 0.8, 0.1),
        View::look_at(eye, target, [0.0, 0.0, 2.0], 0.8, 0.1),
        View::look_at(eye, target, [0.0; 3], 0.8, 0.1),
        View::look_at(eye, [f64::NAN; 3], up, 0.8, 0.1),
        View::look_at(eye, target, up, 0.0, 0.1),
        View::look_at(eye, target, up, 3.2, 0.1),
        View::look_at(eye, target, up, 0.8, 0.0),
        View::fit([], ViewDirection::default(), 0.8, 0.75, 0.1),
        View::fit([[1.0; 3]; 4], ViewDirection::default(), 0.8, 0.75, 0.1),
        View::fit(
            [[1.0; 3], [f64::NAN; 3]],
            ViewDirection::default(),
            0.8,
            0.75,
            0.1,
        ),
        View::fit(
            good,
            ViewDirection {
                elevation: 1.6,
                azimuth: 0.0,
            },
            0.8,
            0.75,
            0.1,
        ),
        View::fit(good, ViewDirection::default(), 0.8, -1.0, 0.1),
        View::fit(good, ViewDirection::default(), 0.8, 0.75, 1.0),
    ] {
        assert!(matches!(bad, Err(RenderError::Camera(_))), "{bad:?}");
    }
}

/// A scene of one triangle with something wrong.
fn refused(spoil: impl Fn(&mut Scene)) -> RenderError {
    let positions = [[0.0; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]];
    let mut scene = Scene::new(&positions, &[[0, 1, 2]]);
    scene.materials = &[];
    spoil(&mut scene);
    render(&scene, &front(5.0), &small())
        .map(|_| ())
        .unwrap_err()
}

#[test]
fn attributes_must_fit_their_object() {
    let text = |spoil: fn(&mut Scene)| refused(spoil).to_string();
    assert_eq!(
        text(|s| s.objects[0].texture_coordinates = Some(Attribute::of_vertices(&[[0.0; 2]; 2]))),
        "the texture coordinates of object 0: there is not one value for each vertex (element 2)"
    );
    assert_eq!(
        text(|s| s.objects[0].normals = Normals::Given(Attribute::of_corners(&[[0.0; 3]], &[]))),
        "the normals of object 0: there is not one entry for each triangle (element 0)"
    );
    assert_eq!(
        text(|s| {
            let corners = &[Some([0, 0, 1])];
            s.objects[0].tangents = Some(Attribute::of_corners(&[[1.0; 4]], corners));
        }),
        "the tangents of object 0: a triangle names a value that does not exist (element 0)"
    );
    assert_eq!(
        text(|s| s.objects[0].colours =
            Some(Attribute::of_vertices(&[[1.0, 1.0, f64::NAN, 1.0]; 3]))),
        "the colours of object 0: a number is not finite or beyond 1e30 (element 0)"
    );
    assert_eq!(
        text(|s| s.objects[0].colours = Some(Attribute::of_vertices(&[[1.0, 1.0, -1.0, 1.0]; 3]))),
        "the colours of object 0: a number is negative (element 0)"
    );
    assert_eq!(
        text(|s| s.objects[0].material = MaterialChoice::PerTriangle(&[])),
        "the materials of object 0: there is not one entry for each triangle (element 0)"
    );
}

#[test]
fn materials_and_transforms_are_checked() {
    assert_eq!(
        refused(|s| s.objects[0].material = MaterialChoice::One(0)),
        RenderError::MaterialIndex {
            object: 0,
            material: 0,
            materials: 0
        }
    );
    let material = |material: Appearance<'static>| {
        let materials: &'static [Appearance] =
            Box::leak(Box::new([Appearance::default(), material]));
        refused(|s| s.materials = materials)
    };
    for (bad, quantity) in [
        (
            Appearance {
                roughness: 1.5,
                ..Appearance::default()
            },
            "roughness",
        ),
        (
            Appearance {
                metallic: f64::NAN,
                ..Appearance::default()
            },
            "metallic part",
        ),
        (
            Appearance {
                opacity: -0.1,
                ..Appearance::default()
            },
            "opacity",
        ),
        (
            Appearance {
                normal_scale: f64::INFINITY,
                ..Appearance::default()
            },
            "normal scale",
        ),
        (
            Appearance {
                emission: LinearColour::new(0.0, -1.0, 0.0),
                ..Appearance::default()
            },
            "emission",
        ),
    ] {
        assert_eq!(
            material(bad),
            RenderError::Material {
                material: 1,
                quantity
            }
        );
    }
    for bad in [
        Motor::new_unchecked(2.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0),
        Motor::new_unchecked(f64::NAN, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0),
        Motor::from(Translator::from_displacement([0.0, 1e200, 0.0])),
    ] {
        assert_eq!(
            refused(|s| s.objects[0].transform = bad),
            RenderError::Transform { object: 0 }
        );
    }
}

#[test]
fn lines_and_dots_are_checked() {
    let good = Polyline {
        points: &[[0.0; 3]],
        colour: LinearColour::WHITE,
        width: 1.0,
        visibility: Visibility::Hidden,
    };
    for bad in [
        Polyline {
            points: &[[0.0, f64::NAN, 0.0]],
            ..good
        },
        Polyline {
            width: -1.0,
            ..good
        },
        Polyline {
            colour: LinearColour::new(f64::INFINITY, 0.0, 0.0),
            ..good
        },
    ] {
        let positions = [[0.0; 3]];
        let scene = Scene {
            lines: &[good, bad],
            ..Scene::new(&positions, &[])
        };
        let error = render(&scene, &front(5.0), &small()).map(|_| ());
        assert_eq!(error, Err(RenderError::Line { line: 1 }));
    }
    let dot = Dot {
        position: [0.0; 3],
        colour: LinearColour::WHITE,
        diameter: f64::NAN,
        visibility: Visibility::OnTop,
    };
    let scene = Scene {
        dots: &[dot],
        ..Scene::default()
    };
    let error = render(&scene, &front(5.0), &small()).map(|_| ());
    assert_eq!(error, Err(RenderError::Dot { dot: 0 }));
}
