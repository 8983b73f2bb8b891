//! People, view by view.

use std::collections::BTreeMap;
use std::path::Path;

use crate::common::{assert_failure, assert_success, contents};
use crate::people::{inputs, people};

fn files(folder: &Path) -> BTreeMap<String, Vec<u8>> {
    contents(&folder.join("out")).into_iter().collect()
}

#[test]
fn the_films_of_views_are_those_of_one_process() {
    let folder = inputs();
    let folder = folder.path();
    let films = ["wall.y4m", "wall.y4m"];
    assert_success(&people(folder, &films, &[]));
    let whole = files(folder);
    std::fs::remove_dir_all(folder.join("out")).unwrap();

    for view in ["left side", "front"] {
        assert_success(&people(folder, &films, &["--overlay-of", view]));
    }
    let overlays = files(folder);
    assert_eq!(overlays.len(), 2);
    assert_success(&people(folder, &films, &["--no-overlay"]));
    let parts = files(folder);
    assert!(whole.keys().eq(parts.keys()));
    for (name, bytes) in &whole {
        // They say by which command they were made, and which files it wrote.
        let is_report = name.starts_with("report.");
        assert!(is_report || *bytes == parts[name], "{name}");
    }
    let other = people(folder, &films, &["--overlay-of", "back/top"]);
    assert_failure(&other, &["--overlay-of back/top", "front, left side"]);
}
