//! Atomic writing: the bytes go to a temporary file beside the target, which takes the target's
//! name once it is complete. A failed write leaves the folder as it was.
//!
//! What is not a file, or a file that has to stay the one it is, gets its contents once they are
//! complete.

use std::collections::HashMap;
use std::fs::{File, OpenOptions};
use std::io::{self, Read, Seek, Write};
use std::path::{Path, PathBuf};

use tempfile::SpooledTempFile;

use crate::error::WriteError;
use crate::target::Target;
use crate::temporary::{CreatedFolders, Temporary, leftovers};

/// Writes `contents` to `path`, in place of any file there, and creates missing parent folders.
/// Another process sees either the earlier file or the complete new one.
///
/// A symbolic link is followed. An earlier file keeps its mode and its owner; where it has several
/// names, or its folder or owner do not allow a replacement, it is overwritten once the contents
/// are complete. Devices and pipes are written to.
///
/// # Errors
///
/// [`WriteError`] when a folder or the file cannot be created, the disk is full, an earlier file is
/// read-only, or `path` is a folder. The temporary file and folders that were created are then
/// removed, and an earlier file at `path` is unchanged.
///
/// # Examples
///
/// ```
/// let folder = tempfile::tempdir()?;
/// let path = folder.path().join("out/model.glb");
/// ga_files::write(&path, b"glTF")?;
/// assert_eq!(std::fs::read(&path)?, b"glTF");
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn write(path: impl AsRef<Path>, contents: &[u8]) -> Result<(), WriteError> {
    write_together([(path, contents)])
}

/// Writes files of any folders, each a path and its contents, in place of any there, and creates
/// missing parent folders. All of them are complete beside their places before the first takes its
/// name, so that where one cannot be completed, all earlier files stay as they were, and folders
/// that were created are removed.
///
/// # Errors
///
/// [`WriteError`] with the file that cannot be written. A folder in the place of a file, and two
/// files of one path with different contents, are found before any file takes its name.
///
/// # Examples
///
/// ```
/// let folder = tempfile::tempdir()?;
/// let [table, plot] = ["table.csv", "plots/plot.svg"].map(|name| folder.path().join(name));
/// ga_files::write_together([(&table, &b"t,x\n"[..]), (&plot, b"<svg/>")])?;
/// assert_eq!(std::fs::read(&plot)?, b"<svg/>");
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn write_together<'a, P: AsRef<Path> + 'a>(
    files: impl IntoIterator<Item = (P, &'a [u8])>,
) -> Result<(), WriteError> {
    let mut staged = Staged::default();
    for (path, contents) in files {
        staged.add(path, contents)?;
    }
    staged.finish()
}

/// Where contents are written: also at places before the end.
pub trait WriteSeek: Write + Seek {}

impl<T: Write + Seek> WriteSeek for T {}

/// Files that are written one after the other, of which none takes its name before all are
/// complete: as [`write_together`], for files that are not in memory at the same time.
///
/// Where it is dropped without [`finish`](Self::finish), all earlier files stay as they were, and
/// folders that were created are removed.
///
/// ```
/// let folder = tempfile::tempdir()?;
/// let mut files = ga_files::Staged::default();
/// for number in 0..3 {
///     files.add(folder.path().join(format!("frames/{number}.txt")), b"contents")?;
/// }
/// assert!(!folder.path().join("frames/0.txt").exists());
/// files.finish()?;
/// assert!(folder.path().join("frames/0.txt").exists());
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug, Default)]
pub struct Staged {
    ready: Vec<Ready>,
    /// By the path with its folder resolved, however it was written.
    numbers: HashMap<PathBuf, usize>,
    // Dropped after the files, so that folders are empty.
    created: CreatedFolders,
}

/// Contents that are complete, and where they go.
#[derive(Debug)]
struct Ready {
    path: PathBuf,
    contents: Contents,
}

/// Contents, by how they get to their place.
#[derive(Debug)]
enum Contents {
    /// Beside its place.
    Replacement {
        place: PathBuf,
        file: Temporary,
    },
    /// For a file that stays the one it is.
    InPlace {
        place: PathBuf,
        kept: SpooledTempFile,
    },
    /// For what is not a file.
    Stream {
        kept: SpooledTempFile,
    },
    StandardOutput {
        kept: SpooledTempFile,
    },
}

