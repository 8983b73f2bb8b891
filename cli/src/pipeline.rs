//! From a figure and its motion to the files, the same for every command.

use std::path::{Path, PathBuf};
use std::time::Instant;

use anyhow::{Context, Result};
use ga_anim::gltf::meshes_without_joint;
use ga_anim::retarget::Checks;
use ga_character::report::{AnimationReport, FigureReport};
use ga_character::{Animation, Figure, Overlay, TwoViews, model, pictures};
use ga_image::film::Rate;

use crate::files::Files;
use crate::film_file::{self, Film};
use crate::format::Format;
use crate::frame::{Progress, Warning};
use crate::mesh_file::missing_parts;
use crate::motion_file::lost;
use crate::output::Staging;
use crate::report::{Input, Performed, Report, Tool, Written};

/// How many steps [`perform`] reports as progress.
pub(crate) const STEPS: u64 = 5;

/// The name of the file that holds the report.
pub(crate) const REPORT: &str = "report.json";

/// The name of the film in another folder than that where it will be, without its ending.
pub(crate) const FILM: &str = "film-of-the-figure";

/// Where the files are written, what is drawn over the pictures, and the seed of the random
/// numbers.
#[derive(Clone, Debug, clap::Args)]
pub(crate) struct OutputArguments {
    /// The folder that the files are written to; it is created where it is missing.
    #[arg(long, value_name = "DIR", default_value = "out")]
    out: PathBuf,
    /// The seed of the noise in the pictures of the two cameras.
    #[arg(long, value_name = "N", default_value_t = 1)]
    seed: u64,
    /// Draw the bones over the skin.
    #[arg(long)]
    bones: bool,
    /// Draw the paths of these joints during the last second over the picture; `all` for every
    /// joint.
    ///
    /// Example: --trails LeftHand,RightFoot
    #[arg(long, value_name = "JOINT,…", value_delimiter = ',')]
    trails: Vec<String>,
    /// Also write the motion as a film: an animated PNG if its name ends in .png, without
    /// compression if it ends in .y4m, or as H.264 if it ends in .mp4, where the program was built
    /// with the feature `mp4`.
    #[arg(long, value_name = "FILE.png|FILE.y4m|FILE.mp4")]
    film: Option<PathBuf>,
}

impl OutputArguments {
    /// The folder of the files.
    pub(crate) fn folder(&self) -> &Path {
        &self.out
    }

    /// The seed of all random numbers.
    pub(crate) fn seed(&self) -> u64 {
        self.seed
    }

    /// The film that is asked for.
    pub(crate) fn film(&self) -> Option<&Path> {
        self.film.as_deref()
    }

    /// The same with the files of the folder, and the film, in another one.
    pub(crate) fn in_folder(&self, folder: &Path) -> Self {
        let film = self.film.as_ref().map(|film| {
            let format = Format::of(film, &film_file::FORMATS).unwrap_or(Format::Png);
            folder.join(FILM).with_extension(format.endings()[0])
        });
        Self {
            out: folder.to_path_buf(),
            film,
            ..self.clone()
        }
    }

    /// Fails early where the files could not be written in the end, or would replace one of those
    /// that are read.
    pub(crate) fn check(&self, mut files: Files) -> Result<()> {
        let names = model::NAMES.iter().chain(&[pictures::SHEET, REPORT]);
        files.write_folder("--out", &self.out, names)?;
        if let Some(film) = &self.film {
            film_file::format(&mut files, "--film", film)?;
        }
        Ok(())
    }

    /// The path of the model with its motion.
    fn model(&self) -> PathBuf {
        self.out.join(model::GLB)
    }

    fn overlay<'a>(&self, figure: &'a Figure, animation: &'a Animation) -> Result<Overlay<'a>> {
        let mut joints = Vec::new();
        for name in &self.trails {
            let named = figure.joints_named(name);
            joints.extend(named.with_context(|| format!("--trails {name}"))?);
        }
        Ok(Overlay {
            character: &figure.character,
            clip: &animation.clip,
            bones: self.bones,
            joints,
        })
    }
}

/// A figure with its motion, and where both come from.
pub(crate) struct Performance {
    pub(crate) command: &'static str,
    pub(crate) input: Input,
    pub(crate) figure: Figure,
    pub(crate) animation: Animation,
    pub(crate) checks: Option<Checks>,
}

