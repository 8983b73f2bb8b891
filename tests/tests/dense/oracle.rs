//! The dense reference against coefficients from independent libraries.
//!
//! The extracts in `data/ga` are always tested, the complete test vectors where the shared data is
//! present.

use ga_runtime::dense::{Algebra, Multivector};
use ga_runtime::testing::check_close;
use nullcone_tests::oracle;
use serde_json::Value;

type Result<T> = std::result::Result<T, Box<dyn std::error::Error>>;

const INFINITY: usize = 0b10000;

#[test]
fn products_of_the_extract() -> Result<()> {
    assert_eq!(
        check_products(&oracle::extract("ga/products.json")["products"])?,
        20
    );
    Ok(())
}

#[test]
fn figures_of_the_extract() -> Result<()> {
    assert_eq!(check_figures(&oracle::extract("ga/geometry.json"))?, 8 * 6);
    Ok(())
}

#[test]
fn complete_vectors() -> Result<()> {
    if let Some(all) = oracle::complete() {
        assert_eq!(check_products(&all["products"])?, 240);
        assert_eq!(check_figures(&all["geometry"])?, 8 * 60);
    }
    Ok(())
}

/// Every product and involution of each pair; returns the number of pairs.
fn check_products(pairs: &Value) -> Result<usize> {
    let algebra = conformal_space()?;
    for (index, pair) in list(pairs)?.iter().enumerate() {
        let a = multivector(&algebra, &pair["a"])?;
        let b = multivector(&algebra, &pair["b"])?;
        let size = largest(&a) * largest(&b);
        let expect = |name: &str, found: Multivector<f64>| -> Result<()> {
            let expected = multivector(&algebra, &pair[name])?;
            // Where coefficients cancel completely, the rounding error is relative to the terms
            // that cancelled.
            let scale = if largest(&expected) < 1e-12 {
                size
            } else {
                largest(&expected)
            };
            check_close(&found, &expected, Some(1e-13), Some(scale))
                .map_err(|deviation| format!("{name} of pair {index}: {deviation}").into())
        };
        expect("geometric", a.geometric(&b))?;
        expect("outer", a.wedge(&b))?;
        expect("left_contraction", a.left_contraction(&b))?;
        expect("right_contraction", a.right_contraction(&b))?;
        expect("hestenes", a.hestenes(&b))?;
        expect("dot", a.dot(&b))?;
        expect("commutator", a.commutator(&b))?;
        expect("regressive", a.vee(&b))?;
        expect("reverse_a", a.reverse())?;
        expect("involution_a", a.involute())?;
        expect("conjugate_a", a.conjugate())?;
        expect("dual_a", a.dual())?;
        expect("undual_a", a.undual())?;
        for (name, found, scale) in [
            ("scalar", a.scalar_product(&b), size),
            ("norm_squared_a", a.norm_squared(), largest(&a).powi(2)),
        ] {
            let expected = number(&pair[name])?;
            check_close(
                &found,
                &expected,
                Some(1e-13),
                Some(scale.max(expected.abs())),
            )
            .map_err(|deviation| format!("{name} of pair {index}: {deviation}"))?;
        }
    }
    Ok(list(pairs)?.len())
}

