//! Where spheres, planes and lines meet.

use criterion::{Criterion, criterion_group, criterion_main};
use ga_runtime::cga3::{Infinity, Line, Plane, Point, Sphere};
use nullcone_benches::comparison::{self, Comparison};
use nullcone_benches::inputs;
use nullcone_benches::rivals::Rivals;

fn meets<S: Rivals>(criterion: &mut Criterion) {
    let points = inputs::list(1, |numbers| [(); 4].map(|()| numbers.point::<S>()));
    let sphere = |[p, q, r, s]: &[Point<S>; 4]| -> Sphere<S> { *p ^ *q ^ *r ^ *s };
    let plane = |[p, q, r, _]: &[Point<S>; 4]| -> Plane<S> { *p ^ *q ^ *r ^ Infinity };
    let spheres: Vec<_> = points.iter().map(sphere).collect();
    let planes: Vec<_> = points.iter().rev().map(plane).collect();
    let lines: Vec<_> = points
        .iter()
        .rev()
        .map(|[p, q, ..]| Line::through(*p, *q))
        .collect();

    let mut group = Comparison::new(criterion, &format!("meet/sphere-plane-{}", S::NAME));
    group.zip("nullcone", &spheres, &planes, |s, p| *s & *p);
    S::sphere_plane(&mut group);
    drop(group);

    let mut group = Comparison::new(criterion, &format!("meet/line-sphere-{}", S::NAME));
    group.zip("nullcone", &lines, &spheres, |l, s| *l & *s);
    S::line_sphere(&mut group);
}

criterion_group! {
    name = benches;
    config = comparison::criterion();
    targets = meets::<f32>, meets::<f64>
}
criterion_main!(benches);
