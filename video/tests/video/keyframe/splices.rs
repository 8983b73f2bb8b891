//! Clips spliced from photographs and films, with the frames at which their shots begin.

use std::path::{Path, PathBuf};

use ga_image::file;
use ga_image::grey::Luma;
use ga_image::plane::Plane;
use ga_image::resample::{Method, resize};
use ga_video::Frame;
use nullcone_shared_data::shared;

use super::clips::{Base, Labels, Random, SIZE, blended};

/// Photographs of different scenes.
const PHOTOGRAPHS: [&str; 13] = [
    "middlebury/motorcycle_left.png",
    "opencv/aloeL.jpg",
    "opencv/left03.jpg",
    "quality/astronaut.png",
    "quality/coins.png",
    "stereo/eth3d_terrace/im0.png",
    "stereo/mb2001_venus/left.png",
    "stereo/mb2003_Teddy/left.png",
    "stereo/mb2005_Art/left.png",
    "stereo/mb2005_Reindeer/left.png",
    "stereo/mb2006_Baby1/left.png",
    "stereo/mb2006_Midd1/left.png",
    "stereo/mb2006_Wood1/left.png",
];

/// The width to which photographs are reduced, in pixels.
const WIDTH: usize = 360;

/// Frames before this one and from it on are two shots of the film.
const CUT: usize = 20;

/// What shots are made of.
pub(crate) struct Material {
    photographs: Vec<Plane<f32>>,
    films: Vec<Vec<Plane<f32>>>,
}

impl Material {
    /// The shared photographs and films, and for a longer run the films of a folder, of one shot
    /// each, which a variable names.
    pub(crate) fn read() -> Option<Self> {
        let folder = shared("data/vision")?;
        let photograph = |name: &&str| {
            let grey = file::read(folder.join(name)).unwrap();
            let grey = grey.to_grey::<f32>(Luma::Bt601).map(|value| 255.0 * value);
            let height = WIDTH * grey.height() / grey.width();
            resize(&grey, WIDTH, height, Method::Area).unwrap()
        };
        let mut film = lumas(&folder.join("clips/bbb_f265-305_320x180_cut285.y4m"));
        let second = film.split_off(CUT);
        let mut films = vec![film, second];
        if let Some(folder) = std::env::var_os("NULLCONE_FILMS") {
            let files = std::fs::read_dir(folder).unwrap();
            let mut files: Vec<PathBuf> = files.map(|file| file.unwrap().path()).collect();
            files.sort();
            films.extend(files.iter().map(|file| lumas(file)));
        }
        Some(Self {
            photographs: PHOTOGRAPHS.iter().map(photograph).collect(),
            films,
        })
    }

    /// A clip of several shots, no two of which in succession show the same scene, before an
    /// effect.
    pub(crate) fn splice(&self, seed: u64) -> Base {
        let mut random = Random::new(seed ^ 0x5911_CE00);
        let count = random.index(4..8);
        let (mut frames, mut labels) = (Vec::new(), Labels::default());
        let mut shot = self.shot(&mut random, usize::MAX);
        let mut time = 0;
        for number in 0..count {
            for _ in 0..random.index(12..45) {
                frames.push(shot.frame(time));
                time += 1;
            }
            if number + 1 == count {
                break;
            }
            let next = self.shot(&mut random, shot.scene);
            let start = frames.len();
            let kind = random.index(0..10);
            time = if kind < 5 {
                labels.cuts.push(start);
                0
            } else if kind < 8 {
                let length = [random.index(8..31), random.index(25..121)][random.index(0..2)];
                for step in 0..length {
                    let part = (step + 1) as f32 / (length + 1) as f32;
                    frames.push(blended(&shot.frame(time + step), &next.frame(step), part));
                }
                labels.dissolves.push(start..frames.len());
                length
            } else {
                // Red of black, white, greys and a dark red.
                let level = [0.0, 255.0, 30.0, 70.0, 128.0][random.index(0..5)];
                let flat = Plane::filled(SIZE[0], SIZE[1], level);
                let [out, gap, back] = [8..61, 1..8, 8..61].map(|range| random.index(range));
                for step in 0..out {
                    let part = (step + 1) as f32 / (out + 1) as f32;
                    frames.push(blended(&shot.frame(time + step), &flat, part));
                }
                labels.fades.push(start..frames.len());
                frames.extend(std::iter::repeat_n(flat.clone(), gap));
                let start = frames.len();
                for step in 0..back {
                    let part = (step + 1) as f32 / (back + 1) as f32;
                    frames.push(blended(&flat, &next.frame(step), part));
                }
                labels.fades.push(start..frames.len());
                back
            };
            shot = next;
        }
        Base {
            frames,
            labels,
            random,
        }
    }

