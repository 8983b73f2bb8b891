//! Animated PNG.

use std::borrow::Borrow;
use std::io::Write;

use png::{BitDepth, ColorType, Encoder, Filter};

use super::encode::{kind, raw};
use crate::format::Format;
use crate::format_error::FormatError;
use crate::picture::PictureView;
use crate::plane::Plane;
use crate::size::size_for;

/// How an animation is played.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Animation {
    /// Frames in a second, as numerator and denominator.
    pub frames_per_second: [u16; 2],
    /// How often it is played; 0 is without end.
    pub plays: u32,
}

impl Default for Animation {
    /// 25 frames in a second, without end.
    fn default() -> Self {
        Self {
            frames_per_second: [25, 1],
            plays: 0,
        }
    }
}

/// The bytes of an animated PNG file. Programs that know only still pictures show the first frame.
///
/// The frames may be borrowed, or made one after another by an iterator.
///
/// # Errors
///
/// [`FormatError::Frames`] when there are none, [`FormatError::FrameSize`] when a frame differs in
/// size from the first, and as [`encode`](super::encode).
///
/// # Examples
///
/// ```
/// use ga_image::plane::Plane;
/// use ga_image::png::{self, Animation};
///
/// let frames = (0..10).map(|i| Plane::from_fn(20, 10, |c, r| if c + r == i { 255u8 } else { 0 }));
/// let bytes = png::encode_animation(frames, Animation::default())?;
/// assert_eq!(png::decode(&bytes)?.to_rgb::<u8>().get(0, 0), Some([255; 3]));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn encode_animation<P: Copy, F: Borrow<Plane<P>>>(
    frames: impl IntoIterator<Item = F, IntoIter: ExactSizeIterator>,
    animation: Animation,
) -> Result<Vec<u8>, FormatError>
where
    for<'a> PictureView<'a>: From<&'a Plane<P>>,
{
    let mut frames = frames.into_iter();
    let count = frames.len();
    let Some(first) = frames.next() else {
        return Err(frames_error(count));
    };
    let first = PictureView::from(first.borrow());
    let mut bytes = Vec::new();
    let mut writer = AnimationWriter::new(
        &mut bytes,
        [first.width(), first.height()],
        kind(&first)?,
        count,
        animation,
    )?;
    writer.write(&first)?;
    for frame in frames {
        writer.write(&PictureView::from(frame.borrow()))?;
    }
    writer.finish()?;
    Ok(bytes)
}

/// An animated PNG that is written frame by frame.
pub(crate) struct AnimationWriter<W: Write> {
    writer: png::Writer<W>,
    size: [usize; 2],
    /// The number of the next frame.
    frame: usize,
}

impl<W: Write> AnimationWriter<W> {
    /// Writes what stands before the first of `frames` frames of this size and kind.
    pub(crate) fn new(
        writer: W,
        size: [usize; 2],
        (colour, depth): (ColorType, BitDepth),
        frames: usize,
        animation: Animation,
    ) -> Result<Self, FormatError> {
        let declared = u32::try_from(frames).ok().filter(|&frames| frames > 0);
        let declared = declared.ok_or_else(|| frames_error(frames))?;
        let [width, height] = size_for(Format::Png, size)?;
        let mut encoder = Encoder::new(writer, width, height);
        encoder.set_color(colour);
        encoder.set_depth(depth);
        encoder.set_filter(Filter::Adaptive);
        encoder.set_animated(declared, animation.plays)?;
        let [numerator, denominator] = animation.frames_per_second;
        encoder.set_frame_delay(denominator, numerator)?;
        Ok(Self {
            writer: encoder.write_header()?,
            size,
            frame: 0,
        })
    }

    /// Writes a frame, of the kind of pixels that all have.
    pub(crate) fn write(&mut self, picture: &PictureView<'_>) -> Result<(), FormatError> {
        let size = [picture.width(), picture.height()];
        if size != self.size {
            return Err(FormatError::FrameSize {
                frame: self.frame,
                size,
                first: self.size,
            });
        }
        self.writer.write_image_data(&raw(picture))?;
        self.frame += 1;
        Ok(())
    }

    /// Writes what stands after the last frame.
    pub(crate) fn finish(self) -> Result<(), FormatError> {
        Ok(self.writer.finish()?)
    }
}

fn frames_error(frames: usize) -> FormatError {
    FormatError::Frames {
        format: Format::Png,
        frames,
    }
}
