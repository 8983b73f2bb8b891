//! Rounds near and far: what is made, met or read is as accurate as positions so far from the
//! origin can be. The truth is computed with plain vectors from a place nearby, of the coordinates
//! as they are rounded.

use nullcone_tests::plain::Vector;
use proptest::prelude::*;

/// Places of all distances up to the largest, and sizes from millimetres to many metres.
fn scenes(largest: f64) -> impl Strategy<Value = (Vector, f64)> {
    let place = (-2.0..largest.log10(), nullcone_tests::plain::unit());
    let place = place.prop_map(|(power, direction)| direction.map(|x| x * 10_f64.powf(power)));
    let size = (2e-3_f64.log10()..40_f64.log10()).prop_map(|power| 10_f64.powf(power));
    (place, size)
}

macro_rules! far_rounds {
    ($module:ident, $scalar:ty, $largest:expr, $drift:expr) => {
        mod $module {
            use ga_runtime::cga3::{Circle, Line, Motor, Plane, Point, PointPair, Rotor, Sphere};
            use ga_runtime::geometry::Kind;
            use ga_runtime::geometry::ray::Ray;
            use nullcone_tests::plain::{
                Vector, X, along, cross, dot, length, minus, plus, rotated, times, unit, unit_of,
            };
            use proptest::prelude::*;

            use super::scenes;

            /// An error in units of ε (distance + size).
            fn assert_near(found: f64, expected: f64, size: f64, most: f64) {
                let unit = f64::from(<$scalar>::EPSILON) * size;
                let error = (found - expected).abs() / unit;
                assert!(error <= most, "{found} for {expected}: {error:.1} units");
            }

            /// The scene in the scalar's precision: what lies at an offset from a place.
            struct Scene {
                place: Vector,
                distance: f64,
            }

            impl Scene {
                fn new(place: Vector) -> Self {
                    let place = place.map(|x| f64::from(x as $scalar));
                    let distance = length(place);
                    Self { place, distance }
                }

                fn at(&self, offset: Vector) -> Point<$scalar> {
                    Point::from(plus(self.place, offset).map(|x| x as $scalar))
                }

                fn offset(&self, point: Point<$scalar>) -> Vector {
                    minus(point.coordinates().map(f64::from), self.place)
                }

                fn assert_at(&self, found: Point<$scalar>, expected: Vector, size: f64, most: f64) {
                    let error = length(minus(self.offset(found), expected));
                    assert_near(error, 0.0, self.distance + size, most);
                }
            }

            /// Whether a scene has a size that its distance lets a position express.
            fn is_resolved(scene: &Scene, size: f64) -> bool {
                size >= 64.0 * f64::from(<$scalar>::EPSILON) * scene.distance
            }

            proptest! {
                #[test]
                fn what_is_made_keeps_its_radius((place, size) in scenes($largest), normal in unit()) {
                    let scene = Scene::new(place);
                    let (centre, radius) = (scene.at([0.0; 3]), size as $scalar);
                    let size = f64::from(radius);
                    let sphere = Sphere::from_centre_radius(centre, radius);
                    let normal = normal.map(|x| x as $scalar);
                    let circle = Circle::from_centre_normal_radius(centre, normal, radius).unwrap();
                    for found in [sphere.radius(), circle.radius(), sphere.dual().radius()] {
                        assert_near(f64::from(found.expect("real")), size, size, 1.0);
                    }
                    prop_assert_eq!(sphere.centre(), Some(centre));
                    prop_assert_eq!((sphere.kind(0.0), circle.kind(0.0)), (Kind::Real, Kind::Real));
                }

                #[test]
                fn pairs_give_back_their_points((place, size) in scenes($largest), direction in unit()) {
                    let scene = Scene::new(place);
                    let (p, q) = (scene.at([0.0; 3]), scene.at(times(direction, size)));
                    let ends = [p, q].map(|point| scene.offset(point));
                    let gap = length(minus(ends[1], ends[0]));
                    prop_assume!(is_resolved(&scene, gap));
                    let pair = PointPair::through(p, q);
                    let [a, b] = pair.endpoints().expect("real");
                    scene.assert_at(a, ends[0], size, 8.0);
                    scene.assert_at(b, ends[1], size, 8.0);
                    let unit = scene.distance + size;
                    assert_near(f64::from(pair.radius().expect("real")), gap / 2.0, unit, 8.0);
                }

                #[test]
                fn circles_through_points_have_their_radius(
                    (place, size) in scenes($largest), offsets in prop::array::uniform3(unit()),
                ) {
                    let scene = Scene::new(place);
                    let points = offsets.map(|offset| scene.at(times(offset, size)));
                    let [p, q, r] = points.map(|point| scene.offset(point));
                    let (a, b) = (minus(q, p), minus(r, p));
                    let normal = cross(a, b);
                    let condition = length(a) * length(b) / length(normal);
                    prop_assume!(length(a) * length(b) > 0.0 && is_resolved(&scene, size / condition / 32.0));
                    let [x, y] = [dot(a, a), dot(b, b)];
                    let across = cross(minus(times(b, x), times(a, y)), normal);
                    let to_centre = times(across, 0.5 / dot(normal, normal));
                    let circle = Circle::through(points[0], points[1], points[2]);
                    let unit = scene.distance + size * condition;
                    let radius = f64::from(circle.radius().expect("real"));
                    assert_near(radius, length(to_centre), unit, 8.0);
                    let centre = circle.centre().expect("a circle");
                    scene.assert_at(centre, plus(p, to_centre), unit, 8.0);
                }

                #[test]
                fn spheres_through_points_have_their_radius(
                    (place, size) in scenes($largest), offsets in prop::array::uniform4(unit()),
                ) {
                    let scene = Scene::new(place);
                    let points = offsets.map(|offset| scene.at(times(offset, size)));
                    let [p, q, r, s] = points.map(|point| scene.offset(point));
                    let [a, b, d] = [q, r, s].map(|x| minus(x, p));
                    let volume = dot(cross(a, b), d);
                    let condition = length(a) * length(b) * length(d) / volume.abs();
                    prop_assume!(condition.is_finite() && is_resolved(&scene, size / condition / 32.0));
                    let [x, y, z] = [dot(a, a), dot(b, b), dot(d, d)];
                    let sum = plus(plus(times(cross(b, d), x), times(cross(d, a), y)), times(cross(a, b), z));
                    let to_centre = times(sum, 0.5 / volume);
                    let [p, q, r, s] = points;
                    let sphere = Sphere::through(p, q, r, s);
                    let unit = scene.distance + size * condition;
                    let radius = f64::from(sphere.radius().expect("real"));
                    assert_near(radius, length(to_centre), unit, 8.0);
                    let centre = sphere.centre().expect("a sphere");
                    scene.assert_at(centre, plus(scene.offset(p), to_centre), unit, 8.0);
                }

                #[test]
                fn spheres_meet_in_circles(
                    (place, size) in scenes($largest), direction in unit(),
                    ratio in 0.5..2.0_f64, apart in 0.6..0.95_f64,
                ) {
                    let scene = Scene::new(place);
                    let distance = apart * (1.0 + ratio) * size;
                    let centres = [scene.at([0.0; 3]), scene.at(times(direction, distance))];
                    let radii = [size, ratio * size].map(|x| x as $scalar);
                    let [r, s] = radii.map(f64::from);
                    let between = minus(scene.offset(centres[1]), scene.offset(centres[0]));
                    let gap = length(between);
                    prop_assume!(is_resolved(&scene, size));
                    let height = (gap * gap + r * r - s * s) / (2.0 * gap);
                    let squared = r * r - height * height;
                    prop_assume!(squared > size * size / 16.0);
                    let spheres = [0, 1].map(|k| Sphere::from_centre_radius(centres[k], radii[k]));
                    let circle = spheres[0] & spheres[1];
                    let unit = scene.distance + size;
                    assert_near(f64::from(circle.radius().expect("real")), squared.sqrt(), unit, 8.0);
                    scene.assert_at(circle.centre().expect("a circle"), times(between, height / gap), size, 8.0);
                }

                #[test]
                fn lines_and_planes_meet_spheres(
                    (place, size) in scenes($largest), direction in unit(), normal in unit(),
                    height in 0.0..0.9_f64,
                ) {
                    let scene = Scene::new(place);
                    let radius = size as $scalar;
                    let size = f64::from(radius);
                    prop_assume!(is_resolved(&scene, size));
                    let sphere = Sphere::from_centre_radius(scene.at([0.0; 3]), radius);
                    let side = cross(direction, normal);
                    prop_assume!(length(side) > 0.2);
                    let foot = times(side, height * size / length(side));
                    let [p, q] = [-2.0, 3.0].map(|t| scene.at(along(foot, t * size, direction)));
                    let (start, end) = (scene.offset(p), scene.offset(q));
                    let way = minus(end, start);
                    let way = times(way, 1.0 / length(way));
                    let nearest = along(start, -dot(start, way), way);
                    let half = (size * size - dot(nearest, nearest)).sqrt();
                    let expected = [-half, half].map(|t| along(nearest, t, way));
                    let [a, b] = (Line::through(p, q) & sphere).endpoints().expect("real");
                    // The line stores its distance from the origin.
                    let unit = scene.distance + size;
                    let swapped = length(minus(scene.offset(a), expected[0])) > half;
                    let [a, b] = if swapped { [b, a] } else { [a, b] };
                    scene.assert_at(a, expected[0], unit, 8.0);
                    scene.assert_at(b, expected[1], unit, 8.0);
                    let ray = Ray::new(p, way.map(|x| x as $scalar)).expect("a ray");
                    let hit = ray.first_hit(sphere).expect("a hit");
                    assert_near(f64::from(hit.distance), length(minus(expected[0], start)), unit, 8.0);
                    let plane = Plane::from_point_normal(scene.at(foot), way.map(|x| x as $scalar));
                    let circle = plane & sphere;
                    let offset = dot(scene.offset(scene.at(foot)), way);
                    let squared = size * size - offset * offset;
                    assert_near(f64::from(circle.radius().expect("real")), squared.sqrt(), unit, 8.0);
                }

                #[test]
                fn a_hundred_motions_keep_the_radius((place, size) in scenes($largest), axis in unit(), angle in 0.1..3.0_f64) {
                    let scene = Scene::new(place);
                    let (start, radius) = (scene.at([0.0; 3]), size as $scalar);
                    let mut sphere = Sphere::from_centre_radius(start, radius);
                    let mut expected = scene.place;
                    for k in 1..=100 {
                        let axis = rotated(X, f64::from(k), axis).map(|x| x as $scalar);
                        let angle = angle * f64::from(k) / 50.0;
                        let rotor = Rotor::from_axis_angle(axis, angle as $scalar).expect("an axis");
                        sphere = Motor::from(rotor).transform(sphere);
                        // The rotation that the motor is after rounding.
                        let [w, x, y, z] = [rotor.scalar(), rotor.e23(), -rotor.e13(), rotor.e12()].map(f64::from);
                        let about = unit_of([-x, -y, -z]);
                        expected = rotated(about, 2.0 * length([x, y, z]).atan2(w), expected);
                    }
                    prop_assert_eq!(sphere.radius(), Sphere::from_centre_radius(start, radius).radius());
                    let centre = sphere.centre().expect("a sphere").coordinates().map(f64::from);
                    assert_near(length(minus(centre, expected)), 0.0, scene.distance + size, $drift);
                }
            }
        }
    };
}

far_rounds!(single, f32, 1e4, 128.0);
far_rounds!(double, f64, 1e8, 128.0);
