//! Chessboards in photographs against OpenCV, and in rendered pictures against the truth.

use ga_image::filter::{Border, Gaussian};
use ga_image::grey::Luma;
use ga_image::plane::Plane;
use ga_runtime::cga3::{Motor, Point, Rotor, Translator};
use ga_vision::board::{Board, Pattern};
use ga_vision::calibration::{BoardViews, CalibrationError, LensTerms};
use ga_vision::chessboard::{BoardSize, find, find_part};
use nullcone_shared_data::shared;
use proptest::prelude::*;
use rand_chacha::ChaCha8Rng;
use rand_chacha::rand_core::SeedableRng;
use rand_distr::{Distribution, Normal};
use serde_json::Value;

/// A chessboard before a camera with radial distortion.
#[derive(Clone, Debug)]
pub(crate) struct Scene {
    pub(crate) size: BoardSize,
    pub(crate) board_to_camera: Motor<f64>,
    pub(crate) focal: f64,
    pub(crate) radial: [f64; 2],
    /// The brightness of dark and bright squares, of 1.
    pub(crate) brightness: [f64; 2],
    /// The standard deviations of the blur in pixels and of the noise in brightness.
    pub(crate) blur: f64,
    pub(crate) noise: f64,
}

pub(crate) const WIDTH: usize = 480;
pub(crate) const HEIGHT: usize = 360;

impl Scene {
    fn distorted(&self, [x, y]: [f64; 2]) -> [f64; 2] {
        let squared = x * x + y * y;
        let factor = 1.0 + squared * (self.radial[0] + squared * self.radial[1]);
        [x * factor, y * factor]
    }

    /// The pixels of the corners.
    pub(crate) fn truth(&self) -> Vec<[f64; 2]> {
        let centre = [0.5 * (WIDTH as f64 - 1.0), 0.5 * (HEIGHT as f64 - 1.0)];
        let pixel = |place: &Point<f64>| {
            let [x, y, z] = self.board_to_camera.transform(*place).coordinates();
            let image = self.distorted([x / z, y / z]);
            [0, 1].map(|k| self.focal * image[k] + centre[k])
        };
        self.size.places(1.0).iter().map(pixel).collect()
    }

    /// The place on the board that a place of the picture shows, in squares. The board's plane is
    /// in front of the camera everywhere in the picture.
    fn on_board(&self, place: [f64; 2]) -> [f64; 2] {
        let centre = [0.5 * (WIDTH as f64 - 1.0), 0.5 * (HEIGHT as f64 - 1.0)];
        let goal = [0, 1].map(|k| (place[k] - centre[k]) / self.focal);
        let mut image = goal;
        for _ in 0..12 {
            let found = self.distorted(image);
            image = [0, 1].map(|k| image[k] + goal[k] - found[k]);
        }
        let camera_to_board = self.board_to_camera.reverse();
        let origin = camera_to_board.transform(Point::default()).coordinates();
        let through = camera_to_board.transform(Point::new(image[0], image[1], 1.0));
        let through = through.coordinates();
        let depth = origin[2] / (origin[2] - through[2]);
        [0, 1].map(|k| origin[k] + depth * (through[k] - origin[k]))
    }

    /// The brightness of a place on the board, with one square beyond the corners on each side, a
    /// bright margin around them, and grey beyond.
    fn brightness_of(&self, [x, y]: [f64; 2]) -> f64 {
        let (columns, rows) = (self.size.columns() as f64, self.size.rows() as f64);
        let is_on = |x: f64, count: f64| (-1.0..count).contains(&x);
        let is_paper = |x: f64, count: f64| (-1.7..count + 0.7).contains(&x);
        if !(is_paper(x, columns) && is_paper(y, rows)) {
            return 0.5 * (self.brightness[0] + self.brightness[1]);
        }
        let is_first_colour = (x.floor() + y.floor()).rem_euclid(2.0) == 0.0;
        let is_dark = is_on(x, columns) && is_on(y, rows) && is_first_colour;
        self.brightness[usize::from(!is_dark)]
    }

