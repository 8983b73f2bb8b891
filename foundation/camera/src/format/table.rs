//! The formats of files of cameras.

use std::ffi::OsStr;
use std::path::Path;

use super::camera_file::{CameraFile, NamedCamera, Rectified};
use super::contents::Contents;
use super::error::CameraFileError;
use super::storage::Storage;
use super::{
    anipose, camera, colmap, json, kalibr, kitti, middlebury, opencv, qualisys, rig, ros,
    transforms,
};
use crate::rig::RectifiedRig;

/// A format of files of cameras. All are read, and all but two are written.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Format {
    /// YAML of OpenCV: one camera, or a rig.
    OpenCv,
    /// XML of OpenCV: the same.
    OpenCvXml,
    /// JSON of OpenCV: the same.
    OpenCvJson,
    /// One camera or a list of views; see [`json`].
    Json,
    /// The camchain of kalibr.
    Kalibr,
    /// ROS' `camera_info`.
    Ros,
    /// `calib.txt` and `calib_cam_to_cam.txt` of KITTI.
    Kitti,
    /// `calib.txt` of Middlebury and ETH3D: a rectified pair.
    Middlebury,
    /// A model of COLMAP in a folder.
    Colmap,
    /// TOML of aniposelib and Pose2Sim.
    Anipose,
    /// The calibration of Qualisys.
    Qualisys,
    /// `transforms.json` of radiance fields.
    Transforms,
}

/// What a format keeps of cameras beside their projections.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Kept {
    /// How many cameras it has room for.
    pub(super) cameras: Option<usize>,
    pub(super) sizes: bool,
    pub(super) poses: Poses,
    pub(super) names: bool,
    pub(super) pictures: bool,
    /// Least and greatest depth of a renderer.
    pub(super) depths: bool,
}

/// What a format keeps of the poses of cameras.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Poses {
    /// All, in the world.
    World,
    /// Those of cameras after the first, in the frame of the first.
    InFirst,
    None,
}

/// Files by their names in a folder; the name of the only file is empty.
pub(super) type Texts = Vec<(&'static str, String)>;

/// What is known of a format.
struct Description {
    name: &'static str,
    /// What options call it, the usual one first.
    words: &'static [&'static str],
    /// The usual one first.
    endings: &'static [&'static str],
    kept: Kept,
    /// The cameras of contents in a folder, where they are of this format.
    decode: fn(&Contents, &Path) -> Option<Result<CameraFile, CameraFileError>>,
    encode: fn(&CameraFile) -> Result<Texts, CameraFileError>,
}

/// What OpenCV's files keep; those of one camera keep its pose in the world.
const OF_RIG: Kept = Kept {
    cameras: Some(2),
    sizes: true,
    poses: Poses::InFirst,
    names: false,
    pictures: false,
    depths: false,
};
const OF_ALL: Kept = Kept {
    cameras: None,
    poses: Poses::World,
    names: true,
    ..OF_RIG
};

impl Format {
    /// All formats, in the order in which the contents of a file are tried: the last of those with
    /// a syntax takes what the others do not know, and says what is missing.
    pub const ALL: [Self; 12] = [
        Self::Colmap,
        Self::Kitti,
        Self::Middlebury,
        Self::Anipose,
        Self::Qualisys,
        Self::OpenCvXml,
        Self::Transforms,
        Self::OpenCvJson,
        Self::Json,
        Self::Kalibr,
        Self::Ros,
        Self::OpenCv,
    ];

