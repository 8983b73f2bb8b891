//! The colour of the skin and the clothes at each place of the body at rest.

use std::f64::consts::TAU;

use ga_runtime::scalar::smooth_step;

use super::noise::{noise, rough, spots};
use crate::Vector;
use crate::landmarks::Landmarks;

/// A colour encoded as sRGB, each channel from 0 to 1.
pub(super) type Colour = [f64; 3];

const SKIN: Colour = [0.80, 0.61, 0.51];
const FLUSHED: Colour = [0.76, 0.44, 0.38];
const FRECKLE: Colour = [0.58, 0.38, 0.28];
const LIPS: Colour = [0.66, 0.34, 0.32];
const MOUTH: Colour = [0.33, 0.14, 0.13];
const HAIR: Colour = [0.25, 0.16, 0.10];
const WHITE_OF_EYE: Colour = [0.93, 0.91, 0.89];
const IRIS: Colour = [0.27, 0.42, 0.50];
const BLACK: Colour = [0.05, 0.04, 0.04];
const SHIRT: Colour = [0.22, 0.40, 0.62];
const STRIPE: Colour = [0.88, 0.87, 0.80];
const CROSSED: Colour = [0.62, 0.16, 0.17];
const BUTTON: Colour = [0.94, 0.92, 0.86];
const DENIM: Colour = [0.17, 0.20, 0.30];
const SEAM: Colour = [0.66, 0.48, 0.24];
const BELT: Colour = [0.28, 0.17, 0.10];
const BUCKLE: Colour = [0.78, 0.72, 0.52];
const LEATHER: Colour = [0.40, 0.23, 0.13];
const SOLE: Colour = [0.86, 0.84, 0.80];

/// The heights of belt, trouser legs and shoes.
const WAIST: f64 = 1.0;
const BELT_HALF: f64 = 0.017;
const TROUSERS_END: f64 = 0.100;
/// Where the sleeves are sewn on: their distance from the middle, and the height of the armpits.
const ARMHOLE: f64 = 0.176;
const ARMPIT: f64 = 1.29;
/// The period of the checks.
const CHECK: f64 = 0.060;
/// How far the sleeves reach along the arm.
const SLEEVE: f64 = 0.215;
/// The middle of the left eye, seen from the front.
const EYE: [f64; 2] = [0.032, 1.640];

/// The colour at a point of the surface.
pub(super) fn colour(landmarks: &Landmarks, point: Vector) -> Colour {
    let folded = Vector::new(point.e1.abs(), point.e2, point.e3);
    let above_armpit = folded.e2 > ARMPIT;
    let armhole = folded.e1 - ARMHOLE;
    let stitched = |colour: Colour, distance: f64| {
        let line = falling(0.0012, 0.0030, distance.abs());
        mix(colour, scaled(SHIRT, 0.45), line)
    };
    if folded.e1 > 0.20 || above_armpit && armhole > 0.0 {
        let arm = folded - landmarks.arm.origin;
        let along = arm.dot(landmarks.arm.along);
        if along > SLEEVE {
            return skin(point, folded);
        }
        let angle = arm.e3.atan2(arm.dot(landmarks.arm.across));
        let sleeve = stitched(
            shirt(point, along, around(6, angle)),
            SLEEVE - 0.012 - along,
        );
        return if above_armpit {
            stitched(sleeve, armhole)
        } else {
            sleeve
        };
    }
    // The neckline is level around the neck, lower in front, and rises towards the shoulders.
    let frontal = smooth_step(-0.01, 0.06, folded.e3);
    let rising = 0.35 * folded.e1 * frontal + 0.9 * (folded.e1 - 0.055).max(0.0);
    let above_collar = folded.e2 - (1.470 - 0.050 * frontal + rising);
    if above_collar > 0.0 {
        return head(point, folded);
    }
    if folded.e2 > WAIST + BELT_HALF {
        let angle = (point.e1 / 0.165).atan2((point.e3 + 0.01) / 0.110);
        let cloth = front(shirt(point, point.e2, around(16, angle)), point);
        let collar = stitched(cloth, above_collar + 0.012);
        return if above_armpit {
            stitched(collar, armhole)
        } else {
            collar
        };
    }
    if folded.e2 > WAIST - BELT_HALF {
        return belt(point);
    }
    if folded.e2 > TROUSERS_END {
        return trousers(point, folded);
    }
    shoe(landmarks, point, folded)
}

fn mix(a: Colour, b: Colour, t: f64) -> Colour {
    std::array::from_fn(|i| a[i] + (b[i] - a[i]) * t.clamp(0.0, 1.0))
}

/// A smooth step from 1 at `low` down to 0 at `high`.
fn falling(low: f64, high: f64, x: f64) -> f64 {
    1.0 - smooth_step(low, high, x)
}

