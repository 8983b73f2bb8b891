//! Numbered pictures as a video.

use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};

use ga_image::file;
use ga_image::grey::Luma;
use ga_image::plane::Plane;
use ga_image::y4m::Sampling;
use ga_image::ycbcr::{Range, YCbCr};

use super::{Frame, Properties, Samples, Source};
use crate::VideoError;

/// Endings of the files that are looked at in a folder.
const ENDINGS: [&str; 7] = ["png", "jpg", "jpeg", "ppm", "pgm", "pnm", "pfm"];

/// What numbered pictures hold: 4:4:4 with 8 bits, BT.601, from 0 to 255, so that luma is the grey
/// that pictures have elsewhere.
const COLOURS: YCbCr = YCbCr {
    luma: Luma::Bt601,
    range: Range::Full,
};

/// A row of numbered pictures. Frames are in the order of the numbers, which need not begin at 0
/// but have no gaps. The last number in a name counts: 12 in `shot3_0012.png`.
#[derive(Debug)]
pub struct ImageSource {
    name: Name,
    /// The number and the digits of the first picture, and how many there are.
    numbers: BTreeMap<u64, String>,
    properties: Properties,
    rate: [u32; 2],
    next: usize,
}

impl ImageSource {
    /// Finds the pictures of a row. `path` is a folder with one row, a pattern such as
    /// `shot/frame_%04d.png`, or the first picture of a row. Without a rate, 25 frames in a second
    /// are assumed for their times.
    ///
    /// ```
    /// use ga_image::file;
    /// use ga_image::plane::Plane;
    /// use ga_video::images::ImageSource;
    /// use ga_video::{Frame, Source};
    ///
    /// let folder = tempfile::tempdir()?;
    /// for number in 8..=10u8 {
    ///     let picture = Plane::filled(4, 2, [20 * number; 3]);
    ///     file::write(folder.path().join(format!("frame_{number}.png")), &picture)?;
    /// }
    /// let mut source = ImageSource::new(folder.path().join("frame_%d.png"), Some([50, 1]))?;
    /// assert_eq!(source.properties().frame_count, Some(3));
    /// let mut frame = Frame::default();
    /// assert!(source.read(&mut frame)? && source.read(&mut frame)?);
    /// assert_eq!((frame.index, frame.time_seconds), (1, 0.02));
    /// assert_eq!(frame.samples.eight_bits().luma.get(0, 0), Some(180));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    ///
    /// [`VideoError::Empty`] without pictures, [`VideoError::Missing`] with the file of the first
    /// gap, [`VideoError::Pattern`] for a name without number, two rows in one folder or one number
    /// twice, [`VideoError::Picture`] when the first one cannot be read, and [`VideoError::Open`]
    /// for the folder.
    pub fn new(path: impl AsRef<Path>, rate: Option<[u32; 2]>) -> Result<Self, VideoError> {
        let path = path.as_ref();
        let (name, numbers) = find(path)?;
        let Some((&first, digits)) = numbers.first_key_value() else {
            return Err(VideoError::Empty { file: path.into() });
        };
        for (frame, &number) in numbers.keys().enumerate() {
            let expected = first + frame as u64;
            if number != expected {
                let missing = format!("{expected:0width$}", width = digits.len());
                return Err(VideoError::Missing {
                    file: name.file(&missing),
                    frame,
                });
            }
        }
        let first = name.file(digits);
        Self::of_row(name, numbers, &first, rate)
    }

    /// A picture as a video of one frame. A number in its name has no meaning.
    ///
    /// # Errors
    ///
    /// [`VideoError::Picture`] when it cannot be read, [`VideoError::Pattern`] for a path without a
    /// name of a file.
    pub fn still(path: impl AsRef<Path>) -> Result<Self, VideoError> {
        let path = path.as_ref();
        let whole = path.file_name().and_then(|name| name.to_str());
        let name = Name {
            folder: path.parent().map(Path::to_path_buf).unwrap_or_default(),
            before: whole
                .ok_or_else(|| VideoError::Pattern {
                    file: path.into(),
                    problem: "the picture has no name in UTF-8",
                })?
                .into(),
            after: String::new(),
        };
        Self::of_row(name, BTreeMap::from([(0, String::new())]), path, None)
    }

