//! Bones and weights from JSON: the real rig against known positions, made ones with known faults.

use crate::assert_relative;
use ga_anim::MotionFileError;
use ga_anim::rig::{self};
use ga_anim::skeleton::{Skeleton, SkeletonError};
use ga_anim::skin::SkinError;
use ga_anim::weights::Influence;
use nullcone_shared_data::shared;
use serde_json::{Value, json};

fn truth() -> Value {
    serde_json::from_str(include_str!("../data/human.json")).unwrap()
}

fn real_rig() -> Skeleton {
    rig::decode(include_bytes!("../data/rig.cmu_mb.json")).unwrap()
}

#[test]
fn the_bones_of_the_human_are_where_they_should_be() {
    let (skeleton, truth) = (real_rig(), truth());
    let bones = truth["bones"].as_array().unwrap();
    assert_eq!(skeleton.len(), bones.len());
    for (known, name) in bones.iter().enumerate() {
        let joint = skeleton.joint(name.as_str().unwrap()).unwrap();
        for axis in 0..3 {
            assert_relative(
                joint.head[axis],
                truth["head"][known][axis].as_f64().unwrap(),
                1e-15,
            );
            assert_relative(
                joint.tail[axis],
                truth["tail"][known][axis].as_f64().unwrap(),
                1e-15,
            );
        }
        let parent = usize::try_from(truth["parent"][known].as_i64().unwrap()).ok();
        assert_eq!(
            joint
                .parent
                .map(|parent| skeleton.joints()[parent].name.as_str()),
            parent.map(|parent| bones[parent].as_str().unwrap())
        );
    }
}

#[test]
fn parents_come_first_and_siblings_by_name() {
    let skeleton = real_rig();
    let names: Vec<&str> = skeleton
        .joints()
        .iter()
        .map(|joint| joint.name.as_str())
        .collect();
    assert_eq!(names[..4], ["Hips", "LHipJoint", "LeftUpLeg", "LeftLeg"]);
    let hips = skeleton.index("Hips").unwrap();
    let below: Vec<&str> = skeleton.children(hips).map(|child| names[child]).collect();
    assert_eq!(below, ["LHipJoint", "LowerBack", "RHipJoint"]);
}

#[test]
fn the_weights_of_the_human_cover_every_vertex() {
    let Some(path) = shared("data/anim/human/weights.cmu_mb.json") else {
        return;
    };
    let skeleton = real_rig();
    let weights = rig::read_weights(&path, &skeleton, 19_158).unwrap();
    assert_eq!(
        (weights.vertex_count(), weights.max_influences()),
        (19_158, 8)
    );
    for influences in weights.iter() {
        assert_relative(
            influences.iter().map(|influence| influence.weight).sum(),
            1.0,
            1e-15,
        );
    }
    // The file's own numbers, read another way.
    let file: Value = serde_json::from_slice(&std::fs::read(&path).unwrap()).unwrap();
    let mut sums = vec![0.0; 19_158];
    for pair in file["weights"]
        .as_object()
        .unwrap()
        .values()
        .flat_map(|list| list.as_array().unwrap())
    {
        sums[pair[0].as_u64().unwrap() as usize] += pair[1].as_f64().unwrap();
    }
    for (bone, list) in file["weights"].as_object().unwrap() {
        let joint = skeleton.index(bone).unwrap() as u32;
        for pair in list.as_array().unwrap() {
            let vertex = pair[0].as_u64().unwrap() as usize;
            let ours = weights
                .influences(vertex)
                .iter()
                .find(|influence| influence.joint == joint)
                .unwrap();
            assert_relative(ours.weight, pair[1].as_f64().unwrap() / sums[vertex], 1e-14);
        }
    }

    for (vertices, message) in [
        (
            19_157,
            "has a weight for vertex 19157, but the mesh has 19157 vertices, counted from 0",
        ),
        (19_159, "vertex 19158 is moved by no joint"),
    ] {
        let error = rig::read_weights(&path, &skeleton, vertices)
            .unwrap_err()
            .to_string();
        assert!(
            error.contains("weights.cmu_mb.json: ") && error.ends_with(message),
            "{error}"
        );
    }
}

#[test]
fn other_rigs_and_weights_of_this_form_are_read() {
    let (Some(bones), Some(weights)) = (
        shared("data/anim/human/rig.game_engine.json"),
        shared("data/anim/human/weights.game_engine.json"),
    ) else {
        return;
    };
    let skeleton = rig::read(bones).unwrap();
    assert_eq!(skeleton.joints()[0].parent, None);
    let weights = rig::read_weights(weights, &skeleton, 19_158).unwrap();
    assert_eq!(weights.joint_count(), skeleton.len());
}

fn bone(parent: &str) -> Value {
    json!({"head": {"default_position": [0, 0, 0]}, "tail": {"default_position": [0, 0, 1]}, "parent": parent})
}

fn error_of(bones: &Value) -> MotionFileError {
    rig::decode(bones.to_string().as_bytes()).unwrap_err()
}

