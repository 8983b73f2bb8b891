//! Materials of OBJ files: MTL libraries, what is missing, and what comes back.

use std::io;
use std::sync::Arc;

use ga_files::Reading;
use ga_mesh::obj::{self, Warning, mtl};
use ga_mesh::{
    AlphaMode, CornerAttribute, Faces, Group, Image, Material, Mesh, Phong, Polylines, Texture,
    Wrap,
};
use ga_runtime::vga3::Vector;

const TRIANGLES: &str = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\n";

pub(crate) fn load(text: &str, library: &str) -> (Mesh, Vec<obj::Warning>) {
    let text = format!("{TRIANGLES}{text}");
    obj::decode_with_libraries(text.as_bytes(), Reading::Tolerant, |name| match name {
        "a.mtl" | "two words.mtl" => Ok(library.as_bytes().to_vec()),
        _ => Err(io::ErrorKind::NotFound.into()),
    })
    .unwrap()
}

#[test]
fn all_forms_of_lines_are_read() {
    let materials = mtl::decode(
        b"# caf\xe9
newmtl old paint
Ka 0.1 0.1 0.1
Kd 0.8 0.4 2
Ks 0.5
Ns 30
Ni 1.5
d -halo 0.25
illum 2
sharpness 60
map_Kd -o 0.5 0 0 -s 2 3 -clamp on -mm 0 1 maps\\old paint.png
map_Ks 2.png
bump -bm 0.2 bump.png
refl -type sphere sky.png
aniso 0.5
newmtl metal
Kd 0.5 0.5 0.5
Pr 0.3
Pm 1
Ns 200
Ke 1 2 3
Tr 0
map_Pr -imfchan g orm.png
map_Pm -imfchan b orm.png
norm -bm 0.5 n.png
illum 0
",
    )
    .unwrap();
    let [paint, metal] = &materials[..] else {
        panic!("{materials:?}")
    };
    assert_eq!(paint.name, "old paint");
    assert_eq!(paint.base_colour, [0.8, 0.4, 1.0, 0.25]);
    assert_eq!(paint.alpha_mode, AlphaMode::Blend);
    // r⁴ = 2 / (30 + 2)
    assert_eq!((paint.roughness, paint.metallic), (0.5, 0.0));
    let texture = paint.base_colour_texture.as_ref().unwrap();
    assert_eq!(texture.image, Image::File("maps/old paint.png".into()));
    assert_eq!((texture.offset, texture.scale), ([0.5, 0.0], [2.0, 3.0]));
    assert_eq!(texture.wrap, [Wrap::ClampToEdge; 2]);
    assert_eq!(
        paint.phong,
        Some(Phong {
            ambient: [0.1; 3],
            specular: [0.5; 3],
            exponent: 30.0,
            refraction: Some(1.5),
            illumination: Some(2),
            specular_texture: Some(Texture::file("2.png")),
            bump_texture: Some(Texture::file("bump.png")),
            ..Phong::default()
        })
    );
    assert_eq!((metal.roughness, metal.metallic), (0.3, 1.0));
    assert_eq!(metal.alpha_mode, AlphaMode::Opaque);
    assert_eq!(metal.emissive, [1.0, 2.0, 3.0]);
    assert!(metal.unlit);
    assert_eq!(metal.normal_scale, 0.5);
    assert_eq!(metal.normal_texture, Some(Texture::file("n.png")));
    assert_eq!(
        metal.metallic_roughness_texture,
        Some(Texture::file("orm.png"))
    );
}

