//! Feet that stand where they stand in the source.

use std::ops::RangeInclusive;

use ga_runtime::cga3::{Point, Rotor};
use ga_runtime::vga3::Vector;

use super::{Retarget, hierarchy};
use crate::clip::Clip;
use crate::inverse_kinematics::{Bent, TwoBone, place_limb};
use crate::pose::{Pose, moved};
use crate::recording::RecordingError;

/// How feet are found to stand, and how they are kept in place.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FootLocking {
    /// The length of one unit of the source in metres.
    pub metres_per_unit: f64,
    /// A foot stands while the speed of its ankle in the source is below this, in metres per
    /// second.
    pub speed: f64,
    /// How long a foot takes to come from its own path to the place where it stands, and back, in
    /// seconds; less where it stands again sooner.
    pub blend: f64,
}

impl FootLocking {
    /// Feet stand below 0.05 m/s and come and go within 0.25 s.
    #[must_use]
    pub fn new(metres_per_unit: f64) -> Self {
        Self {
            metres_per_unit,
            speed: 0.05,
            blend: 0.25,
        }
    }
}

/// Speeds are measured in several ways (forwards, backwards, over two frames), which differ by the
/// noise of a recording. What any of them could call standing is kept in place.
const MARGIN: f64 = 1.2;

/// As fractions of the leg's length: the distance within which a foot belongs to the ground; the
/// distance of the knee from the line between hip and ankle below which it does not say to which
/// side the leg bends; and how far a leg is stretched for a foot to stay in its place.
const NEAR_GROUND: f64 = 1.0 / 16.0;
const STRAIGHT: f64 = 1.0 / 64.0;
const STRETCHED: f64 = 0.999;

/// A time during which a foot stands.
#[derive(Clone, Debug, PartialEq)]
pub struct Contact {
    /// The joint of the ankle in the target.
    pub ankle: usize,
    /// The first frame and the last one.
    pub frames: RangeInclusive<usize>,
    /// How far apart two places of the ankle are in these frames at most, in units of the target.
    pub slide: f64,
    /// The same without foot locking.
    pub slide_before: f64,
    /// How far the ankle is at most from where it should stand, since the leg is too short; 0 where
    /// the leg reaches.
    ///
    /// The ankle then stands at the nearest place that the leg reaches in all these frames. Where
    /// there is none, it slides.
    pub short_by: f64,
}

impl Contact {
    /// The same in a motion without foot locking.
    pub(super) fn without_locking(&self) -> Self {
        Self {
            slide: self.slide_before,
            short_by: 0.0,
            ..self.clone()
        }
    }
}

/// A [`Retarget`] whose feet stand while the source's do.
#[derive(Clone, Debug)]
pub struct LockedFeet<'r, 'a> {
    retarget: &'r Retarget<'a>,
    feet: Vec<Foot>,
    contacts: Vec<Contact>,
}

/// The path of a foot.
#[derive(Clone, Debug)]
struct Foot {
    /// Hip, knee and ankle.
    joints: [usize; 3],
    /// The direction at rest to which the knee bends where the leg is straight.
    forward: Vector<f64>,
    /// How far the ankle is moved in each frame.
    offsets: Vec<Vector<f64>>,
}

/// A leg in a frame.
#[derive(Clone, Copy, Debug)]
struct LegPose {
    places: [Point<f64>; 3],
    /// To which side the knee bends.
    forward: Vector<f64>,
    /// The height of the lowest point of the sole.
    lowest: f64,
}

