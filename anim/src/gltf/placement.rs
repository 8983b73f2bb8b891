use std::collections::HashMap;
use std::ops::Range;

use ga_mesh::Mesh;
use ga_mesh::gltf::{self, Document, Primitive, Vertices};
use ga_runtime::cga3::{Direction, DualPlane, Point};
use ga_runtime::geometry::Affine;
use ga_runtime::vga3::Vector;

use super::player::is_finite;
use super::{NodePose, Player};
use crate::file_error::MotionFileError;
use crate::skin::{Binding, Method, Posed};
use crate::weights::SkinWeights;
use crate::weights::error::SkinError;

/// Places the vertices of all meshes of a document in the world: for each node that has a mesh, in
/// rising index, those of each of its primitives.
///
/// A vertex is first displaced by the morph targets, p + Σ wᵢ dᵢ, and then moved by its joints or,
/// where the node has no skin, by the frame of the node. A joint moves it by the frame of the
/// joint's node after the inverse bind matrix.
///
/// # Examples
///
/// ```
/// use ga_anim::gltf::{Placement, Player};
/// use ga_anim::skin::Method;
/// use ga_mesh::gltf::{Document, Mesh, Node, Primitive, Transform};
///
/// let vertex = Primitive { positions: vec![[1.0, 0.0, 0.0]], ..Primitive::default() };
/// let twice = Transform::Decomposed {
///     translation: [0.0, 5.0, 0.0],
///     rotation: [0.0, 0.0, 0.0, 1.0],
///     scale: [2.0; 3],
/// };
/// let document = Document {
///     nodes: vec![Node { mesh: Some(0), transform: twice, ..Node::default() }],
///     meshes: vec![Mesh { primitives: vec![vertex], ..Mesh::default() }],
///     ..Document::default()
/// };
/// let player = Player::new(&document)?;
/// let placement = Placement::new(&player)?;
/// let placed = placement.place(&player.pose(None, 0.0)?, Method::Linear)?;
/// assert_eq!(placed.positions[0].coordinates(), [2.0, 5.0, 0.0]);
/// # Ok::<(), ga_anim::MotionFileError>(())
/// ```
#[derive(Clone, Debug)]
pub struct Placement<'a> {
    document: &'a Document,
    parts: Vec<Part>,
    /// For each part that has a skin, which of `skinned` is its own.
    bound: Vec<Option<usize>>,
    skinned: Vec<Skinned>,
}

/// The vertices of a primitive with the joints of a skin.
#[derive(Clone, Debug)]
struct Skinned {
    weights: SkinWeights,
    binding: Binding<f64>,
    /// Whether morph targets change the vertices from frame to frame.
    is_morphed: bool,
}

/// The vertices that a node and a primitive of its mesh have in the list of all vertices.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Part {
    /// The node.
    pub node: usize,
    /// The mesh.
    pub mesh: usize,
    /// The primitive of the mesh.
    pub primitive: usize,
    /// Its vertices: as many as its `POSITION` has items.
    pub vertices: Range<usize>,
}

/// The vertices of all meshes in the world.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Placed {
    /// Their places, in the order of [`Placement::parts`].
    pub positions: Vec<Point<f64>>,
    /// For each part the unit normals of its vertices; none where its primitive has none.
    pub normals: Vec<Vec<Vector<f64>>>,
    /// For each part the unit tangents of its vertices; none where its primitive has none.
    pub tangents: Vec<Vec<Vector<f64>>>,
    /// For each part, whether it is mirrored, so that its faces must be reversed.
    pub is_mirrored: Vec<bool>,
}

