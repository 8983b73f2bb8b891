//! Meshes from OBJ files: real ones with known counts, made ones with known faults, and `tobj` as a
//! second opinion.

mod faults;
mod properties;
mod tolerant;
mod tolerant_libraries;

use ga_files::{Deviation, Reading};
use ga_mesh::obj::{self, ObjProblem};
use ga_mesh::{FormatError, Mesh};
use ga_runtime::vga3::Vector;
use nullcone_shared_data::shared;
use serde_json::Value;
use tobj::LoadOptions;

#[test]
fn real_files_have_the_counts_and_sums_known_for_them() {
    let truth: Value = serde_json::from_str(include_str!("../../data/obj.json")).unwrap();
    for name in ["human_base.obj", "spot.obj", "stanford-bunny.obj"] {
        let Some(path) = shared(&format!("data/anim/{name}")) else {
            return;
        };
        let truth = &truth[name];
        let mesh = obj::read(path).unwrap();
        assert_eq!(
            mesh.vertex_count() as u64,
            truth["v"].as_u64().unwrap(),
            "{name}"
        );
        assert_eq!(
            mesh.faces().len() as u64,
            truth["f"].as_u64().unwrap(),
            "{name}"
        );
        assert_eq!(
            mesh.triangles().len() as u64,
            truth["tri"].as_u64().unwrap(),
            "{name}"
        );
        assert_eq!(
            mesh.faces().corners().len() as u64,
            truth["corners"].as_u64().unwrap(),
            "{name}"
        );
        let texture = mesh
            .texture_coordinates()
            .map_or(0, |texture| texture.values.len());
        assert_eq!(texture as u64, truth["vt"].as_u64().unwrap(), "{name}");
        let [low, high] = mesh.bounds().unwrap();
        for axis in 0..3 {
            assert_eq!(low[axis], truth["min"][axis].as_f64().unwrap(), "{name}");
            assert_eq!(high[axis], truth["max"][axis].as_f64().unwrap(), "{name}");
            let sum: f64 = mesh.coordinates().map(|x| x[axis]).sum();
            let expected = truth["sum"][axis].as_f64().unwrap();
            assert!(
                (sum - expected).abs() <= 1e-9 * expected.abs().max(1.0),
                "{name}"
            );
        }
    }
}

#[test]
fn the_vertices_of_a_real_file_are_in_its_order() {
    for name in ["human_base.obj", "stanford-bunny.obj"] {
        let Some(path) = shared(&format!("data/anim/{name}")) else {
            return;
        };
        let text = std::fs::read_to_string(&path).unwrap();
        let lines: Vec<Vec<f64>> = text
            .lines()
            .filter_map(|line| line.strip_prefix("v "))
            .map(|line| {
                line.split_whitespace()
                    .map(|word| word.parse().unwrap())
                    .collect()
            })
            .collect();
        let mesh = obj::read(&path).unwrap();
        assert_eq!(mesh.vertex_count(), lines.len());
        assert!(
            mesh.coordinates()
                .zip(&lines)
                .all(|(vertex, line)| vertex[..] == line[..])
        );
    }
}

#[test]
fn the_human_has_its_body_in_a_group() {
    let Some(path) = shared("data/anim/human_base.obj") else {
        return;
    };
    let mesh = obj::read(path).unwrap();
    let body = mesh.part("body").unwrap();
    // basemesh_vertex_groups.json counts the helpers from vertex 13,380 on.
    assert_eq!(body.vertices, (0..13_380).collect::<Vec<u32>>());
    let first_faces = mesh.faces().iter().take(body.mesh.faces().len());
    assert!(body.mesh.faces().iter().eq(first_faces));
    assert_eq!(
        mesh.groups()
            .iter()
            .map(|group| group.faces.len())
            .sum::<usize>(),
        mesh.faces().len()
    );
    assert_eq!(mesh.part("no such group"), None);
}

/// Faces as `tobj` has them: the places of their corners, in single precision.
fn faces_by_tobj(text: &[u8]) -> Vec<Vec<[f32; 3]>> {
    let options = LoadOptions {
        ignore_lines: true,
        ignore_points: true,
        ..LoadOptions::default()
    };
    let no_materials = |_: &std::path::Path| Err(tobj::LoadError::GenericFailure);
    let (models, _) = tobj::load_obj_buf(&mut &text[..], &options, no_materials).unwrap();
    let mut faces = Vec::new();
    for mesh in models.iter().map(|model| &model.mesh) {
        let mut indices = mesh.indices.iter().map(|&index| {
            let first = 3 * index as usize;
            [
                mesh.positions[first],
                mesh.positions[first + 1],
                mesh.positions[first + 2],
            ]
        });
        let triangles = vec![3; mesh.indices.len() / 3];
        let arities = if mesh.face_arities.is_empty() {
            &triangles
        } else {
            &mesh.face_arities
        };
        faces.extend(
            arities
                .iter()
                .map(|&arity| indices.by_ref().take(arity as usize).collect::<Vec<_>>()),
        );
    }
    faces
}

