//! The files that a command reads and writes, checked before it computes anything.

use std::path::{Path, PathBuf};

use anyhow::{Context, Result, bail, ensure};
use ga_camera::format::json::VIEWS;

use crate::format::{self, Format};
use crate::standard_output::{self, is_dash, is_standard_output};

/// What a command reads, and what it is going to write.
#[derive(Debug, Default)]
pub(crate) struct Files {
    inputs: Vec<PathBuf>,
    outputs: Vec<Output>,
    /// The option that prints to standard output, where it is given.
    printing: Option<&'static str>,
}

#[derive(Debug)]
struct Output {
    option: String,
    /// With links and folders resolved as far as they exist.
    place: PathBuf,
}

impl Files {
    /// The files that a command reads. Folders are those of videos as numbered pictures; `-` is
    /// standard input.
    pub(crate) fn reading<P: AsRef<Path>>(inputs: impl IntoIterator<Item = P>) -> Self {
        Self::default().and_reading(inputs)
    }

    pub(crate) fn and_reading<P: AsRef<Path>>(
        mut self,
        inputs: impl IntoIterator<Item = P>,
    ) -> Self {
        let inputs = inputs.into_iter().map(|path| path.as_ref().to_path_buf());
        self.inputs.extend(inputs.filter(|path| !is_dash(path)));
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
            self.add(option, Path::new("-"))?;
            standard_output::take();
        } else if !ga_files::is_stream(path) {
            let Some(format) = Format::of(path, formats) else {
                let endings = format::endings(formats);
                bail!("{option} {shown}: its name must end in {endings}");
            };
            self.check(option, path)?;
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

    /// A folder into which files of these names are to be written.
    ///
    /// # Errors
    ///
    /// A file is in the place of the folder, or what is wrong with one of the files.
    pub(crate) fn write_folder<N: AsRef<Path>>(
        &mut self,
        option: &str,
        folder: &Path,
        names: impl IntoIterator<Item = N>,
    ) -> Result<()> {
        let shown = folder.display();
        ensure!(
            !is_standard_output(folder) && !ga_files::is_stream(folder),
            "{option} {shown}: several files are written, and they need a folder"
        );
        if let Some(existing) = folder.ancestors().find(|path| path.exists()) {
            ensure!(
                existing.is_dir(),
                "cannot make the folder {shown}: {} is a file",
                existing.display()
            );
        }
        for input in &self.inputs {
            ensure!(
                !(input.is_dir() && ga_files::is_same_file(input, folder)),
                "{option} {shown}: it is the folder {} that is read",
                input.display()
            );
        }
        names
            .into_iter()
            .try_for_each(|name| self.check(option, &folder.join(name)))
    }

    /// Fails where a file would replace one that is read or is another output, or cannot be
    /// written.
    fn check(&mut self, option: &str, path: &Path) -> Result<()> {
        for input in &self.inputs {
            ensure!(
                !reads(input, path),
                "{option} {}: it is the input {}, which would be lost",
                path.display(),
                input.display()
            );
        }
        ga_files::check(path)?;
        self.add(option, path)
    }

    fn add(&mut self, option: &str, path: &Path) -> Result<()> {
        let place = resolved(path);
        if let Some(other) = self.outputs.iter().find(|other| other.place == place) {
            bail!(
                "{option} {}: another output has the same path, that of {}",
                path.display(),
                other.option
            );
        }
        let option = option.to_owned();
        self.outputs.push(Output { option, place });
        Ok(())
    }
}

/// Whether reading an input reads a file: the input itself, a picture of a video in a folder, or
/// the cameras of a folder of views.
fn reads(input: &Path, file: &Path) -> bool {
    if !input.is_dir() {
        return ga_files::is_same_file(input, file);
    }
    let is_inside = file
        .parent()
        .is_some_and(|folder| ga_files::is_same_file(input, non_empty(folder)));
    let is_cameras = file.file_name().is_some_and(|name| name == VIEWS);
    is_inside && (is_cameras || matches!(ga_image::file::detect(file), Ok(Some(_))))
}

fn non_empty(folder: &Path) -> &Path {
    if folder.as_os_str().is_empty() {
        Path::new(".")
    } else {
        folder
    }
}

/// A path with everything resolved that exists.
fn resolved(path: &Path) -> PathBuf {
    if let Ok(path) = path.canonicalize() {
        return path;
    }
    match (path.parent(), path.file_name()) {
        (Some(folder), Some(name)) => resolved(non_empty(folder)).join(name),
        _ => path.to_path_buf(),
    }
}