    /// The table of the formats. All else that is said of them follows from it.
    const fn description(self) -> &'static Description {
        match self {
            Self::OpenCv => &Description {
                name: "OpenCV's YAML",
                words: &["opencv", "yaml", "opencv-yaml"],
                endings: &["yml", "yaml"],
                kept: OF_RIG,
                decode: |contents, _| match contents {
                    Contents::Yaml(documents) => Some(of_documents(documents, opencv::decode)),
                    _ => None,
                },
                encode: |file| Ok(single(opencv_storage(&file.cameras)?.encode())),
            },
            Self::OpenCvXml => &Description {
                name: "OpenCV's XML",
                words: &["opencv-xml", "xml"],
                endings: &["xml"],
                kept: OF_RIG,
                decode: |contents, _| match contents {
                    Contents::Xml(xml) => {
                        let entries = xml.entries().map(Storage::of_entries);
                        Some(entries.and_then(|storage| opencv::decode(&storage)))
                    }
                    _ => None,
                },
                encode: |file| Ok(single(opencv_storage(&file.cameras)?.encode_xml())),
            },
            Self::OpenCvJson => &Description {
                name: "OpenCV's JSON",
                words: &["opencv-json"],
                endings: &["json"],
                kept: OF_RIG,
                decode: |contents, _| match contents {
                    Contents::Json { text, value } if !json::is_own(value) => {
                        // It is YAML too, and so has lines.
                        let storage = Storage::decode(text.as_bytes()).ok()?;
                        opencv::has_camera(&storage).then(|| opencv::decode(&storage))
                    }
                    _ => None,
                },
                encode: |file| Ok(single(opencv_storage(&file.cameras)?.encode_json())),
            },
            Self::Json => &Description {
                name: "JSON of a camera or of views",
                words: &["json", "views"],
                endings: &["json"],
                kept: Kept {
                    pictures: true,
                    depths: true,
                    ..OF_ALL
                },
                decode: |contents, folder| match contents {
                    Contents::Json { value, .. } => Some(json::decode(value, folder)),
                    _ => None,
                },
                encode: |file| {
                    Ok(single(match file.cameras.as_slice() {
                        [only] => json::encode(only)?,
                        several => json::encode_views(&with_pictures(several), Path::new(""))?,
                    }))
                },
            },
            Self::Kalibr => &Description {
                name: "kalibr's camchain",
                words: &["kalibr"],
                endings: &["yaml", "yml"],
                kept: Kept {
                    cameras: None,
                    ..OF_RIG
                },
                decode: |contents, _| match contents {
                    Contents::Yaml(documents) if documents.iter().any(kalibr::is_chain) => {
                        Some(of_documents(documents, kalibr::decode))
                    }
                    _ => None,
                },
                encode: |file| Ok(single(kalibr::encode(&file.cameras)?)),
            },
            Self::Ros => &Description {
                name: "ROS' camera_info",
                words: &["ros", "camera-info", "camera_info"],
                endings: &["yaml", "yml"],
                kept: Kept {
                    cameras: Some(1),
                    poses: Poses::None,
                    names: true,
                    ..OF_RIG
                },
                decode: |contents, _| match contents {
                    Contents::Yaml(documents) if documents.iter().any(ros::is_message) => {
                        Some(of_documents(documents, ros::decode))
                    }
                    _ => None,
                },
                encode: |file| Ok(single(ros::encode(&file.cameras[0])?)),
            },
            Self::Kitti => &Description {
                name: "KITTI's calib.txt",
                words: &["kitti"],
                endings: &["txt"],
                kept: Kept {
                    cameras: None,
                    ..OF_RIG
                },
                decode: |contents, _| match contents {
                    Contents::Lines(text) if kitti::is_calibration(text) => {
                        Some(kitti::decode(text))
                    }
                    _ => None,
                },
                encode: |file| Ok(single(kitti::encode(&file.cameras)?)),
            },
            Self::Middlebury => &Description {
                name: "Middlebury's calib.txt",
                words: &["middlebury"],
                endings: &["txt"],
                kept: OF_RIG,
                decode: |contents, _| match contents {
                    Contents::Lines(text) => Some(middlebury::decode(text)),
                    _ => None,
                },
                encode: |file| {
                    let size = file.cameras.first().and_then(|camera| camera.size);
                    Ok(single(middlebury::encode(&rectified(file)?, size)))
                },
            },
            Self::Colmap => &Description {
                name: "COLMAP's model",
                words: &["colmap"],
                endings: &[],
                kept: OF_ALL,
                decode: |contents, folder| match contents {
                    Contents::Bytes(bytes) => Some(colmap::decode(bytes, folder)),
                    Contents::Lines(text) if colmap::is_model(text) => {
                        Some(colmap::decode(text.as_bytes(), folder))
                    }
                    _ => None,
                },
                encode: |file| colmap::encode(&file.cameras),
            },
            Self::Anipose => &Description {
                name: "TOML of aniposelib and Pose2Sim",
                words: &["toml", "anipose", "pose2sim"],
                endings: &["toml"],
                kept: OF_ALL,
                decode: |contents, _| match contents {
                    Contents::Toml(storage) => Some(anipose::decode(storage)),
                    _ => None,
                },
                encode: |file| Ok(single(anipose::encode(&file.cameras)?)),
            },
            Self::Qualisys => &Description {
                name: "Qualisys' calibration",
                words: &["qca", "qualisys"],
                endings: &["txt", "qca", "xml"],
                kept: OF_ALL,
                decode: |contents, _| match contents {
                    Contents::Xml(xml) if qualisys::is_calibration(xml) => {
                        Some(qualisys::decode(xml))
                    }
                    _ => None,
                },
                encode: |_| Err(CameraFileError::ReadOnly("Qualisys' calibration")),
            },
            Self::Transforms => &Description {
                name: "transforms.json",
                words: &["transforms", "nerf", "blender"],
                endings: &["json"],
                kept: OF_ALL,
                decode: |contents, folder| match contents {
                    Contents::Json { value, .. } if transforms::is_transforms(value) => {
                        Some(transforms::decode(value, folder))
                    }
                    _ => None,
                },
                encode: |_| Err(CameraFileError::ReadOnly("transforms.json")),
            },
        }
    }

    /// The name for people, as `kalibr's camchain`.
    #[must_use]
    pub fn name(self) -> &'static str {
        self.description().name
    }

    /// The name in options, as `kalibr`.
    #[must_use]
    pub fn word(self) -> &'static str {
        self.description().words[0]
    }

    /// Whether its lengths have a unit: models of COLMAP have one of their own, and aniposelib's
    /// files that of the board.
    #[must_use]
    pub fn states_unit(self) -> bool {
        !matches!(self, Self::Colmap | Self::Anipose | Self::Transforms)
    }

    /// Whether it is written.
    #[must_use]
    pub fn is_written(self) -> bool {
        !matches!(self, Self::Qualisys | Self::Transforms)
    }

    /// The format that options call by a word.
    ///
    /// ```
    /// use ga_camera::format::Format;
    /// assert_eq!(Format::named("kalibr"), Some(Format::Kalibr));
    /// assert_eq!(Format::named("camera"), None);
    /// ```
    #[must_use]
    pub fn named(word: &str) -> Option<Self> {
        let mut formats = Self::ALL.into_iter();
        formats.find(|format| format.description().words.contains(&word))
    }

    /// The endings of the names of its files in small letters, without the point, the usual one
    /// first; none for a folder.
    #[must_use]
    pub fn endings(self) -> &'static [&'static str] {
        self.description().endings
    }

    /// The format that is written to a file of a name, by its ending.
    ///
    /// ```
    /// use ga_camera::format::Format;
    /// assert_eq!(Format::of_path("rig.XML"), Some(Format::OpenCvXml));
    /// assert_eq!(Format::of_path("camera.json"), Some(Format::Json));
    /// assert_eq!(Format::of_path("model"), None);
    /// ```
    #[must_use]
    pub fn of_path(path: impl AsRef<Path>) -> Option<Self> {
        let ending = path.as_ref().extension().and_then(OsStr::to_str)?;
        let usual = [
            Self::OpenCv,
            Self::OpenCvXml,
            Self::Json,
            Self::Kitti,
            Self::Anipose,
        ];
        let fits = |known: &&str| ending.eq_ignore_ascii_case(known);
        let mut formats = usual.into_iter();
        formats.find(|format| format.endings().iter().any(fits))
    }

    /// The format that is written to a file, by its ending where none is asked for. That of OpenCV
    /// is the one of the ending.
    #[must_use]
    pub fn for_path(asked: Option<Self>, path: impl AsRef<Path>) -> Option<Self> {
        match (asked, Self::of_path(path)) {
            (Some(Self::OpenCv), Some(Self::OpenCvXml)) => Some(Self::OpenCvXml),
            (Some(Self::OpenCv), Some(Self::Json)) => Some(Self::OpenCvJson),
            (asked, of_path) => asked.or(of_path),
        }
    }

    /// The names of its files in a folder, where it is a folder.
    #[must_use]
    pub fn names_in_folder(self) -> Option<&'static [&'static str]> {
        (self == Self::Colmap).then_some(&colmap::NAMES)
    }

    /// Whether it is OpenCV's, in any syntax.
    pub(super) fn is_opencv(self) -> bool {
        matches!(self, Self::OpenCv | Self::OpenCvXml | Self::OpenCvJson)
    }

    pub(super) fn kept(self) -> Kept {
        self.description().kept
    }

    /// The cameras of contents in a folder, where they are of this format.
    pub(super) fn decode(
        self,
        contents: &Contents,
        folder: &Path,
    ) -> Option<Result<CameraFile, CameraFileError>> {
        (self.description().decode)(contents, folder)
    }

    /// The texts of files; there is at least one camera, and not more than are kept.
    pub(super) fn encode(self, file: &CameraFile) -> Result<Texts, CameraFileError> {
        (self.description().encode)(file)
    }
}

