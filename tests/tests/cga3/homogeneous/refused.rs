//! Matrices and numbers that stand for nothing: what is said of them.

use ga_runtime::cga3::{Dilator, Motor, Point, Rotor, Similarity, Translator};
use ga_runtime::geometry::homogeneous::{
    product, rotation, rotation_about_axis, rotation_about_x, rotation_about_y, rotation_about_z,
    scaling, transform, translation,
};
use ga_runtime::geometry::{Affine, NotConformal};

#[test]
fn numbers_that_are_not_finite_give_none() {
    for odd in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
        assert_eq!(rotation_about_x(odd), None);
        assert_eq!(rotation_about_y(odd), None);
        assert_eq!(rotation_about_z(odd), None);
        assert_eq!(Rotor::about_x(odd), None);
        assert_eq!(Rotor::about_y(odd), None);
        assert_eq!(Rotor::about_z(odd), None);
        assert_eq!(rotation([0.0, odd, 1.0], 1.0), None);
        assert_eq!(rotation([0.0, 0.0, 1.0], odd), None);
        let (there, far) = (Point::new(1.0, 2.0, 3.0), Point::new(1.0, odd, 3.0));
        assert_eq!(rotation_about_axis(far, [0.0, 0.0, 1.0], 1.0), None);
        assert_eq!(rotation_about_axis(there, [0.0, 0.0, 1.0], odd), None);
        assert_eq!(Motor::about_axis(far, [0.0, 0.0, 1.0], 1.0), None);
        assert_eq!(Motor::about_axis(there, [0.0, 0.0, 1.0], odd), None);
        assert_eq!(transform(translation([odd, 0.0, 0.0]), there), None);
        for place in 0..16 {
            let mut matrix = translation([1.0, 2.0, 3.0]);
            matrix[place / 4][place % 4] = odd;
            assert_eq!(
                Motor::from_homogeneous(matrix),
                Err(NotConformal::NotFinite)
            );
            assert_eq!(
                Affine::from_homogeneous(matrix),
                Err(NotConformal::NotFinite)
            );
        }
        // A map may be constructed from any numbers.
        let map = Affine::from_translation([0.0, odd, 0.0]);
        assert_eq!(Motor::try_from(map), Err(NotConformal::NotFinite));
        assert_eq!(
            Similarity::try_from(Affine::scaling([odd; 3])),
            Err(NotConformal::NotFinite)
        );
    }
    assert_eq!(rotation([0.0; 3], 1.0), None);
    assert_eq!(
        Motor::about_axis(Point::new(1.0, 2.0, 3.0), [0.0; 3], 1.0),
        None
    );
}

#[test]
fn matrices_of_something_else_say_what_they_are() {
    use NotConformal::{Mirrors, Projective, Rotates, Scales, Shears, Singular, Translates};
    let turn = rotation([1.0, 2.0, 3.0], 0.5).unwrap();
    let shift = translation([0.0, 1e-300, 0.0]);
    let double = scaling([2.0; 3]);
    let mut shear = translation([0.0; 3]);
    shear[0][1] = 1e-3;
    let mut projective = translation([0.0; 3]);
    projective[3][0] = 1e-300;

    assert_eq!(Motor::from_homogeneous(double), Err(Scales));
    assert_eq!(
        Motor::from_homogeneous(scaling([1.0 + 1e-7; 3])),
        Err(Scales)
    );
    assert_eq!(Translator::from_homogeneous(turn), Err(Rotates));
    assert_eq!(Translator::from_homogeneous(double), Err(Scales));
    assert_eq!(Rotor::from_homogeneous(shift), Err(Translates));
    assert_eq!(Rotor::from_homogeneous(double), Err(Scales));
    assert_eq!(Dilator::from_homogeneous(shift), Err(Translates));
    assert_eq!(
        Dilator::from_homogeneous(product(turn, double)),
        Err(Rotates)
    );
    let nothing_of_that = [
        (scaling([-1.0; 3]), Mirrors),
        (scaling([1.0, 1.0, -1.0]), Mirrors),
        (scaling([1.0, 2.0, 3.0]), Shears),
        (shear, Shears),
        (scaling([1.0, 1.0, 0.0]), Singular),
        (scaling([0.0; 3]), Singular),
        (projective, Projective),
    ];
    for (matrix, reason) in nothing_of_that {
        assert_eq!(
            Translator::from_homogeneous(matrix),
            Err(reason),
            "{matrix:?}"
        );
        assert_eq!(Rotor::from_homogeneous(matrix), Err(reason), "{matrix:?}");
        assert_eq!(Motor::from_homogeneous(matrix), Err(reason), "{matrix:?}");
        assert_eq!(Dilator::from_homogeneous(matrix), Err(reason), "{matrix:?}");
        assert_eq!(
            Similarity::from_homogeneous(matrix),
            Err(reason),
            "{matrix:?}"
        );
    }
    assert!(Similarity::from_homogeneous(product(shift, product(turn, double))).is_ok());
}

/// A matrix with a general last row may map a point to infinity.
#[test]
fn points_at_infinity_are_none() {
    let mut matrix = translation([0.0; 3]);
    matrix[3] = [1.0, 0.0, 0.0, 0.0];
    assert_eq!(transform(matrix, Point::new(0.0, 2.0, 3.0)), None);
    assert_eq!(
        transform(matrix, Point::new(2.0, 4.0, 6.0)),
        Some(Point::new(1.0, 2.0, 3.0))
    );
    assert_eq!(
        transform(scaling([1e300; 3]), Point::new(1e300, 0.0, 0.0)),
        None
    );
}

/// Functions that check nothing propagate infinities and NaN.
#[test]
fn numbers_that_are_not_finite_go_on() {
    for odd in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
        let shifted =
            Affine::from_translation([odd, 0.0, 0.0]).transform(Point::new(1.0, 2.0, 3.0));
        assert_eq!(shifted.e1().to_bits(), (odd + 1.0).to_bits());
        assert_eq!((shifted.e2(), shifted.e3()), (2.0, 3.0));
        assert!(
            !Affine::default()
                .transform(Point::new(odd, 2.0, 3.0))
                .e1()
                .is_finite()
        );
        assert_eq!(translation([0.0, odd, 0.0])[1][3].to_bits(), odd.to_bits());
        assert_eq!(scaling([1.0, odd, 1.0])[1][1].to_bits(), odd.to_bits());
        let far = Dilator::from_factor(2.0)
            .unwrap()
            .about(Point::new(odd, 0.0, 0.0));
        assert!(!far.e1i().is_finite());
        assert_eq!(
            Similarity::from_homogeneous(far.to_homogeneous()),
            Err(NotConformal::NotFinite)
        );
    }
}
