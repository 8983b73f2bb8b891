use std::path::Path;

use ga_anim::weights::{Influence, SkinWeights};
use ga_character::{CharacterError, Figure};
use ga_mesh::gltf::{Image, ImageSource};

use super::{character, journey};

/// What a vertex has of a joint.
fn share(weights: &SkinWeights, vertex: usize, joint: u32) -> f64 {
    let influences = weights.influences(vertex).iter();
    let own = influences.filter(|influence| influence.joint == joint);
    own.map(|influence| influence.weight).sum()
}

#[test]
fn smooth_weights_move_half_the_way_to_the_mean_of_the_neighbours() {
    let figure = Figure::new("square", character());
    let same = figure.clone().with_smoothed_weights(0).unwrap();
    assert_eq!(same.character.weights, figure.character.weights);
    let smooth = figure.with_smoothed_weights(1).unwrap().character.weights;
    // The corner 0 has three neighbours, of which 1 goes with the lower joint; the corner 1 has
    // the two ends of the diagonal.
    for (vertex, expected) in [
        (0, 0.5 + 0.5 / 3.0),
        (1, 0.75),
        (2, 0.5 - 0.5 / 3.0),
        (3, 0.25),
    ] {
        assert!(
            (share(&smooth, vertex, 0) - expected).abs() < 1e-12,
            "{vertex}"
        );
    }
}

#[test]
fn the_document_has_the_smooth_weights_as_well() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("square.glb");
    let clip = journey(0.5, &[[0.0; 3]]);
    let (bytes, _) =
        ga_character::gltf::encode(&Figure::new("square", character()), &clip, "still").unwrap();
    std::fs::write(&path, bytes).unwrap();
    let figure = Figure::read_gltf(&path, 1.0).unwrap();
    let before = figure.document.clone().unwrap();
    let figure = figure.with_smoothed_weights(1).unwrap();
    let document = figure.document.unwrap();
    assert_ne!(document, before);
    let primitive = &document.meshes[0].primitives[0];
    for (vertex, joints) in primitive.joints[0].iter().enumerate() {
        for (joint, weight) in joints.iter().zip(primitive.weights[0][vertex]) {
            let expected = share(&figure.character.weights, vertex, u32::from(*joint));
            assert!(weight == 0.0 || (f64::from(weight) - expected).abs() < 1e-6);
        }
    }
}

/// A fan whose middle has ten neighbours, each with a joint of its own.
#[test]
fn the_eight_strongest_joints_of_a_vertex_are_kept() {
    let mut character = character();
    let around: Vec<[f64; 3]> = (0..10)
        .map(|step| {
            let (sin, cos) = (f64::from(step) * 0.2 * std::f64::consts::PI).sin_cos();
            [cos, sin, 0.0]
        })
        .collect();
    let places = [vec![[0.0; 3]], around].concat();
    let triangles = (0..10).map(|step| [0, 1 + step, 1 + (step + 1) % 10]);
    let faces = ga_mesh::Faces::from_uniform(triangles.collect()).unwrap();
    character.mesh = ga_mesh::Mesh::new(places, faces).unwrap();
    let rows = (0..11).map(|vertex| [(vertex, 1.0)]);
    character.weights = SkinWeights::new(11, rows).unwrap();
    let smooth = Figure::new("fan", character)
        .with_smoothed_weights(1)
        .unwrap();
    let middle = smooth.character.weights.influences(0);
    assert_eq!(middle.len(), 8);
    // Half of itself and seven of the ten twentieths are left, which are divided by their sum.
    let own: Vec<&Influence> = middle.iter().filter(|it| it.joint == 0).collect();
    assert!((own[0].weight - 0.5 / 0.85).abs() < 1e-12);
}

#[test]
fn a_relocated_document_leads_to_the_same_picture() {
    let mut figure = Figure::new("square", character());
    let mut document = ga_mesh::gltf::Document::default();
    document.images.push(Image {
        name: None,
        source: ImageSource::Uri("skin.png".to_owned()),
        extras: None,
    });
    figure.document = Some(document);
    figure.file = Some(Path::new("in/figure.gltf").to_path_buf());
    let figure = figure.relocated(Path::new("out/figure.gltf")).unwrap();
    assert_eq!(figure.file.as_deref(), Some(Path::new("out/figure.gltf")));
    let ImageSource::Uri(file) = &figure.document.unwrap().images[0].source else {
        panic!("a picture in a file")
    };
    assert_eq!(file, "../in/skin.png");
}

#[test]
fn the_names_of_joints_are_listed_for_one_that_does_not_exist() {
    let figure = Figure::new("square", character());
    assert_eq!(figure.joints_named("above").unwrap(), [1]);
    assert_eq!(figure.joints_named("all").unwrap(), [0, 1]);
    let Err(CharacterError::NoJoint { name, joints }) = figure.joints_named("beside") else {
        panic!("no such joint")
    };
    assert_eq!(name, "beside");
    assert_eq!(joints, ["below", "above"]);
}
