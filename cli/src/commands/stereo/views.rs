//! The views of a scene, from picture files.

use std::path::Path;

use anyhow::{Result, ensure};
use ga_image::file;
use ga_image::grey::Luma;
use ga_image::plane::Plane;

/// Reads a view in grey. Colours become grey by the weights of ITU-R BT.601.
pub(super) fn read(path: &Path) -> Result<Plane<u8>> {
    Ok(file::read(path)?.to_grey(Luma::Bt601))
}

/// Reads two views of the same size in grey.
pub(super) fn read_pair(left: &Path, right: &Path) -> Result<[Plane<u8>; 2]> {
    let views = [read(left)?, read(right)?];
    let [first, second] = views.each_ref().map(|view| [view.width(), view.height()]);
    ensure!(
        first == second,
        "the views differ in size: {} has {} × {} pixels and {} has {} × {}",
        left.display(),
        first[0],
        first[1],
        right.display(),
        second[0],
        second[1]
    );
    Ok(views)
}
