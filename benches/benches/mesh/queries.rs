//! Nearest points and rays on the Stanford bunny of 69,451 triangles, beside parry in `f64`.
//!
//! | distribution | queries |
//! | --- | --- |
//! | box | points uniform in the bounding box, enlarged by 2 about its centre |
//! | near | points uniform on the surface, moved along the normal by up to 1 % of the diagonal |
//! | outside | rays from a sphere whose radius is the diagonal, aimed uniformly into the box |
//! | hemisphere | rays from the surface, with the density of the cosine to the normal |
//!
//! Parry has no query for any hit; its first hit stands beside ours.

use criterion::Criterion;
use ga_mesh::query::Bvh;
use ga_runtime::cga3::Point;
use ga_runtime::geometry::ray::Ray;
use ga_runtime::vga3::Vector;
use nullcone_benches::comparison::Comparison;
use nullcone_benches::inputs::Numbers;
use parry3d_f64::math::Vector as ParryVector;
use parry3d_f64::query::{PointQuery, Ray as ParryRay, RayCast};
use parry3d_f64::shape::TriMesh;

/// More queries than the caches hold answers to.
const QUERIES: usize = 1 << 14;

pub(crate) fn all(criterion: &mut Criterion) {
    let Some(path) = nullcone_shared_data::shared("data/anim/stanford-bunny.obj") else {
        return;
    };
    let mesh = ga_mesh::obj::read(path).expect("the bunny is a mesh");
    let positions: Vec<[f64; 3]> = mesh.coordinates().collect();
    let triangles = mesh.triangles();
    let parry_positions: Vec<ParryVector> = positions.iter().map(|&p| parry(p.into())).collect();
    let parry_mesh =
        || TriMesh::new(parry_positions.clone(), triangles.clone()).expect("the bunny is a mesh");

    let mut group = Comparison::new(criterion, "mesh/build of the hierarchy");
    group.once("nullcone", &triangles, |triangles| {
        Bvh::new(&positions, triangles)
    });
    group.once("parry", &triangles, |_| parry_mesh());
    drop(group);

    let bvh = Bvh::new(&positions, &triangles).expect("the bunny is a mesh");
    let rival = parry_mesh();
    let queries = Queries::new(&bvh, &positions, &triangles);

    for (name, points) in [("box", queries.in_box), ("near", queries.near)] {
        let mut group = Comparison::new(criterion, &format!("mesh/nearest point, {name}"));
        let conformal: Vec<Point<f64>> = points.iter().map(|&p| p.into()).collect();
        group.once("nullcone", &conformal, |points| {
            let distance = |p: &Point<f64>| bvh.nearest(*p).map_or(0.0, |n| n.distance);
            points.iter().map(distance).sum::<f64>()
        });
        let points: Vec<ParryVector> = points.into_iter().map(parry).collect();
        group.once("parry", &points, |points| {
            let distance =
                |p: &ParryVector| (rival.project_local_point(*p, false).point - *p).length();
            points.iter().map(distance).sum::<f64>()
        });
    }

    for (name, rays) in [
        ("outside", queries.outside),
        ("hemisphere", queries.hemisphere),
    ] {
        let parry_rays: Vec<ParryRay> = rays
            .iter()
            .map(|ray| ParryRay::new(parry(ray.origin().into()), parry(ray.direction().into())))
            .collect();
        let parry_hits = |rays: &[ParryRay]| {
            let hit = |ray: &&ParryRay| rival.cast_local_ray(ray, f64::MAX, false).is_some();
            rays.iter().filter(hit).count()
        };
        let mut group = Comparison::new(criterion, &format!("mesh/first hit, {name}"));
        group.once("nullcone", &rays, |rays| {
            let distance = |ray: &Ray<f64>| bvh.first_hit(*ray).map_or(0.0, |h| h.hit.distance);
            rays.iter().map(distance).sum::<f64>()
        });
        group.once("parry", &parry_rays, parry_hits);
        drop(group);
        let mut group = Comparison::new(criterion, &format!("mesh/any hit, {name}"));
        group.once("nullcone", &rays, |rays| {
            rays.iter()
                .filter(|ray| bvh.is_hit(**ray, f64::INFINITY))
                .count()
        });
        group.once("parry, first hit", &parry_rays, parry_hits);
    }
}

