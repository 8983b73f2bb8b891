//! Texture atlas and maps: a torus of 13,824 triangles and its refinement with bumps, of 55,296.
//!
//! `all` is the atlas, the hierarchy, and the maps of normals, displacement and colour at 1024².

use std::f64::consts::TAU;

use criterion::Criterion;
use ga_mesh::atlas::{self, Atlas};
use ga_mesh::bake::{Bake, Coarse, Fine, OcclusionOptions, Options, corner_colours};
use ga_mesh::normals::vertex_normals;
use ga_mesh::subdivision::{Cage, Rules};
use ga_mesh::{Faces, Mesh};

pub(crate) fn all(criterion: &mut Criterion) {
    let Some((coarse, fine)) = surfaces() else {
        return;
    };
    let positions: Vec<[f64; 3]> = coarse.coordinates().collect();
    let triangles = coarse.triangles();
    let unwrapped = || atlas::unwrap(&positions, &triangles, &atlas::Options::default());
    let mut group = criterion.benchmark_group("mesh/bake");
    group.sample_size(10);
    group.bench_function("atlas of 13,824 triangles", |bencher| {
        bencher.iter(unwrapped);
    });
    group.bench_function("hierarchy of 55,296 triangles", |bencher| {
        bencher.iter(|| Fine::from_mesh(&fine));
    });
    group.bench_function("all, 1024²", |bencher| {
        bencher.iter(|| three_maps(&coarse, &unwrapped().ok()?, &fine));
    });
    let baked = |atlas: Atlas| {
        let coarse = with_coordinates(&coarse, &atlas)?;
        Some((
            Coarse::from_mesh(&coarse, 0).ok()?,
            Fine::from_mesh(&fine).ok()?,
        ))
    };
    if let Some((coarse, fine)) = unwrapped().ok().and_then(baked) {
        group.bench_function("occlusion, 512², 32 rays", |bencher| {
            bencher.iter(|| {
                let bake = Bake::new(&coarse, &fine, &Options::with_size(512)).ok()?;
                bake.occlusion(&OcclusionOptions::default()).ok()
            });
        });
    }
    group.finish();
}

fn three_maps(coarse: &Mesh, atlas: &Atlas, fine: &Mesh) -> Option<[usize; 3]> {
    let coarse = Coarse::from_mesh(&with_coordinates(coarse, atlas)?, 0).ok()?;
    let corners = corner_colours(fine)?;
    let fine = Fine::from_mesh(fine).ok()?;
    let bake = Bake::new(&coarse, &fine, &Options::default()).ok()?;
    let normals = bake.normals();
    let heights = bake.displacement();
    let colours = bake.colour(|point| {
        let [r, g, b, _] = point.mean(&corners[point.triangle as usize]);
        [r, g, b].map(|x| x as f32)
    });
    Some([
        normals.texels.len(),
        heights.texels.len(),
        colours.texels.len(),
    ])
}

fn with_coordinates(mesh: &Mesh, atlas: &Atlas) -> Option<Mesh> {
    let coordinates = vec![atlas.texture_coordinates()];
    mesh.clone().with_texture_coordinates(coordinates).ok()
}

/// The coarse and the fine torus.
fn surfaces() -> Option<(Mesh, Mesh)> {
    const AROUND: u32 = 96;
    const ACROSS: u32 = 72;
    let mut positions = Vec::new();
    let mut triangles = Vec::new();
    for i in 0..AROUND {
        for j in 0..ACROSS {
            let a = TAU * f64::from(i) / f64::from(AROUND);
            let b = TAU * f64::from(j) / f64::from(ACROSS);
            let r = 1.0 + 0.4 * b.cos();
            positions.push([r * a.cos(), 0.4 * b.sin(), -r * a.sin()]);
            let at = |i: u32, j: u32| (i % AROUND) * ACROSS + j % ACROSS;
            let [p, q] = [at(i, j), at(i + 1, j)];
            let [s, t] = [at(i, j + 1), at(i + 1, j + 1)];
            triangles.extend([[p, q, t], [p, t, s]]);
        }
    }
    let faces = Faces::from_polygons(&triangles).ok()?;
    let cage = Cage::new(faces.clone(), positions.len(), Rules::LOOP).ok()?;
    let refined = cage.refine().ok()?;
    let smooth: Vec<[f64; 3]> = refined.stencils.applied(&positions).ok()?;
    let fine_faces = refined.cage.faces().clone();
    let normals = vertex_normals(&smooth, &fine_faces.triangles(&smooth));
    let bumpy = smooth.iter().zip(&normals).map(|(&[x, y, z], normal)| {
        let (a, b) = (z.atan2(x), y.atan2(x.hypot(z) - 1.0));
        let height = 0.02 * (18.0 * a).sin() * (9.0 * b).sin();
        [0, 1, 2].map(|k| [x, y, z][k] + height * normal[k])
    });
    let colours = normals
        .iter()
        .map(|[x, y, z]| [0.5 + 0.5 * x, 0.5 + 0.5 * y, z.abs(), 1.0]);
    let fine = Mesh::new(bumpy.collect(), fine_faces).ok()?;
    let fine = fine.with_colours(colours.collect()).ok()?;
    Some((Mesh::new(positions, faces).ok()?, fine))
}
