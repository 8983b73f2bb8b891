//! A motion on the skeleton of a file, and how well it fits.

use serde::Serialize;
use serde_json::Value;

use super::checks::Checks;
use super::foot_locking::{Contact, FootLocking};
use super::joint_map::{JointMap, MapOrigin};
use super::mapping::Mapping;
use super::reference::FoundReference;
use super::source::Source;
use super::standing::StandingFoot;
use super::up_axis::FoundUpAxis;
use super::{Options, Retarget};
use crate::clip::Clip;
use crate::recording::RecordingError;
use crate::skeleton::Skeleton;

/// How a motion is transferred.
#[derive(Clone, Copy, Debug)]
pub struct TransferOptions<'a> {
    /// How the rotations are found.
    pub retarget: Options<'a>,
    /// Whether standing feet stay in their places.
    pub foot_locking: bool,
    /// The length of one unit of the motion in metres.
    pub motion_metres_per_unit: f64,
    /// The length of one unit of the target in metres.
    pub target_metres_per_unit: f64,
    /// The first and the last frame of the motion that is transferred; `None` for all.
    pub frames: Option<[usize; 2]>,
}

/// The frames of a motion on a target, and what is said of it.
#[derive(Clone, Debug, Serialize)]
pub struct Transfer {
    /// The motion of the target.
    #[serde(skip)]
    pub clip: Clip,
    /// How many frames there are.
    pub frames: usize,
    /// How many joints the target has.
    pub joints: usize,
    /// The time from one frame to the next.
    pub frame_time_seconds: f64,
    /// How long one unit of the motion is in units of the target.
    pub target_units_per_unit: f64,
    /// The length of one unit of the motion.
    pub motion_metres_per_unit: f64,
    /// The length of one unit of the target.
    pub target_metres_per_unit: f64,
    /// Where the map of the joints comes from.
    pub map_by: MapOrigin,
    /// The map as [`JointMap::to_json`] gives it.
    pub map: Value,
    /// How sure the map is.
    pub mapping: Mapping,
    /// The joints of the target that move with their parents.
    pub joints_without_counterpart: Vec<String>,
    /// Whether standing feet stay in their places.
    pub foot_locking: bool,
    /// The greatest [`StandingFoot::slide_metres`].
    pub slide_metres: f64,
    /// The greatest [`StandingFoot::slide_free_metres`].
    pub slide_free_metres: f64,
    /// The greatest [`StandingFoot::short_by_metres`].
    pub short_by_metres: f64,
    /// The feet that stand.
    pub feet: Vec<StandingFoot>,
    /// What the motions of the joints were found from.
    pub reference: FoundReference,
    /// The vertical of the motion.
    #[serde(skip)]
    pub up: Option<FoundUpAxis>,
    /// How far the motion is from standing at all, see [`Retarget::least_cost_of_standing`].
    #[serde(skip)]
    pub least_cost_of_standing: Option<f64>,
    /// What the motion of the target looks like.
    pub checks: Checks,
}

impl Transfer {
    /// Transfers a motion by a map of its joints.
    ///
    /// # Errors
    ///
    /// Those of [`Retarget::new`] and [`Retarget::with_foot_locking`].
    pub fn new(
        source: &dyn Source,
        skeleton: &Skeleton,
        (map, map_by): (&JointMap, MapOrigin),
        options: &TransferOptions,
    ) -> Result<Self, RecordingError> {
        let by_map = Options {
            map: Some(map),
            ..options.retarget
        };
        let retarget = Retarget::new(source, skeleton, &by_map)?;
        let foot_locking = FootLocking::new(options.motion_metres_per_unit);
        let locked = retarget.with_foot_locking(&foot_locking)?;
        let all = [0, source.frame_count().saturating_sub(1)];
        let [first, last] = options.frames.unwrap_or(all);
        let frames = first..=last;
        let clip = match options.foot_locking {
            true => locked.clip(frames)?,
            false => retarget.clip(frames)?,
        };
        let feet = StandingFoot::of_contacts(
            locked.contacts(),
            skeleton,
            options.target_metres_per_unit,
            options.foot_locking,
        );
        let contacts = match options.foot_locking {
            true => locked.contacts().to_vec(),
            false => locked
                .contacts()
                .iter()
                .map(Contact::without_locking)
                .collect(),
        };
        let checks = retarget.checks(&clip, first, &contacts, options.target_metres_per_unit)?;
        let greatest = |of: fn(&StandingFoot) -> f64| feet.iter().map(of).fold(0.0, f64::max);
        Ok(Self {
            frames: clip.frames().len(),
            joints: skeleton.len(),
            frame_time_seconds: clip.frame_time(),
            target_units_per_unit: retarget.scale(),
            motion_metres_per_unit: options.motion_metres_per_unit,
            target_metres_per_unit: options.target_metres_per_unit,
            map_by,
            map: map.to_json(source, skeleton),
            mapping: Mapping::new(
                source,
                (map, map_by),
                skeleton,
                options.retarget.target_motion.is_none(),
            ),
            joints_without_counterpart: retarget.unmatched().map(ToOwned::to_owned).collect(),
            foot_locking: options.foot_locking,
            slide_metres: greatest(|foot| foot.slide_metres),
            slide_free_metres: greatest(|foot| foot.slide_free_metres),
            short_by_metres: greatest(|foot| foot.short_by_metres),
            feet,
            reference: retarget.reference(),
            up: retarget.found_up_axis(),
            least_cost_of_standing: retarget.least_cost_of_standing(),
            checks,
            clip,
        })
    }
}
