//! What ffprobe says of a file.

use std::ffi::OsStr;
use std::process::{Command, Stdio};

use ga_image::grey::Luma;
use serde::Deserialize;

/// What a file holds: its first video, and the packets of that.
#[derive(Debug, Default, Deserialize)]
pub(super) struct Probe {
    #[serde(default)]
    streams: Vec<Stream>,
    #[serde(default)]
    packets: Vec<Packet>,
    /// The first frame, where it was asked for.
    #[serde(default)]
    frames: Vec<Pixels>,
}

/// What is said of pixels.
#[derive(Clone, Debug, Default, Deserialize)]
struct Pixels {
    pix_fmt: Option<String>,
    color_space: Option<String>,
}

#[derive(Debug, Default, Deserialize)]
struct Stream {
    #[serde(flatten)]
    pixels: Pixels,
    r_frame_rate: Option<String>,
    time_base: Option<String>,
}

#[derive(Debug, Deserialize)]
struct Packet {
    pts: Option<i64>,
    #[serde(default)]
    flags: String,
}

/// The kinds of pixels that a pipe of Y4M carries as they are, and those of the same numbers in
/// another order.
const PIXELS: [(&str, &str); 16] = [
    ("yuv420p", "yuv420p"),
    ("yuvj420p", "yuvj420p"),
    ("nv12", "yuv420p"),
    ("nv21", "yuv420p"),
    ("yuv422p", "yuv422p"),
    ("yuvj422p", "yuvj422p"),
    ("yuyv422", "yuv422p"),
    ("uyvy422", "yuv422p"),
    ("yuv444p", "yuv444p"),
    ("yuvj444p", "yuvj444p"),
    ("gray", "gray"),
    ("yuv420p10le", "yuv420p10le"),
    ("p010le", "yuv420p10le"),
    ("yuv422p10le", "yuv422p10le"),
    ("yuv444p10le", "yuv444p10le"),
    ("gray10le", "gray10le"),
];

/// The kind of pixels of which nothing is said.
const UNKNOWN: &str = "unknown";

impl Probe {
    /// Asks ffprobe. The error says what it says.
    pub(super) fn of(file: &OsStr) -> Result<Self, String> {
        let shown = "stream=pix_fmt,color_space,r_frame_rate,time_base:packet=pts,flags";
        let mut probe = Self::asked(file, &["-show_entries", shown])?;
        if probe.streams.is_empty() {
            return Err("the file has no video".into());
        }
        // Where a film begins with sound, ffprobe may give up before it has seen a picture.
        if probe.kind_of_pixels() == UNKNOWN {
            let shown = "frame=pix_fmt,color_space";
            let first = ["-read_intervals", "%+#1", "-show_entries", shown];
            let first = Self::asked(file, &first)?;
            if let Some(pixels) = first.frames.into_iter().next() {
                probe.streams[0].pixels = pixels;
            }
        }
        Ok(probe)
    }

    fn asked(file: &OsStr, what: &[&str]) -> Result<Self, String> {
        let mut command = Command::new("ffprobe");
        command
            .args(["-loglevel", "error", "-protocol_whitelist", "file"])
            .args(["-select_streams", "V:0", "-of", "json"])
            .args(what)
            .arg(file)
            .stdin(Stdio::null());
        let output = command.output();
        let output = output.map_err(|error| format!("ffprobe does not start: {error}"))?;
        if !output.status.success() {
            let said = String::from_utf8_lossy(&output.stderr);
            let last = said.lines().last().unwrap_or("ffprobe fails");
            let problem = last.rsplit_once(": ").map_or(last, |(_, problem)| problem);
            return Err(problem.to_owned());
        }
        serde_json::from_slice(&output.stdout)
            .map_err(|error| format!("ffprobe does not print JSON: {error}"))
    }

    /// The kind of pixels for which ffmpeg is asked, which has the same numbers.
    pub(super) fn pixels(&self) -> Result<&'static str, String> {
        let own = self.kind_of_pixels();
        let found = PIXELS.iter().find(|(name, _)| *name == own);
        let found = found.map(|(_, pixels)| *pixels);
        found.ok_or_else(|| format!("pixels of the kind {own} are not read"))
    }

    fn kind_of_pixels(&self) -> &str {
        self.stream().pixels.pix_fmt.as_deref().unwrap_or(UNKNOWN)
    }

    /// The weights of luma; those of BT.601 where the file does not say them.
    pub(super) fn luma(&self) -> Result<Luma, String> {
        match self.stream().pixels.color_space.as_deref() {
            None | Some("unknown" | "bt470bg" | "smpte170m") => Ok(Luma::Bt601),
            Some("bt709") => Ok(Luma::Bt709),
            Some("bt2020nc") => Ok(Luma::Bt2020),
            Some(other) => Err(format!("colours of the kind {other} are not read")),
        }
    }

    /// The rate of frames, where all are shown at multiples of its inverse, up to the unit of time.
    pub(super) fn constant_rate(&self) -> Option<[u32; 2]> {
        let stream = self.stream();
        let rate = quotient(stream.r_frame_rate.as_deref()?)?;
        let [numerator, denominator] = quotient(stream.time_base.as_deref()?)?;
        let shown = self
            .packets
            .iter()
            .filter(|packet| !packet.flags.contains('D'));
        let mut times: Vec<i64> = shown.map(|packet| packet.pts).collect::<Option<_>>()?;
        times.sort_unstable();
        let first = *times.first()?;
        let units = |seconds: f64| seconds * f64::from(denominator) / f64::from(numerator);
        let is_at = |(frame, time): (usize, &i64)| {
            let seconds = frame as f64 * f64::from(rate[1]) / f64::from(rate[0]);
            ((time - first) as f64 - units(seconds)).abs() <= 1.0
        };
        (times.len() > 1 && times.iter().enumerate().all(is_at)).then_some(rate)
    }

    /// The first video: there is one.
    fn stream(&self) -> &Stream {
        &self.streams[0]
    }
}

/// A quotient of positive numbers, such as `25/1`.
fn quotient(text: &str) -> Option<[u32; 2]> {
    let (numerator, denominator) = text.split_once('/')?;
    let numbers = [numerator.parse().ok()?, denominator.parse().ok()?];
    (!numbers.contains(&0)).then_some(numbers)
}

#[cfg(test)]
#[allow(clippy::unwrap_used, reason = "a test may panic")]
mod tests {
    use super::*;

    fn rate(times: &[i64]) -> Option<[u32; 2]> {
        let stream = Stream {
            r_frame_rate: Some("24000/1001".into()),
            time_base: Some("1/1000".into()),
            ..Stream::default()
        };
        let packet = |&pts| Packet {
            pts: Some(pts),
            flags: "K__".into(),
        };
        let mut packets: Vec<Packet> = times.iter().map(packet).collect();
        packets.push(Packet {
            pts: Some(-5000),
            flags: "_D_".into(),
        });
        let streams = vec![stream];
        Probe {
            streams,
            packets,
            ..Probe::default()
        }
        .constant_rate()
    }

    /// Milliseconds of frames at 24000/1001 in a second, in the order of decoding.
    #[test]
    fn a_rate_is_constant_up_to_the_unit_of_time() {
        assert_eq!(rate(&[0, 83, 42, 125, 167]), Some([24_000, 1001]));
        assert_eq!(rate(&[0, 83, 42, 125, 209]), None);
        assert_eq!(rate(&[0]), None);
    }
}
