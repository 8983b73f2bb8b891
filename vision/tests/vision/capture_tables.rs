//! Tables of points as programs write them, against numbers written by hand.

use ga_runtime::cga3::Point;
use ga_vision::capture::table::{PointTable, PointTableError, PointTableNote, Zeros};
use ga_vision::capture::{Capture, CapturedFrame, PoseOptions};
use nullcone_shared_data::shared;

fn decode(text: &str) -> Result<PointTable, PointTableError> {
    PointTable::decode(text.as_bytes(), Zeros::Lost)
}

#[track_caller]
fn read(text: &str) -> PointTable {
    decode(text).unwrap()
}

#[track_caller]
fn message(text: &str) -> String {
    decode(text).unwrap_err().to_string()
}

type Places = Vec<Vec<Option<[f64; 3]>>>;

fn places(table: &PointTable) -> Places {
    let places = |points: &[Option<Point<f64>>]| {
        let places = points.iter().map(|place| place.map(Point::coordinates));
        places.collect::<Vec<_>>()
    };
    table.frames.iter().map(|row| places(&row.points)).collect()
}

#[track_caller]
fn assert_near(found: &Places, expected: &[Vec<Option<[f64; 3]>>], tolerance: f64) {
    assert_eq!(found.len(), expected.len());
    for (found, expected) in found.iter().flatten().zip(expected.iter().flatten()) {
        match (found, expected) {
            (Some(a), Some(b)) => {
                assert!(
                    (0..3).all(|k| (a[k] - b[k]).abs() <= tolerance),
                    "{a:?} {b:?}"
                );
            }
            (None, None) => {}
            _ => panic!("{found:?} {expected:?}"),
        }
    }
}

/// Three frames of two markers in metres, of which the second is not seen in the second frame.
fn truth() -> Places {
    vec![
        vec![Some([0.001, 0.06, 0.02]), Some([0.0, -0.03, 0.05])],
        vec![Some([0.002, 0.061, 0.02]), None],
        vec![Some([0.003, 0.062, -0.02]), Some([0.0, -0.035, 0.051])],
    ]
}

const MOTIVE: &str = "\
Format Version,1.23,Take Name,smile,Export Frame Rate,60.0,Length Units,Millimeters,\
Coordinate Space,Global\r\n\
\r\n\
,Type,Rigid Body,Rigid Body,Rigid Body,Marker,Marker,Marker,Marker,Marker,Marker,Marker,Marker,\
Marker\r\n\
,Name,Head,Head,Head,face:brow,face:brow,face:brow,Unlabeled 7,Unlabeled 7,Unlabeled 7,face:nose,\
face:nose,face:nose\r\n\
,ID,1,1,1,\"2A\",\"2A\",\"2A\",\"2B\",\"2B\",\"2B\",\"2C\",\"2C\",\"2C\"\r\n\
,,Rotation,Rotation,Position,Position,Position,Position,Position,Position,Position,Position,\
Position,Position\r\n\
Frame,Time (Seconds),X,W,X,X,Y,Z,X,Y,Z,X,Y,Z\r\n\
0,0.000000,0,1,9,1,60,20,,,,0,-30,50\r\n\
1,0.016667,0,1,9,2,61,20,5,5,5,,,\r\n\
2,0.033333,0,1,9,3,62,-20,,,,0,-35,51\r\n";

const VICON: &str = "\
Devices\n\
1000\n\
,,force\n\
Frame,Sub Frame,Fx\n\
,,N\n\
1,0,4\n\
\n\
Trajectories\n\
50\n\
,,face:brow,,,face:nose,,,*12,,\n\
Frame,Sub Frame,X,Y,Z,X,Y,Z,X,Y,Z\n\
,,mm,mm,mm,mm,mm,mm,mm,mm,mm\n\
101,0,1,60,20,0,-30,50,,,\n\
102,0,2,61,20,,,,7,7,7\n\
103,0,3,62,-20,0,-35,51,,,\n";

