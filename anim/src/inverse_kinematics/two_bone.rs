//! Two bones in closed form: a limb of root, middle and end.

use super::rotation::{rotated, rotation_between_frames};
use ga_runtime::cga3::{Point, Rotor};
use ga_runtime::ga;
use ga_runtime::vga3::Vector;

use super::check::finite;
use crate::kinematics::KinematicsError;

ga! { ga_runtime::cga3;
    /// The middle joint of a limb with its root at the origin: of the two points in which the
    /// sphere of the upper bone about the root, the sphere of the lower bone about the end and the
    /// plane through root, end and pole meet, the one on the pole's side.
    fn meet(end: Point, pole: Point, upper: Scalar, lower: Scalar) -> Point {
        let about_root = eo - upper * upper / 2 * ei;
        let about_end = end - lower * lower / 2 * ei;
        let plane = dual(eo ^ end ^ pole ^ ei);
        endpoints(undual(about_root ^ about_end ^ plane)).1
    }

    /// Where on the line from the root, the origin, to the end the plane of the circle is in which
    /// the two spheres meet, as a part of the way to the end.
    fn foot(end: Point, upper: Scalar, lower: Scalar) -> Scalar {
        let square = -2 * (eo | end);
        (square + upper * upper - lower * lower) / (2 * square)
    }
}

/// The middle joint of a limb with its root at the origin, on the side of the pole. Where the
/// spheres only touch, within rounding, it is on the line to the end.
pub(crate) fn middle_joint(
    upper: f64,
    lower: f64,
    end: Vector<f64>,
    pole: Vector<f64>,
) -> Vector<f64> {
    let (at_end, at_pole) = (Point::from(end), Point::from(pole));
    let middle = Vector::from(meet(at_end, at_pole, upper, lower));
    if middle.is_finite() {
        middle
    } else {
        end * foot(at_end, upper, lower)
    }
}

/// A limb of two bones, by their lengths.
///
/// The middle joint is where three figures meet: the sphere about the root with the length of the
/// upper bone as its radius, the sphere about the target with that of the lower bone, and the plane
/// through root, target and a *pole*, a point on the side to which the limb bends,
///
/// ```text
/// σ_root ∨ σ_target ∨ π = p ∧ q
/// ```
///
/// Of this pair of points the one on the pole's side is taken.
///
/// ```
/// use ga_anim::inverse_kinematics::{Reach, TwoBone};
/// use ga_runtime::cga3::Point;
///
/// let arm = TwoBone::new(5.0, 5.0)?;
/// let (shoulder, hand) = (Point::default(), Point::new(8.0, 0.0, 0.0));
/// let bent = arm.solve(shoulder, hand, Point::new(4.0, 0.0, 9.0))?;
/// assert!(bent.middle.distance(Point::new(4.0, 0.0, 3.0)) < 1e-14);
///
/// // Out of reach: the arm points to the target.
/// let far = arm.solve(shoulder, Point::new(13.0, 0.0, 0.0), Point::new(4.0, 0.0, 9.0))?;
/// assert!(matches!(far.reach, Reach::TooFar { by } if (by - 3.0).abs() < 1e-14));
/// assert!(far.end.distance(Point::new(10.0, 0.0, 0.0)) < 1e-14);
/// # Ok::<(), ga_anim::kinematics::KinematicsError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TwoBone {
    upper: f64,
    lower: f64,
    /// One over the length of the limb when it is straight.
    inverse: f64,
}

/// Whether the end of a limb is at its target.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Reach {
    /// It is.
    Exact,
    /// The target is too far away by this length; the limb is straight and points to it.
    TooFar {
        /// How far the end is from the target.
        by: f64,
    },
    /// The target is nearer to the root than the bones, which differ in length, can bring the end;
    /// the limb is folded, with its end in the direction of the target.
    TooClose {
        /// How far the end is from the target.
        by: f64,
    },
}

/// A limb that reaches for a target.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Bent {
    /// The root, as it was.
    pub root: Point<f64>,
    /// The joint between the bones.
    pub middle: Point<f64>,
    /// The end: the target itself where it is in reach, otherwise the nearest point that is.
    pub end: Point<f64>,
    /// Whether the end is at the target.
    pub reach: Reach,
    /// A normal of the plane in which the limb bends, of any length, about which the rotation from
    /// the upper bone to the lower one is right-handed; zero for a straight limb whose pole is in
    /// line with it.
    pub normal: Vector<f64>,
}

/// Below this part of the pole's distance from the root, its distance from the line to the target
/// is rounding.
const IN_LINE: f64 = 8.0 * f64::EPSILON;
/// Below this part of the length of the limb, the target is at the root.
const SAME: f64 = f64::EPSILON;

impl TwoBone {
    /// A limb with bones of these lengths.
    ///
    /// # Errors
    ///
    /// [`KinematicsError::Length`] for a length that is not positive and finite.
    pub fn new(upper: f64, lower: f64) -> Result<Self, KinematicsError> {
        for (bone, length) in [upper, lower].into_iter().enumerate() {
            if !length.is_finite() || length <= 0.0 {
                return Err(KinematicsError::Length { bone, length });
            }
        }
        Ok(Self {
            upper,
            lower,
            inverse: (upper + lower).recip(),
        })
    }

    /// The lengths of the upper and the lower bone.
    #[must_use]
    pub fn lengths(&self) -> [f64; 2] {
        [self.upper, self.lower]
    }

