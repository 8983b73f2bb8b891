//! Loop's scheme beside the regression baselines of OpenSubdiv.
//!
//! The baselines are OBJ files with nine digits, in another order of vertices. Level 0 is already
//! refined at least once.

use ga_mesh::subdivision::{Boundary, Corner, CreaseMethod, Rules, Scheme, Tags};
use ga_mesh::{Mesh, obj};
use nullcone_shared_data::shared;
use serde_json::Value;

use crate::shapes::{Shape, corner, crease, distance, refine};

const EDGE_AND_CORNER: Rules = Rules {
    boundary: Boundary::EdgeAndCorner,
    ..Rules::LOOP
};

fn baseline(name: &str, level: usize) -> Option<Mesh> {
    let file = format!("data/anim/opensubdiv/{name}_level{level}.obj");
    Some(obj::read(shared(&file)?).unwrap())
}

/// The points agree as sets: to each belongs one of the others.
#[track_caller]
fn assert_same(found: &[[f64; 3]], expected: impl Iterator<Item = [f64; 3]>, tolerance: f64) {
    let mut expected: Vec<[f64; 3]> = expected.collect();
    assert_eq!(found.len(), expected.len());
    expected.sort_by(|a, b| a[0].total_cmp(&b[0]));
    let mut taken = vec![false; expected.len()];
    for &point in found {
        let first = expected.partition_point(|other| other[0] < point[0] - tolerance);
        let place = (first..expected.len())
            .take_while(|&place| expected[place][0] <= point[0] + tolerance)
            .find(|&place| !taken[place] && distance(expected[place], point) <= tolerance);
        let place = place.unwrap_or_else(|| panic!("{point:?} is not in the baseline"));
        taken[place] = true;
    }
}

/// The corners of a shape whose OBJ files lack them, from the baselines: a vertex that is still in
/// its place at the levels 1 to n, and not at n + 1, is a corner of sharpness n; one that is in its
/// place at all three levels stays for ever. A vertex that smooth rules leave in its place may be
/// among them, since as a corner it stays too, and its neighbours do not depend on it.
fn corners_that_stay(name: &str, coarse: &Mesh) -> Vec<Corner> {
    let levels = [1, 2, 3].map(|level| baseline(name, level).unwrap());
    let stays = |place: [f64; 3], level: &Mesh| {
        level
            .coordinates()
            .any(|other| distance(place, other) < 1e-7)
    };
    let of_vertex = |(vertex, place): (u32, [f64; 3])| {
        let sharpness = levels
            .iter()
            .take_while(|level| stays(place, level))
            .count();
        let sharpness = if sharpness == levels.len() {
            f64::INFINITY
        } else {
            sharpness as f64
        };
        (sharpness > 0.0).then(|| corner(vertex, sharpness))
    };
    (0..)
        .zip(coarse.coordinates())
        .filter_map(of_vertex)
        .collect()
}

#[test]
fn smooth_meshes_and_boundaries_agree() {
    let files = [
        ("loop_cube", Rules::LOOP),
        ("loop_icosahedron", Rules::LOOP),
        ("loop_saddle_edgeonly", Rules::LOOP),
        ("loop_saddle_edgecorner", EDGE_AND_CORNER),
        ("loop_triangle_edgeonly", Rules::LOOP),
        ("loop_triangle_edgecorner", EDGE_AND_CORNER),
    ];
    for (name, rules) in files {
        let Some(coarse) = baseline(name, 0) else {
            return;
        };
        let faces: Vec<&[u32]> = coarse.faces().iter().collect();
        let positions: Vec<_> = coarse.coordinates().collect();
        let shape = Shape::new(&positions, &faces);
        let mut tags = Tags::default();
        if name == "loop_triangle_edgeonly" {
            tags.corners = corners_that_stay(name, &coarse);
        }
        for level in 1..=3 {
            let (_, points) = refine(&shape, rules, &tags, level);
            assert_same(&points, baseline(name, level).unwrap().coordinates(), 1e-6);
        }
    }
}