/// Contents of more bytes than this that have no place beside their target are kept on disk.
const MOST_IN_MEMORY: usize = 1 << 24;

impl Staged {
    /// Writes a file beside its place, and creates missing parent folders.
    ///
    /// # Errors
    ///
    /// [`WriteError`] with the path: a file that cannot be written, a folder in its place, and a
    /// path that was added with other contents.
    pub fn add(&mut self, path: impl AsRef<Path>, contents: &[u8]) -> Result<(), WriteError> {
        let path = path.as_ref();
        self.add_with(path, |file| {
            file.write_all(contents)
                .map_err(|error| failed(path, error))
        })
    }

    /// As [`add`](Self::add), for contents that are not in memory at once: a function writes them.
    ///
    /// # Errors
    ///
    /// As [`add`](Self::add), and those of the function.
    pub fn add_with<E: From<WriteError>>(
        &mut self,
        path: impl AsRef<Path>,
        write: impl FnOnce(&mut dyn WriteSeek) -> Result<(), E>,
    ) -> Result<(), E> {
        let path = path.as_ref();
        let io = |error| failed(path, error);
        let contents = match Target::of(path).map_err(io)? {
            Target::StandardOutput => {
                return self.add_to_standard_output(path, write);
            }
            Target::Stream => Contents::Stream {
                kept: kept(write, path)?,
            },
            Target::InPlace(place) => Contents::InPlace {
                place,
                kept: kept(write, path)?,
            },
            Target::Replace {
                path: place,
                earlier,
            } => {
                let place = self.with_folder(&place).map_err(io)?;
                let folder = folder_of(&place);
                match (Temporary::new(folder, earlier.as_ref()), earlier) {
                    (Ok((temporary, mut file)), _) => {
                        write(&mut file)?;
                        // Without this a power cut after the rename can leave the new name on an
                        // empty file.
                        file.sync_all().map_err(io)?;
                        // The file is closed, since many may wait for their names.
                        Contents::Replacement {
                            place,
                            file: temporary,
                        }
                    }
                    (Err(error), Some(_)) if error.kind() == io::ErrorKind::PermissionDenied => {
                        let kept = kept(write, path)?;
                        Contents::InPlace { place, kept }
                    }
                    (Err(error), _) => return Err(io(error).into()),
                }
            }
        };
        Ok(self.push(path, contents).map_err(io)?)
    }

    /// Adds a file that is complete elsewhere, and is moved to its place, or copied where it has to
    /// take the place of another file or lies on another file system.
    ///
    /// # Errors
    ///
    /// As [`add`](Self::add), and where the file cannot be read.
    pub fn add_file(
        &mut self,
        path: impl AsRef<Path>,
        from: impl AsRef<Path>,
    ) -> Result<(), WriteError> {
        let (path, from) = (path.as_ref(), from.as_ref());
        let io = |error| failed(path, error);
        if let Target::Replace {
            path: place,
            earlier: None,
        } = Target::of(path).map_err(io)?
        {
            let place = self.with_folder(&place).map_err(io)?;
            if let Some(file) = Temporary::moved(from, folder_of(&place)).map_err(io)? {
                let contents = Contents::Replacement { place, file };
                return self.push(path, contents).map_err(io);
            }
        }
        self.add_with(path, |to| {
            let copied = File::open(from).and_then(|mut from| io::copy(&mut from, to));
            copied.map(|_| ()).map_err(io)
        })
    }

    /// As [`add_with`](Self::add_with), for the standard output of the program. `path` is how
    /// errors name it. A reader that has closed the pipe is not an error.
    ///
    /// # Errors
    ///
    /// [`WriteError`], and those of the function.
    pub fn add_to_standard_output<E: From<WriteError>>(
        &mut self,
        path: impl AsRef<Path>,
        write: impl FnOnce(&mut dyn WriteSeek) -> Result<(), E>,
    ) -> Result<(), E> {
        let path = path.as_ref();
        let kept = kept(write, path)?;
        let contents = Contents::StandardOutput { kept };
        Ok(self
            .push(path, contents)
            .map_err(|error| failed(path, error))?)
    }

