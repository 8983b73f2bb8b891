//! Batches are bit-identical to the same operations on single elements, for every length and every
//! instruction set.

use ga_runtime::batch::{self, Batch, BatchError, InstructionSet, LengthMismatch, Moved};
use ga_runtime::cga3::{
    Circle, Direction, DualPlane, FlatPoint, Line, Motor, Plane, Point, PointPair, Rotor,
    RoundVector, Sphere, Translator,
};
use ga_runtime::scalar::{Field, Real};
use ga_runtime::testing::{assert_close, member};
use ga_runtime::{Element, ga};
use proptest::prelude::*;
use proptest::strategy::ValueTree;
use proptest::test_runner::TestRunner;

const INSTRUCTION_SETS: [InstructionSet; 3] = [
    InstructionSet::Baseline,
    InstructionSet::Avx2,
    InstructionSet::Avx512,
];

/// Reproducible members of a type.
fn members<T>(count: usize) -> Vec<T>
where
    T: Element + std::fmt::Debug,
    T::Scalar: Real + Field + From<f32>,
{
    let mut runner = TestRunner::deterministic();
    let numbers = (-0.9_f32..0.9).prop_map(T::Scalar::from);
    let strategy = member::<T>(numbers);
    (0..count)
        .map(|_| strategy.new_tree(&mut runner).expect("a member").current())
        .collect()
}

fn check_moved<S, X>()
where
    S: Real<Mask = bool> + From<f32> + std::fmt::Debug,
    X: Moved<S> + Element<Scalar = S> + PartialEq + std::fmt::Debug,
    Motor<S>: Element<Scalar = S>,
    Motor<S>: ga_runtime::products::Sandwich<X, Output = X>,
{
    let (motors, elements) = (members::<Motor<S>>(42), members::<X>(41));
    let motor = motors[41];
    for length in 0..=40 {
        let (motors, elements) = (&motors[..length], &elements[..length]);
        let each: Vec<X> = motors
            .iter()
            .zip(elements)
            .map(|(m, x)| m.transform(*x))
            .collect();
        let mut by_baseline = None;
        for set in INSTRUCTION_SETS {
            let batch = Batch::on(set);
            let mut moved = vec![elements.first().copied(); length]
                .into_iter()
                .flatten()
                .collect::<Vec<_>>();
            batch
                .transform_each(motors, elements, &mut moved)
                .expect("one length");
            assert_eq!(moved, each, "{set:?}, {length} elements");
            // A single motor is applied as a linear map, which rounds in another order than the
            // product does.
            batch
                .transform_into(&motor, elements, &mut moved)
                .expect("one length");
            let mut in_place = elements.to_vec();
            batch.transform(&motor, &mut in_place);
            assert_eq!(in_place, moved, "{set:?}, {length} elements");
            assert_eq!(
                *by_baseline.get_or_insert_with(|| moved.clone()),
                moved,
                "{length} elements"
            );
            for (moved, element) in moved.iter().zip(elements) {
                let alone = motor.transform(*element);
                for blade in X::BLADES {
                    let size = X::BLADES
                        .iter()
                        .fold(S::one(), |size, b| size.max(element.coefficient(*b).abs()));
                    let difference = (moved.coefficient(*blade) - alone.coefficient(*blade)).abs();
                    let most = S::from_integer(64) * S::epsilon() * size;
                    assert!(!most.less_than(difference), "{moved:?} and {alone:?}");
                }
            }
        }
    }
}

#[test]
fn everything_moves_alike_alone_and_in_batches() {
    macro_rules! check {
        ($($type:ident),*) => { $( check_moved::<f32, $type<f32>>(); check_moved::<f64, $type<f64>>(); )* };
    }
    check!(
        Point,
        RoundVector,
        DualPlane,
        Direction,
        FlatPoint,
        Line,
        Plane,
        Sphere,
        Circle,
        PointPair
    );
}

fn check_motors<S>()
where
    S: Real<Mask = bool> + From<f32> + std::fmt::Debug,
    Motor<S>: Element<Scalar = S> + PartialEq + std::fmt::Debug,
{
    let motors = members::<Motor<S>>(40);
    let other: Vec<_> = motors.iter().rev().copied().collect();
    for length in 0..=40 {
        let (left, right) = (&motors[..length], &other[..length]);
        for set in INSTRUCTION_SETS {
            let batch = Batch::on(set);
            let mut products = vec![Motor::default(); length];
            batch
                .compose(left, right, &mut products)
                .expect("one length");
            let alone: Vec<_> = left.iter().zip(right).map(|(a, b)| *a * *b).collect();
            assert_eq!(products, alone);
            let mut generators = vec![Motor::default().log(); length];
            batch.log(left, &mut generators).expect("one length");
            let alone: Vec<_> = left.iter().map(|m| m.log()).collect();
            assert_eq!(generators, alone);
            batch.exp(&generators, &mut products).expect("one length");
            let alone: Vec<_> = generators.iter().map(|g| g.exp()).collect();
            assert_eq!(products, alone);
        }
    }
}

#[test]
fn motors_compose_alike_alone_and_in_batches() {
    check_motors::<f32>();
    check_motors::<f64>();
}

ga! { ga_runtime::cga3;
    /// The linear blend of two motors.
    fn mean(a: Motor, b: Motor, s: Scalar, t: Scalar) -> Motor { normalize(s * a + t * b) }
}

