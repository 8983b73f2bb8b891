//! Where the top of a head is.

use ga_runtime::vga3::Vector;

use super::Source;
use super::convention::word_ranges;
use crate::skeleton::Skeleton;

/// The way from the head to its top in the axes of the head: to the End Site, or to a joint below
/// it whose name says that it is an end.
pub(super) fn top_of_head(source: &dyn Source, head: usize) -> Option<Vector<f64>> {
    let end = source.ends().get(head).copied().flatten();
    let end = end.map(Vector::from).filter(|end| end.length() > 0.0);
    end.or_else(|| {
        let places = source.rest_positions();
        let places: Vec<Vector<f64>> = places.into_iter().map(Vector::from).collect();
        top(&source.names(), &source.parents(), &places, head)
    })
}

/// The same of a skeleton at rest.
pub(super) fn top_joint(skeleton: &Skeleton, head: usize) -> Option<Vector<f64>> {
    let joints = skeleton.joints().iter();
    let names: Vec<&str> = joints.clone().map(|joint| joint.name.as_str()).collect();
    let parents: Vec<Option<usize>> = joints.clone().map(|joint| joint.parent).collect();
    let places: Vec<Vector<f64>> = joints.map(|joint| joint.head.into()).collect();
    top(&names, &parents, &places, head)
}

fn top(
    names: &[&str],
    parents: &[Option<usize>],
    places: &[Vector<f64>],
    head: usize,
) -> Option<Vector<f64>> {
    let is_end = |joint: usize| {
        word_ranges(names[joint]).into_iter().any(|range| {
            let word = names[joint][range].to_ascii_lowercase();
            ["end", "top", "nub", "tip"].contains(&word.as_str())
        })
    };
    let mut below = (0..names.len()).filter(|&joint| parents[joint] == Some(head));
    let end = below.find(|&joint| is_end(joint))?;
    let way = places[end] - places[head];
    (way.length() > 0.0).then_some(way)
}
