//! What the commands that write glTF keep of it, counted in the JSON of the files.

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

use base64::Engine;
use ga_image::plane::Plane;
use ga_mesh::gltf::{
    self, CameraElement, Channel, Document, Image, ImageSource, Interpolation, Keys,
    MaterialElement, Mesh, MorphTarget, Node, Primitive, Projection, TextureElement, TextureInfo,
};
use serde_json::{Value, json};
use tempfile::tempdir;

use crate::common::{
    assert_failure, assert_success, extent, figure, heights, json as report, nullcone, text,
};

/// A file with a skin, animations, morph targets, cameras, lights, extras and extensions.
fn everything() -> PathBuf {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../foundation/mesh/tests/data");
    folder.join("everything.gltf")
}

/// The JSON of a file of either form.
fn root(path: &Path) -> Value {
    let file = std::fs::read(path).unwrap();
    if !file.starts_with(b"glTF") {
        return serde_json::from_slice(&file).unwrap();
    }
    let length = u32::from_le_bytes(file[12..16].try_into().unwrap()) as usize;
    serde_json::from_slice(&file[20..20 + length]).unwrap()
}

/// How many elements of each list a file has, and how many morph targets and extensions.
fn counts(path: &Path) -> BTreeMap<String, usize> {
    let root = root(path);
    let lists = root.as_object().unwrap().iter();
    let lists = lists.filter_map(|(key, list)| Some((key.clone(), list.as_array()?.len())));
    let mut counts: BTreeMap<String, usize> = lists.collect();
    let text = root.to_string();
    for key in ["\"extras\"", "\"extensions\"", "\"EXAMPLE_note\""] {
        counts.insert(key.to_owned(), text.matches(key).count());
    }
    let meshes = root["meshes"].as_array().into_iter().flatten();
    let primitives = meshes.flat_map(|mesh| mesh["primitives"].as_array().unwrap());
    let targets = primitives.filter_map(|primitive| primitive["targets"].as_array());
    counts.insert("targets".to_owned(), targets.map(Vec::len).sum());
    // How the bytes are divided does not matter.
    counts.retain(|key, _| !["buffers", "bufferViews"].contains(&key.as_str()));
    counts
}

/// The kinds and the numbers in the warnings of a report.
fn omissions(report: &Value) -> BTreeMap<String, u64> {
    let warnings = report["warnings"].as_array().unwrap().iter();
    let pair = |warning: &Value| {
        assert_eq!(warning["kind"], "omission", "{warning}");
        let what = warning["what"].as_str().unwrap().to_owned();
        (what, warning["count"].as_u64().unwrap())
    };
    warnings.map(pair).collect()
}

#[test]
fn conversion_from_gltf_to_gltf_keeps_all() {
    let folder = tempdir().unwrap();
    let path = folder.path();
    std::fs::copy(everything(), path.join("in.gltf")).unwrap();
    let expected = counts(&path.join("in.gltf"));
    for (from, to) in [
        ("in.gltf", "a.glb"),
        ("a.glb", "b.gltf"),
        ("b.gltf", "c.glb"),
    ] {
        let output = nullcone(path, ["mesh", "convert", from, to]);
        assert_success(&output);
        assert!(output.stderr.is_empty(), "{}", text(&output.stderr));
        assert_eq!(counts(&path.join(to)), expected, "{to}");
        let report = report(path, &["mesh", "convert", from, to, "--force"]);
        assert_eq!(
            (&report["vertices"], &report["faces"]),
            (&json!(8), &json!(4))
        );
    }
    for list in [
        "nodes",
        "skins",
        "animations",
        "cameras",
        "materials",
        "extensions",
        "extras",
    ] {
        let [before, after] = ["in.gltf", "c.glb"].map(|name| root(&path.join(name))[list].clone());
        assert_eq!(before, after, "{list}");
    }
}

/// The buffer of an input is a part of it, also beside an output of another name.
#[test]
fn the_buffer_of_an_input_stays() {
    let folder = tempdir().unwrap();
    let path = folder.path();
    let mut json = root(&everything());
    let uri = json["buffers"][0]["uri"].as_str().unwrap();
    let (_, data) = uri.split_once("base64,").unwrap();
    let before = base64::prelude::BASE64_STANDARD.decode(data).unwrap();
    json["buffers"][0]["uri"] = "b.bin".into();
    std::fs::write(path.join("a.gltf"), json.to_string()).unwrap();
    std::fs::write(path.join("b.bin"), &before).unwrap();
    let convert = ["mesh", "convert", "a.gltf", "b.gltf", "--force"];
    assert_failure(
        &nullcone(path, convert),
        &["b.bin", "a part of the input a.gltf"],
    );
    assert_eq!(std::fs::read(path.join("b.bin")).unwrap(), before);
}

