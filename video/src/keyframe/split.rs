//! Each shot as a film of its own.

use std::ffi::OsString;
use std::io::Write;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};

use ga_image::file::{self, FormatError};
use ga_image::y4m::{Film, Writer};
use tempfile::{TempDir, tempdir};

use super::error::KeyFrameError;
use super::shot::Shot;
use crate::{Frame, Samples, Source, VideoError, ffmpeg};

/// Reads a video again and writes its shots, one after another, as Y4M: every pixel as it was read,
/// without sound.
pub struct Splitter {
    source: Box<dyn Source + Send>,
    frames_per_second: [u32; 2],
    frame: Frame,
}

impl Splitter {
    /// Opens a video whose shots have this rate.
    ///
    /// # Errors
    ///
    /// Those of [`open`](crate::open).
    pub fn new(path: &Path, frames_per_second: [u32; 2]) -> Result<Self, VideoError> {
        Ok(Self {
            source: crate::open(path)?,
            frames_per_second,
            frame: Frame::default(),
        })
    }

    /// Writes the next frames, as many as the next shot has.
    ///
    /// # Errors
    ///
    /// Those of the source, and [`KeyFrameError::Split`] where a film cannot be written.
    pub fn write(&mut self, frames: usize, out: impl Write) -> Result<(), KeyFrameError> {
        let properties = *self.source.properties();
        let film = Film {
            frames_per_second: self.frames_per_second,
            sampling: properties.sampling,
            colours: properties.colours,
            pixel_aspect: properties.pixel_aspect,
        };
        let failed = |problem: FormatError| KeyFrameError::Split(problem.to_string());
        let mut writer =
            Writer::new(out, properties.size, properties.bit_depth, film).map_err(failed)?;
        for _ in 0..frames {
            if !self.source.read(&mut self.frame)? {
                return Err(KeyFrameError::Split("the video has become shorter".into()));
            }
            let written = match &self.frame.samples {
                Samples::Eight(planes) => writer.write(planes.as_array()),
                Samples::Ten(planes) => writer.write(planes.as_array()),
            };
            written.map_err(failed)?;
        }
        Ok(())
    }
}

/// Whether [`by_ffmpeg`] can split a video: the program is installed, and the video is neither of
/// pictures nor Y4M, which stay as they are in the films of a [`Splitter`].
#[must_use]
pub fn is_for_ffmpeg(path: &Path) -> bool {
    path.is_file() && matches!(file::detect(path), Ok(None)) && ffmpeg::is_installed()
}

/// The films of shots, in order, until it is dropped.
#[derive(Debug)]
pub struct Films {
    /// The films.
    pub files: Vec<PathBuf>,
    _folder: TempDir,
}

/// Writes the shots of a video into a temporary folder as H.264 in MP4 with its sound, by the
/// program ffmpeg. Films are coded anew, since a film that is cut as it is coded
/// begins at a picture that can be decoded alone, and not at a cut. Each frame keeps its time.
///
/// # Errors
///
/// [`KeyFrameError::Split`] with what ffmpeg says, [`KeyFrameError::Temporary`].
pub fn by_ffmpeg(path: &Path, shots: &[Shot]) -> Result<Films, KeyFrameError> {
    let task = "create";
    let folder = tempdir().map_err(|source| KeyFrameError::Temporary { task, source })?;
    let starts = shots
        .iter()
        .skip(1)
        .map(|shot| shot.frames.start.to_string());
    let starts: Vec<String> = starts.collect();
    let keys: Vec<String> = starts
        .iter()
        .map(|start| format!("eq(n,{start})"))
        .collect();
    // A name with a colon is none of a protocol.
    let mut named = OsString::from("file:");
    named.push(path);
    let mut command = Command::new("ffmpeg");
    command
        .args(["-nostdin", "-hide_banner", "-loglevel", "error"])
        .args(["-protocol_whitelist", "file,pipe", "-i"])
        .arg(named)
        .args(["-map", "0:V:0", "-map", "0:a?", "-fps_mode", "passthrough"])
        .args(["-c:v", "libx264", "-crf", "14", "-forced-idr", "1"]);
    if !starts.is_empty() {
        command.args(["-force_key_frames", &format!("expr:{}", keys.join("+"))]);
        command.args(["-segment_frames", &starts.join(",")]);
    } else {
        command.args(["-segment_time", "1000000000"]);
    }
    command
        .args([
            "-f",
            "segment",
            "-segment_format",
            "mp4",
            "-reset_timestamps",
            "1",
        ])
        .args(["-segment_start_number", "1"])
        .arg(folder.path().join("shot_%d.mp4"))
        .stdin(Stdio::null());
    let output = command.output();
    let output = output.map_err(|error| KeyFrameError::Split(format!("ffmpeg: {error}")))?;
    if !output.status.success() {
        let said = String::from_utf8_lossy(&output.stderr);
        let said = said.lines().last().unwrap_or("it failed").to_owned();
        return Err(KeyFrameError::Split(format!("ffmpeg: {said}")));
    }
    let files = (1..=shots.len()).map(|number| folder.path().join(format!("shot_{number}.mp4")));
    let files: Vec<PathBuf> = files.collect();
    match files.iter().all(|file| file.is_file()) {
        true => Ok(Films {
            files,
            _folder: folder,
        }),
        false => Err(KeyFrameError::Split(
            "ffmpeg wrote fewer films than there are shots".into(),
        )),
    }
}
