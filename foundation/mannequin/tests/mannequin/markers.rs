//! Markers on the skin.

use std::sync::LazyLock;

use std::f64::consts::TAU;

use ga_anim::character::Character;
use ga_anim::skeleton::{Joint, Skeleton};
use ga_anim::weights::SkinWeights;
use ga_mannequin::{DISC_LIFT, Marker, dots_on, with_discs};
use ga_mesh::query::Bvh;
use ga_mesh::{CornerAttribute, Faces, Mesh};
use ga_runtime::cga3::Point;
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
    // A texel that is wider than the body sees some marker everywhere.
    for size in 0..3 {
        let small = HUMAN.marked_texture(size, &MARKERS[..], &vec![colours; MARKERS.len()]);
        assert_eq!(small.width(), size);
        assert!(small.values().iter().all(|[r, g, b]| r != g || g != b));
    }
}

static DOTS: LazyLock<Vec<Marker>> = LazyLock::new(|| HUMAN.dots());

#[test]
fn dots_are_apart_and_on_every_limb() {
    let mut names: Vec<&String> = DOTS.iter().map(|dot| &dot.name).collect();
    names.sort();
    names.dedup();
    assert_eq!(names.len(), DOTS.len());
    are_apart(&DOTS);
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

fn are_apart(dots: &[Marker]) {
    for (index, dot) in dots.iter().enumerate() {
        for other in &dots[..index] {
            let distance = Vector::from(dot.centre).distance(other.centre.into());
            let least = 1.75 * (dot.radius + other.radius);
            let names = [&dot.name, &other.name];
            assert!(distance >= least - 1e-12, "{names:?}: {distance}");
        }
    }
}

/// An upright pipe that is 1 m long, in rings of 48 vertices, with a joint in its middle.
fn pipe(radius: f64) -> Character {
    let (sides, rings) = (48, 21);
    let positions = (0..rings).flat_map(|ring| {
        (0..sides).map(move |side| {
            let (sin, cos) = (TAU * f64::from(side) / f64::from(sides)).sin_cos();
            [radius * cos, 0.05 * f64::from(ring), -radius * sin]
        })
    });
    let positions: Vec<[f64; 3]> = positions.collect();
    let at = |ring: i32, side: i32| (ring * sides + side % sides) as u32;
    let faces = (0..rings - 1).flat_map(|ring| {
        (0..sides).map(move |side| {
            [
                at(ring, side),
                at(ring, side + 1),
                at(ring + 1, side + 1),
                at(ring + 1, side),
            ]
        })
    });
    let faces = Faces::from_uniform(faces.collect()).unwrap();
    let joint = |name: &str, parent, [low, high]: [f64; 2]| Joint {
        name: name.to_owned(),
        parent,
        head: [0.0, low, 0.0],
        tail: [0.0, high, 0.0],
    };
    let joints = vec![
        joint("low", None, [0.0, 0.5]),
        joint("high", Some(0), [0.5, 1.0]),
    ];
    let rows = positions
        .iter()
        .map(|position| [(u32::from(position[1] > 0.5), 1.0)]);
    Character {
        weights: SkinWeights::new(2, rows).unwrap(),
        mesh: Mesh::new(positions, faces).unwrap(),
        skeleton: Skeleton::new(joints).unwrap(),
    }
}

/// A sixth of the thickness, between 9.5 and 15 mm.
#[test]
fn dots_on_thick_limbs_are_larger() {
    for (radius, expected) in [(0.02, 0.0095), (0.036, 0.012), (0.1, 0.015)] {
        let dots = dots_on(&pipe(radius));
        // As many as circles of the least distance, each in a hexagon, at most.
        let most = TAU * radius / (0.75_f64.sqrt() * (3.5_f64 * expected).powi(2));
        let count = dots.len() as f64;
        assert!(
            (0.4 * most..1.3 * most).contains(&count),
            "{count} of {most}"
        );
        are_apart(&dots);
        for dot in &dots {
            assert!(
                (dot.radius - expected).abs() < 0.02 * expected,
                "{}",
                dot.radius
            );
            let [x, y, z] = dot.centre;
            assert!((x.hypot(z) / radius - 1.0).abs() < 0.01);
            let [u, v, w] = dot.normal;
            assert!((u * x + w * z) / radius > 0.99 && v.abs() < 0.1);
            assert_eq!(dot.joint, usize::from(y > 0.525), "{y}");
        }
    }
    assert!(dots_on(&pipe(0.003)).is_empty());
}

#[test]
fn markers_without_a_disc_are_listed() {
    let character = Character::from(HUMAN.clone());
    let dots = dots_on(&character);
    let discs: Vec<_> = dots.iter().map(|dot| (dot, [0.5; 2])).take(3).collect();
    let without_triangles = Character {
        mesh: Mesh::new(positions(), Faces::default()).unwrap(),
        ..character
    };
    let (dotted, left_out) = with_discs(&without_triangles, &discs, [0.75, 0.5]).unwrap();
    assert_eq!(left_out, [0, 1, 2]);
    assert_eq!(dotted.mesh, {
        let none =
            CornerAttribute::of_vertices(vec![[0.75, 0.5]; positions().len()], &Faces::default());
        let mesh = without_triangles.mesh.clone();
        mesh.with_texture_coordinates(vec![none]).unwrap()
    });
}

#[test]
fn discs_lie_on_the_skin_of_any_character() {
    let character = Character::from(HUMAN.clone());
    let dots = dots_on(&character);
    assert!((300..700).contains(&dots.len()), "{}", dots.len());
    are_apart(&dots);
    let triangles = character.mesh.triangles();
    let surface = Bvh::new(&positions(), &triangles).unwrap();
    let distance = |place: [f64; 3]| surface.nearest(Point::from(place)).unwrap().distance;
    for dot in &dots {
        assert!(distance(dot.centre) < 1e-12, "{}", dot.name);
        assert!((0.0095..=0.015).contains(&dot.radius));
        let sum: f64 = dot.weights.iter().map(|influence| influence.weight).sum();
        assert!((sum - 1.0).abs() < 1e-9);
    }

    let own = |index: usize| [0.25, index as f64 / 1024.0];
    let discs: Vec<_> = dots
        .iter()
        .enumerate()
        .map(|(index, dot)| (dot, own(index)))
        .collect();
    let (dotted, left_out) = with_discs(&character, &discs, [0.75, 0.5]).unwrap();
    assert!(left_out.is_empty());
    assert_eq!(dotted.skeleton, character.skeleton);
    let (before, after) = (character.mesh.vertex_count(), dotted.mesh.vertex_count());
    assert_eq!(after - before, dots.len() * (1 + 4 * 24));
    assert_eq!(
        &dotted.mesh.positions()[..before],
        character.mesh.positions()
    );
    let faces = dotted.mesh.triangles();
    assert_eq!(faces.len() - triangles.len(), dots.len() * (24 + 3 * 48));
    let raised: Vec<[f64; 3]> = dotted.mesh.coordinates().skip(before).collect();
    for (index, place) in raised.iter().enumerate() {
        let dot = &dots[index / 97];
        let above = distance(*place);
        assert!(
            above > 0.5 * DISC_LIFT && above < DISC_LIFT + 1e-9,
            "{}: {above}",
            dot.name
        );
        let away = Vector::from(*place).distance(dot.centre.into());
        assert!(away < dot.radius + 2.0 * DISC_LIFT, "{}", dot.name);
        let influences = dotted.weights.influences(before + index).iter();
        let sum: f64 = influences.map(|influence| influence.weight).sum();
        assert!((sum - 1.0).abs() < 1e-12);
    }
    // Discs look outwards.
    for (triangle, index) in faces[triangles.len()..].iter().zip(0..) {
        let [a, b, c] =
            triangle.map(|vertex| Vector::from(dotted.mesh.positions()[vertex as usize]));
        let normal = Vector::from(dots[index / (24 + 3 * 48)].normal);
        assert!((b - a).cross(c - a).dot(normal) > 0.0, "{index}");
    }
    let coordinates = dotted.mesh.texture_coordinates().unwrap();
    for (corner, &vertex) in dotted.mesh.faces().corners().iter().enumerate() {
        let expected = match (vertex as usize).checked_sub(before) {
            Some(index) => own(index / 97),
            None => [0.75, 0.5],
        };
        assert_eq!(coordinates.get(corner), Some(&expected));
    }
}

/// Between the markers the texture is the skin without colour and at two fifths of its light.
#[test]
fn the_skin_between_markers_is_grey_and_darker() {
    let size = 64;
    let skin = HUMAN.texture(size);
    let marked = HUMAN.marked_texture(size, &[], &[]);
    let linear = |value: u8| {
        let value = f64::from(value) / 255.0;
        if value <= 0.040_45 {
            value / 12.92
        } else {
            ((value + 0.055) / 1.055).powf(2.4)
        }
    };
    let srgb = |light: f64| {
        if light <= 0.003_130_8 {
            12.92 * light
        } else {
            1.055 * light.powf(1.0 / 2.4) - 0.055
        }
    };
    for (skin, marked) in skin.values().iter().zip(marked.values()) {
        let [r, g, b] = skin.map(linear);
        let expected = 255.0 * srgb(0.4 * (0.2126 * r + 0.7152 * g + 0.0722 * b));
        for channel in marked {
            // The skin is rounded, which matters most where it is dark.
            assert!(
                (f64::from(*channel) - expected).abs() < 2.5,
                "{marked:?} {expected}"
            );
        }
    }
}