const TRC: &str = "\
PathFileType\t4\t(X/Y/Z)\tface.trc\n\
DataRate\tCameraRate\tNumFrames\tNumMarkers\tUnits\tOrigDataRate\tOrigDataStartFrame\t\
OrigNumFrames\n\
100\t100\t3\t2\tmm\t100\t1\t3\n\
Frame#\tTime\tbrow\t\t\tnose\t\t\t\n\
\t\tX1\tY1\tZ1\tX2\tY2\tZ2\t\n\
\n\
1\t0.00\t1\t60\t20\t0\t-30\t50\t\n\
2\t0.01\t2\t61\t20\tnan\tnan\tnan\t\n\
3\t0.02\t3\t62\t-20\t0\t-35\t51\t\n";

#[test]
fn motive_is_read() {
    let table = read(MOTIVE);
    assert_eq!(table.names, ["face:brow", "face:nose"]);
    assert_near(&places(&table), &truth(), 1e-15);
    let times: Vec<_> = table.frames.iter().map(|row| row.time.unwrap()).collect();
    assert_eq!(times, [0.0, 0.016667, 0.033333]);
    let frame = &table.frames[2];
    assert_eq!((frame.label.as_str(), frame.line), ("2", 10));
    let passed = vec!["Rigid Body Head".to_owned(), "Unlabeled 7".to_owned()];
    assert_eq!(table.notes, [PointTableNote::ColumnsPassedOver(passed)]);
    // Names are unique after their prefixes, and numbers are those of the markers.
    assert_eq!(table.point("nose").unwrap(), 1);
    assert_eq!(table.point("face:nose").unwrap(), 1);
    assert_eq!(table.point("1").unwrap(), 1);

    let metres = read(&MOTIVE.replace("Millimeters", "Meters"));
    assert_eq!(
        metres.frames[0].points[0],
        Some(Point::new(1.0, 60.0, 20.0))
    );
    let without = read(&MOTIVE.replace("Length Units", "Something"));
    let kinds: Vec<_> = without.notes.iter().map(PointTableNote::kind).collect();
    assert_eq!(
        kinds,
        ["columns_passed_over", "unclear_unit", "unclear_unit"]
    );
    // A spreadsheet of a country with decimal commas has saved it again.
    let saved = MOTIVE.replace(',', ";").replace('.', ",");
    assert_near(&places(&read(&saved)), &truth(), 1e-15);
}

#[test]
fn vicon_is_read() {
    for text in [VICON.to_owned(), VICON.replace('\n', "\r\n")] {
        let table = read(&text);
        assert_eq!(table.names, ["face:brow", "face:nose"]);
        assert_near(&places(&table), &truth(), 1e-15);
        let times: Vec<_> = table.frames.iter().map(|row| row.time.unwrap()).collect();
        assert_eq!(times, [2.0, 2.02, 2.04]);
        let frame = &table.frames[1];
        assert_eq!((frame.label.as_str(), frame.line), ("102", 14));
        let passed = vec!["*12".to_owned()];
        assert_eq!(table.notes, [PointTableNote::ColumnsPassedOver(passed)]);
    }
    let end = format!("{VICON}\nModel Outputs\n50\n,,angle\n");
    assert_near(&places(&read(&end)), &truth(), 1e-15);
}

#[test]
fn trc_is_read() {
    let table = read(TRC);
    assert_eq!(table.names, ["brow", "nose"]);
    assert_near(&places(&table), &truth(), 1e-15);
    let times: Vec<_> = table.frames.iter().map(|row| row.time.unwrap()).collect();
    assert_eq!(times, [0.0, 0.01, 0.02]);
    assert_eq!((table.frames[0].line, table.notes.len()), (7, 0));
    let short = read(&TRC.replace("100\t100\t3", "100\t100\t9"));
    let (stated, found) = ("9".to_owned(), 3);
    assert_eq!(short.notes, [PointTableNote::FrameCount { stated, found }]);
}