#[test]
fn other_formats_list_what_they_cannot_hold() {
    let folder = tempdir().unwrap();
    let path = folder.path();
    std::fs::copy(everything(), path.join("in.gltf")).unwrap();
    let both = [
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
        ("further sets of texture coordinates", 1),
    ];
    let of_obj = [
        ("occlusion textures", 1),
        ("rotated textures", 1),
        ("textures with further texture coordinates", 1),
        ("alpha modes and double sides of materials", 2),
    ];
    let of_ply = [
        ("materials", 2),
        ("textures of materials", 2),
        ("objects", 2),
    ];
    for (out, more) in [("a.obj", &of_obj[..]), ("a.ply", &of_ply)] {
        let expected = both.iter().chain(more);
        let expected = expected
            .map(|&(what, count)| (what.to_owned(), count))
            .collect();
        let convert = ["mesh", "convert", "in.gltf", out];
        let said = report(path, &convert);
        assert_eq!(omissions(&said), expected, "{out}");
        let output = nullcone(path, convert.iter().chain(&["--force"]));
        assert_success(&output);
        let printed = text(&output.stderr);
        assert_eq!(printed.lines().count(), expected.len(), "{printed}");
        assert!(
            printed.contains(&format!("{out}: 1 skin is left out, since")),
            "{printed}"
        );
    }
    let square = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 5 5 5\ng a\nf 1 2 3 4\n";
    std::fs::write(path.join("square.obj"), square).unwrap();
    let said = report(path, &["mesh", "convert", "square.obj", "square.glb"]);
    let expected = [
        ("polygons with more than three corners", 1),
        ("groups", 1),
        ("vertices without a face, line or point", 1),
    ];
    let expected = expected.map(|(what, count)| (what.to_owned(), count));
    assert_eq!(omissions(&said), BTreeMap::from(expected));
}

/// A figure whose file has more than a skin: a picture, a morph target, a plate that no joint
/// moves, a camera and data of an application.
fn hero(folder: &Path) -> Document {
    figure::write(folder, 26);
    let parts = [
        "--mesh",
        "mesh.obj",
        "--rig",
        "rig.json",
        "--weights",
        "weights.json",
    ];
    let animate = ["animate", "--motion", "motion.bvh", "--out", "first"];
    assert_success(&nullcone(folder, animate.iter().chain(&parts)));
    let mut document = gltf::read(folder.join("first/model.glb")).unwrap();
    document.images.push(Image {
        name: Some("paint".to_owned()),
        source: ImageSource::Uri("paint.png".to_owned()),
        extras: Some(json!({"by": "hand"})),
    });
    document.textures.push(TextureElement {
        image: Some(0),
        ..TextureElement::default()
    });
    document.materials[0].base_colour_texture = Some(TextureInfo::default());
    document.cameras.push(CameraElement {
        name: None,
        projection: Projection::Perspective {
            aspect_ratio: None,
            vertical_angle: 1.0,
            near: 0.1,
            far: None,
        },
        extras: None,
    });
    let primitive = &mut document.meshes[0].primitives[0];
    let vertices = primitive.positions.len();
    primitive.texcoords = vec![vec![[0.5, 0.5]; vertices]];
    primitive.targets = vec![MorphTarget {
        positions: vec![[0.0, 0.01, 0.0]; vertices],
        ..MorphTarget::default()
    }];
    let plate = Primitive {
        positions: vec![[0.0; 3], [0.0, 0.0, 1.0], [1.0, 0.0, 0.0]],
        ..Primitive::default()
    };
    document.meshes.push(Mesh {
        primitives: vec![plate],
        ..Mesh::default()
    });
    document.nodes.push(Node {
        name: Some("plate".to_owned()),
        mesh: Some(1),
        camera: Some(0),
        extras: Some(json!({"kind": "ground"})),
        ..Node::default()
    });
    let plate = document.nodes.len() - 1;
    document.scenes[0].nodes.push(plate);
    let paint = Plane::filled(2, 2, PAINT);
    ga_image::file::write(folder.join("paint.png"), &paint).unwrap();
    gltf::write(folder.join("hero.glb"), &document).unwrap();
    document
}

/// The colour of the figure's picture, in sRGB.
const PAINT: [u8; 3] = [0, 150, 0];

/// The names of the animations of a file.
fn animations(path: &Path) -> Vec<String> {
    let animations = root(path)["animations"]
        .as_array()
        .cloned()
        .unwrap_or_default();
    let names = animations
        .iter()
        .map(|it| it["name"].as_str().unwrap().to_owned());
    names.collect()
}

