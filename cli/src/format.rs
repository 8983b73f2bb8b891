//! The formats of files and the endings of their names.

use std::ffi::OsStr;
use std::path::Path;

/// A format that is known by the ending of a file's name.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Format {
    Bvh,
    /// Any format of cameras that is a file.
    Camera(ga_camera::format::Format),
    Clip,
    Csv,
    Edl,
    Glb,
    Gltf,
    Html,
    Json,
    /// Any format of meshes.
    Mesh(ga_mesh::format::Format),
    Mp4,
    Pfm,
    Png,
    Svg,
    Text,
    Y4m,
    Yaml,
}

impl Format {
    /// The endings, the usual one first.
    pub(crate) fn endings(self) -> &'static [&'static str] {
        match self {
            Self::Bvh => &["bvh"],
            Self::Camera(format) => format.endings(),
            Self::Clip => &["clip"],
            Self::Csv => &["csv"],
            Self::Edl => &["edl"],
            Self::Glb => &["glb"],
            Self::Gltf => &["gltf"],
            Self::Html => &["html", "htm"],
            Self::Json => &["json"],
            Self::Mesh(format) => format.endings(),
            Self::Mp4 => &["mp4"],
            Self::Pfm => &["pfm"],
            Self::Png => &["png"],
            Self::Svg => &["svg"],
            Self::Text => &["txt"],
            Self::Y4m => &["y4m"],
            Self::Yaml => &["yml", "yaml"],
        }
    }

    /// Whether the name of a file has an ending of this format, in small or capital letters.
    pub(crate) fn fits(self, path: &Path) -> bool {
        let ending = path.extension().and_then(OsStr::to_str).unwrap_or("");
        let mut endings = self.endings().iter();
        endings.any(|known| ending.eq_ignore_ascii_case(known))
    }

    /// The one of some formats that the name of a file stands for.
    pub(crate) fn of(path: &Path, formats: &[Self]) -> Option<Self> {
        formats.iter().copied().find(|format| format.fits(path))
    }
}

/// The endings of some formats, as in `.svg, .html or .htm`.
pub(crate) fn endings(formats: &[Format]) -> String {
    let all = formats.iter().flat_map(|format| format.endings());
    listed(all.map(|ending| format!(".{ending}")))
}

/// Words as in `a, b or c`.
pub(crate) fn listed(words: impl IntoIterator<Item = String>) -> String {
    let all: Vec<String> = words.into_iter().collect();
    match all.split_last() {
        Some((last, others)) if !others.is_empty() => format!("{} or {last}", others.join(", ")),
        _ => all.concat(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn endings_count_in_small_and_capital_letters() {
        let formats = [Format::Svg, Format::Html];
        let of = |name: &str| Format::of(Path::new(name), &formats);
        assert_eq!(of("a.svg"), Some(Format::Svg));
        assert_eq!(of("a.b/c.HTM"), Some(Format::Html));
        for other in ["svg", ".svg", "a.svg.gz", "a.svg/b", "a."] {
            assert_eq!(of(other), None, "{other}");
        }
    }

    #[test]
    fn endings_are_listed() {
        assert_eq!(endings(&[Format::Png]), ".png");
        assert_eq!(endings(&[Format::Svg, Format::Html]), ".svg, .html or .htm");
    }
}
