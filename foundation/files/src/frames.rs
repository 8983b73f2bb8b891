//! Pictures of several cameras that belong together, by the numbers in their names.

use std::collections::BTreeMap;
use std::path::PathBuf;

use super::list::{Number, natural_order, numbers};

/// Files of several cameras, frame by frame.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Frames {
    /// For each frame the file of each camera, where it has one; in the order of the numbers.
    pub frames: Vec<Vec<Option<PathBuf>>>,
    /// What says which files belong together.
    pub by: FramesBy,
}

/// What says which files of several cameras belong together.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum FramesBy {
    /// The numbers in their names.
    Numbers,
    /// Their places in the natural order of the names.
    Places,
}

/// Why files of several cameras make no frames.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error(
    "{} files do not belong together: the numbers in their names differ, and so do their counts",
    counted(.counts)
)]
pub struct FramesError {
    /// How many files each camera has.
    pub counts: Vec<usize>,
}

fn counted(counts: &[usize]) -> String {
    let counts: Vec<String> = counts.iter().map(usize::to_string).collect();
    counts.join(" and ")
}

/// The files of several cameras in frames: those whose names have the same numbers, as
/// `left7.png` and `right007.png`. A number that is the same in all names of each camera, such as
/// that of the camera or of the day, does not count.
///
/// Where less than half of the files of the camera with the fewest find others, as names with
/// times do, the files belong together by their places in [natural order](natural_order).
///
/// # Errors
/// [`FramesError`]: then the cameras must have as many files each.
///
/// ```
/// use ga_files::{FramesBy, frames};
/// let lists = [
///     ["0-7.png", "0-8.png", "0-9.png"].map(Into::into).to_vec(),
///     ["1-008.png", "1-009.png", "1-010.png"].map(Into::into).to_vec(),
/// ];
/// let found = frames(lists)?;
/// assert_eq!(found.by, FramesBy::Numbers);
/// assert_eq!(found.frames[0], [Some("0-7.png".into()), None]);
/// assert_eq!(found.frames[1], [Some("0-8.png".into()), Some("1-008.png".into())]);
/// # Ok::<(), ga_files::FramesError>(())
/// ```
pub fn frames(cameras: impl Into<Vec<Vec<PathBuf>>>) -> Result<Frames, FramesError> {
    let mut cameras = cameras.into();
    for files in &mut cameras {
        natural_order(files);
        files.dedup();
    }
    if let Some(frames) = by_numbers(&cameras) {
        return Ok(Frames {
            frames,
            by: FramesBy::Numbers,
        });
    }
    let counts: Vec<usize> = cameras.iter().map(Vec::len).collect();
    let count = counts.first().copied().unwrap_or(0);
    if counts.iter().any(|other| *other != count) {
        return Err(FramesError { counts });
    }
    let frame = |place: usize| {
        cameras
            .iter()
            .map(|files| Some(files[place].clone()))
            .collect()
    };
    Ok(Frames {
        frames: (0..count).map(frame).collect(),
        by: FramesBy::Places,
    })
}

/// The frames, where the numbers of most files are those of others.
fn by_numbers(cameras: &[Vec<PathBuf>]) -> Option<Vec<Vec<Option<PathBuf>>>> {
    let keys = keys(cameras);
    let mut frames: BTreeMap<&[Number], Vec<Option<PathBuf>>> = BTreeMap::new();
    for (camera, (files, keys)) in cameras.iter().zip(&keys).enumerate() {
        for (file, key) in files.iter().zip(keys) {
            let empty = || vec![None; cameras.len()];
            let place = &mut frames.entry(key.as_slice()).or_insert_with(empty)[camera];
            // Two files of one camera with the same numbers.
            if place.replace(file.clone()).is_some() {
                return None;
            }
        }
    }
    let shared = |frame: &&Vec<Option<PathBuf>>| frame.iter().flatten().count() > 1;
    let shared = frames.values().filter(shared).count();
    let fewest = cameras.iter().map(Vec::len).min().unwrap_or(0);
    let most_find_others = shared > 0 && 2 * shared >= fewest;
    most_find_others.then(|| frames.into_values().collect())
}

