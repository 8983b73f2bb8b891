//! The lens of some coefficients, of which a file may not state the kind.

use super::error::{CameraFileError, Place, refused};
use crate::{Lens, LensModel};

/// The lenses that coefficients may be of, where the file does not state their kind.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct UnstatedLens {
    /// Where the coefficients stand.
    pub(super) place: Place,
    /// One of each kind.
    lenses: [Lens; 2],
    /// Whether all coefficients are zero: then they are those of a pinhole, as programs write them
    /// for pictures without distortion, unless it is said that the lens is a fisheye.
    are_zero: bool,
}

impl UnstatedLens {
    /// Whether it must be said which of the lenses it is.
    pub(super) fn is_unclear(&self) -> bool {
        !self.are_zero
    }

    /// The lens of a kind, where it may be one.
    pub(super) fn of_model(&self, model: LensModel) -> Option<Lens> {
        let mut lenses = self.lenses.iter().copied();
        lenses.find(|lens| lens.model() == model)
    }
}

/// The lens of coefficients in OpenCV's order. One whose kind is not stated is radial–tangential,
/// as that of most files, unless it has four coefficients.
pub(super) fn lens(
    values: &[f64],
    stated: Option<LensModel>,
    place: impl FnOnce() -> Place,
) -> Result<(Lens, Option<UnstatedLens>), CameraFileError> {
    match stated {
        None if values.len() == 4 => {
            let (lens, unstated) = unstated_lens(values, values, place)?;
            Ok((lens, Some(unstated)))
        }
        stated => {
            let model = stated.unwrap_or(LensModel::RadialTangential);
            Ok((stated_lens(values, model, place)?, None))
        }
    }
}

/// The lens of coefficients whose kind is stated. One that is not a fisheye and without distortion
/// is a pinhole.
pub(super) fn stated_lens(
    values: &[f64],
    model: LensModel,
    place: impl FnOnce() -> Place,
) -> Result<Lens, CameraFileError> {
    let are_zero = values.iter().all(|x| *x == 0.0);
    let lens = match model {
        LensModel::Fisheye => model.lens(values),
        _ if values.is_empty() => Ok(Lens::Pinhole),
        LensModel::Pinhole if are_zero => Ok(Lens::Pinhole),
        LensModel::Pinhole => model.lens(values),
        LensModel::RadialTangential => match model.lens(values) {
            Ok(_) if are_zero => Ok(Lens::Pinhole),
            other => other,
        },
    };
    lens.map_err(|error| refused(place(), error))
}

/// The lens of the coefficients that it has as a radial–tangential one and as a fisheye.
pub(super) fn unstated_lens(
    radial_tangential: &[f64],
    fisheye: &[f64],
    place: impl FnOnce() -> Place,
) -> Result<(Lens, UnstatedLens), CameraFileError> {
    let place = place();
    let of_model = |model: LensModel, values| {
        let lens = model.lens(values);
        lens.map_err(|error| refused(place.clone(), error))
    };
    let radial = of_model(LensModel::RadialTangential, radial_tangential)?;
    let lenses = [radial, of_model(LensModel::Fisheye, fisheye)?];
    let are_zero = fisheye.iter().all(|x| *x == 0.0);
    let lens = if are_zero { Lens::Pinhole } else { radial };
    let unstated = UnstatedLens {
        place,
        lenses,
        are_zero,
    };
    Ok((lens, unstated))
}
