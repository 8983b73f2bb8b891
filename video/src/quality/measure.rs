//! The measures as a list: their names, and where they are found.

use ga_image::quality::MULTISCALE_LEAST_SIDE;

use super::FrameQuality;

/// A measure of a frame.
#[derive(Clone, Copy, Debug)]
pub struct Measure {
    /// Its name for programs: a key of JSON, a column of a table.
    pub key: &'static str,
    /// Its name for people.
    pub name: &'static str,
    /// What its numbers are.
    pub scale: Scale,
    /// Whether it is a measure of luma, which every frame has but for its size, and not of colour
    /// differences, which grey frames lack.
    pub of_luma: bool,
    /// Its value for a frame that has one.
    pub value: fn(&FrameQuality) -> Option<f64>,
    /// Why frames with this number of columns and rows have no value, where that is so.
    pub reason_for_none: fn([usize; 2]) -> Option<String>,
}

/// What the numbers of a measure are.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Scale {
    /// Decibels, infinite where nothing differs.
    Decibels,
    /// An index, 1 where nothing differs.
    Index,
}

const fn luma(
    key: &'static str,
    name: &'static str,
    scale: Scale,
    value: fn(&FrameQuality) -> Option<f64>,
) -> Measure {
    Measure {
        key,
        name,
        scale,
        of_luma: true,
        value,
        reason_for_none: |_| None,
    }
}

const fn colour(
    key: &'static str,
    name: &'static str,
    value: fn(&FrameQuality) -> Option<f64>,
) -> Measure {
    Measure {
        key,
        name,
        scale: Scale::Decibels,
        of_luma: false,
        value,
        reason_for_none: |_| None,
    }
}

/// All measures. Reports, tables and charts follow from this list.
///
/// ```
/// use ga_image::plane::Plane;
/// use ga_video::quality::{FrameQuality, MEASURES, Meter};
///
/// let reference = Plane::from_fn(64, 48, |column, row| (column * row % 200) as u8);
/// let noisy = reference.map(|level| level ^ 4);
/// let luma = Meter::new([64, 48], 255.0)?.compare(&reference, &noisy, &reference)?;
/// let frame = FrameQuality { index: 0, time_seconds: 0.0, luma, psnr_differences: None };
/// let found = MEASURES.iter().filter(|measure| (measure.value)(&frame).is_some());
/// let keys: Vec<&str> = found.map(|measure| measure.key).collect();
/// assert_eq!(keys, ["psnr", "ssim", "attention_psnr", "attention_ssim"]);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub const MEASURES: [Measure; 8] = [
    luma("psnr", "PSNR", Scale::Decibels, |frame| {
        Some(frame.luma.psnr)
    }),
    luma("ssim", "SSIM", Scale::Index, |frame| Some(frame.luma.ssim)),
    Measure {
        reason_for_none: too_small_for_scales,
        ..luma("ms_ssim", "MS-SSIM", Scale::Index, |frame| {
            frame.luma.ms_ssim
        })
    },
    luma(
        "attention_psnr",
        "attention PSNR",
        Scale::Decibels,
        |frame| Some(frame.luma.attention_psnr),
    ),
    luma("attention_ssim", "attention SSIM", Scale::Index, |frame| {
        Some(frame.luma.attention_ssim)
    }),
    colour("psnr_cb", "PSNR of Cb", |frame| {
        Some(frame.psnr_differences?[0])
    }),
    colour("psnr_cr", "PSNR of Cr", |frame| {
        Some(frame.psnr_differences?[1])
    }),
    colour("psnr_6_1_1", "PSNR 6:1:1", FrameQuality::psnr_6_1_1),
];

/// Why there is no index at several scales.
fn too_small_for_scales([width, height]: [usize; 2]) -> Option<String> {
    (width.min(height) < MULTISCALE_LEAST_SIDE).then(|| {
        format!(
            "{width} × {height} pixels are too few, five scales need {MULTISCALE_LEAST_SIDE} × \
             {MULTISCALE_LEAST_SIDE}"
        )
    })
}
