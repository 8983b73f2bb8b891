//! Videos that the program ffmpeg reads.

mod messages;
mod probe;

use std::ffi::OsString;
use std::io;
use std::path::{Path, PathBuf};
use std::process::{Child, ChildStdout, Command, Stdio};
use std::sync::mpsc::{Receiver, channel};
use std::thread::{self, JoinHandle};

use self::messages::{Messages, Shown};
use self::probe::Probe;
use super::y4m::Y4mSource;
use super::{Frame, Properties, Source};
use crate::VideoError;

/// A video of any kind that the programs `ffmpeg` and `ffprobe` read, from version 5.1 on, where
/// they are installed: the first video of the file, upright, without a change of its pixels.
///
/// The pictures come through a pipe, one after another, with the time at which each is shown.
/// Pixels must be of 8 or 10 bits, 4:2:0, 4:2:2, 4:4:4 or grey; others are refused by their name.
#[derive(Debug)]
pub struct FfmpegSource {
    file: PathBuf,
    process: Child,
    frames: Y4mSource<ChildStdout>,
    properties: Properties,
    shown: Receiver<Shown>,
    /// What reads the messages; the result is the first error of them.
    messages: Option<JoinHandle<Option<String>>>,
    /// The time of the first frame in seconds.
    start: Option<f64>,
    /// Frames that were read.
    count: usize,
    has_ended: bool,
}

/// Whether `ffmpeg` and `ffprobe` can be called.
#[must_use]
pub fn is_installed() -> bool {
    ["ffmpeg", "ffprobe"].iter().all(|program| {
        let mut command = Command::new(program);
        command.arg("-version").stdin(Stdio::null());
        let status = command.stdout(Stdio::null()).stderr(Stdio::null()).status();
        status.is_ok_and(|status| status.success())
    })
}

impl FfmpegSource {
    /// Asks what the file holds, and begins to decode.
    ///
    /// # Errors
    ///
    /// [`VideoError::Ffmpeg`] where a program does not start or cannot read the file, or for
    /// colours that are not read; [`VideoError::Samples`], [`VideoError::Interlaced`],
    /// [`VideoError::Empty`].
    pub fn open(path: impl AsRef<Path>) -> Result<Self, VideoError> {
        let file = path.as_ref();
        let wrong = |problem| VideoError::Ffmpeg {
            file: file.into(),
            problem,
        };
        let probe = Probe::of(&named(file)).map_err(wrong)?;
        let pixels = probe.pixels();
        let pixels = pixels.map_err(|problem| VideoError::Samples {
            file: file.into(),
            problem,
        })?;
        let mut command = Command::new("ffmpeg");
        command
            .args(["-nostdin", "-hide_banner", "-nostats", "-xerror"])
            .args(["-loglevel", "repeat+level+info"])
            .args(["-protocol_whitelist", "file,pipe", "-i"])
            .arg(named(file))
            .args(["-map", "0:V:0", "-vf", "showinfo=checksum=0"])
            .args(["-fps_mode", "passthrough", "-pix_fmt", pixels])
            .args(["-strict", "-1", "-f", "yuv4mpegpipe", "-"])
            .stdin(Stdio::null())
            .stdout(Stdio::piped())
            .stderr(Stdio::piped());
        let not_started = |error: io::Error| wrong(format!("ffmpeg does not start: {error}"));
        let mut process = command.spawn().map_err(not_started)?;
        let (Some(output), Some(errors)) = (process.stdout.take(), process.stderr.take()) else {
            return Err(wrong("ffmpeg has no output".into()));
        };
        let (sender, shown) = channel();
        let messages = thread::spawn(move || Messages::new(errors, sender).read());
        let frames = match Y4mSource::new(output, file) {
            Ok(frames) => frames,
            Err(error @ VideoError::Interlaced { .. }) => {
                end(&mut process);
                return Err(error);
            }
            Err(_) => {
                end(&mut process);
                let said = messages.join().ok().flatten();
                return Err(wrong(said.unwrap_or_else(|| "it gives no pictures".into())));
            }
        };
        let mut properties = *frames.properties();
        properties.colours.luma = probe.luma().map_err(wrong)?;
        properties.frames_per_second = probe.constant_rate();
        properties.frame_count = None;
        Ok(Self {
            file: file.into(),
            process,
            frames,
            properties,
            shown,
            messages: Some(messages),
            start: None,
            count: 0,
            has_ended: false,
        })
    }

    /// What was wrong, once there are no more pictures.
    fn finish(&mut self) -> Result<(), VideoError> {
        let (file, frame) = (self.file.clone(), self.count);
        let status = self.process.wait();
        let said = self.messages.take().and_then(|thread| thread.join().ok());
        let said = said.flatten();
        match status {
            Ok(status) if status.success() && said.is_none() => match self.count {
                0 => Err(VideoError::Empty { file }),
                _ => Ok(()),
            },
            Ok(status) => Err(VideoError::Decoding {
                file,
                frame,
                problem: said.unwrap_or_else(|| format!("ffmpeg ended with {status}")),
            }),
            Err(source) => Err(VideoError::Read {
                file,
                frame,
                source,
            }),
        }
    }

    /// Gives the frame its time, and looks whether it is like the first one.
    fn described(&mut self, frame: &mut Frame) -> Result<(), VideoError> {
        let (file, index) = (self.file.clone(), self.count);
        let Ok(shown) = self.shown.recv() else {
            return Err(VideoError::Decoding {
                file,
                frame: index,
                problem: "ffmpeg does not say when it is shown".into(),
            });
        };
        if shown.is_interlaced {
            return Err(VideoError::Interlaced { file });
        }
        // ffmpeg scales pictures to the size of the first.
        if shown.size != self.properties.size {
            return Err(VideoError::Size {
                file,
                frame: index,
                size: shown.size,
                first: self.properties.size,
            });
        }
        let start = *self.start.get_or_insert(shown.seconds);
        frame.time_seconds = shown.seconds - start;
        Ok(())
    }
}

impl Source for FfmpegSource {
    fn properties(&self) -> &Properties {
        &self.properties
    }

    fn read(&mut self, frame: &mut Frame) -> Result<bool, VideoError> {
        if self.has_ended {
            return Ok(false);
        }
        self.has_ended = true;
        match self.frames.read(frame) {
            Ok(true) => {
                self.described(frame)?;
                self.count += 1;
                self.has_ended = false;
                Ok(true)
            }
            // Where ffmpeg ends early, its messages say why.
            outcome => {
                self.finish()?;
                outcome
            }
        }
    }
}

impl Drop for FfmpegSource {
    fn drop(&mut self) {
        end(&mut self.process);
    }
}

/// Ends the process, where it still runs.
fn end(process: &mut Child) {
    // Neither can fail for a process that ran, unless it has ended already.
    let _ = process.kill();
    let _ = process.wait();
}

/// A name that is taken for a file, whatever it begins with.
fn named(file: &Path) -> OsString {
    let mut name = OsString::from("file:");
    name.push(file);
    name
}
