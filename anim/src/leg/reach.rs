//! Angles that bring the ankle to a given place.

use ga_runtime::cga3::{Plane, Point, Sphere};

use super::inverse::turns_about_zyx;
use super::vector::{across, cross, dot, length, minus, rows, unit};
use super::{Leg, LegAngles, LegError, finite};

impl Leg {
    /// The angles that bring the ankle to a target, the knee on the side of a pole; the foot is not
    /// turned.
    ///
    /// The knee is where the sphere of the thigh's length about the hip, the sphere of the calf's
    /// length about the target and the plane through hip, target and pole meet: of this pair of
    /// points the one on the pole's side. A leg that is stretched out has its knee where the
    /// spheres touch.
    ///
    /// # Errors
    /// [`LegError::Unreachable`] for a target that is too far or too near, [`LegError::Folded`] for
    /// one at the hip itself, which any direction of the thigh reaches, [`LegError::Pole`] for a
    /// pole in line with hip and target, [`LegError::Place`] for places that are not finite.
    ///
    /// ```
    /// use ga_anim::leg::Leg;
    /// use ga_runtime::cga3::Point;
    /// let leg = Leg::new(0.45, 0.43, 0.2)?;
    /// let (hip, target) = (Point::new(0.1, 0.9, 0.0), Point::new(0.1, 0.3, 0.2));
    /// let angles = leg.reach(hip, target, Point::new(0.1, 0.5, 1.0))?;
    /// let pose = leg.forward(hip, &angles)?;
    /// assert!(pose.ankle.distance(target) < 1e-14 && pose.knee.e3() > 0.1);
    /// # Ok::<(), ga_anim::leg::LegError>(())
    /// ```
    pub fn reach(
        &self,
        hip: Point<f64>,
        target: Point<f64>,
        pole: Point<f64>,
    ) -> Result<LegAngles, LegError> {
        for (place, point) in [("hip", hip), ("target", target), ("pole", pole)] {
            finite(place, point)?;
        }
        let [thigh, calf, _] = self.lengths();
        let (distance, least, most) = (hip.distance(target), (thigh - calf).abs(), thigh + calf);
        // As much as the places are rounded; a leg that is stretched out must still reach where it
        // is.
        let size = [hip, target, pole]
            .iter()
            .flat_map(|p| p.coordinates())
            .fold(most, |m, x| m.max(x.abs()));
        let rounding = 8.0 * f64::EPSILON * size;
        if distance < least - rounding || distance > most + rounding {
            return Err(LegError::Unreachable {
                distance,
                least,
                most,
            });
        }
        if distance <= rounding {
            return Err(LegError::Folded { distance });
        }
        // From here on with the hip at the origin and the stretched leg as the unit of length:
        // spheres far from the origin, very large or very small would lose digits.
        let scaled = |point| minus(point, hip).map(|x| x / most);
        let target = Point::from(scaled(target));
        let down = unit(target.coordinates()).ok_or(LegError::Folded { distance })?;
        let aside = across(scaled(pole), down);
        // The places' rounding moves the axis, the more the farther the pole is from the hip.
        let lever = 1.0 + pole.distance(hip) / distance;
        if length(aside) <= rounding / most * lever {
            return Err(LegError::Pole);
        }
        let aside = unit(across(unit(aside).ok_or(LegError::Pole)?, down)).ok_or(LegError::Pole)?;
        let hinge = cross(aside, down);

        let knee = knee(thigh / most, calf / most, target, aside);
        let upper = unit(knee.coordinates()).ok_or(LegError::Pole)?;
        let lower = unit(minus(target, knee)).ok_or(LegError::Pole)?;
        let up = upper.map(|x| -x);
        let [hip_z, hip_y, hip_x] = turns_about_zyx(rows(hinge, up, cross(hinge, up)));
        let bend = dot(cross(upper, lower), hinge).atan2(dot(upper, lower));
        Ok(LegAngles {
            hip_z,
            hip_y,
            hip_x,
            knee: bend,
            ..LegAngles::default()
        })
    }
}

/// The knee on the pole's side, for a hip at the origin: where the spheres of the two bones meet
/// the plane in which the leg bends. Where the spheres only touch, it is on the line from hip to
/// target.
fn knee(thigh: f64, calf: f64, target: Point<f64>, aside: [f64; 3]) -> Point<f64> {
    let hip = Point::default();
    let circle = Sphere::from_centre_radius(hip, thigh) & Sphere::from_centre_radius(target, calf);
    let plane = Plane::through(hip, target, Point::from(aside));
    let Some([first, second]) = (circle & plane).endpoints() else {
        let square = dot(target.coordinates(), target.coordinates());
        let part = (square + thigh * thigh - calf * calf) / (2.0 * square);
        return Point::from(target.coordinates().map(|x| x * part));
    };
    if dot(first.coordinates(), aside) > dot(second.coordinates(), aside) {
        first
    } else {
        second
    }
}
