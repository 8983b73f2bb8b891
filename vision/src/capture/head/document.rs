//! The moving surface of a head as glTF.

use ga_mesh::gltf::{Animation, Channel, Document, Interpolation, Keys, Node, Target};
use ga_mesh::normals::vertex_normals;
use ga_mesh::{Mesh, Normals};
use ga_runtime::cga3::Motor;
use ga_runtime::vga3::Vector;

use super::placement::Placement;
use super::surface::{HeadMotion, HeadSurface};
use crate::capture::CaptureError;

impl HeadSurface {
    /// The mesh at rest, with smooth normals unless it has its own.
    ///
    /// # Errors
    /// [`CaptureError::Mesh`].
    pub fn mesh_at_rest(&self) -> Result<Mesh, CaptureError> {
        let mesh = &self.mesh;
        if mesh.normals().is_some() {
            return Ok(mesh.clone());
        }
        let places: Vec<_> = mesh.coordinates().collect();
        let normals = vertex_normals(&places, &mesh.triangles()).into_iter();
        let normals: Vec<Vector<f64>> = normals.map(Vector::from).collect();
        let normals = Normals::of_directions(&normals, mesh.faces());
        Ok(mesh.clone().with_normals(normals)?)
    }

    /// The surface over time: the shapes of the motion as morph targets of a mesh at rest, which is
    /// [`mesh_at_rest`](Self::mesh_at_rest) with its own paths of pictures, and an animation of
    /// their weights and of the poses of the head; without poses, the mesh stays in its own
    /// coordinates. Times are in seconds, one for each frame.
    ///
    /// A frame without a pose has no keys of the pose, and one in which the motion is empty has
    /// none of the weights, so that programs interpolate between the frames before and after it.
    ///
    /// # Errors
    /// [`CaptureError::NoPlace`] for a motion beyond the range of the numbers, and
    /// [`CaptureError::Format`] for what glTF cannot hold.
    pub fn document(
        &self,
        rest: &Mesh,
        motion: &HeadMotion,
        poses: Option<&[Option<Motor<f64>>]>,
        times: &[f64],
    ) -> Result<Document, CaptureError> {
        let names: Vec<_> = (1..=motion.targets.len())
            .map(|k| format!("expression {k}"))
            .collect();
        let targets = names.iter().zip(&motion.targets);
        let targets: Vec<_> = targets
            .map(|(name, displacements)| Target {
                name,
                displacements,
            })
            .collect();
        let document = Document::from_mesh_with_targets(rest, &targets);
        let mut document = document.map_err(|error| CaptureError::Format(Box::new(error)))?;
        let weights = motion.shapes.weights.iter().flatten();
        let weights: Vec<f32> = weights.map(|&weight| weight as f32).collect();
        let channel = |node, times: &[f32], keys| Channel {
            node,
            times: times.to_vec(),
            interpolation: Interpolation::Linear,
            keys,
            extras: None,
        };
        let nodes = document.nodes.len();
        let mut channels = Vec::new();
        if !weights.is_empty() {
            let times = times_of(&motion.keys, times);
            let of_weights = |node| channel(node, &times, Keys::Weights(weights.clone()));
            channels.extend((0..nodes).map(of_weights));
        }
        if let Some(poses) = poses {
            let places: Vec<_> = poses
                .iter()
                .flatten()
                .map(|&pose| Placement::new(self.fit.to_mesh, pose))
                .collect::<Result<_, _>>()?;
            let times = times_of(poses, times);
            let [translations, rotations] = [
                Keys::Translation(places.iter().map(Placement::translation).collect()),
                Keys::Rotation(continuous(places.iter().map(Placement::quaternion))),
            ];
            let at_rest = Placement::new(self.fit.to_mesh, Motor::default())?;
            document.nodes.push(Node {
                name: Some("head".to_owned()),
                children: (0..nodes).collect(),
                transform: at_rest.transform(),
                ..Node::default()
            });
            document.scenes[0].nodes = vec![nodes];
            channels.extend([
                channel(nodes, &times, translations),
                channel(nodes, &times, rotations),
            ]);
        }
        if !channels.is_empty() {
            document.animations.push(Animation {
                name: Some("capture".to_owned()),
                channels,
                extras: None,
            });
        }
        Ok(document)
    }
}

/// The times of the frames that have something.
fn times_of<T>(frames: &[Option<T>], times: &[f64]) -> Vec<f32> {
    let frames = frames.iter().zip(times);
    let frames = frames.filter(|(frame, _)| frame.is_some());
    frames.map(|(_, &time)| time as f32).collect()
}

/// Quaternions without a change of sign from one to the next.
fn continuous(quaternions: impl Iterator<Item = [f32; 4]>) -> Vec<[f32; 4]> {
    let mut found: Vec<[f32; 4]> = Vec::new();
    for quaternion in quaternions {
        let last = found.last().copied().unwrap_or([0.0, 0.0, 0.0, 1.0]);
        let product: f32 = last.iter().zip(quaternion).map(|(a, b)| a * b).sum();
        found.push(if product < 0.0 {
            quaternion.map(|x| -x)
        } else {
            quaternion
        });
    }
    found
}
