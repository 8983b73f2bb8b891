//! The cameras of the views.

use std::path::{Path, PathBuf};

use anyhow::{Result, bail, ensure};
use ga_body::format::JointViews;
use ga_camera::Camera;
use ga_camera::format::camera::CameraFile;
use ga_camera::format::rig::RigFile;
use ga_camera::format::views::{self, ViewEntry};
use ga_runtime::cga3::{Motor, Rotor};

/// The file with the cameras.
#[derive(Clone, Debug, clap::Args)]
#[group(required = true, multiple = false)]
pub(super) struct CameraFiles {
    /// The cameras of one or two views: a camera for one and a stereo rig for two, in OpenCV's
    /// YAML.
    #[arg(long, value_name = "rig.yml")]
    rig: Option<PathBuf>,
    /// The cameras of any number of views, as `nullcone render --views` writes them and `nullcone
    /// texture` reads them; or a folder with them in views.json. The pictures are not read.
    #[arg(long, value_name = "VIEWS.json")]
    views: Option<PathBuf>,
}

impl CameraFiles {
    pub(super) fn path(&self) -> Option<&PathBuf> {
        self.rig.as_ref().or(self.views.as_ref())
    }

    /// The camera of each view of the joints. The world of a rig has y up.
    pub(super) fn read(&self, joints: &JointViews) -> Result<Vec<Camera>> {
        match (&self.rig, &self.views) {
            (Some(path), _) => of_rig(path, joints.views().len()),
            (None, Some(path)) => of_views(path, joints),
            (None, None) => bail!("--rig or --views is needed: the cameras"),
        }
    }
}

fn of_rig(path: &Path, views: usize) -> Result<Vec<Camera>> {
    let found = match views {
        1 => vec![Camera {
            intrinsics: CameraFile::read(path)?.intrinsics,
            world_to_camera: Motor::default(),
        }],
        2 => {
            let rig = RigFile::read(path)?.rig;
            vec![rig.left, rig.right]
        }
        _ => bail!(
            "{}: the joints are in {views} views, and --rig has one camera or two; --views has any \
             number",
            path.display()
        ),
    };
    // From y up and z backwards to y down and z forwards.
    let half_turn_about_x = Rotor::new_unchecked(0.0, 0.0, 0.0, -1.0);
    let upright = found.into_iter().map(|camera| Camera {
        world_to_camera: camera.world_to_camera * Motor::from(half_turn_about_x),
        ..camera
    });
    Ok(upright.collect())
}

/// By the names of the pictures, or in their order where no name is that of a picture.
fn of_views(path: &Path, joints: &JointViews) -> Result<Vec<Camera>> {
    let entries = views::read(path)?;
    let named: Vec<Option<usize>> = joints
        .views()
        .iter()
        .map(|view| entry_named(&entries, &view.name))
        .collect();
    let shown = path.display();
    if named.iter().all(Option::is_none) {
        let (views, cameras) = (joints.views().len(), entries.len());
        ensure!(
            views == cameras,
            "{shown}: the joints are in {views} views, whose names are not those of pictures, and \
             there are {cameras} cameras"
        );
        return Ok(entries.iter().map(|entry| entry.camera).collect());
    }
    let mut cameras = Vec::with_capacity(named.len());
    for (index, (view, entry)) in joints.views().iter().zip(&named).enumerate() {
        let Some(entry) = *entry else {
            bail!(
                "{shown}: no picture has the name of the view {:?}",
                view.name
            );
        };
        if let Some(other) = named[..index]
            .iter()
            .position(|other| *other == Some(entry))
        {
            let (other, name) = (&joints.views()[other].name, &view.name);
            bail!("{shown}: the views {other:?} and {name:?} are of one picture");
        }
        cameras.push(entries[entry].camera);
    }
    Ok(cameras)
}

/// The one picture of this name, with or without its ending.
fn entry_named(entries: &[ViewEntry], name: &str) -> Option<usize> {
    let is_named = |entry: &ViewEntry| {
        let picture = entry.picture.as_path();
        [picture.file_name(), picture.file_stem()].contains(&Some(name.as_ref()))
    };
    let mut found = (0..entries.len()).filter(|&index| is_named(&entries[index]));
    match (found.next(), found.next()) {
        (Some(index), None) => Some(index),
        _ => None,
    }
}
