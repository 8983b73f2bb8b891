//! Motion of key points that is carried to surfaces, against quadrature and by hand.

use std::f64::consts::PI;

use ga_mesh::{Faces, Mesh};
use ga_runtime::cga3::{Motor, Point, Translator};
use ga_runtime::vga3::Vector;
use ga_vision::capture::table::{Key, PointRow, PointTable};
use ga_vision::capture::{
    CaptureError, CapturedFrame, HeadSurface, KeyFit, LocalArea, PrincipalShapes, RigidPose,
    SphericalParameterisation, SphericalSpline, SurfaceMesh, SurfaceMotion,
};
use proptest::prelude::*;

use super::{motor, vector};

/// About even directions, on a spiral.
fn spiral(count: usize) -> Vec<Vector<f64>> {
    let point = |k: usize| {
        let z = 1.0 - (2 * k + 1) as f64 / count as f64;
        let (sine, cosine) = (2.399_963_229_728_653 * k as f64).sin_cos();
        let r = (1.0 - z * z).sqrt();
        Vector::new(r * cosine, r * sine, z)
    };
    (0..count).map(point).collect()
}

/// An ellipsoid about a place: rings of triangles between two poles.
fn ellipsoid(half: [f64; 3], centre: [f64; 3]) -> (Vec<Point<f64>>, Vec<[u32; 3]>) {
    const RINGS: u32 = 23;
    const COLUMNS: u32 = 36;
    let place = |ring: u32, column: u32| {
        let (s, c) = (PI * f64::from(ring) / f64::from(RINGS + 1)).sin_cos();
        let (sine, cosine) = (2.0 * PI * f64::from(column) / f64::from(COLUMNS)).sin_cos();
        let unit = [s * cosine, c, -s * sine];
        Point::from([0, 1, 2].map(|k| centre[k] + half[k] * unit[k]))
    };
    let mut places = vec![place(0, 0)];
    places.extend((0..RINGS * COLUMNS).map(|k| place(1 + k / COLUMNS, k % COLUMNS)));
    places.push(place(RINGS + 1, 0));
    let at = |ring: u32, column: u32| match ring {
        0 => 0,
        ring if ring > RINGS => RINGS * COLUMNS + 1,
        ring => 1 + (ring - 1) * COLUMNS + column % COLUMNS,
    };
    let mut triangles = Vec::new();
    for ring in 0..=RINGS {
        for column in 0..COLUMNS {
            let [a, b] = [at(ring, column), at(ring, column + 1)];
            let [c, d] = [at(ring + 1, column), at(ring + 1, column + 1)];
            triangles.extend(
                [[a, c, d], [a, d, b]]
                    .iter()
                    .filter(|[i, j, k]| i != j && j != k && k != i),
            );
        }
    }
    (places, triangles)
}

/// ∫ (1 − h)² (1 − 2 h z + h²)^(−½) dh from 0 to 1, by Simpson's rule in t with h = 1 − t², which
/// takes the root at h = z = 1 away.
fn kernel(z: f64) -> f64 {
    const PARTS: i32 = 20_000;
    let value = |t: f64| {
        let h = 1.0 - t * t;
        let root = (1.0 - 2.0 * h * z + h * h).sqrt();
        if root == 0.0 {
            0.0
        } else {
            2.0 * t.powi(5) / root
        }
    };
    let step = 1.0 / f64::from(PARTS);
    let sum: f64 = (0..=PARTS)
        .map(|k| {
            let factor = match k {
                0 | PARTS => 1.0,
                k if k % 2 == 1 => 4.0,
                _ => 2.0,
            };
            factor * value(f64::from(k) * step)
        })
        .sum();
    sum * step / 3.0
}

