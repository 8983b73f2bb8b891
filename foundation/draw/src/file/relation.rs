//! Elements made from earlier ones: meets, and elements that are moved.

use std::collections::BTreeMap;

use ga_runtime::Element;
use ga_runtime::cga3::{Circle, Infinity, Motor, Multivector, Point, PointPair, Trivector};
use ga_runtime::geometry::relation::Tolerance;
use ga_runtime::geometry::relation::meet::{CircleAndCircle, LineAndCircle, LineAndLine};

use super::error::ElementProblem;
use super::made::{Made, general};
use crate::shape::{NotDrawable, whole};

/// The blades of the elements with a name; `None` for those that are not blades.
pub(super) type Named = BTreeMap<String, Option<Multivector<f64>>>;

/// The blade of an element by its name.
pub(super) fn known(name: &str, named: &Named) -> Result<Multivector<f64>, ElementProblem> {
    match named.get(name) {
        None => Err(ElementProblem::UnknownName(name.to_owned())),
        Some(None) => Err(ElementProblem::NotABlade(name.to_owned())),
        Some(Some(blade)) => Ok(*blade),
    }
}

/// What two elements meet in.
pub(super) fn meet([a, b]: [String; 2], named: &Named) -> Result<Made, ElementProblem> {
    let (first, second) = (known(&a, named)?, known(&b, named)?);
    if let Some(found) = curves_meet(first, second) {
        return found.map_or(Err(ElementProblem::NoMeet(a, b)), general);
    }
    let meet = first & second;
    let is_null = |vector: &Multivector<f64>| {
        let square = vector.e1 * vector.e1 + vector.e2 * vector.e2 + vector.e3 * vector.e3
            - 2.0 * vector.eo * vector.ei;
        square.abs() <= 1e-9 * (vector.eo * vector.ei).abs()
    };
    let has_vector = [meet.e1, meet.e2, meet.e3, meet.eo, meet.ei] != [0.0; 5];
    // In direct form a vector stands for a point; one that is not null contains no point.
    if has_vector && !is_null(&meet) {
        return Err(ElementProblem::NoMeet(a, b));
    }
    match general(meet) {
        Err(ElementProblem::NotDrawable(NotDrawable::Zero | NotDrawable::NeitherBladeNorMotor)) => {
            Err(ElementProblem::NoMeet(a, b))
        }
        other => other,
    }
}

/// The meet of two lines or circles; `None` for other elements. The product `a ∨ b` of two that lie
/// in one plane vanishes, although they may cross.
fn curves_meet(a: Multivector<f64>, b: Multivector<f64>) -> Option<Option<Multivector<f64>>> {
    let [a, b] = [curve(a)?, curve(b)?];
    let tolerance = Tolerance::new(1e-9, 1e-9);
    let line = |c: Trivector<f64>| is_flat(c).then(|| c.extract_line());
    let round =
        |c: Trivector<f64>| Circle::from_coefficients_unchecked(&mut |blade| c.coefficient(blade));
    let point = |p: Point<f64>| Some(Multivector::from(p));
    let tangent =
        |p: Point<f64>, direction| PointPair::tangent(p, direction).map(Multivector::from);
    Some(match (line(a), line(b)) {
        (Some(l), Some(m)) => match l.meet(m, tolerance)? {
            LineAndLine::Point(p) => Some(Multivector::from(p ^ Infinity)),
            LineAndLine::Coincident(line) => Some(line.into()),
            LineAndLine::Parallel { .. } | LineAndLine::Skew(_) => None,
        },
        (Some(line), None) | (None, Some(line)) => {
            let circle = round(if is_flat(a) { b } else { a });
            match line.meet(circle, tolerance)? {
                LineAndCircle::Points(pair) | LineAndCircle::Imaginary(pair) => Some(pair.into()),
                LineAndCircle::Tangent {
                    point: p,
                    direction,
                } => tangent(p, direction),
                LineAndCircle::Point(p) => point(p),
                LineAndCircle::Apart => None,
            }
        }
        (None, None) => match round(a).meet(round(b), tolerance)? {
            CircleAndCircle::Points(pair) | CircleAndCircle::Imaginary(pair) => Some(pair.into()),
            CircleAndCircle::Tangent {
                point: p,
                direction,
            } => tangent(p, direction),
            CircleAndCircle::Point(p) => point(p),
            CircleAndCircle::Coincident(circle) => Some(circle.into()),
            CircleAndCircle::Apart | CircleAndCircle::Concentric => None,
        },
    })
}

/// A line or circle; `None` for elements with blades of another grade.
fn curve(element: Multivector<f64>) -> Option<Trivector<f64>> {
    let is_other = |blade: usize| blade.count_ones() != 3 && element.coefficient(blade) != 0.0;
    let curve = element.extract_trivector();
    (!(0..32).any(is_other) && curve != Trivector::ZERO).then_some(curve)
}

fn is_flat(c: Trivector<f64>) -> bool {
    [c.e123, c.e12o, c.e13o, c.e23o] == [0.0; 4]
}

/// An element moved by a motor, as the type that it is, so that a flat element stays flat.
pub(super) fn moved(element: Multivector<f64>, motor: Motor<f64>) -> Result<Made, ElementProblem> {
    let moved = whole(&motor).sandwich(element);
    let infinity = Multivector::from_coefficients_unchecked(&mut |blade| {
        f64::from(u8::from(blade == 0b10000))
    });
    let flat = element.wedge(infinity) == Multivector::default();
    let moved = if flat {
        // The blades without infinity have rounding errors only.
        Multivector::from_coefficients_unchecked(&mut |blade| {
            if blade & 0b10000 == 0 {
                0.0
            } else {
                moved.coefficient(blade)
            }
        })
    } else {
        moved
    };
    general(moved)
}
