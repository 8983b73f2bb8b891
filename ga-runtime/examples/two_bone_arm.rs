//! Inverse kinematics of an arm with two bones: where is the elbow when the hand is at a given
//! place?
//!
//! The elbow is on a sphere around the shoulder and on another around the hand. The two meet in a
//! circle, and the plane in which the arm bends meets that circle in two points. This takes a few
//! products and no trigonometry.
//!
//! Run it with `cargo run -p ga-runtime --example two_bone_arm`.

use ga_runtime::cga3::{Circle, Motor, Plane, Point, PointPair, Rotor, Sphere, Translator};

struct Arm {
    shoulder: Point<f64>,
    upper: f64,
    lower: f64,
}

impl Arm {
    /// The place of the elbow when the hand is at a target, on the side of the pole; `None` where
    /// the target is out of reach.
    fn elbow(&self, target: Point<f64>, pole: Point<f64>) -> Option<Point<f64>> {
        let around_shoulder = Sphere::from_centre_radius(self.shoulder, self.upper);
        let around_hand = Sphere::from_centre_radius(target, self.lower);
        // `&` is the meet.
        let candidates: Circle<f64> = around_shoulder & around_hand;
        let bending = Plane::through(self.shoulder, target, pole);
        let two: PointPair<f64> = candidates & bending;
        // Spheres that do not meet have an imaginary circle in common, which has no real points.
        let [p, q] = two.endpoints()?;
        Some(if p.distance(pole) < q.distance(pole) {
            p
        } else {
            q
        })
    }
}

fn main() {
    let arm = Arm {
        shoulder: Point::new(0.0, 0.0, 1.5),
        upper: 0.35,
        lower: 0.25,
    };
    // Elbows bend down and backwards.
    let pole = Point::new(-1.0, 0.2, 0.5);

    println!("       target              elbow        bend at the elbow");
    for step in 0..7 {
        // The hand moves along a line that begins within reach.
        let target = Point::new(0.15 + 0.1 * f64::from(step), 0.1, 1.4);
        let [x, y, z] = target.coordinates();
        print!("{x:6.2} {y:5.2} {z:5.2}   ");

        let distance = arm.shoulder.distance(target);
        let Some(elbow) = arm.elbow(target, pole) else {
            println!("{distance:.3} away: out of reach");
            assert!(distance > arm.upper + arm.lower);
            continue;
        };

        // The motors of the bones. At rest both lie along the x axis, the upper one with its end at
        // the origin.
        let along_upper = arm.shoulder.vector_to(elbow).coordinates();
        let along_lower = elbow.vector_to(target).coordinates();
        let at_shoulder =
            Rotor::between([1.0, 0.0, 0.0], along_upper).expect("the bone has a length");
        let at_elbow = Rotor::between(along_upper, along_lower).expect("the bone has a length");
        let upper: Motor<f64> =
            Translator::from_displacement(arm.shoulder.coordinates()) * at_shoulder;
        // The lower bone follows the upper one and then rotates about the elbow.
        let lower = Motor::about(elbow, at_elbow) * upper;

        let (_, bend) = at_elbow.to_axis_angle();
        let [x, y, z] = elbow.coordinates();
        println!("{x:6.3} {y:6.3} {z:6.3}   {:6.1}°", bend.to_degrees());

        // The motors bring the ends of the bones to the elbow and to the target, …
        let ends = [
            (upper, arm.upper, elbow),
            (lower, arm.upper + arm.lower, target),
        ];
        for (motor, at_rest, expected) in ends {
            let end = motor.transform(Point::new(at_rest, 0.0, 0.0));
            assert!(end.distance(expected) < 1e-12);
        }
        // … and the bend satisfies the law of cosines.
        let product = 2.0 * arm.upper * arm.lower * bend.cos();
        let squared = arm.upper.powi(2) + arm.lower.powi(2) + product;
        assert!((distance.powi(2) - squared).abs() < 1e-12);
    }
}

#[test]
fn it_runs() {
    main();
}