/// Gauss's elimination with pivots.
fn solve(mut rows: Vec<Vec<f64>>) -> Vec<f64> {
    let n = rows.len();
    for k in 0..n {
        let pivot = (k..n)
            .max_by(|&i, &j| rows[i][k].abs().total_cmp(&rows[j][k].abs()))
            .unwrap();
        rows.swap(k, pivot);
        for i in 0..n {
            let factor = rows[i][k] / rows[k][k];
            if i != k {
                let (pivot, rest) = (rows[k].clone(), &mut rows[i]);
                for (value, pivot) in rest.iter_mut().zip(pivot).skip(k) {
                    *value -= factor * pivot;
                }
            }
        }
    }
    (0..n).map(|k| rows[k][n] / rows[k][k]).collect()
}

/// The spline is that of Wahba's integral: c₀ + Σ cₖ q(u, uₖ) with Σ cₖ = 0.
#[test]
fn the_spline_is_that_of_the_integral() {
    let keys = spiral(7);
    let values = [0.3, -0.2, 1.0, 0.0, 0.5, -0.7, 0.1];
    let mut rows: Vec<Vec<f64>> = keys
        .iter()
        .zip(values)
        .map(|(u, value)| {
            let row = keys.iter().map(|v| kernel(u.dot(*v).clamp(-1.0, 1.0)));
            row.chain([1.0, value]).collect()
        })
        .collect();
    rows.push([vec![1.0; 7], vec![0.0; 2]].concat());
    let coefficients = solve(rows);
    let spline = SphericalSpline::new(&keys).unwrap();
    for u in spiral(40) {
        let terms = keys.iter().zip(&coefficients);
        let expected: f64 =
            terms.map(|(v, c)| c * kernel(u.dot(*v))).sum::<f64>() + coefficients[7];
        let weights = spline.weights(u);
        let found: f64 = weights.iter().zip(values).map(|(w, value)| w * value).sum();
        assert!((found - expected).abs() < 1e-8, "{found} {expected}");
    }
}

#[test]
fn the_spline_approaches_smooth_functions() {
    let smooth = |u: Vector<f64>| (2.0 * u.x()).sin() + u.y() * u.z() - 0.3 * u.x() * u.y();
    let error = |count: usize| {
        let keys = spiral(count);
        let spline = SphericalSpline::new(&keys).unwrap();
        let misses = spiral(501).into_iter().map(|u| {
            let weights = spline.weights(u);
            let terms = keys.iter().zip(&weights);
            (terms.map(|(&key, w)| w * smooth(key)).sum::<f64>() - smooth(u)).abs()
        });
        misses.fold(0.0, f64::max)
    };
    let [few, more, many] = [25, 100, 400].map(error);
    // Half the distance between keys leaves less than a third of the error.
    assert!(
        few < 0.4 && more < few / 3.0 && many < more / 3.0,
        "{few} {more} {many}"
    );
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(12))]

    #[test]
    fn keys_move_as_they_are_told_and_all_as_one_body(
        seed in prop::collection::vec(vector(0.02), 24), common in vector(0.05),
        axis in vector(1.0), angle in -3.0..3.0,
    ) {
        prop_assume!(axis.iter().map(|x| x * x).sum::<f64>() > 0.01);
        let (places, triangles) = ellipsoid([0.07, 0.11, 0.09], [0.3, 1.6, -0.2]);
        let chosen: Vec<_> = (0..24).map(|k| 5 + 34 * k).collect();
        let keys: Vec<_> = chosen.iter().map(|&k| places[k]).collect();
        let given: Vec<_> = seed.iter().map(|&d| Vector::from(d)).collect();
        let carried = |places: &[Point<f64>], keys: &[Point<f64>], given: &[Vector<f64>]| {
            let surface = SurfaceMesh::new(places, &triangles).unwrap();
            let sphere = SphericalParameterisation::new(&surface).unwrap();
            let motion = SurfaceMotion::new(&sphere, keys).unwrap();
            let mut moved = vec![Vector::ZERO; places.len()];
            motion.displacements(given, &mut moved).unwrap();
            moved
        };
        let moved = carried(&places, &keys, &given);
        for (&k, given) in chosen.iter().zip(&given) {
            prop_assert!(moved[k].distance(*given) < 1e-12);
        }
        // A displacement that all have in common moves every vertex by that.
        let shifted: Vec<_> = given.iter().map(|&d| d + Vector::from(common)).collect();
        for (a, b) in carried(&places, &keys, &shifted).iter().zip(&moved) {
            prop_assert!((*a - *b).distance(Vector::from(common)) < 1e-12);
        }
        // It does not matter where the head is.
        let motor = motor(axis, angle, [0.5, 0.1, 2.0]);
        let move_all = |p: &[Point<f64>]| p.iter().map(|&p| motor.transform(p)).collect::<Vec<_>>();
        let rotor = ga_runtime::vga3::Rotor::from(motor.rotor());
        let rotated: Vec<_> = given.iter().map(|&d| rotor.transform(d)).collect();
        let there = carried(&move_all(&places), &move_all(&keys), &rotated);
        for (a, b) in there.iter().zip(&moved) {
            prop_assert!(a.distance(rotor.transform(*b)) < 1e-10);
        }
    }
}

