//! Constructing, reading and writing multivectors of the dense reference, and its errors.

use ga_runtime::dense::{Algebra, DenseError};
use ga_runtime::scalar::{Dual, Prime61};

type Result = std::result::Result<(), DenseError>;

#[test]
fn metrics_that_are_none() -> Result {
    let metric =
        |rows: &[&[f64]]| Algebra::new(rows.iter().map(|row| row.to_vec()).collect()).map(|_| ());
    assert_eq!(
        metric(&[&[1.0, 0.0], &[0.0]]),
        Err(DenseError::NotSquare {
            row: 1,
            entries: 1,
            dimension: 2
        })
    );
    assert_eq!(
        metric(&[&[1.0, 2.0], &[3.0, 1.0]]),
        Err(DenseError::NotSymmetric { row: 1, column: 0 })
    );
    assert_eq!(
        metric(&[&[f64::NAN]]),
        Err(DenseError::NotSymmetric { row: 0, column: 0 })
    );
    assert_eq!(
        metric(&[&[1.0, f64::NAN], &[f64::NAN, 1.0]]),
        Err(DenseError::NotSymmetric { row: 1, column: 0 })
    );
    let too_large = Err(DenseError::TooManyVectors { dimension: 17 });
    assert_eq!(
        Algebra::<i64>::new(vec![vec![0; 17]; 17]).map(|_| ()),
        too_large
    );
    assert_eq!(
        Algebra::<i64>::with_signature(9, 8, 0).map(|_| ()),
        too_large
    );
    assert!(Algebra::<i64>::with_signature(usize::MAX, 1, 1).is_err());
    Algebra::<i64>::with_signature(0, 0, 16).map(|_| ())
}

#[test]
fn operands_that_do_not_fit() -> Result {
    let plane = Algebra::with_signature(2, 0, 0)?;
    assert_eq!(
        plane.vector([1, 2, 3]),
        Err(DenseError::CoefficientCount {
            expected: 2,
            found: 3
        })
    );
    assert_eq!(
        plane.multivector([1, 2, 3]),
        Err(DenseError::CoefficientCount {
            expected: 4,
            found: 3
        })
    );
    assert_eq!(
        plane.blade(4),
        Err(DenseError::NoSuchBlade {
            blade: 4,
            dimension: 2
        })
    );
    assert_eq!(
        plane.sparse([(1, 1), (2, 5), (1, 2)]),
        Err(DenseError::RepeatedBlade { blade: 1 })
    );
    assert_eq!(
        plane.zero().set_coefficient(4, 1),
        Err(DenseError::NoSuchBlade {
            blade: 4,
            dimension: 2
        })
    );
    assert_eq!(plane.zero().coefficient(4), 0);
    let names = |names: &[&str]| plane.with_names(names.iter().copied()).map(|_| ());
    assert_eq!(
        names(&["x"]),
        Err(DenseError::NameCount {
            expected: 2,
            found: 1
        })
    );
    assert_eq!(
        names(&["x", "x"]),
        Err(DenseError::UnusableName {
            vector: 1,
            name: "x".into()
        })
    );
    assert_eq!(
        names(&["", "x"]),
        Err(DenseError::UnusableName {
            vector: 0,
            name: String::new()
        })
    );
    Ok(())
}

#[test]
fn errors_say_what_and_where() {
    let messages = [
        (
            DenseError::TooManyVectors { dimension: 17 },
            "17 basis vectors is too large, the maximum is 16",
        ),
        (
            DenseError::NotSquare {
                row: 1,
                entries: 3,
                dimension: 2,
            },
            "row 1 of the metric has 3 entries instead of 2",
        ),
        (
            DenseError::NotSymmetric { row: 1, column: 0 },
            "row 1, column 0",
        ),
        (
            DenseError::NoSuchBlade {
                blade: 4,
                dimension: 2,
            },
            "blade 0b100 does not exist with 2",
        ),
        (
            DenseError::UnusableName {
                vector: 1,
                name: "x".into(),
            },
            "vector 1 has the name `x`",
        ),
    ];
    for (error, part) in messages {
        assert!(error.to_string().contains(part), "{error}");
    }
}

#[test]
#[should_panic(expected = "different algebras")]
fn operands_of_different_algebras() {
    let plane = Algebra::<i64>::with_signature(2, 0, 0).expect("small");
    let spacelike = Algebra::<i64>::with_signature(1, 1, 0).expect("small");
    let _ = plane.one() * spacelike.one();
}

