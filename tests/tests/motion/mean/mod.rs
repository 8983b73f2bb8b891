//! Blends and means of motions, against known means and plain matrices.

mod precision;
mod uniqueness;

use core::f64::consts::{FRAC_PI_2, PI};

use ga_runtime::cga3::{Motor, MotorGenerator, Rotor, Translator};
use ga_runtime::geometry::FitError;
use ga_runtime::testing::assert_close;
use nullcone_tests::plain::{cross, length, motor_coefficients};
use nullcone_tests::random::SplitMix64;

type Matrix = [[f64; 4]; 4];

/// Random motions and weights.
trait Draw {
    /// A rotation by this angle and a translation of this size.
    fn motor(&mut self, angle: f64, size: f64) -> Motor<f64>;
    /// A weight: often 0 or 1, and of many orders of magnitude.
    fn weight(&mut self) -> f64;
    /// The motor or its negative, which is the same motion.
    fn sign(&mut self, motor: Motor<f64>) -> Motor<f64>;
}

impl Draw for SplitMix64 {
    fn motor(&mut self, angle: f64, size: f64) -> Motor<f64> {
        let rotor = Rotor::from_axis_angle(self.axis(), angle).expect("an axis");
        Translator::from_displacement(self.vector(size)) * rotor
    }

    fn weight(&mut self) -> f64 {
        match (self.unit() * 4.0) as usize {
            0 => 1.0,
            1 => 10.0_f64.powf(self.within(3.0)),
            2 => 0.0,
            _ => self.unit(),
        }
    }

    fn sign(&mut self, motor: Motor<f64>) -> Motor<f64> {
        if self.unit() < 0.5 { -motor } else { motor }
    }
}

fn translation(t: [f64; 3]) -> Motor<f64> {
    Translator::from_displacement(t).into()
}

fn rotation(axis: [f64; 3], angle: f64) -> Motor<f64> {
    Rotor::from_axis_angle(axis, angle).expect("an axis").into()
}

/// The largest difference of the coefficients of two motors up to sign, relative to the
/// displacement.
fn deviation(a: Motor<f64>, b: Motor<f64>) -> f64 {
    let size = 1.0 + length(b.translator().displacement());
    let apart = |b: Motor<f64>| {
        let pairs = motor_coefficients(a).into_iter().zip(motor_coefficients(b));
        pairs.fold(0.0, |most: f64, (x, y)| {
            assert!(x.is_finite() && y.is_finite());
            most.max((x - y).abs())
        })
    };
    apart(b).min(apart(-b)) / size
}

fn product(a: &Matrix, b: &Matrix) -> Matrix {
    std::array::from_fn(|i| std::array::from_fn(|j| (0..4).map(|k| a[i][k] * b[k][j]).sum()))
}

/// The motion by a constant angular and linear velocity for a unit of time, as the exponential
/// series of its matrix.
fn matrix_exponential(rotation: [f64; 3], velocity: [f64; 3]) -> Matrix {
    let [x, y, z] = rotation;
    let [u, v, w] = velocity;
    let generator = [[0.0, -z, y, u], [z, 0.0, -x, v], [-y, x, 0.0, w], [0.0; 4]];
    let one: Matrix = std::array::from_fn(|i| std::array::from_fn(|j| f64::from(i == j)));
    let (mut sum, mut term) = (one, one);
    for k in 1..40 {
        term = product(&term, &generator).map(|row| row.map(|x| x / f64::from(k)));
        let before = sum;
        sum = std::array::from_fn(|i| std::array::from_fn(|j| sum[i][j] + term[i][j]));
        // The terms shrink once k exceeds the angle.
        if k > 7 && sum == before {
            break;
        }
    }
    sum
}

fn of_matrix([a, b, c, _]: Matrix) -> Motor<f64> {
    Motor::from_matrix([a, b, c]).expect("a rotation")
}

/// Motors, with weights, whose logarithms relative to a centre have the weighted sum zero; all
/// rotations are within an angle of the centre.
fn planted(random: &mut SplitMix64, centre: Motor<f64>, angle: f64) -> Vec<(f64, Motor<f64>)> {
    let count = 1 + (random.unit() * 12.0) as usize;
    let mut sums = [[0.0; 3]; 2];
    let mut cloud = Vec::new();
    let mut most = 0.0;
    for _ in 0..count {
        let (weight, far) = (random.weight(), random.unit() * angle);
        let rotation = random.axis().map(|x| x * far);
        let velocity = random.vector(5.0);
        for k in 0..3 {
            sums[0][k] += weight * rotation[k];
            sums[1][k] += weight * velocity[k];
        }
        most += weight * angle;
        cloud.push((weight, rotation, velocity));
    }
    // The last motor balances the others.
    let weight = (1.0 + random.unit()) * (most / angle).max(0.1);
    cloud.push((
        weight,
        sums[0].map(|x| -x / weight),
        sums[1].map(|x| -x / weight),
    ));
    let mut moved: Vec<_> = cloud
        .into_iter()
        .map(|(weight, rotation, velocity)| {
            let motor = centre * of_matrix(matrix_exponential(rotation, velocity));
            (weight, random.sign(motor))
        })
        .collect();
    let middle = moved.len() / 2;
    moved.rotate_left(middle);
    moved
}

