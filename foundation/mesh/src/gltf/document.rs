//! Documents: nodes, scenes and cameras, and the lists of everything that they refer to.

use super::{
    Animation, Extras, Image, MaterialElement, Mesh, Origin, Sampler, Skin, TextureElement,
};

/// The contents of a glTF file. Elements refer to each other by their index in these lists.
///
/// # Examples
///
/// ```
/// use ga_mesh::gltf::{self, Document, Mesh, Node, Primitive, Scene};
///
/// let triangle = Primitive {
///     positions: vec![[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]],
///     ..Primitive::default()
/// };
/// let document = Document {
///     nodes: vec![Node { mesh: Some(0), ..Node::default() }],
///     meshes: vec![Mesh { primitives: vec![triangle], ..Mesh::default() }],
///     scenes: vec![Scene { nodes: vec![0], ..Scene::default() }],
///     scene: Some(0),
///     ..Document::default()
/// };
/// let file = gltf::encode(&document)?;
/// assert_eq!(gltf::decode(&file)?.meshes, document.meshes);
/// # Ok::<(), ga_mesh::FormatError>(())
/// ```
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Document {
    /// Who made the file, and with what.
    pub asset: Asset,
    /// The scene to show first.
    pub scene: Option<usize>,
    /// The scenes.
    pub scenes: Vec<Scene>,
    /// The nodes.
    pub nodes: Vec<Node>,
    /// The meshes.
    pub meshes: Vec<Mesh>,
    /// The skins.
    pub skins: Vec<Skin>,
    /// The animations.
    pub animations: Vec<Animation>,
    /// The materials.
    pub materials: Vec<MaterialElement>,
    /// The textures.
    pub textures: Vec<TextureElement>,
    /// How textures are sampled.
    pub samplers: Vec<Sampler>,
    /// The images.
    pub images: Vec<Image>,
    /// The cameras.
    pub cameras: Vec<CameraElement>,
    /// Data of an application.
    pub extras: Extras,
    /// The file that it was read from.
    pub origin: Origin,
}

/// Who made a file, and with what.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Asset {
    /// The program that wrote the file.
    pub generator: Option<String>,
    /// Whose work it is.
    pub copyright: Option<String>,
    /// Data of an application.
    pub extras: Extras,
}

/// Nodes that are shown together.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Scene {
    /// Its name.
    pub name: Option<String>,
    /// The nodes at its top; none of them has a parent.
    pub nodes: Vec<usize>,
    /// Data of an application.
    pub extras: Extras,
}

/// A frame of reference relative to its parent's, and what stands in it.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Node {
    /// Its name.
    pub name: Option<String>,
    /// The nodes below it. A node has at most one parent and is not its own ancestor.
    pub children: Vec<usize>,
    /// Its frame relative to its parent's.
    pub transform: Transform,
    /// The mesh in this frame.
    pub mesh: Option<usize>,
    /// The skin that moves the mesh. The mesh then ignores the frame of the node.
    pub skin: Option<usize>,
    /// The camera in this frame, which looks along −z with y up.
    pub camera: Option<usize>,
    /// The weights of the mesh's morph targets, in place of those of the mesh.
    pub weights: Option<Vec<f32>>,
    /// Data of an application.
    pub extras: Extras,
}

/// A change of frame: p ↦ translation + rotation (scale · p), or p ↦ matrix · p.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Transform {
    /// Scale along the axes, then rotation, then translation.
    Decomposed {
        /// The translation.
        translation: [f32; 3],
        /// The rotation as a unit quaternion (x, y, z, w).
        rotation: [f32; 4],
        /// The factor along each axis.
        scale: [f32; 3],
    },
    /// A 4 × 4 matrix, column by column; its last row is (0, 0, 0, 1). A node that an animation
    /// moves has no matrix.
    Matrix([f32; 16]),
}

/// How a scene is projected onto a picture.
#[derive(Clone, Debug, PartialEq)]
pub struct CameraElement {
    /// Its name.
    pub name: Option<String>,
    /// The projection.
    pub projection: Projection,
    /// Data of an application.
    pub extras: Extras,
}

/// The projection of a camera.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Projection {
    /// A pinhole camera.
    Perspective {
        /// Width by height of the picture; that of the window where absent.
        aspect_ratio: Option<f32>,
        /// The vertical angle of view in radians.
        vertical_angle: f32,
        /// The distance of the near clipping plane.
        near: f32,
        /// The distance of the far clipping plane; infinite where absent.
        far: Option<f32>,
    },
    /// A parallel projection.
    Orthographic {
        /// Half the width of the view.
        half_width: f32,
        /// Half its height.
        half_height: f32,
        /// The distance of the near clipping plane.
        near: f32,
        /// The distance of the far clipping plane.
        far: f32,
    },
}

impl Asset {
    /// The asset of documents that this crate makes.
    pub(super) fn of_this_crate() -> Self {
        Self {
            generator: Some("Nullcone".to_owned()),
            ..Self::default()
        }
    }
}

impl Transform {
    /// The change to the same frame.
    pub const IDENTITY: Self = Self::Decomposed {
        translation: [0.0; 3],
        rotation: [0.0, 0.0, 0.0, 1.0],
        scale: [1.0; 3],
    };

    /// The upper three rows of the 4 × 4 matrix. The quaternion is normalised.
    #[must_use]
    pub fn to_matrix(&self) -> [[f64; 4]; 3] {
        match self {
            Self::Matrix(columns) => {
                let entry = |row: usize, column: usize| f64::from(columns[4 * column + row]);
                std::array::from_fn(|row| std::array::from_fn(|column| entry(row, column)))
            }
            Self::Decomposed {
                translation,
                rotation,
                scale,
            } => {
                let rotation = rotation_matrix(rotation.map(f64::from));
                std::array::from_fn(|row| {
                    let [x, y, z] = rotation[row];
                    let [sx, sy, sz] = scale.map(f64::from);
                    [x * sx, y * sy, z * sz, f64::from(translation[row])]
                })
            }
        }
    }
}

impl Default for Transform {
    fn default() -> Self {
        Self::IDENTITY
    }
}

/// The matrix of a quaternion (x, y, z, w) of any length but zero, row by row.
fn rotation_matrix([x, y, z, w]: [f64; 4]) -> [[f64; 3]; 3] {
    let twice = 2.0 / (x * x + y * y + z * z + w * w);
    [
        [
            1.0 - twice * (y * y + z * z),
            twice * (x * y - z * w),
            twice * (x * z + y * w),
        ],
        [
            twice * (x * y + z * w),
            1.0 - twice * (x * x + z * z),
            twice * (y * z - x * w),
        ],
        [
            twice * (x * z - y * w),
            twice * (y * z + x * w),
            1.0 - twice * (x * x + y * y),
        ],
    ]
}
