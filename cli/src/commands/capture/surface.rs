//! The surface of a head that follows captured points.

use std::path::{Path, PathBuf};

use anyhow::{Context, Result, anyhow, ensure};
use ga_mesh::format::{self, Options};
use ga_mesh::gltf::{
    Animation, Channel, Document, Interpolation, Keys, Node, Target, Transform, encode,
};
use ga_mesh::normals::vertex_normals;
use ga_mesh::{CornerAttribute, Mesh};
use ga_runtime::cga3::{Motor, Point, Similarity};
use ga_runtime::vga3::{Rotor, Vector};
use ga_vision::capture::table::{Key, PointTable, decode_keys};
use ga_vision::capture::{
    CaptureError, CapturedFrame, LocalArea, PrincipalShapes, SphericalParameterisation,
    SurfaceMesh, SurfaceMotion,
};

use super::Arguments;
use super::arguments::Area;
use crate::format::Format;
use crate::frame::Warning;
use crate::mesh_file;

/// A mesh, and how it follows its keys.
pub(super) struct Surface {
    pub(super) warnings: Vec<Warning>,
    mesh: Mesh,
    keys: Vec<Key>,
    motion: SurfaceMotion,
    pub(super) area: LocalArea,
    /// From the points at rest to the mesh.
    to_mesh: Similarity<f64>,
    /// The root mean square distance between the keys on the mesh and the points at rest, in the
    /// unit of the mesh, as all that follows.
    pub(super) fit: f64,
    pub(super) centre: Point<f64>,
    pub(super) folded_triangles: usize,
    keep_centre: bool,
}

/// A surface over time.
pub(super) struct Motion {
    /// For each frame the displacements of the keys.
    keys: Vec<Vec<Vector<f64>>>,
    pub(super) shapes: PrincipalShapes,
    /// For each shape the displacement of every vertex.
    targets: Vec<Vec<Vector<f64>>>,
    /// How many keys were not seen, in all frames together.
    pub(super) filled: usize,
}

impl Surface {
    pub(super) fn new(
        path: &Path,
        arguments: &Arguments,
        points: &PointTable,
        rest: &[Point<f64>],
    ) -> Result<Self> {
        let (mesh, warnings) = mesh_file::read(path)?;
        let keys = match &arguments.keys {
            Some(path) => ga_files::read(path, |bytes| decode_keys(bytes, points, &mesh))?,
            None => (0..)
                .zip(rest)
                .map(|(point, &place)| Key { point, place })
                .collect(),
        };
        let (to_mesh, fit) = match &arguments.keys {
            Some(path) => fit(&keys, rest, arguments.fit_scale)
                .with_context(|| format!("{} does not place the points", path.display()))?,
            None => (Similarity::default(), 0.0),
        };
        ensure!(
            to_mesh.factor() > 0.0,
            "{}: the points at rest and the keys have no scale in common",
            path.display()
        );
        let named =
            |error: CaptureError| anyhow!("{}: {}", path.display(), text(&error, &keys, points));
        let triangles = mesh.triangles();
        let shape = SurfaceMesh::new(mesh.positions(), &triangles).map_err(named)?;
        let sphere = SphericalParameterisation::new(&shape).map_err(named)?;
        let places: Vec<_> = keys.iter().map(|key| key.place).collect();
        let motion = SurfaceMotion::new(&sphere, &places).map_err(named)?;
        let area = match &arguments.area {
            Some(area) => {
                local(area, &shape, &keys, points).with_context(|| path.display().to_string())?
            }
            None => LocalArea::whole(&shape).map_err(named)?,
        };
        Ok(Self {
            warnings,
            fit,
            to_mesh,
            motion,
            area,
            centre: sphere.centre(),
            folded_triangles: sphere.folded_triangles(),
            keep_centre: arguments.keep_centre,
            keys,
            mesh,
        })
    }

    /// The length of the mesh's unit.
    pub(super) fn metres_per_unit(&self) -> f64 {
        self.to_mesh.factor().recip()
    }

    pub(super) fn key_count(&self) -> usize {
        self.keys.len()
    }

    pub(super) fn vertex_count(&self) -> usize {
        self.mesh.vertex_count()
    }

