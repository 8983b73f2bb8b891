//! Where the results of all commands go, and what is refused before the work.

use std::path::Path;

use tempfile::tempdir;

use crate::common::{assert_failure, assert_success, names, nullcone, text};

/// Commands whose inputs do not exist, the option of an output, the endings that fit, and one
/// whose format the command does not write.
const OUTPUTS: [(&str, &str, &str, &str); 40] = [
    ("curve none.csv", "--out", ".csv", "json"),
    ("curve none.csv", "--plot", ".svg", "png"),
    ("draw none.json", "--out", ".svg, .html or .htm", "pdf"),
    ("render none.obj", "--out", ".png, .y4m or .mp4", "jpg"),
    (
        "render none.obj --out p.png",
        "--camera-out",
        ".json",
        "yml",
    ),
    (
        "skin none.glb --time 0",
        "--out",
        ".obj, .glb, .gltf or .ply",
        "stl",
    ),
    (
        "texture none.obj --views v.json",
        "--out",
        ".glb, .gltf or .obj",
        "ply",
    ),
    ("contour none.png", "--out", ".svg", "png"),
    (
        "contour none.png b.png --rig r.yml",
        "--out",
        ".obj, .glb, .gltf or .ply",
        "svg",
    ),
    (
        "clip compress none.bvh --tolerance 1e-4",
        "--out",
        ".clip",
        "bvh",
    ),
    (
        "clip compress none.bvh --tolerance 1e-4",
        "--out",
        ".clip",
        "glb",
    ),
    (
        "clip resample none.clip --rate 5",
        "--out",
        ".clip, .bvh, .glb or .gltf",
        "fbx",
    ),
    (
        "clip mirror none.clip",
        "--out",
        ".clip, .bvh, .glb or .gltf",
        "fbx",
    ),
    (
        "clip convert none.clip",
        "--out",
        ".clip, .bvh, .glb or .gltf",
        "fbx",
    ),
    (
        "clip blend none.clip b.clip --weights 1,1",
        "--out",
        ".clip, .bvh, .glb or .gltf",
        "fbx",
    ),
    (
        "clip retarget none.bvh --target none.glb",
        "--out",
        ".clip, .bvh, .glb or .gltf",
        "fbx",
    ),
    (
        "mesh convert none.obj",
        "OUT",
        ".glb, .gltf, .obj or .ply",
        "stl",
    ),
    (
        "mesh subdivide none.obj --levels 1",
        "--out",
        ".obj, .glb, .gltf or .ply",
        "stl",
    ),
    ("quality compare none.y4m b.y4m", "--csv", ".csv", "txt"),
    ("quality compare none.y4m b.y4m", "--plot", ".svg", "jpg"),
    (
        "quality compare none.y4m b.y4m",
        "--report",
        ".html or .htm",
        "txt",
    ),
    ("quality fit none.csv", "--plot", ".svg", "png"),
    ("quality fit none.csv", "--report", ".html or .htm", "pdf"),
    ("quality ratings none.csv", "--plot", ".svg", "png"),
    (
        "quality ratings none.csv",
        "--report",
        ".html or .htm",
        "pdf",
    ),
    (
        "stereo match none.png b.png --max-disparity 9",
        "--out",
        ".pfm or .png",
        "tiff",
    ),
    (
        "stereo match none.png b.png --max-disparity 9 --out d.pfm",
        "--confidence",
        ".png",
        "jpg",
    ),
    ("stereo evaluate none.pfm b.pfm", "--picture", ".png", "jpg"),
    (
        "stereo undistort none.png --camera none.yml",
        "--out",
        ".png",
        "jpg",
    ),
    (
        "stereo undistort none.png --camera none.yml --out a.png",
        "--new-camera",
        ".yml or .yaml",
        "json",
    ),
    (
        "stereo reconstruct none.png b.png --rig r.yml",
        "--out",
        ".ply, .glb, .gltf or .obj",
        "stl",
    ),
    (
        "capture none.csv --calibrated 0,1,2,3",
        "--out",
        ".csv, .glb, .gltf, .obj or .ply",
        "txt",
    ),
    (
        "capture none.csv --calibrated 0,1,2,3",
        "--pose",
        ".csv",
        "json",
    ),
    (
        "body fit --joints none.json --rig r.yml --character mannequin",
        "--out",
        ".glb",
        "obj",
    ),
    ("body evaluate --motion none.bvh", "--plot", ".svg", "png"),
    ("video align none.y4m", "--out", ".y4m", "mp4"),
    (
        "video comfort none.y4m --layout top-bottom",
        "--out",
        ".html or .htm",
        "pdf",
    ),
    (
        "video keyframes none.y4m",
        "--scenes",
        ".csv or .edl",
        "json",
    ),
    ("video keyframes none.y4m", "--contact-sheet", ".png", "jpg"),
    (
        "animate --character none.glb --motion none.bvh",
        "--film",
        ".png, .y4m or .mp4",
        "gif",
    ),
];

