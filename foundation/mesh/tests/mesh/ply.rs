//! PLY: files written by hand, faults, and what comes back.

use ga_mesh::ply::{self, Encoding};
use ga_mesh::{CornerAttribute, Faces, Mesh, Polylines};
use ga_runtime::vga3::Vector;
use proptest::collection::vec;
use proptest::prelude::*;

const ENCODINGS: [Encoding; 3] = [Encoding::Ascii, Encoding::LittleEndian, Encoding::BigEndian];

/// All that is read, and elements and properties that are not.
const TEXT: &str = "ply\r
format ascii 1.0\r
comment caf\u{e9}\r
obj_info num_cols 512\r
element camera 1\r
property float focal\r
property list uchar float distortion\r
element vertex 4\r
property double x\r
property float32 y\r
property int z\r
property float confidence\r
property float nx\r
property float ny\r
property float nz\r
property uchar red\r
property uchar green\r
property uchar blue\r
property uint16 alpha\r
property float u\r
property float v\r
element face 2\r
property uchar quality\r
property list uchar uint vertex_index\r
element edge 1\r
property int vertex1\r
property int vertex2\r
end_header\r
50 2 .1 -2e-3\r
0 0 0 1 0 0 1 255 0 128 65535 0 0\r
\r
1 0 0 1 0 0 1 0 0 0 0 1 0\r
1. 1 0 1 0 0 2 0 0 0 0 1 1\r
0 1 -1 1 0 0 0 0 0 0 0 0 1\r
7 3 0 1 2\r
7 4 0 1 2 3\r
3 1\r
";

#[test]
fn all_known_properties_are_read() {
    let mesh = ply::decode(TEXT.as_bytes()).unwrap();
    let positions = [[0.0; 3], [1.0, 0.0, 0.0], [1.0, 1.0, 0.0], [0.0, 1.0, -1.0]];
    assert!(mesh.coordinates().eq(positions));
    assert!(mesh.faces().iter().eq([&[0, 1, 2][..], &[0, 1, 2, 3]]));
    let normals = mesh.normals().unwrap();
    assert_eq!(normals.get(2), Some(&Vector::new(0.0, 0.0, 1.0)));
    assert_eq!(normals.get(6), None);
    assert_eq!(
        mesh.texture_coordinates().unwrap().get(5),
        Some(&[1.0, 1.0])
    );
    let [red, green, blue, alpha] = mesh.colours().unwrap()[0];
    assert_eq!([red, green, alpha], [1.0, 0.0, 1.0]);
    // 128 in sRGB, from the tables of the standard.
    assert!((blue - 0.215_860_500).abs() < 1e-8);
    assert!(mesh.polylines().iter().eq([&[3, 1][..]]));
}

/// The bytes of a triangle, put together by hand.
fn binary(big: bool) -> Vec<u8> {
    let word = |low_first: [u8; 4]| {
        let mut bytes = low_first;
        if big {
            bytes.reverse();
        }
        bytes
    };
    let (zero, one) = (word([0; 4]), word([0, 0, 0x80, 0x3f]));
    let end = if big { "big" } else { "little" };
    let mut file = format!(
        "ply\nformat binary_{end}_endian 1.0\nelement vertex 3\nproperty float x\n\
         property float y\nproperty float z\nelement face 1\n\
         property list uchar int vertex_indices\nend_header\n"
    )
    .into_bytes();
    for coordinates in [[zero; 3], [one, zero, zero], [zero, one, zero]] {
        file.extend(coordinates.concat());
    }
    file.push(3);
    for vertex in 0..3 {
        file.extend(word([vertex, 0, 0, 0]));
    }
    file
}

#[test]
fn both_byte_orders_are_read_and_written() {
    for (big, encoding) in [(false, Encoding::LittleEndian), (true, Encoding::BigEndian)] {
        let file = binary(big);
        let mesh = ply::decode(&file).unwrap();
        assert!(
            mesh.coordinates()
                .eq([[0.0; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]])
        );
        assert_eq!(mesh.triangles(), [[0, 1, 2]]);
        assert_eq!(ply::encode(&mesh, encoding), file);
    }
}

