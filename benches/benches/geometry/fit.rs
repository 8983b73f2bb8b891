//! The motion that takes points to points, by least squares.

use criterion::Criterion;
use ga_runtime::cga3::{Motor, Point};
use nalgebra_035::{Isometry3, Matrix3, Point3, Rotation3, Translation3, UnitQuaternion, Vector3};
use nullcone_benches::inputs::Numbers;

use super::group;

type Pairs = Vec<(Point<f64>, Point<f64>)>;

/// Points and their moved images, with an error of a hundredth.
fn pairs(count: usize) -> Pairs {
    let mut numbers = Numbers::new(7);
    let motor = numbers.motor::<f64>();
    (0..count)
        .map(|_| {
            let p = numbers.point::<f64>();
            let [x, y, z] = motor.transform(p).coordinates();
            let [a, b, c] = numbers.numbers::<f64, 3>().map(|e| 0.01 * e);
            (p, Point::new(x + a, y + b, z + c))
        })
        .collect()
}

/// Centroids and moments in one pass over differences from the first points, then the singular
/// values (Umeyama, 1991).
fn by_singular_values(
    pairs: impl ExactSizeIterator<Item = (f64, Point3<f64>, Point3<f64>)> + Clone,
    total: Option<f64>,
) -> Option<Isometry3<f64>> {
    let (_, x0, y0) = pairs.clone().next()?;
    let mut sum = 0.0;
    let (mut x_sum, mut y_sum) = (Vector3::zeros(), Vector3::zeros());
    let mut moments = Matrix3::zeros();
    for (weight, x, y) in pairs {
        let (x, y) = ((x - x0) * weight, y - y0);
        sum += weight;
        x_sum += x;
        y_sum += y * weight;
        moments += y * x.transpose();
    }
    let share = 1.0 / total.unwrap_or(sum);
    moments -= y_sum * x_sum.transpose() * share;
    let decomposed = moments.svd(true, true);
    let (mut u, v) = (decomposed.u?, decomposed.v_t?);
    if (u * v).determinant() < 0.0 {
        let least = decomposed.singular_values.imin();
        u.column_mut(least).neg_mut();
    }
    let rotation = UnitQuaternion::from_rotation_matrix(&Rotation3::from_matrix_unchecked(u * v));
    let (from, to) = (x0 + x_sum * share, y0 + y_sum * share);
    let translation = Translation3::from(to - rotation * from);
    Some(Isometry3::from_parts(translation, rotation))
}

pub(crate) fn all(criterion: &mut Criterion) {
    for count in [10, 1_000, 100_000] {
        let ours = pairs(count);
        let theirs: Vec<_> = ours
            .iter()
            .map(|(x, y)| {
                let [x, y] = [x, y].map(|p| Point3::from(p.coordinates()));
                (x, y)
            })
            .collect();
        let weighted: Vec<_> = ours.iter().map(|&(x, y)| (0.5, x, y)).collect();
        let mut g = group(criterion, &format!("motion from {count} pairs of points"));
        g.once("nullcone", &ours, |pairs| {
            Motor::from_point_pairs(pairs).map(|fit| fit.motion)
        });
        g.once("nalgebra, moments and singular values", &theirs, |pairs| {
            let equal = pairs.iter().map(|&(x, y)| (1.0, x, y));
            by_singular_values(equal, Some(pairs.len() as f64))
        });
        drop(g);
        let theirs: Vec<_> = theirs.iter().map(|&(x, y)| (0.5, x, y)).collect();
        let mut g = group(
            criterion,
            &format!("motion from {count} weighted pairs of points"),
        );
        g.once("nullcone", &weighted, |pairs| {
            Motor::from_weighted_point_pairs(pairs).map(|fit| fit.motion)
        });
        g.once("nalgebra, moments and singular values", &theirs, |pairs| {
            by_singular_values(pairs.iter().copied(), None)
        });
    }
}
