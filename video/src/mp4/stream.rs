//! What the headers of a video in H.264 say (ITU-T H.264, 7.3), and whether pictures are decoded
//! exactly.
//!
//! Parameter sets and headers of slices are read by the crate `h264-reader`. Every tool of a stream
//! must be one for which the decoder was compared with the reconstruction of an encoder; a stream
//! with another one is refused by its name, and never decoded to nearly the right pictures.

use ga_image::grey::Luma;
use ga_image::orientation::Orientation;
use ga_image::ycbcr::{Range, YCbCr};
use h264_reader::Context;
use h264_reader::avcc::AvcDecoderConfigurationRecord;
use h264_reader::nal::pps::PicParameterSet;
use h264_reader::nal::slice::{SliceFamily, SliceHeader};
use h264_reader::nal::sps::{ChromaFormat, FrameMbsFlags, SeqParameterSet};
use h264_reader::nal::{Nal, NalHeader, RefNal, UnitType};

/// What all pictures of a video share, and the parameter sets by which slices are read.
pub(super) struct Stream {
    /// Columns and rows, after cropping, as they are stored.
    pub(super) size: [usize; 2],
    pub(super) colours: YCbCr,
    /// Width and height of a pixel, where the stream says them.
    pub(super) pixel_aspect: Option<[u32; 2]>,
    pub(super) orientation: Orientation,
    /// Bytes of the lengths before units.
    pub(super) length_bytes: usize,
    /// The units with parameter sets that the file keeps outside of samples.
    pub(super) sets: Vec<Vec<u8>>,
    context: Context,
}

/// What the slices of one picture have had so far.
#[derive(Default)]
pub(super) struct PictureSlices {
    next_block: u32,
}

impl Stream {
    /// Reads the contents of the box `avcC`. The error says what is wrong, or what is not decoded.
    pub(super) fn read(avcc: &[u8], orientation: Orientation) -> Result<Self, String> {
        let wrong = |problem: &dyn std::fmt::Debug| format!("the box avcC: {problem:?}");
        let record = AvcDecoderConfigurationRecord::try_from(avcc).map_err(|e| wrong(&e))?;
        let sequences = record.sequence_parameter_sets();
        let sets: Result<Vec<&[u8]>, _> =
            sequences.chain(record.picture_parameter_sets()).collect();
        let sets = sets.map_err(|error| wrong(&error))?;
        let mut stream = Self {
            size: [0, 0],
            colours: YCbCr::default(),
            pixel_aspect: None,
            orientation,
            length_bytes: usize::from(record.length_size_minus_one()) + 1,
            sets: sets.iter().map(|set| set.to_vec()).collect(),
            context: Context::new(),
        };
        for set in sets {
            stream.check(set, &mut PictureSlices::default())?;
        }
        let first = stream.context.sps().next();
        let first = first.ok_or("the sequence parameter set is missing")?;
        let [width, height] = size(first)?;
        let usability = first.vui_parameters.as_ref();
        let signal = usability.and_then(|it| it.video_signal_type.as_ref());
        let aspect = usability.and_then(|it| it.aspect_ratio_info.as_ref()?.get());
        let matrix = signal.and_then(|it| it.colour_description.as_ref());
        stream.colours = YCbCr {
            luma: luma(matrix.map_or(UNSPECIFIED, |it| it.matrix_coefficients))?,
            range: match signal.is_some_and(|it| it.video_full_range_flag) {
                true => Range::Full,
                false => Range::Limited,
            },
        };
        stream.pixel_aspect = aspect.map(|(across, down)| [across, down].map(u32::from));
        stream.size = [width, height];
        Ok(stream)
    }

