use std::fmt::Write;
use std::path::Path;

use ga_files::WriteError;

use crate::Mesh;

/// Writes a mesh to an OBJ file, whole or not at all.
///
/// # Errors
///
/// [`WriteError`]; an earlier file of that name then stays as it was.
pub fn write(path: impl AsRef<Path>, mesh: &Mesh) -> Result<(), WriteError> {
    ga_files::write(path, to_text(mesh).as_bytes())
}

/// A mesh as the text of an OBJ file.
///
/// Numbers are written so that reading them gives the same `f64` back. Characters that a
/// group's name cannot have (white space, `#`, `\`) become `_`.
///
/// # Examples
///
/// ```
/// let mesh = ga_mesh::obj::parse(b"v 0 0 0\nv 1 0 0\nv 0 0.5 0\nf 1 2 3\n")?;
/// assert_eq!(
///     ga_mesh::obj::to_text(&mesh),
///     "v 0.0 0.0 0.0\nv 1.0 0.0 0.0\nv 0.0 0.5 0.0\nf 1 2 3\n"
/// );
/// # Ok::<(), ga_mesh::obj::ObjError>(())
/// ```
#[must_use]
pub fn to_text(mesh: &Mesh) -> String {
    let mut text = String::new();
    // Writing to a String cannot fail.
    let _ = write_to(&mut text, mesh);
    text
}

fn write_to(text: &mut String, mesh: &Mesh) -> std::fmt::Result {
    for [x, y, z] in mesh.coordinates() {
        writeln!(text, "v {x:?} {y:?} {z:?}")?;
    }
    let texture = mesh.texture();
    for [u, v] in texture.map_or(&[][..], |texture| &texture.coordinates) {
        writeln!(text, "vt {u:?} {v:?}")?;
    }

    let mut groups_of_face = vec![Vec::new(); mesh.faces().len()];
    for (group, faces) in mesh.groups().iter().enumerate() {
        for &face in &faces.faces {
            groups_of_face[face as usize].push(group);
        }
    }
    let mut open: &[usize] = &[];
    let mut corner = 0;
    for (vertices, groups) in mesh.faces().iter().zip(&groups_of_face) {
        if open != groups {
            text.push('g');
            for &group in groups {
                write!(text, " {}", word(&mesh.groups()[group].name))?;
            }
            text.push('\n');
            open = groups;
        }
        text.push('f');
        for &vertex in vertices {
            write!(text, " {}", u64::from(vertex) + 1)?;
            if let Some(coordinate) = texture.and_then(|texture| texture.corners[corner]) {
                write!(text, "/{}", u64::from(coordinate) + 1)?;
            }
            corner += 1;
        }
        text.push('\n');
    }
    Ok(())
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
