//! Files that are read and written again keep what is in them, counted without the crate.

use std::path::{Path, PathBuf};

use ga_mesh::gltf::{self, Document, Vertices};
use serde_json::{Value, json};

use super::plain::Plain;
use super::samples::samples;

fn data(name: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR"))
        .join("tests/data")
        .join(name)
}

fn everything() -> Document {
    gltf::read(data("everything.gltf")).unwrap()
}

/// The same without the extension whose references are not known.
fn without_note() -> Document {
    let mut json = Plain::read(&data("everything.gltf")).json;
    let names = json["extensionsUsed"].as_array_mut().unwrap();
    names.retain(|name| name != "EXAMPLE_note");
    gltf::decode(&serde_json::to_vec(&json).unwrap()).unwrap()
}

/// A document as it is written in both forms.
fn written(document: &Document) -> [Plain; 2] {
    let nothing = |name: &str| -> Vec<u8> { panic!("{name} is not to be read") };
    let glb = Plain::decode(&gltf::encode(document).unwrap(), nothing);
    let files = gltf::encode_files(document, "it").unwrap();
    let read = |name: &str| {
        let mut others = files.others.iter();
        others.find(|(other, _)| other == name).unwrap().1.clone()
    };
    [glb, Plain::decode(&files.json, read)]
}

/// Documents of the test data and of the shared samples keep all JSON and all items of accessors.
#[test]
fn files_keep_everything() {
    let names = ["everything.gltf", "draco.glb"].map(data);
    for path in samples().into_iter().chain(names) {
        let before = Plain::read(&path);
        let document = gltf::read(&path).unwrap();
        for after in written(&document) {
            let name = path.display();
            assert_eq!(after.meaning(), before.meaning(), "{name}");
            assert_eq!(after.all_items(), before.all_items(), "{name}");
        }
        let again = gltf::decode(&gltf::encode(&document).unwrap()).unwrap();
        assert_eq!(again, document);
    }
}

/// What each part of the file is for is there, so that the comparison above means something.
#[test]
fn the_file_with_everything_has_everything() {
    let file = Plain::read(&data("everything.gltf"));
    for (list, count) in [
        ("scenes", 2),
        ("nodes", 7),
        ("meshes", 2),
        ("skins", 1),
        ("animations", 2),
        ("materials", 2),
        ("cameras", 2),
        ("buffers", 2),
        ("extensionsUsed", 6),
    ] {
        assert_eq!(file.count(list), count, "{list}");
        if list != "buffers" {
            for after in written(&everything()) {
                assert_eq!(after.count(list), count, "{list}");
            }
        }
    }
    assert_eq!(
        file.json["meshes"][0]["primitives"][0]["targets"]
            .as_array()
            .unwrap()
            .len(),
        1
    );
}

/// The picture is in the buffer of a GLB file and a file beside JSON.
#[test]
fn pictures_keep_their_bytes() {
    let document = without_note();
    let before = Plain::read(&data("everything.gltf"));
    let picture = before
        .view(&before.json["images"][0]["bufferView"])
        .to_vec();
    let [glb, json] = written(&document);
    assert_eq!(glb.view(&glb.json["images"][0]["bufferView"]), picture);
    assert_eq!(json.json["images"][0]["uri"], "it_0.png");
    assert_eq!(json.json["images"][0]["extras"], json!({"of": "image"}));
    assert_eq!(
        gltf::encode_files(&document, "it").unwrap().others[1].1,
        picture
    );
    // Its bytes are not in the buffer as well.
    assert!(
        json.buffers[0]
            .windows(picture.len())
            .all(|bytes| bytes != picture)
    );
}

