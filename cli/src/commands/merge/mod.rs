//! `nullcone merge`: the parts of a work as a whole.

mod film;

use std::path::PathBuf;

use anyhow::{Error, Result, bail};
use ga_draw::document::Page;
use ga_video::keyframe::Analysed;
use serde::Serialize;

use self::film::Joined;
use super::quality::compare;
use super::video::{comfort, keyframes};
use crate::files::expanded;
use crate::format::Format;
use crate::frame::{self, Command, Context, Kept, Shown, Verdict, Warning};
use crate::part::{Outputs, Parts};

/// Join parts of a work, as commands with --frames make them, to the whole.
///
/// The parts are given in any order, by names and patterns: films (.y4m), beside which lies what
/// they are parts of, or files of --part. What is written is, to the byte, what the command writes
/// that made them, without --frames: a film, or of measures those files for which --out is given,
/// and --json and --report. Parts of other inputs, arguments or versions of the program are
/// refused, and so are frames that two parts have or none.
///
/// For instance
///
///   nullcone quality compare film.y4m small.y4m --frames 0..500 --part 0.json
///   nullcone quality compare film.y4m small.y4m --frames 500.. --part 1.json
///   nullcone merge 0.json 1.json --out frames.csv --json
#[derive(Clone, Debug, clap::Args)]
#[command(verbatim_doc_comment)]
pub(crate) struct Arguments {
    /// The parts: films or files of JSON, also as patterns.
    #[arg(value_name = "PART", required = true)]
    parts: Vec<PathBuf>,
    /// What is written: a film (.y4m) of films; of measures the values of --json, or of comfort
    /// those of --summary (.json), a table (.csv) and a chart (.svg); of key frames also an edit
    /// decision list (.edl), a contact sheet (.png) and a folder of pictures; may be repeated.
    #[arg(long, value_name = "FILE")]
    out: Vec<PathBuf>,
}

/// What the command says that makes the whole.
#[derive(Serialize)]
#[serde(untagged)]
enum Whole {
    Film(Joined),
    Quality(compare::Measures),
    KeyFrames(Analysed),
    /// Lines for each frame, which are printed while they are made.
    Comfort(()),
}

/// The same, and where its values are written.
#[derive(Serialize)]
pub(crate) struct Merged {
    #[serde(flatten)]
    shown: Shown<Whole>,
    #[serde(skip)]
    json: Option<PathBuf>,
}

impl Command for Arguments {
    type Report = Merged;

    fn run(&self, context: &Context) -> Result<Merged> {
        context.need_result(!self.out.is_empty(), "--out")?;
        let paths = expanded("PART", &self.parts)?;
        let parts = Parts::read(&paths)?;
        let about = parts.about()?;
        let inputs = about.inputs.iter().map(|input| PathBuf::from(&input.file));
        // The film of which a file of JSON says what it is a part of.
        let films = paths.iter().map(|path| path.with_extension(""));
        let inputs: Vec<PathBuf> = inputs.chain(films).chain(paths.clone()).collect();
        let mut files = context.files(&inputs)?;
        let has_folder = about.command == keyframes::COMMAND;
        let mut outputs =
            |formats: &[Format]| Outputs::new(&self.out, formats, has_folder, &mut files);
        let (shown, json) = match about.command.as_str() {
            film::COMMAND => {
                let outputs = outputs(&film::FORMATS)?;
                (
                    film::join(&parts, &outputs, context)?.map(Whole::Film),
                    None,
                )
            }
            compare::COMMAND => {
                let outputs = outputs(&compare::FORMATS)?;
                let shown = compare::merged(&parts, &outputs, context)?;
                (shown.map(Whole::Quality), outputs.of(Format::Json))
            }
            keyframes::COMMAND => {
                let outputs = outputs(&keyframes::FORMATS)?;
                let shown = keyframes::merged(&parts, &outputs, context)?;
                (shown.map(Whole::KeyFrames), outputs.of(Format::Json))
            }
            comfort::COMMAND => {
                let outputs = outputs(&comfort::FORMATS)?;
                let shown = comfort::merged(&parts, &outputs, context)?;
                (shown.map(|_| Whole::Comfort(())), None)
            }
            other => bail!("the parts are of `{other}`, which this program does not join"),
        };
        Ok(Merged { shown, json })
    }
}

impl frame::Report for Merged {
    fn text(&self) -> String {
        self.shown.text()
    }

    fn is_printed_as_json(&self) -> bool {
        self.shown.is_printed_as_json()
    }

    fn warnings(&self) -> Option<&[Warning]> {
        frame::Report::warnings(&self.shown)
    }

    fn verdict(&self) -> Option<Verdict> {
        frame::Report::verdict(&self.shown)
    }

    fn next(&self) -> Option<String> {
        frame::Report::next(&self.shown)
    }

    fn page(&self) -> Option<Page> {
        frame::Report::page(&self.shown)
    }

    fn kept(&self) -> Option<Kept> {
        let json = self.json.clone()?;
        Some(Kept {
            page: None,
            json: Some(json),
        })
    }

    fn failure(&mut self) -> Option<Error> {
        frame::Report::failure(&mut self.shown)
    }
}