impl<'a> Placement<'a> {
    /// Lists the vertices and normalises the weights of their joints.
    ///
    /// # Errors
    ///
    /// [`MotionFileError::Weights`], and [`MotionFileError::TooLarge`] where nodes place more than
    /// 16 million vertices and corners of faces, and their meshes more than a thousand times each
    /// on average.
    pub fn new(player: &Player<'a>) -> Result<Self, MotionFileError> {
        let document = player.document();
        check_size(document)?;
        let mut placement = Self {
            document,
            parts: Vec::new(),
            bound: Vec::new(),
            skinned: Vec::new(),
        };
        let mut known = HashMap::new();
        let mut end = 0;
        for (index, node) in document.nodes.iter().enumerate() {
            let Some(mesh) = node.mesh else { continue };
            for (number, primitive) in document.meshes[mesh].primitives.iter().enumerate() {
                let start = end;
                end += primitive.positions.len();
                let skin = node.skin.filter(|_| start < end);
                let bound = match skin.map(|skin| (mesh, number, skin)) {
                    None => None,
                    Some(key) => Some(match known.get(&key) {
                        Some(&skinned) => skinned,
                        None => {
                            let joints = document.skins[key.2].joints.len();
                            placement
                                .skinned
                                .push(Skinned::new(primitive, joints, index, number)?);
                            known.insert(key, placement.skinned.len() - 1);
                            placement.skinned.len() - 1
                        }
                    }),
                };
                placement.bound.push(bound);
                placement.parts.push(Part {
                    node: index,
                    mesh,
                    primitive: number,
                    vertices: start..end,
                });
            }
        }
        Ok(placement)
    }

    /// The parts, in rising order of nodes and primitives.
    #[must_use]
    pub fn parts(&self) -> &[Part] {
        &self.parts
    }

    /// How many vertices all parts have together.
    #[must_use]
    pub fn vertex_count(&self) -> usize {
        self.parts.last().map_or(0, |part| part.vertices.end)
    }

    /// The joints of its skin that move the vertices of a part; `None` where it has no skin.
    #[must_use]
    pub fn weights(&self, part: usize) -> Option<&SkinWeights> {
        let skinned = self.bound.get(part).copied().flatten()?;
        self.skinned.get(skinned).map(|skinned| &skinned.weights)
    }

    /// The places of the vertices in a pose of the same document.
    ///
    /// # Errors
    ///
    /// [`MotionFileError::Singular`], except with [`Method::Linear`];
    /// [`MotionFileError::JointNotFinite`] and [`MotionFileError::VertexNotFinite`];
    /// [`MotionFileError::Skin`] for more pairs of joints than can be counted.
    pub fn place(&self, pose: &NodePose, method: Method) -> Result<Placed, MotionFileError> {
        let mut placed = Placed::default();
        for (part, bound) in self.parts.iter().zip(&self.bound) {
            let node = &self.document.nodes[part.node];
            let primitive = &self.document.meshes[part.mesh].primitives[part.primitive];
            let mut moved = Morphed::new(primitive, pose.weights(part.node));
            let map = match (bound, node.skin) {
                (Some(skinned), Some(skin)) => {
                    let maps = self.maps(skin, pose, method)?;
                    let skinned = &self.skinned[*skinned];
                    skinned.pose(&maps, method, &mut moved)?;
                    let first = skinned.weights.influences(0).first();
                    maps[first.map_or(0, |influence| influence.joint as usize)]
                }
                _ => {
                    let map = pose.world[part.node];
                    moved.transform(map);
                    map
                }
            };
            let is_placed = |point: &Point<f64>| point.coordinates().iter().all(|x| x.is_finite());
            if let Some(vertex) = moved.positions.iter().position(|point| !is_placed(point)) {
                return Err(MotionFileError::VertexNotFinite {
                    node: part.node,
                    primitive: part.primitive,
                    vertex,
                });
            }
            let is_mirrored = map.determinant() < 0.0;
            if is_mirrored {
                // The image of a plane has the other orientation, and so have the faces reversed.
                moved
                    .normals
                    .iter_mut()
                    .for_each(|normal| *normal = -*normal);
            }
            placed.positions.append(&mut moved.positions);
            placed.normals.push(moved.normals);
            placed.tangents.push(moved.tangents);
            placed.is_mirrored.push(is_mirrored);
        }
        Ok(placed)
    }