#[test]
fn keys_that_were_not_seen_follow_the_others() {
    let (places, triangles) = ellipsoid([0.07, 0.11, 0.09], [0.0; 3]);
    let surface = SurfaceMesh::new(&places, &triangles).unwrap();
    let sphere = SphericalParameterisation::new(&surface).unwrap();
    let keys: Vec<_> = (0..9).map(|k| places[7 + 90 * k]).collect();
    let given: Vec<_> = (0..9)
        .map(|k| Vector::new(0.01, 0.002 * f64::from(k), 0.0))
        .collect();
    let motion = SurfaceMotion::new(&sphere, &keys).unwrap();
    let mut known: Vec<_> = given.iter().copied().map(Some).collect();
    assert_eq!(motion.filled(&known).unwrap(), given);
    known[3] = None;
    known[8] = None;
    let filled = motion.filled(&known).unwrap();
    let mut all = vec![Vector::ZERO; places.len()];
    motion.displacements(&filled, &mut all).unwrap();
    // The surface that has only the known keys.
    let fewer: Vec<_> = [0, 1, 2, 4, 5, 6, 7].map(|k| keys[k]).to_vec();
    let values: Vec<_> = [0, 1, 2, 4, 5, 6, 7].map(|k| given[k]).to_vec();
    let mut expected = all.clone();
    let small = SurfaceMotion::new(&sphere, &fewer).unwrap();
    small.displacements(&values, &mut expected).unwrap();
    for (a, b) in all.iter().zip(&expected) {
        assert!(a.distance(*b) < 1e-12);
    }
    assert!(matches!(
        motion.filled(&[None; 9]),
        Err(CaptureError::NoKeys)
    ));
}

#[test]
fn centres_of_gravity_by_hand() {
    // A rectangle of 3 × 1 with centre (1.5, 0.5), as two triangles and finer on one side: the
    // centre does not depend on the triangles.
    let coarse = [[0.0, 0.0], [3.0, 0.0], [3.0, 1.0], [0.0, 1.0]];
    let fine = [&coarse[..], &[[0.1, 0.1], [0.2, 0.5]]].concat();
    type Grid<'a> = (&'a [[f64; 2]], &'a [[u32; 3]]);
    let meshes: [Grid<'_>; 2] = [
        (&coarse, &[[0, 1, 2], [0, 2, 3]]),
        (
            &fine,
            &[
                [0, 1, 4],
                [1, 2, 4],
                [4, 2, 5],
                [2, 3, 5],
                [3, 0, 5],
                [0, 4, 5],
            ],
        ),
    ];
    for (corners, triangles) in meshes {
        let places: Vec<_> = corners
            .iter()
            .map(|&[x, y]| Point::new(x, y, 2.0))
            .collect();
        let surface = SurfaceMesh::new(&places, triangles).unwrap();
        assert!((surface.areas().iter().sum::<f64>() - 3.0).abs() < 1e-14);
        let centre = surface.centre_of_gravity();
        assert!(
            centre.distance(Point::new(1.5, 0.5, 2.0)) < 1e-14,
            "{centre:?}"
        );
    }
    // Two triangles of area ½ beside one of area 1: masses 1/6, 1/6 + …, by hand.
    let places = [[0.0, 0.0], [1.0, 0.0], [0.0, 1.0], [1.0, 3.0]];
    let places = places.map(|[x, y]| Point::new(x, y, 0.0));
    let surface = SurfaceMesh::new(&places, &[[0, 1, 2], [1, 3, 2]]).unwrap();
    // (1, 0), (1, 3), (0, 1): area ½ |(0, 3) × (−1, 1)| = 3/2.
    let expected = [1.0 / 6.0, 2.0 / 3.0, 2.0 / 3.0, 0.5];
    for (area, expected) in surface.areas().iter().zip(expected) {
        assert!((area - expected).abs() < 1e-15);
    }
    // x = (2/3 + 1/2)/2, y = (2/3 + 3/2)/2.
    let centre = surface.centre_of_gravity();
    assert!(centre.distance(Point::new(7.0 / 12.0, 13.0 / 12.0, 0.0)) < 1e-15);
}

