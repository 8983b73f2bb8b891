//! What makes a triangle mesh a closed surface, checked from its triangles alone.

use std::collections::{HashMap, HashSet};

use ga_runtime::vga3::Vector;

/// Directed edges with the triangle to their left. Fails when an edge is there twice, as where
/// three triangles meet or two neighbours are wound against each other.
pub(crate) fn directed_edges(triangles: &[[u32; 3]]) -> HashMap<(u32, u32), usize> {
    let mut edges = HashMap::new();
    for (i, t) in triangles.iter().enumerate() {
        for k in 0..3 {
            let edge = (t[k], t[(k + 1) % 3]);
            assert_ne!(edge.0, edge.1, "triangle {i} has one vertex twice");
            assert!(
                edges.insert(edge, i).is_none(),
                "edge {edge:?} is there twice"
            );
        }
    }
    edges
}

/// Fails unless every edge has a triangle on either side.
pub(crate) fn assert_without_boundary(triangles: &[[u32; 3]]) {
    let edges = directed_edges(triangles);
    for &(a, b) in edges.keys() {
        assert!(
            edges.contains_key(&(b, a)),
            "edge {a} {b} has a triangle on one side only"
        );
    }
}

/// Fails unless the triangles round each vertex are one ring, so that the surface does not touch
/// itself at a point.
pub(crate) fn assert_one_ring_each(vertices: usize, triangles: &[[u32; 3]]) {
    let mut next: Vec<HashMap<u32, u32>> = vec![HashMap::new(); vertices];
    for t in triangles {
        for k in 0..3 {
            next[t[k] as usize].insert(t[(k + 1) % 3], t[(k + 2) % 3]);
        }
    }
    for (vertex, ring) in next.iter().enumerate() {
        let start = *ring
            .keys()
            .min()
            .unwrap_or_else(|| panic!("vertex {vertex} has no triangle"));
        let (mut at, mut length) = (ring[&start], 1);
        while at != start {
            at = ring[&at];
            length += 1;
        }
        assert_eq!(
            length,
            ring.len(),
            "vertex {vertex} has more rings than one"
        );
    }
}

/// V − E + F.
pub(crate) fn euler_characteristic(vertices: usize, triangles: &[[u32; 3]]) -> i64 {
    let undirected: HashSet<_> = directed_edges(triangles)
        .into_keys()
        .map(|(a, b)| (a.min(b), a.max(b)))
        .collect();
    vertices as i64 - undirected.len() as i64 + triangles.len() as i64
}

/// How many pieces the vertices for which `inside` holds fall into, along the edges between them.
pub(crate) fn pieces(
    vertices: usize,
    triangles: &[[u32; 3]],
    inside: impl Fn(usize) -> bool,
) -> usize {
    let mut root: Vec<usize> = (0..vertices).collect();
    fn find(root: &mut [usize], mut v: usize) -> usize {
        while root[v] != v {
            root[v] = root[root[v]];
            v = root[v];
        }
        v
    }
    for t in triangles {
        for k in 0..3 {
            let (a, b) = (t[k] as usize, t[(k + 1) % 3] as usize);
            if inside(a) && inside(b) {
                let (a, b) = (find(&mut root, a), find(&mut root, b));
                root[a] = b;
            }
        }
    }
    (0..vertices).filter(|&v| inside(v) && root[v] == v).count()
}

/// Volume by the divergence theorem; positive when the triangles face outwards.
pub(crate) fn volume(positions: &[[f64; 3]], triangles: &[[u32; 3]]) -> f64 {
    let corners = triangles
        .iter()
        .map(|t| t.map(|v| Vector::from(positions[v as usize])));
    corners.map(|[a, b, c]| a.dot(b.cross(c)) / 6.0).sum()
}

/// How often the surface goes round a point: 1 inside, 0 outside (A. Van Oosterom, J. Strackee,
/// "The solid angle of a plane triangle", IEEE Transactions on Biomedical Engineering 30, 1983).
pub(crate) fn winding_number(
    positions: &[[f64; 3]],
    triangles: &[[u32; 3]],
    point: [f64; 3],
) -> f64 {
    let mut angle = 0.0;
    for t in triangles {
        let [a, b, c] = t.map(|v| Vector::from(positions[v as usize]) - Vector::from(point));
        let (la, lb, lc) = (a.length(), b.length(), c.length());
        let below = la * lb * lc + a.dot(b) * lc + b.dot(c) * la + c.dot(a) * lb;
        angle += 2.0 * a.dot(b.cross(c)).atan2(below);
    }
    angle / (4.0 * std::f64::consts::PI)
}

/// The least angle of each triangle in degrees, in rising order.
pub(crate) fn least_angles(positions: &[[f64; 3]], triangles: &[[u32; 3]]) -> Vec<f64> {
    let least = |t: &[u32; 3]| {
        let p = t.map(|v| Vector::from(positions[v as usize]));
        let angle = |k: usize| {
            let (u, v) = (p[(k + 1) % 3] - p[k], p[(k + 2) % 3] - p[k]);
            u.cross(v).length().atan2(u.dot(v)).to_degrees()
        };
        angle(0).min(angle(1)).min(angle(2))
    };
    let mut angles: Vec<f64> = triangles.iter().map(least).collect();
    angles.sort_by(f64::total_cmp);
    angles
}