#[test]
fn every_fault_is_named_with_its_place() {
    let vertices = "element vertex 1\nproperty float x\nproperty float y\nproperty float z\n";
    let faces = "element face 1\nproperty list uchar int vertex_indices\n";
    let header = |elements: &str| format!("ply\nformat ascii 1.0\n{elements}");
    let file = |rest: &str| {
        format!(
            "{}end_header\n{rest}",
            header(&(vertices.to_owned() + faces))
        )
    };
    for (text, message) in [
        (
            "PLY\n".to_owned(),
            "line 1: a PLY file begins with the line \"ply\"",
        ),
        (
            "ply".to_owned(),
            "line 1: the header has no end_header line",
        ),
        (
            header(vertices),
            "line 6: the header has no end_header line",
        ),
        (
            "ply\nformat ascii 2.0\n".to_owned(),
            "line 2: there is no format \"ascii 2.0\"",
        ),
        (
            format!("ply\n{vertices}"),
            "line 2: the header does not say the format before its first element",
        ),
        (
            header("property float x\n"),
            "line 3: a property comes before the first element",
        ),
        (
            header("element vertex -1\n"),
            "line 3: \"element vertex -1\" is not a line of a PLY header",
        ),
        (
            header("element vertex 1\nproperty quaternion x\n"),
            "line 4: \"property quaternion x\" is not a line of a PLY header",
        ),
        (
            header("element vertex 1\nproperty float x\nproperty int x\n"),
            "line 5: vertex x is declared twice",
        ),
        (
            header("element vertex 1\nproperty float x\nproperty float y\nend_header\n0 0\n"),
            "line 3: element vertex has no property z of the right kind",
        ),
        (
            header("element face 0\nproperty int vertex_indices\nend_header\n"),
            "line 3: element face has no property vertex_indices of the right kind",
        ),
        (
            header("element tristrips 1\nproperty list int int strip\nend_header\n1 1\n"),
            "line 3: element tristrips has no property vertex_indices of the right kind",
        ),
        (header("end_header\n"), "the header declares no vertices"),
        (
            file("0 0 0\n3 0 0 0 0\n"),
            "line 11: \"0\" follows the end of the element",
        ),
        (
            file("0 0 nan\n3 0 0 0\n"),
            "line 10: \"nan\" is not a finite number",
        ),
        (
            file("0 0 zero\n3 0 0 0\n"),
            "line 10: \"zero\" is not a number",
        ),
        (
            file("0 0\n3 0 0 0\n"),
            "line 10: the line ends before its element does",
        ),
        (
            file("0 0 0\n2 0 0\n"),
            "line 11: a face has at least 3 corners, but this one has 2",
        ),
        (file("0 0 0\n-3 0 0\n"), "line 11: a list has the length -3"),
        (
            file("0 0 0\n3 0 0 0.5\n"),
            "line 11: 0.5 is not the index of a vertex",
        ),
        (
            file("0 0 0\n3 0 0 -1\n"),
            "line 11: -1 is not the index of a vertex",
        ),
        (
            file("0 0 0\n3 0 0 1\n"),
            "face 0 refers to vertex 1, but there are 1 vertices",
        ),
        (
            file("0 0 0\n\n\n\n\n"),
            "line 14: the file ends within the element",
        ),
    ] {
        let error = ply::decode(text.as_bytes()).unwrap_err().to_string();
        assert_eq!(error, message, "{text}");
    }
    let mut cut = binary(false);
    cut.pop();
    let error = ply::decode(&cut).unwrap_err().to_string();
    let byte = binary(false).len() - 13;
    assert_eq!(
        error,
        format!("face 0 at byte {byte}: the file ends within the element")
    );
}

/// Claims of 10⁹ elements, or of a list of that length, in a file of some bytes.
#[test]
fn a_false_count_is_an_error_at_once() {
    for encoding in ["ascii", "binary_little_endian", "binary_big_endian"] {
        for element in ["vertex", "face", "edge", "other"] {
            let text = format!(
                "ply\nformat {encoding} 1.0\nelement {element} 1000000000\n\
                 property list uint float x\nend_header\n0 0 0\n"
            );
            let error = ply::decode(text.as_bytes()).unwrap_err().to_string();
            let is_missing = error.contains("has no property");
            assert!(
                is_missing || error.contains("1000000000 elements"),
                "{error}"
            );
        }
        let text = format!(
            "ply\nformat {encoding} 1.0\nelement vertex 1000000000\nproperty float x\n\
             property float y\nproperty float z\nend_header\n0 0 0\n"
        );
        let size = if encoding == "ascii" { 6 } else { 12 };
        assert_eq!(
            ply::decode(text.as_bytes()).unwrap_err().to_string(),
            format!(
                "line 3: 1000000000 elements vertex need at least {size}000000000 bytes, but the \
                 file has 6"
            )
        );
    }
    let mut list = b"ply\nformat binary_little_endian 1.0\nelement other 1\n\
                     property list uint float x\nend_header\n"
        .to_vec();
    list.extend(1_000_000_000u32.to_le_bytes());
    let error = ply::decode(&list).unwrap_err().to_string();
    assert!(
        error.ends_with("a list has the length 1000000000"),
        "{error}"
    );
}