#[test]
fn blends_are_normalised_sums_the_short_way() {
    let palette = members::<Motor<f64>>(16);
    let dot = |a: &Motor<f64>, b: &Motor<f64>| {
        a.scalar() * b.scalar() + a.e12() * b.e12() + a.e13() * b.e13() + a.e23() * b.e23()
    };
    for (i, a) in palette.iter().enumerate() {
        for (j, b) in palette.iter().enumerate() {
            let mut found = [Motor::default()];
            batch::blend(&palette, &[[(i, 0.25), (j, 0.75)]], &mut found).expect("a mean");
            let sign = if dot(a, b) < 0.0 { -1.0 } else { 1.0 };
            assert_close!(found[0], mean(*a, *b, sign * 0.25, 0.75), 1e-13);
        }
    }
}

#[test]
fn every_blend_has_the_sign_of_the_heaviest() {
    let about = |angle: f64| {
        let rotor = Rotor::from_axis_angle([0.0, 0.0, 1.0], angle).expect("an axis");
        Translator::from_displacement([angle, 0.0, 2.0]) * rotor
    };
    // The second motor decides the sign: it is the first of those with the largest weight.
    for weights in [[0.2, 0.5, 0.3], [0.1, 0.45, 0.45]] {
        for signs in [
            [1.0, 1.0, 1.0],
            [-1.0, 1.0, 1.0],
            [1.0, -1.0, 1.0],
            [1.0, -1.0, -1.0],
        ] {
            let motors: Vec<_> = [0.3, 0.5, 1.0]
                .iter()
                .zip(signs)
                .map(|(&angle, sign)| {
                    if sign < 0.0 {
                        -about(angle)
                    } else {
                        about(angle)
                    }
                })
                .collect();
            let weighted: Vec<_> = weights.into_iter().zip(motors.iter().copied()).collect();
            let influences = [0, 1, 2].map(|k| (k, weights[k]));
            let mut batched = [Motor::default()];
            batch::blend(&motors, &[influences], &mut batched).expect("a mean");
            let found = [
                Motor::blend(&weighted).expect("a mean"),
                Motor::blend_influences(weighted).expect("a mean"),
                batched[0],
            ];
            // The half angle of the sum lies between those of its terms, where its cosine is
            // positive: a negative scalar shows the sign of the heaviest motor.
            for motor in found {
                assert!(
                    motor.scalar() * signs[1] > 0.0,
                    "{weights:?} {signs:?} {motor:?}"
                );
                assert!((motor.scalar().abs() - 0.3_f64.cos()).abs() < 0.05);
                assert_close!(motor, found[0], 1e-14);
            }
        }
    }
    assert_eq!(Motor::<f64>::blend_influences([]), None);
}

#[test]
fn errors_say_what_is_wrong() {
    let motors = [Motor::<f64>::default(); 3];
    let points = [Point::default(); 2];
    let mut moved = [Point::new(7.0, 7.0, 7.0); 3];
    let mismatch = LengthMismatch {
        expected: 3,
        found: 2,
    };
    assert_eq!(
        batch::transform_each(&motors, &points, &mut moved),
        Err(mismatch)
    );
    assert_eq!(moved, [Point::new(7.0, 7.0, 7.0); 3]);
    assert_eq!(
        mismatch.to_string(),
        "a slice has 2 elements where 3 are needed"
    );
    let mut means = [Motor::default(); 1];
    assert_eq!(
        batch::blend(&motors, &[[(3, 1.0)]], &mut means),
        Err(BatchError::NotInPalette {
            element: 0,
            place: 3,
            palette: 3
        })
    );
    // An influence of weight zero may name any motor.
    assert_eq!(
        batch::blend(&motors, &[[(0, 1.0), (9, 0.0)]], &mut means),
        Ok(())
    );
    for weight in [0.0, f64::NAN, f64::INFINITY] {
        let error = batch::blend(&motors, &[[(0, weight)]], &mut means).expect_err("no mean");
        assert_eq!(error, BatchError::NoDirection { element: 0 }, "{weight}");
    }
    assert_eq!(
        batch::log(&motors, &mut []).expect_err("no room"),
        LengthMismatch {
            expected: 3,
            found: 0
        }
    );
}

#[test]
fn infinities_and_nan_are_propagated() {
    let motor = Motor::from(Translator::from_displacement([1.0, 0.0, 0.0]));
    for set in INSTRUCTION_SETS {
        let mut points = vec![Point::new(0.0, 0.0, 0.0); 9];
        points[4] = Point::new(f64::NAN, 0.0, 0.0);
        points[5] = Point::new(0.0, f64::INFINITY, 0.0);
        Batch::on(set).transform(&motor, &mut points);
        assert!(points[4].e1().is_nan());
        assert!(!points[5].e2().is_finite());
        for place in [0, 3, 6, 8] {
            assert_eq!(points[place].coordinates(), [1.0, 0.0, 0.0]);
        }
    }
}

#[test]
fn instruction_sets_are_those_of_the_processor() {
    assert!(InstructionSet::Baseline.is_available() && InstructionSet::best().is_available());
    let set = Batch::on(InstructionSet::Avx2).instruction_set();
    assert_eq!(
        set == InstructionSet::Avx2,
        InstructionSet::Avx2.is_available()
    );
}
