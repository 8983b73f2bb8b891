//! Files of cameras of any format.

use std::path::Path;

use ga_files::ReadError;

use super::camera_file::CameraFile;
use super::error::CameraFileError;
use super::text::text;
use super::yaml::Storage;
use super::{calib, json, rig};

/// Reads the cameras of a file, or of [`json::VIEWS`] in a folder.
///
/// # Errors
/// [`ReadError`] with the file and an error of [`decode`].
pub fn read(path: impl AsRef<Path>) -> Result<CameraFile, ReadError<CameraFileError>> {
    let path = match path.as_ref() {
        folder if folder.is_dir() => folder.join(json::VIEWS),
        file => file.to_owned(),
    };
    let folder = path.parent().unwrap_or(Path::new(""));
    ga_files::read(&path, |bytes| decode(bytes, folder))
}

/// Reads the cameras of a file that lies in a folder, in which the files that it names are looked
/// for. The contents tell the format: an object of JSON, lines of the form `key=value`, or YAML.
///
/// # Errors
/// [`CameraFileError`] where the bytes are not such a file, or a camera is missing or impossible.
///
/// ```
/// use std::path::Path;
/// use ga_camera::format;
/// let texts = [
///     "%YAML:1.0\n---\nK: [[500, 0, 320], [0, 501, 240], [0, 0, 1]]\n",
///     r#"{"width": 640, "height": 480, "fx": 500, "fy": 501, "cx": 320, "cy": 240}"#,
/// ];
/// for text in texts {
///     let file = format::decode(text.as_bytes(), Path::new(""))?;
///     assert_eq!(file.one(None)?.intrinsics()?.focal(), [500.0, 501.0]);
/// }
/// # Ok::<(), format::CameraFileError>(())
/// ```
pub fn decode(bytes: &[u8], folder: &Path) -> Result<CameraFile, CameraFileError> {
    let text = text(bytes)?;
    if text.trim_start().starts_with(['{', '[']) {
        let found = json::decode(text, folder);
        // OpenCV writes its own keys as JSON too, which is YAML.
        if let (Err(CameraFileError::NoViews), Ok(storage)) = (&found, Storage::decode(bytes))
            && rig::has_matrix(&storage)
        {
            return rig::decode(&storage);
        }
        return found;
    }
    if is_calib(text) {
        return calib::decode(text);
    }
    rig::decode(&Storage::decode(bytes)?)
}

/// Whether the first line that is not empty is of the form `key=value`.
fn is_calib(text: &str) -> bool {
    let line = text.lines().find(|line| !line.trim().is_empty());
    let key = line.and_then(|line| line.split_once('='));
    key.is_some_and(|(key, _)| {
        let mut letters = key.trim().chars();
        !key.trim().is_empty() && letters.all(|c| c.is_ascii_alphanumeric() || c == '_')
    })
}
