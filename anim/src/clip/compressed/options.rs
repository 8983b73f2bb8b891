//! What a compressed clip must keep.

use super::named_bound::NamedBound;
use crate::clip::ClipError;
use crate::recording::RecordedJoint;

/// The bounds that a compressed clip keeps on every frame.
///
/// The error of a joint is the greatest distance, in model space, between a point that its true
/// frame carries and the same point in the decoded one, over all points that the true frame carries
/// within `shell` of the joint in model space. With the affine maps x' = L x + t of the frames,
///
/// ```text
/// error = ‖Δt‖ + shell ‖ΔL L⁻¹‖,
/// ```
///
/// where the norm is the greatest singular value: this is an upper bound of that greatest distance.
/// Without scale ‖ΔL L⁻¹‖ is ‖ΔL‖. A frame that is scaled below 1 % of its greatest scale in the
/// recording counts as scaled by 1 % of it, since the points near a joint that shrinks to nothing
/// have no end.
#[derive(Clone, Debug, PartialEq)]
pub struct Options {
    /// The greatest error of a joint in metres.
    pub tolerance: f64,
    /// The radius of the ball of points about a joint, in metres of model space.
    pub shell: f64,
    /// Joints with bounds of their own.
    pub joints: Vec<JointBound>,
    /// The greatest deviation of a scalar track.
    pub track_tolerance: f64,
}

/// The bound of one joint.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct JointBound {
    /// The joint's index.
    pub joint: usize,
    /// Its greatest error in metres.
    pub tolerance: f64,
    /// The radius of its ball of points in metres.
    pub shell: f64,
}

impl Default for Options {
    /// 0.1 mm for points within 3 cm, and 10⁻⁴ for scalar tracks.
    fn default() -> Self {
        Self {
            tolerance: 1e-4,
            shell: 0.03,
            joints: Vec::new(),
            track_tolerance: 1e-4,
        }
    }
}

impl Options {
    /// These bounds for all joints alike.
    #[must_use]
    pub fn new(tolerance: f64, shell: f64) -> Self {
        Self {
            tolerance,
            shell,
            ..Self::default()
        }
    }

    /// Adds a bound for all of these joints that have its name. Returns whether there are any.
    ///
    /// ```
    /// use ga_anim::clip::compressed::Options;
    /// use ga_anim::recording::RecordedJoint;
    /// use ga_anim::transform::Transform;
    ///
    /// let hand = RecordedJoint { name: "hand".into(), parent: None, rest: Transform::default() };
    /// let mut options = Options::new(1e-3, 0.03);
    /// assert!(options.bound_by_name(&"hand=0.0001".parse()?, &[hand.clone()]));
    /// let bound = options.joints[0];
    /// assert_eq!((bound.joint, bound.tolerance, bound.shell), (0, 0.0001, 0.03));
    /// assert!(!options.bound_by_name(&"foot=0.0001".parse()?, &[hand]));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn bound_by_name(&mut self, bound: &NamedBound, joints: &[RecordedJoint]) -> bool {
        let before = self.joints.len();
        let named = joints.iter().enumerate();
        let named = named.filter(|(_, joint)| joint.name == bound.name);
        let shell = bound.shell.unwrap_or(self.shell);
        self.joints.extend(named.map(|(joint, _)| JointBound {
            joint,
            tolerance: bound.tolerance,
            shell,
        }));
        self.joints.len() > before
    }

    /// The greatest shell of a joint.
    #[must_use]
    pub fn greatest_shell(&self) -> f64 {
        let shells = self.joints.iter().map(|bound| bound.shell);
        shells.fold(self.shell, f64::max)
    }

    /// Makes the tolerances of joints smaller by how far the recording already is from what it was
    /// made of, so that they hold against that. A deviation far below a tolerance is rounding and
    /// does not count.
    ///
    /// # Errors
    ///
    /// [`ClipError::Deviation`] where one of the tolerances does not leave room for it.
    pub fn leave_for(&mut self, deviation: f64) -> Result<(), ClipError> {
        // Far below single precision.
        const ROUNDING: f64 = 1e-5;
        let own = self.joints.iter_mut().map(|bound| &mut bound.tolerance);
        for tolerance in own.chain([&mut self.tolerance]) {
            // What is not a tolerance is refused later.
            if *tolerance > 0.0 && deviation > ROUNDING * *tolerance {
                if deviation >= *tolerance {
                    return Err(ClipError::Deviation {
                        deviation,
                        tolerance: *tolerance,
                    });
                }
                *tolerance -= deviation;
            }
        }
        Ok(())
    }

    pub(super) fn check(&self, joints: usize) -> Result<(), ClipError> {
        let own = self.joints.iter();
        let tolerances = own.clone().map(|bound| ("tolerance", bound.tolerance));
        let shells = own.clone().map(|bound| ("shell", bound.shell));
        let all = [
            ("tolerance", self.tolerance),
            ("tolerance of tracks", self.track_tolerance),
        ];
        for (name, value) in tolerances.chain(all) {
            if !value.is_finite() || value <= 0.0 {
                return Err(ClipError::Setting { name, value });
            }
        }
        for (name, value) in shells.chain([("shell", self.shell)]) {
            if !value.is_finite() || value < 0.0 {
                return Err(ClipError::Setting { name, value });
            }
        }
        match own.map(|bound| bound.joint).find(|&joint| joint >= joints) {
            Some(joint) => Err(ClipError::BoundJoint { joint, joints }),
            None => Ok(()),
        }
    }

    /// The bound of each of `joints` joints.
    pub(super) fn bounds(&self, joints: usize) -> Vec<JointBound> {
        let bound = |joint| JointBound {
            joint,
            tolerance: self.tolerance,
            shell: self.shell,
        };
        let mut bounds: Vec<_> = (0..joints).map(bound).collect();
        for own in &self.joints {
            if let Some(bound) = bounds.get_mut(own.joint) {
                *bound = *own;
            }
        }
        bounds
    }
}