#[test]
fn plain_tables_have_the_habits_of_spreadsheets() {
    let plain = "frame,time,brow_x,brow_y,brow_z,nose_x,nose_y,nose_z\n\
                 0,0.5,0.001,0.06,0.02,0.0,-0.03,0.05\n\
                 1,1.5,0.002,0.061,0.02,,,\n\
                 2,2.5,0.003,0.062,-0.02,0.0,-0.035,0.051\n";
    let semicolons = plain.replace(',', ";");
    let missing = |word: &str| plain.replace(",,,", &format!(",{word},{word},{word}"));
    for text in [
        plain.to_owned(),
        format!("\u{feff}{plain}"),
        plain.replace('\n', "\r\n"),
        plain.replace('\n', ",\n"),
        plain.replace("_z\n", "_z,,\n"),
        plain.replacen(",-0.03,0.05\n", ",-0.03,0.05,\n", 1),
        plain.replace(',', "\t"),
        semicolons.replace('.', ","),
        semicolons,
        plain.replace("frame,time", "Frame,Time (Seconds)"),
        plain.replace("frame,time", "Frame#,Time"),
        plain.replace("frame,time", "Frame Number,time [s]"),
        missing("NaN"),
        missing("nan"),
        missing("null"),
        missing("#N/A"),
        missing("NA"),
    ] {
        let table = read(&text);
        assert_eq!(table.names, ["brow", "nose"], "{text}");
        assert_near(&places(&table), &truth(), 0.0);
        let times: Vec<_> = table.frames.iter().map(|row| row.time.unwrap()).collect();
        assert_eq!(times, [0.5, 1.5, 2.5], "{text}");
        assert_eq!(table.notes, [], "{text}");
    }
}

#[test]
fn a_lost_marker_at_the_origin_is_not_seen() {
    let text = "a_x,a_y,a_z,b_x,b_y,b_z\n\
                1,2,0,0,0,1\n\
                0,0,0,0,0,2\n\
                -0.0,0.000,0,0,1,0\n\
                1,0,0,0,0,3\n";
    let table = read(text);
    let seen: Vec<_> = table
        .frames
        .iter()
        .map(|row| row.points[0].is_some())
        .collect();
    assert_eq!(seen, [true, false, false, true]);
    assert!(table.frames.iter().all(|row| row.points[1].is_some()));
    let point = "a".to_owned();
    let frames = vec!["1".to_owned(), "2".to_owned()];
    assert_eq!(
        table.notes,
        [PointTableNote::LostAtOrigin { point, frames }]
    );
    let said = table.notes[0].to_string();
    assert!(
        said.contains("point a is 0,0,0 in 2 of the frames (1, 2)"),
        "{said}"
    );
    let kept = PointTable::decode(text.as_bytes(), Zeros::Kept).unwrap();
    assert_eq!(kept.frames[1].points[0], Some(Point::new(0.0, 0.0, 0.0)));
    assert_eq!(kept.notes, []);
    let error = table.rest(1).unwrap_err().to_string();
    assert!(
        error.contains("point a is missing") && error.contains("0,0,0"),
        "{error}"
    );
}

#[test]
fn points_that_are_always_at_the_origin_are_decided_by_their_number() {
    // Coordinates relative to the nose.
    let one = read("nose_x,nose_y,nose_z,b_x,b_y,b_z\n0,0,0,1,2,3\n,,,1,2,4\n0,0,0,1,2,3\n");
    assert_eq!(one.frames[0].points[0], Some(Point::new(0.0, 0.0, 0.0)));
    assert_eq!(one.notes, [PointTableNote::AlwaysAtOrigin("nose".into())]);
    // Two points in one place are none.
    let text = "a_x,a_y,a_z,b_x,b_y,b_z,c_x,c_y,c_z\n0,0,0,1,2,3,0,0,0\n0,0,0,1,2,3,0,0,0\n";
    let two = read(text);
    let names = vec!["a".to_owned(), "c".to_owned()];
    assert_eq!(two.names, ["b"]);
    assert_eq!(two.numbers, [1]);
    assert_eq!(two.point("1").unwrap(), 0);
    assert!(two.point("0").is_err());
    assert_eq!(
        two.notes,
        [
            PointTableNote::NeverFound(names.clone()),
            PointTableNote::NeverSeen(names),
        ]
    );
    assert_eq!(
        message("a_x,a_y,a_z\n,,\n,,\n"),
        "no point is seen in any frame"
    );
}

