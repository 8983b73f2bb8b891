//! What is lost where something is written in another format.

use std::fmt;

use crate::{AlphaMode, Material, Mesh};

/// Parts of one kind that a format cannot hold.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Omission {
    /// What they are, as `skins`.
    pub what: &'static str,
    /// What one of them is, as `skin`.
    pub one: &'static str,
    /// How many there are.
    pub count: usize,
    /// Their names, where that says more than their number.
    pub names: Vec<String>,
    /// What becomes of them.
    pub fate: &'static str,
}

/// What becomes of most that a format cannot hold.
const LEFT_OUT: &str = "left out";

impl Omission {
    /// Parts that are left out; `None` where there are none.
    pub(crate) fn new(what: &'static str, one: &'static str, count: usize) -> Option<Self> {
        (count > 0).then(|| Self {
            what,
            one,
            count,
            names: Vec::new(),
            fate: LEFT_OUT,
        })
    }
}

impl fmt::Display for Omission {
    /// As in `2 skins are left out`.
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        let (words, verb) = match self.count {
            1 => (self.one, "is"),
            _ => (self.what, "are"),
        };
        write!(f, "{} {words}", self.count)?;
        if !self.names.is_empty() {
            write!(f, " ({})", self.names.join(", "))?;
        }
        write!(f, " {verb} {}", self.fate)
    }
}

/// What OBJ cannot hold of a mesh.
pub(crate) fn of_obj(mesh: &Mesh) -> Vec<Omission> {
    let textures = || mesh.materials().iter().flat_map(Material::textures);
    let opacity = mesh.colours().into_iter().flatten();
    let properties = mesh.materials().iter().map(properties_beyond_mtl);
    [
        further_sets(mesh),
        tangents(mesh),
        Omission::new(
            "opacities of vertices",
            "opacity of a vertex",
            opacity.filter(|colour| colour[3] != 1.0).count(),
        ),
        Omission::new(
            "occlusion textures",
            "occlusion texture",
            mesh.materials()
                .iter()
                .filter(|material| material.occlusion_texture.is_some())
                .count(),
        ),
        Omission::new(
            "rotated textures",
            "rotated texture",
            textures().filter(|texture| texture.rotation != 0.0).count(),
        ),
        Omission::new(
            "textures with further texture coordinates",
            "texture with further texture coordinates",
            textures().filter(|texture| texture.set != 0).count(),
        ),
        Omission::new(
            "alpha modes and double sides of materials",
            "alpha mode or double side of a material",
            properties.sum(),
        ),
    ]
    .into_iter()
    .flatten()
    .collect()
}

/// What PLY cannot hold of a mesh.
pub(crate) fn of_ply(mesh: &Mesh) -> Vec<Omission> {
    let materials = mesh.materials();
    let textures = materials.iter().flat_map(Material::textures);
    // The points of a file without faces and edges are its vertices.
    let is_cloud = mesh.faces().is_empty() && mesh.polylines().is_empty();
    let points = if is_cloud { 0 } else { mesh.points().len() };
    [
        Omission::new("materials", "material", materials.len()),
        Omission::new(
            "textures of materials",
            "texture of a material",
            textures.count(),
        ),
        Omission::new("groups", "group", mesh.groups().len()),
        Omission::new("objects", "object", mesh.objects().len()),
        further_sets(mesh),
        tangents(mesh),
        Omission::new("points", "point", points),
        split_normals(mesh),
    ]
    .into_iter()
    .flatten()
    .collect()
}

/// What glTF cannot hold of a mesh.
pub(crate) fn of_gltf(mesh: &Mesh) -> Vec<Omission> {
    let faces = mesh.faces();
    let polygons = (0..faces.len()).filter(|&face| faces.corner_range(face).len() > 3);
    let phong = mesh.materials().iter().filter(|m| m.phong.is_some());
    let tangents = tangents(mesh).filter(|_| mesh.normals().is_none());
    [
        Omission::new(
            "polygons with more than three corners",
            "polygon with more than three corners",
            polygons.count(),
        )
        .map(|omission| Omission {
            fate: "split into triangles",
            ..omission
        }),
        Omission::new("groups", "group", mesh.groups().len()),
        Omission::new(
            "vertices without a face, line or point",
            "vertex without a face, line or point",
            unused_vertices(mesh),
        ),
        tangents,
        Omission::new(
            "terms of Phong's model",
            "term of Phong's model",
            phong.map(terms_of_phong).sum(),
        ),
    ]
    .into_iter()
    .flatten()
    .collect()
}

fn further_sets(mesh: &Mesh) -> Option<Omission> {
    let sets = mesh.texture_coordinate_sets().len();
    Omission::new(
        "further sets of texture coordinates",
        "further set of texture coordinates",
        sets.saturating_sub(1),
    )
}

fn tangents(mesh: &Mesh) -> Option<Omission> {
    let count = mesh.tangents().map_or(0, |tangents| tangents.values.len());
    Omission::new("tangents", "tangent", count)
}

/// How many properties of a material MTL has no place for.
fn properties_beyond_mtl(material: &Material) -> usize {
    let is_cut = matches!(material.alpha_mode, AlphaMode::Mask { .. });
    usize::from(is_cut) + usize::from(material.double_sided)
}

/// How many terms of a material's model of Phong have no counterpart in glTF.
fn terms_of_phong(material: &Material) -> usize {
    let Some(phong) = &material.phong else {
        return 0;
    };
    let of_rest = Material {
        phong: None,
        ..material.clone()
    }
    .to_phong();
    let textures = [
        &phong.ambient_texture,
        &phong.specular_texture,
        &phong.exponent_texture,
        &phong.opacity_texture,
        &phong.bump_texture,
    ];
    // A term that the file does not say is black.
    let differs = |own: [f64; 3], of_rest: [f64; 3]| own != [0.0; 3] && own != of_rest;
    textures.into_iter().flatten().count()
        + usize::from(differs(phong.ambient, of_rest.ambient))
        + usize::from(differs(phong.specular, of_rest.specular))
        + usize::from(phong.refraction.is_some())
}

fn unused_vertices(mesh: &Mesh) -> usize {
    let mut is_used = vec![false; mesh.vertex_count()];
    let lines = mesh.polylines().iter().flatten();
    let used = mesh.faces().corners().iter().chain(lines);
    for &vertex in used.chain(mesh.points()) {
        is_used[vertex as usize] = true;
    }
    is_used.into_iter().filter(|is_used| !is_used).count()
}

/// The normals of a mesh with vertices that have several.
fn split_normals(mesh: &Mesh) -> Option<Omission> {
    let normals = mesh.normals()?;
    let mut first = vec![None; mesh.vertex_count()];
    let mut corners = mesh.faces().corners().iter().enumerate();
    let differs = corners.any(|(corner, &vertex)| {
        let normal = normals.get(corner).map(|normal| normal.coordinates());
        *first[vertex as usize].get_or_insert(normal) != normal
    });
    let count = if differs { normals.values.len() } else { 0 };
    Omission::new(
        "normals that differ at a vertex",
        "normal that differs at a vertex",
        count,
    )
}
