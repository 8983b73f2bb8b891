//! Wavefront OBJ: polygon meshes as text, read strictly and in file order, with their materials.
//!
//! Vertex n of the mesh is the n-th `v` line of the file, also when no face uses it, so that
//! weights and other data numbered by vertex fit. Every number must be finite and every index in
//! range; an error names the line and the faulty word.
//!
//! | line | read as |
//! | --- | --- |
//! | `v x y z`, `v x y z w` | a vertex; w is checked and ignored |
//! | `v x y z r g b`, `v x y z r g b a` | a vertex with its colour, and its opacity |
//! | `vt u`, `vt u v`, `vt u v w` | a texture coordinate (u, v); v is 0 when left out |
//! | `vn x y z` | a normal, made a unit vector; corners with a zero one have none |
//! | `f a b c …` | a polygon; each corner is `v`, `v/vt`, `v//vn` or `v/vt/vn` |
//! | `l a b …`, `p a …` | a polyline of corners `v` or `v/vt`, points; their `vt` is ignored |
//! | `g name …` | the following faces belong to these groups |
//! | `o name` | the following faces belong to this object |
//! | `mtllib file`, `usemtl name` | the following faces have this material; see [`mtl`] |
//! | `s` and other attributes | ignored; the normals say what is smooth |
//! | `curv`, `surf` and other free-form geometry, unknown words | an error |
//!
//! Indices count from 1, or from −1 backwards from the latest element.
//!
//! A line that ends in `\` continues on the next one. Line ends may be LF or CR LF. A word that
//! begins with `#` begins a comment, which ends with its line and may be in any encoding;
//! everything else is UTF-8.
//!
//! Colours of vertices are taken as sRGB, as most programs write them, and become linear light.
//! Their numbers are from 0 to 1. Where one is above 1 and all of the file are whole numbers from 0
//! to 255, they are divided by 255, with a [`Warning`]; the same holds for opacities. Other numbers
//! are an error.
//! Where some vertices have a colour, those without are white. `usemtl` without a name or with the
//! name `(null)` stands for no material.
//!
//! # Materials
//!
//! [`decode`] sees one file only, so that materials have their names and are the default otherwise.
//! [`read`] looks for the libraries beside the file. A library that does not exist and a material
//! that no library defines are not errors, since many meshes are passed on without them: the
//! material is then the default one with its name. [`read_with_warnings`] says so in a list of
//! [`Warning`]s. A library with a fault in it is an error that names both files and lines.
//!
//! The reader does not use `tobj`, which numbers vertices by group in order of use, drops those
//! that no face uses, accepts NaN and does not report line numbers. A scan of the text before and a
//! table of vertices after it could correct that, but the scan alone already gives the whole mesh.
//! The tests compare the faces with those of `tobj`.
//!
//! Source: Wavefront, *Advanced Visualizer* manual, appendix B1, "Object Files".

mod check;
mod lines;
pub mod mtl;
mod parser;
mod problem;
mod read;
mod statements;
mod write;

pub use problem::ObjProblem;
pub use read::{Warning, decode, decode_with_libraries, read, read_with_warnings};
pub(crate) use write::files;
pub use write::{encode, encode_files, write};

/// A name in a `usemtl` line that stands for no material.
const NO_MATERIAL: &str = "(null)";
