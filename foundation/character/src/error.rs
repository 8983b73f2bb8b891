//! Why a figure cannot be read, shown or written.

use std::path::PathBuf;

use ga_anim::MotionFileError;
use ga_anim::skeleton::SkeletonError;
use ga_anim::skin::SkinError;
use ga_body::BodyError;
use ga_camera::rig::RigError;
use ga_camera::triangulation::TriangulationError;
use ga_files::ReadError;
use ga_image::file::FormatError as PictureFormatError;
use ga_mesh::{FileError, FormatError, MeshError};
use ga_render::RenderError;
use ga_render::sheet::SheetError;
use ga_render::texture::TextureError;

/// A figure that cannot be read, moved, shown or written.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum CharacterError {
    /// The file of a mesh cannot be read.
    #[error(transparent)]
    MeshFile(#[from] ReadError<FormatError>),
    /// The file of a rig, of weights or of a character cannot be read.
    #[error(transparent)]
    RigFile(#[from] ReadError<MotionFileError>),
    /// The file has no such group.
    #[error(
        "{} has no group {group:?}; its groups are: {}",
        path.display(),
        shortened(groups)
    )]
    NoGroup {
        /// The file.
        path: PathBuf,
        /// The group that is asked for.
        group: String,
        /// The names of those that it has.
        groups: Vec<String>,
    },
    /// In metres the figure is no longer finite.
    #[error("{} with {metres_per_unit} metres a unit: {source}", path.display())]
    Unit {
        /// The file.
        path: PathBuf,
        /// The length of its unit in metres.
        metres_per_unit: f64,
        /// What is wrong.
        source: Box<MotionFileError>,
    },
    /// The figure has no joint of this name.
    #[error("the figure has no such joint; its joints are: {}", joints.join(", "))]
    NoJoint {
        /// The name that is asked for.
        name: String,
        /// The names of the joints that it has.
        joints: Vec<String>,
    },
    /// The weights cannot be smoothed.
    #[error("the weights cannot be smoothed: {0}")]
    Smoothing(SkinError),
    /// The skin weights do not fit the mesh or the skeleton.
    #[error(transparent)]
    Skin(#[from] SkinError),
    /// A pose does not fit the skeleton.
    #[error(transparent)]
    Skeleton(#[from] SkeletonError),
    /// The material does not fit the mesh.
    #[error(transparent)]
    Mesh(#[from] MeshError),
    /// A contact sheet or a film cannot be drawn.
    #[error("cannot draw the {what}: {source}")]
    Draw {
        /// What is drawn.
        what: &'static str,
        /// What is wrong.
        source: SheetError,
    },
    /// A picture or a film cannot be encoded.
    #[error("cannot encode the {what}: {source}")]
    Encode {
        /// What is encoded.
        what: &'static str,
        /// What is wrong.
        source: PictureFormatError,
    },
    /// A glTF document cannot be evaluated, or cannot hold a motion or weights.
    #[error(transparent)]
    Document(Box<MotionFileError>),
    /// The picture of a material cannot be read.
    #[error(transparent)]
    Texture(Box<TextureError>),
    /// The file of a picture cannot be named from where the document is written.
    #[error(transparent)]
    Relocation(Box<FileError>),
    /// The node has no camera.
    #[error("node {node} has no camera")]
    NoCamera {
        /// The node.
        node: usize,
    },
    /// The camera of a node has no centre of projection.
    #[error("node {node}: its camera is a parallel projection, and only perspective is drawn")]
    ParallelProjection {
        /// The node.
        node: usize,
    },
    /// Nothing can be seen from a viewpoint.
    #[error(transparent)]
    Viewpoint(RenderError),
    /// Nothing can be seen by the camera of a node.
    #[error("node {node}: {source}")]
    View {
        /// The node.
        node: usize,
        /// What is wrong.
        source: RenderError,
    },
    /// The model has no form as glTF.
    #[error("the model cannot be written as glTF: {0}")]
    Gltf(#[from] FormatError),
    /// There is no place from which two cameras see the figure.
    #[error("no place was found from which two cameras see the figure")]
    NoPlace,
    /// A camera does not see the joints.
    #[error("{camera} camera: {source}")]
    Observation {
        /// `left` or `right`.
        camera: &'static str,
        /// What is wrong.
        source: Box<TriangulationError>,
    },
    /// The joints cannot be triangulated.
    #[error(transparent)]
    Triangulation(Box<RigError>),
    /// The positions that were found cannot be compared with the true ones.
    #[error(transparent)]
    Comparison(#[from] BodyError),
}

impl From<MotionFileError> for CharacterError {
    fn from(error: MotionFileError) -> Self {
        Self::Document(Box::new(error))
    }
}

/// The first names of a list, and how many more there are.
fn shortened(names: &[String]) -> String {
    const SHOWN: usize = 8;
    let more = names.len().saturating_sub(SHOWN);
    let shown = names[..names.len() - more].join(", ");
    match more {
        0 => shown,
        more => format!("{shown} and {more} more"),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn long_lists_of_names_are_cut() {
        let names = |count: u8| (b'a'..b'a' + count).map(|c| (c as char).to_string());
        let message = |count| {
            let error = CharacterError::NoGroup {
                path: PathBuf::from("man.obj"),
                group: "hat".into(),
                groups: names(count).collect(),
            };
            error.to_string()
        };
        let begin = "man.obj has no group \"hat\"; its groups are: ";
        assert_eq!(message(2), format!("{begin}a, b"));
        assert_eq!(message(8), format!("{begin}a, b, c, d, e, f, g, h"));
        assert_eq!(
            message(11),
            format!("{begin}a, b, c, d, e, f, g, h and 3 more")
        );
    }
}
