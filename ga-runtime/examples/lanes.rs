//! Eight drops of rain at once: the same code on one number and on eight numbers side by side.
//!
//! A function that is generic over its scalar runs on `Lanes<f32, 8>` as it does on `f32`, and the
//! compiler makes each operation a vector instruction. The code cannot branch, since lanes may
//! differ: it computes both outcomes and then selects.
//!
//! Run it with `cargo run -p ga-runtime --example lanes`.

use ga_runtime::cga3::{Direction, DualPlane, Point};
use ga_runtime::scalar::{Lanes, Real};

ga_runtime::ga! { ga_runtime::cga3;
    /// The height above a plane with a normal of length 1.
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

/// The fall during one hundredth of a second. A drop that is below the roof and moves towards it
/// is reflected.
fn step<S: Real>(drop: Drop<S>) -> Drop<S> {
    let (time, gravity) = (S::from_f64(0.01), S::from_f64(9.81));
    let [vx, vy, vz] = drop.velocity.vector();
    let falling = Direction::from_vector([vx, vy, vz - gravity * time]);

    // Both outcomes are computed, and the mask selects: one bool for one drop, eight for eight.
    let bounced = reflected(falling, roof());
    let below = height(drop.place, roof()).less_than(S::zero());
    let approaching = speed_away(falling).less_than(S::zero());
    let hit = below & approaching;
    let (old, new) = (falling.vector(), bounced.vector());
    let velocity = [0, 1, 2].map(|k| S::select(hit, new[k], old[k]));

    let place = drop.place.coordinates();
    Drop {
        place: Point::from([0, 1, 2].map(|k| velocity[k].mul_add(time, place[k]))),
        velocity: Direction::from_vector(velocity),
    }
}

/// The speed at which a velocity leads away from the roof.
fn speed_away<S: Real>(velocity: Direction<S>) -> S {
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
    println!("heights of eight drops above the roof, in metres");
    for count in 0..=STEPS {
        if count % 10 == 0 {
            let heights = height(eight.place, roof());
            println!("{:.1} s  {heights:6.3}", count as f32 / 100.0);
        }
        eight = step(eight);
    }

    // The same drops one by one give the same results to the last bit.
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
    println!("each drop is where it is when it falls alone");
}

#[test]
fn it_runs() {
    main();
}
