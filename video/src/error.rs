//! Why a video cannot be read or written.

use std::io;
use std::path::PathBuf;

use ga_files::ReadError;
use ga_image::file::FormatError;
use ga_image::plane::PlaneError;

/// Why a video cannot be read, written, analysed or compared with another, or not further. Frames
/// are counted from 0. What was read before an error remains valid. The file of the standard input
/// is called so.
#[derive(Debug, thiserror::Error)]
pub enum VideoError {
    /// The operating system could not open the file, or not read its beginning.
    #[error("cannot read {}: {source}", file.display())]
    Open {
        /// The file.
        file: PathBuf,
        /// What the operating system said.
        source: io::Error,
    },
    /// The operating system could not read a frame.
    #[error("{}: frame {frame} cannot be read: {source}", file.display())]
    Read {
        /// The file.
        file: PathBuf,
        /// The frame.
        frame: usize,
        /// What the operating system said.
        source: io::Error,
    },
    /// The file is of no format that this program reads.
    #[error(
        "{}: not a video of a known format (Y4M, MP4, other films by ffmpeg, numbered pictures): it begins with \
         {start:02x?}",
        file.display()
    )]
    UnknownFormat {
        /// The file.
        file: PathBuf,
        /// The first bytes.
        start: Vec<u8>,
    },
    /// The video is not decoded here, and the program ffmpeg, which does it, is not installed.
    #[error(
        "{file}: {problem}; where ffmpeg 5.1 or later is installed, it decodes the video, or let it \
         write one that is read: ffmpeg -i {file} -fps_mode passthrough -strict -1 {y4m}",
        file = file.display(), y4m = file.with_extension("y4m").display()
    )]
    NeedsFfmpeg {
        /// The file.
        file: PathBuf,
        /// Why it is not decoded here.
        problem: String,
    },
    /// The program ffmpeg does not read the video, or its colours are not read here.
    #[error("{}: {problem} (by ffmpeg)", file.display())]
    Ffmpeg {
        /// The file.
        file: PathBuf,
        /// What is wrong.
        problem: String,
    },
    /// The video has no frames.
    #[error("{}: the video has no frames", file.display())]
    Empty {
        /// The file.
        file: PathBuf,
    },
    /// The video ends within a frame.
    #[error("{}: the video ends within frame {frame}", file.display())]
    Truncated {
        /// The file.
        file: PathBuf,
        /// The frame.
        frame: usize,
    },
    /// A frame differs in size from the first.
    #[error(
        "{}: frame {frame} has {} × {} pixels, the first has {} × {}",
        file.display(), size[0], size[1], first[0], first[1]
    )]
    Size {
        /// The file; of numbered pictures, that of the frame.
        file: PathBuf,
        /// The frame.
        frame: usize,
        /// Its columns and rows.
        size: [usize; 2],
        /// Columns and rows of the first frame.
        first: [usize; 2],
    },
    /// The rows of a frame belong to two moments.
    #[error(
        "{file}: the video is interlaced; let ffmpeg separate the moments: ffmpeg -i {file} -vf \
         bwdif -f yuv4mpegpipe -",
        file = file.display()
    )]
    Interlaced {
        /// The file.
        file: PathBuf,
    },
    /// The samples are of a kind that is not read, such as 12 bits.
    #[error(
        "{file}: {problem}; let ffmpeg convert the video: ffmpeg -i {file} -pix_fmt yuv420p10le \
         -strict -1 -f yuv4mpegpipe -",
        file = file.display()
    )]
    Samples {
        /// The file.
        file: PathBuf,
        /// What is not read.
        problem: String,
    },
    /// The header of a Y4M file is wrong.
    #[error("{}: {problem}", file.display())]
    Header {
        /// The file.
        file: PathBuf,
        /// What is wrong.
        problem: FormatError,
    },
    /// A Y4M file is wrong within a frame, or cannot be read further.
    #[error("{}: {problem}", file.display())]
    Y4m {
        /// The file.
        file: PathBuf,
        /// The frame.
        frame: usize,
        /// What is wrong.
        problem: FormatError,
    },
    /// A picture of a row of numbered pictures cannot be read. The error names its file.
    #[error("frame {frame}: {problem}")]
    Picture {
        /// The frame.
        frame: usize,
        /// What is wrong.
        problem: ReadError<FormatError>,
    },
    /// A number is missing in a row of numbered pictures.
    #[error("{}: the picture of frame {frame} is missing", file.display())]
    Missing {
        /// The file that is not there.
        file: PathBuf,
        /// The frame.
        frame: usize,
    },
    /// The name of numbered pictures cannot be understood.
    #[error("{}: {problem}", file.display())]
    Pattern {
        /// The folder or pattern.
        file: PathBuf,
        /// What is wrong.
        problem: &'static str,
    },
    /// An MP4 file is wrong or has what this program does not read.
    #[error("{}: {problem}", file.display())]
    Mp4 {
        /// The file.
        file: PathBuf,
        /// What is wrong.
        problem: String,
    },
    /// A frame of an MP4 file cannot be decoded.
    #[error("{}: frame {frame}: {problem}", file.display())]
    Decoding {
        /// The file.
        file: PathBuf,
        /// The frame.
        frame: usize,
        /// What is wrong.
        problem: String,
    },
    /// Pictures of this size are not encoded.
    #[error(
        "H.264 is written from 16 × 16 to 3840 × 2160 or 2160 × 3840 pixels, not with {} × {}",
        size[0], size[1]
    )]
    EncodedSize {
        /// Columns and rows.
        size: [usize; 2],
    },
    /// A frame cannot be encoded.
    #[error("frame {frame} cannot be encoded: {problem}")]
    Encoding {
        /// The frame.
        frame: usize,
        /// What is wrong.
        problem: String,
    },
    /// The operating system could not write a frame.
    #[error("frame {frame} cannot be written: {source}")]
    Write {
        /// The frame.
        frame: usize,
        /// What the operating system said.
        source: io::Error,
    },
    /// The operating system could not write the index of the frames.
    #[error("the index of the frames cannot be written: {source}")]
    WriteIndex {
        /// What the operating system said.
        source: io::Error,
    },
    /// Two views cannot lie beside each other, or above each other, in a frame of this size.
    #[error(
        "frames of {} × {} pixels cannot be divided into two views {layout}",
        size[0], size[1]
    )]
    Layout {
        /// How the views should lie.
        layout: &'static str,
        /// Columns and rows of the frames.
        size: [usize; 2],
    },
    /// Two videos that should be the two views of one differ in what all their frames share.
    #[error("the left and the right video differ in {what}: {left} and {right}")]
    Views {
        /// In what they differ.
        what: &'static str,
        /// That of the left video.
        left: String,
        /// That of the right video.
        right: String,
    },
    /// Of two videos that should be the two views of one, one ends before the other.
    #[error("the {side} video has no frame {frame}, the other has")]
    Length {
        /// The frame.
        frame: usize,
        /// Which one is shorter: `left` or `right`.
        side: &'static str,
    },
    /// Of two videos that should be the two views of one, a frame is shown at different times.
    #[error(
        "frame {frame} is shown at {left_seconds} s in the left video and at {right_seconds} s in \
         the right one"
    )]
    Time {
        /// The frame.
        frame: usize,
        /// When the left one is shown.
        left_seconds: f64,
        /// When the right one is shown.
        right_seconds: f64,
    },
    /// A frame differs in size from the first, or has no pixels.
    #[error("frame {frame} has {} × {} pixels, the first has {} × {}", size[0], size[1], first[0], first[1])]
    KeyFrameSize {
        /// The frame.
        frame: usize,
        /// Its columns and rows.
        size: [usize; 2],
        /// Columns and rows of the first frame.
        first: [usize; 2],
    },
    /// The videos differ in a property.
    #[error("the videos differ in {what}: {reference} and {distorted}")]
    Properties {
        /// The property.
        what: &'static str,
        /// That of the reference.
        reference: String,
        /// That of the other video.
        distorted: String,
    },
    /// One video ends before the other.
    #[error("the {ended} video has no frame {frame}, the other has")]
    ReferenceLength {
        /// The first frame that only one video has.
        frame: usize,
        /// Which video ended: "reference" or "distorted".
        ended: &'static str,
    },
    /// A frame cannot be measured.
    #[error("frame {frame}: {problem}")]
    Unmeasured {
        /// The number of the frame, from 0.
        frame: usize,
        /// Why.
        problem: PlaneError,
    },
}

