//! Which of the tags in a picture are those of one board.

use ga_runtime::vga2::Vector;

use super::marker::Tag;
use crate::homography::Homography;

/// Where the corners of a tag are on a board, in the order of [`Tag::corners`].
pub(super) type Places = [[f64; 2]; 4];

/// So many tags that are nearest on the board are asked whether a tag is where it should be.
const NEIGHBOURS: usize = 4;
/// The greatest distance of the centre of a tag from where another one suggests it, as a part of
/// its longest edge. The homography of a small tag says less of what is far from it.
const GREATEST: f64 = 0.5;

/// More tags than one, and than this part of them, that are elsewhere mean another board whose tags
/// have the same numbers.
const ELSEWHERE: f64 = 0.1;

/// A tag of a board in a picture.
pub(super) struct Placed {
    pub(super) tag: Tag,
    pub(super) places: Places,
    /// From the board to the picture, by the corners of this tag.
    pub(super) homography: Homography,
}

/// The tags of a board that agree with each other on where it is: the greatest set in which each is
/// where one beside it suggests it. None, where several tags are seen and no two agree or many are
/// elsewhere, and no tag that is seen twice.
pub(super) fn consistent(tags: Vec<Tag>, places: impl Fn(usize) -> Option<Places>) -> Vec<Placed> {
    let placed = tags.into_iter().filter_map(|tag| {
        let places = places(tag.id)?;
        let homography = Homography::from_pairs(&places, &tag.corners)?;
        Some(Placed {
            tag,
            places,
            homography,
        })
    });
    let mut placed: Vec<Placed> = placed.collect();
    let count = placed.len();
    let mut groups: Vec<usize> = (0..count).collect();
    for index in 0..count {
        let here = centre(&placed[index].places);
        let mut others: Vec<usize> = (0..count).filter(|other| *other != index).collect();
        let apart = |other: &usize| (centre(&placed[*other].places) - here).length();
        others.sort_by(|a, b| apart(a).total_cmp(&apart(b)));
        for other in others.into_iter().take(NEIGHBOURS) {
            let agrees = predicts(&placed[index], &placed[other])
                && predicts(&placed[other], &placed[index]);
            if agrees {
                let (from, to) = (groups[other], groups[index]);
                groups
                    .iter_mut()
                    .filter(|group| **group == from)
                    .for_each(|group| *group = to);
            }
        }
    }
    let size = |group: usize| groups.iter().filter(|other| **other == group).count();
    // Of groups of one size the first counts.
    let best = (0..count).rev().max_by_key(|index| size(groups[*index]));
    let Some(best) = best.filter(|best| size(groups[*best]) > 1 || count == 1) else {
        return Vec::new();
    };
    let best = groups[best];
    let elsewhere = count - size(best);
    if elsewhere > 1 && elsewhere as f64 > ELSEWHERE * count as f64 {
        return Vec::new();
    }
    let mut index = 0;
    placed.retain(|_| {
        index += 1;
        groups[index - 1] == best
    });
    let ids: Vec<usize> = placed.iter().map(|placed| placed.tag.id).collect();
    let is_single = |id: usize| ids.iter().filter(|other| **other == id).count() == 1;
    placed.retain(|placed| is_single(placed.tag.id));
    placed
}

/// Whether a tag is where another one suggests it.
fn predicts(from: &Placed, to: &Placed) -> bool {
    let Some(seen) = from.homography.apply(centre(&to.places).coordinates()) else {
        return false;
    };
    let apart = (Vector::from(seen) - Vector::from(to.tag.centre())).length();
    apart <= GREATEST * to.tag.longest_edge()
}

fn centre(places: &Places) -> Vector<f64> {
    places
        .iter()
        .fold(Vector::default(), |sum, place| sum + Vector::from(*place))
        * 0.25
}
