//! The measures of all frames as CSV.

use anyhow::Result;
use ga_video::quality::{FrameQuality, MEASURES};

/// A row for each frame. A measure that a frame does not have is empty.
pub(super) fn csv(frames: &[FrameQuality]) -> Result<Vec<u8>> {
    let mut writer = csv::Writer::from_writer(Vec::new());
    let keys = MEASURES.iter().map(|measure| measure.key);
    writer.write_record(["frame", "time_seconds"].into_iter().chain(keys))?;
    for frame in frames {
        let values = MEASURES.iter().map(|measure| (measure.value)(frame));
        let texts = values.map(|value| value.map_or(String::new(), |number| number.to_string()));
        let place = [frame.index.to_string(), frame.time_seconds.to_string()];
        writer.write_record(place.into_iter().chain(texts))?;
    }
    Ok(writer.into_inner()?)
}
