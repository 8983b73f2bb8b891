//! Videos of two views.

use ga_image::plane::{Plane, PlaneError};

use super::{Frame, Planes, Properties, Samples, Source};
use crate::VideoError;

/// Where the two views lie in a frame.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Layout {
    /// The left view in the left half, the right one in the right half.
    SideBySide,
    /// The left view in the upper half, the right one in the lower half.
    TopBottom,
    /// As [`SideBySide`](Self::SideBySide), each view squeezed to half of its width.
    HalfSideBySide,
    /// As [`TopBottom`](Self::TopBottom), each view squeezed to half of its height.
    HalfTopBottom,
}

impl Layout {
    /// Along which axis the second view follows the first: 0 along columns, 1 along rows.
    #[must_use]
    pub fn axis(self) -> usize {
        match self {
            Self::SideBySide | Self::HalfSideBySide => 0,
            Self::TopBottom | Self::HalfTopBottom => 1,
        }
    }

    /// Width and height of a pixel of a view, where these are stated for the whole frame. Pixels of
    /// squeezed views are twice as wide, or half as wide. A stated shape that is 1.5 times as long
    /// in this direction or more says the same as the layout.
    fn view_aspect(self, [across, down]: [u32; 2]) -> [u32; 2] {
        let [wide, high] = [[across, down], [down, across]].map(|[long, short]| {
            let is_said = f64::from(long) >= 1.5 * f64::from(short);
            if is_said {
                [long, short]
            } else {
                doubled([long, short])
            }
        });
        match self {
            Self::SideBySide | Self::TopBottom => [across, down],
            Self::HalfSideBySide => wide,
            Self::HalfTopBottom => [high[1], high[0]],
        }
    }

    /// The layout that is squeezed where this one is not, or not where this one is, if the views
    /// have a usual shape in that one, 1.2 to 2.6 times as wide as high, but not in this one.
    ///
    /// ```
    /// use ga_image::plane::Plane;
    /// use ga_image::y4m::{self, Film};
    /// use ga_video::stereo::{Layout, StereoSource};
    /// use ga_video::y4m::Y4mSource;
    ///
    /// let frame = Plane::filled(192, 108, [90u8; 3]);
    /// let bytes = y4m::encode([&frame], Film::default())?;
    /// let likelier = |layout: Layout| {
    ///     let video = Y4mSource::new(std::io::Cursor::new(bytes.clone()), "film.y4m")?;
    ///     let views = StereoSource::halves(Box::new(video), layout)?;
    ///     Ok::<_, Box<dyn std::error::Error>>(layout.likelier(views.properties()))
    /// };
    /// assert_eq!(likelier(Layout::SideBySide)?, Some(Layout::HalfSideBySide));
    /// assert_eq!(likelier(Layout::HalfSideBySide)?, None);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    #[must_use]
    pub fn likelier(self, view: &Properties) -> Option<Self> {
        const USUAL: std::ops::Range<f64> = 1.2..2.6;
        let (other, factor) = match self {
            Self::SideBySide => (Self::HalfSideBySide, 2.0),
            Self::HalfSideBySide => (Self::SideBySide, 0.5),
            Self::TopBottom => (Self::HalfTopBottom, 0.5),
            Self::HalfTopBottom => (Self::TopBottom, 2.0),
        };
        let shape = shape(view);
        (!USUAL.contains(&shape) && USUAL.contains(&(factor * shape))).then_some(other)
    }
}

/// A ratio of twice the amount.
fn doubled([numerator, denominator]: [u32; 2]) -> [u32; 2] {
    match denominator.is_multiple_of(2) {
        true => [numerator, denominator / 2],
        false => [numerator.saturating_mul(2), denominator],
    }
}

/// How many times a view is as wide as high, as it is shown.
#[must_use]
pub fn shape(view: &Properties) -> f64 {
    let [width, height] = view.size.map(|side| side as f64);
    width / (height * pixel_height(view.pixel_aspect))
}

/// How many times a pixel of this width and height is as high as wide.
pub(crate) fn pixel_height([across, down]: [u32; 2]) -> f64 {
    f64::from(down) / f64::from(across)
}