    /// The placed vertices of the parts of some nodes as a mesh with all that their primitives
    /// have: faces, lines and points, normals, tangents, colours, texture coordinates and
    /// materials. Each node is an object of its name. Vertices keep their order; those of all nodes
    /// keep their number.
    ///
    /// # Errors
    ///
    /// [`MotionFileError::Document`] past 2³² − 1 vertices or corners, and where `placed` is of
    /// another document.
    pub fn mesh(
        &self,
        placed: &Placed,
        is_shown: impl Fn(usize) -> bool,
    ) -> Result<Mesh, MotionFileError> {
        let parts = self.parts.iter().enumerate();
        let shown = parts.filter(|(_, part)| is_shown(part.node));
        let list =
            |lists: &[Vec<Vector<f64>>], index| lists.get(index).cloned().unwrap_or_default();
        let of_parts = shown.map(|(index, part)| {
            let positions = placed.positions.get(part.vertices.clone());
            let positions = positions.unwrap_or_default().iter();
            let of_part = gltf::Placed {
                positions: positions.map(|point| point.coordinates()).collect(),
                normals: list(&placed.normals, index),
                tangents: list(&placed.tangents, index),
                is_mirrored: placed.is_mirrored.get(index).copied().unwrap_or_default(),
            };
            (part.node, part.primitive, of_part)
        });
        Ok(self.document.placed_mesh(of_parts, Vertices::Kept)?)
    }

    /// For each joint of a skin, the map that takes the mesh at rest to the world.
    fn maps(
        &self,
        skin: usize,
        pose: &NodePose,
        method: Method,
    ) -> Result<Vec<Affine<f64>>, MotionFileError> {
        let of_skin = &self.document.skins[skin];
        let mut maps = Vec::with_capacity(of_skin.joints.len());
        for (joint, &node) in of_skin.joints.iter().enumerate() {
            let inverse = of_skin.inverse_bind_matrices.get(joint);
            let map = pose.world[node] * inverse.map_or_else(Affine::default, inverse_bind_map);
            if !is_finite(map) {
                return Err(MotionFileError::JointNotFinite { skin, joint, node });
            }
            if method != Method::Linear && !has_rotation(map) {
                return Err(MotionFileError::Singular { skin, joint, node });
            }
            maps.push(map);
        }
        Ok(maps)
    }
}

impl Skinned {
    /// Binds a primitive, which errors name by its number and the node of its mesh.
    fn new(
        primitive: &Primitive,
        joints: usize,
        node: usize,
        number: usize,
    ) -> Result<Self, MotionFileError> {
        let weights = influences(primitive, joints);
        let weights = weights.map_err(|problem| MotionFileError::Weights {
            node,
            primitive: number,
            problem,
        })?;
        Ok(Self {
            binding: {
                let rest = Morphed::new(primitive, &[]);
                rest.with_directions(Binding::new(&rest.positions, &weights)?)?
            },
            is_morphed: !primitive.targets.is_empty(),
            weights,
        })
    }

    /// Moves the vertices of a frame.
    fn pose(
        &self,
        maps: &[Affine<f64>],
        method: Method,
        moved: &mut Morphed,
    ) -> Result<(), SkinError> {
        let mut palette = self.binding.palette(method);
        palette.set_maps(maps)?;
        if self.is_morphed {
            let mut binding = self.binding.clone();
            binding.set_points(&moved.positions)?;
            let binding = moved.with_directions(binding)?;
            binding.pose(&palette, moved.posed())
        } else {
            self.binding.pose(&palette, moved.posed())
        }
    }
}

/// Whether a map has a rotation nearest to it: it maps space to space or a plane, not to a line or
/// a point.
fn has_rotation(map: Affine<f64>) -> bool {
    const TOLERANCE: f64 = 1e-12;
    let [a, b, c] = map.linear.map(Vector::from);
    let largest = [a, b, c]
        .map(Vector::length)
        .into_iter()
        .fold(0.0, f64::max);
    if largest == 0.0 {
        return false;
    }
    // Dividing first keeps the products in range.
    let [a, b, c] = [a, b, c].map(|row| row * largest.recip());
    let areas = [a.cross(b), b.cross(c), c.cross(a)].map(Vector::length);
    areas.into_iter().any(|area| area > TOLERANCE)
}

/// The map of a matrix given column by column.
pub(super) fn inverse_bind_map(columns: &[f32; 16]) -> Affine<f64> {
    let entry = |row: usize, column: usize| f64::from(columns[4 * column + row]);
    let rows = [0, 1, 2];
    Affine::new(
        rows.map(|row| rows.map(|column| entry(row, column))),
        rows.map(|row| entry(row, 3)),
    )
}

/// The vertices of a primitive with the displacements of morph targets, p + Σ wᵢ dᵢ, and the
/// directions at them. Those of a primitive without normals or tangents are empty.
struct Morphed {
    positions: Vec<Point<f64>>,
    normals: Vec<Vector<f64>>,
    tangents: Vec<Vector<f64>>,
}

