//! Velocities under generators and Jacobians of chains, against differences and dual numbers.

use ga_runtime::Element;
use ga_runtime::cga3::{Direction, Line, Motor, MotorGenerator, Multivector, Point};
use ga_runtime::geometry::kinematics::{Joint, jacobian, point_jacobian, pose};
use ga_runtime::scalar::Dual;
use nullcone_tests::plain::{
    cross, dense, motor_coefficients, near, near_all, near_dense, plus, unit, vector,
};
use proptest::prelude::*;

type Generator = MotorGenerator<f64>;

fn generators() -> impl Strategy<Value = Generator> + Clone {
    (vector(2.0), vector(2.0))
        .prop_map(|([a, b, c], [d, e, f])| MotorGenerator::new(a, b, c, d, e, f))
}

/// The generator with constants as dual numbers.
fn constant<const N: usize>(generator: Generator) -> MotorGenerator<Dual<f64, N>> {
    Element::map(generator, Dual::constant)
}

fn value<const N: usize>(point: Point<Dual<f64, N>>) -> [f64; 3] {
    point.coordinates().map(|x| x.value)
}

#[derive(Clone, Debug)]
enum Kind {
    Revolute([f64; 3], [f64; 3]),
    Prismatic([f64; 3]),
}

fn joints() -> impl Strategy<Value = Vec<Joint<f64>>> {
    let kind = prop_oneof![
        (vector(3.0), unit()).prop_map(|(p, d)| Kind::Revolute(p, d)),
        unit().prop_map(Kind::Prismatic),
    ];
    prop::collection::vec((kind, -3.0..3.0_f64), 4).prop_map(|joints| {
        let joint = |(kind, q)| match kind {
            Kind::Revolute(p, d) => Joint::revolute(Line::from_point_direction(p.into(), d), q),
            Kind::Prismatic(d) => Joint::prismatic(d.into(), q),
        };
        let made = |j| joint(j).expect("an axis or a direction");
        joints.into_iter().map(made).collect()
    })
}

proptest! {
    #[test]
    fn velocities_are_derivatives_of_the_motion(g in generators(), x in vector(5.0)) {
        let velocity = g.velocity_at(x.into()).vector();
        // By dual numbers, exactly: d/dt exp(t G) X ~exp(t G) at t = 0.
        let t = Dual::variable(0.0);
        let moved = (constant(g) * t).exp().transform(Point::from(x.map(Dual::constant)));
        near_all(velocity, moved.coordinates().map(|x| x.derivative()), 1e-12);
        // By differences.
        let h = 1e-5;
        let at = |t: f64| (g * t).exp().transform(Point::from(x)).coordinates();
        let (before, after) = (at(-h), at(h));
        near_all(velocity, std::array::from_fn(|k| (after[k] - before[k]) / (2.0 * h)), 1e-7);
        // ω × x + u.
        let (spin, origin) = (g.angular_velocity(), g.velocity_at(Point::default()));
        near_all(velocity, plus(cross(spin.vector(), x), origin.vector()), 1e-13);
        let again = MotorGenerator::from_velocities(spin, origin);
        prop_assert_eq!(again, g);
        // In blades: G X − X G, and its outer product with infinity.
        let (element, point) = (Multivector::from(g), Multivector::from(Point::from(x)));
        let rate = element * point - point * element;
        near_all([rate.e1, rate.e2, rate.e3], velocity, 1e-12);
        let along: f64 = (0..3).map(|k| velocity[k] * x[k]).sum();
        near(rate.ei, along, 1e-11);
        near(rate.eo, 0.0, 1e-12);
    }

    #[test]
    fn chains_move_by_their_joints(chain in joints(), x in vector(3.0), rates in prop::array::uniform4(-2.0..2.0_f64)) {
        let variables: [Dual<f64, 4>; 4] =
            Dual::variables(std::array::from_fn(|k| chain[k].coordinate));
        let moving: Vec<Joint<Dual<f64, 4>>> = (0..4)
            .map(|k| Joint { generator: constant(chain[k].generator), coordinate: variables[k] })
            .collect();
        let place = pose(&moving).transform(Point::from(x.map(Dual::constant)));
        near_all(pose(&chain).transform(Point::from(x)).coordinates(), value(place), 1e-12);
        let columns: Vec<Direction<f64>> = point_jacobian(&chain, x.into()).collect();
        prop_assert_eq!(columns.len(), 4);
        for (k, column) in columns.iter().enumerate() {
            near_all(column.vector(), place.coordinates().map(|x| x.derivatives[k]), 1e-11);
        }
        // ∂M/∂q = J M, coefficient by coefficient.
        let motor = pose(&chain);
        let derivatives = pose(&moving);
        let generators: Vec<Generator> = jacobian(&chain).collect();
        for (k, column) in generators.iter().enumerate() {
            let product = Multivector::from(*column) * Multivector::from(motor);
            let slope: Motor<f64> = Element::map(derivatives, |x: Dual<f64, 4>| x.derivatives[k]);
            near_dense(&dense(&product), &dense(&Multivector::from(slope)), 1e-11);
        }
        // The point moves with the sum of the columns, each with its rate.
        let sum = generators
            .iter()
            .zip(rates)
            .fold(Generator::default(), |sum, (column, rate)| sum + *column * rate);
        let expected = columns.iter().zip(rates).fold([0.0; 3], |sum, (column, rate)| {
            plus(sum, column.vector().map(|x| x * rate))
        });
        let found = sum.velocity_at(motor.transform(Point::from(x)));
        near_all(found.vector(), expected, 1e-11);
    }
}

#[test]
fn a_chain_without_joints_stands_still() {
    assert_eq!(
        motor_coefficients(pose::<f64>(&[])),
        motor_coefficients(Motor::<f64>::default())
    );
    assert_eq!(jacobian::<f64>(&[]).count(), 0);
    assert_eq!(point_jacobian::<f64>(&[], Point::default()).len(), 0);
}

#[test]
fn joints_need_an_axis_and_a_finite_coordinate() {
    let axis = Line::from_point_direction(Point::default(), [0.0, 0.0, 2.0]);
    let revolute = Joint::revolute(axis, 1.0).unwrap();
    near_all(
        revolute.generator.angular_velocity().vector(),
        [0.0, 0.0, 1.0],
        1e-16,
    );
    assert_eq!(Joint::revolute(Line::default(), 1.0), None);
    assert_eq!(Joint::revolute(axis, f64::NAN), None);
    assert_eq!(Joint::prismatic(Direction::default(), 1.0), None);
    let slide = Joint::prismatic(Direction::new(0.0, 4.0, 0.0), 2.0).unwrap();
    let moved = pose(&[slide]).transform(Point::new(1.0, 1.0, 1.0));
    assert_eq!(moved, Point::new(1.0, 3.0, 1.0));
}
