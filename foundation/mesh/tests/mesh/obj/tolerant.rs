//! Files that other programs read although they deviate from the format: the same mesh as theirs,
//! with a warning for each kind, and an error in a strict reading.

use std::io;

use ga_files::Reading;
use ga_mesh::obj::{self, Warning};
use ga_mesh::{FormatError, Mesh};
use proptest::collection::vec;
use proptest::prelude::*;

use super::faults::strict;
use super::properties::meshes;

fn tolerant(text: &[u8]) -> Result<(Mesh, Vec<Warning>), FormatError> {
    let nothing = |_: &str| Err(io::ErrorKind::NotFound.into());
    obj::decode_with_libraries(text, Reading::Tolerant, nothing)
}

const SQUARE: &str = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nvt 0 0\nvt 1 0\nvt 1 1\nvn 0 0 1\n";

/// The numbers of vertices and faces are those that tinyobjloader 2.0 (without triangulation) and,
/// where that fails, trimesh 5.2 give.
#[test]
fn deviations_give_the_mesh_that_other_readers_give() {
    let square = |lines: &str| format!("{SQUARE}{lines}");
    for (name, text, vertices, faces, warnings) in [
        (
            "an empty index",
            square("f 1/1/ 2/2/ 3/3/\nf 1// 3// 4//\n"),
            4,
            2,
            &[("corner_form", 9, 2)][..],
        ),
        (
            "an empty index alone",
            square("f 1/ 2/ 3/\n"),
            4,
            1,
            &[("corner_form", 9, 1)],
        ),
        (
            "four indices",
            square("f 1/1/1/1 2/2/1/2 3/3/1/3\n"),
            4,
            1,
            &[("corner_form", 9, 1)],
        ),
        (
            "faces that are too short",
            square("f 1 2\nf 1 2 3\nf 3\n"),
            4,
            1,
            &[("short_face", 9, 2)],
        ),
        (
            "a polyline that is too short",
            square("l 1\nl 1 2\nf 1 2 3\n"),
            4,
            1,
            &[("short_line", 9, 1)],
        ),
        (
            "unknown words",
            square("f 1 2 3\nt crease 2/1/0 0 1 3.0\nvw 1 0.5\nfoo\nt a\nf 1 3 4\n"),
            4,
            2,
            &[
                ("unknown_statement", 10, 2),
                ("unknown_statement", 11, 1),
                ("unknown_statement", 12, 1),
            ],
        ),
        (
            "free-form curves",
            square("f 1 2 3\nvp 0 0\ncstype bezier\ncurv 0 1 1 2 3 4\nend\n"),
            4,
            1,
            &[
                ("unknown_statement", 10, 1),
                ("unknown_statement", 11, 1),
                ("unknown_statement", 12, 1),
                ("unknown_statement", 13, 1),
            ],
        ),
        (
            "no normals",
            "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1//1 2//1 3//1\nf 1//1 3//1 2//1\n".to_owned(),
            3,
            2,
            &[("no_normals", 4, 2)],
        ),
        (
            "no normals to count backwards",
            "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1//-1 2//-1 3//-1\n".to_owned(),
            3,
            1,
            &[("no_normals", 4, 1)],
        ),
        (
            "no texture coordinates",
            "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\nf 1/1 2/2 3/3\nf 1/1 2/2 3/3\n".to_owned(),
            3,
            3,
            &[("no_texture_coordinates", 5, 2)],
        ),
        (
            "points alone",
            "v 0 0 0\nv 1 0 0\nv 0 1 0\n".to_owned(),
            3,
            0,
            &[("points_alone", 3, 1)],
        ),
        (
            "carriage returns",
            square("f 1 2 3\nf 1 3 4\n").replace('\n', "\r"),
            4,
            2,
            &[("line_ends", 1, 10)],
        ),
        (
            "five numbers of a vertex",
            "v 0 0 0 1 2\nv 1 0 0 1 2\nv 0 1 0 1 2\nf 1 2 3\n".to_owned(),
            3,
            1,
            &[("number_count", 1, 3)],
        ),
        (
            "eight numbers of a vertex",
            "v 0 0 0 1 0 0 1 9\nv 1 0 0 0 1 0 1 9\nv 0 1 0 0 0 1 1 9\nf 1 2 3\n".to_owned(),
            3,
            1,
            &[("number_count", 1, 3)],
        ),
        (
            "four numbers of vt and vn",
            "v 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0 0 0\nvn 0 0 1 0\nf 1/1/1 2/1/1 3/1/1\n".to_owned(),
            3,
            1,
            &[("number_count", 4, 1), ("number_count", 5, 1)],
        ),
        (
            "more indices in lines and points",
            square("l 1/1/1 2/1/1\np 1/1\nf 1 2 3\n"),
            4,
            1,
            &[("line_vertex_form", 9, 1), ("point_form", 10, 1)],
        ),
    ] {
        let (mesh, found) = tolerant(text.as_bytes()).unwrap();
        assert_eq!(
            (mesh.vertex_count(), mesh.faces().len()),
            (vertices, faces),
            "{name}"
        );
        let found: Vec<(&str, usize, usize)> = found
            .iter()
            .map(|warning| match warning {
                Warning::Deviation(deviation) => (warning.kind(), deviation.line, deviation.count),
                other => panic!("{name}: {other}"),
            })
            .collect();
        assert_eq!(found, warnings, "{name}");
        let refused = strict(text.as_bytes()).unwrap_err().to_string();
        let line = warnings[0].1;
        assert!(
            refused.starts_with(&format!("line {line}: ")),
            "{name}: {refused}"
        );
    }
}

