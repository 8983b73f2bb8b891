//! The measures as a list: their names, and where they are found.

use ga_image::quality::MULTISCALE_LEAST_SIDE;

use super::FrameQuality;
use super::measures::SSIM_LEAST_SIDE;
use super::vif::VIF_LEAST_SIDE;

/// A measure of a frame.
#[derive(Clone, Copy, Debug)]
pub struct Measure {
    /// Its name for programs: a key of JSON, a column of a table.
    pub key: &'static str,
    /// Its name for people.
    pub name: &'static str,
    /// What its numbers are.
    pub scale: Scale,
    /// What it looks at.
    pub part: Part,
    /// Its value for a frame that has one.
    pub value: fn(&FrameQuality) -> Option<f64>,
    /// Why a frame with this number of columns and rows has no value, where it has none.
    pub reason_for_none: fn([usize; 2]) -> String,
}

/// What the numbers of a measure are.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Scale {
    /// Decibels, infinite where nothing of the part differs.
    Decibels,
    /// An index, 1 where nothing differs.
    Index,
    /// A difference of colours, 0 where nothing differs.
    Difference,
}

/// The samples that a measure looks at.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Part {
    /// Luma, which every frame has.
    Luma,
    /// One plane of colour differences, which grey frames lack, by its name.
    Plane(&'static str),
    /// Several planes, each with its own infinite value.
    Planes,
    /// All samples of all planes together; of pictures red, green and blue.
    All,
}

const fn measure(
    key: &'static str,
    name: &'static str,
    scale: Scale,
    part: Part,
    value: fn(&FrameQuality) -> Option<f64>,
) -> Measure {
    Measure {
        key,
        name,
        scale,
        part,
        value,
        reason_for_none: |_| "the frames are grey".to_owned(),
    }
}

/// All measures. Reports, tables and charts follow from this list.
///
/// ```
/// use ga_image::picture::Picture;
/// use ga_image::plane::Plane;
/// use ga_video::quality::{MEASURES, compare_pictures};
///
/// let reference = Plane::from_fn(64, 48, |column, row| (column * row % 200) as u8);
/// let noisy = reference.map(|level| level ^ 4);
/// let frame = compare_pictures(&Picture::from(reference), &Picture::from(noisy), None)?;
/// let found = MEASURES.iter().filter(|measure| (measure.value)(&frame).is_some());
/// let keys: Vec<&str> = found.map(|measure| measure.key).collect();
/// assert_eq!(keys[..4], ["psnr", "ssim", "vif", "attention_psnr"]);
/// assert_eq!(keys[4..], ["attention_ssim", "psnr_all", "ciede2000"]);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub const MEASURES: [Measure; 11] = [
    measure("psnr", "PSNR", Scale::Decibels, Part::Luma, |frame| {
        Some(frame.luma.psnr)
    }),
    Measure {
        reason_for_none: too_small_for_a_window,
        ..measure("ssim", "SSIM", Scale::Index, Part::Luma, |frame| {
            frame.luma.ssim
        })
    },
    Measure {
        reason_for_none: too_small_for_scales,
        ..measure("ms_ssim", "MS-SSIM", Scale::Index, Part::Luma, |frame| {
            frame.luma.ms_ssim
        })
    },
    Measure {
        reason_for_none: too_small_for_fidelity,
        ..measure("vif", "VIF", Scale::Index, Part::Luma, |frame| {
            frame.luma.vif
        })
    },
    measure(
        "attention_psnr",
        "attention PSNR",
        Scale::Decibels,
        Part::Luma,
        |frame| Some(frame.luma.attention_psnr),
    ),
    Measure {
        reason_for_none: too_small_for_a_window,
        ..measure(
            "attention_ssim",
            "attention SSIM",
            Scale::Index,
            Part::Luma,
            |frame| frame.luma.attention_ssim,
        )
    },
    measure(
        "psnr_cb",
        "PSNR of Cb",
        Scale::Decibels,
        Part::Plane("Cb"),
        |frame| Some(frame.psnr_differences?[0]),
    ),
    measure(
        "psnr_cr",
        "PSNR of Cr",
        Scale::Decibels,
        Part::Plane("Cr"),
        |frame| Some(frame.psnr_differences?[1]),
    ),
    measure(
        "psnr_6_1_1",
        "PSNR 6:1:1",
        Scale::Decibels,
        Part::Planes,
        FrameQuality::psnr_6_1_1,
    ),
    measure(
        "psnr_all",
        "PSNR of all samples",
        Scale::Decibels,
        Part::All,
        |frame| Some(frame.psnr_all),
    ),
    Measure {
        reason_for_none: |_| "it is computed of 8 bits".to_owned(),
        ..measure(
            "ciede2000",
            "CIEDE2000",
            Scale::Difference,
            Part::All,
            |frame| frame.ciede2000,
        )
    },
];

fn too_small_for_a_window([width, height]: [usize; 2]) -> String {
    format!(
        "{width} × {height} pixels are too few, the window needs {SSIM_LEAST_SIDE} × \
         {SSIM_LEAST_SIDE}"
    )
}

fn too_small_for_scales([width, height]: [usize; 2]) -> String {
    format!(
        "{width} × {height} pixels are too few, five scales need {MULTISCALE_LEAST_SIDE} × \
         {MULTISCALE_LEAST_SIDE}"
    )
}

fn too_small_for_fidelity([width, height]: [usize; 2]) -> String {
    format!(
        "{width} × {height} pixels are too few, four scales need {VIF_LEAST_SIDE} × \
         {VIF_LEAST_SIDE}"
    )
}
