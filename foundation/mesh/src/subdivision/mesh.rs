//! Meshes with all that they carry.

use super::{Cage, CornerValues, Rules, Stencils, Tags};
use crate::{CornerAttribute, Group, Mesh, MeshError, Position, Rgba};

/// A mesh refined a number of times; see [`Subdivision`] for what it keeps.
///
/// # Errors
///
/// As [`Cage::new`], [`Cage::with_tags`] and [`Cage::refine`]; [`MeshError::RefinedTooLarge`] is
/// found before any level is computed.
///
/// # Examples
///
/// ```
/// use ga_mesh::subdivision::{Rules, Tags, subdivide};
///
/// let square = ga_mesh::obj::decode(b"v 0 0 0\nv 4 0 0\nv 4 4 0\nv 0 4 0\nf 1 2 3 4\n")?;
/// let fine = subdivide(&square, 2, Rules::CATMULL_CLARK, &Tags::default())?;
/// assert_eq!(fine.faces().len(), 16);
/// assert_eq!(fine.positions()[0].coordinates(), [0.625, 0.625, 0.0]);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn subdivide(mesh: &Mesh, levels: u32, rules: Rules, tags: &Tags) -> Result<Mesh, MeshError> {
    // Either scheme gives a face four times as many corners as it has.
    let corners = mesh.faces().corners().len() as u64;
    let corners = corners.saturating_mul(4_u64.saturating_pow(levels));
    if corners > u64::from(u32::MAX) {
        return Err(MeshError::RefinedTooLarge {
            what: "corners",
            count: corners,
        });
    }
    let mut level = Subdivision::new(mesh, rules, tags)?;
    for _ in 0..levels {
        level = level.refined()?;
    }
    level.into_mesh()
}

/// A mesh at some level of its refinement.
///
/// Vertices keep their numbers, and new ones follow; their colours are refined like positions. Sets
/// of texture coordinates keep their seams and are numbered anew; faces that lack a coordinate at
/// some corner have none at the others either. The faces that take the place of a face have its
/// material and are in its groups and objects. Polylines and points keep their vertices. Normals
/// and tangents are left out, since they belong to the shape as it was; [`Limit`](super::Limit)
/// gives new ones.
#[derive(Clone, Debug)]
pub struct Subdivision<'a> {
    mesh: &'a Mesh,
    levels: u32,
    cage: Cage,
    positions: Vec<Position>,
    colours: Option<Vec<Rgba>>,
    texture: Vec<Option<Texture>>,
}

/// A set of texture coordinates.
#[derive(Clone, Debug)]
struct Texture {
    values: CornerValues,
    coordinates: Vec<[f64; 2]>,
}

impl<'a> Subdivision<'a> {
    /// A mesh before its refinement.
    ///
    /// # Errors
    ///
    /// As [`Cage::new`] and [`Cage::with_tags`].
    pub fn new(mesh: &'a Mesh, rules: Rules, tags: &Tags) -> Result<Self, MeshError> {
        let cage = Cage::new(mesh.faces().clone(), mesh.vertex_count(), rules)?.with_tags(tags)?;
        let mut texture = Vec::new();
        for set in mesh.texture_coordinate_sets() {
            let values = CornerValues::new(&cage, &set.corners)?;
            texture.push(values.map(|values| {
                let sources = values.sources().iter();
                let coordinates = sources.map(|&source| set.values[source as usize]).collect();
                Texture {
                    values,
                    coordinates,
                }
            }));
        }
        Ok(Self {
            mesh,
            levels: 0,
            cage,
            positions: mesh.positions().to_vec(),
            colours: mesh.colours().map(<[_]>::to_vec),
            texture,
        })
    }

    /// The faces at this level.
    #[must_use]
    pub fn cage(&self) -> &Cage {
        &self.cage
    }

    /// The positions at this level.
    #[must_use]
    pub fn positions(&self) -> &[Position] {
        &self.positions
    }

    /// The next level.
    ///
    /// # Errors
    ///
    /// [`MeshError::RefinedTooLarge`].
    pub fn refined(self) -> Result<Self, MeshError> {
        let fine = self.cage.refine()?;
        let mut texture = Vec::new();
        for set in self.texture {
            texture.push(match set {
                Some(set) => {
                    let (values, stencils) = set.values.refine()?;
                    let coordinates = applied(&stencils, &set.coordinates);
                    Some(Texture {
                        values,
                        coordinates,
                    })
                }
                None => None,
            });
        }
        Ok(Self {
            mesh: self.mesh,
            levels: self.levels + 1,
            positions: applied(&fine.stencils, &self.positions),
            colours: self
                .colours
                .map(|colours| applied(&fine.stencils, &colours)),
            texture,
            cage: fine.cage,
        })
    }

    /// The mesh of this level.
    ///
    /// # Errors
    ///
    /// [`MeshError::NotFinite`] where a coordinate overflows.
    pub fn into_mesh(self) -> Result<Mesh, MeshError> {
        let firsts = self.first_descendants();
        let range = |face: u32| firsts[face as usize]..firsts[face as usize + 1];
        let group = |group: &Group| Group {
            name: group.name.clone(),
            faces: group.faces.iter().flat_map(|&face| range(face)).collect(),
        };
        let groups = self.mesh.groups().iter().map(group).collect();
        let objects = self.mesh.objects().iter().map(group).collect();
        let mut materials = Vec::new();
        for (face, &material) in (0..).zip(self.mesh.face_materials()) {
            materials.extend(range(face).map(|_| material));
        }
        let corners = self.cage.faces().corners().len();
        let sets = self.texture.into_iter().map(|set| match set {
            Some(set) => CornerAttribute {
                values: set.coordinates,
                corners: set.values.corners(),
            },
            None => CornerAttribute {
                values: Vec::new(),
                corners: vec![None; corners],
            },
        });
        let mut mesh = Mesh::new(self.positions, self.cage.faces().clone())?
            .with_texture_coordinates(sets.collect())?
            .with_groups(groups)?
            .with_objects(objects)?
            .with_polylines(self.mesh.polylines().clone())?
            .with_points(self.mesh.points().to_vec())?;
        if let Some(colours) = self.colours {
            mesh = mesh.with_colours(colours)?;
        }
        if !self.mesh.materials().is_empty() {
            mesh = mesh.with_materials(self.mesh.materials().to_vec(), materials)?;
        }
        Ok(mesh)
    }

    /// For each face of the mesh before its refinement the first face that takes its place, and the
    /// number of faces.
    fn first_descendants(&self) -> Vec<u32> {
        let scheme = self.cage.rules().scheme;
        let mut firsts = vec![0];
        let mut total = 0;
        for polygon in self.mesh.faces() {
            let mut corners = polygon.len() as u32;
            let mut count = 1;
            for _ in 0..self.levels {
                count *= scheme.children(corners);
                corners = scheme.face_size();
            }
            total += count;
            firsts.push(total);
        }
        firsts
    }
}

/// The stencils and the values are of the same level.
fn applied<V: super::Value>(stencils: &Stencils, values: &[V]) -> Vec<V> {
    stencils
        .applied(values)
        .expect("there are as many values as the cage has vertices")
}