/// As tinyobjloader, trimesh and assimp read these, and they are no deviations.
#[test]
fn forms_that_the_format_has_give_no_warning() {
    for (text, vertices, faces) in [
        (format!("{SQUARE}f 1 2 3 3\nf 1 3 4\n"), 4, 2),
        (format!("{SQUARE}f 1 2 \\\n 3 4\n"), 4, 1),
        (
            format!("{SQUARE}f -4 -3 -2\nf -4//-1 -2//-1 -1//-1\n"),
            4,
            2,
        ),
        (
            "v 0 0 0 1\nv 1 0 0 1\nv 0 1 0 1\nf 1 2 3\n".to_owned(),
            3,
            1,
        ),
        (
            "\tv\t0 0 0\r\r\n\n  v 1 0 0  \nv 0 1 0\n\n f\t1 2 3 \n".to_owned(),
            3,
            1,
        ),
    ] {
        let (mesh, warnings) = tolerant(text.as_bytes()).unwrap();
        assert_eq!((mesh.vertex_count(), mesh.faces().len()), (vertices, faces));
        assert_eq!(warnings, []);
        assert_eq!(strict(text.as_bytes()).unwrap(), mesh);
    }
}

#[test]
fn warnings_say_what_is_done_and_how_often() {
    let text = format!("{SQUARE}f 1/1/ 2/2/ 3/3/\nt a\nt b\nf 1 2\nf 1 2 3 4\n");
    let (mesh, warnings) = tolerant(text.as_bytes()).unwrap();
    let sentences: Vec<String> = warnings.iter().map(ToString::to_string).collect();
    assert_eq!(
        sentences,
        [
            "line 9: \"1/1/\" is not a corner of a face (v, v/vt, v//vn or v/vt/vn); what does not \
             fit this form is ignored",
            "line 10: a line of a polygon mesh cannot begin with \"t\"; it is left out (2 such \
             lines)",
            "line 12: a face has at least 3 corners, but this one has 2; it is left out",
        ]
    );
    let texture = mesh.texture_coordinates().unwrap();
    let expected = [Some(0), Some(1), Some(2), None, None, None, None];
    assert_eq!(texture.corners, expected);
    let points = tolerant(b"v 0 0 0\nv 1 0 0\n").unwrap().0;
    assert_eq!(points.points(), [0, 1]);
}