/// A video of two views, left and right: halves of the frames of one video, or two videos.
///
/// ```
/// use ga_image::plane::Plane;
/// use ga_image::y4m::{self, Film};
/// use ga_video::stereo::{Layout, StereoSource};
/// use ga_video::y4m::Y4mSource;
///
/// let wide = Plane::from_fn(8, 4, |column, _| [if column < 4 { 0u8 } else { 255 }; 3]);
/// let bytes = y4m::encode([&wide], Film::default())?;
/// let video = Y4mSource::new(std::io::Cursor::new(bytes), "wide.y4m")?;
///
/// let mut views = StereoSource::halves(Box::new(video), Layout::SideBySide)?;
/// assert_eq!(views.properties().size, [4, 4]);
/// let mut frames = Default::default();
/// assert!(views.read(&mut frames)?);
/// let levels = frames.map(|frame| frame.samples.eight_bits().luma.get(1, 1));
/// assert_eq!(levels, [Some(16), Some(235)]);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub struct StereoSource {
    views: Views,
    properties: Properties,
    /// Width and height of a pixel, as they are stated for whole frames.
    frame_aspect: [u32; 2],
    /// The number of the next frame.
    next: usize,
    has_ended: bool,
}

enum Views {
    Halves(Box<dyn Source + Send>, Layout, Box<Frame>),
    Pair([Box<dyn Source + Send>; 2]),
}

/// The greatest difference of the times of two frames that belong together. Containers count time
/// in milliseconds or finer.
const SIMULTANEOUS_SECONDS: f64 = 1.5e-3;

impl StereoSource {
    /// The views in the two halves of each frame. Where a view has an odd number of columns, its
    /// first colour difference in 4:2:0 and 4:2:2 is that of a pair which both views share; rows
    /// likewise.
    ///
    /// # Errors
    ///
    /// [`VideoError::Layout`] when the number of columns, or of rows, is odd.
    pub fn halves(source: Box<dyn Source + Send>, layout: Layout) -> Result<Self, VideoError> {
        let mut properties = *source.properties();
        let frame_aspect = properties.pixel_aspect;
        properties.pixel_aspect = layout.view_aspect(properties.pixel_aspect);
        let side = &mut properties.size[layout.axis()];
        let name = ["side by side", "one above the other"][layout.axis()];
        if !side.is_multiple_of(2) {
            return Err(VideoError::Layout {
                layout: name,
                size: source.properties().size,
            });
        }
        *side /= 2;
        let views = Views::Halves(source, layout, Box::default());
        Ok(Self::new(views, properties, frame_aspect))
    }

    /// The views in two videos.
    ///
    /// # Errors
    ///
    /// [`VideoError::Views`] when they differ in size, shape of pixels, depth, sampling, colours or
    /// rate.
    pub fn pair(
        left: Box<dyn Source + Send>,
        right: Box<dyn Source + Send>,
    ) -> Result<Self, VideoError> {
        let [a, b] = [*left.properties(), *right.properties()];
        let size = |p: Properties| format!("{} × {} pixels", p.size[0], p.size[1]);
        let rate = |p: Properties| match p.frames_per_second {
            Some([numerator, denominator]) => format!("{numerator}/{denominator} per second"),
            None => "not constant".into(),
        };
        let storage = |p: Properties| format!("{} bits, {:?}", p.bit_depth, p.sampling);
        let colours = |p: Properties| format!("{:?}", p.colours);
        let same_rate = match (a.frames_per_second, b.frames_per_second) {
            (Some([n, d]), Some([m, e])) => {
                u64::from(n) * u64::from(e) == u64::from(m) * u64::from(d)
            }
            // Whether the times agree is seen frame by frame.
            _ => true,
        };
        let same_storage = a.bit_depth == b.bit_depth && a.sampling == b.sampling;
        let aspect = |p: Properties| format!("{}:{}", p.pixel_aspect[0], p.pixel_aspect[1]);
        let same_aspect = pixel_height(a.pixel_aspect) == pixel_height(b.pixel_aspect);
        let checks = [
            ("size", a.size == b.size, size(a), size(b)),
            ("shape of pixels", same_aspect, aspect(a), aspect(b)),
            ("rate of frames", same_rate, rate(a), rate(b)),
            ("samples", same_storage, storage(a), storage(b)),
            ("colours", a.colours == b.colours, colours(a), colours(b)),
        ];
        for (what, is_same, left, right) in checks {
            if !is_same {
                return Err(VideoError::Views { what, left, right });
            }
        }
        Ok(Self::new(Views::Pair([left, right]), a, a.pixel_aspect))
    }

