//! Eight drops of rain at once: the same code on one number and on eight side by side.
//!
//! A function that is generic over its scalar runs on `Lanes<f32, 8>` as it does on `f32`, and the
//! compiler turns each operation into a vector instruction. The one thing to give up is the branch,
//! since lanes may differ: compute both outcomes, then select.
//!
//! Run it with `cargo run -p ga-runtime --example lanes`.

use ga_runtime::cga3::{Direction, DualPlane, Point};
use ga_runtime::scalar::{Lanes, Real};

ga_runtime::ga! { ga_runtime::cga3;
    /// The height over a plane with a normal of length 1.
    fn height(point: Point, roof: DualPlane) -> Scalar { point | roof }

    /// A velocity reflected in a plane.
    fn reflected(velocity: Direction, roof: DualPlane) -> Direction { sandwich(roof, velocity) }
}

#[derive(Clone, Copy)]
struct Drop<S> {
    place: Point<S>,
    velocity: Direction<S>,
}

/// The roof slopes down along x: its normal is (0.6, 0, 0.8).
fn roof<S: Real>() -> DualPlane<S> {
    DualPlane::from_normal_distance([0.6, 0.0, 0.8].map(S::from_f64), S::zero())
}

/// One hundredth of a second of falling. A drop that has come through the roof while going down
/// jumps off.
fn step<S: Real>(drop: Drop<S>) -> Drop<S> {
    let (time, gravity) = (S::from_f64(0.01), S::from_f64(9.81));
    let [vx, vy, vz] = drop.velocity.vector();
    let falling = Direction::from_vector([vx, vy, vz - gravity * time]);

    // Both outcomes are worked out, and the mask chooses: a bool for one drop, eight of them for
    // eight.
    let bounced = reflected(falling, roof());
    let below = height(drop.place, roof()).less_than(S::zero());
    let approaching = bounced_height(falling).less_than(S::zero());
    let hit = below & approaching;
    let (old, new) = (falling.vector(), bounced.vector());
    let velocity = [0, 1, 2].map(|k| S::select(hit, new[k], old[k]));

    let place = drop.place.coordinates();
    Drop {
        place: Point::from([0, 1, 2].map(|k| velocity[k].mul_add(time, place[k]))),
        velocity: Direction::from_vector(velocity),
    }
}

/// How fast a velocity leads away from the roof.
fn bounced_height<S: Real>(velocity: Direction<S>) -> S {
    height(Point::from(velocity.vector()), roof())
}

fn start(lane: usize) -> [f32; 3] {
    [0.0, lane as f32, 1.0 + 0.25 * lane as f32]
}

fn main() {
    const STEPS: usize = 60;
    let still = Direction::from_vector([0.0; 3].map(Lanes::splat));
    let places = [0, 1, 2].map(|k| Lanes::from_array(std::array::from_fn(|lane| start(lane)[k])));
    let mut eight: Drop<Lanes<f32, 8>> = Drop {
        place: Point::from(places),
        velocity: still,
    };
    println!("heights of eight drops over the roof, in metres");
    for count in 0..=STEPS {
        if count % 10 == 0 {
            let heights = height(eight.place, roof());
            println!("{:.1} s  {heights:6.3}", count as f32 / 100.0);
        }
        eight = step(eight);
    }

    // The same drops, one by one: not nearly the same, but the same bits.
    for lane in 0..8 {
        let mut one = Drop {
            place: Point::from(start(lane)),
            velocity: Direction::from_vector([0.0; 3]),
        };
        for _ in 0..=STEPS {
            one = step(one);
        }
        assert_eq!(
            one.place.coordinates(),
            eight.place.coordinates().map(|x| x[lane])
        );
    }
    println!("each is where it is when it falls alone");
}

#[test]
fn it_runs() {
    main();
}
