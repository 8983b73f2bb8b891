//! `nullcone stereo diagnose`: what is wrong with a pair that should be rectified.

use std::path::PathBuf;

use anyhow::{Error, Result};
use ga_vision::ViewGeometryError;
use ga_vision::diagnosis::{Diagnosis, DiagnosisOptions};
use ga_vision::feature::{ViewOptions, match_views};
use serde::Serialize;

use super::views;
use crate::frame::{self, Check, Command, Context, Verdict, Warning};

/// Say how a pair of views deviates from a rectified one.
///
/// In rectified views the images of a point are in one row. The rows of matched points, whatever
/// their depth, show how the right view is rotated, magnified and displaced vertically against the
/// left. Pictures in colour are taken as grey.
///
/// For instance
///
///   nullcone stereo diagnose left.png right.png --json
///
/// prints {"rectified": …, "views_exchanged": …, "vertical_offset_px": …, "rotation_degrees": …,
/// "zoom": …, "vertical_disparity_median_px": …, "vertical_disparity_rms_px": …,
/// "vertical_disparity_95_percent_px": …, "unexplained_rms_px": …, "disparity_least_px": …,
/// "disparity_median_px": …, "disparity_greatest_px": …, "matches": …, "matches_used": …}.
/// Offsets are positive where the right view shows things lower, rotations where it is rotated
/// clockwise; zoom is its magnification. A pair counts as rectified where 95 percent of the
/// vertical disparities are below 1 px. The verdict is good where the views are rectified and not
/// exchanged; --json has it as "verdict", and what is wrong as "warnings".
#[derive(Clone, Debug, clap::Args)]
#[command(verbatim_doc_comment)]
pub(crate) struct Arguments {
    /// The left view.
    #[arg(value_name = "LEFT")]
    left: PathBuf,
    /// The right view.
    #[arg(value_name = "RIGHT")]
    right: PathBuf,
    /// Matches whose rows differ from the explanation by more than this number of pixels are left
    /// out.
    #[arg(
        long,
        value_name = "PX",
        default_value_t = 1.5,
        allow_negative_numbers = true
    )]
    threshold: f64,
    /// The seed of the random samples: equal seeds give equal results.
    #[arg(long, value_name = "N", default_value_t = 1)]
    seed: u64,
    #[command(flatten)]
    check: Check,
}

/// What is printed.
#[derive(Serialize)]
pub(crate) struct Report {
    rectified: bool,
    views_exchanged: bool,
    vertical_offset_px: f64,
    rotation_degrees: f64,
    zoom: f64,
    vertical_disparity_median_px: f64,
    vertical_disparity_rms_px: f64,
    vertical_disparity_95_percent_px: f64,
    unexplained_rms_px: f64,
    disparity_least_px: f64,
    disparity_median_px: f64,
    disparity_greatest_px: f64,
    matches: usize,
    matches_used: usize,
    #[serde(skip)]
    warnings: Vec<Warning>,
}

impl Command for Arguments {
    type Report = Report;

    fn is_check(&self) -> bool {
        self.check.check
    }

    fn run(&self, context: &Context) -> Result<Report> {
        let arguments = self;
        context.files([&arguments.left, &arguments.right])?;
        let progress = context.progress(3);
        progress.step("reading the views");
        let [left, right] = views::read_pair(&arguments.left, &arguments.right)?;
        views::check_side(&left, &arguments.left)?;
        progress.step("matching points");
        let matching = ViewOptions::default();
        let pairs = match_views(&left, &right, &matching);
        progress.step("fitting");
        let options = DiagnosisOptions {
            threshold: arguments.threshold,
            seed: arguments.seed,
        };
        let found = Diagnosis::new(&pairs, [left.width(), left.height()], options);
        let paths = [&*arguments.left, &*arguments.right];
        let found = found.map_err(|error| {
            let context = match error {
                ViewGeometryError::TooFewMatches { needed, .. } => {
                    views::few_matches([&left, &right], paths, &matching.detect, needed)
                }
                _ => format!("{} and {}", paths[0].display(), paths[1].display()),
            };
            Error::new(error).context(context)
        })?;
        drop(progress);
        Ok(Report::new(&found))
    }
}

impl Report {
    fn new(found: &Diagnosis) -> Self {
        let mut warnings = Vec::new();
        if !found.is_rectified() {
            let most = found.vertical.most;
            let message = format!(
                "the views are not rectified: 95 % of the vertical disparities are below {most:.3} px, and should be below 1 px"
            );
            warnings.push(Warning::new("not_rectified", message));
        }
        if found.is_exchanged() {
            let message = "the disparities are negative: the views seem to be exchanged";
            warnings.push(Warning::new("views_exchanged", message));
        }
        Self {
            rectified: found.is_rectified(),
            views_exchanged: found.is_exchanged(),
            vertical_offset_px: found.vertical_offset,
            rotation_degrees: found.rotation.to_degrees(),
            zoom: found.zoom,
            vertical_disparity_median_px: found.vertical.median,
            vertical_disparity_rms_px: found.vertical.rms,
            vertical_disparity_95_percent_px: found.vertical.most,
            unexplained_rms_px: found.residual_rms,
            disparity_least_px: found.disparity[0],
            disparity_median_px: found.disparity[1],
            disparity_greatest_px: found.disparity[2],
            matches: found.pairs,
            matches_used: found.agreeing,
            warnings,
        }
    }
}

impl frame::Report for Report {
    fn warnings(&self) -> Option<&[Warning]> {
        Some(&self.warnings)
    }

    fn verdict(&self) -> Option<Verdict> {
        Some(match (self.rectified, self.views_exchanged) {
            (true, false) => Verdict::Good,
            _ => Verdict::Failed,
        })
    }

    fn text(&self) -> String {
        let verdict = if self.rectified {
            "the views are rectified"
        } else {
            "the views are not rectified"
        };
        let exchanged = match self.views_exchanged {
            true => "the disparities are negative: the views seem to be exchanged\n",
            false => "",
        };
        format!(
            "{verdict}\n{exchanged}\
             vertical offset       {:9.3} px\n\
             rotation              {:9.4}°\n\
             zoom                  {:9.5}\n\
             vertical disparity    {:9.3} px (rms), 95 % below {:.3} px\n\
             unexplained           {:9.3} px (rms)\n\
             disparity             {:9.1} to {:.1} px\n\
             matches used          {:9} of {}\n",
            self.vertical_offset_px,
            self.rotation_degrees,
            self.zoom,
            self.vertical_disparity_rms_px,
            self.vertical_disparity_95_percent_px,
            self.unexplained_rms_px,
            self.disparity_least_px,
            self.disparity_greatest_px,
            self.matches_used,
            self.matches
        )
    }
}
