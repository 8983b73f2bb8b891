//! What was measured, of pictures or of videos.

use ga_video::quality::PictureQuality;
use serde::Serialize;

use super::videos::Videos;
use crate::part::PartWritten;

/// What was measured.
#[derive(Serialize)]
#[serde(untagged)]
pub(crate) enum Measures {
    Pictures(PictureQuality),
    Videos(Videos),
    Part(PartWritten),
}
