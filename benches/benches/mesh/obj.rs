//! Reading of OBJ files from memory, beside `tobj`.
//!
//! Both read into memory what the file says: ga-mesh in double precision, with every number, index
//! and group checked and the vertices of the file kept; tobj in single precision, with polygons
//! kept and vertices numbered anew where their texture coordinates differ. `tobj, single index`
//! splits vertices as a renderer needs them.

use criterion::{Criterion, Throughput};
use nullcone_shared_data::shared;
use tobj::LoadOptions;

pub(crate) fn all(criterion: &mut Criterion) {
    for name in ["stanford-bunny", "human_base", "spot"] {
        let Some(path) = shared(&format!("data/anim/{name}.obj")) else {
            continue;
        };
        let Ok(bytes) = std::fs::read(&path) else {
            continue;
        };
        let mut group = criterion.benchmark_group(format!("mesh/reading {name}.obj"));
        group.throughput(Throughput::Bytes(bytes.len() as u64));
        group.bench_function("nullcone", |bencher| {
            bencher.iter(|| ga_mesh::obj::decode(&bytes));
        });
        let no_materials = |_: &std::path::Path| Err(tobj::LoadError::GenericFailure);
        let read =
            |options: &LoadOptions| tobj::load_obj_buf(&mut &bytes[..], options, no_materials);
        let plain = LoadOptions::default();
        group.bench_function("tobj", |bencher| bencher.iter(|| read(&plain)));
        let split = LoadOptions {
            single_index: true,
            triangulate: true,
            ..LoadOptions::default()
        };
        group.bench_function("tobj, single index", |bencher| {
            bencher.iter(|| read(&split));
        });
    }
}
