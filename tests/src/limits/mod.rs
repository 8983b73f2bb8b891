//! How accurate rounds are that are made, met, moved and read, near the origin and far from it. The
//! truth is computed with vectors of twofold precision, of the coordinates as they are rounded.

mod meeting;
mod scene;

use ga_runtime::cga3::{Circle, Line, Motor, PointPair, Rotor, Sphere};
use ga_runtime::geometry::Kind;
use ga_runtime::geometry::ray::Ray;
use ga_runtime::geometry::relation::Tolerance;
use ga_runtime::geometry::relation::meet::{LineAndSphere, SphereAndSphere};

use crate::plain::{O, X, along, cross, dot, largest, minus, plus, rotated, times};
use crate::twofold::Twofold;
pub use scene::{Precision, SIZES};

use meeting::{
    Meeting, first_hit, line_at, line_meets_sphere, plane_meets_circle, plane_meets_sphere,
    spheres_meet,
};
use scene::{Measured, Scene, exact, norm, off};

/// What is asked of a round, or of two that meet.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Query {
    /// Centre and radius of a sphere and a circle that are made of these, and of a dual sphere.
    Made,
    /// Endpoints and radius of the pair of two points.
    PairThrough,
    /// Centre and radius of the circle through three points.
    CircleThrough,
    /// Centre and radius of the sphere through four points.
    SphereThrough,
    /// Centre and radius of the circle in which spheres with radii up to 1:1000 meet, by the
    /// product of the smaller and the larger, and by the method.
    SpheresMeet,
    /// The same by the product of the larger and the smaller.
    LargerMeetsSmaller,
    /// Centre and radius of the circle in which a plane and a sphere meet.
    PlaneMeetsSphere,
    /// Endpoints of the pair in which a line and a sphere meet.
    LineMeetsSphere,
    /// Endpoints of the pair in which a plane and a circle meet.
    PlaneMeetsCircle,
    /// The distance along a ray at which it meets a sphere first.
    FirstHit,
    /// Centre and radius of a sphere after a hundred rotations about the origin.
    HundredMotions,
}

impl Query {
    /// All queries.
    pub const ALL: [Self; 11] = [
        Self::Made,
        Self::PairThrough,
        Self::CircleThrough,
        Self::SphereThrough,
        Self::SpheresMeet,
        Self::LargerMeetsSmaller,
        Self::PlaneMeetsSphere,
        Self::LineMeetsSphere,
        Self::PlaneMeetsCircle,
        Self::FirstHit,
        Self::HundredMotions,
    ];

    /// The largest error of a case at this distance from the origin, of this size, in units of
    /// ε (distance + size·K), where K is the condition of the shape. The other numbers of the case
    /// are drawn by the seed. `None` where they make no case, such as a size that positions so far
    /// away cannot express; infinite where the query has no answer.
    #[must_use]
    pub fn error<S: Precision>(self, distance: f64, size: f64, seed: u64) -> Option<f64> {
        let mut scene = Scene::<S>::new(distance, size, seed);
        let (error, unit) = match self {
            Self::Made => made(&mut scene),
            Self::PairThrough => pair_through(&mut scene),
            Self::CircleThrough => circle_through(&mut scene),
            Self::SphereThrough => sphere_through(&mut scene),
            Self::SpheresMeet => spheres_meet(&mut scene, |meeting| {
                let tolerance = Tolerance::new(S::zero(), S::zero());
                let found = meeting.larger.meet(meeting.smaller, tolerance);
                let Some(SphereAndSphere::Circle(circle)) = found else {
                    return vec![];
                };
                vec![meeting.smaller & meeting.larger, circle]
            }),
            Self::LargerMeetsSmaller => {
                spheres_meet(&mut scene, |meeting| vec![meeting.larger & meeting.smaller])
            }
            Self::PlaneMeetsSphere => plane_meets_sphere(&mut scene),
            Self::LineMeetsSphere => line_meets_sphere(&mut scene),
            Self::PlaneMeetsCircle => plane_meets_circle(&mut scene),
            Self::FirstHit => first_hit(&mut scene),
            Self::HundredMotions => hundred_motions(&mut scene),
        }?;
        Some(error / (S::epsilon().into() * unit))
    }
}

