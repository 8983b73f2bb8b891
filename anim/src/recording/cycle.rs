//! A part of a recording that is repeated.

use ga_runtime::cga3::{Motor, Rotor, Translator};
use ga_runtime::geometry::Affine;
use ga_runtime::vga3::Vector;

use super::{Recording, model_maps};
use crate::clip::about;
use crate::kinematics::KinematicsError;
use crate::recording::RecordingError;
use crate::transform::Transform;

/// By how much a joint may be rotated otherwise at the end of a cycle than at its begin, in
/// degrees, and by how much the body may be higher or lower, in metres. A step of a walk swings the
/// limbs by more, and the noise of a recording by less.
const CYCLIC_DEGREES: f64 = 15.0;
const CYCLIC_METRES: f64 = 0.05;

/// A part of a recording that is repeated, and the way on the ground in it, by which each
/// repetition begins where the one before ends.
///
/// With the frame F of the first joint that moves, at the begin and at the end of the cycle, the
/// way is the motor D that takes the place of one to that of the other along the ground, with the
/// part of the rotation about the vertical. In repetition k, roots move as `Dᵏ` times what is
/// recorded. What is left between end and begin, relative to the joints above, is spread evenly
/// over the cycle where it is small: a share of it in proportion to the time, so that neither
/// places nor speeds jump for it.
#[derive(Clone, Debug)]
pub struct Cycle {
    begin: f64,
    end: f64,
    way: Motor<f64>,
    /// What takes each joint at the end to that at the begin: a rotation, and what is added to the
    /// translation.
    corrections: Option<Vec<(Rotor<f64>, Vector<f64>)>>,
    seam: Seam,
}

/// What is left between the end of a [`Cycle`] and its begin.
#[derive(Clone, Debug, PartialEq)]
pub struct Seam {
    /// The joint that is rotated most.
    pub joint: usize,
    /// By how much, in radians.
    pub angle: f64,
    /// How much farther up or down the body is, in metres.
    pub height: f64,
}

impl Seam {
    /// Whether the end is like the begin: no joint is rotated by more than 15° and the body is not
    /// 5 cm higher or lower.
    #[must_use]
    pub fn is_cyclic(&self) -> bool {
        self.angle.to_degrees() <= CYCLIC_DEGREES && self.height.abs() <= CYCLIC_METRES
    }
}

impl Cycle {
    /// The whole recording as a cycle; `up` is the vertical. It ends at the last frame where that
    /// is like the first one, and one step later where the first one would be next. Where neither
    /// is so, it ends at the last frame, and each repetition begins with a jump, as its
    /// [`seam`](Self::seam) says.
    ///
    /// # Errors
    ///
    /// [`RecordingError::Kinematics`], and [`RecordingError::FrameTime`] for an `up` of zero.
    pub fn of_whole(recording: &Recording, up: Vector<f64>) -> Result<Self, RecordingError> {
        let (last, step) = (recording.duration(), recording.frame_time);
        let cycle = Self::new(recording, [0.0, last.max(step)], up, false)?;
        if recording.frame_count() < 3 {
            return Ok(cycle);
        }
        // How far frames are apart that follow each other.
        let first_step = Self::new(recording, [0.0, step], up, false)?;
        let last_step = Self::new(recording, [last - step, last], up, false)?;
        let apart = first_step.seam.angle.max(last_step.seam.angle);
        let is_next = (0.5 * apart..=2.0 * apart).contains(&cycle.seam.angle);
        if !is_next || !cycle.seam.is_cyclic() {
            return Ok(cycle);
        }
        Ok(Self {
            end: last + step,
            way: last_step.way * cycle.way,
            corrections: None,
            seam: Seam {
                joint: cycle.seam.joint,
                angle: 0.0,
                height: 0.0,
            },
            ..cycle
        })
    }

    /// The part of a recording between two times as a cycle, with what is left between end and
    /// begin spread over it, however much it is.
    ///
    /// # Errors
    ///
    /// [`RecordingError::Kinematics`], and [`RecordingError::FrameTime`] unless the end is after
    /// the begin.
    pub fn between(
        recording: &Recording,
        times: [f64; 2],
        up: Vector<f64>,
    ) -> Result<Self, RecordingError> {
        Self::new(recording, times, up, true)
    }