/// A command with an output of this name.
fn with_output(command: &str, option: &str, name: &str) -> Vec<String> {
    let words = command.split(' ').chain([option, name]);
    let words = words.filter(|word| *word != "OUT");
    words.map(str::to_owned).collect()
}

#[test]
fn an_ending_that_does_not_fit_is_refused_before_the_input_is_read() {
    let folder = tempdir().unwrap();
    for (command, option, endings, wrong) in OUTPUTS {
        for name in [format!("a.{wrong}"), "a".to_owned()] {
            let output = nullcone(folder.path(), with_output(command, option, &name));
            let message = format!("{option} {name}: its name must end in {endings}\n");
            assert_failure(&output, &[&message]);
        }
    }
    assert!(names(folder.path()).is_empty());
}

#[test]
fn endings_count_in_capital_letters_too() {
    let folder = tempdir().unwrap();
    for (command, option, endings, _) in OUTPUTS {
        let endings = endings
            .split([',', ' '])
            .filter(|word| word.starts_with('.'))
            .filter(|ending| cfg!(feature = "mp4") || *ending != ".mp4");
        for ending in
            endings.filter(|ending| !(command.starts_with("capture") && *ending != ".csv"))
        {
            let name = format!("A{}", ending.to_ascii_uppercase());
            let output = nullcone(folder.path(), with_output(command, option, &name));
            // The name of the output is right, so that the input is missed.
            assert_failure(&output, &["none", "No such file"]);
        }
    }
    assert!(names(folder.path()).is_empty());
}

const KEYS: &str = "t,x\n0,0\n1,1\n2,0.5\n";
const TRIANGLE: &str = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";

#[test]
fn an_input_is_not_replaced() {
    let folder = tempdir().unwrap();
    let path = |name: &str| folder.path().join(name);
    for name in [
        "k.csv", "m.obj", "w.clip", "run.bvh", "hero.glb", "a.png", "k.yml",
    ] {
        std::fs::write(path(name), "the only copy").unwrap();
        #[cfg(unix)]
        {
            std::fs::hard_link(path(name), path(&format!("hard-{name}"))).unwrap();
            std::os::unix::fs::symlink(name, path(&format!("soft-{name}"))).unwrap();
        }
    }
    let before = names(folder.path());
    for (command, option, input) in [
        ("curve k.csv", "--out", "k.csv"),
        ("clip resample w.clip --rate 5", "--out", "w.clip"),
        ("clip mirror w.clip", "--out", "w.clip"),
        ("clip blend w.clip w.clip --weights 1,1", "--out", "w.clip"),
        (
            "clip retarget run.bvh --target hero.glb",
            "--out",
            "hero.glb",
        ),
        (
            "clip retarget run.bvh --target hero.glb",
            "--out",
            "run.bvh",
        ),
        ("mesh convert m.obj", "OUT", "m.obj"),
        ("mesh subdivide m.obj --levels 1", "--out", "m.obj"),
        ("contour a.png b.png --rig m.obj", "--out", "m.obj"),
        ("texture hero.glb --views v.json", "--out", "hero.glb"),
        ("stereo undistort a.png --camera k.yml", "--out", "a.png"),
        (
            "stereo undistort a.png --camera k.yml --out b.png",
            "--new-camera",
            "k.yml",
        ),
        ("stereo evaluate a.png b.pfm", "--picture", "a.png"),
        (
            "render m.obj --out p.png --camera x.json",
            "--out",
            "./k.csv/../p.png",
        ),
        (
            "body fit --joints j.json --rig k.yml --character hero.glb",
            "--out",
            "hero.glb",
        ),
        (
            "quality compare a.png b.png --attention a.png",
            "--csv",
            "k.csv",
        ),
    ]
    .into_iter()
    .filter(|(command, _, input)| command.contains(input))
    {
        let forms: &[&str] = if cfg!(unix) {
            &["", "./", "hard-", "soft-"]
        } else {
            &["", "./"]
        };
        for form in forms {
            let name = format!("{form}{input}");
            let output = nullcone(folder.path(), with_output(command, option, &name));
            let message = format!("{option} {name}: it is the input {input}, which would be lost");
            assert_failure(&output, &[&message]);
            assert_eq!(names(folder.path()), before);
            assert_eq!(std::fs::read(path(input)).unwrap(), b"the only copy");
        }
    }
}

