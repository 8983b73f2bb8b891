//! Files of cameras in a format that is chosen.

use std::fmt;
use std::path::{Path, PathBuf};

use ga_runtime::cga3::Motor;

use super::camera_file::{CameraFile, NamedCamera, SIDES, SINGLE};
use super::error::CameraFileError;
use super::kitti;
use super::table::{Format, Poses};

/// Something of some cameras that a format cannot hold and that is left out.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Omission {
    /// What it is, as `sizes of pictures`; without the `places in the world`, it is the frame of
    /// the first camera.
    pub what: &'static str,
    /// Of how many cameras.
    pub count: usize,
}

impl fmt::Display for Omission {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { what, count } = self;
        let cameras = if *count == 1 { "camera" } else { "cameras" };
        write!(f, "the {what} of {count} {cameras} are left out")
    }
}

/// Files of cameras, and what they do not hold.
#[derive(Clone, Debug, PartialEq)]
pub struct Encoded {
    /// Paths and contents.
    pub files: Vec<(PathBuf, String)>,
    /// What is left out.
    pub omissions: Vec<Omission>,
}

/// The files of cameras in a format, of which the path is a file, or a folder for a model of
/// COLMAP.
///
/// # Errors
/// [`CameraFileError`] where the format has no room for as many cameras, or cannot hold something
/// without which they would be other cameras, as a distortion.
///
/// ```
/// use std::path::Path;
/// use ga_camera::{Intrinsics, format};
/// use ga_camera::format::{CameraFile, Format, NamedCamera, encode_files};
/// let intrinsics = Intrinsics::new([500.0, 501.0], [320.0, 240.0])?;
/// let camera = NamedCamera::new("camera", intrinsics).with_size(Some([640, 480]));
/// let file = CameraFile::new(vec![camera]);
/// let written = encode_files("cam.yaml", Format::Kalibr, &file)?;
/// let again = format::decode(written.files[0].1.as_bytes(), Path::new(""))?;
/// assert_eq!(again.cameras[0].intrinsics()?, intrinsics);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn encode_files(
    path: impl AsRef<Path>,
    format: Format,
    file: &CameraFile,
) -> Result<Encoded, CameraFileError> {
    let kept = format.kept();
    let cameras = &file.cameras;
    if cameras.is_empty() || kept.cameras.is_some_and(|most| cameras.len() > most) {
        return Err(CameraFileError::TooMany {
            format: format.name(),
            most: match kept.cameras {
                Some(1) => "one camera",
                Some(_) => "one camera or two",
                None => "one camera or more",
            },
            names: cameras.iter().map(|camera| camera.name.clone()).collect(),
        });
    }
    let texts = format.encode(file)?;
    let path = path.as_ref();
    let files = texts.into_iter().map(|(name, text)| match name {
        "" => (path.to_path_buf(), text),
        name => (path.join(name), text),
    });
    Ok(Encoded {
        files: files.collect(),
        omissions: omissions(format, file),
    })
}

/// What a format cannot hold of cameras.
fn omissions(format: Format, file: &CameraFile) -> Vec<Omission> {
    let (kept, cameras) = (format.kept(), file.cameras.as_slice());
    let mut found = Vec::new();
    let mut add = |what, is_kept: bool, is_lost: &dyn Fn(&NamedCamera) -> bool| {
        let count = cameras.iter().filter(|camera| is_lost(camera)).count();
        if !is_kept && count > 0 {
            found.push(Omission { what, count });
        }
    };
    let is_rig_file = format.is_opencv() || format == Format::Middlebury;
    let sizes: Vec<_> = cameras.iter().filter_map(|camera| camera.size).collect();
    let is_one_size = sizes.iter().all(|size| *size == sizes[0]) && sizes.len() == cameras.len();
    let are_projections = format == Format::Kitti && kitti::are_projections(cameras);
    let keeps_sizes = match (is_rig_file, are_projections) {
        (true, _) => is_one_size,
        (_, true) => false,
        _ => kept.sizes,
    };
    add("sizes of pictures", keeps_sizes, &|camera| {
        camera.size.is_some()
    });
    let is_placed = |camera: &NamedCamera| camera.pose.is_some_and(|pose| !is_identity(pose));
    let all_have = cameras.iter().all(|camera| camera.pose.is_some());
    match kept.poses {
        Poses::World => {}
        Poses::InFirst if format.is_opencv() && cameras.len() == 1 => {}
        Poses::InFirst if all_have && cameras.len() > 1 => {
            let moves = cameras.first().is_some_and(is_placed);
            add("places in the world", !moves, &|_| true);
        }
        Poses::InFirst | Poses::None => add("poses", false, &is_placed),
    }
    let given: &[&str] = if cameras.len() == 2 {
        &SIDES
    } else {
        &[SINGLE]
    };
    let has_usual_names = cameras.iter().map(|camera| &camera.name).eq(given.iter());
    let keeps_names = match format {
        Format::Json => cameras.len() > 1,
        // The names are those of images, which have poses.
        Format::Colmap => cameras.iter().any(|camera| camera.pose.is_some()),
        _ => kept.names,
    };
    add("names", keeps_names || has_usual_names, &|_| true);
    add("pictures", kept.pictures, &|camera| {
        camera.picture.is_some()
    });
    add("least and greatest depths", kept.depths, &|camera| {
        camera.near.is_some() || camera.far.is_some()
    });
    let is_middlebury = format == Format::Middlebury;
    let rectified = file.rectified.filter(|_| !is_middlebury);
    add(
        "marks of rectified pictures",
        rectified.is_none() || are_projections,
        &|_| true,
    );
    let disparities = rectified.and_then(|rectified| rectified.disparities);
    add("bounds of disparities", disparities.is_none(), &|_| true);
    found
}

fn is_identity(pose: Motor<f64>) -> bool {
    let along = pose.translator().displacement();
    let angle = pose.rotor().canonical().to_axis_angle().1;
    angle.abs() < 1e-15 && along.iter().all(|x| x.abs() < 1e-15)
}
