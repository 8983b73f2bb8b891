//! The types of cga3 against test vectors that other libraries computed.

use std::iter;

use ga_runtime::Element;
use ga_runtime::cga3::{
    Circle, DualPlane, DualSphere, Even, Infinity, Line, Motor, MotorGenerator, Multivector, Plane,
    Point, Rotor, RoundVector, Sphere, Translator,
};
use nullcone_tests::oracle;
use serde_json::Value;

/// The coefficients of a record's multivector, by blade.
fn coefficients(value: &Value) -> Vec<f64> {
    let list = value.as_array().expect("a list of coefficients");
    list.iter().map(|x| x.as_f64().expect("a number")).collect()
}

fn element<T: Element<Scalar = f64>>(value: &Value) -> T {
    let coefficients = coefficients(value);
    T::from_coefficients_unchecked(&mut |blade| coefficients[blade])
}

fn vector(value: &Value) -> [f64; 3] {
    let list = coefficients(value);
    [list[0], list[1], list[2]]
}

fn points(record: &Value) -> Vec<Point<f64>> {
    let list = record["points"].as_array().expect("points");
    list.iter().map(|p| Point::from(vector(p))).collect()
}

/// Compares all 32 coefficients, relative to the largest of both or to a given scale.
fn close<T: Element<Scalar = f64>>(
    what: &str,
    found: &T,
    expected: &Value,
    tolerance: f64,
    least: f64,
) {
    let expected = coefficients(expected);
    let all: Vec<f64> = (0..32).map(|blade| found.coefficient(blade)).collect();
    let scale = all
        .iter()
        .chain(&expected)
        .fold(least, |m, x| m.max(x.abs()));
    for (blade, (a, b)) in all.iter().zip(&expected).enumerate() {
        assert!(
            (a - b).abs() <= tolerance * scale,
            "{what}, blade {blade:05b}: {a} is not {b}"
        );
    }
}

fn near(what: &str, found: &[f64], expected: &[f64], tolerance: f64) {
    let scale = expected.iter().fold(1.0_f64, |m, x| m.max(x.abs()));
    for (a, b) in found.iter().zip(expected) {
        assert!(
            (a - b).abs() <= tolerance * scale,
            "{what}: {found:?} is not {expected:?}"
        );
    }
}

/// The extract in the repository, and all test vectors where the shared data is present.
fn sources(extract: &str, key: Option<&str>) -> Vec<Value> {
    let complete = oracle::complete().map(|all| key.map_or(all, |key| &all[key]).clone());
    iter::once(oracle::extract(extract))
        .chain(complete)
        .collect()
}

fn records<'a>(source: &'a Value, kind: &str) -> &'a Vec<Value> {
    source[kind].as_array().expect("records")
}

#[test]
fn products_of_multivectors() {
    for source in sources("ga/products.json", None) {
        for pair in records(&source, "products") {
            let (a, b): (Multivector<f64>, Multivector<f64>) =
                (element(&pair["a"]), element(&pair["b"]));
            // Every coefficient of a product is a sum of at most 32 products of numbers below 1.
            let check = |name: &str, found: Multivector<f64>| {
                close(name, &found, &pair[name], 1e-13, 1.0);
            };
            check("geometric", a * b);
            check("outer", a ^ b);
            check("left_contraction", a | b);
            check("right_contraction", a.right_contraction(b));
            check("commutator", a.commutator(b));
            check("regressive", a & b);
            check("reverse_a", a.reverse());
            check("involution_a", a.involute());
            check("conjugate_a", a.conjugate());
            check("dual_a", a.dual());
            check("undual_a", a.undual());
            let number = |name: &str| pair[name].as_f64().expect("a number");
            near("scalar", &[a.scalar_product(b)], &[number("scalar")], 1e-13);
            near(
                "norm",
                &[a.norm_squared()],
                &[number("norm_squared_a")],
                1e-13,
            );
        }
    }
}

