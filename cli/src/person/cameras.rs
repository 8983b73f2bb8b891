//! The cameras of the views.

use std::path::{Path, PathBuf};

use anyhow::{Context, Result, bail};
use ga_body::format::JointViews;
use ga_camera::Camera;
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
                self.chosen.refuse_names(
                    "it chooses cameras of --rig; those of --views have the names of views",
                )?;
                let cameras = joints.match_cameras(&self.chosen.read_all(path)?.cameras);
                cameras.with_context(|| path.display().to_string())
            }
            (None, None) => bail!("--rig or --views is needed: the cameras"),
        }
    }
}

fn of_rig(path: &Path, chosen: &ChosenPair, views: usize) -> Result<Vec<Camera>> {
    let found = match views {
        1 => {
            let intrinsics = chosen.read_one(path)?.intrinsics();
            vec![Camera {
                intrinsics: intrinsics.map_err(|error| about(path, error))?,
                world_to_camera: Motor::default(),
            }]
        }
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
    let upright = found.into_iter().map(Camera::in_world_with_y_up);
    Ok(upright.collect())
}