fn faces_of(mesh: &Mesh) -> Vec<Vec<[f32; 3]>> {
    let places: Vec<[f32; 3]> = mesh.coordinates().map(|x| x.map(|x| x as f32)).collect();
    mesh.faces()
        .iter()
        .map(|face| face.iter().map(|&vertex| places[vertex as usize]).collect())
        .collect()
}

#[test]
fn tobj_sees_the_same_faces_in_real_files() {
    for name in ["human_base.obj", "spot.obj", "stanford-bunny.obj"] {
        let Some(path) = shared(&format!("data/anim/{name}")) else {
            return;
        };
        let text = std::fs::read(path).unwrap();
        assert_eq!(
            faces_of(&obj::decode(&text).unwrap()),
            faces_by_tobj(&text),
            "{name}"
        );
    }
}

#[test]
fn all_forms_of_lines_are_read() {
    let text = b"\
# caf\xe9, in an old encoding
mtllib unused.mtl
v 0 0 0
v 1 0 0 1\r
v 1 \\
  1 0
v 0 1 0 0.5 0.5 0.5 # with a colour
vt 0.25
vt 0.5 0.75
vt 1 1 0
vn 0 0 1
o thing one
usemtl red
g left right left
f 1/1/1 2/2/1 3/3/1
g
s off
f -4//-1 -2//-1 -1//-1
g right
f 1 2 3 4
";
    let mesh = obj::decode(text).unwrap();
    let expected = [
        [0.0, 0.0, 0.0],
        [1.0, 0.0, 0.0],
        [1.0, 1.0, 0.0],
        [0.0, 1.0, 0.0],
    ];
    assert!(mesh.coordinates().eq(expected));
    assert!(
        mesh.faces()
            .iter()
            .eq([&[0, 1, 2][..], &[0, 2, 3], &[0, 1, 2, 3]])
    );
    let texture = mesh.texture_coordinates().unwrap();
    assert_eq!(texture.values, [[0.25, 0.0], [0.5, 0.75], [1.0, 1.0]]);
    assert_eq!(texture.corners[..4], [Some(0), Some(1), Some(2), None]);
    assert!(texture.corners[4..].iter().all(Option::is_none));
    let groups: Vec<_> = mesh
        .groups()
        .iter()
        .map(|group| (group.name.as_str(), &group.faces[..]))
        .collect();
    assert_eq!(groups, [("left", &[0][..]), ("right", &[0, 2])]);
    assert_eq!(mesh.objects().len(), 1);
    assert_eq!(mesh.object("thing one").unwrap().faces, [0, 1, 2]);
    assert_eq!(mesh.materials().len(), 1);
    assert!((0..3).all(|face| mesh.material(face).unwrap().name == "red"));
    let normals = mesh.normals().unwrap();
    assert_eq!(normals.values, [Vector::new(0.0, 0.0, 1.0)]);
    assert_eq!(normals.corners[..6], [Some(0); 6]);
    assert_eq!(normals.corners[6..], [None; 4]);
    // 0.5 in sRGB is the linear light ((0.5 + 0.055) / 1.055)^2.4; vertices without are white.
    let grey = (0.555f64 / 1.055).powf(2.4);
    assert_eq!(mesh.colours().unwrap()[0], [1.0; 4]);
    assert_eq!(mesh.colours().unwrap()[3], [grey, grey, grey, 1.0]);
}

#[test]
fn a_face_may_come_before_its_vertices() {
    let mesh = obj::decode(b"f 1 2 3\nv 0 0 0\nv 1 0 0\nv 0 1 0\n").unwrap();
    assert_eq!(mesh.triangles(), [[0, 1, 2]]);
}

const TRIANGLE: &str = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";

#[test]
fn a_seventh_number_is_the_opacity() {
    let text = "v 0 0 0 1 0 1 0.25\nv 1 0 0 0 1 0\nv 0 1 0\nf 1 2 3\n";
    let mesh = obj::decode(text.as_bytes()).unwrap();
    let expected = [[1.0, 0.0, 1.0, 0.25], [0.0, 1.0, 0.0, 1.0], [1.0; 4]];
    assert_eq!(mesh.colours().unwrap(), expected);
}

