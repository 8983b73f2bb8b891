//! Pictures on surfaces.

use ga_files::ReadError;
use ga_image::colour::linear_from_srgb;
use ga_image::file::FormatError;
use ga_image::picture::PictureView;

pub use ga_mesh::Wrap;

/// A picture on a surface, with linear numbers, and smaller copies of it for surfaces far away.
///
/// Texture coordinates (u, v) run to the right and up; (0, 0) is the lower left corner of the
/// picture, and the centres of its pixels lie on halves of a pixel.
///
/// ```
/// use ga_image::plane::Plane;
/// use ga_render::texture::{Sampler, Mipmap};
///
/// let picture = Plane::from_values(2, 1, vec![[0, 0, 0, 255], [255u8; 4]])?;
/// let texture = Mipmap::colour(&picture, Sampler::default())?;
/// assert_eq!(texture.at([0.75, 0.5], 0.0), [1.0; 4]);
/// assert_eq!(texture.at([0.5, 0.5], 0.0)[0], 0.5);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Mipmap {
    /// The picture, and where the filter asks for them its copies, each half as wide and high as
    /// the one before.
    levels: Vec<Level>,
    sampler: Sampler,
}

/// How a texture is read between and beyond its pixels.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub struct Sampler {
    /// What is seen beyond the edges, along u and along v.
    pub wrap: [Wrap; 2],
    /// How pixels are mixed.
    pub filter: Filter,
}

/// How the pixels of a texture are mixed.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum Filter {
    /// The nearest pixel alone.
    Nearest,
    /// Linearly between the four nearest pixels.
    Bilinear,
    /// Linearly between neighbours, and between two copies of the picture whose pixels are about as
    /// large as those of the rendered picture ("mipmaps").
    #[default]
    Trilinear,
}

/// Pixels that do not make a texture, or the picture of a material that cannot be used.
#[derive(Debug, thiserror::Error)]
pub enum TextureError {
    /// The file cannot be read, or is not a picture.
    #[error("the picture of material {material:?}: {problem}")]
    File {
        /// The name of the material.
        material: String,
        /// What is wrong; it names the file.
        problem: ReadError<FormatError>,
    },
    /// A picture within the file of the model is not a picture.
    #[error("the picture of material {material:?}: {problem}")]
    Embedded {
        /// The name of the material.
        material: String,
        /// What is wrong.
        problem: FormatError,
    },
    /// The pixels of a picture do not make a texture.
    #[error("the picture of material {material:?}: {problem}")]
    Pixels {
        /// The name of the material.
        material: String,
        /// What is wrong.
        problem: Box<TextureError>,
    },
    /// There are no pixels.
    #[error("a texture needs at least one pixel, but this one has {width} × {height}")]
    Empty {
        /// Columns.
        width: usize,
        /// Rows.
        height: usize,
    },
    /// The number of pixels is not that of the rows and columns.
    #[error("{found} pixels do not make a texture of {width} × {height}")]
    Length {
        /// Columns.
        width: usize,
        /// Rows.
        height: usize,
        /// The number of pixels.
        found: usize,
    },
}

/// A pixel: 65535 stands for 1.
type Texel = [u16; 4];

#[derive(Clone, Debug, PartialEq)]
struct Level {
    width: usize,
    height: usize,
    texels: Vec<Texel>,
}

