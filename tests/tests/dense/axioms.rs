//! The axioms of geometric algebra, exactly, in the dense reference over the prime field.
//!
//! Associativity, linearity and v v = v·v determine the geometric product, and the grades of its
//! parts determine all other products. So nothing here depends on how the reference computes.

use ga_runtime::dense::{Algebra, Multivector};
use ga_runtime::scalar::Prime61;
use ga_runtime::testing::strategy::{
    metric, multivector, nonzero_prime, of_grade, prime, vector, versor,
};
use proptest::prelude::*;
use proptest::strategy::BoxedStrategy;

/// The algebras of the tests: conformal space on its null basis, projective space, spacetime, the
/// plane, and any metric of up to five dimensions, singular ones included.
fn algebra() -> BoxedStrategy<Algebra<Prime61>> {
    prop_oneof![
        2 => Just(conformal_space()),
        1 => Just(signature(3, 0, 1)),
        1 => Just(signature(1, 3, 0)),
        1 => Just(signature(2, 0, 0)),
        1 => Just(signature(0, 0, 3)),
        3 => (0_usize..=5).prop_flat_map(|dimension| metric(dimension, prime())).prop_map(with_metric),
        // Rows that are multiples of one vector: rank one at most.
        1 => proptest::collection::vec(prime(), 4).prop_map(|v| {
            with_metric(v.iter().map(|&x| v.iter().map(|&y| x * y).collect()).collect())
        }),
    ]
    .boxed()
}

fn conformal_space() -> Algebra<Prime61> {
    let rows = [
        [1, 0, 0, 0, 0],
        [0, 1, 0, 0, 0],
        [0, 0, 1, 0, 0],
        [0, 0, 0, 0, -1],
        [0, 0, 0, -1, 0],
    ];
    with_metric(rows.map(|row| row.map(Prime61::from).to_vec()).to_vec())
}

fn signature(positive: usize, negative: usize, null: usize) -> Algebra<Prime61> {
    Algebra::with_signature(positive, negative, null).expect("small enough")
}

fn with_metric(rows: Vec<Vec<Prime61>>) -> Algebra<Prime61> {
    Algebra::new(rows).expect("symmetric and small enough")
}

type Operand = Multivector<Prime61>;

/// An algebra with three of its multivectors.
fn three() -> impl Strategy<Value = (Operand, Operand, Operand)> {
    algebra().prop_flat_map(|algebra| {
        let any = multivector(&algebra, prime());
        (any.clone(), any.clone(), any)
    })
}

fn two() -> impl Strategy<Value = (Operand, Operand)> {
    three().prop_map(|(a, b, _)| (a, b))
}

/// Two vectors and any multivector.
fn two_vectors() -> impl Strategy<Value = (Operand, Operand, Operand)> {
    algebra().prop_flat_map(|algebra| {
        let any_vector = vector(&algebra, prime());
        (
            any_vector.clone(),
            any_vector,
            multivector(&algebra, prime()),
        )
    })
}

/// A multivector of grade r and one of grade s.
fn two_of_grades() -> impl Strategy<Value = (Operand, usize, Operand, usize)> {
    algebra()
        .prop_flat_map(|algebra| {
            let grade = 0..=algebra.dimension();
            (Just(algebra), grade.clone(), grade)
        })
        .prop_flat_map(|(algebra, r, s)| {
            (
                of_grade(&algebra, r, prime()),
                Just(r),
                of_grade(&algebra, s, prime()),
                Just(s),
            )
        })
}

/// Products of up to three vectors each, and any multivector.
fn two_versors() -> impl Strategy<Value = (Operand, Operand, Operand, Operand)> {
    (algebra(), 0_usize..4, 0_usize..4).prop_flat_map(|(algebra, k, l)| {
        let any = multivector(&algebra, prime());
        (
            versor(&algebra, k, prime()),
            versor(&algebra, l, prime()),
            any.clone(),
            any,
        )
    })
}

/// An algebra and one of its basis blades.
fn blade() -> impl Strategy<Value = (Algebra<Prime61>, usize)> {
    algebra().prop_flat_map(|algebra| {
        let blades = 0..algebra.size();
        (Just(algebra), blades)
    })
}

