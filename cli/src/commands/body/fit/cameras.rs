//! The cameras of the views.

use std::path::{Path, PathBuf};

use anyhow::{Result, bail, ensure};
use ga_body::format::JointViews;
use ga_camera::Camera;
use ga_camera::format::{self, NamedCamera};
use ga_camera::frame::y_up;
use ga_runtime::cga3::Motor;

use crate::camera_file::{ChosenPair, about};

/// The file with the cameras.
#[derive(Clone, Debug, clap::Args)]
pub(super) struct CameraFiles {
    /// The cameras of one or two views, of a file of any format: a camera for one and a stereo rig
    /// for two. The person stands in the frame of the first camera with y up.
    #[arg(
        long,
        value_name = "FILE",
        required_unless_present = "views",
        conflicts_with = "views"
    )]
    rig: Option<PathBuf>,
    #[command(flatten)]
    chosen: ChosenPair,
    /// The cameras of any number of views, as `nullcone render --views` writes them and `nullcone
    /// texture` reads them, or of a file of another format that states poses; or a folder with them
    /// in views.json. The person stands in the world of the file. The pictures are not read.
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
            (Some(path), _) => of_rig(path, &self.chosen, joints.views().len()),
            (None, Some(path)) => {
                self.chosen.refuse(
                    "it chooses cameras of --rig; those of --views have the names of views",
                )?;
                of_views(path, joints)
            }
            (None, None) => bail!("--rig or --views is needed: the cameras"),
        }
    }
}

fn of_rig(path: &Path, chosen: &ChosenPair, views: usize) -> Result<Vec<Camera>> {
    let found = match views {
        1 => vec![Camera {
            intrinsics: chosen
                .read_one(path)?
                .intrinsics()
                .map_err(|error| about(path, error))?,
            world_to_camera: Motor::default(),
        }],
        2 => {
            let rig = chosen.read(path)?.rig;
            vec![rig.left, rig.right]
        }
        _ => bail!(
            "{}: the joints are in {views} views, and --rig has one camera or two; --views has any \
             number",
            path.display()
        ),
    };
    let upright = found.into_iter().map(|camera| Camera {
        world_to_camera: camera.world_to_camera * y_up(),
        ..camera
    });
    Ok(upright.collect())
}

/// By the names of the pictures, or in their order where no name is that of a picture.
fn of_views(path: &Path, joints: &JointViews) -> Result<Vec<Camera>> {
    let entries = format::read(path)?.cameras;
    let camera = |entry: &NamedCamera| entry.camera().map_err(|error| about(path, error));
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
        return entries.iter().map(camera).collect();
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
        cameras.push(camera(&entries[entry])?);
    }
    Ok(cameras)
}

/// The one picture of this name, with or without its ending.
fn entry_named(entries: &[NamedCamera], name: &str) -> Option<usize> {
    let mut found = (0..entries.len()).filter(|&index| entries[index].is_named(name));
    match (found.next(), found.next()) {
        (Some(index), None) => Some(index),
        _ => None,
    }
}
