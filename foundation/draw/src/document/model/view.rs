//! What a model that is shown on a page consists of.

use crate::colour::Colour;
use crate::document::motion::Encoding;

/// A model of triangles, at rest or moving. Lengths are in metres, y is up, and triangles are
/// counterclockwise as seen from outside; their back sides are shown too.
///
/// # What the page has of it
///
/// Each coordinate of a position is written as a whole number of 16 bits within the bounds that all
/// frames have along its axis: it is off by at most the length of the bounds / 131070, which is
/// 0.02 mm for a walk of 2.6 m. In the same way each texture coordinate is off by at most its range
/// / 131070. Normals are computed in the page, and surfaces are smooth across all edges: vertices
/// that are at the same place in all frames count as one, so that a surface is smooth across seams
/// of the texture as well. Vertices that no triangle has are left out.
///
/// A model of 9,500 vertices and 19,000 triangles takes 0.15 MB, another 0.08 MB for each frame,
/// and its texture.
///
/// ```
/// use ga_draw::document::{ModelView, Page};
///
/// let low = vec![[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 0.0, 1.0], [0.0, 1.0, 0.0]];
/// let mut high = low.clone();
/// high[3][1] = 1.5;
/// let model = ModelView {
///     triangles: vec![[0, 1, 2], [0, 3, 1], [0, 2, 3], [1, 3, 2]],
///     frames: vec![low, high],
///     floor: Some(0.0),
///     ..ModelView::default()
/// };
/// let mut page = Page::new("A pyramid");
/// page.model(&model, "A pyramid that grows.")?;
/// assert!(page.into_html().contains("<figcaption>A pyramid that grows.</figcaption>"));
/// # Ok::<(), ga_draw::document::ModelError>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct ModelView {
    /// The indices of the vertices of each triangle.
    pub triangles: Vec<[u32; 3]>,
    /// For each frame the positions of all vertices; one frame for a model at rest.
    pub frames: Vec<Vec<[f64; 3]>>,
    /// The number of frames in a second.
    pub frames_per_second: f64,
    /// The colours of the vertices. A texture is multiplied by them.
    pub colours: Option<Vec<Colour>>,
    /// The picture on the surface.
    pub texture: Option<ModelTexture>,
    /// The height of the floor, on which a grid is drawn, and the shadow of what is near to it.
    pub floor: Option<f64>,
    /// The azimuth and the elevation in degrees from which the model is seen at first. At azimuth 0
    /// the eye is on the side of +z, at 90 on that of +x.
    pub turn: [f64; 2],
}

impl Default for ModelView {
    /// A model without triangles, which is seen from somewhat above and beside +z and plays 25
    /// frames per second.
    fn default() -> Self {
        Self {
            triangles: vec![],
            frames: vec![],
            frames_per_second: 25.0,
            colours: None,
            texture: None,
            floor: None,
            turn: [25.0, 10.0],
        }
    }
}

/// A picture on the surface of a [`ModelView`].
#[derive(Clone, Debug, PartialEq)]
pub struct ModelTexture {
    /// Where in the picture the corners of the triangles lie.
    pub coordinates: ModelCoordinates,
    /// The format of the picture.
    pub encoding: Encoding,
    /// The bytes of its file. Transparent pixels are shown on grey.
    pub bytes: Vec<u8>,
}

/// Texture coordinates (u, v) with u to the right and v *up*, as those of meshes in OBJ: (0, 0) is
/// the lower left corner of the picture, (1, 1) the upper right one. Beyond them the picture is
/// repeated.
#[derive(Clone, Debug, PartialEq)]
pub enum ModelCoordinates {
    /// One for each vertex.
    Vertices(Vec<[f64; 2]>),
    /// One for each corner of each triangle, so that a vertex on a seam has several.
    Corners(Vec<[[f64; 2]; 3]>),
}

impl ModelCoordinates {
    /// That of a corner of a triangle.
    pub(super) fn of(&self, triangle: usize, corner: usize, vertex: u32) -> [f64; 2] {
        match self {
            Self::Vertices(all) => all[vertex as usize],
            Self::Corners(all) => all[triangle][corner],
        }
    }
}
