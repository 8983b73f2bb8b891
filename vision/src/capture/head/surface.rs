//! The surface of a head, and its motion by the expressions of frames.

use ga_mesh::Mesh;
use ga_runtime::cga3::{Motor, Point};
use ga_runtime::vga3::{Rotor, Vector};

use super::area::KeyArea;
use super::fit::KeyFit;
use super::placement::Placement;
use crate::capture::error::{CaptureError, KeyProblem};
use crate::capture::summary::{AreaSummary, SurfaceSummary};
use crate::capture::table::{Key, PointTable};
use crate::capture::{
    FrameOutcome, LocalArea, PrincipalShapes, SphericalParameterisation, SurfaceMesh, SurfaceMotion,
};

/// The mesh of a head, and how it follows its keys: the points of a table that have a place on it.
///
/// Lengths are in the unit of the mesh, unless they are said to be in metres.
#[derive(Clone, Debug)]
pub struct HeadSurface {
    pub(super) mesh: Mesh,
    keys: Vec<Key>,
    names: Vec<String>,
    motion: SurfaceMotion,
    area: LocalArea,
    area_of_key: Option<KeyArea>,
    keeps_centre: bool,
    pub(super) fit: KeyFit,
    centre: Point<f64>,
    folded_triangles: usize,
}

/// The surface of a head over time.
#[derive(Clone, Debug)]
pub struct HeadMotion {
    /// For each frame the displacements of the keys, where any is known.
    pub(super) keys: Vec<Option<Vec<Vector<f64>>>>,
    /// The shapes, with the weights of those frames that have displacements.
    pub(super) shapes: PrincipalShapes,
    /// For each shape the displacement of every vertex.
    pub(super) targets: Vec<Vec<Vector<f64>>>,
    /// How many keys were not seen, in all frames with displacements together.
    filled: usize,
}

impl HeadMotion {
    /// The frames in which the surface has no expression: they have no pose, or show no key.
    #[must_use]
    pub fn empty_frames(&self) -> Vec<usize> {
        let frames = self.keys.iter().enumerate();
        let empty = frames.filter(|(_, keys)| keys.is_none());
        empty.map(|(frame, _)| frame).collect()
    }
}

impl HeadSurface {
    /// A mesh whose whole surface moves with keys, which are points of a table.
    ///
    /// # Errors
    /// [`CaptureError`]: a fit without a scale, triangles without area, a vertex at their centre of
    /// gravity, and keys that are not finite, at this centre, or in one direction from it.
    ///
    /// # Panics
    /// Where the point of a key is not in the table.
    pub fn new(
        mesh: Mesh,
        keys: Vec<Key>,
        fit: KeyFit,
        points: &PointTable,
    ) -> Result<Self, CaptureError> {
        if fit.to_mesh.factor().is_nan() || fit.to_mesh.factor() <= 0.0 {
            return Err(CaptureError::NoScale);
        }
        let names = keys.iter().map(|key| points.names[key.point].clone());
        let names: Vec<String> = names.collect();
        let triangles = mesh.triangles();
        let shape = SurfaceMesh::new(mesh.positions(), &triangles)?;
        let sphere = SphericalParameterisation::new(&shape)?;
        let places: Vec<_> = keys.iter().map(|key| key.place).collect();
        let motion = SurfaceMotion::new(&sphere, &places);
        let motion = motion.map_err(|error| with_names(error, &names))?;
        Ok(Self {
            motion,
            area: LocalArea::whole(&shape)?,
            area_of_key: None,
            keeps_centre: false,
            fit,
            centre: sphere.centre(),
            folded_triangles: sphere.folded_triangles(),
            keys,
            names,
            mesh,
        })
    }

    /// The same surface, of which only the part around a key moves.
    ///
    /// # Errors
    /// [`CaptureError::NotKey`], and as [`LocalArea::around`].
    pub fn with_area(self, area: KeyArea, points: &PointTable) -> Result<Self, CaptureError> {
        let point = points.point(&area.key).ok();
        let key = self.keys.iter().find(|key| Some(key.point) == point);
        let key = key.ok_or_else(|| CaptureError::NotKey(area.key.clone()))?;
        let triangles = self.mesh.triangles();
        let shape = SurfaceMesh::new(self.mesh.positions(), &triangles)?;
        Ok(Self {
            area: LocalArea::around(&shape, key.place, area.radius)?,
            area_of_key: Some(area),
            ..self
        })
    }

    /// The same surface, whose centre of gravity, or that of its area, stays where it is at rest.
    #[must_use]
    pub fn keeping_centre(self, keeps_centre: bool) -> Self {
        Self {
            keeps_centre,
            ..self
        }
    }

