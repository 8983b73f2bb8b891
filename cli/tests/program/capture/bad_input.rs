//! Points and arguments that cannot be used.

use super::face::{
    CALIBRATED, NAMES, assert_near, capture, folder, json, moved, plain, pose, table,
};
use crate::common::{assert_failure, names, nullcone, text};

#[track_caller]
fn fails(points: &str, arguments: &[&str], parts: &[&str]) {
    let folder = folder(points);
    let mut all = vec!["capture", "points.csv", "--out", "new.csv"];
    all.extend(arguments);
    if !arguments.contains(&"--calibrated") {
        all.extend(CALIBRATED);
    }
    assert_failure(&nullcone(folder.path(), all), parts);
    assert_eq!(names(folder.path()), ["face.obj", "keys.csv", "points.csv"]);
}

#[test]
fn points_that_determine_nothing_are_refused() {
    let with = |frame: usize, name: &'static str, text: &'static str| {
        table(move |f, point, place| match (f, NAMES[point]) {
            (f, found) if f == frame && found == name => text.to_owned(),
            _ => plain(f, point, place),
        })
    };
    fails(
        &with(3, "lip", "nan,0,0"),
        &[],
        &["points.csv", "line 5", "frame f3", "x of point lip", "nan"],
    );
    fails(
        &with(1, "chin", "0,inf,0"),
        &[],
        &["line 3", "y of point chin", "inf"],
    );
    fails(
        &with(1, "chin", "0,word,0"),
        &[],
        &["y of point chin", "word"],
    );
    fails(
        &with(1, "chin", "0,,0"),
        &[],
        &["line 3", "y of point chin is empty"],
    );
    fails(
        &with(1, "chin", "0,0"),
        &[],
        &["line 3", "24 columns, but line 1 has 25"],
    );
    fails(
        &with(0, "lip", ",,"),
        &[],
        &["line 2, frame f0", "point lip is missing in the reference"],
    );
    let few = ["--calibrated", "brow,nose"];
    fails(&table(plain), &few, &["3 points are needed", "not 2"]);
    let twice = ["--calibrated", "brow,nose,left,nose"];
    fails(&table(plain), &twice, &["nose is named twice"]);
    let strange = ["--calibrated", "brow,nose,left,tail"];
    fails(
        &table(plain),
        &strange,
        &["--calibrated tail", "brow, nose, left"],
    );
    // Of five calibrated points, three are missing in all frames but the reference.
    let missing = table(|f, point, place| match (f, NAMES[point]) {
        (1.., "brow" | "nose" | "right") => ",,".to_owned(),
        _ => plain(f, point, place),
    });
    fails(
        &missing,
        &[],
        &[
            "points.csv",
            "no frame but the reference has a pose",
            "line 3, frame f1: 2 calibrated points are seen, and 3 are needed",
            "missing: brow, nose, right",
        ],
    );
    // On a line at rest, or in a frame that is to be shown; in a plane is enough.
    let line = |frame: usize| {
        table(move |f, point, place| match f >= frame && point < 4 {
            true => format!("0.0,{},0.1", 0.02 * point as f64 * (point + f) as f64),
            false => plain(f, point, place),
        })
    };
    let four = ["--calibrated", "brow,nose,left,right"];
    fails(
        &line(0),
        &four,
        &[
            "line 2, frame f0",
            "at rest are on one line",
            "in one plane are enough",
        ],
    );
    let shown = "--mesh face.obj --keys keys.csv --frame f4 --out f4.obj";
    let shown: Vec<_> = four.into_iter().chain(shown.split(' ')).collect();
    fails(
        &line(4),
        &shown,
        &["line 6, frame f4", "of the frame are on one line"],
    );
    let flat = table(|f, point, place| match point < 4 {
        true => {
            let (angle, by) = pose(f);
            let place = [
                [0.0, 0.0, 0.0],
                [0.1, 0.0, 0.0],
                [0.1, 0.1, 0.0],
                [0.0, 0.1, 0.0],
            ][point];
            plain(f, point, moved(place, angle, by))
        }
        false => plain(f, point, place),
    });
    let folder = folder(&flat);
    let lost = nullcone(
        folder.path(),
        [&["capture", "points.csv", "--json"], &four[..]].concat(),
    );
    let (warning, error) = text(&lost.stderr).split_once('\n').unwrap();
    assert!(!lost.status.success() && warning.contains("brow is 0,0,0"));
    assert!(error.contains("frame f0: point brow is missing"), "{error}");
    assert!(error.contains("--keep-zeros"), "{error}");
    let plane = ["capture", "points.csv", "--json", "--keep-zeros"];
    let plane = [&plane, &four[..]].concat();
    let report = json(&nullcone(folder.path(), plane));
    assert_near(&report["poses"][3]["translation_metres"], &pose(3).1, 1e-9);
    let one = table(|_, _, _| "0.1,0.1,0.1".to_owned());
    fails(&one, &[], &["in one place"]);
    let noise = table(|f, point, place| match (f, point < 5) {
        (1.., true) => {
            let [x, y, z] = [point * point, 7 % (point + 1), 9 + point * f];
            format!("0.{x:02},0.{y:02},0.{z:02}")
        }
        _ => plain(f, point, place),
    });
    fails(
        &noise,
        &["--threshold", "0.001"],
        &["line 3, frame f1", "agree with one pose"],
    );
}

