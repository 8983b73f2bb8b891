//! Where the samples of a video lie in an MP4 file, and when they are shown.

use std::ops::Range;

use ga_image::orientation::Orientation;
use re_mp4::{Co64Box, CttsBox, ElstBox, MdhdBox, MvhdBox, StcoBox, StscBox, StszBox, SttsBox};

use super::boxes::Node;

/// A sample: the bytes of one picture, still encoded.
#[derive(Clone, Copy, Debug)]
pub(super) struct Sample {
    /// The index of its first byte in the file.
    pub(super) offset: u64,
    /// Its bytes.
    pub(super) size: u32,
    /// When it is shown, in the unit of the track.
    pub(super) time: i64,
}

/// The samples of a track, in the order in which they are decoded.
#[derive(Debug)]
pub(super) struct Table {
    pub(super) samples: Vec<Sample>,
    /// Units of time in a second.
    pub(super) timescale: u32,
    /// The times at which samples are shown; others are only decoded.
    pub(super) shown: Range<i64>,
    /// Width and height of a pixel.
    pub(super) pixel_aspect: [u32; 2],
}

impl Table {
    /// Reads the boxes of a track, in a file of `length` bytes.
    pub(super) fn new(moov: Node<'_>, trak: Node<'_>, length: u64) -> Result<Self, String> {
        let mdia = trak.child(b"mdia")?;
        let stbl = mdia.child(b"minf")?.child(b"stbl")?;
        let timescale = mdia.child(b"mdhd")?.parse::<MdhdBox>()?.timescale;
        if timescale == 0 {
            return Err("the track has 0 units of time in a second".into());
        }
        let mut samples = places(stbl, length)?;
        add_times(&mut samples, stbl)?;
        // A sample without bytes stands for a picture that was left out.
        samples.retain(|sample| sample.size > 0);
        Ok(Self {
            samples,
            timescale,
            shown: shown(moov, trak, timescale)?,
            pixel_aspect: [1, 1],
        })
    }
}

/// The samples, without their times.
fn places(stbl: Node<'_>, length: u64) -> Result<Vec<Sample>, String> {
    let sizes: StszBox = stbl.child(b"stsz")?.parse()?;
    let count = sizes.sample_count as usize;
    // One size for all samples. A picture has more bytes than the length before a unit.
    if (1..5).contains(&sizes.sample_size) {
        return Err(format!(
            "samples of {} bytes hold no picture",
            sizes.sample_size
        ));
    }
    if u64::from(sizes.sample_size) * count as u64 > length {
        return Err(format!("{count} samples are more than the file holds"));
    }
    let chunks: Vec<u64> = match stbl.find(b"co64")? {
        Some(co64) => co64.parse::<Co64Box>()?.entries,
        None => {
            let stco = stbl.child(b"stco")?.parse::<StcoBox>()?;
            stco.entries.into_iter().map(u64::from).collect()
        }
    };
    let runs = stbl.child(b"stsc")?.parse::<StscBox>()?.entries;
    let mut samples = Vec::with_capacity(count);
    let mut run = 0;
    for (chunk, &offset) in chunks.iter().enumerate() {
        let number = chunk as u64 + 1;
        while runs
            .get(run + 1)
            .is_some_and(|next| u64::from(next.first_chunk) <= number)
        {
            run += 1;
        }
        let Some(in_chunk) = runs.get(run) else {
            return Err("the box stsc has no entries".into());
        };
        let mut offset = offset;
        for _ in 0..in_chunk.samples_per_chunk {
            if samples.len() == count {
                return Ok(samples);
            }
            let size = match sizes.sample_size {
                0 => sizes.sample_sizes.get(samples.len()).copied().unwrap_or(0),
                size => size,
            };
            samples.push(Sample {
                offset,
                size,
                time: 0,
            });
            offset = offset.saturating_add(u64::from(size));
        }
    }
    if samples.len() < count {
        let found = samples.len();
        return Err(format!("the chunks hold {found} of {count} samples"));
    }
    Ok(samples)
}

