//! Written meshes, read back by this crate and by tobj.

use ga_mesh::{CornerAttribute, Faces, Group, Mesh, obj};
use proptest::collection::vec;
use proptest::prelude::*;

use super::{faces_by_tobj, faces_of};

pub(super) fn meshes() -> impl Strategy<Value = Mesh> {
    let coordinate = prop_oneof![
        4 => -10.0..10.0f64,
        1 => any::<f64>().prop_filter("finite", |x| x.is_finite()),
    ];
    let positions = vec(proptest::array::uniform3(coordinate), 3..20);
    (positions, 1usize..12, 1usize..6).prop_flat_map(|(positions, faces, coordinates)| {
        let vertices = positions.len() as u32;
        let corner = (0..vertices, proptest::option::of(0..coordinates as u32));
        let group = vec(0..faces as u32, 1..=faces);
        (
            Just(positions),
            vec(vec(corner, 3..7), faces),
            vec(proptest::array::uniform2(0.0..1.0f64), coordinates),
            vec(group, 0..4),
        )
            .prop_map(|(positions, polygons, coordinates, groups)| {
                let vertices = polygons
                    .iter()
                    .map(|face| face.iter().map(|corner| corner.0).collect::<Vec<_>>());
                let corners = polygons.iter().flatten().map(|corner| corner.1).collect();
                let named = |(index, faces)| Group {
                    name: format!("group{index}"),
                    faces,
                };
                Mesh::new(positions, Faces::from_polygons(vertices).unwrap())
                    .and_then(|mesh| {
                        mesh.with_texture_coordinates(vec![CornerAttribute {
                            values: coordinates,
                            corners,
                        }])
                    })
                    .and_then(|mesh| {
                        mesh.with_groups(groups.into_iter().enumerate().map(named).collect())
                    })
                    .unwrap()
            })
    })
}

proptest! {
    #[test]
    fn a_written_mesh_reads_back_the_same(mesh in meshes()) {
        let back = obj::decode(obj::encode(&mesh).as_bytes()).unwrap();
        let by_name = |mesh: &Mesh| {
            let mut groups = mesh.groups().to_vec();
            groups.sort_by(|a, b| a.name.cmp(&b.name));
            groups
        };
        // Groups come back in the order in which faces use them.
        prop_assert_eq!(by_name(&back), by_name(&mesh));
        prop_assert_eq!(back.with_groups(vec![]).unwrap(), mesh.with_groups(vec![]).unwrap());
    }

    #[test]
    fn tobj_sees_the_same_faces(mesh in meshes()) {
        let mesh = mesh.with_positions(
            mesh.coordinates().map(|x| x.map(|x| f64::from((x.clamp(-1e30, 1e30)) as f32))).collect(),
        ).unwrap();
        let mut text = String::new();
        for line in obj::encode(&mesh).lines() {
            // tobj wants texture coordinates at all corners of a face or at none.
            let words: Vec<_> = line.split(' ').collect();
            let bare = |word: &str| word.split('/').next().unwrap().to_owned();
            if words[0] == "f" && words[1..].iter().any(|word| !word.contains('/')) {
                text += &words.iter().map(|word| bare(word)).collect::<Vec<_>>().join(" ");
            } else {
                text += line;
            }
            text.push('\n');
        }
        let ours = obj::decode(text.as_bytes()).unwrap();
        prop_assert_eq!(faces_of(&ours), faces_by_tobj(text.as_bytes()));
    }

    #[test]
    fn indices_from_the_end_mean_the_same(mesh in meshes()) {
        let text = obj::encode(&mesh);
        let coordinates = mesh.texture_coordinates().unwrap().values.len() as i64;
        let mut from_the_end = String::new();
        for line in text.lines() {
            let mut words = line.split(' ');
            if let Some("f") = words.next() {
                from_the_end.push('f');
                for corner in words {
                    let indices: Vec<i64> = corner.split('/').map(|index| index.parse().unwrap()).collect();
                    from_the_end += &format!(" {}", indices[0] - mesh.vertex_count() as i64 - 1);
                    if let Some(index) = indices.get(1) {
                        from_the_end += &format!("/{}", index - coordinates - 1);
                    }
                }
            } else {
                from_the_end += line;
            }
            from_the_end += "\r\n";
        }
        prop_assert_eq!(obj::decode(from_the_end.as_bytes()), obj::decode(text.as_bytes()));
    }

    #[test]
    fn no_bytes_make_it_panic(bytes in vec(any::<u8>(), 0..200)) {
        let _ = obj::decode(&bytes);
    }

    #[test]
    fn no_damage_makes_it_panic_or_yield_a_bad_mesh(
        mesh in meshes(),
        damage in vec((any::<prop::sample::Index>(), any::<u8>()), 1..4),
    ) {
        let mut text = obj::encode(&mesh).into_bytes();
        for (place, byte) in damage {
            let place = place.index(text.len());
            text[place] = byte;
        }
        if let Ok(mesh) = obj::decode(&text) {
            prop_assert!(mesh.coordinates().flatten().all(f64::is_finite));
            prop_assert!(mesh.faces().corners().iter().all(|&v| (v as usize) < mesh.vertex_count()));
        }
    }
}
