//! `nullcone mesh subdivide`: a smooth surface from a coarse mesh.

use std::path::{Path, PathBuf};

use anyhow::{Result, anyhow, ensure};
use clap::ValueEnum;
use ga_mesh::format::{self, Options};
use ga_mesh::subdivision::{Boundary, CreaseMethod, Rules, Scheme, Subdivision, TagText};
use ga_mesh::{Mesh, MeshError};
use serde::Serialize;

use crate::format::Format;
use crate::frame::{self, Command, Context, Warning};
use crate::{mesh_file, output};

/// A result of more faces than this is taken for a mistake.
const MOST_FACES: u64 = 100_000_000;

/// Refine a mesh into a smooth surface.
///
/// Vertices keep their numbers, and texture coordinates, colours, groups and materials are carried
/// along. Normals of the file are left out.
///
/// TAGS is a text with a line for each sharp edge or vertex:
///
///     crease a b sharpness
///     corner v sharpness
///
/// Vertices are counted from 0, as in the tags of OpenSubdiv's shapes; the first vertex of an OBJ
/// file is therefore 0 here. A sharpness of s keeps an edge or vertex sharp for s levels; 10 or
/// more, and inf, keep it sharp at all levels. What follows a # is ignored.
///
/// --json prints {"scheme": …, "levels": …, "vertices": …, "faces": …, "files": […],
/// "warnings": […]}.
#[derive(Clone, Debug, clap::Args)]
#[command(verbatim_doc_comment)]
pub(crate) struct Arguments {
    /// The mesh to be refined.
    #[arg(value_name = "IN")]
    input: PathBuf,
    /// How many times each face is split: into four, or at first into as many as it has corners.
    #[arg(long, value_name = "N")]
    levels: u32,
    /// Loop's scheme for triangles, or Catmull and Clark's for any polygons [default: loop where
    /// all faces are triangles, catmull-clark otherwise].
    #[arg(long)]
    scheme: Option<SchemeName>,
    /// Sharp edges and vertices.
    #[arg(long, value_name = "TAGS")]
    creases: Option<PathBuf>,
    /// Whether boundary vertices of one face are smooth along the boundary or stay where they are.
    #[arg(long, default_value = "edge-only")]
    boundary: BoundaryName,
    /// Whether sharpness falls by 1 a level, or is also averaged along chains of creases.
    #[arg(long, default_value = "normal")]
    crease_method: CreaseMethodName,
    /// The file to be written. Materials go into a file of the same name ending in .mtl beside it;
    /// a file of that name that is there already is replaced.
    #[arg(long, value_name = "OUT.obj")]
    out: PathBuf,
}

#[derive(Clone, Copy, Debug, ValueEnum)]
enum SchemeName {
    Loop,
    CatmullClark,
}

#[derive(Clone, Copy, Debug, ValueEnum)]
enum BoundaryName {
    EdgeOnly,
    EdgeAndCorner,
}

#[derive(Clone, Copy, Debug, ValueEnum)]
enum CreaseMethodName {
    Normal,
    Chaikin,
}

/// What is printed.
#[derive(Serialize)]
pub(crate) struct Report {
    scheme: &'static str,
    levels: u32,
    vertices: usize,
    faces: usize,
    files: Vec<String>,
    #[serde(skip)]
    warnings: Vec<Warning>,
}

impl Command for Arguments {
    type Report = Report;

    fn run(&self, context: &Context) -> Result<Report> {
        let arguments = self;
        let Self { input, out, .. } = arguments;
        let inputs = [input].into_iter().chain(&arguments.creases);
        let format = context.files(inputs)?.write("--out", out, &[Format::Obj])?;
        let progress = context.progress(3);
        progress.step("reading");
        let (mesh, warnings) = mesh_file::read(input)?;
        let tags = match &arguments.creases {
            Some(path) => ga_files::read(path, TagText::decode)?,
            None => TagText::default(),
        };

        let mesh = &format::relocated(&mesh, input, out)?;
        let rules = rules(arguments, mesh);
        check_size(mesh, rules.scheme, arguments.levels)?;
        let scheme = match rules.scheme {
            Scheme::Loop => "loop",
            Scheme::CatmullClark => "catmull-clark",
        };
        let mut level = Subdivision::new(mesh, rules, &tags.tags)
            .map_err(|error| located(error, input, arguments.creases.as_deref(), &tags))?;
        progress.step("subdividing");
        for _ in 0..arguments.levels {
            level = level.refined()?;
        }
        let fine = level.into_mesh()?;

        progress.step("writing");
        let files = mesh_file::files(out, format, &fine, &Options::default())?;
        mesh_file::check_parts("--out", &[input], &files[1..])?;
        output::write_together(files.iter().map(|(path, contents)| (path, contents)))?;
        drop(progress);
        let files = files.iter().map(|(path, _)| path.display().to_string());
        Ok(Report {
            scheme,
            levels: arguments.levels,
            vertices: fine.vertex_count(),
            faces: fine.faces().len(),
            files: files.collect(),
            warnings,
        })
    }
}

impl frame::Report for Report {
    fn text(&self) -> String {
        let out = self.files.first().map_or("", String::as_str);
        format!(
            "wrote {out}: {} vertices, {} faces\n",
            self.vertices, self.faces
        )
    }

    fn warnings(&self) -> Option<&[Warning]> {
        Some(&self.warnings)
    }
}

fn rules(arguments: &Arguments, mesh: &Mesh) -> Rules {
    let scheme = match arguments.scheme {
        Some(SchemeName::Loop) => Scheme::Loop,
        Some(SchemeName::CatmullClark) => Scheme::CatmullClark,
        None if mesh.faces().iter().all(|face| face.len() == 3) => Scheme::Loop,
        None => Scheme::CatmullClark,
    };
    Rules {
        boundary: match arguments.boundary {
            BoundaryName::EdgeOnly => Boundary::EdgeOnly,
            BoundaryName::EdgeAndCorner => Boundary::EdgeAndCorner,
        },
        creases: match arguments.crease_method {
            CreaseMethodName::Normal => CreaseMethod::Normal,
            CreaseMethodName::Chaikin => CreaseMethod::Chaikin,
        },
        ..Rules::new(scheme)
    }
}

/// Fails before the work where the result would be too large.
fn check_size(mesh: &Mesh, scheme: Scheme, levels: u32) -> Result<()> {
    let faces = match (scheme, levels) {
        (Scheme::CatmullClark, 1..) => {
            let corners = mesh.faces().corners().len() as u64;
            corners.saturating_mul(4_u64.saturating_pow(levels - 1))
        }
        _ => (mesh.faces().len() as u64).saturating_mul(4_u64.saturating_pow(levels)),
    };
    ensure!(
        faces <= MOST_FACES,
        "--levels {levels} would give {faces} faces, more than {MOST_FACES}"
    );
    Ok(())
}

/// An error with the file it comes from, and the line where that is known.
fn located(
    error: MeshError,
    input: &Path,
    creases: Option<&Path>,
    tags: &TagText,
) -> anyhow::Error {
    let line = match error {
        MeshError::NoEdge { crease, .. } => tags.crease_lines.get(crease),
        MeshError::NoVertex { corner, .. } => tags.corner_lines.get(corner),
        _ => None,
    };
    match (line, creases) {
        (Some(line), Some(path)) => {
            anyhow!(error).context(format!("{}: line {line}", path.display()))
        }
        _ => anyhow!(error).context(input.display().to_string()),
    }
}
