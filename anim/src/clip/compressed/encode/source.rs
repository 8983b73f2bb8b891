//! What the encoder knows about a recording before it begins.

use std::collections::VecDeque;

use ga_runtime::cga3::Rotor;
use ga_runtime::geometry::Affine;
use ga_runtime::vga3::Vector;
use rayon::prelude::*;

use super::super::layout::{self, JointLayout, Part};
use super::super::options::JointBound;
use super::super::shell::{Sizes, least_of};
use super::hierarchy::Hierarchy;
use crate::kinematics::KinematicsError;
use crate::recording::{Recording, model_maps};

/// A recording in model space, and the layout of its channels.
pub(super) struct Source<'a> {
    pub(super) recording: &'a Recording,
    pub(super) layouts: Vec<JointLayout>,
    pub(super) bounds: Vec<JointBound>,
    /// The least tolerance of a joint and all below it.
    pub(super) tolerances: Vec<f64>,
    /// By frame, then by joint.
    pub(super) models: Vec<Affine<f64>>,
    /// The rotation of each of `models` where the joint is [`conformal`](Self::conformal).
    pub(super) rotors: Vec<Rotor<f64>>,
    /// Whether all scaling of a joint and those above it is by the same positive factor along every
    /// axis, so that its map in model space is a rotation, a factor and a translation.
    pub(super) conformal: Vec<bool>,
    /// The places, in a joint's own coordinates, of joints that it carries: those whose places its
    /// rotation alone decides. They are the nearest in the hierarchy, at most [`MOST_CARRIED`].
    pub(super) carried: Vec<Vec<Vector<f64>>>,
    pub(super) levers: Vec<Levers>,
    pub(super) sizes: Sizes,
    pub(super) hierarchy: Hierarchy,
}

/// How far, in model space and at most, a change by 1 moves the points about a joint and those that
/// it carries.
#[derive(Clone, Copy, Debug)]
pub(super) struct Levers {
    /// Of its translation.
    pub(super) translation: f64,
    /// Of a factor of its scale.
    pub(super) scale: f64,
    /// Of the angle of its rotation, in radians.
    pub(super) rotation: f64,
}

impl Levers {
    /// The levers of a joint that carries places up to a distance in its own coordinates.
    fn new(recording: &Recording, sizes: &Sizes, joint: usize, distance: f64, shell: f64) -> Self {
        let above = recording.parents()[joint].map_or(1.0, |parent| sizes.greatest[parent]);
        let factors = recording.locals().iter().skip(joint);
        let factors = factors
            .step_by(recording.joints().len())
            .flat_map(|local| local.scale.abs().coordinates());
        let (least, greatest) = factors.fold((f64::INFINITY, 0.0f64), |(least, most), factor| {
            (least.min(factor), most.max(factor))
        });
        Self {
            translation: above,
            scale: (shell / least.max(least_of(greatest))).max(above * distance),
            rotation: shell.max(sizes.greatest[joint] * distance),
        }
    }
}

/// The most joints below a joint that its rotation is chosen for: their number must not grow with
/// the square of that of the joints.
const MOST_CARRIED: usize = 64;

impl<'a> Source<'a> {
    /// A channel whose deviation from its constant moves no point by more than the part
    /// `negligible` of the tolerance is left out.
    pub(super) fn new(
        recording: &'a Recording,
        bounds: Vec<JointBound>,
        negligible: f64,
    ) -> Result<Self, KinematicsError> {
        let count = recording.joints().len();
        let mut models = vec![Affine::default(); recording.locals().len()];
        for (locals, models) in recording
            .locals()
            .chunks_exact(count)
            .zip(models.chunks_exact_mut(count))
        {
            model_maps(recording.parents(), locals, models)?;
        }
        let conformal = conformal(recording);
        let rotors = rotors(recording);
        let sizes = Sizes::new(recording)?;
        let mut tolerances: Vec<f64> = bounds.iter().map(|bound| bound.tolerance).collect();
        for joint in (0..count).rev() {
            if let Some(parent) = recording.parents()[joint] {
                tolerances[parent] = tolerances[parent].min(tolerances[joint]);
            }
        }
        let hierarchy = Hierarchy::new(recording.parents());
        let layouts: Vec<JointLayout> = (0..count)
            .into_par_iter()
            .map(|joint| {
                let negligible = negligible * tolerances[joint];
                let distance = reach(recording, hierarchy.children(joint));
                let shell = bounds[joint].shell;
                let levers = Levers::new(recording, &sizes, joint, distance, shell);
                layout(recording, joint, &levers, negligible)
            })
            .collect();
        let carried: Vec<_> = (0..count)
            .map(|joint| carried(&layouts, &hierarchy, joint))
            .collect();
        let levers = carried.iter().enumerate().map(|(joint, carried)| {
            let lengths = carried.iter().map(|place| place.length());
            let distance = lengths.fold(0.0, f64::max);
            Levers::new(recording, &sizes, joint, distance, bounds[joint].shell)
        });
        Ok(Self {
            levers: levers.collect(),
            sizes,
            layouts,
            tolerances,
            hierarchy,
            bounds,
            models,
            rotors,
            conformal,
            carried,
            recording,
        })
    }

    pub(super) fn joints(&self) -> usize {
        self.layouts.len()
    }
}

