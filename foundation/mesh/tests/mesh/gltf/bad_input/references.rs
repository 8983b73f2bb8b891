//! References and lengths of every list of a document.

use serde_json::{Value, json};

use super::message;

/// The message of the model with one value of its JSON replaced. In pointers and messages # stands
/// for the primitive, @ for an attribute of it.
#[track_caller]
fn check(pointer: &str, value: Value, expected: &str) {
    let pointer = pointer.replace('#', "/meshes/0/primitives/0");
    let expected = expected.replace('@', "#, attribute");
    let expected = expected.replace('#', "mesh 0, primitive 0");
    assert_eq!(
        message(&pointer, value.clone()),
        expected,
        "{pointer} {value}"
    );
}

#[test]
fn the_file_and_its_meshes() {
    check(
        "/asset/version",
        json!("1.0"),
        "file: version 1.0 of glTF is not supported",
    );
    check(
        "/asset/minVersion",
        json!("2.1"),
        "file: version 2.1 of glTF is not supported",
    );
    check(
        "/extensionsRequired",
        json!(["KHR_mesh_quantization", "KHR_xmp_json_ld"]),
        "file: requires the extension KHR_xmp_json_ld, which is not supported",
    );
    check(
        "#/attributes/POSITION",
        json!(6),
        "@ POSITION: refers to accessor 6, but there are 6",
    );
    check(
        "#/attributes/POSITION",
        json!(4_294_967_296u64),
        "@ POSITION: refers to accessor 4294967296, but there are 6",
    );
    check(
        "#/attributes/NORMAL",
        json!(3),
        "@ NORMAL: accessor 3: is SCALAR of UNSIGNED_SHORT, but must be VEC3 of FLOAT",
    );
    check(
        "#/attributes/TEXCOORD_1",
        json!(0),
        "@ TEXCOORD_1: lacks the set with the number before it",
    );
    check(
        "#/attributes/COLOUR",
        json!(0),
        "@ COLOUR: the name cannot be COLOUR",
    );
    check(
        "#/targets/0",
        json!({"NORMAL": 5}),
        "#, morph target 0, attribute NORMAL: accessor 5: is VEC4 of FLOAT, but must \
         be VEC3 of FLOAT",
    );
    check(
        "#/targets/0",
        json!({}),
        "#: lacks attributes of a morph target",
    );
    check("#/mode", json!(7), "#: mode cannot be 7");
    check(
        "#/material",
        json!(0),
        "#: refers to material 0, but there are 0",
    );
    check(
        "/meshes/0/weights",
        json!([1.0, 2.0]),
        "mesh 0: has 2 weights of morph targets, not 1",
    );
    check(
        "/meshes/0/primitives",
        json!([]),
        "mesh 0: lacks primitives",
    );
}

#[test]
fn accessors_and_buffers() {
    let sparse = |count: usize, component: u32| {
        json!({
            "count": count,
            "indices": {"bufferView": 0, "componentType": component},
            "values": {"bufferView": 0},
        })
    };
    check(
        "/accessors/0/bufferView",
        json!(1),
        "@ POSITION: accessor 0: refers to buffer view 1, but there are 1",
    );
    check(
        "/accessors/0/count",
        json!(1_000_000_000),
        "@ POSITION: accessor 0: needs 12000000000 bytes, but has 180",
    );
    check(
        "/accessors/0/count",
        json!(u64::MAX),
        "@ POSITION: accessor 0: needs 18446744073709551615 bytes, but has 180",
    );
    check(
        "/accessors/0/count",
        json!(3),
        "@ WEIGHTS_0: has 4 items, not 3",
    );
    check(
        "/accessors/0/count",
        json!(0),
        "@ POSITION: accessor 0: count cannot be 0",
    );
    check(
        "/accessors/0/byteOffset",
        json!(133),
        "@ POSITION: accessor 0: needs 181 bytes, but has 180",
    );
    check(
        "/accessors/0/type",
        json!("VEC5"),
        "@ POSITION: accessor 0: type cannot be VEC5",
    );
    check(
        "/accessors/0/componentType",
        json!(5124),
        "@ POSITION: accessor 0: componentType cannot be 5124",
    );
    check(
        "/accessors/0/sparse",
        sparse(1, 5126),
        "@ POSITION: accessor 0: type of sparse indices cannot be FLOAT",
    );
    check(
        "/accessors/0/sparse",
        sparse(2, 5121),
        "@ POSITION: accessor 0: sparse index 1 is 0, which is not greater than the \
         index before it or not less than the count 4",
    );
    check(
        "/accessors/0/sparse",
        sparse(5, 5121),
        "@ POSITION: accessor 0: sparse count cannot be 5",
    );
    check("/accessors/4/normalized", json!(true), "none");
    check(
        "/bufferViews/0/byteStride",
        json!(8),
        "@ POSITION: accessor 0: byteStride cannot be 8",
    );
    check(
        "/bufferViews/0/byteLength",
        json!(181),
        "@ POSITION: accessor 0: buffer view 0: needs 181 bytes, but has 180",
    );
    check(
        "/bufferViews/0/buffer",
        json!(1),
        "@ POSITION: accessor 0: buffer view 0: refers to buffer 1, but there are 1",
    );
    check(
        "/buffers/0/byteLength",
        json!(184),
        "buffer 0: needs 184 bytes, but has 180",
    );
    check(
        "/buffers/0/uri",
        json!("http://example.org/a.bin"),
        "buffer 0: the URI \"http://example.org/a.bin\" does not name a file and holds \
         no data",
    );
    check(
        "/buffers/0/uri",
        json!("/etc/passwd"),
        "buffer 0: the URI \"/etc/passwd\" does not name a file and holds no data",
    );
    check(
        "/buffers/0/uri",
        json!("data:;base64,%%"),
        "buffer 0: the URI \"data:;base64,%%\" does not name a file and holds no data",
    );
}

