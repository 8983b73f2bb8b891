//! Models that cannot be written.

use ga_mesh::gltf::model::{Dielectric, Model, ModelProblem, encode};

use super::source::{Source, strip};
use ga_mesh::FormatError;

#[test]
fn what_cannot_be_written_is_named() {
    let good = strip(2, 6, 2, 3);
    let fails = |change: &dyn Fn(&mut Source)| {
        let mut source = good.clone();
        change(&mut source);
        match source.write() {
            Err(FormatError::Model(problem)) => problem,
            other => panic!("{other:?}"),
        }
    };
    let animation = || "bend".to_owned();

    assert_eq!(
        fails(&|s| s.triangles = vec![[1, 1, 2]]),
        ModelProblem::Empty
    );
    assert_eq!(
        fails(&|s| s.positions[4][1] = 1e39),
        ModelProblem::NotFinite {
            what: "position",
            index: 4
        }
    );
    assert_eq!(
        fails(&|s| s.normals[3][0] = f64::NAN),
        ModelProblem::NotFinite {
            what: "normal",
            index: 3
        }
    );
    assert_eq!(
        fails(&|s| s.triangles[2][1] = 6),
        ModelProblem::Triangle {
            triangle: 2,
            vertex: 6,
            vertices: 6
        }
    );
    assert_eq!(
        fails(&|s| s.normals.truncate(5)),
        ModelProblem::Count {
            what: "normals",
            expected: 6,
            found: 5
        }
    );
    assert_eq!(
        fails(&|s| s.weights = strip(2, 5, 2, 1).weights),
        ModelProblem::Count {
            what: "vertices with weights",
            expected: 6,
            found: 5
        }
    );
    assert_eq!(
        fails(&|s| s.weights[4] = vec![(0, 0.5), (2, 0.5)]),
        ModelProblem::Influence {
            vertex: 4,
            joint: 2,
            joints: 2
        }
    );
    for (weights, sum) in [
        (vec![], 0.0),
        (vec![(0, 0.75), (1, 0.5)], 1.25),
        (vec![(0, 1.5), (1, -0.5)], 1.0),
        (vec![(0, f64::INFINITY)], f64::INFINITY),
    ] {
        let error = ModelProblem::Weights { vertex: 5, sum };
        assert_eq!(fails(&|s| s.weights[5] = weights.clone()), error);
    }
    assert_eq!(fails(&|s| s.joints.clear()), ModelProblem::JointCount(0));
    assert_eq!(
        fails(&|s| s.joints[0].parent = Some(1)),
        ModelProblem::ParentNotBefore {
            joint: "joint 0".into(),
            parent: 1
        }
    );
    for change in [
        &(|s: &mut Source| s.joints[1].rest.rotation = [0.0; 4]) as &dyn Fn(&mut Source),
        &|s: &mut Source| s.joints[1].rest.translation[2] = f64::INFINITY,
    ] {
        let joint = "joint 1".into();
        assert_eq!(fails(change), ModelProblem::Rest { joint });
    }
    assert_eq!(
        fails(&|s| s.joints[1].rest.translation[2] = 1e39),
        ModelProblem::NotFinite {
            what: "joint",
            index: 1
        }
    );
    assert_eq!(
        fails(&|s| s.animations[0].times.clear()),
        ModelProblem::NoKeys {
            animation: animation()
        }
    );
    assert_eq!(
        fails(&|s| s.animations[0].tracks.clear()),
        ModelProblem::NoKeys {
            animation: animation()
        }
    );
    for (key, time) in [(0, -0.1), (1, 0.0), (2, f64::NAN), (2, 1.0 / 30.0 + 1e-12)] {
        assert_eq!(
            fails(&|s| s.animations[0].times[key] = time),
            ModelProblem::Time {
                animation: animation(),
                key
            }
        );
    }
    for joint in [0, 2] {
        assert_eq!(
            fails(&|s| s.animations[0].tracks[1].joint = joint),
            ModelProblem::TrackJoint {
                animation: animation(),
                joint
            }
        );
    }
    assert_eq!(
        fails(&|s| s.animations[0].tracks[1].keys.truncate(2)),
        ModelProblem::TrackLength {
            animation: animation(),
            joint: 1,
            expected: 3,
            found: 2
        }
    );
    for change in [
        &(|s: &mut Source| s.animations[0].tracks[1].keys[2].rotation = [0.0; 4])
            as &dyn Fn(&mut Source),
        &|s: &mut Source| s.animations[0].tracks[1].keys[2].translation[0] = 1e39,
    ] {
        let key = ModelProblem::Key {
            animation: animation(),
            joint: 1,
            key: 2,
        };
        assert_eq!(fails(change), key);
    }
    let glass = Dielectric {
        roughness: 1.5,
        ..Dielectric::default()
    };
    assert_eq!(
        encode(&Model {
            material: glass,
            ..good.build().model()
        }),
        Err(FormatError::Model(ModelProblem::Material))
    );
}