impl Morphed {
    fn new(primitive: &Primitive, weights: &[f64]) -> Self {
        let vector = |numbers: [f32; 3]| Vector::from(numbers.map(f64::from));
        let plain = |list: &[[f32; 3]]| list.iter().map(|&numbers| vector(numbers)).collect();
        let mut positions: Vec<Vector<f64>> = plain(&primitive.positions);
        let mut normals: Vec<Vector<f64>> = plain(&primitive.normals);
        let tangents = primitive.tangents.iter();
        let mut tangents: Vec<_> = tangents.map(|&[x, y, z, _]| vector([x, y, z])).collect();
        for (target, &weight) in primitive.targets.iter().zip(weights) {
            for (sums, displacements) in [
                (&mut positions, &target.positions),
                (&mut normals, &target.normals),
                (&mut tangents, &target.tangents),
            ] {
                for (sum, &displacement) in sums.iter_mut().zip(displacements) {
                    *sum += vector(displacement) * weight;
                }
            }
        }
        // A primitive without positions has none of its vertices placed.
        normals.truncate(positions.len());
        tangents.truncate(positions.len());
        Self {
            positions: positions.into_iter().map(Point::from).collect(),
            normals,
            tangents,
        }
    }

    /// Moves all by the frame of a node.
    fn transform(&mut self, map: Affine<f64>) {
        for position in &mut self.positions {
            *position = map.transform(*position);
        }
        for normal in &mut self.normals {
            let plane = DualPlane::from_normal_distance((*normal).into(), 0.0).undual();
            let image = Vector::from(map.transform_plane(plane).dual().normal());
            *normal = image.normalized().unwrap_or_default();
        }
        for tangent in &mut self.tangents {
            let image = map.transform_direction(Direction::from(*tangent));
            *tangent = Vector::from(image).normalized().unwrap_or_default();
        }
    }

    /// The binding with the directions as they are.
    fn with_directions(&self, mut binding: Binding<f64>) -> Result<Binding<f64>, SkinError> {
        if !self.normals.is_empty() {
            binding = binding.with_normals(&self.normals)?;
        }
        if !self.tangents.is_empty() {
            binding = binding.with_tangents(&self.tangents)?;
        }
        Ok(binding)
    }

    fn posed(&mut self) -> Posed<'_, f64> {
        Posed {
            points: &mut self.positions,
            normals: &mut self.normals,
            tangents: &mut self.tangents,
        }
    }
}

/// The influences of all sets together. Where a vertex has two weights for a joint, which glTF does
/// not allow, their sum counts.
fn influences(primitive: &Primitive, joints: usize) -> Result<SkinWeights, SkinError> {
    let row = |vertex: usize| {
        let mut row: Vec<(u32, f64)> = Vec::with_capacity(4 * primitive.joints.len());
        for (joints, weights) in primitive.joints.iter().zip(&primitive.weights) {
            for (joint, weight) in joints[vertex].into_iter().zip(weights[vertex]) {
                let (joint, weight) = (u32::from(joint), f64::from(weight));
                match row.iter_mut().find(|influence| influence.0 == joint) {
                    Some(influence) => influence.1 += weight,
                    None => row.push((joint, weight)),
                }
            }
        }
        row
    };
    SkinWeights::new(joints, (0..primitive.positions.len()).map(row))
}

/// A few bytes for each of many nodes that place one mesh must not become vertices without limit.
fn check_size(document: &Document) -> Result<(), MotionFileError> {
    const FREE: u64 = 1 << 24;
    const TIMES: u64 = 1000;
    let size = |primitive: &Primitive| {
        let indices = primitive.indices.as_ref().map_or(0, Vec::len);
        (primitive.vertex_count() + indices) as u64
    };
    let sizes: Vec<u64> = document
        .meshes
        .iter()
        .map(|mesh| mesh.primitives.iter().map(size).sum())
        .collect();
    let meshes = document.nodes.iter().filter_map(|node| node.mesh);
    let needed = meshes.fold(0, |sum: u64, mesh| sum.saturating_add(sizes[mesh]));
    let limit = FREE.max(TIMES.saturating_mul(sizes.iter().sum()));
    if needed > limit {
        return Err(MotionFileError::TooLarge { needed, limit });
    }
    Ok(())
}