#[test]
fn a_local_area_moves_alone_and_keeps_its_centre() {
    let (places, triangles) = ellipsoid([0.08, 0.11, 0.09], [0.0, 1.6, 0.0]);
    let surface = SurfaceMesh::new(&places, &triangles).unwrap();
    let middle = places[400];
    let area = LocalArea::around(&surface, middle, 0.05).unwrap();
    assert!(area.falloff()[400] == 1.0);
    let inside = area.vertex_count();
    assert!(inside > 10 && inside < places.len() / 2, "{inside}");
    for (place, &falloff) in places.iter().zip(area.falloff()) {
        // The way along the surface is longer than the straight one.
        let distance = place.distance(middle);
        assert!((0.0..=1.0).contains(&falloff));
        assert!(falloff == 0.0 || distance < 0.05);
        assert!(falloff > 0.0 || distance > 0.04, "{distance}");
    }
    let masses: Vec<_> = surface
        .areas()
        .iter()
        .zip(area.falloff())
        .map(|(&mass, &falloff)| if falloff > 0.0 { mass } else { 0.0 })
        .collect();
    let centre = |moved: &[Vector<f64>]| {
        let total: f64 = masses.iter().sum();
        let terms = places.iter().zip(moved).zip(&masses);
        let sum = terms.fold(Vector::ZERO, |sum, ((&p, &d), &m)| {
            sum + (Vector::from(p) + d) * m
        });
        sum / total
    };
    let still = vec![Vector::ZERO; places.len()];
    assert!(centre(&still).distance(area.centre_of_gravity().into()) < 1e-14);
    let given: Vec<_> = (0..places.len())
        .map(|k| Vector::new(0.01, 0.001 * (k % 7) as f64, -0.004))
        .collect();
    for keep in [false, true] {
        let mut moved = given.clone();
        area.apply(&mut moved, keep);
        for (moved, &falloff) in moved.iter().zip(area.falloff()) {
            assert!(falloff > 0.0 || *moved == Vector::ZERO);
        }
        let by = centre(&moved) - centre(&still);
        assert!(by.distance(area.centre_displacement(&moved)) < 1e-14);
        assert_eq!(by.length() < 1e-14, keep, "{by:?}");
    }
    // The whole surface keeps its centre too.
    let whole = LocalArea::whole(&surface).unwrap();
    let [found, expected] = [whole.centre_of_gravity(), surface.centre_of_gravity()];
    assert!(found.distance(expected) < 1e-14);
    let mut moved = given.clone();
    whole.apply(&mut moved, false);
    assert_eq!(moved, given);
    whole.apply(&mut moved, true);
    assert!(whole.centre_displacement(&moved).length() < 1e-15);
    // All vertices move by the same displacement less.
    let less = given[0] - moved[0];
    for (moved, given) in moved.iter().zip(&given) {
        assert!((*given - *moved).distance(less) < 1e-15);
    }
}

