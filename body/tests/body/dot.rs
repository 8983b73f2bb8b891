//! Dots of one colour, in pictures that are drawn here.

use ga_body::marker::{DotOptions, Hue, find_dots};
use ga_image::colour::{LinearColour, SrgbEncoder};
use ga_image::plane::Plane;

/// Samples along each side of a pixel.
const SAMPLES: usize = 12;
const SIDE: usize = 30;

/// An ellipse on grey, with light that changes across it.
struct Spot {
    hue: Hue,
    centre: [f64; 2],
    semi_axes: [f64; 2],
    angle: f64,
    /// The light at the centre in each channel.
    light: LinearColour,
    /// The change of the light in a pixel, along x.
    slope: f64,
}

impl Spot {
    fn new(hue: Hue) -> Self {
        Self {
            hue,
            centre: [14.3, 15.8],
            semi_axes: [3.0, 3.0],
            angle: 0.0,
            light: LinearColour::WHITE,
            slope: 0.0,
        }
    }

    fn covers(&self, [x, y]: [f64; 2]) -> bool {
        let (sin, cos) = self.angle.sin_cos();
        let [x, y] = [x - self.centre[0], y - self.centre[1]];
        let [a, b] = self.semi_axes;
        ((x * cos + y * sin) / a).hypot((y * cos - x * sin) / b) < 1.0
    }

    fn picture(&self) -> Plane<[u8; 3]> {
        let encoder = SrgbEncoder::new();
        let grey = LinearColour::new(0.1, 0.1, 0.1);
        let paint = LinearColour::from_srgb(self.hue.colour());
        Plane::from_fn(SIDE, SIDE, |column, row| {
            let mut sum = LinearColour::BLACK;
            for sample in 0..SAMPLES * SAMPLES {
                let offset = |k: usize| (k as f64 + 0.5) / SAMPLES as f64 - 0.5;
                let x = column as f64 + offset(sample % SAMPLES);
                let y = row as f64 + offset(sample / SAMPLES);
                let albedo = if self.covers([x, y]) { paint } else { grey };
                let light = self.light * (1.0 + self.slope * (x - self.centre[0])).max(0.0);
                let [r, g, b] = [0, 1, 2].map(|k| albedo.channels()[k] * light.channels()[k]);
                sum += LinearColour::new(r, g, b);
            }
            encoder.encode(sum * (1.0 / (SAMPLES * SAMPLES) as f64))
        })
    }

    /// The distance of the only dot that is found from the centre.
    fn error(&self) -> f64 {
        let found = find_dots(self.picture().view(), &DotOptions::default());
        assert_eq!(found.len(), 1, "{:?}", self.hue);
        assert_eq!(found[0].hue, self.hue);
        let [u, v] = self.centre;
        (found[0].centre[0] - u).hypot(found[0].centre[1] - v)
    }
}

#[test]
fn hues_are_known_in_bright_dim_and_coloured_light() {
    let lights = [
        LinearColour::WHITE,
        LinearColour::new(0.2, 0.2, 0.2),
        // A lamp, and a shadow under a blue sky.
        LinearColour::new(1.0, 0.85, 0.7),
        LinearColour::new(0.36, 0.42, 0.52),
    ];
    for hue in Hue::ALL {
        for light in lights {
            let spot = Spot {
                light,
                ..Spot::new(hue)
            };
            assert!(
                spot.error() < 0.06,
                "{hue:?} {light:?}: {} px",
                spot.error()
            );
        }
    }
}

#[test]
fn centres_of_ellipses_are_found_to_a_fraction_of_a_pixel() {
    let mut squares = 0.0;
    let mut count = 0;
    for step in 0..48 {
        let k = f64::from(step);
        let greater = 2.2 + 0.05 * k;
        let spot = Spot {
            centre: [14.0 + 0.13 * (k % 7.0), 15.0 + 0.17 * (k % 5.0)],
            semi_axes: [greater, greater * (1.0 - 0.1 * (k % 6.0))],
            angle: 0.4 * k,
            ..Spot::new(Hue::ALL[step as usize % 6])
        };
        let error = spot.error();
        assert!(error < 0.12, "{step}: {error} px");
        squares += error * error;
        count += 1;
    }
    let root_mean_square = (squares / f64::from(count)).sqrt();
    assert!(root_mean_square < 0.05, "{root_mean_square} px");
}

#[test]
fn light_from_the_side_does_not_move_the_centre() {
    // On a limb of 10 px in radius, lit at 60° from the normal, light changes by 17 % in a pixel.
    for slope in [0.08, 0.17] {
        let spot = Spot {
            slope,
            ..Spot::new(Hue::Cyan)
        };
        // The mean of the light alone is off by slope r² / 4: 0.18 and 0.38 px.
        assert!(spot.error() < 0.12, "{slope}: {} px", spot.error());
    }
}

#[test]
fn dots_of_two_hues_that_nearly_touch_are_two() {
    let spots = [(Hue::Red, 9.0), (Hue::Blue, 16.2)].map(|(hue, x)| Spot {
        centre: [x, 14.0],
        ..Spot::new(hue)
    });
    let pictures = spots.each_ref().map(Spot::picture);
    let both = Plane::from_fn(SIDE, SIDE, |column, row| {
        let side = usize::from(column as f64 > 12.6);
        pictures[side].row(row)[column]
    });
    let found = find_dots(both.view(), &DotOptions::default());
    let hues: Vec<Hue> = found.iter().map(|dot| dot.hue).collect();
    assert!(hues.contains(&Hue::Red) && hues.contains(&Hue::Blue) && hues.len() == 2);
}

#[test]
fn grey_and_large_areas_are_not_dots() {
    let grey = Plane::filled(20, 20, [128; 3]);
    assert_eq!(find_dots(grey.view(), &DotOptions::default()), []);
    let large = Spot {
        semi_axes: [9.0, 9.0],
        ..Spot::new(Hue::Green)
    };
    let options = DotOptions {
        greatest_semi_axis: 8.0,
        ..DotOptions::default()
    };
    assert_eq!(find_dots(large.picture().view(), &options), []);
    let empty: Plane<[u8; 3]> = Plane::filled(0, 0, [0; 3]);
    assert_eq!(find_dots(empty.view(), &DotOptions::default()), []);
}
