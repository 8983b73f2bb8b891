//! Meshes as OBJ files.

use std::collections::HashSet;
use std::fmt::Write;
use std::path::Path;
use std::sync::Arc;

use ga_files::WriteError;

use super::{NO_MATERIAL, mtl};
use crate::colour_space::srgb_from_linear;
use crate::{CornerAttribute, Group, Image, Mesh};

/// Writes a mesh to an OBJ file, and beside it the files of [`encode_files`], all of them or none.
///
/// # Errors
///
/// [`WriteError`]; earlier files of these names then stay as they were.
pub fn write(path: impl AsRef<Path>, mesh: &Mesh) -> Result<(), WriteError> {
    let path = path.as_ref();
    let files = files(path, mesh);
    if let [(_, contents)] = &files[..] {
        return ga_files::write(path, contents);
    }
    let folder = match path.parent() {
        Some(folder) if !folder.as_os_str().is_empty() => folder,
        _ => Path::new("."),
    };
    let files = files.iter();
    ga_files::write_all(
        folder,
        files.map(|(name, contents)| (name.as_str(), &contents[..])),
    )
}

/// The names and contents of the files that [`write`] writes, that of the path first.
pub(crate) fn files(path: &Path, mesh: &Mesh) -> Vec<(String, Vec<u8>)> {
    let stem = path.file_stem().unwrap_or_default().to_string_lossy();
    let mut files = encode_files(mesh, &stem);
    if let (Some((first, _)), Some(name)) = (files.first_mut(), path.file_name()) {
        *first = name.to_string_lossy().into_owned();
    }
    files
}

/// A mesh as the text of an OBJ file, which names materials but no library of them.
///
/// Numbers are written so that reading them gives the same `f64` back; colours of vertices, which
/// become sRGB without opacity, are rounded to 14 decimals. Names of groups must be single words,
/// those of objects and materials words with single spaces between them: characters that these
/// cannot have (other white space, `#`, `\`) become `_`, and a name that was used before gets a
/// number at its end. OBJ has no place for tangents and for sets of
/// texture coordinates other than the first; these are left out.
///
/// # Examples
///
/// ```
/// let mesh = ga_mesh::obj::decode(b"v 0 0 0\nv 1 0 0\nv 0 0.5 0\nf 1 2 3\n")?;
/// assert_eq!(
///     ga_mesh::obj::encode(&mesh),
///     "v 0.0 0.0 0.0\nv 1.0 0.0 0.0\nv 0.0 0.5 0.0\nf 1 2 3\n"
/// );
/// # Ok::<(), ga_mesh::FormatError>(())
/// ```
#[must_use]
pub fn encode(mesh: &Mesh) -> String {
    let mut text = String::new();
    // Writing to a String cannot fail.
    let _ = write_to(&mut text, mesh, &material_names(mesh));
    text
}

