//! The body of a motion by itself: its legs, its vertical.

use ga_numerics::order_statistics::Sorted;
use ga_runtime::cga3::{Point, Rotor};
use ga_runtime::vga3::Vector;

use super::convention::{Part, Side};
use super::human::Human;
use super::joint_map::{has_legs, parts_of_names};
use super::source::Source;
use super::structure::{Parts, parts_by_structure};
use super::up_axis::{self, UpAxis};

/// How many frames are looked at where a few say what all would.
const FRAMES: usize = 100;

/// The joints of the body that a motion moves, with two legs.
#[derive(Clone, Debug)]
pub(crate) struct Body {
    /// Hip, knee and ankle of the left and the right leg.
    pub(crate) legs: [[usize; 3]; 2],
    human: Option<Human>,
}

impl Body {
    /// The body by the names of its joints, or where those do not tell both legs, by its structure:
    /// at rest or in a frame, with y or z up. `None` without two legs.
    pub(crate) fn of(source: &dyn Source) -> Option<Self> {
        let by_names = parts_of_names(source);
        let parts = match has_legs(&by_names) {
            true => by_names,
            false => Self::by_structure(source)?,
        };
        let first = |part, side| parts.get(&(part, Some(side)))?.first().copied();
        let sides = [Side::Left, Side::Right];
        let [Some(left), Some(right)] = sides.map(|side| {
            Some([
                first(Part::UpperLeg, side)?,
                first(Part::LowerLeg, side)?,
                first(Part::Foot, side)?,
            ])
        }) else {
            return None;
        };
        Some(Self {
            legs: [left, right],
            human: Human::new(&parts),
        })
    }

    fn by_structure(source: &dyn Source) -> Option<Parts> {
        let parents = source.parents();
        let frames = frames(source, 4).filter_map(|frame| places(source, frame));
        let at_rest = source.rest_positions().into_iter().map(Vector::from);
        let poses: Vec<Vec<Vector<f64>>> =
            std::iter::once(at_rest.collect()).chain(frames).collect();
        let upright = |up: UpAxis, pose: &[Vector<f64>]| -> Vec<[f64; 3]> {
            let upright = up.to_y();
            let place = |place: &Vector<f64>| upright.transform(Point::from(*place)).coordinates();
            pose.iter().map(place).collect()
        };
        let axes = [UpAxis::Y, UpAxis::Z].into_iter();
        let mut all = axes.flat_map(|up| {
            let (parents, upright) = (&parents, &upright);
            let parts = move |pose: &Vec<_>| parts_by_structure(parents, &upright(up, pose));
            poses.iter().filter_map(parts).collect::<Vec<_>>()
        });
        all.find(has_legs)
    }

    /// The length of thigh and shin together, in the unit of the motion: the mean of both legs, in
    /// the median over the frames. The bones at rest count where there are no frames.
    pub(crate) fn leg_length(&self, source: &dyn Source) -> Option<f64> {
        let length = |places: &[Vector<f64>]| {
            let legs = self.legs.map(|[hip, knee, ankle]| {
                places[hip].distance(places[knee]) + places[knee].distance(places[ankle])
            });
            0.5 * (legs[0] + legs[1])
        };
        let in_motion = frames(source, FRAMES).filter_map(|frame| places(source, frame));
        let mut lengths: Vec<f64> = in_motion.map(|places| length(&places)).collect();
        if lengths.is_empty() {
            let at_rest = source.rest_positions().into_iter().map(Vector::from);
            lengths.push(length(&at_rest.collect::<Vec<_>>()));
        }
        let length = Sorted::new(&mut lengths)?.quantile(0.5);
        (length.is_finite() && length > 0.0).then_some(length)
    }

    /// The rotation that makes the vertical of the motion the y axis; none where a head is not
    /// known, by which it is found.
    pub(crate) fn to_y_up(&self, source: &dyn Source) -> Rotor<f64> {
        let poses = frames(source, FRAMES).filter_map(|frame| places(source, frame));
        let poses: Vec<Vec<Vector<f64>>> = poses.collect();
        let moments = poses.iter().map(Vec::as_slice);
        let human = self.human.as_ref();
        let up = human.and_then(|human| up_axis::find(human, moments));
        up.map_or(UpAxis::Y, |up| up.axis).to_y()
    }
}

/// At most `most` frames that are spread over a motion.
fn frames(source: &dyn Source, most: usize) -> impl Iterator<Item = usize> {
    let count = source.frame_count();
    (0..count).step_by(count.div_ceil(most).max(1))
}

/// Where the joints are in a frame.
fn places(source: &dyn Source, frame: usize) -> Option<Vec<Vector<f64>>> {
    let frames = source.frames_of_joints(frame)?;
    let place = |motor: &ga_runtime::cga3::Motor<f64>| motor.translator().displacement().into();
    Some(frames.iter().map(place).collect())
}
