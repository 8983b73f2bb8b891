//! Wavefront MTL: the libraries of materials of OBJ files.
//!
//! | line | read as |
//! | --- | --- |
//! | `newmtl name` | the following lines describe this material |
//! | `Kd r g b` | the base colour |
//! | `d α`, `Tr 1−α` | the opacity; below 1 what lies behind shows through |
//! | `Ke r g b` | the emission |
//! | `Pr`, `Pm` | roughness and metallic part, as many programs write them |
//! | `Ka`, `Ks`, `Ns`, `Ni`, `illum` | [`Phong`](crate::Phong)'s model as it stands |
//! | `map_Kd`, `map_Ke` | factors of the base colour and of the emission |
//! | `norm`, `map_Kn` | normals in the tangent frame; `-bm` scales them |
//! | `map_Pr`, `map_Pm` | roughness and metallic part, where both name one picture |
//! | `map_Ka`, `map_Ks`, `map_Ns`, `map_d`, `bump`, `map_bump` | the pictures of Phong's model |
//! | `Tf`, `sharpness`, `refl`, `disp`, `decal`, `Ps`, `Pc`, `aniso` and the like | ignored |
//!
//! A [tolerant](ga_files::Reading) reading also takes the following, with one warning for each kind
//! that names its first line and says how many there are:
//!
//! | line | read as | as by |
//! | --- | --- | --- |
//! | an unknown word | ignored, in a strict reading too | Blender, assimp, tinyobjloader |
//! | a word without its number, a colour of two | ignored | |
//! | more numbers than the line has place for | the first ones | Blender, tinyobjloader |
//! | `Kd spectral …`, `Kd xyz …` | ignored | |
//! | `newmtl` without a name | left out, since nothing can name it | |
//! | a property before the first `newmtl` | ignored | Blender, assimp |
//! | an option of a picture without its value | ignored | |
//! | lines that end in CR alone | lines | assimp, tinyobjloader |
//! | text that is not UTF-8 | see [`ga_files::text::decode`] | |
//!
//! Where `d` and `Tr` of a material state different opacities, that by `d` counts, as in
//! tinyobjloader, with a warning. Text in the place of a number, NaN and infinity are errors.
//!
//! Without `Pr` the roughness follows from `Ns` by the formula of [`Material`]. Without `Ns` the
//! exponent is 0. `illum 0` stands for an unlit surface. A colour of one number is grey. Numbers
//! are taken as linear light, and those beyond their range as the nearest within it, since MTL
//! allows for them.
//!
//! A picture is a path, whose `\` become `/`, after options: `-o` and `-s` place it, `-clamp on`
//! does not repeat it, `-bm` scales bumps and normals, `-imfchan` chooses a channel; others are
//! checked for their number of words and ignored. An option that does not exist is ignored with the
//! word after it, its value, and a picture without a path is left out, both with a warning.
//!
//! Source: Wavefront, *MTL material format (Lightwave, OBJ)*, version 4.2, 1995; `Pr`, `Pm`, `Ke`
//! and `norm` from Exocortex, *Physically-Based Rendering in MTL*, 2013.

mod parser;
mod problem;
mod remarks;
mod texture;
mod write;

use ga_files::{Deviation, Reading};

use crate::{FormatError, Material};

pub(super) use parser::{Fault, Library, library};
pub use problem::MtlProblem;
pub use write::encode;

/// Reads the materials of a library tolerantly, in its order.
///
/// # Errors
///
/// [`FormatError`], for the first faulty line.
///
/// # Examples
///
/// ```
/// let materials = ga_mesh::obj::mtl::decode(b"newmtl brick\nKd 0.5 0.1 0.1\nNs 30\n")?;
/// assert_eq!(materials[0].base_colour, [0.5, 0.1, 0.1, 1.0]);
/// assert_eq!(materials[0].roughness, 0.5);
///
/// let error = ga_mesh::obj::mtl::decode(b"newmtl brick\nKd red\n").unwrap_err();
/// assert_eq!(error.to_string(), "line 2: \"red\" is not a number");
/// # Ok::<(), ga_mesh::FormatError>(())
/// ```
pub fn decode(bytes: &[u8]) -> Result<Vec<Material>, FormatError> {
    decode_with_warnings(bytes, Reading::Tolerant).map(|(materials, _)| materials)
}

/// Reads the materials of a library, and says what in it deviates from the format, each kind once.
///
/// # Errors
///
/// As [`decode`]; for a strict reading also what other readers tolerate.
///
/// # Examples
///
/// ```
/// use ga_files::Reading;
/// use ga_mesh::obj::mtl;
///
/// let library = b"newmtl brick\nmap_Kd -colorspace sRGB brick.png\n";
/// let (materials, warnings) = mtl::decode_with_warnings(library, Reading::Tolerant)?;
/// assert_eq!(materials[0].textures().count(), 1);
/// let message = "line 2: map_Kd has no option -colorspace; this is ignored";
/// assert_eq!(warnings[0].to_string(), message);
/// # Ok::<(), ga_mesh::FormatError>(())
/// ```
pub fn decode_with_warnings(
    bytes: &[u8],
    reading: Reading,
) -> Result<(Vec<Material>, Vec<Deviation<MtlProblem>>), FormatError> {
    library(bytes, reading).map_err(|(line, problem)| FormatError::Mtl { line, problem })
}