fn conformal(recording: &Recording) -> Vec<bool> {
    let count = recording.joints().len();
    let mut conformal = vec![true; count];
    for locals in recording.locals().chunks_exact(count) {
        for (joint, local) in locals.iter().enumerate() {
            let [a, b, c] = local.scale.coordinates();
            conformal[joint] &= a > 0.0 && a == b && b == c;
        }
    }
    for joint in 0..count {
        if let Some(parent) = recording.parents()[joint] {
            conformal[joint] &= conformal[parent];
        }
    }
    conformal
}

fn rotors(recording: &Recording) -> Vec<Rotor<f64>> {
    let count = recording.joints().len();
    let mut rotors: Vec<Rotor<f64>> = Vec::with_capacity(recording.locals().len());
    for locals in recording.locals().chunks_exact(count) {
        let begin = rotors.len();
        for (local, parent) in locals.iter().zip(recording.parents()) {
            let own = local.rotor();
            rotors.push(parent.map_or(own, |parent| rotors[begin + parent] * own));
        }
    }
    rotors
}

/// The farthest place of a child from a joint, in the joint's own coordinates.
fn reach(recording: &Recording, children: &[usize]) -> f64 {
    let count = recording.joints().len();
    children
        .iter()
        .flat_map(|&child| recording.locals().iter().skip(child).step_by(count))
        .map(|local| local.translation().length())
        .fold(0.0, f64::max)
}

fn layout(recording: &Recording, joint: usize, levers: &Levers, negligible: f64) -> JointLayout {
    let count = recording.joints().len();
    let parent = recording.parents()[joint];
    let locals = || recording.locals().iter().skip(joint).step_by(count);
    // Where a lever is 0, nothing is seen of what it moves.
    let within = |lever: f64| negligible / lever.max(1e-12);

    let vector = |values: &dyn Fn(usize) -> Vector<f64>, usual: Vector<f64>, negligible: f64| {
        let frames = recording.frame_count();
        let usual = layout::double(layout::single(usual));
        let stays = |frame| (values(frame) - usual).length() <= USUAL * negligible;
        if (0..frames).all(stays) {
            return Part::constant(usual);
        }
        let sum = (0..frames).fold(Vector::default(), |sum, frame| sum + values(frame));
        let mean = layout::double(layout::single(sum * (frames as f64).recip()));
        let deviations: Vec<[f64; 3]> = (0..frames)
            .map(|frame| (values(frame) - mean).coordinates())
            .collect();
        in_few_bytes(Part::of_deviations(mean, &deviations, negligible))
    };
    let at = |frame: usize| recording.locals()[frame * count + joint];
    let rest = recording.joints()[joint].rest;
    let translation = vector(
        &|frame| at(frame).translation(),
        rest.translation(),
        within(levers.translation),
    );
    let scale = vector(
        &|frame| at(frame).scale,
        Vector::new(1.0, 1.0, 1.0),
        within(levers.scale),
    );
    let rotation = |middle: Rotor<f32>| {
        let back = layout::double_rotor(middle).reverse();
        let deviations: Vec<[f64; 3]> = locals()
            .map(|local| layout::stereographic((back * local.rotor()).canonical()))
            .collect();
        Part::of_deviations(
            Vector::default(),
            &deviations,
            within(4.0 * levers.rotation),
        )
    };
    let middle = layout::single_rotor(layout::middle(locals().map(|local| local.rotor())));
    let near = layout::from_steps(layout::to_steps(middle));
    let (middle, rotation) = match (rotation(middle), rotation(near)) {
        (exact, rounded) if exact.live == 3 && rounded.live == 3 => (near, in_few_bytes(rounded)),
        (exact, _) => (middle, exact),
    };
    JointLayout {
        parent,
        translation,
        scale,
        rotation,
        middle,
    }
}

/// A vector that stays this near to what is usual for it, in parts of what is negligible, is taken
/// to be that: the translation at rest, or factors of 1, which take no bytes in the file.
const USUAL: f64 = 0.2;

/// Three axes span everything wherever they are, so those near the principal axes with which the
/// rotor takes few bytes do as well.
fn in_few_bytes(part: Part) -> Part {
    let axes = match part.live {
        3 => layout::from_steps(layout::to_steps(part.axes)),
        _ => part.axes,
    };
    Part { axes, ..part }
}

fn carried(layouts: &[JointLayout], hierarchy: &Hierarchy, joint: usize) -> Vec<Vector<f64>> {
    let mut places = Vec::new();
    // Joints below whose parents are rigidly attached, with the maps of those to the joint.
    let below = |joint: usize, map: Affine<f64>| {
        let children = hierarchy.children(joint).iter().take(MOST_CARRIED);
        children.map(move |&child| (child, map))
    };
    let mut queue: VecDeque<(usize, Affine<f64>)> = below(joint, Affine::default()).collect();
    for _ in 0..MOST_CARRIED {
        let Some((other, map)) = queue.pop_front() else {
            break;
        };
        let layout = &layouts[other];
        if layout.translation.live > 0 {
            continue;
        }
        let place = layout::double(layout.translation.constant);
        let rotation = Affine::from(layout::double_rotor(layout.middle));
        let scaling = Affine::scaling(layout::double(layout.scale.constant).coordinates());
        let own = map * Affine::from_translation(place.coordinates());
        places.push((other, Vector::from(own.translation)));
        if layout.is_still() && queue.len() < MOST_CARRIED {
            queue.extend(below(other, own * rotation * scaling));
        }
    }
    places.sort_unstable_by_key(|&(other, _)| other);
    let places = places.into_iter().map(|(_, place)| place);
    places.filter(|place| place.length() > 1e-6).collect()
}
