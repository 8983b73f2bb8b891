//! `nullcone mesh info`: what a mesh consists of, and whether it is a regular surface.

use std::fmt::Display;
use std::path::PathBuf;

use anyhow::Result;
use ga_mesh::{Fault, Summary};
use serde::Serialize;

use crate::frame::{self, Check, Command, Context, Verdict, Warning};
use crate::mesh_file;

/// Count the elements of a mesh and say whether it is a regular surface.
///
/// For instance
///
///   nullcone mesh info bunny.obj --json
///
/// prints {"vertices": 35947, "faces": 69451, "edges": 104288, "components": 1,
/// "euler_characteristic": -3, "boundary_edges": 223, "non_manifold_edges": 0, …}. The Euler
/// characteristic counts only vertices that faces use. An edge belongs to the boundary when one
/// face has it, and is not manifold when more than two have it. Degenerate faces name a vertex
/// twice or have no area; keyhole faces name vertices twice only since they run along an edge to a
/// hole and back, and are regular; concave faces have an angle of more than 180 degrees inside; the
/// corners of non-planar faces do not lie in a plane. Duplicate vertices lie at the very place of
/// an earlier one.
///
/// The verdict is good where the mesh is manifold and oriented, without degenerate faces, its file
/// keeps to the format, and nothing that the file refers to is missing; else it is doubtful, and
/// --json has the reasons as "warnings". A mesh with a boundary may be good.
#[derive(Clone, Debug, clap::Args)]
#[command(verbatim_doc_comment)]
pub(crate) struct Arguments {
    /// The mesh.
    #[arg(value_name = "FILE")]
    file: PathBuf,
    #[command(flatten)]
    check: Check,
}

impl Command for Arguments {
    type Report = Info;

    fn run(&self, context: &Context) -> Result<Info> {
        context.files([&self.file])?;
        let (mesh, mut warnings) = mesh_file::read(&self.file)?;
        let summary = Summary::of_mesh(&mesh);
        warnings.extend(summary.faults().into_iter().map(|fault| {
            let kind = match fault {
                Fault::NotManifold { .. } => "not_manifold",
                Fault::NotOriented { .. } => "not_oriented",
                Fault::Degenerate { .. } => "degenerate_faces",
            };
            Warning::new(kind, fault).in_file(&self.file)
        }));
        Ok(Info { summary, warnings })
    }

    fn is_check(&self) -> bool {
        self.check.check
    }
}

/// What is said about a mesh.
#[derive(Debug, Serialize)]
pub(crate) struct Info {
    #[serde(flatten)]
    summary: Summary,
    #[serde(skip)]
    warnings: Vec<Warning>,
}

impl frame::Report for Info {
    fn verdict(&self) -> Option<Verdict> {
        Some(Verdict::of(&self.warnings))
    }

    fn is_result(&self) -> bool {
        true
    }

    fn warnings(&self) -> Option<&[Warning]> {
        Some(&self.warnings)
    }

    /// A line for each number, the sets of faces below.
    fn text(&self) -> String {
        let of = &self.summary;
        let yes = |holds: bool| if holds { "yes" } else { "no" };
        let genus = of
            .genus
            .map_or("undefined".to_owned(), |genus| genus.to_string());
        let numbers: [(&str, &dyn Display); 30] = [
            ("vertices", &of.vertices),
            ("faces", &of.faces),
            ("  triangles", &of.triangles),
            ("  quadrilaterals", &of.quadrilaterals),
            ("  larger polygons", &of.larger_polygons),
            ("edges", &of.edges),
            ("components", &of.components),
            ("Euler characteristic", &of.euler_characteristic),
            ("genus", &genus),
            ("boundary edges", &of.boundary_edges),
            ("boundary loops", &of.boundary_loops),
            ("non-manifold edges", &of.non_manifold_edges),
            ("non-manifold vertices", &of.non_manifold_vertices),
            ("inconsistent edges", &of.inconsistent_edges),
            ("manifold", &yes(of.manifold)),
            ("oriented", &yes(of.oriented)),
            ("closed", &yes(of.closed)),
            ("unreferenced vertices", &of.unreferenced_vertices),
            ("duplicate vertices", &of.duplicate_vertices),
            ("degenerate faces", &of.degenerate_faces),
            ("keyhole faces", &of.keyhole_faces),
            ("concave faces", &of.concave_faces),
            ("non-planar faces", &of.non_planar_faces),
            ("duplicate faces", &of.duplicate_faces),
            ("texture coordinates", &of.texture_coordinates),
            ("normals", &of.normals),
            ("tangents", &of.tangents),
            ("vertex colours", &yes(of.vertex_colours)),
            ("polylines", &of.polylines),
            ("points", &of.points),
        ];
        let numbers = numbers.map(|(name, value)| (name, value.to_string()));
        let bounds = of.bounds.iter().flat_map(|bounds| {
            [
                ("least coordinates", format!("{:?}", bounds.min)),
                ("greatest coordinates", format!("{:?}", bounds.max)),
            ]
        });
        let sets = [
            ("group", &of.groups),
            ("object", &of.objects),
            ("material", &of.materials),
        ];
        let sets = sets.into_iter().flat_map(|(kind, sets)| {
            let faces = sets.iter();
            faces.map(move |set| (kind, format!("{}, {} faces", set.name, set.faces)))
        });
        let lines = numbers.into_iter().chain(bounds).chain(sets);
        let lines = lines.map(|(name, value)| format!("{name:<24}{value}\n"));
        lines.collect()
    }
}