#[test]
fn vertices_alone_are_points() {
    let header = "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\n\
                  property float z\nelement face 0\nproperty list uchar int vertex_indices\n\
                  end_header\n";
    let cloud = ply::decode(format!("{header}0 0 0\n1 0 0\n0 2 0\n").as_bytes()).unwrap();
    assert_eq!(cloud.points(), [0, 1, 2]);
    let text = ga_mesh::obj::encode(&cloud);
    assert!(text.ends_with("p 1\np 2\np 3\n"), "{text}");
    let again = ga_mesh::obj::decode(text.as_bytes()).unwrap();
    assert_eq!(again, cloud);
    let document = ga_mesh::gltf::Document::from_mesh(&cloud).unwrap();
    let primitive = &document.meshes[0].primitives[0];
    assert_eq!(primitive.mode, ga_mesh::gltf::Mode::Points);
    assert_eq!(primitive.positions[2], [0.0, 2.0, 0.0]);
}

/// They take no bytes, so that the count may be any.
#[test]
fn elements_without_properties_are_skipped() {
    for (format, end) in [
        ("ascii", &b"0 0 5\n"[..]),
        ("binary_little_endian", b"\0\0\0\0\0\0\0\0\0\0\xa0\x40"),
    ] {
        let mut text = format!("ply\nformat {format} 1.0\n");
        for index in 0..100_000 {
            text += &format!("element nothing{index} 18446744073709551615\n");
        }
        text += "element vertex 1\n";
        for name in ["x", "y", "z"] {
            text += &format!("property float {name}\n");
        }
        text += "end_header\n";
        let mesh = ply::decode(&[text.as_bytes(), end].concat()).unwrap();
        assert!(mesh.coordinates().eq([[0.0, 0.0, 5.0]]));
    }
}

#[test]
fn normals_that_differ_at_a_vertex_are_left_out_and_texture_coordinates_become_lists() {
    let faces = Faces::from_polygons([[0, 1, 2], [0, 2, 3]]).unwrap();
    let corners = vec![[0.0; 3], [1.0, 0.0, 0.0], [1.0, 1.0, 0.0], [0.0, 1.0, 0.0]];
    let mesh = Mesh::new(corners, faces)
        .and_then(|mesh| {
            mesh.with_normals(CornerAttribute {
                values: vec![Vector::new(0.0, 0.0, 1.0), Vector::new(0.0, 1.0, 0.0)],
                corners: (0..6).map(|corner| Some(corner / 3)).collect(),
            })
        })
        .and_then(|mesh| {
            mesh.with_texture_coordinates(vec![CornerAttribute {
                values: vec![[0.5, 0.25]],
                corners: vec![Some(0), Some(0), Some(0), None, None, None],
            }])
        })
        .unwrap();
    for encoding in ENCODINGS {
        let back = ply::decode(&ply::encode(&mesh, encoding)).unwrap();
        assert_eq!(back.normals(), None);
        let texture = back.texture_coordinates().unwrap();
        assert_eq!(texture.get(2), Some(&[0.5, 0.25]));
        assert_eq!(texture.get(3), None);
    }
}