    /// The limb with its root here and its end at a target, bent to the side of the pole.
    ///
    /// # Errors
    ///
    /// [`KinematicsError::NotFinite`]; [`KinematicsError::Folded`] for a target at the root, where
    /// a limb of equal bones may point anywhere, and one of unequal bones has no nearest point to
    /// reach; [`KinematicsError::Pole`] for a pole in line with root and target, where the limb has
    /// to bend.
    #[inline]
    pub fn solve(
        &self,
        root: Point<f64>,
        target: Point<f64>,
        pole: Point<f64>,
    ) -> Result<Bent, KinematicsError> {
        // The root is the origin and the straight limb the unit of length: spheres far from the
        // origin, very large or very small would lose digits.
        let end = root.vector_to(target) * self.inverse;
        let to_pole = root.vector_to(pole) * self.inverse;
        let normal = to_pole.cross(end);
        let (square, area) = (end.length_squared(), normal.length_squared());
        let (upper, lower) = (self.upper * self.inverse, self.lower * self.inverse);
        let least = (upper - lower).abs();
        // A comparison with NaN does not hold.
        let shows_side = area > IN_LINE * IN_LINE * square * to_pole.length_squared();
        let bends = square < 1.0 && square > least * least && square > SAME * SAME;
        if bends && shows_side && area < f64::INFINITY {
            let middle = middle_joint(upper, lower, end, to_pole);
            return Ok(Bent {
                root,
                middle: displaced(root, middle * (self.upper + self.lower)),
                end: target,
                reach: Reach::Exact,
                normal,
            });
        }
        if !(square + area).is_finite() {
            return Err(not_finite(root, target, to_pole));
        }
        self.straight(
            root,
            target,
            (end, square.sqrt()),
            shows_side.then_some(normal),
        )
    }

    /// The limb that cannot bend to reach its target, which is at the end of a vector of a length,
    /// both relative to the straight limb; with a normal, where the pole gives one.
    #[inline(never)]
    fn straight(
        &self,
        root: Point<f64>,
        target: Point<f64>,
        (end, distance): (Vector<f64>, f64),
        normal: Option<Vector<f64>>,
    ) -> Result<Bent, KinematicsError> {
        let whole = self.upper + self.lower;
        let least = (self.upper - self.lower).abs() * self.inverse;
        if distance <= SAME {
            return Err(KinematicsError::Folded);
        }
        if distance < 1.0 && distance > least {
            return Err(KinematicsError::Pole);
        }
        let along = end / distance;
        let is_far = distance >= 1.0;
        let by = if is_far {
            distance - 1.0
        } else {
            least - distance
        } * whole;
        let length = if is_far { whole } else { least * whole };
        let middle = match !is_far && self.upper < self.lower {
            true => -self.upper,
            false => self.upper,
        };
        let (reach, end) = match by > 0.0 {
            false => (Reach::Exact, target),
            true if is_far => (Reach::TooFar { by }, displaced(root, along * length)),
            true => (Reach::TooClose { by }, displaced(root, along * length)),
        };
        Ok(Bent {
            root,
            middle: displaced(root, along * middle),
            end,
            reach,
            normal: normal.unwrap_or_default(),
        })
    }
}

impl Bent {
    /// The rotors that take a limb with these places of root, middle and end to this one: of the
    /// upper and of the lower bone, each in the coordinates of the world. The plane of the limb is
    /// taken along, so that neither bone twists against it. Where one of the limbs is straight,
    /// its plane is not known, and each bone is rotated the shortest way.
    ///
    /// `None` where a bone has no length.
    #[must_use]
    pub fn rotors_from(&self, [root, middle, end]: [Point<f64>; 3]) -> Option<[Rotor<f64>; 2]> {
        let before = [root.vector_to(middle), middle.vector_to(end)];
        let after = [
            self.root.vector_to(self.middle),
            self.middle.vector_to(self.end),
        ];
        let normal = before[0].cross(before[1]);
        let [upper, lower] = [before[0].length(), before[1].length()];
        if normal.length() <= 1e-9 * upper * lower || self.normal == Vector::default() {
            let between = |k: usize| Rotor::between(before[k].into(), after[k].into());
            let upper = between(0)?;
            // The lower bone goes with the upper one and then the rest of the way.
            let carried: Vector<f64> = rotated(upper, before[1]);
            return Some([
                upper,
                Rotor::between(carried.into(), after[1].into())? * upper,
            ]);
        }
        Some([
            rotation_between_frames([before[0], normal], [after[0], self.normal])?,
            rotation_between_frames([before[1], normal], [after[1], self.normal])?,
        ])
    }
}

/// A point displaced by a vector.
#[inline]
pub(super) fn displaced(point: Point<f64>, by: Vector<f64>) -> Point<f64> {
    Point::from(Vector::from(point) + by)
}

#[cold]
fn not_finite(root: Point<f64>, target: Point<f64>, pole: Vector<f64>) -> KinematicsError {
    let places = [("the root", root), ("the target", target)];
    let mut checks = places.into_iter().map(|(what, place)| finite(what, place));
    let coordinates = pole.coordinates();
    let what = "the pole, relative to the limb,";
    checks
        .find_map(Result::err)
        .unwrap_or(KinematicsError::NotFinite { what, coordinates })
}