fn parry(v: Vector<f64>) -> ParryVector {
    ParryVector::new(v.e1, v.e2, v.e3)
}

struct Queries {
    in_box: Vec<Vector<f64>>,
    near: Vec<Vector<f64>>,
    outside: Vec<Ray<f64>>,
    hemisphere: Vec<Ray<f64>>,
}

impl Queries {
    fn new(bvh: &Bvh, positions: &[[f64; 3]], triangles: &[[u32; 3]]) -> Self {
        let [low, high] = bvh.bounds().unwrap_or_default().map(Vector::from);
        let (centre, half) = ((low + high) * 0.5, (high - low) * 0.5);
        let diagonal = 2.0 * half.length();
        let mut numbers = Numbers::new(11);
        let mut cube = || Vector::from(numbers.numbers::<f64, 3>());
        let anywhere: Vec<_> = (0..QUERIES).map(|_| cube()).collect();
        let spheres: Vec<_> = std::iter::from_fn(|| Some(cube()))
            .filter(|v| v.length() <= 1.0)
            .filter_map(Vector::normalized)
            .take(QUERIES)
            .collect();
        let surface = Surface::new(positions, triangles);
        let places: Vec<_> = (0..QUERIES).map(|_| surface.point(cube())).collect();
        let heights: Vec<_> = (0..QUERIES).map(|_| cube().e1).collect();

        let aimed = anywhere.iter().map(|v| centre + v.component_product(half));
        let outside = aimed
            .zip(&spheres)
            .filter_map(|(to, &from)| Ray::through((centre + from * diagonal).into(), to.into()));
        let hemisphere = places
            .iter()
            .zip(&spheres)
            .filter_map(|(&(place, normal), &sphere)| {
                let from = place + normal * (1e-5 * diagonal);
                Ray::new(from.into(), normal + sphere)
            });
        let near = places.iter().zip(heights);
        let in_box = anywhere
            .iter()
            .map(|v| centre + v.component_product(half) * 2.0);
        Self {
            in_box: in_box.collect(),
            near: near
                .map(|(&(place, normal), height)| place + normal * (height * 0.01 * diagonal))
                .collect(),
            outside: outside.collect(),
            hemisphere: hemisphere.collect(),
        }
    }
}

/// Triangles, chosen in proportion to their areas.
struct Surface {
    corners: Vec<[Vector<f64>; 3]>,
    /// The area of each triangle and of those before it, twice.
    areas: Vec<f64>,
}

impl Surface {
    fn new(positions: &[[f64; 3]], triangles: &[[u32; 3]]) -> Self {
        let corner = |vertex: u32| Vector::from(positions[vertex as usize]);
        let corners: Vec<_> = triangles.iter().map(|t| t.map(corner)).collect();
        let areas = corners.iter().scan(0.0, |sum, corners| {
            *sum += ga_mesh::normals::area_vector(*corners).length();
            Some(*sum)
        });
        Self {
            areas: areas.collect(),
            corners,
        }
    }

    /// A point and the normal there, for three numbers from −1 to 1.
    fn point(&self, numbers: Vector<f64>) -> (Vector<f64>, Vector<f64>) {
        let [x, v, w] = (numbers * 0.5).coordinates().map(|x| x + 0.5);
        let area = x * self.areas.last().copied().unwrap_or_default();
        let triangle = self.areas.partition_point(|&sum| sum < area);
        let [a, b, c] = self.corners[triangle.min(self.corners.len() - 1)];
        let (v, w) = if v + w > 1.0 {
            (1.0 - v, 1.0 - w)
        } else {
            (v, w)
        };
        let normal = ga_mesh::normals::area_vector([a, b, c]).normalized();
        (a + (b - a) * v + (c - a) * w, normal.unwrap_or(Vector::Z))
    }
}
