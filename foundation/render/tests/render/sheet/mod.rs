//! Contact sheets, taken apart again.

mod refused;
mod shadow;

use crate::{Pixels, enumerated};
use ga_image::plane::Plane;
use ga_render::sheet::{
    Caption, Frame, Framing, Kind, Layout, Options, Sequence, Sheet, SheetError, contact_sheet,
};
use ga_render::{RenderError, Scene, Style, ViewDirection};
use proptest::prelude::*;

const TRIANGLES: [[u32; 3]; 8] = [
    [0, 2, 4],
    [2, 1, 4],
    [1, 3, 4],
    [3, 0, 4],
    [2, 0, 5],
    [1, 2, 5],
    [3, 1, 5],
    [0, 3, 5],
];

/// An octahedron, slim and upright like a figure.
fn octahedron([x, y, z]: [f64; 3]) -> Vec<[f64; 3]> {
    vec![
        [x + 0.3, y, z],
        [x - 0.3, y, z],
        [x, y, z - 0.2],
        [x, y, z + 0.2],
        [x, y + 1.0, z],
        [x, y - 1.0, z],
    ]
}

/// `keys` key frames with `between` frames between each two.
fn kinds(keys: usize, between: usize) -> Vec<Kind> {
    let steps = between + 1;
    (0..=(keys - 1) * steps)
        .map(|frame| match frame % steps {
            0 => Kind::Key,
            step => Kind::InBetween { step, steps },
        })
        .collect()
}

fn frames<'a>(kinds: &[Kind], positions: &'a [Vec<[f64; 3]>]) -> Vec<Frame<'a>> {
    let numbered = kinds.iter().zip(positions).enumerate();
    numbered
        .map(|(number, (&kind, positions))| Frame {
            caption: Caption {
                number,
                time: number as f64 / 30.0,
                kind,
            },
            positions,
            bones: &[],
        })
        .collect()
}

fn walk(count: usize, step: [f64; 3]) -> Vec<Vec<[f64; 3]>> {
    (0..count)
        .map(|i| octahedron(step.map(|c| c * i as f64)))
        .collect()
}

fn small() -> Options {
    Options {
        style: Style {
            width: 48,
            height: 64,
            supersampling: 2,
            ..Style::default()
        },
        depth: false,
        ..Options::default()
    }
}

fn sheet(kinds: &[Kind], positions: &[Vec<[f64; 3]>], options: &Options) -> Sheet {
    contact_sheet(&frames(kinds, positions), &TRIANGLES, options).unwrap()
}

/// The top left corners of all copies of a picture on a sheet, in reading order.
fn places(sheet: &Plane<[u8; 3]>, picture: &Plane<[u8; 3]>) -> Vec<(u32, u32)> {
    let size = |plane: &Plane<[u8; 3]>| [plane.width(), plane.height()].map(|size| size as u32);
    let ([width, height], [columns, rows]) = (size(picture), size(sheet));
    let mut places = Vec::new();
    for y in 0..=rows - height {
        for x in 0..=columns - width {
            let equal = |(column, row, pixel): (u32, u32, [u8; 3])| {
                sheet.pixel(x + column, y + row) == pixel
            };
            if enumerated(picture).all(equal) {
                places.push((x, y));
            }
        }
    }
    places
}

fn colours_beside(sheet: &Plane<[u8; 3]>, (x, y): (u32, u32)) -> Vec<[u8; 3]> {
    (1..=3).map(|d| sheet.pixel(x - d, y - d)).collect()
}

#[test]
fn rows_run_from_key_to_key() {
    let kinds = kinds(3, 3);
    let sheet = sheet(&kinds, &walk(9, [0.1, 0.02, 0.0]), &small());
    assert_eq!(sheet.pictures.len(), 9);
    let found: Vec<_> = sheet
        .pictures
        .iter()
        .map(|p| places(&sheet.image, &p.colour))
        .collect();
    // The key in the middle ends the first row and begins the second.
    let copies: Vec<usize> = found.iter().map(Vec::len).collect();
    assert_eq!(copies, [1, 1, 1, 1, 2, 1, 1, 1, 1]);
    let (first, second) = (found[0][0].1, found[8][0].1);
    assert!(second > first + 64);
    assert_eq!(found[4][0].1, first);
    assert_eq!(found[4][1], (found[0][0].0, second));
    let columns: Vec<u32> = (0..5).map(|i| found[i][0].0).collect();
    assert!(
        columns
            .windows(2)
            .all(|pair| pair[1] - pair[0] == columns[1] - columns[0])
    );
    assert!(columns[1] - columns[0] > 48);

    let beside = |index: usize| colours_beside(&sheet.image, found[index][0]);
    assert!(beside(0).iter().all(|c| c == &beside(0)[0]));
    for (index, kind) in kinds.iter().enumerate() {
        assert_eq!(
            beside(index) == beside(0),
            *kind == Kind::Key,
            "frame {index}"
        );
    }
}

