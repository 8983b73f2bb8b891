//! `nullcone mesh convert`: a mesh in another format.

use std::path::{Path, PathBuf};

use anyhow::{Result, bail};
use ga_mesh::format::{self, Options};
use ga_mesh::gltf::{self, Document};
use ga_mesh::ply::Encoding;
use ga_mesh::{Mesh, Omission};
use serde::Serialize;

use crate::format::Format;
use crate::frame::{self, Command, Context, Warning};
use crate::mesh_file::{self, Written};

/// Write a mesh in the format that the ending of the output's name says.
///
/// What both formats have is kept: positions, polygons, normals, texture coordinates, colours of
/// vertices, and, between formats that have them, groups, objects and materials. From glTF to glTF
/// everything is kept: nodes, skins, animations, morph targets, cameras, lights, extras,
/// extensions, and the types of numbers. Another format holds the shown scene as it stands.
/// Warnings list what the format of the output cannot hold, one for each kind with its number:
/// "what" and "count" in --json, as in {"kind": "omission", "what": "skins", "count": 1, "message":
/// …}. Paths of pictures are written relative to the output.
///
/// glTF that is compressed by KHR_draco_mesh_compression is read; to glTF it is written as it is.
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
        let contents = Contents::read(input, out, format)?;
        let files = mesh_file::files_at(out, format, |path| contents.files(path, self.ascii))?;
        mesh_file::check_parts("OUT", &[input], &files[1..])?;
        if !self.force {
            for (path, contents) in files.iter().skip(1) {
                refuse_other_contents(path, contents)?;
            }
        }
        let mut warnings = contents.warnings;
        let omissions = contents.omissions.iter();
        warnings.extend(
            omissions.map(|(omission, name)| Warning::of_omission(omission, name).in_file(out)),
        );
        let counts = contents.shape.counts();
        Ok(Report {
            mesh: mesh_file::write_counted(counts, &files, context.outputs())?,
            warnings,
        })
    }
}

/// What is converted.
struct Contents {
    shape: Shape,
    warnings: Vec<Warning>,
    /// What is lost, with the format that cannot hold it.
    omissions: Vec<(Omission, &'static str)>,
}

/// A mesh, or a whole document where both files are glTF.
enum Shape {
    Mesh(Box<Mesh>),
    Document(Box<Document>),
}

impl Contents {
    /// Reads a file that is to be written to another in this format.
    fn read(input: &Path, out: &Path, format: Format) -> Result<Self> {
        let (from, Format::Mesh(to)) = (format::Format::of_path(input)?, format) else {
            bail!("{}: it is no format of meshes", out.display());
        };
        let read_document = || -> Result<Document> { Ok(gltf::read(input)?) };
        if from == format::Format::Gltf && to == from {
            let document = read_document()?.relocated(input, out)?;
            return Ok(Self {
                shape: Shape::Document(Box::new(document)),
                warnings: Vec::new(),
                omissions: Vec::new(),
            });
        }
        let (mesh, warnings) = mesh_file::read(input)?;
        let mut omissions = to.omissions(&mesh);
        if from == format::Format::Gltf {
            omissions.splice(0..0, read_document()?.omissions());
        }
        let mesh = format::relocated(&mesh, input, out)?;
        let omissions = omissions.into_iter().map(|it| (it, to.name()));
        Ok(Self {
            shape: Shape::Mesh(Box::new(mesh)),
            warnings,
            omissions: omissions.collect(),
        })
    }

    fn files(&self, path: &Path, ascii: bool) -> Result<Vec<(PathBuf, Vec<u8>)>> {
        match &self.shape {
            Shape::Mesh(mesh) => {
                let ply = match ascii {
                    true => Encoding::Ascii,
                    false => Encoding::default(),
                };
                Ok(format::encode_files(path, mesh, &Options { ply })?)
            }
            Shape::Document(document) => {
                let files = gltf::path_files(path, document)?.into_iter();
                let files = files.map(|(name, contents)| (path.with_file_name(name), contents));
                Ok(files.collect())
            }
        }
    }
}

impl Shape {
    /// How many vertices and faces there are.
    fn counts(&self) -> [usize; 2] {
        match self {
            Self::Mesh(mesh) => [mesh.vertex_count(), mesh.faces().len()],
            Self::Document(document) => {
                let primitives = document.meshes.iter().flat_map(|mesh| &mesh.primitives);
                let counts = primitives.map(|it| [it.vertex_count(), it.triangles().len()]);
                counts.fold([0, 0], |[vertices, faces], [more, triangles]| {
                    [vertices + more, faces + triangles]
                })
            }
        }
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