    /// The frames of a random shot.
    pub(crate) fn one_shot(&self, random: &mut Random, count: usize) -> Vec<Plane<f32>> {
        let shot = self.shot(random, usize::MAX);
        (0..count).map(|time| shot.frame(time)).collect()
    }

    /// A random view of a photograph.
    pub(crate) fn photograph(&self, scene: usize, random: &mut Random) -> Plane<f32> {
        loop {
            let shot = self.shot(random, usize::MAX);
            if shot.scene == scene {
                return shot.frame(0);
            }
        }
    }

    /// A random shot of any scene but one.
    fn shot(&self, random: &mut Random, other: usize) -> Shot<'_> {
        let count = self.photographs.len() + self.films.len();
        let scene = loop {
            let scene = random.index(0..count);
            if scene != other {
                break scene;
            }
        };
        let pictures = match scene.checked_sub(self.photographs.len()) {
            None => std::slice::from_ref(&self.photographs[scene]),
            Some(film) => &self.films[film],
        };
        let size = [pictures[0].width() as f32, pictures[0].height() as f32];
        let zoom = random.between(1.0, 2.2);
        let still = random.index(0..3) == 0;
        // A view that fits, of the shape of a frame.
        let width = size[0].min(size[1] * SIZE[0] as f32 / SIZE[1] as f32) / zoom;
        let height = width * SIZE[1] as f32 / SIZE[0] as f32;
        let mut part = || random.between(0.0, 1.0);
        let centre = [
            width / 2.0 + part() * (size[0] - width),
            height / 2.0 + part() * (size[1] - height),
        ];
        let angle = std::f32::consts::TAU * part();
        // Up to one per cent of the width of the view in a frame.
        let speed = if still { 0.0 } else { 0.01 * width * part() };
        Shot {
            pictures,
            scene,
            centre,
            velocity: [speed * angle.cos(), speed * angle.sin()],
            scale: width / SIZE[0] as f32,
            growth: if still { 0.0 } else { 0.006 * (part() - 0.5) },
        }
    }
}

/// A view that moves over a photograph, or over the frames of a film, which runs to and fro.
struct Shot<'a> {
    pictures: &'a [Plane<f32>],
    scene: usize,
    centre: [f32; 2],
    velocity: [f32; 2],
    /// Pixels of the picture for a pixel of a frame, and how this grows in a frame.
    scale: f32,
    growth: f32,
}

impl Shot<'_> {
    fn frame(&self, time: usize) -> Plane<f32> {
        let last = self.pictures.len() - 1;
        let at = time % (2 * last).max(1);
        let picture = &self.pictures[at.min(2 * last - at.min(2 * last))];
        let scale = self.scale * (1.0 + self.growth * time as f32);
        let middle = [0, 1].map(|axis| self.centre[axis] + self.velocity[axis] * time as f32);
        Plane::from_fn(SIZE[0], SIZE[1], |column, row| {
            // Four samples for a pixel.
            let mut sum = 0.0;
            for (dx, dy) in [(0.25, 0.25), (0.75, 0.25), (0.25, 0.75), (0.75, 0.75)] {
                let x = middle[0] + scale * (column as f32 + dx - SIZE[0] as f32 / 2.0);
                let y = middle[1] + scale * (row as f32 + dy - SIZE[1] as f32 / 2.0);
                sum += mirrored(picture, x - 0.5, y - 0.5);
            }
            sum / 4.0
        })
    }
}

/// The picture between its pixels; beyond its border it is mirrored.
fn mirrored(picture: &Plane<f32>, x: f32, y: f32) -> f32 {
    let along = |at: f32, length: usize| {
        let last = (length - 1) as f32;
        let at = at.rem_euclid(2.0 * last);
        let at = if at > last { 2.0 * last - at } else { at };
        let first = (at as usize).min(length - 2);
        (first, at - first as f32)
    };
    let ((column, s), (row, t)) = (along(x, picture.width()), along(y, picture.height()));
    let mix = |line: &[f32]| line[column] + s * (line[column + 1] - line[column]);
    let [upper, lower] = [row, row + 1].map(|row| mix(picture.row(row)));
    upper + t * (lower - upper)
}

fn lumas(path: &Path) -> Vec<Plane<f32>> {
    let mut source = ga_video::open(path).unwrap();
    let (mut frame, mut lumas) = (Frame::default(), Vec::new());
    while source.read(&mut frame).unwrap() {
        let luma = &frame.samples.eight_bits().luma;
        // Black is 16 and white 235.
        lumas.push(luma.map(|value| ((f32::from(value) - 16.0) * 255.0 / 219.0).clamp(0.0, 255.0)));
    }
    lumas
}
