//! What errors say of frames and points that have names.

use super::points::PointTable;
use crate::capture::CaptureError;

impl PointTable {
    /// What an error of a [`Capture`](crate::capture::Capture) of the frames of the table says,
    /// with the names of frames and points; `reference` is the frame in which the head is at rest.
    #[must_use]
    pub fn describe(&self, error: &CaptureError, reference: usize) -> String {
        let name = |point: &usize| self.names[*point].as_str();
        match error {
            CaptureError::Twice(point) => format!("{} is named twice", name(point)),
            CaptureError::Rest(error) => match &**error {
                CaptureError::TooFew { found, needed } => {
                    format!("{needed} points are needed for a pose, not {found}")
                }
                error => format!("{}: {error}", self.place(reference)),
            },
            CaptureError::Frame { frame, problem } => {
                format!("{}: {}", self.place(*frame), self.reason(problem))
            }
            CaptureError::NoPose { problem } => {
                let reason = self.reason(problem);
                format!("no frame has a pose; {}: {reason}", self.place(0))
            }
            error => error.to_string(),
        }
    }

    /// Why a frame of the table has no pose, with the names of points.
    #[must_use]
    pub fn reason(&self, problem: &CaptureError) -> String {
        let name = |point: &usize| self.names[*point].as_str();
        let names = |points: &[usize]| points.iter().map(name).collect::<Vec<_>>().join(", ");
        match problem {
            CaptureError::Missing {
                seen,
                needed,
                missing,
            } => format!(
                "{seen} calibrated points are seen, and {needed} are needed; missing: {}",
                names(missing)
            ),
            CaptureError::PoseOfSeen { missing, error } => {
                format!("{error}; missing: {}", names(missing))
            }
            problem => problem.to_string(),
        }
    }
}
