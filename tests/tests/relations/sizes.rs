//! Relations of the same figures at every size: lengths grow with the size, angles do not.

use ga_runtime::cga3::{Line, Plane, Point, PointPair, Rotor, Sphere};
use ga_runtime::geometry::relation::Tolerance;
use ga_runtime::geometry::relation::meet::{
    LineAndPlane, LineAndSphere, PlaneAndPlane, PlaneAndSphere, SphereAndSphere,
};
use ga_runtime::scalar::Real;

/// A number type with its own rounding, and `f64` to compare in.
trait Number: Real<Mask = bool> + Into<f64> {}

impl Number for f32 {}
impl Number for f64 {}

#[derive(Clone, Copy)]
struct Scene<S> {
    size: S,
    allowed: f64,
}

impl<S: Number> Scene<S> {
    fn length(self, x: f64) -> S {
        S::from_f64(x) * self.size
    }

    fn point(self, [x, y, z]: [f64; 3]) -> Point<S> {
        Point::new(self.length(x), self.length(y), self.length(z))
    }

    fn is_length(self, found: Option<S>, expected: f64) {
        let found = found.expect("a length of regular figures");
        let relative: f64 = (found / self.size).into();
        assert!(
            (relative - expected).abs() <= self.allowed,
            "{found:?} at {:?} is {relative}, not {expected}",
            self.size
        );
    }

    fn is_at(self, found: Option<Point<S>>, expected: [f64; 3]) {
        let found = found.expect("a place of regular figures").coordinates();
        for (found, expected) in found.into_iter().zip(expected) {
            self.is_length(Some(found), expected);
        }
    }

    fn tolerance(self) -> Tolerance<S> {
        Tolerance::for_size(self.size)
    }

    fn flats(self) {
        let p = self.point([3.0, 4.0, 12.0]);
        let axis = Line::through(self.point([1.0, 0.0, 0.0]), self.point([3.0, 0.0, 0.0]));
        let skew = Line::through(self.point([0.0, 1.0, 5.0]), self.point([0.0, 3.0, 5.0]));
        let plane = |place, normal: [f64; 3]| {
            Plane::from_point_normal(self.point(place), normal.map(S::from_f64))
        };
        let ground = plane([0.0, 0.0, 2.0], [0.0, 0.0, 3.0]);
        let wall = plane([1.0, 0.0, 0.0], [2.0, 0.0, 0.0]);
        self.is_length(Some(p.distance(Point::default())), 13.0);
        self.is_length(axis.distance(p), 160.0_f64.sqrt());
        self.is_length(p.distance_to(axis), 160.0_f64.sqrt());
        self.is_length(axis.distance_to(skew), 5.0);
        self.is_length(ground.signed_distance(p), 10.0);
        self.is_length(p.distance_to(ground), 10.0);
        self.is_at(ground.support(), [0.0, 0.0, 2.0]);
        self.is_at(skew.support(), [0.0, 0.0, 5.0]);
        self.is_at(axis.foot(p), [3.0, 0.0, 0.0]);
        self.is_at(p.project_onto(axis), [3.0, 0.0, 0.0]);
        self.is_at(p.project_onto(ground), [3.0, 4.0, 2.0]);
        self.is_at(p.reflect_in(ground), [3.0, 4.0, -8.0]);
        self.is_at(p.reflect_in(axis), [3.0, -4.0, -12.0]);
        self.is_at(p.reflect_in(Point::default()), [-3.0, -4.0, -12.0]);
        assert!(!p.is_on(axis, self.tolerance()) && !p.is_on(ground, self.tolerance()));
        assert!(self.point([7.0, 0.0, 0.0]).is_on(axis, self.tolerance()));
        assert!(self.point([7.0, 8.0, 2.0]).is_on(ground, self.tolerance()));
        for angle in [axis.angle_to(skew), ground.angle_to(wall)] {
            let angle: f64 = angle.expect("an angle").into();
            assert!((angle - std::f64::consts::FRAC_PI_2).abs() <= self.allowed);
        }
        let crossing = match ground.meet(wall, self.tolerance()) {
            Some(PlaneAndPlane::Line(line)) => line,
            other => panic!("{other:?}"),
        };
        self.is_at(crossing.support(), [1.0, 0.0, 2.0]);
        match axis.meet(wall, self.tolerance()) {
            Some(LineAndPlane::Point(place)) => self.is_at(Some(place), [1.0, 0.0, 0.0]),
            other => panic!("{other:?}"),
        }
        let between = axis.common_perpendicular(skew, self.tolerance());
        let between = between.expect("skew lines");
        self.is_length(Some(between.distance), 5.0);
        self.is_at(Some(between.feet[1]), [0.0, 0.0, 5.0]);
    }