#[test]
fn every_fault_names_both_files_and_lines() {
    for (library, message) in [
        (
            "Kd 1 0 0\n",
            "line 1: Kd comes before the first newmtl line",
        ),
        (
            "\nnewmtl\n",
            "line 2: a newmtl line has a name, but this one has none",
        ),
        (
            "newmtl a\nKd 1 0\n",
            "line 2: a Kd line has 1 or 3 numbers, but this one has 2",
        ),
        (
            "newmtl a\nNs\n",
            "line 2: a Ns line has one number, but this one has 0",
        ),
        ("newmtl a\nKd 1 0 x\n", "line 2: \"x\" is not a number"),
        (
            "newmtl a\nd nan\n",
            "line 2: \"nan\" is not a finite number",
        ),
        (
            "newmtl a\nKs spectral ident.rfl 0\n",
            "line 2: Ks spectral is not supported; write red, green and blue",
        ),
        (
            "newmtl a\nbump -bm\n",
            "line 2: the option -bm of bump has no value",
        ),
        (
            "newmtl a\nKd 1 \0 0\n",
            "line 2: the file is not UTF-8 text",
        ),
    ] {
        let error = mtl::decode_with_warnings(library.as_bytes(), Reading::Strict);
        assert_eq!(error.unwrap_err().to_string(), message);
        let text = format!("{TRIANGLES}mtllib a.mtl\nf 1 2 3\n");
        let open = |_: &str| Ok(library.into());
        let error = obj::decode_with_libraries(text.as_bytes(), Reading::Strict, open);
        assert_eq!(
            error.unwrap_err().to_string(),
            format!("line 5: a.mtl: {message}")
        );
    }
    let text = format!("{TRIANGLES}mtllib a.mtl\nf 1 2 3\n");
    let denied = |_: &str| Err(io::ErrorKind::PermissionDenied.into());
    let error = obj::decode_with_libraries(text.as_bytes(), Reading::Tolerant, denied).unwrap_err();
    assert_eq!(
        error.to_string(),
        "line 5: cannot read a.mtl: permission denied"
    );
}

/// A line for a picture does not make the shape unreadable.
#[test]
fn faults_of_pictures_are_warnings() {
    let nothing = "a map_Kd line ends with the path of a picture, but this one has none";
    for (line, path, message) in [
        ("map_Kd", None, nothing),
        ("map_Kd -clamp on", None, nothing),
        (
            "map_Kd -wrap on a.png",
            Some("a.png"),
            "map_Kd has no option -wrap",
        ),
        (
            "map_Kd -colorspace sRGB -s 2 2 my brick.png",
            Some("my brick.png"),
            "map_Kd has no option -colorspace",
        ),
        ("map_Kd -x a.png", Some("a.png"), "map_Kd has no option -x"),
    ] {
        let library = format!("newmtl red\n{line}\nKd 1 0 0\n");
        let (mesh, warnings) = load("mtllib a.mtl\nusemtl red\nf 1 2 3\n", &library);
        let [red] = mesh.materials() else {
            panic!("{:?}", mesh.materials())
        };
        assert_eq!(red.base_colour, [1.0, 0.0, 0.0, 1.0]);
        let image = path.map(|path| Image::File(path.to_owned()));
        let texture = red.base_colour_texture.as_ref();
        assert_eq!(texture.map(|texture| texture.image.clone()), image);
        let sentences: Vec<String> = warnings.iter().map(ToString::to_string).collect();
        let expected = format!("a.mtl: line 2: {message}; this is ignored");
        assert_eq!(sentences, [expected]);
    }
}

#[test]
fn faces_have_the_materials_of_the_libraries() {
    let library = "newmtl unused\nnewmtl red\nKd 1 0 0\n";
    let text =
        "mtllib a.mtl\nf 1 2 3\nusemtl red\nf 1 2 4\nusemtl (null)\nf 1 3 4\nusemtl red\nf 2 3 4\n";
    let (mesh, warnings) = load(text, library);
    assert_eq!(warnings, []);
    let names: Vec<&str> = mesh.materials().iter().map(|m| &m.name[..]).collect();
    assert_eq!(names, ["unused", "red"]);
    assert_eq!(mesh.face_materials(), [None, Some(1), None, Some(1)]);
    let (spaced, warnings) = load("mtllib two words.mtl\nusemtl red\nf 1 2 3\n", library);
    assert_eq!(warnings, []);
    assert_eq!(spaced.material(0).unwrap().base_colour[1], 0.0);
    let (several, warnings) = load("mtllib a.mtl missing.mtl\nusemtl red\nf 1 2 3\n", library);
    assert_eq!(
        warnings,
        [Warning::MissingLibrary {
            line: 5,
            library: "missing.mtl".into()
        }]
    );
    assert_eq!(several.material(0).unwrap().base_colour[1], 0.0);
}

