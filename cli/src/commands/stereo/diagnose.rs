//! `nullcone stereo diagnose`: what is wrong with a pair that should be rectified.

use anyhow::{Error, Result};
use ga_vision::ViewGeometryError;
use ga_vision::diagnosis::{Diagnosis, DiagnosisOptions};
use ga_vision::feature::{ViewOptions, match_views};
use serde::Serialize;

use super::views::{self, ViewPair};
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
/// "disparity_median_px": …, "disparity_greatest_px": …, "matches": …, "matches_used": …,
/// "sideways": …}. sideways says that points are in one column and not in one row.
/// Offsets are positive where the right view shows things lower, rotations where it is rotated
/// clockwise; zoom is its magnification. A pair counts as rectified where 95 percent of the
/// vertical disparities are below 1 px. The verdict is good where the views are rectified and not
/// exchanged; --json has it as "verdict", and what is wrong as "warnings".
#[derive(Clone, Debug, clap::Args)]
#[command(verbatim_doc_comment)]
pub(crate) struct Arguments {
    #[command(flatten)]
    views: ViewPair,
    /// Matches whose rows differ from the explanation by more than this number of pixels are left
    /// out.
    #[arg(long, value_name = "PX", default_value_t = 1.5)]
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
    #[serde(flatten)]
    found: Diagnosis,
    #[serde(skip)]
    warnings: Vec<Warning>,
}

impl Command for Arguments {
    type Report = Report;

    fn is_check(&self) -> bool {
        self.check.check
    }

    fn run(&self, context: &Context) -> Result<Report> {
        context.files(self.views.paths())?;
        let progress = context.progress(3);
        progress.step("reading the views");
        let [left, right] = views::read_pair(&self.views.left, &self.views.right)?;
        views::check_side(&left, &self.views.left)?;
        progress.step("matching points");
        let matching = ViewOptions::default();
        let pairs = match_views(&left, &right, &matching);
        progress.step("fitting");
        let options = DiagnosisOptions {
            threshold: self.threshold,
            seed: self.seed,
        };
        let found = Diagnosis::new(&pairs, [left.width(), left.height()], options);
        let found = found.map_err(|error| {
            let context = match error {
                ViewGeometryError::TooFewMatches { needed, .. } => {
                    let paths = self.views.paths();
                    views::few_matches([&left, &right], paths, &matching.detect, needed)
                }
                _ => self.views.named(),
            };
            Error::new(error).context(context)
        })?;
        let faults = found.faults().into_iter();
        Ok(Report {
            rectified: found.is_rectified(),
            views_exchanged: found.is_exchanged(),
            warnings: faults
                .map(|fault| Warning::new(fault.kind(), fault))
                .collect(),
            found,
        })
    }
}

impl frame::Report for Report {
    fn warnings(&self) -> Option<&[Warning]> {
        Some(&self.warnings)
    }

    fn verdict(&self) -> Option<Verdict> {
        Some(match self.warnings.as_slice() {
            [] => Verdict::Good,
            _ => Verdict::Failed,
        })
    }

    fn text(&self) -> String {
        let found = &self.found;
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
            found.vertical_offset,
            found.rotation.to_degrees(),
            found.zoom,
            found.vertical.rms,
            found.vertical.most,
            found.residual_rms,
            found.disparity.least,
            found.disparity.greatest,
            found.agreeing,
            found.pairs
        )
    }
}
