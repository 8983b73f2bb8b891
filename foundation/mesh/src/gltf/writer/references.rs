//! The references to accessors and buffer views in the JSON of a file.

use serde_json::{Map, Value};

use super::super::json::{DRACO, MESHOPT};

/// What a reference is to.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum To {
    Accessor,
    View,
}

/// Calls a function with each reference, in every element that glTF or an extension of Khronos with
/// such references has.
pub(super) fn visit(root: &mut Map<String, Value>, mut seen: impl FnMut(To, &mut Value)) {
    for primitive in elements(root, "meshes").flat_map(|mesh| items(mesh, "primitives")) {
        at(primitive, "indices").for_each(|it| seen(To::Accessor, it));
        at(primitive, "attributes").for_each(|it| {
            values(it).for_each(|it| seen(To::Accessor, it));
        });
        for target in items(primitive, "targets") {
            values(target).for_each(|it| seen(To::Accessor, it));
        }
        extension(primitive, DRACO).for_each(|it| {
            at(it, "bufferView").for_each(|it| seen(To::View, it));
        });
    }
    for skin in elements(root, "skins") {
        at(skin, "inverseBindMatrices").for_each(|it| seen(To::Accessor, it));
    }
    for sampler in elements(root, "animations").flat_map(|motion| items(motion, "samplers")) {
        at(sampler, "input").for_each(|it| seen(To::Accessor, it));
        at(sampler, "output").for_each(|it| seen(To::Accessor, it));
    }
    for node in elements(root, "nodes") {
        extension(node, "EXT_mesh_gpu_instancing").for_each(|it| {
            at(it, "attributes").for_each(|it| {
                values(it).for_each(|it| seen(To::Accessor, it));
            });
        });
    }
    for accessor in elements(root, "accessors") {
        at(accessor, "bufferView").for_each(|it| seen(To::View, it));
        at(accessor, "sparse").for_each(|sparse| {
            for part in ["indices", "values"] {
                at(sparse, part).for_each(|it| {
                    at(it, "bufferView").for_each(|it| seen(To::View, it));
                });
            }
        });
    }
    for image in elements(root, "images") {
        at(image, "bufferView").for_each(|it| seen(To::View, it));
    }
}

/// Whether all references are known: the file uses only extensions that have none, or those above.
pub(super) fn are_known(root: &Map<String, Value>) -> bool {
    const FAMILIES: [&str; 4] = ["KHR_materials_", "KHR_texture_", "EXT_texture_", "VRM"];
    const OTHERS: [&str; 7] = [
        "EXT_mesh_gpu_instancing",
        "KHR_animation_pointer",
        "KHR_lights_punctual",
        "KHR_mesh_quantization",
        "KHR_node_visibility",
        "KHR_xmp_json_ld",
        "MSFT_lod",
    ];
    let used = root.get("extensionsUsed").and_then(Value::as_array);
    let mut names = used.into_iter().flatten().filter_map(Value::as_str);
    names.all(|name| {
        let mut families = FAMILIES.iter();
        families.any(|family| name.starts_with(family))
            || OTHERS.contains(&name)
            || name == DRACO
            || MESHOPT.contains(&name)
    })
}

/// The parts of buffers from which a view is decompressed.
pub(super) fn compressed(view: &mut Value) -> impl Iterator<Item = &mut Value> {
    let extensions = view.get_mut("extensions").and_then(Value::as_object_mut);
    let extensions = extensions.into_iter().flatten();
    extensions.filter_map(|(name, it)| MESHOPT.contains(&name.as_str()).then_some(it))
}

fn elements<'a>(
    root: &'a mut Map<String, Value>,
    list: &str,
) -> impl Iterator<Item = &'a mut Value> {
    let list = root.get_mut(list).and_then(Value::as_array_mut);
    list.into_iter().flatten()
}

fn items<'a>(element: &'a mut Value, list: &str) -> impl Iterator<Item = &'a mut Value> {
    let list = element.get_mut(list).and_then(Value::as_array_mut);
    list.into_iter().flatten()
}

fn values(object: &mut Value) -> impl Iterator<Item = &mut Value> {
    let object = object.as_object_mut();
    object.into_iter().flat_map(Map::values_mut)
}

fn at<'a>(element: &'a mut Value, key: &str) -> impl Iterator<Item = &'a mut Value> {
    element.get_mut(key).into_iter()
}

fn extension<'a>(element: &'a mut Value, name: &str) -> impl Iterator<Item = &'a mut Value> {
    let extensions = element.get_mut("extensions");
    extensions.and_then(|all| all.get_mut(name)).into_iter()
}