    /// The surface in all frames, as shapes that represent the keys within a tolerance in metres.
    pub(super) fn follow(
        &self,
        frames: &[CapturedFrame],
        points: &PointTable,
        tolerance: f64,
    ) -> Result<Motion> {
        let rotor = Rotor::from(self.to_mesh.rotor());
        let turned = |d: Vector<f64>| rotor.transform(d) * self.to_mesh.factor();
        let mut filled = 0;
        let mut all = Vec::with_capacity(frames.len());
        for (index, frame) in frames.iter().enumerate() {
            let keys = self.keys.iter();
            let seen: Vec<_> = keys
                .map(|key| frame.expression[key.point].map(turned))
                .collect();
            filled += seen.iter().filter(|key| key.is_none()).count();
            let found = self.motion.filled(&seen);
            all.push(found.map_err(|error| match error {
                CaptureError::NoKeys => anyhow!("{}: no key is seen", points.place(index)),
                error => anyhow!(
                    "{}: {}",
                    points.place(index),
                    text(&error, &self.keys, points)
                ),
            })?);
        }
        let shapes = PrincipalShapes::new(&all, tolerance * self.to_mesh.factor())?;
        let targets = shapes.shapes.iter().map(|shape| self.displacements(shape));
        Ok(Motion {
            targets: targets.collect::<Result<_>>()?,
            keys: all,
            shapes,
            filled,
        })
    }

    /// The displacements of all vertices by those of the keys.
    fn displacements(&self, keys: &[Vector<f64>]) -> Result<Vec<Vector<f64>>> {
        let mut moved = vec![Vector::ZERO; self.vertex_count()];
        self.motion.displacements(keys, &mut moved)?;
        self.area.apply(&mut moved, self.keep_centre);
        Ok(moved)
    }

    /// The displacement of the area's centre of gravity in each frame, on the mesh.
    pub(super) fn centre_displacements(&self, motion: &Motion) -> Vec<Vector<f64>> {
        let targets = motion.targets.iter();
        let parts: Vec<_> = targets.map(|t| self.area.centre_displacement(t)).collect();
        let frames = motion.shapes.weights.iter();
        let sum = |weights: &Vec<f64>| {
            let terms = parts.iter().zip(weights);
            terms.fold(Vector::ZERO, |sum, (&part, &weight)| sum + part * weight)
        };
        frames.map(sum).collect()
    }

    /// From the mesh to where the head is.
    fn placed(&self, pose: Motor<f64>) -> Result<Placement> {
        let factor = self.to_mesh.factor().recip();
        // rest = S⁻¹ mesh: the displacement belongs to the origin of the mesh.
        let to_mesh = self.to_mesh;
        let back = Rotor::from(to_mesh.rotor()).reverse();
        let origin = back.transform(Vector::from(to_mesh.displacement())) * -factor;
        let rotor = Rotor::from(pose.rotor()) * back;
        let translation = Vector::from(pose.transform(Point::from(origin)));
        ensure!(
            translation.is_finite() && factor.is_finite(),
            "the mesh has no place at rest"
        );
        Ok(Placement {
            rotor,
            factor,
            translation,
        })
    }

    /// The files of the surface in one frame.
    pub(super) fn frame_files(
        &self,
        (out, format): (&Path, Format),
        arguments: &Arguments,
        motion: &Motion,
        frame: usize,
        pose: Motor<f64>,
    ) -> Result<Vec<(PathBuf, Vec<u8>)>> {
        let moved = self.displacements(&motion.keys[frame])?;
        let placement = match arguments.still {
            true => Placement::default(),
            false => self.placed(pose)?,
        };
        let positions = self.mesh.positions().iter().zip(moved);
        let positions: Vec<_> = positions
            .map(|(&place, by)| placement.apply(Vector::from(place) + by).coordinates())
            .collect();
        let mesh = self.mesh.with_positions(positions)?;
        let mesh = relocated(&mesh, arguments, out)?;
        mesh_file::files(out, format, &mesh, &Options::default())
    }

    /// A binary glTF file with the shapes as morph targets, and their weights and the pose as an
    /// animation.
    pub(super) fn glb(
        &self,
        out: &Path,
        arguments: &Arguments,
        motion: &Motion,
        poses: &[Motor<f64>],
        times: &[f64],
    ) -> Result<Vec<u8>> {
        let mesh = relocated(&with_normals(&self.mesh)?, arguments, out)?;
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
        let mut document = Document::from_mesh_with_targets(&mesh, &targets)?;
        let times: Vec<f32> = times.iter().map(|&time| time as f32).collect();
        let weights = motion.shapes.weights.iter().flatten();
        let weights: Vec<f32> = weights.map(|&weight| weight as f32).collect();
        let channel = |node, keys| Channel {
            node,
            times: times.clone(),
            interpolation: Interpolation::Linear,
            keys,
            extras: None,
        };
        let nodes = document.nodes.len();
        let mut channels = Vec::new();
        if !weights.is_empty() {
            channels.extend((0..nodes).map(|node| channel(node, Keys::Weights(weights.clone()))));
        }
        if !arguments.still {
            let places: Vec<_> = poses
                .iter()
                .map(|&pose| self.placed(pose))
                .collect::<Result<_>>()?;
            let [translations, rotations] = [
                Keys::Translation(places.iter().map(Placement::translation).collect()),
                Keys::Rotation(continuous(places.iter().map(Placement::quaternion))),
            ];
            let rest = self.placed(Motor::default())?;
            document.nodes.push(Node {
                name: Some("head".to_owned()),
                children: (0..nodes).collect(),
                transform: rest.transform(),
                ..Node::default()
            });
            document.scenes[0].nodes = vec![nodes];
            channels.extend([channel(nodes, translations), channel(nodes, rotations)]);
        }
        if !channels.is_empty() {
            document.animations.push(Animation {
                name: Some("capture".to_owned()),
                channels,
                extras: None,
            });
        }
        Ok(encode(&document)?)
    }
}

