//! Films that were drawn in parts.

use std::fs::File;
use std::io::{self, BufRead, BufReader, Read};
use std::path::Path;

use anyhow::{Context as _, Result, bail, ensure};
use ga_image::y4m::MAX_LINE;
use serde::Serialize;

pub(super) use crate::commands::render::COMMAND;
use crate::format::Format;
use crate::frame::{Context, Shown};
use crate::part::{FilmPart, Outputs, Parts};

pub(super) const FORMATS: [Format; 1] = [Format::Y4m];

/// What is said of the whole film.
#[derive(Serialize)]
pub(super) struct Joined {
    out: String,
    frames: usize,
    parts: usize,
}

/// Writes the whole film: the first line of each part is the same, and the frames follow it.
pub(super) fn join(parts: &Parts, outputs: &Outputs, context: &Context) -> Result<Shown<Joined>> {
    let Some(out) = outputs.of(Format::Y4m) else {
        bail!("the parts are films: --out FILE.y4m is needed");
    };
    let joined = Joined {
        out: out.display().to_string(),
        frames: parts.frames(),
        parts: parts.paths().len(),
    };
    let text = format!(
        "wrote {}, {} frames of {} parts\n",
        joined.out, joined.frames, joined.parts
    );
    let mut header: Option<Vec<u8>> = None;
    context.outputs().write_with(&out, |whole| {
        for part in parts.contents() {
            let (path, part): (&Path, FilmPart) = part?;
            let film = part.path(path);
            let named = || film.display().to_string();
            let (line, mut frames) = open(&film, part.bytes)?;
            match &header {
                None => {
                    whole
                        .write_all(&line)
                        .with_context(|| out.display().to_string())?;
                    header = Some(line);
                }
                Some(first) => ensure!(
                    *first == line,
                    "{}: its size or rate is another than that of the parts before",
                    named()
                ),
            }
            io::copy(&mut frames, whole).with_context(named)?;
        }
        Ok(())
    })?;
    Ok(Shown::new(joined, text))
}

/// The first line of a film, and its frames.
fn open(path: &Path, bytes: usize) -> Result<(Vec<u8>, impl Read)> {
    let named = || format!("cannot read {}", path.display());
    let file = File::open(path).with_context(named)?;
    let length = file.metadata().with_context(named)?.len();
    ensure!(
        length == bytes as u64,
        "{}: it is not the film that was written with its part: it has {length} bytes and had \
         {bytes}",
        path.display()
    );
    let mut file = BufReader::new(file);
    let mut line = Vec::new();
    let mut first = (&mut file).take(MAX_LINE as u64);
    first.read_until(b'\n', &mut line).with_context(named)?;
    ensure!(
        line.starts_with(b"YUV4MPEG2") && line.ends_with(b"\n"),
        "{}: it is no Y4M film",
        path.display()
    );
    Ok((line, file))
}
