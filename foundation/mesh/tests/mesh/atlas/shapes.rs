//! Surfaces that the implementation was not made for.

use std::f64::consts::{PI, TAU};

use nullcone_shared_data::shared;

pub(super) struct Shape {
    pub(super) name: String,
    pub(super) positions: Vec<[f64; 3]>,
    pub(super) triangles: Vec<[u32; 3]>,
}

impl Shape {
    fn new(name: &str, positions: Vec<[f64; 3]>, triangles: Vec<[u32; 3]>) -> Self {
        let name = name.into();
        Self {
            name,
            positions,
            triangles,
        }
    }

    /// The same surface with every position changed.
    pub(super) fn map(mut self, name: &str, change: impl Fn([f64; 3]) -> [f64; 3]) -> Self {
        for position in &mut self.positions {
            *position = change(*position);
        }
        self.name = name.into();
        self
    }

    fn named(mut self, name: &str) -> Self {
        self.name = name.into();
        self
    }

    /// This surface and another one beside it.
    fn with(mut self, other: Self) -> Self {
        let first = self.positions.len() as u32;
        self.positions.extend(other.positions);
        let moved = other.triangles.into_iter().map(|t| t.map(|v| v + first));
        self.triangles.extend(moved);
        self
    }
}

/// A grid of quadrilaterals over the unit square, closed in either direction or not.
fn grid(
    name: &str,
    [columns, rows]: [u32; 2],
    [closed_u, closed_v]: [bool; 2],
    place: impl Fn(f64, f64) -> [f64; 3],
) -> Shape {
    let (width, height) = (columns + u32::from(!closed_u), rows + u32::from(!closed_v));
    let mut positions = Vec::new();
    for row in 0..height {
        for column in 0..width {
            let (u, v) = (
                f64::from(column) / f64::from(columns),
                f64::from(row) / f64::from(rows),
            );
            positions.push(place(u, v));
        }
    }
    let mut triangles = Vec::new();
    for row in 0..rows {
        for column in 0..columns {
            let at = |c: u32, r: u32| (r % height) * width + c % width;
            let [a, b] = [at(column, row), at(column + 1, row)];
            let [d, c] = [at(column, row + 1), at(column + 1, row + 1)];
            triangles.extend([[a, b, c], [a, c, d]]);
        }
    }
    Shape::new(name, positions, triangles)
}

pub(super) fn torus(columns: u32, rows: u32, [large, small]: [f64; 2]) -> Shape {
    grid("torus", [columns, rows], [true, true], |u, v| {
        let (a, b) = (TAU * u, TAU * v);
        let r = large + small * b.cos();
        [r * a.cos(), r * a.sin(), small * b.sin()]
    })
}

/// A sphere of latitudes and longitudes, with a triangle without area for each longitude at each
/// pole.
fn sphere(columns: u32, rows: u32) -> Shape {
    grid("sphere", [columns, rows], [true, false], |u, v| {
        let (a, b) = (TAU * u, PI * (v - 0.5));
        [b.cos() * a.cos(), b.cos() * a.sin(), b.sin()]
    })
}

fn tube(length: f64, columns: u32, rows: u32) -> Shape {
    grid("tube", [columns, rows], [true, false], |u, v| {
        let a = TAU * u;
        [a.cos(), a.sin(), length * v]
    })
}

pub(super) fn terrain(width: f64) -> Shape {
    grid("terrain", [120, 60], [false, false], |u, v| {
        let height = 0.1 * (9.0 * u).sin() * (7.0 * v).cos() + 0.02 * (40.0 * u + 25.0 * v).sin();
        [width * u, v, height]
    })
}

/// A cube with its corner at this place. Its faces share no vertices if it is split.
fn cube(corner: [f64; 3], steps: u32, split: bool) -> Shape {
    let mut all = Shape::new("cube", Vec::new(), Vec::new());
    for axis in 0..3 {
        for (end, flip) in [(0.0, true), (1.0, false)] {
            let side = grid("", [steps, steps], [false, false], |u, v| {
                let mut place = [0.0; 3];
                place[axis] = end;
                place[(axis + 1) % 3] = if flip { v } else { u };
                place[(axis + 2) % 3] = if flip { u } else { v };
                std::array::from_fn(|k| place[k] + corner[k])
            });
            all = all.with(side);
        }
    }
    if split {
        return all;
    }
    let mut kept: Vec<[f64; 3]> = Vec::new();
    let number: Vec<u32> = all
        .positions
        .iter()
        .map(|p| {
            let found = kept.iter().position(|q| q == p);
            found.unwrap_or_else(|| {
                kept.push(*p);
                kept.len() - 1
            }) as u32
        })
        .collect();
    let triangles = all.triangles.iter().map(|t| t.map(|v| number[v as usize]));
    Shape::new("cube", kept, triangles.collect())
}

/// Pseudo-random numbers from −1 to 1.
fn noise(seed: usize) -> f64 {
    let mut x = seed as u64 ^ 0x9e37_79b9_7f4a_7c15;
    for _ in 0..3 {
        x ^= x >> 30;
        x = x.wrapping_mul(0xbf58_476d_1ce4_e5b9);
        x ^= x >> 27;
    }
    (x >> 11) as f64 / (1u64 << 52) as f64 - 1.0
}

