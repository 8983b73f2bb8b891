//! Opening videos of any kind.

use super::images::{self, ImageSource};
use super::y4m::Y4mSource;
use crate::{Source, VideoError};
use ga_image::file::Format;
use std::fs::File;
use std::io::{self, Cursor, Read};
use std::path::{Path, PathBuf};

/// Opens a video: a Y4M file, or the standard input with Y4M where `path` is `-`; a folder of
/// numbered pictures, a pattern such as `frame_%04d.png` or the first picture of a row (see
/// [`ImageSource`]); H.264 in MP4 with the feature `mp4`.
///
/// ```
/// use ga_image::plane::Plane;
/// use ga_image::y4m::{self, Film};
/// use ga_video::{Frame};
///
/// let folder = tempfile::tempdir()?;
/// let path = folder.path().join("film.y4m");
/// y4m::write(&path, (0..3u8).map(|i| Plane::filled(8, 6, [80 * i; 3])), Film::default())?;
///
/// let mut source = ga_video::open(&path)?;
/// assert_eq!(source.properties().size, [8, 6]);
/// let mut frame = Frame::default();
/// let mut times = Vec::new();
/// while source.read(&mut frame)? {
///     times.push(frame.time_seconds);
/// }
/// assert_eq!(times, [0.0, 0.04, 0.08]);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # Errors
///
/// [`VideoError::Open`] when it cannot be read, [`VideoError::Empty`] for a file without bytes,
/// [`VideoError::UnknownFormat`] when it is of another kind, and those of its format.
pub fn open(path: impl AsRef<Path>) -> Result<Box<dyn Source + Send>, VideoError> {
    open_as(path.as_ref(), |path| ImageSource::new(path, None))
}

/// Opens a video as [`open`] does, except that a file with a picture is a video of one frame: two
/// such files, or one with both views, are a stereoscopic picture. Folders and patterns are still
/// rows of pictures.
///
/// # Errors
///
/// As [`open`].
pub fn open_with_stills(path: impl AsRef<Path>) -> Result<Box<dyn Source + Send>, VideoError> {
    open_as(path.as_ref(), |path| ImageSource::still(path))
}

fn open_as(
    path: &Path,
    picture: impl Fn(&Path) -> Result<ImageSource, VideoError>,
) -> Result<Box<dyn Source + Send>, VideoError> {
    if path.as_os_str() == "-" {
        let source = Y4mSource::new(io::stdin(), "standard input")?;
        return Ok(Box::new(source));
    }
    if path.is_dir() || (images::is_pattern(path) && !path.exists()) {
        return Ok(Box::new(ImageSource::new(path, None)?));
    }
    let (mut start, mut input) = (Vec::new(), open_file(path)?);
    let limited = input.by_ref().take(START).read_to_end(&mut start);
    limited.map_err(|source| unreadable(path, source))?;
    match Kind::of(&start) {
        Some(Kind::Y4m) => {
            let length = input.metadata().ok().filter(std::fs::Metadata::is_file);
            let whole = Cursor::new(start).chain(input);
            let mut source = Y4mSource::new(whole, path)?;
            source.expect_length(length.map(|file| file.len()));
            Ok(Box::new(source))
        }
        Some(Kind::Picture) => Ok(Box::new(picture(path)?)),
        #[cfg(feature = "mp4")]
        Some(Kind::Mp4) => Ok(Box::new(super::mp4::Mp4Source::open(path)?)),
        #[cfg(not(feature = "mp4"))]
        Some(Kind::Mp4) => Err(VideoError::Mp4Feature { file: path.into() }),
        None if start.is_empty() => Err(VideoError::Empty { file: path.into() }),
        None => Err(VideoError::UnknownFormat {
            file: path.into(),
            start: start[..start.len().min(8)].to_vec(),
        }),
    }
}

/// Bytes by which the kind of a file is known.
const START: u64 = 12;

enum Kind {
    Y4m,
    Picture,
    Mp4,
}

impl Kind {
    fn of(start: &[u8]) -> Option<Self> {
        if start.starts_with(b"YUV4MPEG2") {
            return Some(Self::Y4m);
        }
        // A box has its length before its name.
        if start.get(4..8) == Some(b"ftyp") {
            return Some(Self::Mp4);
        }
        Format::detect(start).map(|_| Self::Picture)
    }
}

fn open_file(path: &Path) -> Result<File, VideoError> {
    File::open(path).map_err(|source| unreadable(path, source))
}

fn unreadable(path: &Path, source: io::Error) -> VideoError {
    VideoError::Open {
        file: PathBuf::from(path),
        source,
    }
}