fn add_times(samples: &mut [Sample], stbl: Node<'_>) -> Result<(), String> {
    let durations = stbl.child(b"stts")?.parse::<SttsBox>()?.entries;
    let mut delays = match stbl.find(b"ctts")? {
        Some(ctts) => ctts.parse::<CttsBox>()?.entries,
        None => Vec::new(),
    }
    .into_iter()
    .flat_map(|run| (0..run.sample_count).map(move |_| run.sample_offset));
    let mut durations = durations
        .into_iter()
        .flat_map(|run| (0..run.sample_count).map(move |_| run.sample_delta));
    let (mut decoded, count) = (0_i64, samples.len());
    for (index, sample) in samples.iter_mut().enumerate() {
        sample.time = decoded.saturating_add(i64::from(delays.next().unwrap_or(0)));
        let Some(duration) = durations.next() else {
            return Err(format!("{index} of {count} samples have a duration"));
        };
        decoded = decoded.saturating_add(i64::from(duration));
    }
    Ok(())
}

/// The times at which the edit list shows the track.
fn shown(moov: Node<'_>, trak: Node<'_>, timescale: u32) -> Result<Range<i64>, String> {
    let everything = i64::MIN..i64::MAX;
    let Some(elst) = trak
        .find(b"edts")?
        .map(|edts| edts.find(b"elst"))
        .transpose()?
        .flatten()
    else {
        return Ok(everything);
    };
    let list: ElstBox = elst.parse()?;
    let nothing = match list.version {
        1 => u64::MAX,
        _ => u64::from(u32::MAX),
    };
    // Times count from the first frame, so that an empty part before it changes nothing.
    let mut parts = list
        .entries
        .iter()
        .filter(|part| part.media_time != nothing);
    let (Some(part), None) = (parts.next(), parts.next()) else {
        return match list.entries.iter().all(|part| part.media_time == nothing) {
            true => Ok(everything),
            false => Err("edit lists that show several parts of a track are not read".into()),
        };
    };
    let start = i64::try_from(part.media_time).map_err(|_| "an edit begins too late")?;
    if part.segment_duration == 0 {
        return Ok(start..i64::MAX);
    }
    let mvhd: MvhdBox = moov.child(b"mvhd")?.parse()?;
    // Rounded up: the duration of the edit may be in a coarser unit than the times.
    let scaled = u128::from(part.segment_duration) * u128::from(timescale);
    let duration = scaled.div_ceil(u128::from(mvhd.timescale.max(1)));
    let duration = i64::try_from(duration).unwrap_or(i64::MAX);
    Ok(start..start.saturating_add(duration))
}

/// How pictures are placed on the screen: the matrix of the box `tkhd`, which takes (x, y), y
/// downwards, to (a x + c y, b x + d y).
pub(super) fn orientation(trak: Node<'_>) -> Result<Orientation, String> {
    let Some(tkhd) = trak.find(b"tkhd")? else {
        return Ok(Orientation::NoTransforms);
    };
    let tkhd = tkhd.contents();
    // Times and the duration have 64 bits from version 1 on.
    let start = if tkhd.first() == Some(&0) { 40 } else { 52 };
    let numbers = tkhd
        .get(start..start + 20)
        .ok_or("the box tkhd ends within its matrix")?;
    let at = |k: usize| {
        let number = numbers[4 * k..]
            .first_chunk()
            .map_or(0, |n| i32::from_be_bytes(*n));
        f64::from(number) / 65536.0
    };
    match [at(0), at(1), at(3), at(4)] {
        [1.0, 0.0, 0.0, 1.0] => Ok(Orientation::NoTransforms),
        [0.0, 1.0, -1.0, 0.0] => Ok(Orientation::Rotate90),
        [-1.0, 0.0, 0.0, -1.0] => Ok(Orientation::Rotate180),
        [0.0, -1.0, 1.0, 0.0] => Ok(Orientation::Rotate270),
        [-1.0, 0.0, 0.0, 1.0] => Ok(Orientation::FlipHorizontal),
        [1.0, 0.0, 0.0, -1.0] => Ok(Orientation::FlipVertical),
        [0.0, 1.0, 1.0, 0.0] => Ok(Orientation::Rotate90FlipH),
        [0.0, -1.0, -1.0, 0.0] => Ok(Orientation::Rotate270FlipH),
        [a, b, c, d] => Err(format!(
            "pictures that the matrix ({a}, {b}; {c}, {d}) places on the screen are not read"
        )),
    }
}

/// Width and height of a pixel: the contents of the box `pasp`.
pub(super) fn pixel_aspect(contents: &[u8]) -> Option<[u32; 2]> {
    let (numbers, _) = contents.as_chunks::<4>();
    let [across, down, ..] = *numbers else {
        return None;
    };
    let aspect = [across, down].map(u32::from_be_bytes);
    Some(aspect).filter(|aspect| !aspect.contains(&0))
}
