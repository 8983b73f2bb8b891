//! Pairs of triangles of two surfaces that meet.

use ga_mesh::query::Bvh;
use proptest::prelude::*;

use super::surface::star;
use super::{Soup, soups};

type Whole = [i128; 3];

fn minus(a: Whole, b: Whole) -> Whole {
    [a[0] - b[0], a[1] - b[1], a[2] - b[2]]
}

fn cross(a: Whole, b: Whole) -> Whole {
    [
        a[1] * b[2] - a[2] * b[1],
        a[2] * b[0] - a[0] * b[2],
        a[0] * b[1] - a[1] * b[0],
    ]
}

fn dot(a: Whole, b: Whole) -> i128 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

/// Whether the origin lies in the convex hull of points: by Carathéodory's theorem, in that of at
/// most four that are affinely independent. Exact, in whole numbers.
fn hull_has_origin(points: &[Whole]) -> bool {
    let zero = [0; 3];
    let one_sign =
        |numbers: &[i128]| numbers.iter().all(|&x| x >= 0) || numbers.iter().all(|&x| x <= 0);
    for (i, &a) in points.iter().enumerate() {
        if a == zero {
            return true;
        }
        for (j, &b) in points.iter().enumerate().skip(i + 1) {
            if cross(a, b) == zero && dot(a, b) <= 0 {
                return true;
            }
            for (k, &c) in points.iter().enumerate().skip(j + 1) {
                let normal = cross(minus(b, a), minus(c, a));
                let volume = dot(cross(a, b), c);
                if normal != zero && volume == 0 {
                    let parts = [(a, b), (b, c), (c, a)].map(|(p, q)| dot(cross(p, q), normal));
                    if one_sign(&parts) {
                        return true;
                    }
                }
                for &d in &points[k + 1..] {
                    if dot(normal, minus(d, a)) == 0 {
                        continue;
                    }
                    // The volumes of the origin with the four faces, all seen from outside.
                    let volumes = [[b, c, d], [c, a, d], [a, b, d], [b, a, c]]
                        .map(|[p, q, r]| dot(cross(p, q), r));
                    if one_sign(&volumes) {
                        return true;
                    }
                }
            }
        }
    }
    false
}

/// Whether two triangles have a common point: the differences of their points, a convex set, have
/// the origin among them.
fn have_common_point(a: [Whole; 3], b: [Whole; 3]) -> bool {
    let differences: Vec<Whole> = a
        .iter()
        .flat_map(|&p| b.iter().map(move |&q| minus(p, q)))
        .collect();
    hull_has_origin(&differences)
}

/// Triangles with corners in whole numbers up to a bound.
fn whole_soups() -> impl Strategy<Value = Soup> {
    prop_oneof![Just(1), Just(2), Just(5), Just(300)].prop_flat_map(|bound| {
        let coordinate = (-bound..=bound).prop_map(f64::from);
        let flat = [coordinate.clone(), coordinate.clone()].prop_map(|[x, y]| [x, y, x + y]);
        let positions = prop_oneof![
            prop::collection::vec(prop::array::uniform3(coordinate), 3..20),
            // All within one plane.
            prop::collection::vec(flat, 3..20),
        ];
        positions.prop_flat_map(|positions| {
            let count = positions.len() as u32;
            let triangles = prop::collection::vec([0..count, 0..count, 0..count], 1..40);
            (Just(positions), triangles).prop_map(|(positions, triangles)| Soup {
                positions,
                triangles,
            })
        })
    })
}

fn whole(soup: &Soup, triangle: usize) -> [Whole; 3] {
    soup.corners(triangle)
        .map(|corner| corner.coordinates().map(|x| x as i128))
}

