//! Why a scene cannot be drawn.

/// A scene, camera or style that cannot be drawn. Elements are counted from 0.
#[derive(Clone, Copy, Debug, PartialEq, thiserror::Error)]
pub enum RenderError {
    /// A position has a coordinate that is NaN, infinite, or beyond 10³⁰.
    #[error(
        "vertex {vertex} of object {object} has a coordinate that is not finite or beyond 1e30"
    )]
    Position {
        /// Index of the object.
        object: usize,
        /// Index of the vertex.
        vertex: usize,
    },
    /// A triangle names a vertex that does not exist.
    #[error(
        "triangle {triangle} of object {object} names vertex {vertex}, but there are {vertices} \
         vertices"
    )]
    Triangle {
        /// Index of the object.
        object: usize,
        /// Index of the triangle.
        triangle: usize,
        /// The vertex it names.
        vertex: u32,
        /// The number of vertices there are.
        vertices: usize,
    },
    /// The values of an attribute do not fit the object.
    #[error("the {attribute} of object {object}: {problem} (element {element})")]
    Attribute {
        /// Index of the object.
        object: usize,
        /// Which attribute, such as `normals`.
        attribute: &'static str,
        /// What is wrong with it.
        problem: &'static str,
        /// Index of the faulty value or triangle, or the number of values where that is wrong.
        element: usize,
    },
    /// An object names a material that does not exist.
    #[error("object {object} names material {material}, but there are {materials} materials")]
    MaterialIndex {
        /// Index of the object.
        object: usize,
        /// The material it names.
        material: u32,
        /// The number of materials there are.
        materials: usize,
    },
    /// A number of a material is out of range.
    #[error("the {quantity} of material {material} is out of range")]
    Material {
        /// Index of the material.
        material: usize,
        /// Which number.
        quantity: &'static str,
    },
    /// The transform of an object is not a rigid motion, or takes a vertex beyond 10³⁰.
    #[error("the transform of object {object} is not a rigid motion of moderate size")]
    Transform {
        /// Index of the object.
        object: usize,
    },
    /// A line has a point that is not finite or beyond 10³⁰, or a colour or width that is not
    /// finite or negative.
    #[error("line {line} has a point, colour or width that is not finite or is out of range")]
    Line {
        /// Index of the line.
        line: usize,
    },
    /// A dot has a position that is not finite or beyond 10³⁰, or a colour or diameter that is not
    /// finite or negative.
    #[error("dot {dot} has a position, colour or diameter that is not finite or is out of range")]
    Dot {
        /// Index of the dot.
        dot: usize,
    },
    /// An end of a bone has a coordinate that is NaN, infinite, or beyond 10³⁰.
    #[error("bone {bone} has an end with a coordinate that is not finite or beyond 1e30")]
    Bone {
        /// Index of the bone.
        bone: usize,
    },
    /// There are more triangles than 32-bit numbers can tell apart.
    #[error("there are {0} triangles, more than 32-bit numbers can tell apart")]
    TooManyTriangles(usize),
    /// The ground's height is not finite or its grid is not positive.
    #[error("the ground's height is not finite or its grid not positive")]
    Ground,
    /// The camera is not usable; the text says why.
    #[error("invalid camera: {0}")]
    Camera(&'static str),
    /// The lens of a camera has distortion, which is not drawn.
    #[error("the lens of the camera has distortion, which is not drawn")]
    Lens,
    /// The style is not usable; the text says why.
    #[error("invalid picture: {0}")]
    Style(&'static str),
}