ga_runtime::ga! { ga_runtime::cga3;
    fn circle_of(a: Sphere, b: Sphere) -> Circle { a & b }
    fn pair_of(a: Line, b: Sphere) -> PointPair { a & b }
}

/// What is said of two spheres, or a line and a sphere, that nearly touch.
#[derive(Debug)]
pub struct NearTangency {
    /// The displacement that makes them touch, in units of ε (distance + size·K).
    pub displacement: f64,
    /// Whether they meet in real points.
    pub is_real: bool,
    /// Whether products, `ga!`, methods without a tolerance and rays say so.
    pub by_numbers: Vec<bool>,
    /// Whether the method says so with a tolerance of eight such units; `None` for a contact.
    pub with_tolerance: Option<bool>,
}

impl NearTangency {
    /// Spheres with radii up to 1:1000.
    #[must_use]
    pub fn of_spheres<S: Precision>(distance: f64, size: f64, seed: u64) -> Option<Self> {
        let mut scene = Scene::<S>::new(distance, size, seed);
        let height = scene.nearly_one();
        let meeting = Meeting::new(&mut scene, height)?;
        let (larger, smaller) = (meeting.larger, meeting.smaller);
        let method = |tolerance: S| match larger.meet(smaller, Tolerance::new(tolerance, tolerance))
        {
            Some(SphereAndSphere::Circle(_)) => Some(true),
            Some(SphereAndSphere::Imaginary(_)) => Some(false),
            _ => None,
        };
        let unit = S::epsilon().into() * scene.size() * meeting.condition;
        let products = [smaller & larger, circle_of(smaller, larger)];
        let products = products.map(|circle| circle.kind(S::zero()) == Kind::Real);
        Some(Self {
            displacement: meeting.to_contact / unit,
            is_real: meeting.squared.rounded() > 0.0,
            by_numbers: products.into_iter().chain(method(S::zero())).collect(),
            with_tolerance: method(S::from_f64(8.0 * unit)),
        })
    }

    /// A line or a ray, and a sphere.
    #[must_use]
    pub fn of_line_and_sphere<S: Precision>(distance: f64, size: f64, seed: u64) -> Option<Self> {
        let mut scene = Scene::<S>::new(distance, size, seed);
        let height = scene.nearly_one();
        let ([p, q], [nearest, _]) = line_at(&mut scene, height);
        let sphere = Sphere::from_centre_radius(scene.at(O), scene.size);
        let line = Line::through(p, q);
        let method = |tolerance: S| match line.meet(sphere, Tolerance::new(tolerance, tolerance)) {
            Some(LineAndSphere::Points(_)) => Some(true),
            Some(LineAndSphere::Imaginary(_)) => Some(false),
            _ => None,
        };
        let unit = S::epsilon().into() * (scene.distance + scene.size());
        let depth = (exact(scene.size) - norm(nearest)).rounded();
        let products = [line & sphere, pair_of(line, sphere)];
        let products = products.map(|pair| pair.kind(S::zero()) == Kind::Real);
        let hits = Ray::through(p, q).map(|ray| ray.first_hit(sphere).is_some());
        scene.resolves(scene.size()).then(|| Self {
            displacement: depth.abs() / unit,
            is_real: depth > 0.0,
            by_numbers: products
                .into_iter()
                .chain(method(S::zero()))
                .chain(hits)
                .collect(),
            with_tolerance: method(S::from_f64(8.0 * unit)),
        })
    }
}

