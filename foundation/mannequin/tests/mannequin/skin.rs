//! Texture coordinates and the painted texture.

use ga_image::quality::mse;
use ga_image::resample::{Method, resize};

use crate::{HUMAN, positions};

/// Where the vertex nearest to a place lies in a texture of this side: column and row.
pub(crate) fn texel(place: [f64; 3], size: usize) -> (usize, usize) {
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

/// The figures that an atlas of any surface is made for; a test of ga-mesh compares them with those
/// of code of its own.
#[test]
fn the_skin_has_an_atlas_that_uses_the_texture_well() {
    let options = ga_mesh::atlas::Options::default();
    let atlas = ga_mesh::atlas::unwrap(&positions(), &HUMAN.mesh.triangles(), &options).unwrap();
    let report = atlas.report;
    assert_eq!((report.flipped, report.overlapping_texels), (0, 0));
    assert!(report.charts <= 200, "{} charts", report.charts);
    assert!(report.stretch_l2 <= 1.1, "stretch {}", report.stretch_l2);
    assert!(
        report.utilisation >= 0.55,
        "utilisation {}",
        report.utilisation
    );
}

/// The mean difference of colours on both sides of the seams of the atlas, where the texture is
/// read between texels in a copy that is `reduction` times smaller.
fn difference_at_seams(size: usize, reduction: usize) -> f64 {
    let texture = HUMAN.texture(size);
    let small = size / reduction;
    let texture = resize(&texture, small, small, Method::Area).unwrap();
    let read = |[u, v]: [f64; 2]| -> [f64; 3] {
        let [x, y] = [u, 1.0 - v].map(|t| t * small as f64 - 0.5);
        let (i, j) = (x.floor(), y.floor());
        let texel = |di: f64, dj: f64| {
            let index = |t: f64| t.clamp(0.0, small as f64 - 1.0) as usize;
            texture
                .get(index(i + di), index(j + dj))
                .unwrap()
                .map(f64::from)
        };
        std::array::from_fn(|c| {
            let row = |dj: f64| texel(0.0, dj)[c] * (1.0 - x + i) + texel(1.0, dj)[c] * (x - i);
            row(0.0) * (1.0 - y + j) + row(1.0) * (y - j)
        })
    };
    let coordinates = HUMAN.mesh.texture_coordinates().unwrap();
    let middle = |face: usize, side: usize| {
        let [a, b] =
            [side, (side + 1) % 3].map(|corner| *coordinates.get(3 * face + corner).unwrap());
        [0, 1].map(|axis| 0.5 * (a[axis] + b[axis]))
    };
    let mut of_edge = std::collections::HashMap::new();
    let (mut sum, mut count) = (0.0, 0.0);
    for (face, triangle) in HUMAN.mesh.triangles().iter().enumerate() {
        for side in 0..3 {
            let [a, b] = [triangle[side], triangle[(side + 1) % 3]];
            let here = middle(face, side);
            let Some(there) = of_edge
                .insert((a, b), here)
                .or(of_edge.get(&(b, a)).copied())
            else {
                continue;
            };
            if here != there {
                let (p, q) = (read(here), read(there));
                sum += (0..3).map(|c| (p[c] - q[c]).abs()).sum::<f64>() / 3.0;
                count += 1.0;
            }
        }
    }
    assert!(count > 100.0);
    sum / count
}

/// The colours are formulas of the place, so that both sides of a seam show the same, in smaller
/// copies of the texture too.
#[test]
fn seams_cannot_be_seen() {
    for (reduction, most) in [(1, 4.0), (2, 5.0), (4, 9.0)] {
        let difference = difference_at_seams(1024, reduction);
        assert!(difference < most, "{reduction}: {difference}");
    }
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
    // The soles are light and the leather at the heel is brown, both without large spots.
    let shoes = positions().into_iter().filter(|[_, y, _]| *y < 0.06);
    let mut counts = [0; 2];
    for place in shoes.step_by(20) {
        let colour = at(place);
        if place[1] < 0.010 {
            counts[0] += 1;
            assert!(brightness(colour) > 180, "{place:?}: {colour:?}");
        } else if place[1] > 0.030 && place[2] < 0.0 {
            counts[1] += 1;
            assert!(
                (48..82).contains(&brightness(colour)),
                "{place:?}: {colour:?}"
            );
            assert!(colour[0] > colour[2], "{place:?}: {colour:?}");
        }
    }
    assert!(counts.iter().all(|count| *count > 10), "{counts:?}");
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