    /// Whether no edge of a square or of the paper is within `reach` of a place on the board, along
    /// either of its axes.
    fn is_plain(&self, place: [f64; 2], reach: [f64; 2]) -> bool {
        let counts = [self.size.columns(), self.size.rows()];
        (0..2).all(|k| {
            [place[k].round(), -1.7, counts[k] as f64 + 0.7]
                .iter()
                .all(|edge| (place[k] - edge).abs() > reach[k])
        })
    }

    pub(crate) fn picture(&self, seed: u64) -> Plane<u8> {
        // Samples of a pixel along each axis. Their grid is the same in all pixels, so that what it
        // does wrong moves an edge as a whole: by 1/64 of a pixel at most.
        const SAMPLES: usize = 32;
        let offset = |sample: usize| (sample as f64 + 0.5) / SAMPLES as f64 - 0.5;
        let sharp = Plane::from_fn(WIDTH, HEIGHT, |column, row| {
            // Within a pixel the map to the board is linear.
            let at = |dx: f64, dy: f64| self.on_board([column as f64 + dx, row as f64 + dy]);
            let [left, right, above, below] =
                [at(-0.5, 0.0), at(0.5, 0.0), at(0.0, -0.5), at(0.0, 0.5)];
            let centre = [0, 1].map(|k| 0.25 * (left[k] + right[k] + above[k] + below[k]));
            let [across, down] = [[left, right], [above, below]]
                .map(|[from, to]: [[f64; 2]; 2]| [0, 1].map(|k| to[k] - from[k]));
            if self.is_plain(
                centre,
                [0, 1].map(|k| 0.5 * (across[k].abs() + down[k].abs())),
            ) {
                return self.brightness_of(centre) as f32;
            }
            let samples = (0..SAMPLES * SAMPLES).map(|sample| {
                let [dx, dy] = [sample % SAMPLES, sample / SAMPLES].map(offset);
                self.brightness_of([0, 1].map(|k| centre[k] + dx * across[k] + dy * down[k]))
            });
            (samples.sum::<f64>() / (SAMPLES * SAMPLES) as f64) as f32
        });
        let blurred = match Gaussian::new(self.blur) {
            Ok(gaussian) => gaussian.blur(&sharp, Border::Mirror),
            Err(_) => sharp,
        };
        let normal = Normal::new(0.0, self.noise).expect("a standard deviation");
        let mut random = ChaCha8Rng::seed_from_u64(seed);
        blurred.map(|value| {
            let noisy = f64::from(value) + normal.sample(&mut random);
            (255.0 * noisy).round().clamp(0.0, 255.0) as u8
        })
    }
}

/// Scenes with the whole board in the picture.
pub(crate) fn scenes() -> impl Strategy<Value = Scene> {
    let size = prop::sample::select(vec![(9, 6), (6, 9), (5, 4), (7, 8), (4, 11)]);
    let pose = (-3.1..3.1, -0.7..0.7, -0.7..0.7, -0.3..0.3, -0.3..0.3);
    let look = (0.0..0.5, 0.3..0.5, 0.0..1.8, 0.0..0.02);
    (size, pose, (-0.25..0.15, -0.05..0.05), look, 1.0..1.6).prop_map(
        |((columns, rows), (roll, pitch, yaw, right, down), (k1, k2), look, distance)| {
            let size = BoardSize::new(columns, rows).expect("a size");
            let about = |axis, angle| Rotor::from_axis_angle(axis, angle).expect("an axis");
            let extent = (columns + 1).max(rows + 1) as f64;
            let centre = [0.5 * (columns as f64 - 1.0), 0.5 * (rows as f64 - 1.0), 0.0];
            let rotor = about([0.0, 1.0, 0.0], yaw)
                * about([1.0, 0.0, 0.0], pitch)
                * about([0.0, 0.0, 1.0], roll);
            let place = [right, down, 1.6 * distance].map(|x| x * extent);
            let board_to_camera = Translator::from_displacement(place)
                * (rotor * Translator::from_displacement(centre.map(|x| -x)));
            let (dark, contrast, blur, noise) = look;
            Scene {
                size,
                board_to_camera,
                focal: 420.0,
                radial: [k1, k2],
                brightness: [dark, dark + contrast],
                blur,
                noise,
            }
        },
    )
}

fn is_inside(pixels: &[[f64; 2]], margin: f64) -> bool {
    pixels.iter().all(|[u, v]| {
        (margin..WIDTH as f64 - margin).contains(u) && (margin..HEIGHT as f64 - margin).contains(v)
    })
}