#[test]
fn planted_means_are_found() {
    for (angle, most_steps) in [(30.0_f64, 4), (90.0, 6)] {
        for seed in 0..2000 {
            let mut random = SplitMix64(seed);
            let turned = random.within(PI);
            let centre = random.motor(turned, 10.0);
            let cloud = planted(&mut random, centre, angle.to_radians());
            let found = Motor::mean(&cloud)
                .unwrap_or_else(|error| panic!("{angle}°, seed {seed}: {error}"));
            let error = deviation(found.mean, centre);
            assert!(error < 1e-13, "{angle}°, seed {seed}: {error}");
            assert!(
                found.steps <= most_steps,
                "{angle}°, seed {seed}: {found:?}"
            );
            assert!(found.residual.angle < 1e-13 && found.residual.displacement < 1e-12);
        }
    }
}

/// Uneven clouds of motors: any number, any weights, all within an angle of some motor.
fn cloud(random: &mut SplitMix64, angle: f64) -> Vec<(f64, Motor<f64>)> {
    let turned = random.within(PI);
    let centre = random.motor(turned, 10.0);
    let count = 1 + (random.unit() * 30.0) as usize;
    let is_at_the_edge = random.unit() < 0.3;
    let mut cloud: Vec<_> = (0..count)
        .map(|_| {
            let far = if is_at_the_edge { 1.0 } else { random.unit() };
            let motor = centre * random.motor(far * angle, 5.0);
            (random.weight(), random.sign(motor))
        })
        .collect();
    cloud[0].0 += 0.1;
    cloud
}

/// The largest of rotation and displacement in the weighted mean of `log(M⁻¹ Mᵢ)`, by matrices and
/// the formulas of Rodrigues.
fn left_over(mean: Motor<f64>, cloud: &[(f64, Motor<f64>)]) -> f64 {
    let (mut sums, mut total) = ([[0.0; 3]; 2], 0.0);
    for &(weight, motor) in cloud {
        let (m, n) = (mean.to_matrix(), motor.to_matrix());
        let column = |matrix: [[f64; 4]; 3], k: usize| matrix.map(|row| row[k]);
        let dot = |a: [f64; 3], b: [f64; 3]| (0..3).map(|k| a[k] * b[k]).sum::<f64>();
        let r: [[f64; 3]; 3] =
            std::array::from_fn(|i| std::array::from_fn(|j| dot(column(m, i), column(n, j))));
        let apart = std::array::from_fn(|k| n[k][3] - m[k][3]);
        let u: [f64; 3] = std::array::from_fn(|i| dot(column(m, i), apart));
        let twice_sine = [r[2][1] - r[1][2], r[0][2] - r[2][0], r[1][0] - r[0][1]];
        let angle = length(twice_sine).atan2(r[0][0] + r[1][1] + r[2][2] - 1.0);
        let factor = if angle < 1e-9 {
            0.5
        } else {
            angle / length(twice_sine)
        };
        let rotation = twice_sine.map(|x| x * factor);
        let once = cross(rotation, u);
        let twice = cross(rotation, once);
        let change = if angle < 1e-4 {
            1.0 / 12.0
        } else {
            (1.0 - 0.5 * angle / (0.5 * angle).tan()) / (angle * angle)
        };
        for k in 0..3 {
            sums[0][k] += weight * rotation[k];
            sums[1][k] += weight * (u[k] - 0.5 * once[k] + change * twice[k]);
        }
        total += weight;
    }
    length(sums[0]).max(length(sums[1])) / total
}

#[test]
fn uneven_clouds_come_to_rest_in_few_steps() {
    for (angle, most_steps) in [(30.0_f64, 4), (60.0, 5), (90.0, 6)] {
        let mut worst = 0;
        for seed in 0..2000 {
            let cloud = cloud(&mut SplitMix64(seed), angle.to_radians());
            let found = Motor::mean(&cloud)
                .unwrap_or_else(|error| panic!("{angle}°, seed {seed}: {error}"));
            worst = worst.max(found.steps);
            let left = left_over(found.mean, &cloud);
            // Near 180° matrices determine angles less accurately.
            assert!(left < 1e-11, "{angle}°, seed {seed}: {left}");
            assert!(found.residual.angle < 1e-13 && found.residual.displacement < 1e-12);
        }
        println!("{angle}°: at most {worst} steps");
        assert!(worst <= most_steps, "{angle}°: {worst} steps");
    }
}