/// A few bytes for each name and each face must not take memory for each pair of them.
#[test]
fn groups_take_memory_in_proportion_to_the_file() {
    let file = |groups: usize, faces: usize| {
        let mut text = format!("{TRIANGLE}g");
        for group in 0..groups {
            text += &format!(" {group:x}");
        }
        text += "\n";
        text += &"f 1 2 3\n".repeat(faces);
        text
    };
    let mesh = obj::decode(file(60, 2000).as_bytes()).unwrap();
    assert_eq!(mesh.groups().len(), 60);
    assert!(mesh.groups().iter().all(|group| group.faces.len() == 2000));
    let text = file(30_000, 15_000);
    let error = obj::decode(text.as_bytes()).unwrap_err();
    let expected = FormatError::Obj {
        // 30,000 names for a face; the faces begin at line 5.
        line: 5 + 8 * text.len() / 30_000,
        problem: ObjProblem::TooManyGroups,
    };
    assert_eq!(error, expected);
    // A name may be given again and again.
    let text = format!("{TRIANGLE}g{}\nf 1 2 3\n", " a".repeat(100_000));
    let mesh = obj::decode(text.as_bytes()).unwrap();
    assert_eq!(mesh.groups().len(), 1);
    assert_eq!(mesh.groups()[0].faces, [0]);
}

/// A colour beyond 1 is a byte where all may be; opacities are judged alone.
#[test]
fn colours_up_to_255_are_bytes() {
    let file = |colours: [&str; 3]| {
        let [a, b, c] = colours;
        format!("v 0 0 0 {a}\nv 1 0 0 {b}\nv 0 1 0 {c}\nf 1 2 3\n")
    };
    let read_as = |colours, reading| {
        obj::decode_with_libraries(file(colours).as_bytes(), reading, |_| {
            Err(std::io::ErrorKind::NotFound.into())
        })
    };
    let read = |colours| read_as(colours, Reading::Tolerant);
    let grey = 0.215_860_500;
    // Of colours and of opacities: the first number beyond 1, its line, and how many lines have
    // one.
    let (colour, opacity) = ("colours", "opacities");
    for (colours, alpha, expected) in [
        (["255 128 0", "1 1 1", ""], 1.0, vec![(colour, 255.0, 1, 1)]),
        (
            ["255 128.0 0 0.5", "1 1 1 1", ""],
            0.5,
            vec![(colour, 255.0, 1, 1)],
        ),
        (
            ["1 0.50196078 0 51", "1 1 1 255", ""],
            0.2,
            vec![(opacity, 51.0, 1, 2)],
        ),
        (
            ["255 128 0 1", "1 1 2 1", ""],
            1.0,
            vec![(colour, 255.0, 1, 2)],
        ),
        (
            ["1 0.50196078 0 51", "1 0 0 1", "1 1 1 255"],
            0.2,
            vec![(opacity, 51.0, 1, 2)],
        ),
        (
            ["255 128 0 255", "1 9 1 0", "255 255 255 255"],
            1.0,
            vec![(colour, 255.0, 1, 3), (opacity, 255.0, 1, 2)],
        ),
        (["1.000001 0.50196078 0", "", ""], 1.0, vec![]),
    ] {
        let (mesh, warnings) = read(colours).unwrap();
        let told = expected.iter().map(|&(what, value, line, count)| {
            obj::Warning::Deviation(Deviation {
                line,
                count,
                problem: ObjProblem::ByteColours { what, value },
            })
        });
        assert_eq!(warnings, told.collect::<Vec<_>>(), "{colours:?}");
        let strict = read_as(colours, Reading::Strict).map(|(_, warnings)| warnings);
        match (strict, expected.first()) {
            (Err(error), Some((what, value, ..))) => {
                let end = format!("{value} is not from 0 to 1, as {what} are");
                assert!(error.to_string().ends_with(&end), "{error}");
            }
            (found, None) => assert_eq!(found, Ok(vec![])),
            (found, _) => panic!("{colours:?} is read strictly: {found:?}"),
        }
        let [red, green, blue, opacity] = mesh.colours().unwrap()[0];
        assert_eq!([red, blue, opacity], [1.0, 0.0, alpha]);
        assert!((green - grey).abs() < 1e-7);
        assert_eq!(mesh.colours().unwrap()[2], [1.0; 4]);
    }
    // The earlier line first, whichever it is about.
    let (_, warnings) = read(["1 0 0 51", "255 128 0 255", ""]).unwrap();
    let lines: Vec<Option<usize>> = warnings
        .iter()
        .map(|warning| warning.of_file("a.obj".as_ref()).line)
        .collect();
    assert_eq!(lines, [Some(1), Some(2)]);
    for (colours, start) in [
        (
            ["255 128 0", "0.5 0 0", ""],
            "line 1: 255 is not a part of a colour",
        ),
        (["1 0.5 0", "0 1.5 0", ""], "line 2: 1.5 is no"),
        (["255 0 0", "0 0 0", "0 300 0"], "line 3: 300 is no"),
        (["1 0 0", "0 0 -1", ""], "line 2: -1 is no"),
    ] {
        let error = read(colours).unwrap_err().to_string();
        assert!(error.starts_with(start), "{error}");
    }
}
