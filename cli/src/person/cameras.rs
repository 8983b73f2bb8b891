//! The cameras of the views.

use std::path::{Path, PathBuf};

use anyhow::{Context, Result, bail};
use ga_body::format::match_named;
use ga_camera::Camera;
use ga_camera::format::NamedCamera;
use ga_runtime::cga3::Motor;

use crate::camera_file::{ChosenPair, about};

/// The file with the cameras.
#[derive(Clone, Debug, clap::Args)]
pub(crate) struct CameraFiles {
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

/// The camera of a view.
#[derive(Clone, Copy, Debug)]
pub(crate) struct ViewCamera {
    pub(crate) camera: Camera,
    /// Columns and rows of its pictures, where the file says them.
    pub(crate) size: Option<[usize; 2]>,
}

/// Sizes of a film and of its camera's pictures have one shape where their ratios differ by less.
const SHAPE: f64 = 0.01;

impl ViewCamera {
    /// How many times wider and higher the pictures of the camera are than those of a film; 1 where
    /// the file does not say their size. `None` where they have another shape.
    pub(crate) fn scale(&self, film: [usize; 2]) -> Option<[f64; 2]> {
        let size = self.size.unwrap_or(film);
        let [across, down] = [0, 1].map(|k| size[k] as f64 / film[k] as f64);
        ((across - down).abs() <= SHAPE * down).then_some([across, down])
    }
}

impl CameraFiles {
    /// Whether the cameras stand in a world of their own, and not in the frame of one of them.
    pub(crate) fn has_world(&self) -> bool {
        self.views.is_some()
    }

    pub(crate) fn path(&self) -> Option<&PathBuf> {
        self.rig.as_ref().or(self.views.as_ref())
    }

    /// The camera of each view, by the names of these. The world of a rig has y up.
    pub(crate) fn read<N: AsRef<str>>(&self, views: &[N]) -> Result<Vec<ViewCamera>> {
        match (&self.rig, &self.views) {
            (Some(path), _) => of_rig(path, &self.chosen, views.len()),
            (None, Some(path)) => {
                self.chosen.refuse_names(
                    "it chooses cameras of --rig; those of --views have the names of views",
                )?;
                let all = self.chosen.read_all(path)?.cameras;
                let named = match_named(views, &all);
                let named = named.with_context(|| path.display().to_string())?;
                let cameras = named.into_iter().map(|named| {
                    let camera = named.camera().map_err(|error| about(path, error))?;
                    let size = named.size;
                    Ok(ViewCamera { camera, size })
                });
                cameras.collect()
            }
            (None, None) => bail!("--rig or --views is needed: the cameras"),
        }
    }
}

fn of_rig(path: &Path, chosen: &ChosenPair, views: usize) -> Result<Vec<ViewCamera>> {
    let upright = |camera: Camera, named: &NamedCamera| ViewCamera {
        camera: camera.in_world_with_y_up(),
        size: named.size,
    };
    match views {
        1 => {
            let named = chosen.read_one(path)?;
            let intrinsics = named.intrinsics();
            let camera = Camera {
                intrinsics: intrinsics.map_err(|error| about(path, error))?,
                world_to_camera: Motor::default(),
            };
            Ok(vec![upright(camera, &named)])
        }
        2 => {
            let rig = chosen.read(path)?;
            let [left, right] = &rig.cameras;
            Ok(vec![
                upright(rig.rig.left, left),
                upright(rig.rig.right, right),
            ])
        }
        _ => bail!(
            "{}: there are {views} views, and --rig has one camera or two; --views has any number",
            path.display()
        ),
    }
}
