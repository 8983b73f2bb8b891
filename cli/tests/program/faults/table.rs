//! The table of all commands, each with small inputs and its outputs.

use std::path::Path;

use super::inputs;
use crate::common::text;
use crate::manuals;

/// A command with its words. `DATA` is the folder of the inputs, and all outputs are below `OUT`.
pub(super) struct Row {
    pub(super) line: &'static str,
    /// Whether the inputs are too small for the work, which fails at the end: the rest of it is
    /// tried.
    pub(super) fails: bool,
}

impl Row {
    /// The words for inputs in a folder and outputs in another.
    pub(super) fn words(&self, data: &Path, out: &str) -> Vec<String> {
        words(self.line, data, out)
    }

    /// The inputs that are files by their names.
    pub(super) fn inputs(&self) -> Vec<&'static str> {
        let words = self.line.split_whitespace();
        let names = words.filter_map(|word| word.strip_prefix("DATA/"));
        let mut names: Vec<&str> = names.filter(|name| !name.contains('?')).collect();
        names.sort_unstable();
        names.dedup();
        names
    }
}

pub(super) fn words(line: &str, data: &Path, out: &str) -> Vec<String> {
    let data = data.to_str().unwrap();
    let words = line.split_whitespace();
    let words = words.map(|word| word.replace("DATA", data).replace("OUT", out));
    words.collect()
}

/// The rows whose inputs suffice.
pub(super) fn working() -> Vec<&'static Row> {
    ROWS.iter().filter(|row| !row.fails).collect()
}

const fn row(line: &'static str) -> Row {
    Row { line, fails: false }
}

const fn failing(line: &'static str) -> Row {
    Row { line, fails: true }
}

