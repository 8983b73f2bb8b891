//! The files that a command reads and writes, checked before it computes anything.

use std::path::{Path, PathBuf};

use anyhow::{Context, Result, anyhow, bail};
use ga_camera::format::json::VIEWS;
use ga_files::Outputs;

use crate::format::{self, Format};
use crate::standard_output::{self, is_dash, is_standard_output};

/// The files that the arguments of an option stand for: names, or patterns where no file has that
/// name.
pub(crate) fn expanded<P: AsRef<Path>>(option: &str, arguments: &[P]) -> Result<Vec<PathBuf>> {
    ga_files::expand(arguments).map_err(|error| anyhow!("{option} {error}"))
}

/// What a command reads, and what it is going to write.
#[derive(Debug)]
pub(crate) struct Files {
    outputs: Outputs,
    /// The option that prints to standard output, where it is given.
    printing: Option<&'static str>,
}

impl Files {
    /// The files that a command reads. Folders are those of videos as numbered pictures, or of
    /// views with their cameras; `-` is standard input.
    pub(crate) fn reading<P: AsRef<Path>>(inputs: impl IntoIterator<Item = P>) -> Self {
        let files = Self {
            outputs: Outputs::new(is_part),
            printing: None,
        };
        files.and_reading(inputs)
    }

    pub(crate) fn and_reading<P: AsRef<Path>>(
        mut self,
        inputs: impl IntoIterator<Item = P>,
    ) -> Self {
        let inputs = inputs.into_iter().filter(|path| !is_dash(path.as_ref()));
        inputs.for_each(|path| self.outputs.read(path));
        self
    }

    /// Whether an option prints more than what was done to standard output.
    pub(crate) fn printing(mut self, option: &'static str, is_given: bool) -> Self {
        if is_given {
            self.printing = Some(option);
        }
        self
    }

    /// The format of a file that is to be written: the one of `formats` that its name says, or the
    /// first for standard output, which is `-`, and for devices and pipes.
    ///
    /// # Errors
    ///
    /// The name has another ending; the file is one that is read or another output, cannot be
    /// written, or goes to standard output together with something else.
    pub(crate) fn write(
        &mut self,
        option: &str,
        path: &Path,
        formats: &[Format],
    ) -> Result<Format> {
        let shown = path.display();
        if is_standard_output(path) {
            if let Some(printing) = self.printing {
                bail!("{option} {shown}: {printing} prints to standard output too");
            }
            self.outputs.write_to_standard_output(option)?;
            standard_output::take();
        } else if !ga_files::is_stream(path) {
            let Some(format) = Format::of(path, formats) else {
                let endings = format::endings(formats);
                bail!("{option} {shown}: its name must end in {endings}");
            };
            self.outputs.write(option, path)?;
            return Ok(format);
        }
        let default = formats.first().copied();
        default.with_context(|| format!("{option} {shown}: no format is known"))
    }

    /// As [`write`](Self::write), for a file that may be asked for.
    pub(crate) fn write_if_given(
        &mut self,
        option: &str,
        path: Option<&PathBuf>,
        formats: &[Format],
    ) -> Result<Option<Format>> {
        path.map(|path| self.write(option, path, formats))
            .transpose()
    }

    /// Whether a file is one of those that are to be written.
    pub(crate) fn writes(&self, path: &Path) -> bool {
        self.outputs.writes(path)
    }

    /// A folder into which files of these names are to be written.
    pub(crate) fn write_folder<N: AsRef<Path>>(
        &mut self,
        option: &str,
        folder: &Path,
        names: impl IntoIterator<Item = N>,
    ) -> Result<()> {
        Ok(self.outputs.write_folder(option, folder, names)?)
    }
}

/// Whether a file of a folder that is read is read with it: the cameras of views, and what begins
/// as a picture does.
fn is_part(file: &Path) -> bool {
    let is_picture = matches!(ga_image::file::detect(file), Ok(Some(_)));
    is_picture || file.file_name().is_some_and(|name| name == VIEWS)
}
