//! What a transferred motion looks like, so that one that is broken does not pass in silence.

use ga_numerics::order_statistics::Sorted;
use ga_runtime::cga3::{Direction, Motor};
use ga_runtime::vga3::Vector;
use serde::Serialize;

use super::Retarget;
use super::bodies::Leg;
use super::fault::{Fault, Place};
use super::feet::Feet;
use super::foot_locking::Contact;
use super::human::Human;
use crate::clip::Clip;
use crate::pose::moved;
use crate::skeleton::SkeletonError;

/// Measures of a transferred motion, each the worst of all frames, and where it is.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Checks {
    /// The angle between the vertical and the way from the hips to the head.
    pub trunk_from_upright_degrees: f64,
    /// The height of the lowest point of the soles.
    pub lowest_foot_metres: f64,
    /// How far apart two places of an ankle are at most while the foot stands.
    pub stance_slide_metres: f64,
    /// The greatest change of the distance between a joint and the one that it hangs on, as a part
    /// of that distance at rest.
    pub longest_stretch: f64,
    /// Joints that nothing moves.
    pub joints_left_out: Vec<String>,
    /// The greatest rotation of a joint in space from one frame to the next; 0 for one frame.
    pub largest_rotation_degrees_per_frame: f64,
    /// Where each of these is worst, by its name.
    pub worst: Worst,
    /// What is beyond its limit.
    #[serde(skip)]
    pub faults: Vec<Fault>,
}

/// Where each measure is worst; nowhere where there is nothing to measure, as no rotation in one
/// frame.
#[derive(Clone, Debug, Default, PartialEq, Serialize)]
#[allow(missing_docs, reason = "the names are those of the measures")]
pub struct Worst {
    pub trunk_from_upright_degrees: Option<Place>,
    pub lowest_foot_metres: Option<Place>,
    pub stance_slide_metres: Option<Place>,
    pub longest_stretch: Option<Place>,
    pub largest_rotation_degrees_per_frame: Option<Place>,
}

/// The limits: in degrees of the head against the trunk and of a rotation from one frame to the
/// next, as parts of a bone's and of a leg's length, and of the frames.
const HEAD: f64 = 60.0;
const ROTATION: f64 = 60.0;
const STRETCH: f64 = 1e-6;
const HEIGHT: f64 = 0.05;
const BACKWARDS: f64 = 0.05;
/// In degrees, of a sole from flat and of a foot from where the pelvis looks, while it stands.
const SOLE: f64 = 15.0;
const HEADING: f64 = 90.0;

