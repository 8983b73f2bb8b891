//! Which film is asked for.

use std::path::PathBuf;

use anyhow::{Result, bail, ensure};
use serde::Serialize;

/// A film in place of a picture.
#[derive(Clone, Debug, Serialize, clap::Args)]
pub(super) struct FilmArguments {
    /// A film of the animation, in place of a picture: an animated PNG if its name ends in .png, a
    /// film without compression if it ends in .y4m, which `ffmpeg -i FILE.y4m FILE.mp4` makes
    /// small, or H.264 if it ends in .mp4, where the program was built with the feature `mp4`.
    #[arg(
        id = "film",
        long = "film",
        value_name = "FILE.png|FILE.y4m|FILE.mp4",
        conflicts_with = "out"
    )]
    #[serde(skip)]
    pub(super) file: Option<PathBuf>,
    /// The pictures of the film in a second, at most 1000.
    #[arg(long, value_name = "FPS", default_value_t = 25.0, requires = "film")]
    pub(super) rate: f64,
    /// The time in seconds at which the film begins.
    #[arg(long, value_name = "SECONDS", default_value_t = 0.0, requires = "film")]
    from: f64,
    /// The time in seconds at which the film ends; by default that of the last key of the
    /// animation.
    #[arg(long, value_name = "SECONDS", requires = "film")]
    to: Option<f64>,
}

/// The most pictures of a film: more than an hour.
const MOST_PICTURES: f64 = 100_000.0;

/// The times of the pictures of a film.
pub(super) struct Times {
    from: f64,
    rate: f64,
    count: usize,
}

impl Times {
    pub(super) fn one(time: f64) -> Self {
        Self {
            from: time,
            rate: 1.0,
            count: 1,
        }
    }

    pub(super) fn count(&self) -> usize {
        self.count
    }

    /// The time of a picture.
    pub(super) fn at(&self, picture: usize) -> f64 {
        self.from + picture as f64 / self.rate
    }

    /// The first and the last time.
    pub(super) fn ends(&self) -> [f64; 2] {
        [self.from, self.at(self.count.saturating_sub(1))]
    }
}

impl FilmArguments {
    /// Fails for numbers that no film has.
    pub(super) fn check(&self) -> Result<()> {
        let Self { rate, from, to, .. } = *self;
        ensure!(
            rate > 0.0 && rate <= 1000.0,
            "--rate {rate}: the number of pictures in a second must be greater than 0 and at most \
             1000"
        );
        for (option, time) in [("--from", Some(from)), ("--to", to)] {
            if let Some(time) = time.filter(|time| !time.is_finite()) {
                bail!("{option} {time}: the time must be finite");
            }
        }
        if let Some(to) = to.filter(|&to| to < from) {
            bail!("--from {from} comes after --to {to}");
        }
        Ok(())
    }

    /// The times of the pictures, where the animation ends at this time. A picture that would be
    /// missed by rounding alone counts.
    pub(super) fn times(&self, end: f64) -> Result<Times> {
        let (from, rate) = (self.from, self.rate);
        let to = self.to.unwrap_or(end);
        ensure!(
            from <= to,
            "--from {from}: the animation ends at {} s",
            end as f32
        );
        let steps = ((to - from) * rate * (1.0 + f64::from(f32::EPSILON))).floor();
        ensure!(
            steps < MOST_PICTURES,
            "--film: {from} to {} s at {rate} pictures in a second are more than {MOST_PICTURES} \
             pictures; choose less by --from and --to, or a lower --rate",
            to as f32
        );
        let count = steps as usize + 1;
        Ok(Times { from, rate, count })
    }
}
