//! Markers on the skin.

use std::sync::LazyLock;

use ga_mannequin::Marker;
use ga_runtime::vga3::Vector;

use crate::skin::texel;
use crate::{HUMAN, joint, positions};

static MARKERS: LazyLock<Vec<Marker>> = LazyLock::new(|| HUMAN.markers());

#[test]
fn markers_have_names_of_their_own_and_do_not_overlap() {
    assert_eq!(MARKERS.len(), 70);
    for (index, marker) in MARKERS.iter().enumerate() {
        let bone = &HUMAN.skeleton.joints()[marker.joint].name;
        assert!(
            marker.name.starts_with(&format!("{bone} ")),
            "{}",
            marker.name
        );
        assert!(
            MARKERS[..index]
                .iter()
                .all(|other| other.name != marker.name)
        );
    }
    // Palm and back of a hand are nearer to each other than their radii together, but neither
    // reaches the other.
    for place in positions().into_iter().map(Vector::from) {
        let near = |marker: &&Marker| place.distance(marker.centre.into()) < marker.radius + 0.002;
        let names: Vec<&String> = MARKERS
            .iter()
            .filter(near)
            .map(|marker| &marker.name)
            .collect();
        assert!(names.len() < 2, "{names:?}");
    }
}

#[test]
fn centres_are_on_the_skin_and_middles_a_little_below() {
    let skin: Vec<Vector<f64>> = positions().into_iter().map(Vector::from).collect();
    for marker in MARKERS.iter() {
        let (centre, middle) = (Vector::from(marker.centre), Vector::from(marker.middle));
        let nearest = skin
            .iter()
            .map(|p| p.distance(centre))
            .fold(f64::INFINITY, f64::min);
        // The mesh has vertices at most a centimetre and a half apart.
        assert!(nearest < 0.010, "{}: {nearest}", marker.name);
        let below = centre.distance(middle);
        assert!(below < 0.5 * marker.radius, "{}: {below}", marker.name);
        let sum: f64 = marker
            .weights
            .iter()
            .map(|influence| influence.weight)
            .sum();
        assert!((sum - 1.0).abs() < 1e-9, "{}: {sum}", marker.name);
    }
}

#[test]
fn long_bones_carry_their_markers_alone() {
    for bone in ["UpperLeg", "LowerLeg", "UpperArm", "LowerArm"] {
        for side in ["Left", "Right"] {
            let joint = joint(&format!("{side}{bone}"));
            let own = MARKERS.iter().filter(|marker| marker.joint == joint);
            let shares: Vec<f64> = own
                .map(|marker| {
                    let influences = marker.weights.iter();
                    let own = influences.filter(|influence| influence.joint as usize == joint);
                    own.map(|influence| influence.weight).sum()
                })
                .collect();
            assert_eq!(shares.len(), 4);
            assert!(
                shares.iter().all(|&share| share > 0.8),
                "{side}{bone}: {shares:?}"
            );
        }
    }
}

#[test]
fn left_and_right_are_mirror_images() {
    for marker in MARKERS
        .iter()
        .filter(|marker| marker.name.starts_with("Left"))
    {
        let [x, y, z] = marker.centre;
        let others = MARKERS
            .iter()
            .filter(|other| other.name.starts_with("Right"));
        let nearest = others
            .map(|other| Vector::from(other.centre).distance(Vector::new(-x, y, z)))
            .fold(f64::INFINITY, f64::min);
        assert!(nearest < 1e-3, "{}: {nearest}", marker.name);
    }
}

#[test]
fn the_marked_texture_is_grey_but_for_the_markers() {
    let size = 2048;
    let colours = [[200, 10, 10], [10, 10, 200]];
    let texture = HUMAN.marked_texture(size, &MARKERS[..], &vec![colours; MARKERS.len()]);
    let is_coloured = |[r, g, b]: &[u8; 3]| r.max(g).max(b) - r.min(g).min(b) > 100;
    let coloured = texture
        .values()
        .iter()
        .filter(|texel| is_coloured(texel))
        .count();
    // The discs as a part of the skin, whose charts cover about two thirds of the texture.
    let discs: f64 = MARKERS
        .iter()
        .map(|m| std::f64::consts::PI * m.radius * m.radius)
        .sum();
    let share = coloured as f64 / (size * size) as f64;
    let expected = 0.66 * discs / 2.0;
    assert!(
        (0.7..1.6).contains(&(share / expected)),
        "{share} {expected}"
    );
    for place in positions().into_iter().step_by(400) {
        let away = |marker: &Marker| {
            Vector::from(place).distance(marker.centre.into()) > marker.radius + 0.02
        };
        if MARKERS.iter().all(away) {
            let (column, row) = texel(place, size);
            let [r, g, b] = texture.row(row)[column];
            assert!(r == g && g == b, "{place:?}");
        }
    }
    for marker in MARKERS.iter() {
        let (column, row) = texel(marker.centre, size);
        assert!(is_coloured(&texture.row(row)[column]), "{}", marker.name);
    }
    let plain = HUMAN.marked_texture(64, &[], &[]);
    assert!(plain.values().iter().all(|[r, g, b]| r == g && g == b));
}

static DOTS: LazyLock<Vec<Marker>> = LazyLock::new(|| HUMAN.dots());

#[test]
fn dots_are_apart_and_on_every_limb() {
    let mut names: Vec<&String> = DOTS.iter().map(|dot| &dot.name).collect();
    names.sort();
    names.dedup();
    assert_eq!(names.len(), DOTS.len());
    for (index, dot) in DOTS.iter().enumerate() {
        for other in &DOTS[..index] {
            let distance = Vector::from(dot.centre).distance(other.centre.into());
            let least = 1.75 * (dot.radius + other.radius);
            assert!(
                distance >= least - 1e-12,
                "{}, {}: {distance}",
                dot.name,
                other.name
            );
        }
    }
    for bone in [
        "UpperLeg", "LowerLeg", "UpperArm", "LowerArm", "Hand", "Foot",
    ] {
        for side in ["Left", "Right"] {
            let joint = joint(&format!("{side}{bone}"));
            let count = DOTS.iter().filter(|dot| dot.joint == joint).count();
            assert!(count >= 6, "{side}{bone}: {count}");
        }
    }
}

#[test]
fn dots_lie_on_the_skin_with_its_normal() {
    for dot in DOTS.iter() {
        let (centre, middle) = (Vector::from(dot.centre), Vector::from(dot.middle));
        let normal = Vector::from(dot.normal);
        assert!((normal.length() - 1.0).abs() < 1e-12);
        assert!(centre.distance(middle) < 0.5 * dot.radius, "{}", dot.name);
        let sum: f64 = dot.weights.iter().map(|influence| influence.weight).sum();
        assert!((sum - 1.0).abs() < 1e-9, "{}: {sum}", dot.name);
        // A ray along the normal leaves the body, so no skin is in front of the dot at once.
        let front = centre + normal * (0.3 * dot.radius);
        let near = positions().into_iter().map(Vector::from).filter(|place| {
            (*place - front).dot(normal) > 0.0 && place.distance(front) < 0.5 * dot.radius
        });
        assert_eq!(near.count(), 0, "{}", dot.name);
    }
}
