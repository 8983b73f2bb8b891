//! The formats of motions.

use std::ffi::OsStr;
use std::path::Path;

use ga_files::ReadError;

use crate::MotionFileError;

/// A format of files with motions.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Format {
    /// BVH; see [`bvh`](crate::bvh).
    Bvh,
    /// glTF 2.0, as JSON or GLB; see [`gltf`](crate::gltf).
    Gltf,
    /// A compressed clip; see [`compressed`](crate::clip::compressed).
    Clip,
}

impl Format {
    /// The format that the ending of a file's name stands for, in small or capital letters.
    ///
    /// # Errors
    ///
    /// [`ReadError::Contents`] with [`MotionFileError::Ending`].
    ///
    /// ```
    /// use ga_anim::motion_file::Format;
    ///
    /// assert_eq!(Format::of_path("takes/Walk.BVH")?, Format::Bvh);
    /// assert!(Format::of_path("walk.txt").is_err());
    /// # Ok::<(), ga_files::ReadError<ga_anim::MotionFileError>>(())
    /// ```
    pub fn of_path(path: impl AsRef<Path>) -> Result<Self, ReadError<MotionFileError>> {
        let path = path.as_ref();
        let ending = path.extension().and_then(OsStr::to_str).unwrap_or("");
        match ending.to_ascii_lowercase().as_str() {
            "bvh" => Ok(Self::Bvh),
            "glb" | "gltf" => Ok(Self::Gltf),
            "clip" => Ok(Self::Clip),
            _ => Err(ReadError::Contents {
                path: path.to_owned(),
                problem: MotionFileError::Ending,
            }),
        }
    }
}
