//! `nullcone mesh`: polygon meshes in files.

mod bake;
mod convert;
mod info;
mod subdivide;

use ga_mesh::format::Format;

use crate::format::listed;
use crate::frame::group;

group! {
    /// Examine, convert and refine polygon meshes, and bake maps for them.
    #[command(long_about = long_about())]
    Info: info::Arguments,
    Convert: convert::Arguments,
    Subdivide: subdivide::Arguments,
    Bake: bake::Arguments,
}

/// With the formats of the files.
fn long_about() -> String {
    let named = |format: Format| {
        let endings = format.endings().join(", .");
        format!("{} (.{endings})", format.name())
    };
    format!(
        "Examine, convert and refine polygon meshes, and bake maps for them.\n\nFiles may be {}; the \
         ending of the name says which.",
        listed(Format::ALL.map(named))
    )
}