/// Figures as outer products, meets as regressive products, motions as sandwiches; returns the
/// number of records.
fn check_figures(geometry: &Value) -> Result<usize> {
    let algebra = conformal_space()?;
    let blade = |record: &Value, name: &str| multivector(&algebra, &record[name]);
    let infinity = algebra.blade(INFINITY)?;
    let mut records = 0;
    let mut check =
        |kind: &str, examine: &dyn Fn(&Value, &Comparison) -> Result<()>| -> Result<()> {
            for (index, record) in list(&geometry[kind])?.iter().enumerate() {
                examine(record, &Comparison { kind, index })?;
                records += 1;
            }
            Ok(())
        };

    for (kind, flat) in [
        ("circles", false),
        ("spheres", false),
        ("lines", true),
        ("planes", true),
    ] {
        check(kind, &|record, compare| {
            let mut figure = algebra.one();
            for place in list(&record["points"])? {
                figure = figure ^ point(&algebra, place)?;
            }
            if flat {
                figure = figure ^ &infinity;
            }
            compare.close("blade", &figure, &blade(record, "blade")?)
        })?;
    }
    check("sphere_plane", &|record, compare| {
        // The intersection of two dual hyperplanes is their outer product.
        let meet = blade(record, "sphere_dual")? ^ blade(record, "plane_dual")?;
        compare.close("meet_dual", &meet, &blade(record, "meet_dual")?)?;
        let through_duals =
            (blade(record, "sphere_dual")?.undual() & blade(record, "plane_dual")?.undual()).dual();
        compare.close("meet_dual", &through_duals, &meet)
    })?;
    check("sphere_line", &|record, compare| {
        let meet = blade(record, "line")? & blade(record, "sphere")?;
        compare.close("meet", &meet, &blade(record, "meet")?)?;
        for hit in list(&record["hits"])? {
            let incidence = point(&algebra, hit)? ^ &meet;
            check_close(
                &incidence,
                &algebra.zero(),
                Some(1e-12),
                Some(largest(&meet)),
            )
            .map_err(|deviation| format!("hit: {deviation}"))?;
        }
        Ok(())
    })?;
    check("motors", &|record, compare| {
        let motor = blade(record, "motor")?;
        compare.close(
            "half",
            &blade(record, "half")?.geometric(&blade(record, "half")?),
            &motor,
        )?;
        compare.close(
            "point",
            &motor.sandwich(&point(&algebra, &record["point"])?),
            &point(&algebra, &record["image"])?,
        )?;
        for figure in ["line", "sphere", "circle"] {
            let image = blade(record, &format!("{figure}_image"))?;
            compare.close(figure, &motor.sandwich(&blade(record, figure)?), &image)?;
            let transformed = motor
                .transform(&blade(record, figure)?)
                .ok_or("a motor has an inverse")?;
            compare.close(figure, &transformed, &image)?;
        }
        Ok(())
    })?;
    check("versors", &|record, compare| {
        let versor = blade(record, "versor")?;
        compare.close(
            "point",
            &versor.sandwich(&point(&algebra, &record["point"])?),
            &blade(record, "image")?,
        )?;
        compare.close(
            "circle",
            &versor.sandwich(&blade(record, "circle")?),
            &blade(record, "circle_image")?,
        )
    })?;
    Ok(records)
}

struct Comparison<'a> {
    kind: &'a str,
    index: usize,
}

impl Comparison<'_> {
    fn close(
        &self,
        name: &str,
        found: &Multivector<f64>,
        expected: &Multivector<f64>,
    ) -> Result<()> {
        // For images of images, both computations lose some digits.
        check_close(found, expected, Some(1e-12), None).map_err(|deviation| {
            format!("{name} of {} {}: {deviation}", self.kind, self.index).into()
        })
    }
}

fn conformal_space() -> Result<Algebra<f64>> {
    let metric = [
        [1.0, 0.0, 0.0, 0.0, 0.0],
        [0.0, 1.0, 0.0, 0.0, 0.0],
        [0.0, 0.0, 1.0, 0.0, 0.0],
        [0.0, 0.0, 0.0, 0.0, -1.0],
        [0.0, 0.0, 0.0, -1.0, 0.0],
    ];
    Ok(Algebra::new(metric.map(Vec::from).to_vec())?.with_names(["e1", "e2", "e3", "eo", "ei"])?)
}

fn point(algebra: &Algebra<f64>, place: &Value) -> Result<Multivector<f64>> {
    let coordinates = numbers(place)?;
    let half_square = coordinates.iter().map(|x| x * x).sum::<f64>() / 2.0;
    Ok(algebra.vector(coordinates.into_iter().chain([1.0, half_square]))?)
}

fn multivector(algebra: &Algebra<f64>, coefficients: &Value) -> Result<Multivector<f64>> {
    Ok(algebra.multivector(numbers(coefficients)?)?)
}

fn largest(a: &Multivector<f64>) -> f64 {
    a.coefficients()
        .iter()
        .fold(0.0, |largest, value| largest.max(value.abs()))
}

fn list(value: &Value) -> Result<&Vec<Value>> {
    value
        .as_array()
        .ok_or_else(|| format!("{value} is not a list").into())
}

fn numbers(value: &Value) -> Result<Vec<f64>> {
    list(value)?.iter().map(number).collect()
}

fn number(value: &Value) -> Result<f64> {
    value
        .as_f64()
        .ok_or_else(|| format!("{value} is not a number").into())
}