    /// A row whose first picture is in this file.
    fn of_row(
        name: Name,
        numbers: BTreeMap<u64, String>,
        first: &Path,
        rate: Option<[u32; 2]>,
    ) -> Result<Self, VideoError> {
        let picture =
            file::read(first).map_err(|problem| VideoError::Picture { frame: 0, problem })?;
        let properties = Properties {
            size: [picture.width(), picture.height()],
            sampling: Sampling::Full,
            bit_depth: 8,
            colours: COLOURS,
            pixel_aspect: [1, 1],
            frames_per_second: rate,
            frame_count: Some(numbers.len()),
        };
        Ok(Self {
            name,
            numbers,
            properties,
            rate: rate.filter(|rate| !rate.contains(&0)).unwrap_or([25, 1]),
            next: 0,
        })
    }
}

impl Source for ImageSource {
    fn properties(&self) -> &Properties {
        &self.properties
    }

    fn read(&mut self, frame: &mut Frame) -> Result<bool, VideoError> {
        let Some((_, digits)) = self.numbers.pop_first() else {
            return Ok(false);
        };
        let (index, file) = (self.next, self.name.file(&digits));
        let outcome = self.read_picture(frame, &file, index);
        if outcome.is_err() {
            self.numbers.clear();
        }
        self.next += 1;
        outcome.map(|()| true)
    }
}

impl ImageSource {
    fn read_picture(&self, frame: &mut Frame, path: &Path, index: usize) -> Result<(), VideoError> {
        let picture = file::read(path).map_err(|problem| VideoError::Picture {
            frame: index,
            problem,
        })?;
        let size = [picture.width(), picture.height()];
        if size != self.properties.size {
            return Err(VideoError::Size {
                file: path.into(),
                frame: index,
                size,
                first: self.properties.size,
            });
        }
        let colours = picture.to_rgb::<u8>();
        let mut planes = frame.samples.take_eight();
        let [cb, cr] = &mut planes.differences;
        let targets = [&mut planes.luma, cb, cr];
        let mut values = targets.each_ref().map(|_| Vec::new());
        for (values, plane) in values.iter_mut().zip(targets) {
            *values = std::mem::take(plane).into_values();
            values.clear();
            values.reserve(colours.values().len());
        }
        for rgb in colours.values() {
            let encoded = COLOURS.from_rgb(*rgb);
            for (values, number) in values.iter_mut().zip(encoded) {
                values.push(number);
            }
        }
        // There is a number for each pixel.
        let [luma, cb, cr] =
            values.map(|values| Plane::from_values(size[0], size[1], values).unwrap_or_default());
        planes.luma = luma;
        planes.differences = [cb, cr];
        frame.samples = Samples::Eight(planes);
        frame.index = index;
        let [numerator, denominator] = self.rate;
        frame.time_seconds = index as f64 * f64::from(denominator) / f64::from(numerator);
        Ok(())
    }
}

/// What the names of a row share.
#[derive(Clone, Debug, PartialEq, Eq)]
struct Name {
    folder: PathBuf,
    before: String,
    after: String,
}

impl Name {
    fn file(&self, digits: &str) -> PathBuf {
        let Self { before, after, .. } = self;
        self.folder.join(format!("{before}{digits}{after}"))
    }

    /// The name of a file without its last number, and the digits of that number.
    fn split(folder: &Path, name: &str) -> Option<(Self, String)> {
        let stem = name.rfind('.').unwrap_or(name.len());
        let is_digit = |c: char| c.is_ascii_digit();
        let end = name[..stem].rfind(is_digit)? + 1;
        let start = name[..end].trim_end_matches(is_digit).len();
        let row = Self {
            folder: folder.into(),
            before: name[..start].into(),
            after: name[end..].into(),
        };
        Some((row, name[start..end].into()))
    }
}

