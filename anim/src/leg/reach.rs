//! Angles that bring the ankle to a given place.

use ga_runtime::cga3::{Infinity, Line, Plane, Point, PointPair, Sphere};

use super::inverse::{cross, frame, turns_about_zyx};
use super::{Leg, LegAngles, LegError, finite};

impl Leg {
    /// The angles that bring the ankle to a target, the knee on the side of a pole; the foot is not turned.
    ///
    /// The knee is where the sphere of the thigh's length about the hip, the sphere of the calf's length about the target and the
    /// plane through hip, target and pole meet: of this pair of points the one on the pole's side. A leg that is stretched out
    /// has its knee where the spheres touch.
    ///
    /// # Errors
    /// [`LegError::Unreachable`] for a target that is too far or too near, [`LegError::Folded`] for one at the hip itself, which any
    /// direction of the thigh reaches, [`LegError::Pole`] for a pole in line with hip and target, [`LegError::Place`] for places that are not finite.
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
        // As much as the places are rounded; a leg that is stretched out must still reach where it is.
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
        let axis = Line::through(hip, target);
        let foot = axis.foot(pole).ok_or(LegError::Pole)?;
        let aside = minus(pole, foot);
        // The foot is off by the rounding of the axis, which grows with the pole's distance from it.
        let lever = 1.0 + pole.distance(hip) / distance;
        if dot(aside, aside).sqrt() <= rounding * lever {
            return Err(LegError::Pole);
        }
        let down = minus(target, hip).map(|x| x / distance);
        let hinge = unit(cross(aside, down)).ok_or(LegError::Pole)?;

        let knee = self.knee(hip, target, pole).unwrap_or_else(|| {
            // The spheres touch: the knee is on the axis.
            let along = (distance * distance + thigh * thigh - calf * calf) / (2.0 * distance);
            Point::from([0, 1, 2].map(|k| hip.coordinates()[k] + down[k] * along))
        });
        let (upper, lower) = (minus(knee, hip), minus(target, knee));
        let up = unit(upper).ok_or(LegError::Pole)?.map(|x| -x);
        let forward = cross(hinge, up);
        let rotor = frame(hinge, up, forward).ok_or(LegError::Pole)?;
        let [hip_z, hip_y, hip_x] = turns_about_zyx(rotor.to_matrix());
        let bend = dot(cross(upper, lower), hinge).atan2(dot(upper, lower));
        Ok(LegAngles {
            hip_z,
            hip_y,
            hip_x,
            knee: bend,
            ..LegAngles::default()
        })
    }

    /// The knee on the pole's side; `None` where the spheres only touch.
    fn knee(&self, hip: Point<f64>, target: Point<f64>, pole: Point<f64>) -> Option<Point<f64>> {
        let [thigh, calf, _] = self.lengths();
        let circle =
            Sphere::from_centre_radius(hip, thigh) & Sphere::from_centre_radius(target, calf);
        let [first, second] = ends(circle & Plane::through(hip, target, pole))?;
        let is_first = first.distance_squared(pole) < second.distance_squared(pole);
        Some(if is_first { first } else { second })
    }
}

/// The points of a real pair. With `P = p∧q` of any weight and `x = ei⌋P`, a multiple of p − q, the points are
/// `−(P⌊x)/√P² ± x` up to weight.
fn ends(pair: PointPair<f64>) -> Option<[Point<f64>; 2]> {
    let square = pair.scalar_product(pair);
    if !square.is_finite() || square <= 0.0 {
        return None;
    }
    let between = Infinity | pair;
    let sum = pair.right_contraction(between) / -square.sqrt();
    Some([(sum + between).centre()?, (sum - between).centre()?])
}

fn minus(a: Point<f64>, b: Point<f64>) -> [f64; 3] {
    let (a, b) = (a.coordinates(), b.coordinates());
    [a[0] - b[0], a[1] - b[1], a[2] - b[2]]
}

fn dot(a: [f64; 3], b: [f64; 3]) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

fn unit(a: [f64; 3]) -> Option<[f64; 3]> {
    let length = dot(a, a).sqrt();
    (length.is_finite() && length > 0.0).then(|| a.map(|x| x / length))
}