impl<'a> Retarget<'a> {
    /// The same with feet that stand while the source's do.
    ///
    /// While the ankle of the source is slower than [`FootLocking::speed`], that of the target
    /// stays in one place: the mean of its places in these frames, with the sole on the ground
    /// where it is near it, and within the reach of the leg. Before and after, its displacement
    /// decreases smoothly, and a sole that is a little below the ground is raised to it. Hip and
    /// knee bend for that in closed form ([`TwoBone`]), in the plane of the leg; all other bones,
    /// the feet included, keep their directions, and the hips their place.
    ///
    /// A leg that is too short for its place is reported by [`Contact::short_by`].
    ///
    /// # Errors
    ///
    /// [`RecordingError::FootLocking`] for settings that are not positive and finite, and
    /// [`RecordingError::Skeleton`].
    pub fn with_foot_locking(
        &self,
        settings: &FootLocking,
    ) -> Result<LockedFeet<'_, 'a>, RecordingError> {
        for (name, value) in [
            ("the length of a unit", settings.metres_per_unit),
            ("the speed of a standing foot", settings.speed),
            ("the time in which a foot comes and goes", settings.blend),
        ] {
            if !value.is_finite() || value <= 0.0 {
                return Err(RecordingError::FootLocking { name, value });
            }
        }
        let mut feet = self.feet();
        let paths = self.paths(&feet)?;
        let ankles = self.source_ankles();
        let step = settings.speed * MARGIN * self.source.frame_time() / settings.metres_per_unit;
        let blend = (settings.blend / self.source.frame_time()).ceil();
        let mut contacts = Vec::new();
        for ((foot, path), ankle) in feet.iter_mut().zip(&paths).zip(&ankles) {
            let runs = standing(ankle, step);
            let stands: Vec<Stand> = runs.into_iter().map(|run| Stand::new(path, run)).collect();
            foot.offsets = offsets(path, &stands, blend);
            contacts.extend(stands.into_iter().map(|stand| foot.contact(path, stand)));
        }
        Ok(LockedFeet {
            retarget: self,
            feet,
            contacts,
        })
    }

    fn feet(&self) -> Vec<Foot> {
        let legs = self.correspondence.legs.iter();
        let foot = |joints: [usize; 3]| {
            let heads = joints.map(|joint| Vector::from(self.target.joints()[joint].head));
            let horizontal = |v: Vector<f64>| Vector::new(v.e1, 0.0, v.e3);
            let soles = self.soles().middle(|joint| self.is_below(joint, joints[2]));
            let to_toes = soles.map(|soles| horizontal(soles - heads[2]));
            let knee = (heads[1] - heads[0]).reject(heads[2] - heads[0]);
            let size = heads[0].distance(heads[2]);
            let directions = [to_toes, knee, Some(Vector::new(0.0, 0.0, 1.0))];
            let forward = directions
                .into_iter()
                .flatten()
                .find(|v| v.length() > STRAIGHT * size);
            Foot {
                joints,
                forward: forward.and_then(Vector::normalized).unwrap_or_default(),
                offsets: Vec::new(),
            }
        };
        legs.map(|leg| foot(leg.joints)).collect()
    }

    /// Whether a joint is another one or below it.
    fn is_below(&self, joint: usize, above: usize) -> bool {
        hierarchy::is_below(&self.correspondence.hanging.parents, joint, above)
    }

    /// Each leg in every frame, without foot locking.
    fn paths(&self, feet: &[Foot]) -> Result<Vec<Vec<LegPose>>, RecordingError> {
        let count = self.source.frame_count();
        let mut paths = vec![Vec::with_capacity(count); feet.len()];
        let soles: Vec<Vec<bool>> = feet
            .iter()
            .map(|foot| {
                let joints = 0..self.target.len();
                joints
                    .map(|joint| self.is_below(joint, foot.joints[2]))
                    .collect()
            })
            .collect();
        for frame in 0..count {
            let motions = self.pose(frame)?.motions(self.target)?;
            for ((path, foot), sole) in paths.iter_mut().zip(feet).zip(&soles) {
                let place = |joint: usize| {
                    Point::from(moved(motions[joint], self.target.joints()[joint].head))
                };
                let thigh = motions[foot.joints[0]].rotor();
                path.push(LegPose {
                    places: foot.joints.map(place),
                    forward: thigh.transform(Point::from(foot.forward)).into(),
                    lowest: self.soles().lowest_of(&motions, |joint| sole[joint]),
                });
            }
        }
        Ok(paths)
    }

    /// The ankles of the source, each in every frame.
    fn source_ankles(&self) -> Vec<Vec<Vector<f64>>> {
        let legs = &self.correspondence.legs;
        let mut ankles = vec![Vec::with_capacity(self.source.frame_count()); legs.len()];
        for frame in 0..self.source.frame_count() {
            let Some(frames) = self.source_frames(frame) else {
                break;
            };
            for (ankle, leg) in ankles.iter_mut().zip(legs) {
                let place = frames[leg.source_ankle].transform(Point::default());
                ankle.push(place.into());
            }
        }
        ankles
    }
}

impl LockedFeet<'_, '_> {
    /// The times in which feet stand, foot after foot.
    #[must_use]
    pub fn contacts(&self) -> &[Contact] {
        &self.contacts
    }

