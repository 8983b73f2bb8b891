//! `nullcone contour`: the contours of what pictures show, in the picture and in space.

mod arguments;
mod curve;
mod flat;
mod settling;

pub(crate) use arguments::Arguments;

use anyhow::Result;
use serde::Serialize;

use crate::files::expanded;
use crate::frame::{self, Command, Context, Verdict, Warning};

/// What is printed.
#[derive(Serialize)]
#[serde(untagged)]
pub(crate) enum Report {
    Flat(flat::Report),
    Curve(Box<curve::Report>),
}

impl Command for Arguments {
    type Report = Report;

    fn is_check(&self) -> bool {
        self.check.check
    }

    fn run(&self, context: &Context) -> Result<Report> {
        let arguments = &Self {
            images: expanded("IMAGE", &self.images)?,
            ..self.clone()
        };
        match (&arguments.images[..], &self.rig) {
            ([image], None) => {
                self.chosen.refuse("it is about the cameras of --rig")?;
                flat::run(arguments, image, context).map(Report::Flat)
            }
            ([left, right], Some(rig)) => curve::run(arguments, [left, right], rig, context)
                .map(Box::new)
                .map(Report::Curve),
            ([image], Some(rig)) => anyhow::bail!(
                "--rig {} needs two views, and {} is one",
                rig.display(),
                image.display()
            ),
            (&[_, _, _, ..] | [], _) => anyhow::bail!(
                "IMAGE: a picture or two views are looked at, not {} pictures",
                arguments.images.len()
            ),
            _ => anyhow::bail!("two views need the cameras that took them: --rig rig.yml"),
        }
    }
}

impl frame::Report for Report {
    fn text(&self) -> String {
        match self {
            Self::Flat(report) => report.text(),
            Self::Curve(report) => report.text(),
        }
    }

    fn warnings(&self) -> Option<&[Warning]> {
        Some(match self {
            Self::Flat(report) => &report.warnings,
            Self::Curve(report) => &report.warnings,
        })
    }

    fn verdict(&self) -> Option<Verdict> {
        self.warnings().map(Verdict::of)
    }
}
