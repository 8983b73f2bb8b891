//! Films that are written as H.264 in MP4.

use std::io::{self, Seek, SeekFrom, Write};
use std::num::NonZeroU32;

use ga_image::film::Rate;
use ga_image::grey::Luma;
use ga_image::plane::Plane;
use ga_image::y4m::{Sampling, Siting, planes};
use ga_image::ycbcr::{Range, YCbCr};
use openh264::OpenH264API;
use openh264::encoder::{
    Complexity, EncodedBitStream, Encoder, EncoderConfig, FrameRate, IntraFramePeriod, QpRange,
    RateControlMode, VuiConfig,
};
use openh264::formats::YUVSlices;
use shiguredo_mp4::boxes::{Avc1Box, AvccBox, SampleEntry, VisualSampleEntryFields};
use shiguredo_mp4::mux::{
    Mp4FileMuxer, Mp4FileMuxerOptions, Sample, estimate_maximum_moov_box_size,
};
use shiguredo_mp4::{TrackKind, Uint};

use crate::VideoError;

/// The quantiser of all blocks, from 0 to 51: fine enough that edges of drawings stay clean.
const QUANTISER: u8 = 20;

/// Seconds from one key frame, which is stored without reference to others, to the next.
const KEY_FRAME_EVERY: f64 = 2.0;

/// The most frames for whose index room is kept at the beginning: nine hours at 30 a second.
const MOST_RESERVED: usize = 1_000_000;

/// The least units of time in a second: players are made for about so many.
const TIMESCALE: u32 = 10_000;

/// What pictures are encoded as, which the stream states.
const COLOURS: YCbCr = YCbCr {
    luma: Luma::Bt709,
    range: Range::Limited,
};

/// A film in MP4 that is written picture by picture: H.264 with 8 bits, 4:2:0, BT.709, limited
/// range, the colour differences at the first of two columns.
///
/// The quantiser is constant, so that the quality is. The index comes first, where room is kept for
/// it; in memory are the frame that is written and some bytes of the index for each one before.
/// Equal pictures give equal bytes.
///
/// The film has an even number of columns and of rows: the last one of the pictures is repeated
/// where theirs is odd.
///
/// ```
/// use std::io::Cursor;
///
/// use ga_image::film::Rate;
/// use ga_image::plane::Plane;
/// use ga_video::mp4::{Mp4Source, Writer};
/// use ga_video::{Frame, Source};
///
/// let mut bytes = Cursor::new(Vec::new());
/// let rate = Rate::new(30.0).ok_or("no rate")?;
/// let mut film = Writer::new(&mut bytes, [32, 18], 3, rate)?;
/// for frame in 0..3u8 {
///     film.write(&Plane::filled(32, 18, [80 * frame; 3]))?;
/// }
/// film.finish()?;
///
/// let mut source = Mp4Source::new(bytes, "film.mp4")?;
/// assert_eq!(source.properties().frame_count, Some(3));
/// assert_eq!(source.properties().frames_per_second, Some([30, 1]));
/// let mut frame = Frame::default();
/// assert!(source.read(&mut frame)?);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub struct Writer<W> {
    writer: W,
    encoder: Encoder,
    muxer: Mp4FileMuxer,
    size: [usize; 2],
    /// Units of time in a second.
    timescale: NonZeroU32,
    /// Units of time of a frame.
    duration: u32,
    /// Bytes before the next sample.
    position: u64,
    /// The sequence and the picture parameter set of the first frame.
    sets: Option<[Vec<u8>; 2]>,
    /// The number of the next frame.
    frame: usize,
}

