//! Joints in the format of DeepLabCut.

use ga_body::format::{DetectorOptions, FrameKey, JointViews, Model, deeplabcut};

use super::{pixel, views};

const ONE: &str = "scorer,S,S,S,S,S,S
bodyparts,nose,nose,nose,tail,tail,tail
coords,x,y,likelihood,x,y,likelihood
0,310.5,82,0.25,1,2,1
1,,,,3,4,1
3,311,83,1,5,6,0.01
";

#[test]
fn rows_are_frames_and_columns_are_joints() {
    let people = deeplabcut::decode(ONE.as_bytes(), None).unwrap();
    assert_eq!(people.joints, ["nose", "tail"]);
    let found = views(people, &DetectorOptions::default());
    let view = &found.views()[0];
    assert_eq!(found.frame_count(), 4);
    assert_eq!(pixel(view, 0, 0), Some(([310.5, 82.0], 4.0)));
    assert_eq!(pixel(view, 0, 1), Some(([1.0, 2.0], 2.0)));
    assert_eq!(pixel(view, 1, 0), None);
    assert_eq!(pixel(view, 1, 1), Some(([3.0, 4.0], 2.0)));
    // A row that is missing, and little confidence.
    assert_eq!(pixel(view, 2, 1), None);
    assert_eq!(pixel(view, 3, 0), Some(([311.0, 83.0], 2.0)));
    assert_eq!(pixel(view, 3, 1), None);
    // By what it holds, with the mark and the line ends of spreadsheets.
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("cam.csv");
    std::fs::write(&path, format!("\u{feff}{}", ONE.replace('\n', "\r\n"))).unwrap();
    let read = JointViews::read(&[path], &DetectorOptions::default()).unwrap();
    assert_eq!(read.views()[0].frames, view.frames);
    assert_eq!(read.views()[0].name, "cam");
}

#[test]
fn individuals_are_people_in_every_frame() {
    // The second one has a part that the first has not, and another order.
    let text = "scorer,S,S,S,S,S,S,S,S,S
individuals,anna,anna,anna,ben,ben,ben,ben,ben,ben
bodyparts,nose,nose,nose,tail,tail,tail,nose,nose,nose
coords,x,y,likelihood,x,y,likelihood,x,y,likelihood
0,,,,1,2,1,3,4,1
1,5,6,0.5,7,8,1,9,10,1
";
    let people = deeplabcut::decode(text.as_bytes(), None).unwrap();
    assert_eq!(people.joints, ["nose", "tail"]);
    let of = |person| {
        let options = DetectorOptions {
            person: Some(person),
            ..DetectorOptions::default()
        };
        views(people.clone(), &options).views()[0].clone()
    };
    let (anna, ben) = (of(0), of(1));
    assert_eq!(pixel(&anna, 0, 0), None);
    assert_eq!(pixel(&anna, 1, 0), Some(([5.0, 6.0], 2.0 / 0.5f64.sqrt())));
    assert_eq!(pixel(&anna, 1, 1), None);
    assert_eq!(pixel(&ben, 0, 0), Some(([3.0, 4.0], 2.0)));
    assert_eq!(pixel(&ben, 1, 1), Some(([7.0, 8.0], 2.0)));
}

#[test]
fn labelled_data_have_names_and_no_likelihood() {
    let text = "scorer,,,S,S
bodyparts,,,nose,nose
coords,,,x,y
labeled-data,film,img10.png,3,4
labeled-data,film,img9.png,1,2
";
    let people = deeplabcut::decode(text.as_bytes(), None).unwrap();
    assert_eq!(people.frames[0].key, FrameKey::Number(9));
    let found = views(people, &DetectorOptions::default());
    assert_eq!(pixel(&found.views()[0], 0, 0), Some(([1.0, 2.0], 2.0)));
    assert_eq!(pixel(&found.views()[0], 1, 0), Some(([3.0, 4.0], 2.0)));
}

#[test]
fn damaged_tables_name_line_and_joint() {
    let cases: [(&str, &str, &[&str]); 9] = [
        ("bodyparts", "parts", &["line 2", "\"parts\"", "bodyparts"]),
        ("coords", "0", &["line 3", "coords"]),
        (
            "x,y,likelihood\n",
            "x,z,likelihood\n",
            &["line 3", "column 6", "\"tail\"", "\"z\""],
        ),
        (
            "x,y,likelihood\n",
            "x,x,likelihood\n",
            &["line 3", "column 6", "\"tail\""],
        ),
        (
            "tail,tail,tail",
            "tail,tail,nose",
            &["line 3", "column 7", "\"nose\""],
        ),
        ("tail,tail,tail", "tail,top,top", &["\"tail\""]),
        ("82", "8z2", &["line 4", "nose y", "\"8z2\""]),
        ("\n1,", "\n0,", &["line 5", "\"0\""]),
        ("3,4,1", "3,4", &["line 5"]),
    ];
    for (from, to, parts) in cases {
        let text = ONE.replacen(from, to, 1);
        let error = deeplabcut::decode(text.as_bytes(), None)
            .unwrap_err()
            .to_string();
        for part in parts {
            assert!(error.contains(part), "{part:?} is not in {error:?}");
        }
    }
    let model = deeplabcut::decode(ONE.as_bytes(), Some(Model::Coco17)).unwrap_err();
    assert!(model.to_string().contains("2 joints"), "{model}");
    // No prefix of a file is read in silence as another, or ends the program.
    for end in 0..ONE.len() {
        let part = deeplabcut::decode(&ONE.as_bytes()[..end], None);
        assert!(part.is_err() || end > ONE.find("\n0,").unwrap(), "{end}");
    }
}
