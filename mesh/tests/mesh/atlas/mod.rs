//! Atlases of many surfaces, measured by code of their own.

mod shapes;
mod truth;

use ga_mesh::atlas::{Atlas, Options, unwrap};

use shapes::Shape;

fn made(shape: &Shape, options: &Options) -> Atlas {
    unwrap(&shape.positions, &shape.triangles, options)
        .unwrap_or_else(|error| panic!("{}: {error}", shape.name))
}

#[test]
fn report() {
    let options = Options::default();
    let only = std::env::var("ONLY").unwrap_or_default();
    for shape in shapes::all() {
        if !shape.name.contains(&only) {
            continue;
        }
        let start = std::time::Instant::now();
        let atlas = made(&shape, &options);
        let time = start.elapsed();
        let truth = truth::figures(&shape, &atlas, 1024, 1);
        eprintln!(
            "{:34} {:6} faces {:7.1} ms charts {:3} util {:.3} ({:.3}) L2 {:.4} ({:.4}) max {:6.2} flip {} ({}) over {} ({}+{}) out {}",
            shape.name,
            shape.triangles.len(),
            time.as_secs_f64() * 1e3,
            truth.charts,
            atlas.report.utilisation,
            truth.utilisation,
            atlas.report.stretch_l2,
            truth.stretch_l2,
            atlas.report.stretch_max,
            atlas.report.flipped,
            truth.flipped,
            atlas.report.overlapping_texels,
            truth.double,
            truth.contested,
            truth.outside,
        );
    }
}
