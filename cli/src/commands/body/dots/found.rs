//! What is found in a frame.

use ga_body::agreement::Agreement;
use ga_body::marked::MarkedBody;
use ga_body::marker::{Dot, DotOptions, find_dots};
use ga_body::{BodyError, JointPixel};
use ga_camera::Camera;
use ga_image::plane::Plane;

/// The camera of a film.
pub(super) struct View {
    pub(super) camera: Camera,
    /// How many times wider and higher its pictures are than those of the film.
    pub(super) scale: [f64; 2],
}

impl View {
    /// The dots in a picture of the film, in pixels of the camera.
    pub(super) fn dots(&self, picture: &Plane<[u8; 3]>) -> Vec<Dot> {
        let dots = find_dots(picture.view(), &DotOptions::default());
        let scaled = dots.into_iter().map(|dot| Dot {
            centre: [0, 1].map(|k| self.scale[k] * (dot.centre[k] + 0.5) - 0.5),
            semi_axes: dot.semi_axes.map(|semi_axis| self.scale[0] * semi_axis),
            ..dot
        });
        scaled.collect()
    }
}

/// What was found in a frame.
pub(super) struct Found {
    /// How many dots each view shows.
    pub(super) dots: Vec<usize>,
    pub(super) fit: Result<Fit, BodyError>,
}

/// A body that was recognised.
pub(super) struct Fit {
    /// For each view and each joint where it is.
    pub(super) joints: Vec<Vec<Option<JointPixel>>>,
    /// For each view the distances of the recognised dots from where the body has them, in pixels.
    pub(super) residuals_px: Vec<Vec<f64>>,
    /// The root mean square of these in standard deviations of the dots.
    pub(super) deviations: Option<f64>,
}

impl Found {
    pub(super) fn new(body: &MarkedBody, views: &[View], dots: Vec<Vec<Dot>>) -> Self {
        let cameras: Vec<Camera> = views.iter().map(|view| view.camera).collect();
        Self {
            fit: Fit::new(body, &cameras, &dots),
            dots: dots.iter().map(Vec::len).collect(),
        }
    }
}

impl Fit {
    fn new(body: &MarkedBody, cameras: &[Camera], dots: &[Vec<Dot>]) -> Result<Self, BodyError> {
        let found = body.fit(cameras, dots)?;
        let joints = body.joints(cameras, &found)?;
        let (fitted, seen) = ([found.fitted], [found.observation]);
        let agreement = Agreement::new(&fitted, &seen);
        let [fitted] = fitted;
        let residuals = fitted.residuals_px.iter();
        Ok(Self {
            joints,
            residuals_px: residuals
                .map(|view| view.iter().copied().flatten().collect())
                .collect(),
            deviations: agreement.of_frames[0],
        })
    }

    /// The numbers of the joints that are left out.
    pub(super) fn left_out(&self) -> impl Iterator<Item = usize> + '_ {
        let joints = 0..self.joints.first().map_or(0, Vec::len);
        joints.filter(|&joint| self.joints.iter().all(|view| view[joint].is_none()))
    }
}
