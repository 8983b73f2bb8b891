//! What a rendered picture shows, as numbers in files.

use anyhow::{Result, ensure};
use ga_image::plane::Plane;
use ga_image::{pfm, png};
use ga_render::{Buffers, SurfacePoint};

use crate::output::File;

/// The names of the files of `--buffers`.
pub(crate) const NAMES: [&str; 6] = [
    "depth.pfm",
    "distance.pfm",
    "uv.pfm",
    "normal.pfm",
    "identity.png",
    "material.png",
];

/// The contents of the files, in the order of their names.
pub(crate) fn encode(buffers: &Buffers) -> Result<Vec<File>> {
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
    ensure!(
        !too_many && !materials.values().contains(&u16::MAX),
        "--buffers: there are more objects or materials than 16 bits can number"
    );
    let contents = [
        float(&buffers.depth())?,
        float(&buffers.distance())?,
        floats(&buffers.texture_coordinates())?,
        floats(&buffers.normals())?,
        png::encode(&identities)?,
        png::encode(&materials)?,
    ];
    let files = NAMES.into_iter().zip(contents);
    Ok(files
        .map(|(name, contents)| File { name, contents })
        .collect())
}

fn float(plane: &Plane<f32>) -> Result<Vec<u8>> {
    Ok(pfm::encode(plane, pfm::ByteOrder::Little)?)
}

fn floats(plane: &Plane<[f32; 3]>) -> Result<Vec<u8>> {
    Ok(pfm::encode(plane, pfm::ByteOrder::Little)?)
}
