//! Vertices bound to joints, for many frames.

use ga_runtime::batch::Batch;
use ga_runtime::batch::skin::{AffinePalette, Chunk, Mix, MotorPalette, Posed, Skin, SkinScalar};
use ga_runtime::cga3::Point;
use ga_runtime::vga3::Vector;

use super::palette::Kind;
use super::{Method, Palette};
use crate::weights::SkinWeights;
use crate::weights::error::SkinError;

/// Meshes with at least this many vertices are moved on all threads; for fewer, starting the
/// threads costs more than they save.
const PARALLEL: usize = 1 << 18;

/// The fewest chunks that are worth a thread.
const CHUNKS: usize = 8;

/// The vertices of a mesh at rest with their weights, prepared for many frames.
///
/// The vertices are ordered by their number of influences, so that a vertex with one influence
/// costs less than one with eight. A frame is a [`Palette`]; moving the vertices allocates nothing,
/// and gives the same result for any number of threads.
///
/// # Examples
///
/// ```
/// use ga_anim::skin::{Binding, Method, Posed};
/// use ga_anim::weights::SkinWeights;
/// use ga_runtime::cga3::{Motor, Point, Rotor};
/// use ga_runtime::vga3::Vector;
///
/// let rest = [Point::new(1.0_f32, 0.0, 0.0), Point::new(2.0, 0.0, 0.0)];
/// let weights = SkinWeights::new(2, [vec![(0, 1.0)], vec![(0, 0.5), (1, 0.5)]])?;
/// let binding = Binding::new(&rest, &weights)?.with_normals(&[Vector::new(1.0, 0.0, 0.0); 2])?;
///
/// let mut palette = binding.palette(Method::Motor);
/// let (mut points, mut normals) = (rest, [Vector::default(); 2]);
/// for frame in 0..3 {
///     let rotor = Rotor::from_axis_angle([0.0, 0.0, 1.0], 0.5 * frame as f32).ok_or("no axis")?;
///     palette.set_motions(&[Motor::default(), Motor::from(rotor)])?;
///     let posed = Posed { points: &mut points, normals: &mut normals, tangents: &mut [] };
///     binding.pose(&palette, posed)?;
/// }
/// // The blend of no rotation and one by 1 rad is a rotation by 0.5 rad.
/// assert!((points[1].coordinates()[0] - 2.0 * 0.5_f32.cos()).abs() < 1e-6);
/// assert!((normals[1].y() - 0.5_f32.sin()).abs() < 1e-6);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug)]
pub struct Binding<S> {
    pub(super) skin: Skin<S>,
}

impl<S: SkinScalar> Binding<S> {
    /// Binds vertices to the joints that move them.
    ///
    /// # Errors
    ///
    /// [`SkinError::VertexCount`] and [`SkinError::TooLarge`].
    pub fn new(positions: &[Point<S>], weights: &SkinWeights) -> Result<Self, SkinError> {
        let (expected, found) = (positions.len(), weights.vertex_count());
        if expected != found {
            return Err(SkinError::VertexCount { expected, found });
        }
        let rows = weights.iter().map(|influences| {
            influences
                .iter()
                .map(|influence| (influence.joint, S::from_f64(influence.weight)))
        });
        let skin = Skin::new(weights.joint_count(), positions, rows)?;
        Ok(Self { skin })
    }

    /// Adds the normals of the vertices at rest, of any length.
    ///
    /// # Errors
    ///
    /// [`SkinError::VertexCount`] when there is not one for each vertex.
    pub fn with_normals(self, normals: &[Vector<S>]) -> Result<Self, SkinError> {
        let skin = self.skin.with_normals(normals)?;
        Ok(Self { skin })
    }

    /// Adds the tangents of the vertices at rest, of any length. Their handedness does not change.
    ///
    /// # Errors
    ///
    /// [`SkinError::VertexCount`] when there is not one for each vertex.
    pub fn with_tangents(self, tangents: &[Vector<S>]) -> Result<Self, SkinError> {
        let skin = self.skin.with_tangents(tangents)?;
        Ok(Self { skin })
    }

    /// Takes other places of the vertices at rest, as morph targets give them. Weights, normals and
    /// tangents stay.
    ///
    /// # Errors
    ///
    /// [`SkinError::VertexCount`] when there is not one for each vertex. Then nothing changes.
    pub fn set_points(&mut self, positions: &[Point<S>]) -> Result<(), SkinError> {
        Ok(self.skin.set_points(positions)?)
    }

    /// The number of vertices.
    #[must_use]
    pub fn vertex_count(&self) -> usize {
        self.skin.len()
    }

    /// The number of joints.
    #[must_use]
    pub fn joint_count(&self) -> usize {
        self.skin.joints()
    }

    /// A palette of joints at rest, for frames of this binding.
    #[must_use]
    pub fn palette(&self, method: Method) -> Palette<S> {
        Palette::new(&self.skin, method)
    }

    /// Moves the vertices by the motions of a frame, and the normals and tangents where there is
    /// room for them.
    ///
    /// # Errors
    ///
    /// [`SkinError::VertexCount`] where a list that is not empty has another length, and
    /// [`SkinError::JointCount`] for the palette of another binding. [`SkinError::NoDirections`]
    /// where normals or tangents are asked for and the binding has none. Then nothing is written.
    pub fn pose(&self, palette: &Palette<S>, posed: Posed<'_, S>) -> Result<(), SkinError> {
        self.check(&posed)?;
        self.check_palette(palette)?;
        let work = match &palette.kind {
            Kind::Affine(palette) => Work::Affine(palette),
            Kind::Motors { palette, .. } => Work::Motors(palette),
        };
        self.run(&work, posed)
    }

