//! Queries against a comparison with every triangle.

mod degenerate;
mod nearest;
mod overlap;
mod pairs;
mod plain;
mod ray;
mod same;
mod surface;

use ga_runtime::vga3::Vector;
use proptest::prelude::*;

/// Triangles for a query, and their corners.
#[derive(Clone, Debug)]
struct Soup {
    positions: Vec<[f64; 3]>,
    triangles: Vec<[u32; 3]>,
}

impl Soup {
    fn corners(&self, triangle: usize) -> [Vector<f64>; 3] {
        self.triangles[triangle].map(|vertex| Vector::from(self.positions[vertex as usize]))
    }

    fn bvh(&self) -> ga_mesh::query::Bvh {
        ga_mesh::query::Bvh::new(&self.positions, &self.triangles).unwrap()
    }
}

/// Small whole numbers, so that triangles share corners, edges and planes, many are degenerate, and
/// many queries have several answers.
fn lattice() -> impl Strategy<Value = f64> {
    (-2_i32..=2).prop_map(f64::from)
}

fn real() -> impl Strategy<Value = f64> {
    -2.0..2.0_f64
}

fn number() -> impl Strategy<Value = f64> {
    prop_oneof![
        lattice(),
        lattice(),
        real(),
        lattice().prop_map(|x| x / 2.0)
    ]
}

fn triple() -> impl Strategy<Value = [f64; 3]> {
    [number(), number(), number()]
}

/// Triangles without order, up to enough for several levels of the hierarchy.
fn soups() -> impl Strategy<Value = Soup> {
    let positions = prop_oneof![
        prop::collection::vec([lattice(), lattice(), lattice()], 3..60),
        prop::collection::vec(triple(), 3..60),
        // All within one plane, where boxes have no thickness.
        prop::collection::vec([real(), real()].prop_map(|[x, y]| [x, y, 0.5]), 3..60),
    ];
    positions
        .prop_flat_map(|positions| {
            let count = positions.len() as u32;
            let triangles = prop::collection::vec([0..count, 0..count, 0..count], 1..150);
            (Just(positions), triangles)
        })
        .prop_map(|(positions, triangles)| Soup {
            positions,
            triangles,
        })
}

/// A soup at another size and place. Powers of two keep the lattice exact.
fn placed_soups() -> impl Strategy<Value = (Soup, f64, [f64; 3])> {
    let scale = prop_oneof![Just(1.0), Just(1024.0), Just(1.0 / 1_048_576.0)];
    let shift = prop_oneof![Just([0.0; 3]), Just([1000.0, -64.0, 8.0])];
    (soups(), scale, shift).prop_map(|(mut soup, scale, shift)| {
        for position in &mut soup.positions {
            *position = place(*position, scale, shift);
        }
        (soup, scale, shift)
    })
}

fn place(position: [f64; 3], scale: f64, shift: [f64; 3]) -> [f64; 3] {
    [0, 1, 2].map(|axis| (position[axis] + shift[axis]) * scale)
}