#[test]
fn means_are_equivariant_under_changes_of_frames() {
    for seed in 0..500 {
        let mut random = SplitMix64(seed);
        let cloud = cloud(&mut random, 80.0_f64.to_radians());
        let (before, after) = (random.motor(2.0, 3.0), random.motor(-1.0, 3.0));
        let moved: Vec<_> = cloud
            .iter()
            .map(|&(weight, motor)| (weight * 3.0, before * motor * after))
            .collect();
        let mean = Motor::mean(&cloud).unwrap().mean;
        let error = deviation(Motor::mean(&moved).unwrap().mean, before * mean * after);
        assert!(error < 1e-13, "seed {seed}: {error}");
        // The inverse motions have the inverse mean.
        let inverse: Vec<_> = cloud.iter().map(|&(w, m)| (w, m.reverse())).collect();
        let error = deviation(Motor::mean(&inverse).unwrap().mean, mean.reverse());
        assert!(error < 1e-13, "seed {seed}: {error}");
    }
}

#[test]
fn the_mean_of_two_is_on_their_screw() {
    for seed in 0..500 {
        let mut random = SplitMix64(seed);
        let (turned, angle) = (random.within(PI), random.within(3.1));
        let (from, screw) = (random.motor(turned, 5.0), random.motor(angle, 5.0));
        let share = random.unit();
        let to = from * screw;
        let mean = Motor::mean(&[(1.0 - share, from), (share, random.sign(to))]).unwrap();
        let expected = from.interpolate(to, share);
        assert!(deviation(mean.mean, expected) < 1e-13, "seed {seed}");
        let middle = Motor::blend(&[(2.0, from), (2.0, to)]).unwrap();
        assert!(
            deviation(middle, from.interpolate(to, 0.5)) < 1e-13,
            "seed {seed}"
        );
    }
}

#[test]
fn powers_of_a_screw_have_its_mean_power() {
    let screw = MotorGenerator::new(-0.1, 0.05, 0.02, 0.4, -0.3, 0.2);
    let powers = [-2.0, 0.5, 1.0, 3.5, 6.0].map(|t| (t + 3.0, (screw * t).exp()));
    let (sum, total) = powers
        .iter()
        .zip([-2.0, 0.5, 1.0, 3.5, 6.0])
        .fold((0.0, 0.0), |(sum, total), ((weight, _), t)| {
            (sum + weight * t, total + weight)
        });
    let found = Motor::mean(&powers).unwrap();
    assert_close!(found.mean, (screw * (sum / total)).exp(), 1e-14);
}

#[test]
fn translations_have_the_mean_of_their_displacements() {
    let shifts = [[1.0, 0.0, 2.0], [3.0, 4.0, -2.0], [1e6, 0.0, 0.0]];
    let weighted = [1.0, 2.0, 5.0].map(|w| w / 8.0);
    let terms: Vec<_> = weighted.into_iter().zip(shifts.map(translation)).collect();
    let expected = translation([(7.0 + 5e6) / 8.0, 1.0, -0.25]);
    assert_close!(Motor::mean(&terms).unwrap().mean, expected, 1e-15);
    assert_close!(Motor::blend(&terms).unwrap(), expected, 1e-15);
}

#[test]
fn rotors_have_the_mean_of_their_motors() {
    for seed in 0..300 {
        let mut random = SplitMix64(seed);
        let cloud = cloud(&mut random, FRAC_PI_2);
        let turns: Vec<_> = cloud.iter().map(|&(w, m)| (w, m.rotor())).collect();
        let (mean, whole) = (Rotor::mean(&turns).unwrap(), Motor::mean(&cloud).unwrap());
        assert!(
            deviation(mean.mean.into(), whole.mean.rotor().into()) < 1e-13,
            "seed {seed}"
        );
        assert_eq!(mean.residual.displacement, 0.0);
        let blend = Motor::blend(&cloud).unwrap().rotor();
        assert!(deviation(Rotor::blend(&turns).unwrap().into(), blend.into()) < 1e-14);
    }
}

