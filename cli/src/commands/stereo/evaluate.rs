//! `nullcone stereo evaluate`: how far a disparity map is from the truth.

use std::path::PathBuf;

use anyhow::{Context as _, Result, ensure};
use ga_image::png;
use ga_vision::disparity::evaluation::{ErrorMap, ErrorMeasures};
use ga_vision::disparity::{file, picture};

use crate::format::Format;
use crate::frame::{Command, Context, Report};
use crate::output;

/// Compare a disparity map with the truth.
///
/// bad_0_5 is the percentage of pixels whose error is strictly more than 0.5 px, and so on; density
/// is the percentage of pixels whose disparity is known. Pixels whose truth is 0 or not finite are
/// left out. A pixel whose disparity is unknown counts as an error in every bad_…, and is left out
/// of the average. For instance
///
///   nullcone stereo evaluate d.pfm truth.png --scale 4 --json
///
/// prints {"bad_0_5": …, "bad_1": …, "bad_2": …, "bad_3": …, "average_px": …, "density": …,
/// "truth_pixels": …}.
#[derive(Clone, Debug, clap::Args)]
#[command(verbatim_doc_comment)]
pub(crate) struct Arguments {
    /// The disparity map; numbers that are not finite are unknown.
    #[arg(value_name = "MAP.pfm")]
    map: PathBuf,
    /// The true disparities: PFM, or PNG in grey with 8 or 16 bits.
    #[arg(value_name = "TRUTH")]
    truth: PathBuf,
    /// What the truth stores is this number × the disparity in pixels.
    #[arg(long, value_name = "S", default_value_t = 1.0)]
    scale: f64,
    /// Write a picture of the map, the truth and the errors beside each other.
    #[arg(long, value_name = "FILE.png")]
    picture: Option<PathBuf>,
}

impl Command for Arguments {
    type Report = ErrorMeasures;

    fn run(&self, context: &Context) -> Result<ErrorMeasures> {
        let scale = self.scale;
        ensure!(
            scale > 0.0 && scale.is_finite(),
            "--scale {scale}: what the truth stores must be divided by a positive, finite number"
        );
        let mut files = context.files([&self.map, &self.truth])?;
        files.write_if_given("--picture", self.picture.as_ref(), &[Format::Png])?;
        let map = file::read(&self.map)?;
        let truth = file::read_truth(&self.truth, scale)?;
        let errors = ErrorMap::new(&map, &truth).with_context(|| {
            let [map, truth] = [&self.map, &self.truth].map(|path| path.display());
            format!("{map} and {truth}")
        })?;
        if let Some(path) = &self.picture {
            let sheet = picture::comparison(&map, &truth, &errors);
            output::write(path, &png::encode(&sheet)?)?;
        }
        Ok(errors.measures())
    }
}

impl Report for ErrorMeasures {
    fn text(&self) -> String {
        let average = match self.average_px {
            Some(average) => format!("{average:.3} px"),
            None => "none is known".into(),
        };
        format!(
            "bad 0.5   {:7.3} %\nbad 1     {:7.3} %\nbad 2     {:7.3} %\nbad 3     {:7.3} %\n\
             average   {average}\ndensity   {:7.3} % of {} pixels with truth\n",
            self.bad_0_5, self.bad_1, self.bad_2, self.bad_3, self.density, self.truth_pixels
        )
    }
}
