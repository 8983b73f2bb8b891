//! A figure as files: OBJ at rest, binary glTF with its motion.

use ga_anim::clip::Clip;
use ga_anim::motion_file::Loss;
use ga_mesh::obj;
use serde::{Serialize, Serializer};

use crate::error::CharacterError;
use crate::figure::Figure;
use crate::gltf;

/// The name of the mesh at rest, as OBJ.
const OBJ: &str = "model.obj";

/// The name of the mesh with its motion, as binary glTF.
pub const GLB: &str = "model.glb";

/// The names of the material and of the picture on a painted skin.
const MTL: &str = "model.mtl";
const SKIN: &str = "skin.png";

/// The names of all files of a model.
pub const NAMES: [&str; 4] = [OBJ, GLB, MTL, SKIN];

/// A file of a figure. Serialised, it has the number of bytes in place of its contents.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct File {
    /// Its name.
    pub name: &'static str,
    /// What it contains.
    #[serde(rename = "bytes", serialize_with = "length")]
    pub contents: Vec<u8>,
    /// The vertices of the figure, in the file of a mesh.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub vertices: Option<usize>,
    /// Width and height of a picture.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub pixels: Option<[usize; 2]>,
}

fn length<S: Serializer>(contents: &[u8], serializer: S) -> Result<S::Ok, S::Error> {
    contents.len().serialize(serializer)
}

/// The mesh at rest, in metres, and the mesh with skeleton, skin weights and one animation; then
/// the material and the picture that the first refers to, if the figure is painted. The result also
/// says what of the motion is not in the second.
///
/// # Errors
///
/// [`CharacterError::Encode`] for a painted skin without pixels, [`CharacterError::Document`] for a
/// clip of another skeleton, and [`CharacterError::Gltf`] where numbers do not fit the format.
pub fn files(
    figure: &Figure,
    clip: &Clip,
    clip_name: &str,
) -> Result<(Vec<File>, Vec<Loss>), CharacterError> {
    let mesh = &figure.character.mesh;
    let file = |name, contents| File {
        name,
        contents,
        vertices: None,
        pixels: None,
    };
    let of_mesh = |name, contents| File {
        vertices: Some(mesh.vertex_count()),
        ..file(name, contents)
    };
    let (glb, losses) = gltf::encode(figure, clip, clip_name)?;
    let glb = of_mesh(GLB, glb);
    let Some((png, paint)) = figure.png()?.zip(figure.paint.as_ref()) else {
        let text = obj::encode(mesh);
        return Ok((vec![of_mesh(OBJ, text.into_bytes()), glb], losses));
    };
    let material = ga_mesh::Material {
        roughness: gltf::ROUGHNESS,
        base_colour_texture: Some(ga_mesh::Texture::file(SKIN)),
        ..ga_mesh::Material::named(gltf::MATERIAL)
    };
    let faces = vec![Some(0); mesh.faces().len()];
    let mesh = mesh.clone().with_materials(vec![material], faces)?;
    let written = obj::encode_files(&mesh, "model");
    let mut files: Vec<File> = written
        .into_iter()
        .zip([OBJ, MTL])
        .map(|((_, contents), name)| file(name, contents))
        .collect();
    if let Some(obj) = files.first_mut() {
        obj.vertices = Some(mesh.vertex_count());
    }
    files.insert(1, glb);
    files.push(File {
        pixels: Some([paint.width(), paint.height()]),
        ..file(SKIN, png)
    });
    Ok((files, losses))
}
