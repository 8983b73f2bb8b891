//! `nullcone contour`: the contours of what pictures show, in the picture and in space.

mod arguments;
mod curve;
mod drawing;
mod flat;
mod settling;

pub(crate) use arguments::Arguments;

use anyhow::Result;

pub(crate) fn run(arguments: &Arguments, quiet: bool) -> Result<()> {
    match (&arguments.images[..], &arguments.rig) {
        ([image], None) => flat::run(arguments, image, quiet),
        ([left, right], Some(rig)) => curve::run(arguments, [left, right], rig, quiet),
        ([image], Some(rig)) => anyhow::bail!(
            "--rig {} needs two views, and {} is one",
            rig.display(),
            image.display()
        ),
        _ => anyhow::bail!("two views need the cameras that took them: --rig rig.yml"),
    }
}
