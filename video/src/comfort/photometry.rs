//! How the colours of the right view differ from those of the left one.

use ga_image::colour::linear_from_srgb;
use ga_image::plane::Plane;
use ga_image::ycbcr::YCbCr;

use super::matching::Match;
use super::tone::{Tone, above_black};
use crate::Planes;
use ga_numerics::order_statistics::median;
use serde::{Deserialize, Serialize};

/// Colour differences are averaged over this number of pixels on either side of a match.
const RADIUS: usize = 7;

/// The code that stands for mid grey.
const MID_GREY: f64 = 128.0;

/// How brightness and colour differ, right view less left view, at points that both show.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Photometry {
    /// By how many codes, of 255, the right view is brighter: the median of the channels'
    /// [`offsets`](Self::channel_offsets), so that another gain of one channel alone does not
    /// count.
    pub offset_codes: f64,
    /// The relative difference of luminance that this offset makes at mid grey, in per cent:
    /// 12 codes are about 20 %, 25 codes about 50 %.
    pub luminance_percent: f64,
    /// The medians of the differences of red, green and blue, in codes of 255.
    pub channel_offsets: [f64; 3],
    /// The medians of the ratios of red, green and blue.
    pub channel_ratios: [f64; 3],
    /// The codes of red, green and blue in the left view that stand for those of the right view: an
    /// offset, a factor or both, whichever explains the differences.
    pub tones: [Tone; 3],
    /// The length of the median (Δa\*, Δb\*) of CIE 1976 L\*a\*b\*, after the difference in
    /// brightness has been removed: as an offset or as a gain common to all channels, whichever
    /// leaves less.
    pub colour_difference: f64,
}

/// Colours of the surroundings of matches.
#[derive(Clone, Debug, Default)]
pub(super) struct Colours {
    /// Red, green and blue in the left and in the right view, from 0 to 255.
    pairs: Vec<[[f64; 3]; 2]>,
    numbers: Vec<f64>,
}

impl Colours {
    /// The photometry at some matches; `None` where there are none.
    pub(super) fn measure(
        &mut self,
        views: [&Planes<u8>; 2],
        colours: YCbCr,
        matches: &[Match],
    ) -> Option<Photometry> {
        self.pairs.clear();
        for found in matches {
            let places = [found.left, found.right];
            self.pairs.push(std::array::from_fn(|side| {
                let [cb, cr] = differences_around(views[side], places[side]);
                let encoded = [found.luma[side] as f32, cb, cr];
                colours.decoded(encoded).map(f64::from)
            }));
        }
        if self.pairs.is_empty() {
            return None;
        }
        let channel_offsets =
            [0, 1, 2].map(|channel| self.channel_median(channel, |left, right| right - left));
        let of_codes = |left: f64, right: f64| above_black(right) / above_black(left);
        let channel_ratios = [0, 1, 2].map(|channel| self.channel_median(channel, of_codes));
        let offset_codes = middle(channel_offsets);
        let ratio = middle(channel_ratios);
        let as_offset = self.colour_difference(|code| code - offset_codes);
        let as_gain = self.colour_difference(|code| code / ratio);
        Some(Photometry {
            offset_codes,
            luminance_percent: luminance_percent(offset_codes),
            channel_offsets,
            channel_ratios,
            tones: [0, 1, 2].map(|channel| {
                let codes = |pair: [[f64; 3]; 2]| pair.map(|rgb| rgb[channel]);
                let pairs: Vec<_> = self.uncut(&[channel]).into_iter().map(codes).collect();
                Tone::between(&pairs)
            }),
            colour_difference: as_offset.min(as_gain),
        })
    }

    /// The length of the median (Δa*, Δb*) with the right view changed.
    fn colour_difference(&mut self, change: impl Fn(f64) -> f64) -> f64 {
        let [a, b] = [0, 1].map(|axis| {
            self.uncut_median(&[0, 1, 2], |[left, right]| {
                chromaticness(right.map(&change))[axis] - chromaticness(left)[axis]
            })
        });
        a.hypot(b)
    }

    /// The median of a number for the left and the right value of a channel.
    fn channel_median(&mut self, channel: usize, number: impl Fn(f64, f64) -> f64) -> f64 {
        self.uncut_median(&[channel], |[left, right]| {
            number(left[channel], right[channel])
        })
    }