fn scaled(colour: Colour, factor: f64) -> Colour {
    colour.map(|c| c * factor)
}

fn skin(point: Vector, folded: Vector) -> Colour {
    let tone = scaled(
        SKIN,
        1.0 + 0.05 * rough(point * 35.0) + 0.035 * rough(point * 160.0),
    );
    // Blood shows at the cheeks, the nose, the ears, the elbows and the fingers.
    let warm = |centre: Vector, radius: f64| falling(0.3 * radius, radius, folded.distance(centre));
    let flush = [
        (Vector::new(0.042, 1.608, 0.090), 0.034, 0.40),
        (Vector::new(0.0, 1.604, 0.120), 0.020, 0.45),
        (Vector::new(0.080, 1.632, -0.012), 0.030, 0.45),
    ];
    let mut reddened = tone;
    for (centre, radius, strength) in flush {
        reddened = mix(reddened, FLUSHED, strength * warm(centre, radius));
    }
    let freckles = spots(point * 90.0, 0.30, 0.33);
    let moles = spots(point * 22.0, 0.08, 0.07);
    let spotted = mix(reddened, FRECKLE, 0.55 * freckles.sqrt());
    mix(spotted, FRECKLE, (1.6 * moles).min(0.8))
}

fn head(point: Vector, folded: Vector) -> Colour {
    let mut colour = skin(point, folded);
    if folded.e3 > 0.06 {
        colour = face(colour, point, folded);
    }
    let strands = Vector::new(230.0 * point.e1, 30.0 * point.e2, 230.0 * point.e3);
    let hair = scaled(HAIR, 1.0 + 0.45 * rough(strands));
    // The hairline falls from the forehead to the temples, behind the ears and to the nape.
    let back = smooth_step(-0.035, 0.055, folded.e3);
    let line = 1.570 + 0.137 * back + 0.004 * noise(point * 120.0);
    let ear = folded.distance(Vector::new(0.078, 1.632, -0.012)) < 0.034 && folded.e1 > 0.0735;
    if ear {
        return colour;
    }
    mix(colour, hair, smooth_step(-0.003, 0.003, folded.e2 - line))
}

/// Eyes, eyebrows and mouth, seen from the front.
fn face(mut colour: Colour, point: Vector, folded: Vector) -> Colour {
    let (dx, dy) = (folded.e1 - EYE[0], folded.e2 - EYE[1]);
    let across = dx / 0.0150;
    // The brow rises outwards and bends down at its end.
    let brow = folded.e2 - (1.6585 + 0.10 * (dx + 0.012) - 6.0 * (dx - 0.004).powi(2));
    let hairs = 0.5 + 0.5 * noise(Vector::new(420.0 * point.e1, 160.0 * point.e2, 0.0));
    let in_brow = falling(0.0030, 0.0052, brow.abs()) * falling(0.017, 0.021, dx.abs());
    colour = mix(colour, HAIR, in_brow * (0.55 + 0.45 * hairs));
    if across.abs() < 1.0 {
        let lid = 1.0 - across * across;
        let (top, bottom) = (0.0063 * lid, -0.0052 * lid);
        if dy < top && dy > bottom {
            let radius = dx.hypot(dy - 0.0005);
            let rays = 1.0 + 0.25 * noise(Vector::new(4.0 * dy.atan2(dx), 900.0 * radius, 0.0));
            colour = match radius {
                r if r < 0.0024 => BLACK,
                r if r < 0.0054 => scaled(IRIS, rays),
                r if r < 0.0061 => scaled(IRIS, 0.45),
                _ => scaled(WHITE_OF_EYE, 1.0 - 0.10 * across.abs()),
            };
        }
        let upper = falling(0.0004, 0.0014, (dy - top).abs());
        let lower = 0.45 * falling(0.0003, 0.0010, (dy - bottom).abs());
        colour = mix(colour, BLACK, upper.max(lower));
    }
    // The lips, with the two peaks of the upper one.
    let x = folded.e1 / 0.0235;
    if x < 1.0 && (1.555..1.590).contains(&folded.e2) {
        let height = folded.e2 - 1.5720;
        let arc = (1.0 - x * x).sqrt();
        let upper = 0.0078 * arc * (0.86 + 0.14 * (1.0 - (1.0 - 4.0 * x).powi(2)).max(-1.0));
        let lower = -0.0092 * arc;
        let inside =
            falling(-0.0007, 0.0007, height - upper) * smooth_step(-0.0007, 0.0007, height - lower);
        let lined = scaled(
            LIPS,
            1.0 + 0.10 * noise(Vector::new(700.0 * point.e1, 60.0 * height, 3.0)),
        );
        colour = mix(colour, lined, inside);
        colour = mix(colour, MOUTH, falling(0.0005, 0.0014, height.abs()));
    }
    let nostril = Vector::new(0.0065, 1.5965, 0.0);
    let hole = (folded.e1 - nostril.e1).hypot(1.6 * (folded.e2 - nostril.e2));
    mix(colour, MOUTH, 0.8 * falling(0.0025, 0.0045, hole))
}

