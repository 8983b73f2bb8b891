//! `nullcone stereo evaluate`: how far a disparity map is from the truth.

use std::path::PathBuf;

use anyhow::{Context as _, Result, ensure};
use ga_image::plane::Plane;
use ga_image::png;
use ga_vision::disparity::DisparityMap;
use ga_vision::disparity::evaluation::ErrorMap;
use ga_vision::disparity::file;
use ga_vision::disparity::picture::ColourScale;
use serde::Serialize;

use super::picture::{self, Panel};
use crate::format::Format;
use crate::frame::{self, Command, Context};
use crate::output;

/// Errors of this number of pixels and more have the last colour of the picture.
const MOST_ERROR_PX: f64 = 4.0;

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
    #[arg(
        long,
        value_name = "S",
        default_value_t = 1.0,
        allow_negative_numbers = true
    )]
    scale: f64,
    /// Write a picture of the map, the truth and the errors beside each other.
    #[arg(long, value_name = "FILE.png")]
    picture: Option<PathBuf>,
}

/// What is printed. Percentages, unless the name has a unit.
#[derive(Serialize)]
pub(crate) struct Report {
    bad_0_5: f64,
    bad_1: f64,
    bad_2: f64,
    bad_3: f64,
    average_px: Option<f64>,
    density: f64,
    truth_pixels: usize,
}

impl Command for Arguments {
    type Report = Report;

    fn run(&self, context: &Context) -> Result<Report> {
        let arguments = self;
        let scale = arguments.scale;
        ensure!(
            scale > 0.0 && scale.is_finite(),
            "--scale {scale}: what the truth stores must be divided by a positive, finite number"
        );
        let mut files = context.files([&arguments.map, &arguments.truth])?;
        files.write_if_given("--picture", arguments.picture.as_ref(), &[Format::Png])?;
        let map = file::read(&arguments.map)?;
        let truth = file::read_truth(&arguments.truth, scale)?;
        let errors = ErrorMap::new(&map, &truth).with_context(|| {
            let [map, truth] = [&arguments.map, &arguments.truth].map(|path| path.display());
            format!("{map} and {truth}")
        })?;
        let report = Report {
            bad_0_5: errors.bad(0.5),
            bad_1: errors.bad(1.0),
            bad_2: errors.bad(2.0),
            bad_3: errors.bad(3.0),
            average_px: errors.average_px(),
            density: errors.density(),
            truth_pixels: errors.pixels(),
        };
        if let Some(path) = &arguments.picture {
            let sheet = picture_of(&map, &truth, &errors);
            output::write(path, &png::encode(&sheet)?)?;
        }
        Ok(report)
    }
}

/// The map and the truth in the colours of one scale, and the errors.
fn picture_of(map: &DisparityMap, truth: &DisparityMap, errors: &ErrorMap) -> Plane<[u8; 3]> {
    // A truth of 0 is as unknown as one that is not finite.
    let known = |value: f32| if value == 0.0 { f32::NAN } else { value };
    let truth = DisparityMap::new(truth.plane().map(known));
    let range = truth.range().unwrap_or_default().map(f64::from);
    let disparities = ColourScale::viridis(range);
    let errors_scale = ColourScale::inferno([0.0, MOST_ERROR_PX]);
    let panel = |caption: String, map: &DisparityMap| Panel {
        caption,
        picture: disparities.disparities(map),
        scale: disparities,
        most: format!("{:.1} px", range[1]),
        marks: vec![(ColourScale::unknown, "unknown")],
    };
    picture::beside(&[
        panel("disparity".into(), map),
        panel("truth".into(), &truth),
        Panel {
            caption: format!("error, bad 2 = {:.2} %", errors.bad(2.0)),
            picture: errors_scale.errors(errors),
            scale: errors_scale,
            most: format!("{MOST_ERROR_PX:.1} px or more"),
            marks: vec![
                (ColourScale::unknown, "disparity unknown"),
                (|_| ColourScale::left_out(), "no truth"),
            ],
        },
    ])
}

impl frame::Report for Report {
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
