use serde::Deserialize;

use super::bones::Members;
use crate::file_error::MotionFileError;
use crate::skeleton::Skeleton;
use crate::weights::SkinWeights;

#[derive(Deserialize)]
struct File {
    weights: Members<Vec<(u64, f64)>>,
}

pub(super) fn parse(
    bytes: &[u8],
    skeleton: &Skeleton,
    vertex_count: usize,
) -> Result<SkinWeights, MotionFileError> {
    let file: File =
        serde_json::from_slice(bytes).map_err(|error| MotionFileError::Json(error.to_string()))?;
    let mut by_vertex: Vec<Vec<(u32, f64)>> = vec![Vec::new(); vertex_count];
    for (bone, painted) in file.weights.by_name()? {
        let Some(joint) = skeleton.index(&bone) else {
            return Err(MotionFileError::UnknownBone { bone });
        };
        for (vertex, weight) in painted {
            let row = usize::try_from(vertex)
                .ok()
                .and_then(|vertex| by_vertex.get_mut(vertex));
            match row {
                Some(row) => row.push((joint as u32, weight)),
                None => {
                    return Err(MotionFileError::VertexOutOfRange {
                        bone,
                        vertex,
                        vertices: vertex_count,
                    });
                }
            }
        }
    }
    Ok(SkinWeights::new(skeleton.len(), &by_vertex)?)
}