/// An element that is changed keeps its extensions, and all else stays as it was.
#[test]
fn a_change_stays_where_it_is() {
    let before = Plain::read(&data("everything.gltf"));
    let mut document = everything();
    document.nodes[5].name = Some("tray".to_owned());
    document.materials[0].roughness = 0.5;
    document.meshes[1].primitives[0].material = None;
    for after in written(&document) {
        let mut expected = before.json["nodes"].clone();
        expected[5]["name"] = json!("tray");
        let lists = |json: &Value, index: usize| {
            let mut node = json[index].clone();
            // Whole numbers may be written with a point.
            for key in ["translation", "scale"] {
                if let Some(list) = node.get_mut(key).and_then(Value::as_array_mut) {
                    list.iter_mut()
                        .for_each(|it| *it = json!(it.as_f64().unwrap()));
                }
            }
            node
        };
        for index in 0..7 {
            assert_eq!(lists(&after.json["nodes"], index), lists(&expected, index));
        }
        let [old, new] = [&before.json, &after.json].map(|json| &json["materials"][0]);
        assert_eq!(new["extensions"], old["extensions"]);
        assert_eq!(new["pbrMetallicRoughness"]["roughnessFactor"], 0.5);
        assert_eq!(
            new["pbrMetallicRoughness"]["baseColorFactor"],
            json!([0.9, 0.8, 0.7, 1.0])
        );
        assert_eq!(after.json["materials"][1], before.json["materials"][1]);
        assert_eq!(after.json["meshes"][0], before.json["meshes"][0]);
        assert_eq!(
            after.json["meshes"][1]["primitives"][0].get("material"),
            None
        );
        for list in [
            "skins",
            "animations",
            "cameras",
            "scenes",
            "textures",
            "samplers",
        ] {
            assert_eq!(after.json[list], before.json[list], "{list}");
        }
        // Accessors of the changed primitive are added behind those of the file.
        let items = before.all_items();
        assert_eq!(after.all_items()[..items.len()], items);
    }
}

/// What nothing needs any more is removed where all references are known.
#[test]
fn numbers_of_removed_animations_go_with_them() {
    let before = Plain::read(&data("everything.gltf"));
    for (mut document, gone) in [(without_note(), 5), (everything(), 0)] {
        document.animations.clear();
        let after = &written(&document)[0];
        assert_eq!(after.count("animations"), 0);
        // Times, rotations, weights and translations, and the times of the light.
        assert_eq!(after.count("accessors"), before.count("accessors") - gone);
        let positions = |file: &Plain| {
            let primitive = &file.json["meshes"][0]["primitives"][0];
            let accessor = primitive["attributes"]["POSITION"].as_u64().unwrap() as usize;
            file.items(&file.json["accessors"][accessor])
        };
        assert_eq!(positions(after), positions(&before));
        let matrices = |file: &Plain| {
            let accessor = file.json["skins"][0]["inverseBindMatrices"]
                .as_u64()
                .unwrap();
            file.items(&file.json["accessors"][accessor as usize])
        };
        assert_eq!(matrices(after), matrices(&before));
        assert_eq!(
            gltf::decode(&gltf::encode(&document).unwrap()).unwrap(),
            document
        );
    }
}

/// Animations may stand in another order.
#[test]
fn animations_may_move() {
    let mut document = everything();
    let before = Plain::read(&data("everything.gltf"));
    document.animations.reverse();
    for after in written(&document) {
        assert_eq!(after.json["animations"][0], before.json["animations"][1]);
        assert_eq!(after.json["animations"][1], before.json["animations"][0]);
    }
}

#[test]
fn what_a_mesh_lacks_is_counted() {
    let omissions = everything().omissions();
    let counts: Vec<_> = omissions.iter().map(|it| (it.what, it.count)).collect();
    assert_eq!(
        counts,
        [
            ("skins", 1),
            ("animations", 2),
            ("morph targets", 1),
            ("cameras", 2),
            ("lights", 2),
            ("further scenes", 1),
            ("nodes below others in the hierarchy", 3),
            ("custom attributes", 1),
            ("extras", 11),
            ("extensions", 3),
        ]
    );
    let names = "3 extensions (KHR_materials_clearcoat, KHR_animation_pointer, EXAMPLE_note) are";
    assert!(
        omissions[9].to_string().starts_with(names),
        "{}",
        omissions[9]
    );
    // A document that is made of a mesh lacks nothing.
    let mesh = everything().to_mesh(Vertices::Kept).unwrap();
    assert_eq!(Document::from_mesh(&mesh).unwrap().omissions(), []);
}
