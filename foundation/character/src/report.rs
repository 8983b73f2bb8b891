//! What is said of a figure and its animation, in metres and seconds.

use ga_anim::character::MotionReport;
use ga_anim::clip::Clip;
use ga_anim::skin::SkinError;
use serde::Serialize;

use crate::figure::Figure;
use crate::storyboard::Storyboard;

/// A motion of a figure, as it is written and shown.
#[derive(Clone, Debug)]
pub struct Animation {
    /// Its name in files.
    pub name: String,
    /// The motion as it is written.
    pub clip: Clip,
    /// The moments that are shown.
    pub storyboard: Storyboard,
    /// The heading over them.
    pub title: String,
    /// The greatest distance of a joint of an in-between of the storyboard from its recorded
    /// position at that time; `None` where the motion consists of key frames only.
    pub in_between_deviation: Option<f64>,
}

/// A figure in numbers.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct FigureReport {
    /// Its name in files.
    pub name: String,
    /// The group of the input mesh that it is; `None` for the whole.
    pub group: Option<String>,
    /// How long one unit of the input mesh is.
    pub metres_per_unit: f64,
    /// The height at rest.
    pub height_metres: f64,
    /// Vertices of the mesh.
    pub vertices: usize,
    /// Faces of the mesh.
    pub faces: usize,
    /// Triangles into which the faces are split.
    pub triangles: usize,
    /// Joints of the skeleton.
    pub joints: usize,
    /// The greatest number of joints that move one vertex.
    pub influences_max: usize,
}

/// An animation in numbers.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct AnimationReport {
    /// Its name in files.
    pub name: String,
    /// Frames of the clip.
    pub frames: usize,
    /// Their rate.
    pub frames_per_second: f64,
    /// The time from the first frame to the last.
    pub duration_seconds: f64,
    /// What was measured on every frame.
    pub checks: MotionReport,
    /// As [`Animation::in_between_deviation`].
    pub in_between_deviation_max_metres: Option<f64>,
}

impl FigureReport {
    /// Measures a figure at rest.
    #[must_use]
    pub fn new(figure: &Figure) -> Self {
        let character = &figure.character;
        Self {
            name: figure.name.clone(),
            group: figure.group.clone(),
            metres_per_unit: figure.metres_per_unit,
            height_metres: character.height(),
            vertices: character.mesh.vertex_count(),
            faces: character.mesh.faces().len(),
            triangles: character.mesh.triangles().len(),
            joints: character.skeleton.len(),
            influences_max: character.weights.max_influences(),
        }
    }
}

impl AnimationReport {
    /// Measures a figure in motion.
    ///
    /// # Errors
    ///
    /// As [`MotionReport::new`].
    pub fn new(figure: &Figure, animation: &Animation) -> Result<Self, SkinError> {
        let clip = &animation.clip;
        Ok(Self {
            name: animation.name.clone(),
            frames: clip.frames().len(),
            frames_per_second: 1.0 / clip.frame_time(),
            duration_seconds: clip.duration(),
            checks: MotionReport::new(&figure.character, clip)?,
            in_between_deviation_max_metres: animation.in_between_deviation,
        })
    }
}
