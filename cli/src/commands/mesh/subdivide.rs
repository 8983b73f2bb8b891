//! `nullcone mesh subdivide`: a smooth surface from a coarse mesh.

use std::path::PathBuf;

use anyhow::{Error, Result, ensure};
use clap::ValueEnum;
use ga_mesh::format::{self, Format as MeshFormat, Options};
use ga_mesh::subdivision::{Boundary, CreaseMethod, Rules, Scheme, TagText, subdivide};
use ga_mesh::{Mesh, MeshError};
use serde::Serialize;

use crate::frame::{self, Command, Context, Warning};
use crate::mesh_file::{self, Written};

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
    /// The file to be written: .obj, .ply, .glb or .gltf. Materials of .obj go into a file of the
    /// same name ending in .mtl beside it; a file of that name that is there already is replaced.
    #[arg(long, value_name = "OUT")]
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
    #[serde(flatten)]
    mesh: Written,
    #[serde(skip)]
    warnings: Vec<Warning>,
}

impl Command for Arguments {
    type Report = Report;

    fn run(&self, context: &Context) -> Result<Report> {
        let arguments = self;
        let Self { input, out, .. } = arguments;
        let inputs = [input].into_iter().chain(&arguments.creases);
        let format =
            context
                .files(inputs)?
                .write("--out", out, &mesh_file::all_formats(MeshFormat::Obj))?;
        let progress = context.progress(3);
        progress.step("reading");
        let (mesh, warnings) = mesh_file::read(input)?;
        let tags = match &arguments.creases {
            Some(path) => ga_files::read(path, TagText::decode)?,
            None => TagText::default(),
        };

        let mesh = &format::relocated(&mesh, input, out)?;
        let rules = rules(arguments, mesh);
        let levels = arguments.levels;
        let faces = rules.scheme.refined_face_count(mesh.faces(), levels);
        ensure!(
            faces <= MOST_FACES,
            "--levels {levels} would give {faces} faces, more than {MOST_FACES}"
        );
        let scheme = match rules.scheme {
            Scheme::Loop => "loop",
            Scheme::CatmullClark => "catmull-clark",
        };
        progress.step("subdividing");
        let fine = subdivide(mesh, levels, rules, &tags.tags);
        let fine = fine.map_err(|error| located(error, arguments, &tags))?;

        progress.step("writing");
        let files = mesh_file::files(out, format, &fine, &Options::default())?;
        mesh_file::check_parts("--out", &[input], &files[1..])?;
        let written = mesh_file::write(&fine, &files, context.outputs())?;
        drop(progress);
        Ok(Report {
            scheme,
            levels,
            mesh: written,
            warnings,
        })
    }
}

impl frame::Report for Report {
    fn text(&self) -> String {
        let Written {
            vertices,
            faces,
            files,
        } = &self.mesh;
        let out = files.first().map_or("", String::as_str);
        format!("wrote {out}: {vertices} vertices, {faces} faces\n")
    }

    fn warnings(&self) -> Option<&[Warning]> {
        Some(&self.warnings)
    }
}

fn rules(arguments: &Arguments, mesh: &Mesh) -> Rules {
    let scheme = match arguments.scheme {
        Some(SchemeName::Loop) => Scheme::Loop,
        Some(SchemeName::CatmullClark) => Scheme::CatmullClark,
        None => Scheme::of_faces(mesh.faces()),
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

/// An error with the file it comes from, and the line where that is known.
fn located(error: MeshError, arguments: &Arguments, tags: &TagText) -> Error {
    let place = match (tags.line_of(&error), &arguments.creases) {
        (Some(line), Some(path)) => format!("{}: line {line}", path.display()),
        _ => arguments.input.display().to_string(),
    };
    Error::new(error).context(place)
}
