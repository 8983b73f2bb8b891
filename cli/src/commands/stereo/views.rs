//! The views of a scene, from picture files.

use std::path::{Path, PathBuf};

use anyhow::{Result, ensure};
use ga_image::grey::Luma;
use ga_image::picture::Picture;
use ga_image::plane::Plane;
use ga_image::sample::Sample;
use ga_vision::feature::{DetectOptions, LEAST_SIDE, detect};

use crate::picture_file;

/// The views of two cameras.
#[derive(Clone, Debug, clap::Args)]
pub(super) struct ViewPair {
    /// The left view.
    #[arg(value_name = "LEFT")]
    pub(super) left: PathBuf,
    /// The right view.
    #[arg(value_name = "RIGHT")]
    pub(super) right: PathBuf,
}

impl ViewPair {
    pub(super) fn paths(&self) -> [&Path; 2] {
        [&self.left, &self.right]
    }

    /// How errors name them.
    pub(super) fn named(&self) -> String {
        format!("{} and {}", self.left.display(), self.right.display())
    }

    /// Reads both, which must have one size.
    pub(super) fn read(&self) -> Result<[Picture; 2]> {
        let pictures = [
            picture_file::read(&self.left)?,
            picture_file::read(&self.right)?,
        ];
        let [a, b] = pictures.each_ref().map(|p| [p.width(), p.height()]);
        ensure!(
            a == b,
            "the views differ in size: {} has {} × {} pixels and {} has {} × {}",
            self.left.display(),
            a[0],
            a[1],
            self.right.display(),
            b[0],
            b[1]
        );
        Ok(pictures)
    }
}

/// Reads a view in grey. Colours become grey by the weights of ITU-R BT.601, and the range of
/// cameras with 10, 12 or 14 bits is spread.
pub(in crate::commands) fn read<T: Sample>(path: &Path) -> Result<Plane<T>> {
    let [view] = in_grey([picture_file::read(path)?]);
    Ok(view)
}

/// Reads two views of any sizes in grey, as [`read`]; their ranges are spread alike.
pub(super) fn read_both<T: Sample>([left, right]: [&Path; 2]) -> Result<[Plane<T>; 2]> {
    Ok(in_grey([
        picture_file::read(left)?,
        picture_file::read(right)?,
    ]))
}

/// As [`read_both`], of views that must have one size.
pub(in crate::commands) fn read_pair<T: Sample>(
    left: &Path,
    right: &Path,
) -> Result<[Plane<T>; 2]> {
    let [left, right] = [left, right].map(Path::to_path_buf);
    Ok(in_grey(ViewPair { left, right }.read()?))
}

fn in_grey<T: Sample, const N: usize>(pictures: [Picture; N]) -> [Plane<T>; N] {
    Picture::spread(pictures).map(|picture| picture.to_grey(Luma::Bt601))
}

/// Fails where a view is too small for features.
pub(super) fn check_side(view: &Plane<u16>, path: &Path) -> Result<()> {
    let [width, height] = [view.width(), view.height()];
    ensure!(
        width.min(height) >= LEAST_SIDE,
        "{} has {width} × {height} pixels: corners are found in views of at least {LEAST_SIDE} × \
         {LEAST_SIDE} pixels",
        path.display()
    );
    Ok(())
}

/// What two views have that give fewer matched corners than are needed: the first of them that has
/// too few corners for it, or both.
pub(super) fn few_matches(
    views: [&Plane<u16>; 2],
    paths: [&Path; 2],
    options: &DetectOptions,
    needed: usize,
) -> String {
    for (view, path) in views.into_iter().zip(paths) {
        let corners = detect(view, options).len();
        if corners < needed {
            let path = path.display();
            return format!("{path} has too little texture: {corners} corners are found in it");
        }
    }
    let [left, right] = paths.map(Path::display);
    format!("{left} and {right} seem to show different scenes")
}
