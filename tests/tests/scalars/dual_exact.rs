//! Derivatives of rational functions and of motions, exactly in the prime field.

use ga_runtime::Element;
use ga_runtime::cga3::{Direction, Motor, Point, Rotor, Translator};
use ga_runtime::scalar::{Dual, Field, Prime61, Ring};
use ga_runtime::testing::exact_member;
use ga_runtime::testing::strategy::{nonzero_prime, prime};
use proptest::collection::vec;
use proptest::prelude::*;

/// A rational function of three variables.
#[derive(Clone, Debug)]
enum Expression {
    Constant(Prime61),
    Variable(usize),
    Sum(Box<[Expression; 2]>),
    Difference(Box<[Expression; 2]>),
    Product(Box<[Expression; 2]>),
    Quotient(Box<[Expression; 2]>),
    Negative(Box<Expression>),
    Reciprocal(Box<Expression>),
    MulAdd(Box<[Expression; 3]>),
}

fn expression() -> impl Strategy<Value = Expression> {
    let leaf = prop_oneof![
        2 => (0_usize..3).prop_map(Expression::Variable),
        1 => prime().prop_map(Expression::Constant),
    ];
    leaf.prop_recursive(4, 20, 3, |inner| {
        let two = || [inner.clone(), inner.clone()].prop_map(Box::new);
        let three = [inner.clone(), inner.clone(), inner.clone()].prop_map(Box::new);
        prop_oneof![
            two().prop_map(Expression::Sum),
            two().prop_map(Expression::Difference),
            two().prop_map(Expression::Product),
            two().prop_map(Expression::Quotient),
            inner
                .clone()
                .prop_map(|a| Expression::Negative(Box::new(a))),
            inner
                .clone()
                .prop_map(|a| Expression::Reciprocal(Box::new(a))),
            three.prop_map(Expression::MulAdd),
        ]
    })
}

/// The value over any scalar; `None` for a division by zero.
fn evaluate<S: Field>(
    expression: &Expression,
    variables: &[S; 3],
    constant: &impl Fn(Prime61) -> S,
) -> Option<S> {
    let value = |inner: &Expression| evaluate(inner, variables, constant);
    Some(match expression {
        Expression::Constant(number) => constant(*number),
        Expression::Variable(place) => variables[*place],
        Expression::Sum(ab) => value(&ab[0])? + value(&ab[1])?,
        Expression::Difference(ab) => value(&ab[0])? - value(&ab[1])?,
        Expression::Product(ab) => value(&ab[0])? * value(&ab[1])?,
        Expression::Quotient(ab) => {
            let divisor = value(&ab[1])?;
            let dividend = value(&ab[0])?;
            divisor.is_invertible().then(|| dividend / divisor)?
        }
        Expression::Negative(a) => -value(a)?,
        Expression::Reciprocal(a) => {
            let divisor = value(a)?;
            divisor.is_invertible().then(|| divisor.recip())?
        }
        Expression::MulAdd(abc) => value(&abc[0])?.mul_add(value(&abc[1])?, value(&abc[2])?),
    })
}

/// A polynomial in t, the coefficient of t⁰ first.
type Polynomial = Vec<Prime61>;

fn add(a: &Polynomial, b: &Polynomial) -> Polynomial {
    let term = |p: &Polynomial, k: usize| p.get(k).copied().unwrap_or_default();
    (0..a.len().max(b.len()))
        .map(|k| term(a, k) + term(b, k))
        .collect()
}

fn multiply(a: &Polynomial, b: &Polynomial) -> Polynomial {
    let mut product = vec![Prime61::zero(); a.len() + b.len() - 1];
    for (i, &x) in a.iter().enumerate() {
        for (j, &y) in b.iter().enumerate() {
            product[i + j] += x * y;
        }
    }
    product
}

fn negative(a: &Polynomial) -> Polynomial {
    a.iter().map(|&x| -x).collect()
}

