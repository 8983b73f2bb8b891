//! `nullcone demo --figure`, run as a user runs it.

use std::path::{Path, PathBuf};
use std::process::{Output, Stdio};
use std::sync::OnceLock;

use ga_anim::bvh;
use ga_anim::clip::Clip;
use ga_anim::pose::Pose;
use ga_character::Figure;
use serde_json::Value;
use tempfile::tempdir;

use crate::common::{
    assert_failure, assert_success, contents, extent, heights, names, nullcone, number, program,
    report, text,
};

/// What the demo writes, in the order of [`names`].
const FILES: [&str; 6] = [
    "model.glb",
    "model.mtl",
    "model.obj",
    "report.json",
    "sheet.png",
    "skin.png",
];

/// The output of one run for all tests that only look at it, and the folder it wrote.
fn demo() -> &'static (Output, PathBuf) {
    static DEMO: OnceLock<(Output, PathBuf)> = OnceLock::new();
    DEMO.get_or_init(|| {
        let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("figure");
        let _ = std::fs::remove_dir_all(&folder);
        std::fs::create_dir_all(&folder).unwrap();
        let output = nullcone(&folder, ["demo", "--figure"]);
        assert_success(&output);
        (output, folder.join("out"))
    })
}

#[test]
fn it_writes_six_files_and_says_so() {
    let (output, out) = demo();
    assert!(output.stderr.is_empty(), "{}", text(&output.stderr));
    assert_eq!(names(out), FILES);
    for name in FILES {
        assert!(text(&output.stdout).contains(name));
    }
    let report = report(out);
    for (index, name) in [
        "model.obj",
        "model.glb",
        "sheet.png",
        "model.mtl",
        "skin.png",
    ]
    .iter()
    .enumerate()
    {
        let file = &report["files"][index];
        assert_eq!(file["name"], *name);
        let bytes = std::fs::metadata(out.join(name)).unwrap().len();
        assert_eq!(file["bytes"].as_u64(), Some(bytes));
    }
    let sheet = image::open(out.join("sheet.png")).unwrap();
    assert_eq!(
        number(&report, "/files/2/pixels/0"),
        f64::from(sheet.width())
    );
    assert_eq!(
        number(&report, "/files/2/pixels/1"),
        f64::from(sheet.height())
    );
}

/// The picture, the coordinates and the material in the files of the model.
#[test]
fn the_model_wears_its_painted_skin() {
    let (_, out) = demo();
    let skin = image::open(out.join("skin.png")).unwrap().to_rgb8();
    let mesh = ga_mesh::obj::read(out.join("model.obj")).unwrap();
    let texture = mesh.materials()[0].base_colour_texture.as_ref().unwrap();
    assert_eq!(texture.image, ga_mesh::Image::File("skin.png".to_owned()));
    assert!(
        mesh.face_materials()
            .iter()
            .all(|material| *material == Some(0))
    );
    let coordinates = mesh.texture_coordinates().unwrap();
    assert_eq!(coordinates.corners.len(), mesh.faces().corners().len());

    let (document, buffers, images) = gltf::import(out.join("model.glb")).unwrap();
    assert_eq!(images[0].pixels, skin.into_raw());
    let primitive = document
        .meshes()
        .next()
        .unwrap()
        .primitives()
        .next()
        .unwrap();
    let material = primitive.material().pbr_metallic_roughness();
    let info = material.base_color_texture().unwrap();
    assert_eq!((info.texture().source().index(), info.tex_coord()), (0, 0));
    // Each corner has the place and the coordinates of that of the OBJ file; glTF has v down.
    let reader = primitive.reader(|buffer| Some(&buffers[buffer.index()]));
    let positions: Vec<[f32; 3]> = reader.read_positions().unwrap().collect();
    let places: Vec<[f32; 2]> = reader.read_tex_coords(0).unwrap().into_f32().collect();
    let indices: Vec<u32> = reader.read_indices().unwrap().into_u32().collect();
    assert_eq!(positions.len(), places.len());
    assert!(positions.len() < mesh.vertex_count() * 5 / 4);
    assert_eq!(indices.len(), coordinates.corners.len());
    for (corner, &index) in indices.iter().enumerate() {
        let vertex = mesh.faces().corners()[corner] as usize;
        let position = mesh.positions()[vertex].coordinates().map(|c| c as f32);
        let [u, v] = *coordinates.get(corner).unwrap();
        assert_eq!(positions[index as usize], position);
        assert_eq!(places[index as usize], [u as f32, (1.0 - v) as f32]);
    }
}

