//! `nullcone quality compare`: a picture or a video against its reference.

mod arguments;
mod found;
mod measures;
mod merged;
mod videos;

use std::path::Path;

use anyhow::{Context as _, Result, bail, ensure};
use ga_image::file;
use ga_video::quality::{self, PictureQuality};

pub(crate) use self::arguments::{Arguments, COMMAND};
use self::arguments::{line, too_few_pixels};
pub(crate) use self::measures::Measures;
pub(crate) use self::merged::{FORMATS, merged};
use crate::format::Format;
use crate::frame::{Command, Context, Shown};

impl Command for Arguments {
    type Report = Shown<Measures>;

    fn run(&self, context: &Context) -> Result<Self::Report> {
        let paths = [&self.reference, &self.distorted];
        ensure!(
            !paths.iter().all(|path| path.as_os_str() == "-"),
            "standard input can be one of the two videos only"
        );
        let inputs = paths.into_iter().chain(&self.attention);
        let mut files = context.files(inputs)?;
        files.write_if_given("--csv", self.csv.as_ref(), &[Format::Csv])?;
        files.write_if_given("--plot", self.plot.as_ref(), &[Format::Svg])?;
        self.part.check(&mut files)?;
        let differ = |picture: &Path, other: &Path| {
            bail!(
                "{} is a picture and {} is not",
                picture.display(),
                other.display()
            )
        };
        match paths.map(|path| is_picture(path)) {
            // What is missing beside a picture is a picture: its reader says what is wrong.
            [Some(true), Some(true) | None] | [None, Some(true)] => self.pictures(context),
            [Some(true), Some(false)] => differ(paths[0], paths[1]),
            [Some(false), Some(true)] => differ(paths[1], paths[0]),
            _ => match self.part.asked() {
                Some((frames, path)) => {
                    let written = self.part_of_videos(frames, path, context)?;
                    Ok(written.map(Measures::Part))
                }
                None => Ok(self.videos(context)?.map(Measures::Videos)),
            },
        }
    }
}

/// Whether a file begins as a picture does; `None` where it cannot be read.
fn is_picture(path: &Path) -> Option<bool> {
    if path.as_os_str() == "-" {
        return Some(false);
    }
    let format = file::detect(path).ok()?;
    Some(format.is_some_and(|format| format != file::Format::Y4m))
}

impl Arguments {
    fn pictures(&self, context: &Context) -> Result<Shown<Measures>> {
        ensure!(
            self.plot.is_none(),
            "--plot draws measures over time, and pictures have none"
        );
        ensure!(
            !self.scale && !self.align_times,
            "--scale and --align-times are for videos"
        );
        ensure!(
            self.part.are_all(),
            "--frames chooses frames of videos, and pictures have none"
        );
        let [reference, distorted] = [&self.reference, &self.distorted].map(file::read);
        let (reference, distorted) = (reference?, distorted?);
        let size = [reference.width(), reference.height()];
        let map = self.read_map(size)?;
        let frame = quality::compare_pictures(&reference, &distorted, map);
        let frame = frame.with_context(|| self.names())?;
        let found = PictureQuality::new(&frame, size);
        let text = found.rows().iter().map(line).collect();
        let warnings = too_few_pixels(found.too_small_for());
        let page = context.report().map(|_| {
            let map = quality::similarity_map(&reference, &distorted)?;
            let page = found.page(self.files(&[]), [&reference, &distorted], &map);
            page.context("cannot encode the pictures")
        });
        let page = page.transpose()?;
        if let Some(path) = &self.csv {
            context.outputs().write(path, quality::csv(&[frame]))?;
        }
        Ok(Shown {
            warnings: Some(warnings),
            page,
            ..Shown::new(Measures::Pictures(found), text)
        })
    }
}