#[test]
fn points_too_far_apart_for_metres_are_doubted() {
    let table = |scale: f64| {
        let row = [0.0, 0.06, 0.0, 0.07, 0.0, 0.04].map(|x| (scale * x).to_string());
        read(&format!("a_x,a_y,a_z,b_x,b_y,b_z\n{}\n", row.join(",")))
    };
    assert_eq!(table(1.0).notes, []);
    // The diagonal of a box of 70, 60 and 40 is √10100.
    let large = table(1000.0).notes;
    let [PointTableNote::PerhapsMillimetres { frame, extent }] = &large[..] else {
        panic!("{large:?}");
    };
    assert!(frame == "0" && (extent - 10100.0_f64.sqrt()).abs() < 1e-9);
}

#[test]
fn what_is_wrong_is_said_with_its_place() {
    for (text, parts) in [
        (
            MOTIVE.replace("Millimeters", "Ells"),
            &["line 1", "\"Ells\" is not a unit of length"][..],
        ),
        (
            MOTIVE.replace("Marker", "Bone"),
            &[
                "line 7",
                "no positions of markers",
                "Rigid Body Head, Bone face:brow",
            ],
        ),
        (
            MOTIVE.replace("face:nose", "face:brow"),
            &["line 4", "\"face:brow\" is there twice"],
        ),
        (
            MOTIVE.replace("61,20,", "x,20,"),
            &["line 9, frame 1", "y of point face:brow", "\"x\""],
        ),
        (
            MOTIVE.replace("0,-35,51", "0,-35"),
            &["line 10", "13 columns, but line 7 has 14"],
        ),
        (
            MOTIVE.replace("0,-35,51", "0,-35,51,4"),
            &["line 10", "15 columns, but line 7 has 14"],
        ),
        (
            MOTIVE.replace("Frame,", "Row,"),
            &["Motive CSV", "no line of axes"],
        ),
        (
            VICON.replace("\n50\n", "\nfast\n"),
            &["line 9", "the rate \"fast\""],
        ),
        (
            VICON.replace("mm,mm\n1", "mm,in\n1").replace("*12", "chin"),
            &["line 12", "\"in\" is not a unit"],
        ),
        (VICON.replace("102,", "99,"), &["line 14", "time \"99\""]),
        (
            VICON.replace("X,Y,Z,X,Y,Z,X", "X,Y,X,Y,Z,Z,X"),
            &["line 11, column 5", "the z of face:brow"],
        ),
        (
            TRC.replace("\tmm\t", "\tfurlong\t"),
            &["line 3", "\"furlong\" is not a unit"],
        ),
        (
            TRC.replace("\tnose\t", "\t\t"),
            &["line 4, column 6", "the name of a point"],
        ),
        (TRC.replace("Frame#", "Row"), &["TRC", "no line of names"]),
        (
            TRC.replace("nan\tnan\tnan", "nan\t1\tnan"),
            &["line 8, frame 2", "x of point nose", "nan"],
        ),
        (
            "\u{2}P".to_owned() + &"\0".repeat(600),
            &["C3D", "TRC or CSV"],
        ),
        (
            "l:a_x,l:a_y,l:a_z\n1,2,1e999\n".to_owned(),
            &["line 2, frame 0", "z of point l:a", "1e999"],
        ),
    ] {
        let found = message(&text);
        for part in parts {
            assert!(found.contains(part), "{found}\n{part}");
        }
    }
    let table = read("l:a_x,l:a_y,l:a_z,r:a_x,r:a_y,r:a_z\n1,2,3,4,5,6\n");
    let several = table.point("a").unwrap_err().to_string();
    assert!(several.contains("l:a, r:a"), "{several}");
}

