//! `nullcone mesh convert`: a mesh in another format.

use std::path::{Path, PathBuf};

use anyhow::{Result, bail};
use ga_mesh::format::{self, Options};
use ga_mesh::ply::Encoding;

use serde::Serialize;

use crate::format::Format;
use crate::frame::{self, Command, Context, Warning};
use crate::mesh_file::{self, Written};

/// Write a mesh in the format that the ending of the output's name says.
///
/// What both formats have is kept: positions, polygons, normals, texture coordinates, colours of
/// vertices, and, between formats that have them, groups, objects and materials. The documentation
/// of ga-mesh says for each format what it cannot hold. Paths of pictures are written relative to
/// the output.
///
/// Some formats need files beside the output, named after it: libraries of materials (.mtl),
/// buffers (.bin) and pictures. A file of such a name with other contents is not replaced without
/// --force. --json prints {"vertices": …, "faces": …, "files": […], "warnings": […]}.
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

/// What is printed.
#[derive(Serialize)]
pub(crate) struct Report {
    #[serde(flatten)]
    mesh: Written,
    #[serde(skip)]
    warnings: Vec<Warning>,
}

impl Command for Arguments {
    type Report = Report;

    fn run(&self, context: &Context) -> Result<Report> {
        let (input, out) = (&self.input, &self.output);
        let formats = mesh_file::formats(|_| true);
        let format = context.files([input])?.write("OUT", out, &formats)?;
        let (mesh, mut warnings) = mesh_file::read(input)?;
        let mesh = format::relocated(&mesh, input, out)?;
        let options = Options {
            ply: match self.ascii {
                true => Encoding::Ascii,
                false => Encoding::default(),
            },
        };
        let files = mesh_file::files(out, format, &mesh, &options)?;
        mesh_file::check_parts("OUT", &[input], &files[1..])?;
        if !self.force {
            for (path, contents) in files.iter().skip(1) {
                refuse_other_contents(path, contents)?;
            }
        }
        let written = mesh_file::write(&mesh, &files)?;
        if let Format::Mesh(format) = format {
            let omissions = format.omissions(&mesh).into_iter();
            warnings.extend(omissions.map(|text| Warning::new("omission", text).in_file(out)));
        }
        Ok(Report {
            mesh: written,
            warnings,
        })
    }
}

impl frame::Report for Report {
    fn text(&self) -> String {
        let lines = self.mesh.files.iter().map(|file| format!("wrote {file}\n"));
        lines.collect()
    }

    fn warnings(&self) -> Option<&[Warning]> {
        Some(&self.warnings)
    }
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
