//! The models of cameras in COLMAP.

use crate::format::error::{CameraFileError, Place};
use crate::format::fields::pinhole;
use crate::format::lens::stated_lens;
use crate::{Intrinsics, LensModel};

/// The middle of the first pixel.
pub(super) const HALF: f64 = 0.5;

/// A model, its number in binary files, and how many parameters it has.
#[derive(Clone, Copy, Debug)]
pub(super) struct Model {
    pub(super) name: &'static str,
    pub(super) number: i32,
    pub(super) parameters: usize,
    /// Whether there is one focal length for both directions.
    has_one_focal: bool,
    pub(super) lens: LensModel,
}

const fn model(
    name: &'static str,
    number: i32,
    parameters: usize,
    has_one_focal: bool,
    lens: LensModel,
) -> Model {
    Model {
        name,
        number,
        parameters,
        has_one_focal,
        lens,
    }
}

/// The models that are read. Their coefficients are in OpenCV's order.
const MODELS: [Model; 9] = [
    model("SIMPLE_PINHOLE", 0, 3, true, LensModel::Pinhole),
    model("PINHOLE", 1, 4, false, LensModel::Pinhole),
    model("SIMPLE_RADIAL", 2, 4, true, LensModel::RadialTangential),
    model("RADIAL", 3, 5, true, LensModel::RadialTangential),
    model("OPENCV", 4, 8, false, LensModel::RadialTangential),
    model("OPENCV_FISHEYE", 5, 8, false, LensModel::Fisheye),
    model("FULL_OPENCV", 6, 12, false, LensModel::RadialTangential),
    model("SIMPLE_RADIAL_FISHEYE", 8, 4, true, LensModel::Fisheye),
    model("RADIAL_FISHEYE", 9, 5, true, LensModel::Fisheye),
];

/// Models that are known and not read.
const OTHERS: [(&str, i32); 9] = [
    ("FOV", 7),
    ("THIN_PRISM_FISHEYE", 10),
    ("RAD_TAN_THIN_PRISM_FISHEYE", 11),
    ("SIMPLE_DIVISION", 12),
    ("DIVISION", 13),
    ("SIMPLE_FISHEYE", 14),
    ("FISHEYE", 15),
    ("EUCM", 16),
    ("EQUIRECTANGULAR", 17),
];

/// Whether a word is the name of a model.
pub(super) fn is_name(word: &str) -> bool {
    let all = MODELS.iter().map(|model| model.name);
    all.chain(OTHERS.map(|(name, _)| name))
        .any(|name| name == word)
}

/// The model of a name or of a number.
pub(super) fn find(
    name: Option<&str>,
    number: i32,
    place: impl FnOnce() -> Place,
) -> Result<Model, CameraFileError> {
    let fits = |other: &str, other_number| match name {
        Some(name) => name == other,
        None => number == other_number,
    };
    let found = MODELS
        .into_iter()
        .find(|model| fits(model.name, model.number));
    found.ok_or_else(|| {
        let mut others = OTHERS.iter();
        let other = others.find(|(name, number)| fits(name, *number));
        CameraFileError::Model {
            place: place(),
            found: match (name, other) {
                (Some(name), _) => name.into(),
                (None, Some((name, _))) => (*name).into(),
                (None, None) => number.to_string().into(),
            },
            known: Box::new(MODELS.map(|model| model.name)),
        }
    })
}

impl Model {
    /// The camera with these parameters, as many as the model has.
    pub(super) fn intrinsics(
        &self,
        parameters: &[f64],
        place: impl Fn() -> Place,
    ) -> Result<Intrinsics, CameraFileError> {
        let (focal, rest) = match (self.has_one_focal, parameters) {
            (true, [f, rest @ ..]) => ([*f, *f], rest),
            (false, [fx, fy, rest @ ..]) => ([*fx, *fy], rest),
            _ => ([0.0; 2], parameters),
        };
        let (principal, mut coefficients) = match rest {
            [cx, cy, rest @ ..] => ([cx - HALF, cy - HALF], rest.to_vec()),
            _ => ([0.0; 2], Vec::new()),
        };
        let least = match self.lens {
            LensModel::Pinhole => 0,
            LensModel::RadialTangential | LensModel::Fisheye => 4,
        };
        coefficients.resize(coefficients.len().max(least), 0.0);
        let plain = pinhole(focal, principal, &place)?;
        Ok(plain.with_lens(stated_lens(&coefficients, self.lens, place)?))
    }
}

/// The model of a camera that is written, and its parameters; `None` for a lens that none has.
pub(super) fn of(intrinsics: &Intrinsics) -> Option<(&'static str, Vec<f64>)> {
    let (focal, principal) = (intrinsics.focal(), intrinsics.principal());
    let all = intrinsics.lens().coefficients();
    let used = all.iter().rposition(|x| *x != 0.0).map_or(0, |k| k + 1);
    let (name, count) = match (intrinsics.lens().model(), used) {
        (LensModel::Fisheye, _) => ("OPENCV_FISHEYE", 4),
        (_, 0) => ("PINHOLE", 0),
        (_, 1..=4) => ("OPENCV", 4),
        (_, 5..=8) => ("FULL_OPENCV", 8),
        _ => return None,
    };
    let mut parameters = focal.to_vec();
    parameters.extend(principal.map(|c| c + HALF));
    parameters.extend_from_slice(&all[..count]);
    Some((name, parameters))
}
