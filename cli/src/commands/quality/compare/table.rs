//! The measures of all frames as CSV.

use anyhow::Result;
use ga_video::quality::FrameQuality;

const COLUMNS: [&str; 9] = [
    "frame",
    "time_seconds",
    "psnr",
    "ssim",
    "ms_ssim",
    "attention_psnr",
    "attention_ssim",
    "psnr_cb",
    "psnr_cr",
];

/// A row for each frame. A measure that a frame does not have is empty.
pub(super) fn csv(frames: &[FrameQuality]) -> Result<Vec<u8>> {
    let mut writer = csv::Writer::from_writer(Vec::new());
    writer.write_record(COLUMNS)?;
    for frame in frames {
        let luma = &frame.luma;
        let difference = |index: usize| frame.psnr_differences.map(|psnr| psnr[index]);
        let numbers = [
            Some(frame.time_seconds),
            Some(luma.psnr),
            Some(luma.ssim),
            luma.ms_ssim,
            Some(luma.attention_psnr),
            Some(luma.attention_ssim),
            difference(0),
            difference(1),
        ];
        let mut row = vec![frame.index.to_string()];
        row.extend(numbers.map(|number| number.map_or(String::new(), |n| n.to_string())));
        writer.write_record(&row)?;
    }
    Ok(writer.into_inner()?)
}