#[test]
fn equal_metrics_make_equal_algebras() -> Result {
    let one = Algebra::with_signature(1, 1, 0)?;
    let other = Algebra::new(vec![vec![1, 0], vec![0, -1]])?.with_names(["x", "t"])?;
    assert_eq!(one.one() + other.one(), one.scalar(2));
    assert_ne!(one.one(), Algebra::with_signature(2, 0, 0)?.one());
    Ok(())
}

#[test]
fn reading_and_writing_coefficients() -> Result {
    let space = Algebra::with_signature(3, 0, 0)?;
    let mut a = space.sparse([(0b101, 7), (0, 2)])?;
    assert_eq!(a.coefficients(), [2, 0, 0, 0, 0, 7, 0, 0]);
    assert_eq!(a, space.multivector([2, 0, 0, 0, 0, 7, 0, 0])?);
    a.set_coefficient(0b010, -4)?;
    assert_eq!(
        a.terms().collect::<Vec<_>>(),
        [(0, 2), (0b010, -4), (0b101, 7)]
    );
    assert_eq!(a.grades(), [0, 1, 2]);
    assert_eq!(a.grade(1), space.vector([0, -4, 0])?);
    assert_eq!(a.grade(9), space.zero());
    assert_eq!(a.coefficient(0b101), 7);
    Ok(())
}

#[test]
fn blade_notation() -> Result {
    let cga1 = Algebra::new(vec![
        vec![1.0, 0.0, 0.0],
        vec![0.0, 0.0, -1.0],
        vec![0.0, -1.0, 0.0],
    ])?
    .with_names(["e1", "eo", "ei"])?;
    assert_eq!(cga1.zero().to_string(), "0");
    assert_eq!(cga1.scalar(-1.0).to_string(), "-1");
    let a = cga1.sparse([
        (0, 1.0),
        (0b001, -1.0),
        (0b101, -0.25),
        (0b110, 1.0),
        (0b111, 3.5),
    ])?;
    assert_eq!(a.to_string(), "1 - e1 - 0.25 e1i + eoi + 3.5 e1oi");
    assert_eq!(format!("{a:.2}"), "1.00 - e1 - 0.25 e1i + eoi + 3.50 e1oi");
    assert_eq!(format!("{a:?}"), "1.0 - e1 - 0.25 e1i + eoi + 3.5 e1oi");

    let named = Algebra::with_signature(3, 0, 0)?.with_names(["x", "y", "z"])?;
    assert_eq!(
        (named.blade(0b110)? * named.scalar(Prime61::from(-2))).to_string(),
        "-2 yz"
    );
    let large = Algebra::<i64>::with_signature(0, 0, 11)?;
    assert_eq!(large.blade_name(0b10000000001), "e1_11");
    assert_eq!(large.blade_name(0), "1");
    Ok(())
}

#[test]
fn the_algebra_of_no_vectors_is_its_scalars() -> Result {
    let scalars = Algebra::with_signature(0, 0, 0)?;
    let three = scalars.scalar(Prime61::from(3));
    assert_eq!(scalars.size(), 1);
    assert_eq!(&three * &three, scalars.scalar(9.into()));
    assert_eq!(three.dual(), three);
    Ok(())
}

#[test]
fn sixteen_dimensions() -> Result {
    let algebra = Algebra::<i64>::with_signature(8, 8, 0)?;
    let vectors: Vec<_> = (0..16)
        .map(|vector| algebra.blade(1 << vector))
        .collect::<std::result::Result<_, _>>()?;
    let all = vectors
        .iter()
        .fold(algebra.one(), |product, vector| product * vector);
    assert_eq!(all, algebra.pseudoscalar());
    // I² = (−1)^(n (n − 1) / 2) det = (−1)^120 (−1)⁸.
    assert_eq!(&all * &all, algebra.one());
    assert_eq!(algebra.determinant(), 1);
    Ok(())
}

/// A determinant whose value is zero cannot divide, even if its derivative is not zero.
#[test]
fn duals_where_a_determinant_has_no_inverse() {
    let metric = vec![vec![Dual::<f64>::variable(0.0)]];
    let line = Algebra::new(metric).expect("a metric");
    let vector = line.blade(0b1).expect("a blade");
    assert_eq!(vector.dual(), line.one(), "the complement");
    assert_eq!(line.one().undual(), vector, "the complement");
    assert_eq!(vector.dual().undual(), vector);
}
