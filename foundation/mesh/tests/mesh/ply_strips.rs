//! PLY: strips of triangles, and colours without a full scale.

use ga_files::Reading;
use ga_mesh::ply;

/// Two strips in one list, as in Stanford's files, the first with a vertex twice where it turns.
#[test]
fn strips_become_triangles() {
    let text = "ply\nformat ascii 1.0\nelement vertex 6\nproperty float x\nproperty float y\n\
        property float z\nelement tristrips 1\nproperty list int int vertex_indices\nend_header\n\
        0 0 0\n1 0 0\n0 1 0\n1 1 0\n0 2 0\n1 2 0\n11 0 1 2 3 3 5 -1 2 3 4 5\n";
    let mesh = ply::decode(text.as_bytes()).unwrap();
    let triangles = [[0, 1, 2], [2, 1, 3], [2, 3, 4], [4, 3, 5]];
    assert!(mesh.faces().iter().eq(triangles.iter().map(|t| &t[..])));
    assert!(mesh.points().is_empty());
    for (strips, message) in [
        (
            "4 0 1 2 6",
            "face 1 refers to vertex 6, but there are 6 vertices",
        ),
        ("3 0 1.5 2", "line 16: 1.5 is not the index of a vertex"),
    ] {
        let text = text.replace("11 0 1 2 3 3 5 -1 2 3 4 5", strips);
        let error = ply::decode(text.as_bytes()).unwrap_err();
        assert_eq!(error.to_string(), message);
    }
}

#[test]
fn colours_up_to_255_are_bytes() {
    let file = |colours: &str| {
        format!(
            "ply\nformat ascii 1.0\nelement vertex 2\nproperty float x\nproperty float y\n\
             property float z\nproperty float red\nproperty float green\nproperty float blue\n\
             end_header\n{colours}"
        )
    };
    let grey = 0.215_860_500;
    for colours in [
        "0 0 0 255 128 0\n0 0 0 0 0 1\n",
        "0 0 0 1 0.50196078 0\n0 0 0 0 0 0\n",
    ] {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("a.ply");
        std::fs::write(&path, file(colours)).unwrap();
        let (mesh, warnings) = ply::read_with_warnings(&path, Reading::Tolerant).unwrap();
        let [red, green, blue, alpha] = mesh.colours().unwrap()[0];
        assert_eq!([red, blue, alpha], [1.0, 0.0, 1.0]);
        assert!((green - grey).abs() < 1e-7);
        let expected = colours.contains("255").then_some(ply::Warning::ByteColours);
        assert_eq!(warnings, Vec::from_iter(expected));
        let strict = ply::read_with_warnings(&path, Reading::Strict).map_err(|e| e.to_string());
        match expected {
            Some(_) => {
                let end = "line 11: 255 is not a part of a colour, which is from 0 to 1";
                assert!(strict.unwrap_err().ends_with(end));
            }
            None => assert!(strict.is_ok()),
        }
    }
    // The first number beyond 1 is an opacity.
    let text = file("0 0 0 1 0 0 51\n0 0 0 255 0 0 255\n");
    let text = text.replace("float blue\n", "float blue\nproperty float alpha\n");
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("a.ply");
    std::fs::write(&path, text).unwrap();
    let error = ply::read_with_warnings(&path, Reading::Strict)
        .unwrap_err()
        .to_string();
    assert!(error.contains("line 12: 51 is"), "{error}");
    let error = ply::decode(file("0 0 0 255 0.5 0\n0 0 0 0 0 1\n").as_bytes()).unwrap_err();
    let error = error.to_string();
    assert!(
        error.starts_with("line 11: 255 is not a part of a colour"),
        "{error}"
    );
}
