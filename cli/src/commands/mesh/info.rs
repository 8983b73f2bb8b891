//! `nullcone mesh info`: what a mesh consists of, and whether it is a regular surface.

use std::path::{Path, PathBuf};

use anyhow::Result;
use ga_mesh::topology::Report;
use ga_mesh::{Group, Mesh};
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
/// twice or have no area; duplicate vertices lie at the very place of an earlier one.
///
/// The verdict is good where the mesh is manifold and oriented, without degenerate faces, and
/// nothing that its file refers to is missing; else it is doubtful, and --json has the reasons as
/// "warnings". A mesh with a boundary may be good.
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
        let (mesh, warnings) = mesh_file::read(&self.file)?;
        let mut info = Info::new(&mesh, warnings);
        info.warn(&self.file);
        Ok(info)
    }

    fn is_check(&self) -> bool {
        self.check.check
    }
}

/// What is said about a mesh.
#[derive(Debug, Serialize)]
pub(crate) struct Info {
    vertices: usize,
    faces: usize,
    edges: usize,
    components: usize,
    euler_characteristic: i64,
    boundary_edges: usize,
    non_manifold_edges: usize,
    boundary_loops: usize,
    non_manifold_vertices: usize,
    inconsistent_edges: usize,
    manifold: bool,
    oriented: bool,
    orientable: bool,
    closed: bool,
    genus: Option<u64>,
    unreferenced_vertices: usize,
    duplicate_vertices: usize,
    degenerate_faces: usize,
    duplicate_faces: usize,
    triangles: usize,
    quadrilaterals: usize,
    larger_polygons: usize,
    corners: usize,
    texture_coordinates: usize,
    normals: usize,
    tangents: usize,
    vertex_colours: bool,
    polylines: usize,
    points: usize,
    bounds: Option<Bounds>,
    groups: Vec<Part>,
    objects: Vec<Part>,
    materials: Vec<Part>,
    #[serde(skip)]
    warnings: Vec<Warning>,
}

/// The least and the greatest coordinates, in the unit of the file.
#[derive(Debug, Serialize)]
struct Bounds {
    min: [f64; 3],
    max: [f64; 3],
}

/// A named set of faces, and how many there are.
#[derive(Debug, Serialize)]
struct Part {
    name: String,
    faces: usize,
}

impl Info {
    fn new(mesh: &Mesh, warnings: Vec<Warning>) -> Self {
        let report = Report::of_mesh(mesh);
        let with_corners = |count: usize| mesh.faces().iter().filter(|f| f.len() == count).count();
        let (triangles, quadrilaterals) = (with_corners(3), with_corners(4));
        Self {
            vertices: report.vertices,
            faces: report.faces,
            edges: report.edges,
            components: report.components,
            euler_characteristic: report.euler_characteristic,
            boundary_edges: report.boundary_edges,
            non_manifold_edges: report.non_manifold_edges.len(),
            boundary_loops: report.boundary_loops.len(),
            non_manifold_vertices: report.non_manifold_vertices.len(),
            inconsistent_edges: report.inconsistent_edges.len(),
            manifold: report.is_manifold(),
            oriented: report.is_oriented(),
            orientable: report.orientable,
            closed: report.is_closed(),
            genus: report.genus,
            unreferenced_vertices: report.unreferenced_vertices.len(),
            duplicate_vertices: report.duplicate_vertices.len(),
            degenerate_faces: report.degenerate_faces.len(),
            duplicate_faces: report.duplicate_faces.len(),
            triangles,
            quadrilaterals,
            larger_polygons: report.faces - triangles - quadrilaterals,
            corners: mesh.faces().corners().len(),
            texture_coordinates: mesh.texture_coordinates().map_or(0, |set| set.values.len()),
            normals: mesh.normals().map_or(0, |normals| normals.values.len()),
            tangents: mesh.tangents().map_or(0, |tangents| tangents.values.len()),
            vertex_colours: mesh.colours().is_some(),
            polylines: mesh.polylines().len(),
            points: mesh.points().len(),
            bounds: mesh.bounds().map(|[min, max]| Bounds { min, max }),
            groups: parts(mesh.groups()),
            objects: parts(mesh.objects()),
            materials: materials(mesh),
            warnings,
        }
    }
}

