//! The body as a whole: trunk with head, two arms, two legs, joined into one smooth closed surface.

mod arm;
mod head;
mod leg;
mod loft;
pub(crate) mod solid;
mod torso;

use crate::landmarks::Landmarks;
use crate::{Vector, mirror};
use ga_runtime::scalar::smooth_step;
use solid::{Bump, Solid, smooth_minimum};

/// Widths in metres of the fillets between the parts.
const ARM_FILLET: f64 = 0.06;
const BUTTOCK_FILLET: f64 = 0.045;
/// Heights between which the legs pass over into the trunk.
const PELVIS: [f64; 2] = [0.80, 0.93];
const CROTCH_FILLET: f64 = 0.02;

/// The solid body: the left limbs, which the mirror image repeats, the trunk and the modelling of
/// the skin.
#[derive(Clone, Debug)]
pub(crate) struct Body {
    trunk: Solid,
    arm: Solid,
    leg: Solid,
    buttocks: Solid,
    bumps: Vec<Bump>,
}

impl Body {
    pub(crate) fn new(landmarks: &Landmarks) -> Self {
        let mut trunk = torso::solid();
        head::add_to(&mut trunk);
        let mut bumps = torso::bumps();
        bumps.extend(head::bumps());
        bumps.extend(arm::bumps(landmarks));
        bumps.extend(leg::bumps(landmarks));
        Body {
            trunk,
            arm: arm::solid(landmarks),
            leg: leg::solid(landmarks),
            buttocks: torso::buttocks(),
            bumps,
        }
    }

    /// Signed distance to the skin, to first order; a value above `limit` may be any lower bound
    /// above `limit`.
    pub(crate) fn distance(&self, point: Vector, limit: f64) -> f64 {
        // Fillets and bumps reach this far beyond the shapes.
        let reach = limit + ARM_FILLET + 0.01;
        let [trunk, left_arm, right_arm, left_leg, right_leg] = self.parts(point, reach);
        let legs = smooth_minimum(left_leg, right_leg, CROTCH_FILLET);
        let arms = left_arm.min(right_arm);
        // Through the pelvis the legs pass over into the trunk by interpolation: a union of two
        // solids of nearly the same outline would bulge.
        let above = smooth_step(PELVIS[0], PELVIS[1], point.e2);
        let pelvis = if above <= 0.0 {
            legs
        } else if above >= 1.0 {
            trunk
        } else {
            legs + above * (trunk - legs)
        };
        let seat = smooth_minimum(pelvis, self.buttocks.distance(point, reach), BUTTOCK_FILLET);
        let bare = smooth_minimum(seat, arms, ARM_FILLET);
        if bare > reach {
            return bare;
        }
        let folded = Vector::new(point.e1.abs(), point.e2, point.e3);
        // A bump whose centre stands off the plane of symmetry also reaches across it from the
        // other side.
        let height: f64 = self
            .bumps
            .iter()
            .map(|bump| {
                let here = bump.height_at(folded);
                if bump.centre.e1 > 0.0 {
                    here + bump.height_at(mirror(folded))
                } else {
                    here
                }
            })
            .sum();
        bare - height
    }

    /// The distance of each part on its own: trunk, left and right arm, left and right leg.
    pub(crate) fn parts(&self, point: Vector, limit: f64) -> [f64; 5] {
        let other = mirror(point);
        [
            self.trunk.distance(point, limit),
            self.arm.distance(point, limit),
            self.arm.distance(other, limit),
            self.leg.distance(point, limit),
            self.leg.distance(other, limit),
        ]
    }

    /// Corners of a box that holds the left half of the body with room to spare.
    pub(crate) fn left_bounds(&self) -> [Vector; 2] {
        const ROOM: Vector = Vector::new(0.03, 0.03, 0.03);
        let solids = [&self.trunk, &self.arm, &self.leg];
        let bounds = solids.into_iter().filter_map(Solid::bounds);
        let whole = bounds.reduce(|a, b| [a[0].min(b[0]), a[1].max(b[1])]);
        let [low, high] = whole.unwrap_or_default();
        let low = low - ROOM;
        [Vector::new(0.0, low.e2, low.e3), high + ROOM]
    }
}