#[test]
fn what_is_missing_is_the_default_and_said() {
    let (mesh, warnings) = load("mtllib no.mtl\nusemtl red\nf 1 2 3\n", "");
    assert_eq!(mesh.materials(), [Material::named("red")]);
    let sentences: Vec<String> = warnings.iter().map(ToString::to_string).collect();
    assert_eq!(
        sentences,
        [
            "line 5: the file no.mtl does not exist; its materials have the default appearance",
            "line 6: no library defines the material \"red\"; it has the default appearance",
        ]
    );
    let (zero, warnings) = load("vn 0 0 0\nvn 0 0 2\nvn 0 3 0\nf 1//1 2//2 3//3\n", "");
    assert_eq!(warnings, [Warning::ZeroNormals { line: 5, count: 1 }]);
    let normals = zero.normals().unwrap();
    assert_eq!(normals.get(0), None);
    assert_eq!(normals.get(1), Some(&Vector::new(0.0, 0.0, 1.0)));
    assert_eq!(normals.get(2), Some(&Vector::new(0.0, 1.0, 0.0)));
}

#[test]
fn lines_and_points_are_read_and_checked() {
    let (mesh, _) = load("l 1 2/1 -1\np 2 3\nvt 0 0\np 4\n", "");
    assert!(mesh.polylines().iter().eq([&[0, 1, 3][..]]));
    assert_eq!(mesh.points(), [1, 2, 3]);
    assert!(mesh.faces().is_empty());
    for (line, message) in [
        (
            "l 1",
            "line 5: a line has at least 2 vertices, but this one has 1",
        ),
        (
            "l 1 2//1",
            "line 5: \"2//1\" is not a vertex of a line (v or v/vt)",
        ),
        (
            "l 1 2\n\nl 1 5",
            "line 7: \"5\" refers to v 5, but there are 4",
        ),
        ("p 1/1", "line 5: \"1/1\" is not the index of a vertex"),
        (
            "p 1 2\np 3 5",
            "line 6: \"5\" refers to v 5, but there are 4",
        ),
        ("p 0", "line 5: \"0\" refers to v 0, but there are 4"),
    ] {
        let text = format!("{TRIANGLES}{line}\n");
        let nothing = |_: &str| Err(io::ErrorKind::NotFound.into());
        let error = obj::decode_with_libraries(text.as_bytes(), Reading::Strict, nothing);
        assert_eq!(error.unwrap_err().to_string(), message);
    }
}

fn group(name: &str, faces: &[u32]) -> Group {
    Group {
        name: name.into(),
        faces: faces.to_vec(),
    }
}