/// The expression on the line from `start` in `direction` as a quotient of two polynomials.
fn along(
    expression: &Expression,
    start: &[Prime61; 3],
    direction: &[Prime61; 3],
) -> [Polynomial; 2] {
    let part = |inner: &Expression| along(inner, start, direction);
    let sum = |[p, q]: [Polynomial; 2], [r, s]: [Polynomial; 2]| {
        [add(&multiply(&p, &s), &multiply(&r, &q)), multiply(&q, &s)]
    };
    let product =
        |[p, q]: [Polynomial; 2], [r, s]: [Polynomial; 2]| [multiply(&p, &r), multiply(&q, &s)];
    let one = vec![Prime61::one()];
    match expression {
        Expression::Constant(number) => [vec![*number], one],
        Expression::Variable(place) => [vec![start[*place], direction[*place]], one],
        Expression::Sum(ab) => sum(part(&ab[0]), part(&ab[1])),
        Expression::Difference(ab) => {
            let [r, s] = part(&ab[1]);
            sum(part(&ab[0]), [negative(&r), s])
        }
        Expression::Product(ab) => product(part(&ab[0]), part(&ab[1])),
        Expression::Quotient(ab) => {
            let [r, s] = part(&ab[1]);
            product(part(&ab[0]), [s, r])
        }
        Expression::Negative(a) => {
            let [p, q] = part(a);
            [negative(&p), q]
        }
        Expression::Reciprocal(a) => {
            let [p, q] = part(a);
            [q, p]
        }
        Expression::MulAdd(abc) => sum(product(part(&abc[0]), part(&abc[1])), part(&abc[2])),
    }
}

fn first_terms(polynomial: &Polynomial) -> (Prime61, Prime61) {
    let term = |k: usize| polynomial.get(k).copied().unwrap_or_default();
    (term(0), term(1))
}

fn exact3() -> impl Strategy<Value = [Prime61; 3]> {
    [prime(), prime(), prime()]
}

/// The same element as a constant, with zero derivatives.
fn constant<A, B, const N: usize>(element: A) -> B
where
    A: Element<Scalar = Prime61>,
    B: Element<Scalar = Dual<Prime61, N>>,
{
    B::from_coefficients_unchecked(&mut |blade| Dual::constant(element.coefficient(blade)))
}