/// A mesh as files, each with its name and contents: `stem.obj`; `stem.mtl` if there are materials;
/// and the embedded images, as `stem-1.png` and so on. Other images keep their paths. In the names
/// of all but the first file, characters that lines of OBJ and MTL cannot have become `_`.
///
/// # Examples
///
/// ```
/// use ga_mesh::{Faces, Material, Mesh, obj};
///
/// let corners = vec![[0.0; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]];
/// let mesh = Mesh::new(corners, Faces::from_polygons([[0, 1, 2]])?)?
///     .with_materials(vec![Material::named("red")], vec![Some(0)])?;
/// let names = obj::encode_files(&mesh, "corner").into_iter().map(|(name, _)| name);
/// assert_eq!(names.collect::<Vec<_>>(), ["corner.obj", "corner.mtl"]);
/// # Ok::<(), ga_mesh::MeshError>(())
/// ```
#[must_use]
pub fn encode_files(mesh: &Mesh, stem: &str) -> Vec<(String, Vec<u8>)> {
    let names = material_names(mesh);
    let first = format!("{stem}.obj");
    let stem = &file_stem(stem);
    let mut text = String::new();
    if !mesh.materials().is_empty() {
        text = format!("mtllib {stem}.mtl\n");
    }
    // Writing to a String cannot fail.
    let _ = write_to(&mut text, mesh, &names);
    let mut files = vec![(first, text.into_bytes())];
    if mesh.materials().is_empty() {
        return files;
    }
    let images = embedded_images(mesh);
    let name_of = |index: usize, media_type: &str| {
        let ending = match media_type {
            "image/jpeg" => "jpg",
            _ => "png",
        };
        format!("{stem}-{}.{ending}", index + 1)
    };
    let path_of = |image: &Image| match image {
        Image::File(path) => path.clone(),
        Image::Embedded { media_type, bytes } => {
            let index = images.iter().position(|(_, other)| other == bytes);
            name_of(index.unwrap_or_default(), media_type)
        }
    };
    let named = names.iter().map(String::as_str).zip(mesh.materials());
    let library = mtl::encode(named, path_of);
    files.push((format!("{stem}.mtl"), library.into_bytes()));
    for (index, (media_type, bytes)) in images.iter().enumerate() {
        files.push((name_of(index, media_type), bytes.to_vec()));
    }
    files
}

/// The embedded images, each once.
fn embedded_images(mesh: &Mesh) -> Vec<(String, Arc<[u8]>)> {
    let mut images: Vec<(String, Arc<[u8]>)> = Vec::new();
    for texture in mesh
        .materials()
        .iter()
        .flat_map(|material| material.textures())
    {
        if let Image::Embedded { media_type, bytes } = &texture.image
            && images.iter().all(|(_, other)| other != bytes)
        {
            images.push((media_type.clone(), bytes.clone()));
        }
    }
    images
}

fn material_names(mesh: &Mesh) -> Vec<String> {
    let names = mesh.materials().iter().map(|material| &material.name[..]);
    different(names.map(phrase), &[NO_MATERIAL])
}

fn group_names(groups: &[Group]) -> Vec<String> {
    different(groups.iter().map(|group| word(&group.name)), &[])
}

fn object_names(objects: &[Group]) -> Vec<String> {
    different(objects.iter().map(|object| phrase(&object.name)), &[])
}

fn write_to(text: &mut String, mesh: &Mesh, materials: &[String]) -> std::fmt::Result {
    write_vertices(text, mesh)?;
    let texture = mesh.texture_coordinates();
    for [u, v] in texture.map_or(&[][..], |texture| &texture.values) {
        writeln!(text, "vt {u:?} {v:?}")?;
    }
    let normals = mesh.normals();
    for normal in normals.map_or(&[][..], |normals| &normals.values) {
        let [x, y, z] = normal.coordinates();
        writeln!(text, "vn {x:?} {y:?} {z:?}")?;
    }
    write_faces(text, mesh, materials)?;
    for line in mesh.polylines().iter() {
        write_indices(text, "l", line)?;
    }
    for &point in mesh.points() {
        write_indices(text, "p", &[point])?;
    }
    Ok(())
}

fn write_vertices(text: &mut String, mesh: &Mesh) -> std::fmt::Result {
    let Some(colours) = mesh.colours() else {
        for [x, y, z] in mesh.coordinates() {
            writeln!(text, "v {x:?} {y:?} {z:?}")?;
        }
        return Ok(());
    };
    let encoded = |linear: f64| (srgb_from_linear(linear) * 1e14).round() / 1e14;
    for ([x, y, z], &[red, green, blue, _]) in mesh.coordinates().zip(colours) {
        let [red, green, blue] = [red, green, blue].map(encoded);
        writeln!(text, "v {x:?} {y:?} {z:?} {red:?} {green:?} {blue:?}")?;
    }
    Ok(())
}

