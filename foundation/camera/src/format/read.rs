//! Files of cameras of any format.

use std::path::Path;

use ga_files::ReadError;

use super::camera_file::{CameraFile, NamedCamera};
use super::contents::Contents;
use super::error::CameraFileError;
use super::json_line::JsonLines;
use super::table::Format;
use super::{colmap, json};

/// Reads the cameras of a file; or of a folder, in which [`json::VIEWS`], a model of COLMAP or
/// `transforms.json` is looked for.
///
/// # Errors
/// [`ReadError`] with the file and an error of [`decode`].
pub fn read(path: impl AsRef<Path>) -> Result<CameraFile, ReadError<CameraFileError>> {
    Ok(read_with_format(path)?.1)
}

/// As [`read()`], with the format of the file.
///
/// # Errors
/// As [`read()`].
pub fn read_with_format(
    path: impl AsRef<Path>,
) -> Result<(Format, CameraFile), ReadError<CameraFileError>> {
    let path = match path.as_ref() {
        folder if folder.is_dir() => {
            let views = folder.join(json::VIEWS);
            let transforms = folder.join("transforms.json");
            match colmap::file_in(folder) {
                Some(model) if !views.is_file() => model,
                None if transforms.is_file() && !views.is_file() => transforms,
                _ => views,
            }
        }
        file => file.to_owned(),
    };
    let folder = path.parent().unwrap_or(Path::new(""));
    ga_files::read(&path, |bytes| decode_with_format(bytes, folder))
}

/// Reads the cameras of a file that lies in a folder, in which the files that it names are looked
/// for. The contents tell the [format](Format).
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
///     "P0: 500 0 320 0 0 501 240 0 0 0 1 0\n",
/// ];
/// for text in texts {
///     let file = format::decode(text.as_bytes(), Path::new(""))?;
///     assert_eq!(file.one(None)?.intrinsics()?.focal(), [500.0, 501.0]);
/// }
/// # Ok::<(), format::CameraFileError>(())
/// ```
pub fn decode(bytes: &[u8], folder: &Path) -> Result<CameraFile, CameraFileError> {
    Ok(decode_with_format(bytes, folder)?.1)
}

fn decode_with_format(
    bytes: &[u8],
    folder: &Path,
) -> Result<(Format, CameraFile), CameraFileError> {
    let contents = Contents::new(bytes)?;
    let mut formats = Format::ALL.into_iter();
    let found = formats.find_map(|format| Some((format, format.decode(&contents, folder)?)));
    let (format, mut file) = found.unwrap_or((Format::Json, Err(CameraFileError::NoViews)));
    if let Contents::Json { text, .. } = contents {
        let lines = JsonLines::new(text);
        match &mut file {
            Ok(file) => {
                let cameras = file.cameras.iter_mut();
                let unstated = cameras.filter_map(NamedCamera::unstated_lens_mut);
                unstated.for_each(|place| lines.add_to(place));
            }
            Err(error) => error
                .place_mut()
                .into_iter()
                .for_each(|place| lines.add_to(place)),
        }
    }
    Ok((format, file?))
}