    fn rounds(self) {
        let sphere = Sphere::from_centre_radius(self.point([0.0, 0.0, 0.0]), self.length(5.0));
        let other = Sphere::from_centre_radius(self.point([6.0, 0.0, 0.0]), self.length(5.0));
        self.is_at(sphere.centre(), [0.0; 3]);
        self.is_length(sphere.radius(), 5.0);
        let p = self.point([6.0, 8.0, 0.0]);
        self.is_length(p.signed_distance_to(sphere), 5.0);
        self.is_at(p.project_onto(sphere), [3.0, 4.0, 0.0]);
        let line = Line::through(self.point([0.0, 3.0, 0.0]), self.point([1.0, 3.0, 0.0]));
        match line.meet(sphere, self.tolerance()) {
            Some(LineAndSphere::Points(pair)) => {
                let ends = pair.endpoints().expect("two points");
                self.is_at(Some(ends[0]), [-4.0, 3.0, 0.0]);
                self.is_at(Some(ends[1]), [4.0, 3.0, 0.0]);
            }
            other => panic!("{other:?}"),
        }
        let circle = match sphere.meet(other, self.tolerance()) {
            Some(SphereAndSphere::Circle(circle)) => circle,
            other => panic!("{other:?}"),
        };
        self.is_at(circle.centre(), [3.0, 0.0, 0.0]);
        self.is_length(circle.radius(), 4.0);
        let wall = Plane::from_point_normal(
            self.point([4.0, 0.0, 0.0]),
            [2.0, 0.0, 0.0].map(S::from_f64),
        );
        let circle = match sphere.meet(wall, self.tolerance()) {
            Some(PlaneAndSphere::Circle(circle)) => circle,
            other => panic!("{other:?}"),
        };
        self.is_at(circle.centre(), [4.0, 0.0, 0.0]);
        self.is_length(circle.radius(), 3.0);
        let pair = PointPair::through(self.point([1.0, 2.0, 3.0]), self.point([5.0, 2.0, 3.0]));
        let ends = pair.endpoints().expect("two points");
        self.is_at(Some(ends[0]), [1.0, 2.0, 3.0]);
        self.is_at(Some(ends[1]), [5.0, 2.0, 3.0]);
    }
}

#[test]
fn flats_at_every_size() {
    for exponent in (-150..=150).step_by(5) {
        let size = 10_f64.powi(exponent);
        Scene {
            size,
            allowed: 1e-13,
        }
        .flats();
    }
    for exponent in -17..=18 {
        let size = 10_f32.powi(exponent);
        Scene {
            size,
            allowed: 1e-4,
        }
        .flats();
    }
}

#[test]
fn rounds_at_every_size() {
    for exponent in (-75..=75).step_by(5) {
        let size = 10_f64.powi(exponent);
        Scene {
            size,
            allowed: 1e-13,
        }
        .rounds();
    }
    for exponent in -9..=9 {
        let size = 10_f32.powi(exponent);
        Scene {
            size,
            allowed: 1e-4,
        }
        .rounds();
    }
}

#[test]
fn numbers_beyond_all_sizes_give_nothing() {
    let line = Line::through(Point::new(0.0, 1.0, 0.0), Point::new(1.0, 1.0, 0.0));
    let plane = Plane::from_point_normal(Point::default(), [0.0, 0.0, 1.0]);
    for bad in [f64::NAN, f64::INFINITY] {
        let p = Point::new(bad, 0.0, 0.0);
        assert_eq!(line.distance(p), None);
        assert_eq!(line.foot(p), None);
        assert_eq!(plane.signed_distance(p), None);
        assert_eq!(p.distance_to(plane), None);
        assert_eq!(p.project_onto(plane), None);
        assert_eq!(p.project_onto(line), None);
        assert_eq!(p.reflect_in(plane), None);
        assert_eq!(p.reflect_in(line), None);
        let spoilt = Line::from_point_direction(p, [0.0, 1.0, 0.0]);
        assert_eq!(spoilt.angle_to(line), None);
        assert_eq!(spoilt.distance_to(line), None);
        assert_eq!(spoilt.support(), None);
    }
}

#[test]
fn rotations_between_directions_of_every_size() {
    let root = core::f32::consts::FRAC_1_SQRT_2;
    for exponent in -37..=37 {
        for other in [-37, -11, -6, 0, 6, 11, 37] {
            let [a, b] = [exponent, other].map(|power| 10_f32.powi(power));
            let quarter = Rotor::between([a, 0.0, 0.0], [0.0, b, 0.0]).expect("directions");
            let ([x, y, z], w) = quarter.to_quaternion();
            assert_eq!([x, y], [0.0, 0.0]);
            assert!((z - root).abs() < 1e-6 && (w - root).abs() < 1e-6);
        }
    }
}

/// Half of the angle is just below a right angle, where the sum of both unit directions cancels.
#[test]
fn rotations_between_nearly_opposite_directions() {
    for exponent in 0..=12 {
        let small = 10_f64.powi(-exponent);
        let (a, b) = ([1.0, 0.0, 0.0], [-small.cos(), small.sin(), 0.0]);
        let ([x, y, z], w) = Rotor::between(a, b).expect("directions").to_quaternion();
        let (sine, cosine) = (0.5 * small).sin_cos();
        assert_eq!([x, y], [0.0, 0.0]);
        assert!((z - cosine).abs() < 1e-15 && (w - sine).abs() < 1e-15);
    }
}
