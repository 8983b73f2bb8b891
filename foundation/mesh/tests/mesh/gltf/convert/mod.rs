//! Between documents and meshes.

mod scene;

use ga_files::Reading;
use ga_mesh::gltf::{
    self as ours, Document, Node, Primitive, TextureInfo, TextureTransform, Vertices, read_mesh,
    write_mesh,
};
use ga_mesh::topology::Report;
use ga_mesh::{
    CornerAttribute, Faces, Group, Image, Material, Mesh, Normals, Polylines, Texture, format,
};
use ga_runtime::vga3::Vector;

/// A cube of side 2 with a normal for each face, a picture on each and a colour at each vertex. The
/// first five faces are one object, the last is another with a material.
fn cube() -> Mesh {
    let corner =
        |index: usize| [0, 1, 2].map(|axis| if index >> axis & 1 == 1 { 1.0 } else { -1.0 });
    let faces = [
        [0, 4, 6, 2],
        [1, 3, 7, 5],
        [0, 1, 5, 4],
        [2, 6, 7, 3],
        [0, 2, 3, 1],
        [4, 5, 7, 6],
    ];
    let directions = [
        [-1, 0, 0],
        [1, 0, 0],
        [0, -1, 0],
        [0, 1, 0],
        [0, 0, -1],
        [0, 0, 1],
    ];
    let normals = Normals {
        values: directions.map(|d| Vector::from(d.map(f64::from))).to_vec(),
        corners: (0..24).map(|corner| Some(corner / 4)).collect(),
    };
    let picture = CornerAttribute {
        values: vec![[0.0, 0.0], [1.0, 0.0], [1.0, 0.75], [0.0, 0.75]],
        corners: (0..24).map(|corner| Some(corner % 4)).collect(),
    };
    let group = |name: &str, faces: std::ops::Range<u32>| Group {
        name: name.to_owned(),
        faces: faces.collect(),
    };
    let paint = Material {
        base_colour: [0.5, 0.25, 0.125, 1.0],
        emissive: [4.0, 1.0, 0.0],
        base_colour_texture: Some(Texture::file("a folder/paint.png")),
        ..Material::named("paint")
    };
    Mesh::new(
        (0..8).map(corner).collect(),
        Faces::from_polygons(faces).unwrap(),
    )
    .unwrap()
    .with_normals(normals)
    .unwrap()
    .with_texture_coordinates(vec![picture])
    .unwrap()
    .with_colours(
        (0..8)
            .map(|i| [f64::from(i) / 8.0, 0.5, 1.0, 1.0])
            .collect(),
    )
    .unwrap()
    .with_objects(vec![group("sides", 0..5), group("top", 5..6)])
    .unwrap()
    .with_materials(vec![paint], vec![None, None, None, None, None, Some(0)])
    .unwrap()
}

#[test]
fn vertices_are_split_where_corners_differ() {
    let document = Document::from_mesh(&cube()).unwrap();
    assert_eq!(document.nodes.len(), 2);
    let names: Vec<_> = document
        .nodes
        .iter()
        .map(|node| node.name.as_deref())
        .collect();
    assert_eq!(names, [Some("sides"), Some("top")]);
    let [sides, top] = [0, 1].map(|mesh| &document.meshes[mesh].primitives[0]);
    assert_eq!((sides.positions.len(), top.positions.len()), (20, 4));
    assert_eq!((sides.triangles().len(), top.triangles().len()), (10, 2));
    assert_eq!((sides.material, top.material), (None, Some(0)));
    // The vertices of the top in their order in the cube, with v down.
    let places = [
        [-1.0, -1.0, 1.0],
        [1.0, -1.0, 1.0],
        [-1.0, 1.0, 1.0],
        [1.0, 1.0, 1.0],
    ];
    assert_eq!(top.positions, places);
    assert_eq!(top.normals, [[0.0, 0.0, 1.0]; 4]);
    assert_eq!(
        top.texcoords,
        [[[0.0, 1.0], [1.0, 1.0], [0.0, 0.25], [1.0, 0.25]]]
    );
    assert_eq!(top.colours[0][3], [0.875, 0.5, 1.0, 1.0]);
    let material = &document.materials[0];
    assert_eq!(
        (material.emissive, material.emissive_strength),
        ([1.0, 0.25, 0.0], 4.0)
    );
    let uri = ours::ImageSource::Uri("a%20folder/paint.png".to_owned());
    assert_eq!(document.images[0].source, uri);
}

