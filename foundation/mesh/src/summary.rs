//! What a mesh consists of, in numbers.

use std::fmt;

use serde::Serialize;

use crate::topology::Report;
use crate::{Group, Mesh};

/// How many elements of each kind a mesh has, and whether it is a regular surface; see [`Report`]
/// for what irregular elements are.
///
/// ```
/// use ga_mesh::Summary;
///
/// let square = ga_mesh::obj::decode(b"v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\n")?;
/// let summary = Summary::of_mesh(&square);
/// assert_eq!((summary.edges, summary.boundary_loops), (4, 1));
/// assert_eq!((summary.triangles, summary.quadrilaterals), (0, 1));
/// assert_eq!(summary.faults(), []);
/// # Ok::<(), ga_mesh::FormatError>(())
/// ```
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Summary {
    /// Vertices, those without a face included.
    pub vertices: usize,
    /// Faces.
    pub faces: usize,
    /// Edges.
    pub edges: usize,
    /// Connected components.
    pub components: usize,
    /// V − E + F, with the vertices that faces use.
    pub euler_characteristic: i64,
    /// Edges with one face.
    pub boundary_edges: usize,
    /// Edges with more than two faces.
    pub non_manifold_edges: usize,
    /// Closed chains of boundary edges.
    pub boundary_loops: usize,
    /// Vertices around which the faces form more than one fan.
    pub non_manifold_vertices: usize,
    /// Edges at which the two faces have opposite orientations.
    pub inconsistent_edges: usize,
    /// Whether the mesh is a manifold, perhaps with a boundary.
    pub manifold: bool,
    /// Whether all neighbouring faces are oriented alike.
    pub oriented: bool,
    /// Whether they can be oriented alike.
    pub orientable: bool,
    /// Whether the mesh encloses a volume.
    pub closed: bool,
    /// The number of handles, of an orientable manifold.
    pub genus: Option<u64>,
    /// Vertices that no face uses.
    pub unreferenced_vertices: usize,
    /// Vertices at the very place of an earlier one.
    pub duplicate_vertices: usize,
    /// Faces that name a vertex twice without a keyhole, or have no area.
    pub degenerate_faces: usize,
    /// Faces with a hole to which an edge leads, along which they run there and back.
    pub keyhole_faces: usize,
    /// Faces with an angle of more than 180° inside.
    pub concave_faces: usize,
    /// Faces whose corners do not lie in a plane.
    pub non_planar_faces: usize,
    /// Faces with the vertices of an earlier one.
    pub duplicate_faces: usize,
    /// Faces with three corners.
    pub triangles: usize,
    /// Faces with four corners.
    pub quadrilaterals: usize,
    /// Faces with more corners.
    pub larger_polygons: usize,
    /// Corners of all faces.
    pub corners: usize,
    /// Texture coordinates of the first set.
    pub texture_coordinates: usize,
    /// Normals.
    pub normals: usize,
    /// Tangents.
    pub tangents: usize,
    /// Whether vertices have colours.
    pub vertex_colours: bool,
    /// Polylines.
    pub polylines: usize,
    /// Points that are elements of their own.
    pub points: usize,
    /// The least and the greatest coordinates; `None` without a vertex.
    pub bounds: Option<Bounds>,
    /// The groups of faces.
    pub groups: Vec<NamedFaces>,
    /// The objects.
    pub objects: Vec<NamedFaces>,
    /// The materials.
    pub materials: Vec<NamedFaces>,
}

/// The least and the greatest coordinates of a mesh, in its unit.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Bounds {
    /// The least coordinates.
    pub min: [f64; 3],
    /// The greatest coordinates.
    pub max: [f64; 3],
}

/// How many faces a group, an object or a material has.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct NamedFaces {
    /// The name of the set.
    pub name: String,
    /// How many faces it has.
    pub faces: usize,
}

/// Why a mesh is not a regular surface.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Fault {
    /// Somewhere the mesh does not look like a plane or a half plane.
    NotManifold {
        /// At how many edges.
        edges: usize,
        /// At how many vertices.
        vertices: usize,
    },
    /// Neighbouring faces have opposite orientations.
    NotOriented {
        /// At how many edges.
        edges: usize,
    },
    /// There are degenerate faces.
    Degenerate {
        /// How many.
        faces: usize,
    },
}

impl fmt::Display for Fault {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::NotManifold { edges, vertices } => write!(
                f,
                "the surface is not manifold at {} and {}",
                counted(*edges, ["edge", "edges"]),
                counted(*vertices, ["vertex", "vertices"])
            ),
            Self::NotOriented { edges } => write!(
                f,
                "the faces at {} have opposite orientations",
                counted(*edges, ["edge", "edges"])
            ),
            Self::Degenerate { faces } => write!(
                f,
                "{} degenerate",
                counted(*faces, ["face is", "faces are"])
            ),
        }
    }
}

/// A number with what is counted, of which there is one or are several.
fn counted(count: usize, [one, several]: [&str; 2]) -> String {
    format!("{count} {}", if count == 1 { one } else { several })
}

impl Summary {
    /// Examines a mesh.
    #[must_use]
    pub fn of_mesh(mesh: &Mesh) -> Self {
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
            keyhole_faces: report.keyhole_faces.len(),
            concave_faces: report.concave_faces.len(),
            non_planar_faces: report.non_planar_faces.len(),
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
            groups: mesh.groups().iter().map(named).collect(),
            objects: mesh.objects().iter().map(named).collect(),
            materials: materials(mesh),
        }
    }

    /// Why the mesh is not a regular surface; empty where it is one. A boundary is no fault.
    #[must_use]
    pub fn faults(&self) -> Vec<Fault> {
        let faults = [
            (!self.manifold).then_some(Fault::NotManifold {
                edges: self.non_manifold_edges,
                vertices: self.non_manifold_vertices,
            }),
            (!self.oriented).then_some(Fault::NotOriented {
                edges: self.inconsistent_edges,
            }),
            (self.degenerate_faces > 0).then_some(Fault::Degenerate {
                faces: self.degenerate_faces,
            }),
        ];
        faults.into_iter().flatten().collect()
    }
}

fn named(group: &Group) -> NamedFaces {
    NamedFaces {
        name: group.name.clone(),
        faces: group.faces.len(),
    }
}

fn materials(mesh: &Mesh) -> Vec<NamedFaces> {
    let mut faces = vec![0; mesh.materials().len()];
    for material in mesh.face_materials().iter().flatten() {
        faces[*material as usize] += 1;
    }
    let materials = mesh.materials().iter().zip(faces);
    let named = materials.map(|(material, faces)| NamedFaces {
        name: material.name.clone(),
        faces,
    });
    named.collect()
}
