use ga_character::CharacterError;
use ga_character::animated_scene::{AnimatedScene, Moment, camera_of};
use ga_mesh::gltf::{
    Animation, CameraElement, Channel, Document, Interpolation, Keys, Mesh, Node, Primitive,
    Projection, Scene, Transform,
};
use ga_render::Viewpoint;

use super::assert_near;

/// A triangle that goes from x = 0 to x = 4 in two seconds, one that no scene shows, a perspective
/// camera that stands at (0, 1, 2) and looks along −x, and a parallel one.
fn document() -> Document {
    let primitive = Primitive {
        positions: vec![[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]],
        ..Primitive::default()
    };
    let quarter = std::f32::consts::FRAC_1_SQRT_2;
    let camera = |projection| CameraElement {
        name: None,
        projection,
        extras: None,
    };
    let with_camera = |camera, translation| Node {
        camera: Some(camera),
        transform: Transform::Decomposed {
            translation,
            rotation: [0.0, quarter, 0.0, quarter],
            scale: [2.0; 3],
        },
        ..Node::default()
    };
    let with_mesh = || Node {
        mesh: Some(0),
        ..Node::default()
    };
    Document {
        scene: Some(0),
        scenes: vec![Scene {
            nodes: vec![0, 2, 3],
            ..Scene::default()
        }],
        nodes: vec![
            with_mesh(),
            Node {
                transform: Transform::Decomposed {
                    translation: [0.0, 9.0, 0.0],
                    rotation: [0.0, 0.0, 0.0, 1.0],
                    scale: [1.0; 3],
                },
                ..with_mesh()
            },
            with_camera(0, [0.0, 1.0, 2.0]),
            with_camera(1, [0.0; 3]),
        ],
        meshes: vec![Mesh {
            primitives: vec![primitive],
            ..Mesh::default()
        }],
        cameras: vec![
            camera(Projection::Perspective {
                aspect_ratio: None,
                vertical_angle: 0.5,
                near: 0.25,
                far: Some(8.0),
            }),
            camera(Projection::Orthographic {
                half_width: 1.0,
                half_height: 1.0,
                near: 0.1,
                far: 10.0,
            }),
        ],
        animations: vec![Animation {
            channels: vec![Channel {
                node: 0,
                times: vec![0.0, 2.0],
                interpolation: Interpolation::Linear,
                keys: Keys::Translation(vec![[0.0; 3], [4.0, 0.0, 0.0]]),
                extras: None,
            }],
            ..Animation::default()
        }],
        ..Document::default()
    }
}

fn at(seconds: f64) -> Moment {
    Moment {
        animation: Some(0),
        seconds,
    }
}

#[test]
fn a_camera_is_where_its_node_is() {
    let mut document = document();
    let scene = AnimatedScene::new(&document, None).unwrap();
    let view = scene.view(2, at(0.0)).unwrap();
    assert_near(view.eye(), [0.0, 1.0, 2.0], 1e-7);
    // A quarter around y takes −z to −x.
    assert_near(view.forward(), [-1.0, 0.0, 0.0], 1e-7);
    assert_near(view.up(), [0.0, 1.0, 0.0], 1e-7);
    assert_eq!((view.near(), view.far()), (0.25, 8.0));
    // Half of 200 rows is seen at the angle 0.25.
    let focal = view.camera(300, 200).unwrap().intrinsics.focal()[1];
    assert!((focal - 100.0 / 0.25f64.tan()).abs() < 1e-6, "{focal}");
    let refused = |node| scene.view(node, at(0.0)).map_err(Box::new).unwrap_err();
    assert!(matches!(*refused(0), CharacterError::NoCamera { node: 0 }));
    assert!(matches!(
        *refused(3),
        CharacterError::ParallelProjection { node: 3 }
    ));
    assert_eq!(camera_of(&document, 2), Some(&document.cameras[0]));
    assert_eq!(camera_of(&document, 0), None);
    assert_eq!(camera_of(&document, 99), None);
    let Projection::Perspective { far, .. } = &mut document.cameras[0].projection else {
        panic!("a perspective camera")
    };
    *far = None;
    let scene = AnimatedScene::new(&document, None).unwrap();
    assert_eq!(scene.view(2, at(0.0)).unwrap().far(), f64::INFINITY);
}

#[test]
fn a_frame_holds_what_is_shown_at_all_moments() {
    let document = document();
    let mut scene = AnimatedScene::new(&document, None).unwrap();
    let side: Viewpoint = "front".parse().unwrap();
    let moments = [at(0.0), at(1.0), at(2.0)];
    let (view, bounds) = scene.framing(moments, &side, 2.0).unwrap();
    // The other triangle, at the height 9, is in no scene.
    assert_near(bounds[0].coordinates(), [0.0; 3], 1e-7);
    assert_near(bounds[1].coordinates(), [5.0, 1.0, 0.0], 1e-7);
    // Every corner at every moment is in the picture, the outermost near its border.
    let mut greatest = 0.0f64;
    for x in [0.0, 1.0, 2.0, 3.0, 4.0, 5.0] {
        for y in [0.0, 1.0] {
            let [column, row, depth] = view.project([x, y, 0.0], 400, 200).unwrap();
            assert!(depth > view.near());
            let across = ((column - 199.5) / 200.0).abs();
            greatest = greatest.max(across).max(((row - 99.5) / 100.0).abs());
        }
    }
    assert!((0.85..0.97).contains(&greatest), "{greatest}");

    let place: Viewpoint = "eye 0,0,9 target 0,0,0 fov 40".parse().unwrap();
    let (view, bounds) = scene.framing(moments, &place, 2.0).unwrap();
    assert_near(view.eye(), [0.0, 0.0, 9.0], 1e-12);
    assert_near(bounds[1].coordinates(), [5.0, 1.0, 0.0], 1e-7);
}

#[test]
fn moments_of_an_animation_that_does_not_exist_are_refused() {
    let document = document();
    let mut scene = AnimatedScene::new(&document, None).unwrap();
    let wrong = Moment {
        animation: Some(1),
        seconds: 0.0,
    };
    assert!(matches!(scene.at(wrong), Err(CharacterError::Document(_))));
    let side: Viewpoint = "front".parse().unwrap();
    let framed = scene.framing([at(0.0), wrong], &side, 1.0);
    assert!(matches!(framed, Err(CharacterError::Document(_))));
    let nothing = Document::default();
    let mut scene = AnimatedScene::new(&nothing, None).unwrap();
    let framed = scene.framing([Moment::default()], &side, 1.0);
    assert!(matches!(framed, Err(CharacterError::Viewpoint(_))));
    assert!(scene.warnings().is_empty());
}

/// Where a node is, only the moment decides, and a document may be shown at any order of times.
#[test]
fn times_may_come_in_any_order() {
    let document = document();
    let mut scene = AnimatedScene::new(&document, None).unwrap();
    for seconds in [2.0, 0.5, 1.0, 0.0] {
        let [low, high] = scene.at(at(seconds)).unwrap().bounds();
        let x = 2.0 * seconds;
        assert_near(low.coordinates(), [x, 0.0, 0.0], 1e-6);
        assert_near(high.coordinates(), [x + 1.0, 1.0, 0.0], 1e-6);
    }
}