fn single(text: String) -> Texts {
    vec![("", text)]
}

/// The cameras of documents of YAML, which must all be the same, as those of messages that are
/// printed again and again.
fn of_documents(
    documents: &[Storage],
    decode: fn(&Storage) -> Result<CameraFile, CameraFileError>,
) -> Result<CameraFile, CameraFileError> {
    let mut files = documents.iter().map(decode);
    let first = files
        .next()
        .unwrap_or_else(|| Ok(CameraFile::new(Vec::new())))?;
    for (file, document) in files.zip(documents.iter().skip(1)) {
        if file? != first {
            return Err(CameraFileError::Unsupported {
                line: document.first_line(),
                problem: "a second document begins here, with other cameras",
            });
        }
    }
    Ok(first)
}

/// The values of one camera or of two in OpenCV's files.
fn opencv_storage(cameras: &[NamedCamera]) -> Result<Storage, CameraFileError> {
    match cameras {
        [left, right] => {
            let pose = match (left.pose, right.pose) {
                (Some(first), Some(second)) => {
                    let motion = second * first.reverse();
                    if motion.translator().displacement() == [0.0; 3] {
                        return Err(CameraFileError::SamePlace {
                            left: left.name.clone(),
                            right: right.name.clone(),
                        });
                    }
                    Some(motion)
                }
                _ => None,
            };
            let size = left.size.filter(|size| right.size == Some(*size));
            rig::storage_of([left.intrinsics()?, right.intrinsics()?], pose, size)
        }
        [only] => {
            let mut storage = camera::storage(&only.intrinsics()?, only.size);
            if let Some(pose) = only.pose {
                rig::set_pose(&mut storage, pose);
            }
            Ok(storage)
        }
        _ => Ok(Storage::default()),
    }
}