/// The least distance of corners that are neighbours.
fn least_step(pixels: &[[f64; 2]], size: BoardSize) -> f64 {
    let distance =
        |a: usize, b: usize| (pixels[a][0] - pixels[b][0]).hypot(pixels[a][1] - pixels[b][1]);
    let columns = size.columns();
    let along = (1..pixels.len())
        .filter(|k| k % columns > 0)
        .map(|k| distance(k, k - 1));
    let down = (columns..pixels.len()).map(|k| distance(k, k - columns));
    along.chain(down).fold(f64::INFINITY, f64::min)
}

/// The distances between corresponding pixels.
fn distances(a: &[[f64; 2]], b: &[[f64; 2]]) -> Vec<f64> {
    assert_eq!(a.len(), b.len());
    let pairs = a.iter().zip(b);
    pairs
        .map(|(a, b)| (a[0] - b[0]).hypot(a[1] - b[1]))
        .collect()
}

/// Fails where a corner of the board is further from the truth than its picture explains.
fn is_found_where_it_is(scene: &Scene, seed: u64) -> Result<(), TestCaseError> {
    let board = find(&scene.picture(seed), scene.size);
    let board = board.map_err(|error| TestCaseError::fail(format!("{error}: {scene:?}")))?;
    let errors = distances(&board.view().pixels(), &scene.truth());
    let greatest = errors.iter().fold(0.0_f64, |a, b| a.max(*b));
    let contrast = scene.brightness[1] - scene.brightness[0];
    // Brightness is rounded to 255 steps, which is noise too: uniform within a step.
    let noise = scene.noise.hypot(1.0 / 255.0 / 12.0_f64.sqrt());
    // Sums over the pixels of a window stand for integrals. In squares of eleven pixels that moves
    // a corner by up to 0.06 px, and the samples of the picture are 1/32 px apart. Noise moves an
    // edge the further, the less steep it is.
    let limit = 0.08 + 6.0 * noise / contrast * scene.blur.max(1.0);
    prop_assert!(greatest < limit, "{greatest} px: {scene:?}");
    Ok(())
}

