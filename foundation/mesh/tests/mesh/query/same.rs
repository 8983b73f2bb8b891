//! The same hierarchy and the same answers whenever and wherever they are computed.

use std::thread;

use ga_mesh::query::Bvh;
use ga_runtime::cga3::Point;
use ga_runtime::geometry::ray::Ray;
use ga_runtime::vga3::Vector;

use super::surface::star;

/// The bits of the answers to some queries.
fn answers(bvh: &Bvh, queries: std::ops::Range<u32>) -> Vec<String> {
    let number = |i: u32, k: u32| f64::from(i.wrapping_mul(k) % 4001) / 1000.25 - 2.0;
    queries
        .map(|i| {
            let from = Vector::new(number(i, 7), number(i, 1301), number(i, 2903));
            let to = Vector::new(number(i, 977), number(i, 11), number(i, 1709)) * 0.4;
            let ray = Ray::through(from.into(), to.into()).unwrap();
            let point = Point::from(from);
            format!(
                "{:?} {:?} {:?} {} {:?}",
                bvh.nearest(point),
                bvh.first_hit(ray),
                bvh.all_hits(ray),
                bvh.is_hit(ray, 1.5),
                bvh.within(point, 0.8),
            )
        })
        .collect()
}

#[test]
fn the_hierarchy_and_its_answers_do_not_depend_on_threads() {
    const QUERIES: u32 = 600;
    let soup = star(4, 5.0);
    let bvh = soup.bvh();
    let expected = answers(&bvh, 0..QUERIES);
    assert!(expected.iter().any(|answer| answer.contains("true")));
    assert!(expected.iter().any(|answer| answer.contains("false")));
    let stored = format!("{bvh:?}");
    assert_eq!(format!("{:?}", soup.bvh()), stored);
    for threads in [1, 2, 3, 8] {
        // A hierarchy of its own in each thread, and one that all of them share.
        let parts: Vec<(String, Vec<String>)> = thread::scope(|scope| {
            let handles: Vec<_> = (0..threads)
                .map(|part| {
                    let (bvh, soup) = (&bvh, &soup);
                    let range = QUERIES * part / threads..QUERIES * (part + 1) / threads;
                    scope.spawn(move || (format!("{:?}", soup.bvh()), answers(bvh, range)))
                })
                .collect();
            handles
                .into_iter()
                .map(|handle| handle.join().unwrap())
                .collect()
        });
        assert!(parts.iter().all(|(built, _)| *built == stored));
        let found: Vec<String> = parts.into_iter().flat_map(|(_, answers)| answers).collect();
        assert_eq!(found, expected);
    }
}