    /// The surface in all frames of a table, as shapes that represent the keys within a tolerance
    /// in metres. Frames without a pose or without any key that is seen are left empty
    /// ([`HeadMotion::empty_frames`]).
    ///
    /// # Errors
    /// [`CaptureError::Row`] for the first frame that the surface cannot follow,
    /// [`CaptureError::NoKeySeen`] where all are empty, and as [`PrincipalShapes::new`].
    pub fn follow(
        &self,
        frames: &[FrameOutcome],
        points: &PointTable,
        tolerance: f64,
    ) -> Result<HeadMotion, CaptureError> {
        let to_mesh = self.fit.to_mesh;
        let rotor = Rotor::from(to_mesh.rotor());
        let turned = |d: Vector<f64>| rotor.transform(d) * to_mesh.factor();
        let mut filled = 0;
        let mut all = Vec::with_capacity(frames.len());
        for (index, frame) in frames.iter().enumerate() {
            let Ok(frame) = frame else {
                all.push(None);
                continue;
            };
            let keys = self.keys.iter();
            let seen: Vec<_> = keys
                .map(|key| frame.expression[key.point].map(turned))
                .collect();
            all.push(match self.motion.filled(&seen) {
                Ok(found) => {
                    filled += seen.iter().filter(|key| key.is_none()).count();
                    Some(found)
                }
                Err(CaptureError::NoKeys) => None,
                Err(error) => {
                    return Err(CaptureError::Row {
                        place: points.place(index),
                        problem: Box::new(with_names(error, &self.names)),
                    });
                }
            });
        }
        let known: Vec<_> = all.iter().flatten().cloned().collect();
        if known.is_empty() && !frames.is_empty() {
            return Err(CaptureError::NoKeySeen);
        }
        let shapes = PrincipalShapes::new(&known, tolerance * to_mesh.factor())?;
        let targets = shapes.shapes.iter().map(|shape| self.displacements(shape));
        Ok(HeadMotion {
            targets: targets.collect::<Result<_, _>>()?,
            keys: all,
            shapes,
            filled,
        })
    }

    /// The surface in one frame, where the head is in a pose; without one, in the coordinates of
    /// the mesh.
    ///
    /// # Errors
    /// [`CaptureError::NoKeySeen`] for a frame in which the motion is empty,
    /// [`CaptureError::NoPlace`] for a motion beyond the range of the numbers, and
    /// [`CaptureError::Mesh`] for a position that is.
    ///
    /// # Panics
    /// Where the motion has no such frame.
    pub fn mesh_in_frame(
        &self,
        motion: &HeadMotion,
        frame: usize,
        pose: Option<Motor<f64>>,
    ) -> Result<Mesh, CaptureError> {
        let keys = motion.keys[frame].as_ref();
        let moved = self.displacements(keys.ok_or(CaptureError::NoKeySeen)?)?;
        let placement = match pose {
            None => Placement::default(),
            Some(pose) => Placement::new(self.fit.to_mesh, pose)?,
        };
        let positions = self.mesh.positions().iter().zip(moved);
        let positions: Vec<_> = positions
            .map(|(&place, by)| placement.apply(Vector::from(place) + by).coordinates())
            .collect();
        Ok(self.mesh.with_positions(positions)?)
    }

    /// What the surface is and how it moves, in metres.
    #[must_use]
    pub fn summary(&self, motion: &HeadMotion) -> SurfaceSummary {
        let metres = self.fit.to_mesh.factor().recip();
        let scaled = |place: Vector<f64>| (place * metres).coordinates();
        let area = self.area_of_key.as_ref();
        let displacements = self.centre_displacements(motion).into_iter();
        SurfaceSummary {
            vertices: self.mesh.vertex_count(),
            keys: self.keys.len(),
            keys_filled: motion.filled,
            key_fit_rms: metres * self.fit.root_mean_square,
            sphere_centre: scaled(self.centre.into()),
            folded_triangles: self.folded_triangles,
            morph_targets: motion.shapes.shapes.len(),
            morph_error_max: metres * motion.shapes.error,
            metres_per_mesh_unit: metres,
            area: AreaSummary {
                key: area.map(|area| area.key.clone()),
                radius: area.map(|area| metres * area.radius),
                vertices: self.area.vertex_count(),
                centre: scaled(self.area.centre_of_gravity().into()),
                centre_kept: self.keeps_centre,
                centre_displacement: displacements.map(|by| by.map(scaled)).collect(),
            },
        }
    }

    /// The displacements of all vertices by those of the keys.
    fn displacements(&self, keys: &[Vector<f64>]) -> Result<Vec<Vector<f64>>, CaptureError> {
        let mut moved = vec![Vector::ZERO; self.mesh.vertex_count()];
        self.motion.displacements(keys, &mut moved)?;
        self.area.apply(&mut moved, self.keeps_centre);
        Ok(moved)
    }

    /// The displacement of the area's centre of gravity in each frame that has displacements.
    fn centre_displacements(&self, motion: &HeadMotion) -> Vec<Option<Vector<f64>>> {
        let targets = motion.targets.iter();
        let parts: Vec<_> = targets.map(|t| self.area.centre_displacement(t)).collect();
        let sum = |weights: &Vec<f64>| {
            let terms = parts.iter().zip(weights);
            terms.fold(Vector::ZERO, |sum, (&part, &weight)| sum + part * weight)
        };
        let mut known = motion.shapes.weights.iter().map(sum);
        let frames = motion.keys.iter();
        let frames = frames.map(|keys| keys.as_ref().and_then(|_| known.next()));
        frames.collect()
    }
}

/// An error of keys with their names.
fn with_names(error: CaptureError, names: &[String]) -> CaptureError {
    let key = |key: usize, problem| CaptureError::Key {
        name: names[key].clone(),
        problem,
    };
    match error {
        CaptureError::KeyNotFinite { key: index } => key(index, KeyProblem::NotFinite),
        CaptureError::KeyAtCentre { key: index } => key(index, KeyProblem::AtCentre),
        CaptureError::SameDirection { first, second, .. } => CaptureError::KeysInOneDirection {
            first: names[first].clone(),
            second: names[second].clone(),
        },
        error => error,
    }
}