    /// Reads the header of a unit, of which `unit` may be the beginning. The error says what of it
    /// is wrong or not decoded exactly.
    pub(super) fn check(&mut self, unit: &[u8], picture: &mut PictureSlices) -> Result<(), String> {
        let Some(&first) = unit.first() else {
            return Ok(());
        };
        let header = NalHeader::new(first).map_err(|error| format!("{error:?}"))?;
        let bits = RefNal::new(unit, &[], true).rbsp_bits();
        match header.nal_unit_type() {
            UnitType::SeqParameterSet => {
                let set = SeqParameterSet::from_bits(bits);
                let set = set.map_err(|error| format!("the sequence parameter set: {error:?}"))?;
                check_sequence(&set)?;
                if self.size != [0, 0] && size(&set)? != self.size {
                    return Err("pictures of two sizes in one video are not decoded".into());
                }
                self.context.put_seq_param_set(set);
            }
            UnitType::PicParameterSet => {
                let set = PicParameterSet::from_bits(&self.context, bits);
                let set = set.map_err(|error| format!("the picture parameter set: {error:?}"))?;
                check_picture(&set)?;
                self.context.put_pic_param_set(set);
            }
            UnitType::SliceLayerWithoutPartitioningIdr
            | UnitType::SliceLayerWithoutPartitioningNonIdr => {
                let mut bits = bits;
                let slice = SliceHeader::from_bits(&self.context, &mut bits, header, None);
                let (slice, sequence, _) =
                    slice.map_err(|error| format!("the header of a slice: {error:?}"))?;
                check_slice(&slice, sequence, picture)?;
            }
            UnitType::SliceDataPartitionALayer
            | UnitType::SliceDataPartitionBLayer
            | UnitType::SliceDataPartitionCLayer => {
                return Err("slices in partitions are not decoded".into());
            }
            _ => {}
        }
        Ok(())
    }
}

/// The number of matrix coefficients that are not specified.
const UNSPECIFIED: u8 = 2;

/// The weights of luma for a number of ITU-T H.273, table 4.
fn luma(matrix_coefficients: u8) -> Result<Luma, String> {
    match matrix_coefficients {
        1 => Ok(Luma::Bt709),
        // Those of the systems M, B and G are those of BT.601.
        UNSPECIFIED | 5 | 6 => Ok(Luma::Bt601),
        9 => Ok(Luma::Bt2020),
        other => Err(format!(
            "colours of the matrix {other} of ITU-T H.273 are not decoded"
        )),
    }
}

fn size(set: &SeqParameterSet) -> Result<[usize; 2], String> {
    let (width, height) = set
        .pixel_dimensions()
        .map_err(|error| format!("the sequence parameter set: {error:?}"))?;
    Ok([width as usize, height as usize])
}

fn check_sequence(set: &SeqParameterSet) -> Result<(), String> {
    let chroma = &set.chroma_info;
    if chroma.chroma_format != ChromaFormat::YUV420 {
        return Err("only 4:2:0 is decoded of H.264".into());
    }
    let depths = [chroma.bit_depth_luma_minus8, chroma.bit_depth_chroma_minus8];
    if let Some(depth) = depths.into_iter().find(|depth| *depth > 0) {
        let bits = 8 + u32::from(depth);
        return Err(format!("{bits} bits are not decoded of H.264, only 8"));
    }
    if chroma.qpprime_y_zero_transform_bypass_flag {
        return Err("H.264 without loss is not decoded".into());
    }
    if matches!(set.frame_mbs_flags, FrameMbsFlags::Fields { .. }) {
        return Err("H.264 whose pictures may be interlaced is not decoded".into());
    }
    if set.gaps_in_frame_num_value_allowed_flag {
        return Err("H.264 that may leave out pictures is not decoded".into());
    }
    let cropping = set.frame_cropping.as_ref();
    if cropping.is_some_and(|it| it.left_offset > 0 || it.top_offset > 0) {
        return Err("H.264 that is cropped at the left or at the top is not decoded".into());
    }
    Ok(())
}

fn check_picture(set: &PicParameterSet) -> Result<(), String> {
    if set.slice_groups.is_some() {
        return Err("H.264 with groups of slices is not decoded".into());
    }
    if set.redundant_pic_cnt_present_flag {
        return Err("H.264 with redundant pictures is not decoded".into());
    }
    if set.weighted_bipred_idc == 1 {
        return Err("H.264 with explicit weights of two references is not decoded".into());
    }
    Ok(())
}

fn check_slice(
    slice: &SliceHeader,
    sequence: &SeqParameterSet,
    picture: &mut PictureSlices,
) -> Result<(), String> {
    match slice.slice_type.family {
        SliceFamily::SP | SliceFamily::SI => {
            return Err("slices for switching streams are not decoded".into());
        }
        SliceFamily::B if !sequence.direct_8x8_inference_flag => {
            return Err("direct prediction of blocks of 4 × 4 is not decoded".into());
        }
        _ => {}
    }
    if slice.disable_deblocking_filter_idc == 1 {
        return Err("H.264 without its deblocking filter is not decoded exactly".into());
    }
    if slice.first_mb_in_slice < picture.next_block {
        return Err("slices that are not in the order of their places are not decoded".into());
    }
    picture.next_block = slice.first_mb_in_slice + 1;
    Ok(())
}
