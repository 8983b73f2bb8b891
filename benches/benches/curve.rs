//! Cubic splines through 1,000 keys. A plain solve by the algorithm of Thomas, for the second
//! derivatives alone, and glam's product of a matrix and a point are the units, in the same run.

use std::hint::black_box;

use criterion::{Criterion, Throughput, criterion_group, criterion_main};
use ga_anim::curve::{Curve, EndKind, SplineSystem};
use glam::{DMat4, DVec3};
use nullcone_benches::comparison;
use nullcone_benches::inputs::Numbers;

const KEYS: usize = 1000;
const SAMPLES: usize = 100;
const CHANNELS: usize = 8;

fn keys() -> (Vec<f64>, Vec<f64>) {
    let mut numbers = Numbers::new(1);
    let mut time = 0.0;
    (0..KEYS)
        .map(|_| {
            time += 1.0 + 0.8 * numbers.number::<f64>();
            (time, numbers.number::<f64>())
        })
        .unzip()
}

/// The second derivatives of the natural spline, or of the spline with slopes 0 at the ends, as a
/// textbook has them: the rows, one elimination, one substitution.
fn thomas(times: &[f64], values: &[f64], is_clamped: bool) -> Vec<f64> {
    let n = times.len();
    let h: Vec<f64> = times.windows(2).map(|t| t[1] - t[0]).collect();
    let (mut above, mut right) = (vec![0.0; n], vec![0.0; n]);
    if is_clamped {
        above[0] = 0.5;
        right[0] = 3.0 * (values[1] - values[0]) / (h[0] * h[0]);
    }
    for i in 1..n - 1 {
        let slopes = (values[i + 1] - values[i]) / h[i] - (values[i] - values[i - 1]) / h[i - 1];
        let pivot = 2.0 * (h[i - 1] + h[i]) - h[i - 1] * above[i - 1];
        above[i] = h[i] / pivot;
        right[i] = (6.0 * slopes - h[i - 1] * right[i - 1]) / pivot;
    }
    let mut bends = vec![0.0; n];
    if is_clamped {
        let end = -6.0 * (values[n - 1] - values[n - 2]) / h[n - 2];
        bends[n - 1] = (end - h[n - 2] * right[n - 2]) / (2.0 * h[n - 2] - h[n - 2] * above[n - 2]);
    }
    for i in (0..n - 1).rev() {
        bends[i] = right[i] - above[i] * bends[i + 1];
    }
    bends
}

fn set_up(criterion: &mut Criterion) {
    let (times, values) = keys();
    let solved = thomas(&times, &values, true);
    for (name, kind, is_clamped) in [
        ("natural", EndKind::Natural, false),
        ("clamped", EndKind::Slopes, true),
    ] {
        let mut group = criterion.benchmark_group(format!("curve/set-up {name}-f64"));
        group.throughput(Throughput::Elements(KEYS as u64));
        group.bench_function("nullcone", |bench| {
            bench.iter(|| {
                let system = SplineSystem::new(black_box(&times), kind).expect("times rise");
                system.fit(black_box(&values)).expect("values are finite")
            });
        });
        group.bench_function("Thomas, plain", |bench| {
            bench.iter(|| thomas(black_box(&times), black_box(&values), is_clamped));
        });
        group.finish();
    }
    let clamped = SplineSystem::new(&times, EndKind::Slopes).and_then(|system| system.fit(&values));
    let clamped = clamped.expect("the keys are good");
    let same = clamped.pieces().iter().zip(&solved);
    assert!(
        same.into_iter()
            .all(|(piece, m)| (2.0 * piece[2] - m).abs() < 1e-9)
    );

    let mut numbers = Numbers::new(2);
    let many: Vec<[f64; CHANNELS]> = (0..KEYS).map(|_| numbers.numbers()).collect();
    let mut group = criterion.benchmark_group("curve/set-up 8 channels-f64");
    group.throughput(Throughput::Elements((KEYS * CHANNELS) as u64));
    group.bench_function("nullcone, one factorisation", |bench| {
        bench.iter(|| {
            let system =
                SplineSystem::new(black_box(&times), EndKind::Natural).expect("times rise");
            system.fit(black_box(&many)).expect("values are finite")
        });
    });
    let single: Vec<Vec<f64>> = (0..CHANNELS)
        .map(|k| many.iter().map(|row| row[k]).collect())
        .collect();
    group.bench_function("Thomas, plain", |bench| {
        bench.iter(|| {
            for values in black_box(&single) {
                black_box(thomas(black_box(&times), values, false));
            }
        });
    });
    group.finish();
}

