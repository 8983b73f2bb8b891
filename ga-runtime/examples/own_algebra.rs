//! An algebra declared by the user: that of a hexagonal crystal, whose basis vectors neither have
//! length 1 nor are orthogonal.
//!
//! The metric is part of the declaration, and all products follow it: lengths, angles and rotations
//! are right in the coordinates that crystallographers use. The crystal is the hexagonal closest
//! packing of balls, which the crystals of magnesium and zinc resemble.
//!
//! Run it with `cargo run -p ga-runtime --example own_algebra`.

ga_runtime::algebra! {
    /// Space with the axes of a hexagonal crystal: a and b of length 1 at an angle of 120°, c of
    /// length √(8/3) perpendicular to both.
    mod hexagonal {
        basis a, b, c;
        metric a*a = 1, b*b = 1, c*c = 8/3, a*b = -1/2;

        /// A vector in crystal coordinates.
        struct Vector { a, b, c }
        /// An oriented area.
        struct Bivector { ab, ac, bc }
        /// An oriented volume.
        struct Volume { abc }
        /// Products of two vectors.
        struct Even { scalar, ab, ac, bc }
        /// A rotation about an atom.
        #[hull(Even)]
        #[facts(unit_versor)]
        struct Rotor { scalar, ab, ac, bc }

        products {
            left_contraction(Vector, Vector) -> Scalar;
            wedge(Vector, Vector);
            wedge(Vector, Bivector);
            geometric(Vector, Vector) -> Even;
            geometric(Rotor, Rotor) -> Rotor;
            sandwich(Rotor, Vector) -> Self;
        }
    }
}
use hexagonal::{Rotor, Vector};

ga_runtime::ga! { hexagonal;
    /// A function in the new algebra, with its metric.
    fn squared_length(v: Vector) -> Scalar { v | v }

    /// The volume that three vectors span.
    fn volume(u: Vector, v: Vector, w: Vector) -> Scalar { norm(u ^ v ^ w) }
}

/// The atoms near the one at the origin, without that one. A cell contains two atoms.
fn atoms() -> Vec<Vector<f64>> {
    let mut atoms = Vec::new();
    let second = Vector::new(2.0 / 3.0, 1.0 / 3.0, 0.5);
    for a in -3..=3 {
        for b in -3..=3 {
            for c in -2..=2 {
                let corner = Vector::new(f64::from(a), f64::from(b), f64::from(c));
                atoms.extend([corner, corner + second]);
            }
        }
    }
    atoms.retain(|&atom| squared_length(atom) > 0.0);
    atoms
}

fn main() {
    let atoms = atoms();

    // The numbers of atoms by squared distance. Those of the closest packing are known: 12, 6, 2,
    // 18, 12.
    let shells = [
        (1.0, 12),
        (2.0, 6),
        (8.0 / 3.0, 2),
        (3.0, 18),
        (11.0 / 3.0, 12),
    ];
    println!("distance  atoms");
    for (square, expected) in shells {
        let at_distance = |atom: &&Vector<f64>| (squared_length(**atom) - square).abs() < 1e-12;
        let count = atoms.iter().filter(at_distance).count();
        println!("{:8.4}  {count:5}", f64::sqrt(square));
        assert_eq!(count, expected);
    }

    // Balls of diameter 1, two in each cell, fill π/√18 of space.
    let cell = volume(
        Vector::new(1.0, 0.0, 0.0),
        Vector::new(0.0, 1.0, 0.0),
        Vector::new(0.0, 0.0, 1.0),
    );
    let filled = 2.0 * std::f64::consts::PI / 6.0 / cell;
    println!("{:.2} % of space is filled", 100.0 * filled);
    assert!((filled - std::f64::consts::PI / 18.0_f64.sqrt()).abs() < 1e-12);

    // The product of two unit vectors rotates by twice the angle between them. That of a and a + b
    // is 60°.
    let a = Vector::new(1.0, 0.0, 0.0);
    let third = Rotor::normalize(Vector::new(1.0, 1.0, 0.0) * a).expect("the product is not zero");
    println!("a rotation by 120°: {third:.4}");
    // Three of them are a rotation by 360°, whose rotor is −1.
    let whole: Rotor<f64> = third * third * third;
    assert!((whole.scalar() + 1.0).abs() < 1e-12);

    // The rotation maps the crystal to itself: every neighbour is moved to the place of a
    // neighbour.
    let near = |v: Vector<f64>| squared_length(v) < 1.0 + 1e-12;
    let neighbours: Vec<_> = atoms.iter().copied().filter(|&atom| near(atom)).collect();
    for &atom in &neighbours {
        let rotated = third.transform(atom);
        let is_there = |other: &Vector<f64>| squared_length(*other - rotated) < 1e-20;
        assert!(
            neighbours.iter().any(is_there),
            "{rotated} is not a neighbour"
        );
    }
    println!("it permutes the {} neighbours", neighbours.len());
}

#[test]
fn it_runs() {
    main();
}