/// A stride has eight key poses: a row from each to the next, with three poses between.
#[test]
fn the_sheet_shows_a_whole_stride() {
    let sheet = image::open(demo().1.join("sheet.png")).unwrap().to_rgb8();
    // The frame around the picture of a key frame.
    let is_key = |x: u32, y: u32| sheet.get_pixel(x, y).0 == [210, 84, 12];
    let begins = |list: Vec<bool>| {
        let mut before = false;
        list.into_iter()
            .filter(|&here| !std::mem::replace(&mut before, here) && here)
            .count()
    };
    // Down the left frame of the first column: a picture and its depth in each row.
    let any = |x: u32| (0..sheet.height()).any(|y| is_key(x, y));
    let left = (0..sheet.width()).find(|&x| any(x)).unwrap();
    let down = begins((0..sheet.height()).map(|y| is_key(left, y)).collect());
    assert_eq!(down, 8 * 2);
    // Across the first row: the left and the right frame of the first and of the last picture.
    let middle = (0..sheet.height()).find(|&y| is_key(left, y)).unwrap() + 100;
    let across = begins((0..sheet.width()).map(|x| is_key(x, middle)).collect());
    assert_eq!(across, 4);
}

#[test]
fn bones_trails_and_a_film_are_drawn_where_they_are_asked_for() {
    let folder = tempdir().unwrap();
    let marked = [
        "--bones",
        "--trails",
        "LeftFoot,RightHand",
        "--film",
        "film.png",
    ];
    let output = nullcone(folder.path(), ["demo", "--figure"].iter().chain(&marked));
    assert_success(&output);
    assert!(text(&output.stdout).contains("film.png"));
    let film = std::fs::File::open(folder.path().join("film.png")).unwrap();
    let decoder = image::codecs::png::PngDecoder::new(std::io::BufReader::new(film)).unwrap();
    let frames = image::AnimationDecoder::into_frames(decoder.apng().unwrap());
    let frames: Vec<image::Frame> = frames.map(Result::unwrap).collect();
    let out = folder.path().join("out");
    assert_eq!(
        frames.len() as f64,
        number(&report(&out), "/animation/frames")
    );
    let (numerator, denominator) = frames[0].delay().numer_denom_ms();
    let seconds = f64::from(numerator) / f64::from(denominator) / 1000.0;
    let rate = number(&report(&out), "/animation/frames_per_second");
    assert!((seconds * rate - 1.0).abs() < 0.02, "{seconds} {rate}");

    let count = |colour: [u8; 3], picture: &image::RgbImage| {
        picture.pixels().filter(|pixel| pixel.0 == colour).count()
    };
    let (bone, path) = ([28, 88, 160], [214, 51, 39]);
    let [plain, drawn] = [&demo().1, &out].map(|out| {
        let sheet = image::open(out.join("sheet.png")).unwrap();
        sheet.to_rgb8()
    });
    assert_eq!((count(bone, &plain), count(path, &plain)), (0, 0));
    assert!(count(bone, &drawn) > 1000);
    // A trail grows with time: it is there in the last picture, but not in the first one.
    let [first, last] = [&frames[0], &frames[frames.len() - 1]].map(|frame| {
        let picture = image::DynamicImage::from(frame.buffer().clone()).to_rgb8();
        picture
            .pixels()
            .filter(|p| p.0[0] > 180 && p.0[1] < 110 && p.0[2] < 110)
            .count()
    });
    assert!(last > first + 100, "{first} {last}");
    // The model is the same.
    for name in ["model.glb", "model.obj", "skin.png"] {
        let [a, b] = [&demo().1, &out].map(|out| std::fs::read(out.join(name)).unwrap());
        assert!(a == b, "{name}");
    }
}

#[test]
fn wrong_films_and_trails_are_named() {
    let folder = tempdir().unwrap();
    for (arguments, parts) in [
        (["--trails", "Tail"], ["Tail", "LeftFoot"]),
        (["--film", "film.gif"], ["film.gif", ".png, .y4m or .mp4"]),
        (
            ["--film", "out/sheet.png"],
            ["out/sheet.png", "another output"],
        ),
    ] {
        let output = nullcone(folder.path(), ["demo", "--figure"].iter().chain(&arguments));
        assert_failure(&output, &parts);
    }
    assert!(names(folder.path()).is_empty());
}

