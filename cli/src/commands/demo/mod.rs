//! `nullcone demo`: the whole way, from a figure to films of it, and back by the pictures alone.

mod algebra;
mod counterparts;
mod disparity;
mod findings;
mod folder;
mod inputs;
mod joints;
mod page;
mod paper;
mod report;
mod run;
mod scores;
mod steps;
mod studio;
mod subject;
mod times;

use std::path::Path;
use std::time::Instant;

use anyhow::Result;
use ga_anim::skeleton::Skeleton;
use nullcone_speed::Speed;
use serde::Serialize;

use crate::frame::{self, Command, Context, Progress, Warning, keep_for_failure};
use crate::output::Staging;
use crate::pipeline::{self, OutputArguments, perform};
use crate::report::Performed;
use algebra::{LEG, LegBothWays, Weights};
use counterparts::counterparts;
use folder::Work;
use inputs::{STILL, Truth};
use page::Contents;
use report::Report;
use run::{Run, found_disparities};
use scores::Scores;
use subject::{Subject, SubjectArguments, TEXTURE_SIZE};
use times::Times;

/// Film a person that walks, and find it again in the films; needs no input.
///
/// A figure is made and walks through a room, where two cameras film it: one is too bright and
/// rolled a little, and both have noise. From the two films and from pictures of a chessboard,
/// other commands of this program find the cameras, depth, a surface, a contour, the joints and the
/// body, key frames, the quality and the comfort of the films, which are then aligned, and the
/// texture of the body. With --motion the figure does not walk, but does what somebody recorded;
/// with --character it is one of yours, whose dots are discs on its skin. Joints are found by the
/// dots of their bones: where films show none, as of thin fingers, joints are far off.
///
/// Writes report.html (a page with all of it, the command of each step, and the numbers of the
/// paper beside those found here), report.json, times.js (measured times, which the page shows
/// where it lies beside it), model.obj (the figure at rest) with model.mtl and skin.png, model.glb
/// (with skeleton, skin weights and the motion), sheet.png (key frames, of the walk those of a
/// stride, with three in-betweens after each), and what the steps write: film/, boards/, stills/,
/// rig.yml, views.json, rectified/, disparity.pfm, surface.glb, contour.obj, joints.json, person/,
/// keys/, aligned.y4m and more. A --character has no skin.png and no model.mtl. truth/ is what the
/// pictures were made of, for the scores. Equal seeds give equal bytes, but for times.js. Lengths
/// are metres, y points up. The commands on the page run in the folder of the results. --json
/// prints what report.json holds, with the paths of the figure's files as "written" and the time
/// that it took as "seconds".
#[derive(Clone, Debug, clap::Args)]
pub(crate) struct Arguments {
    #[command(flatten)]
    subject: SubjectArguments,
    #[command(flatten)]
    output: OutputArguments,
    /// Make the figure and its motion alone: model.obj, model.mtl, skin.png, model.glb, sheet.png
    /// and report.json.
    #[arg(long)]
    figure: bool,
}

/// Shares of the time before the steps, in hundredths.
const FIGURE: u64 = 5;
const FILMS: u64 = 25;

impl Command for Arguments {
    type Report = Demonstrated;

    fn run(&self, context: &Context) -> Result<Demonstrated> {
        let begin = Instant::now();
        self.output.check(context.files(self.subject.inputs())?)?;
        let subject = self.subject.read()?;
        if self.figure {
            let Subject {
                performance,
                warnings,
                ..
            } = subject;
            let progress = context.progress(pipeline::STEPS);
            let mut performed = perform(
                performance,
                &self.output,
                context.outputs(),
                &progress,
                begin,
            )?;
            performed.warnings.splice(0..0, warnings);
            return Ok(Demonstrated::Figure(performed.into()));
        }
        let steps: u64 = steps::STEPS.iter().map(|step| step.share).sum();
        let progress = Progress::of_parts(FIGURE + FILMS + steps, context.is_quiet());
        let outputs = self.output.in_folder(Path::new(""));
        let work = Work::enter(self.output.folder())?;
        let mut report = demonstrate(subject, &outputs, context, &progress)?;
        drop(progress);
        report.files = work.publish(context.outputs(), self.output.film())?;
        report.seconds = begin.elapsed().as_secs_f64();
        Ok(Demonstrated::All(report.into()))
    }
}

/// What was made.
#[derive(Serialize)]
#[serde(untagged)]
pub(crate) enum Demonstrated {
    Figure(Box<Performed>),
    All(Box<Report>),
}

impl frame::Report for Demonstrated {
    fn text(&self) -> String {
        match self {
            Self::Figure(report) => report.text(),
            Self::All(report) => report.text(),
        }
    }

    fn warnings(&self) -> Option<&[Warning]> {
        match self {
            Self::Figure(report) => report.warnings(),
            Self::All(report) => report.warnings(),
        }
    }
}

/// Makes everything in the current folder.
fn demonstrate(
    subject: Subject,
    outputs: &OutputArguments,
    context: &Context,
    progress: &Progress,
) -> Result<Report> {
    let seed = outputs.seed();
    let mut times = Times::default();
    progress.part("Making a figure", FIGURE);
    let (dotted, no_room) = subject.dotted()?.into_figure(TEXTURE_SIZE)?;
    let model = subject.model();
    let Subject {
        performance,
        clip,
        warnings,
        ..
    } = subject;
    let figure = performance.figure.clone();
    progress.part("Filming it", FILMS);
    let (performed, truth) = rayon::join(
        || {
            let files = Staging::default();
            let progress = Progress::new(0, true);
            let performed = perform(performance, outputs, &files, &progress, Instant::now())?;
            files.finish()?;
            anyhow::Ok(performed)
        },
        || inputs::make(&dotted, &clip, seed),
    );
    let (mut performed, truth) = (performed?, truth?);
    performed
        .warnings
        .splice(0..0, warnings.into_iter().chain(no_room));
    let run = Run::new(&truth, model, context, progress, &mut times);
    // The commands of the steps have forgotten the warnings of what was before.
    keep_for_failure(&performed.warnings);
    let run = run?;

    let scores = Scores::new(&run, &truth)?;
    let leg = leg(&figure.character.skeleton, &truth)?;
    let rectified = run::rectified(&run.rig)?;
    let levels = algebra::levels(&found_disparities()?, &rectified)?;
    let weights = Weights::new(&figure.character)?;
    let page = page::page(&Contents {
        figure: &figure,
        clip: &clip,
        run: &run,
        scores: &scores,
        leg: leg.as_ref(),
        levels: &levels,
        weights: &weights,
    })?;
    ga_files::write("report.html", page.into_html().as_bytes())?;
    ga_files::write(times::FILE, times.script(Speed::measure())?.as_bytes())?;
    let report = Report::new(performed, &run, scores, leg, levels, weights);
    report.write()?;
    Ok(report)
}

/// The left leg in the still, as the films show it; `None` where it is not known which joints it
/// has.
fn leg(skeleton: &Skeleton, truth: &Truth) -> Result<Option<LegBothWays>> {
    let Some(joints) = counterparts(skeleton, LEG) else {
        return Ok(None);
    };
    let table = joints::Table::read(Path::new("person/joints.csv"), &truth.names)?;
    let places = table.frame(STILL)?;
    LegBothWays::new(joints.map(|joint| places[joint])).map(Some)
}
