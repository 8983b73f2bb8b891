//! Meets and joins of dual forms are those of the direct forms.

use ga_runtime::cga3::{Direction, Point};
use nullcone_tests::plain::*;
use proptest::prelude::*;

proptest! {
    #[test]
    fn meets_and_joins_take_either_form(
        p in vector(3.0), q in vector(3.0), d in unit(), e in unit(), r in 0.5..4.0_f64, s in 0.5..4.0_f64,
    ) {
        let t = tolerance();
        // Each figure with each other one, in all combinations of forms.
        macro_rules! meets {
            ($a:expr; $($b:expr),*) => {$({
                let (a, b) = ($a, $b);
                let expected = a.meet(b, t);
                prop_assert!(expected.is_some());
                prop_assert_eq!(a.dual().meet(b, t), expected);
                prop_assert_eq!(a.meet(b.dual(), t), expected);
                prop_assert_eq!(a.dual().meet(b.dual(), t), expected);
            })*};
        }
        macro_rules! joins {
            ($a:expr; $($b:expr),*) => {$({
                let (a, b) = ($a, $b);
                let expected = a.join(b, t);
                prop_assert!(expected.is_some());
                prop_assert_eq!(a.dual().join(b, t), expected);
                prop_assert_eq!(a.join(b.dual(), t), expected);
                prop_assert_eq!(a.dual().join(b.dual(), t), expected);
            })*};
        }
        macro_rules! all {
            ($which:ident: $($a:expr),*) => {$(
                $which!($a; line(q, e), plane(q, e), circle(q, e, s), sphere(q, s));
            )*};
        }
        all!(meets: line(p, d), plane(p, d), circle(p, d, r), sphere(p, r));
        all!(joins: line(p, d), plane(p, d), circle(p, d, r), sphere(p, r), pair(p, q), point(p) ^ ga_runtime::cga3::Infinity);
        prop_assert_eq!(point(p).join(sphere(q, s).dual(), t), point(p).join(sphere(q, s), t));
        prop_assert_eq!(line(p, d).join(pair(p, q).dual(), t), line(p, d).join(pair(p, q), t));
    }
}

/// What is not a figure in direct form is not a figure in dual form either.
#[test]
fn figures_that_are_none_meet_nothing() {
    let t = tolerance();
    let flat = plane(O, Z).dual();
    let no_sphere = sphere(O, 1.0).dual() * 0.0;
    assert_eq!(no_sphere.meet(line(O, X), t), None);
    assert_eq!(flat.meet(no_sphere, t), None);
    assert_eq!(no_sphere.join(Point::from(X), t), None);
    let nothing = line(O, X).dual() * 0.0;
    assert_eq!(nothing.join(Point::from(X), t), None);
    assert_eq!(Direction::<f64>::default().dual().normal(), [0.0; 3]);
}
