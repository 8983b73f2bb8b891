//! The files that a program reads and writes, checked before it computes anything.

use std::path::{Path, PathBuf};

use crate::error::WriteError;
use crate::target::{check, is_same_file, is_stream};

/// What a program reads, and what it is going to write.
///
/// ```
/// use ga_files::{OutputError, Outputs};
///
/// let folder = tempfile::tempdir()?;
/// let [mesh, other] = ["mesh.obj", "other.obj"].map(|name| folder.path().join(name));
/// std::fs::write(&mesh, b"v 0 0 0")?;
/// let mut outputs = Outputs::new(|_| false);
/// outputs.read(&mesh);
/// outputs.write("--out", &other)?;
/// let same = outputs.write("--plot", folder.path().join("./other.obj"));
/// assert!(matches!(same, Err(OutputError::Same { .. })));
/// let lost = outputs.write("--table", &mesh);
/// assert!(matches!(lost, Err(OutputError::Input { .. })));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug)]
pub struct Outputs {
    inputs: Vec<PathBuf>,
    is_part: fn(&Path) -> bool,
    outputs: Vec<Output>,
}

#[derive(Clone, Debug)]
struct Output {
    name: String,
    /// With links and folders resolved as far as they exist.
    place: PathBuf,
}

/// Why a file or a folder cannot be written. `output` is what the program calls it, such as the
/// option that asks for it.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum OutputError {
    /// It is a file that is read.
    #[error("{output} {}: it is the input {}, which would be lost", path.display(), input.display())]
    Input {
        /// The output.
        output: String,
        /// Its path.
        path: PathBuf,
        /// The path of the input.
        input: PathBuf,
    },
    /// It is a folder that is read.
    #[error("{output} {}: it is the folder {} that is read", path.display(), input.display())]
    InputFolder {
        /// The output.
        output: String,
        /// Its path.
        path: PathBuf,
        /// The path of the input.
        input: PathBuf,
    },
    /// Another output has the same path.
    #[error("{output} {}: another output has the same path, that of {other}", path.display())]
    Same {
        /// The output.
        output: String,
        /// Its path.
        path: PathBuf,
        /// The other output.
        other: String,
    },
    /// Several files cannot go to a stream.
    #[error("{output} {}: several files are written, and they need a folder", path.display())]
    NoFolder {
        /// The output.
        output: String,
        /// The path of the stream.
        path: PathBuf,
    },
    /// A file is in the place of the folder, or of one above it.
    #[error("cannot make the folder {}: {} is a file", folder.display(), file.display())]
    FileInPlace {
        /// The folder.
        folder: PathBuf,
        /// The file.
        file: PathBuf,
    },
    /// The file cannot be written.
    #[error(transparent)]
    Write(#[from] WriteError),
}

impl Outputs {
    /// Nothing is read or written yet. Of the files in a folder that is read, `is_part` says
    /// which are read with it.
    #[must_use]
    pub fn new(is_part: fn(&Path) -> bool) -> Self {
        Self {
            inputs: Vec::new(),
            is_part,
            outputs: Vec::new(),
        }
    }

    /// A file or a folder that is read.
    pub fn read(&mut self, input: impl AsRef<Path>) {
        self.inputs.push(input.as_ref().to_path_buf());
    }

    /// A file that is to be written.
    ///
    /// # Errors
    ///
    /// [`OutputError`]: the file is one that is read or another output, or cannot be written.
    pub fn write(&mut self, output: &str, path: impl AsRef<Path>) -> Result<(), OutputError> {
        let path = path.as_ref();
        if let Some(input) = self.inputs.iter().find(|input| self.reads(input, path)) {
            return Err(OutputError::Input {
                output: output.to_owned(),
                path: path.to_path_buf(),
                input: input.clone(),
            });
        }
        check(path)?;
        self.add(output, path)
    }

    /// An output that goes to standard output.
    ///
    /// # Errors
    ///
    /// [`OutputError::Same`] where another one does.
    pub fn write_to_standard_output(&mut self, output: &str) -> Result<(), OutputError> {
        self.add(output, Path::new("-"))
    }

