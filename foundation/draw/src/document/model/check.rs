//! What can be wrong with a model.

use super::view::{ModelCoordinates, ModelTexture, ModelView};
use crate::document::motion::Encoding;

/// The farthest place from the origin along an axis, in metres, as of motions.
const FARTHEST: f64 = 1e5;

/// Why a [`ModelView`] cannot be shown.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum ModelError {
    /// There are no triangles.
    #[error("the model has no triangles, so that there is nothing to show")]
    NoTriangles,
    /// There are no frames.
    #[error("the model has no frame, so that there is nothing to show")]
    NoFrames,
    /// The number of frames in a second is not a positive number.
    #[error("{0} frames per second: this must be a positive number")]
    FramesPerSecond(f64),
    /// A frame has another number of positions than the first one.
    #[error("frame {frame} has {positions} positions, but frame 0 has {vertices}")]
    Positions {
        /// The frame.
        frame: usize,
        /// The number of its positions.
        positions: usize,
        /// The number of positions of the first frame.
        vertices: usize,
    },
    /// A coordinate is not a number, or is far beyond what can be shown.
    #[error("{element} has the coordinate {value}, which must be a number from -1e5 to 1e5 metres")]
    Coordinate {
        /// What has the coordinate.
        element: String,
        /// The coordinate.
        value: f64,
    },
    /// A triangle has a vertex that does not exist.
    #[error("triangle {triangle} has vertex {vertex}, but there are {vertices} vertices")]
    Index {
        /// The index of the triangle.
        triangle: usize,
        /// The index of the vertex.
        vertex: u32,
        /// The number of vertices.
        vertices: usize,
    },
    /// There are more or fewer colours than vertices.
    #[error("there are {colours} colours, but {vertices} vertices")]
    Colours {
        /// The number of colours.
        colours: usize,
        /// The number of vertices.
        vertices: usize,
    },
    /// There are more or fewer texture coordinates than what has them.
    #[error("there are texture coordinates for {coordinates} {owners}, but {expected} {owners}")]
    TextureCoordinates {
        /// For how many there are texture coordinates.
        coordinates: usize,
        /// What has them: `vertices` or `triangles`.
        owners: &'static str,
        /// The number of these.
        expected: usize,
    },
    /// A texture coordinate is not a number, or is far from the picture.
    #[error(
        "the texture coordinates of {owner} {index} have {value}, which must be a number from -1e5 \
         to 1e5"
    )]
    TextureCoordinate {
        /// What has it: `vertex` or `triangle`.
        owner: &'static str,
        /// The index of this.
        index: usize,
        /// The coordinate.
        value: f64,
    },
    /// The bytes of the texture do not begin as a file of its format does.
    #[error("the bytes of the texture are not a picture in {0:?}")]
    Picture(Encoding),
    /// An angle is not a number.
    #[error("the model is seen from {0} degrees, which must be a number")]
    Turn(f64),
}

/// Finds what is wrong with a model.
pub(super) fn check(model: &ModelView) -> Result<(), ModelError> {
    let rate = model.frames_per_second;
    if !(rate.is_finite() && rate > 0.0) {
        return Err(ModelError::FramesPerSecond(rate));
    }
    if let Some(&angle) = model.turn.iter().find(|angle| !angle.is_finite()) {
        return Err(ModelError::Turn(angle));
    }
    if model.triangles.is_empty() {
        return Err(ModelError::NoTriangles);
    }
    let vertices = model.frames.first().ok_or(ModelError::NoFrames)?.len();
    for (frame, positions) in model.frames.iter().enumerate() {
        if positions.len() != vertices {
            return Err(ModelError::Positions {
                frame,
                positions: positions.len(),
                vertices,
            });
        }
        for (vertex, position) in positions.iter().enumerate() {
            if let Some(value) = wrong(position) {
                return Err(ModelError::Coordinate {
                    element: format!("vertex {vertex} of frame {frame}"),
                    value,
                });
            }
        }
    }
    for (triangle, corners) in model.triangles.iter().enumerate() {
        if let Some(&vertex) = corners.iter().find(|&&vertex| vertex as usize >= vertices) {
            return Err(ModelError::Index {
                triangle,
                vertex,
                vertices,
            });
        }
    }
    if let Some(value) = model.floor.and_then(|height| wrong(&[height])) {
        return Err(ModelError::Coordinate {
            element: "the floor".to_owned(),
            value,
        });
    }
    match &model.colours {
        Some(colours) if colours.len() != vertices => Err(ModelError::Colours {
            colours: colours.len(),
            vertices,
        }),
        _ => Ok(()),
    }?;
    match &model.texture {
        Some(texture) => check_texture(texture, vertices, model.triangles.len()),
        None => Ok(()),
    }
}

fn check_texture(
    texture: &ModelTexture,
    vertices: usize,
    triangles: usize,
) -> Result<(), ModelError> {
    let (coordinates, owner, owners, expected) = match &texture.coordinates {
        ModelCoordinates::Vertices(all) => (all.len(), "vertex", "vertices", vertices),
        ModelCoordinates::Corners(all) => (all.len(), "triangle", "triangles", triangles),
    };
    if coordinates != expected {
        return Err(ModelError::TextureCoordinates {
            coordinates,
            owners,
            expected,
        });
    }
    let first_wrong = match &texture.coordinates {
        ModelCoordinates::Vertices(all) => find_wrong(all.iter().map(<[f64; 2]>::as_slice)),
        ModelCoordinates::Corners(all) => {
            find_wrong(all.iter().map(|corners| corners.as_flattened()))
        }
    };
    if let Some((index, value)) = first_wrong {
        return Err(ModelError::TextureCoordinate {
            owner,
            index,
            value,
        });
    }
    let begin: &[u8] = match texture.encoding {
        Encoding::Jpeg => b"\xff\xd8\xff",
        Encoding::Png => b"\x89PNG\r\n\x1a\n",
    };
    if texture.bytes.starts_with(begin) {
        Ok(())
    } else {
        Err(ModelError::Picture(texture.encoding))
    }
}

/// The first number that is wrong, with the index of the list that has it.
fn find_wrong<'n>(mut lists: impl Iterator<Item = &'n [f64]>) -> Option<(usize, f64)> {
    let mut index = 0;
    lists.find_map(|numbers| {
        let found = wrong(numbers).map(|value| (index, value));
        index += 1;
        found
    })
}

fn wrong(numbers: &[f64]) -> Option<f64> {
    let is_wrong = |x: &&f64| x.is_nan() || x.abs() > FARTHEST;
    numbers.iter().find(is_wrong).copied()
}