/// The length around a limb at an angle, where this many periods of the checks go around it.
fn around(periods: u32, angle: f64) -> f64 {
    f64::from(periods) * CHECK * angle / TAU
}

/// A checked cloth; `along` and `around` are lengths in metres on it.
fn shirt(point: Vector, along: f64, around: f64) -> Colour {
    let band = |place: f64, period: f64, width: f64| {
        let distance = (place / period - (place / period).round()).abs() * period;
        falling(0.7 * width, width, distance)
    };
    let mut colour = scaled(SHIRT, 1.0 + 0.10 * rough(point * 60.0));
    colour = mix(colour, scaled(SHIRT, 0.6), 0.7 * band(along, CHECK, 0.015));
    colour = mix(colour, scaled(SHIRT, 0.6), 0.7 * band(around, CHECK, 0.015));
    colour = mix(colour, STRIPE, 0.8 * band(along + 0.030, CHECK, 0.0030));
    colour = mix(colour, STRIPE, 0.8 * band(around + 0.030, CHECK, 0.0030));
    mix(
        colour,
        CROSSED,
        0.8 * band(along + 0.018, 2.0 * CHECK, 0.0030),
    )
}

/// The front of the shirt with its buttons.
fn front(colour: Colour, point: Vector) -> Colour {
    if point.e3 < 0.0 {
        return colour;
    }
    let edge = falling(0.0012, 0.0025, (point.e1 - 0.016).abs());
    let button = (point.e2 / 0.085 - (point.e2 / 0.085).round()) * 0.085;
    let button = falling(0.0050, 0.0065, point.e1.hypot(button));
    mix(mix(colour, scaled(SHIRT, 0.4), edge), BUTTON, button)
}

fn belt(point: Vector) -> Colour {
    let height = (point.e2 - WAIST).abs();
    let leather = scaled(BELT, 1.0 + 0.25 * rough(point * 90.0));
    let stitched = mix(
        leather,
        SEAM,
        0.5 * falling(0.0007, 0.0014, (height - 0.013).abs()),
    );
    if point.e3 < 0.0 || point.e1.abs() > 0.026 {
        return stitched;
    }
    let frame = point.e1.abs() > 0.019 || height > 0.011;
    if frame { BUCKLE } else { stitched }
}

fn trousers(point: Vector, folded: Vector) -> Colour {
    let faded = 1.0
        + 0.22
            * rough(Vector::new(
                40.0 * point.e1,
                14.0 * point.e2,
                40.0 * point.e3,
            ));
    let twill = 1.0 + 0.10 * (TAU * (point.e2 + 0.5 * point.e1 + 0.5 * point.e3) / 0.011).sin();
    let worn = 0.16 * falling(0.06, 0.16, (folded.e2 - 0.52).abs());
    let front_of_leg = smooth_step(0.0, 0.05, folded.e3);
    let cloth = mix(scaled(DENIM, faded * twill), STRIPE, worn * front_of_leg);
    let line = |distance: f64| falling(0.0011, 0.0022, distance.abs());
    // The pockets, the hem, and the seam at the side of the leg.
    let pocket = if folded.e2 > 0.84 && folded.e3 > 0.0 {
        line(folded.e1 + folded.e2 - 1.045)
    } else {
        0.0
    };
    let hem = line(folded.e2 - TROUSERS_END - 0.014);
    let side = if folded.e1 > 0.10 && folded.e2 > 0.55 {
        line(folded.e3 - 0.012)
    } else {
        0.0
    };
    mix(cloth, SEAM, 0.8 * pocket.max(hem).max(side))
}

fn shoe(landmarks: &Landmarks, point: Vector, folded: Vector) -> Colour {
    if folded.e2 < 0.016 {
        return scaled(SOLE, 1.0 + 0.10 * rough(point * 120.0));
    }
    let leather = scaled(LEATHER, 1.0 + 0.20 * rough(point * 80.0));
    let offset = folded - landmarks.foot.origin;
    let (along, across) = (
        offset.dot(landmarks.foot.along),
        offset.dot(landmarks.foot.across),
    );
    let welt = falling(0.0015, 0.0030, (folded.e2 - 0.021).abs());
    let mut colour = mix(leather, SEAM, 0.7 * welt);
    if (0.035..0.115).contains(&along) && across.abs() < 0.026 {
        let lace = (along / 0.016 - (along / 0.016).round()) * 0.016;
        colour = mix(colour, BUTTON, falling(0.0022, 0.0034, lace.abs()));
    }
    colour
}
