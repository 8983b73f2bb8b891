//! The mutual information of neighbouring frames by itself.

use std::ops::ControlFlow;
use std::path::Path;

use ga_image::plane::Plane;
use ga_image::quality::MutualInformation;

use super::error::KeyFrameError;
use crate::{Frame, VideoError};

/// Measures how much the frames of a video from one on say of those before them, as
/// [`FrameMeasures::mutual_information_bits`](super::FrameMeasures::mutual_information_bits), and
/// hands it over in order, until the video or `each` ends. Returns whether the video has ended.
///
/// Of the measures of a frame this one takes the most time. The others need more than two frames.
///
/// # Errors
///
/// [`KeyFrameError::Video`] where a frame cannot be read, and [`KeyFrameError::Frame`] for a frame
/// of another size than the one before.
pub fn information(
    path: &Path,
    first: usize,
    mut each: impl FnMut(Option<f64>) -> ControlFlow<()>,
) -> Result<bool, KeyFrameError> {
    let mut source = crate::open(path)?;
    let mut information = MutualInformation::new();
    let mut frame = Frame::default();
    let mut previous: Option<Plane<u8>> = None;
    let mut index = 0;
    while source.read(&mut frame)? {
        let eight = frame.samples.eight_bits();
        if index >= first {
            let bits = previous.as_ref().map(|previous| {
                let found = information.compare(previous, &eight.luma);
                found.map(|found| found.mutual_bits())
            });
            let bits = bits.transpose().map_err(|_| KeyFrameError::Frame {
                file: path.to_path_buf(),
                problem: Box::new(VideoError::KeyFrameSize {
                    frame: index,
                    size: frame.samples.size(),
                    first: previous
                        .as_ref()
                        .map_or([0, 0], |p| [p.width(), p.height()]),
                }),
            })?;
            if each(bits).is_break() {
                return Ok(false);
            }
        }
        if index + 1 >= first {
            previous = Some(eight.into_owned().luma);
        }
        index += 1;
    }
    Ok(true)
}