#[test]
fn columns_hold_each_frame_once() {
    let options = Options {
        layout: Layout::Columns(4),
        ..small()
    };
    let sheet = sheet(&kinds(3, 3), &walk(9, [0.1, 0.02, 0.0]), &options);
    let found: Vec<_> = sheet
        .pictures
        .iter()
        .map(|p| places(&sheet.image, &p.colour))
        .collect();
    assert!(found.iter().all(|places| places.len() == 1));
    let at = |index: usize| found[index][0];
    assert_eq!((at(0).0, at(0).1), (at(4).0, at(3).1));
    assert_eq!(at(8).0, at(0).0);
    assert!(at(0).1 < at(4).1 && at(4).1 < at(8).1);
}

#[test]
fn depth_pictures_stand_under_their_pictures_and_share_a_range() {
    let options = Options {
        depth: true,
        framing: Framing::Fixed,
        ..small()
    };
    let positions = walk(2, [0.0, 0.0, 1.5]);
    let sheet = sheet(&[Kind::Key; 2], &positions, &options);
    let (near, far) = sheet.depth_range.unwrap();
    let ranges: Vec<_> = sheet
        .pictures
        .iter()
        .map(|p| p.depth.range().unwrap())
        .collect();
    assert_eq!((near, far), (ranges[1].0, ranges[0].1));
    // The label stands on the first column only.
    let depth = sheet.pictures[1].depth.to_plane(near, far);
    let depth = depth.map(|grey| [grey; 3]);
    let (above, below) = (
        places(&sheet.image, &sheet.pictures[1].colour),
        places(&sheet.image, &depth),
    );
    assert_eq!((above.len(), below.len()), (1, 1));
    assert_eq!(above[0].0, below[0].0);
    assert!(below[0].1 > above[0].1 + 64);
}

#[test]
fn captions_of_keys_and_of_frames_between_have_their_own_colours() {
    let sheet = sheet(&kinds(2, 1), &walk(3, [0.1, 0.0, 0.0]), &small());
    let ink = |index: usize| -> Vec<[u8; 3]> {
        let (x, y) = places(&sheet.image, &sheet.pictures[index].colour)[0];
        let caption =
            (y + 64 + 6..y + 64 + 24).flat_map(|row| (x..x + 48).map(move |column| (column, row)));
        caption.map(|(x, y)| sheet.image.pixel(x, y)).collect()
    };
    let orange = |c: &[u8; 3]| i32::from(c[0]) - i32::from(c[2]) > 100;
    let blue = |c: &[u8; 3]| i32::from(c[2]) - i32::from(c[0]) > 30;
    assert!(ink(0).iter().any(orange) && !ink(0).iter().any(blue));
    assert!(ink(1).iter().any(blue) && !ink(1).iter().any(orange));
}

#[test]
fn a_title_adds_its_line() {
    let (kinds, positions) = (kinds(2, 1), walk(3, [0.1, 0.0, 0.0]));
    let plain = sheet(&kinds, &positions, &small());
    let titled = sheet(
        &kinds,
        &positions,
        &Options {
            title: "Title".into(),
            ..small()
        },
    );
    assert_eq!(plain.image.width(), titled.image.width());
    assert!(titled.image.height() > plain.image.height());
}

#[test]
fn the_ground_lies_under_the_lowest_vertex_or_where_it_is_asked_for() {
    let (kinds, positions) = (kinds(2, 1), walk(3, [0.1, 0.2, 0.0]));
    // Without a shadow the camera does not depend on the height of the ground.
    let style = Style {
        shadow: 0.0,
        ..small().style
    };
    let with = |ground| {
        let options = Options {
            ground,
            style,
            ..small()
        };
        sheet(&kinds, &positions, &options)
    };
    assert_eq!(with(None).image, with(Some(-1.0)).image);
    let covered = |sheet: &Sheet| {
        let depth = &sheet.pictures[0].depth;
        (0..64)
            .flat_map(|y| (0..48).map(move |x| depth.coverage(x, y)))
            .sum::<f64>()
    };
    // Half of the first figure is below the ground at its middle.
    let share = covered(&with(Some(0.0))) / covered(&with(None));
    assert!((0.3..0.7).contains(&share), "{share}");
    assert!(matches!(
        contact_sheet(
            &frames(&kinds, &positions),
            &TRIANGLES,
            &Options {
                ground: Some(f64::NAN),
                ..small()
            }
        ),
        Err(SheetError::Frame {
            source: RenderError::Ground,
            ..
        })
    ));
}

