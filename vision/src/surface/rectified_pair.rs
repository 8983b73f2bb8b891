//! Rectified views with their cameras, and the disparities of what both see.

use ga_camera::rig::{RectifiedRig, StereoRig};
use ga_image::grey::Luma;
use ga_image::picture::Picture;
use ga_image::plane::Plane;
use ga_runtime::cga3::Motor;

use super::pair::{disparity_range, seen_by_both};
use crate::diagnosis::of_match::{MatchFault, faults_of_match};
use crate::disparity::{DisparityMap, StereoError};
use crate::matcher::{GREATEST_RANGE, Matcher, MatcherOptions, Mode};
use crate::rectification::{Rectification, RectificationOptions};

/// Two rectified views in colour, which of their pixels were seen, and the cameras.
#[derive(Clone, Debug)]
pub struct RectifiedPair {
    views: [Plane<[u8; 3]>; 2],
    /// The same in grey, as deep as the pictures are.
    grey: [Plane<u16>; 2],
    inside: [Plane<bool>; 2],
    rig: RectifiedRig,
    to_left: Motor<f64>,
}

/// How the disparities of a [`RectifiedPair`] are found.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct PairOptions {
    /// The least disparity in pixels.
    pub min_disparity: i32,
    /// Disparities are less than this number of pixels; without it, the views decide.
    pub max_disparity: Option<i32>,
    /// How much work is done.
    pub mode: Mode,
    /// The number of threads; 0 for as many as the machine can run at the same time.
    pub threads: usize,
    /// Disparities that are less certain, from 0 to 1, are unknown.
    pub least_confidence: f32,
}

/// The disparities of a [`RectifiedPair`].
#[derive(Clone, Debug)]
pub struct PairMatch {
    /// Those of what both cameras see.
    pub disparity: DisparityMap,
    /// The range that was looked at: the least one, and the first one beyond the greatest.
    pub range: [i32; 2],
    /// Why the views were matched badly, where they were.
    pub faults: Vec<MatchFault>,
}

impl RectifiedPair {
    /// Views that are rectified already.
    #[must_use]
    pub fn new(views: &[Picture; 2], rig: RectifiedRig) -> Self {
        let inside = |view: &Picture| Plane::filled(view.width(), view.height(), true);
        Self {
            inside: views.each_ref().map(inside),
            views: views.each_ref().map(Picture::to_rgb),
            grey: grey(views),
            rig,
            to_left: Motor::default(),
        }
    }

    /// Views as two cameras took them, rectified with their focal length kept.
    ///
    /// # Errors
    /// [`StereoError::Geometry`] for cameras whose views cannot be rectified, and
    /// [`StereoError::Plane`] for views of different sizes.
    pub fn rectify(views: &[Picture; 2], rig: &StereoRig) -> Result<Self, StereoError> {
        let [left, right] = views;
        let size = [left.width(), left.height()];
        let found = Rectification::new(rig, size, RectificationOptions::default());
        let found = found.map_err(|error| StereoError::Geometry(Box::new(error)))?;
        let maps = [found.left_map(), found.right_map()];
        let views = [
            left.view().warped(&maps[0])?,
            right.view().warped(&maps[1])?,
        ];
        Ok(Self {
            views: views.each_ref().map(Picture::to_rgb),
            grey: grey(&views),
            inside: maps.each_ref().map(ga_image::warp::Warp::inside),
            rig: found.rig,
            to_left: found.left.motor.reverse(),
        })
    }

    /// The left and the right view. What no camera saw is black.
    #[must_use]
    pub fn views(&self) -> &[Plane<[u8; 3]>; 2] {
        &self.views
    }

    /// The rectified cameras.
    #[must_use]
    pub fn rig(&self) -> &RectifiedRig {
        &self.rig
    }

    /// From the frame of the rectified left camera into that of the left camera.
    #[must_use]
    pub fn to_left(&self) -> Motor<f64> {
        self.to_left
    }

    /// The disparities of what both cameras see.
    ///
    /// # Errors
    /// [`StereoError`] for views that cannot be matched.
    pub fn disparities(&self, options: &PairOptions) -> Result<PairMatch, StereoError> {
        let PairOptions {
            min_disparity,
            mode,
            threads,
            ..
        } = *options;
        let [left, right] = &self.grey;
        let beyond = match options.max_disparity {
            Some(beyond) => beyond,
            None => {
                let most = left.width().min(GREATEST_RANGE) as i32;
                let found = disparity_range(left, right, threads)? as i32;
                found.min(min_disparity.saturating_add(most))
            }
        };
        let range = [min_disparity, beyond];
        let of_matcher = MatcherOptions {
            range,
            mode,
            threads,
        };
        let mut matcher = Matcher::new(of_matcher, left.width(), left.height())?;
        let found = matcher.run(left, right)?;
        let faults = faults_of_match([left, right], &found, range);
        let [left, right] = self.inside.each_ref().map(Plane::view);
        let certain = found.at_least(options.least_confidence).disparity;
        Ok(PairMatch {
            disparity: seen_by_both(&certain, [left, right])?,
            range,
            faults,
        })
    }
}

/// Views in grey by the weights of ITU-R BT.601.
fn grey(views: &[Picture; 2]) -> [Plane<u16>; 2] {
    views.each_ref().map(|view| view.to_grey(Luma::Bt601))
}
