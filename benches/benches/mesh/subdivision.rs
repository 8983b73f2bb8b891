//! One step of Loop's scheme on a torus of 6,912 vertices and 13,824 triangles, and of Catmull and
//! Clark's on its 6,912 quadrilaterals, beside opensubdiv-rs, a port of OpenSubdiv to Rust that
//! computes with weights in `f32`.
//!
//! A step begins with positions and triangles and ends with those of the next level; all
//! connectivity is found within it. The stencils are those of that step, applied again.

use criterion::Criterion;
use ga_mesh::Faces;
use ga_mesh::subdivision::{Cage, Crease, Rules, Tags};
use nullcone_benches::comparison::Comparison;
use opensubdiv_rs::far::{
    PrimvarRefiner, StencilTableFactory, StencilTableOptions, TopologyDescriptor, TopologyRefiner,
    TopologyRefinerFactory, UniformOptions,
};
use opensubdiv_rs::sdc::{Options, SchemeType};

/// Quadrilaterals around the axis and around the tube.
const AROUND: [u32; 2] = [96, 72];

pub(crate) fn all(criterion: &mut Criterion) {
    let positions = positions();
    let quadrilaterals = quadrilaterals();
    let triangles: Vec<[u32; 3]> = quadrilaterals
        .iter()
        .flat_map(|&[a, b, c, d]| [[a, b, c], [a, c, d]])
        .collect();
    steps(criterion, &positions, &triangles, &quadrilaterals);
    creases(criterion, &positions, &triangles);
    again(criterion, &positions, &triangles);
}

fn steps(
    criterion: &mut Criterion,
    positions: &[[f64; 3]],
    triangles: &[[u32; 3]],
    quadrilaterals: &[[u32; 4]],
) {
    let mut group = Comparison::new(criterion, "mesh/step of Loop's scheme");
    group.once("nullcone", positions, |positions| {
        step(positions, triangles, Rules::LOOP, &Tags::default())
    });
    group.once("opensubdiv-rs", positions, |positions| {
        rival_step(positions, triangles.as_flattened(), SchemeType::Loop)
    });
    drop(group);

    let mut group = Comparison::new(criterion, "mesh/step of Catmull and Clark's scheme");
    group.once("nullcone", positions, |positions| {
        step(
            positions,
            quadrilaterals,
            Rules::CATMULL_CLARK,
            &Tags::default(),
        )
    });
    group.once("opensubdiv-rs", positions, |positions| {
        rival_step(
            positions,
            quadrilaterals.as_flattened(),
            SchemeType::Catmark,
        )
    });
}

/// One ring of the torus is a crease.
fn creases(criterion: &mut Criterion, positions: &[[f64; 3]], triangles: &[[u32; 3]]) {
    let crease = |at| Crease {
        vertices: [at, (at + 1) % AROUND[0]].map(|at| at * AROUND[1]),
        sharpness: 2.5,
    };
    let tags = Tags {
        creases: (0..AROUND[0]).map(crease).collect(),
        ..Tags::default()
    };
    let mut group = Comparison::new(criterion, "mesh/step of Loop's scheme with creases");
    group.once("nullcone", positions, |positions| {
        step(positions, triangles, Rules::LOOP, &tags)
    });
}

fn again(criterion: &mut Criterion, positions: &[[f64; 3]], triangles: &[[u32; 3]]) {
    let single: Vec<[f32; 3]> = positions.iter().map(|x| x.map(|x| x as f32)).collect();
    let cage = cage(positions.len(), triangles, Rules::LOOP, &Tags::default());
    let stencils = cage.refine().expect("the mesh is small").stencils;
    let fine = vec![[0.0_f64; 3]; stencils.row_count()];
    let fine_single = vec![[0.0_f32; 3]; stencils.row_count()];
    let refiner = rival(triangles.as_flattened(), positions.len(), SchemeType::Loop);
    let table = StencilTableFactory::create(&refiner, StencilTableOptions::default());

    let mut group = Comparison::new(criterion, "mesh/stencils of Loop's scheme again");
    group.whole("nullcone, f64", positions, &fine, |positions, fine| {
        stencils.apply(positions, fine).expect("the lengths fit");
    });
    group.whole("nullcone, f32", &single, &fine_single, |positions, fine| {
        stencils.apply(positions, fine).expect("the lengths fit");
    });
    group.whole("opensubdiv-rs, f64", positions, &fine, |positions, fine| {
        table.update_values(positions, fine);
    });
    group.whole(
        "opensubdiv-rs, f32",
        &single,
        &fine_single,
        |positions, fine| {
            table.update_values(positions, fine);
        },
    );
}

fn positions() -> Vec<[f64; 3]> {
    let angle = |at: u32, axis: usize| {
        (std::f64::consts::TAU * f64::from(at) / f64::from(AROUND[axis])).sin_cos()
    };
    let vertices = (0..AROUND[0]).flat_map(|i| (0..AROUND[1]).map(move |j| (i, j)));
    let positions = vertices.map(|(i, j)| {
        let ((sin, cos), (height, outwards)) = (angle(i, 0), angle(j, 1));
        let radius = 1.0 + 0.4 * outwards;
        [radius * cos, radius * sin, 0.4 * height]
    });
    positions.collect()
}

fn quadrilaterals() -> Vec<[u32; 4]> {
    let vertex = |i: u32, j: u32| i % AROUND[0] * AROUND[1] + j % AROUND[1];
    let faces = (0..AROUND[0]).flat_map(|i| (0..AROUND[1]).map(move |j| (i, j)));
    let face = |(i, j)| {
        [
            vertex(i, j),
            vertex(i + 1, j),
            vertex(i + 1, j + 1),
            vertex(i, j + 1),
        ]
    };
    faces.map(face).collect()
}

fn cage<const N: usize>(vertices: usize, faces: &[[u32; N]], rules: Rules, tags: &Tags) -> Cage {
    let faces = Faces::from_uniform(faces.to_vec()).expect("the faces are polygons");
    let cage = Cage::new(faces, vertices, rules).expect("a torus is manifold");
    cage.with_tags(tags).expect("the creases are edges")
}

fn step<const N: usize>(
    positions: &[[f64; 3]],
    faces: &[[u32; N]],
    rules: Rules,
    tags: &Tags,
) -> (Cage, Vec<[f64; 3]>) {
    let fine = cage(positions.len(), faces, rules, tags).refine();
    let fine = fine.expect("the mesh is small");
    let positions = fine.stencils.applied(positions).expect("the lengths fit");
    (fine.cage, positions)
}

fn rival(corners: &[u32], vertices: usize, scheme: SchemeType) -> TopologyRefiner {
    let size = match scheme {
        SchemeType::Loop => 3,
        _ => 4,
    };
    let sizes = vec![size; corners.len() / size];
    let descriptor = TopologyDescriptor::new(vertices, &sizes, corners);
    let refiner = TopologyRefinerFactory::create(descriptor, scheme, Options::default());
    let mut refiner = refiner.expect("a torus is manifold");
    refiner.refine_uniform(UniformOptions::new(1));
    refiner
}

fn rival_step(
    positions: &[[f64; 3]],
    corners: &[u32],
    scheme: SchemeType,
) -> (TopologyRefiner, Vec<[f64; 3]>) {
    let refiner = rival(corners, positions.len(), scheme);
    let mut fine = vec![[0.0; 3]; refiner.level(1).num_vertices()];
    PrimvarRefiner::new(&refiner).interpolate(1, positions, &mut fine);
    (refiner, fine)
}