pub(super) const ROWS: &[Row] = &[
    row(
        "animate --mesh DATA/mesh.obj --rig DATA/rig.json --weights DATA/weights.json --motion DATA/motion.bvh --out OUT/animated",
    ),
    row(
        "animate --character DATA/hero.glb --motion DATA/motion.bvh --out OUT/animated --film OUT/film.y4m",
    ),
    row(
        "capture DATA/points.csv --calibrated 0,1,2,3 --out OUT/e.csv --pose OUT/pose.csv --matrix OUT/matrix.csv",
    ),
    row("expand DATA/functions.txt --report OUT/page.html"),
    row("contour DATA/blob.png --out OUT/blob.svg"),
    row(
        "curve DATA/keys.csv --samples 5 --out OUT/curve.csv --plot OUT/curve.svg --report OUT/page.html",
    ),
    row("draw DATA/scene.json --out OUT/scene.html"),
    row("merge DATA/0.json DATA/1.json --out OUT/t.csv --out OUT/c.svg --out OUT/v.json"),
    row(
        "people DATA/wall.y4m --joints DATA/joints.json --views DATA/views.json --up y --floor -0.9 --out OUT/person",
    ),
    row(
        "render DATA/cube.obj --size 24x16 --out OUT/p.png --buffers OUT/b --camera-out OUT/c.json",
    ),
    row("render DATA/hero.glb --size 24x16 --samples 1 --film OUT/film.y4m --rate 25"),
    row("render DATA/cube.obj --turntable 3 --size 24x16 --views OUT/views --out OUT/turn.y4m"),
    row("skin DATA/hero.glb --time 0.02 --out OUT/frame.obj"),
    row("texture DATA/cube.obj --views DATA/views/views.json --size 32 --out OUT/textured.glb"),
    row("completions bash --report OUT/page.html"),
    row("man --out OUT/man1"),
    row(
        "body fit --joints DATA/joints.json --views DATA/views.json --character mannequin --out OUT/fitted.glb",
    ),
    row(
        "body evaluate --motion DATA/person.bvh --noise 1 --views 2 --frames 3 --plot OUT/plot.svg",
    ),
    row("body paint --character DATA/hero.glb --out OUT/dotted.glb"),
    failing(
        "body dots DATA/a.y4m DATA/b.y4m DATA/a.y4m --views DATA/views.json --out OUT/joints.json",
    ),
    row(
        "camera calibrate DATA/left0.png DATA/left1.png DATA/left2.png DATA/left3.png --board 5x4 --square 0.1 --out OUT/camera.yml",
    ),
    row(
        "camera calibrate-rig --board 5x4 --square 0.1 --views DATA/left?.png --views DATA/right?.png --out OUT/rig.toml",
    ),
    row("camera convert DATA/rig.yml --out OUT/rig.json"),
    row("clip compress DATA/motion.bvh --tolerance 0.01 --shell 1 --out OUT/a.clip"),
    row("clip info DATA/motion.bvh --report OUT/page.html"),
    row("clip sample DATA/walk.clip --times 0,0.02 --report OUT/page.html"),
    row("clip convert DATA/walk.clip --out OUT/a.bvh"),
    row("clip resample DATA/motion.bvh --rate 10 --out OUT/a.clip"),
    row("clip retarget DATA/motion.bvh --target DATA/hero.glb --out OUT/moved.glb"),
    row("clip mirror DATA/walk.clip --out OUT/a.bvh"),
    row("clip blend DATA/motion.bvh DATA/walk.clip --weights 0.5,0.5 --out OUT/a.clip"),
    row("mesh info DATA/cube.obj --report OUT/page.html"),
    row("mesh convert DATA/cube.obj OUT/a.glb"),
    row("mesh convert DATA/cube.ply OUT/a.obj"),
    row("mesh subdivide DATA/cube.obj --levels 2 --out OUT/smooth.ply"),
    row(
        "mesh bake --fine DATA/cube.obj --coarse DATA/cube.obj --maps normal --size 16 --out OUT/baked",
    ),
    row(
        "quality compare DATA/a.y4m DATA/b.y4m --csv OUT/t.csv --plot OUT/c.svg --report OUT/page.html",
    ),
    row("quality compare DATA/a.y4m DATA/b.y4m --frames 0..2 --part OUT/part.json"),
    row("quality fit DATA/scores.csv --draws 5 --plot OUT/fit.svg --report OUT/page.html"),
    row("quality ratings DATA/ratings.csv --plot OUT/r.svg --report OUT/page.html"),
    row(
        "stereo calibrate --board 5x4 --square 0.1 --left DATA/left0.png DATA/left1.png DATA/left2.png DATA/left3.png --right DATA/right0.png DATA/right1.png DATA/right2.png DATA/right3.png --out OUT/rig.yml --pictures OUT/found",
    ),
    row(
        "stereo match DATA/small-left.png DATA/small-right.png --max-disparity 12 --out OUT/d.pfm --confidence OUT/c.png --picture OUT/d.png",
    ),
    row("stereo match DATA/a.y4m DATA/b.y4m --max-disparity 4 --out OUT/d_%02d.pfm"),
    row("stereo evaluate DATA/d.pfm DATA/truth.pfm --picture OUT/wrong.png"),
    row("stereo pose DATA/left.png DATA/right.png --camera DATA/camera.yml --report OUT/page.html"),
    row("stereo rectify DATA/left.png DATA/right.png --rig DATA/rig.yml --out OUT/straight"),
    row(
        "stereo undistort DATA/left.png --camera DATA/camera.yml --out OUT/s.png --new-camera OUT/n.yml",
    ),
    row("stereo diagnose DATA/left.png DATA/right.png --report OUT/page.html"),
    row(
        "stereo reconstruct DATA/left.png DATA/right.png --rig DATA/rig.yml --max-disparity 12 --out OUT/model.ply",
    ),
    row("video align DATA/left.y4m DATA/right.y4m --out OUT/aligned.y4m"),
    row("video comfort DATA/left.y4m DATA/right.y4m --out OUT/page.html --summary OUT/s.json"),
    row(
        "video keyframes DATA/a.y4m --out OUT/keys --plot OUT/c.svg --scenes OUT/s.csv --contact-sheet OUT/sheet.png",
    ),
    row("video keyframes DATA/a.y4m --split OUT/shots --report OUT/page.html"),
    row("video score DATA/found.json DATA/labels.csv --report OUT/page.html"),
    row("video statistics DATA/a.y4m DATA/b.y4m --report OUT/page.html"),
];

/// `demo` has tests of its own, as it takes a minute.
const APART: [&str; 1] = ["demo"];

/// A page of `--report` is an output of every command.
#[test]
fn the_table_has_every_command() {
    for command in manuals::commands() {
        let is_group = !manuals::below(&command).is_empty();
        let line = command.join(" ");
        let has_row = ROWS.iter().any(|row| {
            let rest = row.line.strip_prefix(&line);
            rest.is_some_and(|rest| rest.starts_with(' '))
        });
        assert!(has_row || is_group || APART.contains(&&*line), "{line}");
    }
}

/// Otherwise the faults would be those of the inputs.
#[test]
fn the_rows_work() {
    super::for_each(ROWS, |row| {
        let out = tempfile::tempdir().unwrap();
        let words = row.words(inputs::folder(), "new");
        let output = crate::common::nullcone(out.path(), words);
        assert_eq!(
            output.status.code(),
            Some(i32::from(row.fails)),
            "{}: {}",
            row.line,
            text(&output.stderr)
        );
        for output in row.line.split(' ').filter(|word| word.starts_with("OUT/")) {
            let path = out.path().join(output.replace("OUT", "new"));
            let is_there = path.exists() || output.contains('%');
            assert_eq!(is_there, !row.fails, "{}: {output}", row.line);
        }
    });
}
