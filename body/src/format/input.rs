//! Reading files of every kind.

use std::collections::HashMap;
use std::path::{Path, PathBuf};

use ga_files::ReadError;
use serde::Deserialize;
use serde::de::IgnoredAny;

use super::detections::Picture;
use super::{
    Detections, DetectorOptions, FrameKey, JointViews, JointsError, Model, alphapose, coco,
    deeplabcut, film, keys, mmpose, openpose,
};

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

/// What a file of joints is.
enum Kind {
    Views,
    Coco,
    OpenPose,
    AlphaPose,
    MmPose,
    Film,
    DeepLabCut,
}

/// The members by which the elements of lists differ.
#[derive(Deserialize)]
struct Element {
    image_id: Option<IgnoredAny>,
    frame_id: Option<IgnoredAny>,
    keypoint_scores: Option<IgnoredAny>,
}

/// The kind of a file by what it begins with and by its members, whose values are passed over.
fn kind(bytes: &[u8]) -> Result<Kind, JointsError> {
    let text = bytes.trim_ascii_start();
    let unmarked = text.strip_prefix(b"\xef\xbb\xbf").unwrap_or(text);
    let first = unmarked.get(..deeplabcut::FIRST.len()).unwrap_or_default();
    if first.eq_ignore_ascii_case(deeplabcut::FIRST.as_bytes()) {
        return Ok(Kind::DeepLabCut);
    }
    if text.starts_with(b"[") {
        let elements: Vec<Element> = serde_json::from_slice(bytes)?;
        let is_of_mmpose = elements.first().is_some_and(|element| {
            let is_frame_or_person =
                element.frame_id.is_some() || element.keypoint_scores.is_some();
            element.image_id.is_none() && is_frame_or_person
        });
        return Ok(if is_of_mmpose {
            Kind::MmPose
        } else {
            Kind::Coco
        });
    }
    let members: HashMap<String, IgnoredAny> = serde_json::from_slice(bytes)?;
    let told = [
        ("people", Kind::OpenPose),
        ("annotations", Kind::Coco),
        ("instance_info", Kind::MmPose),
        ("views", Kind::Views),
        ("frames", Kind::Film),
    ];
    let mut told = told.into_iter();
    if let Some((_, kind)) = told.find(|(member, _)| members.contains_key(*member)) {
        return Ok(kind);
    }
    let has_ending = |name: &String| Path::new(name).extension().is_some();
    let are_pictures = !members.is_empty() && members.keys().all(has_ending);
    Ok(match are_pictures {
        true => Kind::AlphaPose,
        false => Kind::Views,
    })
}

impl JointViews {
    /// Reads one file that holds [all views](JointViews), or for each view a file of any other
    /// [format](super), or a folder with a file for each frame, as OpenPose and MMPose write them.
    /// The names of views are those of the files or folders without their endings. Formats are told
    /// by what the files hold.
    ///
    /// # Errors
    /// [`JointsReadError`], which names the file.
    pub fn read<P: AsRef<Path>>(
        paths: &[P],
        options: &DetectorOptions,
    ) -> Result<Self, JointsReadError> {
        let model = options.model;
        let mut views: Vec<(String, Detections)> = Vec::with_capacity(paths.len());
        for path in paths {
            let path = path.as_ref();
            let found = if path.is_dir() {
                folder(path, model)?
            } else {
                match ga_files::read(path, |bytes| file(path, bytes, model))? {
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

fn file(path: &Path, bytes: &[u8], model: Option<Model>) -> Result<Contents, JointsError> {
    Ok(Contents::View(match kind(bytes)? {
        Kind::Views => return Ok(Contents::AllViews(JointViews::decode(bytes)?)),
        Kind::Coco => coco::decode(bytes, model)?,
        Kind::OpenPose => openpose::decode(&[(ga_files::name(path), bytes)], model)?,
        Kind::AlphaPose => alphapose::decode(bytes, model)?,
        Kind::MmPose => mmpose::decode(bytes, model)?,
        Kind::Film => film::decode(bytes, model)?,
        Kind::DeepLabCut => deeplabcut::decode(bytes, model)?,
    }))
}

/// The files of the frames of a view.
fn folder(path: &Path, model: Option<Model>) -> Result<Detections, JointsReadError> {
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
    ga_files::natural_order(&mut files);
    let names: Vec<String> = files.iter().map(|file| ga_files::name(file)).collect();
    let names: Vec<&str> = names.iter().map(String::as_str).collect();
    let mut joints = None;
    let mut pictures = Vec::with_capacity(files.len());
    for ((file, name), key) in files.iter().zip(&names).zip(keys::keys(&names)) {
        let label = FrameKey::Name((*name).to_owned()).to_string();
        let people = ga_files::read(file, |bytes| {
            let text = bytes.trim_ascii_start();
            // A list holds the people of a picture in MMPose's form, and may be empty.
            let is_list = text.starts_with(b"[");
            if !is_list && matches!(kind(bytes)?, Kind::OpenPose) {
                return openpose::File::parse(bytes)?.people(&label);
            }
            let file = mmpose::File::parse(bytes)?;
            joints = joints.take().or_else(|| file.names());
            file.people(&label)
        })?;
        pictures.push(Picture { key, label, people });
    }
    Detections::new(pictures, joints, model).map_err(|problem| {
        let path = path.to_owned();
        ReadError::Contents { path, problem }.into()
    })
}