/// Computes everything, then writes everything.
pub(crate) fn perform(
    performance: Performance,
    arguments: &OutputArguments,
    outputs: &Staging,
    progress: &Progress,
    begin: Instant,
) -> Result<Performed> {
    let Performance {
        command,
        input,
        figure,
        animation,
        checks,
    } = performance;
    let overlay = arguments.overlay(&figure, &animation)?;
    progress.step("measuring the motion");
    let measured = AnimationReport::new(&figure, &animation);
    let measured = measured.context("the motion cannot be measured")?;
    progress.step("looking from two sides");
    let two_views = TwoViews::new(&figure.character, &animation.clip, arguments.seed)
        .context("two cameras cannot see the motion")?;
    progress.step("drawing the contact sheet");
    let (sheet, left_out) = pictures::sheet(&figure, &animation, &overlay)?;
    let file = figure.file.as_ref();
    let mut warnings = file.map_or(Vec::new(), |file| missing_parts(file, left_out));
    let mut written = Vec::new();
    if let Some(path) = &arguments.film {
        progress.step("drawing the film");
        let Animation { clip, .. } = &animation;
        let film = Film {
            path,
            format: Format::of(path, &film_file::FORMATS).unwrap_or(Format::Png),
            size: pictures::FILM_SIZE,
            frames: clip.frames().len(),
            rate: Rate::new(clip.frame_time().recip()).unwrap_or(Rate::HIGHEST),
        };
        let bytes = film.write(outputs, |show| {
            pictures::film(&figure, &animation, &overlay, |number, picture| {
                progress.at(number as u64 + 1, film.frames as u64);
                show(picture)
            })
        })?;
        written.push(Written {
            file: path.display().to_string(),
            bytes,
        });
    }
    progress.step("making the model");
    let figure = figure.relocated(&arguments.model())?;
    let (mut files, losses) = model::files(&figure, &animation.clip, &animation.name)?;
    let losses = losses.iter().map(|loss| lost(loss, &arguments.model()));
    warnings.extend(losses);
    files.insert(2, sheet);

    let report = Report {
        tool: Tool::NULLCONE,
        command,
        input,
        figure: FigureReport::new(&figure),
        animation: measured,
        checks,
        two_views,
        files,
    };
    let mut text =
        serde_json::to_string_pretty(&report).context("the report cannot be written as JSON")?;
    text.push('\n');
    progress.step("writing");
    let files = report.files.iter();
    let files = files.map(|file| (arguments.out.join(file.name), file.contents.as_slice()));
    let contents = files.chain([(arguments.out.join(REPORT), text.as_bytes())]);
    let mut others = Vec::new();
    for (path, contents) in contents {
        outputs.write(&path, contents)?;
        others.push(Written {
            file: path.display().to_string(),
            bytes: contents.len(),
        });
    }
    written.splice(0..0, others);
    Ok(Performed {
        report,
        written,
        seconds: begin.elapsed().as_secs_f64(),
        warnings,
    })
}

/// What of a document is not in the mesh of its character, and so not in model.obj.
pub(crate) fn not_in_obj(figure: &Figure, file: Option<&Path>) -> Result<Vec<Warning>> {
    let Some(document) = &figure.document else {
        return Ok(Vec::new());
    };
    let still = meshes_without_joint(document)?;
    let targets = document.meshes.iter().flat_map(|mesh| {
        let primitives = mesh.primitives.iter();
        primitives.map(|primitive| primitive.targets.len()).max()
    });
    let losses = [
        ("materials", document.materials.len()),
        ("morph targets", targets.sum()),
        ("meshes that no joint moves", still),
    ];
    let losses = losses.into_iter().filter(|(_, count)| *count > 0);
    let warnings = losses.map(|(what, count)| {
        let message = format!("{what} ({count}) are in model.glb and pictures, not in model.obj");
        let warning = Warning::new("omission", message);
        let warning = match file {
            Some(path) => warning.in_file(path),
            None => warning,
        };
        Warning {
            what: Some(what),
            count: Some(count),
            ..warning
        }
    });
    Ok(warnings.collect())
}
