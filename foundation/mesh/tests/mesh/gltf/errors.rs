//! Models that cannot be written.

use ga_mesh::gltf::model::{Material, Model, ModelError, to_glb};

use super::source::{Source, strip};

#[test]
fn what_cannot_be_written_is_named() {
    let good = strip(2, 6, 2, 3);
    let fails = |change: &dyn Fn(&mut Source)| {
        let mut source = good.clone();
        change(&mut source);
        source.write().unwrap_err()
    };
    let animation = || "bend".to_owned();

    assert_eq!(fails(&|s| s.triangles = vec![[1, 1, 2]]), ModelError::Empty);
    assert_eq!(
        fails(&|s| s.positions[4][1] = 1e39),
        ModelError::NotFinite {
            what: "position",
            index: 4
        }
    );
    assert_eq!(
        fails(&|s| s.normals[3][0] = f64::NAN),
        ModelError::NotFinite {
            what: "normal",
            index: 3
        }
    );
    assert_eq!(
        fails(&|s| s.triangles[2][1] = 6),
        ModelError::Triangle {
            triangle: 2,
            vertex: 6,
            vertices: 6
        }
    );
    assert_eq!(
        fails(&|s| s.normals.truncate(5)),
        ModelError::Count {
            what: "normals",
            expected: 6,
            found: 5
        }
    );
    assert_eq!(
        fails(&|s| s.weights = strip(2, 5, 2, 1).weights),
        ModelError::Count {
            what: "vertices with weights",
            expected: 6,
            found: 5
        }
    );
    assert_eq!(
        fails(&|s| s.weights[4] = vec![(0, 0.5), (2, 0.5)]),
        ModelError::Influence {
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
        let error = ModelError::Weights { vertex: 5, sum };
        assert_eq!(fails(&|s| s.weights[5] = weights.clone()), error);
    }
    assert_eq!(fails(&|s| s.joints.clear()), ModelError::JointCount(0));
    assert_eq!(
        fails(&|s| s.joints[0].parent = Some(1)),
        ModelError::ParentNotBefore {
            joint: "joint 0".into(),
            parent: 1
        }
    );
    for change in [
        &(|s: &mut Source| s.joints[1].rest.rotation = [0.0; 4]) as &dyn Fn(&mut Source),
        &|s: &mut Source| s.joints[1].rest.translation[2] = f64::INFINITY,
    ] {
        let joint = "joint 1".into();
        assert_eq!(fails(change), ModelError::Rest { joint });
    }
    assert_eq!(
        fails(&|s| s.joints[1].rest.translation[2] = 1e39),
        ModelError::NotFinite {
            what: "joint",
            index: 1
        }
    );
    assert_eq!(
        fails(&|s| s.animations[0].times.clear()),
        ModelError::NoKeys {
            animation: animation()
        }
    );
    assert_eq!(
        fails(&|s| s.animations[0].tracks.clear()),
        ModelError::NoKeys {
            animation: animation()
        }
    );
    for (key, time) in [(0, -0.1), (1, 0.0), (2, f64::NAN), (2, 1.0 / 30.0 + 1e-12)] {
        assert_eq!(
            fails(&|s| s.animations[0].times[key] = time),
            ModelError::Time {
                animation: animation(),
                key
            }
        );
    }
    for joint in [0, 2] {
        assert_eq!(
            fails(&|s| s.animations[0].tracks[1].joint = joint),
            ModelError::TrackJoint {
                animation: animation(),
                joint
            }
        );
    }
    assert_eq!(
        fails(&|s| s.animations[0].tracks[1].keys.truncate(2)),
        ModelError::TrackLength {
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
        let key = ModelError::Key {
            animation: animation(),
            joint: 1,
            key: 2,
        };
        assert_eq!(fails(change), key);
    }
    let glass = Material {
        roughness: 1.5,
        ..Material::default()
    };
    assert_eq!(
        to_glb(&Model {
            material: glass,
            ..good.build().model()
        }),
        Err(ModelError::Material)
    );
}
