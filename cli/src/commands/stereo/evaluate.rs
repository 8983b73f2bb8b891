//! `nullcone stereo evaluate`: how far a disparity map is from the truth.

use std::path::PathBuf;

use anyhow::{Context as _, Result, ensure};
use ga_image::png;
use ga_vision::disparity::evaluation::{ErrorMeasures, Evaluation};
use ga_vision::disparity::visibility::Visibility;
use ga_vision::disparity::{file, picture};

use crate::format::Format;
use crate::frame::{Command, Context, Report};

/// Compare a disparity map with the truth.
///
/// bad_0_5 is the percentage of pixels whose error is strictly more than 0.5 px, and so on; d1, of
/// KITTI, that of pixels whose error is more than 3 px and more than 5 % of the truth; density is
/// the percentage of pixels whose disparity is known. Pixels whose truth is 0 or not finite are
/// left out. A pixel whose disparity is unknown counts as an error in every bad_… and in d1, and is
/// left out of the average. For instance
///
///   nullcone stereo evaluate d.pfm truth.png --scale 4 --json
///
/// prints {"bad_0_5": …, "bad_1": …, "bad_2": …, "bad_3": …, "d1": …, "average_px": …,
/// "density": …, "truth_pixels": …, "visible": …, "occluded": …}. The last two have the same keys
/// for the pixels that both cameras see and for the others, or are null without --mask and
/// --visible.
///
/// Maps and truths are PFM, whose numbers that are not finite are unknown, or grey PNG or PGM with
/// 8 or 16 bits, where 0 is unknown. The numbers of 16 bits are divided by 256, as KITTI has them,
/// unless --scale or --map-scale gives another scale.
#[derive(Clone, Debug, clap::Args)]
#[command(verbatim_doc_comment)]
pub(crate) struct Arguments {
    /// The disparity map.
    #[arg(value_name = "MAP")]
    map: PathBuf,
    /// The true disparities.
    #[arg(value_name = "TRUTH")]
    truth: PathBuf,
    /// What the truth stores is this number × the disparity in pixels; by default 256 for 16 bits
    /// and 1 for other files.
    #[arg(long, value_name = "S")]
    scale: Option<f64>,
    /// The same for the map.
    #[arg(long, value_name = "S")]
    map_scale: Option<f64>,
    /// A grey picture that says which pixels count, as Middlebury's mask0nocc.png: both cameras see
    /// white pixels (255), only the left camera grey ones (128), and black ones are left out.
    #[arg(long, value_name = "FILE", conflicts_with = "visible")]
    mask: Option<PathBuf>,
    /// The truth where both cameras see it, as KITTI's disp_noc: only the left camera sees other
    /// pixels that have a truth.
    #[arg(long, value_name = "FILE")]
    visible: Option<PathBuf>,
    /// Write a picture of the map, the truth and the errors beside each other.
    #[arg(long, value_name = "FILE.png")]
    picture: Option<PathBuf>,
}

impl Command for Arguments {
    type Report = Evaluation;

    fn run(&self, context: &Context) -> Result<Evaluation> {
        for (option, scale) in [("--scale", self.scale), ("--map-scale", self.map_scale)] {
            ensure!(
                scale.is_none_or(|scale| scale > 0.0 && scale.is_finite()),
                "{option} {}: what is stored must be divided by a positive, finite number",
                scale.unwrap_or_default()
            );
        }
        let inputs = [&self.map, &self.truth].into_iter();
        let mut files = context.files(inputs.chain(&self.mask).chain(&self.visible))?;
        files.write_if_given("--picture", self.picture.as_ref(), &[Format::Png])?;
        let map = file::read(&self.map, self.map_scale)?;
        let truth = file::read(&self.truth, self.scale)?;
        let mask = self.mask.as_ref().map(Visibility::read_mask).transpose()?;
        let visible = self.visible.as_ref().map(|path| file::read(path, None));
        let visible = visible.transpose()?;
        let visible = visible.as_ref().map(Visibility::from_truth_of_visible);
        let found = Evaluation::new(&map, &truth, mask.or(visible).as_ref());
        let found = found.with_context(|| {
            let [map, truth] = [&self.map, &self.truth].map(|path| path.display());
            format!("{map} and {truth}")
        })?;
        if let Some(path) = &self.picture {
            let sheet = picture::comparison(&map, &truth, &found.errors);
            context.outputs().write(path, &png::encode(&sheet)?)?;
        }
        Ok(found)
    }
}

impl Report for Evaluation {
    fn text(&self) -> String {
        let mut text = lines(&self.all);
        for (name, part) in [("visible", self.visible), ("occluded", self.occluded)] {
            if let Some(part) = part {
                text.push_str(&format!("{name}:\n{}", lines(&part)));
            }
        }
        text
    }
}

fn lines(found: &ErrorMeasures) -> String {
    let average = match found.average_px {
        Some(average) => format!("{average:.3} px"),
        None => "none is known".into(),
    };
    format!(
        "bad 0.5   {:7.3} %\nbad 1     {:7.3} %\nbad 2     {:7.3} %\nbad 3     {:7.3} %\n\
         D1        {:7.3} %\naverage   {average}\ndensity   {:7.3} % of {} pixels with truth\n",
        found.bad_0_5,
        found.bad_1,
        found.bad_2,
        found.bad_3,
        found.d1,
        found.density,
        found.truth_pixels
    )
}