#[test]
fn the_person_is_whole_and_upright() {
    let (_, out) = demo();
    let report = report(out);
    let heights = heights(&std::fs::read_to_string(out.join("model.obj")).unwrap());
    assert_eq!(number(&report, "/figure/vertices"), heights.len() as f64);
    assert!((number(&report, "/figure/height_metres") - extent(&heights)).abs() < 1e-12);
    assert!((1.7..1.8).contains(&extent(&heights)));

    let checks = |name: &str| number(&report, &format!("/animation/checks/{name}"));
    assert!(checks("bone_length_deviation_max_metres") < 1e-12);
    assert!(checks("lowest_vertex_min_metres") > -0.01);
    assert!(checks("lowest_vertex_max_metres") < 0.01);
    assert!(checks("trunk_from_upright_max_degrees") < 5.0);
    assert!(checks("linear_to_motor_blend_max_metres") < 0.02);
    assert!(checks("linear_to_motor_blend_mean_metres") > 0.0);
}

#[test]
fn the_model_walks_one_way_in_a_viewer() {
    let (_, out) = demo();
    let report = report(out);
    let (document, buffers, _) = gltf::import(out.join("model.glb")).unwrap();
    let skin = document.skins().next().unwrap();
    assert_eq!(
        skin.joints().count() as f64,
        number(&report, "/figure/joints")
    );
    let animation = document.animations().next().unwrap();
    let hips = animation.channels().find_map(|channel| {
        if channel.target().node().name() != Some("Hips") {
            return None;
        }
        let reader = channel.reader(|buffer| Some(&buffers[buffer.index()]));
        let times: Vec<f32> = reader.read_inputs()?.collect();
        match reader.read_outputs()? {
            gltf::animation::util::ReadOutputs::Translations(places) => {
                Some((times, places.collect::<Vec<_>>()))
            }
            _ => None,
        }
    });
    let (times, places) = hips.expect("the hips move");
    let duration = number(&report, "/animation/duration_seconds");
    assert!((f64::from(*times.last().unwrap()) - duration).abs() < 1e-5);
    assert_eq!(times.len() as f64, number(&report, "/animation/frames"));
    assert!(places.windows(2).all(|pair| pair[1][2] > pair[0][2]));
    // People walk at 1.2 to 1.5 metres a second.
    let way = f64::from(places.last().unwrap()[2] - places[0][2]);
    assert!(
        (1.0..1.6).contains(&(way / duration)),
        "{way} m in {duration} s"
    );
}

fn joint_error(report: &Value, which: &str) -> f64 {
    number(
        report,
        &format!("/two_views/{which}/mean_per_joint_position_error_metres"),
    )
}

#[test]
fn two_cameras_find_the_joints() {
    let report = report(&demo().1);
    assert!(joint_error(&report, "noise_free") <= 1e-9);

    // A pixel is s = D/f metres at the distance D. Two rays at the angle α to either side of the
    // axis between the cameras, each shifted across by independent noise of standard deviation s,
    // cross with these deviations in depth, aside and in height.
    let place = |name: &str| -> [f64; 3] {
        serde_json::from_value(report["two_views"][name].clone()).unwrap()
    };
    let (eye, target) = (place("left_camera_metres"), place("target_metres"));
    let distance = (0..3)
        .map(|k| (eye[k] - target[k]).powi(2))
        .sum::<f64>()
        .sqrt();
    let s = distance / number(&report, "/two_views/focal_length_pixels");
    let alpha = 0.5 * number(&report, "/two_views/angle_degrees").to_radians();
    let depth = s / (2f64.sqrt() * alpha.sin());
    let aside = s / (2f64.sqrt() * alpha.cos());
    let height = s / 2f64.sqrt();
    // Not less than the mean of the error in depth alone, not more than the root of the mean square
    // of all; 5 % for the joints' distances.
    let least = depth * (2.0 / std::f64::consts::PI).sqrt();
    let most = (depth * depth + aside * aside + height * height).sqrt();
    let found = joint_error(&report, "one_pixel_noise");
    assert!(
        found > 0.95 * least && found < 1.05 * most,
        "{least} {found} {most}"
    );
    for which in ["noise_free", "one_pixel_noise"] {
        let found = &report["two_views"][which];
        assert_eq!(found["all_in_front_of_both_cameras"], true);
        assert_eq!(found["all_inside_both_pictures"], true);
    }
}

#[test]
fn a_second_run_writes_the_same_bytes_on_any_number_of_threads_and_is_quiet_if_asked() {
    let folder = tempdir().unwrap();
    let mut command = program(folder.path());
    command
        .args(["--quiet", "demo", "--figure", "--out", "a/b"])
        .env("RAYON_NUM_THREADS", "1");
    let output = command.output().unwrap();
    assert_success(&output);
    assert!(output.stdout.is_empty() && output.stderr.is_empty());
    let (first, second) = (contents(&demo().1), contents(&folder.path().join("a/b")));
    assert_eq!(first.len(), second.len());
    for (a, b) in first.iter().zip(&second) {
        assert!(a == b, "{} differs", a.0);
    }
}