    fn push(&mut self, path: &Path, mut contents: Contents) -> io::Result<()> {
        if let Some(place) = contents.place() {
            if let Some(&number) = self.numbers.get(place) {
                if self.ready[number].contents.bytes()? == contents.bytes()? {
                    return Ok(());
                }
                let reason = "another output has the same path";
                return Err(io::Error::new(io::ErrorKind::InvalidInput, reason));
            }
            self.numbers.insert(place.to_path_buf(), self.ready.len());
        }
        self.ready.push(Ready {
            path: path.to_path_buf(),
            contents,
        });
        Ok(())
    }

    /// The path of a file with its folder, which is created if it is missing, resolved.
    fn with_folder(&mut self, path: &Path) -> io::Result<PathBuf> {
        let name = path.file_name().ok_or(io::ErrorKind::InvalidInput)?;
        let folder = folder_of(path);
        self.created.create(folder)?;
        Ok(folder.canonicalize()?.join(name))
    }

    /// Gives all files their names.
    ///
    /// # Errors
    ///
    /// [`WriteError`] with the file that cannot take its name.
    pub fn finish(mut self) -> Result<(), WriteError> {
        let mut ready = std::mem::take(&mut self.ready);
        // What goes to a stream may fail, and no file has its name yet.
        for file in &mut ready {
            file.send().map_err(|error| failed(&file.path, error))?;
        }
        let mut leftovers = leftovers();
        let mut failure = None;
        for Ready { path, contents } in &mut ready {
            let done = match contents {
                Contents::InPlace { place, kept } => overwrite(place, kept),
                Contents::Replacement { place, file } => file.persist(place, &mut leftovers),
                Contents::Stream { .. } | Contents::StandardOutput { .. } => Ok(()),
            };
            if let Err(error) = done {
                failure = Some(failed(path, error));
                break;
            }
        }
        drop(leftovers);
        match failure {
            Some(error) => Err(error),
            None => {
                self.created.keep();
                Ok(())
            }
        }
    }
}

impl Ready {
    /// Writes to a stream.
    fn send(&mut self) -> io::Result<()> {
        match &mut self.contents {
            Contents::Stream { kept } => {
                kept.rewind()?;
                let mut stream = OpenOptions::new().append(true).open(&self.path)?;
                io::copy(kept, &mut stream)?;
                Ok(())
            }
            Contents::StandardOutput { kept } => {
                kept.rewind()?;
                let mut output = io::stdout().lock();
                match io::copy(kept, &mut output).and_then(|_| output.flush()) {
                    Err(error) if error.kind() != io::ErrorKind::BrokenPipe => Err(error),
                    _ => Ok(()),
                }
            }
            Contents::InPlace { .. } | Contents::Replacement { .. } => Ok(()),
        }
    }
}

impl Contents {
    /// Which file they become.
    fn place(&self) -> Option<&Path> {
        match self {
            Self::Replacement { place, .. } | Self::InPlace { place, .. } => Some(place),
            Self::Stream { .. } | Self::StandardOutput { .. } => None,
        }
    }

    fn bytes(&mut self) -> io::Result<Vec<u8>> {
        match self {
            Self::Replacement { file, .. } => std::fs::read(file.path().unwrap_or(Path::new(""))),
            Self::InPlace { kept, .. } | Self::Stream { kept } | Self::StandardOutput { kept } => {
                let mut bytes = Vec::new();
                kept.rewind()?;
                kept.read_to_end(&mut bytes)?;
                Ok(bytes)
            }
        }
    }
}

fn failed(path: &Path, source: io::Error) -> WriteError {
    WriteError {
        path: path.to_path_buf(),
        source,
    }
}

/// The folder of a file.
fn folder_of(path: &Path) -> &Path {
    match path.parent() {
        Some(folder) if !folder.as_os_str().is_empty() => folder,
        _ => Path::new("."),
    }
}

/// What a function writes.
fn kept<E: From<WriteError>>(
    write: impl FnOnce(&mut dyn WriteSeek) -> Result<(), E>,
    path: &Path,
) -> Result<SpooledTempFile, E> {
    let mut kept = SpooledTempFile::new(MOST_IN_MEMORY);
    write(&mut kept)?;
    kept.flush().map_err(|error| failed(path, error))?;
    Ok(kept)
}

/// Replaces the contents of a file.
fn overwrite(place: &Path, kept: &mut SpooledTempFile) -> io::Result<()> {
    kept.rewind()?;
    let mut file: File = OpenOptions::new().write(true).truncate(true).open(place)?;
    io::copy(kept, &mut file)?;
    file.sync_all()
}