/// Σ over all grades r and s of ⟨aᵣ bₛ⟩ of the grade that the function chooses, if any.
fn graded_product(
    a: &Operand,
    b: &Operand,
    choose: impl Fn(usize, usize) -> Option<usize>,
) -> Operand {
    let mut sum = a.algebra().zero();
    for r in 0..=a.algebra().dimension() {
        for s in 0..=a.algebra().dimension() {
            if let Some(grade) = choose(r, s) {
                sum = sum + (a.grade(r) * b.grade(s)).grade(grade);
            }
        }
    }
    sum
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(256))]

    #[test]
    fn the_geometric_product_is_associative((a, b, c) in three()) {
        prop_assert_eq!((&a * &b) * &c, &a * (&b * &c));
    }

    #[test]
    fn products_are_bilinear((a, b, c) in three(), s in prime()) {
        type Product = fn(&Operand, &Operand) -> Operand;
        let products: [Product; 8] = [
            Multivector::geometric,
            Multivector::wedge,
            Multivector::left_contraction,
            Multivector::right_contraction,
            Multivector::dot,
            Multivector::hestenes,
            Multivector::commutator,
            Multivector::vee,
        ];
        for product in products {
            prop_assert_eq!(product(&a.scale(s), &(&b + &c)), (product(&a, &b) + product(&a, &c)).scale(s));
            prop_assert_eq!(product(&(&a - &b), &c.scale(s)), (product(&a, &c) - product(&b, &c)).scale(s));
        }
    }

    #[test]
    fn one_is_neutral((a, _, _) in three(), s in prime()) {
        let one = a.algebra().one();
        prop_assert_eq!(&a * &one, a.clone());
        prop_assert_eq!(&one * &a, a.clone());
        prop_assert_eq!(&one ^ &a, a.clone());
        prop_assert_eq!(&one | &a, a.clone());
        prop_assert_eq!(a.algebra().scalar(s) * &a, a.scale(s));
        prop_assert_eq!(&a - &a, a.algebra().zero());
        prop_assert_eq!(-&a + &a, a.algebra().zero());
    }

    #[test]
    fn a_vector_squares_to_its_inner_square((v, _, _) in two_vectors()) {
        let algebra = v.algebra();
        let component = |vector: usize| v.coefficient(1 << vector);
        let mut square = Prime61::default();
        for (i, row) in algebra.metric().iter().enumerate() {
            for (j, &inner_product) in row.iter().enumerate() {
                square += component(i) * inner_product * component(j);
            }
        }
        prop_assert_eq!(&v * &v, algebra.scalar(square));
        prop_assert_eq!(&v | &v, algebra.scalar(square));
        prop_assert!((&v ^ &v).is_zero());
    }

    #[test]
    fn basis_blades_are_outer_products_of_their_vectors((algebra, blade) in blade()) {
        let mut product = algebra.one();
        for vector in (0..algebra.dimension()).filter(|vector| blade >> vector & 1 == 1) {
            product = product ^ algebra.blade(1 << vector)?;
        }
        prop_assert_eq!(product, algebra.blade(blade)?);
    }

    #[test]
    fn the_outer_product_of_vectors_is_their_antisymmetric_part((u, v, a) in two_vectors()) {
        prop_assert_eq!((&u ^ &v).scale(2.into()), &u * &v - &v * &u);
        prop_assert_eq!(u.commutator(&v), &u ^ &v);
        // With any second factor: v ∧ a = (v a + â v) / 2, v ⌋ a = (v a − â v) / 2.
        prop_assert_eq!((&v ^ &a).scale(2.into()), &v * &a + a.involute() * &v);
        prop_assert_eq!((&v | &a).scale(2.into()), &v * &a - a.involute() * &v);
    }

    #[test]
    fn products_are_parts_of_the_geometric_product((a, b) in two()) {
        prop_assert_eq!(a.wedge(&b), graded_product(&a, &b, |r, s| Some(r + s)));
        prop_assert_eq!(a.left_contraction(&b), graded_product(&a, &b, |r, s| s.checked_sub(r)));
        prop_assert_eq!(a.right_contraction(&b), graded_product(&a, &b, |r, s| r.checked_sub(s)));
        prop_assert_eq!(a.dot(&b), graded_product(&a, &b, |r, s| Some(r.abs_diff(s))));
        prop_assert_eq!(a.hestenes(&b), graded_product(&a, &b, |r, s| (r > 0 && s > 0).then(|| r.abs_diff(s))));
        prop_assert_eq!(a.scalar_product(&b), (&a * &b).coefficient(0));
        prop_assert_eq!(a.norm_squared(), (&a * a.reverse()).coefficient(0));
        prop_assert_eq!(a.commutator(&b).scale(2.into()), &a * &b - &b * &a);
    }

    #[test]
    fn products_of_grades_stay_within_their_grades((a, r, b, s) in two_of_grades()) {
        let allowed: Vec<usize> = (r.abs_diff(s)..=r + s).step_by(2).collect();
        prop_assert!((&a * &b).grades().iter().all(|grade| allowed.contains(grade)));
    }

    #[test]
    fn the_wedge_is_associative_and_contraction_its_adjoint((a, b, c) in three()) {
        prop_assert_eq!((&a ^ &b) ^ &c, &a ^ (&b ^ &c));
        prop_assert_eq!((&a ^ &b) | &c, &a | (&b | &c));
        prop_assert_eq!(c.right_contraction(&(&b ^ &a)), c.right_contraction(&b).right_contraction(&a));
        prop_assert_eq!((&a ^ &b).scalar_product(&c), a.scalar_product(&(&b | &c)));
    }

    #[test]
    fn reverse_involute_and_conjugate((a, b) in two()) {
        prop_assert_eq!((&a * &b).reverse(), b.reverse() * a.reverse());
        prop_assert_eq!((&a * &b).involute(), a.involute() * b.involute());
        prop_assert_eq!((&a * &b).conjugate(), b.conjugate() * a.conjugate());
        prop_assert_eq!(a.conjugate(), a.reverse().involute());
        prop_assert_eq!(a.reverse().reverse(), a.clone());
        prop_assert_eq!(a.grade(0).reverse(), a.grade(0));
        prop_assert_eq!(a.grade(1).reverse(), a.grade(1));
        prop_assert_eq!(a.grade(1).involute(), -a.grade(1));
        let whole = (0..=a.algebra().dimension()).fold(a.algebra().zero(), |sum, grade| sum + a.grade(grade));
        prop_assert_eq!(whole, a);
    }

    #[test]
    fn the_commutator_obeys_leibniz_and_jacobi((a, b, c) in three()) {
        let x = |a: &Operand, b: &Operand| a.commutator(b);
        prop_assert_eq!(x(&a, &(&b * &c)), x(&a, &b) * &c + &b * x(&a, &c));
        prop_assert!((x(&a, &x(&b, &c)) + x(&b, &x(&c, &a)) + x(&c, &x(&a, &b))).is_zero());
    }

    #[test]
    fn dual_and_undual_are_inverse((a, b) in two()) {
        prop_assert_eq!(a.dual().undual(), a.clone());
        prop_assert_eq!(a.undual().dual(), a.clone());
        prop_assert_eq!(a.right_complement().left_complement(), a.clone());
        prop_assert_eq!(a.left_complement().right_complement(), a.clone());
        // De Morgan, in both directions.
        prop_assert_eq!((&a & &b).dual(), a.dual() ^ b.dual());
        prop_assert_eq!((&a ^ &b).undual(), a.undual() & b.undual());
    }

    #[test]
    fn the_dual_is_division_by_the_pseudoscalar((a, _, _) in three()) {
        let algebra = a.algebra();
        let pseudoscalar = algebra.pseudoscalar();
        prop_assert_eq!(&pseudoscalar * pseudoscalar.reverse(), algebra.scalar(algebra.determinant()));
        if algebra.determinant() == Prime61::default() {
            prop_assert_eq!(a.dual(), a.right_complement());
            prop_assert_eq!(a.undual(), a.left_complement());
        } else {
            prop_assert_eq!(a.dual() * &pseudoscalar, a.clone());
            prop_assert_eq!(a.undual(), &a * &pseudoscalar);
        }
    }

    #[test]
    fn complements_complete_basis_blades((algebra, blade) in blade()) {
        let blade = algebra.blade(blade)?;
        prop_assert_eq!(&blade ^ blade.right_complement(), algebra.pseudoscalar());
        prop_assert_eq!(blade.left_complement() ^ &blade, algebra.pseudoscalar());
    }

    #[test]
    fn the_vee_is_associative_with_the_pseudoscalar_for_one((a, b, c) in three()) {
        prop_assert_eq!((&a & &b) & &c, &a & (&b & &c));
        let neutral = a.algebra().one().undual();
        prop_assert_eq!(&a & &neutral, a.clone());
        prop_assert_eq!(&neutral & &a, a);
    }

    #[test]
    fn versors_act_as_automorphisms((v, w, a, b) in two_versors()) {
        let Some(inverse) = v.inverse() else {
            // For a versor V without an inverse, V ~V is zero.
            prop_assert!((&v * v.reverse()).is_zero());
            return Ok(());
        };
        let one = a.algebra().one();
        prop_assert_eq!(&v * &inverse, one.clone());
        prop_assert_eq!(&inverse * &v, one);
        prop_assert_eq!(v.sandwich(&a), &v * &a * v.reverse());
        let act = |v: &Operand, a: &Operand| v.transform(a).ok_or_else(|| TestCaseError::fail("no action"));
        prop_assert_eq!(act(&v, &(&a ^ &b))?, act(&v, &a)? ^ act(&v, &b)?);
        prop_assert_eq!(act(&v, &(&a * &b))?, act(&v, &a)? * act(&v, &b)?);
        prop_assert_eq!(act(&v, &a.grade(1))?, act(&v, &a)?.grade(1));
        if w.inverse().is_some() {
            prop_assert_eq!(act(&(&v * &w), &a)?, act(&v, &act(&w, &a)?)?);
        }
    }

    #[test]
    fn a_vector_reflects_in_its_hyperplane((v, x, _) in two_vectors()) {
        let square = (&v | &v).coefficient(0);
        prop_assume!(square != Prime61::default());
        let along = v.scale((&v | &x).coefficient(0) / square);
        prop_assert_eq!(v.transform(&x), Some(&x - &along - &along));
    }

    #[test]
    fn mixed_parity_does_not_act((v, _, _) in two_vectors(), even in nonzero_prime()) {
        let mixed = v.algebra().scalar(even) + &v;
        prop_assert_eq!(mixed.transform(&v).is_none(), !v.is_zero());
    }
}
