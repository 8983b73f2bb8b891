//! Points of a body whose distances no rotation changes.

use ga_runtime::vga3::Vector;

use crate::chain::Chain;

/// Two points with a fixed distance.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Link {
    pub(crate) points: [usize; 2],
    pub(crate) length: f64,
}

/// The fixed distances of a body and the joints about which its points rotate.
#[derive(Clone, Debug)]
pub(crate) struct Links {
    pub(crate) links: Vec<Link>,
    /// For each point the joint about which it rotates first.
    pub(super) pivots: Vec<Option<usize>>,
}

impl Links {
    pub(crate) fn new(chain: &Chain<'_>) -> Self {
        let joints = chain.model.skeleton().joints();
        let points = chain.model.points();
        let pivot = |point: usize| {
            let strongest = points[point]
                .joints
                .iter()
                .max_by(|a, b| a.1.total_cmp(&b.1));
            let mut above = strongest.map(|(joint, _)| *joint);
            while let Some(joint) =
                above.filter(|&joint| joints[joint].head == points[point].at_rest)
            {
                above = joints[joint].parent;
            }
            above
        };
        let pivots: Vec<Option<usize>> = (0..points.len()).map(pivot).collect();
        // A point that follows several joints has no fixed distance from any other.
        let is_of_one = |point: usize| points[point].joints.len() == 1;
        let mut links = Vec::new();
        for (to, above) in pivots.iter().enumerate() {
            let Some(above) = above.filter(|_| is_of_one(to)) else {
                continue;
            };
            for from in (0..points.len()).filter(|&from| is_of_one(from)) {
                let is_pivot = points[from].at_rest == joints[above].head;
                let is_beside = from < to && pivots[from] == Some(above);
                let length = Vector::from(points[from].at_rest).distance(points[to].at_rest.into());
                if (is_pivot || is_beside) && length > 0.0 {
                    links.push(Link {
                        points: [from, to],
                        length,
                    });
                }
            }
        }
        Self { links, pivots }
    }

    /// The points with a fixed distance from a point, and these distances.
    pub(super) fn of(&self, point: usize) -> impl Iterator<Item = (usize, f64)> + '_ {
        self.links.iter().filter_map(move |link| match link.points {
            [a, b] if a == point => Some((b, link.length)),
            [a, b] if b == point => Some((a, link.length)),
            _ => None,
        })
    }
}