    /// The pose of the skeleton in a frame of the recording.
    ///
    /// # Errors
    ///
    /// [`RecordingError::FrameRange`].
    pub fn pose(&self, frame: usize) -> Result<Pose, RecordingError> {
        let target = self.retarget.target;
        let mut pose = self.retarget.pose(frame)?;
        let motions = pose.motions(target)?;
        for foot in &self.feet {
            let place =
                |joint: usize| Point::from(moved(motions[joint], target.joints()[joint].head));
            let thigh = motions[foot.joints[0]].rotor();
            let leg = LegPose {
                places: foot.joints.map(place),
                forward: thigh.transform(Point::from(foot.forward)).into(),
                lowest: 0.0,
            };
            let Some(bent) = leg.bent(foot.offsets[frame]) else {
                continue;
            };
            let [hip, knee, ankle] = leg.places;
            let rotor = |from: Vector<f64>, to: Vector<f64>| {
                Rotor::between(from.coordinates(), to.coordinates()).unwrap_or_default()
            };
            let upper = rotor(hip.vector_to(knee), bent.root.vector_to(bent.middle));
            let lower = rotor(knee.vector_to(ankle), bent.middle.vector_to(bent.end));
            place_limb(
                target,
                &mut pose,
                foot.joints,
                leg.places,
                &bent,
                [upper, lower],
            );
        }
        Ok(pose)
    }

    /// The clip of these frames of the recording, both ends included, at the recording's rate.
    ///
    /// # Errors
    ///
    /// [`RecordingError::FrameRange`].
    pub fn clip(&self, frames: RangeInclusive<usize>) -> Result<Clip, RecordingError> {
        self.retarget.check_range(&frames)?;
        let poses: Result<Vec<Pose>, _> = frames.map(|frame| self.pose(frame)).collect();
        Ok(Clip::new(self.retarget.source.frame_time(), poses?)?)
    }
}

impl Foot {
    /// What the times are like in which the foot stands.
    fn contact(&self, path: &[LegPose], stand: Stand) -> Contact {
        let Stand { frames, wanted, .. } = stand;
        let mut short_by: f64 = 0.0;
        let own = |frame: usize| Vector::from(path[frame].places[2]);
        let places: Vec<Vector<f64>> = frames
            .clone()
            .map(|frame| {
                let offset = self.offsets[frame];
                let found = match path[frame].bent(offset) {
                    Some(bent) => Vector::from(bent.end),
                    None => own(frame),
                };
                short_by = short_by.max(found.distance(wanted));
                found
            })
            .collect();
        Contact {
            ankle: self.joints[2],
            slide: extent(places.into_iter()),
            slide_before: extent(frames.clone().map(own)),
            frames,
            short_by,
        }
    }
}

impl LegPose {
    fn lengths(&self) -> [f64; 2] {
        let [hip, knee, ankle] = self.places;
        [hip.distance(knee), knee.distance(ankle)]
    }

    /// How far from the hip the ankle may be. A leg that is straighter than others stays so.
    fn reach(&self) -> f64 {
        let [upper, lower] = self.lengths();
        let now = self.places[0].distance(self.places[2]);
        now.max(STRETCHED * (upper + lower))
    }

    /// The leg with its ankle moved by an offset; `None` where it stays as it is.
    fn bent(&self, offset: Vector<f64>) -> Option<Bent> {
        if offset == Vector::default() {
            return None;
        }
        let [hip, knee, ankle] = self.places.map(Vector::from);
        let [upper, lower] = self.lengths();
        let wanted = within(hip, self.reach(), ankle + offset);
        // The side of a straight leg's knee is noise: it bends forwards, more so the farther the
        // ankle moves.
        let beside = (knee - hip).reject(ankle - hip).unwrap_or_default();
        let straight = STRAIGHT * (upper + lower);
        let doubt = (1.0 - beside.length() / (4.0 * straight)).max(0.0);
        let wish = straight.min(offset.length()) - beside.dot(self.forward);
        let pole = knee + self.forward * (doubt * wish.max(0.0));
        let [hip, wanted, pole] = [hip, wanted, pole].map(Point::from);
        TwoBone::new(upper, lower)
            .ok()?
            .solve(hip, wanted, pole)
            .ok()
    }
}

/// The runs of frames in which an ankle moves at most `step` a frame.
fn standing(ankle: &[Vector<f64>], step: f64) -> Vec<RangeInclusive<usize>> {
    let count = ankle.len();
    let mut stands = vec![false; count];
    for (frame, pair) in ankle.windows(2).enumerate() {
        if pair[0].distance(pair[1]) <= step {
            stands[frame] = true;
            stands[frame + 1] = true;
        }
    }
    for (frame, three) in ankle.windows(3).enumerate() {
        stands[frame + 1] |= three[0].distance(three[2]) <= 2.0 * step;
    }
    let mut runs = Vec::new();
    let mut first = None;
    for frame in 0..=count {
        let is_standing = stands.get(frame).copied().unwrap_or(false);
        match (first, is_standing) {
            (None, true) => first = Some(frame),
            (Some(begin), false) => {
                runs.push(begin..=frame - 1);
                first = None;
            }
            _ => {}
        }
    }
    runs
}

