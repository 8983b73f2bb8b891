//! Images: bytes in a buffer, in a URI or in a file.

use std::path::Path;

use super::super::problem::{Element, Problem};
use super::super::uri::{self, Uri};
use super::super::{Image, ImageSource, json};
use super::accessor::Accessors;
use super::buffer::{Buffers, uri_problem};
use super::file::read_file;
use crate::FormatError;

/// No picture file that is longer is read.
const LIMIT: u64 = 1 << 30;

pub(super) fn image(
    index: usize,
    json: &json::Image,
    root: &json::Root,
    buffers: &Buffers,
    accessors: &Accessors,
) -> Result<Image, FormatError> {
    let element = || Element::Image(index);
    let stated = json.mime_type.clone();
    let source = match (&json.uri, json.buffer_view) {
        (None, Some(view)) => {
            let (bytes, _) = buffers
                .view(root, view)
                .map_err(|error| error.within(element()))?;
            accessors
                .charge(bytes.len() as u64)
                .map_err(|problem| FormatError::gltf(element(), problem))?;
            let media_type = stated.unwrap_or_else(|| media_type(bytes).to_owned());
            let bytes = bytes.to_vec();
            ImageSource::Bytes { media_type, bytes }
        }
        (Some(uri), None) => match uri::parse(uri) {
            Some(Uri::Data {
                media_type: of_uri,
                bytes,
            }) => {
                let of_uri = Some(of_uri).filter(|name| name.starts_with("image/"));
                let media_type = stated
                    .or(of_uri)
                    .unwrap_or_else(|| media_type(&bytes).to_owned());
                ImageSource::Bytes { media_type, bytes }
            }
            Some(Uri::File(_)) => ImageSource::Uri(uri.clone()),
            None => return Err(FormatError::gltf(element(), uri_problem(uri))),
        },
        (Some(_), Some(_)) => {
            let what = "the source of image";
            return Err(FormatError::gltf(
                element(),
                Problem::Duplicate { what, index },
            ));
        }
        (None, None) => {
            let problem = Problem::Missing("a URI and a buffer view");
            return Err(FormatError::gltf(element(), problem));
        }
    };
    Ok(Image {
        name: json.name.clone(),
        source,
        extras: json.extras.clone(),
    })
}

/// The bytes of an image that a URI names.
pub(super) fn load(uri: &str, folder: &Path) -> Result<ImageSource, Problem> {
    match uri::parse(uri) {
        Some(Uri::File(path)) => {
            let bytes = read_file(&folder.join(path), LIMIT)?;
            let media_type = media_type(&bytes).to_owned();
            Ok(ImageSource::Bytes { media_type, bytes })
        }
        Some(Uri::Data { media_type, bytes }) => Ok(ImageSource::Bytes { media_type, bytes }),
        None => Err(uri_problem(uri)),
    }
}

/// The media type of a picture file, by its first bytes.
fn media_type(bytes: &[u8]) -> &'static str {
    if bytes.starts_with(b"\xff\xd8\xff") {
        "image/jpeg"
    } else if bytes.starts_with(b"RIFF") {
        "image/webp"
    } else {
        "image/png"
    }
}