#[test]
fn a_set_of_vertices_falls_off_at_its_border() {
    // A strip of 20 × 1 squares of 1 cm; vertices 0 to 19 are its first half.
    let corner = |k: u32| Point::new(0.01 * f64::from(k / 2), 0.01 * f64::from(k % 2), 0.0);
    let places: Vec<_> = (0..42).map(corner).collect();
    let squares = (0..20).map(|k| 2 * k);
    let triangles: Vec<_> = squares
        .flat_map(|k| [[k, k + 2, k + 1], [k + 1, k + 2, k + 3]])
        .collect();
    let strip = SurfaceMesh::new(&places, &triangles).unwrap();
    let half: Vec<_> = (0..20).collect();
    let area = LocalArea::of_vertices(&strip, &half, 0.04).unwrap();
    assert_eq!(area.vertex_count(), 20);
    for (k, &found) in area.falloff().iter().enumerate() {
        // The outside begins at x = 10 cm.
        let t = (1.0 - (10.0 - (k / 2) as f64) / 4.0).clamp(0.0, 1.0);
        let expected = 1.0 - (10.0 * t.powi(3) - 15.0 * t.powi(4) + 6.0 * t.powi(5));
        assert!((found - expected).abs() < 1e-12, "{k}: {found} {expected}");
    }
    // Everything: there is no edge.
    let all: Vec<_> = (0..42).collect();
    let whole = LocalArea::of_vertices(&strip, &all, 0.01).unwrap();
    assert!(whole.falloff().iter().all(|&falloff| falloff == 1.0));
    assert_eq!(
        LocalArea::of_vertices(&strip, &[1, 42], 0.01),
        Err(CaptureError::NoVertex {
            vertex: 42,
            vertices: 42
        })
    );
    let none = LocalArea::of_vertices(&strip, &[], 0.01);
    assert!(matches!(none, Err(CaptureError::EmptyArea { .. })));
    let far = LocalArea::around(&strip, Point::new(0.0, 0.0, 1.0), 0.02);
    assert!(far.is_ok(), "the nearest point of the surface counts");
    for radius in [0.0, -1.0, f64::NAN, f64::INFINITY] {
        let refused = LocalArea::around(&strip, places[0], radius);
        assert!(matches!(refused, Err(CaptureError::Radius(_))));
    }
    let between = Point::new(0.005, 0.004, 0.0);
    let small = LocalArea::around(&strip, between, 1e-4);
    assert_eq!(small, Err(CaptureError::EmptyArea { radius: 1e-4 }));
}

#[test]
fn shapes_of_a_sequence() {
    let keys = 5;
    let shape = |seed: f64| -> Vec<Vector<f64>> {
        (0..keys)
            .map(|k| Vector::new((seed * f64::from(k)).sin(), seed.cos(), 0.3) * 0.01)
            .collect()
    };
    let (smile, frown) = (shape(1.3), shape(4.1));
    let frames: Vec<Vec<_>> = (0..30)
        .map(|frame| {
            let t = 0.2 * f64::from(frame);
            let pairs = smile.iter().zip(&frown);
            pairs.map(|(&a, &b)| a * t.sin() + b * (0.3 * t)).collect()
        })
        .collect();
    let found = PrincipalShapes::new(&frames, 1e-9).unwrap();
    assert_eq!(found.shapes.len(), 2);
    assert!(found.error < 1e-15);
    for (frame, weights) in frames.iter().zip(&found.weights) {
        assert!(weights.iter().all(|weight| weight.abs() <= 1.0));
        for (k, expected) in frame.iter().enumerate() {
            let sum = found.shapes[0][k] * weights[0] + found.shapes[1][k] * weights[1];
            assert!(sum.distance(*expected) < 1e-15);
        }
    }
    for shape in 0..2 {
        let greatest = found.weights.iter().map(|w| w[shape]).fold(0.0, f64::max);
        assert_eq!(greatest, 1.0);
    }
    // Within a tolerance, fewer are enough.
    let coarse = PrincipalShapes::new(&frames, 0.02).unwrap();
    assert!(coarse.shapes.len() < 2 && coarse.error <= 0.02 && coarse.error > 1e-9);
    let still = PrincipalShapes::new(&[vec![Vector::ZERO; 3], vec![Vector::ZERO; 3]], 0.0).unwrap();
    assert!(still.shapes.is_empty() && still.weights.iter().all(Vec::is_empty));
    assert!(PrincipalShapes::new(&[], 0.0).unwrap().weights.is_empty());
    let uneven = [vec![Vector::ZERO; 3], vec![Vector::ZERO; 2]];
    assert!(matches!(
        PrincipalShapes::new(&uneven, 0.0),
        Err(CaptureError::ListCounts {
            expected: 3,
            found: 2,
            ..
        })
    ));
    assert_eq!(
        PrincipalShapes::new(&[], -1.0),
        Err(CaptureError::Tolerance(-1.0))
    );
}