fn meshes() -> impl Strategy<Value = Mesh> {
    let coordinate = prop_oneof![
        4 => -10.0..10.0f64,
        2 => (-10.0..10.0f32).prop_map(f64::from),
        1 => any::<f64>().prop_filter("finite", |x| x.is_finite()),
    ];
    let vertex = (
        proptest::array::uniform3(coordinate),
        proptest::array::uniform3(-1.0..1.0f64),
        proptest::array::uniform4(any::<u8>()),
        proptest::array::uniform2(-2.0..2.0f64),
    );
    (vec(vertex, 3..20), 0usize..9).prop_flat_map(|(vertices, faces)| {
        let count = vertices.len() as u32;
        (
            Just(vertices),
            vec(vec(0..count, 3..7), faces),
            vec([0..count, 0..count], 0..4),
        )
            .prop_map(|(vertices, polygons, edges)| {
                let faces = Faces::from_polygons(polygons).unwrap();
                let normals = vertices.iter().map(|v| {
                    (Vector::from(v.1) + Vector::new(2.0, 0.0, 0.0))
                        .normalized()
                        .unwrap()
                });
                let normals = CornerAttribute::of_vertices(normals.collect(), &faces);
                let texture = vertices.iter().map(|v| v.3).collect();
                let texture = CornerAttribute::of_vertices(texture, &faces);
                // Values whose linear light is exact: black and white.
                let colours = vertices.iter().map(|v| {
                    let [red, green, blue, alpha] = v.2;
                    let [red, green, blue] = [red, green, blue].map(|c| f64::from(c & 1));
                    [red, green, blue, f64::from(alpha) / 255.0]
                });
                Mesh::new(vertices.iter().map(|v| v.0).collect(), faces)
                    .and_then(|mesh| mesh.with_normals(normals))
                    .and_then(|mesh| mesh.with_texture_coordinates(vec![texture]))
                    .and_then(|mesh| mesh.with_colours(colours.collect()))
                    .and_then(|mesh| mesh.with_polylines(Polylines::from_lines(edges).unwrap()))
                    .unwrap()
            })
    })
}

/// The values of all corners.
fn at_corners<T: Copy>(attribute: Option<&CornerAttribute<T>>, mesh: &Mesh) -> Vec<Option<T>> {
    let corners = 0..mesh.faces().corners().len();
    corners
        .map(|corner| attribute.and_then(|values| values.get(corner).copied()))
        .collect()
}

proptest! {
    #[test]
    fn a_written_mesh_reads_back_the_same(mesh in meshes()) {
        for encoding in ENCODINGS {
            let back = ply::decode(&ply::encode(&mesh, encoding)).unwrap();
            prop_assert_eq!(back.positions(), mesh.positions());
            prop_assert_eq!(back.faces(), mesh.faces());
            prop_assert_eq!(back.colours(), mesh.colours());
            prop_assert_eq!(back.polylines(), mesh.polylines());
            prop_assert_eq!(
                at_corners(back.normals(), &back),
                at_corners(mesh.normals(), &mesh)
            );
            prop_assert_eq!(
                at_corners(back.texture_coordinates(), &back),
                at_corners(mesh.texture_coordinates(), &mesh)
            );
        }
    }

    /// Where all coordinates fit single precision, the file declares that.
    #[test]
    fn coordinates_of_single_precision_come_back(
        positions in vec(proptest::array::uniform3(any::<f32>()), 1..4),
    ) {
        let positions = positions.iter().map(|p| p.map(f64::from)).collect();
        let mesh = Mesh::new(positions, Faces::default()).unwrap();
        for encoding in ENCODINGS {
            let file = ply::encode(&mesh, encoding);
            prop_assert!(file.windows(16).any(|line| line == b"property float x"));
            let back = ply::decode(&file).unwrap();
            prop_assert_eq!(back.positions(), mesh.positions());
        }
    }

    /// Colours of a byte come back as the same byte.
    #[test]
    fn bytes_of_colour_come_back(colour in proptest::array::uniform3(any::<u8>())) {
        let text = |[red, green, blue]: [u8; 3]| format!(
            "ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nproperty float y\n\
             property float z\nproperty uchar red\nproperty uchar green\nproperty uchar blue\n\
             element face 0\nproperty list uchar int vertex_indices\nend_header\n\
             0 0 0 {red} {green} {blue}\n"
        );
        let mesh = ply::decode(text(colour).as_bytes()).unwrap();
        prop_assert_eq!(
            String::from_utf8(ply::encode(&mesh, Encoding::Ascii)).unwrap(),
            text(colour)
        );
    }

    #[test]
    fn no_damage_makes_it_panic_or_yield_a_bad_mesh(
        mesh in meshes(),
        encoding in 0usize..3,
        damage in vec((any::<prop::sample::Index>(), any::<u8>()), 0..4),
        end in any::<prop::sample::Index>(),
    ) {
        let mut file = ply::encode(&mesh, ENCODINGS[encoding]);
        for (place, byte) in damage {
            let place = place.index(file.len());
            file[place] = byte;
        }
        for file in [&file[..], &file[..end.index(file.len())]] {
            if let Ok(mesh) = ply::decode(file) {
                prop_assert!(mesh.coordinates().flatten().all(f64::is_finite));
                let vertices = mesh.vertex_count();
                prop_assert!(mesh.faces().corners().iter().all(|&v| (v as usize) < vertices));
            }
        }
    }
}
