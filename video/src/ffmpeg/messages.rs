//! What ffmpeg says while it decodes.

use std::io::{BufRead, BufReader, Read};
use std::sync::mpsc::Sender;

/// What the filter `showinfo` says of a frame.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Shown {
    /// When it is shown.
    pub(super) seconds: f64,
    /// Columns and rows.
    pub(super) size: [usize; 2],
    pub(super) is_interlaced: bool,
}

/// The lines that ffmpeg writes to its standard error.
pub(super) struct Messages<R> {
    lines: BufReader<R>,
    frames: Sender<Shown>,
    /// Seconds of a unit of time, as a quotient.
    time_base: Option<[f64; 2]>,
    error: Option<String>,
}

impl<R: Read> Messages<R> {
    pub(super) fn new(errors: R, frames: Sender<Shown>) -> Self {
        Self {
            lines: BufReader::new(errors),
            frames,
            time_base: None,
            error: None,
        }
    }

    /// Reads until ffmpeg ends: passes on what is said of frames, and returns the first error.
    pub(super) fn read(mut self) -> Option<String> {
        let mut line = Vec::new();
        while self
            .lines
            .read_until(b'\n', &mut line)
            .is_ok_and(|read| read > 0)
        {
            self.read_line(&String::from_utf8_lossy(&line));
            line.clear();
        }
        self.error
    }

    fn read_line(&mut self, line: &str) {
        let line = line.trim();
        let is_error = ["[error]", "[fatal]", "[panic]"]
            .iter()
            .any(|level| line.contains(level));
        if is_error {
            let message = line.rsplit_once("] ").map_or(line, |(_, message)| message);
            self.error.get_or_insert_with(|| message.to_owned());
        } else if !line.starts_with("[Parsed_showinfo") {
        } else if let Some((_, rest)) = line.split_once("config in time_base: ") {
            let quotient = rest.split([',', ' ']).next().unwrap_or_default();
            self.time_base = quotient
                .split_once('/')
                .and_then(|(numerator, denominator)| {
                    Some([numerator.parse().ok()?, denominator.parse().ok()?])
                });
        } else if let Some(shown) = self.shown(line) {
            // Nobody reads where the source is closed.
            let _ = self.frames.send(shown);
        }
    }

    /// What a line such as `n: 3 pts: 1024 … s:320x240 i:P …` says.
    fn shown(&self, line: &str) -> Option<Shown> {
        let word = |name: &str| {
            let (_, rest) = line.split_once(name)?;
            rest.split_whitespace().next()
        };
        let units: f64 = word(" pts:")?.parse().ok()?;
        let [numerator, denominator] = self.time_base?;
        let (columns, rows) = word(" s:")?.split_once('x')?;
        Some(Shown {
            seconds: units * numerator / denominator,
            size: [columns.parse().ok()?, rows.parse().ok()?],
            is_interlaced: word(" i:")? != "P",
        })
    }
}

#[cfg(test)]
#[allow(clippy::unwrap_used, reason = "a test may panic")]
mod tests {
    use std::sync::mpsc::channel;

    use super::*;

    #[test]
    fn lines_give_frames_and_the_first_error() {
        let text = "\
[info] Input #0, mov, from 'file:pts: 3 s:1x1 i:T.mp4':
[Parsed_showinfo_0 @ 0x5] [info] config in time_base: 1/12800, frame_rate: 25/1
[Parsed_showinfo_0 @ 0x5] [info] n:   0 pts:    512 pts_time:0.04    pos: 9 fmt:yuv420p sar:1/1 s:352x240 i:P iskey:1
[Parsed_showinfo_0 @ 0x5] [info]   side data - User data unregistered:
[Parsed_showinfo_0 @ 0x5] [info] n:   1 pts:   1024 pts_time:0.08    pos: 9 fmt:yuv420p sar:1/1 s:352x240 i:T iskey:0
[h264 @ 0x6] [error] error while decoding MB 3 4
[fatal] Conversion failed!
";
        let (sender, receiver) = channel();
        let error = Messages::new(text.as_bytes(), sender).read();
        assert_eq!(error.as_deref(), Some("error while decoding MB 3 4"));
        let found: Vec<Shown> = receiver.iter().collect();
        let expected = |seconds, is_interlaced| Shown {
            seconds,
            size: [352, 240],
            is_interlaced,
        };
        assert_eq!(found, [expected(0.04, false), expected(0.08, true)]);
    }
}