/// A mesh with everything that OBJ and MTL can hold.
fn full_mesh() -> Mesh {
    let positions = vec![[0.0; 3], [1.0, 0.0, 0.0], [1.0, 1.0, 0.1], [0.0, 1.0, 1e-7]];
    let faces = Faces::from_polygons([&[0, 1, 2][..], &[0, 2, 3], &[0, 1, 2, 3]]).unwrap();
    let mut placed = Texture::new(Image::Embedded {
        media_type: "image/jpeg".into(),
        bytes: Arc::from(&b"not really a picture"[..]),
    });
    placed.offset = [0.25, 0.5];
    let glass = Material {
        base_colour: [0.1, 0.2, 0.3, 0.5],
        base_colour_texture: Some(placed.clone()),
        metallic: 0.125,
        roughness: 0.3,
        metallic_roughness_texture: Some(Texture::file("maps/orm.png")),
        normal_texture: Some(Texture::file("n.png")),
        normal_scale: 0.75,
        emissive: [0.0, 4.0, 0.0],
        emissive_texture: Some(placed),
        alpha_mode: AlphaMode::Blend,
        phong: Some(Phong {
            specular: [0.9; 3],
            exponent: 12.0,
            opacity_texture: Some(Texture::file("d.png")),
            ..Phong::default()
        }),
        ..Material::named("glass")
    };
    let unlit = Material {
        unlit: true,
        phong: Some(Phong {
            illumination: Some(0),
            ..Phong::default()
        }),
        ..Material::named("sign")
    };
    Mesh::new(positions, faces)
        .and_then(|mesh| {
            mesh.with_colours(vec![
                [1.0, 0.0, 1.0, 1.0],
                [0.0, 1.0, 0.0, 1.0],
                [0.25, 0.5, 0.7, 1.0],
                [0.001, 0.1, 0.9, 1.0],
            ])
        })
        .and_then(|mesh| {
            mesh.with_normals(CornerAttribute {
                values: vec![Vector::new(0.0, 0.6, 0.8), Vector::new(0.0, 0.0, -1.0)],
                corners: (0..10).map(|c| (c != 4).then_some(c % 2)).collect(),
            })
        })
        .and_then(|mesh| {
            mesh.with_texture_coordinates(vec![CornerAttribute {
                values: vec![[0.1, 0.2], [0.3, 0.4]],
                corners: (0..10).map(|c| (c < 6).then_some(c / 3)).collect(),
            }])
        })
        .and_then(|mesh| mesh.with_groups(vec![group("a", &[0, 1]), group("b", &[1])]))
        .and_then(|mesh| mesh.with_objects(vec![group("left", &[0]), group("right", &[2])]))
        .and_then(|mesh| mesh.with_materials(vec![glass, unlit], vec![Some(1), None, Some(0)]))
        .and_then(|mesh| mesh.with_polylines(Polylines::from_lines([[3, 0, 1]]).unwrap()))
        .and_then(|mesh| mesh.with_points(vec![2, 2]))
        .unwrap()
}

#[test]
fn a_mesh_with_everything_comes_back_the_same() {
    let mesh = full_mesh();
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("full.obj");
    obj::write(&path, &mesh).unwrap();
    for picture in ["d.png", "n.png", "maps/orm.png"] {
        std::fs::create_dir_all(folder.path().join("maps")).unwrap();
        std::fs::write(folder.path().join(picture), b"").unwrap();
    }
    let (back, warnings) = obj::read_with_warnings(&path, Reading::Tolerant).unwrap();
    assert_eq!(warnings, []);

    let embedded = std::fs::read(folder.path().join("full-1.jpg")).unwrap();
    assert_eq!(embedded, b"not really a picture");
    // Embedded images come back as files.
    let mut materials = mesh.materials().to_vec();
    for texture in materials.iter_mut().flat_map(Material::textures_mut) {
        if matches!(texture.image, Image::Embedded { .. }) {
            texture.image = Image::File("full-1.jpg".into());
        }
    }
    let of_faces = mesh.face_materials().to_vec();
    let expected = mesh.clone().with_materials(materials, of_faces).unwrap();
    for (back, colour) in back.colours().unwrap().iter().zip(mesh.colours().unwrap()) {
        assert!(back.iter().zip(colour).all(|(a, b)| (a - b).abs() < 1e-13));
    }
    let colours = mesh.colours().unwrap().to_vec();
    assert_eq!(back.with_colours(colours).unwrap(), expected);
}