/// For each file of each camera the numbers that tell it from the others, counted from the end of
/// the name.
fn keys(cameras: &[Vec<PathBuf>]) -> Vec<Vec<Vec<Number>>> {
    let all: Vec<Vec<Vec<Number>>> = cameras
        .iter()
        .map(|files| files.iter().map(|file| numbers(file)).collect())
        .collect();
    let count = all.iter().flatten().map(Vec::len).min().unwrap_or(0);
    let from_end = |numbers: &[Number], place: usize| numbers[numbers.len() - 1 - place].clone();
    let varies = |place: &usize| {
        let is_varied = |files: &Vec<Vec<Number>>| {
            let mut values = files.iter().map(|numbers| from_end(numbers, *place));
            let first = values.next();
            values.any(|value| Some(value) != first)
        };
        all.iter().any(is_varied)
    };
    let places: Vec<usize> = (0..count).rev().filter(varies).collect();
    let key = |numbers: &Vec<Number>| {
        places
            .iter()
            .map(|place| from_end(numbers, *place))
            .collect()
    };
    all.iter()
        .map(|files| files.iter().map(key).collect())
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn found<const N: usize>(cameras: [&[&str]; N]) -> Result<Frames, FramesError> {
        let files = |names: &&[&str]| names.iter().map(PathBuf::from).collect();
        frames(cameras.iter().map(files).collect::<Vec<_>>())
    }

    /// The frames as text, with `-` for a camera without a file.
    fn shown<const N: usize>(cameras: [&[&str]; N]) -> Vec<String> {
        let name = |file: &Option<PathBuf>| match file {
            Some(path) => path.display().to_string(),
            None => "-".to_owned(),
        };
        let line = |frame: &Vec<_>| frame.iter().map(name).collect::<Vec<_>>().join(" ");
        found(cameras).unwrap().frames.iter().map(line).collect()
    }

    #[test]
    fn files_that_are_missing_leave_their_partner_alone() {
        let left = ["left01.jpg", "left02.jpg", "left04.jpg"];
        let right = ["right01.jpg", "right03.jpg", "right04.jpg"];
        let expected = [
            "left01.jpg right01.jpg",
            "left02.jpg -",
            "- right03.jpg",
            "left04.jpg right04.jpg",
        ];
        assert_eq!(shown([&left, &right]), expected);
    }

    /// Of six files of the camera with the fewest, three find a partner; where only two do, numbers
    /// say nothing, and the order does.
    #[test]
    fn half_of_the_files_must_find_others() {
        let names = |camera: &str, numbers: [u32; 6]| {
            numbers.map(|number| format!("{camera}{number:02}.png"))
        };
        let left = names("l", [1, 2, 3, 4, 5, 6]);
        for (others, expected) in [
            ([4, 5, 6, 7, 8, 9], FramesBy::Numbers),
            ([5, 6, 7, 8, 9, 10], FramesBy::Places),
        ] {
            let right = names("r", others);
            let cameras = [&left, &right].map(|names| names.each_ref().map(String::as_str));
            let found = found([&cameras[0], &cameras[1]]).unwrap();
            assert_eq!(found.by, expected, "{others:?}");
        }
    }

    #[test]
    fn zeros_before_a_number_and_other_orders_do_not_matter() {
        let (left, right) = (["l10.png", "l9.png", "l9.png"], ["r0009.png", "r0010.png"]);
        assert_eq!(
            shown([&left, &right]),
            ["l9.png r0009.png", "l10.png r0010.png"]
        );
    }

    #[test]
    fn the_number_of_the_camera_and_of_the_day_do_not_count() {
        let left = ["cam0-day3-1.png", "cam0-day3-2.png"];
        let right = ["cam1-day3-1.png", "cam1-day3-2.png"];
        let third = ["cam12-day3-2.png", "cam12-day3-3.png"];
        let expected = [
            "cam0-day3-1.png cam1-day3-1.png -",
            "cam0-day3-2.png cam1-day3-2.png cam12-day3-2.png",
            "- - cam12-day3-3.png",
        ];
        assert_eq!(shown([&left, &right, &third]), expected);
        // Only the last numbers can be compared where one camera has more of them.
        let other = ["1.png", "2.png"];
        let expected = ["cam0-day3-1.png 1.png", "cam0-day3-2.png 2.png"];
        assert_eq!(shown([&left, &other]), expected);
    }

    #[test]
    fn several_numbers_count_together() {
        let left = ["l1-1.png", "l1-2.png", "l2-1.png"];
        let right = ["r1-1.png", "r2-1.png", "r2-2.png"];
        let expected = [
            "l1-1.png r1-1.png",
            "l1-2.png -",
            "l2-1.png r2-1.png",
            "- r2-2.png",
        ];
        assert_eq!(shown([&left, &right]), expected);
    }

    #[test]
    fn names_with_times_belong_together_by_their_places() {
        let left = ["12_00_01.250.png", "12_00_02.251.png"];
        let right = ["12_00_01.252.png", "12_00_02.249.png"];
        let found = found([&left, &right]).unwrap();
        assert_eq!(found.by, FramesBy::Places);
        assert_eq!(found.frames[1][1], Some("12_00_02.249.png".into()));
        // So do names without numbers, and one file each.
        assert_eq!(
            shown([&["a.png", "b.png"], &["c.png", "d.png"]]),
            ["a.png c.png", "b.png d.png"]
        );
        assert_eq!(shown([&["a1.png"], &["b2.png"]]), ["a1.png b2.png"]);
    }

    #[test]
    fn other_counts_without_common_numbers_are_refused() {
        let error = found([&["a1.png", "a2.png"], &["b3.png", "b4.png", "b5.png"]]).unwrap_err();
        assert_eq!(error.counts, [2, 3]);
        assert!(
            error
                .to_string()
                .starts_with("2 and 3 files do not belong together")
        );
    }
}