impl<W: Write + Seek> Writer<W> {
    /// Writes what stands before the first picture into an empty file. With more pictures than
    /// `frames`, or than a million, the index comes last.
    ///
    /// # Errors
    ///
    /// [`VideoError::EncodedSize`] where H.264 is not written in this size,
    /// [`VideoError::Encoding`] where the encoder does not start, and [`VideoError::Write`].
    pub fn new(
        mut writer: W,
        size: [usize; 2],
        frames: usize,
        rate: Rate,
    ) -> Result<Self, VideoError> {
        let [short, long] = {
            let [width, height] = even(size);
            [width.min(height), width.max(height)]
        };
        if !(16..=2160).contains(&short) || long > 3840 {
            return Err(VideoError::EncodedSize { size });
        }
        let [numerator, denominator] = rate.quotient().map(u32::from);
        let per_second = f64::from(numerator) / f64::from(denominator);
        let configuration = EncoderConfig::new()
            .qp(QpRange::new(QUANTISER, QUANTISER))
            .complexity(Complexity::High)
            .intra_frame_period(IntraFramePeriod::from_num_frames(
                (KEY_FRAME_EVERY * per_second).ceil() as u32,
            ))
            // Those that the encoder knows; the times are in the file.
            .max_frame_rate(FrameRate::from_hz(per_second.clamp(1.0, 60.0) as f32))
            .vui(VuiConfig::bt709())
            // Otherwise the quantiser would change where a scene does, and pictures be left out.
            .rate_control_mode(RateControlMode::Bufferbased)
            .scene_change_detect(false)
            .background_detection(false)
            .adaptive_quantization(false)
            .skip_frames(false)
            .num_threads(1);
        let encoder = Encoder::with_api_config(OpenH264API::from_source(), configuration)
            .map_err(|error| encoding(0, error))?;
        let options = Mp4FileMuxerOptions {
            reserved_moov_box_size: estimate_maximum_moov_box_size(&[frames.min(MOST_RESERVED)]),
            ..Mp4FileMuxerOptions::default()
        };
        let muxer = Mp4FileMuxer::with_options(options).map_err(|error| encoding(0, error))?;
        let start = muxer.initial_boxes_bytes();
        let written = writer.write_all(start);
        written.map_err(|source| VideoError::Write { frame: 0, source })?;
        let times = TIMESCALE.div_ceil(numerator);
        Ok(Self {
            position: start.len() as u64,
            writer,
            encoder,
            muxer,
            size,
            timescale: NonZeroU32::MIN.saturating_add(times * numerator - 1),
            duration: times * denominator,
            sets: None,
            frame: 0,
        })
    }

    /// Writes the next picture.
    ///
    /// # Errors
    ///
    /// [`VideoError::KeyFrameSize`] for a picture of another size, [`VideoError::Encoding`] and
    /// [`VideoError::Write`].
    pub fn write(&mut self, picture: &Plane<[u8; 3]>) -> Result<(), VideoError> {
        let frame = self.frame;
        let size = [picture.width(), picture.height()];
        if size != self.size {
            let first = self.size;
            return Err(VideoError::KeyFrameSize { frame, size, first });
        }
        let [width, height] = even(size);
        let [luma, cb, cr] = if [width, height] == size {
            planes(picture, Sampling::Quarter, Siting::Left, COLOURS)
        } else {
            let padded = Plane::from_fn(width, height, |column, row| {
                picture.row(row.min(size[1] - 1))[column.min(size[0] - 1)]
            });
            planes(&padded, Sampling::Quarter, Siting::Left, COLOURS)
        };
        let source = YUVSlices::new(
            (luma.values(), cb.values(), cr.values()),
            (width, height),
            (width, width / 2, width / 2),
        );
        let encoded = self.encoder.encode(&source);
        let unit = AccessUnit::new(&encoded.map_err(|error| encoding(frame, error))?);
        if unit.bytes.is_empty() {
            return Err(encoding(frame, "the encoder left it out"));
        }
        let entry = self.entry(&unit, [width, height])?;
        let sample = Sample {
            track_kind: TrackKind::Video,
            sample_entry: entry,
            keyframe: unit.is_key_frame,
            timescale: self.timescale,
            duration: self.duration,
            composition_time_offset: None,
            data_offset: self.position,
            data_size: unit.bytes.len(),
        };
        let written = self.writer.write_all(&unit.bytes);
        written.map_err(|source| VideoError::Write { frame, source })?;
        let added = self.muxer.append_sample(&sample);
        added.map_err(|error| encoding(frame, error))?;
        self.position += unit.bytes.len() as u64;
        self.frame += 1;
        Ok(())
    }

    /// Writes the index, without which the film cannot be played.
    ///
    /// # Errors
    ///
    /// [`VideoError::Encoding`] without pictures, and [`VideoError::WriteIndex`].
    pub fn finish(mut self) -> Result<(), VideoError> {
        if self.frame == 0 {
            return Err(encoding(0, "a film has at least one picture"));
        }
        let failed = |source| VideoError::WriteIndex { source };
        let index = self.muxer.finalize();
        let index = index.map_err(|error| failed(io::Error::other(error.to_string())))?;
        for (place, bytes) in index.offset_and_bytes_pairs() {
            self.writer.seek(SeekFrom::Start(place)).map_err(failed)?;
            self.writer.write_all(bytes).map_err(failed)?;
        }
        self.writer.flush().map_err(failed)
    }