#[test]
fn the_outputs_of_a_calibration_are_checked_before_its_views_are_read() {
    let folder = tempdir().unwrap();
    for name in ["corners001.png", "r.png"] {
        std::fs::write(folder.path().join(name), "the only copy").unwrap();
    }
    let before = names(folder.path());
    let refused = |more: &str, message: &str| {
        let views = "--left corners001.png --right r.png";
        let line = format!("stereo calibrate --board 9x6 --square 0.1 {views} {more}");
        assert_failure(&nullcone(folder.path(), line.split(' ')), &[message]);
        assert_eq!(names(folder.path()), before);
    };
    refused(
        "--out rig.json",
        "--out rig.json: its name must end in .yml or .yaml",
    );
    refused(
        "--out RIG.YAML --pictures .",
        "--pictures ./corners001.png: it is the input corners001.png",
    );
}

/// A folder of numbered pictures is a video.
#[test]
fn a_picture_of_a_video_is_not_replaced() {
    let folder = tempdir().unwrap();
    let film = folder.path().join("film");
    std::fs::create_dir(&film).unwrap();
    std::fs::write(film.join("1.png"), b"\x89PNG").unwrap();
    std::fs::write(film.join("old.svg"), b"<svg/>").unwrap();
    let run = |more: &[&str]| {
        let output = nullcone(
            folder.path(),
            [&["video", "keyframes", "film"], more].concat(),
        );
        assert_failure(&output, &[]);
        text(&output.stderr).to_owned()
    };
    let sheet = run(&["--contact-sheet", "film/1.png"]);
    assert!(sheet.contains("it is the input film"), "{sheet}");
    let keys = run(&["--out", "film/../film"]);
    assert!(
        keys.contains("it is the folder film that is read"),
        "{keys}"
    );
    // What is no picture is not read: this fails later, at the picture.
    let plot = run(&["--plot", "film/old.svg"]);
    assert!(plot.contains("1.png"), "{plot}");
    assert_eq!(names(&film), ["1.png", "old.svg"]);
}

#[test]
fn a_dash_is_standard_output() {
    let folder = tempdir().unwrap();
    let path = |name: &str| folder.path().join(name);
    std::fs::write(path("k.csv"), KEYS).unwrap();
    std::fs::write(path("m.obj"), TRIANGLE).unwrap();
    let curve = |more: &[&str]| {
        nullcone(
            folder.path(),
            [&["curve", "k.csv", "--samples", "5"], more].concat(),
        )
    };
    assert_success(&curve(&["--out", "rows.csv"]));
    let rows = std::fs::read(path("rows.csv")).unwrap();
    let mut dashes = vec!["-"];
    if cfg!(unix) {
        dashes.push("/dev/stdout");
    }
    for dash in dashes {
        let output = curve(&["--out", dash]);
        assert_success(&output);
        assert_eq!(output.stdout, rows);
        assert_eq!(text(&output.stderr), format!("wrote {dash}: 5 rows\n"));
    }
    let quiet = curve(&["--out", "-", "--plot", "plot.svg", "--quiet"]);
    assert_eq!((&quiet.stdout, &quiet.stderr[..]), (&rows, &b""[..]));
    let binary = nullcone(folder.path(), ["mesh", "convert", "m.obj", "-"]);
    assert!(binary.stdout.starts_with(b"glTF"));
    assert_eq!(
        names(folder.path()),
        ["k.csv", "m.obj", "plot.svg", "rows.csv"]
    );

    assert_failure(&curve(&["--out", "-", "--json"]), &["--out -", "--json"]);
    let both = curve(&["--out", "-", "--plot", "-"]);
    assert_failure(
        &both,
        &["--plot -: another output has the same path, that of --out"],
    );
    for folders in [
        "demo --out -",
        "mesh bake --fine m.obj --coarse m.obj --out -",
        "video keyframes film.y4m --out -",
        "stereo rectify a.png b.png --rig r.yml --out -",
        "render m.obj --out p.png --buffers -",
        "man --out -",
    ] {
        let output = nullcone(folder.path(), folders.split(' '));
        assert_failure(
            &output,
            &["-: several files are written, and they need a folder"],
        );
    }
    assert_eq!(
        names(folder.path()),
        ["k.csv", "m.obj", "plot.svg", "rows.csv"]
    );
}

