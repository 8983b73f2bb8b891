//! Weights by distance through the body.

use ga_anim::pose::Pose;
use ga_anim::rig;
use ga_anim::skin::{Method, SkinError, skin};
use ga_anim::weights::distance::distance_weights;
use ga_anim::weights::geodesic::{Options, geodesic_weights};
use ga_anim::weights::{Influence, SkinWeights};
use ga_mesh::obj;
use ga_runtime::cga3::{Motor, Rotor};
use nullcone_shared_data::shared;

/// A box with 12 triangles.
fn cuboid(low: [f64; 3], high: [f64; 3], first: u32) -> (Vec<[f64; 3]>, Vec<[u32; 3]>) {
    let end = |k: usize, axis: usize| {
        if k >> axis & 1 == 0 {
            low[axis]
        } else {
            high[axis]
        }
    };
    let positions = (0..8).map(|k| [end(k, 0), end(k, 1), end(k, 2)]).collect();
    let faces = [
        [0, 2, 3, 1],
        [4, 5, 7, 6],
        [0, 1, 5, 4],
        [2, 6, 7, 3],
        [0, 4, 6, 2],
        [1, 3, 7, 5],
    ];
    let triangles = faces
        .iter()
        .flat_map(|&[a, b, c, d]| [[a, b, c], [a, c, d]])
        .map(|t: [u32; 3]| t.map(|v| v + first))
        .collect();
    (positions, triangles)
}

/// In a convex body all paths are straight, so the distances are those in space up to the cells.
#[test]
fn in_a_convex_body_distances_are_those_in_space() {
    let (positions, triangles) = cuboid([0.0; 3], [4.0, 1.0, 1.0], 0);
    let bones = [
        [[0.5, 0.5, 0.5], [1.5, 0.5, 0.5]],
        [[2.5, 0.5, 0.5], [3.5, 0.5, 0.5]],
    ];
    let options = Options {
        influences: 2,
        exponent: 1.0,
        resolution: 200,
    };
    let found = geodesic_weights(&positions, &triangles, &bones, &options).unwrap();
    assert!(found.has_interior && found.unreached.is_empty());
    let known = distance_weights(positions.iter().copied(), &bones, 2, 1.0).unwrap();
    for vertex in 0..positions.len() {
        for (ours, known) in found
            .weights
            .influences(vertex)
            .iter()
            .zip(known.influences(vertex))
        {
            assert_eq!(ours.joint, known.joint);
            assert!(
                (ours.weight - known.weight).abs() < 0.01,
                "{vertex}: {ours:?} {known:?}"
            );
        }
    }
}

/// A gap much thinner than a cell separates.
#[test]
fn a_thin_gap_separates() {
    let (mut positions, mut triangles) = cuboid([0.0; 3], [1.0, 1.0, 1.0], 0);
    let (others, more) = cuboid([1.001, 0.0, 0.0], [2.0, 1.0, 1.0], 8);
    positions.extend(others);
    triangles.extend(more);
    let bones = [
        [[0.9, 0.2, 0.5], [0.9, 0.8, 0.5]],
        [[1.1, 0.2, 0.5], [1.1, 0.8, 0.5]],
    ];
    let options = Options {
        resolution: 20,
        ..Options::default()
    };
    let found = geodesic_weights(&positions, &triangles, &bones, &options).unwrap();
    for vertex in 0..16 {
        let [only] = found.weights.influences(vertex) else {
            panic!("vertex {vertex} follows both");
        };
        assert_eq!(only.joint, u32::from(vertex >= 8));
    }
}

#[test]
fn a_surface_without_inside_uses_its_edges() {
    let positions = [
        [0.0, 0.0, 0.0],
        [1.0, 0.0, 0.0],
        [2.0, 0.0, 0.0],
        [1.0, 1.0, 0.0],
        [9.0, 9.0, 9.0],
    ];
    let triangles = [[0, 1, 3], [1, 2, 3]];
    let bones = [
        [[0.0, 0.0, 0.0], [0.0, 0.0, 0.1]],
        [[2.0, 0.0, 0.0], [2.0, 0.0, 0.1]],
    ];
    let found = geodesic_weights(&positions, &triangles, &bones, &Options::default()).unwrap();
    assert!(!found.has_interior);
    assert_eq!(found.weights.influences(0).len(), 1);
    assert!((found.weights.influences(1)[0].weight - 0.5).abs() < 1e-12);
    // The last vertex belongs to no triangle and takes the weights of the nearest corner.
    assert_eq!(found.unreached, [4]);
    assert_eq!(found.weights.influences(4), found.weights.influences(3));
}

