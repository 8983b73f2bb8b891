//! Texture coordinates and the painted texture.

use ga_image::quality::mse;
use ga_image::resample::{Method, resize};

use crate::{HUMAN, positions};

/// Where the vertex nearest to a place lies in a texture of this side: column and row.
fn texel(place: [f64; 3], size: usize) -> (usize, usize) {
    let positions = positions();
    let triangles = HUMAN.mesh.triangles();
    let distance = |p: [f64; 3]| (0..3).map(|k| (p[k] - place[k]).powi(2)).sum::<f64>();
    let (face, corner) = (0..triangles.len())
        .flat_map(|face| [0, 1, 2].map(|corner| (face, corner)))
        .min_by(|a, b| {
            let at = |&(face, corner): &(usize, usize)| {
                distance(positions[triangles[face][corner] as usize])
            };
            at(a).total_cmp(&at(b))
        })
        .unwrap();
    let coordinates = HUMAN.mesh.texture_coordinates().unwrap();
    let [u, v] = *coordinates.get(3 * face + corner).unwrap();
    let index = |t: f64| ((t * size as f64) as usize).min(size - 1);
    (index(u), index(1.0 - v))
}

#[test]
fn texture_coordinates_lie_in_the_unit_square_and_no_triangle_is_folded() {
    let coordinates = HUMAN.mesh.texture_coordinates().unwrap();
    let triangles = HUMAN.mesh.triangles();
    assert_eq!(coordinates.corners.len(), 3 * triangles.len());
    let mut covered = 0.0;
    for face in 0..triangles.len() {
        let [a, b, c] = [0, 1, 2].map(|corner| *coordinates.get(3 * face + corner).unwrap());
        assert!([a, b, c].iter().flatten().all(|t| (0.0..=1.0).contains(t)));
        let area = 0.5 * ((b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]));
        assert!(area > 0.0, "face {face}");
        covered += area;
    }
    assert!((0.45..1.0).contains(&covered), "{covered}");
}

#[test]
fn hair_is_dark_skin_is_light_and_clothes_have_their_colours() {
    let size = 512;
    let texture = HUMAN.texture(size);
    let at = |place| {
        let (column, row) = texel(place, size);
        texture.get(column, row).unwrap().map(i32::from)
    };
    let brightness = |[r, g, b]: [i32; 3]| (r + g + b) / 3;
    let forehead = at([0.0, 1.69, 0.1]);
    assert!(
        brightness(forehead) > 120 && forehead[0] > forehead[2] + 30,
        "{forehead:?}"
    );
    assert!(brightness(at([0.0, 1.75, -0.02])) < 90);
    assert!(brightness(at([0.0, 1.66, -0.1])) < 90);
    // The middle of the eye is dark, the hand has the colour of skin, denim is blue.
    assert!(brightness(at([0.032, 1.64, 0.1])) < 130);
    let hand = at([0.62, 0.90, 0.0]);
    assert!(hand[0] > hand[2] + 30, "{hand:?}");
    let leg = at([0.1, 0.7, 0.08]);
    assert!(leg[2] > leg[0] && brightness(leg) < 110, "{leg:?}");
}

/// A larger texture shows the same with more detail, and the same at every call.
#[test]
fn the_texture_does_not_depend_on_its_size() {
    let small = HUMAN.texture(128);
    assert!(small == HUMAN.texture(128));
    let shrunk = resize(&HUMAN.texture(512), 128, 128, Method::Area).unwrap();
    let difference = mse(&small, &shrunk).unwrap();
    assert!(difference < 900.0, "{difference}");
    assert!(HUMAN.texture(0).is_empty());
}
