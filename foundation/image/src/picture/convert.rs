//! From one kind of pixel to another, and to and from the pictures of the crate `image`.

use image::{GrayImage, RgbImage, RgbaImage};

use super::{Picture, PictureView};
use crate::grey::Luma;
use crate::plane::{Plane, PlaneView};
use crate::sample::Sample;

impl Picture {
    /// The picture in grey: `luma` of the colours. Alpha is left out. Where the depths differ,
    /// black stays black and white becomes white.
    #[must_use]
    pub fn to_grey<T: Sample>(&self, luma: Luma) -> Plane<T> {
        self.view().to_grey(luma)
    }

    /// The picture in red, green and blue. Alpha is left out; grey becomes three equal channels.
    /// Where the depths differ, black stays black and white becomes white: the encoding of the
    /// colours, such as sRGB, is not changed.
    #[must_use]
    pub fn to_rgb<T: Sample>(&self) -> Plane<[T; 3]> {
        self.view().to_rgb()
    }

    /// As [`to_rgb`](Self::to_rgb), with alpha, which is that of white where the picture has none.
    #[must_use]
    pub fn to_rgba<T: Sample>(&self) -> Plane<[T; 4]> {
        self.view().to_rgba()
    }
}

impl PictureView<'_> {
    /// See [`Picture::to_grey`].
    #[must_use]
    pub fn to_grey<T: Sample>(&self, luma: Luma) -> Plane<T> {
        T::grey(self, luma)
    }

    /// See [`Picture::to_rgb`].
    #[must_use]
    pub fn to_rgb<T: Sample>(&self) -> Plane<[T; 3]> {
        T::rgb(self)
    }

    /// See [`Picture::to_rgba`].
    #[must_use]
    pub fn to_rgba<T: Sample>(&self) -> Plane<[T; 4]> {
        T::rgba(self)
    }
}

/// The picture in grey.
pub(crate) fn grey<T: Sample>(picture: &PictureView<'_>, luma: Luma) -> Plane<T> {
    fn of_rgb<S: Sample, T: Sample>(luma: Luma, rgb: [S; 3]) -> T {
        T::from_unit(luma.of(rgb).to_unit())
    }
    match picture {
        PictureView::Grey8(view) => view.map(|v| T::from_unit(v.to_unit())),
        PictureView::GreyAlpha8(view) => view.map(|[v, _]| T::from_unit(v.to_unit())),
        PictureView::Rgb8(view) => view.map(|rgb| of_rgb(luma, rgb)),
        PictureView::Rgba8(view) => view.map(|[r, g, b, _]| of_rgb(luma, [r, g, b])),
        PictureView::Grey16(view) => view.map(|v| T::from_unit(v.to_unit())),
        PictureView::GreyAlpha16(view) => view.map(|[v, _]| T::from_unit(v.to_unit())),
        PictureView::Rgb16(view) => view.map(|rgb| of_rgb(luma, rgb)),
        PictureView::Rgba16(view) => view.map(|[r, g, b, _]| of_rgb(luma, [r, g, b])),
        PictureView::GreyF32(view) => view.map(T::from_unit),
        PictureView::RgbF32(view) => view.map(|rgb| of_rgb(luma, rgb)),
    }
}