#[test]
fn what_is_wrong_is_named() {
    let (mut positions, triangles) = cuboid([0.0; 3], [1.0; 3], 0);
    let bones = [[[0.5, 0.5, 0.2], [0.5, 0.5, 0.8]]];
    let weights = |positions: &[[f64; 3]], triangles: &[[u32; 3]], options: &Options| {
        geodesic_weights(positions, triangles, &bones, options)
    };
    let usual = Options::default();
    assert_eq!(
        weights(&positions, &[], &usual),
        Err(SkinError::NoTriangles)
    );
    let options = Options {
        resolution: 0,
        ..usual
    };
    assert_eq!(
        weights(&positions, &triangles, &options),
        Err(SkinError::BadResolution { resolution: 0 })
    );
    let options = Options {
        influences: 0,
        ..usual
    };
    assert_eq!(
        weights(&positions, &triangles, &options),
        Err(SkinError::NoInfluences)
    );
    assert!(matches!(
        weights(&positions, &[[0, 1, 9]], &usual),
        Err(SkinError::Mesh(_))
    ));
    positions[2][1] = f64::NAN;
    let error = weights(&positions, &triangles, &usual).unwrap_err();
    assert!(error.to_string().starts_with("point 2 "), "{error}");
}

/// The human with the arms down: hands hang beside the thighs, and no thigh moves a hand.
#[test]
fn thighs_do_not_pull_hands() {
    let (Some(mesh), Some(painted)) = (
        shared("data/anim/human_base.obj"),
        shared("data/anim/human/weights.cmu_mb.json"),
    ) else {
        return;
    };
    let mesh = obj::read(mesh).unwrap();
    let skeleton = rig::decode(include_bytes!("../data/rig.cmu_mb.json")).unwrap();
    let painted = rig::read_weights(painted, &skeleton, mesh.vertex_count()).unwrap();
    let body = mesh.part("body").unwrap();
    let weights = painted.select(&body.vertices).unwrap();

    let about_z = |angle: f64| Rotor::from_axis_angle([0.0, 0.0, 1.0], angle).unwrap();
    let mut rotors = vec![Rotor::default(); skeleton.len()];
    for (name, angle) in [("LeftArm", -0.75), ("RightArm", 0.75)] {
        rotors[skeleton.index(name).unwrap()] = about_z(angle);
    }
    let pose = Pose::from_rotors(&skeleton, Motor::default(), &rotors).unwrap();
    let motions = pose.motions(&skeleton).unwrap();
    let moved = skin(body.mesh.positions(), &weights, &motions, Method::Motor).unwrap();
    let bones = pose.bones(&skeleton).unwrap();

    let hand = |joint: u32| {
        let name = skeleton.joints()[joint as usize].name.as_str();
        ["Hand", "Thumb", "Finger"]
            .iter()
            .any(|part| name.contains(part))
    };
    let heaviest = weights.strongest(1);
    let hands: Vec<usize> = (0..moved.len())
        .filter(|&vertex| hand(heaviest.influences(vertex)[0].joint))
        .collect();
    let thighs = ["LeftUpLeg", "RightUpLeg", "LHipJoint", "RHipJoint"];
    let thighs = thighs.map(|name| skeleton.index(name).unwrap() as u32);
    let pulled = |weights: &SkinWeights| {
        let is_thigh = |influence: &Influence| thighs.contains(&influence.joint);
        let follows = |vertex: &&usize| weights.influences(**vertex).iter().any(is_thigh);
        hands.iter().filter(follows).count()
    };
    assert!(hands.len() > 1000);
    let triangles = body.mesh.triangles();
    for influences in [4, 8] {
        let options = Options {
            influences,
            ..Options::default()
        };
        let found = geodesic_weights(&moved, &triangles, &bones, &options).unwrap();
        assert!(found.has_interior);
        assert_eq!(pulled(&found.weights), 0, "{influences} influences");
    }
    // In space the thighs are among the eight nearest bones.
    let places = moved.iter().map(|p| p.coordinates());
    let by_distance = distance_weights(places, &bones, 8, 2.0).unwrap();
    assert!(pulled(&by_distance) > 100);
}

/// A tent whose top carries all weight: the mean of the neighbours, by hand.
#[test]
fn smoothing_is_the_mean_of_neighbours() {
    let weights = SkinWeights::new(2, [[(0, 1.0)], [(1, 1.0)], [(1, 1.0)], [(1, 1.0)]]).unwrap();
    let fan = [[0, 1, 2], [0, 2, 3]];
    let smooth = weights.smoothed(&fan, 1, 0.25).unwrap();
    let of_first = |vertex: usize| {
        let influences = smooth.influences(vertex).iter();
        influences
            .filter(|i| i.joint == 0)
            .map(|i| i.weight)
            .sum::<f64>()
    };
    // The first vertex has three neighbours, the third too, the others two.
    for (vertex, expected) in [0.75, 0.125, 0.25 / 3.0, 0.125].into_iter().enumerate() {
        assert!((of_first(vertex) - expected).abs() < 1e-15, "{vertex}");
    }
    assert_eq!(weights.smoothed(&fan, 3, 0.0), Ok(weights.clone()));
    assert!(matches!(
        weights.smoothed(&fan, 1, 1.5),
        Err(SkinError::BadShare { .. })
    ));
    assert!(matches!(
        weights.smoothed(&[[0, 1, 9]], 1, 0.5),
        Err(SkinError::Mesh(_))
    ));
}