/// A run of frames in which an ankle stands.
#[derive(Clone, Debug)]
struct Stand {
    frames: RangeInclusive<usize>,
    /// Where it should stand, and the nearest place to that within the reach of the leg.
    wanted: Vector<f64>,
    place: Vector<f64>,
}

/// How far the ankle is moved in each frame, when it takes `blend` frames to come to where it
/// stands and to go from there.
fn offsets(path: &[LegPose], stands: &[Stand], blend: f64) -> Vec<Vector<f64>> {
    let own = |frame: usize| Vector::from(path[frame].places[2]);
    let mut offsets = vec![Vector::default(); path.len()];
    // How much of an offset is that of a standing foot.
    let mut shares = vec![0.0; path.len()];
    for stand in stands {
        for frame in stand.frames.clone() {
            offsets[frame] = stand.place - own(frame);
            shares[frame] = 1.0;
        }
    }
    let mut add = |frame: usize, away: usize, length: f64, offset: Vector<f64>| {
        let t = (away as f64 / length).min(1.0);
        let share = 1.0 - t * t * (3.0 - 2.0 * t);
        offsets[frame] += offset * share;
        shares[frame] += share;
    };
    for (number, stand) in stands.iter().enumerate() {
        let (first, last) = (*stand.frames.start(), *stand.frames.end());
        let after = stands.get(number + 1).map(|next| *next.frames.start());
        let before = number
            .checked_sub(1)
            .map(|before| *stands[before].frames.end());
        let [at_first, at_last] = [first, last].map(|frame| stand.place - own(frame));
        let length = after.map_or(blend, |after| blend.min((after - last) as f64));
        for frame in last + 1..after.unwrap_or(path.len()) {
            add(frame, frame - last, length, at_last);
        }
        let length = before.map_or(blend, |before| blend.min((first - before) as f64));
        for frame in before.map_or(0, |before| before + 1)..first {
            add(frame, first - frame, length, at_first);
        }
    }
    for ((offset, share), leg) in offsets.iter_mut().zip(shares).zip(path) {
        let [upper, lower] = leg.lengths();
        let below = -(leg.lowest + offset.e2);
        // What is far below the ground is meant to be there.
        let near = NEAR_GROUND * (upper + lower);
        let raised = below.min(2.0 * near - below).max(0.0);
        offset.e2 += raised * (1.0 - share);
    }
    offsets
}

impl Stand {
    fn new(path: &[LegPose], frames: RangeInclusive<usize>) -> Self {
        let run = &path[frames.clone()];
        let count = run.len() as f64;
        let ankles = run.iter().map(|leg| Vector::from(leg.places[2]));
        let mut wanted = ankles.sum::<Vector<f64>>() / count;
        let [upper, lower] = run[0].lengths();
        let lowest = run.iter().map(|leg| leg.lowest).sum::<f64>() / count;
        if lowest.abs() <= NEAR_GROUND * (upper + lower) {
            wanted.e2 -= lowest;
        }
        // By projection onto the balls in which the ankle can be, in turn.
        const ROUNDS: usize = 100;
        let mut place = wanted;
        for _ in 0..ROUNDS {
            let before = place;
            for leg in run {
                place = within(leg.places[0].into(), leg.reach(), place);
            }
            if place == before {
                break;
            }
        }
        Self {
            frames,
            wanted,
            place,
        }
    }
}

/// The nearest place within a distance of a centre.
fn within(centre: Vector<f64>, distance: f64, place: Vector<f64>) -> Vector<f64> {
    let away = place - centre;
    let length = away.length();
    if length <= distance {
        place
    } else {
        centre + away * (distance / length)
    }
}

/// The diagonal of the box about some places, which no two of them exceed in distance.
fn extent(places: impl Iterator<Item = Vector<f64>>) -> f64 {
    let bounds = places.fold(None, |bounds: Option<[Vector<f64>; 2]>, place| {
        let [low, high] = bounds.unwrap_or([place; 2]);
        Some([low.min(place), high.max(place)])
    });
    bounds.map_or(0.0, |[low, high]| low.distance(high))
}
