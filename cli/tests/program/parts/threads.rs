//! `--threads` of every command.

use std::path::Path;

use tempfile::tempdir;

use super::{run, write_film};
use crate::common::{contents, nullcone, text};

/// Commands of every kind, whose files are the same on any number of threads.
const COMMANDS: [&str; 7] = [
    "render DATA/m.obj --size 40x30 --out picture.png",
    "stereo match DATA/left.pgm DATA/right.pgm --max-disparity 16 --out d.pfm",
    "quality compare DATA/a.y4m DATA/b.y4m --csv frames.csv --plot frames.svg",
    "video keyframes DATA/a.y4m --out keys --plot curves.svg",
    "video comfort DATA/a.y4m DATA/b.y4m --summary s.json --out comfort.html",
    "video align DATA/a.y4m DATA/b.y4m --out aligned.y4m",
    "mesh subdivide DATA/m.obj --levels 3 --out smooth.obj",
];

/// A grey picture of the left or the right view.
fn view(shift: usize) -> Vec<u8> {
    let mut bytes = b"P5 96 64 255\n".to_vec();
    for row in 0..64 {
        for column in 0..96 {
            let [x, y] = [(column + shift) / 3, row / 3];
            let hash = (x * 7919 + y * 104_729 + 17) * 2_654_435_761usize % 4_294_967_296;
            bytes.push((hash >> 12) as u8);
        }
    }
    bytes
}

fn data(folder: &Path) {
    std::fs::create_dir(folder.join("data")).unwrap();
    let write = |name: &str, bytes: &[u8]| {
        std::fs::write(folder.join("data").join(name), bytes).unwrap();
    };
    write("left.pgm", &view(0));
    write("right.pgm", &view(4));
    let cube = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n";
    write("m.obj", cube.as_bytes());
    write_film(&folder.join("data/a.y4m"), [96, 64], &[0; 5]);
    write_film(&folder.join("data/b.y4m"), [96, 64], &[2; 5]);
}

#[test]
fn results_do_not_depend_on_the_number_of_threads() {
    let folder = tempdir().unwrap();
    data(folder.path());
    let made = ["1", "3"].map(|threads| {
        let out = folder.path().join(threads);
        std::fs::create_dir(&out).unwrap();
        for command in COMMANDS {
            let line = command.replace("DATA", "../data");
            run(&out, &format!("{line} --threads {threads}"));
        }
        let keys = contents(&out.join("keys"));
        assert!(!keys.is_empty());
        std::fs::remove_dir_all(out.join("keys")).unwrap();
        (keys, contents(&out))
    });
    let [first, second] = &made;
    assert_eq!(first.1.len(), 9);
    for (first, second) in first.1.iter().zip(&second.1) {
        assert!(first == second, "{}", first.0);
    }
    assert!(first.0 == second.0);
}

#[test]
fn no_threads_and_too_many_are_refused() {
    for count in ["0", "-1", "100000", "two"] {
        let output = nullcone(Path::new("."), ["completions", "bash", "--threads", count]);
        assert_eq!(output.status.code(), Some(2), "{count}");
        assert!(text(&output.stderr).contains("--threads"), "{count}");
    }
}