    /// A folder into which files of these names are to be written. `-` is standard output, as any
    /// other stream no folder.
    ///
    /// # Errors
    ///
    /// [`OutputError`]: a file is in the place of the folder, the folder is one that is read, or
    /// what is wrong with one of the files.
    pub fn write_folder<N: AsRef<Path>>(
        &mut self,
        output: &str,
        folder: &Path,
        names: impl IntoIterator<Item = N>,
    ) -> Result<(), OutputError> {
        if folder == Path::new("-") || is_stream(folder) {
            return Err(OutputError::NoFolder {
                output: output.to_owned(),
                path: folder.to_path_buf(),
            });
        }
        let existing = folder.ancestors().find(|path| path.exists());
        if let Some(file) = existing.filter(|path| !path.is_dir()) {
            return Err(OutputError::FileInPlace {
                folder: folder.to_path_buf(),
                file: file.to_path_buf(),
            });
        }
        let is_read = |input: &&PathBuf| input.is_dir() && is_same_file(input, folder);
        if let Some(input) = self.inputs.iter().find(is_read) {
            return Err(OutputError::InputFolder {
                output: output.to_owned(),
                path: folder.to_path_buf(),
                input: input.clone(),
            });
        }
        names
            .into_iter()
            .try_for_each(|name| self.write(output, folder.join(name)))
    }

    /// Whether a file is one of those that are to be written.
    #[must_use]
    pub fn writes(&self, path: impl AsRef<Path>) -> bool {
        let place = resolved(path.as_ref());
        self.outputs.iter().any(|output| output.place == place)
    }

    /// Whether reading an input reads a file: the input itself, or a part of a folder.
    fn reads(&self, input: &Path, file: &Path) -> bool {
        if !input.is_dir() {
            return is_same_file(input, file);
        }
        let folder = file.parent().map(non_empty);
        folder.is_some_and(|folder| is_same_file(input, folder)) && (self.is_part)(file)
    }

    fn add(&mut self, output: &str, path: &Path) -> Result<(), OutputError> {
        let place = resolved(path);
        if let Some(other) = self.outputs.iter().find(|other| other.place == place) {
            return Err(OutputError::Same {
                output: output.to_owned(),
                path: path.to_path_buf(),
                other: other.name.clone(),
            });
        }
        let name = output.to_owned();
        self.outputs.push(Output { name, place });
        Ok(())
    }
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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn parts_of_a_folder_that_is_read_are_inputs() {
        let folder = tempfile::tempdir().unwrap();
        let folder = folder.path();
        for name in ["1.png", "notes.txt"] {
            std::fs::write(folder.join(name), b"").unwrap();
        }
        let is_picture = |path: &Path| path.extension().is_some_and(|ending| ending == "png");
        let mut outputs = Outputs::new(is_picture);
        outputs.read(folder);
        let lost = outputs.write("--out", folder.join("1.png"));
        assert!(matches!(lost, Err(OutputError::Input { .. })));
        outputs.write("--out", folder.join("notes.txt")).unwrap();
        let whole = outputs.write_folder("--views", folder, ["a"]);
        assert!(matches!(whole, Err(OutputError::InputFolder { .. })));
        std::fs::create_dir(folder.join("sub")).unwrap();
        outputs
            .write_folder("--views", &folder.join("sub"), ["a"])
            .unwrap();
        let below = outputs.write_folder("--views", &folder.join("1.png/b"), ["a"]);
        assert!(matches!(below, Err(OutputError::FileInPlace { .. })));
        let stream = outputs.write_folder("--views", Path::new("-"), ["a"]);
        assert!(matches!(stream, Err(OutputError::NoFolder { .. })));
    }

    #[test]
    fn outputs_that_do_not_exist_yet_are_told_apart() {
        let folder = tempfile::tempdir().unwrap();
        let folder = folder.path();
        std::fs::create_dir(folder.join("a")).unwrap();
        let mut outputs = Outputs::new(|_| false);
        outputs.write("--out", folder.join("a/x.png")).unwrap();
        outputs.write("--plot", folder.join("a/y.png")).unwrap();
        assert!(outputs.writes(folder.join("a/./x.png")));
        assert!(!outputs.writes(folder.join("x.png")));
        let same = outputs.write("--csv", folder.join("a/../a/x.png"));
        assert!(matches!(same, Err(OutputError::Same { .. })));
    }

    #[test]
    fn one_output_goes_to_standard_output() {
        let mut outputs = Outputs::new(|_| false);
        outputs.write_to_standard_output("--out").unwrap();
        let second = outputs.write_to_standard_output("--plot").unwrap_err();
        assert_eq!(
            second.to_string(),
            "--plot -: another output has the same path, that of --out"
        );
    }
}