#[test]
fn characters_keep_all_but_what_is_replaced() {
    let folder = tempdir().unwrap();
    let path = folder.path();
    let hero = hero(path);
    let before = counts(&path.join("hero.glb"));
    assert_eq!(
        (before["images"], before["targets"], before["meshes"]),
        (1, 1, 2)
    );
    let animate = [
        "animate",
        "--character",
        "hero.glb",
        "--motion",
        "motion.bvh",
        "--out",
    ];
    let retarget = [
        "clip",
        "retarget",
        "motion.bvh",
        "--target",
        "hero.glb",
        "--out",
    ];
    for (command, out, file) in [
        (&animate[..], "second", "second/model.glb"),
        (&retarget, "moved.glb", "moved.glb"),
    ] {
        for (more, names) in [
            (&[][..], &["motion 2", "motion"][..]),
            (&["--replace"], &["motion"]),
        ] {
            let output = nullcone(path, command.iter().chain(&[out]).chain(more));
            assert_success(&output);
            let file = path.join(file);
            assert_eq!(animations(&file), names);
            let mut after = counts(&file);
            let mut expected = before.clone();
            expected.insert("animations".to_owned(), names.len());
            // Numbers of animations are further accessors.
            for counts in [&mut after, &mut expected] {
                counts.remove("accessors");
            }
            assert_eq!(after, expected);
            let document = gltf::read(&file).unwrap();
            assert_eq!(document.meshes, hero.meshes);
            assert_eq!(document.materials, hero.materials);
            assert_eq!(document.cameras, hero.cameras);
            let picture = if out == "second" {
                "../paint.png"
            } else {
                "paint.png"
            };
            assert_eq!(
                document.images[0].source,
                ImageSource::Uri(picture.to_owned())
            );
        }
    }
    // In another folder the picture is the same one.
    std::fs::create_dir(path.join("other")).unwrap();
    let convert = ["clip", "convert", "hero.glb", "--out", "other/hero.gltf"];
    assert_success(&nullcone(path, convert));
    let document = gltf::read(path.join("other/hero.gltf")).unwrap();
    let picture = ImageSource::Uri("../paint.png".to_owned());
    assert_eq!(document.images[0].source, picture);

    // A file with one animation in place of another is not longer.
    let length = |name: &str| std::fs::metadata(path.join(name)).unwrap().len();
    assert!(length("moved.glb") < length("hero.glb") * 3 / 2);

    let said = report(path, &[&animate[..], &["third"]].concat());
    let expected = [
        ("materials", 1),
        ("morph targets", 1),
        ("meshes that no joint moves", 1),
    ];
    let expected = expected.map(|(what, count)| (what.to_owned(), count));
    assert_eq!(omissions(&said), BTreeMap::from(expected));
}

/// A morph target without a name is known by its number, in its own file alone.
#[test]
fn weights_of_morph_targets_go_to_those_of_the_same_name() {
    let folder = tempdir().unwrap();
    let path = folder.path();
    let mut document = hero(path);
    let node = document.nodes.iter().position(|node| node.mesh == Some(0));
    document.animations[0].channels.push(Channel {
        node: node.unwrap(),
        times: vec![0.0, 0.1],
        interpolation: Interpolation::Linear,
        keys: Keys::Weights(vec![0.25, 0.75]),
        extras: None,
    });
    for (name, target) in [
        ("own.glb", None),
        ("other.glb", None),
        ("smile.glb", Some("smile")),
        ("smiling.glb", Some("smile")),
        ("frown.glb", Some("frown")),
    ] {
        document.meshes[0].extras = target.map(|target| json!({ "targetNames": [target] }));
        gltf::write(path.join(name), &document).unwrap();
    }
    for (motion, target, is_kept) in [
        ("own.glb", "own.glb", true),
        ("own.glb", "other.glb", false),
        ("smile.glb", "smiling.glb", true),
        ("smile.glb", "frown.glb", false),
    ] {
        let retarget = [
            "clip", "retarget", motion, "--target", target, "--out", "out.glb",
        ];
        let said = report(path, &retarget);
        let moved = gltf::read(path.join("out.glb")).unwrap();
        let weights = moved.animations[0]
            .channels
            .iter()
            .find_map(|channel| match &channel.keys {
                Keys::Weights(keys) => Some(keys[0]),
                _ => None,
            });
        assert_eq!(weights, is_kept.then_some(0.25), "{motion} {target}");
        let mut warnings = said["warnings"].as_array().unwrap().iter();
        let is_listed = warnings.any(|warning| warning["kind"] == "tracks_left_out");
        assert_eq!(is_listed, !is_kept, "{said}");
    }
}

