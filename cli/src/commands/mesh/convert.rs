//! `nullcone mesh convert`: a mesh in another format.

use std::path::PathBuf;

use anyhow::Result;
use ga_mesh::format::{self, Options};
use ga_mesh::ply::Encoding;

use crate::output::print;

/// Write a mesh in the format that the ending of the output's name says.
///
/// What both formats have is kept: positions, polygons, normals, texture coordinates, colours of
/// vertices, and, between formats that have them, groups, objects and materials. The documentation
/// of ga-mesh says for each format what it cannot hold. Paths of pictures are written relative to
/// the output.
///
/// For instance
///
///   nullcone mesh convert scan.ply scan.obj
#[derive(Clone, Debug, clap::Args)]
#[command(verbatim_doc_comment)]
pub(crate) struct Arguments {
    /// The mesh to be read.
    #[arg(value_name = "IN")]
    input: PathBuf,
    /// The file to be written.
    #[arg(value_name = "OUT")]
    output: PathBuf,
    /// Write PLY as text instead of binary.
    #[arg(long)]
    ascii: bool,
}

pub(crate) fn run(arguments: &Arguments, quiet: bool) -> Result<()> {
    let Arguments {
        input,
        output,
        ascii,
    } = arguments;
    // An unknown ending is reported before a large file is read.
    format::Format::of_path(output)?;
    let loaded = super::read(input, quiet)?;
    let mesh = format::relocated(&loaded.mesh, input, output)?;
    let options = Options {
        ply: if *ascii {
            Encoding::Ascii
        } else {
            Encoding::default()
        },
    };
    format::write(output, &mesh, &options)?;
    if !quiet {
        print(&format!("wrote {}\n", output.display()))?;
    }
    Ok(())
}