/// Blurred squares of eleven pixels in little contrast, seen obliquely.
#[test]
fn small_pale_squares_are_found_where_they_are() {
    let scene = Scene {
        size: BoardSize::new(6, 9).unwrap(),
        board_to_camera: Motor::new_unchecked(
            0.9118275192639905,
            -0.08622929699696437,
            -0.31328443714188153,
            -0.25097399247129315,
            -3.857668548320381,
            -1.137686202905222,
            -10.257064976047946,
            1.640896513878164,
        ),
        focal: 420.0,
        radial: [0.0; 2],
        brightness: [0.0, 0.3],
        blur: 1.63,
        noise: 0.0,
    };
    is_found_where_it_is(&scene, 0).unwrap();
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(24))]

    #[test]
    fn rendered_boards_are_found_where_they_are(scene in scenes(), seed in 0_u64..100) {
        let truth = scene.truth();
        prop_assume!(is_inside(&truth, 25.0) && least_step(&truth, scene.size) > 11.0);
        is_found_where_it_is(&scene, seed)?;
    }

    #[test]
    fn a_board_that_is_partly_outside_is_not_found(
        scene in scenes(),
        seed in 0_u64..100,
        corner in any::<prop::sample::Index>(),
    ) {
        let truth = scene.truth();
        prop_assume!(is_inside(&truth, 5.0) && least_step(&truth, scene.size) > 11.0);
        // The picture ends at one of the corners.
        let picture = scene.picture(seed);
        let width = corner.get(&truth)[0] as usize;
        let part = picture.view().part(0, 0, width, HEIGHT).expect("a part");
        let found = find(part, scene.size);
        prop_assert!(
            matches!(found, Err(CalibrationError::NotFound { .. })),
            "{found:?} {scene:?}"
        );
    }

    /// Where the picture cuts the board, the corners that are found are those of rows and columns
    /// in their order, and the first one may be any.
    #[test]
    fn parts_of_boards_are_found_where_they_are(
        scene in scenes(),
        seed in 0_u64..100,
        corner in any::<prop::sample::Index>(),
    ) {
        let truth = scene.truth();
        prop_assume!(is_inside(&truth, 25.0) && least_step(&truth, scene.size) > 11.0);
        let picture = scene.picture(seed);
        let width = corner.get(&truth)[0] as usize;
        let part = picture.view().part(0, 0, width, HEIGHT).expect("a part");
        let Ok(found) = find_part(part, scene.size) else {
            return Ok(());
        };
        let (seen, columns) = (found.view().points(), scene.size.columns());
        prop_assert!(2 * seen.len() >= truth.len() && seen.len() < truth.len());
        let nearest = |pixel: &[f64; 2]| {
            let apart = |index: &usize| distances(&[*pixel], &[truth[*index]])[0];
            (0..truth.len()).min_by(|a, b| apart(a).total_cmp(&apart(b))).unwrap()
        };
        let cell = |index: usize| [index % columns, index / columns].map(|k| k as f64);
        let mut steps = Vec::new();
        for corner in seen {
            let index = nearest(&corner.pixel);
            let apart = distances(&[corner.pixel], &[truth[index]])[0];
            prop_assert!(apart < 0.5, "{apart} px: {scene:?}");
            let first = [seen[0].point, nearest(&seen[0].pixel)].map(cell);
            let here = [corner.point, index].map(cell);
            steps.push([0, 1].map(|k| [0, 1].map(|axis| here[k][axis] - first[k][axis])));
        }
        // Rotated by right angles and not mirrored, steps keep their products.
        for [a, c] in &steps {
            for [b, d] in &steps {
                prop_assert_eq!(a[0] * b[0] + a[1] * b[1], c[0] * d[0] + c[1] * d[1]);
                prop_assert_eq!(a[0] * b[1] - a[1] * b[0], c[0] * d[1] - c[1] * d[0]);
            }
        }
    }

    #[test]
    fn a_board_of_another_size_is_not_found(scene in scenes(), seed in 0_u64..100) {
        let truth = scene.truth();
        prop_assume!(is_inside(&truth, 25.0) && least_step(&truth, scene.size) > 11.0);
        let picture = scene.picture(seed);
        let changes = [(1, 0), (0, 1), (1, 1), (-1, 0), (0, -1), (-1, -1), (-2, 0), (-1, -2)];
        for (columns, rows) in changes {
            let other = |count: usize, change: isize| count.saturating_add_signed(change);
            let [columns, rows] = [
                other(scene.size.columns(), columns),
                other(scene.size.rows(), rows),
            ];
            if [columns, rows] == [scene.size.rows(), scene.size.columns()] {
                continue;
            }
            let Ok(size) = BoardSize::new(columns, rows) else {
                continue;
            };
            let found = find(&picture, size);
            prop_assert!(found.is_err(), "{size}: {found:?} {scene:?}");
        }
    }
}

/// What is missing beyond the border of the picture may be up to half of the corners; a smaller
/// board within the picture is no part of a larger one.
#[test]
fn parts_are_cut_by_the_border_alone() {
    let size = BoardSize::new(9, 6).unwrap();
    let scene = Scene {
        size,
        board_to_camera: Translator::from_displacement([-4.0, -2.5, 14.0]).into(),
        focal: 420.0,
        radial: [0.0; 2],
        brightness: [0.1, 0.9],
        blur: 0.8,
        noise: 0.0,
    };
    let (truth, picture) = (scene.truth(), scene.picture(0));
    let step = truth[1][0] - truth[0][0];
    for columns in 3..9 {
        let width = (truth[columns - 1][0] + 0.7 * step) as usize;
        let part = picture.view().part(0, 0, width, HEIGHT).unwrap();
        assert!(find(part, size).is_err());
        let found = find_part(part, size);
        if columns < 5 {
            assert!(
                matches!(found, Err(CalibrationError::NotFound { .. })),
                "{found:?}"
            );
            continue;
        }
        let found = found.unwrap();
        let expected: Vec<usize> = (0..54).filter(|point| point % 9 < columns).collect();
        let points: Vec<usize> = found
            .view()
            .points()
            .iter()
            .map(|seen| seen.point)
            .collect();
        assert_eq!(points, expected);
        let expected: Vec<[f64; 2]> = expected.iter().map(|point| truth[*point]).collect();
        let errors = distances(&found.view().pixels(), &expected);
        assert!(errors.iter().all(|error| *error < 0.05), "{errors:?}");
    }
    for other in ["10x6", "9x7", "11x6", "12x9"] {
        let found = find_part(&picture, other.parse().unwrap());
        assert!(
            matches!(found, Err(CalibrationError::NotFound { .. })),
            "{other}: {found:?}"
        );
    }
    assert_eq!(find_part(&picture, size), find(&picture, size));
}

