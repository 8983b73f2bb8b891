//! Why points of a head do not determine its pose or its expression.

use ga_mesh::{FormatError, MeshError};
use ga_runtime::geometry::FitError;

/// Why a head cannot be captured: points that do not determine a rigid motion, frames, and surfaces
/// to which motion cannot be carried.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum CaptureError {
    /// A calibrated point does not exist.
    #[error("calibrated point {point} does not exist; there are {points}, which count from 0")]
    NoPoint {
        /// The point.
        point: usize,
        /// How many points there are.
        points: usize,
    },
    /// A calibrated point is named twice.
    #[error("calibrated point {0} is named twice")]
    Twice(usize),
    /// A point at rest is not finite.
    #[error("point {point} at rest is not finite")]
    RestNotFinite {
        /// The point.
        point: usize,
    },
    /// The calibrated points at rest do not determine a pose.
    #[error(transparent)]
    Rest(Box<CaptureError>),
    /// A frame is not valid.
    #[error("frame {frame}: {problem}")]
    Frame {
        /// Which frame, from 0.
        frame: usize,
        /// What is wrong with it.
        problem: Box<CaptureError>,
    },
    /// There are not as many points as at rest.
    #[error("{found} points, but there are {expected} at rest")]
    FrameCounts {
        /// How many there are at rest.
        expected: usize,
        /// How many the frame has.
        found: usize,
    },
    /// A point is not finite.
    #[error("point {point} is not finite")]
    PointNotFinite {
        /// The point.
        point: usize,
    },
    /// Too few calibrated points were seen.
    #[error(
        "{seen} calibrated points are seen, and {needed} are needed; missing: {}",
        list(missing)
    )]
    Missing {
        /// How many calibrated points were seen.
        seen: usize,
        /// How many are needed.
        needed: usize,
        /// The calibrated points that were not seen.
        missing: Vec<usize>,
    },
    /// Those calibrated points that were seen do not determine a pose.
    #[error("{error}; missing: {}", list(missing))]
    PoseOfSeen {
        /// The calibrated points that were not seen.
        missing: Vec<usize>,
        /// Why the others do not determine a pose.
        error: Box<CaptureError>,
    },
    /// There are not as many points as at rest.
    #[error("{rest} points at rest, but {seen} points seen")]
    Counts {
        /// How many there are at rest.
        rest: usize,
        /// How many were seen.
        seen: usize,
    },
    /// There are too few points.
    #[error("{needed} calibrated points are needed for a pose, not {found}")]
    TooFew {
        /// How many there are.
        found: usize,
        /// How many are needed.
        needed: usize,
    },
    /// A coordinate is not finite.
    #[error("calibrated point {point} is not finite")]
    NotFinite {
        /// Which point, from 0.
        point: usize,
    },
    /// All points coincide.
    #[error("all calibrated points {place} are in one place, which does not show a rotation")]
    Coincident {
        /// Which set of points it is.
        place: PointSet,
    },
    /// All points are on one line. Points in one plane do determine a pose.
    #[error(
        "all calibrated points {place} are on one line, about which a rotation cannot be seen \
         (points in one plane are enough)"
    )]
    Collinear {
        /// Which set of points it is.
        place: PointSet,
    },
    /// Several rotations fit equally well.
    #[error("several rotations fit the calibrated points equally well")]
    NotUnique,
    /// Too few points agree with any one motion.
    #[error(
        "no more than {agreeing} of {points} calibrated points agree with one pose, and {needed} \
         are needed"
    )]
    NoConsensus {
        /// How many agree with the best motion.
        agreeing: usize,
        /// How many points there are.
        points: usize,
        /// How many must agree.
        needed: usize,
    },
    /// The threshold is not positive and finite.
    #[error("{0} is not a distance within which points agree")]
    Threshold(f64),
    /// The motion is beyond the range of the numbers.
    #[error("the pose is beyond the range of double precision")]
    OutOfRange,
    /// The conversion description ratio h is not finite.
    #[error("the conversion description ratio h = {0} is not finite")]
    Ratio(f64),
    /// A ratio hᵢ of a time is not finite.
    #[error("the ratio h{time} = {ratio} is not finite")]
    Term {
        /// Its number i, from 1.
        time: usize,
        /// The ratio.
        ratio: f64,
    },
    /// The controllable frame value ϖ is not finite.
    #[error("the controllable frame value ϖ = {0} is not finite")]
    FrameValue(f64),
    /// The sum is beyond the range of the numbers.
    #[error("H is beyond the range of double precision for {terms} terms and ϖ = {frame_value}")]
    DescriptionOutOfRange {
        /// m.
        terms: usize,
        /// ϖ.
        frame_value: f64,
    },
    /// The triangles are not those of a mesh.
    #[error(transparent)]
    Mesh(#[from] MeshError),
    /// The surface has no area.
    #[error("a surface without area has no centre of gravity")]
    NoArea,
    /// A vertex is at the centre of the sphere.
    #[error("vertex {vertex} is at the centre of the sphere, from where it has no direction")]
    VertexAtCentre {
        /// The vertex.
        vertex: usize,
    },
    /// There are no key points.
    #[error("without key points no motion is known")]
    NoKeys,
    /// There are too many key points.
    #[error("{keys} key points are more than {most}")]
    TooManyKeys {
        /// How many there are.
        keys: usize,
        /// How many there may be.
        most: usize,
    },
    /// A key point is not finite.
    #[error("key point {key} is not finite")]
    KeyNotFinite {
        /// The key point.
        key: usize,
    },
    /// A key point is at the centre of the sphere.
    #[error("key point {key} is at the centre of the sphere, from where it has no direction")]
    KeyAtCentre {
        /// The key point.
        key: usize,
    },
    /// Two key points have the same direction.
    #[error(
        "key points {first} and {second} are seen in the same direction from the centre of the \
         sphere, within {angle:.1e} radians"
    )]
    SameDirection {
        /// The first of them.
        first: usize,
        /// The second.
        second: usize,
        /// The angle between their directions.
        angle: f64,
    },
    /// A list has another length than there are key points, or vertices.
    #[error("{found} {what} are given, and there are {expected}")]
    ListCounts {
        /// What is counted.
        what: &'static str,
        /// How many there are.
        expected: usize,
        /// How many were given.
        found: usize,
    },
    /// There are too many vertices and key points.
    #[error("the weights of {keys} key points at {vertices} vertices are too many")]
    TooLarge {
        /// How many vertices there are.
        vertices: usize,
        /// How many key points.
        keys: usize,
    },
    /// A radius or the breadth of a border is not positive and finite.
    #[error("{0} is neither the radius of an area nor the breadth of its border")]
    Radius(f64),
    /// No vertex lies in the area.
    #[error("no vertex of the surface is within {radius} of the place")]
    EmptyArea {
        /// The radius of the area.
        radius: f64,
    },
    /// The tolerance of shapes is negative or not finite.
    #[error("{0} is not a tolerance")]
    Tolerance(f64),
    /// A vertex does not exist.
    #[error("vertex {vertex} does not exist; there are {vertices}, which count from 0")]
    NoVertex {
        /// The vertex.
        vertex: u32,
        /// How many there are.
        vertices: usize,
    },
    /// A key of a head's surface does not move it.
    #[error("key {name} {problem}")]
    Key {
        /// The name of its point.
        name: String,
        /// What is wrong with it.
        problem: KeyProblem,
    },
    /// Two keys of a head's surface have the same direction.
    #[error(
        "keys {first} and {second} are seen in the same direction from the centre of gravity of \
         the mesh"
    )]
    KeysInOneDirection {
        /// The name of the first point.
        first: String,
        /// The name of the second point.
        second: String,
    },
    /// The points at rest and the keys on the mesh have no scale in common.
    #[error("the points at rest and the keys have no scale in common")]
    NoScale,
    /// A point by whose name an area is chosen is not a key.
    #[error("{0:?} is not a key")]
    NotKey(String),
    /// A text is not a key and a radius.
    #[error("expected a key and a positive radius, such as chin:0.04")]
    AreaText,
    /// A surface cannot follow a frame of a table.
    #[error("{place}: {problem}")]
    Row {
        /// The line and the name of the frame.
        place: String,
        /// What is wrong with it.
        problem: Box<CaptureError>,
    },
    /// No frame shows where the head is.
    #[error("no frame has a pose; the first: {problem}")]
    NoPose {
        /// Why the first frame has none.
        problem: Box<CaptureError>,
    },
    /// A frame shows no key.
    #[error("no key is seen")]
    NoKeySeen,
    /// The motion takes the mesh beyond the range of the numbers.
    #[error("the mesh has no place at rest")]
    NoPlace,
    /// The surface and its motion cannot be a file.
    #[error(transparent)]
    Format(Box<FormatError>),
}

