//! The choice among candidates that keeps the order along both contours.

use super::candidates::Candidate;

/// What it costs to leave out a point that has candidates, in units of the cost of a point at which
/// the right contour is passed through twice as fast as on average, or not at all.
const OMISSION: f64 = 1.0;

/// The number of points from which the search begins.
const STARTS: usize = 4;

/// For each point of the left contour one of its candidates, or none, so that they run once along
/// the right contour in its order, as evenly as possible. The fractions are the lengths along the
/// contours at their corners.
pub(super) fn in_order(
    candidates: &[Vec<Candidate>],
    left: &[f64],
    right: &[f64],
) -> Vec<Option<Candidate>> {
    let along = |candidate: &Candidate| {
        let start = right[candidate.edge];
        let end = right.get(candidate.edge + 1).copied().unwrap_or(1.0);
        start + candidate.part * (end - start)
    };
    let nodes: Vec<Vec<f64>> = candidates
        .iter()
        .map(|found| found.iter().map(along).collect())
        .collect();
    let mut best: Option<(f64, Vec<[usize; 2]>)> = None;
    for start in starts(&nodes) {
        for choice in 0..nodes[start].len() {
            let path = shortest(&nodes, left, [start, choice]);
            if best.as_ref().is_none_or(|(cost, _)| path.0 < *cost) {
                best = Some(path);
            }
        }
    }
    let mut chosen = vec![None; candidates.len()];
    for [index, choice] in best.map(|(_, path)| path).unwrap_or_default() {
        chosen[index] = Some(candidates[index][choice].clone());
    }
    chosen
}

/// Points with the fewest candidates, far from each other.
fn starts(nodes: &[Vec<f64>]) -> Vec<usize> {
    let count = nodes.len();
    let mut starts: Vec<usize> = (0..STARTS)
        .filter_map(|part| {
            let range = part * count / STARTS..(part + 1) * count / STARTS;
            let middle = (range.start + range.end) / 2;
            let with_any = range.filter(|index| !nodes[*index].is_empty());
            with_any.min_by_key(|index| (nodes[*index].len(), index.abs_diff(middle)))
        })
        .collect();
    starts.dedup();
    starts
}

/// The least sum of costs of a way from a candidate once round to itself, and the way.
fn shortest(
    nodes: &[Vec<f64>],
    left: &[f64],
    [start, choice]: [usize; 2],
) -> (f64, Vec<[usize; 2]>) {
    let count = nodes.len();
    let origin = [left[start], nodes[start][choice]];
    // Along the left contour from the start, and along the right one from its candidate.
    let around = |value: f64, from: f64| (value - from).rem_euclid(1.0);
    let mut visited = vec![Visited {
        node: [start, choice],
        omitted: 0.0,
        place: [0.0; 2],
        cost: 0.0,
        before: 0,
    }];
    let each = OMISSION / count as f64;
    let mut omitted = 0.0;
    for step in 1..=count {
        let index = (start + step) % count;
        let is_end = step == count;
        let first_of_index = visited.len();
        for (other, value) in nodes[index].iter().enumerate() {
            if is_end && other != choice {
                continue;
            }
            let place = if is_end {
                [1.0; 2]
            } else {
                [around(left[index], origin[0]), around(*value, origin[1])]
            };
            let costs = visited[..first_of_index].iter().enumerate();
            let nearest = costs
                .filter(|(_, from)| from.place[1] < place[1])
                .map(|(before, from)| {
                    let [ahead, aside] = [0, 1].map(|k| place[k] - from.place[k]);
                    let uneven = (aside - ahead) * (aside - ahead) / ahead.max(f64::EPSILON);
                    (from.cost + uneven + omitted - from.omitted, before)
                })
                .min_by(|a, b| a.0.total_cmp(&b.0));
            if let Some((cost, before)) = nearest {
                visited.push(Visited {
                    node: [index, other],
                    omitted: 0.0,
                    place,
                    cost,
                    before,
                });
            }
        }
        if !nodes[index].is_empty() {
            omitted += each;
        }
        for added in &mut visited[first_of_index..] {
            added.omitted = omitted;
        }
    }
    let Some(mut at) = visited
        .iter()
        .rposition(|visited| visited.place == [1.0; 2])
    else {
        return (f64::INFINITY, Vec::new());
    };
    let cost = visited[at].cost;
    let mut path = Vec::new();
    while at != 0 {
        at = visited[at].before;
        path.push(visited[at].node);
    }
    (cost, path)
}

/// A candidate that is reached from the start.
struct Visited {
    /// The point of the left contour and the number of its candidate.
    node: [usize; 2],
    /// The cost of omitting all points with candidates from the start up to this one.
    omitted: f64,
    /// The lengths along both contours from the start.
    place: [f64; 2],
    cost: f64,
    /// From where it is reached.
    before: usize,
}