    /// The description of the film, which is said with its first frame. All key frames must have
    /// its parameter sets.
    fn entry(
        &mut self,
        unit: &AccessUnit,
        [width, height]: [usize; 2],
    ) -> Result<Option<SampleEntry>, VideoError> {
        let sets = match (&unit.sets, &self.sets) {
            ([Some(sequence), Some(picture)], None) => [sequence.clone(), picture.clone()],
            ([sequence, picture], Some(known)) => {
                let is_new = |(set, known): (&Option<Vec<u8>>, &Vec<u8>)| {
                    set.as_ref().is_some_and(|set| set != known)
                };
                if [sequence, picture].into_iter().zip(known).any(is_new) {
                    return Err(encoding(self.frame, "its parameter sets are others"));
                }
                return Ok(None);
            }
            _ => return Err(encoding(self.frame, "it has no parameter sets")),
        };
        let [Some(profile), Some(compatibility), Some(level)] =
            [1, 2, 3].map(|byte| sets[0].get(byte).copied())
        else {
            return Err(encoding(self.frame, "its parameter set is too short"));
        };
        let entry = Avc1Box {
            visual: VisualSampleEntryFields {
                data_reference_index: VisualSampleEntryFields::DEFAULT_DATA_REFERENCE_INDEX,
                width: width as u16,
                height: height as u16,
                horizresolution: VisualSampleEntryFields::DEFAULT_HORIZRESOLUTION,
                vertresolution: VisualSampleEntryFields::DEFAULT_VERTRESOLUTION,
                frame_count: VisualSampleEntryFields::DEFAULT_FRAME_COUNT,
                compressorname: VisualSampleEntryFields::NULL_COMPRESSORNAME,
                depth: VisualSampleEntryFields::DEFAULT_DEPTH,
            },
            avcc_box: AvccBox {
                avc_profile_indication: profile,
                profile_compatibility: compatibility,
                avc_level_indication: level,
                // Lengths of 4 bytes.
                length_size_minus_one: Uint::new(3),
                sps_list: vec![sets[0].clone()],
                pps_list: vec![sets[1].clone()],
                // 4:2:0 with 8 bits.
                chroma_format: Some(Uint::new(1)),
                bit_depth_luma_minus8: Some(Uint::new(0)),
                bit_depth_chroma_minus8: Some(Uint::new(0)),
                sps_ext_list: Vec::new(),
            },
            unknown_boxes: Vec::new(),
        };
        self.sets = Some(sets);
        Ok(Some(SampleEntry::Avc1(entry)))
    }
}

/// A frame as it is encoded.
struct AccessUnit {
    /// The units of H.264 but for the parameter sets, each after its length.
    bytes: Vec<u8>,
    /// The sequence and the picture parameter set.
    sets: [Option<Vec<u8>>; 2],
    /// Whether it is decoded without another frame.
    is_key_frame: bool,
}

impl AccessUnit {
    fn new(encoded: &EncodedBitStream<'_>) -> Self {
        let mut found = Self {
            bytes: Vec::new(),
            sets: [None, None],
            is_key_frame: false,
        };
        let layers = (0..encoded.num_layers()).filter_map(|layer| encoded.layer(layer));
        for layer in layers {
            let units = (0..layer.nal_count()).filter_map(|unit| layer.nal_unit(unit));
            // A unit begins after zeros and a one.
            let contents = units.filter_map(|unit| {
                let start = unit.iter().position(|&byte| byte == 1)? + 1;
                unit.get(start..)
            });
            for unit in contents {
                match unit.first().map(|header| header & 31) {
                    Some(7) => found.sets[0] = Some(unit.to_vec()),
                    Some(8) => found.sets[1] = Some(unit.to_vec()),
                    kind => {
                        found.is_key_frame |= kind == Some(5);
                        found.bytes.extend((unit.len() as u32).to_be_bytes());
                        found.bytes.extend(unit);
                    }
                }
            }
        }
        found
    }
}

/// Columns and rows of a film of pictures of this size.
fn even(size: [usize; 2]) -> [usize; 2] {
    size.map(|side| side.next_multiple_of(2))
}

fn encoding(frame: usize, problem: impl ToString) -> VideoError {
    VideoError::Encoding {
        frame,
        problem: problem.to_string(),
    }
}
