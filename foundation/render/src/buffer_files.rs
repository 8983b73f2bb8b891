//! What a picture shows, as numbers in files.
//!
//! | file | what it holds |
//! | --- | --- |
//! | `depth.pfm`, `distance.pfm` | depths and distances; infinite where nothing is seen |
//! | `uv.pfm`, `normal.pfm` | texture coordinates; normals |
//! | `identity.png` | object and triangle, from 1: the object, the high and the low half |
//! | `material.png` | the material, from 1; 0 for that of the style |

use ga_image::file::FormatError;
use ga_image::pfm::ByteOrder;
use ga_image::{pfm, png};

use crate::buffers::{Buffers, SurfacePoint};

/// The names of the files.
pub const NAMES: [&str; 6] = [
    "depth.pfm",
    "distance.pfm",
    "uv.pfm",
    "normal.pfm",
    "identity.png",
    "material.png",
];

/// Why buffers cannot be files.
#[derive(Debug, thiserror::Error)]
pub enum BufferFileError {
    /// The numbers in `identity.png` and `material.png` have 16 bits.
    #[error("there are more objects or materials than 16 bits can number")]
    TooMany,
    /// A buffer does not fit its format.
    #[error(transparent)]
    Format(#[from] FormatError),
}

/// The names and contents of the files, in the order of [`NAMES`].
///
/// # Errors
///
/// [`BufferFileError`].
pub fn encode(buffers: &Buffers<'_>) -> Result<Vec<(&'static str, Vec<u8>)>, BufferFileError> {
    let points = buffers.points();
    let counted = |number: usize| u16::try_from(number + 1);
    let mut too_many = false;
    let mut identity = |point: Option<SurfacePoint>| {
        let Some(point) = point else {
            return [0; 3];
        };
        let triangle = point.triangle as u32 + 1;
        let object = counted(point.object).unwrap_or_else(|_| {
            too_many = true;
            u16::MAX
        });
        [object, (triangle >> 16) as u16, triangle as u16]
    };
    let identities = points.map(&mut identity);
    let materials = points.map(|point| {
        let material = point.and_then(|point| point.material);
        material.map_or(0, |material| counted(material as usize).unwrap_or(u16::MAX))
    });
    if too_many || materials.values().contains(&u16::MAX) {
        return Err(BufferFileError::TooMany);
    }
    let contents = [
        pfm::encode(&buffers.depth(), ByteOrder::Little)?,
        pfm::encode(&buffers.distance(), ByteOrder::Little)?,
        pfm::encode(&buffers.texture_coordinates(), ByteOrder::Little)?,
        pfm::encode(&buffers.normals(), ByteOrder::Little)?,
        png::encode(&identities)?,
        png::encode(&materials)?,
    ];
    Ok(NAMES.into_iter().zip(contents).collect())
}