    fn new(
        recording: &Recording,
        [begin, end]: [f64; 2],
        up: Vector<f64>,
        is_closed: bool,
    ) -> Result<Self, RecordingError> {
        let up = up.normalized().filter(|_| end > begin);
        let up = up.ok_or(RecordingError::FrameTime(end - begin))?;
        let mut ends = [(); 2].map(|()| vec![Transform::default(); recording.joints.len()]);
        for (locals, time) in ends.iter_mut().zip([begin, end]) {
            recording.fill(recording.position(time), locals);
        }
        let [first, last] = &ends;
        let body = moving_joint(recording);
        let (from, from_rotor) = frame_of(recording, first, body)?;
        let (to, to_rotor) = frame_of(recording, last, body)?;
        let along = |v: Vector<f64>| v - up * v.dot(up);
        let translator = |v: Vector<f64>| Translator::from_displacement(v.coordinates());
        let heading = about(up, to_rotor * from_rotor.reverse()).unwrap_or_default();
        let way = translator(along(to)) * heading * translator(-along(from));

        let left = |joint: usize| {
            let next = match recording.parents[joint] {
                Some(_) => first[joint].motor,
                None => way * first[joint].motor,
            };
            let rotor = next.rotor() * last[joint].rotor().reverse();
            let place = Vector::from(next.translator().displacement());
            (rotor, place - last[joint].translation())
        };
        let left: Vec<(Rotor<f64>, Vector<f64>)> = (0..first.len()).map(left).collect();
        let angles = left.iter().map(|(rotor, _)| angle(*rotor)).enumerate();
        let (joint, angle) = angles
            .max_by(|a, b| a.1.total_cmp(&b.1))
            .unwrap_or((0, 0.0));
        let height = (to - from).dot(up);
        let seam = Seam {
            joint,
            angle,
            height,
        };
        Ok(Self {
            begin,
            end,
            way,
            corrections: (is_closed || seam.is_cyclic()).then_some(left),
            seam,
        })
    }

    /// How long a repetition is, in seconds.
    #[must_use]
    pub fn duration(&self) -> f64 {
        self.end - self.begin
    }

    /// What is left between the end and the begin.
    #[must_use]
    pub fn seam(&self) -> &Seam {
        &self.seam
    }

    /// The number of the repetition at a time, and the time in the recording.
    pub(super) fn within(&self, time: f64) -> (u64, f64) {
        if time.is_nan() || time < self.end {
            return (0, time);
        }
        let repetition = ((time - self.begin) / self.duration()).floor();
        let within = time - repetition * self.duration();
        (repetition as u64, within.clamp(self.begin, self.end))
    }

    /// The local transforms of a recording at a time, into one place for each joint.
    pub(super) fn fill(&self, recording: &Recording, time: f64, locals: &mut [Transform<f64>]) {
        let (repetition, within) = self.within(time);
        recording.fill(recording.position(within), locals);
        if let Some(corrections) = &self.corrections {
            let share = ((within - self.begin) / self.duration()).clamp(0.0, 1.0);
            for (local, (rotor, way)) in locals.iter_mut().zip(corrections) {
                let rotor = Rotor::default().interpolate(*rotor, share) * local.rotor();
                let place = local.translation() + *way * share;
                *local = Transform::from_parts(place, rotor, local.scale);
            }
        }
        let beyond = (within - recording.duration()) / recording.frame_time;
        if beyond > 0.0 {
            let mut next = vec![Transform::default(); locals.len()];
            recording.fill(0.0, &mut next);
            move_roots(recording, self.way, &mut next);
            for (local, next) in locals.iter_mut().zip(&next) {
                *local = local.interpolate(next, beyond.min(1.0));
            }
        }
        move_roots(recording, power(self.way, repetition), locals);
    }
}

fn move_roots(recording: &Recording, way: Motor<f64>, locals: &mut [Transform<f64>]) {
    let roots = locals.iter_mut().zip(&recording.parents);
    for (local, _) in roots.filter(|(_, parent)| parent.is_none()) {
        local.motor = way * local.motor;
    }
}

/// The first joint that moves relative to its parent.
fn moving_joint(recording: &Recording) -> usize {
    let count = recording.joints.len();
    let moves = |&joint: &usize| {
        let mut locals = recording.locals.iter().skip(joint).step_by(count);
        let first = locals.next();
        locals.any(|local| Some(local) != first)
    };
    (0..count).find(moves).unwrap_or(0)
}

/// Where a joint is in model space, and its rotation.
fn frame_of(
    recording: &Recording,
    locals: &[Transform<f64>],
    joint: usize,
) -> Result<(Vector<f64>, Rotor<f64>), KinematicsError> {
    let mut maps = vec![Affine::default(); locals.len()];
    model_maps(&recording.parents, locals, &mut maps)?;
    let above = |&joint: &usize| recording.parents[joint];
    let rotors = std::iter::successors(Some(joint), above).map(|joint| locals[joint].rotor());
    let rotor = rotors.fold(Rotor::default(), |below, own| own * below);
    Ok((maps[joint].translation.into(), rotor))
}

/// The angle of a rotor, the shorter way round.
fn angle(rotor: Rotor<f64>) -> f64 {
    let plane = Vector::new(rotor.e23(), rotor.e13(), rotor.e12());
    2.0 * plane.length().atan2(rotor.scalar().abs())
}

/// The product of as many factors.
fn power(factor: Motor<f64>, mut count: u64) -> Motor<f64> {
    let (mut product, mut square) = (Motor::default(), factor);
    while count > 0 {
        if count % 2 == 1 {
            product *= square;
        }
        square = square * square;
        count /= 2;
    }
    product
}
