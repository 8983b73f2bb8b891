//! Why data do not form a mesh, or a mesh cannot be processed.

use crate::subdivision::TagProblem;

/// Data that do not form a mesh, or a mesh that cannot be subdivided or have tangents. Vertices,
/// faces and corners are counted from 0.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum MeshError {
    /// A face has fewer than three corners.
    #[error("face {face} has {corners} corners; a polygon has at least 3")]
    FaceTooShort {
        /// The face.
        face: usize,
        /// How many corners it has.
        corners: usize,
    },
    /// A face refers to a vertex that does not exist.
    #[error("face {face} refers to vertex {index}, but there are {vertices} vertices")]
    IndexOutOfRange {
        /// The face.
        face: usize,
        /// The vertex it refers to.
        index: u32,
        /// How many vertices there are.
        vertices: usize,
    },
    /// There are not as many positions as the mesh has vertices.
    #[error("{found} positions for {expected} vertices")]
    VertexCount {
        /// How many vertices there are.
        expected: usize,
        /// How many positions.
        found: usize,
    },
    /// A coordinate of a vertex is infinite or not a number.
    #[error("vertex {vertex} has a coordinate that is not finite: {coordinates:?}")]
    NotFinite {
        /// The vertex.
        vertex: usize,
        /// Its coordinates.
        coordinates: [f64; 3],
    },
    /// A number of an attribute is infinite or not a number.
    #[error("{attribute} {index} is not finite: {value:?}")]
    AttributeNotFinite {
        /// The name of one value of the attribute, such as `"texture coordinate"`.
        attribute: &'static str,
        /// The value.
        index: usize,
        /// Its numbers.
        value: Vec<f64>,
    },
    /// A normal or a tangent has no direction.
    #[error("{attribute} {index} is the zero vector")]
    ZeroVector {
        /// `"normal"` or `"tangent"`.
        attribute: &'static str,
        /// The vector.
        index: usize,
    },
    /// The handedness of a tangent is neither 1 nor −1.
    #[error("the handedness of tangent {index} is {handedness}; it must be 1 or -1")]
    Handedness {
        /// The tangent.
        index: usize,
        /// Its handedness.
        handedness: f64,
    },
    /// The list of an attribute's corners is not as long as the list of face corners.
    #[error("the list of {attribute} indices has {found} entries for {expected} corners of faces")]
    AttributeLength {
        /// The name of one value of the attribute.
        attribute: &'static str,
        /// Corners of faces.
        expected: usize,
        /// Entries in the list.
        found: usize,
    },
    /// A corner refers to a value that does not exist.
    #[error("corner {corner} refers to {attribute} {index}, but there are {values}")]
    AttributeOutOfRange {
        /// The name of one value of the attribute.
        attribute: &'static str,
        /// The corner.
        corner: usize,
        /// The value it refers to.
        index: u32,
        /// How many there are.
        values: usize,
    },
    /// A mesh has colours for some vertices only, or for more than it has.
    #[error("{colours} colours for {vertices} vertices")]
    ColourCount {
        /// How many vertices there are.
        vertices: usize,
        /// How many colours.
        colours: usize,
    },
    /// The list of the faces' materials is not as long as the list of faces.
    #[error("{found} materials of faces for {faces} faces")]
    FaceMaterialCount {
        /// How many faces there are.
        faces: usize,
        /// How many entries the list has.
        found: usize,
    },
    /// A face refers to a material that does not exist.
    #[error("face {face} refers to material {material}, but there are {materials} materials")]
    MaterialOutOfRange {
        /// The face.
        face: usize,
        /// The material it refers to.
        material: u32,
        /// How many there are.
        materials: usize,
    },
    /// A number of a material is outside its range.
    #[error("the {number} of material {material:?} is out of range")]
    MaterialNumber {
        /// The name of the material.
        material: String,
        /// What the number stands for.
        number: &'static str,
    },
    /// A polyline has fewer than two vertices.
    #[error("polyline {polyline} has {vertices} vertices; a polyline has at least 2")]
    PolylineTooShort {
        /// The polyline.
        polyline: usize,
        /// How many vertices it has.
        vertices: usize,
    },
    /// A polyline refers to a vertex that does not exist.
    #[error("polyline {polyline} refers to vertex {index}, but there are {vertices} vertices")]
    PolylineOutOfRange {
        /// The polyline.
        polyline: usize,
        /// The vertex it refers to.
        index: u32,
        /// How many vertices there are.
        vertices: usize,
    },
    /// An element of the list of points refers to a vertex that does not exist.
    #[error("point {point} refers to vertex {index}, but there are {vertices} vertices")]
    PointOutOfRange {
        /// The element of the list.
        point: usize,
        /// The vertex it refers to.
        index: u32,
        /// How many vertices there are.
        vertices: usize,
    },
    /// A group or an object refers to a face that does not exist.
    #[error("group {group:?} refers to face {face}, but there are {faces} faces")]
    GroupOutOfRange {
        /// The name of the group or object.
        group: String,
        /// The face it refers to.
        face: u32,
        /// How many faces there are.
        faces: usize,
    },
    /// More vertices or corners than 32-bit indices can number.
    #[error("{count} {what} are more than 32-bit indices can number")]
    TooLarge {
        /// What there is too much of.
        what: &'static str,
        /// How many there are.
        count: usize,
    },
    /// A mesh without faces was to be subdivided.
    #[error("a mesh without faces cannot be subdivided")]
    NoFaces,
    /// Loop's scheme was to split a face with more than three corners.
    #[error("face {face} has {corners} corners; Loop's scheme takes triangles alone")]
    NotATriangle {
        /// The face.
        face: usize,
        /// How many corners it has.
        corners: usize,
    },
    /// A face has the same vertex at two of its corners.
    #[error("face {face} has vertex {vertex} at two of its corners")]
    DegenerateFace {
        /// The face.
        face: usize,
        /// The vertex.
        vertex: u32,
    },
    /// More than two faces meet at an edge.
    #[error("{faces} faces meet at the edge between vertices {a} and {b}; at most 2 may")]
    NonManifoldEdge {
        /// Its lower vertex.
        a: u32,
        /// Its higher vertex.
        b: u32,
        /// How many faces.
        faces: usize,
    },
    /// A crease lies between vertices that no face joins.
    #[error("no edge joins vertices {a} and {b}, between which crease {crease} should lie")]
    NoEdge {
        /// Which of the creases, from 0.
        crease: usize,
        /// Its first vertex.
        a: u32,
        /// Its second vertex.
        b: u32,
    },
    /// A sharp corner lies at a vertex that does not exist.
    #[error("corner {corner} lies at vertex {vertex}, but there are {vertices} vertices")]
    NoVertex {
        /// Which of the corners, from 0.
        corner: usize,
        /// Its vertex.
        vertex: u32,
        /// How many vertices there are.
        vertices: usize,
    },
    /// A sharpness is negative or not a number.
    #[error("{sharpness} is not a sharpness, which is at least 0 ({kind} {index})")]
    Sharpness {
        /// `"crease"` or `"corner"`.
        kind: &'static str,
        /// Which of these, from 0.
        index: usize,
        /// The sharpness.
        sharpness: f64,
    },
    /// The refined mesh would have more elements than 32-bit indices can number.
    #[error("the refined mesh would have {count} {what}, more than 32-bit indices can number")]
    RefinedTooLarge {
        /// What there would be too much of.
        what: &'static str,
        /// How many there would be.
        count: u64,
    },
    /// The list of values is not as long as the list of corners or vertices.
    #[error("{found} {what} were given for {expected}")]
    Length {
        /// What the list holds.
        what: &'static str,
        /// How many there must be.
        expected: usize,
        /// How many there are.
        found: usize,
    },
    /// A line of the text of [`Tags`](crate::subdivision::Tags) is wrong.
    #[error("line {line}: {problem}")]
    Tag {
        /// The line, from 1.
        line: usize,
        /// What is wrong.
        problem: TagProblem,
    },
    /// The mesh has no such set of texture coordinates.
    #[error("the mesh has no set {set} of texture coordinates")]
    NoTextureCoordinates {
        /// The set, from 0.
        set: usize,
    },
    /// A coordinate of a vertex is too large for single precision.
    #[error("vertex {vertex} is too far away for single precision: {coordinates:?}")]
    TooFar {
        /// The vertex.
        vertex: usize,
        /// Its coordinates.
        coordinates: [f64; 3],
    },
    /// A texture coordinate is too large for single precision.
    #[error("texture coordinate {index} is too large for single precision: {value:?}")]
    TextureTooLarge {
        /// The texture coordinate.
        index: usize,
        /// Its value.
        value: [f64; 2],
    },
}
