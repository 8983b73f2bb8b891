//! Lenses: from a place in the camera's frame to its image at focal length 1, and back.

use super::error::CameraError;
use super::fisheye::{self, Fisheye};
use super::radial_tangential::{self, NoInverse, RadialTangential};

/// How a lens forms the image of a point at focal length 1, before focal lengths and principal
/// point make it a pixel.
///
/// `x/z`, `y/z` for a pinhole; the other lenses add a distortion to this.
#[expect(
    clippy::large_enum_variant,
    reason = "cameras are few, and are copied without a heap"
)]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub enum Lens {
    /// The central projection, without distortion.
    #[default]
    Pinhole,
    /// A central projection with radial–tangential distortion.
    RadialTangential(RadialTangential),
    /// A fisheye lens.
    Fisheye(Fisheye),
}

/// A kind of lens.
///
/// # Examples
///
/// ```
/// use ga_camera::{Lens, LensModel};
///
/// let model = LensModel::named("fisheye").ok_or("no such lens")?;
/// assert_eq!(model.coefficients(), ["k1", "k2", "k3", "k4"]);
/// let lens = model.lens(&[0.1, 0.0, 0.0, 0.0])?;
/// assert_eq!((lens.model(), lens.coefficients()[0]), (LensModel::Fisheye, 0.1));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum LensModel {
    /// [`Lens::Pinhole`].
    Pinhole,
    /// [`Lens::RadialTangential`].
    RadialTangential,
    /// [`Lens::Fisheye`].
    Fisheye,
}

/// What is known of a kind of lens.
struct Description {
    name: &'static str,
    /// What ROS, kalibr, ORB-SLAM3, Basalt, RealSense and others call it, in small letters.
    other_names: &'static [&'static str],
    coefficients: &'static [&'static str],
    /// How many coefficients files have.
    counts: &'static [usize],
    lens: fn(&[f64]) -> Result<Lens, CameraError>,
}

impl LensModel {
    /// All kinds.
    pub const ALL: [Self; 3] = [Self::Pinhole, Self::RadialTangential, Self::Fisheye];

    /// The table of the kinds. Files and calibrations follow from it.
    const fn description(self) -> &'static Description {
        match self {
            Self::Pinhole => &Description {
                name: "pinhole",
                other_names: &["none"],
                coefficients: &[],
                counts: &[0],
                lens: |coefficients| match coefficients {
                    [] => Ok(Lens::Pinhole),
                    _ => Err(CameraError::CoefficientCount {
                        found: coefficients.len(),
                        expected: "0",
                    }),
                },
            },
            Self::RadialTangential => &Description {
                name: "radial-tangential",
                other_names: &[
                    "plumb_bob",
                    "radtan",
                    "rational_polynomial",
                    "brown_conrady",
                    "pinhole-radtan8",
                    "opencv",
                ],
                coefficients: &radial_tangential::NAMES,
                counts: &[5, 8, 12, 14],
                lens: |coefficients| Ok(RadialTangential::new(coefficients)?.into()),
            },
            Self::Fisheye => &Description {
                name: "fisheye",
                other_names: &[
                    "equidistant",
                    "equi",
                    "kannala_brandt",
                    "kannala_brandt4",
                    "kannalabrandt8",
                    "kb4",
                    "opencv_fisheye",
                ],
                coefficients: &fisheye::NAMES,
                counts: &[4],
                lens: |coefficients| Ok(Fisheye::new(coefficients)?.into()),
            },
        }
    }

    /// Its name in JSON and in options.
    #[must_use]
    pub fn name(self) -> &'static str {
        self.description().name
    }

    /// Its name, and those that other programs have for it.
    pub fn names(self) -> impl Iterator<Item = &'static str> {
        let description = self.description();
        [description.name]
            .into_iter()
            .chain(description.other_names.iter().copied())
    }

    /// The kind of a name.
    #[must_use]
    pub fn named(name: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|model| model.name() == name)
    }

    /// The names of the distortion coefficients, as OpenCV writes them.
    #[must_use]
    pub fn coefficients(self) -> &'static [&'static str] {
        self.description().coefficients
    }

    /// How many coefficients, the first of all, files have. The greatest number is that of all.
    #[must_use]
    pub fn counts(self) -> &'static [usize] {
        self.description().counts
    }

    /// The lens with these coefficients, in OpenCV's order.
    ///
    /// # Errors
    /// [`CameraError`] as [`RadialTangential::new`] and [`Fisheye::new`];
    /// [`CameraError::CoefficientCount`] for a pinhole with coefficients.
    pub fn lens(self, coefficients: &[f64]) -> Result<Lens, CameraError> {
        (self.description().lens)(coefficients)
    }
}