impl Mipmap {
    /// A texture of colours that are encoded as sRGB; the alpha channel is linear.
    ///
    /// # Errors
    ///
    /// [`TextureError::Empty`].
    pub fn colour<'a>(
        picture: impl Into<PictureView<'a>>,
        sampler: Sampler,
    ) -> Result<Self, TextureError> {
        let decoded: Vec<u16> = (0..=u16::MAX).map(linear).collect();
        Self::of_picture(picture.into(), sampler, |[red, green, blue, alpha]| {
            let [red, green, blue] = [red, green, blue].map(|code| decoded[usize::from(code)]);
            [red, green, blue, alpha]
        })
    }

    /// A texture of plain numbers, such as normals or roughness: white stands for 1.
    ///
    /// # Errors
    ///
    /// [`TextureError::Empty`].
    pub fn data<'a>(
        picture: impl Into<PictureView<'a>>,
        sampler: Sampler,
    ) -> Result<Self, TextureError> {
        Self::of_picture(picture.into(), sampler, |texel| texel)
    }

    fn of_picture(
        picture: PictureView,
        sampler: Sampler,
        texel: impl Fn(Texel) -> Texel,
    ) -> Result<Self, TextureError> {
        let size = [picture.width(), picture.height()];
        let pixels = picture.to_rgba::<u16>().into_values();
        Self::build(size, pixels.into_iter().map(texel).collect(), sampler)
    }

    /// A texture of plain numbers from 0 to 1, row by row from the top; numbers beyond are clamped.
    /// They are stored with 16 bits.
    ///
    /// # Errors
    ///
    /// [`TextureError::Empty`] and [`TextureError::Length`].
    pub fn numbers(
        width: usize,
        height: usize,
        pixels: &[[f64; 4]],
        sampler: Sampler,
    ) -> Result<Self, TextureError> {
        if width.checked_mul(height) != Some(pixels.len()) {
            let found = pixels.len();
            return Err(TextureError::Length {
                width,
                height,
                found,
            });
        }
        let texels = pixels.iter().map(|pixel| pixel.map(quantised)).collect();
        Self::build([width, height], texels, sampler)
    }

    fn build(
        [width, height]: [usize; 2],
        texels: Vec<Texel>,
        sampler: Sampler,
    ) -> Result<Self, TextureError> {
        if texels.is_empty() {
            return Err(TextureError::Empty { width, height });
        }
        let mut levels = vec![Level {
            width,
            height,
            texels,
        }];
        if sampler.filter == Filter::Trilinear {
            while let Some(next) = levels.last().and_then(Level::halved) {
                levels.push(next);
            }
        }
        Ok(Self { levels, sampler })
    }

    /// Columns.
    pub fn width(&self) -> usize {
        self.levels[0].width
    }

    /// Rows.
    pub fn height(&self) -> usize {
        self.levels[0].height
    }

    /// Red, green, blue and alpha at texture coordinates (u, v), for a pixel of the rendered
    /// picture that is `footprint` pixels of the texture wide.
    pub fn at(&self, coordinates: [f64; 2], footprint: f64) -> [f64; 4] {
        match self.sampler.filter {
            Filter::Nearest => self.levels[0].nearest(coordinates, self.sampler.wrap),
            Filter::Bilinear => self.levels[0].bilinear(coordinates, self.sampler.wrap),
            Filter::Trilinear => self.trilinear(coordinates, footprint),
        }
    }

    fn trilinear(&self, coordinates: [f64; 2], footprint: f64) -> [f64; 4] {
        let last = self.levels.len() - 1;
        // The greater comes first, so that a footprint that is not a number reads the picture.
        let level = 1f64.max(footprint).log2().min(last as f64);
        let below = level as usize;
        let fine = self.levels[below].bilinear(coordinates, self.sampler.wrap);
        let part = level - below as f64;
        if part == 0.0 {
            return fine;
        }
        let coarse = self.levels[below + 1].bilinear(coordinates, self.sampler.wrap);
        mix(fine, coarse, part)
    }
}

impl Level {
    fn nearest(&self, coordinates: [f64; 2], wrap: [Wrap; 2]) -> [f64; 4] {
        let [x, y] = self.place(coordinates, wrap);
        let column = wrapped(x.floor() as i64, self.width, wrap[0]);
        let row = wrapped(y.floor() as i64, self.height, wrap[1]);
        self.texel(column, row)
    }

    fn bilinear(&self, coordinates: [f64; 2], wrap: [Wrap; 2]) -> [f64; 4] {
        let [x, y] = self.place(coordinates, wrap).map(|c| c - 0.5);
        let (left, top) = (x.floor(), y.floor());
        let columns = [0, 1].map(|i| wrapped(left as i64 + i, self.width, wrap[0]));
        let rows = [0, 1].map(|i| wrapped(top as i64 + i, self.height, wrap[1]));
        let [upper, lower] = rows.map(|row| {
            let [a, b] = columns.map(|column| self.texel(column, row));
            mix(a, b, x - left)
        });
        mix(upper, lower, y - top)
    }

