//! Tags in pictures.

use ga_image::plane::{Plane, PlaneView};
use ga_image::sample::Sample;

use super::marker::{Tag, TagOptions};
use super::{code, edge, quad};

/// The tags in a grey picture, by their numbers and then from the top left. What is not one of the
/// dictionary is left out. Modules should be 2.5 pixels wide or wider, and tags must have a bright
/// margin; they are not seen in a mirror.
///
/// ```
/// use ga_image::plane::Plane;
/// use ga_vision::tag::{Dictionary, TagOptions, detect};
///
/// // Tag 7 with modules of 8 pixels, in a border of one module, from (40, 30) on.
/// let dictionary = Dictionary::Aruco4x4_50;
/// let modules = dictionary.modules(7).ok_or("no such tag")?;
/// let picture = Plane::from_fn(160, 120, |column: usize, row: usize| {
///     let at = [column.wrapping_sub(40) / 8, row.wrapping_sub(30) / 8];
///     match at {
///         [1..5, 1..5] if modules[(at[1] - 1) * 4 + at[0] - 1] => 230u8,
///         [0..6, 0..6] => 20,
///         _ => 230,
///     }
/// });
/// let tags = detect(&picture, TagOptions { dictionary, border: 1 });
/// assert_eq!((tags.len(), tags[0].id, tags[0].hamming), (1, 7, 0));
/// let [u, v] = tags[0].corners[0];
/// assert!((u - 39.5).abs() < 0.05 && (v - 29.5).abs() < 0.05);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[must_use]
pub fn detect<'a, T: Sample>(
    picture: impl Into<PlaneView<'a, T>>,
    options: TagOptions,
) -> Vec<Tag> {
    in_levels(&picture.into().map(Sample::to_level), options)
}

/// The tags in a picture of levels from 0 to 255.
pub(super) fn in_levels(levels: &Plane<f32>, options: TagOptions) -> Vec<Tag> {
    let modules = (options.dictionary.side() + 2 * usize::from(options.border)) as f64;
    let mut tags: Vec<Tag> = Vec::new();
    for quad in quad::quads(levels) {
        let longest = edge::lengths(&quad).into_iter().fold(0.0, f64::max);
        let refined = edge::refined(levels, quad, longest / modules);
        let Some(read) = refined.and_then(|quad| code::read(levels, quad, options)) else {
            continue;
        };
        // The same tag is found at several thresholds.
        let is_same = |tag: &Tag| {
            let apart = edge::distance(tag.centre(), read.centre());
            apart < 0.3 * tag.longest_edge().max(read.longest_edge())
        };
        match tags.iter_mut().find(|tag| is_same(tag)) {
            Some(other) if read.hamming < other.hamming => *other = read,
            Some(_) => {}
            None => tags.push(read),
        }
    }
    tags.sort_by(|a, b| {
        let [p, q] = [a.centre(), b.centre()];
        a.id.cmp(&b.id)
            .then((p[0] + p[1]).total_cmp(&(q[0] + q[1])))
    });
    tags
}