#[test]
fn nodes_scenes_and_skins() {
    check(
        "/nodes/1/children",
        json!([0]),
        "node 0: is an ancestor of itself",
    );
    check(
        "/nodes/1/children",
        json!([1]),
        "node 1: is a child of node 0 and of node 1",
    );
    check(
        "/nodes/1/children",
        json!([9]),
        "node 1: refers to node 9, but there are 3",
    );
    check(
        "/nodes/1/matrix",
        json!([1, 0, 0, 1, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1]),
        "node 1: the last row of the matrix cannot be [1.0, 0.0, 0.0, 1.0]",
    );
    check(
        "/nodes/1/rotation",
        json!([0, 0, 0, 0]),
        "node 1: rotation cannot be zero",
    );
    check(
        "/nodes/1/skin",
        json!(0),
        "node 1: lacks the mesh of its skin or weights",
    );
    check(
        "/nodes/1/camera",
        json!(0),
        "node 1: refers to camera 0, but there are 0",
    );
    check(
        "/nodes/2/mesh",
        json!(1),
        "node 2: refers to mesh 1, but there are 1",
    );
    check(
        "/nodes/2/skin",
        json!(1),
        "node 2: refers to skin 1, but there are 1",
    );
    check(
        "/nodes/2/weights",
        json!([1, 2]),
        "node 2: has 2 weights of morph targets, not 1",
    );
    check(
        "/scenes/0/nodes",
        json!([1]),
        "scene 0: a node at its top cannot be 1",
    );
    check(
        "/scenes/0/nodes",
        json!([0, 0]),
        "scene 0: has node 0 twice",
    );
    check(
        "/scene",
        json!(1),
        "file: refers to scene 1, but there are 1",
    );
    check("/skins/0/joints", json!([]), "skin 0: lacks joints");
    check(
        "/skins/0/joints",
        json!([0]),
        "node 2: @ JOINTS_0: vertex 0 is moved by joint 1, but the skin has 1 joints",
    );
    check(
        "/skins/0/joints",
        json!([0, 0]),
        "skin 0: has joint 0 twice",
    );
    check(
        "/skins/0/skeleton",
        json!(3),
        "skin 0: refers to node 3, but there are 3",
    );
    check(
        "/skins/0/inverseBindMatrices",
        json!(2),
        "skin 0: accessor 2: is VEC4 of FLOAT, but must be MAT4 of FLOAT",
    );
}

#[test]
fn animations() {
    check(
        "/animations/0/channels/0/sampler",
        json!(1),
        "animation 0, channel 0: refers to sampler 1, but there are 1",
    );
    check(
        "/animations/0/channels/0/target/node",
        json!(3),
        "animation 0, channel 0: refers to node 3, but there are 3",
    );
    check(
        "/animations/0/channels/0/target/path",
        json!("colour"),
        "animation 0, channel 0: path cannot be colour",
    );
    check(
        "/animations/0/channels/0/target/path",
        json!("scale"),
        "animation 0, channel 0: accessor 5: is VEC4 of FLOAT, but must be VEC3 of FLOAT",
    );
    check(
        "/animations/0/samplers/0/interpolation",
        json!("CUBIC"),
        "animation 0, channel 0: interpolation cannot be CUBIC",
    );
    check(
        "/animations/0/samplers/0/interpolation",
        json!("CUBICSPLINE"),
        "animation 0, channel 0: has 2 values of keys, not 6",
    );
    check(
        "/animations/0/channels/0/target",
        json!({"path": "pointer"}),
        "none",
    );
}

#[test]
fn materials_textures_and_cameras() {
    check(
        "/materials",
        json!([{"normalTexture": {"index": 0}}]),
        "material 0: refers to texture 0, but there are 0",
    );
    check(
        "/materials",
        json!([{"alphaMode": "GLASS"}]),
        "material 0: alphaMode cannot be GLASS",
    );
    check(
        "/materials",
        json!([{"pbrMetallicRoughness": {"metallicFactor": 1.5}}]),
        "material 0: a factor cannot be 1.5",
    );
    check(
        "/textures",
        json!([{"source": 0}]),
        "texture 0: refers to image 0, but there are 0",
    );
    check(
        "/samplers",
        json!([{"wrapS": 1}]),
        "sampler 0: wrapS cannot be 1",
    );
    check(
        "/images",
        json!([{}]),
        "image 0: lacks a URI and a buffer view",
    );
    check(
        "/images",
        json!([{"bufferView": 3}]),
        "image 0: refers to buffer view 3, but there are 1",
    );
    check(
        "/cameras",
        json!([{"type": "perspective"}]),
        "camera 0: lacks perspective",
    );
    check(
        "/cameras",
        json!([{"type": "perspective", "perspective": {"yfov": 0, "znear": 1}}]),
        "camera 0: yfov cannot be 0",
    );
}