#[test]
fn another_seed_is_other_noise_and_standard_output_may_be_closed() {
    let folder = tempdir().unwrap();
    let mut command = program(folder.path());
    command.args(["demo", "--figure", "--seed", "2"]);
    command.stdout(Stdio::piped()).stderr(Stdio::piped());
    let mut child = command.spawn().unwrap();
    drop(child.stdout.take());
    let output = child.wait_with_output().unwrap();
    assert_success(&output);
    assert!(output.stderr.is_empty(), "{}", text(&output.stderr));

    let [one, two] = [&demo().1, &folder.path().join("out")].map(|out| report(out));
    assert_eq!(
        joint_error(&one, "noise_free"),
        joint_error(&two, "noise_free")
    );
    assert_ne!(
        joint_error(&one, "one_pixel_noise"),
        joint_error(&two, "one_pixel_noise")
    );
}

#[test]
fn what_cannot_be_written_leaves_everything_as_it_was() {
    let folder = tempdir().unwrap();
    std::fs::write(folder.path().join("file"), "kept").unwrap();
    assert_failure(
        &nullcone(folder.path(), ["demo", "--figure", "--out", "file"]),
        &["cannot make the folder file"],
    );
    assert_failure(
        &nullcone(folder.path(), ["demo", "--figure", "--out", "file/below"]),
        &["cannot make the folder file/below"],
    );
    assert_eq!(names(folder.path()), ["file"]);

    let out = folder.path().join("out");
    std::fs::create_dir_all(out.join("report.json")).unwrap();
    std::fs::write(out.join("model.obj"), "kept").unwrap();
    assert_failure(
        &nullcone(folder.path(), ["demo", "--figure"]),
        &["cannot write out/report.json", "is a directory"],
    );
    assert_eq!(names(&out), ["model.obj", "report.json"]);
    assert_eq!(std::fs::read(out.join("model.obj")).unwrap(), b"kept");
}

/// A recording of two seconds in which the hips turn by 90° and go a metre to the left of the room,
/// behind a calibration frame; its first second is taken.
#[test]
fn another_motion_takes_the_place_of_the_walk() {
    let folder = tempdir().unwrap();
    let motion = turning();
    bvh::decode(motion.as_bytes()).unwrap();
    std::fs::write(folder.path().join("turn.bvh"), motion).unwrap();
    let demo = ["demo", "--figure", "--motion", "turn.bvh", "--out"];
    assert_success(&nullcone(folder.path(), demo.iter().chain(&["out"])));
    let out = report(&folder.path().join("out"));
    let of_motion = |key: &str| number(&out, &format!("/input/motion/{key}"));
    assert_eq!(out["input"]["motion"]["name"], "turn.bvh");
    assert_eq!(out["input"]["mesh"], "made by nullcone");
    assert_eq!(of_motion("frames"), 41.0);
    assert_eq!(
        [of_motion("first_frame"), of_motion("last_frame")],
        [1.0, 21.0]
    );
    assert_eq!(number(&out, "/animation/duration_seconds"), 1.0);
    assert!(number(&out, "/animation/checks/lowest_vertex_min_metres") > -0.02);

    let from = demo.iter().chain(&["late", "--from", "31"]);
    assert_success(&nullcone(folder.path(), from));
    let late = report(&folder.path().join("late"));
    // The last whole frame of the film before the end at 0.45 s.
    assert_eq!(number(&late, "/animation/duration_seconds"), 0.44);
    for (arguments, parts) in [
        (["--from", "41", "--out", "no"], ["--from 41", "0 to 40"]),
        (
            ["--reference-frame", "99", "--out", "no"],
            ["turn.bvh", "99"],
        ),
    ] {
        let arguments = demo[..4].iter().chain(&arguments);
        assert_failure(&nullcone(folder.path(), arguments), &parts);
    }
    assert_eq!(names(folder.path()), ["late", "out", "turn.bvh"]);
}