#[test]
fn what_is_no_rig_is_named() {
    assert!(matches!(
        error_of(&json!({})),
        MotionFileError::Skeleton(SkeletonError::Empty)
    ));
    let lost = error_of(&json!({"a": bone(""), "b": bone("c")}));
    assert_eq!(
        lost.to_string(),
        "bone \"b\" has the parent \"c\", which is not in the file"
    );
    let ring =
        json!({"a": bone(""), "b": bone("d"), "c": bone("d"), "d": bone("e"), "e": bone("d")});
    assert!(
        matches!(error_of(&ring), MotionFileError::Cycle { bone } if bone == "d" || bone == "e"),
        "b and c hang below the cycle but are not in it"
    );
    assert_eq!(
        error_of(&json!({"a": bone("a")})).to_string(),
        "bone \"a\" is its own ancestor"
    );

    let twice = format!("{{\"a\": {0}, \"a\": {0}}}", bone(""));
    let error = rig::decode(twice.as_bytes()).unwrap_err();
    assert_eq!(error.to_string(), "bone \"a\" is in the file twice");

    for (text, message) in [
        ("", "EOF while parsing a value at line 1 column 0"),
        (
            "[1, 2]",
            "invalid type: sequence, expected an object of bones by name at line 1 column 0",
        ),
        (
            "{\"weights\": {\"Head\": []}}",
            "missing field `head` at line 1 column 24",
        ),
        ("\u{0}\u{1}PNG", "expected value at line 1 column 1"),
    ] {
        assert_eq!(
            rig::decode(text.as_bytes()).unwrap_err().to_string(),
            message
        );
    }
    let infinite = bone("").to_string().replace("[0,0,1]", "[0,\n0,1e999]");
    let error = rig::decode(format!("{{\"a\": {infinite}}}").as_bytes())
        .unwrap_err()
        .to_string();
    assert!(
        error.starts_with("number out of range at line 2"),
        "{error}"
    );
}

#[test]
fn what_are_no_weights_is_named() {
    let skeleton = rig::decode(
        json!({"a": bone(""), "b": bone("a")})
            .to_string()
            .as_bytes(),
    )
    .unwrap();
    let parse = |weights: Value| {
        rig::decode_weights(
            json!({ "weights": weights }).to_string().as_bytes(),
            &skeleton,
            2,
        )
    };
    let good = parse(json!({"b": [[0, 1.0], [1, 0.25]], "a": [[0, 3.0]]})).unwrap();
    let expected = [
        Influence {
            joint: 0,
            weight: 0.75,
        },
        Influence {
            joint: 1,
            weight: 0.25,
        },
    ];
    assert_eq!(
        (good.influences(0), good.influences(1)),
        (
            &expected[..],
            &[Influence {
                joint: 1,
                weight: 1.0
            }][..]
        )
    );

    assert!(matches!(
        parse(json!({"c": [[0, 1.0]]})).unwrap_err(),
        MotionFileError::UnknownBone { bone } if bone == "c"
    ));
    assert!(matches!(
        parse(json!({"a": [[0, 1.0], [2, 1.0]]})).unwrap_err(),
        MotionFileError::VertexOutOfRange { bone, vertex: 2, vertices: 2 } if bone == "a"
    ));
    for (weights, expected) in [
        (
            json!({"a": [[0, 1.0]]}),
            SkinError::Unweighted { vertex: 1 },
        ),
        (
            json!({"a": [[0, 1.0], [1, 0.0]]}),
            SkinError::Unweighted { vertex: 1 },
        ),
        (
            json!({"a": [[0, 1.0], [1, -0.5]]}),
            SkinError::BadWeight {
                vertex: 1,
                joint: 0,
                weight: -0.5,
            },
        ),
        (
            json!({"a": [[0, 1.0], [1, 1.0], [1, 1.0]]}),
            SkinError::DuplicateJoint {
                vertex: 1,
                joint: 0,
            },
        ),
    ] {
        assert!(
            matches!(parse(weights).unwrap_err(), MotionFileError::Skin(found) if found == expected)
        );
    }
    for text in [
        "{}",
        "{\"weights\": 3}",
        "{\"weights\": {\"a\": [[-1, 1.0]]}}",
        "{\"weights\": {\"a\": [[0, \"1\"]]}}",
    ] {
        assert!(matches!(
            rig::decode_weights(text.as_bytes(), &skeleton, 2).unwrap_err(),
            MotionFileError::Json(_)
        ));
    }
}

#[test]
fn a_skeleton_can_be_had_in_metres() {
    let metres = real_rig().scaled(rig::METRES_PER_UNIT).unwrap();
    let head = metres.joint("Head").unwrap();
    let foot = metres.joint("LeftFoot").unwrap();
    let height = head.tail[1] - foot.tail[1];
    assert!(
        (1.5..1.8).contains(&height),
        "{height} m from toes to crown"
    );
    assert!(matches!(
        real_rig().scaled(f64::INFINITY).unwrap_err(),
        SkeletonError::NotFinite { .. }
    ));
}
