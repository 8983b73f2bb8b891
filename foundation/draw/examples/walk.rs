//! Writes a page on which a made-up figure walks beside two films of it:
//! `cargo run -p ga-draw --example walk -- walk.html`.

use std::error::Error;
use std::f64::consts::TAU;

use ga_draw::document::{
    Bone, Encoding, Motion, MotionCamera, MotionFilm, MotionPicture, Page, Side,
};

const NAMES: [&str; 13] = [
    "head",
    "left shoulder",
    "right shoulder",
    "left elbow",
    "right elbow",
    "left wrist",
    "right wrist",
    "left hip",
    "right hip",
    "left knee",
    "right knee",
    "left ankle",
    "right ankle",
];
const BONES: [(usize, usize, Side); 14] = [
    (1, 3, Side::Left),
    (3, 5, Side::Left),
    (7, 9, Side::Left),
    (9, 11, Side::Left),
    (1, 7, Side::Left),
    (2, 4, Side::Right),
    (4, 6, Side::Right),
    (8, 10, Side::Right),
    (10, 12, Side::Right),
    (2, 8, Side::Right),
    (1, 2, Side::Middle),
    (7, 8, Side::Middle),
    (0, 1, Side::Middle),
    (0, 2, Side::Middle),
];
const FRAMES: usize = 120;
const SIZE: [usize; 2] = [240, 160];
/// The focal length of the films in pixels.
const FOCAL: f64 = 180.0;

fn main() -> Result<(), Box<dyn Error>> {
    let path = std::env::args()
        .nth(1)
        .ok_or("walk: the path of the page is missing")?;
    let frames: Vec<_> = (0..FRAMES)
        .map(|k| (!(50..58).contains(&k)).then(|| pose(k)))
        .collect();
    let eyes = [([-1.6, 1.4, 3.4], 0.3), ([2.6, 1.5, 2.6], -0.7)];
    let films = eyes
        .iter()
        .zip([1, 4])
        .enumerate()
        .map(|(k, (&eye, step))| {
            let starts = (0..FRAMES).step_by(step);
            let pictures = starts.map(|start| {
                Ok(MotionPicture {
                    frames: start..(start + step).min(FRAMES),
                    encoding: Encoding::Png,
                    bytes: film(&pose(start), eye)?,
                })
            });
            Ok(MotionFilm {
                name: format!("camera {}", k + 1),
                size: SIZE.map(|x| x as u32),
                pictures: pictures.collect::<Result<_, png::EncodingError>>()?,
            })
        });
    let bone = |(from, to, side)| Bone {
        ends: [from, to],
        side,
    };
    let motion = Motion {
        frames_per_second: 30.0,
        names: NAMES.map(str::to_owned).to_vec(),
        bones: BONES.map(bone).to_vec(),
        frames,
        floor: Some(0.0),
        cameras: eyes
            .iter()
            .enumerate()
            .map(|(k, &eye)| camera(k, eye))
            .collect(),
        films: films.collect::<Result<_, png::EncodingError>>()?,
    };
    let mut page = Page::new("A walk");
    page.motion(&motion, "A made-up figure walks towards the right.")?;
    std::fs::write(path, page.into_html())?;
    Ok(())
}

/// The figure at a frame: it walks along x and looks along x, so that its left is at negative z.
fn pose(frame: usize) -> Vec<[f64; 3]> {
    let time = frame as f64 / 30.0;
    let ahead = 0.6 * time - 1.2;
    let swing = (TAU * 0.9 * time).sin();
    let limb = |height: f64, side: f64, lengths: [f64; 2], angles: [f64; 2]| {
        let mut place = [ahead, height, side];
        let mut joints = vec![place];
        for (length, angle) in lengths.into_iter().zip(angles) {
            place[0] += length * angle.sin();
            place[1] -= length * angle.cos();
            joints.push(place);
        }
        joints
    };
    let arm = |side: f64| {
        limb(
            1.45,
            0.2 * side,
            [0.3, 0.27],
            [0.5 * side * swing, 0.5 * side * swing + 0.3],
        )
    };
    let leg = |side: f64| {
        limb(
            0.9,
            0.1 * side,
            [0.45, 0.45],
            [-0.5 * side * swing, -0.5 * side * swing - 0.25],
        )
    };
    let mut points = vec![[ahead + 0.03, 1.7, 0.0]];
    let [left_arm, right_arm, left_leg, right_leg] = [arm(-1.0), arm(1.0), leg(-1.0), leg(1.0)];
    for (left, right) in [(left_arm, right_arm), (left_leg, right_leg)] {
        points.extend(
            left.into_iter()
                .zip(right)
                .flat_map(|(left, right)| [left, right]),
        );
    }
    points
}

/// A camera at a place, turned about the vertical axis by an angle from the direction of −z.
type Eye = ([f64; 3], f64);

fn camera(index: usize, (centre, angle): Eye) -> MotionCamera {
    let [half_width, half_height] = SIZE.map(|size| 0.5 * size as f64 / FOCAL);
    let corner = |[x, y]: [f64; 2]| {
        let [right, up, ahead] = [0.3 * half_width * x, 0.3 * half_height * y, 0.3];
        let (sin, cos) = angle.sin_cos();
        [
            centre[0] + cos * right + sin * ahead,
            centre[1] + up,
            centre[2] + sin * right - cos * ahead,
        ]
    };
    MotionCamera {
        name: format!("camera {}", index + 1),
        centre,
        corners: [[-1.0, 1.0], [1.0, 1.0], [1.0, -1.0], [-1.0, -1.0]].map(corner),
    }
}

/// What a camera sees of a pose, as PNG.
fn film(pose: &[[f64; 3]], (centre, angle): Eye) -> Result<Vec<u8>, png::EncodingError> {
    let [width, height] = SIZE;
    let mut pixels = vec![230_u8; width * height];
    let (sin, cos) = angle.sin_cos();
    for (from, to, side) in BONES {
        let shade = if side == Side::Left { 30 } else { 110 };
        for step in 0..=200 {
            let t = f64::from(step) / 200.0;
            let [x, y, z] =
                [0, 1, 2].map(|k| (1.0 - t) * pose[from][k] + t * pose[to][k] - centre[k]);
            let [right, depth] = [cos * x + sin * z, sin * x - cos * z];
            let u = 0.5 * width as f64 + FOCAL * right / depth;
            let v = 0.5 * height as f64 - FOCAL * y / depth;
            if depth > 0.1 && (0.0..width as f64).contains(&u) && (0.0..height as f64).contains(&v)
            {
                pixels[v as usize * width + u as usize] = shade;
            }
        }
    }
    let mut bytes = Vec::new();
    let mut encoder = png::Encoder::new(&mut bytes, width as u32, height as u32);
    encoder.set_color(png::ColorType::Grayscale);
    let mut writer = encoder.write_header()?;
    writer.write_image_data(&pixels)?;
    writer.finish()?;
    Ok(bytes)
}