    /// What all frames of each view share.
    #[must_use]
    pub fn properties(&self) -> &Properties {
        &self.properties
    }

    /// Width and height of a pixel, as they are stated for frames that have both views in the same
    /// layout, or for each video: those of a view where it is not squeezed.
    #[must_use]
    pub fn frame_aspect(&self) -> [u32; 2] {
        self.frame_aspect
    }

    /// Reads the next frame of the left and of the right view. Returns whether there was one; after
    /// an error there are no more.
    ///
    /// # Errors
    ///
    /// Those of the sources; for two videos [`VideoError::Length`] when one ends before the other,
    /// and [`VideoError::Time`] when two frames are not shown at the same time.
    pub fn read(&mut self, frames: &mut [Frame; 2]) -> Result<bool, VideoError> {
        if self.has_ended {
            return Ok(false);
        }
        self.has_ended = true;
        let has_frame = match &mut self.views {
            Views::Halves(source, layout, whole) => {
                let has_frame = source.read(whole)?;
                if has_frame {
                    split(whole, *layout, self.properties.size, frames);
                }
                has_frame
            }
            Views::Pair(sources) => read_pair(sources, frames, self.next)?,
        };
        self.next += 1;
        self.has_ended = !has_frame;
        Ok(has_frame)
    }

    fn new(views: Views, properties: Properties, frame_aspect: [u32; 2]) -> Self {
        Self {
            views,
            properties,
            frame_aspect,
            next: 0,
            has_ended: false,
        }
    }
}

fn read_pair(
    [left, right]: &mut [Box<dyn Source + Send>; 2],
    [left_frame, right_frame]: &mut [Frame; 2],
    frame: usize,
) -> Result<bool, VideoError> {
    match (left.read(left_frame)?, right.read(right_frame)?) {
        (true, true) => {}
        (false, false) => return Ok(false),
        (false, true) => {
            return Err(VideoError::Length {
                frame,
                side: "left",
            });
        }
        (true, false) => {
            return Err(VideoError::Length {
                frame,
                side: "right",
            });
        }
    }
    let times = [left_frame.time_seconds, right_frame.time_seconds];
    if (times[0] - times[1]).abs() > SIMULTANEOUS_SECONDS {
        return Err(VideoError::Time {
            frame,
            left_seconds: times[0],
            right_seconds: times[1],
        });
    }
    Ok(true)
}

/// Copies the halves of a frame, which are of `size`.
fn split(whole: &Frame, layout: Layout, size: [usize; 2], halves: &mut [Frame; 2]) {
    for (side, half) in halves.iter_mut().enumerate() {
        half.index = whole.index;
        half.time_seconds = whole.time_seconds;
        let mut start = [0; 2];
        start[layout.axis()] = side * size[layout.axis()];
        half.samples = match &whole.samples {
            Samples::Eight(planes) => {
                Samples::Eight(part(planes, start, size, half.samples.take_eight()))
            }
            Samples::Ten(planes) => {
                Samples::Ten(part(planes, start, size, half.samples.take_ten()))
            }
        };
    }
}