/// Cameras that all have pictures: where the file names none, one with the camera's name.
fn with_pictures(cameras: &[NamedCamera]) -> Vec<NamedCamera> {
    let cameras = cameras.iter().cloned().map(|mut camera| {
        let name = camera.name.clone();
        camera.picture.get_or_insert_with(|| name.into());
        camera
    });
    cameras.collect()
}

/// What Middlebury's format has of a pair.
fn rectified(file: &CameraFile) -> Result<Rectified, CameraFileError> {
    let refuse = |problem: String| CameraFileError::NotRectified {
        format: Format::Middlebury.name(),
        problem,
    };
    if let Some(rectified) = file.rectified {
        return Ok(rectified);
    }
    let rig = file.rig(&[])?;
    let motion = rig.left_to_right().motor;
    let [x, y, z] = motion.translator().displacement();
    let turned = motion.rotor().canonical().to_axis_angle().1;
    if turned.abs() > 1e-12 || y.abs() > 1e-12 || z.abs() > 1e-12 {
        return Err(refuse(
            "the views are not in one plane side by side".to_owned(),
        ));
    }
    let rig = RectifiedRig::new(rig.left.intrinsics, rig.right.intrinsics, -x);
    Ok(Rectified {
        rig: rig.map_err(|error| refuse(error.to_string()))?,
        disparities: None,
    })
}