impl VideoError {
    /// The frame at which reading or writing ended, counted from 0, where it did at a frame.
    #[must_use]
    pub fn frame(&self) -> Option<usize> {
        match self {
            Self::Read { frame, .. }
            | Self::Truncated { frame, .. }
            | Self::Size { frame, .. }
            | Self::Y4m { frame, .. }
            | Self::Picture { frame, .. }
            | Self::Missing { frame, .. }
            | Self::Decoding { frame, .. }
            | Self::Encoding { frame, .. }
            | Self::Write { frame, .. }
            | Self::Length { frame, .. }
            | Self::Time { frame, .. }
            | Self::KeyFrameSize { frame, .. }
            | Self::ReferenceLength { frame, .. }
            | Self::Unmeasured { frame, .. } => Some(*frame),
            Self::Open { .. }
            | Self::UnknownFormat { .. }
            | Self::NeedsFfmpeg { .. }
            | Self::Ffmpeg { .. }
            | Self::Empty { .. }
            | Self::Interlaced { .. }
            | Self::Header { .. }
            | Self::Pattern { .. }
            | Self::Mp4 { .. }
            | Self::EncodedSize { .. }
            | Self::WriteIndex { .. }
            | Self::Layout { .. }
            | Self::Views { .. }
            | Self::Properties { .. }
            | Self::Samples { .. } => None,
        }
    }
}
