//! The views of a scene, from picture files.

use std::path::Path;

use anyhow::{Result, ensure};
use ga_image::file;
use ga_image::grey::Luma;
use ga_image::plane::Plane;
use ga_vision::feature::{DetectOptions, LEAST_SIDE, detect};

/// Reads a view in grey. Colours become grey by the weights of ITU-R BT.601.
pub(super) fn read(path: &Path) -> Result<Plane<u8>> {
    Ok(file::read(path)?.to_grey(Luma::Bt601))
}

/// Fails where a view is too small for features.
pub(super) fn check_side(view: &Plane<u8>, path: &Path) -> Result<()> {
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
    views: [&Plane<u8>; 2],
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

/// Reads two views of the same size in grey.
pub(in crate::commands) fn read_pair(left: &Path, right: &Path) -> Result<[Plane<u8>; 2]> {
    of_one_size([read(left)?, read(right)?], [left, right])
}

/// Reads two views of the same size in colour; grey ones have three equal channels.
pub(super) fn read_colour_pair(left: &Path, right: &Path) -> Result<[Plane<[u8; 3]>; 2]> {
    let read = |path: &Path| -> Result<Plane<[u8; 3]>> { Ok(file::read(path)?.to_rgb()) };
    of_one_size([read(left)?, read(right)?], [left, right])
}

fn of_one_size<T: Copy>(views: [Plane<T>; 2], [left, right]: [&Path; 2]) -> Result<[Plane<T>; 2]> {
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
