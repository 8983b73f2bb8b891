//! Stereoscopic video without the defects that were measured in it.

use std::collections::VecDeque;
use std::io::{BufWriter, Write};
use std::path::{Path, PathBuf};

use anyhow::{Context, Result, ensure};
use ga_image::plane::Plane;
use ga_image::y4m::{self, Film};
use ga_vision::comfort::Viewing;
use ga_vision::comfort::align::Aligner;
use ga_vision::comfort::monitor::{Options, analyse};
use ga_vision::comfort::stereoscopy::Stereoscopy;
use ga_vision::video::Frame;
use ga_vision::video::stereo::{Layout, StereoSource};

use super::{LayoutName, input};
use crate::output;
use crate::progress::Progress;

/// Remove differences between the views of stereoscopic video that they should not have.
///
/// What `nullcone video comfort` measures is applied backwards: views that are exchanged, the delay
/// of one eye in whole frames, vertical shift, rotation and size of the right view, its brightness
/// and its colours. Parallax and sharpness stay as they are. The video is read twice; the result
/// has 8 bits and both views in each frame, one above the other if the video has them so, else side
/// by side.
///
/// For instance
///
///   nullcone video align film.y4m --out aligned.y4m
///   nullcone video comfort aligned.y4m --layout side-by-side
#[derive(Clone, Debug, clap::Args)]
#[command(verbatim_doc_comment)]
pub(in crate::commands::video) struct Arguments {
    /// The video of both views, or of the left one.
    #[arg(value_name = "IN")]
    video: PathBuf,
    /// The video of the right view.
    #[arg(value_name = "RIGHT")]
    right: Option<PathBuf>,
    /// Where the views lie; side-by-side if nothing is said, two-files if RIGHT is given.
    #[arg(long, value_enum)]
    layout: Option<LayoutName>,
    /// The video to be written.
    #[arg(long, value_name = "OUT.y4m")]
    out: PathBuf,
}

/// What is known of a video after it was read once.
struct Plan {
    /// Whether the views of each frame are exchanged.
    exchanged: Vec<bool>,
    /// By how many frames the right view is late.
    delay: i64,
}

pub(in crate::commands::video) fn run(arguments: &Arguments, quiet: bool) -> Result<()> {
    ensure!(
        arguments
            .out
            .extension()
            .is_some_and(|ending| ending == "y4m"),
        "--out {}: its name must end in .y4m",
        arguments.out.display()
    );
    let right = arguments.right.as_deref();
    let is_stream = |path: &Path| path.as_os_str() == "-";
    ensure!(
        !is_stream(&arguments.video) && !right.is_some_and(is_stream),
        "the video is read twice, which standard input does not allow: write it to a file first"
    );
    let name = match (arguments.layout, right) {
        (None, None) => Some(LayoutName::SideBySide),
        (name, _) => name,
    };
    let layout = input::layout(name, right)?;
    let open = || input::open(&arguments.video, right, layout);
    let progress = Progress::new(2, quiet);
    progress.step("analysing");
    let plan = Plan::of(&mut open()?, input::halves(layout))?;
    progress.step("aligning");
    let mut source = open()?;
    let folder = match arguments.out.parent() {
        Some(folder) if !folder.as_os_str().is_empty() => folder,
        _ => Path::new("."),
    };
    let cannot = || format!("cannot write {}", arguments.out.display());
    let mut file = tempfile::NamedTempFile::new_in(folder).with_context(cannot)?;
    let written = {
        let mut writer = BufWriter::new(file.as_file_mut());
        let written = plan.write(&mut source, input::halves(layout), &mut writer)?;
        writer.flush().with_context(cannot)?;
        written
    };
    file.persist(&arguments.out).with_context(cannot)?;
    drop(progress);
    if !quiet {
        let exchanged = plan
            .exchanged
            .iter()
            .filter(|exchanged| **exchanged)
            .count();
        output::print(&format!(
            "{}: {written} frames; views exchanged in {exchanged}; delay of {} frames removed\n",
            arguments.out.display(),
            plan.delay
        ))?;
    }
    Ok(())
}

impl Plan {
    fn of(source: &mut StereoSource, layout: Option<Layout>) -> Result<Self> {
        let options = Options {
            viewing: Viewing::default(),
            layout,
            threads: 2,
        };
        let (mut exchanged, mut delays) = (Vec::new(), Vec::new());
        analyse(source, options, |record| {
            exchanged.push(record.stereoscopy == Stereoscopy::Exchanged);
            delays.extend(record.asynchrony.delay().map(|delay| delay.frames));
        })?;
        delays.sort_unstable_by(f64::total_cmp);
        let delay = delays.get(delays.len() / 2).copied().unwrap_or(0.0);
        Ok(Self {
            exchanged,
            delay: delay.round() as i64,
        })
    }

    /// Writes the frames, and returns how many.
    fn write(
        &self,
        source: &mut StereoSource,
        layout: Option<Layout>,
        writer: &mut impl Write,
    ) -> Result<usize> {
        let properties = *source.properties();
        let film = Film {
            frames_per_second: properties.frames_per_second.unwrap_or([25, 1]),
            sampling: properties.sampling,
            colours: properties.colours,
        };
        let mut aligner = Aligner::new(properties.size, properties.colours);
        // Views that wait for the frame of the other eye.
        let mut waiting: [VecDeque<Frame>; 2] = Default::default();
        let mut skip = [(-self.delay).max(0), self.delay.max(0)];
        let (mut views, mut read, mut written) = (<[Frame; 2]>::default(), 0, 0);
        while source.read(&mut views)? {
            if self.exchanged.get(read).copied().unwrap_or(false) {
                views.swap(0, 1);
            }
            read += 1;
            for (eye, queue) in waiting.iter_mut().enumerate() {
                match skip[eye] {
                    0 => queue.push_back(views[eye].clone()),
                    _ => skip[eye] -= 1,
                }
            }
            let [lefts, rights] = &mut waiting;
            if let (Some(left), Some(right)) = (lefts.front(), rights.front()) {
                let aligned = aligner.align(left, right)?;
                let whole = joined(&left.to_rgb(properties.colours), &aligned, layout);
                write_frame(writer, &whole, film, written == 0)?;
                written += 1;
                lefts.pop_front();
                rights.pop_front();
            }
        }
        ensure!(written > 0, "the video is shorter than the delay");
        Ok(written)
    }
}

/// Both views as one picture.
fn joined(left: &Plane<[u8; 3]>, right: &Plane<[u8; 3]>, layout: Option<Layout>) -> Plane<[u8; 3]> {
    let (width, height) = (left.width(), left.height());
    match layout {
        Some(Layout::TopBottom) => Plane::from_fn(width, 2 * height, |column, row| {
            let view = if row < height { left } else { right };
            view.row(row % height)[column]
        }),
        Some(Layout::SideBySide) | None => Plane::from_fn(2 * width, height, |column, row| {
            let view = if column < width { left } else { right };
            view.row(row)[column % width]
        }),
    }
}

/// Writes one frame, and the header of the file before the first one.
fn write_frame(
    writer: &mut impl Write,
    picture: &Plane<[u8; 3]>,
    film: Film,
    is_first: bool,
) -> Result<()> {
    let bytes = y4m::encode([picture], film)?;
    let header = bytes.iter().position(|byte| *byte == b'\n');
    let start = match is_first {
        true => 0,
        false => header.map_or(0, |end| end + 1),
    };
    writer.write_all(&bytes[start..])?;
    Ok(())
}