/// A camera from boards of which the border of the picture cuts every side.
#[test]
fn cameras_are_calibrated_with_parts_of_boards() {
    let size = BoardSize::new(9, 6).unwrap();
    let board = Board::new(Pattern::Chessboard, size, 1.0).unwrap();
    let mut views = BoardViews::new(board);
    let poses = [
        (0.4, 0.0, 4.2, 0.0),
        (-0.4, 0.0, -4.2, 0.0),
        (0.0, 0.4, 0.0, 3.6),
        (0.0, -0.4, 0.0, -3.6),
        (0.35, 0.3, 0.0, 0.0),
        (-0.35, 0.3, 0.5, 0.0),
        (0.2, -0.4, 0.0, 0.5),
    ];
    for (index, (yaw, pitch, right, down)) in poses.into_iter().enumerate() {
        let about = |axis, angle| Rotor::from_axis_angle(axis, angle).unwrap();
        let rotor = about([0.0, 1.0, 0.0], yaw) * about([1.0, 0.0, 0.0], pitch);
        let to_centre = Translator::from_displacement([-4.0, -2.5, 0.0]);
        let scene = Scene {
            size,
            board_to_camera: Translator::from_displacement([right, down, 12.0])
                * (rotor * to_centre),
            focal: 420.0,
            radial: [0.0; 2],
            brightness: [0.1, 0.9],
            blur: 0.8,
            noise: 0.003,
        };
        let picture = scene.picture(index as u64);
        views.add(&picture, index.to_string()).unwrap();
    }
    let found = views.calibrate(Some(LensTerms::none())).unwrap();
    assert_eq!(found.views.len(), poses.len(), "{:?}", found.rejected);
    let parts = found.views.iter().filter(|view| view.points < 54);
    assert_eq!(parts.count(), 4, "{:?}", found.views);
    assert!(found.camera.rms < 0.05, "{}", found.camera.rms);
    let [fx, fy] = found.camera.intrinsics.focal();
    assert!(
        (fx - 420.0).abs() < 1.0 && (fy - 420.0).abs() < 1.0,
        "{fx} {fy}"
    );
}

/// The corners that OpenCV finds in its own pictures, with the calibration from them.
pub(crate) fn opencv() -> Value {
    let path = concat!(env!("CARGO_MANIFEST_DIR"), "/tests/data/chessboard.json");
    let text = std::fs::read_to_string(path).expect("the extract is committed");
    serde_json::from_str(&text).expect("JSON")
}

pub(crate) fn pixels(value: &Value) -> Vec<[f64; 2]> {
    nullcone_shared_data::json::rows::<2>(value)
}

/// The corners that are found in the left and in the right views of OpenCV's pairs. `None` where
/// the pictures are absent.
pub(crate) fn opencv_boards() -> Option<[Vec<Vec<[f64; 2]>>; 2]> {
    let folder = shared("data/vision/opencv")?;
    let oracle = opencv();
    let size: BoardSize = "9x6".parse().unwrap();
    let board = |side: &str, name: &Value| {
        let path = folder.join(format!("{side}{}", name.as_str().unwrap()));
        let picture = ga_image::file::read(&path)
            .unwrap()
            .to_grey::<u8>(Luma::Bt601);
        let board = find(&picture, size).unwrap_or_else(|error| panic!("{path:?}: {error}"));
        board.view().pixels()
    };
    let names = oracle["names"].as_array().unwrap();
    Some(["left", "right"].map(|side| names.iter().map(|name| board(side, name)).collect()))
}

