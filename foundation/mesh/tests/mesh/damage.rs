//! Files that are cut off or changed at every place: an error or a mesh, never a panic.

use ga_files::Reading;
use ga_mesh::obj::{self, mtl};
use ga_mesh::ply::{self, Encoding, Place, PlyProblem};
use ga_mesh::{FormatError, Mesh};

const OBJ: &[u8] = b"# sample
mtllib a.mtl
v 0 0 0 1 0.5 0
v 1 0 0
v 1 1 -2.5e-1
v 0 1 .5
vt 0 0
vt 1 1
vn 0 0 1
o thing
g left right
usemtl red
f 1/1/1 2/2/1 -2/-1/-1
f 1//1 3//1 4//1
s off
f 1 2 \\
 3 4
l 1 2 3
p -1
";

const MTL: &[u8] = b"newmtl red
Ka 0.1 0.1 0.1
Kd 1 0 0
Ns 10
d 0.5
illum 2
map_Kd -o 0.5 0 -s 2 2 -clamp on a b.png
norm -bm 0.5 n.png
";

/// Bytes that mean something in one of the formats.
const BYTES: [u8; 12] = [
    0, b' ', b'\n', b'-', b'.', b'/', b'0', b'9', b'#', b'\\', 0x7f, 0xff,
];

/// The sample cut off at every place, with every byte changed, with every byte left out, and with
/// every byte doubled.
fn damaged(sample: &[u8], mut check: impl FnMut(&[u8])) {
    for place in 0..sample.len() {
        check(&sample[..place]);
        let mut copy = sample.to_vec();
        for byte in BYTES {
            copy[place] = byte;
            check(&copy);
        }
        copy[place] = sample[place] ^ 1;
        check(&copy);
        copy.remove(place);
        check(&copy);
        copy.insert(place, sample[place]);
        copy.insert(place, sample[place]);
        check(&copy);
    }
}

fn assert_sound(mesh: &Mesh) {
    assert!(mesh.coordinates().flatten().all(f64::is_finite));
    let vertices = mesh.vertex_count();
    let corners = mesh.faces().corners();
    assert!(corners.iter().all(|&v| (v as usize) < vertices));
    assert!(mesh.faces().iter().all(|face| face.len() >= 3));
}

/// The line of an error is one of the text, whose last line may be empty.
fn assert_line(line: usize, text: &[u8]) {
    let lines = text.split(|&byte| byte == b'\n').count();
    assert!((1..=lines).contains(&line), "{line} of {lines}");
}

#[test]
fn damaged_obj_files() {
    let (mut readable, mut faults) = (0, 0);
    damaged(OBJ, |text| {
        match obj::decode_with_libraries(text, Reading::Tolerant, |_| Ok(MTL.to_vec())) {
            Ok((mesh, _)) => {
                assert_sound(&mesh);
                readable += 1;
            }
            Err(error) => {
                let FormatError::Obj { line, .. } = error else {
                    panic!("{error:?}")
                };
                assert_line(line, text);
                assert!(error.to_string().starts_with(&format!("line {line}: ")));
                faults += 1;
            }
        }
    });
    assert!(readable > 0 && faults > 0);
}

#[test]
fn damaged_mtl_files() {
    // The line of the sample that names the library.
    const NAMED_AT: usize = 2;
    let (mut readable, mut faults) = (0, 0);
    damaged(MTL, |text| {
        let alone = mtl::decode(text);
        match &alone {
            Ok(_) => {}
            Err(FormatError::Mtl { line, .. }) => assert_line(*line, text),
            Err(error) => panic!("{error:?}"),
        }
        match obj::decode_with_libraries(OBJ, Reading::Tolerant, |_| Ok(text.to_vec())) {
            Ok((mesh, _)) => {
                assert_sound(&mesh);
                assert!(alone.is_ok());
                readable += 1;
            }
            Err(error) => {
                assert!(matches!(&error, FormatError::Obj { line: NAMED_AT, .. }));
                let fault = alone.expect_err("only the library is damaged").to_string();
                assert!(error.to_string().ends_with(&fault), "{error}");
                faults += 1;
            }
        }
    });
    assert!(readable > 0 && faults > 0);
}

#[test]
fn damaged_ply_files() {
    let mesh = obj::decode(OBJ).unwrap();
    for encoding in [Encoding::Ascii, Encoding::LittleEndian, Encoding::BigEndian] {
        let sample = ply::encode(&mesh, encoding);
        assert!(ply::decode(&sample).is_ok());
        damaged(&sample, |file| match ply::decode(file) {
            Ok(mesh) => assert_sound(&mesh),
            Err(FormatError::Ply { place, problem }) => match place {
                Place::Line(line) => assert_line(line, file),
                Place::Element { kind, byte, .. } => {
                    assert!(matches!(&*kind, "vertex" | "face" | "edge"), "{kind}");
                    assert!(byte <= file.len());
                }
                Place::File => assert!(
                    matches!(
                        problem,
                        PlyProblem::NotPly
                            | PlyProblem::NoEndOfHeader
                            | PlyProblem::NoFormat
                            | PlyProblem::NoVertices
                            | PlyProblem::Mesh(_)
                    ),
                    "{problem:?}"
                ),
            },
            Err(error) => panic!("{error:?}"),
        });
    }
}