fn made<S: Precision>(scene: &mut Scene<S>) -> Measured {
    let normal = scene.numbers.axis().map(S::from_f64);
    let (centre, radius) = (scene.at(O), scene.size);
    let sphere = Sphere::from_centre_radius(centre, radius);
    let circle = Circle::from_centre_normal_radius(centre, normal, radius)?;
    let radii = [sphere.radius(), circle.radius(), sphere.dual().radius()];
    let centres = [sphere.centre(), circle.centre(), sphere.dual().centre()];
    let errors = radii.map(|found| off(found, exact(radius)));
    let moved = centres.map(|found| scene.away(found, O.map(Twofold::from)));
    // The limit does not need the distance.
    Some((largest(errors.into_iter().chain(moved)), scene.size()))
}

fn pair_through<S: Precision>(scene: &mut Scene<S>) -> Measured {
    let step = times(scene.numbers.axis(), scene.size());
    let points = [scene.at(O), scene.at(step)];
    let ends = points.map(|point| scene.offset(point));
    let half = norm(minus(ends[1], ends[0])) * 0.5.into();
    let pair = PointPair::through(points[0], points[1]);
    let error = largest([scene.ends_away(pair, ends), off(pair.radius(), half)]);
    scene.measured(error, 1.0)
}

fn circle_through<S: Precision>(scene: &mut Scene<S>) -> Measured {
    let (points, [p, q, r]) = scene.points();
    let (a, b) = (minus(q, p), minus(r, p));
    let normal = cross(a, b);
    let condition = (norm(a) * norm(b) / norm(normal)).rounded();
    let across = cross(minus(times(b, dot(a, a)), times(a, dot(b, b))), normal);
    let to_centre = times(across, Twofold::from(0.5) / dot(normal, normal));
    let circle = Circle::through(points[0], points[1], points[2]);
    let error = largest([
        off(circle.radius(), norm(to_centre)),
        scene.away(circle.centre(), plus(p, to_centre)),
    ]);
    scene.measured_of_points(error, condition)
}

fn sphere_through<S: Precision>(scene: &mut Scene<S>) -> Measured {
    let (points, [p, q, r, s]) = scene.points();
    let [a, b, d] = [q, r, s].map(|x| minus(x, p));
    let volume = dot(cross(a, b), d);
    let condition = (norm(a) * norm(b) * norm(d) / volume).rounded().abs();
    let sides = [(cross(b, d), a), (cross(d, a), b), (cross(a, b), d)];
    let [x, y, z] = sides.map(|(side, edge)| times(side, dot(edge, edge)));
    let to_centre = times(plus(plus(x, y), z), Twofold::from(0.5) / volume);
    let sphere = Sphere::through(points[0], points[1], points[2], points[3]);
    let error = largest([
        off(sphere.radius(), norm(to_centre)),
        scene.away(sphere.centre(), plus(p, to_centre)),
    ]);
    scene.measured_of_points(error, condition)
}

fn hundred_motions<S: Precision>(scene: &mut Scene<S>) -> Measured {
    let (axis, angle) = (scene.numbers.axis(), 0.1 + 2.9 * scene.numbers.unit());
    let start = Sphere::from_centre_radius(scene.at(O), scene.size);
    let (mut sphere, mut expected) = (start, scene.place.map(Twofold::from));
    for k in (1..=100).map(f64::from) {
        let axis = rotated(X, k, axis).map(S::from_f64);
        let rotor = Rotor::from_axis_angle(axis, S::from_f64(angle * k / 50.0))?;
        sphere = Motor::from(rotor).transform(sphere);
        // What the rotor, as it is rounded, makes of the centre: that of the unit quaternion of
        // its direction.
        let w = exact(rotor.scalar());
        let v = [-rotor.e23(), rotor.e13(), -rotor.e12()].map(exact);
        let side = cross(v, expected);
        let step = plus(times(side, w), cross(v, side));
        expected = along(expected, Twofold::from(2.0) / (w * w + dot(v, v)), step);
    }
    let expected = minus(expected, scene.place.map(Twofold::from));
    let error = largest([
        off(sphere.radius(), exact(start.radius()?)),
        scene.away(sphere.centre(), expected),
    ]);
    scene.measured(error, 1.0)
}