#[test]
fn the_boards_of_opencv_are_found_in_all_pictures() {
    let Some(boards) = opencv_boards() else {
        return;
    };
    let oracle = opencv();
    let mut all = Vec::new();
    for (boards, side) in boards.iter().zip(["left", "right"]) {
        for (index, board) in boards.iter().enumerate() {
            let mut errors = distances(board, &pixels(&oracle[side][index]));
            errors.sort_by(f64::total_cmp);
            assert!(errors[27] < 0.15, "{side} {index}: {}", errors[27]);
            all.extend(errors);
        }
    }
    all.sort_by(f64::total_cmp);
    let part = |part: f64| all[(part * all.len() as f64) as usize];
    // OpenCV's window, 23 pixels wide, is drawn to other edges where squares are smaller.
    assert!(
        part(0.5) < 0.06 && part(0.9) < 0.25,
        "{} {}",
        part(0.5),
        part(0.9)
    );
}

/// A board of 9 × 6 corners contains smaller grids, which are no boards.
#[test]
fn parts_of_the_boards_of_opencv_are_not_boards() {
    let Some(folder) = shared("data/vision/opencv") else {
        return;
    };
    for name in opencv()["names"].as_array().unwrap() {
        for side in ["left", "right"] {
            let path = folder.join(format!("{side}{}", name.as_str().unwrap()));
            let picture = ga_image::file::read(&path).unwrap();
            let picture = picture.to_grey::<u8>(Luma::Bt601);
            for size in ["8x6", "9x5", "8x5", "7x6", "6x5", "10x6", "9x7"] {
                let found = find(&picture, size.parse().unwrap());
                assert!(found.is_err(), "{path:?}, {size}: {found:?}");
            }
        }
    }
}

/// A board that looks the same after a rotation by 180°, or by 90°, keeps its order.
#[test]
fn boards_of_two_views_get_one_order() {
    for (columns, rows) in [(5, 5), (6, 6), (6, 4), (5, 4)] {
        let board = |roll: f64| {
            let size = BoardSize::new(columns, rows).unwrap();
            let centre = [columns, rows].map(|count| -0.5 * (count as f64 - 1.0));
            let scene = Scene {
                size,
                board_to_camera: Translator::from_displacement([0.0, 0.0, 12.0])
                    * (Rotor::from_axis_angle([0.0, 0.0, 1.0], roll).unwrap()
                        * Translator::from_displacement([centre[0], centre[1], 0.0])),
                focal: 420.0,
                radial: [0.0; 2],
                brightness: [0.1, 0.9],
                blur: 0.8,
                noise: 0.0,
            };
            find(&scene.picture(1), size).unwrap()
        };
        for quarter in 0..4 {
            // On both sides of where the first corner changes.
            let roll = f64::from(quarter) * std::f64::consts::FRAC_PI_2 - 0.8;
            let [left, right] = [roll - 0.08, roll + 0.08].map(board);
            let right = right.ordered_like(&left);
            let moved = distances(&left.view().pixels(), &right.view().pixels());
            assert!(
                moved.iter().all(|d| *d < 40.0),
                "{columns} × {rows}, {quarter}: {moved:?}"
            );
        }
    }
}

#[test]
fn sizes_are_read_and_refused() {
    let size: BoardSize = "9x6".parse().unwrap();
    assert_eq!((size.columns(), size.rows(), size.count()), (9, 6, 54));
    for text in ["9", "9x", "x", "9x6x3", "-9x6", "9.5x6", ""] {
        let found = text.parse::<BoardSize>();
        assert_eq!(found, Err(CalibrationError::BoardText(text.to_owned())));
    }
    for text in ["2x6", "9x0", "9x101", "1000000x1000000"] {
        let found = text.parse::<BoardSize>();
        assert!(
            matches!(found, Err(CalibrationError::BoardSize { .. })),
            "{found:?}"
        );
    }
}

#[test]
fn pictures_without_a_board_are_refused() {
    let size: BoardSize = "9x6".parse().unwrap();
    let not_found = |picture: &Plane<u8>| {
        let found = find(picture, size);
        assert!(
            matches!(found, Err(CalibrationError::NotFound { .. })),
            "{found:?}"
        );
    };
    not_found(&Plane::filled(0, 0, 0));
    not_found(&Plane::filled(1, 1, 7));
    not_found(&Plane::filled(300, 200, 128));
    let mut state = 1_u32;
    not_found(&Plane::from_fn(640, 480, |_, _| {
        state = state.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
        (state >> 24) as u8
    }));
    // Squares of one brightness in an endless grid: the board could lie anywhere.
    not_found(&Plane::from_fn(640, 480, |x: usize, y: usize| {
        if (x / 20 + y / 20).is_multiple_of(2) {
            30
        } else {
            220
        }
    }));
}