/// Whatever is left of a file is read as what it says, or refused.
#[test]
fn files_that_are_cut_off_are_read_or_refused() {
    let plain = "frame;time;a_x;a_y;a_z\n0;0,5;1,5;2;3\n1;0,75;\"4\";5;6\n2;1;;;\n";
    for text in [MOTIVE, VICON, TRC, plain] {
        let whole = places(&PointTable::decode(text.as_bytes(), Zeros::Kept).unwrap());
        let mut read = 0;
        for end in 0..text.len() {
            let Ok(table) = PointTable::decode(&text.as_bytes()[..end], Zeros::Kept) else {
                continue;
            };
            read += 1;
            let found = places(&table);
            assert!(found.len() <= whole.len());
            // Only the last number may have lost digits.
            for (found, whole) in found.iter().zip(&whole).take(found.len() - 1) {
                for (place, name) in found.iter().zip(&table.names) {
                    let at = table.numbers[table.point(name).unwrap()];
                    assert_eq!(*place, whole[at], "{end}");
                }
            }
        }
        assert!(read > 0);
        // A byte that is not text, anywhere.
        for place in 0..text.len() {
            let mut bytes = text.as_bytes().to_vec();
            bytes[place] = 0xff;
            let _ = PointTable::decode(&bytes, Zeros::Lost);
            bytes[place] = b'\n';
            let _ = PointTable::decode(&bytes, Zeros::Lost);
        }
    }
}

/// The frames of a file of the case, in which brow, nose, left and right are calibrated.
fn captured(name: &str) -> Option<(PointTable, Vec<Option<CapturedFrame>>)> {
    let path = shared(&format!("cases/people/capture-tables/{name}"))?;
    let bytes = std::fs::read(path).unwrap();
    let table = PointTable::decode(&bytes, Zeros::Lost).unwrap();
    let calibrated = ["brow", "nose", "left", "right"].map(|name| table.point(name).unwrap());
    let rest = table.rest(0).unwrap();
    let capture = Capture::new(rest, calibrated.to_vec(), PoseOptions::default()).unwrap();
    let rows: Vec<_> = table.frames.iter().map(|row| &row.points[..]).collect();
    let frames = capture.frames(&rows).unwrap().into_iter().map(Result::ok);
    Some((table, frames.collect()))
}

/// The files are one take, with what is missing or written in another way.
#[test]
fn a_take_in_several_forms_has_one_expression() {
    let Some((clean, truth)) = captured("ts.csv") else {
        return;
    };
    assert_eq!((clean.names.len(), truth.len()), (8, 15));
    assert!(truth.iter().all(Option::is_some));
    for (name, frames, unsolved, lost) in [
        ("g1.csv", 15, None, Some((5, 0))),
        ("g3.csv", 15, Some(7), None),
        ("motive.csv", 9, None, None),
        ("semi.csv", 15, None, None),
        ("zero.csv", 15, None, Some((5, 0))),
    ] {
        let (table, found) = captured(name).unwrap();
        assert_eq!((table.names.len(), found.len()), (8, frames), "{name}");
        for (frame, (found, truth)) in found.iter().zip(&truth).enumerate() {
            assert_eq!(found.is_none(), unsolved == Some(frame), "{name} {frame}");
            let (Some(found), Some(truth)) = (found, truth) else {
                continue;
            };
            for (point, (found, truth)) in
                found.expression.iter().zip(&truth.expression).enumerate()
            {
                let is_lost = lost == Some((frame, point));
                assert_eq!(found.is_none(), is_lost, "{name} {frame} {point}");
                if let (Some(found), Some(truth)) = (found, truth) {
                    // Numbers are rounded to 1 µm, which three points pass on.
                    assert!(found.distance(*truth) < 5e-6, "{name} {frame} {point}");
                    assert!(
                        point >= 4 || found.length() < 5e-6,
                        "{name} {frame} {point}"
                    );
                }
            }
        }
        let notes = usize::from(name == "zero.csv");
        assert_eq!(table.notes.len(), notes, "{name}: {:?}", table.notes);
    }
}