    /// Moves the vertices to places between those of a linear blend and of a blend of motors, by a
    /// share for all or for each vertex: 0 is the linear blend, 1 the blend of motors.
    ///
    /// # Errors
    ///
    /// As [`pose`](Self::pose), and [`SkinError::NotBoth`] when the first palette is not of
    /// [`Method::Linear`], or the second is.
    pub fn pose_mixed(
        &self,
        linear: &Palette<S>,
        motors: &Palette<S>,
        mix: Mix<'_, S>,
        posed: Posed<'_, S>,
    ) -> Result<(), SkinError> {
        self.check(&posed)?;
        self.check_palette(linear)?;
        self.check_palette(motors)?;
        if let Mix::Each(shares) = mix {
            let (expected, found) = (self.vertex_count(), shares.len());
            if expected != found {
                return Err(SkinError::VertexCount { expected, found });
            }
        }
        let (
            Kind::Affine(maps),
            Kind::Motors {
                palette: motors, ..
            },
        ) = (&linear.kind, &motors.kind)
        else {
            return Err(SkinError::NotBoth);
        };
        self.run(&Work::Both(maps, motors, mix), posed)
    }

    fn run(&self, work: &Work<'_, S>, posed: Posed<'_, S>) -> Result<(), SkinError> {
        let chunks = self.skin.chunks();
        if self.vertex_count() < PARALLEL || rayon::current_num_threads() < 2 {
            move_chunks(work, chunks, posed)
        } else {
            move_on_threads(work, chunks, posed)
        }
    }

    fn check(&self, posed: &Posed<'_, S>) -> Result<(), SkinError> {
        let expected = self.vertex_count();
        let directions = [posed.normals.len(), posed.tangents.len()];
        let asked = directions.into_iter().filter(|&length| length > 0);
        for found in [posed.points.len()].into_iter().chain(asked) {
            if found != expected {
                return Err(SkinError::VertexCount { expected, found });
            }
        }
        let lacks = |length: usize, has: bool| length > 0 && !has;
        if lacks(directions[0], self.skin.has_normals())
            || lacks(directions[1], self.skin.has_tangents())
        {
            return Err(SkinError::NoDirections);
        }
        Ok(())
    }

    fn check_palette(&self, palette: &Palette<S>) -> Result<(), SkinError> {
        let (expected, found) = (self.joint_count(), palette.joint_count());
        if expected != found {
            return Err(SkinError::JointCount { expected, found });
        }
        Ok(())
    }
}

/// How the chunks are moved.
enum Work<'a, S> {
    Affine(&'a AffinePalette<S>),
    Motors(&'a MotorPalette<S>),
    Both(&'a AffinePalette<S>, &'a MotorPalette<S>, Mix<'a, S>),
}

fn move_chunks<S: SkinScalar>(
    work: &Work<'_, S>,
    chunks: &[Chunk<S>],
    mut posed: Posed<'_, S>,
) -> Result<(), SkinError> {
    let batch = Batch::new();
    for chunk in chunks {
        let range = chunk.range();
        let (here, rest) = split(posed, range.len());
        posed = rest;
        match work {
            Work::Affine(palette) => batch.skin_by_affine_maps(chunk, palette, here)?,
            Work::Motors(palette) => batch.skin_by_motors(chunk, palette, here)?,
            Work::Both(maps, motors, mix) => {
                let mix = match mix {
                    Mix::Whole(share) => Mix::Whole(*share),
                    Mix::Each(shares) => Mix::Each(&shares[range]),
                };
                batch.skin_by_both(chunk, maps, motors, mix, here)?;
            }
        }
    }
    Ok(())
}

fn move_on_threads<S: SkinScalar>(
    work: &Work<'_, S>,
    chunks: &[Chunk<S>],
    posed: Posed<'_, S>,
) -> Result<(), SkinError> {
    if chunks.len() < 2 * CHUNKS {
        return move_chunks(work, chunks, posed);
    }
    let (left, right) = chunks.split_at(chunks.len() / 2);
    let length = left.iter().map(|chunk| chunk.range().len()).sum();
    let (first, rest) = split(posed, length);
    let (left, right) = rayon::join(
        || move_on_threads(work, left, first),
        || move_on_threads(work, right, rest),
    );
    left.and(right)
}

/// The places of the first vertices, and those of the others.
fn split<S>(posed: Posed<'_, S>, length: usize) -> (Posed<'_, S>, Posed<'_, S>) {
    let (points, other_points) = posed.points.split_at_mut(length);
    let at = |list: &[Vector<S>]| if list.is_empty() { 0 } else { length };
    let (normals, other_normals) = {
        let at = at(posed.normals);
        posed.normals.split_at_mut(at)
    };
    let (tangents, other_tangents) = {
        let at = at(posed.tangents);
        posed.tangents.split_at_mut(at)
    };
    (
        Posed {
            points,
            normals,
            tangents,
        },
        Posed {
            points: other_points,
            normals: other_normals,
            tangents: other_tangents,
        },
    )
}