#[test]
fn a_board_of_thousands_of_corners_is_found() {
    let size = BoardSize::new(62, 51).unwrap();
    // Squares of 10 pixels, from (40, 40) on.
    let picture = Plane::from_fn(710, 600, |column: usize, row: usize| {
        let inside = (40..670).contains(&column) && (40..560).contains(&row);
        let dark = inside && ((column - 40) / 10 + (row - 40) / 10).is_multiple_of(2);
        if dark { 20u8 } else { 230 }
    });
    let board = find(&picture, size).unwrap();
    assert_eq!(board.view().pixels().len(), 3162);
    let [u, v] = board.view().pixels()[0];
    assert!(
        (u - 49.5).abs() < 0.01 && (v - 49.5).abs() < 0.01,
        "{u} {v}"
    );
}

/// Saddle points of the clutter around the board, one of which begins a grid of its own through
/// corners of the board, do not keep these corners from it.
#[test]
fn a_board_among_clutter_is_found() {
    let Some(path) = shared("cases/vision/board-not-found/left22.png") else {
        return;
    };
    let picture = ga_image::file::read(&path).unwrap();
    let picture = picture.to_grey::<u8>(Luma::Bt601);
    let board = find(&picture, "9x6".parse().unwrap()).unwrap();
    // By OpenCV 5.0.0: `findChessboardCorners`, then `cornerSubPix` in a window of 11 × 11 pixels.
    for (index, corner) in [
        (0, [140.7499, 148.0141]),
        (8, [278.3428, 141.7948]),
        (22, [223.1983, 176.7996]),
        (45, [158.3945, 241.2406]),
        (53, [290.1012, 229.0317]),
    ] {
        let apart = distances(&[board.view().pixels()[index]], &[corner])[0];
        assert!(apart < 0.15, "{index}: {apart} px");
    }
    for size in ["4x3", "5x4", "8x5", "8x6", "9x5", "10x6"] {
        let found = find(&picture, size.parse().unwrap());
        assert!(found.is_err(), "{size}: {found:?}");
    }
}

/// Letters, discs and squares of random places and brightness, up to the margin of the board.
#[test]
fn boards_among_random_clutter_are_found() {
    let size: BoardSize = "7x5".parse().unwrap();
    let mut found = 0;
    for seed in 0..30 {
        let mut random = ChaCha8Rng::seed_from_u64(seed);
        let mut below = |limit: u32| (random.next_u32() % limit) as usize;
        let mut picture = Plane::filled(480, 360, 128_u8);
        for _ in 0..400 {
            let [left, top, side, value] = [below(480), below(360), 3 + below(30), below(256)];
            for row in top..(top + side).min(360) {
                for column in left..(left + side).min(480) {
                    picture.row_mut(row)[column] = value as u8;
                }
            }
        }
        let (left, top, square) = (20 + below(150), 20 + below(100), 20 + below(12));
        let margin = square / 3;
        for row in top - margin..top + 6 * square + margin {
            for column in left - margin..left + 8 * square + margin {
                let inside = (left..left + 8 * square).contains(&column)
                    && (top..top + 6 * square).contains(&row);
                let is_dark =
                    inside && ((column - left) / square + (row - top) / square).is_multiple_of(2);
                picture.row_mut(row)[column] = if is_dark { 40 } else { 220 };
            }
        }
        if let Ok(board) = find(&picture, size) {
            found += 1;
            // Edges are half a pixel before the first pixel of a square.
            let first = [left, top].map(|k| (k + square) as f64 - 0.5);
            let apart = distances(&[board.view().pixels()[0]], &[first])[0];
            assert!(apart < 0.1, "{seed}: {apart} px");
        }
        for other in ["6x5", "7x4", "8x5", "5x4"] {
            let found = find(&picture, other.parse().unwrap());
            assert!(found.is_err(), "{seed}, {other}: {found:?}");
        }
    }
    assert!(found >= 29, "{found} of 30");
}
