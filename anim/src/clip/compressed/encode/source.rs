//! What the encoder knows about a recording before it begins.

use ga_runtime::cga3::Rotor;
use ga_runtime::geometry::Affine;
use ga_runtime::vga3::Vector;
use rayon::prelude::*;

use super::super::layout::{self, JointLayout, Part};
use super::super::settings::JointBound;
use crate::recording::{ModelSpaceError, Recording, model_maps};

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
    /// The places, in a joint's own coordinates, of the joints that it carries: those whose places
    /// its rotation alone decides.
    pub(super) carried: Vec<Vec<Vector<f64>>>,
    /// How far a joint's rotation by one radian moves what it carries.
    pub(super) levers: Vec<f64>,
    /// A joint and all below it, in order.
    pub(super) subtrees: Vec<Vec<usize>>,
}

impl<'a> Source<'a> {
    /// A channel whose deviation from its constant moves no point by more than the part
    /// `negligible` of the tolerance is left out.
    pub(super) fn new(
        recording: &'a Recording,
        bounds: Vec<JointBound>,
        negligible: f64,
    ) -> Result<Self, ModelSpaceError> {
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
        let sizes = sizes(recording, &models);
        let mut tolerances: Vec<f64> = bounds.iter().map(|bound| bound.tolerance).collect();
        for joint in (0..count).rev() {
            if let Some(parent) = recording.parents()[joint] {
                tolerances[parent] = tolerances[parent].min(tolerances[joint]);
            }
        }
        let layouts: Vec<JointLayout> = (0..count)
            .into_par_iter()
            .map(|joint| {
                let negligible = negligible * tolerances[joint];
                layout(recording, joint, bounds[joint].shell, negligible, &sizes)
            })
            .collect();
        let carried: Vec<_> = (0..count).map(|joint| carried(&layouts, joint)).collect();
        let levers = carried.iter().zip(&bounds).map(|(carried, bound)| {
            carried
                .iter()
                .map(|place| place.length())
                .fold(bound.shell, f64::max)
        });
        Ok(Self {
            levers: levers.collect(),
            layouts,
            tolerances,
            subtrees: (0..count)
                .map(|joint| subtree(recording.parents(), joint))
                .collect(),
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

/// The greatest factor by which each joint's frame is scaled in model space.
fn sizes(recording: &Recording, models: &[Affine<f64>]) -> Vec<f64> {
    let count = recording.joints().len();
    let mut sizes = vec![0.0f64; count];
    for models in models.chunks_exact(count) {
        for (size, model) in sizes.iter_mut().zip(models) {
            let rows = model.linear.map(|row| Vector::from(row).length_squared());
            // The root of the sum of squares is at least the greatest singular value.
            *size = size.max((rows.iter().sum::<f64>() / 3.0).sqrt());
        }
    }
    sizes
}

fn layout(
    recording: &Recording,
    joint: usize,
    shell: f64,
    negligible: f64,
    sizes: &[f64],
) -> JointLayout {
    let count = recording.joints().len();
    let parent = recording.parents()[joint];
    let locals = || recording.locals().iter().skip(joint).step_by(count);
    let above = parent.map_or(1.0, |parent| sizes[parent].max(1e-9));
    // The farthest place that this joint's rotation moves, its children.
    let children = (0..count).filter(|&other| recording.parents()[other] == Some(joint));
    let reach = children
        .flat_map(|child| recording.locals().iter().skip(child).step_by(count))
        .map(|local| local.translation().length())
        .fold(shell, f64::max)
        * sizes[joint].max(1e-9);

    let vector = |values: &dyn Fn(usize) -> Vector<f64>, negligible: f64| {
        let frames = recording.frame_count();
        let sum = (0..frames).fold(Vector::default(), |sum, frame| sum + values(frame));
        let mean = layout::double(layout::single(sum * (frames as f64).recip()));
        let deviations: Vec<[f64; 3]> = (0..frames)
            .map(|frame| (values(frame) - mean).coordinates())
            .collect();
        Part::of_deviations(mean, &deviations, negligible)
    };
    let at = |frame: usize| recording.locals()[frame * count + joint];
    let translation = vector(&|frame| at(frame).translation(), negligible / above);
    let scale = vector(
        &|frame| at(frame).scale,
        negligible / (reach * above).max(1e-12),
    );
    let middle = layout::single_rotor(layout::middle(locals().map(|local| local.rotor())));
    let back = layout::double_rotor(middle).reverse();
    let deviations: Vec<[f64; 3]> = locals()
        .map(|local| layout::stereographic(canonical(back * local.rotor())))
        .collect();
    JointLayout {
        parent,
        translation,
        scale,
        rotation: Part::of_deviations(Vector::default(), &deviations, negligible / (4.0 * reach)),
        middle,
    }
}

/// The rotor of the same rotation with a scalar that is not negative.
pub(super) fn canonical(rotor: Rotor<f64>) -> Rotor<f64> {
    if rotor.scalar() < 0.0 { -rotor } else { rotor }
}

fn carried(layouts: &[JointLayout], joint: usize) -> Vec<Vector<f64>> {
    let mut places = Vec::new();
    // Frames that are rigidly attached to the joint's, with their maps to it.
    let mut attached: Vec<Option<Affine<f64>>> = vec![None; layouts.len()];
    attached[joint] = Some(Affine::default());
    for (other, layout) in layouts.iter().enumerate().skip(joint + 1) {
        let Some(map) = layout.parent.and_then(|parent| attached[parent]) else {
            continue;
        };
        if layout.translation.live > 0 {
            continue;
        }
        let place = layout::double(layout.translation.constant);
        let rotation = Affine::from(layout::double_rotor(layout.middle));
        let scaling = Affine::scaling(layout::double(layout.scale.constant).coordinates());
        let own = map * Affine::from_translation(place.coordinates());
        places.push(Vector::from(own.translation));
        if layout.is_still() {
            attached[other] = Some(own * rotation * scaling);
        }
    }
    places.retain(|place| place.length() > 1e-6);
    places
}

fn subtree(parents: &[Option<usize>], joint: usize) -> Vec<usize> {
    let mut below = vec![false; parents.len()];
    below[joint] = true;
    for other in joint + 1..parents.len() {
        below[other] = parents[other].is_some_and(|parent| below[parent]);
    }
    (joint..parents.len())
        .filter(|&other| below[other])
        .collect()
}