    /// Column and row of texture coordinates, where they repeat within two pictures.
    fn place(&self, [u, v]: [f64; 2], wrap: [Wrap; 2]) -> [f64; 2] {
        let near = |c: f64, wrap| match wrap {
            Wrap::Repeat => c - c.floor(),
            Wrap::MirroredRepeat => c - 2.0 * (c / 2.0).floor(),
            Wrap::ClampToEdge => c.clamp(0.0, 1.0),
        };
        [
            near(u, wrap[0]) * self.width as f64,
            near(1.0 - v, wrap[1]) * self.height as f64,
        ]
    }

    fn texel(&self, column: usize, row: usize) -> [f64; 4] {
        self.texels[row * self.width + column].map(|c| f64::from(c) / 65535.0)
    }

    /// The picture with half the columns and rows, each pixel the mean of the area that it covers;
    /// `None` for a single pixel.
    fn halved(&self) -> Option<Self> {
        if self.width == 1 && self.height == 1 {
            return None;
        }
        let (width, height) = ((self.width / 2).max(1), (self.height / 2).max(1));
        let columns: Vec<_> = (0..width).map(|c| shares(c, width, self.width)).collect();
        let mut texels = Vec::with_capacity(width * height);
        for row in 0..height {
            let rows = shares(row, height, self.height);
            for columns in &columns {
                let mut sum = [0.0; 4];
                for &(j, down) in &rows {
                    for &(i, across) in columns {
                        let texel = self.texels[j * self.width + i];
                        for (sum, channel) in sum.iter_mut().zip(texel) {
                            *sum += f64::from(channel) * (down * across);
                        }
                    }
                }
                texels.push(sum.map(|c| c.round() as u16));
            }
        }
        Some(Self {
            width,
            height,
            texels,
        })
    }
}

/// The pixels of a row of `fine` that one of `coarse` equal parts covers, with their shares of it.
fn shares(part: usize, coarse: usize, fine: usize) -> Vec<(usize, f64)> {
    let per_part = fine as f64 / coarse as f64;
    let (begin, end) = (part as f64 * per_part, (part + 1) as f64 * per_part);
    (begin as usize..(end.ceil() as usize).min(fine))
        .map(|pixel| {
            let covered = end.min((pixel + 1) as f64) - begin.max(pixel as f64);
            (pixel, covered.max(0.0) / per_part)
        })
        .collect()
}

fn wrapped(index: i64, size: usize, wrap: Wrap) -> usize {
    let size = size as i64;
    let index = match wrap {
        Wrap::Repeat => index.rem_euclid(size),
        Wrap::MirroredRepeat => {
            let within = index.rem_euclid(2 * size);
            within.min(2 * size - 1 - within)
        }
        Wrap::ClampToEdge => index.clamp(0, size - 1),
    };
    index as usize
}

fn mix(a: [f64; 4], b: [f64; 4], t: f64) -> [f64; 4] {
    std::array::from_fn(|i| a[i] * (1.0 - t) + b[i] * t)
}

fn quantised(number: f64) -> u16 {
    (number.clamp(0.0, 1.0) * 65535.0).round() as u16
}

/// The linear light of a 16-bit sRGB code.
fn linear(code: u16) -> u16 {
    quantised(linear_from_srgb(f64::from(code) / 65535.0))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_shares_of_a_part_add_to_one_and_each_pixel_is_used_up() {
        for fine in 1..40usize {
            let coarse = (fine / 2).max(1);
            let mut used = vec![0.0; fine];
            for part in 0..coarse {
                let shares = shares(part, coarse, fine);
                let total: f64 = shares.iter().map(|share| share.1).sum();
                assert!((total - 1.0).abs() < 1e-12);
                for (pixel, share) in shares {
                    used[pixel] += share;
                }
            }
            let expected = coarse as f64 / fine as f64;
            assert!(used.iter().all(|u| (u - expected).abs() < 1e-12), "{fine}");
        }
    }

    #[test]
    fn indices_beyond_the_edges_follow_the_wrap_mode() {
        let row = |wrap| (-4..7).map(|i| wrapped(i, 3, wrap)).collect::<Vec<_>>();
        assert_eq!(row(Wrap::Repeat), [2, 0, 1, 2, 0, 1, 2, 0, 1, 2, 0]);
        assert_eq!(row(Wrap::MirroredRepeat), [2, 2, 1, 0, 0, 1, 2, 2, 1, 0, 0]);
        assert_eq!(row(Wrap::ClampToEdge), [0, 0, 0, 0, 0, 1, 2, 2, 2, 2, 2]);
    }
}