/// `(1 + α e12)²/(1 + α²)`: the rotation about e3 by the angle θ with `tan ¼θ = −α`.
fn turn<S: Field>(alpha: S) -> Rotor<S> {
    let norm = (S::one() + alpha * alpha).recip();
    Rotor::new_unchecked(
        (S::one() - alpha * alpha) * norm,
        (alpha + alpha) * norm,
        S::zero(),
        S::zero(),
    )
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(512))]

    #[test]
    fn rational_functions(expression in expression(), start in exact3(), direction in exact3()) {
        let plain = evaluate(&expression, &start, &|number| number);
        let dual = evaluate(&expression, &Dual::variables(start), &Dual::constant);
        prop_assert_eq!(dual.map(|d| d.value), plain);
        prop_assume!(plain.is_some());
        let gradient = dual.map_or([Prime61::zero(); 3], |d| d.derivatives);
        let [p, q] = along(&expression, &start, &direction);
        let ((p0, p1), (q0, q1)) = (first_terms(&p), first_terms(&q));
        // A product of denominators may be zero although no divisor is.
        prop_assume!(q0 != Prime61::zero());
        let slope = (p1 * q0 - p0 * q1) / (q0 * q0);
        let directional = (0..3).fold(Prime61::zero(), |sum, k| sum + gradient[k] * direction[k]);
        prop_assert_eq!(directional, slope);
    }

    #[test]
    fn polynomials_to_the_second_derivative(coefficients in vec(prime(), 1..9), x in prime()) {
        let at = Dual::<Dual<Prime61>>::variable(Dual::variable(x));
        let horner = coefficients.iter().rev().fold(Dual::zero(), |sum: Dual<Dual<Prime61>>, &c| {
            sum.mul_add(at, Dual::constant(Dual::constant(c)))
        });
        let term = |order: u64| {
            coefficients.iter().zip(0_u64..).filter(|(_, k)| *k >= order).fold(Prime61::zero(), |sum, (&c, k)| {
                let falling = (0..order).fold(Prime61::one(), |product, j| product * Prime61::new(k - j));
                sum + c * falling * x.power(k - order)
            })
        };
        prop_assert_eq!(horner.value.value, term(0));
        prop_assert_eq!([horner.value.derivative(), horner.derivative().value], [term(1); 2]);
        prop_assert_eq!(horner.derivative().derivative(), term(2));
    }

    #[test]
    fn integers_differentiate_too(x in -1000_i64..1000, y in -1000_i64..1000) {
        let [a, b] = Dual::variables([x, y]);
        let mut product = a;
        product *= b;
        product -= a;
        product += -b * b;
        prop_assert_eq!(product, Dual::new(x * y - x - y * y, [y - 1, x - 2 * y]));
    }

    #[test]
    fn assignment_is_the_operator(x in exact3(), y in exact3()) {
        let (a, b) = (Dual::new(x[0], [x[1], x[2]]), Dual::new(y[0], [y[1], y[2]]));
        let mut c = a;
        c /= b;
        prop_assert_eq!(c, a / b);
        prop_assert_eq!(b.is_invertible(), y[0] != Prime61::zero());
        prop_assert_eq!(a.recip() * b, b / a);
    }

    /// The Jacobian of a motion by the coordinates is its rotation: the columns are the rotated
    /// basis vectors.
    #[test]
    fn jacobian_of_a_sandwich(motor in exact_member::<Motor<Prime61>>(), point in exact3(), step in exact3()) {
        let moved = constant::<_, Motor<Dual<Prime61, 3>>, 3>(motor).transform(Point::from(Dual::variables(point)));
        let coordinates = moved.coordinates();
        let plain = motor.transform(Point::from(point)).coordinates();
        prop_assert_eq!(coordinates.map(|x| x.value), plain);
        for k in 0..3 {
            let mut unit = [Prime61::zero(); 3];
            unit[k] = Prime61::one();
            let turned = motor.transform(Direction::new(unit[0], unit[1], unit[2]));
            prop_assert_eq!(coordinates.map(|x| x.derivatives[k]), [turned.e1i, turned.e2i, turned.e3i]);
        }
        // A motion is affine, so its difference over any step is its derivative.
        let there = motor.transform(Point::from([0, 1, 2].map(|k| point[k] + step[k]))).coordinates();
        for i in 0..3 {
            let along = (0..3).fold(Prime61::zero(), |sum, k| sum + coordinates[i].derivatives[k] * step[k]);
            prop_assert_eq!(there[i] - plain[i], along);
        }
        // The derived coefficient of ei is half the square of the coordinates: its gradient is x'ᵀ
        // J.
        let infinity = moved.coefficient(0b10000);
        for k in 0..3 {
            let inner = coordinates.iter().fold(Prime61::zero(), |sum, x| sum + x.value * x.derivatives[k]);
            prop_assert_eq!(infinity.derivatives[k], inner);
        }
    }

    /// The derivative of a moved point by the parameters of the motor.
    #[test]
    fn velocity_by_the_parameters_of_a_motor(alpha in nonzero_prime(), shift in exact3(), point in exact3()) {
        let one = Prime61::one();
        let norm = one + alpha * alpha;
        prop_assume!(norm != Prime61::zero());
        let [a, x, y, z] = Dual::variables([alpha, shift[0], shift[1], shift[2]]);
        let motor: Motor<Dual<Prime61, 4>> = Translator::from_displacement([x, y, z]) * turn(a);
        let moved = motor.transform(Point::from(point.map(Dual::constant))).coordinates();

        // θ = −4 arctan α, and the velocity by θ is e3 × (x' − t).
        let rate = Prime61::from(-4) / norm;
        let arm = [0, 1].map(|k| moved[k].value - shift[k]);
        prop_assert_eq!(moved.map(|x| x.derivatives[0]), [-rate * arm[1], rate * arm[0], Prime61::zero()]);
        for k in 0..3 {
            let mut unit = [Prime61::zero(); 3];
            unit[k] = one;
            prop_assert_eq!(moved.map(|x| x.derivatives[k + 1]), unit);
        }
    }

    /// The chain rule for a product of motors: the outer motor rotates the derivative of the inner
    /// one.
    #[test]
    fn chain_rule_through_motors(outer in exact_member::<Motor<Prime61>>(), alpha in prime(), point in exact3()) {
        prop_assume!(Prime61::one() + alpha * alpha != Prime61::zero());
        let fixed: Motor<Dual<Prime61>> = constant(outer);
        let inner = Motor::from(turn(Dual::variable(alpha)));
        let start = Point::from(point.map(Dual::constant));
        let whole = (fixed * inner).transform(start).coordinates().map(Dual::derivative);
        let [x, y, z] = inner.transform(start).coordinates().map(Dual::derivative);
        let turned = outer.transform(Direction::new(x, y, z));
        prop_assert_eq!(whole, [turned.e1i, turned.e2i, turned.e3i]);
    }
}
