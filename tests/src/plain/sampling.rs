//! Least values by sampling.

use std::f64::consts::TAU;

/// The least value of a function of an angle, by dense sampling and golden-section search around
/// the smallest samples.
pub fn least_by_sampling(samples: usize, function: impl Fn(f64) -> f64) -> f64 {
    let step = TAU / samples as f64;
    let values: Vec<f64> = (0..samples).map(|k| function(k as f64 * step)).collect();
    let mut best = f64::INFINITY;
    for k in 0..samples {
        let (before, after) = (
            values[(k + samples - 1) % samples],
            values[(k + 1) % samples],
        );
        if values[k] > before || values[k] > after {
            continue;
        }
        let (mut a, mut b) = ((k as f64 - 1.0) * step, (k as f64 + 1.0) * step);
        let ratio = (5.0_f64.sqrt() - 1.0) / 2.0;
        let (mut c, mut d) = (b - ratio * (b - a), a + ratio * (b - a));
        let (mut at_c, mut at_d) = (function(c), function(d));
        for _ in 0..80 {
            if at_c < at_d {
                (b, d, at_d) = (d, c, at_c);
                c = b - ratio * (b - a);
                at_c = function(c);
            } else {
                (a, c, at_c) = (c, d, at_d);
                d = a + ratio * (b - a);
                at_d = function(d);
            }
        }
        best = best.min(at_c).min(at_d).min(values[k]);
    }
    best
}
