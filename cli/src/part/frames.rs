//! Some frames of all.

use std::fmt::{Display, Formatter, Result as Formatted};
use std::ops::Range;
use std::str::FromStr;

use anyhow::{Error, Result, bail, ensure};

/// Frames from one on and up to another, which is not among them; without an end up to the last.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Frames {
    pub(crate) first: usize,
    pub(crate) end: Option<usize>,
}

impl FromStr for Frames {
    type Err = Error;

    fn from_str(text: &str) -> Result<Self> {
        let number = |text: &str| match text.bytes().all(|byte| byte.is_ascii_digit()) {
            true => text.parse::<usize>().ok(),
            // `parse` would accept a sign.
            false => None,
        };
        let Some((first, end)) = text.split_once("..") else {
            bail!("it must be as 0..100, 100.. or ..100");
        };
        let (first, end) = match (first, end) {
            ("", "") => bail!("without numbers these are all frames"),
            ("", end) => (Some(0), number(end).map(Some)),
            (first, "") => (number(first), Some(None)),
            (first, end) => (number(first), number(end).map(Some)),
        };
        let (Some(first), Some(end)) = (first, end) else {
            bail!("it must be as 0..100, 100.. or ..100");
        };
        ensure!(
            end.is_none_or(|end| first < end),
            "these are no frames: the first must be less than the end, which is not included"
        );
        Ok(Self { first, end })
    }
}

impl Display for Frames {
    fn fmt(&self, formatter: &mut Formatter<'_>) -> Formatted {
        match self.end {
            Some(end) => write!(formatter, "{}..{end}", self.first),
            None => write!(formatter, "{}..", self.first),
        }
    }
}

impl Frames {
    /// Those among a number of frames. Where all parts are to have the same number of frames, the
    /// last one may end before its end.
    ///
    /// # Errors
    ///
    /// None of them are.
    pub(crate) fn among(self, count: usize) -> Result<Range<usize>> {
        let end = self.end.unwrap_or(count).min(count);
        ensure!(
            self.first < end,
            "--frames {self}: there are {count} frames, the last is {}",
            count.saturating_sub(1)
        );
        Ok(self.first..end)
    }

    /// Whether a frame comes after them.
    pub(crate) fn end_at(self, frame: usize) -> bool {
        self.end.is_some_and(|end| end <= frame)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn ranges_are_those_of_rust() {
        let parsed = |text: &str| text.parse::<Frames>().map(|found| (found.first, found.end));
        assert_eq!(parsed("3..10").unwrap(), (3, Some(10)));
        assert_eq!(parsed("3..").unwrap(), (3, None));
        assert_eq!(parsed("..10").unwrap(), (0, Some(10)));
        for wrong in [
            "", "..", "3", "3-10", "3..=10", "-3..4", "+3..4", "4..4", "5..4", "a..b",
        ] {
            assert!(parsed(wrong).is_err(), "{wrong}");
        }
        assert_eq!("3..10".parse::<Frames>().unwrap().to_string(), "3..10");
    }

    #[test]
    fn the_last_part_may_be_shorter() {
        let among = |text: &str, count| text.parse::<Frames>().unwrap().among(count);
        assert_eq!(among("3..10", 8).unwrap(), 3..8);
        assert_eq!(among("3..", 8).unwrap(), 3..8);
        assert_eq!(among("3..5", 8).unwrap(), 3..5);
        let error = among("8..10", 8).unwrap_err().to_string();
        assert_eq!(error, "--frames 8..10: there are 8 frames, the last is 7");
    }
}
