//! Writing: a [`Document`] to JSON and buffers.

mod animation;
mod buffer;
mod kept;
mod material;
mod node;
mod primitive;
mod references;
mod root;
mod unused;

use std::path::Path;

use super::{Document, ImageSource, glb, uri};
use crate::{FileError, FormatError};
use root::{ImagePlace, Writer};

/// The files of a document in JSON.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct GltfFiles {
    /// The JSON.
    pub json: Vec<u8>,
    /// The names and contents of the other files: of the buffer, if there is any, and of images.
    pub others: Vec<(String, Vec<u8>)>,
}

/// The bytes of a GLB file of the document. Images whose bytes are in the document are in the file;
/// those named by a URI stay files of their own, which this does not write.
///
/// What has not been changed since the document was read stands as in its file, see
/// [`Origin`](super::Origin). Other numbers are written in single precision as they are, so that
/// [`decode`](super::decode) returns the same vertices, weights and keys. Lists that are equal are
/// written once. What the Khronos validator reports of such a file is in the document;
/// [`Document::conformed`] mends most of it.
///
/// # Errors
///
/// As [`Document::validate`]; [`Problem::TooLarge`](super::Problem::TooLarge) past 4 GiB.
pub fn encode(document: &Document) -> Result<Vec<u8>, FormatError> {
    document.validate()?;
    let mut writer = Writer::new(document)?;
    for index in 0..document.images.len() {
        writer.image(index, ImagePlace::InBuffer);
    }
    let (text, bytes) = writer.finish(None)?;
    glb::join(text, &bytes)
}

/// The files of a document in JSON with a binary buffer: `name.bin` and, for each image whose bytes
/// are in the document, `name_0.png` or the like, numbered as the images.
///
/// # Errors
///
/// As [`Document::validate`].
pub fn encode_files(document: &Document, name: &str) -> Result<GltfFiles, FormatError> {
    document.validate()?;
    let mut writer = Writer::new(document)?;
    let mut others = Vec::new();
    for (index, image) in document.images.iter().enumerate() {
        let ImageSource::Bytes { media_type, bytes } = &image.source else {
            writer.image(index, ImagePlace::InBuffer);
            continue;
        };
        let extension = match media_type.as_str() {
            "image/jpeg" => "jpg",
            "image/webp" => "webp",
            "image/ktx2" => "ktx2",
            _ => "png",
        };
        let file = format!("{name}_{index}.{extension}");
        writer.image(index, ImagePlace::File(uri::of_file(&file)));
        others.push((file, bytes.clone()));
    }
    let file = format!("{name}.bin");
    let (json, bytes) = writer.finish(Some(uri::of_file(&file)))?;
    if !bytes.is_empty() {
        others.insert(0, (file, bytes));
    }
    Ok(GltfFiles { json, others })
}

/// Writes a document to a file: JSON with other files beside it where the name ends in `.gltf`, see
/// [`encode_files`], else GLB. All files are written, or none.
///
/// # Errors
///
/// [`FileError`].
pub fn write(path: impl AsRef<Path>, document: &Document) -> Result<(), FileError> {
    let path = path.as_ref();
    let files = path_files(path, document)?;
    if let [(_, contents)] = &files[..] {
        return Ok(ga_files::write(path, contents)?);
    }
    let here = Path::new(".");
    let folder = super::reader::folder_of(path);
    let folder = if folder.as_os_str().is_empty() {
        here
    } else {
        &folder
    };
    let files = files.iter().rev();
    let files = files.map(|(name, contents)| (name.as_str(), &contents[..]));
    Ok(ga_files::write_all(folder, files)?)
}

/// The names and contents of the files that [`write()`] writes, that of the path first.
///
/// # Errors
///
/// [`FileError::Contents`], as [`encode`].
pub fn path_files(path: &Path, document: &Document) -> Result<Vec<(String, Vec<u8>)>, FileError> {
    let fault = |problem| FileError::Contents {
        path: path.to_path_buf(),
        problem,
    };
    let is_json = path
        .extension()
        .is_some_and(|extension| extension.eq_ignore_ascii_case("gltf"));
    let stem = path.file_stem().and_then(|stem| stem.to_str());
    let name = path.file_name().unwrap_or_default().to_string_lossy();
    let (true, Some(stem)) = (is_json, stem) else {
        let contents = encode(document).map_err(fault)?;
        return Ok(vec![(name.into_owned(), contents)]);
    };
    let GltfFiles { json, others } = encode_files(document, stem).map_err(fault)?;
    let mut files = vec![(name.into_owned(), json)];
    files.extend(others);
    Ok(files)
}