/// The row to which a numbered picture belongs, as a pattern such as `shot/frame_%d.png`, and its
/// number; `None` for files with other names.
#[must_use]
pub fn row_of(path: &Path) -> Option<(PathBuf, u64)> {
    let ending = path.extension()?.to_str()?;
    let folder = path.parent().unwrap_or(Path::new(""));
    let (name, digits) = Name::split(folder, path.file_name()?.to_str()?)?;
    let is_picture = ENDINGS
        .iter()
        .any(|other| ending.eq_ignore_ascii_case(other));
    let number = digits.parse().ok().filter(|_| is_picture)?;
    Some((name.file("%d"), number))
}

/// Whether a name is a pattern, such as `frame_%04d.png`.
pub(super) fn is_pattern(path: &Path) -> bool {
    let name = path.file_name().and_then(|name| name.to_str());
    name.and_then(split_pattern).is_some()
}

/// What stands before and after `%d`, `%4d` or `%04d`.
fn split_pattern(name: &str) -> Option<(&str, &str)> {
    let (before, rest) = name.split_once('%')?;
    let after = rest.trim_start_matches(|c: char| c.is_ascii_digit());
    Some((before, after.strip_prefix('d')?))
}

/// The row that `path` stands for, with its numbers and their digits.
fn find(path: &Path) -> Result<(Name, BTreeMap<u64, String>), VideoError> {
    let wrong = |problem| VideoError::Pattern {
        file: path.into(),
        problem,
    };
    let parent = || match path.parent() {
        Some(folder) if folder != Path::new("") => folder.to_path_buf(),
        _ => PathBuf::from("."),
    };
    let name = path.file_name().and_then(|name| name.to_str());
    let (folder, wanted, least) = if path.is_dir() {
        (path.to_path_buf(), None, 0)
    } else if let Some((before, after)) = name.and_then(split_pattern) {
        let row = Name {
            folder: parent(),
            before: before.into(),
            after: after.into(),
        };
        (parent(), Some(row), 0)
    } else {
        let (row, digits) = name
            .and_then(|name| Name::split(&parent(), name))
            .ok_or_else(|| wrong("the name of the picture has no number"))?;
        let least: u64 = digits
            .parse()
            .map_err(|_| wrong("the number of the picture is too large"))?;
        (parent(), Some(row), least)
    };
    let (mut row, mut numbers) = (wanted, BTreeMap::new());
    for name in names(&folder)? {
        let Some((found, digits)) = Name::split(&folder, &name) else {
            continue;
        };
        match &row {
            Some(row) if *row == found => {}
            // Another row beside the one that is asked for.
            Some(_) if !path.is_dir() => continue,
            Some(_) => return Err(wrong("the folder has pictures of several rows")),
            None => row = Some(found),
        }
        let number: u64 = digits
            .parse()
            .map_err(|_| wrong("the number of a picture is too large"))?;
        if number >= least && numbers.insert(number, digits).is_some() {
            return Err(wrong("two pictures have the same number"));
        }
    }
    row.map(|row| (row, numbers))
        .ok_or_else(|| VideoError::Empty { file: path.into() })
}

/// The names of the pictures in a folder.
fn names(folder: &Path) -> Result<Vec<String>, VideoError> {
    let unreadable = |source| VideoError::Open {
        file: folder.into(),
        source,
    };
    let mut names = Vec::new();
    for entry in fs::read_dir(folder).map_err(unreadable)? {
        let name = entry.map_err(unreadable)?.file_name();
        let ending = Path::new(&name).extension().and_then(|e| e.to_str());
        let is_picture = ending.is_some_and(|e| ENDINGS.iter().any(|p| e.eq_ignore_ascii_case(p)));
        names.extend(name.to_str().filter(|_| is_picture).map(String::from));
    }
    Ok(names)
}
