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