#[test]
fn rounds_and_flats_through_points() {
    for source in sources("ga/geometry.json", Some("geometry")) {
        for record in records(&source, "circles") {
            let [p, q, r] = points(record)[..] else {
                panic!("three points")
            };
            let circle = Circle::through(p, q, r);
            close("circle", &circle, &record["blade"], 1e-12, 0.0);
            let radius = record["radius"].as_f64().expect("a number");
            let centre = circle.centre().expect("no line").coordinates();
            // The smaller the weight, the more of its digits were lost by cancellation.
            let conditioning = radius.max(1.0).powi(2);
            near(
                "centre",
                &centre,
                &vector(&record["center"]),
                1e-11 * conditioning,
            );
            near(
                "radius",
                &[circle.radius().expect("real")],
                &[radius],
                1e-11 * conditioning,
            );
            near(
                "normal",
                &circle.unit_normal().expect("no line"),
                &vector(&record["normal"]),
                1e-11,
            );
            let again = Circle::from_centre_normal_radius(
                Point::from(centre),
                vector(&record["normal"]),
                radius,
            )
            .expect("a normal");
            near(
                "built radius",
                &[again.radius().expect("real")],
                &[radius],
                1e-11 * conditioning,
            );
            near(
                "built centre",
                &again.centre().expect("no line").coordinates(),
                &centre,
                1e-11,
            );
        }
        for record in records(&source, "spheres") {
            let [p, q, r, s] = points(record)[..] else {
                panic!("four points")
            };
            let sphere = Sphere::through(p, q, r, s);
            close("sphere", &sphere, &record["blade"], 1e-11, 0.0);
            let radius = record["radius"].as_f64().expect("a number");
            let conditioning = radius.max(1.0).powi(2);
            let centre = sphere.centre().expect("no plane").coordinates();
            near(
                "centre",
                &centre,
                &vector(&record["center"]),
                1e-11 * conditioning,
            );
            near(
                "radius",
                &[sphere.radius().expect("real")],
                &[radius],
                1e-11 * conditioning,
            );
        }
        for record in records(&source, "lines") {
            let [p, q] = points(record)[..] else {
                panic!("two points")
            };
            let line = Line::through(p, q);
            close("line", &line, &record["blade"], 1e-13, 0.0);
            close("line", &(p ^ q ^ Infinity), &record["blade"], 1e-13, 0.0);
            let direction = line.unit_direction().expect("two places");
            near(
                "direction",
                &direction,
                &vector(&record["direction"]),
                1e-12,
            );
            let length = line.direction().iter().map(|x| x * x).sum::<f64>().sqrt();
            near(
                "length",
                &[length],
                &[record["length"].as_f64().expect("a number")],
                1e-12,
            );
        }
        for record in records(&source, "planes") {
            let [p, q, r] = points(record)[..] else {
                panic!("three points")
            };
            let plane = Plane::through(p, q, r);
            close("plane", &plane, &record["blade"], 1e-12, 0.0);
            close(
                "plane",
                &(p ^ q ^ r ^ Infinity),
                &record["blade"],
                1e-12,
                0.0,
            );
            near(
                "normal",
                &plane.unit_normal().expect("no line"),
                &vector(&record["normal"]),
                1e-11,
            );
            let offset = plane.signed_distance(Point::default()).expect("no line");
            near(
                "offset",
                &[-offset],
                &[record["offset"].as_f64().expect("a number")],
                1e-11,
            );
        }
    }
}

