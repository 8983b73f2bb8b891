//! Reading files of every kind.

use std::collections::HashMap;
use std::path::{Path, PathBuf};

use ga_files::ReadError;
use serde::de::IgnoredAny;

use super::{Detections, DetectorOptions, JointViews, JointsError, coco, openpose};

/// Why files of joints cannot be read.
#[derive(Debug, thiserror::Error)]
pub enum JointsReadError {
    /// A file cannot be read, or its contents are wrong.
    #[error(transparent)]
    File(#[from] ReadError<JointsError>),
    /// A folder cannot be listed.
    #[error("cannot list {}: {source}", path.display())]
    Folder {
        /// The folder.
        path: PathBuf,
        /// What the operating system said.
        source: std::io::Error,
    },
    /// The views do not fit together.
    #[error(transparent)]
    Views(#[from] JointsError),
    /// A file has the joints of all views, and there are others beside it.
    #[error("{} has the joints of all views, and cannot be given together with other files", path.display())]
    AllViews {
        /// The file.
        path: PathBuf,
    },
}

/// What a file of joints is, by its members.
enum Kind {
    Views,
    Coco,
    OpenPose,
}

/// The kind of a file by the members of its object, whose values are passed over.
fn kind(bytes: &[u8]) -> Result<Kind, JointsError> {
    if bytes.iter().find(|byte| !byte.is_ascii_whitespace()) == Some(&b'[') {
        return Ok(Kind::Coco);
    }
    let members: HashMap<String, IgnoredAny> = serde_json::from_slice(bytes)?;
    Ok(if members.contains_key("people") {
        Kind::OpenPose
    } else if members.contains_key("annotations") {
        Kind::Coco
    } else {
        Kind::Views
    })
}

impl JointViews {
    /// Reads one file that holds [all views](JointViews), or for each view a file of COCO, a file
    /// of OpenPose, or a folder with OpenPose's files of its frames. The names of views are those
    /// of the files or folders without their endings.
    ///
    /// # Errors
    /// [`JointsReadError`], which names the file.
    pub fn read<P: AsRef<Path>>(
        paths: &[P],
        options: &DetectorOptions,
    ) -> Result<Self, JointsReadError> {
        let mut views: Vec<(String, Detections)> = Vec::with_capacity(paths.len());
        for path in paths {
            let path = path.as_ref();
            let found = if path.is_dir() {
                folder(path)?
            } else {
                match ga_files::read(path, |bytes| file(path, bytes))? {
                    Contents::View(detections) => detections,
                    Contents::AllViews(joints) if paths.len() == 1 => return Ok(joints),
                    Contents::AllViews(_) => {
                        let path = path.to_owned();
                        return Err(JointsReadError::AllViews { path });
                    }
                }
            };
            let mut name = ga_files::stem(path);
            if views.iter().any(|(other, _)| *other == name) {
                name = path.display().to_string();
            }
            views.push((name, found));
        }
        Ok(Self::from_detections(&views, options)?)
    }
}

enum Contents {
    AllViews(JointViews),
    View(Detections),
}

fn file(path: &Path, bytes: &[u8]) -> Result<Contents, JointsError> {
    Ok(match kind(bytes)? {
        Kind::Views => Contents::AllViews(JointViews::decode(bytes)?),
        Kind::Coco => Contents::View(coco::decode(bytes)?),
        Kind::OpenPose => Contents::View(openpose::decode(&[(ga_files::name(path), bytes)])?),
    })
}

/// OpenPose's files of the frames of a view.
fn folder(path: &Path) -> Result<Detections, JointsReadError> {
    let failed = |source| JointsReadError::Folder {
        path: path.to_owned(),
        source,
    };
    let mut files: Vec<PathBuf> = Vec::new();
    for entry in std::fs::read_dir(path).map_err(failed)? {
        let file = entry.map_err(failed)?.path();
        if file.extension().is_some_and(|ending| ending == "json") {
            files.push(file);
        }
    }
    let mut frames = Vec::with_capacity(files.len());
    for file in files {
        let name = ga_files::name(&file);
        let frame = ga_files::read(&file, |bytes| openpose::decode_file(&name, bytes))?;
        frames.push((name, frame));
    }
    openpose::join(frames).map_err(|problem| {
        let path = path.to_owned();
        ReadError::Contents { path, problem }.into()
    })
}