/// Materials of OBJ are in a file of their own.
#[test]
fn several_files_do_not_go_to_standard_output() {
    let folder = tempdir().unwrap();
    let path = |name: &str| folder.path().join(name);
    let obj = format!("mtllib a.mtl\n{}", TRIANGLE.replace("f ", "usemtl red\nf "));
    std::fs::write(path("a.obj"), obj).unwrap();
    std::fs::write(path("a.mtl"), "newmtl red\nKd 1 0 0\n").unwrap();
    let run = |command: &str| nullcone(folder.path(), command.split(' '));
    let refused = run("mesh subdivide a.obj --levels 1 --out -");
    assert_failure(
        &refused,
        &["-: the mesh needs several files, such as model.mtl"],
    );
    let binary = run("mesh convert a.obj -");
    assert_success(&binary);
    assert!(binary.stdout.starts_with(b"glTF"));
    assert_eq!(names(folder.path()), ["a.mtl", "a.obj"]);
}

#[cfg(unix)]
fn mode(path: &Path) -> u32 {
    std::os::unix::fs::MetadataExt::mode(&path.metadata().unwrap())
}

/// A pipe, a link, and files whose owner has set their modes.
#[cfg(unix)]
#[test]
fn outputs_keep_what_they_are() {
    use std::os::unix::fs::{PermissionsExt, symlink};
    let folder = tempdir().unwrap();
    let path = |name: &str| folder.path().join(name);
    std::fs::write(path("k.csv"), KEYS).unwrap();
    let curve = |out: &str| nullcone(folder.path(), ["curve", "k.csv", "--out", out]);
    assert_success(&curve("new.csv"));
    let rows = std::fs::read(path("new.csv")).unwrap();
    assert_eq!(mode(&path("new.csv")), mode(&path("k.csv")));

    let made = std::process::Command::new("mkfifo")
        .arg(path("pipe"))
        .status();
    assert!(made.unwrap().success());
    let reader = std::thread::spawn({
        let pipe = path("pipe");
        move || std::fs::read(pipe).unwrap()
    });
    assert_success(&curve("pipe"));
    assert_eq!(reader.join().unwrap(), rows);
    assert!(!path("pipe").metadata().unwrap().is_file());

    std::fs::write(path("target.csv"), "old").unwrap();
    std::fs::set_permissions(path("target.csv"), PermissionsExt::from_mode(0o640)).unwrap();
    symlink("target.csv", path("link.csv")).unwrap();
    std::fs::hard_link(path("target.csv"), path("other.csv")).unwrap();
    assert_success(&curve("link.csv"));
    assert!(path("link.csv").symlink_metadata().unwrap().is_symlink());
    assert_eq!(std::fs::read(path("other.csv")).unwrap(), rows);
    assert_eq!(mode(&path("other.csv")) & 0o777, 0o640);

    std::fs::write(path("master.csv"), "old").unwrap();
    std::fs::set_permissions(path("master.csv"), PermissionsExt::from_mode(0o444)).unwrap();
    let refused = curve("master.csv");
    assert_failure(
        &refused,
        &["cannot write master.csv: the file is read-only"],
    );
    assert_eq!(std::fs::read(path("master.csv")).unwrap(), b"old");
}
