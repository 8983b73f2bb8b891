//! Keys that are wrong are named.

use ga_anim::curve::{
    ArcLength, BezierCurve, BezierKey, Curve, CurveError, EndKind, Ends, SplineSystem,
};

#[test]
fn times() {
    let fails = |times: &[f64], message: &str| {
        let values = vec![0.0; times.len()];
        let natural = Curve::spline(times, &values, Ends::Natural).unwrap_err();
        assert_eq!(natural.to_string(), message);
        if times.len() != 1 && !message.contains("at least") {
            for curve in [
                Curve::linear(times, &values),
                Curve::catmull_rom(times, &values),
                Curve::hermite(times, &values, &values, &values),
            ] {
                assert_eq!(curve.unwrap_err().to_string(), message);
            }
        }
    };
    fails(&[], "0 keys, but this curve needs at least 2");
    fails(&[1.0], "1 keys, but this curve needs at least 2");
    fails(&[0.0, f64::NAN, 2.0], "the time of key 1 is NaN");
    fails(&[0.0, 1.0, f64::INFINITY], "the time of key 2 is inf");
    fails(
        &[0.0, 1.0, 1.0],
        "key 2 at 1 is not after the key before it, at 1",
    );
    fails(
        &[0.0, 3.0, 2.5],
        "key 2 at 2.5 is not after the key before it, at 3",
    );
    let far = [-1e308, 1e308, 1.5e308];
    let error = Curve::spline(&far, &[0.0; 3], Ends::NotAKnot).unwrap_err();
    assert_eq!(error, CurveError::OutOfRange { key: 0 });
    // Each interval is in range here, but not the whole.
    let far = [-1e308, 0.0, 1e308];
    for error in [
        Curve::spline(&far, &[0.0; 3], Ends::Natural).unwrap_err(),
        Curve::linear(&far, &[0.0; 3]).unwrap_err(),
        Curve::step(&far, &[0.0; 3]).unwrap_err(),
    ] {
        assert_eq!(error, CurveError::OutOfRange { key: 1 });
    }
    let error = Curve::linear(&[], &[0.0; 0]).unwrap_err();
    assert_eq!(
        error,
        CurveError::TooFewKeys {
            found: 0,
            needed: 1
        }
    );
}

#[test]
fn values() {
    let times = [0.0, 1.0, 2.0];
    let few = Curve::spline(&times, &[0.0; 2], Ends::Natural).unwrap_err();
    assert_eq!(few.to_string(), "2 values for 3 times");
    let bad = [[0.0, 1.0], [0.0, 2.0], [3.0, f64::NAN]];
    for error in [
        Curve::spline(&times, &bad, Ends::Natural).unwrap_err(),
        Curve::step(&times, &bad).unwrap_err(),
        Curve::catmull_rom(&times, &bad).unwrap_err(),
    ] {
        assert_eq!(error.to_string(), "values of key 2, channel 1, is NaN");
    }
    let slopes = [0.0, f64::INFINITY];
    let error = Curve::spline(&times, &[0.0; 3], Ends::Slopes(slopes)).unwrap_err();
    assert_eq!(error.to_string(), "the slope of key 2, channel 0, is inf");
    let open = Curve::spline(
        &times,
        &[[1.0, 2.0], [0.0, 0.0], [1.0, 2.5]],
        Ends::Periodic,
    );
    let error = open.unwrap_err();
    assert_eq!(
        error,
        CurveError::NotPeriodic {
            channel: 1,
            first: 2.0,
            last: 2.5
        }
    );
    let steep = Curve::spline(&[0.0, 1.0, 2.0], &[-1e308, 1e308, 0.0], Ends::Natural).unwrap_err();
    assert_eq!(steep, CurveError::OutOfRange { key: 0 });
    let natural = SplineSystem::new(&times, EndKind::Natural).unwrap();
    let error = natural.fit_with_slopes(&[0.0; 3], [1.0, 1.0]).unwrap_err();
    assert_eq!(error, CurveError::SlopesNotTaken);
    let mut places = [0.0; 2];
    let curve = natural.fit(&[0.0; 3]).unwrap();
    assert!(curve.sample_into(&[0.0; 3], &mut places).is_err());
}

#[test]
fn handles() {
    let key = |time: f64, before: f64, after: f64| BezierKey {
        time,
        value: 0.0,
        before: (before, 1.0),
        after: (after, 1.0),
    };
    let error = BezierCurve::new(&[key(0.0, 0.0, 1.5), key(1.0, 0.5, 1.0)]).unwrap_err();
    assert_eq!(error, CurveError::Handle { key: 0, time: 1.5 });
    let error = BezierCurve::new(&[key(0.0, 0.0, 0.5), key(1.0, -0.5, 1.0)]).unwrap_err();
    assert_eq!(error, CurveError::Handle { key: 1, time: -0.5 });
    assert!(BezierCurve::new(&[key(0.0, 0.0, 0.5), key(1.0, f64::NAN, 1.0)]).is_err());
    assert!(BezierCurve::<f64>::new(&[]).is_err());
    let mut bad = key(0.0, 0.0, 0.5);
    bad.after.1 = f64::NAN;
    let error = BezierCurve::new(&[bad, key(1.0, 0.5, 1.0)]).unwrap_err();
    assert_eq!(
        error.to_string(),
        "the handle after of key 0, channel 0, is NaN"
    );
    assert_eq!(
        BezierCurve::new(&[key(2.0, 0.0, 0.0)]).unwrap().value(5.0),
        0.0
    );
}

#[test]
fn speeds_beyond_the_range() {
    // The coefficients are finite, but three times the cubic one is not.
    let slopes = [-8e307, 1.6e308];
    let steep = Curve::hermite(
        &[0.0, 1.0, 2.0],
        &[0.0; 3],
        &[0.0, 0.0, slopes[1]],
        &[0.0, slopes[0], 0.0],
    );
    let error = ArcLength::new(&steep.unwrap()).unwrap_err();
    assert_eq!(error, CurveError::OutOfRange { key: 1 });
    // Each piece has a length, but their sum is beyond the range.
    let far = Curve::linear(&[0.0, 1.0, 2.0, 3.0], &[0.0, 8e307, 0.0, 8e307]).unwrap();
    let error = ArcLength::new(&far).unwrap_err();
    assert_eq!(error, CurveError::OutOfRange { key: 2 });
    // Near the range a length is still found.
    let long = Curve::linear(&[0.0, 2.0], &[[0.0, 0.0], [3e306, 4e306]]).unwrap();
    let total = ArcLength::new(&long).unwrap().total();
    assert!((total / 5e306 - 1.0).abs() < 1e-12);
}