/// The shape `loop_cube_creases1`: a cube on its side, all edges of which are sharp for five
/// levels, one for a fifth of a level.
#[test]
fn a_cube_with_creases_agrees() {
    // √2, of which the shape gives six digits.
    let r = std::f64::consts::SQRT_2;
    let positions = [
        [0.0, r, 1.0],
        [-r, 0.0, 1.0],
        [r, 0.0, 1.0],
        [0.0, -r, 1.0],
        [r, 0.0, -1.0],
        [0.0, -r, -1.0],
        [0.0, r, -1.0],
        [-r, 0.0, -1.0],
    ];
    let faces = [
        [0, 1, 2],
        [2, 1, 3],
        [2, 3, 4],
        [4, 3, 5],
        [4, 5, 6],
        [6, 5, 7],
        [6, 7, 0],
        [0, 7, 1],
        [1, 7, 3],
        [3, 7, 5],
        [6, 0, 4],
        [4, 0, 2],
    ];
    let sharp = [
        [1, 3],
        [3, 2],
        [2, 0],
        [0, 1],
        [7, 5],
        [5, 4],
        [4, 6],
        [6, 7],
        [0, 6],
        [1, 7],
        [3, 5],
    ];
    let mut creases: Vec<_> = sharp.iter().map(|&[a, b]| crease(a, b, 5.0)).collect();
    creases.push(crease(2, 4, 0.2));
    let tags = Tags {
        creases,
        corners: Vec::new(),
    };
    compare("loop_cube_creases1", &Shape::new(&positions, &faces), &tags);
}

/// The shape `loop_chaikin0`: a box whose long edges become sharper from one end to the other. The
/// name notwithstanding, its creases follow the normal method.
#[test]
fn a_box_with_varying_creases_agrees() {
    let mut positions = Vec::new();
    for (x, z) in (0..12).map(|i| {
        let along = 0.6 * f64::from(i % 6);
        if i < 6 {
            (1.5 - along, 0.5)
        } else {
            (along - 1.5, -0.5)
        }
    }) {
        positions.extend([[x, -0.5, z], [x, 0.5, z]]);
    }
    let mut faces = Vec::new();
    for i in 0..12_u32 {
        let next = 2 * ((i + 1) % 12);
        faces.extend([[2 * i, 2 * i + 1, next], [next, 2 * i + 1, next + 1]]);
    }
    // The sides y = 1/2 and y = −1/2 in strips.
    for i in 0..5 {
        let (near, far) = (2 * i, 22 - 2 * i);
        faces.extend([[near + 1, far + 1, near + 3], [near + 3, far + 1, far - 1]]);
        faces.extend([[far, near, far - 2], [far - 2, near, near + 2]]);
    }
    let around = [1.0, 2.0, 3.0, 4.0, 5.0, 5.0, 5.0, 4.0, 3.0, 2.0, 1.0, 5.0];
    let mut creases = Vec::new();
    for (i, sharpness) in (0..12_u32).zip(around) {
        let next = 2 * ((i + 1) % 12);
        creases.push(crease(2 * i, next, sharpness));
        creases.push(crease(2 * i + 1, next + 1, sharpness));
    }
    creases.extend([0, 10, 12, 22].map(|a| crease(a, a + 1, 5.0)));
    let tags = Tags {
        creases,
        corners: Vec::new(),
    };
    compare("loop_chaikin0", &Shape::new(&positions, &faces), &tags);
}

/// Compares levels 0 to 3, of which level 0 is refined once.
fn compare(name: &str, shape: &Shape, tags: &Tags) {
    for level in 0..=3 {
        let Some(expected) = baseline(name, level) else {
            return;
        };
        let (_, points) = refine(shape, Rules::LOOP, tags, level + 1);
        assert_same(&points, expected.coordinates(), 1e-6);
    }
}

/// Creases of fractional sharpness by Chaikin's method, several of which end in the same step, some
/// of them above 1.
#[test]
fn creases_by_chaikins_method_agree() {
    let truth: Value = serde_json::from_str(include_str!("../data/chaikin.json")).unwrap();
    let read = |value: &Value| -> Vec<[f64; 3]> { serde_json::from_value(value.clone()).unwrap() };
    for case in truth["cases"].as_array().unwrap() {
        let faces: Vec<Vec<u32>> = serde_json::from_value(case["faces"].clone()).unwrap();
        let creases: Vec<(u32, u32, f64)> =
            serde_json::from_value(case["creases"].clone()).unwrap();
        let corners: Vec<(u32, f64)> = serde_json::from_value(case["corners"].clone()).unwrap();
        let tags = Tags {
            creases: creases.iter().map(|&(a, b, s)| crease(a, b, s)).collect(),
            corners: corners.iter().map(|&(v, s)| corner(v, s)).collect(),
        };
        let scheme = match case["scheme"].as_str() {
            Some("loop") => Scheme::Loop,
            _ => Scheme::CatmullClark,
        };
        let rules = Rules {
            creases: CreaseMethod::Chaikin,
            ..Rules::new(scheme)
        };
        let shape = Shape::new(&read(&case["positions"]), &faces);
        let levels = case["levels"].as_u64().unwrap() as usize;
        let (_, points) = refine(&shape, rules, &tags, levels);
        assert_same(&points, read(&case["points"]).into_iter(), 1e-6);
    }
}
