//! Stereoscopic pictures, and defects injected into them.

use ga_image::file;
use ga_image::filter::{Border, Gaussian};
use ga_image::grey::Luma;
use ga_image::plane::Plane;
use ga_image::ycbcr::{Range, YCbCr};
use ga_video::comfort::{Dimension, FrameMeasures, Level, Viewing};
use ga_video::{Planes, Samples};
use nullcone_shared_data::shared;

/// Pictures as numbers, before they are rounded.
pub(super) type Picture = Plane<[f32; 3]>;

/// The encoding of pictures from files.
pub(super) const COLOURS: YCbCr = YCbCr {
    luma: Luma::Bt601,
    range: Range::Full,
};

macro_rules! middlebury {
    ($name:literal) => {
        [
            concat!("data/vision/stereo/", $name, "/left.png"),
            concat!("data/vision/stereo/", $name, "/right.png"),
        ]
    };
}
/// Rectified pairs, left and right. The exposures of the last one differ.
pub(super) const PAIRS: [[&str; 2]; 10] = [
    [
        "data/vision/middlebury/motorcycle_left.png",
        "data/vision/middlebury/motorcycle_right.png",
    ],
    [
        "data/vision/opencv/aloeL.jpg",
        "data/vision/opencv/aloeR.jpg",
    ],
    middlebury!("mb2001_venus"),
    middlebury!("mb2003_Teddy"),
    middlebury!("mb2005_Art"),
    middlebury!("mb2005_Reindeer"),
    middlebury!("mb2006_Baby1"),
    middlebury!("mb2006_Midd1"),
    middlebury!("mb2006_Wood1"),
    [
        "data/vision/stereo/eth3d_terrace/im0.png",
        "data/vision/stereo/eth3d_terrace/im1.png",
    ],
];

/// The pictures of a pair; `None` where the shared data is absent.
pub(super) fn pair(paths: [&str; 2]) -> Option<[Picture; 2]> {
    let [left, right] = paths.map(|path| Some(picture(&shared(path)?)));
    Some([left?, right?])
}

pub(super) fn picture(path: &std::path::Path) -> Picture {
    let codes = file::read(path).unwrap().to_rgb::<u8>();
    codes.map(|rgb| rgb.map(f32::from))
}

/// A picture as a frame of video stores it.
pub(super) fn samples(picture: &Picture) -> Samples {
    let rounded = |rgb: [f32; 3]| rgb.map(|code| code.round().clamp(0.0, 255.0) as u8);
    let encoded = picture.map(|rgb| COLOURS.from_rgb(rounded(rgb)));
    let [luma, cb, cr] = [0, 1, 2].map(|channel| encoded.channel(channel).unwrap());
    Samples::Eight(Planes {
        luma,
        differences: [cb, cr],
    })
}

/// The measures of two pictures.
pub(super) fn measures(left: &Picture, right: &Picture) -> FrameMeasures {
    FrameMeasures::of(&samples(left), &samples(right), COLOURS).unwrap()
}

/// The level of a row, before the default screen.
pub(super) fn level(found: &FrameMeasures, dimension: Dimension) -> Level {
    let row = found.row(dimension, &Viewing::default()).unwrap();
    row.score.unwrap().level()
}

/// How a picture is moved: by pixels to the right and down, by degrees counter-clockwise, and to a
/// size that is larger by this many per cent, about its middle.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Motion {
    pub(super) right: f64,
    pub(super) down: f64,
    pub(super) degrees: f64,
    pub(super) percent: f64,
}

/// A picture that has been moved.
pub(super) fn moved(picture: &Picture, motion: Motion) -> Picture {
    let (sine, cosine) = motion.degrees.to_radians().sin_cos();
    let size = 1.0 + 0.01 * motion.percent;
    warped(picture, |[x, y]| {
        let [x, y] = [x - motion.right, y - motion.down];
        // Rows count downwards, so that the inverse rotation has these signs.
        let [u, v] = [cosine * x - sine * y, sine * x + cosine * y];
        [u / size, v / size]
    })
}

/// The picture that shows at each place what another shows at a place that `source` gives, both in
/// pixels from the middle, by cubic convolution (R. G. Keys, "Cubic convolution interpolation for
/// digital image processing", 1981), which keeps it sharp.
pub(super) fn warped(picture: &Picture, source: impl Fn([f64; 2]) -> [f64; 2]) -> Picture {
    let middle = [picture.width(), picture.height()].map(|side| 0.5 * (side as f64 - 1.0));
    Plane::from_fn(picture.width(), picture.height(), |column, row| {
        let [u, v] = source([column as f64 - middle[0], row as f64 - middle[1]]);
        cubic(picture, [u + middle[0], v + middle[1]])
    })
}

fn cubic(picture: &Picture, place: [f64; 2]) -> [f32; 3] {
    let first = place.map(f64::floor);
    let weights = [0, 1].map(|axis| {
        let t = place[axis] - first[axis];
        [
            0.5 * t * (t * (2.0 - t) - 1.0),
            0.5 * (t * t * (3.0 * t - 5.0) + 2.0),
            0.5 * t * (t * (4.0 - 3.0 * t) + 1.0),
            0.5 * t * t * (t - 1.0),
        ]
    });
    let size = [picture.width(), picture.height()];
    let pixel = |axis: usize, step: usize| {
        let place = first[axis] as i64 + step as i64 - 1;
        place.clamp(0, size[axis] as i64 - 1) as usize
    };
    let mut sum = [0.0; 3];
    for (down, by_row) in weights[1].iter().enumerate() {
        let row = picture.row(pixel(1, down));
        for (right, by_column) in weights[0].iter().enumerate() {
            let codes = row[pixel(0, right)];
            for (sum, code) in sum.iter_mut().zip(codes) {
                *sum += by_row * by_column * f64::from(code);
            }
        }
    }
    sum.map(|code| code as f32)
}

pub(super) fn blurred(picture: &Picture, deviation: f64) -> Picture {
    Gaussian::new(deviation)
        .unwrap()
        .blur(picture, Border::Mirror)
}
