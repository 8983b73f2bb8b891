use ga_character::{Figure, model};
use ga_image::picture::Picture;
use ga_mesh::gltf::decode;
use ga_mesh::obj;

use super::{character, journey, painted};

#[test]
fn a_figure_without_paint_is_two_files() {
    let clip = journey(0.5, &[[0.0; 3], [1.0, 0.0, 0.0]]);
    let (files, losses) = model::files(&Figure::new("square", character()), &clip, "go").unwrap();
    assert!(losses.is_empty());
    let names: Vec<&str> = files.iter().map(|file| file.name).collect();
    assert_eq!(names, ["model.obj", "model.glb"]);
    for file in &files {
        assert_eq!((file.vertices, file.pixels), (Some(4), None));
    }
    let mesh = obj::decode(&files[0].contents).unwrap();
    let places: Vec<[f64; 3]> = mesh.coordinates().collect();
    assert_eq!(places, character().mesh.coordinates().collect::<Vec<_>>());
    let document = decode(&files[1].contents).unwrap();
    assert!(document.images.is_empty() && document.textures.is_empty());
    assert_eq!(document.animations[0].name.as_deref(), Some("go"));
    let primitive = &document.meshes[0].primitives[0];
    assert_eq!(primitive.positions.len(), 4);
    assert_eq!(document.meshes[0].name.as_deref(), Some("square"));
    for normal in &primitive.normals {
        assert_eq!(*normal, [0.0, 0.0, 1.0]);
    }
}

#[test]
fn a_painted_figure_has_a_material_and_a_picture_in_both_formats() {
    let figure = painted();
    let (files, _) = model::files(&figure, &journey(0.5, &[[0.0; 3]]), "still").unwrap();
    let names: Vec<&str> = files.iter().map(|file| file.name).collect();
    assert_eq!(names, model::NAMES);
    assert_eq!(files[3].pixels, Some([2, 1]));
    assert_eq!(files[0].vertices, Some(4));
    let Picture::Rgb8(picture) = ga_image::png::decode(&files[3].contents).unwrap() else {
        panic!("three bytes a pixel")
    };
    assert_eq!(&picture, figure.paint.as_ref().unwrap());
    let library = std::str::from_utf8(&files[2].contents).unwrap();
    assert!(library.contains("newmtl skin"), "{library}");
    assert!(library.contains("skin.png"), "{library}");
    let text = std::str::from_utf8(&files[0].contents).unwrap();
    assert!(text.contains("mtllib model.mtl") && text.contains("usemtl skin"));

    let document = decode(&files[1].contents).unwrap();
    let [mesh] = &document.meshes[..] else {
        panic!("one mesh")
    };
    let primitive = &mesh.primitives[0];
    let material = &document.materials[primitive.material.unwrap()];
    assert_eq!(material.name.as_deref(), Some("skin"));
    assert!((material.roughness - 0.8).abs() < 1e-6);
    let texture = &document.textures[material.base_colour_texture.as_ref().unwrap().texture];
    let sampler = &document.samplers[texture.sampler.unwrap()];
    assert_eq!(sampler.wrap_u, ga_mesh::Wrap::ClampToEdge);
    assert_eq!(sampler.wrap_v, ga_mesh::Wrap::ClampToEdge);
    assert_eq!(sampler.magnification, Some(ga_mesh::Filter::Linear));
    let smaller = sampler.minification.unwrap();
    assert_eq!(smaller.filter, ga_mesh::Filter::Linear);
    assert_eq!(smaller.levels, Some(ga_mesh::Filter::Linear));
    let ga_mesh::gltf::ImageSource::Bytes { media_type, bytes } =
        &document.images[texture.image.unwrap()].source
    else {
        panic!("the picture is in the file")
    };
    assert_eq!(media_type, "image/png");
    assert_eq!(bytes, &files[3].contents);

    // Each corner of the triangles has its place and, with v down, its texture coordinates.
    let indices = primitive.indices.as_ref().unwrap();
    let mesh = &figure.character.mesh;
    let places: Vec<[f64; 3]> = mesh.coordinates().collect();
    let coordinates = mesh.texture_coordinates().unwrap();
    assert_eq!(indices.len(), 6);
    assert_eq!(primitive.positions.len(), 6);
    for (corner, &index) in indices.iter().enumerate() {
        let place = places[mesh.faces().corners()[corner] as usize];
        assert_eq!(primitive.positions[index as usize], place.map(|x| x as f32));
        let [u, v] = coordinates.values[corner];
        assert_eq!(
            primitive.texcoords[0][index as usize],
            [u as f32, (1.0 - v) as f32]
        );
    }
}