    /// The median of a number for [uncut](Self::uncut) surroundings in both views.
    fn uncut_median(&mut self, channels: &[usize], number: impl Fn([[f64; 3]; 2]) -> f64) -> f64 {
        let pairs = self.uncut(channels);
        self.numbers.clear();
        self.numbers.extend(pairs.into_iter().map(number));
        median(&mut self.numbers).unwrap_or(f64::NAN)
    }

    /// Colours of surroundings in the left and in the right view. Those in which pixels may have
    /// been cut off at black or white in these channels are left out, unless few others remain.
    fn uncut(&self, channels: &[usize]) -> Vec<[[f64; 3]; 2]> {
        const UNCUT: std::ops::RangeInclusive<f64> = 32.0..=223.0;
        const LEAST: usize = 12;
        let is_uncut = |pair: &&[[f64; 3]; 2]| {
            let codes = pair.iter().map(|rgb| channels.iter().map(|&k| rgb[k]));
            codes.flatten().all(|code| UNCUT.contains(&code))
        };
        let uncut: Vec<_> = self.pairs.iter().filter(is_uncut).copied().collect();
        match uncut.len() >= LEAST.max(self.pairs.len() / 4) {
            true => uncut,
            false => self.pairs.clone(),
        }
    }
}

/// The relative difference of luminance of mid grey and what is brighter or darker by an offset,
/// in per cent of the darker one.
fn luminance_percent(offset_codes: f64) -> f64 {
    let luminance = |code: f64| linear_from_srgb(code / 255.0);
    100.0 * (luminance(MID_GREY + offset_codes.abs()) / luminance(MID_GREY) - 1.0)
}

/// The second of three numbers.
fn middle(mut numbers: [f64; 3]) -> f64 {
    median(&mut numbers).unwrap_or(f64::NAN)
}

/// a* and b* of CIE 1976 L*a*b* (ISO/CIE 11664-4) of a colour in sRGB, for the white D65.
fn chromaticness(codes: [f64; 3]) -> [f64; 2] {
    /// Rows for X, Y and Z, divided by those of white (IEC 61966-2-1).
    const TO_XYZ: [[f64; 3]; 3] = [
        [0.433_953, 0.376_219, 0.189_828],
        [0.212_673, 0.715_152, 0.072_175],
        [0.017_758, 0.109_477, 0.872_765],
    ];
    let light = codes.map(|code| linear_from_srgb((code / 255.0).clamp(0.0, 1.0)));
    let [x, y, z] = TO_XYZ.map(|row| {
        let t: f64 = row
            .iter()
            .zip(light)
            .map(|(weight, light)| weight * light)
            .sum();
        let kink = 6.0_f64 / 29.0;
        if t > kink.powi(3) {
            t.cbrt()
        } else {
            t / (3.0 * kink * kink) + 4.0 / 29.0
        }
    });
    [500.0 * (x - y), 200.0 * (y - z)]
}

/// The means of the stored colour differences around a pixel; neutral in a grey view.
fn differences_around(planes: &Planes<u8>, [u, v]: [f64; 2]) -> [f32; 2] {
    let size = [planes.luma.width(), planes.luma.height()];
    planes.differences.each_ref().map(|plane| {
        if plane.is_empty() {
            return 128.0;
        }
        // One or two pixels for each number.
        let stored = [plane.width(), plane.height()];
        let range = |axis: usize, place: f64| {
            let pixels = size[axis].div_ceil(stored[axis]);
            let middle = (place.round().max(0.0) as usize / pixels).min(stored[axis] - 1);
            let around = RADIUS / pixels;
            middle.saturating_sub(around)..(middle + around + 1).min(stored[axis])
        };
        mean(plane, range(0, u), range(1, v))
    })
}

fn mean(plane: &Plane<u8>, columns: std::ops::Range<usize>, rows: std::ops::Range<usize>) -> f32 {
    let count = columns.len() * rows.len();
    let row = |row: usize| -> u32 {
        let values = &plane.row(row)[columns.clone()];
        values.iter().map(|value| u32::from(*value)).sum()
    };
    rows.map(row).sum::<u32>() as f32 / count as f32
}
