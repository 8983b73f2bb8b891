//! `nullcone mesh convert`: a mesh in another format.

use std::path::{Path, PathBuf};

use anyhow::{Result, bail};
use ga_mesh::format::{self, Options};
use ga_mesh::ply::Encoding;

use super::input;
use crate::output::print;

/// Write a mesh in the format that the ending of the output's name says.
///
/// What both formats have is kept: positions, polygons, normals, texture coordinates, colours of
/// vertices, and, between formats that have them, groups, objects and materials. The documentation
/// of ga-mesh says for each format what it cannot hold. Paths of pictures are written relative to
/// the output.
///
/// Some formats need files beside the output, named after it: libraries of materials (.mtl),
/// buffers (.bin) and pictures. A file of such a name with other contents is not replaced without
/// --force.
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
    /// Replace files beside the output that have other contents.
    #[arg(long)]
    force: bool,
}

pub(crate) fn run(arguments: &Arguments, quiet: bool) -> Result<()> {
    let Arguments {
        input,
        output,
        ascii,
        force,
    } = arguments;
    // An unknown ending is reported before a large file is read.
    format::Format::of_path(output)?;
    let loaded = input::read(input, quiet)?;
    let mesh = format::relocated(&loaded.mesh, input, output)?;
    let options = Options {
        ply: if *ascii {
            Encoding::Ascii
        } else {
            Encoding::default()
        },
    };
    let files = format::to_files(output, &mesh, &options)?;
    if !force {
        for (path, contents) in files.iter().skip(1) {
            refuse_other_contents(path, contents)?;
        }
    }
    format::write(output, &mesh, &options)?;
    if !quiet {
        for omission in format::omissions(output, &mesh)? {
            eprintln!("warning: {}: {omission}", output.display());
        }
        let lines = files
            .iter()
            .map(|(path, _)| format!("wrote {}\n", path.display()));
        print(&lines.collect::<String>())?;
    }
    Ok(())
}

/// Fails where there is a file with other contents.
fn refuse_other_contents(path: &Path, contents: &[u8]) -> Result<()> {
    match std::fs::read(path) {
        Ok(found) if found == contents => Ok(()),
        Err(error) if error.kind() == std::io::ErrorKind::NotFound => Ok(()),
        _ => bail!(
            "{} exists with other contents; choose another name for the output, or replace it with \
             --force",
            path.display()
        ),
    }
}
