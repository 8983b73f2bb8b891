//! `nullcone mesh convert`: a mesh in another format.

use std::path::{Path, PathBuf};

use anyhow::{Result, bail};
use ga_mesh::format::{self, Options};
use ga_mesh::ply::Encoding;

use super::input;
use crate::files::Files;
use crate::format::Format;
use crate::{mesh_file, output};

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
        output: out,
        ascii,
        force,
    } = arguments;
    let formats = [Format::Glb, Format::Gltf, Format::Obj, Format::Ply];
    let format = Files::reading([input]).write("OUT", out, &formats)?;
    let (mesh, _) = input::read(input, quiet)?;
    let mesh = format::relocated(&mesh, input, out)?;
    let options = Options {
        ply: if *ascii {
            Encoding::Ascii
        } else {
            Encoding::default()
        },
    };
    let files = mesh_file::files(out, format, &mesh, &options)?;
    if !force {
        for (path, contents) in files.iter().skip(1) {
            refuse_other_contents(path, contents)?;
        }
    }
    output::write_together(files.iter().map(|(path, contents)| (path, contents)))?;
    if !quiet {
        let omissions = match format {
            Format::Obj => format::omissions("model.obj", &mesh)?,
            _ => Vec::new(),
        };
        for omission in omissions {
            eprintln!("warning: {}: {omission}", out.display());
        }
        let lines = files
            .iter()
            .map(|(path, _)| format!("wrote {}\n", path.display()));
        output::print(&lines.collect::<String>())?;
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