/// What is chosen of red, green, blue and alpha.
pub(crate) fn channels<T: Sample, P: Copy>(
    picture: &PictureView<'_>,
    choose: impl Fn([T; 4]) -> P,
) -> Plane<P> {
    fn level<S: Sample, T: Sample>(value: S) -> T {
        T::from_unit(value.to_unit())
    }
    fn changed<S: Copy, T: Sample, P: Copy>(
        view: &PlaneView<'_, S>,
        channels: impl Fn(S) -> [T; 4],
        choose: impl Fn([T; 4]) -> P,
    ) -> Plane<P> {
        view.map(|pixel| choose(channels(pixel)))
    }
    let opaque = T::from_unit(1.0);
    let grey = |v: T| [v, v, v, opaque];
    let grey_alpha = |[v, alpha]: [T; 2]| [v, v, v, alpha];
    let rgb = |[r, g, b]: [T; 3]| [r, g, b, opaque];
    match picture {
        PictureView::Grey8(view) => changed(view, |v| grey(level(v)), choose),
        PictureView::GreyAlpha8(view) => changed(view, |v| grey_alpha(v.map(level)), choose),
        PictureView::Rgb8(view) => changed(view, |v| rgb(v.map(level)), choose),
        PictureView::Rgba8(view) => changed(view, |v| v.map(level), choose),
        PictureView::Grey16(view) => changed(view, |v| grey(level(v)), choose),
        PictureView::GreyAlpha16(view) => changed(view, |v| grey_alpha(v.map(level)), choose),
        PictureView::Rgb16(view) => changed(view, |v| rgb(v.map(level)), choose),
        PictureView::Rgba16(view) => changed(view, |v| v.map(level), choose),
        PictureView::GreyF32(view) => changed(view, |v| grey(level(v)), choose),
        PictureView::RgbF32(view) => changed(view, |v| rgb(v.map(level)), choose),
    }
}

macro_rules! from_crate_image {
    ($($image:ident, $kind:ident, $channels:literal, $pixel:ty;)*) => {$(
        impl<'a> From<&'a $image> for PictureView<'a> {
            fn from(image: &'a $image) -> Self {
                let (width, height) = (image.width() as usize, image.height() as usize);
                let (pixels, _) = image.as_raw().as_chunks::<$channels>();
                // The crate `image` keeps width · height pixels without gaps.
                PlaneView::new(pixels, width, height, width).map_or_else(
                    |_| Self::$kind(PlaneView::default()),
                    Self::$kind,
                )
            }
        }

        impl From<&$image> for Plane<$pixel> {
            fn from(image: &$image) -> Self {
                let (width, height) = (image.width() as usize, image.height() as usize);
                let (pixels, _) = image.as_raw().as_chunks::<$channels>();
                Self::from_values(width, height, pixels.to_vec()).unwrap_or_default()
            }
        }
    )*};
}

from_crate_image! {
    RgbImage, Rgb8, 3, [u8; 3];
    RgbaImage, Rgba8, 4, [u8; 4];
}

impl<'a> From<&'a GrayImage> for PictureView<'a> {
    fn from(image: &'a GrayImage) -> Self {
        let (width, height) = (image.width() as usize, image.height() as usize);
        PlaneView::new(image.as_raw(), width, height, width)
            .map_or_else(|_| Self::Grey8(PlaneView::default()), Self::Grey8)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use image::{Luma as Grey, Rgb};

    #[test]
    fn depth_and_channels_change_and_come_back() {
        let rgb = Plane::from_fn(7, 5, |column, row| {
            [column * 40, row * 50, 255 - column * row].map(|v| v as u8)
        });
        let picture = Picture::from(rgb.clone());
        let deep = Picture::from(picture.to_rgba::<u16>());
        assert_eq!(
            deep.to_rgb::<u16>().get(1, 0),
            Some([40 * 257, 0, 255 * 257])
        );
        assert_eq!(deep.to_rgb::<u8>(), rgb);
        assert_eq!(Picture::from(picture.to_rgb::<f32>()).to_rgb::<u8>(), rgb);
        let grey = Picture::from(Plane::filled(1, 1, [9u8, 3]));
        assert_eq!(grey.to_rgba::<u8>().values(), [[9, 9, 9, 3]]);
        assert_eq!(grey.to_grey::<u8>(Luma::Bt709).values(), [9]);
    }

    #[test]
    fn pictures_of_the_crate_image_are_borrowed_as_they_are() {
        let image = RgbImage::from_fn(3, 2, |x, y| Rgb([x as u8, y as u8, 7]));
        let PictureView::Rgb8(view) = PictureView::from(&image) else {
            panic!("not RGB");
        };
        assert_eq!(view.get(2, 1), Some([2, 1, 7]));
        assert_eq!(Plane::from(&image), view.to_plane());
        let image = GrayImage::from_pixel(3, 2, Grey([5]));
        assert_eq!(
            PictureView::from(&image).to_rgb::<u8>().get(2, 1),
            Some([5; 3])
        );
    }
}