/// Both views in one frame: the inverse of [`StereoSource::halves`]. Where both views store a
/// colour difference for one pair of pixels, as at an odd number of columns in 4:2:0, it is that of
/// the left view.
///
/// ```
/// use ga_image::plane::Plane;
/// use ga_video::stereo::{Layout, joined};
/// use ga_video::{Planes, Samples};
///
/// let view = |code: u8| {
///     let luma = Plane::filled(3, 2, code);
///     Samples::Eight(Planes { luma, ..Planes::default() })
/// };
/// let whole = joined([&view(40), &view(90)], Layout::SideBySide)?;
/// assert_eq!(whole.size(), [6, 2]);
/// assert_eq!(whole.eight_bits().luma.row(1), [40, 40, 40, 90, 90, 90]);
/// # Ok::<(), ga_image::plane::PlaneError>(())
/// ```
///
/// # Errors
///
/// [`PlaneError::Differs`] where the views differ in size; also where they differ in depth, with
/// equal sizes.
pub fn joined(views: [&Samples; 2], layout: Layout) -> Result<Samples, PlaneError> {
    let [first, second] = views.map(Samples::size);
    match views {
        _ if first != second => Err(PlaneError::Differs { first, second }),
        [Samples::Eight(left), Samples::Eight(right)] => {
            Ok(Samples::Eight(joined_planes([left, right], layout)))
        }
        [Samples::Ten(left), Samples::Ten(right)] => {
            Ok(Samples::Ten(joined_planes([left, right], layout)))
        }
        _ => Err(PlaneError::Differs { first, second }),
    }
}

fn joined_planes<T: Copy + Default>(views: [&Planes<T>; 2], layout: Layout) -> Planes<T> {
    let axis = layout.axis();
    let side = |plane: &Plane<T>| [plane.width(), plane.height()][axis];
    let lumas = views.map(|view| &view.luma);
    let whole = 2 * side(lumas[0]);
    let differences = [0, 1].map(|channel| {
        let planes = views.map(|view| &view.differences[channel]);
        if planes.iter().any(|plane| plane.is_empty()) {
            return Plane::default();
        }
        // 1 or 2 pixels for each stored number.
        let pixels = side(lumas[0]).div_ceil(side(planes[0]));
        joined_plane(planes, axis, whole.div_ceil(pixels))
    });
    Planes {
        luma: joined_plane(lumas, axis, whole),
        differences,
    }
}

/// Two planes beside each other or one above the other, with this number of columns or rows in all;
/// the second one ends with the last of them.
fn joined_plane<T: Copy + Default>(
    [first, second]: [&Plane<T>; 2],
    axis: usize,
    whole: usize,
) -> Plane<T> {
    let side = [second.width(), second.height()][axis];
    let mut size = [first.width(), first.height()];
    size[axis] = whole;
    Plane::from_fn(size[0], size[1], |column, row| {
        let later = || {
            let mut place = [column, row];
            place[axis] = (place[axis] + side).checked_sub(whole)?;
            second.get(place[0], place[1])
        };
        first.get(column, row).or_else(later).unwrap_or_default()
    })
}

/// A rectangle of the planes, in the memory of `target`.
fn part<T: Copy + Default>(
    planes: &Planes<T>,
    start: [usize; 2],
    size: [usize; 2],
    mut target: Planes<T>,
) -> Planes<T> {
    let luma = &planes.luma;
    copy(luma, start, size, &mut target.luma);
    let stored = planes.differences.iter().zip(&mut target.differences);
    for (difference, target) in stored {
        // 1 or 2 pixels for each stored number; no pixels in a grey video.
        let pixels = [
            luma.width().div_ceil(difference.width().max(1)),
            luma.height().div_ceil(difference.height().max(1)),
        ];
        let (start, size) = match difference.is_empty() {
            true => ([0, 0], [0, 0]),
            false => (
                [start[0] / pixels[0], start[1] / pixels[1]],
                [size[0].div_ceil(pixels[0]), size[1].div_ceil(pixels[1])],
            ),
        };
        copy(difference, start, size, target);
    }
    target
}

fn copy<T: Copy + Default>(
    plane: &Plane<T>,
    [left, top]: [usize; 2],
    [width, height]: [usize; 2],
    target: &mut Plane<T>,
) {
    let mut values = std::mem::take(target).into_values();
    values.clear();
    for row in plane.rows().skip(top).take(height) {
        values.extend_from_slice(&row[left..left + width]);
    }
    // There are that many rows.
    *target = Plane::from_values(width, height, values).unwrap_or_default();
}