fn write_faces(text: &mut String, mesh: &Mesh, materials: &[String]) -> std::fmt::Result {
    let faces = mesh.faces();
    let (group_names, object_names) = (group_names(mesh.groups()), object_names(mesh.objects()));
    let mut groups_of_face = vec![Vec::new(); faces.len()];
    for (group, members) in mesh.groups().iter().enumerate() {
        for &face in &members.faces {
            groups_of_face[face as usize].push(group);
        }
    }
    let mut object_of_face = vec![None; faces.len()];
    for (object, members) in mesh.objects().iter().enumerate() {
        for &face in &members.faces {
            object_of_face[face as usize] = Some(object);
        }
    }
    let (mut open_groups, mut open_object, mut open_material) = (&Vec::new(), None, None);
    let mut corner = 0;
    for (face, vertices) in faces.iter().enumerate() {
        if open_object != object_of_face[face] {
            open_object = object_of_face[face];
            let name = open_object.map_or("", |object| &object_names[object]);
            writeln!(text, "{}", format!("o {name}").trim_end())?;
        }
        if open_groups != &groups_of_face[face] {
            open_groups = &groups_of_face[face];
            text.push('g');
            for &group in open_groups {
                write!(text, " {}", group_names[group])?;
            }
            text.push('\n');
        }
        let material = mesh.face_materials().get(face).copied().flatten();
        if open_material != material {
            open_material = material;
            let name = material.map_or(NO_MATERIAL, |material| &materials[material as usize]);
            writeln!(text, "usemtl {name}")?;
        }
        text.push('f');
        for &vertex in vertices {
            write_corner(text, mesh, corner, vertex)?;
            corner += 1;
        }
        text.push('\n');
    }
    Ok(())
}

fn write_corner(text: &mut String, mesh: &Mesh, corner: usize, vertex: u32) -> std::fmt::Result {
    write!(text, " {}", u64::from(vertex) + 1)?;
    let texture = index_at(mesh.texture_coordinates(), corner);
    let normal = index_at(mesh.normals(), corner);
    match (texture, normal) {
        (None, None) => Ok(()),
        (Some(texture), None) => write!(text, "/{texture}"),
        (None, Some(normal)) => write!(text, "//{normal}"),
        (Some(texture), Some(normal)) => write!(text, "/{texture}/{normal}"),
    }
}

/// The index of the value at a corner, from 1.
fn index_at<T>(attribute: Option<&CornerAttribute<T>>, corner: usize) -> Option<u64> {
    attribute?.corners[corner].map(|index| u64::from(index) + 1)
}

fn write_indices(text: &mut String, keyword: &str, vertices: &[u32]) -> std::fmt::Result {
    text.push_str(keyword);
    for &vertex in vertices {
        write!(text, " {}", u64::from(vertex) + 1)?;
    }
    text.push('\n');
    Ok(())
}

/// The names, with numbers at the end where needed to be all different and none of `taken`.
fn different(names: impl Iterator<Item = String>, taken: &[&str]) -> Vec<String> {
    let mut taken: HashSet<String> = taken.iter().map(|&name| name.to_owned()).collect();
    names
        .map(|name| {
            let numbered = (2u64..).map(|number| format!("{name}_{number}"));
            let free = std::iter::once(name.clone())
                .chain(numbered)
                .find(|name| !taken.contains(name))
                .unwrap_or(name);
            taken.insert(free.clone());
            free
        })
        .collect()
}

/// A name that reads back as the rest of a line: words with single spaces between them.
fn phrase(name: &str) -> String {
    let words: Vec<String> = name.split(' ').map(word).collect();
    words.join(" ")
}

/// The stem of the name of a file that lines of OBJ and MTL can name. A path of a picture that
/// begins with `-` would be an option.
fn file_stem(stem: &str) -> String {
    let stem = phrase(stem);
    match stem.strip_prefix('-') {
        Some(rest) => format!("_{rest}"),
        None => stem,
    }
}

/// A name that reads back as one word.
fn word(name: &str) -> String {
    if name.is_empty() {
        return "_".to_owned();
    }
    let stands = |c: char| !c.is_whitespace() && !c.is_control() && c != '#' && c != '\\';
    name.chars()
        .map(|c| if stands(c) { c } else { '_' })
        .collect()
}
