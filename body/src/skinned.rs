//! Points that follow several joints by a blend of their motors.

use ga_anim::skin::{Binding, Method, Posed};
use ga_anim::weights::SkinWeights;
use ga_runtime::cga3::{Motor, Point};
use ga_runtime::vga3::Vector;

use super::model::BodyModel;

/// The points of a model that follow several joints, bound to them as vertices of the skin are.
#[derive(Clone, Debug)]
pub(super) struct Skinned {
    /// Which points they are.
    points: Vec<usize>,
    at_rest: Vec<Point<f64>>,
    binding: Binding<f64>,
    method: Method,
}

impl Skinned {
    /// `None` where the means of positions suffice.
    pub(super) fn new(model: &BodyModel) -> Option<Self> {
        let method = model.blending();
        let all = model.points();
        let points = (0..all.len()).filter(|&point| all[point].joints.len() > 1);
        let points: Vec<usize> = points.collect();
        if points.is_empty() || method == Method::Linear {
            return None;
        }
        let at_rest = points.iter().map(|&point| all[point].at_rest.into());
        let at_rest: Vec<Point<f64>> = at_rest.collect();
        let weights = points.iter().map(|&point| {
            let joints = &all[point].joints;
            let sum: f64 = joints.iter().map(|(_, weight)| weight).sum();
            let shares = joints.iter().filter(|(_, weight)| *weight > 0.0);
            shares
                .map(|&(joint, weight)| (joint as u32, weight / sum))
                .collect::<Vec<_>>()
        });
        let weights = SkinWeights::new(model.skeleton().len(), weights).ok()?;
        Some(Self {
            binding: Binding::new(&at_rest, &weights).ok()?,
            points,
            at_rest,
            method,
        })
    }

    /// Replaces the places of these points. To first order each of a point's joints moves it as if
    /// it was fixed there.
    pub(super) fn blend(
        &self,
        motions: &[Motor<f64>],
        points: &mut [Vector<f64>],
        parts: &mut [Vec<Vector<f64>>],
    ) {
        let mut palette = self.binding.palette(self.method);
        let mut moved = self.at_rest.clone();
        let posed = palette.set_motions(motions);
        // Motions of unit motors and lengths that fit are never refused.
        if posed.is_err()
            || self
                .binding
                .pose(&palette, Posed::of_points(&mut moved))
                .is_err()
        {
            return;
        }
        for (&point, place) in self.points.iter().zip(moved) {
            points[point] = place.into();
            parts[point].fill(place.into());
        }
    }
}
