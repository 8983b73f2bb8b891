//! What the bytes of a file are, before any format is told.

use serde_json::Value;

use super::error::CameraFileError;
use super::storage::Storage;
use super::syntax::xml::Xml;
use super::text::text;
use super::{colmap, kitti, syntax};

/// The contents of a file by their syntax.
pub(super) enum Contents<'a> {
    /// Numbers in bytes.
    Bytes(&'a [u8]),
    Xml(Xml<'a>),
    Json {
        text: &'a str,
        value: Value,
    },
    Toml(Storage),
    /// Lines that are none of the others: numbers behind a key, or equations.
    Lines(&'a str),
    /// Documents of YAML; one where they share no names.
    Yaml(Vec<Storage>),
}

impl<'a> Contents<'a> {
    /// Tells the syntax by how the text begins, and parses it.
    pub(super) fn new(bytes: &'a [u8]) -> Result<Self, CameraFileError> {
        if colmap::is_binary(bytes) {
            return Ok(Self::Bytes(bytes));
        }
        let text = text(bytes)?;
        let mut lines = text.lines().map(str::trim);
        let first = lines.find(|line| !line.is_empty() && !line.starts_with('#'));
        let first = first.unwrap_or("");
        if first.starts_with('<') {
            return Ok(Self::Xml(Xml::parse(text)?));
        }
        let is_equation = is_equation(first);
        if (is_section(first) && text.contains('='))
            || (is_equation && text.lines().map(str::trim).any(is_section))
        {
            return Ok(Self::Toml(Storage::of_entries(syntax::toml::entries(
                text,
            )?)));
        }
        if first.starts_with(['{', '[']) {
            let value = syntax::json::parse(text)?;
            return Ok(Self::Json { text, value });
        }
        if is_equation || colmap::is_camera_line(first) || kitti::is_calibration(text) {
            return Ok(Self::Lines(text));
        }
        Ok(Self::Yaml(Storage::documents(text)?))
    }
}

/// Whether a line is of the form `key=value`.
fn is_equation(line: &str) -> bool {
    let key = line.split_once('=').map(|(key, _)| key.trim());
    key.is_some_and(|key| {
        !key.is_empty() && key.chars().all(|c| c.is_ascii_alphanumeric() || c == '_')
    })
}

/// Whether a line is the head of a section of TOML: `[name]`.
fn is_section(line: &str) -> bool {
    let inside = line
        .strip_prefix('[')
        .and_then(|rest| rest.strip_suffix(']'));
    inside.is_some_and(|name| {
        let is_part = |c: char| c.is_ascii_alphanumeric() || "_-. \"'".contains(c);
        name.contains(|c: char| c.is_ascii_alphabetic() || c == '_') && name.chars().all(is_part)
    })
}
