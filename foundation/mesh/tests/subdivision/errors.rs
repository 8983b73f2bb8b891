//! Meshes that cannot be subdivided, and texts that are not tags.

use ga_mesh::subdivision::{Cage, Rules, StencilLength, TagProblem, TagText, Tags};
use ga_mesh::{Faces, MeshError};

use crate::shapes::{corner, crease, cube};

fn error(faces: &[&[u32]], vertices: usize, rules: Rules) -> MeshError {
    Cage::new(Faces::from_polygons(faces).unwrap(), vertices, rules).unwrap_err()
}

#[test]
fn faulty_faces_are_named() {
    for rules in [Rules::LOOP, Rules::CATMULL_CLARK] {
        assert_eq!(error(&[], 3, rules), MeshError::NoFaces);
        let twice = MeshError::DegenerateFace { face: 1, vertex: 2 };
        assert_eq!(error(&[&[0, 1, 2], &[2, 3, 2]], 4, rules), twice);
        let edge = MeshError::NonManifoldEdge {
            a: 0,
            b: 2,
            faces: 3,
        };
        assert_eq!(error(&[&[0, 1, 2], &[2, 0, 3], &[2, 0, 4]], 5, rules), edge);
        assert_eq!(
            edge.to_string(),
            "3 faces meet at the edge between vertices 0 and 2; at most 2 may"
        );
        let range = MeshError::IndexOutOfRange {
            face: 0,
            index: 7,
            vertices: 4,
        };
        assert_eq!(error(&[&[0, 1, 7]], 4, rules), range);
    }
    let quadrilateral = MeshError::NotATriangle {
        face: 1,
        corners: 4,
    };
    assert_eq!(
        error(&[&[0, 1, 2], &[0, 2, 3, 4]], 5, Rules::LOOP),
        quadrilateral
    );
    let twice = MeshError::DegenerateFace { face: 0, vertex: 1 };
    assert_eq!(error(&[&[0, 1, 2, 3, 1]], 4, Rules::CATMULL_CLARK), twice);
}

#[test]
fn faulty_tags_are_named() {
    let error = |tags: Tags| {
        let cage = Cage::new(cube().faces(), 8, Rules::CATMULL_CLARK).unwrap();
        cage.with_tags(&tags).unwrap_err()
    };
    let creases = |creases: &[_]| Tags {
        creases: creases.to_vec(),
        ..Tags::default()
    };
    let corners = |corners: &[_]| Tags {
        corners: corners.to_vec(),
        ..Tags::default()
    };
    let no_edge = |b| MeshError::NoEdge { crease: 1, a: 0, b };
    for b in [7, 8, u32::MAX, 0] {
        assert_eq!(
            error(creases(&[crease(0, 1, 1.0), crease(0, b, 1.0)])),
            no_edge(b)
        );
    }
    let no_vertex = MeshError::NoVertex {
        corner: 0,
        vertex: 8,
        vertices: 8,
    };
    assert_eq!(error(corners(&[corner(8, 1.0)])), no_vertex);
    for sharpness in [-0.1, f64::NAN, f64::NEG_INFINITY] {
        for (tags, kind) in [
            (creases(&[crease(0, 1, sharpness)]), "crease"),
            (corners(&[corner(0, sharpness)]), "corner"),
        ] {
            let message = error(tags).to_string();
            let expected =
                format!("{sharpness} is not a sharpness, which is at least 0 ({kind} 0)");
            assert_eq!(message, expected);
        }
    }
}

#[test]
fn the_last_tag_counts() {
    let cage = |tags: &Tags| {
        let cage = Cage::new(cube().faces(), 8, Rules::CATMULL_CLARK).unwrap();
        cage.with_tags(tags).unwrap()
    };
    let tags = Tags {
        creases: vec![
            crease(1, 0, 3.0),
            crease(2, 3, 1.0),
            crease(0, 1, 2.0),
            crease(3, 2, 0.0),
        ],
        corners: vec![
            corner(5, 1.0),
            corner(5, 4.0),
            corner(2, 1.0),
            corner(2, 0.0),
        ],
    };
    assert_eq!(cage(&tags).creases(), [crease(0, 1, 2.0)]);
    assert_eq!(cage(&tags).corners(), [corner(5, 4.0)]);
    let cleared = cage(&tags).with_tags(&Tags::default()).unwrap();
    assert!(cleared.creases().is_empty() && cleared.corners().is_empty());
}

#[test]
fn wrong_lengths_are_named() {
    let stencils = Cage::new(cube().faces(), 8, Rules::CATMULL_CLARK)
        .unwrap()
        .refine()
        .unwrap()
        .stencils;
    let mut fine = vec![7.0; 26];
    let expected = |what, expected, found| {
        Err(StencilLength {
            what,
            expected,
            found,
        })
    };
    assert_eq!(
        stencils.apply(&[0.0; 9], &mut fine),
        expected("coarse values", 8, 9)
    );
    assert_eq!(
        stencils.apply(&[0.0; 8], &mut fine[1..]),
        expected("fine values", 26, 25)
    );
    assert_eq!(
        stencils.apply_channels(3, &[0.0; 8], &mut fine),
        expected("coarse values", 24, 8)
    );
    assert_eq!(fine, [7.0; 26]);
    assert!(stencils.then(&stencils).is_err());
}

#[test]
fn texts_that_are_not_tags_are_errors() {
    let problem = |text: &[u8]| match TagText::decode(text) {
        Err(MeshError::Tag { line: 2, problem }) => problem,
        other => panic!("{other:?}"),
    };
    let word = |word: &str| word.to_owned();
    assert_eq!(
        problem(b"\nsharp 1 2 3"),
        TagProblem::UnknownTag {
            word: word("sharp")
        }
    );
    let count = TagProblem::WrongCount {
        expected: "crease a b sharpness",
        found: 2,
    };
    assert_eq!(problem(b"# ok\ncrease 1 2"), count);
    let count = TagProblem::WrongCount {
        expected: "corner v sharpness",
        found: 3,
    };
    assert_eq!(problem(b"corner 1 1\ncorner 1 2 3"), count);
    for vertex in ["-1", "1.0", "4294967296", "a", "1/2"] {
        let text = format!("\ncorner {vertex} 3");
        let expected = TagProblem::NotAVertex { word: word(vertex) };
        assert_eq!(problem(text.as_bytes()), expected);
    }
    for sharpness in ["-1", "nan", "-inf", "sharp"] {
        let text = format!("\r\ncrease 0 1 {sharpness}\r\n");
        let expected = TagProblem::NotASharpness {
            word: word(sharpness),
        };
        assert_eq!(problem(text.as_bytes()), expected);
    }
    assert_eq!(problem(b"\ncorner \xff 1"), TagProblem::NotText);
    let text = TagText::decode(b"  crease 3 4 1e1 # \xff\r\n\tcorner 0 infinity").unwrap();
    assert_eq!(text.tags.creases, [crease(3, 4, 10.0)]);
    assert_eq!(text.tags.corners, [corner(0, f64::INFINITY)]);
    assert_eq!((text.crease_lines, text.corner_lines), (vec![1], vec![2]));
}
