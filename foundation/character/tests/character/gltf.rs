use ga_anim::clip::Clip;
use ga_anim::gltf::Player;
use ga_anim::pose::Pose;
use ga_character::animated_scene::{AnimatedScene, Moment};
use ga_character::{Figure, gltf};
use ga_mesh::gltf::{Document, Mesh, Node, Primitive, Scene, Transform, decode};

use super::{assert_near, character, journey, moved, painted};

/// A square with a skin, and beside it a triangle that no joint moves, at the height 5.
fn document() -> Document {
    let clip = journey(0.5, &[[0.0; 3]]);
    let (bytes, _) = gltf::encode(&Figure::new("square", character()), &clip, "still").unwrap();
    let mut document = decode(&bytes).unwrap();
    document.animations.clear();
    document.meshes.push(Mesh {
        primitives: vec![Primitive {
            positions: vec![[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]],
            ..Primitive::default()
        }],
        ..Mesh::default()
    });
    document.nodes.push(Node {
        mesh: Some(document.meshes.len() - 1),
        transform: Transform::Decomposed {
            translation: [0.0, 5.0, 0.0],
            rotation: [0.0, 0.0, 0.0, 1.0],
            scale: [1.0; 3],
        },
        ..Node::default()
    });
    let triangle = document.nodes.len() - 1;
    document.scenes[0].nodes.push(triangle);
    document
}

/// The least and the greatest coordinates of what a document shows at a time of its animation.
fn bounds(document: &Document, seconds: f64) -> [[f64; 3]; 2] {
    let mut scene = AnimatedScene::new(document, None).unwrap();
    let animation = (!document.animations.is_empty()).then_some(0);
    let moment = Moment { animation, seconds };
    let model = scene.at(moment).unwrap();
    model.bounds().map(|corner| corner.coordinates())
}

/// Writes a document, reads it as a figure in centimetres, and animates it.
fn in_centimetres(document: &Document, clip: &Clip) -> Document {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("figure.glb");
    std::fs::write(&path, ga_mesh::gltf::encode(document).unwrap()).unwrap();
    let figure = Figure::read_gltf(&path, 0.01).unwrap();
    assert_eq!(figure.metres_per_unit, 0.01);
    assert!((figure.character.height() - 0.02).abs() < 1e-12);
    let (bytes, losses) = gltf::encode(&figure, clip, "go").unwrap();
    assert!(losses.is_empty());
    decode(&bytes).unwrap()
}

#[test]
fn all_that_a_document_shows_is_in_metres() {
    let document = document();
    assert_eq!(bounds(&document, 0.0), [[-1.0, 0.0, 0.0], [1.0, 6.0, 0.0]]);
    let clip = journey(0.5, &[[0.0; 3], [0.03, 0.0, 0.0]]);
    let scenes = document.scenes.clone();
    let nowhere = Scene::default();
    for scenes in [
        scenes.clone(),
        vec![],
        [scenes.clone(), scenes, vec![nowhere]].concat(),
    ] {
        let mut document = document.clone();
        document.scene = (!scenes.is_empty()).then_some(0);
        document.scenes = scenes;
        let count = document.nodes.len();
        let scaled = in_centimetres(&document, &clip);
        assert_eq!(scaled.nodes.len(), count + 1);
        let [low, high] = bounds(&scaled, 0.0);
        assert_near(low, [-0.01, 0.0, 0.0], 1e-8);
        assert_near(high, [0.01, 0.06, 0.0], 1e-8);
        // The square goes 3 cm along x; the triangle stays.
        let [low, high] = bounds(&scaled, 0.5);
        assert_near(low, [0.0, 0.0, 0.0], 1e-8);
        assert_near(high, [0.04, 0.06, 0.0], 1e-8);
        // A scene that shows nothing has no node for the unit.
        if let Some(nowhere) = scaled.scenes.get(2) {
            assert!(nowhere.nodes.is_empty());
            assert!(scaled.scenes[1].nodes.contains(&count));
        }
    }
}

#[test]
fn a_skin_stays_at_the_top_and_what_hangs_below_it_does_not() {
    let mut document = document();
    let skinned = (0..document.nodes.len())
        .find(|&node| document.nodes[node].skin.is_some())
        .unwrap();
    let triangle = document.nodes.len() - 1;
    let clip = journey(0.5, &[[0.0; 3]]);
    let scaled = in_centimetres(&document, &clip);
    let unit = scaled.nodes.len() - 1;
    assert_eq!(scaled.nodes[unit].name.as_deref(), Some("unit"));
    assert!(scaled.scenes[0].nodes.contains(&skinned));
    assert!(!scaled.nodes[unit].children.contains(&skinned));

    document.scenes[0].nodes.retain(|&node| node != triangle);
    document.nodes[skinned].children.push(triangle);
    let scaled = in_centimetres(&document, &clip);
    assert!(scaled.nodes[unit].children.contains(&skinned));
    let [_, high] = bounds(&scaled, 0.0);
    assert_near(high, [0.01, 0.06, 0.0], 1e-8);
}

#[test]
fn a_document_in_metres_gets_no_node() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("figure.glb");
    let document = document();
    std::fs::write(&path, ga_mesh::gltf::encode(&document).unwrap()).unwrap();
    let figure = Figure::read_gltf(&path, 1.0).unwrap();
    assert_eq!(figure.name, "figure");
    assert_eq!(figure.file.as_deref(), Some(path.as_path()));
    let (bytes, _) = gltf::encode(&figure, &journey(0.5, &[[0.0; 3]]), "go").unwrap();
    assert_eq!(decode(&bytes).unwrap().nodes.len(), document.nodes.len());
}

#[test]
fn joints_and_vertices_of_an_encoded_figure_move_as_its_clip_says() {
    let mut last = Pose::rest(2);
    last.joints[1] = moved([0.0, 0.0, 0.5]);
    let clip = Clip::new(0.5, vec![Pose::rest(2), last]).unwrap();
    for figure in [Figure::new("square", character()), painted()] {
        let (bytes, losses) = gltf::encode(&figure, &clip, "go").unwrap();
        assert!(losses.is_empty());
        let document = decode(&bytes).unwrap();
        let player = Player::new(&document).unwrap();
        let pose = player.pose(Some(0), 0.5).unwrap();
        // The joints are the first nodes.
        assert_near(pose.world[0].translation, [0.0; 3], 1e-7);
        assert_near(pose.world[1].translation, [0.0, 1.0, 0.5], 1e-7);
        assert_eq!(bounds(&document, 0.5), [[-1.0, 0.0, 0.0], [1.0, 2.0, 0.5]]);
    }
}
