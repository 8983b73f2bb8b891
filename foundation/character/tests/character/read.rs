use std::path::Path;

use ga_anim::weights::Influence;
use ga_character::{CharacterError, Figure};
use ga_files::Reading;

/// Two triangles with a vertex in common, in groups of their own, and a rig of one joint.
const MESH: &str = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nv 0 0 2\n\
                    g other\nf 1 2 3\ng body\nf 3 4 5\n";

fn write(folder: &Path) -> [std::path::PathBuf; 3] {
    let texts = [
        ("mesh.obj", MESH),
        (
            "rig.json",
            r#"{"a": {"head": {"default_position": [0, 0, 0]},
                "tail": {"default_position": [0, 0, 0.1]}, "parent": ""}}"#,
        ),
        (
            "weights.json",
            r#"{"weights": {"a": [[0, 1], [1, 1], [2, 1], [3, 1], [4, 1]]}}"#,
        ),
    ];
    texts.map(|(name, text)| {
        let path = folder.join(name);
        std::fs::write(&path, text).unwrap();
        path
    })
}

#[test]
fn the_body_is_taken_unless_another_group_is_asked_for() {
    let folder = tempfile::tempdir().unwrap();
    let [mesh, rig, weights] = write(folder.path());
    let of = |group, unit| {
        Figure::read_parts(&mesh, &rig, &weights, group, unit, Reading::default()).map_err(Box::new)
    };
    let body = of(None, 0.1).unwrap();
    assert_eq!(
        (body.name.as_str(), body.group.as_deref()),
        ("mesh", Some("body"))
    );
    assert_eq!(body.metres_per_unit, 0.1);
    let places: Vec<[f64; 3]> = body.character.mesh.coordinates().collect();
    assert_eq!(places, [[0.0, 0.1, 0.0], [0.0, 0.0, 0.1], [0.0, 0.0, 0.2]]);
    assert_eq!(body.character.weights.vertex_count(), 3);
    assert_eq!(
        body.character.weights.influences(2),
        [Influence {
            joint: 0,
            weight: 1.0
        }]
    );
    assert!((body.character.skeleton.joints()[0].tail[1] - 0.1).abs() < 1e-15);
    let other = of(Some("other"), 1.0).unwrap();
    assert_eq!(other.group.as_deref(), Some("other"));
    assert_eq!(other.character.mesh.bounds().unwrap()[1], [1.0, 1.0, 0.0]);
    let CharacterError::NoGroup {
        group,
        groups,
        path,
    } = *of(Some("hair"), 1.0).unwrap_err()
    else {
        panic!("no such group")
    };
    assert_eq!((group.as_str(), path), ("hair", mesh.clone()));
    assert_eq!(groups, ["other", "body"]);
    assert!(matches!(
        *of(None, 1e308).unwrap_err(),
        CharacterError::Unit { .. }
    ));
}
