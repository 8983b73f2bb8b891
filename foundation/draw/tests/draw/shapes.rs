//! What elements of the algebra are read as.

use ga_draw::{Drawable, NotDrawable, Scene, Shape, Style};
use ga_runtime::cga3::{
    Bivector, Circle, Direction, DualPlane, Infinity, Line, Motor, Multivector, Plane, Point,
    PointPair, Rotor, RoundVector, Sphere, Translator,
};

use crate::{assert_well_formed, close};

#[test]
fn pairs_are_read_from_their_blades() {
    let (p, q) = (Point::new(1.0, 2.0, 3.0), Point::new(1.0, 2.0, 5.0));
    let shape = ((p ^ q) * -3.0).shape().unwrap();
    let Shape::PointPair {
        centre,
        direction,
        radius,
        imaginary,
    } = shape
    else {
        panic!("{shape:?}")
    };
    assert!(close(centre, [1.0, 2.0, 4.0]) && close(direction, [0.0, 0.0, -1.0]));
    assert!((radius - 1.0).abs() < 1e-12 && !imaginary);
    // A line passing a unit sphere at distance 2 meets it in points √−3 from its foot.
    let sphere = Sphere::from_centre_radius(Point::new(0.0, 0.0, 0.0), 1.0);
    let line = Line::from_point_direction(Point::new(0.0, 2.0, 0.0), [1.0, 0.0, 0.0]);
    let Shape::PointPair {
        centre,
        radius,
        imaginary: true,
        ..
    } = (sphere & line).shape().unwrap()
    else {
        panic!()
    };
    assert!(close(centre, [0.0, 2.0, 0.0]) && (radius * radius - 3.0).abs() < 1e-12);
    // One touching it meets it in a tangent vector.
    let line = Line::from_point_direction(Point::new(0.0, 1.0, 0.0), [1.0, 0.0, 0.0]);
    let Shape::TangentVector { at, .. } = (sphere & line).shape().unwrap() else {
        panic!()
    };
    assert!(close(at, [0.0, 1.0, 0.0]));
}

#[test]
fn each_type_is_what_it_is_called() {
    let [o, x, y] = [[0.0; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]].map(Point::from);
    let sphere = |x: f64, r| Sphere::from_centre_radius(Point::new(x, 0.0, 0.0), r);
    let plane = Plane::from_point_normal(x, [2.0, 0.0, 0.0]);
    let kinds: [(&dyn Drawable, &str); 15] = [
        (&o, "point"),
        (&(x ^ Infinity), "flat point"),
        (&(x ^ y), "point pair"),
        (&Circle::through(o, x, y), "circle"),
        (&(sphere(0.0, 1.0) & sphere(3.0, 1.0)), "imaginary circle"),
        (&(sphere(0.0, 1.0) & sphere(2.0, 1.0)), "tangent bivector"),
        (&sphere(0.0, 1.0), "sphere"),
        (&RoundVector::dual_sphere(x, 1.0), "sphere"),
        (&Line::through(o, x), "line"),
        (&plane, "plane"),
        (
            &DualPlane::from_normal_distance([0.0, 0.0, 1.0], 2.0),
            "plane",
        ),
        (&Direction::from_vector([0.0, 0.0, 2.0]), "direction"),
        (&Motor::<f64>::default(), "frame"),
        (&Rotor::<f64>::default(), "frame"),
        (&Translator::from_displacement([1.0, 0.0, 0.0]), "frame"),
    ];
    let mut scene = Scene::new("kinds");
    for (element, kind) in kinds {
        let shape = element.shape().unwrap();
        assert_eq!(shape.kind(), kind);
        scene.add(shape, Style::labelled(kind)).unwrap();
    }
    (scene.axes, scene.grid) = (true, true);
    assert_well_formed(&scene.to_svg());
    let Shape::Plane { support, normal } = plane.shape().unwrap() else {
        panic!()
    };
    assert!(close(support, [1.0, 0.0, 0.0]) && close(normal, [1.0, 0.0, 0.0]));
}

#[test]
fn dual_forms_look_as_what_they_stand_for() {
    let at = Point::new(1.0, -2.0, 3.0);
    let normal = [0.0, 3.0, 4.0];
    for squared in [4.0, 0.0, -1.0] {
        let sphere = Sphere::from_centre_radius_squared(at, squared);
        let circle = Circle::from_centre_normal_radius_squared(at, normal, squared).unwrap();
        let pair = PointPair::from_centre_axis_radius_squared(at, normal, squared).unwrap();
        assert_eq!(sphere.dual().shape(), sphere.shape());
        assert_eq!(circle.dual().shape(), circle.shape());
        assert_eq!(pair.dual().shape(), pair.shape());
    }
    let flat = at ^ Infinity;
    assert_eq!(flat.dual().shape(), flat.shape());
    assert_eq!(
        flat.shape(),
        Ok(Shape::FlatPoint {
            at: Point::new(1.0, -2.0, 3.0)
        })
    );
}

#[test]
fn what_has_no_place_is_refused() {
    let mut scene = Scene::new("");
    let nan = Point::new(f64::NAN, 0.0, 0.0);
    assert!(matches!(
        scene.add(nan, Style::default()),
        Err(NotDrawable::NotFinite(_))
    ));
    let far = Point::new(1e200, 0.0, 0.0);
    assert_eq!(
        scene.add(far, Style::default()).unwrap_err(),
        NotDrawable::TooLarge(1e200)
    );
    assert_eq!(Bivector::<f64>::ZERO.shape(), Err(NotDrawable::Zero));
    let at_infinity = RoundVector::new(0.0, 0.0, 0.0, 0.0, 1.0);
    assert_eq!(at_infinity.shape(), Err(NotDrawable::NoWeight));
    let infinite = Sphere::from_centre_radius_squared(Point::ORIGIN, f64::INFINITY);
    assert_eq!(infinite.shape(), Err(NotDrawable::NotFinite(f64::INFINITY)));
    let mixed: Multivector<f64> = Multivector {
        scalar: 1.0,
        e1: 1.0,
        ..Multivector::default()
    };
    assert_eq!(mixed.shape(), Err(NotDrawable::NeitherBladeNorMotor));
    assert_eq!(scene.shapes().count(), 0);
}
