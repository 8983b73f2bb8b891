//! The frame whose errors are the means of many.

use super::measures::Measures;
use super::same::Same;
use super::video::FrameQuality;

/// A frame with the means of the errors of all: PSNR is that of the mean squared error, which one
/// identical frame does not make infinite, and indices and differences of colours are their means.
/// `None` without frames.
pub(super) fn mean_frame(frames: &[FrameQuality]) -> Option<FrameQuality> {
    let first = frames.first()?;
    let count = frames.len() as f64;
    let mean = |value: &dyn Fn(&FrameQuality) -> f64| frames.iter().map(value).sum::<f64>() / count;
    let mean_of_some = |value: fn(&FrameQuality) -> Option<f64>| {
        let values: Option<Vec<f64>> = frames.iter().map(value).collect();
        values.map(|values| values.iter().sum::<f64>() / count)
    };
    // PSNR is 10 log₁₀ of the square of the range over the error.
    let psnr = |value: &dyn Fn(&FrameQuality) -> f64| {
        -10.0 * mean(&|frame| 10f64.powf(-0.1 * value(frame))).log10()
    };
    let difference = |place: usize| {
        psnr(&|frame| {
            frame
                .psnr_differences
                .map_or(f64::INFINITY, |found| found[place])
        })
    };
    let same = frames.iter().map(|frame| frame.same);
    Some(FrameQuality {
        luma: Measures {
            mse: mean(&|frame| frame.luma.mse),
            psnr: psnr(&|frame| frame.luma.psnr),
            ssim: mean_of_some(|frame| frame.luma.ssim),
            ms_ssim: mean_of_some(|frame| frame.luma.ms_ssim),
            vif: mean_of_some(|frame| frame.luma.vif),
            attention_psnr: psnr(&|frame| frame.luma.attention_psnr),
            attention_ssim: mean_of_some(|frame| frame.luma.attention_ssim),
        },
        psnr_differences: first.psnr_differences.map(|_| [0, 1].map(difference)),
        psnr_all: psnr(&|frame| frame.psnr_all),
        ciede2000: mean_of_some(|frame| frame.ciede2000),
        same: same.fold(Same::ALL, Same::and),
        ..*first
    })
}