/// Each triangle in a hierarchy of its own, with each other one.
fn one_by_one(a: &Soup, b: &Soup) -> Vec<[u32; 2]> {
    let alone = |soup: &Soup| -> Vec<Bvh> {
        let triangles = soup.triangles.iter();
        triangles
            .map(|&triangle| Bvh::new(&soup.positions, &[triangle]).unwrap())
            .collect()
    };
    let (first, second) = (alone(a), alone(b));
    let mut pairs = Vec::new();
    for (i, bvh) in first.iter().enumerate() {
        for (j, other) in second.iter().enumerate() {
            if !bvh.overlaps(other).is_empty() {
                pairs.push([i as u32, j as u32]);
            }
        }
    }
    pairs
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(100))]

    /// Triangles that touch, lie in one plane or are degenerate are among these.
    #[test]
    fn pairs_are_those_with_a_common_point(a in whole_soups(), b in whole_soups()) {
        let found = a.bvh().overlaps(&b.bvh());
        let mut expected = Vec::new();
        for i in 0..a.triangles.len() {
            for j in 0..b.triangles.len() {
                if have_common_point(whole(&a, i), whole(&b, j)) {
                    expected.push([i as u32, j as u32]);
                }
            }
        }
        prop_assert_eq!(found, expected);
    }

    #[test]
    fn the_hierarchies_lose_no_pair(
        a in soups(),
        b in soups(),
        // Frames of another size and place.
        (scale, shift) in prop_oneof![
            Just((1.0, 0.0)),
            Just((1.0 / 1024.0, 0.0)),
            Just((64.0, 100.0)),
            (0.01..10.0_f64, -2.0..2.0_f64),
        ],
        far in prop_oneof![Just(0.0), Just(1e9)],
    ) {
        let [mut a, mut b] = [a, b];
        for position in &mut b.positions {
            *position = position.map(|x| x * scale + shift);
        }
        for position in a.positions.iter_mut().chain(&mut b.positions) {
            *position = position.map(|x| x + far);
        }
        let found = a.bvh().overlaps(&b.bvh());
        prop_assert_eq!(&found, &one_by_one(&a, &b));
        let mut swapped: Vec<_> = b.bvh().overlaps(&a.bvh()).iter().map(|&[i, j]| [j, i]).collect();
        swapped.sort_unstable();
        prop_assert_eq!(found, swapped);
    }
}

/// Two spheres of radius 1 meet in a circle, which lies in the plane halfway.
#[test]
fn two_spheres_meet_in_a_circle() {
    let sphere = star(4, 0.0);
    let mut other = star(4, 0.0);
    let apart = 1.2;
    for position in &mut other.positions {
        position[0] += apart;
    }
    let pairs = sphere.bvh().overlaps(&other.bvh());
    // The circumference over the length of a side.
    assert!(pairs.len() > 60, "{}", pairs.len());
    let radius = (1.0_f64 - 0.25 * apart * apart).sqrt();
    for [i, j] in pairs {
        for corner in [sphere.corners(i as usize), other.corners(j as usize)].as_flattened() {
            assert!((corner.e1 - 0.5 * apart).abs() < 0.15);
            assert!((corner.e2.hypot(corner.e3) - radius).abs() < 0.15);
        }
    }
    for position in &mut other.positions {
        position[0] += 1.0;
    }
    assert_eq!(sphere.bvh().overlaps(&other.bvh()), [[0; 2]; 0]);
}

#[test]
fn a_surface_meets_itself_where_triangles_share_a_corner() {
    let sphere = star(2, 0.0);
    let bvh = sphere.bvh();
    let mut expected = Vec::new();
    for (i, first) in sphere.triangles.iter().enumerate() {
        for (j, second) in sphere.triangles.iter().enumerate() {
            if first.iter().any(|vertex| second.contains(vertex)) {
                expected.push([i as u32, j as u32]);
            }
        }
    }
    assert_eq!(bvh.overlaps(&bvh), expected);
    let empty = Bvh::new(&sphere.positions, &[]).unwrap();
    assert!(bvh.overlaps(&empty).is_empty() && empty.overlaps(&bvh).is_empty());
}