/// Names that OBJ cannot hold stay different from one another.
#[test]
fn names_become_different_words() {
    let named = |names: [&str; 4]| names.map(Material::named).to_vec();
    let (mesh, _) = load("f 1 2 3\nf 1 2 4\nf 1 3 4\nf 2 3 4\n", "");
    let of_faces = || (0..4).map(Some).collect();
    let mesh = mesh
        .with_materials(named(["a b", "a_b", "(null)", ""]), of_faces())
        .unwrap();
    let back = obj::decode(obj::encode(&mesh).as_bytes()).unwrap();
    let names: Vec<&str> = back.materials().iter().map(|m| &m.name[..]).collect();
    assert_eq!(names, ["a b", "a_b", "(null)_2", "_"]);
    let mesh = mesh
        .with_materials(named(["a  b", "a #b ", "a #b ", "a\tb"]), of_faces())
        .unwrap();
    let back = obj::decode(obj::encode(&mesh).as_bytes()).unwrap();
    let names: Vec<&str> = back.materials().iter().map(|m| &m.name[..]).collect();
    assert_eq!(names, ["a _ b", "a _b _", "a _b __2", "a_b"]);
    // `g` takes several names, `o` one.
    let set = |name: &str| Group {
        name: name.to_owned(),
        faces: vec![0, 1, 2, 3],
    };
    let mesh = mesh
        .with_objects(vec![set("left hand")])
        .and_then(|mesh| mesh.with_groups(vec![set("left hand")]))
        .unwrap();
    let back = obj::decode(obj::encode(&mesh).as_bytes()).unwrap();
    assert_eq!(back.objects()[0].name, "left hand");
    assert_eq!(back.groups()[0].name, "left_hand");
}

#[test]
fn files_beside_the_mesh_have_names_that_lines_can_hold() {
    let folder = tempfile::tempdir().unwrap();
    let image = Image::Embedded {
        media_type: "image/png".into(),
        bytes: Arc::from(&b"png"[..]),
    };
    let paint = Material {
        base_colour: [1.0, 0.0, 0.0, 1.0],
        base_colour_texture: Some(Texture::new(image)),
        ..Material::named("paint")
    };
    let (mesh, _) = load("f 1 2 3\n", "");
    let mesh = mesh.with_materials(vec![paint], vec![Some(0)]).unwrap();
    for name in ["a #1.obj", "-s 1.obj", "two  words.obj", " x.obj"] {
        let path = folder.path().join(name);
        obj::write(&path, &mesh).unwrap();
        let (mesh, warnings) = obj::read_with_warnings(&path, Reading::Tolerant).unwrap();
        assert_eq!(warnings, [], "{name}");
        let paint = mesh.material(0).unwrap();
        assert_eq!(paint.base_colour, [1.0, 0.0, 0.0, 1.0], "{name}");
        assert!(paint.base_colour_texture.is_some(), "{name}");
    }
}

/// MTL cannot rotate a texture and has one set of texture coordinates.
#[test]
fn textures_that_mtl_cannot_place_are_left_out() {
    let material = Material {
        base_colour_texture: Some(Texture {
            rotation: 0.5,
            offset: [0.25, 0.5],
            ..Texture::file("rotated.png")
        }),
        emissive_texture: Some(Texture {
            set: 1,
            ..Texture::file("second.png")
        }),
        normal_texture: Some(Texture::file("plain.png")),
        ..Material::default()
    };
    let text = mtl::encode([("a", &material)], |image| match image {
        Image::File(path) => path.clone(),
        Image::Embedded { .. } => String::new(),
    });
    let back = mtl::decode(text.as_bytes()).unwrap();
    let images: Vec<_> = back[0].textures().map(|texture| &texture.image).collect();
    let plain = Image::File("plain.png".into());
    assert_eq!(images, [&plain], "{text}");
}

#[test]
fn a_missing_picture_is_said() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("a.obj");
    std::fs::write(
        &path,
        format!("{TRIANGLES}mtllib a.mtl\nusemtl m\nf 1 2 3\n"),
    )
    .unwrap();
    std::fs::write(
        folder.path().join("a.mtl"),
        "newmtl m\nmap_Kd no.png\nmap_Ke no.png\n",
    )
    .unwrap();
    let (_, warnings) = obj::read_with_warnings(&path, Reading::Tolerant).unwrap();
    let sentences: Vec<String> = warnings.iter().map(ToString::to_string).collect();
    assert_eq!(
        sentences,
        ["material \"m\": there is no picture no.png; the surface is shown without it"]
    );
    // Faults of libraries name the OBJ file as well.
    std::fs::write(folder.path().join("a.mtl"), "newmtl m\nNs x\n").unwrap();
    assert_eq!(
        obj::read(&path).unwrap_err().to_string(),
        format!(
            "{}: line 5: a.mtl: line 2: \"x\" is not a number",
            path.display()
        )
    );
}