#[test]
fn another_character_walks_as_well() {
    let folder = tempdir().unwrap();
    let made = demo().1.join("model.glb");
    std::fs::copy(made, folder.path().join("own.glb")).unwrap();
    let demo = ["demo", "--figure", "--character"];
    assert_success(&nullcone(folder.path(), demo.iter().chain(&["own.glb"])));
    let out = report(&folder.path().join("out"));
    assert_eq!(out["input"]["rig"], "own.glb");
    assert_eq!(out["input"]["motion"]["name"], "walk");
    assert_eq!(number(&out, "/animation/duration_seconds"), 1.0);
    for key in ["min", "max"] {
        let key = format!("/animation/checks/lowest_vertex_{key}_metres");
        assert!(number(&out, &key).abs() < 0.02);
    }

    // The figure alone may be smaller than any on which dots are seen.
    let mut small = Figure::read_gltf(&folder.path().join("own.glb"), 0.01).unwrap();
    small.paint = None;
    let rest = Clip::new(1.0, vec![Pose::rest(small.character.skeleton.len())]).unwrap();
    let (bytes, _) = ga_character::gltf::encode(&small, &rest, "rest").unwrap();
    std::fs::write(folder.path().join("small.glb"), bytes).unwrap();
    let to_small = demo.iter().chain(&["small.glb", "--out", "small"]);
    assert_success(&nullcone(folder.path(), to_small));
    assert_failure(
        &nullcone(
            folder.path(),
            ["demo", "--character", "small.glb", "--out", "none"],
        ),
        &["small.glb", "the skin has room for", "0.017 m large"],
    );
    assert!(!folder.path().join("none").exists());
    let none = nullcone(folder.path(), demo.iter().chain(&["none.glb"]));
    assert_failure(&none, &["none.glb", "No such file"]);
}

/// A person in BVH, in metres.
fn turning() -> String {
    let leg = |side: &str, x: f64| {
        format!(
            "JOINT {side}UpLeg {{ OFFSET {x} 0 0 CHANNELS 3 Zrotation Xrotation Yrotation
             JOINT {side}Leg {{ OFFSET 0 -0.42 0 CHANNELS 3 Zrotation Xrotation Yrotation
             JOINT {side}Foot {{ OFFSET 0 -0.42 0 CHANNELS 3 Zrotation Xrotation Yrotation
             End Site {{ OFFSET 0 -0.06 0.15 }} }} }} }}\n"
        )
    };
    let arm = |side: &str, sign: f64| {
        let [first, second] = [0.15 * sign, 0.28 * sign];
        format!(
            "JOINT {side}Arm {{ OFFSET {first} 0.45 0 CHANNELS 3 Zrotation Xrotation Yrotation
             JOINT {side}ForeArm {{ OFFSET {second} 0 0 CHANNELS 3 Zrotation Xrotation Yrotation
             End Site {{ OFFSET {second} 0 0 }} }} }}\n"
        )
    };
    let head = "JOINT Spine { OFFSET 0 0.1 0 CHANNELS 3 Zrotation Xrotation Yrotation
         JOINT Head { OFFSET 0 0.5 0 CHANNELS 3 Zrotation Xrotation Yrotation
         End Site { OFFSET 0 0.2 0 } }\n";
    let frames = (0..41).map(|frame| {
        let part = f64::from(frame) / 40.0;
        let arms = if frame == 0 { 0.0 } else { 75.0 };
        let mut line = format!("{part} 0.9 0 0 0 {}", 90.0 * part);
        for joint in 0..12 {
            let down = match joint {
                2 => -arms,
                4 => arms,
                _ => 0.0,
            };
            line += &format!(" {down} 0 0");
        }
        line + "\n"
    });
    format!(
        "HIERARCHY ROOT Hips {{ OFFSET 0 0 0 CHANNELS 6 Xposition Yposition Zposition Zrotation \
         Xrotation Yrotation\n{head}{}{} }}\n{}{} }}\nMOTION\nFrames: 41\nFrame Time: 0.05\n{}",
        arm("Left", 1.0),
        arm("Right", -1.0),
        leg("Left", 0.1),
        leg("Right", -0.1),
        frames.collect::<String>()
    )
}

#[test]
fn wrong_usage_has_a_status_of_its_own() {
    let folder = tempdir().unwrap();
    for arguments in [
        &[][..],
        &["dance"],
        &["demo", "--seed", "x"],
        &["demo", "--from", "1"],
        &["animate"],
    ] {
        let output = nullcone(folder.path(), arguments);
        assert_eq!(output.status.code(), Some(2), "{arguments:?}");
        assert!(!output.stderr.is_empty());
    }
    for arguments in [&["--help"][..], &["--version"], &["animate", "--help"]] {
        let output = nullcone(folder.path(), arguments);
        assert_success(&output);
        assert!(text(&output.stdout).contains("nullcone"));
    }
    assert!(names(folder.path()).is_empty());
}
