//! The video without its defects as a file.

use std::io::Write;

use ga_image::y4m::{Film, Writer};

use super::Plan;
use crate::Samples;
use crate::comfort::ComfortError;
use crate::stereo::{Layout, StereoSource, joined};

impl Plan {
    /// Reads the video, and writes it as it should be: as Y4M with both views in each frame, in
    /// this layout. `progress` hears the number of each frame that was written.
    ///
    /// # Errors
    ///
    /// Those of the source; [`ComfortError::Output`].
    pub fn write(
        &self,
        source: &mut StereoSource,
        layout: Layout,
        out: impl Write,
        mut progress: impl FnMut(usize),
    ) -> Result<(), ComfortError> {
        let properties = *source.properties();
        let (frames, last_seconds) = self.source_frames();
        let film = Film {
            frames_per_second: properties.rate(frames, last_seconds),
            sampling: properties.sampling,
            colours: properties.colours,
            pixel_aspect: source.frame_aspect(),
        };
        let mut size = properties.size;
        size[layout.axis()] *= 2;
        let mut writer = Writer::new(out, size, properties.bit_depth, film)?;
        let mut frame = 0;
        self.apply(source, |views| {
            let whole = joined(views.map(|view| &view.samples), layout);
            match &whole.map_err(|source| ComfortError::Size { frame, source })? {
                Samples::Eight(planes) => writer.write(planes.as_array())?,
                Samples::Ten(planes) => writer.write(planes.as_array())?,
            }
            progress(frame);
            frame += 1;
            Ok(())
        })
    }
}