#[test]
fn blends_are_normalised_sums() {
    for seed in 0..500 {
        let mut random = SplitMix64(seed);
        let cloud = cloud(&mut random, 1.0);
        let blend = Motor::blend(&cloud).unwrap();
        // The rotor part is the normalised sum of the rotor parts, by plain numbers.
        let strongest = cloud.iter().fold(0.0, |most: f64, (w, _)| most.max(*w));
        let (_, guide) = cloud.iter().find(|(w, _)| *w == strongest).unwrap();
        let rotor = |m: &Motor<f64>| [m.scalar(), m.e12(), m.e13(), m.e23()];
        let along =
            |m: &Motor<f64>| -> f64 { rotor(m).iter().zip(rotor(guide)).map(|(a, b)| a * b).sum() };
        let mut sum = [0.0; 4];
        for (weight, motor) in &cloud {
            let signed = weight * along(motor).signum();
            sum = std::array::from_fn(|k| sum[k] + signed * rotor(motor)[k]);
        }
        let size = sum.iter().map(|x| x * x).sum::<f64>().sqrt();
        assert_close!(
            rotor(&blend).to_vec(),
            sum.map(|x| x / size).to_vec(),
            1e-14
        );
        // The result is a motor: of norm 1, and the Study condition holds.
        let study = blend.scalar() * blend.e123i() - blend.e12() * blend.e3i()
            + blend.e13() * blend.e2i()
            - blend.e23() * blend.e1i();
        assert!(study.abs() < 1e-14, "seed {seed}: {study}");
    }
}

#[test]
fn signs_and_scale_of_weights_change_nothing() {
    let motors = [
        rotation([0.0, 0.0, 1.0], 0.4),
        translation([1.0, 2.0, 3.0]),
        rotation([0.6, 0.8, 0.0], -0.9),
    ];
    let plain = motors.map(|m| (1.0, m));
    let mean = Motor::mean(&plain).unwrap().mean;
    for scale in [5e-324, 1e-300, 1e300, f64::MAX] {
        let scaled = motors.map(|m| (scale, m));
        assert_eq!(Motor::mean(&scaled).unwrap().mean, mean);
    }
    // The sign is that of the first of the heaviest motors; the signs of the others do not matter.
    let [a, b, c] = motors;
    assert_eq!(
        Motor::mean(&[(1.0, a), (1.0, -b), (1.0, -c)]).unwrap().mean,
        mean
    );
    assert_eq!(
        Motor::mean(&[(1.0, -a), (1.0, -b), (1.0, c)]).unwrap().mean,
        -mean
    );
    // A motor of weight zero has no influence, even if it is opposite to the rest.
    let with_none = [
        (0.0, rotation([1.0, 0.0, 0.0], PI)),
        plain[0],
        plain[1],
        plain[2],
    ];
    assert_eq!(Motor::mean(&with_none).unwrap().mean, mean);
}

#[test]
fn one_motor_is_its_own_mean() {
    for motor in [
        translation([1e12, -3.0, 0.0]),
        rotation([0.0, 1.0, 0.0], PI),
        -translation([0.0; 3]),
    ] {
        let found = Motor::mean(&[(2.0, motor), (1.0, -motor), (1.0, motor)]).unwrap();
        assert_close!(found.mean, motor, 1e-15);
        assert!(found.steps <= 1);
        assert_eq!(Motor::blend(&[(0.3, motor)]).unwrap(), motor);
    }
}

#[test]
fn bad_input_is_named() {
    let one = Motor::<f64>::default();
    assert_eq!(Motor::<f64>::blend(&[]), Err(FitError::NoMotions));
    assert_eq!(Motor::<f64>::mean(&[]), Err(FitError::NoMotions));
    for bad in [-1.0, f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
        let Err(FitError::InvalidWeight { index, weight }) =
            Motor::blend(&[(1.0, one), (bad, one)])
        else {
            panic!("{bad} is a weight");
        };
        assert!(index == 1 && weight.to_bits() == bad.to_bits());
        let error = Motor::mean(&[(bad, one)]).unwrap_err();
        assert!(error.to_string().starts_with("weight 0 is "), "{error}");
        let coefficient = bad * f64::INFINITY;
        let lost = Motor::new_unchecked(1.0, 0.0, 0.0, 0.0, coefficient, 0.0, 0.0, 0.0);
        let named = FitError::MotionNotFinite { index: 2 };
        let motors = [(1.0, one), (1.0, one), (0.0, lost)];
        assert_eq!(Motor::blend(&motors), Err(named));
        let lost = Rotor::new_unchecked(coefficient, 0.0, 0.0, 0.0);
        let rotors = [(1.0, one.rotor()), (1.0, one.rotor()), (1.0, lost)];
        assert_eq!(Rotor::blend(&rotors), Err(named));
    }
    let none = Motor::blend(&[(0.0, one), (0.0, one)]);
    assert_eq!(none, Err(FitError::ZeroWeights));
    assert_eq!(none.unwrap_err().to_string(), "all weights are zero");
    // Displacements whose sum is beyond the range although each is within it.
    let far = translation([f64::MAX, 0.0, 0.0]);
    let far = Motor::blend(&[(1.0, far), (1.0, far), (1.0, far)]);
    assert_eq!(far, Err(FitError::OutOfRange));
}
