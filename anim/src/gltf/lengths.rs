//! Rigged documents whose bones have other lengths.

use ga_runtime::cga3::Point;
use ga_runtime::geometry::Affine;
use ga_runtime::vga3::Vector;

use super::parts::{to_node, uniform_parts};
use super::rigged::Rigged;
use crate::file_error::MotionFileError;
use crate::skeleton::{Joint, Skeleton, SkeletonError};
use crate::transform::Transform;

impl Rigged {
    /// The document with bones of other lengths: for each joint the factor of the way from the
    /// joint above it. A joint without one above it has the factor f of everything below it: its
    /// node is scaled, and its head h is at f h. The nodes below are moved along the ways, so that
    /// the skin keeps its inverse bind matrices: parts beside a bone grow by f, and what a bone is
    /// longer or shorter beyond that stretches the skin where it is blended between two joints.
    ///
    /// Animations are left out, since their translations are for the old lengths.
    ///
    /// # Errors
    ///
    /// [`MotionFileError::Skeleton`] for another number of factors than joints,
    /// [`MotionFileError::Length`] for a factor that is not positive and finite,
    /// [`MotionFileError::NonUniformScale`], and where the longer bones are not finite.
    ///
    /// # Examples
    ///
    /// ```
    /// use ga_anim::gltf::Rigged;
    /// use ga_anim::skeleton::{Joint, Skeleton};
    ///
    /// let joint = |name: &str, parent, y: f64| Joint {
    ///     name: name.into(),
    ///     parent,
    ///     head: [0.0, y, 0.0],
    ///     tail: [0.0, y + 0.25, 0.0],
    /// };
    /// let arm = [joint("shoulder", None, 1.0), joint("elbow", Some(0), 1.25)];
    /// let rigged = Rigged::of_skeleton(&Skeleton::new(arm.to_vec())?);
    /// let longer = rigged.with_lengths(&[2.0, 3.0])?;
    /// let heads = longer.skeleton().joints().iter().map(|joint| joint.head[1]);
    /// assert_eq!(heads.collect::<Vec<_>>(), [2.0, 2.75]);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn with_lengths(&self, factors: &[f64]) -> Result<Self, MotionFileError> {
        let (expected, found) = (self.nodes.len(), factors.len());
        if expected != found {
            return Err(SkeletonError::PoseLength { expected, found }.into());
        }
        let joints = self.skeleton.joints();
        for (joint, &factor) in joints.iter().zip(factors) {
            if !(factor > 0.0 && factor.is_finite()) {
                let joint = joint.name.clone();
                return Err(MotionFileError::Length { joint, factor });
            }
        }
        let player = super::Player::new(&self.document)?;
        let rest = player.pose(None, 0.0)?;
        let mut document = self.document.clone();
        document.animations.clear();
        // For each joint the factor of the tree that it is in.
        let mut of_tree: Vec<f64> = Vec::with_capacity(joints.len());
        for (joint, &node) in self.nodes.iter().enumerate() {
            let local = uniform_parts(&rest.locals[node])
                .ok_or(MotionFileError::NonUniformScale { node })?;
            let (mut place, mut scale) = (local.translation(), local.scale);
            let whole = match joints[joint].parent {
                Some(parent) => {
                    let whole = of_tree[parent];
                    place *= factors[joint] / whole;
                    whole
                }
                None => {
                    let whole = factors[joint];
                    scale *= whole;
                    let back = match player.parents()[node] {
                        Some(above) => {
                            let back = rest.world[above].inverse();
                            back.ok_or(MotionFileError::NonUniformScale { node: above })?
                        }
                        None => Affine::default(),
                    };
                    let head = Vector::from(joints[joint].head) * whole;
                    place = back.transform(Point::from(head)).coordinates().into();
                    whole
                }
            };
            of_tree.push(whole);
            let local = Transform::from_parts(place, local.rotor(), scale);
            document.nodes[node].transform = to_node(&local);
        }
        let rest = super::Player::new(&document)?.pose(None, 0.0)?;
        let heads = self.nodes.iter().map(|&node| rest.world[node].translation);
        let heads: Vec<Vector<f64>> = heads.map(Vector::from).collect();
        Ok(Self {
            skeleton: with_heads(&self.skeleton, &heads, &of_tree)?,
            nodes: self.nodes.clone(),
            document,
        })
    }
}

/// The skeleton with its heads in other places. Where a bone ends beside the joints below it, it
/// still does so, farther by a factor.
fn with_heads(
    skeleton: &Skeleton,
    heads: &[Vector<f64>],
    factors: &[f64],
) -> Result<Skeleton, SkeletonError> {
    let old: Vec<Vector<f64>> = skeleton.joints().iter().map(|j| j.head.into()).collect();
    let joints = skeleton.joints().iter().enumerate().map(|(index, joint)| {
        // The mean place of the joints below, or of the joint itself.
        let end = |heads: &[Vector<f64>]| {
            let below = skeleton.children(index).map(|child| heads[child]);
            let (sum, count) =
                below.fold((Vector::ZERO, 0_u32), |(sum, n), head| (sum + head, n + 1));
            match count {
                0 => heads[index],
                count => sum / f64::from(count),
            }
        };
        let beside = Vector::from(joint.tail) - end(&old);
        Joint {
            head: heads[index].into(),
            tail: (end(heads) + beside * factors[index]).into(),
            ..joint.clone()
        }
    });
    Skeleton::new(joints.collect())
}