#[test]
fn what_has_no_meaning_stays_an_error() {
    for (lines, message) in [
        ("f 1 2 9", "line 9: \"9\" refers to v 9, but there are 4"),
        (
            "f 1 2 3\nf 1 9",
            "line 10: \"9\" refers to v 9, but there are 4",
        ),
        (
            "f 1 2 3\nl 9",
            "line 10: \"9\" refers to v 9, but there are 4",
        ),
        (
            "f 1//2 2//1 3//1",
            "line 9: \"2\" refers to vn 2, but there are 1",
        ),
        (
            "f 1/9 2/1 3/1",
            "line 9: \"9\" refers to vt 9, but there are 3",
        ),
        (
            "f 1/1/0 2/1/1 3/1/1",
            "line 9: \"1/1/0\" refers to vn 0, but there are 1",
        ),
        (
            "f 1 2 /3",
            "line 9: \"/3\" is not a corner of a face (v, v/vt, v//vn or v/vt/vn)",
        ),
        (
            "f 1 2 3/x",
            "line 9: \"3/x\" is not a corner of a face (v, v/vt, v//vn or v/vt/vn)",
        ),
        (
            "v 1 2",
            "line 9: a v line has 3, 4, 6 or 7 numbers, but this one has 2",
        ),
        ("v 1 2 nan", "line 9: \"nan\" is not a finite number"),
        ("v 1 2 x", "line 9: \"x\" is not a number"),
        ("v 1 2 3 4 5 x", "line 9: \"x\" is not a number"),
        // A cloud of points would be wrong where faces or surfaces are left out.
        (
            "f 1 2",
            "line 9: the file ends without a face, a line or a point",
        ),
        (
            "F 1 2 3",
            "line 9: the file ends without a face, a line or a point",
        ),
        (
            "surf 0 1 0 1 1 2 3 4",
            "line 9: the file ends without a face, a line or a point",
        ),
    ] {
        let error = tolerant(format!("{SQUARE}{lines}\n").as_bytes()).unwrap_err();
        assert_eq!(error.to_string(), message);
    }
    // The normal comes after the index into the empty list.
    let text = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1//-1 2//-1 3//-1\nvn 0 0 1\n";
    let error = tolerant(text.as_bytes()).unwrap_err().to_string();
    assert_eq!(error, "line 4: \"1//-1\" refers to vn -1, but there are 0");
}

#[test]
fn names_in_other_encodings_are_read_and_said() {
    let file = |name: &[u8]| [SQUARE.as_bytes(), b"g ", name, b"\nf 1 2 3\n"].concat();
    for (name, expected, encoding) in [
        (&b"K\xf6rper"[..], "Körper", "Latin-1"),
        (b"R\xfccken", "Rücken", "Latin-1"),
        (b"\x8f\xe3\x94\xbc\x90g", "上半身", "Shift-JIS"),
        // The second byte is that of a backslash, which continues no line.
        (b"\x95\x5c", "表", "Shift-JIS"),
    ] {
        let (mesh, warnings) = tolerant(&file(name)).unwrap();
        assert_eq!(mesh.groups()[0].name, expected);
        let [warning] = &warnings[..] else {
            panic!("{warnings:?}")
        };
        let message = format!("line 9: the file is not UTF-8 text; it is read as {encoding}");
        assert_eq!((warning.kind(), warning.to_string()), ("encoding", message));
        assert!(strict(&file(name)).is_err());
    }
    // Comments may have any encoding, and names are UTF-8 nevertheless.
    let text = [&b"# caf\xe9\n"[..], &file("Körper".as_bytes())].concat();
    let (mesh, warnings) = tolerant(&text).unwrap();
    assert_eq!(
        (mesh.groups()[0].name.as_str(), warnings),
        ("Körper", vec![])
    );
    let text = [SQUARE.as_bytes(), b"f 1 2 3 # \xfc\n# \xe9\n"].concat();
    assert_eq!(tolerant(&text).unwrap().1, []);
}