/// p ↦ translation + factor · R p ~R.
struct Placement {
    rotor: Rotor<f64>,
    factor: f64,
    translation: Vector<f64>,
}

impl Default for Placement {
    fn default() -> Self {
        Self {
            rotor: Rotor::default(),
            factor: 1.0,
            translation: Vector::ZERO,
        }
    }
}

impl Placement {
    fn apply(&self, place: Vector<f64>) -> Vector<f64> {
        self.translation + self.rotor.transform(place) * self.factor
    }

    fn translation(&self) -> [f32; 3] {
        self.translation.coordinates().map(|x| x as f32)
    }

    fn quaternion(&self) -> [f32; 4] {
        let ([x, y, z], w) = self.rotor.to_quaternion();
        [x, y, z, w].map(|x| x as f32)
    }

    fn transform(&self) -> Transform {
        Transform::Decomposed {
            translation: self.translation(),
            rotation: self.quaternion(),
            scale: [self.factor as f32; 3],
        }
    }
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

/// The motion of the points at rest to the keys on the mesh.
fn fit(keys: &[Key], rest: &[Point<f64>], scale: bool) -> Result<(Similarity<f64>, f64)> {
    let pairs: Vec<_> = keys
        .iter()
        .map(|key| (rest[key.point], key.place))
        .collect();
    Ok(if scale {
        let fit = Similarity::from_point_pairs(&pairs)?;
        (fit.motion, fit.residual(&pairs))
    } else {
        let fit = Motor::from_point_pairs(&pairs)?;
        (fit.motion.into(), fit.residual(&pairs))
    })
}

fn local(
    area: &Area,
    shape: &SurfaceMesh<'_>,
    keys: &[Key],
    points: &PointTable,
) -> Result<LocalArea> {
    let Area { key: name, radius } = area;
    let point = points.point(name);
    let key = keys.iter().find(|key| Some(key.point) == point);
    let key = key.with_context(|| format!("--area {name}:{radius}: {name:?} is not a key"))?;
    LocalArea::around(shape, key.place, *radius).with_context(|| format!("--area {name}:{radius}"))
}

/// The text of an error, with the names of the points.
fn text(error: &CaptureError, keys: &[Key], points: &PointTable) -> String {
    let name = |key: &usize| &points.names[keys[*key].point];
    match error {
        CaptureError::KeyNotFinite { key } => format!("key {} is not finite", name(key)),
        CaptureError::KeyAtCentre { key } => {
            format!("key {} is at the centre of gravity of the mesh", name(key))
        }
        CaptureError::SameDirection { first, second, .. } => format!(
            "keys {} and {} are seen in the same direction from the centre of gravity of the mesh",
            name(first),
            name(second)
        ),
        error => error.to_string(),
    }
}

/// The mesh with smooth normals, unless it has its own.
fn with_normals(mesh: &Mesh) -> Result<Mesh> {
    if mesh.normals().is_some() {
        return Ok(mesh.clone());
    }
    let places: Vec<_> = mesh.coordinates().collect();
    let normals = vertex_normals(&places, &mesh.triangles()).into_iter();
    // Vertices without a face have no normal, and none is drawn.
    let normals = normals.map(|n| Vector::from(n).normalized().unwrap_or(Vector::Z));
    let normals = CornerAttribute::of_vertices(normals.collect(), mesh.faces());
    Ok(mesh.clone().with_normals(normals)?)
}

fn relocated(mesh: &Mesh, arguments: &Arguments, out: &Path) -> Result<Mesh> {
    match &arguments.mesh {
        Some(from) => Ok(format::relocated(mesh, from, out)?),
        None => Ok(mesh.clone()),
    }
}
