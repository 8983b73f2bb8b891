//! What is wrong with the contents of a mesh file.

use std::fmt;

use crate::gltf::model::ModelProblem;
use crate::gltf::{Element, Problem};
use crate::obj::ObjProblem;
use crate::obj::mtl::MtlProblem;
use crate::ply::{Place, PlyProblem};

/// What is wrong with the contents of a mesh file, or with what is to become such contents, and
/// where.
#[derive(Clone, Debug, PartialEq)]
pub enum FormatError {
    /// In a Wavefront OBJ file.
    Obj {
        /// The line, from 1; for a line continued with `\`, its first line; for what is missing,
        /// the last line.
        line: usize,
        /// What is wrong.
        problem: ObjProblem,
    },
    /// In a library of materials, Wavefront MTL.
    Mtl {
        /// The line, from 1; for a line continued with `\`, its first line.
        line: usize,
        /// What is wrong.
        problem: MtlProblem,
    },
    /// In a PLY file.
    Ply {
        /// Where.
        place: Place,
        /// What is wrong.
        problem: PlyProblem,
    },
    /// In a glTF file or a [`Document`](crate::gltf::Document). Elements are counted from 0, as in
    /// the file.
    Gltf {
        /// The faulty element, last, and before it those that lead to it, from the outside in, as
        /// the attribute that refers to an accessor.
        path: Vec<Element>,
        /// What is wrong with the element.
        problem: Problem,
    },
    /// In a [`Model`](crate::gltf::model::Model) that is to become a glTF file.
    Model(ModelProblem),
}

impl FormatError {
    /// A problem of an element of glTF.
    pub(crate) fn gltf(element: Element, problem: Problem) -> Self {
        let path = vec![element];
        Self::Gltf { path, problem }
    }

    /// A reference of glTF to an element that does not exist. The element that refers to it is
    /// added by [`FormatError::within`].
    pub(crate) fn dangling(what: &'static str, index: usize, count: usize) -> Self {
        Self::gltf(Element::File, Problem::OutOfRange { what, index, count })
    }

    /// The same error, found in what the element `user` of glTF refers to.
    pub(crate) fn within(mut self, user: Element) -> Self {
        if let Self::Gltf { path, .. } = &mut self {
            match path.first_mut() {
                Some(element) if *element == Element::File => *element = user,
                Some(element) if *element == user => {}
                _ => path.insert(0, user),
            }
        }
        self
    }
}

impl std::error::Error for FormatError {}

impl fmt::Display for FormatError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Obj { line, problem } => write!(f, "line {line}: {problem}"),
            Self::Mtl { line, problem } => write!(f, "line {line}: {problem}"),
            Self::Ply { place, problem } => write!(f, "{place}{problem}"),
            Self::Gltf { path, problem } => {
                for element in path {
                    write!(f, "{element}: ")?;
                }
                problem.fmt(f)
            }
            Self::Model(problem) => problem.fmt(f),
        }
    }
}

impl From<ModelProblem> for FormatError {
    fn from(problem: ModelProblem) -> Self {
        Self::Model(problem)
    }
}
