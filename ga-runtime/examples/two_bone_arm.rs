//! Inverse kinematics of an arm with two bones: where is the elbow when the hand is to be at a given place?
//!
//! The elbow is on a sphere around the shoulder and on another around the hand. The two meet in a circle, and the plane in which the arm
//! is to bend meets that circle in two points. Three products, no trigonometry.
//!
//! Run it with `cargo run -p ga-runtime --example two_bone_arm`.

use ga_runtime::cga3::{Circle, Motor, Plane, Point, PointPair, Rotor, Sphere, Translator};

struct Arm {
    shoulder: Point<f64>,
    upper: f64,
    lower: f64,
}

impl Arm {
    /// The elbow with the hand at a target, on the side of the pole; `None` where the target is out of reach.
    fn elbow(&self, target: Point<f64>, pole: Point<f64>) -> Option<Point<f64>> {
        let around_shoulder = Sphere::from_centre_radius(self.shoulder, self.upper);
        let around_hand = Sphere::from_centre_radius(target, self.lower);
        // `&` is the meet.
        let candidates: Circle<f64> = around_shoulder & around_hand;
        let bending = Plane::through(self.shoulder, target, pole);
        let two: PointPair<f64> = candidates & bending;
        // Spheres that do not touch meet in an imaginary circle, and that has no points to give.
        let [p, q] = two.endpoints()?;
        Some(if p.distance(pole) < q.distance(pole) {
            p
        } else {
            q
        })
    }
}

/// The motion that takes a bone from its rest, along the x axis from the origin, to a joint and a direction.
fn pose(joint: Point<f64>, end: Point<f64>) -> Option<Motor<f64>> {
    let ([x, y, z], [u, v, w]) = (joint.coordinates(), end.coordinates());
    let turn = Rotor::between([1.0, 0.0, 0.0], [u - x, v - y, w - z])?;
    Some(Translator::from_displacement([x, y, z]) * turn)
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
        // The hand goes along a line, at first within reach.
        let t = f64::from(step);
        let target = Point::new(0.15 + 0.1 * t, 0.1, 1.4);
        let [x, y, z] = target.coordinates();
        print!("{x:6.2} {y:5.2} {z:5.2}   ");

        let distance = arm.shoulder.distance(target);
        let Some(elbow) = arm.elbow(target, pole) else {
            println!("{distance:.3} away: out of reach");
            assert!(distance > arm.upper + arm.lower);
            continue;
        };
        let bones = [(arm.shoulder, elbow), (elbow, target)].map(|(from, to)| pose(from, to));
        let [Some(upper), Some(lower)] = bones else {
            panic!("a bone has no direction")
        };
        // The angle between the bones, from the turn that leads from one to the other.
        let (_, bend) = (upper.reverse() * lower).rotor().to_axis_angle();
        let [x, y, z] = elbow.coordinates();
        println!("{x:6.3} {y:6.3} {z:6.3}   {:6.1}°", bend.to_degrees());

        // The bones are as long as before, and the hand is where it should be.
        assert!((arm.shoulder.distance(elbow) - arm.upper).abs() < 1e-12);
        let hand = lower.transform(Point::new(arm.lower, 0.0, 0.0));
        assert!(hand.distance(target) < 1e-12);
        // The law of cosines gives the same distance from the shoulder.
        let squares = arm.upper.powi(2) + arm.lower.powi(2);
        let between = direction_cosine(upper, lower);
        assert!((distance.powi(2) - squares - 2.0 * arm.upper * arm.lower * between).abs() < 1e-12);
    }
}

/// The cosine of the angle between two bones, from their directions.
fn direction_cosine(a: Motor<f64>, b: Motor<f64>) -> f64 {
    let [a, b] = [a, b].map(|motor| {
        motor
            .rotor()
            .transform(Point::new(1.0, 0.0, 0.0))
            .coordinates()
    });
    a.iter().zip(b).map(|(x, y)| x * y).sum()
}