/// A line that is left out, and the word or the kind that it is told with.
const LEFT_OUT: [(&str, &str); 10] = [
    ("t crease 2/1/0 0 1 3.0", "t"),
    ("vw 1 0.5", "vw"),
    ("vp 0.5 0.5", "vp"),
    ("curv 0 1 1 2 3", "curv"),
    ("\tparm u 0 1", "parm"),
    ("// a comment of another language", "//"),
    ("f 1 2", "face"),
    ("f\t1", "face"),
    ("f", "face"),
    ("l 1", "line"),
];

proptest! {
    /// Lines that are left out, empty indices and other line ends change nothing in the mesh.
    #[test]
    fn deviations_do_not_change_the_mesh(
        mesh in meshes(),
        inserted in vec((any::<prop::sample::Index>(), 0..LEFT_OUT.len()), 0..8),
        slashes in any::<bool>(),
        ends in prop_oneof![Just("\n"), Just("\r\n"), Just("\r")],
    ) {
        let text = obj::encode(&mesh);
        let mut lines: Vec<(String, Option<usize>)> =
            text.lines().map(|line| (line.to_owned(), None)).collect();
        let mut has_slashes = false;
        if slashes {
            for (line, _) in lines.iter_mut().filter(|(line, _)| line.starts_with("f ")) {
                has_slashes = true;
                *line = line.replacen(' ', "\t", 1).replace(' ', "/ ") + "/";
            }
        }
        for (place, kind) in inserted {
            let place = place.index(lines.len() + 1);
            lines.insert(place, (LEFT_OUT[kind].0.to_owned(), Some(kind)));
        }
        let changed: String = lines.iter().map(|(line, _)| format!("{line}{ends}")).collect();
        let (read, warnings) = tolerant(changed.as_bytes()).unwrap();
        prop_assert_eq!(read, obj::decode(text.as_bytes()).unwrap());

        let of_kind = |name: &str| {
            let mut places = lines.iter().enumerate().filter_map(|(index, (_, kind))| {
                (LEFT_OUT[(*kind)?].1 == name).then_some(index + 1)
            });
            let first = places.next()?;
            Some((first, 1 + places.count()))
        };
        let mut names: Vec<&str> = LEFT_OUT.iter().map(|(_, name)| *name).collect();
        names.dedup();
        let mut expected: Vec<(usize, usize)> = names.into_iter().filter_map(of_kind).collect();
        let mut found = Vec::new();
        for warning in &warnings {
            let Warning::Deviation(deviation) = warning else {
                return Err(TestCaseError::fail(warning.to_string()));
            };
            match warning.kind() {
                "corner_form" => prop_assert!(has_slashes),
                "line_ends" => prop_assert_eq!(ends, "\r"),
                _ => found.push((deviation.line, deviation.count)),
            }
        }
        expected.sort_unstable();
        found.sort_unstable();
        prop_assert_eq!(found, expected);
    }

    /// Bytes and words of the format in any places: what a strict reading takes is the same in a
    /// tolerant one, without deviations.
    #[test]
    fn a_strict_reading_is_a_tolerant_one(
        mesh in meshes(),
        edits in vec((any::<prop::sample::Index>(), 0..WORDS.len()), 0..4),
    ) {
        let mut text = obj::encode(&mesh).into_bytes();
        for (place, word) in edits {
            let place = place.index(text.len());
            text.splice(place..place, WORDS[word].bytes());
        }
        let read = tolerant(&text);
        if let Ok(mesh) = &read {
            prop_assert!(mesh.0.coordinates().flatten().all(f64::is_finite));
        }
        if let Ok(mesh) = strict(&text) {
            let (same, warnings) = read.unwrap();
            prop_assert_eq!(same, mesh);
            prop_assert!(!warnings.iter().any(|found| matches!(found, Warning::Deviation(_))));
        }
    }
}

const WORDS: [&str; 16] = [
    "/",
    "//",
    " 1",
    " -1",
    "\n",
    "\r",
    "\\\n",
    "#",
    "\nf 1 2",
    "\nf",
    "\nv ",
    "\nvn 0 0 1\n",
    " 0.5",
    "\nt x",
    "ü",
    "\nl 1 2/1/1",
];
