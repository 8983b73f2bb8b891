//! Wavefront OBJ: polygon meshes as text, read in file order, with their materials.
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
//!
//! Indices count from 1, or from −1 backwards from the latest element.
//!
//! A line that ends in `\` continues on the next one. Line ends may be LF or CR LF. A word that
//! begins with `#` begins a comment, which ends with its line and may be in any encoding;
//! everything else is UTF-8. A polygon may name a vertex twice.
//!
//! # Deviations
//!
//! A [tolerant](ga_files::Reading) reading, which [`read`] and [`decode`] do, also takes what other
//! programs read. There is one [`Warning`] for each kind, which names its first line and says how
//! many lines there are. A strict reading makes an error of it.
//!
//! | line | read as | as by |
//! | --- | --- | --- |
//! | `t`, `vw`, `vp`, `curv` and other words | left out | Blender, assimp, three.js, trimesh |
//! | a face of 1 or 2 corners, a polyline of 1 | left out | tinyobjloader, trimesh |
//! | corners as `1/`, `1//`, `1/1/`, `1/1/1/1` | without what does not fit | Blender, trimesh |
//! | `l 1/1/1 …`, `p 1/1 …` | the vertices | tinyobjloader |
//! | corners with `vn` or `vt` that no line has | corners without | Blender, assimp, trimesh |
//! | `v` of 5 or more than 7 numbers | the first 3 or 6 | Blender, tinyobjloader |
//! | `vt` or `vn` of more than 3 numbers | the first ones | Blender, tinyobjloader |
//! | vertices alone | points | Blender, trimesh |
//! | lines that end in CR alone | lines | assimp, tinyobjloader |
//! | names that are not UTF-8 | see [`ga_files::text::decode`] | |
//!
//! In a file without any face, polyline or point, a line that is left out is an error where it may
//! be geometry, as `curv` or a face of two corners: its vertices alone would be another model.
//!
//! An index beyond the end of its list, text in the place of a number, NaN and infinity, and a
//! vertex with fewer than three numbers are errors in either reading.
//!
//! Colours of vertices are taken as sRGB, as most programs write them, and become linear light.
//! Their numbers are from 0 to 1. Where one is above 1 and all of the file are whole numbers from 0
//! to 255, a tolerant reading divides them by 255; the same holds for opacities. Other numbers are
//! an error.
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
mod colours;
mod corner;
mod lines;
pub mod mtl;
mod parser;
mod problem;
mod read;
mod statements;
mod text;
mod write;

pub use problem::ObjProblem;
pub use read::{Warning, decode, decode_with_libraries, read, read_with_warnings};
pub(crate) use write::files;
pub use write::{encode, encode_files, write};

/// A name in a `usemtl` line that stands for no material.
const NO_MATERIAL: &str = "(null)";
