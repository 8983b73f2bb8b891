//! Noisy points give the least sum that another library finds.

use ga_runtime::cga3::{Circle, Line, Plane, Point, Sphere};
use ga_runtime::geometry::fit::{Cylinder, Loss, PrimitiveFit, RobustSettings};
use nullcone_tests::oracle;
use nullcone_tests::plain::{Vector, cross, dot, length, minus};
use serde_json::Value;

fn numbers(value: &Value) -> Vec<f64> {
    let list = value.as_array().expect("a list");
    list.iter().map(|x| x.as_f64().expect("a number")).collect()
}

fn vector(value: &Value) -> Vector {
    numbers(value).try_into().expect("three numbers")
}

fn points(case: &Value) -> Vec<Point<f64>> {
    let list = case["points"].as_array().expect("a list");
    list.iter()
        .map(|point| Point::from(vector(point)))
        .collect()
}

/// The centre or a point, the axis, the radius and the root mean square of what was fitted.
struct Found {
    origin: Vector,
    axis: Vector,
    radius: f64,
    rms: f64,
}

fn found<P, const N: usize>(fit: &PrimitiveFit<P, f64, N>) -> Found {
    Found {
        origin: fit.origin().coordinates(),
        axis: fit.axes()[2],
        radius: fit.radius(),
        rms: fit.rms(),
    }
}

macro_rules! fit {
    ($Type:ident, $case:expr) => {{
        let (points, case) = (points($case), $case);
        let loss = match case["loss"].as_str() {
            Some("huber") => Some((Loss::Huber, 1.345)),
            Some("tukey") => Some((Loss::Tukey, 4.685)),
            _ => None,
        };
        if let Some((loss, constant)) = loss {
            // No point is beyond the threshold: the losses alone decide.
            let settings = RobustSettings {
                loss,
                scale: case["limit"].as_f64().map(|limit| limit / constant),
                ..RobustSettings::new(1e3)
            };
            let robust = $Type::fit_robustly(&points, &settings).unwrap();
            assert_eq!(robust.inliers.len(), points.len());
            found(&robust.fit)
        } else if case["weights"].is_array() {
            let weighted: Vec<_> = numbers(&case["weights"]).into_iter().zip(points).collect();
            found(&$Type::fit_weighted(&weighted).unwrap())
        } else {
            found(&$Type::fit(&points).unwrap())
        }
    }};
}

#[test]
fn another_library_finds_the_same_optimum() {
    let file = oracle::extract("fit/primitives.json");
    let cases = file["cases"].as_array().unwrap();
    assert_eq!(cases.len(), 35);
    let mut greatest: f64 = 0.0;
    for (index, case) in cases.iter().enumerate() {
        let kind = case["kind"].as_str().unwrap();
        let found = match kind {
            "sphere" => fit!(Sphere, case),
            "circle" => fit!(Circle, case),
            "plane" => fit!(Plane, case),
            "line" => fit!(Line, case),
            "cylinder" => fit!(Cylinder, case),
            _ => panic!("{kind}"),
        };
        let point = vector(&case["point"]);
        let apart = minus(found.origin, point);
        let mut errors = Vec::new();
        if kind == "sphere" || kind == "circle" {
            errors.push(length(apart));
        }
        if kind != "sphere" {
            let axis = vector(&case["direction"]);
            errors.push(length(cross(axis, found.axis)));
            match kind {
                "plane" => errors.push(dot(axis, apart).abs()),
                "line" | "cylinder" => errors.push(length(cross(axis, apart))),
                _ => {}
            }
        }
        if let Some(radius) = case["radius"].as_f64() {
            errors.push((found.radius - radius).abs());
        }
        if case["loss"] == "squares" {
            let total = match &case["weights"] {
                Value::Null => points(case).len() as f64,
                weights => numbers(weights).iter().sum(),
            };
            let expected = (case["cost"].as_f64().unwrap() / total).sqrt();
            errors.push((found.rms / expected - 1.0).abs());
        }
        let most = errors.iter().fold(0.0, |most: f64, error| most.max(*error));
        assert!(most < 1e-6, "case {index}, {kind}: {errors:?}");
        greatest = greatest.max(most);
    }
    println!("the greatest difference is {greatest:e}");
}

/// The algebraic fits of spheres and circles are those of Taubin, by another library's generalized
/// eigenvectors.
#[test]
fn another_library_has_the_same_algebraic_fits() {
    let file = oracle::extract("fit/primitives.json");
    let cases = file["cases"].as_array().unwrap();
    let mut count = 0;
    for case in cases.iter().filter(|case| case["algebraic"].is_object()) {
        count += 1;
        let known = &case["algebraic"];
        let (centre, radius) = (vector(&known["point"]), known["radius"].as_f64().unwrap());
        let (found, found_radius) = if case["kind"] == "sphere" {
            let sphere = Sphere::fit_algebraically(&points(case)).unwrap();
            (sphere.centre(), sphere.radius())
        } else {
            let circle = Circle::fit_algebraically(&points(case)).unwrap();
            let normal = circle.unit_normal().unwrap();
            assert!(length(cross(normal, vector(&known["direction"]))) < 1e-9);
            (circle.centre(), circle.radius())
        };
        let found = found.unwrap().coordinates();
        // The radius of a blade has the rounding of the squared distance from the origin.
        assert!(length(minus(found, centre)) < 1e-8, "{found:?} {centre:?}");
        assert!((found_radius.unwrap() - radius).abs() < 1e-8);
    }
    assert_eq!(count, 6);
}

/// The algebraic fits of cylinders are near to the least distances.
#[test]
fn algebraic_fits_of_cylinders_are_near() {
    let file = oracle::extract("fit/primitives.json");
    let cases = file["cases"].as_array().unwrap();
    let cylinders = cases.iter().filter(|case| case["kind"] == "cylinder");
    for case in cylinders.filter(|case| case["loss"] == "squares" && case["weights"].is_null()) {
        let found = Cylinder::fit_algebraically(&points(case)).unwrap();
        let radius = case["radius"].as_f64().unwrap();
        assert!(
            (found.radius / radius - 1.0).abs() < 0.02,
            "{} {radius}",
            found.radius
        );
        let axis = found.axis.unit_direction().unwrap();
        assert!(length(cross(axis, vector(&case["direction"]))) < 0.02);
    }
}
