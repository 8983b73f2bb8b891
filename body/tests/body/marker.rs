//! Painted markers, in pictures of discs in space that are drawn here by rays.

use ga_body::marker::{Code, FindOptions, FoundMarker, INNER, find};
use ga_image::colour::{LinearColour, SrgbEncoder};
use ga_image::plane::Plane;
use ga_runtime::vga3::Vector;

/// A disc in the frame of a camera with f = 1000 px and the principal point (c, c).
struct Disc {
    centre: Vector<f64>,
    normal: Vector<f64>,
    radius: f64,
    code: Code,
    /// How bright it is lit.
    light: f64,
}

const FOCAL: f64 = 1000.0;
/// Samples along each side of a pixel.
const SAMPLES: usize = 12;

fn encoder() -> SrgbEncoder {
    SrgbEncoder::new()
}

/// The picture of discs before something grey: each pixel is the mean of the light of rays.
fn picture(size: usize, discs: &[Disc], hides: impl Fn([f64; 2]) -> bool) -> Plane<[u8; 3]> {
    let encoder = encoder();
    let middle = (size - 1) as f64 / 2.0;
    let grey = LinearColour::new(0.18, 0.18, 0.18);
    let colours: Vec<[LinearColour; 2]> = discs
        .iter()
        .map(|disc| {
            disc.code
                .colours()
                .map(|c| LinearColour::from_srgb(c) * disc.light)
        })
        .collect();
    Plane::from_fn(size, size, |column, row| {
        let mut sum = LinearColour::BLACK;
        for sample in 0..SAMPLES * SAMPLES {
            let offset = |k: usize| (k as f64 + 0.5) / SAMPLES as f64 - 0.5;
            let u = column as f64 + offset(sample % SAMPLES);
            let v = row as f64 + offset(sample / SAMPLES);
            let ray = Vector::new((u - middle) / FOCAL, (v - middle) / FOCAL, 1.0);
            let hit = discs.iter().zip(&colours).find_map(|(disc, colours)| {
                let depth = disc.centre.dot(disc.normal) / ray.dot(disc.normal);
                let distance = (ray * depth).distance(disc.centre) / disc.radius;
                (distance < 1.0).then(|| colours[usize::from(distance >= INNER)])
            });
            let hit = hit.filter(|_| !hides([u - middle, v - middle]));
            sum += hit.unwrap_or(grey);
        }
        encoder.encode(sum * (1.0 / (SAMPLES * SAMPLES) as f64))
    })
}

fn disc(number: usize, centre: [f64; 3], tilt_degrees: f64, about: f64) -> Disc {
    let (sin, cos) = tilt_degrees.to_radians().sin_cos();
    Disc {
        centre: centre.into(),
        normal: Vector::new(sin * about.cos(), sin * about.sin(), -cos),
        radius: 0.02,
        code: Code::new(number).unwrap(),
        light: 1.0,
    }
}

fn found(size: usize, discs: &[Disc]) -> Vec<FoundMarker> {
    find(
        picture(size, discs, |_| false).view(),
        &FindOptions::default(),
    )
}

/// Where the camera sees the centre.
fn pixel(size: usize, disc: &Disc) -> [f64; 2] {
    let [x, y, z] = disc.centre.coordinates();
    let middle = (size - 1) as f64 / 2.0;
    [x, y].map(|c| FOCAL * c / z + middle)
}

fn error(size: usize, disc: &Disc, marker: &FoundMarker) -> f64 {
    let [u, v] = pixel(size, disc);
    (marker.centre[0] - u).hypot(marker.centre[1] - v)
}

#[test]
fn every_code_is_known_in_any_light() {
    for number in 0..Code::COUNT {
        let mut disc = disc(number, [0.003, -0.001, 4.0], 0.0, 0.0);
        disc.light = 0.25 + 0.75 * (number % 7) as f64 / 6.0;
        let found = found(24, &[disc]);
        assert_eq!(found.len(), 1, "{number}");
        assert_eq!(found[0].code.number(), number);
    }
    assert!(Code::new(Code::COUNT).is_none());
}