#[test]
fn a_mesh_comes_back_from_either_file() {
    let cube = cube();
    let folder = tempfile::tempdir().unwrap();
    for name in ["cube.glb", "cube.gltf"] {
        let path = folder.path().join(name);
        write_mesh(&path, &cube).unwrap();
        let again = read_mesh(&path).unwrap();
        assert_eq!(again.materials(), cube.materials());
        assert_eq!(again.vertex_count(), 24);
        assert_eq!(again.objects()[1].faces, [10, 11]);
        assert_eq!(again.objects()[1].name, "top");

        let joined = ours::read(&path)
            .unwrap()
            .to_mesh(Vertices::Merged)
            .unwrap();
        let sorted = |mesh: &Mesh| {
            let mut places: Vec<_> = mesh.coordinates().map(|p| p.map(|c| c as i32)).collect();
            places.sort_unstable();
            places
        };
        assert_eq!(sorted(&joined), sorted(&cube));
        assert_eq!(joined.faces().len(), 12);
        // What the corners of the triangles have is what those of the quadrilaterals had.
        let triangles = cube.triangles();
        for (face, corners) in joined.faces().iter().enumerate() {
            for (index, &vertex) in corners.iter().enumerate() {
                let old = triangles[face][index] as usize;
                assert_eq!(joined.positions()[vertex as usize], cube.positions()[old]);
                assert_eq!(
                    joined.colours().unwrap()[vertex as usize],
                    cube.colours().unwrap()[old]
                );
                let corner = joined.faces().corner_range(face).start + index;
                // Triangle 2 f is corners 0, 1, 2 of face f, the next one corners 0, 2, 3.
                let of_quad = if index == 0 { 0 } else { index + face % 2 };
                let old_corner = 4 * (face / 2) + of_quad;
                let normals = |mesh: &Mesh, corner| mesh.normals().unwrap().get(corner).copied();
                assert_eq!(normals(&joined, corner), normals(&cube, old_corner));
                let picture =
                    |mesh: &Mesh, at| mesh.texture_coordinates().unwrap().get(at).copied();
                assert_eq!(picture(&joined, corner), picture(&cube, old_corner));
            }
        }
    }
}

