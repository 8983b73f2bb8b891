//! Closed surfaces.

use std::collections::HashMap;

use ga_runtime::vga3::Vector;

use super::Soup;

/// A sphere-like surface about the origin: an octahedron whose faces are split into four `levels`
/// times, with every vertex put at a distance between ½ and 1½ that depends on its direction.
pub(super) fn star(levels: u32, bumps: f64) -> Soup {
    let mut positions: Vec<Vector<f64>> = [0, 1, 2]
        .into_iter()
        .flat_map(|axis| {
            let mut unit = Vector::ZERO;
            unit[axis] = 1.0;
            [unit, -unit]
        })
        .collect();
    let mut triangles: Vec<[u32; 3]> = Vec::new();
    for [x, y, z] in [[0, 2, 4], [2, 1, 4], [1, 3, 4], [3, 0, 4]] {
        triangles.push([x, y, z]);
        triangles.push([y, x, 5]);
    }
    for _ in 0..levels {
        let mut middles: HashMap<[u32; 2], u32> = HashMap::new();
        let mut split = Vec::new();
        for [a, b, c] in triangles {
            let [ab, bc, ca] = [[a, b], [b, c], [c, a]].map(|[a, b]| {
                *middles.entry([a.min(b), a.max(b)]).or_insert_with(|| {
                    let middle = positions[a as usize] + positions[b as usize];
                    positions.push(middle.normalized().unwrap());
                    positions.len() as u32 - 1
                })
            });
            split.extend([[a, ab, ca], [ab, b, bc], [ca, bc, c], [ab, bc, ca]]);
        }
        triangles = split;
    }
    let bump = |p: Vector<f64>| 1.0 + 0.5 * (bumps * p.e1).sin() * (bumps * (p.e2 + p.e3)).cos();
    Soup {
        positions: positions
            .iter()
            .map(|&p| (p * bump(p)).coordinates())
            .collect(),
        triangles,
    }
}