#[test]
fn centres_and_axes_of_inclined_discs_are_found_to_a_fraction_of_a_pixel() {
    let mut squares = 0.0;
    let mut count = 0;
    for step in 0..60 {
        let tilt = (step % 6) as f64 * 10.0;
        let about = f64::from(step) * 0.7;
        let depth = 2.5 + 0.05 * f64::from(step % 21);
        let place = [
            0.0013 * f64::from(step % 9),
            -0.0017 * f64::from(step % 5),
            depth,
        ];
        let disc = disc(step as usize, place, tilt, about);
        let found = found(32, &[disc]);
        let disc = self::disc(step as usize, place, tilt, about);
        assert_eq!(found.len(), 1, "tilt {tilt}, depth {depth}");
        assert_eq!(found[0].code, disc.code);
        let distance = error(32, &disc, &found[0]);
        assert!(distance < 0.08, "tilt {tilt}: {distance} px");
        squares += distance * distance;
        count += 1;
        let radius = FOCAL * disc.radius / depth;
        let [greater, smaller] = found[0].semi_axes;
        assert!((greater / radius - 1.0).abs() < 0.04, "{greater} {radius}");
        let expected = radius * tilt.to_radians().cos();
        assert!(
            (smaller / expected - 1.0).abs() < 0.06,
            "{smaller} {expected}"
        );
    }
    let root_mean_square = (squares / f64::from(count)).sqrt();
    assert!(root_mean_square < 0.03, "{root_mean_square} px");
}

#[test]
fn neighbours_are_told_apart() {
    let discs = [
        disc(3, [-0.021, 0.0, 4.0], 20.0, 1.0),
        disc(40, [0.023, 0.004, 4.0], 30.0, 2.0),
    ];
    let found = found(40, &discs);
    assert_eq!(found.len(), 2);
    for (disc, marker) in discs.iter().zip(&found) {
        assert_eq!(marker.code, disc.code);
        assert!(error(40, disc, marker) < 0.08);
    }
}

#[test]
fn what_is_hidden_in_part_is_not_a_marker() {
    for cut in [-0.3, 0.0, 0.4] {
        let disc = disc(11, [0.0, 0.0, 3.0], 0.0, 0.0);
        let radius = FOCAL * disc.radius / 3.0;
        let picture = picture(32, &[disc], |[u, v]| u * 0.8 + v * 0.6 > cut * radius);
        assert_eq!(find(picture.view(), &FindOptions::default()), []);
    }
}

#[test]
fn discs_seen_from_the_side_or_cut_off_and_codes_seen_twice_are_left_out() {
    assert_eq!(found(32, &[disc(5, [0.0, 0.0, 3.0], 68.0, 0.3)]), []);
    assert_eq!(found(32, &[disc(5, [0.04, 0.0, 3.0], 0.0, 0.3)]), []);
    let twice = [-0.03, 0.03].map(|x| disc(5, [x, 0.0, 3.0], 0.0, 0.0));
    assert_eq!(found(48, &twice), []);
    // One colour alone is not a marker, and grey is nothing.
    let plain = Plane::filled(20, 20, [128; 3]);
    assert_eq!(find(plain.view(), &FindOptions::default()), []);
    let red = Plane::from_fn(20, 20, |column, row| {
        let inside = (column as f64 - 9.0).hypot(row as f64 - 9.0) < 5.0;
        if inside { [200, 0, 0] } else { [128; 3] }
    });
    assert_eq!(find(red.view(), &FindOptions::default()), []);
    let empty: Plane<[u8; 3]> = Plane::filled(0, 0, [0; 3]);
    assert_eq!(find(empty.view(), &FindOptions::default()), []);
}