impl Info {
    /// Adds a warning for each reason why the mesh is not a regular surface.
    fn warn(&mut self, file: &Path) {
        let reasons = [
            (
                !self.manifold,
                "not_manifold",
                format!(
                    "the surface is not manifold at {} edges and {} vertices",
                    self.non_manifold_edges, self.non_manifold_vertices
                ),
            ),
            (
                !self.oriented,
                "not_oriented",
                format!(
                    "the faces at {} edges have opposite orientations",
                    self.inconsistent_edges
                ),
            ),
            (
                self.degenerate_faces > 0,
                "degenerate_faces",
                format!("{} faces are degenerate", self.degenerate_faces),
            ),
        ];
        let found = reasons.into_iter().filter(|(is_found, ..)| *is_found);
        let found = found.map(|(_, kind, text)| Warning::new(kind, text).in_file(file));
        self.warnings.extend(found);
    }
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
        let yes = |holds: bool| if holds { "yes" } else { "no" }.to_owned();
        let genus = self
            .genus
            .map_or("undefined".to_owned(), |genus| genus.to_string());
        let mut lines = vec![
            ("vertices", self.vertices.to_string()),
            ("faces", self.faces.to_string()),
            ("  triangles", self.triangles.to_string()),
            ("  quadrilaterals", self.quadrilaterals.to_string()),
            ("  larger polygons", self.larger_polygons.to_string()),
            ("edges", self.edges.to_string()),
            ("components", self.components.to_string()),
            (
                "Euler characteristic",
                self.euler_characteristic.to_string(),
            ),
            ("genus", genus),
            ("boundary edges", self.boundary_edges.to_string()),
            ("boundary loops", self.boundary_loops.to_string()),
            ("non-manifold edges", self.non_manifold_edges.to_string()),
            (
                "non-manifold vertices",
                self.non_manifold_vertices.to_string(),
            ),
            ("inconsistent edges", self.inconsistent_edges.to_string()),
            ("manifold", yes(self.manifold)),
            ("oriented", yes(self.oriented)),
            ("closed", yes(self.closed)),
            (
                "unreferenced vertices",
                self.unreferenced_vertices.to_string(),
            ),
            ("duplicate vertices", self.duplicate_vertices.to_string()),
            ("degenerate faces", self.degenerate_faces.to_string()),
            ("duplicate faces", self.duplicate_faces.to_string()),
            ("texture coordinates", self.texture_coordinates.to_string()),
            ("normals", self.normals.to_string()),
            ("tangents", self.tangents.to_string()),
            ("vertex colours", yes(self.vertex_colours)),
            ("polylines", self.polylines.to_string()),
            ("points", self.points.to_string()),
        ];
        if let Some(Bounds { min, max }) = &self.bounds {
            lines.push(("least coordinates", format!("{min:?}")));
            lines.push(("greatest coordinates", format!("{max:?}")));
        }
        let mut table = String::new();
        for (name, value) in lines {
            table += &format!("{name:<24}{value}\n");
        }
        for (kind, parts) in [
            ("group", &self.groups),
            ("object", &self.objects),
            ("material", &self.materials),
        ] {
            for Part { name, faces } in parts {
                table += &format!("{kind:<24}{name}, {faces} faces\n");
            }
        }
        table
    }
}

fn parts(groups: &[Group]) -> Vec<Part> {
    let parts = groups.iter().map(|group| Part {
        name: group.name.clone(),
        faces: group.faces.len(),
    });
    parts.collect()
}

fn materials(mesh: &Mesh) -> Vec<Part> {
    let mut faces = vec![0; mesh.materials().len()];
    for material in mesh.face_materials().iter().flatten() {
        faces[*material as usize] += 1;
    }
    let materials = mesh.materials().iter().zip(faces);
    materials
        .map(|(material, faces)| Part {
            name: material.name.clone(),
            faces,
        })
        .collect()
}