#[test]
fn tables_and_arguments_that_are_wrong_are_refused() {
    fails("", &[], &["points.csv", "no frames"]);
    fails("frame,a_x,a_y,a_z\n", &[], &["no frames"]);
    fails("frame\n1\n", &[], &["points"]);
    fails("a_x,a_y\n1,2\n", &[], &["column 3", "a_z"]);
    fails("a_x,b_y,a_z\n1,2,3\n", &[], &["column 2", "b_y", "a_y"]);
    fails(
        "a_x,a_y,a_z,a_x,a_y,a_z\n1,2,3,4,5,6\n",
        &[],
        &["\"a\" is there twice"],
    );
    fails("1,2,3,4\n", &[], &["4 columns without names"]);
    fails(
        "time,a_x,a_y,a_z\n2,1,1,1\n1,1,1,1\n",
        &[],
        &["line 3", "time \"1\""],
    );
    fails(
        "frame,a_x,a_y,a_z\nk,1,1,1\nk,1,1,1\n",
        &[],
        &["line 3", "\"k\" is there twice"],
    );
    let good = table(plain);
    fails(
        &good,
        &["--reference", "f9"],
        &["--reference f9", "f0 to f4"],
    );
    fails(&good, &["--threshold", "0"], &["--threshold 0"]);
    fails(&good, &["--fps", "-1"], &["--fps -1"]);
    fails(&good, &["--out", "a.txt"], &["a.txt", ".csv, .glb"]);
    fails(&good, &["--out", "a.glb"], &["a.glb", "--mesh"]);
    fails(&good, &["--out", "new.csv"], &["new.csv", "another output"]);
    let mesh =
        |more: &[&'static str]| [&["--mesh", "face.obj", "--keys", "keys.csv"], more].concat();
    fails(&good, &mesh(&["--out", "a.obj"]), &["a.obj", "--frame"]);
    fails(
        &good,
        &mesh(&["--area", "tail:0.1"]),
        &["--area tail:0.1", "not a key"],
    );
    fails(&good, &mesh(&["--tolerance", "-1"]), &["--tolerance -1"]);
    fails(&good, &["--mesh", "none.obj"], &["none.obj"]);
    let keys = |text: &str, parts: &[&str]| {
        let folder = folder(&good);
        std::fs::write(folder.path().join("keys.csv"), text).unwrap();
        let output = capture(
            folder.path(),
            "--mesh face.obj --keys keys.csv --out new.glb",
        );
        assert_failure(&output, parts);
        assert_eq!(names(folder.path()), ["face.obj", "keys.csv", "points.csv"]);
    };
    keys("name,place\n", &["keys.csv", "point,vertex"]);
    keys("point,vertex\n", &["no keys"]);
    keys("point,vertex\ntail,3\n", &["line 2", "tail"]);
    keys(
        "point,vertex\nchin,3\nlip,99999\n",
        &["line 3", "99999", "0 to 829"],
    );
    keys(
        "point,vertex\nchin,3\nchin,4\n",
        &["line 3", "chin", "twice"],
    );
    keys("point,x,y,z\nchin,0,nan,0\n", &["line 2", "nan"]);
    keys(
        "point,vertex\nchin,3\nlip,4\n",
        &["keys.csv", "does not place the points"],
    );
    keys(
        "point,vertex\nchin,3\nlip,4\nnose,400\nbrow,4\n",
        &["face.obj", "lip and brow", "direction"],
    );
}
