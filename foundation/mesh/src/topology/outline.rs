//! How a face names its vertices.

use std::collections::{HashMap, HashSet};

/// How a face names its vertices.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Outline {
    /// Each once.
    Simple,
    /// Each once on one of several rings, which are joined by bridges: edges along which the face
    /// runs there and back.
    Keyhole,
    /// Some twice, without need.
    Repeated,
}

impl Outline {
    /// The outline of a face with these vertices.
    pub(super) fn of(face: &[u32]) -> Self {
        if let [a, b, c] = face {
            let is_repeated = a == b || b == c || c == a;
            return if is_repeated {
                Self::Repeated
            } else {
                Self::Simple
            };
        }
        let mut sorted = face.to_vec();
        sorted.sort_unstable();
        match sorted.windows(2).any(|pair| pair[0] == pair[1]) {
            true if is_keyhole(face) => Self::Keyhole,
            true => Self::Repeated,
            false => Self::Simple,
        }
    }
}

/// Whether the face is rings that bridges join as the edges of a tree: with rings and vertices
/// between bridges as its nodes there is one bridge less than nodes, and no bridge ends without a
/// ring.
fn is_keyhole(face: &[u32]) -> bool {
    let next = face.iter().cycle().skip(1);
    let sides: Vec<[u32; 2]> = face.iter().zip(next).map(|(&a, &b)| [a, b]).collect();
    let known: HashSet<[u32; 2]> = sides.iter().copied().collect();
    let is_plain = sides.iter().all(|[a, b]| a != b) && known.len() == sides.len();
    let is_bridge = |&&[a, b]: &&[u32; 2]| known.contains(&[b, a]);
    let mut on_ring: HashMap<u32, u32> = HashMap::new();
    let mut rings = sides.iter().filter(|side| !is_bridge(side));
    let is_once = rings.all(|&[from, to]| on_ring.insert(from, to).is_none());
    let mut bridges_at: HashMap<u32, usize> = HashMap::new();
    for [from, _] in sides.iter().filter(is_bridge) {
        *bridges_at.entry(*from).or_default() += 1;
    }
    let goes_on = |(vertex, &count): (&u32, &usize)| count > 1 || on_ring.contains_key(vertex);
    let between = bridges_at
        .keys()
        .filter(|vertex| !on_ring.contains_key(vertex));
    let nodes = ring_count(&on_ring) + between.count();
    let bridges = bridges_at.values().sum::<usize>() / 2;
    is_plain && is_once && bridges_at.iter().all(goes_on) && bridges + 1 == nodes
}

/// How many rings there are, where each vertex on one has a next one.
fn ring_count(next: &HashMap<u32, u32>) -> usize {
    let mut left: HashSet<u32> = next.keys().copied().collect();
    let mut count = 0;
    while let Some(&first) = left.iter().next() {
        count += 1;
        let mut vertex = first;
        while left.remove(&vertex) {
            match next.get(&vertex) {
                Some(&after) => vertex = after,
                None => break,
            }
        }
    }
    count
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn holes_behind_bridges_are_told_from_vertices_that_are_named_twice() {
        // One hole, two holes from one vertex, a hole behind a hole, a bridge of two edges.
        for face in [
            &[0, 1, 2, 3, 0, 4, 5, 6, 7, 4][..],
            &[0, 1, 2, 0, 3, 4, 5, 3, 0, 6, 7, 8, 6],
            &[0, 1, 2, 0, 3, 4, 6, 7, 8, 6, 4, 5, 3],
            &[0, 1, 2, 0, 9, 3, 4, 5, 3, 9],
        ] {
            assert_eq!(Outline::of(face), Outline::Keyhole, "{face:?}");
            let mut reversed = face.to_vec();
            reversed.reverse();
            reversed.rotate_left(3);
            assert_eq!(Outline::of(&reversed), Outline::Keyhole, "{face:?}");
        }
        // A corner twice in a row, a vertex on two rings without a bridge, a way there and back
        // to a vertex alone, the same side twice, no ring at all, a ring with a diagonal that is
        // passed there and back, and two bridges between two rings.
        for face in [
            &[0, 0, 1, 2][..],
            &[0, 1, 2, 0, 3, 4],
            &[0, 1, 2, 3, 2],
            &[0, 1, 2, 0, 1, 3],
            &[0, 1, 0, 1],
            &[0, 1, 2, 1],
            &[0, 1, 0],
            &[0, 2, 0, 1, 2, 3],
            &[0, 3, 5, 4, 1, 2, 0, 1, 4, 3],
        ] {
            assert_eq!(Outline::of(face), Outline::Repeated, "{face:?}");
        }
        assert_eq!(Outline::of(&[0, 1, 2]), Outline::Simple);
        assert_eq!(Outline::of(&[0, 1, 2, 3]), Outline::Simple);
    }
}