impl Retarget<'_> {
    /// Measures a clip that was transferred, of the frames of the recording from `first_frame` on,
    /// in which feet stand as these contacts say. A unit of the target is `metres_per_unit` long.
    ///
    /// # Errors
    ///
    /// [`SkeletonError`] for a clip of another skeleton.
    pub fn checks(
        &self,
        clip: &Clip,
        first_frame: usize,
        contacts: &[Contact],
        metres_per_unit: f64,
    ) -> Result<Checks, SkeletonError> {
        let body = Body::new(self);
        let mut measures = Measures::default();
        let mut before: Option<Vec<Motor<f64>>> = None;
        let mut heights = Vec::with_capacity(clip.frames().len());
        for (number, pose) in clip.frames().iter().enumerate() {
            let motions = pose.motions(self.target)?;
            let frame = first_frame + number;
            body.look(&mut measures, &motions, frame);
            let lowest = self.soles().lowest(&motions);
            measures
                .lowest
                .update(-lowest, frame, body.lowest_joint(&motions));
            heights.push(lowest);
            if let Some(before) = &before {
                self.rotations(&mut measures, before, &motions, frame - 1);
            }
            before = Some(motions);
        }
        for (side, foot) in measures.feet.sides.iter_mut().enumerate() {
            let ankle = body.human.map(|human| human.legs[side][2]);
            let own = contacts
                .iter()
                .filter(|contact| Some(contact.ankle) == ankle);
            let frames: Vec<_> = own.map(|contact| contact.frames.clone()).collect();
            foot.retain_standing(&frames, body.leg_length);
        }
        for contact in contacts {
            let frame = *contact.frames.start();
            measures.slide.update(contact.slide, frame, contact.ankle);
        }
        let height = Sorted::new(&mut heights).map_or(0.0, |heights| heights.quantile(0.25));
        Ok(self.judged(
            &body,
            measures,
            height,
            clip.frames().len(),
            metres_per_unit,
        ))
    }

    /// The rotations of the joints from one frame to the next, and by how much they exceed those of
    /// the joints that move them.
    fn rotations(
        &self,
        measures: &mut Measures,
        before: &[Motor<f64>],
        after: &[Motor<f64>],
        frame: usize,
    ) {
        let angle = |from: Motor<f64>, to: Motor<f64>| {
            let (_, angle) = (to.rotor() * from.rotor().reverse()).to_axis_angle();
            // A rotor and its negative are one rotation.
            angle.min(std::f64::consts::TAU - angle).to_degrees()
        };
        let source = [frame, frame + 1].map(|frame| self.source_frames(frame));
        for joint in 0..before.len() {
            let own = angle(before[joint], after[joint]);
            measures.rotation.update(own, frame, joint);
            let there = self.correspondence.source_of[joint];
            if let (Some(there), [Some(a), Some(b)]) = (there, &source) {
                measures
                    .excess
                    .update(own - angle(a[there], b[there]), frame, joint);
            }
        }
    }

    fn judged(
        &self,
        body: &Body,
        measures: Measures,
        height: f64,
        frames: usize,
        metres_per_unit: f64,
    ) -> Checks {
        let joints = self.target.joints();
        let place = |largest: &Largest| Place {
            frame: largest.frame,
            joint: joints[largest.joint].name.clone(),
        };
        let found = |largest: &Largest| largest.value.is_finite().then(|| place(largest));
        let mut faults = Vec::new();
        if measures.head.value > HEAD {
            faults.push(Fault::Head {
                degrees: measures.head.value,
                place: place(&measures.head),
            });
        }
        if measures.stretch.value > STRETCH {
            faults.push(Fault::Stretch {
                part: measures.stretch.value,
                place: place(&measures.stretch),
            });
        }
        if height.abs() > HEIGHT * body.leg_length && !self.keeps_height {
            faults.push(Fault::Height {
                metres: height * metres_per_unit,
                place: place(&measures.lowest),
            });
        }
        for (count, most) in measures.backwards.iter().zip(&measures.knees) {
            let part = *count as f64 / frames.max(1) as f64;
            if part > BACKWARDS {
                faults.push(Fault::Knee {
                    percent: 100.0 * part,
                    place: place(most),
                });
            }
        }
        for (side, foot) in measures.feet.sides.iter().enumerate() {
            let Some(human) = body.human else { break };
            let place = |frame: usize| Place {
                frame,
                joint: joints[human.legs[side][2]].name.clone(),
            };
            if let Some((degrees, frame)) = foot.tilt().filter(|&(degrees, _)| degrees > SOLE) {
                let place = place(frame);
                faults.push(Fault::Sole { degrees, place });
            }
            let heading = foot.heading();
            if let Some((degrees, frame)) = heading.filter(|&(degrees, _)| degrees > HEADING) {
                let place = place(frame);
                faults.push(Fault::Heading { degrees, place });
            }
        }
        if measures.excess.value > ROTATION {
            faults.push(Fault::Rotation {
                degrees: measures.excess.value,
                place: place(&measures.excess),
            });
        }
        Checks {
            trunk_from_upright_degrees: measures.trunk.value,
            lowest_foot_metres: -measures.lowest.value * metres_per_unit,
            stance_slide_metres: measures.slide.value.max(0.0) * metres_per_unit,
            longest_stretch: measures.stretch.value.max(0.0),
            joints_left_out: self.unmatched().map(ToOwned::to_owned).collect(),
            largest_rotation_degrees_per_frame: measures.rotation.value.max(0.0),
            worst: Worst {
                trunk_from_upright_degrees: found(&measures.trunk),
                lowest_foot_metres: found(&measures.lowest),
                stance_slide_metres: found(&measures.slide),
                longest_stretch: found(&measures.stretch),
                largest_rotation_degrees_per_frame: found(&measures.rotation),
            },
            faults,
        }
    }
}

/// The largest value of a measure, and where it is.
#[derive(Clone, Debug)]
struct Largest {
    value: f64,
    frame: usize,
    joint: usize,
}

impl Default for Largest {
    fn default() -> Self {
        Self {
            value: f64::NEG_INFINITY,
            frame: 0,
            joint: 0,
        }
    }
}

impl Largest {
    fn update(&mut self, value: f64, frame: usize, joint: usize) {
        if value > self.value {
            *self = Self {
                value,
                frame,
                joint,
            };
        }
    }
}