#[test]
fn meets() {
    for source in sources("ga/geometry.json", Some("geometry")) {
        for record in records(&source, "sphere_plane") {
            let centre = Point::from(vector(&record["center"]));
            let radius = record["radius"].as_f64().expect("a number");
            let sphere = DualSphere::from_centre_radius(centre, radius);
            close("dual sphere", &sphere, &record["sphere_dual"], 1e-13, 0.0);
            let offset = record["offset"].as_f64().expect("a number");
            let plane = DualPlane::from_normal_distance(vector(&record["normal"]), offset);
            close("dual plane", &plane, &record["plane_dual"], 1e-13, 0.0);
            let circle = sphere.undual() & plane.undual();
            close("meet", &circle.dual(), &record["meet_dual"], 1e-12, 0.0);
            let expected = vector(&record["circle_center"]);
            near(
                "centre",
                &circle.centre().expect("no line").coordinates(),
                &expected,
                1e-11,
            );
            let radius = record["circle_radius"].as_f64();
            if let Some(radius) = radius {
                near(
                    "radius",
                    &[circle.radius().expect("real")],
                    &[radius],
                    1e-10,
                );
            }
        }
        for record in records(&source, "sphere_line") {
            let line: Line<f64> = element(&record["line"]);
            let sphere: Sphere<f64> = element(&record["sphere"]);
            let through = Point::from(vector(&record["through"]));
            near(
                "on line",
                &[line.distance(through).expect("a line")],
                &[0.0],
                1e-12,
            );
            let meet = line & sphere;
            close("meet", &meet, &record["meet"], 1e-12, 0.0);
            for hit in record["hits"].as_array().into_iter().flatten() {
                let outside = meet ^ Point::from(vector(hit));
                let size = meet.norm_squared().abs().max(1.0);
                let error: Multivector<f64> = outside.into();
                assert!(error.norm_squared().abs() <= 1e-10 * size);
            }
        }
    }
}

#[test]
fn motions() {
    for source in sources("ga/geometry.json", Some("geometry")) {
        for record in records(&source, "motors") {
            let angle = record["angle"].as_f64().expect("a number");
            let rotor = Rotor::from_axis_angle(vector(&record["axis"]), angle).expect("an axis");
            let motor: Motor<f64> =
                Translator::from_displacement(vector(&record["translation"])) * rotor;
            close("motor", &motor, &record["motor"], 1e-13, 0.0);
            close("log", &motor.log(), &record["log"], 1e-12, 0.0);
            let generator: MotorGenerator<f64> = element(&record["log"]);
            close("exp", &generator.exp(), &record["motor"], 1e-13, 0.0);
            let half = (generator * 0.5).exp();
            close("half", &half, &record["half"], 1e-13, 0.0);
            let path = Motor::default().interpolate(motor, 0.5);
            // The other library halves the logarithm as it is; our interpolation takes the short
            // way.
            if motor.scalar() >= 0.0 {
                close("half way", &path, &record["half"], 1e-12, 0.0);
            }
            let point = Point::from(vector(&record["point"]));
            let image = motor.transform(point).coordinates();
            near("point", &image, &vector(&record["image"]), 1e-13);
            let line: Line<f64> = element(&record["line"]);
            close(
                "line",
                &motor.transform(line),
                &record["line_image"],
                1e-13,
                0.0,
            );
            let sphere: Sphere<f64> = element(&record["sphere"]);
            close(
                "sphere",
                &motor.transform(sphere),
                &record["sphere_image"],
                1e-12,
                0.0,
            );
            let circle: Circle<f64> = element(&record["circle"]);
            close(
                "circle",
                &motor.transform(circle),
                &record["circle_image"],
                1e-12,
                0.0,
            );
            let [x, y, z] = motor.to_matrix().map(|[a, b, c, t]| {
                let [x, y, z] = point.coordinates();
                a * x + b * y + c * z + t
            });
            near("matrix", &[x, y, z], &vector(&record["image"]), 1e-13);
        }
    }
}

#[test]
fn general_versors() {
    for source in sources("ga/geometry.json", Some("geometry")) {
        for record in records(&source, "versors") {
            let versor: Even<f64> = element(&record["versor"]);
            let point = Point::from(vector(&record["point"]));
            let image = versor.sandwich(RoundVector::from(point));
            close("image", &image, &record["image"], 1e-12, 0.0);
            let whole = Multivector::from(versor);
            let circle: Circle<f64> = element(&record["circle"]);
            let image = whole.sandwich(Multivector::from(circle));
            close("circle", &image, &record["circle_image"], 1e-12, 0.0);
            let norm = Multivector::from(versor * versor.reverse());
            near("norm", &[norm.scalar], &[1.0], 1e-12);
        }
    }
}