#[test]
fn the_number_of_threads_changes_nothing() {
    let (kinds, positions) = (kinds(3, 3), walk(9, [0.1, 0.02, 0.3]));
    let with = |threads: usize| {
        let pool = rayon::ThreadPoolBuilder::new()
            .num_threads(threads)
            .build()
            .unwrap();
        pool.install(|| sheet(&kinds, &positions, &small()).image)
    };
    assert_eq!(with(1), with(4));
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(12))]

    /// The border of every picture is free of the figure, and some picture uses its room.
    #[test]
    fn the_whole_figure_is_in_every_picture(
        step in prop::array::uniform3(-0.5f64..0.5),
        azimuth in -3f64..3.0,
        elevation in 0f64..0.8,
        fixed in any::<bool>(),
    ) {
        let options = Options {
            view: ViewDirection { azimuth, elevation },
            framing: if fixed { Framing::Fixed } else { Framing::Following },
            layout: Layout::Columns(3),
            ..small()
        };
        let positions = walk(3, step);
        let sheet = sheet(&kinds(2, 1), &positions, &options);
        let mut reach = 0f64;
        for picture in &sheet.pictures {
            for row in 0..64 {
                for column in 0..48 {
                    if picture.depth.coverage(column, row) > 0.0 {
                        let x = (f64::from(column) + 0.5) / 24.0 - 1.0;
                        let y = (f64::from(row) + 0.5) / 32.0 - 1.0;
                        reach = reach.max(x.abs()).max(y.abs());
                    }
                }
            }
        }
        prop_assert!(reach < 0.93, "{reach}");
        prop_assert!(reach > 0.78, "{reach}");
    }

    /// A camera that goes along sees a figure that only moves along the ground stand still.
    #[test]
    fn following_cancels_level_motion(x in -2f64..2.0, z in -2f64..2.0) {
        let positions = walk(2, [x, 0.0, z]);
        let sheet = sheet(&[Kind::Key; 2], &positions, &small());
        let [a, b] = [&sheet.pictures[0].depth, &sheet.pictures[1].depth];
        for row in 0..64 {
            for column in 0..48 {
                // Rounding may move a sample across an edge.
                prop_assert!((a.coverage(column, row) - b.coverage(column, row)).abs() < 0.3);
            }
        }
        let (near, far) = (a.range().unwrap(), b.range().unwrap());
        prop_assert!((near.0 - far.0).abs() < 0.02 && (near.1 - far.1).abs() < 0.02);
    }
}

/// Drawn one after the other, as for a film.
#[test]
fn a_film_shows_the_pictures_of_a_sheet() {
    for (framing, azimuth) in [
        (Framing::Fixed, 0.4),
        (Framing::Following, 2.0),
        (Framing::Following, 4.5),
    ] {
        let options = Options {
            layout: Layout::Columns(5),
            framing,
            view: ViewDirection {
                azimuth,
                elevation: 0.2,
            },
            ..small()
        };
        let positions: Vec<Vec<[f64; 3]>> = (0..5)
            .map(|i| {
                let mut corners = octahedron([0.3 * f64::from(i), 0.02, 0.1]);
                corners[i as usize][0] += 0.4;
                corners
            })
            .collect();
        let kinds = [Kind::Key; 5];
        let frames = frames(&kinds, &positions);
        let mut sequence = Sequence::new(options.clone());
        for frame in &frames {
            sequence.add(frame).unwrap();
        }
        let shooting = sequence.shoot().unwrap();
        let sheet = sheet(&kinds, &positions, &options);
        for (index, frame) in frames.iter().enumerate() {
            let scene = Scene::new(frame.positions, &TRIANGLES);
            let picture = shooting.picture(index, &scene).unwrap();
            assert_eq!(picture.colour, sheet.pictures[index].colour);
        }
        assert!(matches!(
            shooting.picture(5, &Scene::default()),
            Err(SheetError::NoFrames)
        ));
    }
    let sequence = Sequence::new(small());
    assert!(matches!(
        sequence.shoot().map(|_| ()),
        Err(SheetError::NoFrames)
    ));
}