#[derive(Clone, Debug, Default)]
struct Measures {
    trunk: Largest,
    head: Largest,
    /// The depth below the ground.
    lowest: Largest,
    slide: Largest,
    stretch: Largest,
    rotation: Largest,
    excess: Largest,
    /// For each leg the frames in which the knee bends backwards, and the one in which it does
    /// most.
    backwards: [usize; 2],
    knees: [Largest; 2],
    feet: Feet,
}

/// What is known of the target.
struct Body<'a> {
    retarget: &'a Retarget<'a>,
    /// The joints at both ends of the trunk.
    trunk: [usize; 2],
    human: Option<&'a Human>,
    leg_length: f64,
    /// From right to left at rest.
    left: Vector<f64>,
}

impl<'a> Body<'a> {
    fn new(retarget: &'a Retarget<'a>) -> Self {
        let joints = retarget.target.joints();
        let head = |joint: usize| Vector::from(joints[joint].head);
        let human = retarget.correspondence.human.as_ref();
        let highest = (0..joints.len()).max_by(|&a, &b| head(a).e2.total_cmp(&head(b).e2));
        let trunk = match human {
            Some(human) => [human.hips, human.head],
            None => [0, highest.unwrap_or_default()],
        };
        let legs = retarget.correspondence.legs.iter();
        let lengths = legs.map(
            |&Leg {
                 joints: [hip, knee, ankle],
                 ..
             }| { head(hip).distance(head(knee)) + head(knee).distance(head(ankle)) },
        );
        let count = retarget.correspondence.legs.len().max(1) as f64;
        let hips = human.map(|human| head(human.legs[0][0]) - head(human.legs[1][0]));
        Self {
            retarget,
            trunk,
            human,
            leg_length: lengths.sum::<f64>() / count,
            left: hips.unwrap_or_default(),
        }
    }

    fn place(&self, motions: &[Motor<f64>], joint: usize) -> Vector<f64> {
        moved(motions[joint], self.retarget.target.joints()[joint].head).into()
    }

    /// The lower one of both ankles, or the root.
    fn lowest_joint(&self, motions: &[Motor<f64>]) -> usize {
        let ankles = self
            .retarget
            .correspondence
            .legs
            .iter()
            .map(|leg| leg.joints[2]);
        let height = |joint: &usize| self.place(motions, *joint).e2;
        ankles
            .min_by(|a, b| height(a).total_cmp(&height(b)))
            .unwrap_or_default()
    }

    fn look(&self, measures: &mut Measures, motions: &[Motor<f64>], frame: usize) {
        const BENT: f64 = 15.0;
        let up = Vector::new(0.0, 1.0, 0.0);
        let degrees = |a: Vector<f64>, b: Vector<f64>| a.angle(b).map_or(0.0, f64::to_degrees);
        let place = |joint: usize| self.place(motions, joint);
        let [hips, head] = self.trunk;
        let trunk = place(head) - place(hips);
        measures.trunk.update(degrees(trunk, up), frame, head);
        let joints = self.retarget.target.joints();
        for (joint, parent) in self
            .retarget
            .correspondence
            .hanging
            .parents
            .iter()
            .enumerate()
        {
            let Some(parent) = *parent else { continue };
            let rest = Vector::from(joints[joint].head).distance(joints[parent].head.into());
            let now = place(joint).distance(place(parent));
            if rest > 0.0 {
                measures
                    .stretch
                    .update((now / rest - 1.0).abs(), frame, joint);
            }
        }
        let Some(human) = self
            .human
            .filter(|_| self.retarget.correspondence.stands_at_rest)
        else {
            return;
        };
        let rotated = |joint: usize, v: Vector<f64>| {
            Vector::from(motions[joint].rotor().transform(Direction::from(v)))
        };
        measures
            .head
            .update(degrees(rotated(head, up), trunk), frame, head);
        for (side, [hip, knee, ankle]) in human.legs.into_iter().enumerate() {
            let (thigh, shin) = (place(knee) - place(hip), place(ankle) - place(knee));
            let bend = degrees(thigh, shin);
            let is_backwards = thigh.cross(shin).dot(rotated(hip, self.left)) < 0.0;
            let looks = rotated(human.hips, self.left).cross(up);
            let points = rotated(ankle, self.left.cross(up));
            measures.feet.sides[side].add(
                frame,
                place(ankle).e2,
                rotated(ankle, up),
                [points, looks],
            );
            if bend > BENT && is_backwards {
                measures.backwards[side] += 1;
                measures.knees[side].update(bend, frame, knee);
            }
        }
    }
}