/// Every position moved at random.
fn rough(mut shape: Shape, name: &str, amount: f64) -> Shape {
    for (index, position) in shape.positions.iter_mut().enumerate() {
        for (axis, x) in position.iter_mut().enumerate() {
            *x += amount * noise(3 * index + axis);
        }
    }
    shape.name = name.into();
    shape
}

fn file(path: &str, group: Option<&str>) -> Option<Shape> {
    let file = shared(path)?;
    let mesh = ga_files::read(&file, ga_mesh::obj::decode).unwrap();
    let mesh = match group {
        Some(group) => mesh.part(group).unwrap().mesh,
        None => mesh,
    };
    Some(Shape::new(
        path,
        mesh.coordinates().collect(),
        mesh.triangles(),
    ))
}

/// A screw surface of several storeys, which any projection lays over itself.
fn screw() -> Shape {
    grid("screw", [16, 200], [false, false], |u, v| {
        let a = 3.0 * TAU * v;
        [(1.0 + u) * a.cos(), (1.0 + u) * a.sin(), 0.15 * a]
    })
}

fn moebius() -> Shape {
    let mut strip = grid("Möbius strip", [6, 90], [false, false], |u, v| {
        let a = TAU * v;
        let w = 0.4 * (u - 0.5);
        let r = 1.0 + w * (a / 2.0).cos();
        [r * a.cos(), r * a.sin(), w * (a / 2.0).sin()]
    });
    // The last row is the first one, the other way round.
    let last = 90 * 7;
    for triangle in &mut strip.triangles {
        *triangle = triangle.map(|v| if v >= last { 6 - (v - last) } else { v });
    }
    strip
}

/// Three squares at one edge.
fn fan() -> Shape {
    let mut all = Shape::new("three squares at an edge", Vec::new(), Vec::new());
    for third in 0..3 {
        let (sine, cosine) = (TAU * f64::from(third) / 3.0).sin_cos();
        let page = grid("", [8, 8], [false, false], |u, v| [u * cosine, u * sine, v]);
        all = all.with(page);
    }
    all
}

/// A plane with steep spikes all over it.
pub(super) fn spikes() -> Shape {
    grid("spikes", [60, 60], [false, false], |u, v| {
        let bump = (20.0 * u).sin() * (20.0 * v).sin();
        [u, v, 0.25 * bump * bump * bump]
    })
}

pub(super) fn all() -> Vec<Shape> {
    let bumps = |[x, y, z]: [f64; 3]| {
        let a = 1.0 + 0.06 * (9.0 * x).sin() * (8.0 * y).sin() * (7.0 * z + 1.0).sin();
        [x * a, y * a, z * a]
    };
    let mut shapes = vec![
        torus(72, 96, [1.0, 0.4]),
        torus(200, 20, [1.0, 0.05]).named("thin ring"),
        torus(72, 96, [1.0, 0.4]).map("torus with bumps", bumps),
        rough(torus(72, 96, [1.0, 0.4]), "rough torus", 0.012),
        rough(torus(72, 96, [1.0, 0.4]), "very rough torus", 0.03),
        sphere(64, 32),
        sphere(160, 80).map("sphere with bumps", bumps),
        sphere(40, 20).map("ellipsoid", |[x, y, z]| [x, 3.0 * y, 0.2 * z]),
        tube(200.0, 12, 400).named("long tube"),
        tube(8.0, 24, 40),
        tube(60.0, 8, 300).map("bent tube", |[x, y, z]| {
            [x + 10.0 * (z / 5.0).sin(), y + 10.0 * (z / 7.0).cos(), z]
        }),
        terrain(1.0),
        terrain(8.0).named("long terrain"),
        rough(terrain(1.0), "rough terrain", 0.004),
        cube([0.0; 3], 1, false),
        cube([0.0; 3], 8, true).named("split cube"),
        screw(),
        moebius(),
        fan(),
        grid("disc", [40, 12], [true, false], |u, v| {
            [v * (TAU * u).cos(), v * (TAU * u).sin(), 0.0]
        }),
        torus(72, 96, [1.0, 0.4]).map("tiny torus", |p| p.map(|x| x * 1e-160)),
        torus(72, 96, [1.0, 0.4]).map("huge torus", |p| p.map(|x| x * 1e300)),
        torus(72, 96, [1.0, 0.4]).map("far torus", |p| p.map(|x| x + 1e6)),
        grid("one square", [1, 1], [false, false], |u, v| [u, v, 0.0]),
    ];
    let mut cubes = cube([0.0; 3], 1, false);
    for index in 1..60 {
        let corner = [2.0 * f64::from(index), noise(index as usize), 0.0];
        cubes = cubes.with(cube(corner, 1, false));
    }
    shapes.push(cubes.named("sixty cubes"));
    let files = [
        ("data/anim/stanford-bunny.obj", None),
        ("data/anim/spot.obj", None),
        ("data/anim/human_base.obj", Some("body")),
    ];
    shapes.extend(
        files
            .into_iter()
            .filter_map(|(path, group)| file(path, group)),
    );
    shapes
}
