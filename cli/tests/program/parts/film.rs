//! Films in parts.

use std::sync::OnceLock;

use proptest::prelude::*;
use tempfile::TempDir;

use super::{divisions, few_cases, run};
use crate::render_animation;

const FRAMES: usize = 9;

/// A folder with a model that moves and one that does not.
fn folder() -> &'static TempDir {
    static FOLDER: OnceLock<TempDir> = OnceLock::new();
    FOLDER.get_or_init(|| {
        let folder = render_animation::folder();
        let faces = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n";
        std::fs::write(folder.path().join("still.obj"), faces).unwrap();
        folder
    })
}

/// Draws the film in one process and in parts, and compares the bytes.
fn compare(name: &str, command: &str, parts: &[[usize; 2]]) {
    let folder = folder().path();
    let whole = folder.join(format!("{name}.y4m"));
    if !whole.exists() {
        let film = command.replace("FILM", &format!("{name}.y4m"));
        run(folder, &film);
    }
    let names: Vec<String> = (0..parts.len())
        .map(|part| format!("{name}-{part}.y4m"))
        .collect();
    for ([first, end], part) in parts.iter().zip(&names) {
        let film = command.replace("FILM", part);
        // The part at the end may be asked for more than there is.
        let end = if *end == FRAMES {
            "".to_owned()
        } else {
            end.to_string()
        };
        run(folder, &format!("{film} --frames {first}..{end}"));
    }
    run(
        folder,
        &format!("merge {} --out {name}-merged.y4m", names.join(" ")),
    );
    let merged = std::fs::read(folder.join(format!("{name}-merged.y4m"))).unwrap();
    assert!(std::fs::read(whole).unwrap() == merged, "{parts:?}");
}

proptest! {
    #![proptest_config(few_cases())]

    #[test]
    fn an_animation_in_parts_is_the_animation(parts in divisions(FRAMES)) {
        let command = "render square.glb --animation go --rate 4 --size 40x30 --samples 2 \
                       --ground --film FILM";
        compare("film", command, &parts);
    }

    #[test]
    fn a_turntable_in_parts_is_the_turntable(parts in divisions(FRAMES)) {
        let command = "render still.obj --turntable 9 --size 40x30 --samples 1 --out FILM";
        compare("turntable", command, &parts);
    }
}
