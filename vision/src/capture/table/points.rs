//! Tables of points in frames.

use ga_runtime::cga3::Point;

use super::error::PointTableError;
use super::note::PointTableNote;
use super::row::PointRow;

/// Points of a face over time, in metres.
///
/// ```
/// use ga_vision::capture::table::{PointTable, Zeros};
///
/// // TRC in millimetres; the marker is lost in the second frame.
/// let text = "PathFileType\t4\t(X/Y/Z)\tface.trc\n\
///     DataRate\tCameraRate\tNumFrames\tNumMarkers\tUnits\n\
///     60\t60\t3\t1\tmm\n\
///     Frame#\tTime\tnose\t\t\n\
///     \t\tX1\tY1\tZ1\n\
///     1\t0.00\t10\t20\t50\n\
///     2\t0.02\t0\t0\t0\n\
///     3\t0.04\t11\t20\t50\n";
/// let table = PointTable::decode(text.as_bytes(), Zeros::Lost)?;
/// let nose = table.point("nose")?;
/// let place = table.frames[0].points[nose].ok_or("it is seen")?;
/// assert!((place.x() - 0.01).abs() < 1e-15 && (place.z() - 0.05).abs() < 1e-15);
/// assert!(table.frames[1].points[nose].is_none());
/// assert_eq!(table.notes[0].kind(), "lost_at_origin");
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug)]
pub struct PointTable {
    /// The names of the points.
    pub names: Vec<String>,
    /// The number of each point in the file, from 0.
    pub numbers: Vec<usize>,
    /// At least one.
    pub frames: Vec<PointRow>,
    /// What was left out, replaced or assumed.
    pub notes: Vec<PointTableNote>,
}

impl PointTable {
    /// A point by its name, by its name after a prefix with a colon if only one has it, or else by
    /// its number from 0.
    ///
    /// # Errors
    /// [`PointTableError::NoSuchPoint`] and [`PointTableError::SeveralPoints`].
    pub fn point(&self, word: &str) -> Result<usize, PointTableError> {
        if let Some(point) = self.names.iter().position(|name| name == word) {
            return Ok(point);
        }
        let after_prefix = |name: &str| name.rsplit_once(':').is_some_and(|(_, end)| end == word);
        let found: Vec<_> = (0..self.names.len())
            .filter(|&point| after_prefix(&self.names[point]))
            .collect();
        if found.len() > 1 {
            return Err(PointTableError::SeveralPoints {
                name: word.to_owned(),
                names: found
                    .iter()
                    .map(|&point| self.names[point].clone())
                    .collect(),
            });
        }
        let number = word.parse().ok();
        let by_number = || self.numbers.iter().position(|&found| Some(found) == number);
        let found = found.first().copied().or_else(by_number);
        found.ok_or_else(|| PointTableError::NoSuchPoint {
            name: word.to_owned(),
            names: self.names.clone(),
        })
    }

    /// A frame by its name.
    ///
    /// # Errors
    /// [`PointTableError::NoFrame`].
    pub fn frame(&self, name: &str) -> Result<usize, PointTableError> {
        let found = self.frames.iter().position(|frame| frame.label == name);
        let label = |frame: Option<&PointRow>| frame.map_or("", |frame| &frame.label).to_owned();
        found.ok_or_else(|| PointTableError::NoFrame {
            name: name.to_owned(),
            first: label(self.frames.first()),
            last: label(self.frames.last()),
        })
    }

    /// The points of a frame, which must be there, in which the head is at rest.
    ///
    /// # Errors
    /// [`PointTableError::MissingAtRest`] for the first point that was not seen.
    pub fn rest(&self, frame: usize) -> Result<Vec<Point<f64>>, PointTableError> {
        let row = self.frames[frame].points.iter().zip(&self.names);
        let place = |(place, name): (&Option<Point<f64>>, &String)| {
            place.ok_or_else(|| PointTableError::MissingAtRest {
                place: self.place(frame),
                point: name.clone(),
                at_origin: self.was_at_origin(name, &self.frames[frame].label),
            })
        };
        row.map(place).collect()
    }

    /// How a message names a frame, which must be there.
    pub fn place(&self, frame: usize) -> String {
        let PointRow { line, label, .. } = &self.frames[frame];
        format!("line {line}, frame {label}")
    }

    /// Times in seconds from the first frame on, by their column or by the rate.
    pub fn times(&self, frames_per_second: f64) -> Vec<f64> {
        let start = self.frames[0].time.unwrap_or(0.0);
        let frames = self.frames.iter().enumerate();
        let by_rate = |k: usize| k as f64 / frames_per_second;
        frames
            .map(|(k, frame)| frame.time.map_or_else(|| by_rate(k), |time| time - start))
            .collect()
    }

    fn was_at_origin(&self, name: &str, label: &String) -> bool {
        self.notes.iter().any(|note| {
            matches!(note, PointTableNote::LostAtOrigin { point, frames }
                if point == name && frames.contains(label))
        })
    }
}