/// An image and its derivatives by the point and by the coefficients, by rows. Unused places of the
/// latter are zero.
pub(super) struct LensImage {
    pub(super) image: [f64; 2],
    pub(super) by_point: [[f64; 3]; 2],
    pub(super) by_coefficients: [[f64; 14]; 2],
}

/// Why a point has no image.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum NoImage {
    Behind,
    OutsideField,
}

impl Lens {
    /// Its kind.
    #[must_use]
    pub fn model(&self) -> LensModel {
        match self {
            Self::Pinhole => LensModel::Pinhole,
            Self::RadialTangential(_) => LensModel::RadialTangential,
            Self::Fisheye(_) => LensModel::Fisheye,
        }
    }

    /// How many distortion coefficients the lens has: 0, 14 or 4.
    #[must_use]
    pub fn coefficient_count(&self) -> usize {
        self.names().len()
    }

    /// The names of the distortion coefficients, as OpenCV writes them.
    #[must_use]
    pub fn names(&self) -> &'static [&'static str] {
        self.model().coefficients()
    }

    /// The distortion coefficients in OpenCV's order, followed by zeros.
    #[must_use]
    pub fn coefficients(&self) -> [f64; 14] {
        match self {
            Self::Pinhole => [0.0; 14],
            Self::RadialTangential(lens) => lens.coefficients(),
            Self::Fisheye(lens) => {
                let mut all = [0.0; 14];
                all[..4].copy_from_slice(&lens.coefficients());
                all
            }
        }
    }

    /// A lens of the same kind with other coefficients.
    ///
    /// # Errors
    /// As [`LensModel::lens`].
    pub fn with_coefficients(&self, coefficients: &[f64]) -> Result<Self, CameraError> {
        self.model().lens(coefficients)
    }

    /// The image of a point at focal length 1.
    pub(super) fn image(&self, point: [f64; 3]) -> Result<[f64; 2], NoImage> {
        match self {
            Self::Pinhole => plane_image(point),
            Self::RadialTangential(lens) => {
                let flat = plane_image(point)?;
                if lens.is_in_field(flat) {
                    Ok(lens.distort(flat))
                } else {
                    Err(NoImage::OutsideField)
                }
            }
            Self::Fisheye(lens) if lens.is_in_field(point) => Ok(lens.image(point)),
            Self::Fisheye(_) => Err(NoImage::OutsideField),
        }
    }

    /// The image of a point at focal length 1, with its derivatives.
    pub(super) fn derivatives(&self, point: [f64; 3]) -> Result<LensImage, NoImage> {
        if let Self::Fisheye(lens) = self {
            if !lens.is_in_field(point) {
                return Err(NoImage::OutsideField);
            }
            let found = lens.derivatives(point);
            let mut by_coefficients = [[0.0; 14]; 2];
            for (all, own) in by_coefficients.iter_mut().zip(found.by_coefficients) {
                all[..4].copy_from_slice(&own);
            }
            return Ok(LensImage {
                image: found.image,
                by_point: found.by_point,
                by_coefficients,
            });
        }
        let flat = plane_image(point)?;
        let inverse_depth = 1.0 / point[2];
        // Columns x, y and z of the derivatives of `a x/z + b y/z`.
        let chain = |[a, b]: [f64; 2]| {
            [
                a * inverse_depth,
                b * inverse_depth,
                -(a * flat[0] + b * flat[1]) * inverse_depth,
            ]
        };
        let Self::RadialTangential(lens) = self else {
            return Ok(LensImage {
                image: flat,
                by_point: [chain([1.0, 0.0]), chain([0.0, 1.0])],
                by_coefficients: [[0.0; 14]; 2],
            });
        };
        if !lens.is_in_field(flat) {
            return Err(NoImage::OutsideField);
        }
        let found = lens.derivatives(flat);
        Ok(LensImage {
            image: found.image,
            by_point: found.by_image.map(chain),
            by_coefficients: found.by_coefficients,
        })
    }

    /// The direction in which an image at focal length 1 is seen, of any length.
    pub(super) fn direction(&self, image: [f64; 2]) -> Result<[f64; 3], NoInverse> {
        match self {
            Self::Pinhole => Ok([image[0], image[1], 1.0]),
            Self::RadialTangential(lens) => lens.undistort(image).map(|[x, y]| [x, y, 1.0]),
            Self::Fisheye(lens) => lens.direction(image).ok_or(NoInverse::OutsideField),
        }
    }
}

fn plane_image([x, y, depth]: [f64; 3]) -> Result<[f64; 2], NoImage> {
    if depth > 0.0 {
        Ok([x / depth, y / depth])
    } else {
        Err(NoImage::Behind)
    }
}

impl From<RadialTangential> for Lens {
    fn from(lens: RadialTangential) -> Self {
        Self::RadialTangential(lens)
    }
}

impl From<Fisheye> for Lens {
    fn from(lens: Fisheye) -> Self {
        Self::Fisheye(lens)
    }
}
