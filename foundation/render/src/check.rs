//! Whether a scene can be drawn.

use ga_image::colour::LinearColour;

use crate::scene::{Attribute, MaterialChoice, Normals, Object, Scene};
use crate::{LARGEST_COORDINATE, RenderError};

/// Checks every number and index of a scene.
pub(crate) fn check(scene: &Scene) -> Result<(), RenderError> {
    for (index, object) in scene.objects.iter().enumerate() {
        check_object(index, object, scene.materials.len())?;
    }
    // The last number means that there is no triangle.
    let triangles = scene.objects.iter().map(|o| o.triangles.len()).sum();
    if triangles >= u32::MAX as usize {
        return Err(RenderError::TooManyTriangles(triangles));
    }
    for (material, content) in scene.materials.iter().enumerate() {
        if let Some(quantity) = content.faulty_number() {
            return Err(RenderError::Material { material, quantity });
        }
    }
    let is_visible = |colour: LinearColour, width: f64| {
        let mut numbers = colour.channels().into_iter().chain([width]);
        numbers.all(|n| n.is_finite() && n >= 0.0)
    };
    let bad_line = scene.lines.iter().position(|line| {
        !(line.points.iter().all(is_reasonable) && is_visible(line.colour, line.width))
    });
    if let Some(line) = bad_line {
        return Err(RenderError::Line { line });
    }
    let bad_dot = scene
        .dots
        .iter()
        .position(|dot| !(is_reasonable(&dot.position) && is_visible(dot.colour, dot.diameter)));
    if let Some(dot) = bad_dot {
        return Err(RenderError::Dot { dot });
    }
    let mut bones = scene.bones.iter();
    if let Some(bone) = bones.position(|ends| !ends.iter().all(is_reasonable)) {
        return Err(RenderError::Bone { bone });
    }
    match scene.ground {
        Some(ground)
            if !(ground.height.abs() <= LARGEST_COORDINATE
                && ground.grid.is_normal()
                && ground.grid > 0.0) =>
        {
            Err(RenderError::Ground)
        }
        _ => Ok(()),
    }
}

fn is_reasonable(p: &[f64; 3]) -> bool {
    p.iter().all(|c| c.abs() <= LARGEST_COORDINATE)
}

fn check_object(index: usize, object: &Object, materials: usize) -> Result<(), RenderError> {
    if let Some(vertex) = object.positions.iter().position(|p| !is_reasonable(p)) {
        return Err(RenderError::Position {
            object: index,
            vertex,
        });
    }
    let vertices = object.positions.len();
    for (triangle, corners) in object.triangles.iter().enumerate() {
        if let Some(&vertex) = corners.iter().find(|&&v| v as usize >= vertices) {
            return Err(RenderError::Triangle {
                object: index,
                triangle,
                vertex,
                vertices,
            });
        }
    }
    if let Normals::Given(normals) = &object.normals {
        check_attribute(index, object, "normals", normals)?;
    }
    if let Some(coordinates) = &object.texture_coordinates {
        check_attribute(index, object, "texture coordinates", coordinates)?;
    }
    if let Some(coordinates) = &object.second_texture_coordinates {
        check_attribute(index, object, "second texture coordinates", coordinates)?;
    }
    if let Some(tangents) = &object.tangents {
        check_attribute(index, object, "tangents", tangents)?;
    }
    if let Some(colours) = &object.colours {
        check_attribute(index, object, "colours", colours)?;
        let negative = |colour: &[f64; 4]| colour.iter().any(|&c| c < 0.0);
        if let Some(element) = colours.values.iter().position(negative) {
            return Err(RenderError::Attribute {
                object: index,
                attribute: "colours",
                problem: "a number is negative",
                element,
            });
        }
    }
    check_materials(index, object, materials)
}

fn check_attribute<const N: usize>(
    index: usize,
    object: &Object,
    attribute: &'static str,
    values: &Attribute<[f64; N]>,
) -> Result<(), RenderError> {
    let refuse = |problem, element| {
        Err(RenderError::Attribute {
            object: index,
            attribute,
            problem,
            element,
        })
    };
    let reasonable = |value: &[f64; N]| value.iter().all(|c| c.abs() <= LARGEST_COORDINATE);
    if let Some(element) = values.values.iter().position(|value| !reasonable(value)) {
        return refuse("a number is not finite or beyond 1e30", element);
    }
    let count = values.values.len();
    match values.corners {
        None if count != object.positions.len() => {
            refuse("there is not one value for each vertex", count)
        }
        None => Ok(()),
        Some(corners) if corners.len() != object.triangles.len() => {
            refuse("there is not one entry for each triangle", corners.len())
        }
        Some(corners) => {
            let outside = |corners: &Option<[u32; 3]>| {
                corners.is_some_and(|c| c.iter().any(|&value| value as usize >= count))
            };
            match corners.iter().position(outside) {
                Some(triangle) => refuse("a triangle names a value that does not exist", triangle),
                None => Ok(()),
            }
        }
    }
}

fn check_materials(index: usize, object: &Object, materials: usize) -> Result<(), RenderError> {
    let outside = |material: &u32| *material as usize >= materials;
    let faulty = match &object.material {
        MaterialChoice::Style => None,
        MaterialChoice::One(material) => Some(*material).filter(outside),
        MaterialChoice::PerTriangle(list) => {
            if list.len() != object.triangles.len() {
                return Err(RenderError::Attribute {
                    object: index,
                    attribute: "materials",
                    problem: "there is not one entry for each triangle",
                    element: list.len(),
                });
            }
            list.iter().flatten().copied().find(outside)
        }
    };
    match faulty {
        None => Ok(()),
        Some(material) => Err(RenderError::MaterialIndex {
            object: index,
            material,
            materials,
        }),
    }
}