/// The second triangle has no texture coordinates, which glTF demands of a texture.
#[test]
fn faces_without_texture_coordinates_have_no_texture() {
    let corners = vec![[0.0; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [1.0, 1.0, 0.0]];
    let faces = Faces::from_polygons([[0, 1, 2], [1, 3, 2]]).unwrap();
    let paint = Material {
        base_colour: [0.5, 0.25, 0.125, 1.0],
        base_colour_texture: Some(Texture::file("a.png")),
        ..Material::named("paint")
    };
    let mesh = Mesh::new(corners, faces)
        .and_then(|mesh| mesh.with_materials(vec![paint], vec![Some(0); 2]))
        .and_then(|mesh| {
            mesh.with_texture_coordinates(vec![CornerAttribute {
                values: vec![[0.0, 0.0], [1.0, 0.0], [0.0, 1.0]],
                corners: vec![Some(0), Some(1), Some(2), None, None, None],
            }])
        });
    let document = Document::from_mesh(&mesh.unwrap()).unwrap();
    let primitives = &document.meshes[0].primitives;
    assert_eq!(primitives.len(), 2);
    for primitive in primitives {
        let material = &document.materials[primitive.material.unwrap()];
        let has_texture = material.base_colour_texture.is_some();
        assert_eq!(has_texture, !primitive.texcoords.is_empty());
        assert_eq!(material.base_colour, [0.5, 0.25, 0.125, 1.0]);
        assert_eq!(material.name.as_deref(), Some("paint"));
    }
}

/// A path along the vertices, as edges and as polylines of three vertices.
#[test]
fn many_lines_are_one_primitive() {
    let count = 20_000u32;
    let places: Vec<_> = (0..=count).map(|i| [f64::from(i), 0.0, 0.0]).collect();
    let mesh = Mesh::new(places, Faces::default()).unwrap();
    let edges: Vec<[u32; 2]> = (0..count).map(|i| [i, i + 1]).collect();
    let long: Vec<[u32; 3]> = (0..count / 2)
        .map(|i| [2 * i, 2 * i + 1, 2 * i + 2])
        .collect();
    for lines in [Polylines::from_lines(&edges), Polylines::from_lines(&long)] {
        let mesh = mesh.clone().with_polylines(lines.unwrap()).unwrap();
        let document = Document::from_mesh(&mesh).unwrap();
        let [primitive] = &document.meshes[0].primitives[..] else {
            panic!("{} primitives", document.meshes[0].primitives.len())
        };
        assert_eq!(primitive.positions.len(), 20_001);
        let indices = primitive.indices.as_ref().unwrap();
        assert_eq!(indices.as_chunks::<2>().0, edges);
        let again = document.to_mesh(Vertices::Kept).unwrap();
        assert!(
            again
                .polylines()
                .iter()
                .eq(edges.iter().map(|edge| &edge[..]))
        );
    }
}

/// By any ending of the name the faces are connected, also where their normals differ.
#[test]
fn a_cube_is_one_component() {
    let cube = cube();
    let folder = tempfile::tempdir().unwrap();
    for name in ["cube.glb", "cube.gltf", "cube.obj"] {
        let path = folder.path().join(name);
        format::write(&path, &cube, &format::Options::default()).unwrap();
        let (again, _) = format::read(&path, Reading::Tolerant).unwrap();
        let report = Report::of_mesh(&again);
        assert_eq!((report.vertices, report.components), (8, 1), "{name}");
        assert!(report.is_closed(), "{name}");
        assert_eq!(report.genus, Some(0), "{name}");
        // Three different normals meet at every vertex.
        let mut at_vertices = vec![Vec::new(); 8];
        for (corner, &vertex) in again.faces().corners().iter().enumerate() {
            let normal = again.normals().unwrap().get(corner).unwrap().coordinates();
            if !at_vertices[vertex as usize].contains(&normal) {
                at_vertices[vertex as usize].push(normal);
            }
        }
        assert!(at_vertices.iter().all(|normals| normals.len() == 3));
    }
}

/// Corners without an attribute stay without it.
#[test]
fn faces_without_attributes_are_a_primitive_of_their_own() {
    let cube = cube();
    let mut normals = cube.normals().unwrap().clone();
    normals.corners[5] = None;
    let document = Document::from_mesh(&cube.with_normals(normals).unwrap()).unwrap();
    let sides = &document.meshes[0].primitives;
    let triangles: Vec<usize> = sides.iter().map(|p| p.triangles().len()).collect();
    let has_normals: Vec<bool> = sides.iter().map(|p| !p.normals.is_empty()).collect();
    assert_eq!((triangles, has_normals), (vec![2, 8], vec![false, true]));
    assert_eq!(sides[0].texcoords.len(), 1);
}

#[test]
fn strips_fans_lines_and_points_are_taken_apart() {
    use ours::Mode::*;
    let positions: Vec<[f32; 3]> = (0..5u8)
        .map(|i| [f32::from(i), f32::from(i % 2), 0.0])
        .collect();
    let primitive = |mode| Primitive {
        mode,
        positions: positions.clone(),
        ..Primitive::default()
    };
    assert_eq!(
        primitive(TriangleStrip).triangles(),
        [[0, 1, 2], [1, 3, 2], [2, 3, 4]]
    );
    assert_eq!(
        primitive(TriangleFan).triangles(),
        [[1, 2, 0], [2, 3, 0], [3, 4, 0]]
    );
    assert_eq!(primitive(Triangles).triangles(), [[0, 1, 2]]);
    let document = Document {
        nodes: vec![Node {
            mesh: Some(0),
            ..Node::default()
        }],
        meshes: vec![ours::Mesh {
            primitives: [Points, Lines, LineLoop, LineStrip].map(primitive).to_vec(),
            ..ours::Mesh::default()
        }],
        ..Document::default()
    };
    let mesh = document.to_mesh(Vertices::Merged).unwrap();
    assert_eq!(mesh.points(), [0, 1, 2, 3, 4]);
    let lines: Vec<&[u32]> = mesh.polylines().iter().collect();
    let expected: [&[u32]; 4] = [&[0, 1], &[2, 3], &[0, 1, 2, 3, 4, 0], &[0, 1, 2, 3, 4]];
    assert_eq!(lines, expected);

    let polylines = Polylines::from_lines(expected).unwrap();
    let again = Document::from_mesh(&mesh.clone().with_polylines(polylines).unwrap()).unwrap();
    assert_eq!(again.to_mesh(Vertices::Merged).unwrap(), mesh);
}

/// The place on the picture is the same by either convention: that of `KHR_texture_transform`,
/// worked out here as its text has it, and that of [`Texture`].
#[test]
fn transforms_of_textures_change_with_the_direction_of_v() {
    for (offset, rotation, scale) in [
        ([0.0f32, 0.0], 0.0f32, [1.0f32, 1.0]),
        ([0.25, 0.5], 0.0, [2.0, 0.5]),
        ([0.1, -0.3], 0.7, [1.5, 0.25]),
    ] {
        let transform = TextureTransform {
            offset,
            rotation,
            scale,
            texcoord: Some(1),
        };
        let document = Document {
            materials: vec![ours::MaterialElement {
                base_colour_texture: Some(TextureInfo {
                    texture: 0,
                    texcoord: 0,
                    transform: Some(transform),
                }),
                ..ours::MaterialElement::default()
            }],
            textures: vec![ours::TextureElement {
                image: Some(0),
                ..ours::TextureElement::default()
            }],
            images: vec![ours::Image {
                name: None,
                source: ours::ImageSource::Uri("a.png".to_owned()),
                extras: None,
            }],
            ..Document::default()
        };
        let mesh = document.to_mesh(Vertices::Kept).unwrap();
        let texture = mesh.materials()[0].base_colour_texture.clone().unwrap();
        assert_eq!(texture.set, 1);
        assert_eq!(texture.image, Image::File("a.png".to_owned()));
        for [u, v] in [[0.0, 0.0], [0.2, 0.9], [-1.5, 0.3]] {
            // In glTF: scale, then rotate by the matrix ((cos, sin), (−sin, cos)), then offset.
            let (sine, cosine) = f64::from(rotation).sin_cos();
            let [x, y] = [f64::from(scale[0]) * u, f64::from(scale[1]) * (1.0 - v)];
            let expected = [
                cosine * x + sine * y + f64::from(offset[0]),
                1.0 - (-sine * x + cosine * y + f64::from(offset[1])),
            ];
            // Here: scale, rotate counter-clockwise, offset.
            let (sine, cosine) = texture.rotation.sin_cos();
            let [x, y] = [texture.scale[0] * u, texture.scale[1] * v];
            let found = [
                cosine * x - sine * y + texture.offset[0],
                sine * x + cosine * y + texture.offset[1],
            ];
            for axis in 0..2 {
                assert!((found[axis] - expected[axis]).abs() < 1e-12);
            }
        }
        let again = Document::from_mesh(&mesh).unwrap();
        let found = again.materials[0].base_colour_texture.unwrap();
        assert_eq!(found.texcoord, 1);
        let found = found.transform.unwrap_or_default();
        assert_eq!((found.rotation, found.scale), (rotation, scale));
        for (found, offset) in found.offset.into_iter().zip(offset) {
            assert!((found - offset).abs() < 1e-6);
        }
    }
}
