//! An algebra of one's own: that of a hexagonal crystal, whose basis vectors are neither of length
//! 1 nor at right angles.
//!
//! The metric goes into the declaration, and from then on nobody has to think of it: lengths,
//! angles and rotations come out right in the coordinates that crystallographers use. The crystal
//! is the closest packing of balls that magnesium and zinc resemble.
//!
//! Run it with `cargo run -p ga-runtime --example own_algebra`.

ga_runtime::algebra! {
    /// Space with the axes of a hexagonal crystal: a and b of length 1 at 120°, c of length √(8/3)
    /// across both.
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
        /// A turn about an atom.
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
    /// A function compiled in the new algebra, metric included.
    fn squared_length(v: Vector) -> Scalar { v | v }

    /// The volume that three vectors span.
    fn volume(u: Vector, v: Vector, w: Vector) -> Scalar { norm(u ^ v ^ w) }
}

/// All other atoms up to two cells away from the one at the origin. A cell holds two.
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

    // How many atoms are at which distance. The shells of the closest packing are known: 12, 6, 2,
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

    // Balls of diameter 1, two to a cell, fill π/√18 of space.
    let cell = volume(
        Vector::new(1.0, 0.0, 0.0),
        Vector::new(0.0, 1.0, 0.0),
        Vector::new(0.0, 0.0, 1.0),
    );
    let filled = 2.0 * std::f64::consts::PI / 6.0 / cell;
    println!("{:.2} % of space is filled", 100.0 * filled);
    assert!((filled - std::f64::consts::PI / 18.0_f64.sqrt()).abs() < 1e-12);

    // The product of two unit vectors turns by twice the angle between them: a and a + b are 60°
    // apart.
    let a = Vector::new(1.0, 0.0, 0.0);
    let third = Rotor::normalize(Vector::new(1.0, 1.0, 0.0) * a).expect("the product is not zero");
    println!("a third of a turn: {third:.4}");
    // Three of them are a whole turn, and the rotor of that is −1.
    let whole: Rotor<f64> = third * third * third;
    assert!((whole.scalar() + 1.0).abs() < 1e-12);

    // It takes the crystal to itself: every neighbour comes to the place of a neighbour.
    let near = |v: Vector<f64>| squared_length(v) < 1.0 + 1e-12;
    let neighbours: Vec<_> = atoms.iter().copied().filter(|&atom| near(atom)).collect();
    for &atom in &neighbours {
        let turned = third.transform(atom);
        let is_there = |other: &Vector<f64>| squared_length(*other - turned) < 1e-20;
        assert!(neighbours.iter().any(is_there), "{turned} is no neighbour");
    }
    println!("it takes the {} neighbours to each other", neighbours.len());
}

#[test]
fn it_runs() {
    main();
}