fn evaluation(criterion: &mut Criterion) {
    let (times, values) = keys();
    let system = SplineSystem::new(&times, EndKind::Natural).expect("times rise");
    let curve = system.fit(&values).expect("values are finite");
    let (start, end) = (curve.start(), curve.end());
    let count = (KEYS - 1) * SAMPLES;
    let queries: Vec<f64> = (0..count)
        .map(|i| start + (end - start) * i as f64 / count as f64)
        .collect();
    let mut numbers = Numbers::new(3);
    let shuffled: Vec<f64> = (0..count)
        .map(|_| start + (end - start) * (0.5 + 0.5 * numbers.number::<f64>()))
        .collect();
    let mut results = vec![0.0; count];
    let triples: Vec<[f64; 3]> = values.iter().map(|&v| [v, 1.0 - v, v * v]).collect();
    let triple = system.fit(&triples).expect("values are finite");
    let mut places = vec![[0.0; 3]; count];

    let mut group = criterion.benchmark_group("curve/evaluation-f64");
    group.throughput(Throughput::Elements(count as u64));
    group.bench_function("nullcone, forward", |bench| {
        bench.iter(|| curve.sample_into(black_box(&queries), black_box(&mut results)));
    });
    group.bench_function("nullcone, forward by a cursor", |bench| {
        bench.iter(|| {
            let mut cursor = curve.cursor();
            for (result, &time) in black_box(&mut results).iter_mut().zip(black_box(&queries)) {
                *result = cursor.value(time);
            }
        });
    });
    group.bench_function("nullcone, at random", |bench| {
        bench.iter(|| {
            for (result, &time) in black_box(&mut results).iter_mut().zip(black_box(&shuffled)) {
                *result = curve.value(time);
            }
        });
    });
    group.bench_function("nullcone, 3 channels forward", |bench| {
        bench.iter(|| triple.sample_into(black_box(&queries), black_box(&mut places)));
    });
    let matrix = DMat4::from_axis_angle(DVec3::Y, 0.3);
    let points: Vec<DVec3> = queries
        .iter()
        .map(|&t| DVec3::new(t, 1.0 - t, 0.5))
        .collect();
    let mut moved = points.clone();
    group.bench_function("glam, DMat4 · point", |bench| {
        bench.iter(|| {
            for (moved, &point) in black_box(&mut moved).iter_mut().zip(black_box(&points)) {
                *moved = matrix.transform_point3(point);
            }
        });
    });
    group.finish();
}

fn resampling(criterion: &mut Criterion) {
    use ga_anim::curve::Distance;
    let (times, values) = keys();
    let path: Vec<[f64; 3]> = values
        .iter()
        .map(|&v| [v, 1.0 - v * v, v * v * v])
        .collect();
    let curve = Curve::catmull_rom(&times, &path).expect("the keys are good");
    let mut group = criterion.benchmark_group("curve/resampling-f64");
    for tolerance in [1e-2, 1e-4] {
        let count = curve
            .resampled(tolerance, Distance::Geometric)
            .map_or(0, |r| r.times.len());
        group.throughput(Throughput::Elements(count as u64));
        group.bench_function(format!("nullcone, a vertex at {tolerance}"), |bench| {
            bench.iter(|| curve.resampled(black_box(tolerance), Distance::Geometric));
        });
    }
    group.finish();
}

criterion_group! {
    name = benches;
    config = comparison::criterion();
    targets = set_up, evaluation, resampling
}
criterion_main!(benches);
