//! Faults of OBJ files: each is named with its line.

use ga_mesh::obj::{self, ObjProblem};

use super::TRIANGLE;
use ga_files::Reading;
use ga_mesh::{FormatError, Mesh};

/// A mesh of a file that is read strictly.
pub(super) fn strict(text: &[u8]) -> Result<Mesh, FormatError> {
    let nothing = |_: &str| Err(std::io::ErrorKind::NotFound.into());
    obj::decode_with_libraries(text, Reading::Strict, nothing).map(|(mesh, _)| mesh)
}

#[test]
fn every_fault_is_named_with_its_line() {
    for (lines, message) in [
        ("v 1 2 nan", "line 4: \"nan\" is not a finite number"),
        ("v 1 2 1e999", "line 4: \"1e999\" is not a finite number"),
        ("v 1 2 3 inf", "line 4: \"inf\" is not a finite number"),
        ("v 1 2,5 3", "line 4: \"2,5\" is not a number"),
        (
            "v 1 2",
            "line 4: a v line has 3, 4, 6 or 7 numbers, but this one has 2",
        ),
        (
            "v 1 2 3 4 5",
            "line 4: a v line has 3, 4, 6 or 7 numbers, but this one has 5",
        ),
        (
            "v 1 2 3 4 5 6 7 8",
            "line 4: a v line has 3, 4, 6 or 7 numbers, but this one has 8",
        ),
        (
            "v",
            "line 4: a v line has 3, 4, 6 or 7 numbers, but this one has 0",
        ),
        (
            "vt",
            "line 4: a vt line has 1, 2 or 3 numbers, but this one has 0",
        ),
        (
            "vn 1 0",
            "line 4: a vn line has 3 numbers, but this one has 2",
        ),
        (
            "v 1 \\\n2 \\\n\nf 1 2 3",
            "line 4: a v line has 3, 4, 6 or 7 numbers, but this one has 2",
        ),
        ("f 1 2 4", "line 4: \"4\" refers to v 4, but there are 3"),
        (
            "\n\r\nf 1 2 9",
            "line 6: \"9\" refers to v 9, but there are 3",
        ),
        ("f 1 2 0", "line 4: \"0\" refers to v 0, but there are 3"),
        ("f 1 2 -4", "line 4: \"-4\" refers to v -4, but there are 3"),
        (
            "f 1/1 2/1 3/1",
            "line 4: \"1\" refers to vt 1, but there are 0",
        ),
        (
            "vn 0 0 1\nf 1//1 2//2 3//1",
            "line 5: \"2\" refers to vn 2, but there are 1",
        ),
        (
            "f 1 2 4294967297",
            "line 4: \"4294967297\" refers to v 4294967297, but there are 3",
        ),
        (
            "f 1 2",
            "line 4: a face has at least 3 corners, but this one has 2",
        ),
        (
            "f 1 2 3/",
            "line 4: \"3/\" is not a corner of a face (v, v/vt, v//vn or v/vt/vn)",
        ),
        (
            "f 1 2 3//",
            "line 4: \"3//\" is not a corner of a face (v, v/vt, v//vn or v/vt/vn)",
        ),
        (
            "f 1 2 /3",
            "line 4: \"/3\" is not a corner of a face (v, v/vt, v//vn or v/vt/vn)",
        ),
        (
            "f 1 2 1/1/1/1",
            "line 4: \"1/1/1/1\" is not a corner of a face (v, v/vt, v//vn or v/vt/vn)",
        ),
        (
            "f 1 2 three",
            "line 4: \"three\" is not a corner of a face (v, v/vt, v//vn or v/vt/vn)",
        ),
        (
            "f 1 2 1.0",
            "line 4: \"1.0\" is not a corner of a face (v, v/vt, v//vn or v/vt/vn)",
        ),
        (
            "face 1 2 3",
            "line 4: a line of a polygon mesh cannot begin with \"face\"",
        ),
        (
            "curv 0 1 1 2",
            "line 4: a line of a polygon mesh cannot begin with \"curv\"",
        ),
        ("f 1 2 3\0", "line 4: the file is not UTF-8 text"),
        (
            "# only vertices",
            "line 4: the file ends without a face, a line or a point",
        ),
    ] {
        let error = strict(format!("{TRIANGLE}{lines}\n").as_bytes()).unwrap_err();
        assert_eq!(error.to_string(), message, "{lines:?}");
    }
    assert_eq!(
        obj::decode(b"").unwrap_err().to_string(),
        "line 1: the file ends without a vertex"
    );
    for bytes in [&b"v 0 0 0\ng \xff\n"[..], b"v 0 0 0\ng \0\n"] {
        assert_eq!(
            strict(bytes).unwrap_err().to_string(),
            "line 2: the file is not UTF-8 text"
        );
    }
    let not_text = FormatError::Obj {
        line: 2,
        problem: ObjProblem::NotText,
    };
    assert_eq!(obj::decode(b"v 0 0 0\ng \0\n"), Err(not_text));
}

#[test]
fn errors_name_the_file() {
    let folder = tempfile::tempdir().unwrap();
    let missing = folder.path().join("missing.obj");
    let message = obj::read(&missing).unwrap_err().to_string();
    assert!(
        message.starts_with(&format!("cannot read {}: ", missing.display())),
        "{message}"
    );
    let picture = folder.path().join("picture.obj");
    std::fs::write(&picture, b"\x89PNG\r\n\x1a\n\0\0\0\rIHDR").unwrap();
    let message = obj::read(&picture).unwrap_err().to_string();
    assert_eq!(
        message,
        format!("{}: line 1: the file is not UTF-8 text", picture.display())
    );
}