/// Why a key does not move the surface of a head.
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
pub enum KeyProblem {
    /// A coordinate is infinite or not a number.
    #[error("is not finite")]
    NotFinite,
    /// It has no direction from the centre.
    #[error("is at the centre of gravity of the mesh")]
    AtCentre,
}

/// The least number of calibrated points.
pub(super) const NEEDED: usize = 3;

/// One of the two sets of points that a pose relates.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum PointSet {
    /// The points at rest.
    Rest,
    /// The points of a frame.
    Seen,
}

impl std::fmt::Display for PointSet {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str(match self {
            Self::Rest => "at rest",
            Self::Seen => "of the frame",
        })
    }
}

impl CaptureError {
    /// What a failed fit means, where the points at rest determine a motion or do not.
    pub(super) fn from_fit(error: FitError<f64>, place: PointSet) -> Self {
        match error {
            FitError::TooFewPairs { found, .. } => Self::TooFew {
                found,
                needed: NEEDED,
            },
            FitError::PairNotFinite { index } => Self::NotFinite { point: index },
            FitError::PairsCoincident => Self::Coincident { place },
            FitError::PairsCollinear => Self::Collinear { place },
            FitError::RotationNotUnique => Self::NotUnique,
            _ => Self::OutOfRange,
        }
    }
}

fn list(points: &[usize]) -> String {
    let names: Vec<_> = points
        .iter()
        .map(|point| format!("point {point}"))
        .collect();
    names.join(", ")
}
