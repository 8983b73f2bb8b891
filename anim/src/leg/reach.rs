//! Angles that bring the ankle to a given place.

use ga_runtime::cga3::Point;
use ga_runtime::vga3::Vector;

use super::inverse::angles_about_zyx;
use super::{Leg, LegAngles, finite, rotation};
use crate::inverse_kinematics::middle_joint;
use crate::kinematics::KinematicsError;

impl Leg {
    /// The angles that bring the ankle to a target, with the knee on the side of a pole; the foot
    /// is not rotated.
    ///
    /// The knee is where the sphere of the thigh's length about the hip, the sphere of the calf's
    /// length about the target and the plane through hip, target and pole meet: of this pair of
    /// points the one on the pole's side. A leg that is stretched out has its knee where the
    /// spheres touch.
    ///
    /// # Errors
    /// [`KinematicsError::LegUnreachable`] for a target that is too far or too near,
    /// [`KinematicsError::LegFolded`] for one at the hip itself, which any direction of the thigh
    /// reaches, [`KinematicsError::LegPole`] for a pole in line with hip and target,
    /// [`KinematicsError::LegPlace`] for points that are not finite.
    ///
    /// ```
    /// use ga_anim::leg::Leg;
    /// use ga_runtime::cga3::Point;
    /// let leg = Leg::new(0.45, 0.43, 0.2)?;
    /// let (hip, target) = (Point::new(0.1, 0.9, 0.0), Point::new(0.1, 0.3, 0.2));
    /// let angles = leg.reach(hip, target, Point::new(0.1, 0.5, 1.0))?;
    /// let pose = leg.forward(hip, &angles)?;
    /// assert!(pose.ankle.distance(target) < 1e-14 && pose.knee.e3() > 0.1);
    /// # Ok::<(), ga_anim::kinematics::KinematicsError>(())
    /// ```
    pub fn reach(
        &self,
        hip: Point<f64>,
        target: Point<f64>,
        pole: Point<f64>,
    ) -> Result<LegAngles, KinematicsError> {
        for (place, point) in [("hip", hip), ("target", target), ("pole", pole)] {
            finite(place, point)?;
        }
        let [thigh, calf, _] = self.lengths();
        let (distance, least, most) = (hip.distance(target), (thigh - calf).abs(), thigh + calf);
        // The rounding of the coordinates; a stretched leg must still reach its own ankle.
        let size = [hip, target, pole]
            .iter()
            .flat_map(|p| p.coordinates())
            .fold(most, |m, x| m.max(x.abs()));
        let rounding = 8.0 * f64::EPSILON * size;
        if distance < least - rounding || distance > most + rounding {
            return Err(KinematicsError::LegUnreachable {
                distance,
                least,
                most,
            });
        }
        if distance <= rounding {
            return Err(KinematicsError::LegFolded { distance });
        }
        // From here on the hip is the origin and the stretched leg the unit of length: spheres far
        // from the origin, very large or very small would lose digits.
        let scaled = |point| hip.vector_to(point) / most;
        let target = scaled(target);
        let down = target
            .normalized()
            .ok_or(KinematicsError::LegFolded { distance })?;
        let across = |vector: Vector<f64>| vector - down * vector.dot(down);
        let aside = across(scaled(pole));
        // The rounding of the coordinates moves the axis, the more the farther the pole is away.
        let lever = 1.0 + pole.distance(hip) / distance;
        if aside.length() <= rounding / most * lever {
            return Err(KinematicsError::LegPole);
        }
        let aside = aside.normalized().ok_or(KinematicsError::LegPole)?;
        let aside = across(aside).normalized().ok_or(KinematicsError::LegPole)?;
        let hinge = aside.cross(down);

        let knee = middle_joint(thigh / most, calf / most, target, aside);
        let upper = knee.normalized().ok_or(KinematicsError::LegPole)?;
        let lower = (target - knee)
            .normalized()
            .ok_or(KinematicsError::LegPole)?;
        let [hip_z, hip_y, hip_x] = angles_about_zyx(rotation(hinge, -upper));
        let bend = upper.cross(lower).dot(hinge).atan2(upper.dot(lower));
        Ok(LegAngles {
            hip_z,
            hip_y,
            hip_x,
            knee: bend,
            ..LegAngles::default()
        })
    }
}
