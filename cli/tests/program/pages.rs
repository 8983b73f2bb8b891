//! The commands of the pages in `docs`.
//!
//! The blocks of a page that are marked `sh` are run in their order, in a folder that has what
//! `nullcone demo` wrote. Blocks marked `sh own-files` need files that a reader has: their commands
//! are run too, and may fail only because those files are not there.

use std::env;
use std::iter;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};
use std::sync::OnceLock;

use tempfile::tempdir;

use crate::common::{assert_success, names, nullcone, text};

/// How the program says that an input is not there. Standard input is empty.
const MISSING: [&str; 3] = ["No such file", "matches no file", "standard input"];

fn docs() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../docs")
}

/// The blocks of code of a page that have this mark.
fn blocks(page: &str, mark: &str) -> Vec<String> {
    let page = std::fs::read_to_string(docs().join(page)).unwrap();
    let blocks = page.split("\n```").skip(1).step_by(2);
    let marked = blocks.filter_map(|block| block.strip_prefix(mark)?.strip_prefix('\n'));
    marked.map(str::to_owned).collect()
}

/// Runs lines of a shell, in which `nullcone` is the program under test; ends at the first error.
fn shell(folder: &Path, script: &str) -> Output {
    let program = Path::new(env!("CARGO_BIN_EXE_nullcone")).parent().unwrap();
    let others = env::var_os("PATH").unwrap_or_default();
    let folders = iter::once(program.to_owned()).chain(env::split_paths(&others));
    let path = env::join_paths(folders).unwrap();
    let mut command = Command::new("sh");
    command.args(["-e", "-c", script]).current_dir(folder);
    command.env("PATH", path).output().unwrap()
}

/// What `nullcone demo` wrote, once for all pages.
fn demo() -> &'static Path {
    static DEMO: OnceLock<PathBuf> = OnceLock::new();
    DEMO.get_or_init(|| {
        let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("pages");
        let _ = std::fs::remove_dir_all(&folder);
        std::fs::create_dir_all(&folder).unwrap();
        assert_success(&nullcone(&folder, ["demo", "--figure"]));
        folder.join("out")
    })
}

/// Runs the commands of a page, and checks that they wrote these files.
fn page(name: &str, files: &[&str]) {
    let folder = tempdir().unwrap();
    let out = folder.path().join("out");
    std::fs::create_dir(&out).unwrap();
    for file in names(demo()) {
        std::fs::copy(demo().join(&file), out.join(&file)).unwrap();
    }
    let blocks = blocks(name, "sh");
    assert!(!blocks.is_empty());
    for block in blocks {
        let output = shell(folder.path(), &block);
        let error = text(&output.stderr);
        assert!(output.status.success(), "{name}:\n{block}\n{error}");
    }
    for file in files {
        let length = std::fs::metadata(folder.path().join(file)).map(|file| file.len());
        assert!(length.is_ok_and(|length| length > 0), "{name}: {file}");
    }
}

#[test]
fn animation() {
    page(
        "animation.md",
        &[
            "bones/sheet.png",
            "walking.glb",
            "animated/model.glb",
            "curve.svg",
        ],
    );
}

#[test]
fn meshes() {
    page(
        "meshes.md",
        &[
            "picture.png",
            "walk.y4m",
            "baked/normal.png",
            "textured.glb",
        ],
    );
}

#[test]
fn stereo() {
    page("stereo.md", &["disparity.png", "figure.ply", "snake.svg"]);
}

#[test]
fn people() {
    page(
        "people.md",
        &["errors.svg", "expression.csv", "walker/joints.csv"],
    );
}

#[test]
fn video() {
    page(
        "video.md",
        &["keys", "quality.html", "report.html", "aligned.y4m"],
    );
}

#[test]
fn batch() {
    page(
        "batch.md",
        &["whole.y4m", "frames.csv", "chart.svg", "quality.html"],
    );
}

#[test]
fn engine() {
    page("engine.md", &["scene.html", "scene.svg"]);
}

/// Every page with commands is run.
#[test]
fn no_page_is_left_out() {
    let pages = names(&docs());
    let pages: Vec<&str> = pages
        .iter()
        .filter_map(|name| name.strip_suffix(".md"))
        .filter(|name| !blocks(&format!("{name}.md"), "sh").is_empty())
        .collect();
    assert_eq!(
        pages,
        [
            "animation",
            "batch",
            "engine",
            "meshes",
            "people",
            "stereo",
            "video"
        ]
    );
}

/// Options that are not there, or have faulty values, are another error, with status 2.
#[test]
fn commands_on_files_of_the_reader() {
    let mut count = 0;
    for name in names(&docs()).iter().filter(|name| name.ends_with(".md")) {
        let blocks = blocks(name, "sh own-files");
        for line in blocks.iter().flat_map(|block| block.lines()) {
            // What another program writes into a pipe is not there either.
            let line = line.rsplit("| ").next().unwrap();
            assert!(line.starts_with("nullcone "), "{name}: {line}");
            count += 1;
            let folder = tempdir().unwrap();
            let output = shell(folder.path(), &format!("{line} </dev/null"));
            let error = text(&output.stderr);
            assert_eq!(output.status.code(), Some(1), "{name}: {line}\n{error}");
            assert!(names(folder.path()).is_empty(), "{name}: {line}");
            let missing = MISSING.iter().any(|words| error.contains(words));
            assert!(missing, "{name}: {line}\n{error}");
        }
    }
    assert!(count >= 10, "{count} commands");
}
