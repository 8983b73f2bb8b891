//! URIs of buffers and images: data in the URI itself, or a file beside the glTF file.

use std::path::{Path, PathBuf};

use base64::Engine;
use base64::engine::DecodePaddingMode;
use base64::engine::general_purpose::{GeneralPurpose, GeneralPurposeConfig};

/// Accepts data with and without padding.
const BASE64: GeneralPurpose = GeneralPurpose::new(
    &base64::alphabet::STANDARD,
    GeneralPurposeConfig::new()
        .with_decode_padding_mode(DecodePaddingMode::Indifferent)
        .with_decode_allow_trailing_bits(true),
);

/// What a URI names.
pub(super) enum Uri {
    /// Data, and their media type.
    Data { media_type: String, bytes: Vec<u8> },
    /// A file, relative to the folder of the glTF file.
    File(PathBuf),
}

/// What a URI names; `None` for an absolute path, for a scheme other than `data:` and for data that
/// cannot be decoded.
pub(super) fn parse(uri: &str) -> Option<Uri> {
    // Schemes and the names of parameters may be in small or capital letters (RFC 3986, RFC 2397).
    if let Some((scheme, data)) = uri.split_at_checked("data:".len())
        && scheme.eq_ignore_ascii_case("data:")
    {
        return parse_data(data);
    }
    let path = urlencoding::decode(uri).ok()?;
    let has_scheme = path.split(['/', '\\']).next()?.contains(':');
    let path = Path::new(path.as_ref());
    let is_named = path.file_name().is_some();
    (is_named && !has_scheme && !path.has_root()).then(|| Uri::File(path.to_path_buf()))
}

fn parse_data(data: &str) -> Option<Uri> {
    let (head, body) = data.split_once(',')?;
    let last = head.rsplit_once(';');
    let in_base64 = last.filter(|(_, word)| word.eq_ignore_ascii_case("base64"));
    let (media_type, bytes) = match in_base64 {
        Some((media_type, _)) => (media_type, BASE64.decode(body).ok()?),
        None => (
            head,
            urlencoding::decode_binary(body.as_bytes()).into_owned(),
        ),
    };
    let media_type = media_type.split(';').next().unwrap_or_default().to_owned();
    Some(Uri::Data { media_type, bytes })
}

/// The URI of a file in the same folder.
pub(super) fn of_file(name: &str) -> String {
    urlencoding::encode(name).into_owned()
}

/// The URI of a file, given by its path with `/` between folders.
pub(super) fn of_path(path: &str) -> String {
    let folders: Vec<_> = path.split('/').map(urlencoding::encode).collect();
    folders.join("/")
}
