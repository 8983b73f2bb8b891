//! Automatic derivatives: at what time does a point that moves along a screw reach a sphere?
//!
//! The depth of the point in the sphere is one function of time that is generic over its scalar.
//! Called with dual numbers it also gives the derivative, which Newton's method needs.
//!
//! Run it with `cargo run -p ga-runtime --example derivatives`.

use ga_runtime::cga3::{DualSphere, Motor, MotorGenerator, Point};
use ga_runtime::scalar::{Dual, Real};

ga_runtime::ga! { ga_runtime::cga3;
    /// The inner product of the moved point and a dual sphere: `½(r² − d²)` for a point at the
    /// distance d from the centre, which is zero on the sphere.
    fn inside(motor: Motor, point: Point, sphere: DualSphere) -> Scalar {
        (motor * point * reverse(motor)) | sphere
    }
}

const START: [f64; 3] = [2.0, 0.0, 0.0];
const CENTRE: [f64; 3] = [-2.0, 0.5, 1.5];
const RADIUS: f64 = 1.0;
/// In each second the screw rotates by RATE radians about the z axis and advances by SPEED along
/// it.
const RATE: f64 = 0.8;
const SPEED: f64 = 0.4;

/// The motion up to a time t: the exponential of t times the generator
/// `−½ RATE e12 − ½ SPEED e3∧ei`.
fn motion<S: Real<Mask = bool>>(time: S) -> Motor<S> {
    let [angle, advance] = [RATE, SPEED].map(|x| time * S::from_f64(-0.5 * x));
    let zero = S::zero();
    MotorGenerator::new(angle, zero, zero, zero, zero, advance).exp()
}

/// A measure of how far inside the sphere the point is at a time. The code does not mention
/// derivatives.
fn depth<S: Real<Mask = bool>>(time: S) -> S {
    let point = Point::from(START.map(S::from_f64));
    let centre = Point::from(CENTRE.map(S::from_f64));
    let sphere: DualSphere<S> = DualSphere::from_centre_radius(centre, S::from_f64(RADIUS));
    inside(motion(time), point, sphere)
}

fn main() {
    let mut time = 2.5;
    println!("step      time           depth       its derivative");
    for step in 0..8 {
        // A variable has the derivative 1; everything computed from it has its own derivative.
        let depth = depth(Dual::variable(time));
        println!(
            "{step:4}  {time:.12}  {:12.3e}  {:10.6}",
            depth.value,
            depth.derivative()
        );

        // The derivative in coordinates: with the centre c and the velocity ω × x + v of the point
        // x, it is (c − x)·(ω × x + v).
        let [x, y, z] = motion(time).transform(Point::from(START)).coordinates();
        let velocity = [-RATE * y, RATE * x, SPEED];
        let by_hand: f64 = (0..3)
            .map(|k| (CENTRE[k] - [x, y, z][k]) * velocity[k])
            .sum();
        assert!((depth.derivative() - by_hand).abs() < 1e-12);

        if depth.value.abs() < 1e-14 {
            break;
        }
        time -= depth.value / depth.derivative();
    }

    let place = motion(time).transform(Point::from(START));
    println!(
        "after {time:.6} seconds the point is on the sphere, at {:.6?}",
        place.coordinates()
    );
    assert!((place.distance(Point::from(CENTRE)) - RADIUS).abs() < 1e-12);
}

#[test]
fn it_runs() {
    main();
}
