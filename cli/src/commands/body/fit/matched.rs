//! The joints of a file that a skeleton has.

use std::collections::BTreeMap;

use anyhow::Result;
use ga_anim::gltf::Rigged;
use ga_anim::skeleton::Skeleton;
use ga_body::format::JointViews;
use ga_body::format::correspondence::correspondence;
use ga_body::{BodyModel, Lengths, Observation, fit_lengths};
use ga_camera::Camera;

use super::arguments::FitLengths;

/// The joints of a file that a skeleton has.
pub(super) struct Matched {
    pub(super) model: BodyModel,
    /// For each point of the model which joint of the file it is.
    pub(super) order: Vec<Option<usize>>,
    pub(super) without_counterpart: Vec<String>,
    /// By the name of the joint, where lengths were fitted.
    pub(super) length_factors: Option<BTreeMap<String, f64>>,
}

impl Matched {
    pub(super) fn new(joints: &JointViews, skeleton: &Skeleton) -> Result<Self> {
        let found = correspondence(joints.joints(), skeleton)?;
        let (mut order, mut of_skeleton, mut without_counterpart) = (vec![], vec![], vec![]);
        for (index, (name, joint)) in joints.joints().iter().zip(found).enumerate() {
            match joint {
                Some(joint) => {
                    order.push(Some(index));
                    of_skeleton.push(skeleton.joints()[joint].name.clone());
                }
                None => without_counterpart.push(name.clone()),
            }
        }
        Ok(Self {
            model: BodyModel::of_joints(skeleton.clone(), &of_skeleton)?,
            order,
            without_counterpart,
            length_factors: None,
        })
    }

    /// The character with the lengths that the views show. The model then is that of this
    /// character.
    pub(super) fn fit_lengths(
        &mut self,
        body: &Rigged,
        cameras: &[Camera],
        observations: &[Observation],
        lengths: FitLengths,
    ) -> Result<Rigged> {
        let lengths = match lengths {
            FitLengths::Size => Lengths::OneFactor,
            FitLengths::Bones => Lengths::EachBone,
        };
        let factors = fit_lengths(&self.model, cameras, observations, lengths)?.factors;
        let body = body.with_lengths(&factors)?;
        let points = self.model.points().iter();
        let names: Vec<String> = points.map(|point| point.name.clone()).collect();
        self.model = BodyModel::of_joints(body.skeleton().clone(), &names)?;
        let joints = body.skeleton().joints().iter();
        let by_name = joints
            .zip(factors)
            .map(|(j, factor)| (j.name.clone(), factor));
        self.length_factors = Some(by_name.collect());
        Ok(body)
    }
}
