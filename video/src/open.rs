//! Opening videos of any kind.

use super::ffmpeg::{self, FfmpegSource};
use super::images::{self, ImageSource};
use super::y4m::Y4mSource;
use crate::{Source, VideoError};
use ga_image::file::Format;
use std::fs::File;
use std::io::{self, Cursor, Read};
use std::path::{Path, PathBuf};

/// Opens a video: a Y4M file, or the standard input with Y4M where `path` is `-`; a folder of
/// numbered pictures, a pattern such as `frame_%04d.png` or the first picture of a row (see
/// [`ImageSource`]); H.264 in MP4 with the feature `mp4`, where it is decoded exactly; and by the
/// program ffmpeg, where that is installed, the films that it reads.
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
/// [`VideoError::UnknownFormat`] when it is of another kind, [`VideoError::NeedsFfmpeg`] when only
/// ffmpeg decodes it, and those of its format.
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
        Some(Kind::Mp4) => open_mp4(path),
        Some(Kind::Film) => open_by_ffmpeg(path, "films of this kind are not decoded here".into()),
        None if start.is_empty() => Err(VideoError::Empty { file: path.into() }),
        None => Err(VideoError::UnknownFormat {
            file: path.into(),
            start: start[..start.len().min(8)].to_vec(),
        }),
    }
}

/// Opens an MP4: here, where it is decoded exactly, and otherwise by ffmpeg.
fn open_mp4(path: &Path) -> Result<Box<dyn Source + Send>, VideoError> {
    #[cfg(feature = "mp4")]
    let problem = match super::mp4::Mp4Source::open(path) {
        Err(VideoError::Mp4 { problem, .. }) => problem,
        source => return Ok(Box::new(source?)),
    };
    #[cfg(not(feature = "mp4"))]
    let problem = "MP4 is decoded here where the program is built with the feature `mp4`".into();
    open_by_ffmpeg(path, problem)
}

/// Opens a video by ffmpeg, where it is installed; `problem` says why it is not decoded here.
fn open_by_ffmpeg(path: &Path, problem: String) -> Result<Box<dyn Source + Send>, VideoError> {
    if ffmpeg::is_installed() {
        return Ok(Box::new(FfmpegSource::open(path)?));
    }
    let file = path.into();
    Err(VideoError::NeedsFfmpeg { file, problem })
}

/// Bytes by which the kind of a file is known.
const START: u64 = 12;

enum Kind {
    Y4m,
    Picture,
    Mp4,
    /// Another container of films, or a stream without one.
    Film,
}

/// How films of other kinds begin: Matroska, MPEG transport and program streams, streams of H.264
/// and H.265, Flash, Ogg, ASF, MXF and IVF.
const FILMS: [&[u8]; 9] = [
    &[0x1a, 0x45, 0xdf, 0xa3],
    &[0x47],
    &[0, 0, 1],
    &[0, 0, 0, 1],
    b"FLV\x01",
    b"OggS",
    &[0x30, 0x26, 0xb2, 0x75],
    &[0x06, 0x0e, 0x2b, 0x34],
    b"DKIF",
];

impl Kind {
    fn of(start: &[u8]) -> Option<Self> {
        if start.starts_with(b"YUV4MPEG2") {
            return Some(Self::Y4m);
        }
        // A box has its length before its name. QuickTime may begin without a brand.
        let is_box = |name: &[u8; 4]| start.get(4..8) == Some(name);
        if [b"ftyp", b"moov", b"mdat", b"wide", b"free", b"skip"]
            .into_iter()
            .any(is_box)
        {
            return Some(Self::Mp4);
        }
        if Format::detect(start).is_some() {
            return Some(Self::Picture);
        }
        let is_avi = start.starts_with(b"RIFF") && start.get(8..12) == Some(b"AVI ");
        let is_film = is_avi || FILMS.iter().any(|magic| start.starts_with(magic));
        is_film.then_some(Self::Film)
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
