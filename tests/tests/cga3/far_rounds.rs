//! Rounds near and far: what is made, met, moved or read is as accurate as positions so far from
//! the origin can be.

use ga_runtime::cga3::{Circle, Point, Sphere};
use ga_runtime::geometry::Kind;
use nullcone_tests::limits::{NearTangency, Precision, Query, SIZES};
use proptest::prelude::*;

/// The largest error in units of ε (distance + size·K).
fn limit(query: Query) -> f64 {
    match query {
        Query::Made => 1.0,
        // Most cases stay within 64; a hundred rotations about nearly the same axis do not.
        Query::HundredMotions => 128.0,
        // Products read the squared radius about the first sphere.
        Query::LargerMeetsSmaller => f64::INFINITY,
        _ => 8.0,
    }
}

/// Distances up to the largest, and sizes from millimetres to many metres.
fn places<S: Precision>() -> impl Strategy<Value = (f64, f64)> {
    let powers = (
        -2.0..S::FARTHEST.log10(),
        SIZES[0].log10()..SIZES[1].log10(),
    );
    powers.prop_map(|(distance, size)| (10_f64.powf(distance), 10_f64.powf(size)))
}

fn check<S: Precision>(distance: f64, size: f64, seed: u64) -> Result<(), TestCaseError> {
    for query in Query::ALL {
        let error = query.error::<S>(distance, size, seed).unwrap_or(0.0);
        prop_assert!(
            error <= limit(query),
            "{query:?} in {}: {error:.1} units",
            S::NAME
        );
    }
    Ok(())
}

/// Products, methods and rays are right beyond eight units from a contact; nearer to it they may
/// differ, and the method with such a tolerance says that they touch.
fn check_contact<S: Precision>(distance: f64, size: f64, seed: u64) -> Result<(), TestCaseError> {
    let spheres = NearTangency::of_spheres::<S>(distance, size, seed);
    let line = NearTangency::of_line_and_sphere::<S>(distance, size, seed);
    for found in spheres.into_iter().chain(line) {
        let is_right = |said: bool| said == found.is_real;
        prop_assert!(found.with_tolerance.is_none_or(is_right), "{found:?}");
        let all_right = found.by_numbers.iter().all(|said| is_right(*said));
        prop_assert!(all_right || found.displacement <= 8.0, "{found:?}");
    }
    Ok(())
}

proptest! {
    #[test]
    fn errors_are_within_the_limits_in_single((distance, size) in places::<f32>(), seed: u64) {
        check::<f32>(distance, size, seed)?;
    }

    #[test]
    fn errors_are_within_the_limits_in_double((distance, size) in places::<f64>(), seed: u64) {
        check::<f64>(distance, size, seed)?;
    }

    #[test]
    fn near_tangency_the_rounding_decides_in_single((distance, size) in places::<f32>(), seed: u64) {
        check_contact::<f32>(distance, size, seed)?;
    }

    #[test]
    fn near_tangency_the_rounding_decides_in_double((distance, size) in places::<f64>(), seed: u64) {
        check_contact::<f64>(distance, size, seed)?;
    }

    #[test]
    fn what_is_made_is_real((distance, size) in places::<f32>()) {
        let (centre, radius) = (Point::new(distance as f32, 0.0, 0.0), size as f32);
        let sphere = Sphere::from_centre_radius(centre, radius);
        let circle = Circle::from_centre_normal_radius(centre, [0.0, 0.6, 0.8], radius).unwrap();
        prop_assert_eq!((sphere.kind(0.0), circle.kind(0.0)), (Kind::Real, Kind::Real));
        prop_assert_eq!(sphere.centre(), Some(centre));
    }
}

/// Cases are made and measured, so that a query that never applies does not pass for accurate.
#[test]
fn every_query_is_measured() {
    for query in Query::ALL {
        let measured = (0..100).filter_map(|seed| query.error::<f64>(1.0, 1.0, seed));
        assert!(measured.count() > 50, "{query:?}");
    }
}

/// Some of the cases near a contact are decided by the rounding, and most are not.
#[test]
fn cases_lie_on_both_sides_of_the_rounding() {
    let cases = (0..1000).filter_map(|seed| NearTangency::of_spheres::<f32>(1.0, 1.0, seed));
    let (near, far): (Vec<_>, Vec<_>) = cases.partition(|case| case.displacement <= 8.0);
    assert!(
        near.len() > 50 && far.len() > 200,
        "{}, {}",
        near.len(),
        far.len()
    );
    assert!(
        near.iter()
            .any(|case| case.by_numbers.iter().any(|said| *said != case.is_real))
    );
}