#[test]
fn surfaces_and_keys_that_cannot_be_used_are_refused() {
    let (places, triangles) = ellipsoid([1.0, 1.0, 1.0], [0.0; 3]);
    let surface = SurfaceMesh::new(&places, &triangles).unwrap();
    let sphere = SphericalParameterisation::new(&surface).unwrap();
    assert_eq!(sphere.folded_triangles(), 0);
    let key = |x, y, z| Point::new(x, y, z);
    let fails = |keys: &[Point<f64>]| SurfaceMotion::new(&sphere, keys).unwrap_err();
    assert_eq!(fails(&[]), CaptureError::NoKeys);
    let many = fails(&[key(1.0, 0.0, 0.0); 8193]);
    assert_eq!(
        many,
        CaptureError::TooManyKeys {
            keys: 8193,
            most: 8192
        }
    );
    let nan = [key(1.0, 0.0, 0.0), key(0.0, f64::NAN, 0.0)];
    assert_eq!(fails(&nan), CaptureError::KeyNotFinite { key: 1 });
    let inside = [key(1.0, 0.0, 0.0), sphere.centre()];
    assert_eq!(fails(&inside), CaptureError::KeyAtCentre { key: 1 });
    let same = [key(0.0, 1.0, 0.0), key(1.0, 0.0, 0.0), key(0.0, 3.0, 0.0)];
    assert!(matches!(
        fails(&same),
        CaptureError::SameDirection {
            first: 0,
            second: 2,
            ..
        }
    ));
    assert_eq!(
        SurfaceMesh::new(&places, &[[0, 1, 1]]),
        Err(CaptureError::NoArea)
    );
    assert!(matches!(
        SurfaceMesh::new(&places[..9], &triangles),
        Err(CaptureError::Mesh(_))
    ));
    let mut bad = places.clone();
    bad[3] = key(f64::INFINITY, 0.0, 0.0);
    assert!(matches!(
        SurfaceMesh::new(&bad, &triangles),
        Err(CaptureError::Mesh(_))
    ));
    let centre = places[17];
    assert_eq!(
        SphericalParameterisation::about(centre, &surface),
        Err(CaptureError::VertexAtCentre { vertex: 17 })
    );
    // Seen from a place near the surface, the near side shows its front.
    let aside = SphericalParameterisation::about(key(1.5, 0.1, 0.1), &surface).unwrap();
    assert!(aside.folded_triangles() > 0);
    let motion = SurfaceMotion::new(&sphere, &[places[0], places[400]]).unwrap();
    let mut moved = vec![Vector::ZERO; places.len()];
    let three = [Vector::ZERO; 3];
    assert!(matches!(
        motion.displacements(&three, &mut moved),
        Err(CaptureError::ListCounts {
            expected: 2,
            found: 3,
            ..
        })
    ));
    let wrong = [Vector::ZERO, Vector::new(0.0, f64::NAN, 0.0)];
    assert_eq!(
        motion.displacements(&wrong, &mut moved),
        Err(CaptureError::KeyNotFinite { key: 1 })
    );
    assert!(motion.displacements(&three[..2], &mut moved[..5]).is_err());
}