/// The unit and the weights are those of the figure that is shown.
#[test]
fn characters_are_written_in_metres_with_their_weights() {
    let folder = tempdir().unwrap();
    let path = folder.path();
    let hero = hero(path);
    let animate = [
        "animate",
        "--character",
        "hero.glb",
        "--motion",
        "motion.bvh",
    ];
    let half = [
        "--metres-per-unit",
        "0.5",
        "--smooth-weights",
        "4",
        "--out",
        "half",
    ];
    assert_success(&nullcone(path, animate.iter().chain(&half)));
    let skin = [
        "skin",
        "half/model.glb",
        "--animation",
        "rest",
        "--time",
        "0",
        "--out",
        "rest.obj",
    ];
    assert_success(&nullcone(path, skin));
    let rest = std::fs::read_to_string(path.join("rest.obj")).unwrap();
    assert!((extent(&heights(&rest)) - 0.85).abs() < 1e-6);
    let written = gltf::read(path.join("half/model.glb")).unwrap();
    let [before, after] = [&hero, &written].map(|it| &it.meshes[0].primitives[0]);
    assert_ne!(before.weights, after.weights);
    for vertex in 0..after.positions.len() {
        let weights = after.weights.iter().flat_map(|set| set[vertex]);
        let sum: f64 = weights.map(f64::from).sum();
        assert!((sum - 1.0).abs() < 1e-6, "{sum}");
    }
    assert_eq!(
        (&before.positions, &before.targets),
        (&after.positions, &after.targets)
    );
}

/// The figure without light in the colour of its picture, and a plate that stands behind it.
#[test]
fn pictures_show_what_the_document_has() {
    const PLATE: [u8; 3] = [255, 0, 255];
    let folder = tempdir().unwrap();
    let path = folder.path();
    let mut hero = hero(path);
    hero.materials[0].unlit = true;
    hero.materials[0].base_colour = [1.0; 4];
    hero.materials.push(MaterialElement {
        base_colour: [1.0, 0.0, 1.0, 1.0],
        unlit: true,
        double_sided: true,
        ..MaterialElement::default()
    });
    let plate = &mut hero.meshes[1].primitives[0];
    plate.material = Some(1);
    plate.positions = vec![[-1.0, 0.5, -0.5], [1.0, 0.5, -0.5], [0.0, 1.5, -0.5]];
    let film = |name: &str, hero: &Document| {
        std::fs::create_dir_all(path.join("in")).unwrap();
        std::fs::copy(path.join("paint.png"), path.join("in/paint.png")).unwrap();
        gltf::write(path.join("in/hero.glb"), hero).unwrap();
        let file = format!("{name}.png");
        let animate = format!(
            "animate --character in/hero.glb --motion motion.bvh --out {name} --film {file}"
        );
        let said = report(path, &animate.split(' ').collect::<Vec<_>>());
        for warning in said["warnings"].as_array().unwrap() {
            assert_eq!(warning["kind"], "omission");
            let message = warning["message"].as_str().unwrap();
            assert!(message.ends_with("not in model.obj"), "{message}");
        }
        let picture = |file: &Path| ga_image::file::read(file).unwrap().to_rgb();
        [path.join(file), path.join(name).join("sheet.png")].map(|file| picture(&file))
    };
    let plain = film("plain", &hero);
    for picture in &plain {
        for colour in [PAINT, PLATE] {
            let pixels = picture.values().iter();
            assert!(pixels.filter(|&&pixel| pixel == colour).count() > 1000);
        }
    }

    // The morph target makes the figure broader; another one is so from the beginning.
    let figure = &mut hero.meshes[0];
    figure.weights = vec![10.0];
    let primitive = &mut figure.primitives[0];
    let wider = primitive
        .positions
        .iter()
        .map(|[x, _, _]| [0.03 * x, 0.0, 0.0]);
    primitive.targets[0].positions = wider.collect();
    let morphed = film("morphed", &hero);
    let primitive = &mut hero.meshes[0].primitives[0];
    primitive.targets.clear();
    for position in &mut primitive.positions {
        position[0] *= 1.3;
    }
    hero.meshes[0].weights.clear();
    let broad = film("broad", &hero);
    for number in 0..2 {
        let share = |other: &Plane<[u8; 3]>| {
            let pairs = morphed[number].values().iter().zip(other.values());
            pairs.filter(|(a, b)| a != b).count() as f64 / other.values().len() as f64
        };
        // Rounding to single precision may move an edge.
        assert!(share(&broad[number]) < 1e-3, "{}", share(&broad[number]));
        assert!(share(&plain[number]) > 1e-2, "{}", share(&plain[number]));
    }

    std::fs::remove_file(path.join("paint.png")).unwrap();
    let animate = "animate --character hero.glb --motion motion.bvh --out lost";
    let said = report(path, &animate.split(' ').collect::<Vec<_>>());
    let warnings = said["warnings"].as_array().unwrap();
    let lost = warnings.iter().filter(|it| it["kind"] == "missing_part");
    let lost: Vec<&Value> = lost.collect();
    assert_eq!(lost.len(), 1, "{warnings:?}");
    assert_eq!(lost[0]["file"], "hero.glb");
    assert!(lost[0]["message"].as_str().unwrap().contains("paint.png"));
}
