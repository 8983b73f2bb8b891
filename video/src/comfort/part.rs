//! The measures of some frames by themselves.

use std::ops::ControlFlow;

use rayon::prelude::*;

use super::{ComfortError, FrameMeasures, FrameMeter};
use crate::Frame;
use crate::stereo::StereoSource;

/// Measures the frames from one on, each by itself, on all threads, and hands the measures over in
/// order, until the video or `each` ends. Frames before are read alone. Returns whether the video
/// has ended.
///
/// [`observe_measured`](super::monitor::observe_measured) makes of the measures of all frames what
/// [`observe`](super::monitor::observe) makes of the video.
///
/// # Errors
///
/// [`ComfortError::Video`], and [`ComfortError::Size`] for a frame of another size.
pub fn measure(
    source: &mut StereoSource,
    first: usize,
    mut each: impl FnMut(FrameMeasures) -> ControlFlow<()>,
) -> Result<bool, ComfortError> {
    let properties = *source.properties();
    let meter = FrameMeter::new(properties.size, properties.colours)
        .with_pixel_aspect(properties.pixel_aspect);
    let count = rayon::current_num_threads();
    let mut meters = vec![meter; count];
    let mut batch: Vec<[Frame; 2]> = vec![Default::default(); count];
    for _ in 0..first {
        if !source.read(&mut batch[0])? {
            return Ok(true);
        }
    }
    loop {
        let mut read = 0;
        while read < count && source.read(&mut batch[read])? {
            read += 1;
        }
        let measured = meters[..read].par_iter_mut().zip(&batch[..read]);
        let measured = measured.map(|(meter, views)| {
            let found = meter.measure(&views[0].samples, &views[1].samples);
            let frame = views[0].index;
            found
                .cloned()
                .map_err(|source| ComfortError::Size { frame, source })
        });
        for found in measured.collect::<Vec<_>>() {
            if each(found?).is_break() {
                return Ok(false);
            }
        }
        if read < count {
            return Ok(true);
        }
    }
}