/// A mesh in millimetres, whose keys all move by 10 mm while the head is carried 1 m away.
#[test]
fn a_head_moves_with_its_keys_and_its_pose() {
    let (places, triangles) = ellipsoid([80.0, 120.0, 100.0], [0.0; 3]);
    let faces = Faces::from_uniform(triangles).unwrap();
    let mesh = Mesh::new(places.clone(), faces).unwrap();
    let keys: Vec<Key> = [0, 100, 300, 500, 700, 829]
        .into_iter()
        .enumerate()
        .map(|(point, vertex): (_, usize)| Key {
            point,
            place: places[vertex],
        })
        .collect();
    let metres = |place: Point<f64>| Point::from(place.coordinates().map(|x| 1e-3 * x));
    let rest: Vec<_> = keys.iter().map(|key| metres(key.place)).collect();
    let fit = KeyFit::new(&keys, &rest, true).unwrap();
    let points = PointTable {
        names: (0..6).map(|k| format!("p{k}")).collect(),
        numbers: (0..6).collect(),
        frames: (0..3)
            .map(|frame: usize| PointRow {
                line: 2 + frame,
                label: frame.to_string(),
                time: None,
                points: vec![None; 6],
            })
            .collect(),
        notes: Vec::new(),
    };
    let motor: Motor<f64> = Translator::from_displacement([0.0, 0.0, 1.0]).into();
    let rise = Vector::new(0.0, 0.01, 0.0);
    let mut frame = CapturedFrame {
        pose: RigidPose {
            motor,
            inliers: vec![0, 1, 2, 3],
            root_mean_square: 0.0,
        },
        still: vec![None; 6],
        expression: vec![Some(rise); 6],
    };
    frame.expression[3] = None;
    let head = HeadSurface::new(mesh, keys, fit, &points).unwrap();
    let motion = head.follow(&[Ok(frame.clone())], &points, 1e-9).unwrap();
    let moved = |pose| head.mesh_in_frame(&motion, 0, pose).unwrap();
    for (in_mesh, (there, place)) in moved(None)
        .positions()
        .iter()
        .zip(moved(Some(motor)).positions().iter().zip(&places))
    {
        let [x, y, z] = place.coordinates();
        assert!(in_mesh.distance(Point::new(x, y + 10.0, z)) < 1e-9);
        let expected = Point::new(1e-3 * x, 1e-3 * y + 0.01, 1e-3 * z + 1.0);
        assert!(there.distance(expected) < 1e-12);
    }
    let found = head.summary(&motion);
    assert_eq!(
        (found.keys, found.keys_filled, found.morph_targets),
        (6, 1, 1)
    );
    assert!((found.metres_per_mesh_unit - 1e-3).abs() < 1e-15);
    let raised = found.area.centre_displacement[0].unwrap();
    assert!(Vector::from(raised).distance(rise) < 1e-12);

    // Frames without a pose, or without a key that is seen, are empty.
    let good = frame.clone();
    frame.expression = vec![None; 6];
    let blind = Err(CaptureError::NotUnique);
    let frames = [blind, Ok(good.clone()), Ok(frame.clone())];
    let motion = head.follow(&frames, &points, 1e-9).unwrap();
    assert_eq!(motion.empty_frames(), [0, 2]);
    let found = head.summary(&motion).area.centre_displacement;
    assert!(found[0].is_none() && found[1] == Some(raised) && found[2].is_none());
    assert_eq!(
        head.mesh_in_frame(&motion, 0, None).unwrap_err(),
        CaptureError::NoKeySeen
    );
    // Keys of the animation are at the times of those frames that have something.
    let rest = head.mesh_at_rest().unwrap();
    let poses = [None, Some(motor), Some(motor)];
    let document = head.document(&rest, &motion, Some(&poses), &[0.0, 0.5, 1.0]);
    let channels = &document.unwrap().animations[0].channels;
    let times: Vec<_> = channels.iter().map(|channel| &channel.times[..]).collect();
    assert_eq!(times, [&[0.5][..], &[0.5, 1.0], &[0.5, 1.0]]);
    assert_eq!(
        head.follow(&[Ok(frame)], &points, 1e-9).unwrap_err(),
        CaptureError::NoKeySeen
    );
    let unknown = head
        .with_area("p9:1".parse().unwrap(), &points)
        .unwrap_err();
    assert_eq!(unknown.to_string(), "\"p9\" is not a key");
}
