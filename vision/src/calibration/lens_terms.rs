//! Which coefficients of a lens a calibration determines.

use std::fmt;
use std::str::FromStr;

use crate::calibration::CalibrationError;
use ga_camera::{CameraError, Intrinsics, Lens, LensModel};

/// The kind of a lens, and the coefficients of its distortion that a calibration determines. The
/// others stay as they are at the start, which is 0 where no camera is given.
///
/// As text: `none`; names that are separated by commas, such as `k1,k2,p1,p2,k3`; or the
/// [name](LensModel::name) of another lens, all of whose coefficients are determined, as `fisheye`.
///
/// ```
/// use ga_vision::calibration::LensTerms;
///
/// let terms: LensTerms = "k1,k2,p1,p2".parse()?;
/// assert_eq!(terms.to_string(), "k1,k2,p1,p2");
/// for wrong in ["k1,k1", "k9", "pinhole", "radial-tangential"] {
///     assert!(wrong.parse::<LensTerms>().is_err());
/// }
/// # Ok::<(), ga_vision::calibration::CalibrationError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct LensTerms {
    model: LensModel,
    is_free: [bool; TERMS.len()],
}

/// The coefficients of [`LensModel::RadialTangential`] that a calibration may determine. The tilt
/// of the sensor is not among them: beside the principal point it is not determined.
const TERMS: [&str; 12] = [
    "k1", "k2", "p1", "p2", "k3", "k4", "k5", "k6", "s1", "s2", "s3", "s4",
];

impl LensTerms {
    /// A pinhole.
    #[must_use]
    pub fn none() -> Self {
        Self::of(LensModel::Pinhole, 0)
    }

    /// Radial and tangential distortion: k1, k2, p1, p2 and k3, OpenCV's default.
    #[must_use]
    pub fn radial_tangential() -> Self {
        Self::of(LensModel::RadialTangential, 5)
    }

    /// A fisheye lens with k1 to k4.
    #[must_use]
    pub fn fisheye() -> Self {
        Self::of(LensModel::Fisheye, 4)
    }

    /// Radial and tangential distortion with a denominator: k1 to k6, p1 and p2.
    #[must_use]
    pub fn rational() -> Self {
        Self::of(LensModel::RadialTangential, 8)
    }

    /// The lens of a kind with its usual terms, or what the text says as terms.
    ///
    /// # Errors
    /// [`CalibrationError::LensTerms`].
    pub fn named(text: &str) -> Result<Self, CalibrationError> {
        match LensModel::named(text) {
            Some(LensModel::Pinhole) => Ok(Self::none()),
            Some(LensModel::RadialTangential) => Ok(Self::radial_tangential()),
            Some(LensModel::Fisheye) => Ok(Self::fisheye()),
            None => text.parse(),
        }
    }

    /// The kind of the lens.
    #[must_use]
    pub fn model(&self) -> LensModel {
        self.model
    }

    fn of(model: LensModel, free: usize) -> Self {
        let is_free = std::array::from_fn(|k| k < free);
        Self { model, is_free }
    }

    /// The lens without distortion at which a search begins.
    pub(super) fn lens(&self) -> Result<Lens, CameraError> {
        self.model.lens(&vec![0.0; self.model.coefficients().len()])
    }

    /// The intrinsic parameters that vary, as indices of [`Intrinsics::parameters`]: focal lengths,
    /// principal point, and the coefficients.
    #[must_use]
    pub fn free(&self) -> Vec<usize> {
        let coefficients = (0..TERMS.len()).filter(|&k| self.is_free[k]).map(|k| 4 + k);
        (0..4).chain(coefficients).collect()
    }
}

impl Default for LensTerms {
    /// [`radial_tangential`](Self::radial_tangential).
    fn default() -> Self {
        Self::radial_tangential()
    }
}

impl fmt::Display for LensTerms {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self.model {
            LensModel::Pinhole => formatter.write_str("none"),
            LensModel::RadialTangential => {
                let free = (0..TERMS.len()).filter(|&k| self.is_free[k]);
                let free: Vec<&str> = free.map(|k| TERMS[k]).collect();
                formatter.write_str(&free.join(","))
            }
            other => formatter.write_str(other.name()),
        }
    }
}

impl FromStr for LensTerms {
    type Err = CalibrationError;

    fn from_str(text: &str) -> Result<Self, CalibrationError> {
        match (text, LensModel::named(text)) {
            ("none", _) => return Ok(Self::none()),
            (_, Some(LensModel::Pinhole | LensModel::RadialTangential)) | (_, None) => {}
            (_, Some(model)) => return Ok(Self::of(model, model.coefficients().len())),
        }
        let wrong = || CalibrationError::LensTerms(text.to_owned());
        let mut terms = Self::of(LensModel::RadialTangential, 0);
        for name in text.split(',') {
            let place = TERMS.iter().position(|known| *known == name.trim());
            let place = &mut terms.is_free[place.ok_or_else(wrong)?];
            if std::mem::replace(place, true) {
                return Err(wrong());
            }
        }
        Ok(terms)
    }
}

/// The name of an intrinsic parameter by its index in [`Intrinsics::parameters`].
pub(super) fn parameter_name(camera: &Intrinsics, parameter: usize) -> &'static str {
    match parameter {
        0 => "fx",
        1 => "fy",
        2 => "cx",
        3 => "cy",
        _ => camera
            .lens()
            .names()
            .get(parameter - 4)
            .copied()
            .unwrap_or("a coefficient"),
    }
}
